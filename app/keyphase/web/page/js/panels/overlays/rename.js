/** Naming a segment where it stands, with the folder's labels to choose from. */

import { segmentFill } from "../../lib/colors.js";
import { byId, el, icon } from "../../lib/dom.js";
import { middle } from "../../model/segments.js";

const LEAST_WIDTH = 264;

const hint = () =>
  el(
    "p",
    {},
    el("kbd", { text: "Enter" }),
    "names it",
    el("kbd", { text: "Tab" }),
    "and goes on to the next",
  );

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} timeline
 * @param {any} actions
 */
export function createRename(store, timeline, actions) {
  const form = byId("rename");
  const input = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "text",
      "aria-label": "Label of the segment",
      maxlength: 200,
      autocomplete: "off",
      spellcheck: "false",
    })
  );
  const list = el("ul", { role: "listbox", "aria-label": "Labels of the folder" });
  form.append(input, list, hint());
  let choices = [];
  let at = -1;
  let typed = "";
  /** The time by which the segment that is being named is known. */
  let named = NaN;

  function complete() {
    const wanted = input.value.toLowerCase();
    const { labels, document: doc } = store.state;
    const known = labels.map(({ name, color }, k) => ({
      name,
      color,
      number: k < 9 ? k + 1 : null,
    }));
    const used = doc.segments
      .filter((segment) => !known.some(({ name }) => name === segment.label))
      .map(({ label, color }) => ({ name: label, color, number: null }));
    const all = [
      ...known,
      ...used.filter(({ name }, k) => used.findIndex((other) => other.name === name) === k),
    ];
    choices = all
      .filter(({ name }) => name.toLowerCase().includes(wanted) || wanted === typed.toLowerCase())
      .slice(0, 8);
    choose(-1);
  }

  function choose(index) {
    at = index;
    list.hidden = !choices.length;
    list.replaceChildren(
      ...choices.map(({ name, color, number }, k) =>
        el(
          "li",
          {
            class: k === at ? "on" : "",
            role: "option",
            "aria-selected": String(k === at),
            on: { pointerdown: (event) => (event.preventDefault(), finish(name)) },
          },
          el("i", {
            style: { background: typeof color === "string" ? color : segmentFill({ color }) },
          }),
          el("span", { text: name }),
          number ? el("kbd", { text: number }) : "",
          inVocabulary(name) ? forgetting(name) : "",
        ),
      ),
    );
  }

  const inVocabulary = (name) => store.state.labels.some((label) => label.name === name);

  /** Takes a label out of the folder's vocabulary; segments that have it keep it. */
  function forgetting(name) {
    return el(
      "button",
      {
        type: "button",
        class: "tool",
        title: "Take out of the vocabulary (Shift Delete)",
        "aria-label": `Take ${name} out of the vocabulary`,
        tabindex: "-1",
        on: {
          pointerdown: (event) => (
            event.preventDefault(),
            event.stopPropagation(),
            actions.forgetLabel(name)
          ),
        },
      },
      icon("close", "small"),
    );
  }

  /** @param {string|null} label @param {-1|0|1} goesOn to the kept segment before, to none, to the one after */
  function finish(label, goesOn = 0) {
    const { renaming, document: doc } = store.state;
    if (renaming === null) return;
    const { segments } = doc;
    const beside =
      goesOn > 0
        ? segments.findIndex(({ kept }, index) => index > renaming && kept)
        : segments.findLastIndex(({ kept }, index) => index < renaming && kept);
    store.set({ renaming: goesOn && beside >= 0 ? beside : null });
    store.drawNow();
    const text = label?.trim();
    if (text) actions.label(text, renaming);
  }

  input.addEventListener("input", complete);
  input.addEventListener("keydown", (event) => {
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by) choose(Math.min(Math.max(at + by, -1), choices.length - 1));
    else if (event.key === "Enter") finish(choices[at]?.name ?? input.value);
    else if (event.key === "Tab") finish(choices[at]?.name ?? input.value, event.shiftKey ? -1 : 1);
    else if (event.key === "Escape") finish(null);
    else if (
      event.key === "Delete" &&
      event.shiftKey &&
      choices[at] &&
      inVocabulary(choices[at].name)
    )
      actions.forgetLabel(choices[at].name);
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
  // Who types a name and presses elsewhere has named it; another window takes nothing away.
  input.addEventListener("blur", () => {
    if (document.hasFocus()) finish(input.value === typed ? null : input.value);
  });
  form.addEventListener("submit", (event) => event.preventDefault());

  store.later(["layout", "view", "plotWidth"], ({ renaming, document: doc }) => {
    const segment = renaming === null ? null : doc?.segments[renaming];
    if (segment && !form.hidden) place(form, timeline, segment);
  });
  store.on(["labels"], ({ renaming }) => renaming !== null && complete());
  store.on(["renaming"], ({ renaming, document: doc }) => {
    const segment = renaming === null ? null : doc?.segments[renaming];
    const wasOpen = !form.hidden;
    if (segment && wasOpen && segment.start_s < named && named < segment.end_s)
      return place(form, timeline, segment);
    named = segment ? middle(segment) : NaN;
    form.hidden = !segment;
    if (!segment) return wasOpen && timeline.surface.focus({ preventScroll: true });
    place(form, timeline, segment);
    typed = segment.label;
    input.value = segment.label;
    complete();
    input.focus();
    input.select();
    return undefined;
  });
}

function place(form, timeline, segment) {
  const box = timeline.surface.getBoundingClientRect();
  const scale = timeline.scale();
  const row = timeline.layout().rows.get("segments");
  const left = Math.max(0, scale.x(segment.start_s));
  const right = Math.min(scale.width, scale.x(segment.end_s));
  const width = Math.max(LEAST_WIDTH, right - left);
  const x = Math.min(box.left + left, innerWidth - width - 8);
  form.style.setProperty("left", `${x}px`);
  form.style.setProperty("top", `${box.top + row.y + (row.height - 30) / 2}px`);
  form.style.setProperty("width", `${width}px`);
}
