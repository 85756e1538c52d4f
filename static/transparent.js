// The arm is transparent in this window if the page has the attribute `data-transparent`. The arm is one object for all
// windows, and viser has no opacity for its kind of mesh, so the materials are changed here, after viser made them.
"use strict";

(() => {
  const OPACITY = 0.3;
  const LOOK_MS = 300; // a new arm has new materials
  const solid = new WeakMap(); // material: its looks as they were loaded

  function changed(material, transparent) {
    const before = solid.get(material);
    if (Boolean(before) === transparent) return false;
    if (transparent) {
      solid.set(material, { transparent: material.transparent, opacity: material.opacity, depthWrite: material.depthWrite });
      Object.assign(material, { transparent: true, opacity: OPACITY * material.opacity, depthWrite: false });
    } else {
      Object.assign(material, before);
      solid.delete(material);
    }
    material.needsUpdate = true;
    return true;
  }

  function paint() {
    const viser = window.__viserMutable;
    const transparent = document.documentElement.hasAttribute("data-transparent");
    let any = false;
    for (const [name, node] of Object.entries(viser?.nodeRefFromName ?? {})) {
      if (!node || !/^\/arm\/[^/]+\/mesh$/.test(name)) continue;
      node.traverse((part) => {
        for (const material of [part.material ?? []].flat()) any = changed(material, transparent) || any;
      });
    }
    if (any) viser.requestRender?.();
  }

  setInterval(paint, LOOK_MS);
})();
