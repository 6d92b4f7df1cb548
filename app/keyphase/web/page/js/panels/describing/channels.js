/** The columns of a binary format, one below the other: what each is, and its first numbers. */

import { el } from "../../lib/dom.js";
import { PART_TEXTS, withPart } from "./parts.js";

/** So many columns that are not read are shown before one narrows them. */
const MOST_UNREAD = 40;

/** @type {{of: string, typed: string}} what the columns of a recording are narrowed to */
const narrowed = { of: "", typed: "" };

/**
 * @param {import("./describing.js").Proposal} table
 * @param {import("./describing.js").Change} change
 */
export function drawChannels(table, change) {
  if (narrowed.of !== table.id) Object.assign(narrowed, { of: table.id, typed: "" });
  const body = el("tbody", {});
  const told = el("span", { class: "quiet" });
  const fill = () => fillRows(table, change, body, told);
  const narrow = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "search",
      placeholder: "Narrow by name",
      "aria-label": "Narrow the columns by name",
      value: narrowed.typed,
      data: { field: "narrow" },
      on: {
        input: () => {
          narrowed.typed = narrow.value;
          fill();
        },
      },
    })
  );
  fill();
  const heads = ["Column", "What it is", "First numbers", "Why"];
  return el(
    "div",
    {},
    el("div", { class: "describing-narrow" }, narrow, told),
    el(
      "div",
      { class: "describing-table", tabindex: "0", role: "region", "aria-label": "The columns" },
      el(
        "table",
        { class: "channels" },
        el("thead", {}, el("tr", {}, ...heads.map((text) => el("th", { scope: "col", text })))),
        body,
      ),
    ),
  );
}

function fillRows(table, change, body, told) {
  const shown = shownColumns(table, narrowed.typed);
  body.replaceChildren(...shown.map((column) => channel(table, column, change)));
  const count = table.names.length;
  told.textContent =
    shown.length < count ? `${shown.length} of ${count} columns are shown` : `${count} columns`;
}

/**
 * What is read first, then what is not, as far as its name fits.
 * @param {{names: readonly string[], evidence: readonly string[], answers: {parts: readonly string[]}}} table
 * @param {string} typed
 */
export function shownColumns({ names, evidence, answers: { parts } }, typed) {
  const word = typed.trim().toLowerCase();
  const fits = names.flatMap((name, i) => (name.toLowerCase().includes(word) ? [i] : []));
  const isRead = (i) => parts[i] !== "ignore";
  const read = names.flatMap((_, i) => (isRead(i) || evidence[i] ? [i] : []));
  const rest = fits.filter((i) => !read.includes(i)).slice(0, MOST_UNREAD);
  return [...(word ? read.filter((i) => fits.includes(i)) : read), ...rest];
}

function channel({ answers, names, rows, evidence, choices }, column, change) {
  const part = answers.parts[column];
  const side = answers.sides[column];
  const why = evidence[column] ?? "";
  const select = /** @type {HTMLSelectElement} */ (
    el(
      "select",
      {
        "aria-label": `What ${names[column]} is`,
        data: { field: `column ${column}` },
        on: {
          change: () => change({ parts: withPart(answers.parts, names, column, select.value) }),
        },
      },
      ...choices.map((one) =>
        el("option", { value: one, text: PART_TEXTS[one] ?? one, selected: one === part }),
      ),
    )
  );
  const numbers = rows.map((row) => row[column]).filter((cell) => cell !== "");
  return el(
    "tr",
    { class: part === "ignore" ? "ignored" : "" },
    el("th", { scope: "row", text: names[column], title: names[column] }),
    el("td", {}, select, side ? el("small", { text: ` ${side}` }) : ""),
    el("td", { class: "numbers", text: numbers.join("  ") || "none" }),
    el("td", { class: "reason", text: why, title: why }),
  );
}
