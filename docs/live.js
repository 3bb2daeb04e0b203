// live.js: figures that compute.  <div class="live" data-figure="NAME"> before a printed figure becomes a form and panels, which
// panels.js draws; the page keeps its room, shows the printed figure there until the first answer is painted, and has it folded
// away below.  Without WebAssembly, workers or engine.js the page stays as it is.
(function () {
  "use strict";
  const { el, draw, guess } = window.signoriniPanels;

  // 1. The engine: one worker for all figures of a page, started when the first of them comes near the screen.  A page that is
  //    opened from disk may not load a worker or a .wasm, but a script, and a worker made from its text.
  const inWorker = `let engine;
const call = (name, ...args) => engine.ccall(name, name === "live_answer" ? "string" : "number", args.map(a => typeof a), args);
onmessage = async ({ data }) => {
  if (data.wasm) {
    engine = await Signorini({ wasmBinary: data.wasm });
    return postMessage({ ready: true });
  }
  const begin = performance.now(), arrays = [];
  let text;
  try {
    text = call("live_answer", data.words);
    for (let k = 0, n; (n = call("live_size", k)) >= 0; ++k) {
      const at = call("live_data", k) / 8;
      arrays.push(engine.HEAPF64.slice(at, at + n));
    }
  } catch (e) {
    text = JSON.stringify({ error: "The engine stopped: " + e.message + ". Open the page anew." });
  }
  postMessage({ id: data.id, text, arrays, milliseconds: performance.now() - begin }, arrays.map(a => a.buffer));
};`;
  const unpack = text => {
    const bytes = Uint8Array.from(atob(text), c => c.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip")));
  };
  async function start() {
    await new Promise((done, fail) => {
      const script = el("script", { src: "engine.js" });
      script.onload = done;
      script.onerror = () => fail(new Error("no engine.js"));
      document.head.append(script);
    });
    const begin = performance.now(), packed = window.signoriniEngine;
    const [glue, wasm] = await Promise.all([unpack(packed.glue).text(), unpack(packed.wasm).arrayBuffer()]);
    const worker = new Worker(URL.createObjectURL(new Blob([glue, inWorker], { type: "text/javascript" })));
    const waiting = new Map();
    let id = 0;
    await new Promise((done, fail) => {
      worker.onerror = e => fail(new Error(e.message));
      worker.onmessage = ({ data }) => {
        if (data.ready) return done();
        waiting.get(data.id)(data);
        waiting.delete(data.id);
      };
      worker.postMessage({ wasm }, [wasm]);
    });
    const ask = async words => {
      const got = await new Promise(done => { waiting.set(++id, done); worker.postMessage({ id, words }); });
      const answer = JSON.parse(got.text);
      return { words, answer, arrays: got.arrays, milliseconds: got.milliseconds };
    };
    return { ask, started: performance.now() - begin };
  }
  let engine;
  const theEngine = () => engine ??= start();

  // 2. A control: a slider, which may play, a list or a box.
  const spoken = name => name.replaceAll("_", " ");
  function field(figure, control) {
    const id = `live-${figure}-${control.name}`;
    if (control.choices?.join() === "off,on") {
      const box = el("input", { id, type: "checkbox" });
      box.checked = box.defaultChecked = control.value === 1;
      return { whole: el("label", { for: id, class: "box" }, box, " " + control.label), value: () => box.checked ? "on" : "off", put: v => { box.checked = v === "on"; }, first: box.checked ? "on" : "off" };
    }
    if (control.choices) {
      const list = el("select", { id }, ...control.choices.map((c, k) => el("option", k === control.value ? { value: c, selected: "" } : { value: c }, spoken(c))));
      return { whole: el("div", { class: "field" }, el("label", { for: id }, control.label), list), value: () => list.value, put: v => { list.value = v; }, first: list.value };
    }
    const range = el("input", { id, type: "range", min: control.least, max: control.most, step: control.step, value: control.value });
    const shown = el("output", { for: id, "aria-live": "off" }, range.value), play = control.plays && el("button", { type: "button", class: "play", "aria-label": "play: " + control.label });
    return { whole: el("div", { class: "field" }, el("label", { for: id }, control.label + " ", shown), el("span", {}, range, play || "")), value: () => range.value, range, play,
      put: v => { range.value = v; }, first: range.value, show: () => { shown.textContent = range.value.replace("-", "−"); } };
  }
  // Plays a slider from where it stands, or from its begin, to its end, each step when the one before is painted.
  function player(live, f, moved) {
    const { range, play } = f, steps = Math.round((range.max - range.min) / range.step), by = Math.ceil(steps / 80) * range.step;
    let running = 0;
    const stop = () => { running = 0; play.classList.remove("playing"); };
    async function run() {
      const mine = running = performance.now();
      play.classList.add("playing");
      if (+range.value >= +range.max) range.value = +range.min - by;
      while (running === mine && +range.value < +range.max) {
        const painted = new Promise(done => live.addEventListener("answered", done, { once: true })), begin = performance.now();
        range.value = Math.max(+range.min, +range.value + by);
        moved();
        await painted;
        await new Promise(done => setTimeout(done, Math.max(0, 90 - performance.now() + begin)));
      }
      if (running === mine) stop();
    }
    play.onclick = () => running ? stop() : run();
    return { run, stop };
  }

  // 3. The state of a figure in the address: #live-NAME&load=2&cells=100, only what is not as at the beginning.
  const asked = () => { const [name, ...settings] = decodeURIComponent(location.hash.slice(1)).split("&"); return [name.replace(/^live-/, ""), settings.map(s => s.split("="))]; };
  const address = (name, fields) => "#live-" + [name, ...Object.entries(fields).filter(([, f]) => f.value() !== f.first).map(([n, f]) => `${n}=${f.value()}`)].join("&");
  function put(fields, settings) {
    for (const f of Object.values(fields)) f.put(f.first);
    for (const [n, v] of settings) if (Object.hasOwn(fields, n)) fields[n].put(v);
  }

  // 4. What a figure shows.  With three panels side by side the first takes two rows, and none of the room is left blank; on a phone
  //    one is seen at a time.
  function arrange(places, tabs, panels) {
    while (places.children.length > panels.length) places.lastChild.remove();
    while (places.children.length < panels.length) places.append(el("div"));
    const wide = panel => panel.equal && panel.window[3] - panel.window[2] < 0.5 * (panel.window[1] - panel.window[0]), narrow = panels.filter(p => !wide(p));
    places.classList.toggle("first-large", narrow.length === 3 && narrow[0] === panels[0] && !!panels[0].equal);
    panels.forEach((panel, k) => {
      places.children[k].classList.toggle("wide", wide(panel) || narrow.length === 1);
      places.children[k].classList.toggle("tall", narrow.length === 3 && panel === narrow[0]);
    });
    const shown = Math.min(Math.max(0, [...tabs.children].findIndex(t => t.getAttribute("aria-pressed") === "true")), panels.length - 1);
    if ([...tabs.children].map(t => t.textContent).join("\n") !== panels.map(p => p.title).join("\n"))
      tabs.replaceChildren(...panels.map(p => el("button", { type: "button" }, p.title)));
    [...tabs.children].forEach((t, k) => { t.setAttribute("aria-pressed", k === shown); places.children[k].classList.toggle("shown", k === shown); });
  }
  function tell(parts, answer) {
    parts.numbers.replaceChildren(...answer.numbers.map(n => el("div", {}, el("dt", {}, n.label), el("dd", {}, `${n.text.replace(/^-/, "−")} ${n.unit}`.trim()))));
    parts.notes.textContent = answer.notes ?? "";
    parts.table.replaceChildren(...answer.table.map((row, k) => el("tr", {}, ...row.map(cell => el(k ? "td" : "th", k ? {} : { scope: "col" }, cell ?? "")))));
  }
  // The series of a trail are kept by panel and layer.
  function memory() {
    const visited = new Map();
    const of = (panel, layer) => { const key = panel.title + "\n" + layer.label; if (!visited.has(key)) visited.set(key, new Map()); return visited.get(key); };
    const visit = (panel, layer, arrays) => {
      const series = of(panel, layer), x = arrays[layer.x][0], y = arrays[layer.y][0];
      if (!series.has(layer.series)) series.set(layer.series, new Map());
      series.get(layer.series).set(x, y);
    };
    const add = ({ answer, arrays }) => answer.panels.forEach(p => p.layers.forEach(l => { if (l.look === "trail") visit(p, l, arrays); }));
    return { add, of, clear: () => visited.clear() };
  }

  // 5. A figure: controls, panels, numbers, and a sentence for all readers.  While the engine computes, only the newest wish waits.
  const mounted = new Map();
  async function mount(live) {
    const name = live.dataset.figure, about = (await (await theEngine()).ask(`figure ${name}`)).answer;
    if (about.error) throw new Error(about.error);
    const fields = Object.fromEntries(about.controls.map(c => [c.name, field(name, c)])), all = Object.values(fields), trails = memory();
    const form = el("form", { "aria-label": about.title }, ...all.map(f => f.whole), el("button", { type: "reset" }, "as at the beginning"));
    const places = el("div", { class: "live-panels" }), tabs = el("div", { class: "live-tabs", role: "group", "aria-label": "panels" }), says = el("p", { role: "status", "aria-live": "polite" });
    const parts = { numbers: el("dl"), table: el("table"), notes: el("p", { class: "live-notes" }) };
    const whole = [el("h3", {}, about.title), form, says, tabs, places, parts.numbers, el("div", { class: "live-table" }, parts.table), parts.notes,
      el("div", { class: "source" }, "computed by ", el("a", { href: live.dataset.source }, live.dataset.label))];
    let last, busy = false, wish = null, drawn = asked()[0] === name ? {} : null, timer = 0, players = [];
    const reveal = line => {
      drawn = { line };
      tabs.children[last.answer.panels.findIndex(p => p.question)]?.click();  // the guess beside the answer
      show();
      if (line && last.answer.panels.some(p => p.question && p.layers.some(l => l.look === "trail"))) players[0]?.run();
    };
    const show = () => {
      if (!last || !live.contains(places)) return;
      const open = drawn ? -1 : last.answer.panels.findIndex(p => p.question), visited = (panel, layer) => new Map([...trails.of(panel, layer)].map(([s, points]) => [s, [...points]]));
      live.classList.toggle("asks", open >= 0);
      says.textContent = open >= 0 ? last.answer.panels[open].question : last.answer.says;
      if (open >= 0 && places.children[open]?.querySelector(".live-ask")) return;
      arrange(places, tabs, last.answer.panels);
      last.answer.panels.forEach((panel, k) => {
        places.children[k].classList.toggle("asked", k === open);
        if (k === open) guess(places.children[k], panel, reveal);
        else if (open < 0) draw(places.children[k], panel, last.arrays, { drag, visited, guess: panel.question ? drawn?.line : null });
      });
    };
    const ask = () => {
      for (const f of all) f.show?.();
      wish = [name, ...Object.entries(fields).map(([n, f]) => `${n}=${f.value()}`)].join(" ");
      if (!busy) go();
    };
    const moved = () => {
      clearTimeout(timer);
      timer = setTimeout(() => history.replaceState(null, "", address(name, fields)), 300);
      ask();
    };
    let grip = {};
    const drag = (to, kind) => {
      players.forEach(p => p.stop());
      for (const [control, value, from] of to) {
        if (kind === "pointerdown") grip[control] = +fields[control].value() - (from ?? value);
        fields[control].put(value + (from === null ? 0 : grip[control]));
      }
      moved();
    };
    async function go() {
      busy = true;
      live.setAttribute("aria-busy", "true");
      while (wish) {
        const words = wish;
        wish = null;
        const begin = performance.now(), got = await (await theEngine()).ask(words), failed = "error" in got.answer;
        if (!live.contains(form)) live.replaceChildren(...whole);
        live.classList.toggle("failed", failed);
        if (failed) says.textContent = got.answer.error;
        else {
          last = got;
          trails.add(got);
          tell(parts, got.answer);
          show();
        }
        live.dispatchEvent(new CustomEvent("answered", { detail: { ...got, total: performance.now() - begin } }));
      }
      live.removeAttribute("aria-busy");
      busy = false;
    }
    players = all.filter(f => f.play).map(f => player(live, f, moved));
    form.addEventListener("input", () => { players.forEach(p => p.stop()); moved(); });
    form.addEventListener("reset", () => { players.forEach(p => p.stop()); trails.clear(); setTimeout(moved); });
    form.addEventListener("submit", event => event.preventDefault());
    tabs.addEventListener("click", event => {
      if (!event.target.matches("button")) return;
      for (const t of tabs.children) t.setAttribute("aria-pressed", t === event.target);
      [...places.children].forEach((p, k) => p.classList.toggle("shown", tabs.children[k] === event.target));
      if (event.isTrusted) show();
    });
    const set = settings => { players.forEach(p => p.stop()); drawn ??= {}; put(fields, settings); ask(); };
    mounted.set(name, set);
    if (asked()[0] === name) put(fields, asked()[1]);
    let width = live.clientWidth;
    new ResizeObserver(() => { if (live.clientWidth !== width) { width = live.clientWidth; live.querySelector(".live-ask")?.remove(); show(); } }).observe(live);
    new MutationObserver(show).observe(document.documentElement, { attributeFilter: ["class"] });
    ask();
  }

  // 6. The page: figures that come near are mounted; words that name a state of a figure lead to it.
  function go() {
    const [name, settings] = asked(), live = [...document.querySelectorAll("div.live")].find(e => e.dataset.figure === name);
    if (!live) return;
    const at = live.getBoundingClientRect();
    if (at.top > innerHeight * 0.6 || at.bottom < innerHeight * 0.4) live.scrollIntoView();
    mounted.get(name)?.(settings);
  }
  addEventListener("DOMContentLoaded", () => {
    if (!document.documentElement.classList.contains("computes")) return;
    const near = new IntersectionObserver((entries, observer) => entries.forEach(entry => {
      if (!entry.isIntersecting) return;
      observer.unobserve(entry.target);
      mount(entry.target).catch(() => { entry.target.querySelector(".live-wait p")?.remove(); });
    }), { rootMargin: "300px" });
    document.querySelectorAll("div.live").forEach(live => {
      const printed = live.nextElementSibling?.querySelector("img")?.cloneNode();
      live.append(el("div", { class: "live-wait" }, el("p", {}, "This figure is being computed …"), printed ?? ""));
      near.observe(live);
    });
    document.querySelectorAll("span.set").forEach(words => {
      const { figure, set } = words.dataset;
      words.replaceWith(el("a", { class: "set", href: "#live-" + [figure, ...set.split(" ")].join("&") }, ...words.childNodes));
    });
    addEventListener("hashchange", go);
    if (asked()[1].length || location.hash.startsWith("#live-")) go();
  });
  window.signoriniLive = theEngine;  // for the test
})();
