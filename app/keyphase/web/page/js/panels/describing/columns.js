/** The first rows of a table, and over each column what it is. */

import { el } from "../../lib/dom.js";
import { PART_TEXTS } from "./parts.js";

/**
 * @param {import("./describing.js").Proposal} table
 * @param {import("./describing.js").Change} change
 */
export function drawColumns({ answers, names, rows, evidence, choices }, change) {
  const { parts } = answers;
  const choose = (column, part) =>
    change({ parts: parts.map((one, i) => (i === column ? part : one)) });
  const head = parts.map((part, column) => {
    const name = names[column] || `column ${column + 1}`;
    const why = evidence[column] ?? "";
    const select = /** @type {HTMLSelectElement} */ (
      el(
        "select",
        {
          "aria-label": `What ${name} is`,
          title: why,
          data: { field: `column ${column}` },
          on: { change: () => choose(column, select.value) },
        },
        ...choices.map((one) =>
          el("option", { value: one, text: PART_TEXTS[one] ?? one, selected: one === part }),
        ),
      )
    );
    return el(
      "th",
      { scope: "col", class: part === "ignore" ? "ignored" : "" },
      select,
      el("b", { text: name, title: name }),
      el("small", { text: why || " ", title: why }),
    );
  });
  return el(
    "div",
    { class: "describing-table", tabindex: "0", role: "region", "aria-label": "The first rows" },
    el(
      "table",
      {},
      el("thead", {}, el("tr", {}, ...head)),
      el(
        "tbody",
        {},
        ...rows.map((row) =>
          el(
            "tr",
            {},
            ...row.map((cell, i) =>
              el("td", { class: parts[i] === "ignore" ? "ignored" : "", text: cell }),
            ),
          ),
        ),
      ),
    ),
  );
}
