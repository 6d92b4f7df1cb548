/** From one unsure boundary to the next, in this recording and then in the others. */

import { nextDoubtful, nextUndone, proposedHere } from "../model/recordings/recording_list.js";
import { unsureBoundaries } from "../model/unsure.js";

/**
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions those these build on
 */
export function createDoubtActions(store, actions) {
  const { state } = store;
  /** The recording that is on its way so that its doubts are visited. @type {string|null} */
  let wanted = null;
  store.on(["recording"], ({ recording }) => {
    if (recording === wanted) arrive();
    wanted = null;
  });
  /** The document as it was before a proposal was taken over. @type {import("../model/types.js").Doc|null} */
  let taking = null;
  /** The phase that fits badly in what was taken over, until that was told. @type {{id: string, at: string, told: string}|null} */
  let misfit = null;
  store.on(["document"], ({ document: doc }) => {
    if (!taking || (doc?.id === taking.id && doc.revision <= taking.revision)) return;
    const arrived = doc?.id === taking.id;
    taking = null;
    if (arrived) own.nextDoubt();
  });
  /** What is played around a doubt ends with it. */
  store.on(["current"], ({ current, playhead }) => {
    if (current === null && playhead.between_s) actions.play({ playing: false });
  });
  const pace = createPace(store);
  /** Shows a doubt, and plays what is around it. @param {number} index */
  function show(index) {
    actions.visit(index);
    actions.playAround(state.document.boundaries[index].time_s);
  }
  const tell = (text) => store.set({ notice: { level: "info", text } });

  /** What differs from the finished recordings is looked at last. @param {string} then */
  function tellMisfit(then) {
    const { at, told } = misfit;
    misfit = null;
    const { segments } = state.document;
    const index = segments.findIndex(({ label }) => label === at);
    if (index >= 0) {
      actions.select(index);
      actions.goTo(segments[index].start_s);
    }
    store.set({ notice: { level: "warning", text: `It differs: ${told}. Look at it. ${then}` } });
  }

  /** Doubts of the program’s own boundaries may be none any more in what is proposed. */
  function arrive() {
    if (!proposedHere(state)) return own.visitUnsure(1);
    const { name } = state.document;
    return tell(`${name}: Shift Enter takes over what is proposed; N: the program’s own doubts.`);
  }

  /** Goes to the next recording with an unsure boundary, and there to the least certain one. */
  function goOn() {
    const next = nextDoubtful(state);
    if (!next) return tell("No boundary is unsure.");
    wanted = next.id;
    return actions.open(next.id);
  }

  const own = {
    visitUnsure(direction) {
      const unsure = unsureBoundaries(state.document);
      if (!unsure.length) return goOn();
      const at = unsure.indexOf(state.current);
      const next = at < 0 ? (direction > 0 ? 0 : unsure.length - 1) : at + direction;
      return show(unsure.at(next % unsure.length));
    },
    /** Once what is being taken over has come, its first doubt is shown. */
    doubtsOfProposal(/** @type {import("../messages/list_messages").Difference|null} */ differs) {
      taking = state.document;
      misfit = taking && differs ? { id: taking.id, at: differs.at, told: differs.told } : null;
    },
    /** The next unsure boundary; where none is left, what can be done now is told. */
    nextDoubt() {
      const unsure = unsureBoundaries(state.document);
      pace.decided();
      if (unsure.length) return show(unsure[0]);
      store.set({ current: null, explained: null });
      const next = nextUndone(state);
      const on = next && next.id !== state.recording ? `, on to ${next.name}` : "";
      const doubtful = nextDoubtful(state);
      const other = doubtful ? ` N: the next doubt, in ${doubtful.name}.` : "";
      const then = `K: done${on}.${other}`;
      if (misfit?.id !== state.document?.id) return tell(`No doubt left. ${then}`);
      return tellMisfit(then);
    },
  };
  return own;
}

/** Decisions further apart than this say nothing of the pace. */
const PAUSE_MS = 60_000;
const REMEMBERED = 9;

/** How long a person takes for a doubt: the middle one of the last few. @param {import("../lib/store.js").Store} store */
function createPace(store) {
  let before = 0;
  /** @type {number[]} */
  let took = [];
  return {
    decided() {
      const now = performance.now();
      if (before && now - before < PAUSE_MS) took = [...took, now - before].slice(-REMEMBERED);
      before = now;
      const middle = took.toSorted((a, b) => a - b)[took.length >> 1];
      if (took.length > 2) store.set({ secondsPerDoubt: middle / 1000 });
    },
  };
}
