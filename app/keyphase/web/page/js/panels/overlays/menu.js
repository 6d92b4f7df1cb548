/** Menus at the pointer: everything one can do to what was clicked, and which tracks to show. */

import { segmentAt } from "../../model/segments.js";
import { byId, el, icon } from "../../lib/dom.js";
import { segmentsStand } from "../../model/held.js";
import { SKILLS, toggle, tracksFor } from "../../model/rows.js";
import { comparisonItems, recordingItems, timelineItems } from "./menu_items.js";

/**
 * @typedef {{text: string, key?: string, run: () => void, off?: boolean, checked?: boolean}|"rule"|{heading: string}} Item
 */

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createMenu(store, actions) {
  const node = byId("menu");
  /** @type {HTMLElement|null} where the focus was before */
  let before = null;

  function close() {
    const was = !node.hidden;
    const hadFocus = node.contains(document.activeElement);
    node.hidden = true;
    if (hadFocus) before?.focus({ preventScroll: true });
    return was;
  }

  /** What its entries are about. @type {import("../../model/held.js").Stands} */
  let stands = () => true;
  store.on(["document"], ({ document: doc }) => !node.hidden && !stands(doc) && close());

  /** @param {Item[]} items @param {{x: number, y: number}} at */
  function open(items, { x, y }) {
    close();
    const { document: doc } = store.state;
    stands = doc ? segmentsStand(doc) : (now) => !now;
    before = /** @type {HTMLElement} */ (document.activeElement);
    node.replaceChildren(...items.map(drawItem));
    node.hidden = false;
    const { offsetWidth: width, offsetHeight: height } = node;
    node.style.setProperty("left", `${Math.max(4, Math.min(x, innerWidth - width - 8))}px`);
    node.style.setProperty(
      "top",
      `${y + height > innerHeight - 8 ? Math.max(4, y - height) : y}px`,
    );
    /** @type {HTMLElement|null} */ (node.querySelector("button:not(:disabled)"))?.focus();
  }

  function drawItem(item) {
    if (item === "rule") return el("hr", { role: "separator" });
    if ("heading" in item)
      return el("div", { class: "menu-heading", role: "presentation", text: item.heading });
    const { text, key, run, off, checked } = item;
    const start = () => {
      close();
      run();
    };
    return el(
      "button",
      {
        type: "button",
        role: checked === undefined ? "menuitem" : "menuitemcheckbox",
        "aria-checked": checked === undefined ? null : String(checked),
        disabled: Boolean(off),
        on: { click: start },
      },
      checked === undefined ? "" : el("i", { class: "check" }, checked ? icon("check") : ""),
      el("span", { text }),
      key ? el("kbd", { text: key }) : "",
    );
  }

  node.addEventListener("keydown", (event) => {
    const buttons = /** @type {HTMLElement[]} */ ([
      ...node.querySelectorAll("button:not(:disabled)"),
    ]);
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (event.key === "Escape" || event.key === "Tab") close();
    else if (by)
      buttons
        .at(
          (buttons.indexOf(/** @type {HTMLElement} */ (document.activeElement)) + by) %
            buttons.length,
        )
        ?.focus();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  addEventListener(
    "pointerdown",
    ({ target }) => !node.contains(/** @type {Node} */ (target)) && close(),
    true,
  );
  addEventListener("blur", close);
  node.addEventListener("contextmenu", (event) => event.preventDefault());

  return {
    close,
    /** The menu of the current boundary, or of the segment selected or at the playhead. */
    forChosen(timeline) {
      const { document: doc, selected, current, clock } = store.state;
      const boundary = doc.boundaries[current];
      const index = selected ?? segmentAt(doc, clock);
      const time = boundary ? boundary.time_s : timeInside(doc.segments[index], clock);
      const hit = boundary ? { kind: "boundary", boundary: current } : { kind: "segment" };
      const box = timeline.surface.getBoundingClientRect();
      const { width } = timeline.scale();
      const row = timeline.layout().rows.get(boundary ? "boundaries" : "segments");
      open(timelineItems(store, actions, hit, time), {
        x: box.left + Math.min(Math.max(timeline.scale().x(time), 0), width),
        y: box.top + row.y + row.height,
      });
    },
    /** @param {import("../../timeline/hand/hit.js").Hit} hit */
    forTimeline(hit, time, { clientX: x, clientY: y }) {
      open(timelineItems(store, actions, hit, time), { x, y });
    },
    /** @param {import("../../model/types.js").Recording} item @param {MouseEvent} event */
    forRecording(item, event) {
      event.preventDefault();
      open(recordingItems(store, actions, item), { x: event.clientX, y: event.clientY });
    },
    tracks(event) {
      const box = event.currentTarget.getBoundingClientRect();
      const { document: doc, hidden, comparison } = store.state;
      if (!comparison) actions.compare(null);
      const all = [{ key: SKILLS, title: "Skills" }, ...tracksFor(doc)];
      const items = all.map(({ key, title }) => ({
        text: title,
        checked: !hidden.has(key),
        run: () => toggle(store, "hidden", key),
      }));
      open([{ heading: "Tracks" }, ...items, ...comparisonItems(store, actions)], {
        x: box.right - 208,
        y: box.bottom + 4,
      });
    },
  };
}

/** The playhead where it is inside the segment, else the segment's middle. */
function timeInside({ start_s: start, end_s: end }, clock) {
  return clock > start && clock < end ? clock : (start + end) / 2;
}
