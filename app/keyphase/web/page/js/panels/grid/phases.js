/** The phases of the task beside the grid: their order, colours, ends, and changes in all. */

import { el, icon, redraw } from "../../lib/dom.js";
import { plural } from "../../lib/format.js";
import {
  COLORS,
  colorOf,
  countOf,
  namesBeside,
  phaseNames,
  shifted,
} from "../../model/recordings/grid.js";
import { lastPhaseStep } from "../../model/recordings/phase_steps.js";

/**
 * @typedef {import("../../model/recordings/grid.js").Phase} Phase
 * @typedef {import("../../model/recordings/grid.js").Grid} Grid
 */

/** @type {Phase["end"][]} */
const ENDS = ["contact", "release", "configuration", "gripper"];

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createPhases(store, actions) {
  const list = el("ol", { class: "phases" });
  const none = el("p", {
    class: "quiet",
    text: "None yet. The first recording that is done writes them (K), or type one here.",
  });
  const others = el("div", { class: "phases-others" });
  const input = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "text",
      placeholder: "Another phase",
      "aria-label": "Name of another phase",
      maxlength: 200,
    })
  );
  const add = el(
    "form",
    { class: "phases-add" },
    input,
    el("button", { type: "submit", class: "button", text: "Add" }),
  );
  add.addEventListener("submit", (event) => {
    event.preventDefault();
    const name = input.value.trim();
    const { grid } = store.state;
    if (!grid || !name || grid.phases.some((one) => one.name === name)) return;
    actions.writePhases([...grid.phases, phaseOf(name, grid)]);
    input.value = "";
  });
  const undo = el("button", {
    type: "button",
    class: "link",
    text: "Undo",
    title: "The list as it was before its last change",
    "aria-label": "Undo the last change of the list of phases",
    on: { click: () => actions.undoPhases() },
  });
  const node = el(
    "aside",
    { class: "grid-phases", "aria-label": "Phases of the task" },
    el("div", { class: "phases-head" }, el("h3", { text: "Phases of the task" }), undo),
    none,
    list,
    add,
    others,
  );

  // Without a recording there is no task.
  for (const one of [undo, none, add]) one.hidden = true;
  store.on(["grid", "gridChange", "readOnly", "phaseSteps"], (state) => {
    const { grid, readOnly, phaseSteps } = state;
    if (!grid) return;
    undo.hidden = readOnly || !lastPhaseStep(phaseSteps, grid.phases);
    none.hidden = grid.phases.length > 0;
    add.hidden = readOnly;
    redraw(
      list,
      "at",
      grid.phases.map((phase, at) => drawPhase(phase, at, grid, actions, readOnly)),
    );
    const own = grid.phases.map(({ name }) => name);
    const alike = grid.rows.filter(({ standing }) => standing !== "outlier");
    const rest = namesBeside(own, alike).filter((name) => countOf(grid, name));
    redraw(others, "at", rest.length ? drawOthers(rest, grid, actions, readOnly) : []);
  });
  return node;
}

/** @param {string} name @param {Grid} grid @returns {Phase} */
const phaseOf = (name, grid) => ({
  name,
  color: COLORS[grid.phases.length % COLORS.length],
  end: "configuration",
  optional: false,
  repeated: false,
});

/** @param {Phase} phase @param {number} at @param {Grid} grid @param {any} actions @param {boolean} readOnly */
function drawPhase(phase, at, grid, actions, readOnly) {
  const { phases } = grid;
  const write = (change) =>
    actions.writePhases(phases.map((one, k) => (k === at ? { ...one, ...change } : one)));
  const next = COLORS[(COLORS.indexOf(phase.color.toUpperCase()) + 1) % COLORS.length];
  const button = (sign, told, run, off = false) =>
    el(
      "button",
      {
        type: "button",
        class: "tool",
        title: told,
        "aria-label": `${told}: ${phase.name}`,
        disabled: off || readOnly,
        data: { at: `${at} ${sign}` },
        on: { click: run },
      },
      icon(sign, "small"),
    );
  return el(
    "li",
    {},
    el("span", {
      class: "quiet",
      text: String(at + 1),
      title: at < 9 ? `Key ${at + 1} gives the selected segment this name` : "",
    }),
    el("button", {
      type: "button",
      class: "phase-color",
      style: { background: phase.color },
      title: "Another colour",
      "aria-label": `Another colour: ${phase.name}`,
      disabled: readOnly,
      data: { at: `${at} color` },
      on: { click: () => write({ color: next }) },
    }),
    nameField(phase.name, `${at} name`, actions, readOnly),
    button("up", "Earlier", () => actions.writePhases(shifted(phases, at, -1)), at === 0),
    button(
      "down",
      "Later",
      () => actions.writePhases(shifted(phases, at, 1)),
      at === phases.length - 1,
    ),
    button("close", "Out of the list; recordings stay as they are", () =>
      actions.writePhases(phases.toSpliced(at, 1)),
    ),
    drawMore(phase, at, grid, { actions, readOnly, write }),
  );
}

/** @param {Phase} phase @param {number} at @param {Grid} grid @param {{actions: any, readOnly: boolean, write: (change: Partial<Phase>) => void}} given */
function drawMore(phase, at, grid, { actions, readOnly, write }) {
  const end = /** @type {HTMLSelectElement} */ (
    el(
      "select",
      {
        "aria-label": `What ${phase.name} ends with`,
        disabled: readOnly,
        data: { at: `${at} end` },
      },
      ...ENDS.map((value) => el("option", { value, text: value, selected: value === phase.end })),
    )
  );
  end.addEventListener("change", () => write({ end: /** @type {Phase["end"]} */ (end.value) }));
  const tick = (name, told) => {
    const box = /** @type {HTMLInputElement} */ (
      el("input", {
        type: "checkbox",
        checked: phase[name],
        disabled: readOnly,
        data: { at: `${at} ${name}` },
      })
    );
    box.addEventListener("change", () => write({ [name]: box.checked }));
    return el("label", { title: told }, box, name);
  };
  return el(
    "div",
    { class: "phase-more" },
    end,
    tick("optional", "Not every recording has it"),
    tick("repeated", "A recording may have it several times"),
    dropButton(phase.name, grid, `${at} drop`, actions, readOnly),
  );
}

/** Names that recordings have beside the phases of the task. @param {string[]} names @param {Grid} grid @param {any} actions @param {boolean} readOnly */
function drawOthers(names, grid, actions, readOnly) {
  const drawn = names.map((name, k) =>
    el(
      "div",
      { class: "phases-other" },
      el("span", {
        class: "phase-color",
        style: {
          background: colorOf(
            grid,
            { label: name, color: 0, start_s: 0, end_s: 0, proposed: false },
            phaseNames(grid),
          ),
        },
      }),
      nameField(name, `other ${k}`, actions, readOnly),
      el(
        "button",
        {
          type: "button",
          class: "tool",
          title: "Make it a phase of the task",
          "aria-label": `Make it a phase of the task: ${name}`,
          disabled: readOnly,
          data: { at: `other ${k} add` },
          on: { click: () => actions.writePhases([...grid.phases, phaseOf(name, grid)]) },
        },
        icon("plus", "small"),
      ),
      dropButton(name, grid, `other ${k} drop`, actions, readOnly),
    ),
  );
  return [el("h3", { text: "Other names in the recordings" }), ...drawn];
}

/** A name; another one is given in all recordings. @param {string} name @param {string} at @param {any} actions @param {boolean} readOnly */
function nameField(name, at, actions, readOnly) {
  const field = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "text",
      value: name,
      maxlength: 200,
      title: "Another name is given in all recordings, after a look at them",
      "aria-label": `Name of ${name}, in all recordings`,
      readonly: readOnly,
      data: { at },
    })
  );
  field.addEventListener("change", () => {
    const to = field.value.trim();
    if (!to) field.value = name;
    else actions.renamePhase(name, to);
  });
  field.addEventListener("keydown", (event) => {
    if (event.key !== "Escape" || field.value === name) return;
    event.preventDefault();
    event.stopPropagation();
    field.value = name;
  });
  return field;
}

/** @param {string} name @param {Grid} grid @param {string} at @param {any} actions @param {boolean} readOnly */
function dropButton(name, grid, at, actions, readOnly) {
  const count = countOf(grid, name);
  return el("button", {
    type: "button",
    class: "link",
    text: "Drop in all",
    title: `${plural(count, "recording has", "recordings have")} it; see first what would change`,
    "aria-label": `Drop in all: ${name}`,
    disabled: readOnly || !count,
    data: { at },
    on: { click: () => actions.considerInAll({ label: name, to: null }) },
  });
}
