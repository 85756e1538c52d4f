// The link to a view is the fragment of the page's address. Its content belongs to the server (view/share.py).
"use strict";

(() => {
  // Puts a link into the address and on the clipboard, which browsers allow only on a safe origin; "" removes it.
  window.helicoideShare = (fragment) => {
    history.replaceState(null, "", location.pathname + location.search + (fragment ? `#${fragment}` : ""));
    if (fragment) navigator.clipboard?.writeText(location.href).catch(() => {}); // the address shows it in any case
  };

  // Another link in the address of an open page is opened like the first one. `replaceState` makes no such event.
  window.addEventListener("hashchange", () => location.reload());
})();
