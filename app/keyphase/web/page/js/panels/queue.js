/** The recordings at the left: what is left to do, and where doubt is greatest. */

import { segmentFill } from "../lib/colors.js";
import { byId, el, redraw, svg } from "../lib/dom.js";
import { leastCertainOf } from "../actions/recording_actions.js";

const UNSURE_BELOW = 0.7;
const MOST_PIECES = 90;
const STATES = ["done", "touched", "automatic"];

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 */
export function createQueue(store, actions) {
  const rows = byId("queue-rows");
  const sort = byId("queue-sort");
  sort.addEventListener("click", actions.toggleOrder);
  byId("least-certain").addEventListener("click", actions.leastCertain);
  byId("previous-recording").addEventListener("click", () => actions.nextRecording(-1));
  byId("next-recording").addEventListener("click", () => actions.nextRecording(1));

  store.later(
    ["recordings", "leastCertainFirst", "small"],
    ({ recordings, leastCertainFirst, small }) => {
      const { items, current } = recordings;
      byId("queue-count").textContent = String(items.length);
      byId("queue-progress").replaceChildren(...progress(items));
      byId("queue-states").replaceChildren(...counts(items, small));
      sort.classList.toggle("on", leastCertainFirst);
      sort.setAttribute("aria-pressed", String(leastCertainFirst));
      const shown = leastCertainFirst
        ? items.toSorted((a, b) => (a.confidence ?? 2) - (b.confidence ?? 2))
        : items;
      redraw(
        rows,
        "recording",
        shown.map((item) => drawRow(item, item.id === current, actions)),
      );
      rows.querySelector(".on")?.scrollIntoView({ block: "nearest" });
      const least = leastCertainOf(recordings);
      byId("least-certain-value").textContent = least ? least.confidence.toFixed(2) : "";
      byId("least-certain-value").classList.toggle(
        "low",
        Boolean(least && least.confidence < UNSURE_BELOW),
      );
      /** @type {HTMLButtonElement} */ (byId("least-certain")).disabled = !least;
    },
  );
}

function progress(items) {
  const color = { done: "var(--good)", touched: "var(--accent)", automatic: "var(--text-4)" };
  return STATES.map((state) => [state, items.filter((item) => item.state === state).length])
    .filter(([, count]) => count)
    .map(([state, count]) => el("i", { style: { flex: String(count), background: color[state] } }));
}

function counts(items, small) {
  const names = small
    ? { done: "done", touched: "", automatic: "auto" }
    : { done: "done", touched: "touched", automatic: "automatic" };
  return STATES.map((state) => {
    const count = items.filter((item) => item.state === state).length;
    return el(
      "span",
      { title: `${count} ${state}` },
      stateMark(state),
      `${count} ${names[state]}`.trim(),
    );
  });
}

/** Dotted ring automatic, half ring touched, tick done. */
function stateMark(state) {
  const mark = svg("svg", {
    class: "state",
    width: 14,
    height: 14,
    viewBox: "0 0 14 14",
    role: "img",
    "aria-label": state,
  });
  if (state === "done") {
    mark.append(
      svg("circle", { cx: 7, cy: 7, r: 6, style: { fill: "var(--good)" } }),
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

/** A strip of many segments in as many pieces as there are pixels to show them. */
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

function drawRow(item, on, actions) {
  const sure = item.confidence === null ? "" : item.confidence.toFixed(2);
  const low = item.confidence !== null && item.confidence < UNSURE_BELOW && item.state !== "done";
  const row = el(
    "button",
    {
      type: "button",
      class: `queue-row ${on ? "on" : ""}`,
      role: "option",
      "aria-selected": String(on),
      data: { recording: item.id },
      title: item.error ?? item.name,
      on: { click: () => actions.open(item.id) },
    },
    stateMark(item.state),
    el("span", { class: "queue-name", text: item.name }),
    el("span", { class: `queue-confidence ${low ? "low" : ""}`, text: sure }),
  );
  row.append(
    item.error
      ? el("span", { class: "queue-error", text: "cannot be read" })
      : el(
          "span",
          { class: "queue-strip" },
          ...coarse(item.strip).map(({ share, color }) =>
            el("i", { style: { flex: String(share), background: segmentFill({ color }) } }),
          ),
        ),
  );
  return row;
}
