/** The native controls of the dialog about a table. */

import { el } from "../../lib/dom.js";

/**
 * A labelled list to choose from.
 * @param {string} label
 * @param {string} field
 * @param {string} value
 * @param {readonly (readonly [string, string])[]} options value and text of each
 * @param {(value: string) => void} choose
 * @param {string} [title]
 */
export function choice(label, field, value, options, choose, title = "") {
  const select = /** @type {HTMLSelectElement} */ (
    el(
      "select",
      { data: { field }, title, on: { change: () => choose(select.value) } },
      ...options.map(([key, text]) => el("option", { value: key, text, selected: key === value })),
    )
  );
  return el("label", { class: "describing-field", title }, el("span", { text: label }), select);
}

/**
 * A labelled number; nothing is 0 or null, as the caller says.
 * @param {string} label
 * @param {string} field
 * @param {number|null} value
 * @param {(value: number|null) => void} choose
 * @param {{min: number, step: number|"any", title?: string}} how
 */
export function number(label, field, value, choose, { min, step, title = "" }) {
  const input = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "number",
      min,
      step,
      value: value ?? "",
      data: { field },
      on: {
        change: () => {
          const typed = input.valueAsNumber;
          if (Number.isNaN(typed)) choose(null);
          else if (typed >= min) choose(typed);
        },
      },
    })
  );
  return el("label", { class: "describing-field", title }, el("span", { text: label }), input);
}

/**
 * A labelled text.
 * @param {string} label
 * @param {string} field
 * @param {string} value
 * @param {(value: string) => void} choose
 */
export function text(label, field, value, choose) {
  const input = /** @type {HTMLInputElement} */ (
    el("input", { type: "text", value, data: { field }, on: { change: () => choose(input.value) } })
  );
  return el("label", { class: "describing-field" }, el("span", { text: label }), input);
}
