/** Changing the parameters of a recording. */

/**
 * Whether nothing may be changed now; where a person could not know, they are told.
 * @param {import("../lib/store.js").Store} store
 */
export function refuses({ state, set }) {
  if (state.connected === false)
    set({ notice: { level: "warning", text: "keyphase is not running: nothing was changed." } });
  return state.readOnly;
}

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 * @param {ReturnType<typeof import("../model/latency.js").createLatency>} latency
 * @param {ReturnType<typeof import("../model/own_changes.js").createOwnChanges>} own
 */
export function createParameterActions(store, send, latency, own) {
  const actions = {
    resetParameters: () => send({ type: "reset" }),
    /**
     * A parameter as it is being held, or as it was let go; null is the automatic value.
     * @param {string} name
     * @param {*} value
     * @param {boolean} held
     * @param {Event} [input] what the hand did
     * @param {import("../model/latency.js").Source} [source]
     */
    setParameter(name, value, held, input, source = "slider") {
      if (!store.state.document || refuses(store)) return;
      const event = latency.began(input?.timeStamp ?? performance.now(), source);
      if (send({ type: "set", parameter: name, value, event, held }))
        own.moved(event, name, value, held);
    },
    automaticThreshold: (name = "force_threshold") => actions.setParameter(name, null, false),
  };
  return actions;
}
