/**
 * Every format in which a recording can be written: the file it becomes, what it leaves behind,
 * how it is read again, and where it cannot be written, why.
 */

import { byId, el, icon } from "../../lib/dom.js";

/** @typedef {import("../../messages/export_messages").OfferLine} Offer */

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 */
export function createExporting(store, actions) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("exporting"));
  const formats = el("div", {
    class: "export-formats",
    role: "radiogroup",
    "aria-label": "Format",
  });
  const details = el("div", { class: "export-details", "aria-live": "polite" });
  const scope = scopeChoice();
  const trim = tick("Leave out idle ends");
  const write = /** @type {HTMLButtonElement} */ (
    el("button", { type: "button", class: "button primary", text: "Write" })
  );
  const told = createTold(store, actions);
  dialog.append(
    el("h2", { text: "Export" }),
    el("div", { class: "export-body" }, formats, details),
    told,
    el(
      "div",
      { class: "buttons" },
      scope.node,
      trim.node,
      el("span", { class: "space" }),
      write,
      el("button", {
        type: "button",
        class: "button",
        text: "Close",
        on: { click: () => dialog.close() },
      }),
    ),
  );
  let chosen = "json";

  function choose(name) {
    const { offers, exporting } = store.state;
    const offer = offers?.items.find((one) => one.name === name) ?? offers?.items[0];
    if (!offer) return;
    chosen = offer.name;
    details.replaceChildren(...describe(offer, actions));
    trim.node.hidden = !offer.trims;
    write.disabled = Boolean(offer.refusal || exporting);
  }
  write.addEventListener("click", () => {
    const trims = !trim.node.hidden && trim.input.checked;
    const { picked } = store.state;
    actions.exportAs(chosen, { scope: scope.value(), picked, trim_idle: trims });
  });
  formats.addEventListener("change", ({ target }) =>
    choose(/** @type {HTMLInputElement} */ (target).value),
  );
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());
  dialog.addEventListener("close", () => store.set({ offers: null }));

  store.on(["offers"], ({ offers, recordings: { items }, picked }) => {
    if (!offers) return dialog.open && dialog.close();
    scope.show(items, picked);
    formats.replaceChildren(...linesOf(offers.items, chosen));
    choose(chosen);
    if (dialog.open) return undefined;
    dialog.showModal();
    return /** @type {HTMLElement} */ (formats.querySelector("input:checked"))?.focus();
  });
  store.on(["exporting"], () => choose(chosen));
}

/** Those that this recording can be written in come first. @param {Offer[]} items @param {string} chosen */
function linesOf(items, chosen) {
  const lines = (some) => some.map((offer) => formatLine(offer, chosen));
  const cannot = lines(items.filter(({ refusal: why }) => why));
  const heading = el("p", { class: "export-heading", text: "Not for this recording, or not yet" });
  const can = lines(items.filter(({ refusal: why }) => !why));
  return cannot.length ? [...can, heading, ...cannot] : can;
}

/** @param {Offer} offer @param {string} chosen */
function formatLine({ name, title, file, refusal, install }, chosen) {
  return el(
    "label",
    { class: `export-format ${refusal ? "cannot" : ""}`, data: { format: name } },
    el("input", { type: "radio", name: "format", value: name, checked: name === chosen }),
    el(
      "span",
      {},
      el("b", { text: title }),
      el("small", { text: refusal && !install ? "" : file }),
    ),
  );
}

/** @param {Offer} offer @param {any} actions */
function describe(offer, actions) {
  const list = (title, items) =>
    items.length
      ? [el("h3", { text: title }), el("ul", {}, ...items.map((text) => el("li", { text })))]
      : [];
  // Of what this recording can never become, no file is named.
  if (offer.refusal && !offer.install) return [refusal(offer, actions)];
  return [
    el("h3", { class: "export-file" }, icon("file"), el("code", { text: offer.file })),
    ...(offer.refusal ? [refusal(offer, actions)] : []),
    ...(offer.copies
      ? [el("p", { text: "A copy of what was recorded, which itself stays as it is." })]
      : []),
    ...(offer.refusal
      ? []
      : offer.not_carried.length
        ? list("What it leaves behind", offer.not_carried)
        : [el("p", { text: "Carries everything." })]),
    ...list("Good to know", offer.remarks),
    el("h3", { text: "Read it in Python" }),
    el("pre", { class: "lines", tabindex: "0", text: offer.reads_back }),
    copier("Copy these lines", offer.reads_back, actions),
  ];
}

/** @param {Offer} offer @param {any} actions */
function refusal({ refusal: why, install }, actions) {
  return el(
    "div",
    { class: "export-refusal" },
    el("p", {
      text: install ? "A package is missing. Install it, and start keyphase again:" : why,
    }),
    ...(install ? [el("code", { text: install }), copier("Copy", install, actions)] : []),
  );
}

function copier(title, text, actions) {
  return el("button", {
    type: "button",
    class: "link",
    text: title,
    on: { click: () => actions.copy(text) },
  });
}

/** How far it is, and where it is then. */
function createTold(store, actions) {
  const bar = el("i");
  const meter = el("div", { class: "spread-progress" }, bar);
  const line = el("p", { class: "export-told", role: "status" });
  const node = el("div", {}, meter, line);
  store.on(["exporting", "saved", "progress", "recording"], (state) => {
    const { exporting, progress, recording } = state;
    const saved = state.saved?.recording === recording ? state.saved : null;
    meter.hidden = !exporting;
    bar.style.setProperty("width", `${100 * (progress?.fraction ?? 0)}%`);
    line.replaceChildren(
      ...(exporting
        ? [progress?.name ?? "Writing"]
        : saved
          ? [el("b", { text: "Written to " }), saved.path, copier("Copy path", saved.path, actions)]
          : []),
    );
  });
  return node;
}

function tick(text) {
  const input = /** @type {HTMLInputElement} */ (el("input", { type: "checkbox" }));
  return { input, node: el("label", { class: "export-tick", hidden: true }, input, text) };
}

/** Which recordings: this one, those that are done, all of the list. */
function scopeChoice() {
  const select = /** @type {HTMLSelectElement} */ (el("select", { "aria-label": "Which" }));
  return {
    node: select,
    value: () => /** @type {"this"|"picked"|"done"|"all"} */ (select.value),
    /** @param {import("../../model/types.js").Recording[]} items @param {string[]} picked */
    show(items, picked) {
      const done = items.filter(({ state }) => state === "done").length;
      const before = picked.length > 1 ? "picked" : select.value || "this";
      const choices = [
        ["this", "This recording"],
        ...(picked.length > 1 ? [["picked", `The ${picked.length} picked`]] : []),
        ...(done ? [["done", `The ${done} that ${done === 1 ? "is" : "are"} done`]] : []),
        ...(items.length > 1 ? [["all", `All ${items.length} of the list`]] : []),
      ];
      select.replaceChildren(...choices.map(([value, text]) => el("option", { value, text })));
      select.value = choices.some(([value]) => value === before) ? before : "this";
    },
  };
}
