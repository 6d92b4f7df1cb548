/** The recordings at the left: what is left to do, and where doubt is greatest. */

import { leastCertainOf } from "../actions/recording_actions.js";
import { byId, el } from "../lib/dom.js";
import {
  asksForALook,
  byFolder,
  commonBeginning,
  pickedWith,
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
  attachRowKeys(rows, store, pick);

  store.later(
    ["recordings", "recording", "leastCertainFirst", "small", "filter", "picked"],
    ({ recordings, leastCertainFirst, small, recording }) => {
      const { items } = recordings;
      byId("queue-count").textContent = String(items.length);
      byId("queue-progress").replaceChildren(...progress(items));
      byId("queue-states").replaceChildren(...counts(items, small));
      sort.classList.toggle("on", leastCertainFirst);
      sort.setAttribute("aria-pressed", String(leastCertainFirst));
      filter.hidden = items.length < FILTER_FROM && !items.some(isAssessed) && !filter.value;
      const shown = shownRecordings(store.state);
      rows.replaceChildren(...drawFolders(shown, leastCertainFirst, rowOf));
      rows.querySelector(".on")?.scrollIntoView({ block: "nearest" });
      const active = shown.find(({ id }) => id === recording);
      if (active) rows.setAttribute("aria-activedescendant", rowId(active));
      else rows.removeAttribute("aria-activedescendant");
      drawLeastCertain(recordings);
    },
  );

  /** @param {string} id @param {MouseEvent|KeyboardEvent} event */
  function pick(id, { ctrlKey, metaKey, shiftKey }) {
    const how = { toggles: ctrlKey || metaKey, extends: shiftKey };
    store.set({ picked: pickedWith(store.state, id, how) });
    if (!how.toggles && !how.extends) actions.open(id);
  }

  function rowOf(item, common) {
    return drawRow(item, {
      on: item.id === (store.state.recording ?? store.state.recordings.current),
      common,
      picked: store.state.picked.includes(item.id),
      open: (event) => pick(item.id, event),
      menu: (event) => menu.forRecording(item, event),
    });
  }
}

const isAssessed = ({ assessment, marked = [] }) =>
  marked.length > 0 ||
  Boolean(assessment && (assessment.outcome || assessment.quality || assessment.note));

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
 * The list is one stop of the Tab key; arrows go from row to row, Enter opens, and Ctrl Space picks.
 * @param {import("../lib/store.js").Store} store
 * @param {(id: string, event: KeyboardEvent) => void} pick
 */
function attachRowKeys(rows, store, pick) {
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
  const isOpen = () =>
    rows.getAttribute("aria-activedescendant") === rowId({ id: store.state.recording ?? "" });
  const keys = {
    ArrowDown: () => move((at) => at + 1),
    ArrowUp: () => move((at) => at - 1),
    Home: () => move(() => 0),
    End: () => move((_, count) => count - 1),
    Enter: (event) => choose(event),
    " ": (event) => choose(event),
  };
  const choose = (event) => {
    const id = rows.getAttribute("aria-activedescendant");
    const item = store.state.recordings.items.find((one) => rowId(one) === id);
    if (item) pick(item.id, event);
  };
  rows.addEventListener("keydown", (event) => {
    const picks = event.key === " " && !event.metaKey;
    if (!keys[event.key] || ((event.ctrlKey || event.metaKey) && !picks)) return;
    // On the row of the open recording Enter accepts what is shown, as everywhere.
    if (event.key === "Enter" && !event.shiftKey && isOpen()) return;
    event.preventDefault();
    event.stopPropagation();
    keys[event.key](event);
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
