/** What a person can do with all recordings of the folder beside each other. */

import { countOf } from "../model/recordings/grid.js";
import { lastPhaseStep, withPhaseStep } from "../model/recordings/phase_steps.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 * @param {any} actions those these build on
 */
export function createGridActions(store, send, actions) {
  const { state } = store;
  const own = {
    /** Shows all recordings of the folder, or no more. */
    toggleGrid() {
      const gridShown = !state.gridShown;
      const anew = gridShown ? { grid: null, phaseSteps: [] } : {};
      store.set({ gridShown, gridChange: null, ...anew });
      send({ type: "grid", shown: gridShown });
    },
    askForGrid: () => send({ type: "grid", shown: true }),
    /** Opens a recording at a time, and leaves the grid. @param {string} id @param {number} time_s */
    openAt(id, time_s) {
      if (state.gridShown) own.toggleGrid();
      if (state.document?.id === id) return actions.goTo(time_s);
      store.set({ goTo: { id, time_s } });
      return actions.open(id);
    },
    /** Shows what a change of a phase would do, before it is made. @param {import("../model/recordings/grid.js").Change|null} gridChange */
    considerInAll: (gridChange) => store.set({ gridChange }),
    /** Makes the change that is shown. @param {boolean} includeDone */
    applyInAll(includeDone) {
      const change = state.gridChange;
      if (!change || state.readOnly) return;
      send({ type: "phase_for_all", ...change, include_done: includeDone });
      store.set({ gridChange: null });
    },
    undoInAll: () => !state.readOnly && send({ type: "phase_undo" }),
    /** Keeps these as the phases of the task; seen at once, so that the next change builds on it. @param {import("../model/recordings/grid.js").Phase[]} phases */
    writePhases(phases) {
      const { grid, phaseSteps } = state;
      if (state.readOnly || !grid) return;
      if (send({ type: "phases", name: grid.task, phases }))
        store.set({
          phaseSteps: withPhaseStep(phaseSteps, grid.phases, phases),
          grid: { ...grid, phases },
        });
    },
    /** The list of phases as it was before its last change. */
    undoPhases() {
      const { grid, phaseSteps } = state;
      const last = grid && lastPhaseStep(phaseSteps, grid.phases);
      if (state.readOnly || !last) return;
      if (send({ type: "phases", name: grid.task, phases: last.before }))
        store.set({ phaseSteps: phaseSteps.slice(0, -1), grid: { ...grid, phases: last.before } });
    },
    /** Calls a phase otherwise: where recordings have it, after a look at them all. */
    renamePhase(name, to) {
      const { grid } = state;
      if (!grid || !to || to === name) return;
      if (countOf(grid, name)) own.considerInAll({ label: name, to });
      else
        own.writePhases(grid.phases.map((one) => (one.name === name ? { ...one, name: to } : one)));
    },
  };
  return own;
}

/**
 * Goes to the time that was asked for as soon as its recording is shown.
 * @param {import("../lib/store.js").Store} store
 * @param {{goTo: (time: number) => void}} actions
 */
export function arriveWhereAsked(store, actions) {
  store.later(["recording", "goTo"], ({ goTo, recording }) => {
    if (!goTo || goTo.id !== recording) return;
    store.set({ goTo: null });
    actions.goTo(goTo.time_s);
  });
}
