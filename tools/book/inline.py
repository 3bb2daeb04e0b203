"""inline.py: one paragraph of Markdown as HTML: formulas, code, links, emphasis; numbers and signs as a printer sets them.

What is finished is kept aside, with a mark in its place, so that no later rule reads it again.
"""
import re

import cxx
from shelf import slug
from tex import FormulaError, escaped, formula

CODE = re.compile(r"(?<!`)(`+)(?!`)(.+?)(?<!`)\1(?!`)")
TICKED = re.compile(r"\$`(.+?)`\$")
DOLLARS = re.compile(r"(?<![\\\w$])\$(?![\s$])((?:\\.|[^\\$])*?(?:\\.|[^\\$\s]))\$(?![\w$])")
LINK = re.compile(r"(?<!!)\[((?:[^\[\]]|\[[^\]]*\])+)\]\(((?:[^()\s]|\([^()\s]*\))+)\)")
TAG = re.compile(r"</?(?:sub|sup|br|kbd|em|b|i)\b[^>]*>")
SET = re.compile(r"<!-- set (\w+) ([\w=. -]+?) -->(.*?)<!-- /set -->")
UNIT = re.compile(r"(?<=[\d\0]) (?=(?:[kM]?N|[ckµ]?m|mm|[MG]Pa|%|ms|s|MB|GB|°)(?:[/²\s.,;:)]|$))")
PAPER = re.compile(r"\\PaperEq\{\s*(\w+)\s*,\s*([^}]*?)\s*\}")
SAME_PAPER = re.compile(r"\\PaperEq\{(\w+), *([^}]*)\}, \\PaperEq\{\1, *")
ENTRY = re.compile(r"\[\\ref (\w+)\]")
WIDE_FORMULA = 28    # signs
MARK = re.compile(r"\0(\d+)\0")
# A formula and the signs that may not stand alone at the begin of a line, or at the end of one.
STUCK = re.compile(r"([(\[±−“]*)(\0\d+\0)((?:\u00a0[\w/²%]+)?(?:’s|[.,;:!?)\]%”])+|\u00a0[\w/²%]+|-\w+)?")


class Inline:
    """Paragraphs of one text; `refer` is what finds references in them, or None."""

    def __init__(self, book, page, refer=None):
        self.book, self.page, self.refer, self.kept = book, page, refer, []

    def keep(self, piece):
        self.kept.append(piece)
        return "\0%d\0" % (len(self.kept) - 1)

    def restored(self, text):
        while "\0" in text:
            text = MARK.sub(lambda m: self.kept[int(m[1])], text)
        return text

    def math(self, tex, display=False):
        """The MathML of a formula; one that cannot be read is a complaint."""
        try:
            return formula(tex, display)
        except FormulaError as error:
            self.book.complain(self.book.path.get(self.page, self.page), str(error))
            return "<code>%s</code>" % escaped(tex), None

    def small(self, m):
        """A formula within a line; one that is longer than a line of a phone can be moved there."""
        mathml = self.math(m[1])[0]
        wide = len(re.sub(r"<[^>]*>", "", mathml)) > WIDE_FORMULA
        return self.keep('<span class="move">%s</span>' % mathml if wide else mathml)

    def code(self, m):
        if m.string[m.start() - 1:m.start()] == "$":
            return m[0]    # a formula in ticks
        inside = m[2].strip()
        to = self.refer.function(inside) if self.refer else None
        shown = "<code>%s</code>" % escaped(inside)
        return self.keep('<a class="fn" href="%s">%s</a>' % (to, shown) if to else shown)

    def link(self, m):
        words, url = m[1], m[2]
        href = self.book.href(self.page, url)
        if not href:
            return words
        only = MARK.fullmatch(words.strip())
        name = re.search(r"<code>([\w:~]+)(?:\(\))?</code>", self.kept[int(only[1])]) if only else None
        for k in MARK.findall(words):    # no link within a link
            self.kept[int(k)] = re.sub(r"</?a\b[^>]*>", "", self.kept[int(k)])
        if name and href.startswith("source-") and "#" not in href:
            href = cxx.place(self.book, self.book.resolved(self.page, url)[0], name[1])
        if self.refer:
            self.refer.linked(href)
        kind = ' class="out"' if re.match(r"\w+:", href) else ' class="fn"' if name and "#" in href else ""
        return self.keep('<a href="%s"%s>%s</a>' % (href, kind, self.emphasised(self.set_as_printed(words))))

    def state(self, m):
        """Words that name a state of a live figure of this page; live.js makes them a link to it."""
        if "<!-- live %s -->" % m[1] not in self.book.text.get(self.page, ""):
            self.book.complain(self.book.path.get(self.page, self.page), "no live figure %s on this page, set to %s" % (m[1], m[2]))
        return self.keep('<span class="set" data-figure="%s" data-set="%s">' % (m[1], m[2])) + m[3] + self.keep("</span>")

    def paper(self, m):
        r"""Equations of a paper, \PaperEq{XuanLi2002, 23}, and the entry of the paper."""
        shown = []
        for number in re.split(r"\s*,\s*", m[2]):
            to = self.book.equation_of_paper(m[1], number)
            if to and self.refer:
                self.refer.linked(to)
            shown.append('<a class="ref" href="%s">%s</a>' % (to, number) if to else number)
        if self.refer:
            self.refer.linked("references.html#" + m[1])
        return self.keep('eq.\u00a0(%s) of <a class="ref" href="references.html#%s">[%s]</a>' % (", ".join(shown), m[1], m[1]))

    def entry(self, m):
        r"""[\ref Murty1974]: an entry of the references."""
        if m[1] not in self.book.entry:
            self.book.complain(self.page, "no reference " + m[1])
            return m[0]
        if self.refer:
            self.refer.linked("references.html#" + m[1])
        return self.keep('<a class="ref" href="references.html#%s">[%s]</a>' % (m[1], m[1]))

    def finished(self, text):
        """Everything that later rules have to leave alone."""
        text = SET.sub(self.state, text)
        text = re.sub(r"<!--.*?-->", "", text)
        text = CODE.sub(self.code, text)
        text = TICKED.sub(self.small, text)
        text = DOLLARS.sub(self.small, text)
        while SAME_PAPER.search(text):
            text = SAME_PAPER.sub(r"\\PaperEq{\1, \2, ", text)
        text = ENTRY.sub(self.entry, PAPER.sub(self.paper, text))
        text = re.sub(r"\\([\\*_#|$`<>\[\]])", lambda m: self.keep(escaped(m[1])), text)
        text = TAG.sub(lambda m: self.keep(m[0]), text)
        text = re.sub(r'<a id="([\w-]+)"></a>', lambda m: self.keep(m[0]), text)
        return LINK.sub(self.link, text)

    @staticmethod
    def set_as_printed(text):
        """A minus instead of a hyphen before a number, quotes, and blanks that do not break."""
        text = escaped(text).replace("&amp;nbsp;", "\u00a0")
        text = re.sub(r"(?<![\w.)\]\0])-(?=\d)", "−", text)
        text = re.sub(r"(?<![\w\0-])-(?=\0\d)", "−", text)
        text = re.sub(r'"([^"\s][^"]*)"', r"“\1”", text)
        text = re.sub(r"(?<=\w)'(?=\w)|(?<=s)'(?=\s)", "’", text)
        text = re.sub(r"(?<=\([A-Z]) (?=\d)", "\u00a0", text)    # (A 12)
        return UNIT.sub("\u00a0", text)

    @staticmethod
    def emphasised(text):
        text = re.sub(r"\*\*(?=\S)(.+?)(?<=\S)\*\*", r"<strong>\1</strong>", text)
        text = re.sub(r"(?<![\w*])\*(?=[^\s*])(.+?)(?<=[^\s*])\*(?![\w*])", r"<em>\1</em>", text)
        return re.sub(r"(?<=\w-)\*([^*]+)\*(?!\w)", r"<em>\1</em>", text)    # half-*plane*

    def stuck(self, m):
        """A formula with its comma: no line begins with one."""
        inside = self.kept[int(m[2][1:-1])]
        kind = "nb move" if 'class="move"' in inside else "nb"
        return '<span class="%s">%s</span>' % (kind, m[0]) if (m[1] or m[3]) and "<math" in inside else m[0]

    def html(self, text, words=True):
        text = self.set_as_printed(self.finished(text))
        if self.refer and words:
            text = self.refer.references(text, self.keep)
        return self.restored(STUCK.sub(self.stuck, self.emphasised(text)))


def anchor_of(words):
    """The anchor of a glossary word."""
    return slug(re.sub(r"^an? ", "", words))
