// Buttons that copy the text they carry. Without a secure context (a classroom's plain http), and in the cell of a
// notebook, whose page may forbid it, the clipboard is reached by a hidden text field.
"use strict";

(() => {
  const SHOWN_MS = 1500;

  async function copy(text) {
    try {
      return await navigator.clipboard.writeText(text);
    } catch {
      // go on with the text field
    }
    const field = document.createElement("textarea");
    field.value = text;
    field.style.position = "fixed";
    field.style.opacity = "0";
    document.body.append(field);
    field.select();
    document.execCommand("copy");
    field.remove();
  }

  document.addEventListener("click", async (event) => {
    const button = event.target.closest?.(".helicoide-copy");
    if (!button) return;
    const label = button.textContent;
    await copy(button.dataset.text);
    if (label === button.dataset.done) return;
    button.textContent = button.dataset.done;
    setTimeout(() => (button.textContent = label), SHOWN_MS);
  });
})();
