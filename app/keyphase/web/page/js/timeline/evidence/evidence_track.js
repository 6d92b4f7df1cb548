/**
 * The evidence: the probability of a contact change and of a boundary of the motion over time, a
 * line over each that one can drag, and every place where a boundary could be.
 */

import { cssColor } from "../../lib/colors.js";
import { el } from "../../lib/dom.js";
import { heightOf, LINES, linesOf, lineValue } from "../../model/evidence.js";
import { curvesOf, valueAt } from "../../model/signals.js";
import { createCurves } from "../curves/curves.js";
import { createReadout } from "../gutter.js";
import { tickLabels } from "../tracks.js";
import { drawCandidates, nearestCandidate, showNote } from "./candidates.js";
import { createHeldBack } from "./held_back.js";
import { drawLines, tagLevels } from "./lines.js";
import { drawProfile } from "./profile.js";

/** Room above and below the way of the lines, as a share of it. */
const AIR = 0.05;
const TICKS = { large: [0.001, 0.05, 0.5, 0.95, 0.999], small: [0.01, 0.5, 0.99] };
const LINE_PX = 4;
const TAG_PX = 8;
const NOTHING = { times: new Float64Array(), values: new Float64Array() };

/**
 * @param {import("../gutter.js").TrackParts} parts
 * @param {import("../../lib/store.js").Store} _store
 * @param {any} actions
 */
export function createEvidenceTrack({ plot, marks, gutter, texts }, _store, actions) {
  const pens = LINES.map(({ origin }) => ({ color: `--origin-${origin}`, width: 1.2 }));
  const folded = createCurves(plot, [{ color: "--text-3", width: 1 }]);
  const note = el("div", { class: "candidate-note", role: "tooltip", hidden: true });
  plot.after(note);
  const readout = createReadout(
    gutter,
    LINES.map(({ kind }, k) => ({ key: kind, color: pens[k].color })),
  );
  const heldBack = createHeldBack(plot, actions);
  let colors = colorsOf(pens);
  let shades = [];
  const curves = createCurves(plot, pens, { shades: () => shades });
  let paired = { source: null, series: [] };

  /** Contact and motion in this order, whichever there are. */
  function pairOf(source) {
    if (paired.source !== source) {
      const of = (key) => source.find((one) => one.key === key) ?? { key, ...NOTHING };
      paired = { source, series: LINES.map(({ kind }) => of(kind)) };
    }
    return paired.series;
  }

  /** Height of the way from the least to the greatest probability [px]. */
  const way = () => curves.y(0) - curves.y(1);

  return {
    draw(state, scale, row) {
      const source = curvesOf(state, "evidence")?.series;
      plot.classList.toggle("folded", row.folded);
      (row.folded ? curves : folded).hide();
      note.hidden = true;
      heldBack(state);
      if (!source?.length) return marks.replaceChildren();
      const range = rangeOf(state.small);
      if (row.folded) {
        folded.resize(scale.width, row.height, true);
        folded.draw([source[0]], range, state.view);
        return marks.replaceChildren();
      }
      const series = pairOf(source);
      const lines = linesOf(state);
      shades = shadesOf(lines, series, colors);
      curves.resize(scale.width, row.height, false);
      curves.draw(series, range, state.view);
      showNote(note, state, scale, curves.y, row.height);
      return marks.replaceChildren(
        ...tickLabels(range, curves.y, texts()),
        ...drawCandidates(state, scale, curves.y),
        ...drawProfile(lines, state, scale, curves.y),
        ...drawLines(lines, state, scale, curves.y, row.height),
      );
    },
    read(state, time) {
      const series = curvesOf(state, "evidence")?.series ?? [];
      // Where no force was recorded there is nothing to say of contacts.
      const isThere = ({ key }) => !series.length || series.some((one) => one.key === key);
      readout.show(
        pairOf(series).map((one) => (isThere(one) ? shareText(valueAt(one, time)) : null)),
      );
    },
    recolor() {
      colors = colorsOf(pens);
      curves.recolor();
      folded.recolor();
    },
    /** The line that is grabbed at a height of the track, by itself or in the margin by its tag. */
    lineAt(state, y, height, byTag) {
      const lines = linesOf(state);
      const levels = byTag
        ? tagLevels(lines, curves.y, height)
        : lines.map(({ value }) => curves.y(value));
      const near = lines
        .map(({ parameter }, k) => ({ parameter, away: Math.abs(levels[k] - y) }))
        .filter(({ away }) => away <= (byTag ? TAG_PX : LINE_PX))
        .sort((a, b) => a.away - b.away);
      return near[0]?.parameter ?? null;
    },
    /** Where a line is drawn [px from the track's top]. */
    lineY: (state, parameter) =>
      curves.y(linesOf(state).find((line) => line.parameter === parameter)?.value ?? NaN),
    /** What a line becomes that is let go at a height of the track. */
    lineValue: (automatic, y) => lineValue((curves.y(0) - y) / way(), automatic, way()),
    candidateAt: (state, scale, x, y) => nearestCandidate(state, scale, curves.y, x, y),
  };
}

const colorsOf = (pens) => pens.map(({ color }) => cssColor(color));
const shareText = (value) => (Number.isNaN(value) ? "–" : value.toFixed(2));

/** curves.y(0) and curves.y(1) are the ends of the way, since a probability is clipped to it. */
const ranges = new Map(
  [true, false].map((small) => [
    small,
    { low: -AIR, high: 1 + AIR, ticks: TICKS[small ? "small" : "large"], map: heightOf },
  ]),
);
const rangeOf = (small) => ranges.get(Boolean(small));

/** What of each curve stands above its line. @returns {import("../curves/curves.js").Shade[]} */
function shadesOf(lines, series, colors) {
  return LINES.flatMap(({ kind }, k) => {
    const line = lines.find((one) => one.kind === kind);
    return line ? [{ series: series[k], above: line.value, color: colors[k] }] : [];
  });
}
