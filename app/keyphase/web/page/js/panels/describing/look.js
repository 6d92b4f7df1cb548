/** The recording as it would be read: its path from two sides, its force, what would be done to it. */

import { el, svg } from "../../lib/dom.js";
import { time as timeText } from "../../lib/format.js";
import { fitted } from "./fitted.js";

const WIDTH = 190;
const HEIGHT = 96;

/** @param {import("./describing.js").Proposal} table */
export function drawLook({ looks }) {
  const title = el("h3", { text: looks.length > 1 ? "The recordings" : "The recording" });
  if (!looks.length)
    return el(
      "section",
      { "aria-label": "The recording" },
      title,
      el("p", { class: "quiet", text: "It is drawn here as soon as nothing is missing." }),
    );
  return el("section", { "aria-label": "The recording" }, title, ...looks.flatMap(drawn));
}

/**
 * One recording, under the name of its tool where there are several.
 * @param {import("../../messages/import_messages").TableLook} look
 */
function drawn({
  name,
  samples,
  duration_s: duration,
  rate_hz: rate,
  path_m: path,
  time_s: times,
  force_N: sizes,
  notices,
}) {
  const called = (label) => (name ? `${name}, ${label}` : label);
  const side = (first, second, label) =>
    figure(
      called(label),
      fitted(
        path.map((p) => [p[first], p[second]]),
        WIDTH,
        HEIGHT,
        true,
      ),
      "path",
    );
  const force = sizes?.map((value, i) => [times?.[i] ?? 0, value]);
  return [
    el("p", {
      class: "numbers",
      text: called(`${samples} samples, ${timeText(duration)} s at ${rate.toPrecision(4)} Hz`),
    }),
    el(
      "div",
      { class: "describing-figures" },
      side(0, 2, `from the side, ${extent(path, 0)} wide, ${extent(path, 2)} high`),
      side(0, 1, `from above, ${extent(path, 1)} deep`),
      force &&
        figure(
          called(`force, at most ${largest(force)} N`),
          fitted(force, WIDTH, HEIGHT, false),
          "force",
        ),
    ),
    el("ul", {}, ...notices.map((text) => el("li", { text }))),
  ];
}

function figure(label, points, kind) {
  return el(
    "figure",
    {},
    svg(
      "svg",
      { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": label },
      svg("polyline", { class: kind, points: points.map((p) => p.join(",")).join(" ") }),
      kind === "path" && svg("circle", { cx: points[0][0], cy: points[0][1], r: 3 }),
    ),
    el("figcaption", { text: label }),
  );
}

const extent = (path, axis) => {
  const values = path.map((point) => point[axis]);
  return `${(1000 * (Math.max(...values) - Math.min(...values))).toPrecision(3)} mm`;
};

const largest = (force) => Math.max(...force.map(([, value]) => value)).toPrecision(3);
