/**
 * Marks too narrow for their own number, side by side: as many together as it takes to say which
 * they are.
 */

/**
 * @typedef {{number: number, left: number, right: number, fits: boolean}} Narrow
 *   number: as a person counts; fits: its own number has room in it
 * @typedef {{first: number, last: number, left: number, right: number}} Run
 */

/**
 * The runs of marks that have no number of their own, each just wide enough for its words.
 * @param {Narrow[]} marks in order
 * @param {(first: number, last: number) => number} widthOf the words of a run [px]
 * @returns {Run[]}
 */
export function runsOf(marks, widthOf) {
  const runs = [];
  /** @type {Run|null} */
  let open = null;
  for (const { number, left, right, fits } of marks) {
    if (fits) {
      open = null;
      continue;
    }
    open = open ? { ...open, last: number, right } : { first: number, last: number, left, right };
    if (open.right - open.left < widthOf(open.first, open.last)) continue;
    runs.push(open);
    open = null;
  }
  return runs;
}

/** What a run is called: "7 – 9". @param {number} first @param {number} last */
export const runText = (first, last) => (first === last ? String(first) : `${first}–${last}`);
