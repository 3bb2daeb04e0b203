// flow.js: what a typesetter does to the text that print.js has joined: hyphens, and figures that float.
//
// hyphenate(rules) puts soft hyphens into the words where lines end, by Liang's method; rules is the text of a file of patterns, such as hyph_en_GB.dic.
// join_words() takes away those where a line ends no more.
// floats(sheet) lets text go before a figure that does not fit on its page; sheet is {width, height} of what is printed on a page, in pixels.
"use strict";
const BROKEN = "p, li, td, figcaption, .hint";    // what has words that may be broken
const WHOLE = "pre, code, math, svg, .nb";        // and what within it has none
const SIZES = [0.95, 0.9, 0.85, 0.8];             // of pictures, if one saves a page or fills one
const WHITE = 0.3;                                // of a page, at most; a third in print
const KEPT = 0.2;                                 // of a page: listings and tables below stay in one piece
const EDGE = [2, 3];                              // letters that stay together at both ends of a word

/// {letters: numbers between them} of a file of patterns.
function patterns_of(rules) {
  const patterns = new Map();
  for (const line of rules.split("\n")) {
    if (!/^[.\d\p{Ll}]+$/u.test(line)) continue;
    const numbers = [0];
    for (const sign of line) if (/\d/.test(sign)) numbers[numbers.length - 1] = Number(sign); else numbers.push(0);
    patterns.set(line.replace(/\d/g, ""), numbers);
  }
  return patterns;
}

/// A word with soft hyphens: a break is where the largest number of the patterns that fit is odd.
function broken(word, patterns) {
  const text = `.${word.toLowerCase()}.`, most = new Array(text.length + 1).fill(0);
  for (let from = 0; from < text.length; ++from)
    for (let to = from + 1; to <= text.length; ++to)
      (patterns.get(text.slice(from, to)) ?? []).forEach((n, i) => { most[from + i] = Math.max(most[from + i], n); });
  return [...word].map((letter, i) =>
      (i >= EDGE[0] && i <= word.length - EDGE[1] && most[i + 1] % 2 ? "\u00ad" : "") + letter).join("");
}

/// Is a soft hyphen of a text at the end of a line?
function ends_line(node, at) {
  const around = [at - 1, at + 1].map((i) => {
    const range = document.createRange();
    range.setStart(node, i);
    range.setEnd(node, i + 1);
    return range.getBoundingClientRect();
  });
  return around[1].left < around[0].right - 1;
}

/// The texts whose words may be broken.
function texts() {
  const nodes = [], walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT,
      (node) => node.parentElement.closest(BROKEN) && !node.parentElement.closest(WHOLE) ? NodeFilter.FILTER_ACCEPT : NodeFilter.FILTER_REJECT);
  while (walk.nextNode()) nodes.push(walk.currentNode);
  return nodes;
}

/// Takes away the hyphens that no line ends with: a search would not find words that have them.
function join_words() {
  const nodes = texts().filter((node) => node.data.includes("\u00ad"));
  const left = nodes.map((node) => node.data.replace(/\u00ad/g, (sign, at) => ends_line(node, at) ? sign : ""));
  nodes.forEach((node, i) => { node.data = left[i]; });
}

function hyphenate(rules) {
  const patterns = patterns_of(rules), known = new Map();
  for (const node of texts()) {
    node.data = node.data.replace(/(?<![\p{L}\d_.])\p{L}?\p{Ll}{4,}(?![\p{L}\d_.]\S)/gu, (word) => {
      if (!known.has(word)) known.set(word, broken(word, patterns));
      return known.get(word);
    });
  }
  join_words();
}

const heading = (e) => /^H\d$/.test(e.tagName);
const picture = (e) => e.matches("figure.picture");
const leads = (e) => heading(e) || /[:,]$/.test(e.textContent.trim());
const led = (e) => e.matches(".eq, .code, .table") || /^\p{Ll}/u.test(e.textContent.trim());

/// The page of a section on which a block begins, that on which it ends, and how much of this is free below it.
function page_of(e, section, { width, height }) {
  const frame = section.getBoundingClientRect(), parts = e.getClientRects(), last = parts[parts.length - 1];
  const page = (part) => Math.floor((part.left + 1 - frame.left) / width);
  return { first: page(parts[0]), last: page(last), free: height - (last.bottom - frame.top) };
}

/// The text that goes before a figure: from the next block to one after which a figure may stand.
function text_after(figure) {
  const after = [], text = [];
  for (let e = figure.nextElementSibling; e && !e.matches(".exercises"); e = e.nextElementSibling) if (!picture(e)) after.push(e);
  for (const [i, e] of after.entries()) {
    text.push(e);
    if (!leads(e) && !(after[i + 1] && led(after[i + 1]))) return text;
  }
  return [];
}

/// Text goes before a figure until the page above it is full.
function settle_figure(figure, section, sheet) {
  for (;;) {
    let before = figure.previousElementSibling;
    while (before && heading(before)) before = before.previousElementSibling;
    if (!before || page_of(figure, section, sheet).first === page_of(before, section, sheet).last) return;
    if (page_of(before, section, sheet).free < sheet.line) return;
    const text = text_after(figure);
    if (!text.length) return;
    figure.before(...text);
  }
}

/// The largest share of a page of a section, but the last, that is white.
function whitest(section, sheet) {
  const blocks = [...section.children].map((e) => page_of(e, section, sheet));
  return Math.max(0, ...blocks.slice(1).map((next, i) => next.first > blocks[i].last ? blocks[i].free / sheet.height : 0));
}

/// Sets the pictures of a section in one size, and text before those that do not fit on their pages.
function settle_section(section, order, size, sheet) {
  section.style.setProperty("--size", size);
  section.append(...order);
  for (const figure of section.querySelectorAll(":scope > figure.picture")) settle_figure(figure, section, sheet);
  return { pages: Math.round(section.scrollWidth / sheet.width), full: whitest(section, sheet) < WHITE };
}

/// The largest size of the pictures of a section that saves its last page, or fills a page that would be white; or 1.
function size_of(section, order, sheet) {
  const plain = settle_section(section, order, 1, sheet);
  const last = sheet.height - page_of(section.lastElementChild, section, sheet).free;
  const pictures = [...section.querySelectorAll("figure.picture")].reduce((sum, e) => sum + e.offsetHeight, 0);
  return SIZES.find((size) => {
    if (plain.full && (1 - size) * pictures < last) return false;
    const { pages, full } = settle_section(section, order, size, sheet);
    return full && (!plain.full || pages < plain.pages);
  }) ?? 1;
}

function floats(sheet) {
  for (const e of document.querySelectorAll("pre, table")) if (e.offsetHeight < KEPT * sheet.height) e.classList.add("short");
  for (const section of document.querySelectorAll("section")) {
    section.style.cssText = `columns: ${sheet.width}px; column-fill: auto; column-gap: 0; width: ${sheet.width}px; height: ${sheet.height}px`;
    const order = [...section.childNodes], size = size_of(section, order, sheet);
    settle_section(section, order, size, sheet);
    section.style.cssText = `--size: ${size}`;
  }
}
