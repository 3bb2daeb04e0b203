#!/usr/bin/env python3
"""book.py ROOT OUT [TAGS]: the pages of the book from the texts and sources of ROOT, as static HTML that works from disk.

    tex.py       formulas, as MathML                    blocks.py    a text, block by block
    shelf.py     what there is and can be pointed at    pieces.py    figures, listings, tables, boxes
    inline.py    a paragraph                            sources.py   a source as a page, prose beside code
    references.py  links with previews                  evenings.py  the order in which the library is read
    cxx.py       names in code                          contracts.py previews of functions; copies for Doxygen
    frame.py     side bar, cover, previous and next     seek.py      full-text search
    cut.py       what of a chapter goes to slides       decks.py     the slides

Needs Python 3, and Perl for what functions lead to (tools/evenings.pl).  TAGS is the tag file of the reference that Doxygen made in
OUT/reference; figures compute if OUT has an engine.js.  Ends with status 1 and says why if a formula cannot be read, or a link, an
equation "(n)" or a figure that a text names does not exist.
"""
import base64
import re
import shutil
import sys
import xml.etree.ElementTree
from pathlib import Path

sys.dont_write_bytecode = True    # no __pycache__ beside the tools

import contracts
import decks
import evenings
import frame
import sources
from blocks import Text
from seek import Seek
from shelf import Book


def reference_pages(tags):
    """path -> page of the reference, from Doxygen's tag file."""
    found = {}
    for file in xml.etree.ElementTree.parse(tags).getroot().iter("compound"):
        if file.get("kind") == "file":
            path = (file.findtext("path") or "") + file.findtext("name")
            name = file.findtext("filename")
            found[path[path.index("src/"):] if "src/" in path else path] = name if name.endswith(".html") else name + ".html"
    return found


def rooms(file):
    """Figure -> its height at 1280 and at 390 pixels, measured by tools/check-live.py."""
    lines = [line.split() for line in file.read_text(encoding="utf-8").splitlines() if line and not line.startswith("#")]
    return {name: (int(wide), int(narrow)) for name, wide, narrow in lines}


def copy(book):
    """What pages are made of, and the files that they link to."""
    docs = book.root / "docs"
    for path in book.copied:
        to = book.out / "files" / (path + ("" if Path(path).suffix in (".svg", ".png") else ".txt"))
        to.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(book.root / path, to)
    for name in ("page.js", "peek.js", "find.js", "panels.js", "live.js", "live.css", "slides.js", "slides.css"):
        shutil.copyfile(docs / name, book.out / name)

    def data(m):    # the faces travel in the style sheet: they do not come late, and nothing moves
        return "url(data:font/woff2;base64,%s)" % base64.b64encode((docs / m[1]).read_bytes()).decode()
    for name in ("page.css", "formula.css"):
        sheet = re.sub(r"url\((fonts/[\w-]+\.woff2)\)", data, (docs / name).read_text(encoding="utf-8"))
        (book.out / name).write_text(sheet, encoding="utf-8")
    shutil.copytree(docs / "fonts", book.out / "fonts", dirs_exist_ok=True, ignore=shutil.ignore_patterns("*.woff2", "*.sh"))


def check_shape(book, name, text):
    """No link stands within a link, no anchor twice."""
    ends = re.findall(r"<(/?)a\b", text)
    if ends != ["", "/"] * (len(ends) // 2):
        book.complain(name, "a link within a link")
    body, seen = text.split("<template", 1)[0], set()
    for anchor in re.findall(r'\bid="([^"]+)"', body):
        if anchor in seen:
            book.complain(name, "an anchor twice: " + anchor)
        seen.add(anchor)


def check_links(book):
    """Every link, picture and script of every page leads to something; their number."""
    pages = {file.name: file.read_text(encoding="utf-8") for file in book.out.glob("*.html")}
    there = {str(file.relative_to(book.out)) for file in book.out.rglob("*")}
    anchors = {name: set(re.findall(r'\bid="([^"]+)"', text)) for name, text in pages.items()}
    count = 0
    for name, text in pages.items():
        check_shape(book, name, text)
        for url in set(re.findall(r'(?:href|src|data-source)="([^"]+)"', text)):
            path, _, anchor = url.partition("#")
            count += 1
            if re.match(r"\w+:", url):
                continue
            if path and path not in there:
                book.complain(name, "dead link: " + url)
            elif anchor and anchor not in anchors.get(path or name, {anchor}):
                book.complain(name, "dead anchor: " + url)
    return len(pages), count


def main():
    root, out = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    out.mkdir(parents=True, exist_ok=True)
    book = Book(root, out)
    book.seek = Seek()
    book.engine = (out / "engine.js").is_file()
    book.rooms = rooms(root / "docs/rooms")
    book.reference = reference_pages(sys.argv[3]) if len(sys.argv) > 3 else {}
    evenings.add(book)
    evenings.read_leads(book)
    for page in list(book.text):
        frame.write_text(book, page, Text(book, page))
    frame.write_cover(book, Text(book, "use"))
    decks.write_all(book)
    functions = contracts.previews(book)
    (out / "contracts.js").write_text(functions, encoding="utf-8")
    sources.write_all(book)
    book.seek.write(out, contracts.places(book))
    copy(book)
    pages, links = check_links(book)
    for where, what in sorted(book.complaints):
        print("%s: error: %s" % (where, what), file=sys.stderr)
    print("%d pages, %d links, %d complaints" % (pages, links, len(book.complaints)))
    sys.exit(1 if book.complaints else 0)


if __name__ == "__main__":
    main()
