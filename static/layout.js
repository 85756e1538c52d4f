// Layout that style sheets alone cannot do. It is computed again whenever viser's page changes.
"use strict";

(() => {
  const SOON_MS = 150; // texts about a moving arm change several times a second
  const tidies = [];
  let planned = null;

  function tidy() {
    planned = null;
    for (const one of tidies) one();
  }

  function soon() {
    planned ??= setTimeout(tidy, SOON_MS);
  }

  // Calls a function now and whenever the page has changed.
  window.helicoideOnChange = (one) => {
    tidies.push(one);
    soon();
  };

  // Stop and the status line are placed beside a docked panel, and on a phone above the sheet.
  function place() {
    const canvas = document.querySelector("canvas:not(.uplot *)")?.getBoundingClientRect();
    if (!canvas) return;
    const sheet = document.querySelector('.mantine-Paper-root[style*="position: fixed"]')?.getBoundingClientRect();
    const style = document.documentElement.style;
    style.setProperty("--canvas-left", `${Math.max(canvas.left, 0)}px`);
    style.setProperty("--sheet", sheet ? `${innerHeight - sheet.top}px` : "0px");
  }

  // A formula that is wider than its panel is drawn smaller, but not below 0.7em.
  function fit() {
    for (const box of document.querySelectorAll(".helicoide-formula")) {
      const wide = `${box.clientWidth}`;
      if (box.clientWidth === 0 || box.dataset.fits === wide) continue;
      box.style.fontSize = "";
      const share = box.clientWidth / box.scrollWidth;
      if (share < 1) box.style.fontSize = `${Math.max(share * 0.98, 0.7)}em`;
      box.dataset.fits = wide;
    }
  }

  // A choice that is longer than its field gets the whole width of the panel.
  function stack() {
    for (const field of document.querySelectorAll('input[aria-haspopup="listbox"]')) {
      const row = field.closest(".mantine-Flex-root");
      const shown = `${field.value} ${document.documentElement.dataset.projector ?? ""}`;
      if (!row || field.clientWidth === 0 || field.dataset.stacked === shown) continue;
      row.classList.remove("helicoide-long");
      row.classList.toggle("helicoide-long", field.scrollWidth > field.clientWidth + 1);
      field.dataset.stacked = shown;
    }
  }

  // A logarithmic slider shows its value in its label; viser's own numbers are exponents and are hidden.
  function markDecades() {
    for (const label of document.querySelectorAll("label")) {
      if (label.textContent.endsWith("\u2063")) label.closest(".mantine-Flex-root")?.classList.add("helicoide-decades");
    }
  }

  for (const one of [place, fit, stack, markDecades]) window.helicoideOnChange(one);
  const all = { subtree: true, childList: true, attributes: true, attributeFilter: ["style", "class", "hidden"] };
  new MutationObserver(soon).observe(document.body, all);
  new MutationObserver(soon).observe(document.documentElement, { attributeFilter: ["data-projector", "lang"] });
  for (const event of ["resize", "load", "transitionend"]) window.addEventListener(event, soon, true);
})();
