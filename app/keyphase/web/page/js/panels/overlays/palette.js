/** The command palette: commands, recordings and labels by what one types. */

import { byId, el } from "../../lib/dom.js";

const MOST = 120;

/**
 * @param {import("../../lib/store.js").Store} store
 * @param {any} actions
 * @param {() => import("../../actions/keys/commands.js").Command[]} commands
 */
export function createPalette(store, actions, commands) {
  const dialog = /** @type {HTMLDialogElement} */ (byId("palette"));
  const input = /** @type {HTMLInputElement} */ (
    el("input", {
      type: "text",
      placeholder: "Commands, recordings, labels",
      "aria-label": "Commands, recordings, labels",
      autocomplete: "off",
      spellcheck: "false",
      role: "combobox",
      "aria-expanded": "true",
      "aria-controls": "palette-found",
    })
  );
  const list = el("ul", { id: "palette-found", role: "listbox", "aria-label": "Found" });
  dialog.append(input, list);
  let entries = [];
  let at = 0;
  /** What is looked for, where it is not everything. */
  let ofKind = "";

  function everything() {
    const { document: doc, recordings, labels, comparison } = store.state;
    const named = commands()
      .filter((command) => doc || command.always)
      .map(({ name, keys, run, group }) => ({ text: name, kind: group, key: keys[0] ?? "", run }));
    const open = recordings.items.map(({ id, name, error }) => ({
      text: name,
      kind: error ? "Recording, cannot be read" : "Recording",
      key: "",
      run: () => actions.open(id),
    }));
    const label = doc
      ? labels.map(({ name }, k) => ({
          text: name,
          kind: "Label the segment",
          key: k < 9 ? String(k + 1) : "",
          run: () => actions.label(name),
        }))
      : [];
    const compare = doc
      ? (comparison?.options ?? [])
          .filter((name) => name !== "automatic")
          .map((name) => ({
            text: `Compare with ${name}`,
            kind: "Recordings",
            key: "",
            run: () => actions.compare(name),
          }))
      : [];
    return [...named, ...compare, ...open, ...label];
  }

  function search() {
    const words = input.value.toLowerCase().split(/\s+/).filter(Boolean);
    entries = everything()
      .filter(({ kind }) => !ofKind || kind.split(",")[0] === ofKind)
      .filter(({ text, kind }) =>
        words.every((word) => `${text} ${kind}`.toLowerCase().includes(word)),
      )
      .slice(0, MOST);
    choose(0);
  }

  function choose(index) {
    at = Math.min(Math.max(index, 0), Math.max(0, entries.length - 1));
    list.replaceChildren(
      ...entries.map(({ text, kind, key }, k) =>
        el(
          "li",
          {
            id: `found-${k}`,
            class: k === at ? "on" : "",
            role: "option",
            "aria-selected": String(k === at),
            on: { click: () => run(k), pointermove: () => k !== at && choose(k) },
          },
          el("span", { text }),
          el("span", { class: "quiet", text: kind }),
          el("span", { class: "space" }),
          key ? el("kbd", { text: key }) : "",
        ),
      ),
    );
    if (!entries.length)
      list.replaceChildren(el("li", { class: "nothing", text: "Nothing has that name." }));
    input.setAttribute("aria-activedescendant", entries.length ? `found-${at}` : "");
    list.children[at]?.scrollIntoView({ block: "nearest" });
  }

  function run(index) {
    dialog.close();
    entries[index]?.run();
  }

  input.addEventListener("input", search);
  input.addEventListener("keydown", (event) => {
    if (!dialog.open) return;
    const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (by) choose(at + by);
    else if (event.key === "Enter") run(at);
    else return;
    event.preventDefault();
  });
  dialog.addEventListener("click", ({ target }) => target === dialog && dialog.close());

  return {
    open(query = "", kind = "") {
      if (dialog.open) return;
      ofKind = kind;
      input.value = query;
      dialog.showModal();
      search();
      input.focus();
    },
  };
}
