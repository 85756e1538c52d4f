// Keyboard and screen reader: names and tab stops that viser does not set, and arrow keys with the steps of a teach
// pendant: 1 (degree, millimetre), 0.1 with Alt, 10 with Shift. Enter sends a text field.
"use strict";

(() => {
  const words = JSON.parse(document.currentScript.dataset.words);
  const TARGET = "/target";
  const MILLIMETRE = 0.001;
  const ALONG = {
    ArrowUp: [0, 1],
    ArrowDown: [0, -1],
    ArrowLeft: [1, 1],
    ArrowRight: [1, -1],
    PageUp: [2, 1],
    PageDown: [2, -1],
  };
  const ICONS = { "list-search": "commands", adjustments: "settings" }; // buttons of viser without text
  const FOLDER = '.mantine-Paper-root[style*="cursor: pointer"]';
  const TEXT_FIELDS = "textarea, [contenteditable], input:not([type=checkbox], [readonly])";
  const FOLDED = ".tabler-icon-chevron-down";
  const SHORT_RANGE = 20; // sliders with a smaller range keep viser's own steps
  const TYPED_IS_SENT = 150; // ms
  const OWN_STEPS = 10; // steps of viser, 0.1 each, in one step of 1

  function set(element, name, value) {
    if (element.getAttribute(name) !== value) element.setAttribute(name, value);
  }

  function nameControls() {
    for (const label of document.querySelectorAll("label[for]")) {
      const row = label.closest(".mantine-Flex-root");
      const words = label.textContent.replace("\u2063", "").trim();
      if (!row || !words) continue;
      const boxes = row.querySelectorAll("input:not([type=checkbox]):not([type=hidden])");
      boxes.forEach((box, k) => set(box, "aria-label", boxes.length === 3 ? `${words}: ${"xyz"[k]}` : words));
      for (const thumb of row.querySelectorAll("[role=slider]")) set(thumb, "aria-label", words);
      for (const tick of row.querySelectorAll("input[type=checkbox]")) set(tick, "aria-label", words);
    }
    for (const heading of document.querySelectorAll(FOLDER)) {
      set(heading, "role", "button");
      set(heading, "tabindex", "0");
      set(heading, "aria-expanded", heading.querySelector(FOLDED) ? "false" : "true");
    }
  }

  function factor(event) {
    return event.altKey ? 0.1 : event.shiftKey ? 10 : 1;
  }

  // viser's sliders take one of their own small steps for a key event, and one event per turn of the event loop.
  function stepSlider(event) {
    const thumb = event.target.closest?.("[role=slider]");
    if (!thumb || !event.isTrusted || !event.key.startsWith("Arrow")) return;
    const [least, most] = ["min", "max"].map((name) => Number(thumb.getAttribute(`aria-value${name}`)));
    if (most - least < SHORT_RANGE) return;
    event.preventDefault();
    event.stopPropagation();
    const key = { key: event.key, bubbles: true, cancelable: true };
    for (let k = 0; k < factor(event) * OWN_STEPS; k += 1) {
      setTimeout(() => thumb.dispatchEvent(new KeyboardEvent("keydown", key)));
    }
  }

  // Keys drag the target along the axes of the base, from the press of a key to its release.
  let drag = null;

  function tellTarget(kind, fields = {}) {
    const owner = window.helicoideClient;
    window.__viserMutable.sendMessage({ type: `TransformControls${kind}Message`, name: TARGET, owner, ...fields });
  }

  function stepTarget(event) {
    const along = ALONG[event.key];
    if (!along || event.target !== window.__viserMutable?.canvas || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation(); // otherwise viser moves the camera
    if (!event.repeat) takeTarget(event.code);
    if (drag?.code !== event.code) return;
    drag.position[along[0]] += along[1] * factor(event) * MILLIMETRE;
    const { wxyz, position } = drag;
    Object.assign(window.__viserMutable.nodePoseData[TARGET], { position: [...position], poseUpdateState: "needsUpdate" });
    window.__viserMutable.requestRender?.();
    tellTarget("Update", { wxyz, position: [...position] });
  }

  function takeTarget(code) {
    endDrag();
    const node = window.__viserMutable.nodeRefFromName[TARGET];
    const pose = window.__viserMutable.nodePoseData[TARGET];
    if (!node || !pose) return;
    drag = { code, wxyz: [...pose.wxyz], position: [...pose.position] };
    tellTarget("DragStart");
  }

  function endDrag() {
    if (drag) tellTarget("DragEnd");
    drag = null;
  }

  function nameScene() {
    const said = words[document.documentElement.lang.startsWith("pt") ? "pt_BR" : "en"];
    for (const [icon, name] of Object.entries(ICONS)) {
      const button = document.querySelector(`button .tabler-icon-${icon}`)?.closest("button");
      if (button) set(button, "aria-label", said[name]);
    }
    const canvas = window.__viserMutable?.canvas;
    if (!canvas) return;
    set(canvas, "tabindex", "0");
    set(canvas, "role", "application");
    set(canvas, "aria-label", said.scene);
  }

  // Ctrl+Z undoes, Ctrl+Shift+Z and Ctrl+Y redo; in a text field they are about its text.
  function undo(event) {
    const key = event.key.toLowerCase();
    if (!(event.ctrlKey || event.metaKey) || event.altKey || (key !== "z" && key !== "y")) return;
    if (event.target.closest?.(TEXT_FIELDS)) return;
    event.preventDefault();
    const type = key === "z" && !event.shiftKey ? "HelicoideUndo" : "HelicoideRedo";
    window.__viserMutable?.sendMessage({ type });
  }

  function openFolder(event) {
    const heading = event.target.closest?.(FOLDER);
    if (!heading || (event.key !== "Enter" && event.key !== " ")) return;
    event.preventDefault();
    heading.click();
  }

  // Enter in a text field presses the button below it, as in a form; later, since viser sends what is typed with a delay.
  function pressButtonBelow(event) {
    if (event.key !== "Enter" || event.isComposing || !event.target.matches?.(".mantine-TextInput-input")) return;
    const row = event.target.closest(".mantine-Flex-root")?.parentElement;
    const button = row?.nextElementSibling?.querySelector("button");
    if (button) setTimeout(() => button.click(), TYPED_IS_SENT);
  }

  window.addEventListener("keydown", stepSlider, true);
  window.addEventListener("keydown", stepTarget, true);
  window.addEventListener("keyup", (event) => (drag?.code === event.code || event.key === "Meta") && endDrag(), true);
  window.addEventListener("blur", endDrag);
  window.addEventListener("helicoide-deaf", () => (drag = null)); // the key has no effect until it is pressed again
  window.addEventListener("keydown", undo, true);
  window.addEventListener("keydown", openFolder, true);
  window.addEventListener("keydown", pressButtonBelow);
  window.helicoideOnChange(nameControls);
  window.helicoideOnChange(nameScene);
})();
