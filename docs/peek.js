// peek.js: previews.  What a link leads to lies in a <template> of this page: no request, so it works from disk.  The contracts of
// functions are many; they lie in a script that the first link to one loads.  A mouse rests on a link, a keyboard comes to it, a
// finger taps once to look and once more to go.
(function () {
  "use strict";
  const kept = new Map([...document.querySelectorAll("template[data-for]")].map(t => [t.dataset.for, t.innerHTML]));
  const page = location.pathname.split("/").pop(), source = /^source-[^#]*#/;
  const here = to => to.startsWith("#") && page.startsWith("source-") ? page + to : to;
  const known = link => kept.has(link.getAttribute("href")) || source.test(here(link.getAttribute("href")));
  let box = null, shown = null, timer = 0;
  function hide() { clearTimeout(timer); box?.remove(); shown?.removeAttribute("aria-describedby"); box = shown = null; }
  async function inside(to) {
    if (!kept.has(to) && source.test(here(to))) {
      const contracts = await window.signoriniPage.script("contracts.js", "signoriniContracts");
      for (const [name, words] of Object.entries(contracts)) kept.set(name, words);
    }
    return kept.get(to) ?? kept.get(here(to));
  }
  async function peek(link) {
    if (link === shown) return;
    hide();
    shown = link;
    const words = await inside(link.getAttribute("href"));
    if (!words || shown !== link) return;
    box = document.createElement("div");
    box.id = "book-peek";
    box.setAttribute("role", "tooltip");
    box.innerHTML = words;
    document.body.append(box);
    const at = [...link.getClientRects()].pop(), h = box.offsetHeight, w = box.offsetWidth;
    const below = at.bottom + h + 10 < innerHeight || at.top < h + 10;
    box.style.left = Math.max(8, Math.min(at.left - 12, document.documentElement.clientWidth - w - 12)) + scrollX + "px";
    box.style.top = (below ? at.bottom + 7 : at.top - h - 7) + scrollY + "px";
    box.addEventListener("mouseenter", () => clearTimeout(timer));
    box.addEventListener("mouseleave", later);
    link.setAttribute("aria-describedby", "book-peek");
  }
  const later = () => { clearTimeout(timer); timer = setTimeout(hide, 220); };
  const linkOf = event => event.target.closest?.("main a[href]");
  let finger = false;
  addEventListener("pointerdown", event => {
    finger = event.pointerType !== "mouse";
    if (box && !box.contains(event.target) && linkOf(event) !== shown) hide();
  });
  document.addEventListener("mouseover", event => {
    const link = linkOf(event);
    if (!link || finger || !known(link)) return;
    clearTimeout(timer);
    timer = setTimeout(() => peek(link), 160);
  });
  document.addEventListener("mouseout", event => { if (linkOf(event)) later(); });
  document.addEventListener("focusin", event => {
    const link = linkOf(event);
    if (link?.matches(":focus-visible") && known(link)) peek(link);
  });
  document.addEventListener("focusout", event => { if (linkOf(event)) later(); });
  document.addEventListener("click", event => {
    const link = linkOf(event);
    if (!link || !finger || !known(link) || shown === link) return;
    event.preventDefault();
    peek(link).then(() => { if (!box && shown === link) location.href = link.href; });    // nothing to show
  });
  addEventListener("keydown", event => { if (event.key === "Escape") hide(); });
})();
