/** Units of what a table holds, and its rate where it has no time. */

import { el } from "../../lib/dom.js";
import { choice, number, text } from "./fields.js";

/** Quantity, its name for people, and the columns that have it. */
const QUANTITIES = /** @type {const} */ ([
  ["time", "Time", ["time"]],
  ["length", "Position", ["x", "y", "z", "pose"]],
  ["angle", "Angles", ["roll", "pitch", "yaw"]],
  ["force", "Force", ["fx", "fy", "fz"]],
  ["torque", "Torque", ["tx", "ty", "tz"]],
  ["joints", "Joints", ["joint"]],
  ["gripper", "Gripper", ["gripper"]],
]);
const SEQUENCES = ["xyz", "zyx", "XYZ", "ZYX", "ZYZ", "zyz", "rotation_vector"];
const ORDERS = [
  ["wxyz", "w x y z"],
  ["xyzw", "x y z w"],
];
const LAYOUTS = [
  ["row_major", "row by row"],
  ["column_major", "column by column"],
];
/** A section of a recipe, its name for people, and the columns that make it. */
const CLOCKED = /** @type {const} */ ([
  ["orientation", "Orientation", ["qw", "quaternion", "roll", "rot6d", "rotation"]],
  ["force", "Force", ["fx"]],
  ["torque", "Torque", ["tx"]],
  ["gripper", "Gripper", ["gripper"]],
  ["joints", "Joints", ["joint"]],
]);

/**
 * @param {import("./describing.js").Proposal} table
 * @param {import("./describing.js").Change} change
 */
export function drawUnits(table, change) {
  const { answers, asked } = table;
  const has = (parts) => answers.parts.some((part) => parts.includes(part));
  const fields = answers.preset ? [] : unitFields(table, has, change);
  if (asked.includes("rate_hz"))
    fields.push(
      number(
        "Rows a second",
        "rate_hz",
        answers.rate_hz ?? null,
        (rate) => change({ rate_hz: rate }),
        { min: 0.001, step: "any", title: "No column is the time" },
      ),
    );
  fields.push(...turnFields(table, change), ...clockFields(table, has, change));
  fields.push(...robotFields(table, change));
  if (!answers.preset && has(["fx"])) fields.push(untouched(answers, change));
  return el(
    "section",
    { "aria-label": "Units" },
    el("h3", { text: answers.preset ? "What it leaves open" : "Units" }),
    ...fields,
  );
}

/**
 * @param {import("./describing.js").Proposal} table
 * @param {(parts: readonly string[]) => boolean} has
 * @param {import("./describing.js").Change} change
 */
function unitFields({ answers, units }, has, change) {
  return QUANTITIES.filter(
    ([quantity, , parts]) => has(parts) && !(quantity === "time" && answers.time_format),
  ).map(([quantity, label]) =>
    choice(
      `${label} in`,
      `unit ${quantity}`,
      answers.units[quantity] ?? "",
      [["", "choose"], ...(units[quantity] ?? []).map((u) => /** @type {const} */ ([u, u]))],
      (unit) => change({ units: { ...answers.units, [quantity]: unit } }),
    ),
  );
}

/** Order of a quaternion, layout of a matrix, axes of three angles. */
function turnFields({ answers, asked }, change) {
  const one = (question, label, options) =>
    asked.includes(question) &&
    choice(label, question, answers[question] ?? "", [["", "choose"], ...options], (value) =>
      change({ [question]: value }),
    );
  return [
    one("order", "Quaternion", ORDERS),
    one("layout", "Matrix", LAYOUTS),
    one(
      "sequence",
      "Turns are about",
      SEQUENCES.map((s) => [s, sequenceText(s)]),
    ),
  ].filter((field) => field instanceof HTMLElement);
}

/**
 * Which clock a section follows, where there is more than one.
 * @param {import("./describing.js").Proposal} table
 * @param {(parts: readonly string[]) => boolean} has
 * @param {import("./describing.js").Change} change
 */
function clockFields({ answers, clocks }, has, change) {
  if (answers.preset || answers.sides.length > 0 || clocks.length < 2) return [];
  return CLOCKED.filter(([section, , parts]) => has(parts) || answers.clocks[section]).map(
    ([section, label]) =>
      choice(
        `${label} at`,
        `clock ${section}`,
        answers.clocks[section] ?? "",
        [["", "the time"], ...clocks.map((name) => /** @type {const} */ ([name, name]))],
        (name) => {
          const { [section]: _, ...others } = answers.clocks;
          change({ clocks: name ? { ...others, [section]: name } : others });
        },
      ),
  );
}

/** Where joints say where the tool is, and which way their torques act. */
function robotFields({ answers, asked }, change) {
  const fields = [];
  if (asked.includes("robot"))
    fields.push(
      text("Robot (URDF beside it)", "urdf", answers.urdf, (urdf) => change({ urdf })),
      text("Its tool is the link", "tool_frame", answers.tool_frame, (name) =>
        change({ tool_frame: name }),
      ),
    );
  if (asked.includes("torque_sign"))
    fields.push(
      choice(
        "Joint torques act",
        "torque_sign",
        String(answers.torque_sign),
        [
          ["0", "choose"],
          ["1", "on the robot"],
          ["-1", "on what it touches"],
        ],
        (sign) => change({ torque_sign: sign === "1" ? 1 : sign === "-1" ? -1 : 0 }),
      ),
    );
  return fields;
}

function untouched(answers, change) {
  return number(
    "Untouched for the first [s]",
    "from_first_s",
    answers.from_first_s ?? null,
    (seconds) => change({ from_first_s: seconds }),
    {
      min: 0.001,
      step: "any",
      title: "The mean of the wrench over this time is taken out, where the sensor has an offset",
    },
  );
}

function sequenceText(sequence) {
  if (sequence === "rotation_vector") return "one axis (rotation vector)";
  const axes = [...sequence.toLowerCase()].join(", ");
  return sequence === sequence.toLowerCase() ? `fixed ${axes}` : `turned ${axes}`;
}
