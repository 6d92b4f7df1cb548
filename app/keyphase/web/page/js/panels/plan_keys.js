/**
 * Keys on a chip of the plan that has the focus: they mean this very entry, repeats included. Enter
 * selects its segment; on the selected one it accepts the name, as everywhere.
 */

/**
 * @param {HTMLElement} chips
 * @param {import("../lib/store.js").Store} store
 * @param {any} actions
 * @returns {{wanted: () => string|undefined}} which entry is to have the focus once it is drawn
 */
export function attachChipKeys(chips, store, actions) {
  /** @type {number|undefined} */
  let wanted;

  function reorder(change, then) {
    if (store.state.readOnly) return;
    const order = store.state.document.plan.map(({ time_s: time }) => time);
    change(order);
    wanted = then;
    actions.reorder(order);
  }

  function move(at, to) {
    if (to < 0 || to >= store.state.document.plan.length) return;
    reorder((order) => order.splice(to, 0, ...order.splice(at, 1)), to);
  }

  const takeOut = (at) => reorder((order) => order.splice(at, 1), at);
  const segmentOf = (at) => store.state.document.plan[at].segment;
  const keys = {
    Delete: takeOut,
    Backspace: takeOut,
    "{": (at) => move(at, at - 1),
    "}": (at) => move(at, at + 1),
    R: (at) => reorder((order) => order.splice(at + 1, 0, order[at]), at + 1),
    Enter: (at) => actions.select(segmentOf(at)),
  };

  chips.addEventListener("keydown", (event) => {
    const chip = /** @type {HTMLElement} */ (event.target).closest(".chip");
    const run = keys[event.key] ?? keys[event.key.toUpperCase()];
    if (!chip || !run || event.ctrlKey || event.metaKey || event.altKey) return;
    const at = Number(/** @type {HTMLElement} */ (chip).dataset.entry);
    if (event.key === "Enter" && segmentOf(at) === store.state.selected) return;
    event.preventDefault();
    event.stopPropagation();
    run(at);
  });
  return {
    wanted() {
      const entry = wanted;
      wanted = undefined;
      return entry === undefined ? undefined : String(entry);
    },
  };
}
