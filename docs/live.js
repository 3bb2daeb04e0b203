// live.js: figures that compute.  <div class="live" data-figure="NAME"> before a printed figure becomes a form and panels; the page
// keeps its room, and has the printed figure folded away below.  Without WebAssembly, workers or engine.js the page stays as it is.
(function () {
  "use strict";
  const el = (tag, attributes = {}, ...inside) => {
    const e = document.createElement(tag);
    for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
    e.append(...inside);
    return e;
  };

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
  const utf8 = text => new TextDecoder().decode(Uint8Array.from(text, c => c.charCodeAt(0)));  // the engine escapes byte by byte
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
      const answer = JSON.parse(got.text, (key, v) => typeof v === "string" ? utf8(v) : v);
      return { words, answer, arrays: got.arrays, milliseconds: got.milliseconds };
    };
    return { ask, started: performance.now() - begin };
  }
  let engine;
  const theEngine = () => engine ??= start();

  // 2. Panels.  Cells are painted on a canvas, lines and points lie over it as SVG.  Shapes and dashes tell them apart, colours only
  //    help; those come from the style sheet, so that light and dark are one picture.
  const marks = {
    closed: p => `<circle cx="${p[0]}" cy="${p[1]}" r="3"/>`, open: p => `<circle cx="${p[0]}" cy="${p[1]}" r="3"/>`,
    cross: p => `<path d="M${p[0] - 5} ${p[1] - 5}l10 10m0 -10l-10 10"/>`,
    here: p => `<circle cx="${p[0]}" cy="${p[1]}" r="7"/><circle class="dot" cx="${p[0]}" cy="${p[1]}" r="1.5"/>`
  };
  const short = (v, step = 0) => {  // as many digits as tell a number from the next tick
    if (v === 0 || Math.abs(v) < 1e-9 * step) return "0";
    const digits = Math.max(2, step ? Math.ceil(Math.log10(Math.abs(v) / step)) + 2 : 4);
    return Math.abs(v) >= 1e4 || Math.abs(v) < 1e-3 ? v.toExponential(Math.min(digits, 6) - 1).replace(/\.?0*e/, "e") : String(+v.toPrecision(digits));
  };
  const safe = text => text.replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);
  function axis(low, high, log, from, to, apart) {  // values to pixels and back, and places for numbers, so many pixels apart
    const f = log ? Math.log10 : v => v, back = log ? v => 10 ** v : v => v;
    let [a, b] = [f(low), f(high)];
    if (!(b > a)) [a, b] = [a - (Math.abs(a) || 1) / 2, b + (Math.abs(b) || 1) / 2];
    const raw = (b - a) / (Math.abs(to - from) / apart), power = 10 ** Math.floor(Math.log10(raw));
    const step = log ? Math.max(1, Math.round(raw)) : [1, 2, 5, 10].find(m => m * power >= raw * 0.999) * power, ticks = [];
    for (let k = Math.ceil(a / step - 1e-9); k * step <= b + 1e-9 * step; ++k) ticks.push(back(+(k * step).toPrecision(12)));
    return { ticks: ticks.map(v => [v, short(v, log ? 0 : step)]), at: v => from + (f(v) - a) / (b - a) * (to - from), value: p => back(a + (p - from) / (to - from) * (b - a)) };
  }
  function windowOf(panel, arrays) {
    if (panel.window.length) return panel.window;
    const box = [Infinity, -Infinity, Infinity, -Infinity];
    for (const layer of panel.layers)
      [[layer.x, 0, panel.log_x], [layer.y, 2, panel.log_y]].forEach(([name, k, log]) => {
        for (const v of arrays[name])
          if (Number.isFinite(v) && !(log && v <= 0)) { box[k] = Math.min(box[k], v); box[k + 1] = Math.max(box[k + 1], v); }
      });
    for (const [k, log] of [[0, panel.log_x], [2, panel.log_y]]) {
      const room = 0.04 * (box[k + 1] - box[k]);
      if (log) { box[k] /= 1.2; box[k + 1] *= 1.2; }
      else { box[k] -= room; box[k + 1] += room; }
    }
    return box;
  }
  function draw(place, panel, arrays, drag) {
    const box = windowOf(panel, arrays), width = Math.max(260, place.clientWidth), left = 60, right = 12, top = 10, bottom = 40;
    const aspect = (box[3] - box[2]) / (box[1] - box[0]);
    let inner = width - left - right, height = panel.equal ? inner * aspect : 190;
    if (panel.equal && height > 340) { height = 340; inner = height / aspect; }
    const w = inner + left + right, h = height + top + bottom, ratio = window.devicePixelRatio || 1;
    const X = axis(box[0], box[1], panel.log_x, left, left + inner, 55), Y = axis(box[2], box[3], panel.log_y, top + height, top, 40);
    const canvas = el("canvas", { "aria-hidden": "true" }), style = getComputedStyle(place);
    canvas.width = w * ratio; canvas.height = h * ratio;
    canvas.style.width = w + "px"; canvas.style.height = h + "px";
    const paint = canvas.getContext("2d");
    paint.scale(ratio, ratio);
    paint.rect(left, top, inner, height);
    paint.clip();
    paint.strokeStyle = style.getPropertyValue("--live-mesh");
    paint.lineWidth = 0.5;
    let lines = "";
    const legend = el("ul", { class: "live-legend" }), scale = {};
    for (const layer of panel.layers.filter(l => l.corners)) {  // layers with the same words share a scale
      const words = layer.label.replace(/^.*, /, "");
      for (const v of arrays[layer.value]) if (Number.isFinite(v)) (scale[words] ??= []).push(v);
    }
    for (const words in scale) {
      const [least, most] = scale[words].reduce(([a, b], v) => [Math.min(a, v), Math.max(b, v)], [Infinity, -Infinity]);
      scale[words] = Math.max(Math.abs(least), Math.abs(most)) || 1;
      legend.append(el("li", {}, `${words}: ${short(least)} (${least < 0 ? "blue, hatched" : "faint"}) to ${short(most)} (${least < 0 ? "red" : "strong"})`));
    }
    for (const layer of panel.layers) {
      const x = arrays[layer.x], y = arrays[layer.y];
      if (layer.corners) {
        const value = arrays[layer.value], largest = scale[layer.label.replace(/^.*, /, "")], fine = value.length > 2500;
        for (let k = 0, n = 0; k < value.length; ++k) {
          paint.beginPath();
          for (let c = 0; c < layer.corners; ++c, ++n) paint.lineTo(X.at(x[n]), Y.at(y[n]));
          if (!Number.isFinite(value[k])) continue;
          paint.closePath();
          const colour = style.getPropertyValue(value[k] < 0 ? "--live-below" : "--live-above");
          paint.fillStyle = `rgb(${colour} / ${Math.sqrt(Math.abs(value[k]) / largest).toFixed(3)})`;
          paint.fill();
          if (value[k] < 0 && !fine) {  // hatched, for those who see no colours
            paint.moveTo(X.at(x[n - layer.corners]), Y.at(y[n - layer.corners]));
            paint.lineTo(X.at(x[n - layer.corners + 2]), Y.at(y[n - layer.corners + 2]));
          }
          if (!fine) paint.stroke();
        }
        continue;
      }
      const pixels = Array.from(x, (v, k) => [X.at(v), Y.at(y[k])].map(p => +p.toFixed(1)));
      if (marks[layer.look])
        lines += pixels.map((p, k) => p.every(Number.isFinite) ? `<g class="${layer.look}"><title>${safe(layer.label)}: ` +
          `${short(x[k])}, ${short(y[k])}</title>${marks[layer.look](p)}</g>` : "").join("");
      else {
        let pen = "M";
        const path = pixels.map(p => { if (!p.every(Number.isFinite)) { pen = "M"; return ""; } const d = pen + p; pen = "L"; return d; });
        lines += `<path class="${layer.look}" d="${path.join("")}"/>`;
      }
      if (layer.label) {
        const sample = marks[layer.look] ? `<g class="${layer.look}">${marks[layer.look]([13, 7])}</g>` : `<path class="${layer.look}" d="M1 7H25"/>`;
        const item = el("li", {}, " " + layer.label);
        item.insertAdjacentHTML("afterbegin", `<svg width="26" height="14" aria-hidden="true">${sample}</svg>`);
        legend.append(item);
      }
    }
    const id = "clip-" + Math.random().toString(36).slice(2), end = top + height;
    const numbers = X.ticks.map(([v, words]) => `<path class="grid" d="M${X.at(v)} ${top}V${end}"/><text x="${X.at(v)}" y="${end + 15}" text-anchor="middle">${words}</text>`)
      .concat(Y.ticks.map(([v, words]) => `<path class="grid" d="M${left} ${Y.at(v)}H${left + inner}"/><text x="${left - 5}" y="${Y.at(v) + 4}" text-anchor="end">${words}</text>`));
    const stage = el("div", { class: "live-stage", style: `width:${w}px;height:${h}px` }, canvas);
    stage.insertAdjacentHTML("beforeend", `<svg width="${w}" height="${h}" role="img" aria-label="${safe(panel.title)}">` +
      `<clipPath id="${id}"><rect x="${left - 4}" y="${top - 4}" width="${inner + 8}" height="${height + 8}"/></clipPath>${numbers.join("")}` +
      `<g clip-path="url(#${id})">${lines}</g><text x="${left + inner / 2}" y="${h - 6}" text-anchor="middle">${safe(panel.x)}</text>` +
      `<text transform="translate(11 ${top + height / 2}) rotate(-90)" text-anchor="middle">${safe(panel.y)}</text></svg>`);
    if (panel.drag_x || panel.drag_y) {
      const follow = event => {
        const r = stage.getBoundingClientRect(), x = event.clientX - r.left, y = event.clientY - r.top;
        if (!(event.buttons & 1) || x < left || x > left + inner || y < top || y > top + height) return;
        drag(panel.drag_x, X.value(x), panel.drag_y, Y.value(y));
        event.preventDefault();
      };
      stage.classList.add("drag");
      stage.addEventListener("pointerdown", follow);
      stage.addEventListener("pointermove", follow);
    }
    place.replaceChildren(el("h4", {}, panel.title), stage, legend);
    place.classList.toggle("wide", panel.equal && aspect < 0.4);
  }

  // 3. A figure: controls, panels, numbers, and a sentence for all readers.  While the engine computes, only the newest wish waits.
  const spoken = name => name.replaceAll("_", " ");
  function field(figure, control) {
    const id = `live-${figure}-${control.name}`, isBox = control.choices?.join() === "off,on";
    if (isBox) {
      const box = el("input", { id, type: "checkbox" });
      box.checked = box.defaultChecked = control.value === 1;
      return { input: box, label: el("label", { for: id, class: "box" }, box, " " + control.label), value: () => box.checked ? "on" : "off" };
    }
    if (control.choices) {
      const list = el("select", { id }, ...control.choices.map((c, k) => el("option", k === control.value ? { value: c, selected: "" } : { value: c }, spoken(c))));
      return { input: list, label: el("label", { for: id }, control.label, list), value: () => list.value };
    }
    const range = el("input", { id, type: "range", min: control.least, max: control.most, step: control.step, value: control.value });
    const shown = el("output", { for: id, "aria-live": "off" }, range.value);
    return { input: range, label: el("label", { for: id }, el("span", {}, control.label + " ", shown), range), value: () => range.value,
      show: () => { shown.textContent = range.value; } };
  }
  async function mount(live) {
    const name = live.dataset.figure, about = (await (await theEngine()).ask(`figure ${name}`)).answer;
    if (about.error) throw new Error(about.error);
    const fields = Object.fromEntries(about.controls.map(c => [c.name, field(name, c)])), all = Object.values(fields);
    const form = el("form", { "aria-label": about.title }, ...all.map(f => f.label), el("button", { type: "reset" }, "as at the beginning"));
    const panels = el("div", { class: "live-panels" }), numbers = el("dl"), table = el("table"), says = el("p", { role: "status", "aria-live": "polite" });
    let last, busy = false, wish = null;
    const show = () => {
      if (!last || last.answer.error) return;
      while (panels.children.length > last.answer.panels.length) panels.lastChild.remove();
      while (panels.children.length < last.answer.panels.length) panels.append(el("div"));
      last.answer.panels.forEach((panel, k) => panels.children[k].classList.toggle("wide", panel.equal && panel.window.length === 4 &&
        panel.window[3] - panel.window[2] < 0.4 * (panel.window[1] - panel.window[0])));
      last.answer.panels.forEach((panel, k) => draw(panels.children[k], panel, last.arrays, drag));
    };
    const ask = () => {
      for (const f of all) f.show?.();
      wish = [name, ...Object.entries(fields).map(([n, f]) => `${n}=${f.value()}`)].join(" ");
      if (!busy) go();
    };
    const drag = (...to) => {
      for (const [control, value] of [to.slice(0, 2), to.slice(2)]) if (control) fields[control].input.value = value;
      ask();
    };
    async function go() {
      busy = true;
      live.setAttribute("aria-busy", "true");
      while (wish) {
        const words = wish;
        wish = null;
        const begin = performance.now(), got = await (await theEngine()).ask(words), failed = "error" in got.answer;
        live.classList.toggle("failed", failed);
        says.textContent = failed ? got.answer.error : got.answer.says;
        if (!failed) {
          last = got;
          numbers.replaceChildren(...got.answer.numbers.map(n => el("div", {}, el("dt", {}, n.label), el("dd", {}, `${n.text} ${n.unit}`.trim()))));
          table.replaceChildren(...got.answer.table.map((row, k) => el("tr", {}, ...row.map(cell => el(k ? "td" : "th", k ? {} : { scope: "col" }, cell ?? "")))));
          show();
        }
        live.dispatchEvent(new CustomEvent("answered", { detail: { ...got, total: performance.now() - begin } }));
      }
      live.removeAttribute("aria-busy");
      busy = false;
    }
    form.addEventListener("input", ask);
    form.addEventListener("reset", () => setTimeout(ask));
    form.addEventListener("submit", event => event.preventDefault());
    live.replaceChildren(el("h3", {}, about.title), form, says, panels, numbers, el("div", { class: "live-table" }, table),
      el("div", { class: "source" }, "computed by ", el("a", { href: live.dataset.source }, live.dataset.label)));
    let width = live.clientWidth;
    new ResizeObserver(() => { if (live.clientWidth !== width) { width = live.clientWidth; show(); } }).observe(live);
    new MutationObserver(show).observe(document.documentElement, { attributeFilter: ["class"] });
    ask();
  }
  addEventListener("DOMContentLoaded", () => {
    const near = new IntersectionObserver((entries, observer) => entries.forEach(entry => {
      if (!entry.isIntersecting) return;
      observer.unobserve(entry.target);
      mount(entry.target).catch(() => entry.target.remove());
    }), { rootMargin: "300px" });
    document.querySelectorAll("div.live").forEach(live => {
      live.append(el("p", { class: "live-wait" }, "This figure is being computed …"));
      near.observe(live);
    });
  });
  window.signoriniLive = theEngine;  // for the test
})();
