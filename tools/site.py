#!/usr/bin/env python3
"""site.py BOOK SITE: copies the book from BOOK (build/book) to SITE, a folder that any web server or a memory stick serves, if nothing is
wrong with it: every link, picture, script and style leads to a file of the folder, and to an anchor where it names one; the HTML of
the pages is well formed, with a language, a title, unique ids, a text for every picture, headings in order, names for links and
controls; no path of the machine is in it; the first page, with all that it loads, is smaller than 500 kB, the engine not counted.
Files that pages do not lead to are left out.  The same book gives the same bytes.  Ends with status 1 and says what is wrong.
"""
import hashlib
import html.parser
import os
import re
import shutil
import sys
import urllib.parse
from pathlib import Path

LIMIT = 500000    # bytes of the first page
VOID = set("area base br col embed hr img input link meta source track wbr".split())
NO_END = {"p", "li", "td", "th", "tr", "dt", "dd", "thead", "tbody", "option"}    # Doxygen and HTML may leave their ends out
CONTROLS = ("input", "select", "textarea")
MACHINE = re.compile(rb"file:///|/(?:home|root|work|tmp|build|usr/(?:src|local))/[\w.+-]+/")
LOADED = ("engine.js", "seek.js", "contracts.js", "panels.js", "live.js")    # scripts that scripts load
TEXT = (".html", ".css", ".js", ".svg", ".txt")


class Page(html.parser.HTMLParser):
    """One page: what it leads to, its anchors, and what is wrong with it; `strict`: it is our own and not Doxygen's."""

    def __init__(self, text, strict):
        super().__init__()
        self.strict, self.bad, self.ids, self.links, self.loads, self.open, self.labels = strict, [], set(), [], [], [], set()
        self.level, self.heads, self.named, self.names, self.apart = 0, 0, [], [], 0
        self.labels = set(re.findall(r'<label[^>]* for="([^"]+)"', text))
        self.title = ""
        self.feed(text)
        self.close()
        self.bad += ["<%s> is not closed" % tag for tag in self.open if tag not in NO_END]
        if strict and self.heads != 1:
            self.bad.append("%d headings <h1>" % self.heads)
        if strict and not self.title.strip():
            self.bad.append("no title")

    def handle_starttag(self, tag, attributes):
        has = dict(attributes)
        if len(has) < len(attributes):
            self.bad.append("<%s> has an attribute twice" % tag)
        self.apart += tag == "template"
        self.reference(tag, has)
        if not self.apart:
            self.own(tag, has)
        if tag not in VOID:
            self.open.append(tag)
            if tag in ("a", "button") and ("href" in has or tag == "button"):
                self.named.append((len(self.open), has.get("aria-label") or has.get("title") or ""))

    def reference(self, tag, has):
        """Files and anchors."""
        for key in ("id", "name") if tag == "a" else ("id",):
            if has.get(key) and not self.apart:
                if key == "id" and has["id"] in self.ids and self.strict:
                    self.bad.append("an id twice: " + has["id"])
                self.ids.add(has[key])
        for key in ("href", "src", "data-source"):
            if has.get(key):
                self.links.append(has[key])
                if key == "src" and tag in ("img", "script") or tag == "link" and has.get("rel") == "stylesheet":
                    self.loads.append(has[key])

    def own(self, tag, has):
        """What readers with another browser need."""
        if tag == "html" and self.strict and not has.get("lang"):
            self.bad.append("no lang")
        if tag == "img":
            if "alt" not in has and self.strict:
                self.bad.append("no alt: " + (has.get("src") or ""))
            self.named = [(depth, words + (has.get("alt") or "")) for depth, words in self.named]
        if tag in CONTROLS and self.strict and has.get("type") != "hidden" and not (
                has.get("aria-label") or has.get("id") in self.labels or "label" in self.open):
            self.bad.append("no label: <%s id=%s>" % (tag, has.get("id")))
        if self.strict and re.fullmatch("h[1-6]", tag):
            level = int(tag[1])
            self.heads += level == 1
            if self.level and level > self.level + 1 and "nav" not in self.open:
                self.bad.append("<h%d> after <h%d>" % (level, self.level))
            self.level = level if "nav" not in self.open else self.level

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        if tag not in VOID:
            self.handle_endtag(tag)

    def handle_endtag(self, tag):
        self.apart -= tag == "template"
        if tag in VOID:
            return
        while self.open and self.open[-1] != tag and self.open[-1] in NO_END and tag in self.open:
            self.open.pop()
        if not self.open or self.open[-1] != tag:
            if tag not in NO_END or self.strict:
                self.bad.append("</%s> where <%s> is open" % (tag, self.open[-1] if self.open else "nothing"))
            return
        if self.named and self.named[-1][0] == len(self.open) and tag in ("a", "button"):
            if not self.named.pop()[1].strip() and self.strict and not self.apart:
                self.bad.append("<%s> without a name" % tag)
        self.open.pop()

    def handle_data(self, data):
        self.named = [(depth, words + data) for depth, words in self.named]
        if self.open and self.open[-1] == "title" and "svg" not in self.open:
            self.title += data


class Site:
    """The files of a book, and what is wrong."""

    def __init__(self, book):
        self.book, self.bad = book, []
        self.files = sorted(str(file.relative_to(book)) for file in book.rglob("*") if file.is_file())
        self.pages = {name: Page((book / name).read_text(encoding="utf-8"), "/" not in name)
                      for name in self.files if name.endswith(".html")}
        self.wanted = {"index.html"} | {name for name in self.files if name in LOADED or name.startswith(("fonts/", "reference/"))}

    def complain(self, where, what):
        self.bad.append("%s: %s" % (where, what))

    def check(self):
        there = set(self.files)
        for name, page in self.pages.items():
            for what in sorted(set(page.bad)):
                self.complain(name, what)
            for url in sorted(set(page.links)):
                if re.match(r"(https?|mailto|doi|javascript|data):", url):
                    continue
                path, _, anchor = url.partition("#")
                path, anchor = urllib.parse.unquote(path.partition("?")[0]), urllib.parse.unquote(anchor)
                to = os.path.normpath(os.path.join(os.path.dirname(name), path)) if path else name
                if to not in there:
                    self.complain(name, "dead link: " + url)
                elif anchor and to in self.pages and not anchor.startswith("index_") and anchor not in self.pages[to].ids:
                    self.complain(name, "dead anchor: " + url)
                else:
                    self.wanted.add(to)
        for name in self.files:
            found = MACHINE.search((self.book / name).read_bytes()) if name.endswith(TEXT) else None
            if found:
                self.complain(name, "a path of the machine: " + found[0].decode("utf-8", "replace"))
        size = self.start()
        if size >= LIMIT:
            self.complain("index.html", "%d bytes with all that it loads, %d allowed" % (size, LIMIT))
        return size

    def start(self):
        """Bytes of the first page and all that it loads before the engine."""
        if "index.html" not in self.pages:
            self.complain("index.html", "there is none")
            return 0
        return sum((self.book / name).stat().st_size for name in {"index.html", *self.pages["index.html"].loads} & set(self.files))

    def copy(self, to):
        shutil.rmtree(to, ignore_errors=True)
        names, sum_of_all = [name for name in self.files if name in self.wanted or name in self.pages], hashlib.sha256()
        for name in names:
            (to / name).parent.mkdir(parents=True, exist_ok=True)
            data = (self.book / name).read_bytes()
            (to / name).write_bytes(data)
            sum_of_all.update(name.encode() + b"\0" + data)
        return len(names), sum_of_all.hexdigest()[:16]


def main():
    book, to = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    if to == book or to in book.parents or book in to.parents or (to.exists() and any(to.iterdir()) and not (to / "index.html").is_file()):
        sys.exit("site.py: %s is no folder of a site: name a new or an empty one" % to)
    site = Site(book)
    size = site.check()
    for line in site.bad[:200]:
        print(line, file=sys.stderr)
    if site.bad:
        sys.exit("site.py: %d problems, nothing copied" % len(site.bad))
    count, key = site.copy(to)
    print("%d files, %d pages, first page %d kB before the engine%s, sum %s" % (
        count, len(site.pages), round(size / 1000), "" if (to / "engine.js").is_file() else " (there is none)", key))


main()
