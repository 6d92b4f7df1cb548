/** Small documents and states for tests of the page's pure parts. */

/** A boundary at a time; anything else as given. */
export function boundary(time, given = {}) {
  return {
    time_s: time,
    origin: "force",
    interval_s: [time - 0.01, time + 0.01],
    confidence: 0.9,
    contact_change: true,
    was_s: null,
    accepted: false,
    at_m: null,
    why: { sentences: [], height: 300, times_threshold: 10, position_s: null, steps: [] },
    ...given,
  };
}

/** A recording from 0 to `end` s at 100 Hz, cut at the boundaries. */
export function documentOf(end, boundaries, given = {}) {
  const cuts = [0, ...boundaries.map(({ time_s: time }) => time), end];
  const segments = cuts.slice(1).map((to, k) => ({
    start_s: cuts[k],
    end_s: to,
    label: `Segment ${k + 1}`,
    proposed: true,
    kept: true,
    idle: false,
    color: k,
    end_condition: {},
    short: [],
    middle_m: [0, 0, 0],
  }));
  return {
    id: "a",
    start_s: 0,
    end_s: end,
    rate_hz: 100,
    boundaries,
    segments,
    plan: [],
    proposed_drops: [],
    peaks: [],
    breaks: [],
    events: [],
    ...given,
  };
}

/** A series of samples, with times 0, step, 2 step, … */
export function seriesOf(values, step = 0.1) {
  return {
    key: "value",
    times: Float64Array.from(values, (_, k) => k * step),
    values: Float64Array.from(values),
  };
}
