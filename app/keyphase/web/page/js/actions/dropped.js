/** What was dropped on the page: files, and those in folders that are no dataset. */

/** A folder with one of these is one recording, or a dataset, of many files. */
const OF_ONE = ["metadata.yaml", "meta/info.json", ".zgroup", ".zarray", "zarr.json"];
const MOST_FILES = 500;
const DEEPEST = 4;

/**
 * @typedef {{isDirectory: boolean, name: string, file?: (done: (file: File) => void, failed: () => void) => void,
 *   createReader?: () => {readEntries: (done: (some: Entry[]) => void, failed: () => void) => void}}} Entry
 */

/**
 * The files that can be sent, and a sentence for each folder whose files cannot.
 * @param {DataTransfer} transfer
 * @param {(name: string) => boolean} isRecording by its ending
 * @returns {Promise<{files: File[], refused: string[]}>}
 */
export async function droppedFiles(transfer, isRecording) {
  // What was dropped is known only until the first wait.
  const files = [...transfer.files];
  const entries = [...transfer.items].map(
    (item) => /** @type {Entry|null} */ (item.webkitGetAsEntry?.() ?? null),
  );
  const folders = entries.filter((entry) => entry?.isDirectory);
  if (!folders.length) return { files, refused: [] };
  const names = new Set(folders.map(({ name }) => name));
  /** @type {File[]} */
  const found = files.filter(({ name }) => !names.has(name));
  const refused = [];
  for (const folder of folders) {
    const inside = (await filesIn(folder, "")).sort(byPath);
    const some = inside.filter(({ entry }) => isRecording(entry.name));
    const isDataset = inside.some(({ path }) => OF_ONE.includes(path));
    if (isDataset || !some.length) refused.push(whyNot(folder.name, isDataset));
    else found.push(...(await Promise.all(some.map(({ entry }) => fileOf(entry)))));
  }
  return { files: found, refused };
}

const byPath = (one, other) => one.path.localeCompare(other.path, "en", { numeric: true });

const whyNot = (name, isDataset) =>
  isDataset
    ? `${name} is one dataset of many files, which a browser cannot send as one: open it in a terminal, as in “keyphase ${name}”.`
    : `${name} is a folder without a recording that can be sent; open it in a terminal, as in “keyphase ${name}”, to hear what is in it.`;

/** @param {Entry} folder @param {string} before @returns {Promise<{path: string, entry: Entry}[]>} */
async function filesIn(folder, before, depth = 0) {
  const reader = folder.createReader();
  const found = [];
  // A folder is told of in parts, until one is empty.
  for (let some = await part(reader); some.length; some = await part(reader)) {
    for (const entry of some) {
      const path = `${before}${entry.name}`;
      if (!entry.isDirectory) found.push({ path, entry });
      else if (depth < DEEPEST) found.push(...(await filesIn(entry, `${path}/`, depth + 1)));
    }
    if (found.length > MOST_FILES) break;
  }
  return found.slice(0, MOST_FILES);
}

/** @returns {Promise<Entry[]>} */
const part = (reader) => new Promise((done) => reader.readEntries(done, () => done([])));

/** @param {Entry} entry @returns {Promise<File>} */
const fileOf = (entry) => new Promise((done, failed) => entry.file(done, () => failed()));
