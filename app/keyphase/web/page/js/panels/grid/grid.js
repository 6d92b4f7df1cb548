/** All recordings of the folder beside each other, as strips; the phases of the task beside them. */

import { byId, el } from "../../lib/dom.js";
import {
  AT_START,
  atPhase,
  EQUAL,
  standings,
  summary,
  usualNames,
} from "../../model/recordings/grid.js";
import { createChangeBar } from "./change_bar.js";
import { createPhases } from "./phases.js";
import { drawRows, rowId } from "./strips.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createGrid(store, actions) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("grid"));
  byId("open-grid").addEventListener("click", actions.toggleGrid);
  const rows = el("div", {
    class: "grid-rows",
    role: "listbox",
    "aria-label": "Recordings",
    tabindex: "0",
  });
  const empty = el("p", { class: "grid-empty", hidden: true });
  const head = createHead(store, actions);
  const bar = createChangeBar(store, actions, () => {
    bar.draw(store.state);
    draw();
  });
  dialog.append(
    head,
    el(
      "div",
      { class: "grid-body" },
      el("div", { class: "grid-list" }, empty, rows),
      createPhases(store, actions),
    ),
    bar.node,
  );
  dialog.addEventListener("close", () => store.state.gridShown && actions.toggleGrid());
  dialog.addEventListener("cancel", (event) => {
    // Escape gives up the change first, then the grid.
    if (!store.state.gridChange) return;
    event.preventDefault();
    actions.considerInAll(null);
  });
  attachKeys(rows, actions);
  /** Whether the grid was just opened: it begins at the open recording. */
  let isNew = false;

  function draw() {
    const { grid, gridAlign: align, gridChange: change, recording } = store.state;
    if (!grid || !dialog.open) return;
    empty.hidden = grid.rows.length > 0;
    const width = Math.max(rows.clientWidth - (innerWidth < NARROW_PX ? 24 : 264), 100);
    const how = {
      align,
      change,
      includeDone: bar.includeDone(),
      current: recording,
      open: actions.openAt,
    };
    const active = rows.getAttribute("aria-activedescendant");
    const top = rows.scrollTop;
    rows.replaceChildren(...drawRows(grid, how, width));
    rows.scrollTop = top;
    const first = /** @type {HTMLElement|null} */ (rows.querySelector(".grid-row"));
    const still = (active && document.getElementById(active)) || first;
    still?.classList.add("active");
    if (still) rows.setAttribute("aria-activedescendant", still.id);
    else rows.removeAttribute("aria-activedescendant");
    if (isNew) still?.scrollIntoView({ block: "nearest" });
    isNew &&= !still;
  }
  store.on(["gridShown"], ({ gridShown }) => {
    if (gridShown === dialog.open) return;
    if (!gridShown) return dialog.close();
    rows.replaceChildren();
    rows.setAttribute("aria-activedescendant", rowId(store.state.recording));
    isNew = true;
    empty.hidden = store.state.recordings.items.length > 0;
    empty.textContent =
      "No recordings yet. Add some (Ctrl O), or drop them on the page: each becomes a strip here.";
    dialog.showModal();
    rows.focus();
  });
  store.on(["grid", "gridAlign", "gridChange", "gridShown", "recording"], draw);
  addEventListener("resize", draw);
  // A server that has come back knows nothing of what this page shows; and what was shown as done
  // may have been refused.
  store.on(
    ["connected", "refusals"],
    ({ connected, gridShown }) => connected && gridShown && actions.askForGrid(),
  );
}

const NARROW_PX = 820;

/** @param {import("../../lib/store.js").Store} store @param {any} actions */
function createHead(store, actions) {
  const told = el("span", { class: "quiet grid-told", role: "status" });
  const meter = el("i");
  const progress = el("div", { class: "grid-progress", hidden: true }, meter);
  const align = /** @type {HTMLSelectElement} */ (el("select", { "aria-label": "Aligned at" }));
  align.addEventListener("change", () => store.set({ gridAlign: align.value }));
  const undo = /** @type {HTMLButtonElement} */ (
    el("button", {
      type: "button",
      class: "button",
      hidden: true,
      on: { click: actions.undoInAll },
    })
  );
  const aligned = el(
    "label",
    { class: "grid-align", hidden: true },
    el("span", { text: "Aligned at" }),
    align,
  );
  const close = el("button", {
    type: "button",
    class: "button",
    text: "Close",
    on: { click: actions.toggleGrid },
  });

  store.on(["grid", "gridAlign", "readOnly"], ({ grid, gridAlign, readOnly }) => {
    aligned.hidden = !grid?.rows.length;
    if (!grid) return;
    const names = usualNames(grid);
    const choices = [
      [AT_START, "Start of the recording"],
      [EQUAL, "Every phase equally long"],
      ...names.map((name) => [atPhase(name), `Start of “${name}”`]),
    ];
    if (!choices.some(([value]) => value === gridAlign)) store.set({ gridAlign: AT_START });
    align.replaceChildren(...choices.map(([value, text]) => el("option", { value, text })));
    align.value = gridAlign;
    const waiting = standings(grid.rows).get("waiting") ?? 0;
    const count = grid.rows.length;
    progress.hidden = !waiting;
    meter.style.setProperty("width", `${(100 * (count - waiting)) / Math.max(count, 1)}%`);
    told.textContent = waiting ? `${count - waiting} of ${count} looked at` : summary(grid.rows);
    undo.hidden = !grid.undo || readOnly;
    undo.textContent = `Undo: ${grid.undo}`;
    undo.title = "In all recordings";
  });
  return el(
    "div",
    { class: "grid-head" },
    el("h2", { text: "All recordings" }),
    told,
    el("span", { class: "space" }),
    aligned,
    undo,
    close,
    progress,
  );
}

/**
 * The rows are one stop of the Tab key: arrows go up and down, left and right go along the
 * segments of a row, Enter opens the recording there.
 * @param {HTMLElement} rows
 * @param {any} actions
 */
function attachKeys(rows, actions) {
  let piece = 0;
  const all = () => /** @type {HTMLElement[]} */ ([...rows.querySelectorAll(".grid-row")]);
  const current = () => rows.querySelector(".grid-row.active") ?? null;
  const pieces = () =>
    /** @type {HTMLElement[]} */ ([...(current()?.querySelectorAll(".grid-strip i") ?? [])]);
  function show() {
    for (const one of rows.querySelectorAll(".at")) one.classList.remove("at");
    pieces()[piece]?.classList.add("at");
  }
  function move(by) {
    const list = all();
    const at = list.indexOf(/** @type {HTMLElement} */ (current()));
    const next = list[Math.min(Math.max(at + by, 0), list.length - 1)];
    if (!next) return;
    current()?.classList.remove("active");
    next.classList.add("active");
    rows.setAttribute("aria-activedescendant", rowId(next.dataset.recording));
    next.scrollIntoView({ block: "nearest" });
    piece = 0;
    show();
  }
  function along(by) {
    piece = Math.min(Math.max(piece + by, 0), Math.max(pieces().length - 1, 0));
    show();
  }
  const keys = {
    ArrowDown: () => move(1),
    ArrowUp: () => move(-1),
    Home: () => move(-Infinity),
    End: () => move(Infinity),
    ArrowRight: () => along(1),
    ArrowLeft: () => along(-1),
    Enter: () => /** @type {HTMLElement} */ (pieces()[piece] ?? current())?.click(),
  };
  rows.addEventListener("keydown", (event) => {
    if (!keys[event.key] || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    keys[event.key](event);
  });
}
