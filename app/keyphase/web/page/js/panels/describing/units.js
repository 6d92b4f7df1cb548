/** Units of what a table holds, and its rate where it has no time. */

import { el } from "../../lib/dom.js";
import { choice, number } from "./fields.js";

/** Quantity, its name for people, and the columns that have it. */
const QUANTITIES = /** @type {const} */ ([
  ["time", "Time", ["time"]],
  ["length", "Position", ["x", "y", "z"]],
  ["angle", "Angles", ["roll", "pitch", "yaw"]],
  ["force", "Force", ["fx", "fy", "fz"]],
  ["torque", "Torque", ["tx", "ty", "tz"]],
  ["joints", "Joints", ["joint"]],
  ["gripper", "Gripper", ["gripper"]],
]);
const SEQUENCES = ["xyz", "zyx", "XYZ", "ZYX", "ZYZ", "zyz"];

/**
 * @param {import("./describing.js").Proposal} table
 * @param {import("./describing.js").Change} change
 */
export function drawUnits({ answers, units }, change) {
  const has = (parts) => answers.parts.some((part) => parts.includes(part));
  const fields = QUANTITIES.filter(([, , parts]) => has(parts)).map(([quantity, label]) =>
    choice(
      `${label} in`,
      `unit ${quantity}`,
      answers.units[quantity] ?? "",
      [["", "choose"], ...(units[quantity] ?? []).map((u) => /** @type {const} */ ([u, u]))],
      (unit) => change({ units: { ...answers.units, [quantity]: unit } }),
    ),
  );
  if (!has(["time", "seconds"]))
    fields.push(
      number(
        "Rows a second",
        "rate_hz",
        answers.rate_hz ?? null,
        (rate) => change({ rate_hz: rate }),
        { min: 0.001, step: "any", title: "No column is the time" },
      ),
    );
  if (has(["roll"]))
    fields.push(
      choice(
        "Turns are about",
        "sequence",
        answers.sequence ?? "xyz",
        SEQUENCES.map((one) => /** @type {const} */ ([one, sequenceText(one)])),
        (sequence) => change({ sequence }),
      ),
    );
  if (has(["fx"]))
    fields.push(
      number(
        "Untouched for the first [s]",
        "from_first_s",
        answers.from_first_s ?? null,
        (seconds) => change({ from_first_s: seconds }),
        {
          min: 0.001,
          step: "any",
          title:
            "The mean of the wrench over this time is taken out, where the sensor has an offset",
        },
      ),
    );
  return el("section", { "aria-label": "Units" }, el("h3", { text: "Units" }), ...fields);
}

function sequenceText(sequence) {
  const axes = [...sequence.toLowerCase()].join(", ");
  return sequence === sequence.toLowerCase() ? `fixed ${axes}` : `turned ${axes}`;
}
