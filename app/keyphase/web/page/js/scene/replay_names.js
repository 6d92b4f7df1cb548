/** What is named over the scene of a replay: its skills at their paths, and the measured force. */

import { segmentFill } from "../lib/colors.js";
import { el } from "../lib/dom.js";
import { measureless } from "../model/label_forms.js";

/** With more skills than this only the one that runs is named. */
const MOST = 6;

/**
 * A segment that is replayed several times is named once.
 * @param {import("../model/types.js").Replay} replay
 * @returns {import("./names.js").Named[]}
 */
export function skillNames({ skills, current }) {
  const first = skills.map(
    ({ segment }, index) => skills.findIndex((one) => one.segment === segment) === index,
  );
  const named = skills.flatMap(({ segment }, index) =>
    segment !== null && first[index] ? [index] : [],
  );
  const running =
    current === null ? null : skills.findIndex((one) => one.segment === skills[current].segment);
  const shown = named.length > MOST ? named.filter((index) => index === running) : named;
  return shown.map((index) => {
    const { middle_m: at, segment, color: number, label } = skills[index];
    const color = segmentFill({ color: number });
    return {
      at,
      color,
      title: label,
      isSelected: index === running,
      mark: el("i", { style: { background: color } }),
      text: `${segment + 1} ${measureless(skills[index])}`,
    };
  });
}

/** The measured force, before anything was measured. @returns {import("./names.js").Named} */
export function forceName() {
  const color = "var(--origin-force)";
  const mark = el("i", { style: { background: color } });
  return { at: [0, 0, 0], color, title: "Measured force", isSelected: false, mark, text: "" };
}

/**
 * The force's size at the tip of its arrow; null where the scene draws none.
 * @param {import("../model/types.js").Replay} replay
 * @param {import("../replay/samples.js").Samples|null} samples
 * @returns {{at: number[], text: string}|null}
 */
export function forceNow({ zero_m, force_arrow: arrow }, samples) {
  if (!samples?.count) return null;
  const newest = (name) =>
    ["x", "y", "z"].map((axis) => samples.columns.get(`${name}_${axis}`)[samples.count - 1]);
  const force = newest("force");
  const size = Math.hypot(...force);
  if (size < arrow.least_N) return null;
  const at = newest("position").map(
    (mm, k) => zero_m[k] + mm / 1000 + arrow.beside_m[k] + arrow.metres_per_N * force[k],
  );
  return { at, text: `${size.toFixed(1)} N` };
}
