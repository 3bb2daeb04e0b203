"""sources.py: a source as a page: prose beside the code that it speaks of.

Comments at the left edge, and the contracts of members, are prose, in Markdown with formulas; the code below stands beside them.  A
comment `# Title` names the page.  Above the code of a function stands what leads from it: contract, tests, chapters, equations.
A file without such comments is one listing.
"""
import os
import re

import cxx
import frame
from blocks import Text
from tex import escaped

COMMENT = re.compile(r"(?://|\s*///)(?!/)(?!<) ?(.*)$")
QUOTED = re.compile(r"\s*// \[[\w ]+\]$|\s*//! \[")    # where a chapter quotes the file
NAMES = re.compile(r"#|namespace|using |\}  // namespace|\s*$")
COMMAND = re.compile(r"(?=\\(?:t?param|returns?|throws)\b)")
INCLUDE = re.compile(r'(<span class="p">#include</span> )(?:<span class="s">)?"([^"]+)"(?:</span>)?')


def split(lines):
    """[prose, code, number of the first line of code] in the order of the file."""
    out, kind = [], ""
    for number, line in enumerate(lines, 1):
        if QUOTED.match(line):
            continue
        m = COMMENT.match(line)
        if m:
            if kind != "prose" and not (out and not out[-1][1]):
                out.append([[], [], 0])
            out[-1][0].append(m[1])
            kind = "prose"
        elif line.strip() or kind == "code":
            if not out:
                out.append([[], [], 0])
            out[-1][2] = out[-1][2] or number
            out[-1][1].append((number, line))
            kind = "code"
        elif out:
            out[-1][0].append("")
            kind = ""
    for piece in out:
        while piece[1] and not piece[1][-1][1].strip():
            piece[1].pop()
    return out


def markdown(lines):
    """The commands of Doxygen as Markdown: arguments, result and errors are a list."""
    out, in_list = [], False
    whole = re.sub(r"\\f\$\s*(.*?)\s*\\f\$", lambda m: "$%s$" % " ".join(m[1].split()), "\n".join(lines), flags=re.S)
    for line in whole.split("\n") if lines else []:
        line = re.sub(r"(?<!\[)\\ref (\S+?)(?=[\s.,;:)]|$)", r"`\1`", line)
        line = re.sub(r"\\f\[", "\n```math\n", re.sub(r"\\f\]", "\n```\n", line))
        line = re.sub(r"^\\(?:file|addtogroup|ingroup|defgroup|name|brief|snippet|namespace|dir)\S*\s*|^@[{}]|\\[pca] ", "", line)
        for part in [part for part in COMMAND.split(line) if part] or [""]:
            said = re.sub(r"^\\t?param(?:\[\w+\])?\s+(\S+)\s*", r"- `\1`: ", part)
            said = re.sub(r"^\\throws\s+(\S+)", r"- throws `\1`", re.sub(r"^\\returns?\s+", "- returns ", said))
            item = said != part
            if (item and not in_list or in_list and re.match(r"\w", said)) and out:
                out.append("")
            in_list = item or (in_list and said.startswith("  "))
            out += [t.rstrip() for t in said.split("\n")]
    return out


def title_of(text):
    m = re.search(r"^///? # (.+)$", text, re.M)
    return m[1] if m else None


class Source:
    """The page of one file."""

    def __init__(self, book, path, leads):
        self.book, self.path, self.leads = book, path, leads
        self.lines = (book.root / path).read_text(encoding="utf-8").rstrip("\n").split("\n")
        self.text, self.taken = Text(book, path), set()
        self.link = cxx.linker(book, path)

    def code(self, numbered):
        """Lines of code as they stand, each with its number and, if it declares something, with an anchor."""
        shown = cxx.highlighted("\n".join(line for _, line in numbered), "cpp", self.link).split("\n")
        out = ""
        for (number, raw), line in zip(numbered, shown):
            name = cxx.declared(raw)
            anchor = ' id="%s"' % name if name and name not in self.taken else ""
            self.taken.add(name)
            m = INCLUDE.match(line)
            to = next((p for p in ("src/" + m[2], os.path.join(os.path.dirname(self.path), m[2])) if (self.book.root / p).is_file()),
                      None) if m else None
            if to:
                line = '%s<a href="%s.html">"%s"</a>' % (m[1], self.book.source_page(os.path.normpath(to)), m[2])
            out += '<span class="l" data-n="%d"%s>%s</span>' % (number, anchor, line)
        return "<pre><code>%s</code></pre>" % out

    def listing(self, numbered):
        """Code, cut where a function begins that leads somewhere."""
        cuts = [k for k, (number, _) in enumerate(numbered) if number in self.leads] + [len(numbered)]
        out = self.code(numbered[:cuts[0]]) if cuts[0] else ""
        for begin, end in zip(cuts, cuts[1:]):
            said = "<br>".join(self.text.html(lead) for lead in self.leads[numbered[begin][0]])
            out += '<div class="leads">%s</div>%s' % (said, self.code(numbered[begin:end]))
        return out

    def rows(self):
        out = ""
        for prose, code, first in split(self.lines):
            said = self.text.blocks(markdown([line for line in prose if not re.match(r"# |This header is internal", line)]))
            listing, kind = self.listing(code) if code else "", "" if said else " bare"
            if code and first < 100 and all(NAMES.match(line) for _, line in code):    # nobody reads these, and they are long
                kind, listing = " opening", '<details class="fold"><summary>includes and names</summary>%s</details>' % listing
            out += '<section class="beside%s"><div class="prose">%s</div><div class="says">%s</div></section>\n' % (kind, said, listing)
        return out

    def about(self):
        """The line below the title: the file, its other half, its contract, its test."""
        stem, own = re.sub(r"\.[ch]pp$", "", self.path), os.path.basename(self.path)
        said = ["<code>%s</code>" % escaped(self.path)]
        for twin in (stem + ".hpp", stem + ".cpp"):
            if twin != self.path and (self.book.root / twin).is_file():
                said.append('<a href="%s.html"><code>%s</code></a>' % (self.book.source_page(twin), os.path.basename(twin)))
        test = "tests/%s/test_%s" % (os.path.basename(os.path.dirname(self.path)), re.sub(r"\.[ch]pp$", ".cpp", own))
        if self.path.startswith("src/") and (self.book.root / test).is_file():
            said.append('<a href="%s.html">%s</a>' % (self.book.source_page(test), os.path.basename(test)))
        if "This header is internal" in self.lines[0]:
            said.append("internal")
        if self.path in self.book.reference:
            said.append('<a href="reference/%s">reference</a>' % self.book.reference[self.path])
        return '<p class="twin">%s</p>' % " · ".join(said)

    def write(self, page):
        rows = self.rows()
        title = title_of("\n".join(self.lines))
        shown = self.text.html(title, False) if title else escaped(os.path.basename(self.path))
        evening = self.book.evening_of.get(self.path)
        where = '<a href="%s.html">%s</a>' % evening if evening else escaped(os.path.dirname(self.path))
        head = '<header class="title"><p>%s</p><h1%s>%s</h1>%s</header>' % (where, "" if title else ' class="file"', shown, self.about())
        told = any(any(prose) for prose, _, _ in split(self.lines))
        frame.write(self.book, page, title or os.path.basename(self.path), head + rows + frame.turn(self.book, page), self.text,
                    "source" if told else "source plain")


def write_all(book):
    """The pages of all sources that a page links to, and of those that these link to, and so on."""
    done = set()
    while set(book.sources) - done:
        for path in sorted(set(book.sources) - done):
            Source(book, path, book.leads.get(path, {})).write(book.sources[path])
            done.add(path)
