/** Which boundaries a person should look at. */

/** Confidence below which a boundary is unsure, as long as nobody accepted it. */
export const UNSURE_BELOW = 0.75;

/** @param {import("./types.js").Boundary} boundary */
export function isUnsure(boundary) {
  return !boundary.accepted && boundary.origin !== "user" && boundary.confidence < UNSURE_BELOW;
}

/** Numbers of the unsure boundaries, the least certain first. @param {import("./types.js").Doc|null} doc */
export function unsureBoundaries(doc) {
  if (!doc) return [];
  const numbers = doc.boundaries
    .map((_, index) => index)
    .filter((index) => isUnsure(doc.boundaries[index]));
  return numbers.sort((a, b) => doc.boundaries[a].confidence - doc.boundaries[b].confidence);
}
