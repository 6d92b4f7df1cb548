/**
 * The address of a recording and a time in it: "#S07@16.82", so that a colleague can be sent there.
 */

/**
 * @param {string} name of the recording
 * @param {number|null} time [s]; null for the recording as a whole
 */
export function addressOf(name, time) {
  const written = encodeURIComponent(name).replaceAll("%2F", "/").replaceAll("%20", "+");
  return time === null ? `#${written}` : `#${written}@${Number(time.toFixed(3))}`;
}

/**
 * @param {string} hash as in `location.hash`
 * @returns {{name: string, time: number|null}|null} null where it names nothing
 */
export function addressIn(hash) {
  const [, written, time] = /^#(.+?)(?:@(-?\d+(?:\.\d+)?))?$/.exec(hash) ?? [];
  if (!written) return null;
  try {
    const name = decodeURIComponent(written.replaceAll("+", "%20"));
    return { name, time: time === undefined ? null : Number(time) };
  } catch {
    return null;
  }
}
