// Helicoide's own part of the page: the Stop button, the status line, their control channel, and the check that nobody
// drives an arm without being able to stop it.
"use strict";

(() => {
  const words = JSON.parse(document.currentScript.dataset.words);
  const channel = new URL("../helicoide/control", document.currentScript.src); // the page may be behind a sub-path
  channel.protocol = channel.protocol.replace("http", "ws");
  const BEAT_MS = 1000;
  const SILENT_BEATS = 2;
  const BEATS_KEPT = 30;
  const LONGEST_LINK = 36000; // a longer one is cut one character after that, and refused
  const SETTLED_MS = 120; // viser delays the last value of a slider by up to 50 ms
  const SEAT = "helicoide-seat";
  const OPEN = '[role="dialog"], [role="listbox"]';
  // Messages that no user action makes, and the parts of a file whose first message was sent.
  const NOT_BY_HAND = new Set([
    "ViewerCameraMessage",
    "FileTransferPart",
    "FileTransferPartAck",
    "GetRenderResponseMessage",
    "LocalStorageGetItemResponseMessage",
  ]);

  let language = navigator.language.startsWith("pt") ? "pt_BR" : "en";
  let notice = { status: "", tone: "ok" };
  let link = "opening"; // then "up" or "lost"
  let socket = null;
  let silence = 0; // heartbeats since the last message from the server
  let retryMs = 100;
  let stopUnheard = false;
  let fence = null; // number of a stop, until all pointers and keys were released after it
  let settling = null;
  let offsets = []; // the server's clock minus the page's, ms, at the last heartbeats; a slow answer makes it too small
  let shown = -1; // the tab in front that the server was told of
  const held = new Set(); // pointers and keys that are down

  function element(tag, id, attributes = {}) {
    const made = document.createElement(tag);
    made.id = id;
    for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
    return made;
  }

  const line = element("div", "helicoide-status", { role: "status", "aria-live": "polite" });
  const button = element("button", "helicoide-stop", { type: "button", "aria-keyshortcuts": "Escape" });
  const label = element("span", "helicoide-stop-label");
  const key = element("kbd", "helicoide-stop-key", { "aria-hidden": "true" });
  key.textContent = "Esc";
  button.append(label, key);

  function write(place, text) {
    if (place.textContent !== text) place.textContent = text; // a screen reader would read the same text again
  }

  function draw() {
    document.documentElement.lang = language.replace("_", "-");
    for (const look of ["projector", "transparent"]) {
      document.documentElement.toggleAttribute(`data-${look}`, notice[look] === true);
    }
    write(label, words[language][notice.everywhere ? "stop_all" : "stop"]);
    write(line, link === "lost" ? words[language].lost : notice.status);
    line.dataset.tone = link === "lost" ? "lost" : notice.tone;
    button.dataset.link = link;
  }

  function send(message) {
    if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
  }

  // A stop is sent again on every new connection until the server has confirmed it.
  function stop(closing = false) {
    stopUnheard = true;
    deafen(fence); // also ignores this user's actions until the server has confirmed the stop
    send({ stop: true, closing });
  }

  // Whether Escape also closes a dialog or a list. Then the stop is shown only if something moved.
  function closes() {
    return [...document.querySelectorAll(OPEN)].some((element) => element.checkVisibility({ visibilityProperty: true }));
  }

  function introduce() {
    if (!window.helicoideWindow) return;
    shown = -1;
    send({
      window: window.helicoideWindow,
      seat: remembered(),
      languages: [...navigator.languages],
      dark: matchMedia("(prefers-color-scheme: dark)").matches,
      link: window.helicoideLink.slice(0, LONGEST_LINK + 1),
      address: location.origin + location.pathname + location.search,
    });
  }

  function tabsOfPanel() {
    const lists = [...document.querySelectorAll("[role=tablist]")].map((list) => [...list.querySelectorAll("[role=tab]")]);
    return lists.find((list) => list.length > 1) ?? []; // a docked lesson has one tab
  }

  // viser builds the tabs a moment after it was told to. They follow a pointer or the Enter key, not a mere click().
  window.helicoideShowTab = (index, tries = 50) => {
    const tab = tabsOfPanel()[index];
    if (tab?.getAttribute("aria-selected") === "true" || tries === 0) return;
    tab?.dispatchEvent(new KeyboardEvent("keydown", { key: "Enter", bubbles: true }));
    setTimeout(() => window.helicoideShowTab(index, tries - 1), 100);
  };

  // Tells the server which tab of the panel is in front: only its rows need updates.
  function look() {
    const tabs = tabsOfPanel();
    const front = tabs.findIndex((tab) => tab.getAttribute("aria-selected") === "true");
    if (front === shown || front < 0) return;
    shown = front;
    send({ tab: front });
  }

  function remembered() {
    try {
      return localStorage.getItem(SEAT);
    } catch {
      return null; // a browser may refuse access to its storage
    }
  }

  function remember(seat) {
    try {
      localStorage.setItem(SEAT, seat);
    } catch {
      // then every visit gets a new seat
    }
  }

  function connect() {
    silence = 0;
    offsets = [];
    socket = new WebSocket(channel);
    socket.onopen = () => {
      link = "up";
      retryMs = 100;
      notice = { status: "", tone: "ok" };
      send({ beat: true });
      if (stopUnheard) stop();
      introduce();
      draw();
    };
    socket.onmessage = (event) => hear(JSON.parse(event.data));
    socket.onclose = lose;
  }

  function hear(message) {
    silence = 0;
    if (message.heard === "stop") stopUnheard = false;
    if (message.heard === "beat") offsets = [...offsets.slice(1 - BEATS_KEPT), message.at - performance.now()];
    if (message.fence) deafen(message.fence);
    if (message.seat) {
      remember(message.seat);
      window.helicoideLink = ""; // it is opened once, not again after a lost connection
    }
    if (message.status === undefined) return;
    language = message.language;
    notice = message;
    draw();
  }

  function lose() {
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
    link = "lost";
    draw();
    setTimeout(connect, retryMs);
    retryMs = Math.min(2 * retryMs, 1000);
  }

  // A cut cable or a stuck server does not close the socket, so unanswered heartbeats are counted.
  function beat() {
    if (socket.readyState > WebSocket.OPEN) return;
    if (silence >= SILENT_BEATS) return lose();
    silence += 1;
    send({ beat: true });
  }

  // After a stop, no user action is sent until all pointers and keys are released. Then the page sends a fence on
  // viser's socket, which keeps the order: all later messages are made by a user who could know of the stop.
  let deaf = true;
  let passOn = null; // viser's own sendMessage

  function deafen(number) {
    deaf = true;
    window.dispatchEvent(new Event("helicoide-deaf"));
    fence = number;
    settle();
  }

  function settle() {
    clearTimeout(settling);
    if (fence !== null && passOn !== null && held.size === 0) settling = setTimeout(pass, SETTLED_MS);
  }

  function pass() {
    if (held.size > 0 || stopUnheard || fence === null) return;
    passOn({ type: "HelicoideFence", number: fence });
    fence = null;
    deaf = false;
    window.dispatchEvent(new Event("helicoide-drives"));
  }

  function sendOfViser(message) {
    if (NOT_BY_HAND.has(message.type)) return passOn(message);
    if (link !== "up" || deaf || offsets.length === 0) return undefined;
    passOn({ type: "HelicoideMadeAt", at: performance.now() + Math.max(...offsets) });
    return passOn(message);
  }

  // viser sets a new sendMessage at every connection; `sendOfViser` is put before each of them.
  function stand() {
    const viser = window.__viserMutable;
    if (!viser || Object.getOwnPropertyDescriptor(viser, "sendMessage").get) return;
    passOn = viser.sendMessage;
    Object.defineProperty(viser, "sendMessage", {
      configurable: true,
      enumerable: true,
      get: () => sendOfViser,
      set: (way) => (passOn = way),
    });
    settle();
  }

  function press(what) {
    if (held.size === 0) send({ pressed: true }); // what is held from now on makes one change, of its own
    held.add(what);
    clearTimeout(settling);
  }

  function release(what) {
    held.delete(what);
    settle();
  }

  // macOS does not report that a key was released while Command was down: all keys count as released with Command.
  function releaseKey(event) {
    for (const what of event.key === "Meta" ? held : []) if (typeof what === "string") held.delete(what);
    release(event.code);
  }

  function releaseAll() {
    held.clear();
    settle();
  }

  button.addEventListener("pointerdown", () => stop()); // on press, not on release
  button.addEventListener("click", (event) => event.detail === 0 && stop()); // by keyboard or a screen reader
  window.addEventListener("keydown", (event) => event.key === "Escape" && !event.repeat && stop(closes()), true);
  window.addEventListener("helicoide-window", introduce);
  window.addEventListener("pointerdown", (event) => press(event.pointerId), true);
  window.addEventListener("keydown", (event) => event.isTrusted && press(event.code), true);
  window.addEventListener("keyup", releaseKey, true);
  window.addEventListener("pointermove", (event) => event.buttons === 0 && release(event.pointerId), true);
  window.addEventListener("blur", releaseAll); // the page gets no event for a key that is released elsewhere
  for (const end of ["pointerup", "pointercancel"]) {
    window.addEventListener(end, (event) => release(event.pointerId), true);
    window.addEventListener(end, () => send({ released: true }), true); // ends the drag even if viser's message is lost
  }

  document.body.append(line, button);
  draw();
  connect();
  setInterval(beat, BEAT_MS);
  setInterval(stand, 50);
  setInterval(look, 100);
})();
