// The page by keyboard and by ear: names and tab stops for what viser leaves without them, and arrow keys in the steps
// of a teach pendant: 1 (degree, millimetre), a tenth of it with Alt, ten of it with Shift.
"use strict";

(() => {
  const FOLDER = '.mantine-Paper-root[style*="cursor: pointer"]';
  const FOLDED = ".tabler-icon-chevron-down";
  const NATIVE = 10; // steps of viser, of 0.1 each, make one
  const SHORT_RANGE = 20; // of a slider whose own steps are as large as they need be

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

  // viser's sliders take each key as one of their own small steps, once a turn of the page's loop.
  function stepSlider(event) {
    const thumb = event.target.closest?.("[role=slider]");
    if (!thumb || !event.isTrusted || !event.key.startsWith("Arrow") || event.altKey) return;
    const [least, most] = ["min", "max"].map((name) => Number(thumb.getAttribute(`aria-value${name}`)));
    if (most - least < SHORT_RANGE) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    const key = { key: event.key, bubbles: true, cancelable: true };
    for (let k = 0; k < NATIVE * (event.shiftKey ? 10 : 1); k += 1) {
      setTimeout(() => thumb.dispatchEvent(new KeyboardEvent("keydown", key)));
    }
  }

  function openFolder(event) {
    const heading = event.target.closest?.(FOLDER);
    if (!heading || (event.key !== "Enter" && event.key !== " ")) return;
    event.preventDefault();
    heading.click();
  }

  window.addEventListener("keydown", stepSlider, true);
  window.addEventListener("keydown", openFolder, true);
  setInterval(nameControls, 300);
})();
