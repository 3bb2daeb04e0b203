// page.js: what a page does besides standing there: light and dark, contents, progress; peek.js has previews, find.js the search.
// Without them every word, formula, figure and link of the page is there.  Loaded in the head, so that no colour flashes.
(function () {
  "use strict";
  const root = document.documentElement;
  const memory = {  // a private window has none
    get(key) { try { return localStorage.getItem("book-" + key); } catch { return null; } },
    put(key, value) { try { localStorage.setItem("book-" + key, value); } catch { /* then not */ } }
  };

  // 1. Light and dark: the system's wish until the reader chooses.
  const system = matchMedia("(prefers-color-scheme: dark)");
  const dark = () => (memory.get("tone") ?? (system.matches ? "dark" : "light")) === "dark";
  function tone() {
    root.classList.toggle("dark", dark());
    root.classList.toggle("light", !dark());
    const button = document.getElementById("book-tone");
    if (!button) return;
    button.textContent = dark() ? "☾" : "☀";
    button.setAttribute("aria-label", dark() ? "dark; switch to light" : "light; switch to dark");
  }
  tone();
  system.addEventListener("change", tone);

  root.classList.add("script");

  // The faces lie in the style sheet; the page is shown when they are read, some milliseconds later, so that nothing moves.
  root.classList.add("loading");
  const ready = () => root.classList.remove("loading");
  Promise.all([...document.fonts].map(face => face.load())).then(ready, ready);
  setTimeout(ready, 500);

  // A script that calls NAME(...): from disk nothing else can be read.
  const scripts = {};
  const script = (file, name) => scripts[file] ??= new Promise((done, fail) => {
    window[name] = (...parts) => done(parts.length === 1 ? parts[0] : parts);
    const tag = document.createElement("script");
    tag.src = file;
    tag.onerror = fail;
    document.head.append(tag);
  });

  // 2. Figures that compute have their room from the first layout on, where they can compute at all.
  const computes = "engine" in root.dataset && "WebAssembly" in window && "Worker" in window && "DecompressionStream" in window;
  root.classList.toggle("computes", computes);

  // 3. The contents on a small screen.
  function show(open) {
    root.classList.toggle("menu", open);
    document.getElementById("book-menu").setAttribute("aria-expanded", open);
  }
  function contents(side, now) {
    const menu = document.getElementById("book-menu");
    menu.onclick = () => show(!root.classList.contains("menu"));
    document.getElementById("book-text").addEventListener("click", () => show(false));
    side.addEventListener("click", event => { if (event.target.closest("a")) show(false); });
    addEventListener("keydown", event => { if (event.key === "Escape") show(false); });
    if (now && now.getBoundingClientRect().bottom > innerHeight) side.scrollTop = now.offsetTop - innerHeight / 3;
  }

  function kept() {    // the chapters read so far, or none if what is stored is damaged
    try {
      const pages = JSON.parse(memory.get("read") ?? "[]");
      return Array.isArray(pages) ? pages : [];
    } catch {
      return [];
    }
  }

  // 4. Where the reader is: a thin line above, the section in the side bar, a mark at chapters read to their end.
  function progress(side, now) {
    const page = location.pathname.split("/").pop(), read = new Set(kept());
    for (const a of side.querySelectorAll("li > a")) if (read.has(a.getAttribute("href"))) a.parentNode.classList.add("read");
    const entries = [...side.querySelectorAll("li ol a")];
    const heads = entries.map(a => document.getElementById(decodeURIComponent(a.hash.slice(1))));
    const line = document.getElementById("book-progress"), end = document.getElementById("exercises") ?? document.querySelector(".turn");
    let waiting = false;
    const where = () => {
      waiting = false;
      const all = root.scrollHeight - innerHeight;
      line.style.transform = `scaleX(${all > 0 ? scrollY / all : 0})`;
      let k = -1;
      heads.forEach((h, i) => { if (h && h.getBoundingClientRect().top < innerHeight * 0.35) k = i; });
      entries.forEach((a, i) => a.classList.toggle("reading", i === k));
      if (/^chapter/.test(page) && end && end.getBoundingClientRect().top < innerHeight && scrollY > 0 && !read.has(page)) {
        read.add(page);
        memory.put("read", JSON.stringify([...read]));
        now?.classList.add("read");
      }
    };
    addEventListener("scroll", () => { if (!waiting) { waiting = true; requestAnimationFrame(where); } }, { passive: true });
    where();
  }

  // 5. The engine starts two screens before a figure that needs it; live.js mounts the figure 300 px before it is seen.
  //    Both watch the window: here nothing else scrolls.
  function engine() {
    if (!computes || !window.signoriniLive) return;
    const soon = new IntersectionObserver(seen => {
      if (!seen.some(entry => entry.isIntersecting)) return;
      soon.disconnect();
      window.signoriniLive().catch(() => root.classList.remove("computes"));
    }, { rootMargin: "200% 0px" });
    document.querySelectorAll(".live").forEach(figure => soon.observe(figure));
  }

  addEventListener("DOMContentLoaded", () => {
    const side = document.getElementById("book-side"), now = side.querySelector(".now");
    tone();
    document.getElementById("book-tone").onclick = () => { memory.put("tone", dark() ? "light" : "dark"); tone(); };
    contents(side, now);
    progress(side, now);
    engine();
  });
  window.signoriniPage = { script, show };

  // 6. On paper everything is open.
  addEventListener("beforeprint", () => document.querySelectorAll("main details").forEach(fold => { fold.open = true; }));
})();
