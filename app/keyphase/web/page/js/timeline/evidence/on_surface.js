/** The evidence track in the coordinates of the timeline's surface, where the pointer is. */

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {{track: () => any, row: () => import("../../model/rows.js").Row|undefined,
 *   scale: () => import("../../lib/scale.js").Scale, scroller: HTMLElement}} parts
 */
export function evidenceOnSurface({ state }, { track, row, scale, scroller }) {
  const isOpen = () => Boolean(track() && row() && !row().folded && state.document);
  const inside = (y) => y - row().y + scroller.scrollTop;
  const covers = (y) => isOpen() && inside(y) >= 0 && inside(y) <= row().height;
  return {
    /**
     * The parameter whose line is at a height, null where there is none.
     * @param {number} y
     * @param {boolean} byTag in the margin, where the tags stand
     */
    lineAt: (y, byTag) =>
      covers(y) ? track().lineAt(state, inside(y), row().height, byTag) : null,
    /** Height of a parameter's line. */
    lineY: (parameter) =>
      isOpen() ? track().lineY(state, parameter) + row().y - scroller.scrollTop : null,
    /** What a line becomes that is let go at a height; null is its automatic value. */
    lineValue: (automatic, y) => track().lineValue(automatic, inside(y)),
    /** Number of the candidate at a place, or null. */
    candidateAt: (x, y) => (covers(y) ? track().candidateAt(state, scale(), x, inside(y)) : null),
  };
}
