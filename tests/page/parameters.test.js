/** Sliders: where a value stands on the way, and which parameters there are. */

import assert from "node:assert/strict";
import { test } from "node:test";
import {
  automaticValue,
  parameterGroups,
  shareOf,
  valueAtShare,
  valueInForce,
} from "../../app/keyphase/web/page/js/model/parameters.js";

const channels = ["position", "force"];
const fieldsOf = (variant, given = channels) =>
  parameterGroups({ parameters: { variant }, channels: given }).flatMap(({ fields }) => fields);
const field = (variant, name) => fieldsOf(variant).find((one) => one.name === name);

test("a value comes back from its place on every slider", () => {
  for (const variant of ["evidence", "paper"])
    for (const one of fieldsOf(variant).filter(({ kind }) => kind === "number"))
      for (const share of [0, 0.2, 0.5, 0.83, 1]) {
        const value = valueAtShare(one, share);
        assert.ok(Math.abs(shareOf(one, value) - share) < 0.02, `${one.name} at ${share}`);
      }
});

test("a threshold over a probability runs in its log-odds", () => {
  const threshold = field("evidence", "force_threshold");
  assert.equal(valueAtShare(threshold, 0.5), 0.5);
  const step = (from, to) => shareOf(threshold, to) - shareOf(threshold, from);
  assert.ok(step(0.9, 0.95) > step(0.5, 0.55));
});

test("a value beyond the slider stands at its end", () => {
  assert.equal(shareOf(field("paper", "force_ratio"), 1e5), 1);
  assert.equal(shareOf(field("paper", "force_threshold"), 1e-9), 0);
});

test("where no force was recorded nothing about force is offered", () => {
  for (const variant of ["evidence", "paper"])
    assert.ok(
      !fieldsOf(variant, ["position"]).some(({ name }) => /force|step|persistence/.test(name)),
    );
});

test("what is held comes before what is set, what is set before what was found", () => {
  const doc = {
    threshold: 30,
    automatic_threshold: 30.7,
    parameters: { force_threshold: 30, force_ratio: 20 },
  };
  assert.equal(valueInForce(doc, {}, "force_threshold"), 30);
  assert.equal(valueInForce(doc, { force_threshold: 12 }, "force_threshold"), 12);
  assert.equal(valueInForce(doc, { force_threshold: null }, "force_threshold"), 30.7);
  assert.equal(automaticValue(doc, { force_ratio: 15 }, "force_ratio"), 15);
});
