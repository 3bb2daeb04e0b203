"""references.py: what a text says of equations, figures, chapters, exercises, words and functions becomes links with previews.

A preview is what the link leads to, and travels in the page: pages that are read from disk may fetch nothing.  Previews of functions
are many and lie in a script of their own, which page.js loads when the first is asked for.
"""
import html
import re

import cxx
from inline import LINK, Inline, anchor_of
from tex import escaped

EQUATION = re.compile(r"(?<![\w)\0])\((?:([A-Z])[ \u00a0])?(\d{1,2}|[a-z])\)(?!\w)")
FIGURE = re.compile(r"\b((?:[Ff]igures? |(?<=\d and )|(?<=\d, )|(?<=\d–)))(\d{1,2}\.\d+)\b(?!\.\d)")
PLACE = re.compile(r"\b([Cc]hapter|[Ee]xercise)(s?[ \u00a0])"
                   r"(\d{1,2}(?:\.\d+)?(?:(?:, | and |, and | or |–| to )\d{1,2}(?:\.\d+)?)*)\b(?!\.\d)")


class References:
    """The references of one page, and the previews that they need."""

    def __init__(self, book, page):
        self.book, self.page, self.previews, self.seen = book, page, {}, set()
        self.in_book = bool(re.match("(chapter|exercise)-", page))

    def plain(self, text):
        """Another text's words, for a preview: without its links."""
        return Inline(self.book, self.page).html(LINK.sub(r"\1", text), False)

    def preview(self, href, inside):
        if href not in self.previews:
            self.previews[href] = ""    # its own references need none
            self.previews[href] = inside()
        return href

    def linked(self, href):
        """A link that the text has itself."""
        page, _, key = href.partition("#")
        name = page[:-5] or self.page
        if name == "references" and key in self.book.entry:
            self.preview(href, lambda: "<p>%s</p>" % self.plain(" ".join(self.book.entry[key].split())))
        elif key.startswith("eq-") and (self.book.chapter_of(name), key[3:]) in self.book.equation:
            self.preview(href, lambda: self.of_equation(self.book.equation[self.book.chapter_of(name), key[3:]], key[3:]))
        elif key.startswith("fig-") and key[4:].replace("-", ".") in self.book.figure:
            self.preview(href, lambda: self.of_figure(key[4:].replace("-", ".")))
        elif not key and self.book.chapter_of(name) is not None and name != self.page and name in self.book.text:
            self.preview(href, lambda: self.of_text(name))

    def of_text(self, name):
        """Title and beginning of a chapter or an exercise."""
        text = re.sub(r"<!-- nav -->.*?<!-- /nav -->", "", self.book.text[name], flags=re.S)
        paragraphs = [p for p in re.split(r"\n\n+", text) if re.match(r"[\w*\"]", p)]
        told = " ".join(" ".join(paragraphs[:2 if name.startswith("exercise") else 1]).split())
        if len(told) > 420:
            told = re.match(r".{0,420}[.;](?= )|.{0,420} ", told)[0] + " …"
        return '<p class="where">%s</p><p>%s</p>' % (self.plain(self.book.title[name]), self.plain(told))

    def of_equation(self, equation, number):
        name, tex = equation
        return '<p class="where">(%s), %s</p>%s' % (number, escaped(self.book.title[name]), Inline(self.book, name).math(tex, True)[0])

    def of_figure(self, number):
        name, words, url = self.book.figure[number]
        return self.book.picture(name, url, "")[0] + "<p>%s</p>" % self.plain(words)

    def place(self, name, anchor):
        return ("" if name == self.page else name + ".html") + "#" + anchor

    def equation(self, m, keep):
        """(12) in a chapter or its programs, (A 12) everywhere."""
        known = m[1] in [letter for letter, _, _ in self.book.papers] if m[1] else self.book.chapter_of(self.page) is not None
        if not known:
            return m[0]
        found = self.book.find_equation(self.page, m[2], m[1])
        if not found:
            if (self.in_book or m[1]) and not m[2].isalpha():
                self.book.complain(self.book.path.get(self.page, self.page), "no equation %s" % m[0].replace("\u00a0", " "))
            return m[0]
        href = self.place(found[0], "eq-" + m[2])
        self.preview(href, lambda: self.of_equation(found, m[2]))
        return keep('<a class="ref" href="%s">%s</a>' % (href, m[0]))

    def figure(self, m, keep, before):
        if not m[1] and "igures" not in before[-40:]:
            return m[0]
        if m[2] not in self.book.figure:
            self.book.complain(self.book.path[self.page], "no figure " + m[2])
            return m[0]
        href = self.place(self.book.figure[m[2]][0], "fig-" + m[2].replace(".", "-"))
        self.preview(href, lambda: self.of_figure(m[2]))
        return keep('<a class="ref" href="%s">' % href) + m[1] + m[2] + keep("</a>")

    def text_link(self, words, chapter, exercise, keep):
        """A chapter or an exercise, if there is one and it is not this page."""
        name = "exercise-%02d-%s" % (int(chapter), exercise) if exercise else "chapter-%02d" % int(chapter)
        if name not in self.book.text or name == self.page:
            return None
        self.preview(name + ".html", lambda: self.of_text(name))
        return keep('<a class="ref" href="%s.html">' % name) + words + keep("</a>")

    def named_place(self, m, keep):
        """'chapter 3', 'exercises 4.1 and 4.3': the first number is linked with its word, the others alone."""
        first, *others = re.split(r"(?<=\d)(?=, | and | or |–| to )", m[3])
        if m[2][0] != "s":
            others, rest = [], "".join(others)
        else:
            rest = ""
        shown = self.one_place(m[1], m[1] + m[2], first, keep)
        for other in others:
            joint, number = re.match(r"(\D+)(.*)", other).groups()
            shown += joint + self.one_place(m[1], "", number, keep)
        return shown + rest

    def one_place(self, kind, words, said, keep):
        chapter, _, exercise = said.partition(".")
        if bool(exercise) != (kind[0] in "eE"):
            return words + said
        return self.text_link(words + said, chapter, exercise, keep) or words + said

    def function(self, said):
        """Where the contract of a function or a type stands that code in a text names, or None."""
        m = re.fullmatch(r"(?:signorini::)?(\w+)(\(\))?", said)
        if not m or not (m[2] or "_" in m[1] or re.match("[A-Z][a-z]", m[1])):
            return None
        return cxx.linker(self.book)(m[1], "", "(")

    def gloss(self, text, keep):
        for word, means, look in glossary(self.book):
            if word in self.seen:
                continue

            def link(m, word=word, means=means):
                self.seen.add(word)
                href = "glossary.html#" + anchor_of(word)
                self.preview(href, lambda: "<p><strong>%s</strong>: %s</p>" % (escaped(word), self.plain(means)))
                return keep('<a class="gloss" href="%s">%s</a>' % (href, m[0]))
            text = look.sub(link, text, count=1)
        return text

    def references(self, text, keep):
        text = EQUATION.sub(lambda m: self.equation(m, keep), text)
        if self.in_book or self.page.startswith(("src/", "chapters/", "evening", "use", "notation")):
            text = FIGURE.sub(lambda m: self.figure(m, keep, text[:m.start()]), text)
            text = PLACE.sub(lambda m: self.named_place(m, keep), text)
        if self.page.startswith("chapter-"):
            text = self.gloss(text, keep)
        return text


def glossary(book):
    """Words that are linked where they come first: "normal" alone has other meanings, "normal cone" has none."""
    if not hasattr(book, "looks"):
        book.looks = [(word, means, re.compile(r"(?<![\w\0*-])%ss?(?![\w*-])" % re.escape(escaped(word)), re.I))
                      for word, means in sorted(book.words.items(), key=lambda w: -len(w[0])) if len(word) >= 9 or " " in word]
    return book.looks


def templates(previews):
    """The previews of a page as elements that nobody sees."""
    return "".join('<template data-for="%s">%s</template>' % (html.escape(href), inside) for href, inside in previews.items() if inside)
