/** A small lens beside the pointer while a boundary is dragged: the force and speed around it. */

import { cssColor } from "../lib/colors.js";
import { byId } from "../lib/dom.js";
import { time as timeText } from "../lib/format.js";
import { eachSample, extent } from "./curves/series.js";

const WIDTH = 216;
const HEIGHT = 128;
const CLOSER = 6;
const TITLE_PX = 22;

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} timeline
 * @param {ReturnType<typeof import("../model/signals.js").createSignals>} signals
 */
export function createLens(store, timeline, signals) {
  const canvas = /** @type {HTMLCanvasElement} */ (byId("lens"));
  const ratio = Math.max(1, devicePixelRatio);
  canvas.width = WIDTH * ratio;
  canvas.height = HEIGHT * ratio;

  store.on(["drag", "lens"], (state) => {
    const { drag, document: doc } = state;
    canvas.hidden = !drag;
    if (!drag) return;
    const scale = timeline.scale();
    const half = (WIDTH / 2 / CLOSER) * ((scale.to - scale.from) / scale.width);
    const window = {
      from: Math.max(doc.start_s, drag.time - half),
      to: Math.min(doc.end_s, drag.time + half),
    };
    signals.look(window, WIDTH);
    place(canvas, timeline, drag);
    draw(canvas.getContext("2d"), ratio, state, drag, {
      from: drag.time - half,
      to: drag.time + half,
    });
  });
}

function place(canvas, timeline, { x, y }) {
  const box = timeline.surface.getBoundingClientRect();
  const right = box.left + x + 24;
  const left = right + WIDTH > innerWidth - 8 ? box.left + x - 24 - WIDTH : right;
  canvas.style.setProperty("left", `${left}px`);
  const beside = Math.max(8, Math.min(box.top + y - HEIGHT - 12, innerHeight - HEIGHT - 8));
  // Over the scene, where there is room, so that it covers no tool and no time.
  const above = byId("transport").getBoundingClientRect().top - HEIGHT - 8;
  canvas.style.setProperty("top", `${above < 8 ? beside : Math.min(above, beside)}px`);
}

/** @param {import("../lib/store.js").State} state */
function draw(ctx, ratio, state, drag, window) {
  ctx.setTransform(ratio, 0, 0, ratio, 0, 0);
  ctx.clearRect(0, 0, WIDTH, HEIGHT);
  const tracks = (state.lens ?? state.whole)?.tracks;
  const rows = ["force", "error", "speed"]
    .filter((name) => tracks?.get(name)?.series.length)
    .slice(0, 2);
  const height = (HEIGHT - TITLE_PX) / Math.max(rows.length, 1);
  rows.forEach((name, k) => {
    const { series } = tracks.get(name);
    const shown = name === "force" ? series : [series[0]];
    const colors = name === "force" ? ["--axis-x", "--axis-y", "--axis-z"] : ["--curve"];
    drawCurves(ctx, shown, colors, window, { top: TITLE_PX + k * height, height: height - 4 });
  });
  ctx.strokeStyle = cssColor("--accent");
  ctx.lineWidth = 1.5;
  ctx.beginPath();
  ctx.moveTo(WIDTH / 2, TITLE_PX);
  ctx.lineTo(WIDTH / 2, HEIGHT);
  ctx.stroke();
  ctx.font = '600 11px "Liberation Sans", Arial, sans-serif';
  ctx.fillStyle = cssColor("--text");
  ctx.fillText(`${timeText(drag.time)} s`, 10, 15);
  ctx.font = '11px "Liberation Sans", Arial, sans-serif';
  ctx.fillStyle = cssColor(drag.snapped ? "--accent-text" : "--text-3");
  ctx.textAlign = "right";
  ctx.fillText(
    drag.ripples ? "all later ones, too" : drag.snapped || "Alt: no snapping",
    WIDTH - 10,
    15,
  );
  ctx.textAlign = "left";
}

function drawCurves(ctx, series, colors, { from, to }, { top, height }) {
  const inside = series.map((one) => {
    const times = [];
    const values = [];
    eachSample(one, from, to, (time, value) => {
      times.push(time);
      values.push(value);
    });
    return { key: one.key, times, values };
  });
  const { low, high } = extent(/** @type {any} */ (inside));
  const span = Math.max(high - low, 1e-9);
  ctx.lineWidth = 1.2;
  inside.forEach(({ times, values }, k) => {
    ctx.strokeStyle = cssColor(colors[k]);
    ctx.beginPath();
    times.forEach((time, j) => {
      const x = ((time - from) / (to - from)) * WIDTH;
      const y = top + height - 3 - ((values[j] - low) / span) * (height - 6);
      if (j) ctx.lineTo(x, y);
      else ctx.moveTo(x, y);
    });
    ctx.stroke();
  });
}
