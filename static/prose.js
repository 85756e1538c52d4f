// Buttons within the text of a lesson: what they do is written in their data-go, and the server does it. A text is
// replaced when it changes, so the new button of the same name gets the focus, for those who use the keyboard. A new
// step begins at its top.
"use strict";

(() => {
  const TOP = ".helicoide-lesson h3";
  let pressed = null; // the data-go of the button that was pressed last, until its text is replaced
  let title = "";

  function refocus() {
    const button = document.querySelector(`.helicoide-go[data-go="${CSS.escape(pressed)}"]`);
    if (document.activeElement === document.body) button?.focus({ preventScroll: true });
  }

  function show() {
    document.querySelector(TOP)?.parentElement.scrollIntoView({ block: "start" });
  }

  function changed() {
    const top = document.querySelector(TOP);
    if (top && top.textContent !== title) setTimeout(show, 300); // viser opens a new panel only then
    title = top?.textContent ?? "";
    if (pressed) refocus();
  }

  document.addEventListener("click", (event) => {
    pressed = event.target.closest?.(".helicoide-go")?.dataset.go ?? null;
    if (pressed) window.__viserMutable?.sendMessage({ type: "HelicoideFollow", target: pressed });
  });
  new MutationObserver(changed).observe(document.body, { childList: true, subtree: true });
})();
