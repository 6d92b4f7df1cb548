/** What shapes the segments, what the scene shows, and which robot follows. */

import { el } from "../../lib/dom.js";
import {
  automaticValue,
  METHOD,
  parameterGroups,
  shareOf,
  valueAtShare,
  valueInForce,
} from "../../model/parameters.js";
import { button, choice, group, row, slider } from "./fields.js";
import { createAssessmentGroup, createSegmentAssessmentGroup } from "./assessment_group.js";
import { createEndGroup } from "./end_group.js";
import { createShownParts } from "./shown_parts.js";
import { createRobotGroup } from "./robot_group.js";

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createSegmentTab(store, actions) {
  const parameters = el("div");
  const method = choiceField(METHOD, actions);
  const reset = button("Reset to automatic", {
    hint: "All parameters as they were.",
    run: actions.resetParameters,
  });
  const spread = button("Apply to all…", {
    hint: "Give these parameters to all recordings of the folder, after a look at what would change.",
    look: "primary",
    run: () => actions.spread("look"),
  });
  /** @type {{show: (state: import("../../model/state.js").State) => void, disable: (off: boolean) => void}[]} */
  let fields = [];
  let built = "";

  /** @param {import("../../model/types.js").Doc} doc */
  function build(doc) {
    const groups = parameterGroups(doc);
    const now = JSON.stringify(groups.map(({ fields: own }) => own.map(({ name }) => name)));
    if (now === built) return;
    built = now;
    const made = groups.map((one) => ({
      title: one.title,
      fields: one.fields.map((field) => fieldOf(field, actions)),
    }));
    fields = [method, ...made.flatMap((one) => one.fields)];
    parameters.replaceChildren(
      ...made.map((one) => group(one.title, {}, ...one.fields.map(({ node }) => node))),
    );
  }

  store.on(["document", "held", "defaults", "readOnly"], (state) => {
    const { document: doc, readOnly } = state;
    parameters.parentElement?.classList.toggle("without", !doc);
    if (!doc) return;
    build(doc);
    // The method can be chosen where there is more than one.
    /** @type {HTMLElement} */ (method.node.parentElement).hidden = !("turns" in doc.parameters);
    for (const field of fields) {
      field.show(state);
      field.disable(readOnly);
    }
    reset.disabled = spread.disabled = readOnly;
  });
  return el(
    "div",
    { class: "panel-body without" },
    el("p", {
      class: "hint only-without",
      text: "What shapes the segments stands here once a recording is open.",
    }),
    el("div", { class: "group plain" }, method.node),
    createEndGroup(store, actions),
    createSegmentAssessmentGroup(store, actions),
    parameters,
    createShownParts(store, actions),
    createRobotGroup(store, actions),
    createAssessmentGroup(store, actions),
    row(reset, spread),
  );
}

/** @param {import("../../model/parameters.js").Field} field */
function fieldOf(field, actions) {
  return field.kind === "number" ? numberField(field, actions) : choiceField(field, actions);
}

/** @param {import("../../model/parameters.js").NumberField} field */
function numberField(field, actions) {
  const { name, title, hint, low, high } = field;
  const control = slider({
    title,
    hint,
    low,
    high: field.course === "linear" ? undefined : high,
    step: "any",
    share: (value) => shareOf(field, value),
    value: (share) => valueAtShare(field, share),
    told: (value, held, event) => actions.setParameter(name, value, held, event),
  });
  return {
    node: control.node,
    disable: control.disable,
    show({ document: doc, held, defaults }) {
      control.show(valueInForce(doc, held, name), automaticValue(doc, defaults, name));
    },
  };
}

/** @param {import("../../model/parameters.js").ChoiceField} field */
function choiceField({ name, title, options, hint }, actions) {
  const whole = name === "gaussians";
  const control = choice(title, hint, (value) =>
    actions.setParameter(name, whole ? (value ? Number(value) : null) : value, false),
  );
  return {
    node: control.node,
    disable: control.disable,
    show({ document: doc, held }) {
      const value = String(valueInForce(doc, held, name) ?? "");
      control.show(whole ? gaussianOptions(options, doc, value) : options, value);
    },
  };
}

/**
 * How many were found where that is left to the program, and more than are offered if given.
 * @param {import("../../model/types.js").Doc} doc
 */
function gaussianOptions(options, doc, value) {
  const found = value ? "" : ` (${doc.gaussians})`;
  const more = options.some((one) => one.value === value) ? [] : [{ value, text: value }];
  return [{ value: "", text: `automatic${found}` }, ...options.slice(1), ...more];
}
