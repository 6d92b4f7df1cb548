/**
 * Names beside what they are about: in a column on either side of it all, in the order of their
 * heights, so that lines never cross far and no name covers another.
 *
 * @typedef {{x: number, y: number}} Point
 * @typedef {{anchor: Point, width: number}} Asked
 * @typedef {{side: "left"|"right", x: number, y: number}} Place  where the line meets the name
 */

const LINE_PX = 26;
const BESIDE_PX = 52;
const MARGIN_PX = 12;
/** What lies over the scene above and below: time, legend. */
const COVERED_PX = 50;

/**
 * @param {Asked[]} asked
 * @param {{width: number, height: number}} canvas
 * @param {{width: number, height: number}} [corner] what of its lower right corner is covered
 * @returns {Place[]} in the same order
 */
export function placed(asked, canvas, corner = { width: 0, height: 0 }) {
  const across = asked.map(({ anchor }) => anchor.x);
  const order = asked.map((_, index) => index).sort((a, b) => across[a] - across[b] || a - b);
  const half = Math.ceil(order.length / 2);
  /** @type {Place[]} */
  const places = Array(asked.length);
  for (const [side, indices] of /** @type {["left"|"right", number[]][]} */ ([
    ["left", order.slice(0, half)],
    ["right", order.slice(half)],
  ])) {
    const column = indices.sort((a, b) => asked[a].anchor.y - asked[b].anchor.y);
    const ends = Math.max(...across) + BESIDE_PX + Math.max(...column.map((k) => asked[k].width));
    const meets = side === "right" && ends > canvas.width - corner.width - MARGIN_PX;
    const heights = apart(
      column.map((index) => asked[index].anchor.y),
      canvas.height,
      meets ? Math.max(COVERED_PX, corner.height + LINE_PX / 2) : COVERED_PX,
    );
    column.forEach((index, k) => {
      const { width } = asked[index];
      const x =
        side === "left"
          ? Math.max(Math.min(...across) - BESIDE_PX, MARGIN_PX + width)
          : Math.min(Math.max(...across) + BESIDE_PX, canvas.width - MARGIN_PX - width);
      places[index] = { side, x, y: heights[k] };
    });
  }
  return places;
}

/** Ascending heights, at least a line apart, around where they were, and above what is covered below. */
function apart(heights, canvasHeight, covered) {
  const spread = downwards(heights, -Infinity);
  const mean = (values) => values.reduce((sum, value) => sum + value, 0) / values.length;
  const shift = mean(heights) - mean(spread);
  const below = downwards(
    spread.map((y) => y + shift),
    COVERED_PX,
  );
  // From the lowest up, the same as from the highest down seen in a mirror.
  return downwards(below.map((y) => -y).reverse(), covered - canvasHeight)
    .map((y) => -y)
    .reverse();
}

/** Each at least a line below the one before, the first no higher than `top`. */
function downwards(heights, top) {
  let least = top;
  return heights.map((y) => {
    const placed = Math.max(y, least);
    least = placed + LINE_PX;
    return placed;
  });
}
