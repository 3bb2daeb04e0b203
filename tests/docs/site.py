#!/usr/bin/env python3
"""site.py ROOT FOLDER: a small book is copied as a site, twice the same bytes; each fault that is planted in its pages is found, those
of links and HTML without a browser, those of contrast and keyboard in one; the first page of the whole book is small.  Needs chromium.
"""
import shutil
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
from book import FOLDER, ROOT, page, run
from slides import small

SOMEWHERE = "/".join(("", "home", "someone", ""))    # as a page may not have it


def tool(name, *words):
    said = subprocess.run([sys.executable, str(ROOT / "tools" / name), *map(str, words)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          encoding="utf-8", check=False)
    return said.returncode, said.stdout


def files(folder):
    return {str(file.relative_to(folder)): file.read_bytes() for file in folder.rglob("*") if file.is_file()}


class Sites(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = small()
        assert run(cls.folder)[0] == 0
        cls.out, cls.to = cls.folder / "out", cls.folder / "site"

    def planted(self, name, old, new, program, where):
        """What a program says of the book with one change, which is undone."""
        text = page(self.folder, name)
        self.assertIn(old, text, new)
        (self.out / (name + ".html")).write_text(text.replace(old, new, 1), encoding="utf-8")
        try:
            return tool(program, where, *([self.to] if program == "site.py" else []))
        finally:
            (self.out / (name + ".html")).write_text(text, encoding="utf-8")

    def test_the_same_bytes(self):
        code, said = tool("site.py", self.out, self.to)
        self.assertEqual(code, 0, said)
        first = files(self.to)
        for name in ("index.html", "seek.js", "live.js", "slides-01.html", "fonts/README"):
            self.assertIn(name, first)
        shutil.rmtree(self.out)
        self.assertEqual(run(self.folder)[0], 0)
        self.assertEqual(tool("site.py", self.out, self.to), (code, said))
        self.assertEqual(files(self.to), first)

    def test_faults(self):
        for what, old, new, complaint in (
                ("a tag that is not closed", "<p>see", "<div><p>see", "</main> where <div> is open"),
                ("tags across each other", "<p>see", "<p><b><i>x</b></i>see", "</b> where <i> is open"),
                ("an end without begin", "<p>see", "</div><p>see", "</div> where <main> is open"),
                ("an id twice", "<p>see", '<p id="the-gap">see', "an id twice: the-gap"),
                ("an attribute twice", "<p>see", '<p class="a" class="b">see', "<p> has an attribute twice"),
                ("a picture without text", ' alt="', ' title="', "no alt: files/figures/fig.svg"),
                ("a heading left out", "<p>see", "<h4>x</h4><p>see", "<h4> after <h2>"),
                ("two titles", "<p>see", "<h1>x</h1><p>see", "2 headings <h1>"),
                ("a control without label", "<p>see", '<input id="x"><p>see', "no label: <input id=x>"),
                ("a link without words", "<p>see", '<a href="index.html"></a><p>see', "<a> without a name"),
                ("a button without words", "<p>see", "<button></button><p>see", "<button> without a name"),
                ("no language", ' lang="en"', "", "no lang"),
                ("no title", "<title>1 One · Signorini</title>", "<title></title>", "no title"),
                ("a dead link", "<p>see", '<a href="gone.html">x</a><p>see', "dead link: gone.html"),
                ("a dead anchor", "<p>see", '<a href="index.html#gone">x</a><p>see', "dead anchor: index.html#gone"),
                ("a style that is not there", 'href="page.css"', 'href="gone.css"', "dead link: gone.css"),
                ("a path of the machine", "<p>see", "<p>%sx see" % SOMEWHERE, "a path of the machine: " + SOMEWHERE)):
            code, said = self.planted("chapter-01", old, new, "site.py", self.out)
            self.assertEqual(code, 1, what)
            self.assertIn("chapter-01.html: " + complaint, said, what)
        code, said = self.planted("index", "</main>", "<p>%s</p></main>" % ("x" * 300000), "site.py", self.out)
        self.assertRegex(said, r"index.html: \d{6} bytes with all that it loads, 500000 allowed")
        self.assertEqual(code, 1)

    def test_contrast_and_keyboard(self):
        code, said = tool("check-reach.py", self.out)
        self.assertEqual(code, 0, said)
        for new, complaint in (
                ('<p style="color: #888">pale</p>', "contrast 3.49, light: pale"),
                ('<p style="color: #555">dim</p>', "dark: dim"),
                ('<a href="use.html" tabindex="-1">jumped</a>', "not reached by keyboard: jumped"),
                ('<a href="use.html" style="outline: none">dark</a>', "the focus does not show: dark"),
                ('<button onfocus="this.blur()">shy</button>', "cannot have the focus: shy"),
                ('<button onkeydown="event.preventDefault()">a trap</button><a href="use.html">behind</a>',
                 "the tabulator does not come to: behind")):
            code, said = self.planted("chapter-01", "<p>see", new + "<p>see", "check-reach.py", self.out)
            self.assertEqual(code, 1, new)
            self.assertIn(complaint, said)

    def test_the_first_page_of_the_book(self):
        """What it loads is in docs/: faces, sheets, scripts; site.py complains where it is more than 500 kB."""
        book = FOLDER / "whole"
        code, said = tool("book/book.py", ROOT, book)
        self.assertEqual(code, 0, said)
        code, said = tool("site.py", book, FOLDER / "site")
        self.assertEqual(code, 0, said)


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    unittest.main(argv=sys.argv[:1])
