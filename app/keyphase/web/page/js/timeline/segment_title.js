/** A segment in words, for whoever rests the pointer on one too narrow for them. */

import { time } from "../lib/format.js";
import { DOUBT, howItEnds } from "../model/end_condition.js";

/**
 * Its number, name and times, and what is executed of it.
 * @param {import("../model/types.js").Doc} doc
 * @param {number} index
 */
export function segmentTitle({ segments, plan }, index) {
  const segment = segments[index];
  if (!segment) return "";
  const { label, kept, proposed, start_s: start, end_s: end } = segment;
  const named = `${index + 1} ${label}${proposed ? " (proposed)" : ""}`;
  const places = plan.flatMap((entry, k) => (entry.segment === index ? [k + 1] : []));
  const { agrees } = segment.end_condition;
  const run = `Skill ${places.join(", ")} of ${plan.length}, ${howItEnds(segment.end_condition)}.`;
  return [
    `${named}, ${time(start)} to ${time(end)} s`,
    kept ? "" : "Dropped: not in the plan.",
    places.length ? `${run}${agrees === false ? ` ${DOUBT}` : ""}` : "",
  ]
    .filter(Boolean)
    .join("\n");
}
