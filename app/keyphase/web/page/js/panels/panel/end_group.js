/** When the selected segment is over, to be changed: an edit like any other. */

import { el } from "../../lib/dom.js";
import { direction, DOUBT, endOfKind, endWith, FIGURES } from "../../model/end_condition.js";
import { button, choice, group, line, toggle } from "./fields.js";

/** Decimals of a figure, and of a part of a direction, which has less room. */
const FIGURES_SHOWN = 3;
const PARTS_SHOWN = 2;
const KINDS = [
  { value: "contact", text: "contact" },
  { value: "configuration", text: "pose" },
];

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createEndGroup(store, actions) {
  const current = () => {
    const { document: doc, selected } = store.state;
    return doc && selected !== null ? doc.segments[selected] : null;
  };
  const change = (end) => {
    const segment = current();
    if (segment) actions.setEnd(segment, end);
  };
  const changed = (some) => change(endWith(current()?.end_condition ?? {}, some));

  const kind = choice("Ends at", "A contact, or the demonstrated pose.", (value) =>
    change(endOfKind(/** @type {"contact"|"configuration"} */ (value))),
  );
  const release = toggle("A release", "Over as the force falls.", (on) => changed({ release: on }));
  const way = vector((parts) => {
    const unit = direction(parts);
    if (unit) changed({ direction: unit });
  });
  const figures = FIGURES.map((one) => ({ ...one, ...figureField(one, changed) }));
  const doubt = el("p", { class: "hint bad", role: "status", text: DOUBT });
  const proposed = button("As proposed", {
    hint: "The end that the recording itself proposes.",
    run: () => change(null),
  });
  const made = group(
    "Ends when",
    { open: false },
    kind.node,
    way.node,
    ...figures.map(({ node }) => node),
    release.node,
    doubt,
    proposed,
  );
  made.hidden = true;
  store.on(["document", "selected", "readOnly"], ({ document: doc, selected, readOnly }) => {
    const segment = doc && selected !== null ? doc.segments[selected] : null;
    made.hidden = !segment;
    if (!segment) return;
    const end = segment.end_condition;
    const contact = end.kind === "contact";
    kind.show(KINDS, end.kind);
    way.node.hidden = release.node.hidden = !contact;
    if (contact) way.show(end.direction);
    release.show(Boolean(end.release));
    doubt.hidden = end.agrees !== false;
    for (const one of figures) {
      one.node.hidden = one.kind !== null && one.kind !== end.kind;
      one.show(end[one.name] ?? null);
    }
    for (const control of [kind, way, release, ...figures]) control.disable(readOnly);
    proposed.disabled = readOnly;
  });
  return made;
}

/** One figure; an empty one, where that may be, leaves it to the skill. */
function figureField({ name, title, hint, unit, factor, low, high, may }, changed) {
  const input = number(`${title}, ${unit}`, low, high);
  input.addEventListener("change", () => {
    if (input.value === "" && may) changed({ [name]: null });
    else if (input.value !== "" && input.checkValidity())
      changed({ [name]: Number(input.value) / factor });
    input.blur();
  });
  return {
    node: line(`${title}, ${unit}`, hint, input),
    show(value) {
      if (document.activeElement !== input)
        input.value = value === null ? "" : shown(value * factor, FIGURES_SHOWN);
    },
    disable: (off) => (input.disabled = off),
  };
}

/** Three figures of a direction. @param {(parts: number[]) => void} told */
function vector(told) {
  const inputs = ["x", "y", "z"].map((axis) => number(`Direction ${axis}`, -1, 1));
  /** What is shown is rounded; a part that nobody typed keeps its value. */
  let exact = [0, 0, 0];
  const partNow = (input, k) =>
    input.value === shown(exact[k], PARTS_SHOWN) ? exact[k] : Number(input.value);
  for (const input of inputs)
    input.addEventListener("change", () => {
      if (inputs.every((each) => each.value !== "" && each.checkValidity()))
        told(inputs.map(partNow));
      input.blur();
    });
  return {
    node: line(
      "Direction",
      "In which the force on the tool changes, x y z of the base.",
      inputs[0],
      el("span", { class: "vector" }, ...inputs),
    ),
    show(parts) {
      exact = parts;
      inputs.forEach((input, k) => {
        if (document.activeElement !== input) input.value = shown(parts[k], PARTS_SHOWN);
      });
    },
    disable: (off) => inputs.forEach((input) => (input.disabled = off)),
  };
}

function number(title, low, high) {
  return /** @type {HTMLInputElement} */ (
    el("input", {
      type: "number",
      class: "number",
      min: low,
      max: high,
      step: "any",
      "aria-label": title,
    })
  );
}

/** No more decimals than can be told apart. @param {number} value @param {number} decimals */
const shown = (value, decimals) => String(Number(value.toFixed(decimals)));
