// print.js: joins web pages of the book to the one that tools/book-pdf.py prints.
//
// join(book) takes {base, brief, version, pictures: {src: svg}, pages: [{name, html}]} and fills the page: title, contents, then a section for
// each page that begins on a new sheet; exercises follow in the section of their chapter, their hints in one at the end.
// Links between pages become links within the book, links to what is not in the book become plain words.  Returns what
// is wrong: places that are linked to and do not exist, or exist twice.
// `ready` becomes true when pictures and faces are there.
// faceless(letters) returns those that no face of this machine has.
// number(pages) writes {place: page} behind the entries of the contents and of the index.
// misfits() lists what is not drawn, and what is wider than the paper or its column.
// told() says what must be found in the print: headings with level, height and width in points, and formulas.
"use strict";
const TALLEST = 380;        // pixels of a picture
const SAID = /^Edit attempt.cpp only; exercise.hpp (says what goes in and comes out|has the questions).$/;    // in nearly every exercise
let ready = false;

function element(tag, attributes = {}, ...children) {
  const e = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) e.setAttribute(name, value);
  e.append(...children);
  return e;
}

let drawings = 0;
/// Fills a polygon with the lines of its pattern: browsers print patterns as bitmaps.
function hatch(svg, polygon, name) {
  const make = (tag, attributes, ...children) => {
    const e = document.createElementNS(svg.namespaceURI, tag);
    for (const [key, value] of Object.entries(attributes)) e.setAttribute(key, value);
    e.append(...children);
    return e;
  };
  const pattern = svg.querySelector(polygon.getAttribute("fill").slice(4, -1));
  const size = ["width", "height"].map((side) => Number(pattern.getAttribute(side)));
  const points = polygon.getAttribute("points").trim().split(/[\s,]+/).map(Number);
  const range = [0, 1].map((axis) => {
    const at = points.filter((_, i) => i % 2 === axis);
    return [Math.floor(Math.min(...at) / size[axis]), Math.ceil(Math.max(...at) / size[axis])];
  });
  const lines = make("g", { "clip-path": `url(#${name})` });
  for (let i = range[0][0]; i < range[0][1]; ++i)
    for (let j = range[1][0]; j < range[1][1]; ++j)
      lines.append(make("g", { transform: `translate(${i * size[0]} ${j * size[1]})` }, ...[...pattern.children].map((e) => e.cloneNode(true))));
  polygon.replaceWith(make("clipPath", { id: name }, make("polygon", { points: polygon.getAttribute("points") })), lines);
}

/// A picture within the page: browsers turn some that are linked to into bitmaps.  Its names become its own.
function drawing(picture, words) {
  const svg = new DOMParser().parseFromString(picture, "image/svg+xml").documentElement, own = `drawing-${++drawings}-`;
  for (const e of [svg, ...svg.querySelectorAll("*")])
    for (const { name, value } of [...e.attributes]) {
      if (name === "id") e.id = own + value;
      else if (/^#/.test(value) && /href$/.test(name)) e.setAttribute(name, "#" + own + value.slice(1));
      else if (value.includes("url(#")) e.setAttribute(name, value.replaceAll("url(#", "url(#" + own));
    }
  for (const polygon of svg.querySelectorAll("polygon[fill^=url]")) hatch(svg, polygon, own + "clip-" + ++drawings);
  for (const label of svg.querySelectorAll("[style*='filter']")) {    // a box behind letters: filters become bitmaps, a seam does not
    label.setAttribute("style", "stroke: #fff; stroke-width: 5; stroke-linejoin: round; paint-order: stroke");
  }
  const [, , width, height] = svg.getAttribute("viewBox").split(/[\s,]+/).map(Number);
  const scale = Math.min(1, TALLEST / height);
  svg.setAttribute("width", width * scale);
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", words);
  return document.importNode(svg, true);
}

/// The text of a page, ready for paper, and its title.  Its anchors carry the name of the page: there is one page now.
function text_of(page, { base, pictures }) {
  const from = new DOMParser().parseFromString(page.html, "text/html");
  const text = from.querySelector("main");
  if (!text) throw new Error(`${page.name}: no text in this page`);
  const lead = text.querySelector(".lead") ?? "";
  const above = text.querySelector("header.title p")?.textContent ?? "";
  const number = page.name.startsWith("exercise-") ? above + " " : "", part = page.name.startsWith("chapter-") ? above : "";
  const title = number + (text.querySelector("header.title h1") ?? from.querySelector("title")).textContent.trim();
  for (const e of text.querySelectorAll("header.title, nav.turn, .self, .live, .live-printed > summary, script, p:empty")) e.remove();
  for (const e of text.querySelectorAll("[style]")) e.removeAttribute("style");
  for (const e of text.querySelectorAll(".hoist")) e.append(...e.querySelectorAll(":scope > .note"));    // there is no margin beside the text
  for (const e of text.querySelectorAll(".live-printed, .hoist")) e.replaceWith(...e.childNodes);
  for (const e of text.querySelectorAll(":is(.eq, .code, .table)"))
    if (/[:,]\s*$/.test(e.previousElementSibling?.textContent ?? "")) e.previousElementSibling.classList.add("introduces");
  for (const image of text.querySelectorAll("img")) {
    const picture = pictures[image.getAttribute("src")];
    if (picture) image.replaceWith(drawing(picture, image.alt));
    else image.src = new URL(image.getAttribute("src"), base).href;
  }
  for (const e of text.querySelectorAll("[id]")) if (!e.closest("svg")) e.id = `${page.name}-${e.id}`;
  for (const link of text.querySelectorAll("a[href]")) {
    const [, name, place] = /^([^#:]*?)(?:\.html)?(?:#(.*))?$/.exec(link.getAttribute("href")) ?? [];
    if (name === undefined) continue;    // to another site
    const to = name || page.name;
    link.setAttribute("href", place ? `${to}.html#${to}-${decodeURIComponent(place)}` : `${to}.html`);
  }
  return { title, text, lead, part };
}

function title_page(cover, book) {
  return element("section", { id: "title" }, element("h1", {}, cover.title), element("div", { class: "brief" }, book.brief),
      element("div", { class: "authors" }, book.authors), cover.text.querySelector("figure svg, figure img") ?? "", cover.lead,
      element("div", { class: "version" }, book.version), element("div", { class: "licence" }, book.licence));
}

/// An exercise in the section of its chapter: its command and its hints stand in the line of its kind and time.
function exercise_of(page, { title, text }, hints) {
  const line = text.querySelector("p"), folded = [...text.querySelectorAll("details")];
  line.append(" · ", element("code", {}, "make ex" + page.name.replace("exercise-", "").split("-").map(Number).join(".")));
  [...text.querySelectorAll("figure.code")].find((e) => /^make ex[\d.]+\s/.test(e.textContent.trim()))?.remove();
  const edit = [...text.querySelectorAll("p")].find((e) => e.textContent.startsWith("Edit attempt.cpp only"));
  const folder = /exercises-(ex\d+_\w+)-attempt/.exec(edit?.innerHTML ?? "");
  if (folder) line.append(" · ", element("code", {}, "exercises/" + folder[1]));
  if (edit && SAID.test(edit.textContent)) edit.remove();
  for (const heading of text.querySelectorAll("h2, h3")) heading.replaceWith(element("h4", {}, ...heading.childNodes));
  if (folded.length) {
    const place = "hints-" + page.name;
    hints.append(element("h3", { id: place }, element("a", { href: page.name + ".html" }, title)));
    for (const one of folded) {
      const words = one.querySelector("summary").textContent;
      one.querySelector("summary").remove();
      hints.append(element("div", { class: "hint" }, element("b", {}, words), ...one.childNodes));
      one.remove();
    }
    line.append(" · ", element("a", { href: "hints.html#" + place }, "hints"));
  }
  return [element("h3", { id: page.name }, title), ...text.childNodes];
}

/// The contents: parts, sections, and their headings but those that half of the chapters have.
function contents_of(sections) {
  const list = element("ol"), often = new Map();
  for (const heading of sections.flatMap((s) => [...s.querySelectorAll("h2")])) often.set(heading.textContent, (often.get(heading.textContent) ?? 0) + 1);
  const add = (heading, kind, place) => list.append(element("li", { class: "contents " + kind },
      element("a", { href: "#" + place }, heading.textContent.trim()), element("i"), element("span", { class: "page", "data-place": place })));
  let part = "";
  for (const section of sections) {
    if (section.dataset.part && section.dataset.part !== part) list.append(element("li", { class: "part" }, section.dataset.part));
    part = section.dataset.part;
    add(section.querySelector("h1"), "chapter", section.id);
    for (const heading of section.querySelectorAll("h2"))
      if (heading.id && often.get(heading.textContent) < sections.length / 2) add(heading, "within", heading.id);
  }
  return element("section", { id: "contents" }, element("h1", {}, "Contents"), list);
}

/// The page of a place in another chapter, behind the first link to it in a paragraph.
function add_page(link, to, told) {
  const block = link.closest("p, li, td, figcaption, h3"), target = document.getElementById(to);
  if (!block || link.matches(".gloss") || target.closest("section") === link.closest("section") && link.textContent !== "hints") return;
  if (!told.has(block)) told.set(block, new Set());
  if (told.get(block).has(to)) return;
  told.get(block).add(to);
  link.after(element("span", { class: "at" }, "\u00a0p.\u2009", element("span", { class: "page", "data-place": to }, "000")));
}

/// Above the pages of a section: where its programs lie, and its heading.
function running_head(section) {
  const box = (side, words) => `@${side} { content: ${JSON.stringify(words)}; font: 8pt Pagella, serif; color: #555; }`;
  return `section#${section.id} { page: ${section.id}; } @page ${section.id} { ` +
      `${box("top-left", section.dataset.folder)} ${box("top-right", section.querySelector("h1").textContent.trim())} }`;
}

function join(book) {
  const hints = element("section", { id: "hints", "data-folder": "" }, element("h1", {}, "Hints"));
  const sections = [];
  let title;
  for (const page of book.pages) {
    const { title: name, text, lead, part } = text_of(page, book);
    if (page.name === "index") {
      title = title_page({ title: name, text, lead }, book);
      continue;
    }
    if (page.name.startsWith("exercise-")) {
      let all = sections.at(-1).querySelector(".exercises");
      if (!all) {
        all = element("div", { class: "exercises" });
        const list = sections.at(-1).lastElementChild;    // the list of those that follow
        if (list?.matches("ul")) list.remove();
        sections.at(-1).append(all);
      }
      all.append(...exercise_of(page, { title: name, text }, hints));
      continue;
    }
    for (const folded of text.querySelectorAll("details")) folded.setAttribute("open", "");
    if (page.name === "use") {    // its first section tells the two commands, its picture is on the title page
      const own = [...text.children], heading = own.filter((e) => e.matches("h2"))[1];
      if (heading) for (const e of own.slice(own.indexOf(heading))) e.remove();
      text.querySelector("figure.picture")?.remove();
    }
    if (page.name === "ways" && sections.length) {
      sections.at(-1).append(element("h2", { id: page.name }, name), ...text.childNodes);
      continue;
    }
    const folder = /source-(ch\d\d_[a-z_]+)-/.exec(page.name.startsWith("chapter-") ? text.innerHTML : "");
    const section = element("section", { id: page.name, "data-part": part, "data-folder": folder ? "chapters/" + folder[1] : "" });
    section.append(element("h1", {}, page.name === "use" ? "The book" : name), ...text.childNodes);
    sections.push(section);
  }
  if (hints.children.length > 1) sections.push(hints);
  document.body.append(title, contents_of(sections), ...sections);
  document.head.append(element("style", {}, sections.map(running_head).join("\n")));

  const pages = new Set([...sections.map((s) => s.id), ...book.pages.map((p) => p.name).filter((n) => n !== "index")]);
  const places = new Map();
  for (const e of document.querySelectorAll("[id]")) places.set(e.id, (places.get(e.id) ?? 0) + 1);
  const wrong = new Set(), told = new Map();
  for (const link of document.querySelectorAll("section a[href]")) {
    const [, page, place] = /^([^#:]*?)(?:\.html)?(?:#(.*))?$/.exec(link.getAttribute("href")) ?? [];
    if (page === undefined) continue;    // to another site
    if (page !== "" && !pages.has(page)) { link.replaceWith(...link.childNodes); continue; }
    const to = place ?? page;
    link.setAttribute("href", "#" + to);
    if (page === "use" && !places.has(to)) { link.replaceWith(...link.childNodes); continue; }    // of the part left out
    if (places.get(to) !== 1) wrong.add(`${link.textContent}: the place #${to} exists ${places.get(to) ?? 0} times`);
    else if (link.closest("#words td")) link.after(" ", element("span", { class: "page", "data-place": to }));
    else if (!link.closest("#contents")) add_page(link, to, told);
  }
  return [...wrong];
}

async function faceless(letters) {
  await Promise.all([...document.fonts].map((face) => face.load()));
  const canvas = element("canvas", { width: 40, height: 40 }), pen = canvas.getContext("2d", { willReadFrequently: true });
  const drawn = (letter) => {
    pen.reset();
    pen.font = "20px Pagella, 'Pagella Math', Listing, Label, sans-serif";
    pen.fillText(letter, 5, 28);
    return pen.getImageData(0, 0, 40, 40).data.join();
  };
  const none = drawn("\u0378"), blank = drawn(" ");    // no letter has this number: it is drawn as the missing ones are
  return [...letters].filter((letter) => letter.trim() && [none, blank].includes(drawn(letter))).join("");
}

async function settle() {
  await Promise.all([...document.images].map((i) => i.complete || new Promise((done) => { i.onload = i.onerror = done; })));
  await Promise.all([...document.fonts].map((face) => face.load().catch(() => null)));
  ready = true;
}

function number(pages) {
  for (const e of document.querySelectorAll(".page")) e.textContent = pages[e.dataset.place] ?? "?";
  join_words();
}

function misfits() {
  const wrong = [];
  const said = (e) => e.textContent.trim().replace(/\s+/g, " ").slice(0, 60);
  for (const image of document.images) if (!image.naturalWidth) wrong.push("image does not load: " + image.src);
  for (const error of document.querySelectorAll("merror")) wrong.push("formula not drawn: " + said(error));
  for (const section of document.querySelectorAll("section")) {
    const right = section.getBoundingClientRect().right + 1;
    for (const e of section.querySelectorAll("p, li, img, pre, table, blockquote, svg, math, .nb"))
      if (e.getBoundingClientRect().right > right) wrong.push(`${section.id}: wider than the paper: ${e.tagName} ${said(e)}`);
    for (const e of section.querySelectorAll(".scroll, .exercises > *, #hints > *"))
      if (e.scrollWidth > e.clientWidth + 1) wrong.push(`${section.id}: wider than its column: ${said(e)}`);
  }
  return wrong;
}

function told() {
  const points = (pixels) => pixels * 72 / 96;
  return {
    headings: [...document.querySelectorAll("h1, h2, h3, h4")].map((h) => [h.textContent.trim(), h.tagName, points(h.offsetHeight), points(h.offsetWidth)]),
    formulas: [...document.querySelectorAll("math")].map((m) => m.textContent),
  };
}
