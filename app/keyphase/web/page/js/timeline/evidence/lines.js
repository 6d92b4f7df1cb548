/** The two lines over the evidence: each with its tag in the margin and the automatic value's notch. */

import { originColor } from "../../lib/colors.js";
import { svg } from "../../lib/dom.js";
import { apart, probabilityText } from "../../model/evidence.js";

const TAG_PX = 17;
const NOTCH_PX = 4;

/** Where the tags stand in the margin: at their lines, but never over each other. */
export function tagLevels(lines, y, height) {
  const wanted = lines.map(({ value }) => y(value));
  return apart(wanted, TAG_PX, [9, height - 9]);
}

/**
 * Lines, tags and notches.
 * @param {ReturnType<typeof import("../../model/evidence.js").linesOf>} lines
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 */
export function drawLines(lines, state, scale, y, height) {
  const tags = tagLevels(lines, y, height);
  return lines.flatMap((line, k) => {
    const color = originColor(line.origin);
    const held = line.parameter in state.held;
    return [
      ...(line.automatic === null ? [] : notch(line, held, color, scale.width, y(line.automatic))),
      svg("path", {
        d: `M0 ${crisp(y(line.value))}H${scale.width}`,
        class: "evidence-line",
        data: { line: line.parameter },
        style: { stroke: color },
      }),
      tag(line, color, scale.width, y(line.value), tags[k], state.small),
    ];
  });
}

const crisp = (level) => Math.round(level) + 0.5;

/** A short mark at the end of the plot; all the way across while the line is held. */
function notch({ parameter, automatic }, held, color, width, level) {
  const at = crisp(level);
  const mark = svg("path", {
    d: `M${width - NOTCH_PX} ${at}l${NOTCH_PX}-3.5v7z`,
    class: "evidence-notch",
    data: { notch: parameter, automatic },
    style: { fill: color },
  });
  const way = svg("path", {
    d: `M0 ${at}H${width}`,
    class: "evidence-automatic",
    style: { stroke: color },
  });
  return held ? [way, mark] : [mark];
}

/** The value in the margin, joined to its line where it had to move aside. */
function tag({ parameter, title, value }, color, width, level, tagY, small) {
  const wide = small ? 28 : 32;
  const left = width + 2;
  return svg(
    "g",
    { class: "evidence-tag", data: { tag: parameter }, style: { stroke: color } },
    svg("title", { text: title }),
    svg("path", {
      d: `M${left} ${crisp(level)}L${left + 6} ${tagY - 8}h${wide - 1}a2 2 0 0 1 2 2v12a2 2 0 0 1-2 2h${1 - wide}z`,
    }),
    svg("text", { x: left + 8, y: tagY + 3.6, text: probabilityText(value) }),
  );
}
