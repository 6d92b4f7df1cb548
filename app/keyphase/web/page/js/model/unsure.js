/** The boundaries a person should look at: the server says which. */

/** How long so many doubts will take, in words; "" while that is not known. @param {number} count @param {number|null} seconds each */
export function timeLeft(count, seconds) {
  if (seconds === null || !count) return "";
  const minutes = (count * seconds) / 60;
  return minutes < 1 ? "less than a minute left" : `about ${Math.round(minutes)} min left`;
}

/** Numbers of the unsure boundaries, the least certain first. @param {import("./types.js").Doc|null} doc */
export function unsureBoundaries(doc) {
  if (!doc) return [];
  const numbers = doc.boundaries
    .map((_, index) => index)
    .filter((index) => doc.boundaries[index].unsure);
  return numbers.sort((a, b) => doc.boundaries[a].confidence - doc.boundaries[b].confidence);
}
