/** Light or dark: as the system says until a person says otherwise; the scene is told. */

const KEY = "keyphase-theme";

/** Whether to begin dark. */
export function firstDark() {
  const chosen = remembered();
  return chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
}

function remembered() {
  try {
    return localStorage.getItem(KEY);
  } catch {
    return null;
  }
}

/**
 * @param {import("../lib/store.js").Store} store
 * @param {import("../model/types.js").Send} send
 */
export function createTheme(store, send) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", ({ matches }) => {
    if (!remembered()) store.set({ dark: matches });
  });
  store.on(["dark"], ({ dark }) => {
    document.documentElement.dataset.theme = dark ? "dark" : "light";
    const system = matchMedia("(prefers-color-scheme: dark)").matches;
    try {
      if (dark === system) localStorage.removeItem(KEY);
      else localStorage.setItem(KEY, dark ? "dark" : "light");
    } catch {
      // Private windows may refuse storage; the choice then lasts as long as the page.
    }
  });
  store.on(["dark", "connected", "greeted"], ({ dark, connected, greeted, lookingOnly }) => {
    if (connected && greeted && !lookingOnly) send({ type: "theme", dark });
  });
}
