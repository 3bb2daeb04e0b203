"""decks.py: a deck of slides per chapter, slides-06.html, and the list of all by lectures, slides.html.

cut.py says what goes to slides; here it is laid out, 1280 x 720 pixels each.  The lectures are those of docs/teaching.md: a chapter
that two lectures share is divided after the section that its line names.
"""
import html
import re

import frame
from blocks import Text
from cut import Cut
from pieces import cells_of
from tex import escaped

ROOM = 545    # pixels below the heading
ALONE = ("figure", "computed", "box open", "box misprint", "box verdict", "predict", "answer", "listing")
WITH_WORDS = ("figure", "listing")
FEW = 120     # pixels of words that a figure has room for

DECK = """<!DOCTYPE html>
<html lang="en"%(engine)s><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<title>Slides: %(title)s · Signorini</title><meta name="color-scheme" content="light dark">
<link rel="stylesheet" href="page.css"><link rel="stylesheet" href="formula.css"><link rel="stylesheet" href="live.css">
<link rel="stylesheet" href="slides.css"><script src="slides.js"></script>%(script)s</head><body class="deck">
<main id="deck">%(slides)s</main>
<nav id="deck-bar" aria-label="slides"><button id="deck-back" aria-label="slide before">←</button><span id="deck-at" role="status">1</span>\
<button id="deck-on" aria-label="next slide">→</button><a href="%(page)s.html">chapter</a><a href="slides.html">all slides</a></nav>
</body></html>
"""


class Lecture:
    """A line of the plan: number, chapter, the section that it ends with, and what is said to the lecturer."""

    def __init__(self, book, row):
        cells = cells_of(row)
        m = re.match(r"\[\d+\]\(\.\./(chapters/[^)]+)\)(?:, to \*([^*]+)\*)?", cells[1])
        self.number, self.page, self.until = cells[0], book.page.get(m[1] if m else "", ""), m[2] if m else None
        self.board, self.room, self.ask = cells[2:5]


def lectures(book):
    """The lectures of the plan, in order."""
    rows = re.findall(r"^\| \d+ \| \[\d+\]\(.*\|$", book.text.get("teaching", "").split("\n## ", 2)[1] if "\n## " in
                      book.text.get("teaching", "") else "", re.M)
    return [Lecture(book, row) for row in rows]


class Deck:
    """The slides of one chapter."""

    def __init__(self, book, page, plan):
        self.book, self.page, self.slides = book, page, []
        self.plan = [lecture for lecture in plan if lecture.page == page]
        self.text = Text(book, "teaching") if "teaching" in book.text else None
        self.lay_out(Cut(book, page).cut())

    def slide(self, kind, head, inside, anchor="", name=""):
        self.slides.append((kind, head, self.outside(inside), anchor, name))

    def outside(self, inside):
        """Links within the chapter lead to the chapter; no anchor is there twice."""
        inside = re.sub(r' id="(?!live-)[^"]*"', "", inside)
        inside = re.sub(r'<a class="self".*?</a>', "", inside)
        return re.sub(r'href="#', 'href="%s.html#' % self.page, inside)

    def lay_out(self, parts):
        number, words = frame.numbered(self.book.title[self.page])
        weeks = " and ".join(lecture.number for lecture in self.plan)
        self.slide("title", "", '<p>%s</p><h1>%s%s</h1>%s' % (
            escaped(self.book.part_of(self.page)), "<span>%s</span> " % number if number else "", escaped(words),
            "<p>lecture%s %s</p>" % ("s" if len(self.plan) > 1 else "", weeks) if weeks else ""))
        begins = self.begins(parts)
        for k, (head, anchor, pieces) in enumerate(parts):
            for lecture in begins.get(k, ()):
                self.lecture(lecture)
            self.section(head, anchor, pieces)

    def begins(self, parts):
        """Part -> the lectures that begin with it: the first before the first heading, another behind the section that ends one."""
        heads, found = [head for head, _, _ in parts], {}
        k = next((k for k, (_, anchor, _) in enumerate(parts) if anchor), 0)
        for lecture in self.plan:
            found.setdefault(k, []).append(lecture)
            if lecture.until in heads:
                k = heads.index(lecture.until) + 1
            elif lecture.until:
                self.book.complain("docs/teaching.md", "lecture %s: %s has no section %s" % (
                    lecture.number, self.book.path[self.page], lecture.until))
        return found

    def lecture(self, lecture):
        """What the plan says of a lecture: the question is asked before the program answers it."""
        said = "".join("<dt>%s</dt><dd>%s</dd>" % (words, self.text.html(what, False)) for words, what in (
            ("at the board", lecture.board), ("in the room", lecture.room), ("before it runs", lecture.ask)))
        self.slide("lecture", "Lecture %s" % lecture.number, "<dl>%s</dl>" % said, "", "lecture-" + lecture.number)

    def section(self, head, anchor, pieces):
        """Sentences, formulas and tables share slides; everything else has one of its own, and some words if they are few."""
        sheet, high, free = [], 0, -1
        for piece in pieces:
            alone, few = piece.kind in ALONE, high + piece.high <= (ROOM if piece.kind == "listing" else FEW)
            if alone and sheet and piece.kind in WITH_WORDS and few:
                self.slide(piece.kind, head, "".join(sheet) + piece.html, anchor)
                sheet, high = [], 0
                continue
            if sheet and (alone or high + piece.high > ROOM):
                self.sheet(head, sheet, high, anchor, free)
                sheet, high, free = [], 0, -1
            if alone:
                free = len(self.slides) if piece.kind == "figure" else -1
                self.slide(piece.kind, piece.head or head, piece.html, anchor)
            else:
                sheet.append(piece.html)
                high += piece.high
        self.sheet(head, sheet, high, anchor, free)

    def sheet(self, head, pieces, high, anchor, free):
        """A slide of some pieces; few words go to the figure before them, slide `free`, if that has none."""
        if pieces and free >= 0 and high <= FEW:
            kind, head, inside, anchor, name = self.slides[free]
            self.slides[free] = (kind, head, self.outside("".join(pieces)) + inside, anchor, name)
        elif pieces:
            self.slide("points", head, "".join(pieces), anchor)

    def html(self):
        out, heads = "", Text(self.book, self.page)
        title = escaped(self.book.title[self.page])
        for k, (kind, head, inside, anchor, name) in enumerate(self.slides, 1):
            shown = "<h2>%s</h2>" % heads.html(head, False) if head else "" if kind == "title" else '<h2 class="none">%s</h2>' % title
            to = self.page + ".html" + ("#" + anchor if anchor else "")
            out += '<section class="slide %s" id="%s" aria-label="slide %d of %d">%s<div class="inside">%s</div>' \
                '<footer><a href="%s">%s</a><span>%d</span></footer></section>\n' % (
                    kind, name or "s%d" % k, k, len(self.slides), shown, inside, to, title, k)
        return out

    def write(self):
        has_live = 'class="live"' in "".join(slide[2] for slide in self.slides)
        words = {"engine": " data-engine" if self.book.engine else "", "title": escaped(re.sub(r"[`$*]", "", self.book.title[self.page])),
                 "script": frame.LIVE_SCRIPTS if has_live else "", "slides": self.html(),
                 "page": html.escape(self.page)}
        (self.book.out / name_of(self.page)).write_text(DECK % words, encoding="utf-8")


def name_of(page):
    return "slides-" + page[8:] + ".html"


def write_all(book):
    """The decks and their list."""
    plan, sizes = lectures(book), {}
    for page in book.chapters:
        deck = Deck(book, page, plan)
        deck.write()
        sizes[page] = len(deck.slides)
    text = Text(book, "teaching" if "teaching" in book.text else "use")
    rows = "".join('<tr><td class="num">%s</td><td><a href="%s#lecture-%s">%s</a></td><td>%s</td></tr>' % (
        one.number, name_of(one.page), one.number, text.html(book.title[one.page], False), text.html(one.ask, False)) for one in plan)
    body = '<header class="title"><p>Use</p><h1>Slides</h1></header><p>A deck for each chapter, cut from its text: →, ← and the ' \
        'space bar turn, f fills the screen, and a print has one slide a page.</p>'
    if rows:
        body += '<h2 id="lectures">By lectures</h2><div class="table wide"><table><thead><tr><th class="num">lecture</th><th>slides</th>' \
            '<th>ask before it runs</th></tr></thead><tbody>%s</tbody></table></div>' % rows
    body += '<h2 id="chapters">By chapters</h2><ul>%s</ul>' % "".join('<li><a href="%s">%s</a>, %d slides</li>' % (
        name_of(page), text.html(book.title[page], False), sizes[page]) for page in book.chapters)
    frame.write(book, "slides", "Slides", body)
