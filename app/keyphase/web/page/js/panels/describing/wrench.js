/** Which way a force points and in whose axes it is written, asked with pictures. */

import { el, svg } from "../../lib/dom.js";

/**
 * @param {import("./describing.js").Proposal} table
 * @param {import("./describing.js").Change} change
 */
export function drawWrench({ answers, asked }, change) {
  const { sign, frame } = answers;
  const signs = asked.includes("sign") && [
    el("h3", { text: "Pressing down on a table, the force in this file points" }),
    el(
      "div",
      { class: "describing-pictures" },
      picture("up, on the tool", sign === 1, () => change({ sign: 1 }), pressing(true)),
      picture("down, on the table", sign === -1, () => change({ sign: -1 }), pressing(false)),
    ),
  ];
  const frames = asked.includes("frame") && [
    el("h3", { text: "Its x, y and z are axes of" }),
    el(
      "div",
      { class: "describing-pictures" },
      picture("the robot's base", frame === "base", () => change({ frame: "base" }), axes(false)),
      picture("the tool", frame === "tool", () => change({ frame: "tool" }), axes(true)),
    ),
  ];
  if (!signs && !frames) return el("section", { class: "nothing" });
  return el("section", { "aria-label": "The force" }, ...(signs || []), ...(frames || []));
}

function picture(text, chosen, choose, drawing) {
  return el(
    "button",
    {
      type: "button",
      class: "describing-picture",
      "aria-pressed": String(chosen),
      data: { field: text },
      on: { click: choose },
    },
    drawing,
    el("span", { text }),
  );
}

/** A tool on a table, and the arrow of the force. @param {boolean} up */
function pressing(up) {
  const [from, to, head] = up ? [50, 12, 18] : [52, 90, 84];
  return svg(
    "svg",
    { viewBox: "0 0 120 96", "aria-hidden": "true" },
    svg("path", { class: "table", d: "M14 58H106M26 58V92M94 58V92" }),
    svg("path", { class: "tool", d: "M44 6H60V38L52 54L44 38Z" }),
    svg("path", { class: "force", d: `M80 ${from}V${to}M74 ${head}L80 ${to}L86 ${head}` }),
  );
}

/** Axes at the robot's foot, or at its tool, which is turned. @param {boolean} tool */
function axes(tool) {
  const at = tool ? "translate(86 48) rotate(40)" : "translate(22 84)";
  return svg(
    "svg",
    { viewBox: "0 0 120 96", "aria-hidden": "true" },
    svg("path", { class: "tool", d: "M14 88H34M24 88V56L56 22L84 44" }),
    svg(
      "g",
      { transform: at },
      svg("path", { class: "axis-x", d: "M0 0H26" }),
      svg("path", { class: "axis-z", d: "M0 0V-26" }),
    ),
  );
}
