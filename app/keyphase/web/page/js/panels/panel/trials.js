/** Trials: the plan in many worlds at once. */

import { createBeside } from "./beside.js";
import { slider } from "./fields.js";

const FEWEST = 10;
const MOST = 200;

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createTrials(store, actions) {
  let count = 20;
  const worlds = slider({
    title: "Worlds",
    hint:
      "Each with parts up to 10 mm higher or lower and 5 mm aside, friction 0.2 to 0.6 and twice " +
      "the sensor noise.",
    low: FEWEST,
    high: MOST,
    step: 1,
    share: (value) => (value - FEWEST) / (MOST - FEWEST),
    value: (share) => Math.round((FEWEST + share * (MOST - FEWEST)) / 10) * 10,
    told: (value) => (count = value ?? count),
  });
  worlds.show(count);
  return createBeside(store, {
    title: "Trials",
    key: "trials",
    start: "Run trials",
    hint: "Replay the plan in disturbed worlds and count its successes.",
    before: [worlds.node],
    begin: () => actions.trials(count),
    cancel: actions.cancelTrials,
    far: (run) => `${run.done} of ${run.count} worlds`,
  });
}
