// slides.js: one slide at a time, as large as the window.  Without it all slides stand below each other.
(function () {
  "use strict";
  const root = document.documentElement;
  let tone = null;
  try { tone = localStorage.getItem("book-tone"); } catch { /* a private window has none */ }
  root.classList.add("script", tone ?? (matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light"));
  root.classList.toggle("computes", "engine" in root.dataset && "WebAssembly" in window && "Worker" in window && "DecompressionStream" in window);
  addEventListener("DOMContentLoaded", () => {
    const slides = [...document.querySelectorAll(".slide")], at = document.getElementById("deck-at");
    let now = 0;
    function show(k, keep) {
      now = Math.max(0, Math.min(slides.length - 1, k));
      slides.forEach((slide, i) => slide.classList.toggle("now", i === now));
      at.textContent = `${now + 1} of ${slides.length}`;
      if (!keep) history.replaceState(null, "", "#" + slides[now].id);
    }
    const fromAddress = () => show(Math.max(0, slides.findIndex(slide => "#" + slide.id === location.hash)), true);
    const fit = () => root.style.setProperty("--scale", Math.min(innerWidth / 1280, (innerHeight - 40) / 720));
    const steps = { ArrowRight: 1, ArrowDown: 1, PageDown: 1, " ": 1, ArrowLeft: -1, ArrowUp: -1, PageUp: -1, Home: -1e6, End: 1e6 };
    addEventListener("keydown", event => {
      if (event.ctrlKey || event.altKey || event.metaKey || event.target.closest("input, select, textarea, form button")) return;
      if (event.key === " " && event.target.closest("button, a, summary")) return;
      if (event.key === "f") document.fullscreenElement ? document.exitFullscreen() : root.requestFullscreen?.();
      if (!(event.key in steps)) return;
      show(now + (event.key === " " && event.shiftKey ? -1 : steps[event.key]));
      event.preventDefault();
    });
    document.getElementById("deck-back").onclick = () => show(now - 1);
    document.getElementById("deck-on").onclick = () => show(now + 1);
    addEventListener("resize", fit);
    addEventListener("hashchange", fromAddress);
    document.addEventListener("answered", ({ target: live }) => {    // a live figure as large as its slide has room for
      const room = live.parentElement.clientHeight;
      live.style.zoom = 1;
      live.style.zoom = Math.min(1, room / live.offsetHeight);
    }, true);
    fit();
    fromAddress();
  });
})();
