/** What is executed, above the segments it is made of: its place in the plan, and how it ends. */

import { segmentFill } from "../../lib/colors.js";
import { svg } from "../../lib/dom.js";
import { textWidth } from "../../lib/text_width.js";
import { runsOf, runText } from "../runs.js";
import { DOUBT, howItEnds } from "../../model/end_condition.js";
import { isCrowded, segmentsInView } from "../dense.js";

const FONT = "11px";

/**
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {import("../../model/rows.js").Row} row
 */
export function drawSkills({ document: doc }, scale, { y, height }) {
  const ground = svg("rect", { y, width: scale.width, height, class: "band-ground" });
  if (isCrowded(segmentsInView(doc.segments, scale).length, scale)) return [ground];
  /** @type {Map<number, number[]>} places in the plan, by the segment in view */
  const places = new Map();
  doc.plan.forEach(({ segment: index }, k) => {
    const segment = doc.segments[index];
    if (!segment || segment.end_s < scale.from || segment.start_s > scale.to) return;
    places.set(index, [...(places.get(index) ?? []), k + 1]);
  });
  const inTime = [...places].sort(([a], [b]) => a - b);
  const skills = inTime.flatMap(([index, at]) =>
    drawSkill(doc.segments[index], at, scale, y, height),
  );
  return [ground, ...skills, ...drawRuns(doc, inTime, scale, y + height - 1)];
}

/** The places of brackets that are too narrow for their own. */
function drawRuns({ segments }, places, scale, foot) {
  const marks = places.map(([index, at]) => {
    const { left, right } = bracketOf(segments[index], scale);
    const fits = textWidth(at.join(", "), FONT) <= right - left;
    return { number: at[0], left, right, fits };
  });
  const widthOf = (first, last) => textWidth(runText(first, last), FONT) + 6;
  return runsOf(marks, widthOf).map(({ first, last, left, right }) =>
    svg("text", {
      class: "skill-run",
      x: (left + right) / 2,
      y: foot - 6.5,
      "text-anchor": "middle",
      text: runText(first, last),
    }),
  );
}

/** Where a segment's bracket is [px]. */
function bracketOf(segment, scale) {
  return {
    left: Math.max(scale.x(segment.start_s), 0) + 2,
    right: Math.min(scale.x(segment.end_s), scale.width) - 2,
  };
}

/** A bracket over its segment, closed at the end by what ends it. */
function drawSkill(segment, places, scale, y, height) {
  const { left, right } = bracketOf(segment, scale);
  if (right - left < 3) return [];
  const { kind, agrees } = segment.end_condition;
  const ends = howItEnds(segment.end_condition);
  const order = places.join(", ");
  const room = right - left;
  const text = [`skill ${order}, ${ends}`, `${order}, ${ends}`, order].find(
    (form) => textWidth(form, FONT) <= room - 14,
  );
  // Where there is no room for both, the number says more than the sign of the end.
  const alone = !text && textWidth(order, FONT) <= room;
  const foot = y + height - 1;
  const doubted = agrees === false;
  return [
    svg(
      "g",
      { class: `skill ${doubted ? "doubted" : ""}`, data: { skill: order } },
      svg("title", {
        text: `Skill ${order}: ${segment.label}, ${ends}.${doubted ? ` ${DOUBT}` : ""}`,
      }),
      svg("path", {
        d: `M${left} ${foot}v-4h${right - left}v4`,
        style: { stroke: segmentFill(segment) },
      }),
      text && kind === "contact"
        ? svg("path", { d: `M${right - 4} ${foot - 8}h8l-4 5z`, class: "skill-end" })
        : "",
      text && kind !== "contact"
        ? svg("circle", { cx: right, cy: foot - 5.5, r: 2.6, class: "skill-end" })
        : "",
      text ? svg("text", { x: left + 2, y: foot - 6.5, text }) : "",
      alone
        ? svg("text", {
            x: (left + right) / 2,
            y: foot - 6.5,
            "text-anchor": "middle",
            text: order,
          })
        : "",
    ),
  ];
}
