// panels.js: draws the panels of a figure that computes.  Cells are painted on a canvas, lines, points and arrows lie over it as
// SVG.  Shapes and dashes tell them apart, colours only help; those come from the style sheet, so that light and dark are one
// picture.  Axes and colours are those that the figure names: they stay while its controls move.
(function () {
  "use strict";
  const el = (tag, attributes = {}, ...inside) => {
    const e = document.createElement(tag);
    for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v);
    e.append(...inside);
    return e;
  };
  const round = p => +p.toFixed(1), safe = text => text.replace(/[&<>"]/g, c => `&#${c.charCodeAt(0)};`);
  const marks = {
    closed: p => `<circle cx="${p[0]}" cy="${p[1]}" r="3"/>`, open: p => `<circle cx="${p[0]}" cy="${p[1]}" r="3"/>`,
    cross: p => `<path d="M${p[0] - 5} ${p[1] - 5}l10 10m0 -10l-10 10"/>`,
    here: p => `<circle cx="${p[0]}" cy="${p[1]}" r="7"/><circle class="dot" cx="${p[0]}" cy="${p[1]}" r="1.5"/>`,
    trail: p => `<circle cx="${p[0]}" cy="${p[1]}" r="2"/>`
  };
  const short = (v, step = 0) => {  // as many digits as tell a number from the next tick
    if (v === 0 || Math.abs(v) < 1e-9 * step) return "0";
    const digits = Math.max(2, step ? Math.ceil(Math.log10(Math.abs(v) / step)) + 2 : 4);
    const text = Math.abs(v) >= 1e4 || Math.abs(v) < 1e-3 ? v.toExponential(Math.min(digits, 6) - 1).replace(/\.?0*e/, "e") : String(+v.toPrecision(digits));
    return text.replaceAll("-", "−");
  };

  // 1. Axes: values to pixels and back, and places for numbers, so many pixels apart.
  function axis(low, high, log, whole, from, to, apart) {
    const f = log ? Math.log10 : v => v, back = log ? v => 10 ** v : v => v, [a, b] = [f(low), f(high)];
    const raw = (b - a) / (Math.abs(to - from) / apart), power = 10 ** Math.floor(Math.log10(raw)), ticks = [];
    let step = log ? Math.max(1, Math.round(raw)) : [1, 2, 5, 10].find(m => m * power >= raw * 0.999) * power;
    if (whole) step = Math.max(1, step);
    for (let k = Math.ceil(a / step - 1e-9); k * step <= b + 1e-9 * step; ++k) ticks.push(back(+(k * step).toPrecision(12)));
    return { ticks: ticks.map(v => [v, short(v, log ? 0 : step)]), at: v => from + (f(v) - a) / (b - a) * (to - from), value: p => back(a + (p - from) / (to - from) * (b - a)) };
  }
  function frameOf(place, panel) {
    const [x0, x1, y0, y1] = panel.window, left = 60, right = 12, top = 10, bottom = 40;
    const tall = place.clientWidth > 380 && (place.classList.contains("tall") || place.classList.contains("asked"));
    let inner = Math.max(260, place.clientWidth) - left - right, height = panel.equal ? inner * (y1 - y0) / (x1 - x0) : tall ? 430 : 190;
    const most = tall ? 560 : 340;
    if (panel.equal && height > most) { inner *= most / height; height = most; }
    return { left, top, inner, height, end: top + height, w: inner + left + right, h: height + top + bottom,
      X: axis(x0, x1, panel.log_x, panel.whole_x, left, left + inner, 55), Y: axis(y0, y1, panel.log_y, panel.whole_y, top + height, top, 40) };
  }
  function axes(frame, panel) {
    const { X, Y, left, inner, top, height, end, h } = frame;
    return X.ticks.map(([v, words]) => `<text x="${round(X.at(v))}" y="${end + 15}" text-anchor="middle">${words}</text>`)
      .concat(Y.ticks.map(([v, words]) => `<text x="${left - 5}" y="${round(Y.at(v) + 4)}" text-anchor="end">${words}</text>`),
        `<text x="${left + inner / 2}" y="${h - 6}" text-anchor="middle">${safe(panel.x)}</text>`,
        `<text transform="translate(11 ${top + height / 2}) rotate(-90)" text-anchor="middle">${safe(panel.y)}</text>`).join("");
  }

  const grid = ({ X, Y, left, inner, top, end }) => X.ticks.map(([v]) => `<path class="grid" d="M${round(X.at(v))} ${top}V${end}"/>`)
    .concat(Y.ticks.map(([v]) => `<path class="grid" d="M${left} ${round(Y.at(v))}H${left + inner}"/>`)).join("");

  // 2. Cells, on the canvas.  A body keeps some colour where nothing strains it.
  const rgb = words => words.match(/[\d.]+/g).slice(0, 3).map(Number);
  function painter(place) {
    const style = getComputedStyle(place), paper = rgb(getComputedStyle(place.closest(".live")).backgroundColor);
    const ends = ["--live-below", "--live-above"].map(name => rgb(style.getPropertyValue(name)));
    return { mesh: style.getPropertyValue("--live-mesh"), colour: (value, layer) => {
      const part = Math.sqrt(Math.min(1, Math.abs(value) / Math.max(-layer.least, layer.most))), most = ends[value < 0 ? 0 : 1];
      const share = layer.mesh ? 0.1 + 0.9 * part : part;
      return `rgb(${paper.map((p, k) => Math.round(p + share * (most[k] - p))).join(" ")})`;
    } };
  }
  function cells(paint, frame, layer, arrays, painted) {
    const x = arrays[layer.x], y = arrays[layer.y], value = arrays[layer.value], few = value.length <= 2500, X = frame.X, Y = frame.Y;
    for (let k = 0, n = 0; k < value.length; ++k) {
      const first = n;
      paint.beginPath();
      for (let c = 0; c < layer.corners; ++c, ++n) paint.lineTo(X.at(x[n]), Y.at(y[n]));
      if (!Number.isFinite(value[k])) continue;
      paint.closePath();
      paint.fillStyle = painted.colour(value[k], layer);
      paint.fill();
      paint.strokeStyle = layer.mesh && few ? painted.mesh : paint.fillStyle;  // else seams would show
      paint.stroke();
      if (layer.mesh && few && value[k] < 0) {  // hatched, for those who see no colours
        paint.beginPath();
        paint.moveTo(X.at(x[first]), Y.at(y[first]));
        paint.lineTo(X.at(x[first + 2]), Y.at(y[first + 2]));
        paint.stroke();
      }
    }
  }
  function canvas(place, frame, panel, arrays) {
    const sheet = el("canvas", { "aria-hidden": "true" }), ratio = window.devicePixelRatio || 1;
    sheet.width = frame.w * ratio;
    sheet.height = frame.h * ratio;
    sheet.style.width = frame.w + "px";
    sheet.style.height = frame.h + "px";
    const paint = sheet.getContext("2d"), painted = painter(place);
    paint.scale(ratio, ratio);
    paint.rect(frame.left, frame.top, frame.inner, frame.height);
    paint.clip();
    paint.lineWidth = 0.5;
    for (const layer of panel.layers) if (layer.corners) cells(paint, frame, layer, arrays, painted);
    return sheet;
  }

  // 3. Lines, points, arrows and solid bodies.
  function line(look, pixels, closed) {
    let pen = "M";
    const path = pixels.map(p => { if (!p.every(Number.isFinite)) { pen = "M"; return ""; } const d = pen + p; pen = "L"; return d; });
    return `<path class="${look}" d="${path.join("")}${closed ? "Z" : ""}"/>`;
  }
  function arrow([x, y], [a, b]) {
    const length = Math.hypot(a - x, b - y), head = Math.min(7, length / 2);
    if (!(length > 1)) return "";
    const [p, q] = [(a - x) / length * head, (b - y) / length * head];
    const wing = s => `${round(a - p + s * q / 2)} ${round(b - q - s * p / 2)}`;
    return `<path d="M${x} ${y}L${round(a - p)} ${round(b - q)}"/><path class="head" d="M${a} ${b}L${wing(1)}L${wing(-1)}Z"/>`;
  }
  function points(frame, layer, x, y, pixels) {
    const { top, end } = frame, inside = v => v >= top - 0.5 && v <= end + 0.5;
    return pixels.map((p, k) => {
      if (!Number.isFinite(x[k]) || !Number.isFinite(y[k])) return "";
      const up = !(p[1] > top), edge = up ? top + 2 : end - 2;
      const mark = inside(p[1]) ? marks[layer.look](p) : `<path d="M${p[0]} ${edge}l-4 ${up ? 7 : -7}h8z"/>`;  // beyond the axes: an arrow at their edge
      return `<g class="${layer.look}"><title>${safe(layer.label)}: ${short(x[k])}, ${short(y[k])}</title>${mark}</g>`;
    }).join("");
  }
  function shape(frame, layer, x, y) {
    const pixels = Array.from(x, (v, k) => [frame.X.at(v), frame.Y.at(y[k])].map(round));
    if (layer.look === "arrow") return `<g class="arrow">${pixels.map((p, k) => k % 2 ? arrow(pixels[k - 1], p) : "").join("")}</g>`;
    if (marks[layer.look] && layer.look !== "trail") return points(frame, layer, x, y, pixels);
    return line(layer.look, pixels, layer.look === "solid");
  }
  // What has been visited: one line for each series of settings, joined along x; the others stay, pale.
  function trail(frame, layer, visited) {
    let out = "";
    for (const [series, points] of visited) {
      const sorted = [...points].sort((a, b) => a[0] - b[0]), now = series === layer.series, last = sorted[sorted.length - 1];
      const pixels = sorted.map(([a, b]) => [frame.X.at(a), frame.Y.at(b)].map(round));
      out += `<g class="trail${now ? "" : " other"}">${line("way", pixels)}${pixels.map(marks.trail).join("")}`;
      if (visited.size > 1) out += `<text x="${Math.min(frame.X.at(last[0]) + 5, frame.left + frame.inner - 4)}" y="${round(frame.Y.at(last[1]) - 6)}" text-anchor="end">${safe(series)}</text>`;
      out += "</g>";
    }
    return out;
  }

  // 4. What a legend says: a sample and words, or the ends of a scale of colours.
  function sample(layer) {
    const inside = layer.look === "arrow" ? `<g class="arrow">${arrow([1, 7], [25, 7])}</g>` : layer.look === "solid" ? `<path class="solid" d="M1 2H25V12H1Z"/>` :
      marks[layer.look] ? `<g class="${layer.look}">${marks[layer.look]([13, 7])}</g>` : `<path class="${layer.look}" d="M1 7H25"/>`;
    const item = el("li", {}, " " + layer.label);
    item.insertAdjacentHTML("afterbegin", `<svg width="26" height="14" aria-hidden="true">${inside}</svg>`);
    return item;
  }
  function legend(place, panel) {
    const list = el("ul", { class: "live-legend" }), painted = painter(place), told = new Set();
    for (const layer of panel.layers) {
      if (!layer.label || told.has(layer.label)) continue;
      told.add(layer.label);
      if (!layer.corners) { list.append(sample(layer)); continue; }
      const parts = [0, 0.02, 0.1, 0.25, 0.5, 0.75, 1].map(p => layer.least + p * (layer.most - layer.least));
      const bar = el("span", { class: "live-scale", style: `background: linear-gradient(90deg, ${parts.map(v => painted.colour(v, layer)).join(", ")})` });
      list.append(el("li", {}, `${layer.label} ${short(layer.least)} `, bar, ` ${short(layer.most)}${layer.least < 0 && layer.mesh ? ", hatched below 0" : ""}`));
    }
    return list;
  }

  // 5. A panel.  `with`: what a pointer moves, what was visited, what the reader has drawn.
  function stageOf(place, panel, frame, lines, points = "") {
    const id = "clip-" + Math.random().toString(36).slice(2), clip = (name, room) => `<clipPath id="${id}${name}"><rect x="${frame.left - room}" y="${frame.top - room}" ` +
      `width="${frame.inner + 2 * room}" height="${frame.height + 2 * room}"/></clipPath>`, stage = el("div", { class: "live-stage", style: `width:${frame.w}px;height:${frame.h}px` });
    stage.innerHTML = `<svg width="${frame.w}" height="${frame.h}" aria-hidden="true">${grid(frame)}</svg><svg width="${frame.w}" height="${frame.h}" role="img" aria-label="${safe(panel.title)}">${clip("l", 1)}${clip("p", 9)}${axes(frame, panel)}` +
      `<g clip-path="url(#${id}l)">${lines}</g><g clip-path="url(#${id}p)">${points}</g></svg>`;
    return stage;
  }
  function draw(place, panel, arrays, { drag, visited, guess }) {
    const frame = frameOf(place, panel);
    let lines = "", points = "";
    for (const layer of panel.layers) {
      if (layer.corners) continue;
      if (layer.look === "trail") points += trail(frame, layer, visited(panel, layer));
      else if (marks[layer.look]) points += shape(frame, layer, arrays[layer.x], arrays[layer.y]);
      else lines += shape(frame, layer, arrays[layer.x], arrays[layer.y]);
    }
    if (guess) lines += line("guess", guess.map(([x, y]) => [frame.X.at(x), frame.Y.at(y)].map(round)));
    const stage = stageOf(place, panel, frame, lines, points), words = legend(place, panel);
    stage.firstChild.after(canvas(place, frame, panel, arrays));
    if (guess) words.append(sample({ look: "guess", label: "your guess" }));
    if (panel.drag.length) pull(stage, frame, panel, drag);
    place.replaceChildren(el("h4", {}, panel.title), stage, words);
  }

  // 6. Dragging: a control is a linear function of the place of the pointer; where an object is held, from where it was.
  function pull(stage, frame, panel, drag) {
    const { X, Y, left, inner, top, end } = frame;
    let held = null;
    const at = event => {
      const r = stage.getBoundingClientRect(), x = event.clientX - r.left, y = event.clientY - r.top;
      return x < left || x > left + inner || y < top || y > end ? null : [X.value(x), Y.value(y)];
    };
    const follow = event => {
      const place = at(event);
      if (!(event.buttons & 1) || !place) return;
      if (event.type === "pointerdown") held = place;
      drag(panel.drag.map(d => [d.control, d.from + d.x * place[0] + d.y * place[1], held && panel.grab ? d.from + d.x * held[0] + d.y * held[1] : null]), event.type);
      event.preventDefault();
    };
    stage.classList.add(panel.grab ? "grab" : "drag");
    stage.addEventListener("pointerdown", follow);
    stage.addEventListener("pointermove", follow);
  }

  // 7. A prediction: the axes alone, and a line that follows the pointer from left to right.
  function guess(place, panel, done) {
    const frame = frameOf(place, panel), { X, Y, left, inner, top, end } = frame, drawn = new Map(), wide = 4;
    const stage = stageOf(place, panel, frame, '<path class="guess" d=""/>'), path = stage.querySelector("path.guess");
    const show = el("button", { type: "button", disabled: "" }, "show the answer"), skip = el("button", { type: "button" }, "without a guess");
    const line = () => [...drawn].sort((a, b) => a[0] - b[0]).map(([k, y]) => [X.value(left + k * wide), Y.value(y)]);
    let last = null;
    const follow = event => {
      if (!(event.buttons & 1)) { last = null; return; }
      const r = stage.getBoundingClientRect(), x = Math.min(Math.max(event.clientX - r.left, left), left + inner);
      const y = Math.min(Math.max(event.clientY - r.top, top), end), k = Math.round((x - left) / wide), [from, height] = last ?? [k, y];
      for (let i = Math.min(from, k); i <= Math.max(from, k); ++i) drawn.set(i, from === k ? y : height + (y - height) * (i - from) / (k - from));
      last = [k, y];
      path.setAttribute("d", "M" + [...drawn].sort((a, b) => a[0] - b[0]).map(([i, v]) => `${round(left + i * wide)},${round(v)}`).join("L"));
      show.disabled = drawn.size * wide < inner / 2;
      event.preventDefault();
    };
    stage.classList.add("guessing");
    for (const type of ["pointerdown", "pointermove", "pointerup"]) stage.addEventListener(type, follow);
    show.onclick = () => done(line());
    skip.onclick = () => done(null);
    place.replaceChildren(el("h4", {}, panel.title), stage, el("div", { class: "live-ask" }, show, skip));
  }
  window.signoriniPanels = { draw, guess, el };
})();
