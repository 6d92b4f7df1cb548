/** Colours of segments, origins and text, as the theme has them. */

/** As many colours as the palette has before it repeats. */
export const COLORS = 7;

/** @param {{color: number|null}} segment */
export function segmentFill({ color }) {
  return color === null
    ? "var(--hatch-line)"
    : `var(--segment-${((color % COLORS) + COLORS) % COLORS})`;
}

/** CSS variable of an origin's colour. @param {import("../model/types.js").Origin} origin */
export const originColor = (origin) => `var(--origin-${origin})`;

/** The value of a CSS variable now. @param {string} name */
export function cssColor(name) {
  return getComputedStyle(document.documentElement).getPropertyValue(name).trim();
}
