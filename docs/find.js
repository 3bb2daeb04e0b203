// find.js: search.  Every section of every page that has all words, best first, by whole beginnings of words; if none has, those that
// have most.  Accents, capitals and the smallest words do not count.  The list, seek.js, is loaded when the box is entered.
(function () {
  "use strict";
  const root = document.documentElement, field = document.getElementById("book-find");
  const hits = document.getElementById("book-hits"), count = document.getElementById("book-count");
  let list = null;
  const load = () => list ??= window.signoriniPage.script("seek.js", "signoriniSeek").then(prepare);
  const fold = words => words.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");
  function prepare([pages, rows, functions]) {
    const titles = new Map(pages);
    const sections = rows.map(([at, anchor, heading, words]) => ({ page: pages[at][0], title: pages[at][1], anchor, heading, words,
      head: fold(heading), name: fold(pages[at][1]), text: fold(words) }));
    const declared = Object.entries(functions).flatMap(([page, names]) => names.map(name => ({ page, title: titles.get(page) ?? page,
      anchor: name, heading: name, words: "", head: fold(name), name: "", text: fold(name.replaceAll("_", " ")) })));
    return sections.concat(declared);
  }
  const wordAt = (text, word, from = 0) => {  // where the word begins a word
    for (let i = text.indexOf(word, from); i >= 0; i = text.indexOf(word, i + 1)) if (!i || !/[\p{L}\p{N}]/u.test(text[i - 1])) return i;
    return -1;
  };
  const small = new Set("a an and as at by for from in is it of on or that the to with".split(" "));
  function rank(row, words, phrase, all) {
    let sum = 0;
    for (const word of words) {
      const inName = wordAt(row.name, word) >= 0, inHead = wordAt(row.head, word) >= 0;
      let n = 0;
      for (let i = wordAt(row.text, word); i >= 0 && n < 5; i = wordAt(row.text, word, i + 1)) ++n;
      if (!inName && !inHead && !n) {
        if (all) return 0;
        continue;
      }
      if (!all) sum += 50;
      sum += 8 * inHead + 5 * inName + n;
    }
    if (row.head === phrase || row.name === phrase) sum += 30;
    if (words.length > 1) sum += 12 * row.text.includes(phrase) + 15 * row.head.includes(phrase);
    return sum * (/^chapter/.test(row.page) ? 2 : /^(glossary|notation|use|scenes|evening)/.test(row.page) ? 1 : 0.5);
  }
  function excerpt(row, words) {
    const line = document.createElement("span");
    const first = Math.max(0, Math.min(...words.map(w => wordAt(row.text, w)).filter(i => i >= 0)) - 50);
    if (row.text.length !== row.words.length || !Number.isFinite(first)) { line.textContent = row.words.slice(0, 140); return line; }
    const begin = first ? row.words.indexOf(" ", first) + 1 : 0, end = row.words.indexOf(" ", begin + 160);
    const text = end < 0 ? row.words.slice(begin) : row.words.slice(begin, end) + " …", low = fold(text);
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
  function entry(row, words) {
    const item = document.createElement("li"), link = document.createElement("a"), head = document.createElement("b");
    link.href = row.page + ".html" + (row.anchor ? "#" + row.anchor : "");
    link.className = "hit";
    head.textContent = row.title + (row.heading ? " · " + row.heading : "");
    link.append(head, excerpt(row, words));
    item.append(link);
    return item;
  }
  async function seek() {
    const phrase = fold(field.value).trim(), said = phrase.split(/\s+/).filter(Boolean);
    const words = said.some(word => !small.has(word)) ? said.filter(word => !small.has(word)) : said;
    root.classList.toggle("seeking", phrase.length > 1);
    if (phrase.length < 2) { count.textContent = ""; return hits.replaceChildren(); }
    const rows = await load();
    if (fold(field.value).trim() !== phrase) return;
    const best = all => rows.map(row => [rank(row, words, phrase, all), row]).filter(r => r[0] > 0)
      .sort((a, b) => b[0] - a[0]).slice(0, 30);
    const exact = best(true), found = exact.length ? exact : best(false);
    hits.replaceChildren(...found.map(([, row]) => entry(row, words)));
    document.getElementById("book-side").scrollTop = 0;
    count.textContent = !exact.length ? "Nothing has all of these words" + (found.length ? "; these have some:" : ".") :
      found.length === 1 ? "1 place" : found.length < 30 ? `${found.length} places` : "the first 30 places";
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
    window.signoriniPage.show(true);
    field.focus();
    event.preventDefault();
  });
})();
