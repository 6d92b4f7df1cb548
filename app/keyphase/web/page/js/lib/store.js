/**
 * The page's one piece of state. Values are set by name; whoever named a value is called in the
 * next animation frame, once, however many messages came in between: the page draws frames, not
 * messages. What can wait (`later`) is drawn right after that frame, so that the timeline is seen
 * first.
 *
 * @typedef {import("../model/state.js").State} State
 * @typedef {(names: string[], draw: (state: State) => void) => void} Listen
 * @typedef {{state: State, set: (patch: Partial<State>) => void, on: Listen, later: Listen,
 *   drawNow: () => void, afterFrame: (done: () => void) => void}} Store
 */

/**
 * @param {State} initial
 * @returns {Store}
 */
export function createStore(initial) {
  const state = { ...initial };
  /** @type {{names: string[], draw: (state: State) => void}[]} */
  const listeners = [];
  /** @type {{names: string[], draw: (state: State) => void}[]} */
  const patient = [];
  const changed = new Set();
  const changedLater = new Set();
  let frame = 0;
  /** @type {(() => void)[]} */
  let waiting = [];

  function drawFrame() {
    frame = 0;
    // A draw may set further values (a view that has to follow): those join this very frame.
    for (let round = 0; changed.size && round < 3; round++) {
      const names = [...changed];
      changed.clear();
      for (const name of names) changedLater.add(name);
      tell(listeners, names, state);
    }
    if (changed.size) schedule();
    const done = waiting;
    waiting = [];
    runAfterFrame([...done, drawLater]);
  }

  function drawLater() {
    const names = [...changedLater];
    changedLater.clear();
    if (names.length) tell(patient, names, state);
  }

  function schedule() {
    if (!frame) frame = requestAnimationFrame(drawFrame);
  }

  return {
    state,
    set(patch) {
      for (const [name, value] of Object.entries(patch)) {
        if (Object.is(state[name], value)) continue;
        state[name] = value;
        changed.add(name);
      }
      if (changed.size) schedule();
    },
    on(names, draw) {
      listeners.push({ names, draw });
    },
    later(names, draw) {
      patient.push({ names, draw });
    },
    /** Draws what has changed at once: where keys typed next must find what was just opened. */
    drawNow() {
      cancelAnimationFrame(frame);
      drawFrame();
    },
    afterFrame(done) {
      waiting.push(done);
      schedule();
    },
  };
}

/** @param {State} state */
function tell(listeners, names, state) {
  for (const { names: wanted, draw } of listeners) {
    if (wanted.some((name) => names.includes(name))) draw(state);
  }
}

/**
 * Calls each function once the frame just drawn has been handed to the compositor: a message
 * posted inside an animation frame is delivered after that frame's style, layout and paint.
 * @param {(() => void)[]} functions
 */
function runAfterFrame(functions) {
  const channel = new MessageChannel();
  channel.port1.onmessage = () => {
    channel.port1.close();
    for (const run of functions) run();
  };
  channel.port2.postMessage(null);
}
