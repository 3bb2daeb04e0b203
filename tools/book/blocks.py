"""blocks.py: a text of Markdown as HTML, block by block.

    text = Text(book, page); text.blocks(lines)

What is read: headings, paragraphs, lists, tables, quotations, fences, formulas, figures, <details>, and the marks of the book:
<!-- code file#name -->, <!-- table ... -->, <!-- live name -->, <!-- nav -->.
"""
import re

import pieces
from inline import Inline
from references import References
from shelf import slug

END_OF_PARAGRAPH = re.compile(r"```|#|\||>|!\[|<!-- (?!=)|</?details|<a id=\"[\w-]+\"></a>\s*$|[*-] |\d+\. ")
ITEM = re.compile(r"(\s*)([*-]|\d+\.) ")


def until(lines, test, start):
    """The first line from `start` on that passes the test, or the end."""
    return next((j for j in range(start, len(lines)) if test(lines[j])), len(lines))


class Text:
    """One text on its way to HTML."""

    def __init__(self, book, page):
        self.book, self.page = book, page
        self.refer = References(book, page)
        self.inline = Inline(book, page, self.refer)
        self.taken, self.sections, self.boxes, self.anchor, self.source, self.out = {}, [], 0, "", "", []

    def html(self, words, link=True):
        return self.inline.html(words, link)

    def take_anchor(self):
        anchor, self.anchor = self.anchor, ""
        return anchor

    def blocks(self, lines):
        """The HTML of some lines."""
        outer, self.out, i = self.out, [], 0
        while i < len(lines):
            i = self.mark(lines, i) or self.block(lines, i)
        inside, self.out = "\n".join(self.out), outer
        return inside

    def mark(self, lines, i):
        """What is no text itself: the next line, or None."""
        line = lines[i]
        if not line.strip() or line.startswith(("<!-- /", "<!-- table")):
            return i + 1
        if line.startswith("<!-- nav"):
            return until(lines, lambda t: t.startswith("<!-- /nav"), i) + 1
        m = re.match(r"<!-- (code|live) (\S+?)(?:#.*)? -->|<!-- (code) (\S+)", line)
        if m and (m[1] or m[3]) == "code":
            self.source = m[2] or m[4]
            return i + 1
        if m:
            self.out.append(pieces.live(self, m[2]))
            return i + 1
        if line.startswith("<!--"):
            return until(lines, lambda t: "-->" in t, i) + 1
        if re.match(r'<div class="\w+"></div>\s*$', line):    # where a sheet begins
            self.out.append(line.strip())
            return i + 1
        m = re.match(r'<a id="([\w-]+)"></a>\s*$', line)
        if m:
            self.anchor = m[1]
            return i + 1
        return None

    def block(self, lines, i):
        """One block that begins at line i: the next line."""
        line = lines[i]
        m = re.match(r"\s*(```+)(\w*)", line)
        if m:
            j = until(lines, lambda t: t.strip().startswith(m[1]), i + 1)
            indent = len(line) - len(line.lstrip())
            self.out.append(pieces.fence(self, "\n".join(t[indent:] for t in lines[i + 1:j]), m[2]))
            return j + 1
        m = re.match(r"(#+) (.*)", line)
        if m:
            self.heading(len(m[1]), m[2])
            return i + 1
        m = re.match(r"!\[(.*)\]\((\S+)\)\s*$", line)
        if m:
            self.out.append(pieces.figure(self, m[1], m[2], bool(self.out) and 'class="live"' in self.out[-1]))
            return i + 1
        if line.startswith("<details>"):
            j = until(lines, lambda t: t.startswith("</details>"), i + 1)
            summary = self.html(re.sub("<.*?>", "", line), False)
            self.out.append('<details class="fold"><summary>%s</summary>%s</details>' % (summary, self.blocks(lines[i + 1:j])))
            return j + 1
        if line.startswith(">"):
            j = until(lines, lambda t: not t.startswith(">"), i)
            pieces.box(self, [t[1:].strip() for t in lines[i:j]])
            return j
        if line.startswith("|"):
            j = until(lines, lambda t: not t.startswith("|"), i)
            self.out.append(pieces.table(self, lines[i:j]))
            return j
        m = ITEM.match(line)
        return self.items(lines, i, m) if m else self.paragraph(lines, i)

    def heading(self, level, words):
        anchor, said = slug(words), self.html(words, False)
        self.taken[anchor] = self.taken.get(anchor, -1) + 1
        if self.taken[anchor]:    # as where the repository is browsed
            anchor += "-%d" % self.taken[anchor]
        if level == 2:
            self.sections.append((anchor, said))
        if level > 1:    # the title stands in the head of the page
            self.out.append('<h%d id="%s">%s<a class="self" href="#%s" aria-label="link to this section">#</a></h%d>' % (
                level, anchor, said, anchor, level))

    def items(self, lines, i, m):
        """A list, with what is indented below its items."""
        j = i
        while j < len(lines) and (re.match(r"\s+\S", lines[j]) or ITEM.match(lines[j]) or (
                not lines[j].strip() and j + 1 < len(lines) and re.match(r"\s{2,}\S", lines[j + 1]))):
            j += 1
        items = re.split(r"\n(?=[*-] |\d+\. )", "\n".join(t[len(m[1]):] for t in lines[i:j]))
        tag = "ol" if m[2][0].isdigit() else "ul"
        first = m[2][:-1] if tag == "ol" and m[2] != "1." else ""
        self.out.append("<%s%s>%s</%s>" % (tag, ' start="%s"' % first if first else "", "".join(
            "<li>%s</li>" % self.item(item) for item in items), tag))
        return j

    def item(self, item):
        first, *rest = re.sub(r"^([*-]|\d+\.) ", "", item).split("\n")
        k = until(rest, lambda t: ITEM.match(t) or not t.strip() or re.match(r"\s*(```|\|)", t), 0)
        said = self.html(" ".join([first] + [t.strip() for t in rest[:k]]))
        return said + (self.blocks([re.sub(r"^\s{2,3}", "", t) for t in rest[k:]]) if k < len(rest) else "")

    def paragraph(self, lines, i):
        if lines[i].startswith("    "):
            j = until(lines, lambda t: t.strip() and not t.startswith("    "), i)
            code = "\n".join(t[4:] for t in lines[i:j]).rstrip()
            self.out.append(pieces.fence(self, code, "sh" if re.match(r"make |build/|\./|tools/", code) else ""))
            return j
        j = until(lines, lambda t: not t.strip() or END_OF_PARAGRAPH.match(t), i + 1)
        anchor = self.take_anchor()
        self.out.append("<p%s>%s</p>" % (' id="%s"' % anchor if anchor else "", self.html(" ".join(t.strip() for t in lines[i:j]))))
        return j
