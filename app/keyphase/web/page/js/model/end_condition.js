/** When a segment is over, in words and as the figures that a person may change. */

export const DOUBT = "Its own demonstration does not end so.";

/** @type {Object<string, string>} */
const GRIPPED = { grasp: ", once it has grasped", release: ", as it lets go" };

/** @param {import("../messages/document_messages").EndConditionMessage} end */
export function howItEnds(end) {
  if (end.kind !== "contact" || end.threshold_N === undefined)
    return `ends at the pose${GRIPPED[end.gripper?.change] ?? ""}`;
  return `ends at ${end.release ? "−" : ""}${end.threshold_N.toFixed(1)} N`;
}

/**
 * The figures of an end condition, in the units that people use; `where` says which direction.
 * @type {{name: string, title: string, hint: string, unit: string, factor: number, low: number,
 *   high: number, kind: "contact"|"configuration"|null, may: boolean}[]}
 */
export const FIGURES = [
  figure(
    "threshold_N",
    "Threshold",
    "So much the force has to rise.",
    "N",
    1,
    0.01,
    1000,
    "contact",
  ),
  figure("offset_m", "Beyond", "How far to go on for it.", "mm", 1e3, 0, 500, "contact", true),
  figure(
    "position_tolerance_m",
    "Position",
    "How near the goal.",
    "mm",
    1e3,
    0.01,
    1000,
    "configuration",
  ),
  figure(
    "rotation_tolerance_rad",
    "Rotation",
    "How near the goal's orientation.",
    "deg",
    180 / Math.PI,
    0.01,
    180,
    "configuration",
  ),
  figure(
    "timeout_s",
    "Timeout",
    "So long without progress has failed.",
    "s",
    1,
    0.01,
    3600,
    null,
    true,
  ),
];

function figure(name, title, hint, unit, factor, low, high, kind, may = false) {
  return { name, title, hint, unit, factor, low, high, kind, may };
}

/** What an edit carries: the condition with one thing changed; whether it agrees is found anew. */
export function endWith(end, change) {
  const { agrees: _, ...rest } = { ...end, ...change };
  return Object.fromEntries(Object.entries(rest).filter(([, value]) => value !== undefined));
}

/** The condition of the other kind, to begin with. @param {"contact"|"configuration"} kind */
export function endOfKind(kind) {
  return kind === "contact"
    ? { kind, direction: [0, 0, 1], threshold_N: 2, release: false }
    : { kind, position_tolerance_m: 0.005, rotation_tolerance_rad: (3 * Math.PI) / 180 };
}

/** A unit vector; null where there is no direction. @param {number[]} parts */
export function direction(parts) {
  const length = Math.hypot(...parts);
  return Number.isFinite(length) && length > 1e-6 ? parts.map((part) => part / length) : null;
}
