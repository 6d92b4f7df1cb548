/** How the text of a table is laid out: encoding, separator, decimal mark, header. */

import { el } from "../../lib/dom.js";
import { choice, number } from "./fields.js";

const ENCODINGS = ["utf-8", "utf-16", "latin-1", "cp1252", "shift_jis", "gb18030"];
const SEPARATORS = /** @type {const} */ ([
  [",", "comma"],
  [";", "semicolon"],
  ["tab", "tab"],
  ["whitespace", "blanks"],
  ["|", "bar"],
  [":", "colon"],
]);

/** @type {[string, string][]} */
const DECIMALS = [
  [".", "point"],
  [",", "comma"],
];

/** @type {[string, string][]} */
const HEADERS = [
  ["true", "in the first line"],
  ["false", "none"],
];

/**
 * @param {import("./describing.js").Proposal} table
 * @param {import("./describing.js").Change} change
 */
export function drawLayout({ answers, layout_evidence: why }, change) {
  return el(
    "div",
    { class: "describing-layout", role: "group", "aria-label": "How the text is laid out" },
    choice(
      "Encoding",
      "encoding",
      answers.encoding,
      ENCODINGS.map((name) => /** @type {const} */ ([name, name])),
      (encoding) => change({ encoding }),
      why.encoding,
    ),
    choice(
      "Columns are parted by",
      "separator",
      answers.separator,
      SEPARATORS,
      (separator) => change({ separator }),
      why.separator,
    ),
    choice(
      "Decimal mark",
      "decimal",
      answers.decimal,
      DECIMALS,
      (decimal) => change({ decimal: decimal === "," ? "," : "." }),
      why.decimal,
    ),
    choice(
      "Names of the columns",
      "header",
      String(answers.header),
      HEADERS,
      (header) => change({ header: header === "true" }),
      why.header,
    ),
    number(
      "Lines to pass over first",
      "skip_lines",
      answers.skip_lines,
      (lines) => change({ skip_lines: lines ?? 0 }),
      { min: 0, step: 1 },
    ),
  );
}
