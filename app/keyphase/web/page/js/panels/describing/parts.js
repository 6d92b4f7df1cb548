/** What a column can be, in words, and which columns go together. */

/** @type {Object<string, string>} */
export const PART_TEXTS = {
  ignore: "not read",
  time: "time",
  seconds: "time, seconds",
  nanoseconds: "time, nanoseconds",
  demonstration: "number of the demonstration",
  x: "position x",
  y: "position y",
  z: "position z",
  qw: "quaternion w",
  qx: "quaternion x",
  qy: "quaternion y",
  qz: "quaternion z",
  quaternion: "quaternion, one of four",
  roll: "turn about x",
  pitch: "turn about y",
  yaw: "turn about z",
  rot6d: "rot6d, one of six",
  rotation: "rotation matrix, one of nine",
  pose: "4x4 matrix, one of 16",
  fx: "force x",
  fy: "force y",
  fz: "force z",
  tx: "torque x",
  ty: "torque y",
  tz: "torque z",
  gripper: "gripper",
  joint: "joint",
};

/** @type {Object<string, string[]>} the columns that follow the first of a vector */
const FOLLOWING = {
  x: ["y", "z"],
  qw: ["qx", "qy", "qz"],
  qx: ["qy", "qz", "qw"],
  quaternion: ["quaternion", "quaternion", "quaternion"],
  roll: ["pitch", "yaw"],
  rot6d: Array(5).fill("rot6d"),
  rotation: Array(8).fill("rotation"),
  pose: Array(15).fill("pose"),
  fx: ["fy", "fz"],
  tx: ["ty", "tz"],
  joint: Array(15).fill("joint"),
};

/**
 * The parts with one column changed; the rest of its vector follows, as far as the next columns are
 * of the same array and not read yet.
 * @param {readonly string[]} parts
 * @param {readonly string[]} names
 * @param {number} column
 * @param {string} part
 */
export function withPart(parts, names, column, part) {
  const changed = [...parts];
  changed[column] = part;
  for (const [i, next] of (FOLLOWING[part] ?? []).entries()) {
    const at = column + 1 + i;
    if (changed[at] !== "ignore" || arrayOf(names[at]) !== arrayOf(names[column])) break;
    changed[at] = next;
  }
  return changed;
}

/** The name of the array a column is one of. @param {string} name */
export const arrayOf = (name) => name.replace(/[[.]?\w+\]?$/, "");
