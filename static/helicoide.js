// Helicoide's own part of the page: the Stop button, the status line, and the channel behind both.
"use strict";

(() => {
  const words = JSON.parse(document.currentScript.dataset.words);
  const BEAT_MS = 1000;
  const SILENT_BEATS = 2;

  let language = navigator.language.startsWith("pt") ? "pt_BR" : "en";
  let notice = { status: "", tone: "ok" };
  let link = "opening"; // then "up" or "lost"
  let socket = null;
  let silence = 0; // beats since the server last said anything
  let retryMs = 100;
  let stopUnheard = false;

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
    if (place.textContent !== text) place.textContent = text; // the same words again would be read aloud again
  }

  function draw() {
    document.documentElement.lang = language.replace("_", "-");
    write(label, words[language].stop);
    write(line, link === "lost" ? words[language].lost : notice.status);
    line.dataset.tone = link === "lost" ? "lost" : notice.tone;
    button.dataset.link = link;
  }

  function send(message) {
    if (socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(message));
  }

  // A stop counts only when the server has said that it heard it; until then every new connection repeats it.
  function stop() {
    stopUnheard = true;
    send({ stop: true });
  }

  function sit() {
    if (window.helicoideSeat) send({ seat: window.helicoideSeat });
  }

  function connect() {
    silence = 0;
    socket = new WebSocket(`${location.protocol.replace("http", "ws")}//${location.host}/helicoide/control`);
    socket.onopen = () => {
      link = "up";
      retryMs = 100;
      notice = { status: "", tone: "ok" };
      if (stopUnheard) stop();
      sit();
      draw();
    };
    socket.onmessage = (event) => hear(JSON.parse(event.data));
    socket.onclose = lose;
  }

  function hear(message) {
    silence = 0;
    if (message.heard === "stop") stopUnheard = false;
    if (message.heard) return;
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

  // A cut cable or a stuck server closes nothing: silence is what tells.
  function beat() {
    if (socket.readyState > WebSocket.OPEN) return;
    if (silence >= SILENT_BEATS) return lose();
    silence += 1;
    send({ beat: true });
  }

  button.addEventListener("pointerdown", stop); // on press, not on release
  button.addEventListener("click", (event) => event.detail === 0 && stop()); // by keyboard or a screen reader
  window.addEventListener("keydown", (event) => event.key === "Escape" && !event.repeat && stop(), true);
  window.addEventListener("helicoide-seat", sit);
  for (const end of ["pointerup", "pointercancel"]) {
    window.addEventListener(end, () => send({ released: true }), true); // what was dragged is let go, come what may
  }

  document.body.append(line, button);
  draw();
  connect();
  setInterval(beat, BEAT_MS);
})();
