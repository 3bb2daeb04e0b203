#!/usr/bin/env python3
"""check-docs.py [--all] [BOOK] [WORD]

Opens pages of BOOK (default build/book) in headless Chromium and checks that every formula is shown, every image is there, no line
begins with a comma, no listing of a chapter is cut off, nothing is wider than a window of 1280 or, for texts, of 390 pixels, nothing
comes from outside, the console is silent, and the search box finds WORD.  Opened are all texts and, of each kind of page that is made
by the hundred, every 16th; with --all every page.  The links and images of the others are read from their files, so that every link
of the book leads somewhere.
Needs python3 and chromium, no further packages: Chromium is driven through its debugging pipe.
"""
import html.parser
import json
import os
import queue
import re
import sys
import threading
import urllib.parse

sys.dont_write_bytecode = True    # no __pycache__ beside the tools
from browser import Browser, Tab, chromium

# Runs in a page: reports what it finds.
PROBE = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms));
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  await document.fonts.ready;
  document.querySelectorAll('main details').forEach(fold => { fold.open = true; });
  const there = i => i.complete && i.naturalWidth > 0;    // under load a picture may come late
  for (let k = 0; k < 60 && ![...document.images].every(there); ++k) {
    if (k % 20 === 10) for (const i of document.images) if (!there(i)) i.src = i.getAttribute('src');
    await wait(100);
  }
  const raw = [], walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let n; (n = walk.nextNode());) {
    if (n.parentElement.closest('script,style,pre,code,.fragment,.tt,.memname,.memItemRight,math,svg,noscript')) continue;
    if (/\\[\[\]()]|\\(frac|sum|int|alpha|begin|end|mathrm|left|right)\b|\\f[\$\[\]]|\$[^\s$](?:[^$]*[^\s$])?\$|[@\\](ref|subpage|anchor|PaperEq)\b|<!--/.test(n.textContent) ||
        n.parentElement.matches('main p, main li, main td') && /(^|[\s(-])\*[A-Za-z]/.test(n.textContent))
      raw.push(n.textContent.trim().slice(0, 80));
  }
  const commas = [];    // after formulas and links, where a line may break
  for (const e of document.querySelectorAll('main :is(p, li, td) :is(math, a, code)')) {
    const next = e.nextSibling ?? e.parentElement.nextSibling;
    if (!e.checkVisibility() || next?.nodeType !== 3 || !/^[,.;:)]/.test(next.data)) continue;
    const sign = document.createRange();
    sign.setStart(next, 0);
    sign.setEnd(next, 1);
    if (sign.getBoundingClientRect().top > e.getBoundingClientRect().bottom - 2) commas.push((e.textContent + next.data).slice(-30));
  }
  const all = (selector, f) => [...document.querySelectorAll(selector)].map(f);
  return JSON.stringify({ raw, commas,
    math: all('math', e => !e.checkVisibility() || e.getBoundingClientRect().width),
    left: all('merror', e => e.textContent.slice(0, 80)),
    cut: all('.chapter figure.code pre, .chapter .eq .scroll', e => e.scrollWidth > e.clientWidth + 1 && e.textContent.trim().slice(0, 60)).filter(Boolean),
    images: all('img', i => [i.getAttribute('src'), i.complete && i.naturalWidth > 0, i.alt]),
    ids: all('[id],a[name]', e => e.id || e.name),
    links: all('a[href]:not(.summary a)', a => a.getAttribute('href')),  // some Doxygens list private classes there
    wide: document.documentElement.scrollWidth > innerWidth + 2 });
})()"""

NARROW = r"""new Promise(done => requestAnimationFrame(() => requestAnimationFrame(() => done(document.documentElement.scrollWidth > innerWidth + 2))))"""

# Runs in a page: types a word into the search box, returns the number of hits.
SEARCH = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms));
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  const box = document.getElementById('book-find');
  if (!box) return -1;
  box.focus();
  box.value = WORD;
  box.dispatchEvent(new Event('input', { bubbles: true }));
  for (let i = 0; i < 60; ++i) {
    await wait(100);
    const n = document.querySelectorAll('.hit').length;
    if (n) return n;
  }
  return 0;
})()"""


TABS = 4     # pages that are open at once
EVERY = 16   # of the pages of one kind that Doxygen made, the first of this many is opened

# Names of the pages that are made by the hundred; the part in brackets is the kind.
MADE = re.compile(r"reference/(struct|class|union|namespace)\w+?(-members)?\.html$|reference/(dir_)[0-9a-f]+\.html$"
                  r"|reference/(functions|globals|namespacemembers)\w*\.html$|(source)-.*\.html$|reference/.*(_8[a-z]+(?:_source)?)\.html$")
TEXT = re.compile(r"(?!source-)[\w-]+\.html$")


class PageFile(html.parser.HTMLParser):
    """The names, links and images of a page that is not opened."""

    def __init__(self, path):
        super().__init__()
        self.ids, self.links, self.images, self.summary = set(), [], [], 0
        with open(path, encoding="utf-8") as file:
            self.feed(file.read())

    def handle_starttag(self, tag, attributes):
        has = dict(attributes)
        if tag == "div" and (self.summary or "summary" in (has.get("class") or "").split()):
            self.summary += 1
        self.ids |= {has[key] for key in ("id", "name") if has.get(key)}
        if tag == "a" and has.get("href") and not self.summary:
            self.links.append(has["href"])
        if tag == "img" and has.get("src"):
            self.images.append(has["src"])

    def handle_endtag(self, tag):
        if tag == "div" and self.summary:
            self.summary -= 1


def kind_of(page):
    """The kind of a page that is made by the hundred, or None."""
    match = MADE.match(page)
    return "".join(filter(None, match.groups())) if match else None


def chosen(pages):
    """The pages to open: all that are of no kind, and of every kind the first, the 17th, the 33rd and so on."""
    count, opened = {}, []
    for page in pages:
        kind = kind_of(page)
        if kind is None or count.setdefault(kind, 0) % EVERY == 0:
            opened.append(page)
        if kind is not None:
            count[kind] += 1
    return opened


class Check:
    """The pages of a folder, and what is wrong with them."""

    def __init__(self, folder):
        self.folder = folder
        self.bad, self.links, self.ids, self.formulas, self.images = set(), [], {}, 0, 0

    def open(self, browser, pages):
        """Opens pages, several at once."""
        left, failures, lock = queue.SimpleQueue(), [], threading.Lock()
        for page in pages:
            left.put(page)

        def work(tab):
            try:
                while True:
                    page = left.get_nowait()
                    found = tab.visit(page, PROBE)
                    narrow = TEXT.match(page) and self.too_wide(tab)
                    with lock:
                        self.bad |= tab.bad | ({(page, "wider than a window of 390 pixels")} if narrow else set())
                        self.note(page, json.loads(found or "null"))
            except queue.Empty:
                pass
            except Exception as failure:  # told in the main thread
                failures.append(failure)

        tabs = [Tab(browser, self.folder) for _ in range(min(TABS, len(pages)))]
        threads = [threading.Thread(target=work, args=(tab,)) for tab in tabs]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        if failures:
            raise failures[0]

    @staticmethod
    def too_wide(tab):
        """Whether the page is wider than a small screen."""
        call = tab.browser.call
        call("Emulation.setDeviceMetricsOverride", tab.session, width=390, height=844, deviceScaleFactor=1, mobile=False)
        wide = call("Runtime.evaluate", tab.session, expression=NARROW, awaitPromise=True, returnByValue=True)["result"].get("value")
        call("Emulation.clearDeviceMetricsOverride", tab.session)
        return wide

    def read(self, pages):
        """Reads pages without opening them."""
        for page in pages:
            file = PageFile(os.path.join(self.folder, page))
            self.ids[page] = file.ids
            self.links += [(page, link) for link in file.links]
            self.bad |= {(page, "image does not exist: " + image) for image in file.images
                         if not re.match("data:", image) and
                         not os.path.exists(os.path.join(self.folder, os.path.dirname(page), urllib.parse.unquote(image.partition("?")[0])))}

    def note(self, page, found):
        if not found:
            self.bad.add((page, "cannot be looked at"))
            return
        self.formulas += len(found["math"])
        self.images += len(found["images"])
        self.ids[page] = set(found["ids"])
        self.links += [(page, link) for link in found["links"]]
        self.bad |= {(page, "raw TeX or command in the text: " + t) for t in found["raw"]}
        self.bad |= {(page, "formula not shown: " + t) for t in found["left"]}
        self.bad |= {(page, "formula without width") for w in found["math"] if w <= 0}
        self.bad |= {(page, "a line begins with a comma: " + t) for t in found["commas"]}
        self.bad |= {(page, "cut off at 1280 pixels: " + t) for t in found["cut"]}
        self.bad |= {(page, "image does not load: " + src) for src, loaded, alt in found["images"] if not loaded}
        if found["wide"]:
            self.bad.add((page, "the page is wider than the window"))

    def check_links(self):
        for page, link in self.links:
            if re.match("(https?|mailto|javascript|doi):", link):
                continue
            path, _, anchor = link.partition("#")
            path, anchor = urllib.parse.unquote(path), urllib.parse.unquote(anchor)
            anchor = re.sub("^(live-[a-z_]+)&.*", r"\1", anchor)    # behind it stands the state of the figure
            path = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
            if not os.path.exists(os.path.join(self.folder, path)):
                self.bad.add((page, "dead link: " + link))
            elif anchor and path in self.ids and not anchor.startswith("index_") and anchor not in self.ids[path]:
                self.bad.add((page, "dead anchor: " + link))


def main():
    words = [word for word in sys.argv[1:] if word != "--all"]
    folder = os.path.abspath(words[0] if words else "build/book")
    word = words[1] if len(words) > 1 else "notation"
    program = chromium()
    if not program:
        sys.exit("check-docs.py: no chromium found, run: tools/setup.sh check")
    pages = sorted(os.path.join(inside, f) for inside in ("", "reference") if os.path.isdir(os.path.join(folder, inside))
                   for f in os.listdir(os.path.join(folder, inside)) if f.endswith(".html"))
    if "index.html" not in pages:
        sys.exit("check-docs.py: no pages in %s, run: make book" % folder)
    opened = pages if "--all" in sys.argv[1:] else chosen(pages)
    check = Check(folder)
    browser = Browser(program)
    try:
        check.open(browser, opened)
        check.read(sorted(set(pages) - set(opened)))
        check.check_links()
        tab = Tab(browser, folder)
        hits = tab.visit("index.html", SEARCH.replace("WORD", json.dumps(word))) or 0
        check.bad |= tab.bad
        if hits < 1:
            check.bad.add(("search", "'%s' is not found" % word))
    finally:
        browser.close()
    for page, what in sorted(check.bad):
        print(page + ": " + what)
    print("%d of %d pages opened, %d formulas, %d images, %d links, %d hits for '%s': %s" % (
        len(opened), len(pages), check.formulas, check.images, len(check.links), hits, word,
        "%d problems" % len(check.bad) if check.bad else "all fine"))
    sys.exit(1 if check.bad else 0)


main()
