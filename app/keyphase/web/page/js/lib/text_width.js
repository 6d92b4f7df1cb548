/** How wide a text will be, without laying it out. */

const FAMILY = 'Inter, "SF Pro Text", "Segoe UI", "Liberation Sans", Arial, sans-serif';
const LIMIT = 4000;

/** @type {CanvasRenderingContext2D|null} */
let context = null;
/** @type {Map<string, number>} */
let known = new Map();

/**
 * @param {string} text
 * @param {string} font size with weight, such as "600 12px"
 * @returns {number} px
 */
export function textWidth(text, font) {
  const key = `${font}|${text}`;
  const width = known.get(key);
  if (width !== undefined) return width;
  context ??= document.createElement("canvas").getContext("2d");
  context.font = `${font} ${FAMILY}`;
  const measured = context.measureText(text).width;
  if (known.size > LIMIT) known = new Map();
  known.set(key, measured);
  return measured;
}

/**
 * A text, cut where it is too wide; "" where little would be left.
 * @param {string} text
 * @param {string} font
 * @param {number} room px
 */
export function fitted(text, font, room) {
  const whole = textWidth(text, font);
  if (whole <= room) return text;
  const letters = Math.floor((text.length * room) / whole) - 1;
  return letters < 3 ? "" : `${text.slice(0, letters).trimEnd()}…`;
}
