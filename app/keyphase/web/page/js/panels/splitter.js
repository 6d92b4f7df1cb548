/** The bar between scene and timeline: dragged, moved by keys, reset by a double click. */

import { byId } from "../lib/dom.js";

const LEAST_SCENE_PX = 160;
/** Unless a person wants less, the scene has so much, or half of what both share in a low window. */
const FAIR_SCENE_PX = 250;
const LEAST_TIMELINE_PX = 130;
const STEP_PX = 24;
/** What else stands below one another: those of the recording, or those of its replay. */
const BESIDE = [
  "header",
  "banners",
  "splitter",
  "transport",
  "replay-transport",
  "plan",
  "replay-plan",
  "status",
];
/** While a workcell is open the scene is what one works in. */
const WHILE_RECORDING_PX = 240;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {() => number} naturalHeight height at which all rows of the timeline show
 */
export function createSplitter(store, naturalHeight) {
  const bar = byId("splitter");
  /** @type {number|null} the height a person chose; null follows the rows */
  let chosen = null;
  let isOpen = false;

  /** What scene and timeline share. */
  const room = () => innerHeight - BESIDE.reduce((sum, id) => sum + byId(id).offsetHeight, 0);

  function limit(height, leastScene = LEAST_SCENE_PX) {
    return Math.round(
      Math.min(
        Math.max(height, LEAST_TIMELINE_PX),
        Math.max(LEAST_TIMELINE_PX, room() - leastScene),
      ),
    );
  }

  /** As high as a person chose, or as its rows are where that leaves the scene its share. */
  function heightNow() {
    if (chosen !== null) return limit(chosen);
    const fair = Math.max(LEAST_SCENE_PX, Math.min(FAIR_SCENE_PX, room() / 2));
    return limit(isOpen ? Math.min(naturalHeight(), WHILE_RECORDING_PX) : naturalHeight(), fair);
  }

  function apply() {
    const now = heightNow();
    document.documentElement.style.setProperty("--timeline-height", `${now}px`);
    bar.setAttribute("aria-valuenow", String(now));
    store.set({ paneHeight: now });
  }

  function choose(height) {
    chosen = height === null ? null : limit(height);
    apply();
  }

  bar.addEventListener("pointerdown", (event) => {
    bar.setPointerCapture(event.pointerId);
    document.body.classList.add("dragging");
    const start = event.clientY + byId("timeline").offsetHeight;
    const move = ({ clientY }) => choose(start - clientY);
    const end = () => {
      document.body.classList.remove("dragging");
      bar.removeEventListener("pointermove", move);
    };
    bar.addEventListener("pointermove", move);
    bar.addEventListener("pointerup", end, { once: true });
    bar.addEventListener("pointercancel", end, { once: true });
  });
  bar.addEventListener("dblclick", () => choose(null));
  bar.addEventListener("keydown", (event) => {
    const step = { ArrowUp: STEP_PX, ArrowDown: -STEP_PX }[event.key];
    if (!step) return;
    event.preventDefault();
    choose(heightNow() + step);
  });
  addEventListener("resize", apply);
  store.on(["record"], ({ record }) => {
    if (isOpen === Boolean(record?.workcell)) return;
    isOpen = !isOpen;
    apply();
  });
  store.on(
    [
      "recording",
      "folded",
      "hidden",
      "small",
      "comparison",
      "cameras",
      "camerasShown",
      "replayShown",
    ],
    apply,
  );
}
