/** Menus at the pointer: everything one can do to what was clicked, and which tracks to show. */

import { segmentAt } from "../../model/segments.js";
import { byId, el, icon } from "../../lib/dom.js";
import { toggle, tracksFor } from "../../model/rows.js";

/** What the server's own comparisons are called here. */
const OWN_NAMES = { automatic: "What the program found", "found now": "As it would be found now" };

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

  /** @param {Item[]} items @param {{x: number, y: number}} at */
  function open(items, { x, y }) {
    close();
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
    /** @param {import("../../timeline/hit.js").Hit} hit */
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
      const items = tracksFor(doc).map(({ key, title }) => ({
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

/** @returns {Item[]} */
function timelineItems(store, actions, hit, time) {
  const { document: doc, readOnly: off, labels } = store.state;
  const general = [
    { text: "Go here", run: () => actions.seek(time) },
    { text: "The whole recording", key: "F", run: actions.fit },
    { text: "All commands", key: "Ctrl K", run: () => actions.openPalette() },
  ];
  if (hit.kind === "boundary")
    return [...boundaryItems(doc, hit.boundary, actions, off), "rule", ...general];
  const index = doc.segments.findIndex(({ end_s: end }) => time < end);
  const segment = doc.segments[index];
  if (!segment) return general;
  const threshold =
    hit.kind === "threshold" || hit.kind === "line"
      ? [
          {
            text: "Threshold back to automatic",
            off,
            run: () => actions.automaticThreshold(hit.line),
          },
          "rule",
        ]
      : [];
  return [
    ...threshold,
    { heading: `Segment ${index + 1}` },
    { text: "Label…", key: "L", off, run: () => actions.rename(index) },
    ...labels.slice(0, 9).map(({ name }, k) => ({
      text: name,
      key: String(k + 1),
      off,
      run: () => actions.label(name, index),
    })),
    ...(segment.proposed
      ? [{ text: "Accept its name", off, run: () => actions.label(segment.label, index) }]
      : []),
    ...(doc.segments.some(({ proposed, kept }) => proposed && kept)
      ? [{ text: "Accept all proposed names", key: "Shift Enter", off, run: actions.acceptNames }]
      : []),
    { text: segment.kept ? "Drop" : "Keep", key: "X", off, run: () => actions.toggleDrop(index) },
    { text: "Split here", off, run: () => actions.addBoundary(time) },
    {
      text: "Merge with the next",
      key: "M",
      off: off || index === doc.segments.length - 1,
      run: () => actions.mergeRange(index, index + 1),
    },
    {
      text: "Merge with the one before",
      off: off || index === 0,
      run: () => actions.mergeRange(index - 1, index),
    },
    "rule",
    {
      text: "Repeat in the plan",
      key: "R",
      off: off || !segment.kept,
      run: () => (actions.select(index), actions.repeat()),
    },
    {
      text: "Earlier in the plan",
      key: "{",
      off: off || !segment.kept,
      run: () => (actions.select(index), actions.shift(-1)),
    },
    {
      text: "Later in the plan",
      key: "}",
      off: off || !segment.kept,
      run: () => (actions.select(index), actions.shift(1)),
    },
    {
      text: "Take out of the plan",
      key: "Shift X",
      off: off || !segment.kept,
      run: () => (actions.select(index), actions.takeOut()),
    },
    "rule",
    ...general,
  ];
}

/** @returns {Item[]} */
function recordingItems(store, actions, item) {
  const { recording, document: doc, readOnly: off, following } = store.state;
  const isOpen = item.id === recording && doc;
  const done = item.state === "done";
  const others = item.pages ?? [];
  return [
    { heading: item.name },
    { text: "Open", off: isOpen, run: () => actions.open(item.id) },
    ...(isOpen
      ? [
          {
            text: done ? "Not done after all" : "Done",
            key: "Shift K",
            off,
            run: () => actions.setDone(!done),
          },
          { text: "Export the segment file", key: "Ctrl S", run: () => actions.exportAs("json") },
        ]
      : []),
    { text: "Copy its address", run: () => actions.copyAddress(item) },
    ...others.map(({ id, name }) => ({
      text: `Follow ${name}`,
      checked: following === id,
      run: () => actions.follow(following === id ? null : id),
    })),
  ];
}

/** With which other segmentations of this recording the shown one can be compared. */
function comparisonItems({ state }, actions) {
  const { options = ["automatic"], with: shown = null } = state.comparison ?? {};
  const items = options.map((name) => ({
    text: OWN_NAMES[name] ?? name,
    checked: name === shown,
    run: () => actions.compare(name === shown ? null : name),
  }));
  return ["rule", { heading: "Compare with" }, ...items];
}

/** @returns {Item[]} */
function boundaryItems(doc, index, actions, off) {
  const boundary = doc.boundaries[index];
  return [
    { heading: `Boundary ${index + 1}` },
    { text: "Why it is there", run: () => actions.visit(index) },
    {
      text: "Accept",
      key: "Enter",
      off: off || boundary.accepted,
      run: () => actions.acceptBoundary(index),
    },
    {
      text: boundary.contact_change ? "Not a contact change" : "A contact change",
      key: "C",
      off,
      run: () => actions.toggleContact(index),
    },
    ...(boundary.was_s !== null
      ? [
          {
            text: "Back to where it was",
            off,
            run: () => actions.moveBoundary(boundary.time_s, boundary.was_s),
          },
        ]
      : []),
    { text: "Remove", key: "Delete", off, run: () => actions.removeBoundary(index) },
  ];
}
