/** The recipe that answers make, which a person may write anew. */

import { el } from "../../lib/dom.js";

/**
 * @param {import("./describing.js").Proposal} table
 * @param {import("./describing.js").Change} change
 */
export function drawRecipe({ answers, recipe }, change) {
  const text = answers.text || recipe;
  if (!text) return null;
  const area = /** @type {HTMLTextAreaElement} */ (
    el("textarea", {
      rows: 9,
      spellcheck: "false",
      "aria-label": "The recipe",
      data: { field: "recipe" },
      on: { change: () => change({ text: area.value }) },
    })
  );
  area.value = text;
  return el(
    "details",
    {},
    el("summary", { text: "The recipe that is written beside it; it may be changed here" }),
    area,
  );
}
