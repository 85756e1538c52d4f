// Buttons within the text of a lesson: what they do is written in their data-go, and the server does it. A text is
// replaced when it changes, so the new button of the same name gets the focus, for those who use the keyboard.
"use strict";

(() => {
  function find(target) {
    return document.querySelector(`.helicoide-go[data-go="${CSS.escape(target)}"]`);
  }

  function refocus(target, tries = 20) {
    if (tries === 0 || (document.activeElement && document.activeElement !== document.body)) return;
    find(target)?.focus({ preventScroll: true });
    setTimeout(() => refocus(target, tries - 1), 50);
  }

  document.addEventListener("click", (event) => {
    const button = event.target.closest?.(".helicoide-go");
    if (!button) return;
    const target = button.dataset.go;
    window.__viserMutable?.sendMessage({ type: "HelicoideFollow", target });
    const watched = new MutationObserver(() => {
      if (button.isConnected) return;
      watched.disconnect();
      refocus(target);
    });
    watched.observe(document.body, { childList: true, subtree: true });
    setTimeout(() => watched.disconnect(), 2000);
  });
})();
