"""frame.py: what is around a text: head of the page, side bar, previous and next; and the cover."""
import html
import re

from blocks import Text
from inline import Inline
from references import templates
from tex import escaped

PAGE = """<!DOCTYPE html>
<html lang="en"%(engine)s><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>%(title)s · Signorini</title><meta name="color-scheme" content="light dark">
<link rel="stylesheet" href="page.css">%(formulas)s%(style)s
<script src="page.js"></script><script src="peek.js" defer></script><script src="find.js" defer></script>
%(script)s</head><body class="%(kind)s">
<a class="skip" href="#book-text">to the text</a><div id="book-progress" aria-hidden="true"></div>
<header id="book-bar"><button id="book-menu" aria-expanded="false" aria-controls="book-side">Contents</button>\
<a class="home" href="index.html">Signorini</a>\
<button id="book-tone" title="light or dark"></button></header>
<nav id="book-side" aria-label="Contents"><div class="top"><a class="home" href="index.html">Signorini<small>a book that runs</small></a>
<search id="book-seek"><input id="book-find" type="search" placeholder="search all pages" aria-label="search all pages" autocomplete="off">\
</search></div>
<p id="book-count" role="status"></p><ol id="book-hits" aria-label="places found"></ol>%(side)s</nav>
<main id="book-text">%(main)s</main>
%(previews)s</body></html>
"""

LIVE_SCRIPTS = '<script src="panels.js" defer></script><script src="live.js" defer></script>'


def numbered(title):
    """'6 A cantilever' as number and words."""
    m = re.match(r"(\d+) (.*)", title)
    return (m[1], m[2]) if m else ("", title)


class Side:
    """The side bar of one page."""

    def __init__(self, book, page, sections):
        self.book, self.page, self.sections = book, page, sections
        self.own = "chapter-" + page[9:11] if page.startswith("exercise") else page

    def entry(self, name, words=None):
        number, title = numbered(words or self.book.title[name])
        shown = ("<i>%s</i> " % number if number else "") + escaped(title)
        here = name == self.page
        inner = "".join('<li><a href="#%s">%s</a></li>' % (anchor, said) for anchor, said in self.sections) if here else ""
        return '<li%s><a href="%s.html"%s>%s</a>%s</li>' % (
            ' class="now"' if name == self.own else "", name, ' aria-current="page"' if here else "", shown,
            "<ol>%s</ol>" % inner if inner else "")

    def html(self):
        book, out = self.book, ""
        for title, _ in book.parts:
            names = [name for name in book.chapters if book.part_of(name) == title]
            out += section(title, [self.entry(name) for name in names])
        out += section("Reading the library", [self.entry(name, words_of_evening(book, name)) for name in book.evenings])
        entries = [self.entry(book.page[path], words) for path, words in book.use if path in book.page]
        entries.append(self.entry("slides", "Slides"))
        if book.reference:
            entries.append('<li><a href="reference/index.html">Reference of src/</a></li>')
        return out + section("Use", entries)


def words_of_evening(book, name):
    m = re.match(r"Evening (\d+): (.*)", book.title[name])
    return "%s %s" % m.groups() if m else "All pages, in order"


def section(title, entries):
    return "<section><h2>%s</h2><ol>%s</ol></section>" % (escaped(title), "".join(entries)) if entries else ""


def reading_order(book):
    """Pages with a page before and after them."""
    return [book.chapters, book.evenings, [book.sources[path] for path in book.order]]


def turn(book, page):
    """Previous and next."""
    if page.startswith("exercise"):
        chapter = "chapter-" + page[9:11]
        anchor = "#exercises" if re.search("^## Exercises$", book.text[chapter], re.M) else ""
        others = sorted((name for name in book.text if name.startswith(page[:12])), key=lambda name: int(name[12:]))
        after = others[others.index(page) + 1:][:1]
        return '<nav class="turn"><a class="prev" href="%s.html%s"><small>← back to</small>%s</a>%s</nav>' % (
            chapter, anchor, escaped(book.title[chapter]), step(book, after[0], "next", "next →") if after else "")
    for names in reading_order(book):
        if page in names:
            k = names.index(page)
            before = step(book, names[k - 1], "prev", "← before") if k else "<span></span>"
            after = step(book, names[k + 1], "next", "next →") if k + 1 < len(names) else ""
            return '<nav class="turn" aria-label="before and after">%s%s</nav>' % (before, after)
    return ""


def step(book, name, kind, words):
    return '<a class="%s" href="%s.html"><small>%s</small>%s</a>' % (kind, name, words, escaped(book.title[name]))


def formula_sheet(shown):
    """The face of formulas, for a page that shows some, or previews of functions, which may have some."""
    return '<link rel="stylesheet" href="formula.css">' if re.search('<math|href="source-[^"]*#', shown) else ""


def write(book, page, title, main, text=None, kind=None):
    """A whole page."""
    has_live = 'class="live"' in main
    previews = templates(text.refer.previews) if text else ""
    words = {"engine": " data-engine" if book.engine else "", "title": escaped(re.sub(r"[`$*]", "", title)), "main": main,
             "formulas": formula_sheet(main + previews), "style": '<link rel="stylesheet" href="live.css">' if has_live else "",
             "script": LIVE_SCRIPTS if has_live else "", "kind": kind or html.escape(page.split("-")[0]),
             "side": Side(book, page, [s for s in text.sections if s[0] != "exercises"] if text else []).html(),
             "previews": previews}
    (book.out / (page + ".html")).write_text(PAGE % words, encoding="utf-8")
    book.seek.add(page, title, main)


def write_text(book, page, text):
    """The page of a text."""
    title, body = book.title[page], text.blocks(book.text[page].split("\n"))
    number, words = numbered(title)
    above = escaped(book.part_of(page)) if page.startswith("chapter") else ""
    m = re.match(r"(Exercise [\d.]+) - (.*)", title)
    if m:
        above, words = m.groups()
    head = '<header class="title"><p>%s</p><h1>%s%s</h1></header>' % (
        above, "<span>%s</span> " % number if number else "", text.html(words, False))
    write(book, page, title, head + body + turn(book, page), text)


def shown_by(book, name):
    """What a chapter shows, from its line in chapters/README.md, or the first sentence of the chapter."""
    link = re.escape("](%s)" % book.path[name].removeprefix("chapters/"))
    m = re.search(r"^\|.*?%s.*\| (.*?) \|$" % link, book.text.get("ways", ""), re.M)
    told = re.search(r"^\*\*What you will learn\.?\*\* (.*?[.;:])(?= |$)", re.sub(r"(?<!\n)\n(?!\n)", " ", book.text[name]), re.M)
    return Inline(book, "ways" if m else name).html(m[1] if m else told[1] if told else "", False)


def live_figure(book, use):
    """The live figure that the first text names, with the printed one, as they stand in its chapter."""
    mark = re.search(r"^<!-- live \w+ -->$", use, re.M)
    for name in book.chapters if mark else ():
        m = re.search(re.escape(mark[0]) + r"\n+!\[.*$", book.text[name], re.M)
        if m:
            return Text(book, name).blocks(m[0].split("\n"))
    return ""


def write_cover(book, text):
    """The first page: what this is, its picture, and the chapters by parts."""
    body, use = "", book.text.get("use", "")
    picture = re.search(r"^!\[(.*)\]\((\S+)\)", use, re.M)
    lead = re.search(r"\n\n(?!!|<|#|\|)(\w.*?)\n\n", use, re.S)
    first = live_figure(book, use)
    if first:
        body += first
    elif picture:
        body += '<figure class="picture title-picture">%s<figcaption>%s</figcaption></figure>' % (
            book.picture("use", picture[2], html.escape(picture[1]))[0], text.html(picture[1], False))
    if lead:
        body += '<p class="lead">%s</p>' % text.html(" ".join(lead[1].split()), False)
    for title, _ in book.parts:
        rows = ""
        for name in (n for n in book.chapters if book.part_of(n) == title):
            number, words = numbered(book.title[name])
            rows += '<li><a href="%s.html"><i>%s</i><b>%s</b></a><span>%s</span></li>' % (
                name, number, escaped(words), shown_by(book, name))
        body += '<section class="part"><h2>%s</h2><ol>%s</ol></section>' % (escaped(title), rows) if rows else ""
    rows = "".join('<li><a href="%s.html"><i>%s</i><b>%s</b></a><span>%s</span></li>' % (
        name, *numbered(words_of_evening(book, name)), text.html(" ".join(book.text[name].split("\n\n")[1].split()), False))
        for name in book.evenings[1:])
    body += '<section class="part"><h2>Reading the library</h2><ol>%s</ol></section>' % rows if rows else ""
    head = '<header class="title"><h1>Signorini</h1></header>'
    main = re.sub(r"<math><mi>(\w)</mi></math>", r"<em>\1</em>", head + body)    # a letter needs no face of formulas
    write(book, "index", "a book that runs", main, text, "cover")
