/** What is said once no doubt of a recording is left. */

import assert from "node:assert/strict";
import { test } from "node:test";
import { createDoubtActions } from "../../app/keyphase/web/page/js/actions/doubt_actions.js";
import { boundary, documentOf } from "./documents.js";

/** A store that tells at once, and what is done by other actions. */
function given(document) {
  const recordings = {
    items: [{ id: document.id, state: "touched", unsure: 0, name: "a", folder: "" }],
  };
  const filter = "";
  const state = {
    document,
    recordings,
    filter,
    recording: document.id,
    current: null,
    playhead: {},
  };
  const listeners = [];
  const set = (patch) => {
    Object.assign(state, patch);
    for (const [names, draw] of listeners) if (names.some((name) => name in patch)) draw(state);
  };
  const store = { state, set, on: (names, draw) => listeners.push([names, draw]) };
  const done = [];
  const names = ["select", "goTo", "open", "visit", "playAround"];
  const others = Object.fromEntries(names.map((name) => [name, (to) => done.push([name, to])]));
  const actions = createDoubtActions(/** @type {any} */ (store), others);
  return { state: /** @type {any} */ (state), set, actions, done };
}

test("how a recording differs is told, and where, once its proposal was taken over", () => {
  const before = documentOf(10, [boundary(5)], { revision: 3 });
  const { state, set, actions, done } = given(before);
  const at = before.segments[1].label;
  actions.doubtsOfProposal({ at, told: `“${at}” is missing` });
  set({ document: { ...before, revision: before.revision + 1 } });
  assert.match(state.notice.text, new RegExp(`It differs: “${at}” is missing`));
  assert.equal(state.notice.level, "warning");
  assert.deepEqual(done, [
    ["select", 1],
    ["goTo", before.segments[1].start_s],
  ]);
  actions.nextDoubt();
  assert.match(state.notice.text, /^No doubt left/);
});

test("nothing is said of a phase where the proposal fitted", () => {
  const before = documentOf(10, [boundary(5)], { revision: 3 });
  const { state, set, actions, done } = given(before);
  actions.doubtsOfProposal(null);
  set({ document: { ...before, revision: before.revision + 1 } });
  assert.match(state.notice.text, /^No doubt left/);
  assert.deepEqual(done, []);
});

test("in a recording with a proposal, taking it over comes before doubts of the program’s own", () => {
  const unsure = (id) =>
    documentOf(10, [boundary(5, { unsure: true })], { id, name: id, revision: 3 });
  for (const [from, told] of [
    [["a"], /^b: Shift Enter takes over/],
    [[], undefined],
  ]) {
    const { state, set, actions, done } = given(documentOf(10, [], { revision: 3 }));
    const line = { id: "b", state: "automatic", unsure: 1, name: "b", folder: "" };
    const items = [...state.recordings.items, { ...line, proposed_from: from }];
    set({ recordings: { items } });
    actions.visitUnsure(1);
    assert.deepEqual(done, [["open", "b"]]);
    set({ document: unsure("b"), recording: "b" });
    if (told) assert.match(state.notice.text, told);
    else assert.deepEqual(done.at(-1), ["playAround", 5]);
  }
});
