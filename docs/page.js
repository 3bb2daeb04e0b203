// page.js: what a page does besides standing there: light and dark, contents, progress, search, previews.
// Without it every word, formula, figure and link of the page is there.  Loaded in the head, so that no colour flashes.
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
    if (button) { button.textContent = dark() ? "☾" : "☀"; button.setAttribute("aria-label", dark() ? "dark; switch to light" : "light; switch to dark"); }
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

  addEventListener("DOMContentLoaded", () => {
    tone();
    document.getElementById("book-tone").onclick = () => { memory.put("tone", dark() ? "light" : "dark"); tone(); };

    // 3. The contents on a small screen.
    const menu = document.getElementById("book-menu"), side = document.getElementById("book-side");
    const show = open => { root.classList.toggle("menu", open); menu.setAttribute("aria-expanded", open); };
    menu.onclick = () => show(!root.classList.contains("menu"));
    document.getElementById("book-text").addEventListener("click", () => show(false));
    side.addEventListener("click", event => { if (event.target.closest("a")) show(false); });
    const now = side.querySelector(".now");
    if (now && now.getBoundingClientRect().bottom > innerHeight) side.scrollTop = now.offsetTop - innerHeight / 3;

    // 4. Where the reader is: a thin line above, the section in the side bar, a mark at chapters read to their end.
    const page = location.pathname.split("/").pop(), read = new Set(JSON.parse(memory.get("read") ?? "[]"));
    for (const a of side.querySelectorAll("li > a")) if (read.has(a.getAttribute("href"))) a.parentNode.classList.add("read");
    const entries = [...side.querySelectorAll("li ol a")], heads = entries.map(a => document.getElementById(decodeURIComponent(a.hash.slice(1))));
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

    // 5. Previews.  What a link leads to lies in a <template> of this page: no request, so it works from disk.  The contracts of
    //    functions are many; they lie in a script that the first link to one loads.  A mouse rests on a link, a keyboard comes to
    //    it, a finger taps once to look and once more to go.
    const kept = new Map([...document.querySelectorAll("template[data-for]")].map(t => [t.dataset.for, t.innerHTML]));
    const source = /^source-[^#]*#/, known = link => { const to = link.getAttribute("href"); return kept.has(to) || source.test(here(to)); };
    const here = to => to.startsWith("#") && page.startsWith("source-") ? page + to : to;
    let box = null, shown = null, timer = 0;
    function hide() { clearTimeout(timer); box?.remove(); shown?.removeAttribute("aria-describedby"); box = shown = null; }
    async function inside(to) {
      if (!kept.has(to) && source.test(here(to))) for (const [name, words] of Object.entries(await script("contracts.js", "signoriniContracts"))) kept.set(name, words);
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
      box.style.left = Math.max(8, Math.min(at.left - 12, root.clientWidth - w - 12)) + scrollX + "px";
      box.style.top = (below ? at.bottom + 7 : at.top - h - 7) + scrollY + "px";
      box.addEventListener("mouseenter", () => clearTimeout(timer));
      box.addEventListener("mouseleave", later);
      link.setAttribute("aria-describedby", "book-peek");
    }
    const later = () => { clearTimeout(timer); timer = setTimeout(hide, 220); };
    const linkOf = event => event.target.closest?.("main a[href]");
    let finger = false;
    addEventListener("pointerdown", event => { finger = event.pointerType !== "mouse"; if (box && !box.contains(event.target) && linkOf(event) !== shown) hide(); });
    document.addEventListener("mouseover", event => {
      const link = linkOf(event);
      if (!link || finger || !known(link)) return;
      clearTimeout(timer);
      timer = setTimeout(() => peek(link), 160);
    });
    document.addEventListener("mouseout", event => { if (linkOf(event)) later(); });
    document.addEventListener("focusin", event => { const link = linkOf(event); if (link?.matches(":focus-visible") && known(link)) peek(link); });
    document.addEventListener("focusout", event => { if (linkOf(event)) later(); });
    document.addEventListener("click", event => {
      const link = linkOf(event);
      if (link && finger && kept.has(link.getAttribute("href")) && shown !== link) { event.preventDefault(); peek(link); }
    });
    addEventListener("keydown", event => { if (event.key === "Escape") { show(false); hide(); } });

    // 6. Search: every section of every page that has all words, best first.  The list is loaded when the box is entered.
    const field = document.getElementById("book-find"), hits = document.getElementById("book-hits"), count = document.getElementById("book-count");
    let list = null;
    const load = () => list ??= script("seek.js", "signoriniSeek").then(prepare);
    const fold = words => words.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
    function prepare([pages, rows, functions]) {
      const all = rows.map(([at, anchor, heading, words]) => ({ page: pages[at][0], title: pages[at][1], anchor, heading, words, head: fold(heading), name: fold(pages[at][1]), text: fold(words) }));
      const titles = new Map(pages);
      for (const [name, declared] of Object.entries(functions)) for (const f of declared)
        all.push({ page: name, title: titles.get(name) ?? name, anchor: f, heading: f, words: "", head: fold(f), name: "", text: fold(f.replaceAll("_", " ")) });
      return all;
    }
    const wordAt = (text, word, from = 0) => {  // where the word begins a word
      for (let i = text.indexOf(word, from); i >= 0; i = text.indexOf(word, i + 1)) if (!i || !/[\p{L}\p{N}]/u.test(text[i - 1])) return i;
      return -1;
    };
    function rank(row, words, phrase) {
      let sum = 0;
      for (const word of words) {
        const inName = wordAt(row.name, word) >= 0, inHead = wordAt(row.head, word) >= 0;
        let n = 0;
        for (let i = wordAt(row.text, word); i >= 0 && n < 5; i = wordAt(row.text, word, i + 1)) ++n;
        if (!inName && !inHead && !n) return 0;
        sum += 8 * inHead + 5 * inName + n;
      }
      if (row.head === phrase || row.name === phrase) sum += 30;
      if (words.length > 1) sum += 12 * row.text.includes(phrase) + 15 * row.head.includes(phrase);
      return sum * (/^chapter/.test(row.page) ? 2 : /^(glossary|notation|use|scenes|evening)/.test(row.page) ? 1 : 0.5);
    }
    function excerpt(row, words) {
      const line = document.createElement("span"), first = Math.max(0, Math.min(...words.map(w => wordAt(row.text, w)).filter(i => i >= 0)) - 50);
      if (row.text.length !== row.words.length || !Number.isFinite(first)) { line.textContent = row.words.slice(0, 140); return line; }
      const begin = first ? row.words.indexOf(" ", first) + 1 : 0, text = row.words.slice(begin, begin + 170), low = fold(text);
      for (let at = 0; at < text.length;) {
        const next = words.map(w => [wordAt(low, w, at), w.length]).filter(n => n[0] >= 0).sort((a, b) => a[0] - b[0])[0];
        line.append(text.slice(at, next ? next[0] : text.length));
        if (!next) break;
        const mark = document.createElement("mark");
        mark.textContent = text.slice(next[0], at = next[0] + next[1]);
        line.append(mark);
      }
      return line;
    }
    async function seek() {
      const phrase = fold(field.value).trim(), words = phrase.split(/\s+/).filter(Boolean);
      root.classList.toggle("seeking", phrase.length > 1);
      if (phrase.length < 2) { count.textContent = ""; return hits.replaceChildren(); }
      const rows = await load();
      if (fold(field.value).trim() !== phrase) return;
      const found = rows.map(row => [rank(row, words, phrase), row]).filter(r => r[0] > 0).sort((a, b) => b[0] - a[0]).slice(0, 30);
      hits.replaceChildren(...found.map(([, row]) => {
        const item = document.createElement("li"), link = document.createElement("a"), head = document.createElement("b");
        link.href = row.page + ".html" + (row.anchor ? "#" + row.anchor : "");
        link.className = "hit";
        head.textContent = row.title + (row.heading ? " · " + row.heading : "");
        link.append(head, excerpt(row, words));
        item.append(link);
        return item;
      }));
      count.textContent = found.length ? `${found.length < 30 ? found.length : "the first 30"} place${found.length === 1 ? "" : "s"}` : "Nothing has all of these words.";
    }
    field.addEventListener("focus", load);
    field.addEventListener("input", seek);
    field.addEventListener("keydown", event => {
      if (event.key === "Enter") hits.querySelector("a")?.click();
      if (event.key === "ArrowDown") { hits.querySelector("a")?.focus(); event.preventDefault(); }
      if (event.key === "Escape") { field.value = ""; seek(); }
    });
    hits.addEventListener("keydown", event => {
      if (!/^Arrow(Up|Down)$/.test(event.key)) return;
      const next = event.target.closest("li")?.[event.key === "ArrowDown" ? "nextElementSibling" : "previousElementSibling"];
      (next?.querySelector("a") ?? field).focus();
      event.preventDefault();
    });
    addEventListener("keydown", event => {
      if (event.key !== "/" || /INPUT|SELECT|TEXTAREA/.test(document.activeElement?.tagName)) return;
      show(true);
      field.focus();
      event.preventDefault();
    });

    // 7. The engine starts two screens before a figure that needs it; live.js mounts the figure 300 px before it is seen.
    //    Both watch the window: here nothing else scrolls.
    if (computes && window.signoriniLive) {
      const soon = new IntersectionObserver(seen => {
        if (!seen.some(entry => entry.isIntersecting)) return;
        soon.disconnect();
        window.signoriniLive().catch(() => root.classList.remove("computes"));
      }, { rootMargin: "200% 0px" });
      document.querySelectorAll(".live").forEach(figure => soon.observe(figure));
    }
  });

  // 8. On paper everything is open.
  addEventListener("beforeprint", () => document.querySelectorAll("main details").forEach(fold => { fold.open = true; }));
})();
