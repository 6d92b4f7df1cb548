/** Recording by lead-through: a workcell, its takes, and the force that is felt. */

import { el } from "../../lib/dom.js";
import { button, choice, row } from "./fields.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createRecordTab(store, actions) {
  let chosen = "";
  const isOpen = () => Boolean(store.state.record?.workcell);
  const workcell = choice("Workcell", "The workcell that is recorded in.", (name) => {
    chosen = name;
    about.show(store.state.record, chosen);
    if (isOpen()) actions.record("open", name);
  });
  const record = button("Record", {
    look: "record",
    run: () => actions.record(store.state.record.recording ? "stop" : "start", chosen),
  });
  const open = button("Open workcell", {
    hint: "Try it without recording.",
    run: () => (isOpen() ? actions.record("close") : actions.record("open", chosen)),
  });
  const reset = button("Reset workcell", {
    hint: "Arm and parts back to their start.",
    run: () => actions.record("reset"),
  });
  const undo = button("Undo last take", { run: () => actions.record("undo_take") });
  const redo = button("Bring back take", { run: () => actions.record("redo_take") });
  const readings = createReadings();
  const about = createTitle();

  store.on(["record", "lookingOnly"], ({ record: now, lookingOnly }) => {
    if (!now) return;
    chosen = now.workcell ?? (chosen || now.choices[0].name);
    workcell.show(
      now.choices.map(({ name }) => ({ value: name, text: name })),
      chosen,
    );
    about.show(now, chosen);
    workcell.disable(now.recording || lookingOnly);
    record.lastElementChild.textContent = now.recording ? "Stop" : "Record";
    record.classList.toggle("on", now.recording);
    open.lastElementChild.textContent = now.workcell === null ? "Open workcell" : "Close workcell";
    record.disabled = lookingOnly;
    open.disabled = now.recording || lookingOnly;
    reset.disabled = open.disabled || now.workcell === null;
    undo.disabled = open.disabled || !now.can_undo;
    redo.disabled = open.disabled || !now.can_redo;
    readings.show(now);
  });
  return el(
    "div",
    { class: "panel-body" },
    el("div", { class: "group plain" }, workcell.node, about.node, row(record, open), row(reset)),
    readings.node,
    el("div", { class: "group plain" }, row(undo, redo)),
    el("p", {
      class: "hint",
      text:
        "Drag the arrows and arcs at the tool: the robot follows, and stops where it meets " +
        "something. Let go and it holds still. Stopping ends the take, opens it and closes the workcell.",
    }),
  );
}

/** What the chosen workcell is. */
function createTitle() {
  const node = el("p", { class: "hint" });
  return {
    node,
    /** @param {import("../../messages/control_messages").RecordMessage|null} record @param {string} chosen */
    show(record, chosen) {
      node.textContent = record?.choices.find(({ name }) => name === chosen)?.title ?? "";
    },
  };
}

/** How long the take is, and the force that is felt. */
function createReadings() {
  const seconds = el("output", { class: "reading" });
  const force = el("output", { class: "reading" });
  const bar = el("i");
  const meter = el(
    "div",
    { class: "meter", role: "meter", "aria-label": "Force", "aria-valuemin": 0 },
    bar,
  );
  const rows = [reading("Recorded", seconds), reading("Force", force)];
  return {
    node: el("div", { class: "group plain" }, ...rows, meter),
    /** @param {import("../../messages/control_messages").RecordMessage} now */
    show(now) {
      seconds.textContent = now.recorded_s === null ? "–" : `${now.recorded_s.toFixed(1)} s`;
      force.textContent = now.force_N === null ? "–" : `${now.force_N.toFixed(1)} N`;
      showMeter(meter, bar, now);
    },
  };
}

const reading = (text, output) => el("div", { class: "field" }, el("span", { text }), output);

/** @param {HTMLElement} meter @param {HTMLElement} bar @param {import("../../messages/control_messages").RecordMessage} record */
function showMeter(meter, bar, { force_N: newtons, full_force_N: full }) {
  meter.setAttribute("aria-valuemax", String(full));
  meter.setAttribute("aria-valuenow", String(Math.min(newtons ?? 0, full)));
  meter.setAttribute("aria-valuetext", `${(newtons ?? 0).toFixed(1)} N`);
  bar.style.setProperty("width", `${Math.min(100, (100 * (newtons ?? 0)) / full)}%`);
}
