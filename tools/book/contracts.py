"""contracts.py: the comments of the headers for two readers: the pages, as previews of functions, and Doxygen, as copies.

Doxygen makes the reference of src/ from copies in which formulas are MathML and equations are links into the book: it needs neither
MathJax nor a filter, and lines keep their numbers.  `python3 contracts.py ROOT FOLDER` writes the copies.
"""
import json
import re
import sys
from pathlib import Path

sys.dont_write_bytecode = True    # no __pycache__ beside the tools

import cxx
from inline import ENTRY, LINK, PAPER, Inline
from shelf import Book
from sources import markdown
from tex import FormulaError, formula

INLINE = re.compile(r"\\f\$(.*?)\\f\$", re.S)
DISPLAY = re.compile(r"\\f\[(.*?)\\f\]", re.S)


def previews(book):
    """The page and the contract of every function and type that a page may link to, as a script."""
    shown = {}
    for path in sorted(path for path in book.root.glob("src/**/*.hpp")):
        path = str(path.relative_to(book.root))
        for name, (contract, declaration) in cxx.declarations(book.root / path).items():
            first = "\n".join(markdown(contract.split("\n"))).strip().split("\n\n")[0]
            plain = LINK.sub(r"\1", " ".join(first.split())) if not first.startswith(("```", "- ")) else ""
            words = "<p>%s</p>" % Inline(book, path).html(plain) if plain else ""
            shown["%s.html#%s" % (book.source_page(path), name)] = "<pre><code>%s</code></pre>%s" % (
                cxx.highlighted(declaration, "cpp"), words)
    return "signoriniContracts(%s);\n" % json.dumps(shown, ensure_ascii=False, indent=0).replace("</", "<\\/")


def places(book):
    """page -> names that it declares, for the search."""
    found = {}
    for name, path in sorted(cxx.index(book.root).items()):
        found.setdefault(book.source_page(path), []).append(name)
    return found


class Copy:
    """A header for Doxygen."""

    def __init__(self, book, path):
        self.book, self.path = book, path

    def mathml(self, tex, display):
        tex = re.sub(r"\n\s*///?", " ", tex)
        try:
            return "\\htmlonly %s\\endhtmlonly" % formula(tex.strip(), display)[0]
        except FormulaError as error:
            self.book.complain(self.path, str(error))
            return tex

    def replaced(self, m, display):
        """A formula in its first line; the lines that it took stay, empty."""
        return self.mathml(m[1], display) + "\n///" * m[0].count("\n")

    def equations(self, m):
        numbers = []
        for number in re.split(r"\s*,\s*", re.sub(r"\s*\n\s*///\s*", " ", m[2])):
            to = self.book.equation_of_paper(m[1], number)
            numbers.append('<a href="../%s">%s</a>' % (to, number) if to else number)
        return 'Eq.&#160;(%s) of <a href="../references.html#%s">[%s]</a>' % (", ".join(numbers), m[1], m[1])

    def entry(self, m):
        """[\\ref Murty1974], if the references have it."""
        return '<a href="../references.html#%s">[%s]</a>' % (m[1], m[1]) if m[1] in self.book.entry else m[0]

    def text(self):
        text = (self.book.root / self.path).read_text(encoding="utf-8")
        text = ENTRY.sub(self.entry, PAPER.sub(self.equations, text))
        text = DISPLAY.sub(lambda m: self.replaced(m, True), text)
        return INLINE.sub(lambda m: self.replaced(m, False), text)


def main():
    root, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
    book = Book(root, folder)
    for path in [*root.glob("src/**/*.hpp"), *root.glob("docs/*.dox")]:
        path = path.relative_to(root)
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(Copy(book, str(path)).text(), encoding="utf-8")
    for where, what in book.complaints:
        print("%s: error: %s" % (where, what), file=sys.stderr)
    sys.exit(1 if book.complaints else 0)


if __name__ == "__main__":
    main()
