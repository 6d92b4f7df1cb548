/** Puts the page together: state, socket, parts. */

import { sceneFrames } from "./scene/viser_client.js";
import { createAddress } from "./actions/address.js";
import { createActions } from "./actions/actions.js";
import { createCommands } from "./actions/keys/commands.js";
import { showOthers } from "./actions/others.js";
import { boundaryText, createAnnouncer, segmentText } from "./panels/announcer.js";
import { createReadNotices } from "./panels/overlays/read_notices.js";
import { createSceneTools } from "./panels/scene_tools.js";
import { createCameras } from "./panels/cameras/cameras.js";
import { createOutline } from "./timeline/outline.js";
import { createBanners } from "./panels/banners.js";
import { byId, placeIcons } from "./lib/dom.js";
import { createDescribing } from "./panels/describing/describing.js";
import { createEmpty } from "./panels/empty.js";
import { createGrid } from "./panels/grid/grid.js";
import { createFirstSteps } from "./panels/first_steps.js";
import { createExplain } from "./panels/overlays/explain.js";
import { createHeader } from "./panels/header.js";
import { createKeys, letGoOfButton } from "./actions/keys/keys.js";
import { keepFocus } from "./actions/keys/kept_focus.js";
import { createHeldLabel } from "./actions/keys/held_label.js";
import { createKeysSheet } from "./panels/overlays/keys_sheet.js";
import { createOwnChanges } from "./model/own_changes.js";
import { createLatency } from "./model/latency.js";
import { createMenu } from "./panels/overlays/menu.js";
import { createNotices } from "./panels/overlays/notices.js";
import { createPalette } from "./panels/overlays/palette.js";
import { createPanel } from "./panels/panel/panel.js";
import { createPlan } from "./panels/plan.js";
import { createPlayback } from "./model/playback.js";
import { createQueue } from "./panels/queue.js";
import { createReceiver } from "./model/receive.js";
import { createReplayKeys } from "./replay/replay_keys.js";
import { createReplay, createReplayActions } from "./replay/replay.js";
import { createRename } from "./panels/overlays/rename.js";
import { createScene } from "./scene/scene.js";
import { createNames } from "./scene/names.js";
import { aboutDocument } from "./model/about_document.js";
import { drawWhatIsInView } from "./scene/in_view.js";
import { askForShadows } from "./scene/shadows.js";
import { createSignals } from "./model/signals.js";
import { openSocket } from "./lib/socket.js";
import { createSplitter } from "./panels/splitter.js";
import { createExporting } from "./panels/overlays/exporting.js";
import { createInTheWay } from "./panels/overlays/in_the_way.js";
import { createSpread } from "./panels/overlays/spread.js";
import { showAnother, showProposals } from "./actions/proposals.js";
import { arriveWhereAsked } from "./actions/grid_actions.js";
import { firstState } from "./model/state.js";
import { createStatus } from "./panels/status.js";
import { createStore } from "./lib/store.js";
import { createTheme, firstDark } from "./panels/theme.js";
import { createLens } from "./timeline/lens.js";
import { attachPointer } from "./timeline/hand/pointer.js";
import { firstChoice, SMALL_BELOW_PX, tracksOf } from "./model/rows.js";
import { createTimeline } from "./timeline/timeline.js";
import { createTake } from "./panels/take.js";
import { createTransport } from "./panels/transport.js";
import { createUpload } from "./actions/upload.js";

/** In a narrower window the panel slides over the scene, as narrow.css has it. */
const DRAWERS_BELOW_PX = 1100;
const isSmall = () => innerWidth <= SMALL_BELOW_PX;

/** Kept in memory only: a tab that is duplicated is another page. */
const pageId = Array.from(crypto.getRandomValues(new Uint8Array(16)), (one) =>
  one.toString(16).padStart(2, "0"),
).join("");
const store = createStore(firstState(isSmall()));

/** @type {import("./lib/socket.js").Socket|null} */
let socket = null;
const send = (message) => socket?.send(aboutDocument(message, store.state.document)) ?? false;
const latency = createLatency(store, send, sceneFrames);
const signals = createSignals(store, send, () => wantedTracks(store.state));
const own = createOwnChanges(store);
const actions = createActions(store, send, latency, own);
const dialogs = {
  openPalette: (query, kind) => palette.open(query, kind),
  openKeys: () => keysSheet.open(),
  chooseFiles: () => upload.choose(),
  openMenu: () => menu.forChosen(timeline),
};
const replayActions = createReplayActions(store, send);
Object.assign(actions, { replay: replayActions });
const commands = createCommands(actions, store, dialogs);
const palette = createPalette(store, actions, () => commands);
const keysSheet = createKeysSheet(() => commands);
const menu = createMenu(store, actions);
const notices = createNotices(store);
const playback = createPlayback(store);

/**
 * The overview needs the error or the speed even where their tracks are hidden; so does snapping.
 * @param {import("./lib/store.js").State} state
 */
function wantedTracks(state) {
  const channels = state.document?.channels ?? [];
  const always = channels.includes("force")
    ? ["error", "speed", "force", "position"]
    : ["speed", "position"];
  return [...new Set([...always, ...tracksOf(state).map(({ key }) => key)])];
}

// The token in the link has done its work; it should not stay in the address or the history.
history.replaceState(null, "", location.pathname + location.hash);
placeIcons();
createTheme(store, send);
// A comparison is with what is shown now, whatever has been edited since.
store.later(["document"], ({ comparison }) => comparison?.with && actions.compare(comparison.with));
store.later(["recording"], () => actions.compare(null));
showOthers(store, actions);
showProposals(store, actions);
showAnother(store, actions);
arriveWhereAsked(store, actions);
const applySize = () =>
  (document.documentElement.dataset.size = store.state.small ? "small" : "large");
applySize();
store.on(["small"], applySize);
const timeline = createTimeline(document.getElementById("timeline"), store, actions);
const pointer = attachPointer(
  store,
  timeline,
  Object.assign(actions, { menu: menu.forTimeline, openPalette: dialogs.openPalette }),
);
createSplitter(store, timeline.naturalHeight);
createHeader(store, actions, dialogs);
createBanners(store, actions);
createQueue(store, actions, menu);
createTransport(store, actions, menu);
createPlan(store, actions);
createStatus(store);
createPanel(store, actions);
createAddress(store, actions);
createReadNotices(store);
createAnnouncer(store);
createOutline(byId("timeline"), store, actions, { segment: segmentText, boundary: boundaryText });
createSceneTools(store, actions);
createCameras(store, actions);
const replay = createReplay(store, replayActions);
createEmpty(store, actions, dialogs);
createFirstSteps(store);
createSpread(store, actions);
createGrid(store, actions);
createExporting(store, actions);
createTake(store, actions);
createInTheWay(store, actions);
createDescribing(store, send);
createExplain(store, timeline, actions);
createRename(store, timeline, actions);
createLens(store, timeline, signals);
store.on(["recording", "method", "hidden"], () => signals.follow());
store.on(["view", "plotWidth"], () => signals.follow());

/** Escape gives up one thing at a time, the innermost first. */
function escape() {
  if (pointer.cancel() || menu.close()) return true;
  const { explained, current, selected, drawer } = store.state;
  if (explained !== null || current !== null) store.set({ explained: null, current: null });
  else if (drawer && innerWidth < DRAWERS_BELOW_PX) store.set({ drawer: null });
  else if (selected !== null) actions.select(null);
  else return notices.close() || upload.cancel();
  return true;
}

const replayKey = createReplayKeys(store, replayActions, commands);
const heldLabel = createHeldLabel(store, actions);
const plainKey = createKeys(store, actions, commands, heldLabel, escape);
const onKey = (event) => replayKey(event) || plainKey(event);
addEventListener("keydown", onKey);
addEventListener("keyup", heldLabel.release);
addEventListener("click", (event) => letGoOfButton(event, timeline.surface));
addEventListener("resize", () => {
  const small = isSmall();
  if (small === store.state.small) return;
  store.set({ small, ...firstChoice(small) });
});

const receive = createReceiver(store, {
  latency,
  playback,
  notices,
  signals,
  replay,
  upload: () => upload,
  own,
  describe: actions.describe,
});
socket = openSocket(pageId, {
  onBroken: (why) => receive({ type: "notice", level: "error", text: why }),
  onMessage: receive,
  onSignals: (frame) => signals.receive(frame),
  onState(connected) {
    if (!connected) {
      upload.broke();
      own.forget();
    }
    const { document: doc, lostAt, following } = store.state;
    // A server that was started anew would show the first recording; asked before anything else.
    if (connected && doc && !following) actions.open(doc.id);
    store.set(
      connected
        ? { connected, lostAt: null }
        : {
            connected,
            saving: false,
            readOnly: true,
            greeted: doc !== null,
            lostAt: lostAt ?? new Date(),
          },
    );
  },
});
const upload = createUpload(store, socket, actions);
const sceneFrame = createScene(store, pageId);
createNames(store, actions, () => sceneFrame.contentWindow);
drawWhatIsInView(store, send);
askForShadows(store, send, () => sceneFrame.contentWindow);
keepFocus(store, timeline.surface);
store.set({ dark: firstDark(), snap: true });

/** For tests and for anyone who wants to know how fast it is. */
/** @type {any} */ (window).keyphase = {
  latency: latency.list,
  state: store.state,
  actions,
  timeline,
  socket,
  store,
};
