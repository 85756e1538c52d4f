// What on the page cannot be read, pressed, named or reached by keyboard: each finding is a line.
(touch) => {
  const findings = [];
  const LEAST_CONTRAST = 4.5;
  const LEAST_SIZE = 11;
  const LEAST_BODY = 14;
  const FINGERTIP = 24;

  const channels = (colour) => {
    const [r, g, b, a = 1] = colour.match(/[\d.]+/g).map(Number);
    return colour.startsWith("color(srgb") ? [255 * r, 255 * g, 255 * b, a] : [r, g, b, a];
  };
  const over = (front, back) => [...[0, 1, 2].map((i) => front[i] * front[3] + back[i] * (1 - front[3])), 1];
  const luminance = (colour) => {
    const [r, g, b] = colour.slice(0, 3).map((v) => (v / 255 <= 0.04045 ? v / 3294.6 : ((v / 255 + 0.055) / 1.055) ** 2.4));
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const lineage = (element) => {
    const found = [];
    for (let one = element; one; one = one.parentElement) found.push(getComputedStyle(one));
    return found;
  };
  const told = (kind, size, words) => findings.push(`${kind} ${size.toFixed(2)}: ${words.trim().slice(0, 40)}`);

  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (texts.nextNode()) {
    const text = texts.currentNode, element = text.parentElement;
    if (!text.textContent.trim() || element.closest("script, style, noscript")) continue;
    const range = document.createRange();
    range.selectNodeContents(text);
    const { width, height } = range.getBoundingClientRect();
    if (width < 1 || height < 1 || !element.checkVisibility({ opacityProperty: true, visibilityProperty: true })) continue;
    const styles = lineage(element);
    const ground = styles.map((style) => channels(style.backgroundColor)).reduceRight((back, front) => over(front, back), [255, 255, 255, 1]);
    const drawn = element.closest("svg") ? styles[0].fill : styles[0].color;
    const [r, g, b, a] = channels(drawn === "none" ? styles[0].color : drawn);
    const ink = over([r, g, b, a * styles.reduce((share, style) => share * Number(style.opacity), 1)], ground);
    const [light, dark] = [luminance(ink), luminance(ground)].sort((x, y) => y - x);
    const contrast = (light + 0.05) / (dark + 0.05);
    if (contrast < LEAST_CONTRAST) told("contrast", contrast, text.textContent);
    const scale = element.closest("svg")?.getScreenCTM?.()?.a ?? 1;
    const size = parseFloat(styles[0].fontSize) * scale;
    if (size < LEAST_SIZE - 0.01) told("size", size, text.textContent);
    if (element.closest("label, button, input, p, td, li, h3") && !element.closest("math, figure, svg, .helicoide-grid, .helicoide-matrix, .helicoide-stage, sub, kbd") && size < LEAST_BODY - 0.45)
      told("body", size, text.textContent);
  }
  for (const box of document.querySelectorAll(".mantine-Paper-root *")) {
    if (box.clientWidth === 0 || box.closest("svg, math, .uplot, input")) continue;
    const style = getComputedStyle(box);
    const [wide, tall] = [box.scrollWidth - box.clientWidth, box.scrollHeight - box.clientHeight];
    if (wide > 1 && /auto|scroll/.test(style.overflowX)) told("scrolls sideways", wide, box.textContent);
    else if (wide > 1 && style.overflowX !== "visible" && [...box.childNodes].some((one) => one.nodeType === Node.TEXT_NODE && one.textContent.trim()) && box.checkVisibility({ opacityProperty: true, visibilityProperty: true })) told("cut", wide, box.textContent);
    if (box.matches(".helicoide-formula, .helicoide-reading") && tall > 0 && /auto|scroll/.test(style.overflowY)) told("tall", tall, box.textContent);
  }
  for (const input of document.querySelectorAll("input")) {
    const isValue = input.inputMode === "decimal" || input.ariaHasPopup === "listbox";
    if (input.clientWidth > 0 && isValue && input.scrollWidth > input.clientWidth + 1) told("cut", input.scrollWidth - input.clientWidth, input.value);
  }
  for (const canvas of document.querySelectorAll(".uplot canvas")) {
    const [inner, outer] = [canvas, canvas.closest(".uplot")].map((one) => one.getBoundingClientRect());
    const out = Math.max(outer.left - inner.left, outer.top - inner.top, inner.right - outer.right, inner.bottom - outer.bottom);
    if (inner.width > 0 && out > 1) told("chart outside its box", out, canvas.closest(".uplot").textContent);
  }
  if (document.documentElement.scrollWidth > innerWidth) told("page", document.documentElement.scrollWidth, "wider than the window");
  if (touch) {
    for (const control of document.querySelectorAll("button:not([aria-hidden=true]), [role=tab], input:not([type=checkbox]), a")) {
      const { width, height } = control.getBoundingClientRect();
      if (width > 0 && height > 0 && Math.min(width, height) < FINGERTIP) told("touch", Math.min(width, height), control.textContent || control.value || control.tagName);
    }
    for (const thumb of document.querySelectorAll("[role=slider]")) {
      const { width, height } = thumb.getBoundingClientRect();
      const around = parseFloat(getComputedStyle(thumb, "::after").top) || 0;
      if (width > 0 && height - 2 * around < FINGERTIP) told("thumb", height - 2 * around, "slider");
    }
  }
  const controls = "input:not([type=hidden]), [role=slider], [role=tab], [role=button], button, canvas[role]";
  for (const one of document.querySelectorAll(controls)) {
    if (!one.checkVisibility() || one.closest("[aria-hidden=true]") || one.type === "file") continue;
    if (!(one.ariaLabel || one.textContent.trim() || one.labels?.length || one.title || one.placeholder)) told("nameless", 0, one.outerHTML);
    const among = one.closest("[role=tablist], [role=radiogroup], .mantine-NumberInput-root, .mantine-InputWrapper-root");
    if (one.tabIndex < 0 && !one.disabled && !among) told("no tab stop", 0, one.outerHTML);
  }
  for (const heading of document.querySelectorAll('.mantine-Paper-root[style*="cursor: pointer"]')) {
    const opens = heading.tabIndex >= 0 && heading.role === "button" && heading.ariaExpanded;
    if (heading.checkVisibility() && !opens) told("no tab stop", 0, heading.textContent);
  }
  return findings;
}
