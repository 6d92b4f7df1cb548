/** One recording of the list: its state, name, doubt, segments, and who else is there. */

import { segmentFill } from "../lib/colors.js";
import { el, svg } from "../lib/dom.js";
import { plural } from "../lib/format.js";
import { asksForALook, namesOf, stateOf } from "../model/recordings/recording_list.js";
import { nameInTwo } from "./name_in_two.js";

const MOST_PIECES = 90;
const MOST_PAGES = 3;

/** The id of a recording's row in the page. @param {{id: string}} item */
export const rowId = ({ id }) => `recording-${id}`;

/**
 * @param {import("../model/types.js").Recording} item
 * @param {{on: boolean, picked: boolean, common: number, open: (event: MouseEvent) => void, menu: (event: MouseEvent) => void}} given
 *   `common`: how much of its name all share
 */
export function drawRow(item, { on, picked, common, open, menu }) {
  const { confidence, error, name } = item;
  const low = asksForALook(item);
  const sure = confidence === null ? "" : confidence.toFixed(2);
  const others = item.pages;
  return el(
    "div",
    {
      id: rowId(item),
      class: `queue-row ${on ? "on" : ""} ${picked ? "picked" : ""}`,
      role: "option",
      "aria-selected": String(on || picked),
      data: { recording: item.id },
      title: error ?? `${name}${sure && `: confidence of its least certain boundary ${sure}`}`,
      on: { click: open, contextmenu: menu },
    },
    stateMark(stateOf(item)),
    el("span", { class: "queue-name", dir: "auto" }, ...nameInTwo(name, common)),
    el(
      "span",
      { class: "queue-pages" },
      assessed(item.assessment),
      markedSegments(item.marked),
      differing(item.differences),
      ...others.slice(0, MOST_PAGES).map(pageMark),
    ),
    certainty(item, low, sure),
    error
      ? el("span", { class: "queue-error", text: "cannot be read" })
      : el("span", { class: "queue-strip", "aria-hidden": "true" }, ...strip(item)),
  );
}

/**
 * What a person thinks of it, in short.
 * @param {import("../model/types.js").Recording["assessment"]|undefined} assessment
 */
function assessed(assessment) {
  const { outcome = null, quality = null, note = "" } = assessment ?? {};
  if (!outcome && !quality && !note) return null;
  const sign = outcome ? { success: "✓", failure: "✗" }[outcome] : note && !quality ? "…" : "";
  const told = [outcome, quality && `quality ${quality} of 5`, note].filter(Boolean).join(", ");
  return el("span", {
    class: `queue-assessed ${outcome ?? ""}`,
    text: `${sign}${quality ?? ""}`,
    title: told,
    role: "img",
    "aria-label": told,
  });
}

/** How many of its segments are marked. @param {import("../model/types.js").Recording["marked"]} marked */
function markedSegments(marked = []) {
  if (!marked.length) return null;
  const failed = marked.filter(({ outcome }) => outcome === "failure").length;
  const told = [
    `${plural(marked.length, "segment")} marked`,
    failed && plural(failed, "failure"),
    ...marked.map(({ note }) => note),
  ];
  return el("span", {
    class: `queue-assessed ${failed ? "failure" : ""}`,
    text: `⚑${marked.length}`,
    title: told.filter(Boolean).join(", "),
    role: "img",
    "aria-label": told.filter(Boolean).join(", "),
  });
}

/** How often another person's segments differ. @param {number|null|undefined} count */
function differing(count) {
  if (!count) return null;
  const told = `${plural(count, "difference")} from the other person`;
  return el("span", {
    class: "queue-differs",
    text: `≠${count}`,
    title: told,
    role: "img",
    "aria-label": told,
  });
}

/**
 * How sure the least sure of it is: of its segmentation, or of what is proposed for it.
 * @param {import("../model/types.js").Recording} item
 * @param {boolean} low
 * @param {string} sure
 */
function certainty(
  { state, proposed_from: from, proposed_confidence: proposed, outlier, differs },
  low,
  sure,
) {
  if (state === "automatic" && outlier)
    return el("span", {
      class: "queue-confidence low",
      text: "unlike",
      title: "It fits none of the recordings that are done, so nothing is proposed for it.",
    });
  if (state === "automatic" && differs)
    return el("span", {
      class: "queue-confidence low",
      text: "differs",
      title: `Proposed from ${namesOf(from)}, but ${differs.told}.`,
    });
  if (state === "automatic" && from.length > 0)
    return el("span", {
      class: "queue-confidence proposed",
      text: proposed?.toFixed(2),
      title: `Proposed from ${namesOf(from)}; ${proposed?.toFixed(2)} is how sure the least sure part of it is.`,
    });
  return el("span", { class: `queue-confidence ${low ? "low" : ""}`, text: sure });
}

/** Somebody else's page. @param {import("../messages/list_messages").PageThere} page */
function pageMark({ name, color }) {
  return el("i", {
    class: "page-mark",
    title: `${name} is here`,
    text: name.split(" ").at(-1).slice(0, 2),
    style: { background: segmentFill({ color }) },
  });
}

/** @param {import("../model/types.js").Recording} item */
function strip({ strip: pieces }) {
  return coarse(pieces).map(({ share, color }) =>
    el("i", { style: { flex: String(share), background: segmentFill({ color }) } }),
  );
}

/**
 * Dotted ring automatic, half ring touched, tick done, a blue one changed since.
 * @param {ReturnType<typeof stateOf>} state
 */
export function stateMark(state) {
  const mark = svg("svg", {
    class: "state",
    width: 14,
    height: 14,
    viewBox: "0 0 14 14",
    role: "img",
    "aria-label": state,
  });
  const done = { done: "var(--good)", "changed since done": "var(--accent)" }[state];
  if (done) {
    mark.append(
      svg("circle", { cx: 7, cy: 7, r: 6, style: { fill: done } }),
      svg("path", {
        d: "m4.2 7.2 2 2 3.7-4",
        "stroke-width": 1.5,
        style: { stroke: "var(--pane)", fill: "none" },
      }),
    );
  } else if (state === "touched") {
    mark.append(
      svg("circle", {
        cx: 7,
        cy: 7,
        r: 5.3,
        "stroke-width": 1.4,
        style: { stroke: "var(--accent)", fill: "none" },
      }),
      svg("path", { d: "M7 3.5a3.5 3.5 0 0 1 0 7z", style: { fill: "var(--accent)" } }),
    );
  } else {
    mark.append(
      svg("circle", {
        cx: 7,
        cy: 7,
        r: 5.3,
        "stroke-width": 1.4,
        "stroke-dasharray": "2.2 1.9",
        style: { stroke: "var(--text-4)", fill: "none" },
      }),
    );
  }
  return mark;
}

/**
 * A strip of many segments in as many pieces as there are pixels to show them.
 * @param {import("../model/types.js").Recording["strip"]} strip
 */
function coarse(strip) {
  if (strip.length <= MOST_PIECES) return strip;
  const pieces = [];
  let share = 0;
  let longest = strip[0];
  for (const piece of strip) {
    share += piece.share;
    if (piece.share > longest.share) longest = piece;
    if (share < 1 / MOST_PIECES) continue;
    pieces.push({ share, color: longest.color });
    share = 0;
    longest = { share: 0, color: null };
  }
  return pieces;
}
