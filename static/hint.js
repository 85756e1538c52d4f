// The first steps, shown over the canvas once the page may drive, until the user closes them. The browser stores that
// they were closed.
"use strict";

(() => {
  const words = JSON.parse(document.currentScript.dataset.words);
  const CLOSED = "helicoide-hint-closed";

  function isClosed() {
    try {
      return localStorage.getItem(CLOSED) !== null;
    } catch {
      return false; // a browser may refuse access to its storage
    }
  }

  if (isClosed()) return;

  const hint = document.createElement("section");
  const steps = document.createElement("ol");
  const lesson = document.createElement("button");
  const close = document.createElement("button");
  hint.id = "helicoide-hint";
  lesson.type = close.type = "button";
  hint.append(steps, lesson, close);

  function draw() {
    const said = words[document.documentElement.lang.startsWith("pt") ? "pt_BR" : "en"];
    hint.setAttribute("aria-label", said.title);
    lesson.textContent = said.lesson;
    close.textContent = said.close;
    steps.replaceChildren(...said.steps.map((step) => Object.assign(document.createElement("li"), { textContent: step })));
  }

  function remove() {
    hint.remove();
    try {
      localStorage.setItem(CLOSED, "yes");
    } catch {
      // then they are shown again next time
    }
  }

  close.addEventListener("click", remove);
  lesson.addEventListener("click", () => {
    window.helicoideShowTab?.(0);
    window.__viserMutable.sendMessage({ type: "HelicoideFirstLesson" });
    remove();
  });
  new MutationObserver(draw).observe(document.documentElement, { attributeFilter: ["lang"] });
  draw();
  window.addEventListener("helicoide-drives", () => document.body.append(hint), { once: true });
})();
