/**
 * Another segmentation of the same recording as a pale band below the shown one, and between the
 * two bands what they share and what only one of them has.
 */

import { segmentFill } from "../../lib/colors.js";
import { el, icon, svg } from "../../lib/dom.js";
import { GIVEN, namesOf, PROPOSED, proposedHere } from "../../model/recordings/recording_list.js";
import { fitted } from "../../lib/text_width.js";

/** Height between the bands, for the links. */
const LINK_PX = 9;
const CROSS_PX = 3.2;

/**
 * @param {import("../../lib/store.js").State} state
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {import("../../model/rows.js").Row} row
 */
export function drawComparison({ document: doc, comparison, labels: known }, scale, { y, height }) {
  const {
    boundaries_s: boundaries,
    labels,
    shared,
    only_first_s: onlyFirst,
    only_second_s: onlySecond,
  } = comparison;
  const edges = [doc.start_s, ...boundaries, doc.end_s];
  const proposed = comparison.with === PROPOSED;
  const place = { top: y + LINK_PX, height: height - LINK_PX - 3 };
  const ground = svg("rect", { y, width: scale.width, height, class: "band-ground" });
  return [
    ground,
    ...labels.flatMap((label, k) =>
      drawOther(
        { label, fill: fillOf(label, doc, known, proposed) },
        edges[k],
        edges[k + 1],
        scale,
        place,
      ),
    ),
    ...shared.map(([first, second]) => link(scale, first, second, y)),
    ...onlySecond.map((time) => tick(scale, time, place)),
    ...onlyFirst.map((time) => missing(scale, time, y + LINK_PX / 2)),
  ];
}

/**
 * A label has the colour it has in the shown segmentation or in the vocabulary, else none; a
 * proposed one that of the vocabulary first, which it will have.
 * @param {string} label
 * @param {import("../../model/types.js").Doc} doc
 * @param {import("../../lib/store.js").State["labels"]} known
 * @param {boolean} proposed
 */
export function fillOf(label, doc, known, proposed) {
  const same = doc.segments.find((segment) => segment.label === label && segment.kept);
  const named = known.find(({ name }) => name === label);
  if (same && !(proposed && named)) return segmentFill(same);
  return named?.color ?? "var(--idle)";
}

/**
 * @param {{label: string, fill: string}} segment
 * @param {number} from
 * @param {number} to
 * @param {import("../../lib/scale.js").Scale} scale
 * @param {{top: number, height: number}} place
 */
function drawOther({ label, fill }, from, to, scale, { top, height }) {
  const left = Math.max(scale.x(from), 0) + 1;
  const right = Math.min(scale.x(to), scale.width) - 1;
  if (right - left < 1) return [];
  const box = svg("rect", {
    x: left,
    y: top,
    width: right - left,
    height,
    rx: 3,
    class: "other-segment",
    style: { fill, stroke: fill },
  });
  const text = fitted(label, "11px", right - left - 12);
  if (!text) return [box];
  return [box, svg("text", { x: left + 6, y: top + height / 2 + 3.6, class: "other-label", text })];
}

/**
 * From where the shown segmentation has a boundary to where the other has it.
 * @param {import("../../lib/scale.js").Scale} scale
 */
function link(scale, first, second, y) {
  return svg("path", {
    d: `M${scale.x(first)} ${y}v1.5L${scale.x(second)} ${y + LINK_PX - 1.5}v1.5`,
    class: "other-link",
  });
}

/** @param {import("../../lib/scale.js").Scale} scale */
function tick(scale, time, { top, height }) {
  return svg("path", {
    d: `M${scale.x(time)} ${top - LINK_PX + 3}v${height + LINK_PX - 3}`,
    class: "only-second",
  });
}

/**
 * A boundary only the shown segmentation has.
 * @param {import("../../lib/scale.js").Scale} scale
 */
function missing(scale, time, y) {
  const x = scale.x(time);
  return svg("path", {
    d: `M${x - CROSS_PX} ${y - CROSS_PX}l${2 * CROSS_PX} ${2 * CROSS_PX}m0 ${-2 * CROSS_PX}l${-2 * CROSS_PX} ${2 * CROSS_PX}`,
    class: "only-first",
  });
}

/** Whose segmentation it is, for people. @param {string} other */
export function nameOf(other) {
  if (other === "found now") return "Found now";
  if (other === PROPOSED) return "Proposed";
  if (other === GIVEN) return "Labels given";
  return other === "automatic" ? "Program’s own" : other.replace(/\.segments\.json$/, "");
}

/**
 * The row's gutter: whose it is, how well the two agree, and what can be done with it.
 * @param {{node: HTMLElement, body: HTMLElement}} gutter
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createComparisonGutter({ node, body }, store, actions) {
  const name = el("b", { class: "other-name" });
  const score = el("span", { class: "other-score" });
  const take = /** @type {HTMLElement} */ (
    el(
      "button",
      {
        type: "button",
        class: "tool",
        title: "Take over: make this segmentation the recording’s, in one step",
        "aria-label": "Take over",
        on: { click: actions.takeOver },
      },
      icon("check", "small"),
    )
  );
  const close = el(
    "button",
    {
      type: "button",
      class: "tool",
      title: "Compare no longer",
      "aria-label": "Compare no longer",
      on: { click: () => actions.compare(null) },
    },
    icon("close", "small"),
  );
  node.replaceChildren(el("div", { class: "other-head" }, name, take, close), score, body);
  /** @param {import("../../messages/comparison_messages").ComparisonMessage} comparison */
  const show = ({
    with: other,
    f1,
    timing_s: timing,
    same_label: same,
    only_first_s: onlyFirst,
    only_second_s: onlySecond,
  }) => {
    const late = timing === null ? "" : ` · ${Math.round(1000 * timing)} ms`;
    const proposed = other === PROPOSED ? proposedHere(store.state) : undefined;
    const labels = `labels ${Math.round(100 * same)} %`;
    name.textContent = nameOf(other);
    score.textContent = `F1 ${f1.toFixed(2)}${late}${store.state.small ? "" : ` · ${labels}`}`;
    take.hidden = store.state.readOnly;
    if (proposed) {
      const from = `from ${namesOf(proposed.proposed_from)}`;
      // The key first: many names have no room.
      score.textContent = take.hidden ? from : `Shift Enter · ${from}`;
      node.title =
        `Proposed ${from}; its least sure part has a confidence of ` +
        `${proposed.proposed_confidence?.toFixed(2)}.` +
        (take.hidden ? "" : " Shift Enter takes it over, in one step.");
      return;
    }
    node.title =
      `Compared with ${nameOf(other)}: F1 ${f1.toFixed(2)}${timing === null ? "" : `, shared boundaries${late.replace(" ·", "")} apart`}, ${labels} of the time the same; ` +
      `${onlyFirst.length} only here (×), ${onlySecond.length} only there (red)`;
  };
  return show;
}
