/** Numbers as the page writes them: a true minus sign, tabular digits, no more than is known. */

/**
 * A value with its sign, for curves and steps: "+3.80", "−0.32".
 * @param {number} value
 * @param {number} digits
 */
export function signed(value, digits = 1) {
  const text = Math.abs(value).toFixed(digits);
  return (value < 0 && Number(text) !== 0 ? "−" : "+") + text;
}

/** A tick or a plain value. @param {number} value */
export function plain(value) {
  return String(Number(value.toPrecision(6))).replace("-", "−");
}

/** From here on a time is told in minutes or hours. */
const LONG_S = 600;

/**
 * A time, with milliseconds unless told otherwise: "4.204", and from ten minutes on "12:05.500" or
 * "1:06:39.996".
 * @param {number} seconds
 * @param {number} [digits]
 */
export function time(seconds, digits = 3) {
  if (Math.abs(seconds) < LONG_S) return seconds.toFixed(digits).replace("-", "−");
  const units = Math.round(Math.abs(seconds) * 10 ** digits);
  const whole = Math.floor(units / 10 ** digits);
  const [hours, minutes] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60];
  const rest = ((units / 10 ** digits) % 60).toFixed(digits).padStart(digits ? digits + 3 : 2, "0");
  const before = hours ? `${hours}:${String(minutes).padStart(2, "0")}` : String(minutes);
  return `${seconds < 0 ? "−" : ""}${before}:${rest}`;
}

/** What a person typed for a time [s]: "4.2", "4,2 s", "12:05.5" or "1:06:39"; NaN where it is none. */
export function seconds(text) {
  const parts = text.trim().replace(/ ?s$/, "").replace("−", "-").replace(",", ".").split(":");
  if (parts.length > 3 || !parts.every((part) => /^-?\d+(\.\d*)?$/.test(part.trim()))) return NaN;
  return parts.reduce((sum, part) => 60 * sum + Number(part), 0);
}

/** A time with its unit, where it needs one: "4.204 s", "1:06:39.996". @param {number} seconds */
export function moment(seconds) {
  return Math.abs(seconds) < LONG_S ? `${time(seconds)} s` : time(seconds);
}

/** A duration in a segment: "1.40 s". @param {number} seconds */
export function duration(seconds) {
  return `${seconds.toFixed(2)} s`;
}

/**
 * The height of a peak or a threshold, three digits: "465", "23.9", "1.20".
 * @param {number} value
 */
export function height(value) {
  if (!Number.isFinite(value)) return "";
  if (value >= 1e5) return value.toExponential(1).replace("e+", "e");
  return value >= 100 ? value.toFixed(0) : value >= 10 ? value.toFixed(1) : value.toFixed(2);
}

/** Half an interval: "± 8 ms" or "± 0.31 s". @param {[number, number]} interval */
export function halfWidth([low, high]) {
  const half = (high - low) / 2;
  return half < 0.1 ? `± ${Math.max(1, Math.round(half * 1000))} ms` : `± ${half.toFixed(2)} s`;
}

/** One thing or several: plural(2, "edit") is "2 edits". @param {number} count @param {string} noun */
export function plural(count, noun, several = `${noun}s`) {
  return `${count} ${count === 1 ? noun : several}`;
}
