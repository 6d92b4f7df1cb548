/** The recordings at the left: what is left to do, and where doubt is greatest. */

import { leastCertainOf } from "../actions/recording_actions.js";
import { byId, el } from "../lib/dom.js";
import {
  asksForALook,
  byFolder,
  commonBeginning,
  shownRecordings,
} from "../model/recordings/recording_list.js";
import { drawRow, rowId, stateMark } from "./queue_row.js";

/** @type {import("../model/types.js").Recording["state"][]} */
const STATES = ["done", "touched", "automatic"];
/** With more recordings than this a filter helps. */
const FILTER_FROM = 8;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @param {{forRecording: (item: import("../model/types.js").Recording, event: MouseEvent) => void}} menu
 */
export function createQueue(store, actions, menu) {
  const rows = byId("queue-rows");
  const sort = byId("queue-sort");
  const filter = /** @type {HTMLInputElement} */ (byId("queue-filter"));
  sort.addEventListener("click", actions.toggleOrder);
  byId("least-certain").addEventListener("click", actions.leastCertain);
  byId("previous-recording").addEventListener("click", () => actions.nextRecording(-1));
  byId("next-recording").addEventListener("click", () => actions.nextRecording(1));
  filter.addEventListener("input", () => store.set({ filter: filter.value }));
  attachRowKeys(rows, store, actions);

  store.later(
    ["recordings", "recording", "leastCertainFirst", "small", "filter"],
    ({ recordings, leastCertainFirst, small, recording }) => {
      const { items } = recordings;
      byId("queue-count").textContent = String(items.length);
      byId("queue-progress").replaceChildren(...progress(items));
      byId("queue-states").replaceChildren(...counts(items, small));
      sort.classList.toggle("on", leastCertainFirst);
      sort.setAttribute("aria-pressed", String(leastCertainFirst));
      filter.hidden = items.length < FILTER_FROM;
      const shown = shownRecordings(store.state);
      rows.replaceChildren(...drawFolders(shown, leastCertainFirst, rowOf));
      rows.querySelector(".on")?.scrollIntoView({ block: "nearest" });
      const active = shown.find(({ id }) => id === recording);
      if (active) rows.setAttribute("aria-activedescendant", rowId(active));
      else rows.removeAttribute("aria-activedescendant");
      drawLeastCertain(recordings);
    },
  );

  function rowOf(item, common) {
    return drawRow(item, {
      on: item.id === (store.state.recording ?? store.state.recordings.current),
      common,
      open: () => actions.open(item.id),
      menu: (event) => menu.forRecording(item, event),
    });
  }
}

/** Rows with a heading above those of each folder, unless all are of one or doubt gives the order. */
function drawFolders(shown, leastCertainFirst, rowOf) {
  const folders = leastCertainFirst ? [{ folder: "", items: shown }] : byFolder(shown);
  return folders.flatMap(({ folder, items }) => {
    const common = commonBeginning(items.map(({ name }) => name));
    const heading = el("div", {
      class: "queue-folder",
      role: "presentation",
      title: folder,
      text: folder,
    });
    return [...(folders.length > 1 ? [heading] : []), ...items.map((item) => rowOf(item, common))];
  });
}

/**
 * The list is one stop of the Tab key; arrows go from row to row, Enter opens.
 * @param {import("../lib/store.js").Store} store
 */
function attachRowKeys(rows, store, actions) {
  const move = (to) => {
    const shown = shownRecordings(store.state);
    const at = shown.findIndex(
      (item) => rowId(item) === rows.getAttribute("aria-activedescendant"),
    );
    const next = shown[Math.min(Math.max(to(at, shown.length), 0), shown.length - 1)];
    if (!next) return;
    rows.setAttribute("aria-activedescendant", rowId(next));
    for (const row of rows.querySelectorAll(".active")) row.classList.remove("active");
    const row = byId(rowId(next));
    row.classList.add("active");
    row.scrollIntoView({ block: "nearest" });
  };
  const keys = {
    ArrowDown: () => move((at) => at + 1),
    ArrowUp: () => move((at) => at - 1),
    Home: () => move(() => 0),
    End: () => move((_, count) => count - 1),
    Enter: () => open(),
    " ": () => open(),
  };
  const open = () => {
    const id = rows.getAttribute("aria-activedescendant");
    const item = store.state.recordings.items.find((one) => rowId(one) === id);
    if (item) actions.open(item.id);
  };
  rows.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key]();
  });
}

function drawLeastCertain(recordings) {
  const least = leastCertainOf(recordings);
  const value = byId("least-certain-value");
  value.textContent = least ? least.confidence.toFixed(2) : "";
  value.classList.toggle("low", Boolean(least && asksForALook(least)));
  const button = /** @type {HTMLButtonElement} */ (byId("least-certain"));
  button.disabled = !least;
  button.title = least ? `Open ${least.name}, where doubt is greatest (U)` : "Nothing is unsure";
}

function progress(items) {
  const color = { done: "var(--good)", touched: "var(--accent)", automatic: "var(--text-4)" };
  return STATES.map((state) => [state, items.filter((item) => item.state === state).length])
    .filter(([, count]) => count)
    .map(([state, count]) => el("i", { style: { flex: String(count), background: color[state] } }));
}

function counts(items, small) {
  const names = small
    ? { done: "done", touched: "", automatic: "auto" }
    : { done: "done", touched: "touched", automatic: "automatic" };
  return STATES.map((state) => {
    const count = items.filter((item) => item.state === state).length;
    return el(
      "span",
      { title: `${count} ${state}` },
      stateMark(state),
      `${count} ${names[state]}`.trim(),
    );
  });
}
