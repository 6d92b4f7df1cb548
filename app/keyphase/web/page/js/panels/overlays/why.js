/** The popover that says why a boundary is there: the evidence, the interval, the confidence. */

import { originColor } from "../../lib/colors.js";
import { el } from "../../lib/dom.js";
import { halfWidth, moment, seconds, signed, time } from "../../lib/format.js";
import { glyphIcon } from "../../timeline/glyphs.js";

const LEVER_M = 0.1;
/** A torque weaker than this share of the strongest step is not worth a line. */
const TELLING = 0.2;
const NAMES = {
  position: "position",
  force: "force",
  gripper: "gripper",
  both: "position and force",
  user: "set by hand",
};

/**
 * @param {HTMLElement} node the popover
 * @param {Object<string, (boundary: number, time?: number) => void>} actions accept, next, remove,
 *   and move, to a time that was typed
 */
export function createWhy(node, actions) {
  let shown = "";
  return {
    /** @param {import("../../model/types.js").Doc} doc @param {number} index */
    show(doc, index, readOnly) {
      const key = `${doc.revision} ${index} ${document.documentElement.dataset.size}`;
      node.hidden = false;
      if (key === shown || isTyping(node, index)) return;
      shown = key;
      const boundary = doc.boundaries[index];
      node.replaceChildren(
        heading(boundary, index, readOnly ? null : actions.move),
        tags(boundary),
        ...boundary.why.sentences.map((text, k) => (k ? el("p", { text }) : sentence(text))),
        reasons(boundary),
        evidence(boundary),
        readOnly ? "" : buttons(boundary, index, actions),
      );
      node.dataset.boundary = String(index);
    },
    hide() {
      node.hidden = true;
      shown = "";
    },
  };
}

/** Whether a time is being typed for this very boundary. @param {HTMLElement} node @param {number} index */
const isTyping = (node, index) =>
  node.dataset.boundary === String(index) &&
  node.querySelector(".typed-time[data-typed]:focus") !== null;

/**
 * @param {import("../../model/types.js").Boundary} boundary
 * @param {number} index
 * @param {((boundary: number, time?: number) => void)|null} move null where nothing can be changed
 */
function heading(boundary, index, move) {
  return el(
    "h2",
    {},
    glyphIcon(boundary.origin, boundary.contact_change),
    `Boundary ${index + 1}`,
    el("span", { class: "space" }),
    move
      ? typedTime(boundary.time_s, (typed) => move(index, typed))
      : el("span", { text: moment(boundary.time_s) }),
  );
}

/**
 * The time as a field: what is typed there is where the boundary goes.
 * @param {number} at
 * @param {(typed: number) => void} told
 */
function typedTime(at, told) {
  const before = time(at);
  const input = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "text",
      class: "typed-time",
      value: before,
      size: Math.max(7, before.length),
      title: "Type the time it belongs at (Shift T)",
      "aria-label": "Time of the boundary",
      autocomplete: "off",
      spellcheck: "false",
    })
  );
  input.addEventListener("focus", () => input.select());
  input.addEventListener("keydown", (event) => {
    if (event.key !== "Enter" && event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    const typed = event.key === "Enter" ? seconds(input.value) : at;
    input.setAttribute("aria-invalid", String(Number.isNaN(typed)));
    if (Number.isNaN(typed)) return input.select();
    input.value = before;
    input.blur();
    if (input.dataset.typed) told(typed);
  });
  input.addEventListener("input", () => (input.dataset.typed = "yes"));
  input.addEventListener("blur", () => (input.value = before));
  return el("span", { class: "typed" }, input, before.includes(":") ? "" : " s");
}

function tags({ origin, contact_change: contact, accepted, taken_from: from }) {
  const tag = (text, color) => el("span", { class: "tag", style: { "--tag": color }, text });
  return el(
    "p",
    { class: "tags" },
    tag(from ? "taken over" : NAMES[origin], originColor(origin)),
    contact ? tag("contact change", "var(--origin-force)") : "",
    accepted ? tag("accepted", "var(--good)") : "",
  );
}

/** Numbers of the first sentence stand out, not those in names; everything stays text. */
function sentence(text) {
  const parts = text.split(/((?<![\p{L}\d_.])\d[\d.,]*(?: ×)?)/u);
  return el("p", {}, ...parts.map((part, k) => (k % 2 ? el("b", { text: part }) : part)));
}

/**
 * What spoke for it and against it: each reason with what it adds to the log-odds.
 * @param {import("../../model/types.js").Boundary} boundary
 */
function reasons({ why }) {
  if (!why.reasons.length) return "";
  const largest = Math.max(...why.reasons.map(({ contribution }) => Math.abs(contribution)), 1e-9);
  const list = el("div", { class: "reasons" });
  for (const { name: text, contribution } of why.reasons) {
    const speaksFor = contribution >= 0;
    list.append(
      el("span", { text, title: text }),
      bar(Math.abs(contribution) / largest, speaksFor ? "var(--good)" : "var(--unsure)", ""),
      el("span", { class: "amount", text: signed(contribution, 1) }),
    );
  }
  return list;
}

/** @param {import("../../model/types.js").Boundary} boundary */
function evidence(boundary) {
  const { why, confidence, interval_s: interval, origin, unsure } = boundary;
  const grid = el("div", { class: "evidence" });
  const largest = Math.max(...why.steps.map(asForce), 1e-9);
  for (const step of why.steps.filter(
    (one) => one.unit === "N" || asForce(one) > TELLING * largest,
  )) {
    const { name, value, unit, axis } = step;
    const strongest = asForce(step) === largest;
    const digits = unit === "N m" ? 3 : 1;
    grid.append(
      el("span", { text: name, class: strongest ? "strongest" : "step" }),
      bar(
        asForce(step) / largest,
        axis ? `var(--axis-${axis})` : "var(--curve)",
        strongest ? "strongest" : "step",
      ),
      el("span", {
        class: `amount ${strongest ? "strongest" : "step"}`,
        text: `${signed(value, digits)} ${unit}`,
      }),
    );
  }
  grid.append(
    el("span", { text: "Interval" }),
    whiskers(originColor(origin)),
    el("span", { class: "amount", text: halfWidth(interval) }),
  );
  const sure = unsure ? "var(--unsure)" : "var(--good)";
  grid.append(
    el("span", { text: "Confidence" }),
    bar(confidence, sure, ""),
    el("span", { class: "amount", text: confidence.toFixed(2) }),
  );
  return grid;
}

/**
 * Forces and torques side by side: a torque counts as the force that makes it at LEVER_M.
 * @param {import("../../messages/document_messages").StepMessage} step
 */
function asForce({ value, unit }) {
  return Math.abs(value) / (unit === "N" ? 1 : LEVER_M);
}

function bar(share, color, name) {
  return el(
    "div",
    { class: `bar ${name}` },
    el("i", { style: { width: `${Math.min(100, 100 * share).toFixed(1)}%`, background: color } }),
  );
}

function whiskers(color) {
  return el("div", { class: "whiskers", style: { color } });
}

/** @param {import("../../model/types.js").Boundary} boundary */
function buttons(boundary, index, actions) {
  const button = (text, key, run, style = "") =>
    el(
      "button",
      { type: "button", class: style, on: { click: () => run(index) } },
      text,
      el("kbd", { text: key }),
    );
  return el(
    "div",
    { class: "buttons" },
    boundary.accepted ? "" : button("Accept", "↵", actions.accept, "primary"),
    button("Next", "N", actions.next),
    button("Remove", "⌫", actions.remove),
  );
}
