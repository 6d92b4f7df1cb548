/** Shorter and shorter ways to write a segment's label, where room is short. */

const MEASURE = /\s*[−-]?\b\d+(\.\d+)?\s?(mm|cm|m|deg|°)(?!\w)/g;

/** @typedef {{label: string, proposed: boolean}} Named */

/** "Move down 86 mm until contact" is "Move down until contact". @param {string} label */
function withoutMeasure(label) {
  return label.replace(MEASURE, "").trim() || label;
}

/** Without its measure where the program gave the name. @param {Named} named */
export const measureless = ({ label, proposed }) => (proposed ? withoutMeasure(label) : label);

/** Shorter where the program gave the name. @param {Named} named */
export const shorter = ({ label, proposed }) => (proposed ? shortName(label) : label);

/** Without measures and the leading "Move": "Down until contact". @param {string} label */
function shortName(label) {
  const name = withoutMeasure(label);
  const after = name.replace(/^Move (?=\S)/, "");
  return after === name ? name : after.charAt(0).toUpperCase() + after.slice(1);
}

/** What is done, and not until when: "Rotate about y until contact" is "Rotate about y". */
const withoutEnd = (label) => shortName(label).replace(/ until .*$/, "");

/**
 * From the full label to its first word; at last only the segment's number remains, which is not
 * in this list. What a person wrote is cut, never put in other words.
 * @param {import("./types.js").Segment|import("./types.js").Skill} named
 */
export function formsOf(named) {
  const { label, short, proposed } = named;
  const others = proposed
    ? [withoutMeasure(label), shortName(label), ...short.slice(0, -1), withoutEnd(label)]
    : [];
  return [...new Set([label, ...others, ...short.slice(-1)])];
}
