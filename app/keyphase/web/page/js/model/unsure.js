/** The boundaries a person should look at: the server says which. */

/** Numbers of the unsure boundaries, the least certain first. @param {import("./types.js").Doc|null} doc */
export function unsureBoundaries(doc) {
  if (!doc) return [];
  const numbers = doc.boundaries
    .map((_, index) => index)
    .filter((index) => doc.boundaries[index].unsure);
  return numbers.sort((a, b) => doc.boundaries[a].confidence - doc.boundaries[b].confidence);
}
