// A number of the block diagram stands for the button with the words of its data-helicoide-press.
"use strict";

(() => {
  let pressed = null;

  function words(event) {
    return document.elementFromPoint(event.clientX, event.clientY)?.closest("[data-helicoide-press]")?.dataset.helicoidePress;
  }

  // The drawing is replaced while the arm moves, so the browser may send no click.
  window.addEventListener("pointerdown", (event) => (pressed = words(event)));
  window.addEventListener("pointerup", (event) => {
    if (!pressed || words(event) !== pressed) return;
    const buttons = [...document.querySelectorAll(".mantine-Button-root")];
    buttons.find((button) => button.textContent.trim() === pressed)?.click();
  });
})();
