/** Points put into a box of pixels. */

const MARGIN_PX = 5;

/**
 * @param {number[][]} points pairs, upwards positive
 * @param {number} width
 * @param {number} height
 * @param {boolean} same whether both axes have one scale
 * @returns {number[][]} pixels, downwards positive
 */
export function fitted(points, width, height, same) {
  const range = (axis) => {
    const values = points.map((point) => point[axis]);
    const least = Math.min(...values);
    return { least, extent: Math.max(...values) - least || 1e-9 };
  };
  const [x, y] = [range(0), range(1)];
  const inner = [width - 2 * MARGIN_PX, height - 2 * MARGIN_PX];
  const scales = [inner[0] / x.extent, inner[1] / y.extent];
  const [sx, sy] = same ? [Math.min(...scales), Math.min(...scales)] : scales;
  const left = (width - sx * x.extent) / 2;
  const bottom = height - (height - sy * y.extent) / 2;
  const round = (value) => Math.round(10 * value) / 10;
  return points.map(([px, py]) => [
    round(left + sx * (px - x.least)),
    round(bottom - sy * (py - y.least)),
  ]);
}
