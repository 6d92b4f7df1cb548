/** Where points of the scene are on the screen. */

/**
 * A function from points below a node of the scene [m] to px of the canvas; null behind the camera.
 * @param {import("./viser_client.js").Viser} viser
 * @param {string} node
 * @returns {(point: number[]) => {x: number, y: number}|null}
 */
export function projection(viser, node) {
  const { camera, canvas } = viser;
  camera.updateMatrixWorld();
  const matrices = [
    viser.nodeRefFromName[node].matrixWorld,
    camera.matrixWorldInverse,
    camera.projectionMatrix,
  ];
  const { clientWidth: width, clientHeight: height } = canvas;
  return (point) => {
    const [x, y, , w] = matrices.reduce(applied, [...point, 1]);
    return w > 0 ? { x: (0.5 + x / w / 2) * width, y: (0.5 - y / w / 2) * height } : null;
  };
}

/** @param {number[]} vector @param {import("./viser_client.js").Matrix} matrix */
function applied(vector, { elements }) {
  return [0, 1, 2, 3].map((row) =>
    vector.reduce((sum, value, column) => sum + elements[4 * column + row] * value, 0),
  );
}
