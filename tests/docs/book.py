#!/usr/bin/env python3
"""book.py ROOT FOLDER: tools/book makes of small texts what it should, and refuses each fault that is planted in a small book in FOLDER."""
import ast
import os
import re
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

sys.dont_write_bytecode = True
ROOT, FOLDER = Path(sys.argv[1]).resolve(), Path(sys.argv[2]).resolve()
sys.path.insert(0, str(ROOT / "tools/book"))

import cxx
import sources
from blocks import Text
from contracts import Copy
from seek import Seek, words_of
from shelf import Book
from tex import FormulaError, formula

TEXTS = {
    "docs/parts": "part First: 0-3\npart Later: 4-99\npaper A Smith1990: 1-2\npaper B Jones2000: 3\nuse README.md: What\nuse chapters/README.md: Ways\n"
                  "use chapters/glossary.md: Glossary\nuse docs/references.md: References\n",
    "docs/rooms": "# rooms\npress 700 900\n",
    **{"docs/" + name: "" for name in ("page.css", "formula.css", "page.js", "peek.js", "find.js", "panels.js", "live.js", "live.css", "slides.js",
                                       "slides.css", "fonts/README")},
    "docs/references.md": '# References\n\n<a id="Smith1990"></a>\nSmith J., On contact, 1990.\n\n'
                          '<a id="Jones2000"></a>\nJones K., More, 2000.\n',
    "README.md": "# Book\n\nA book on contact.\n",
    "chapters/README.md": "# Ways\n\n| chapter | shows |\n|:--|:--|\n| [1 One](ch01_one/README.md) | how it begins |\n"
                          "| [5 Five](ch05_five/README.md) | how it ends |\n",
    "chapters/glossary.md": "# Glossary\n\n| word | Chinese | meaning |\n|:--|:--|:--|\n| active set | x | pairs that are closed |\n",
    "chapters/ch01_one/README.md": "# 1 One\n\n**What you will learn.** Something.\n\n## The gap\n\nThe active set has a gap $g$, and\n\n"
                                   '<a id="eq-1"></a>\n\n```math\ng = 0 \\tag{1}\n```\n\n'
                                   "see (1), (A 1), figure 1.1, exercise 1.2 and chapter 5.\n\n"
                                   "![Figure 1.1: a gap](../../figures/fig.svg)\n\nIts length is -3 mm; `solve_all()` does it.\n",
    "chapters/ch01_one/exercises/ex2_two/README.md": "# Exercise 1.2 - Two\n\n**Kind.** read\n\nDo (1).\n",
    "chapters/ch01_one/live/press.cpp": "int x;\n",
    "chapters/ch05_five/README.md": "# 5 Five\n\nAfter it.\n",
    "figures/fig.svg": '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 80"></svg>',
    "src/evenings": "evening 1: First things\n    What is first.\npapers/thing\n",
    "src/papers/thing.hpp": "// # A thing\n//\n// Solves \\PaperEq{Smith1990, 1}, as [\\ref Smith1990].\n#pragma once\n\n"
                            "/// Solves all of \\f$ a\n/// + b \\f$.\n///\n/// \\param a  first [length]\n/// \\return the sum\nint solve_all(int a);\n",
    "src/papers/thing.cpp": '// # How\n#include "papers/thing.hpp"\n\n// Adds.\nint solve_all(int a) {\n  return a;  // within\n}\n',
}


def make(folder, changes=()):
    """A small repository; a change is (file, old words, new words)."""
    shutil.rmtree(folder, ignore_errors=True)
    for name, text in TEXTS.items():
        for path, old, new in changes:
            if path == name:
                assert old in text, (path, old)
                text = text.replace(old, new)
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    (folder / "tools").mkdir()
    shutil.copy(ROOT / "tools/evenings.pl", folder / "tools")
    return folder


def run(folder):
    said = subprocess.run([sys.executable, str(ROOT / "tools/book/book.py"), str(folder), str(folder / "out")], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, encoding="utf-8", check=False)
    return said.returncode, said.stdout


def page(folder, name):
    return (folder / "out" / (name + ".html")).read_text(encoding="utf-8")


class Formulas(unittest.TestCase):
    def shows(self, tex, *pieces):
        for piece in pieces:
            self.assertIn(piece, formula(tex)[0])

    def test_signs(self):
        self.shows("a - b", "<mi>a</mi><mo>−</mo><mi>b</mi>")
        self.shows("-b", '<mo form="prefix">−</mo>')
        self.shows("= -b", '<mo form="prefix">−</mo>')
        self.shows("a \\le \\lambda", "<mo>≤</mo><mi>λ</mi>")

    def test_structure(self):
        self.shows("|x|", '<mo stretchy="false" lspace="0" rspace="0">|</mo><mi>x</mi>')
        self.shows("x_i^2", "<msubsup><mi>x</mi><mi>i</mi><mrow><mn>2</mn></mrow></msubsup>")
        self.shows("\\tfrac12", "<mfrac><mn>1</mn><mn>2</mn></mfrac>")
        self.shows("\\min_x f", "<munder>", 'movablelimits="true"')
        self.shows("\\sqrt[3]{x}", "<mroot><mrow><mi>x</mi></mrow><mrow><mn>3</mn></mrow></mroot>")
        self.shows("g'", "<mi>g</mi><mo", "′")
        self.shows("\\begin{pmatrix} 1 & 2 \\\\ 3 & 4 \\end{pmatrix}", "<mtr><mtd><mn>1</mn></mtd><mtd><mn>2</mn></mtd></mtr><mtr>")
        self.shows("\\text{if } a", "<mtext>if\u00a0</mtext>")
        self.assertEqual(formula("a \\tag{12}", True)[1], "12")

    def test_what_is_not_known_is_an_error(self):
        for tex in ("\\nosuch{a}", "\\frac{a}", "{a", "a}", "\\begin{array} a \\end{array}", "\\mathbb{Q}", "\\left\\foo a \\right)"):
            with self.assertRaises(FormulaError, msg=tex):
                formula(tex)


class Texts(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.book = Book(make(FOLDER / "texts"), FOLDER / "texts/out")
        cls.book.rooms = {"press": (700, 900)}

    def html(self, text, where="chapter-01"):
        return Text(self.book, where).blocks(text.split("\n"))

    def test_paragraphs(self):
        self.assertEqual(self.html("one\ntwo\n\n*three* **four** `f<x>`"),
                         "<p>one two</p>\n<p><em>three</em> <strong>four</strong> <code>f&lt;x&gt;</code></p>")

    def test_printed_signs(self):
        self.assertIn("−3\u00a0mm", self.html("at -3 mm"))
        self.assertIn("it’s “so”", self.html("it's \"so\""))
        self.assertRegex(self.html("with $a$, and"), r'<span class="nb"><math>.*</math>,</span> and')
        self.assertIn('<p><span class="move"><math>', self.html("$a + b + c + d + e + f + g + h + i + j + k + l + m + n + o$"))
        self.assertIn("half-<em>plane</em>", self.html("half-*plane*"))

    def test_references_have_previews(self):
        text = Text(self.book, "chapter-05")
        said = text.blocks(["see (A 1), figure 1.1, chapter 1, exercise 1.2, an active set, `solve_all()` and",
                            "[Smith](../../docs/references.md#Smith1990)"])
        for link in ("chapter-01.html#eq-1", "chapter-01.html#fig-1-1", "chapter-01.html", "exercise-01-2.html", "glossary.html#active-set",
                     "references.html#Smith1990"):
            self.assertIn('href="%s"' % link, said)
            self.assertTrue(text.refer.previews.get(link), link)
        said = text.blocks(["chapters 1, 4 and 5, or exercises 1.1 and 1.2, not chapter 1 and 5"])
        self.assertEqual(re.sub(r' class="ref"', "", said), '<p><a href="chapter-01.html">chapters 1</a>, 4 and 5, or exercises 1.1 and '
                         '<a href="exercise-01-2.html">1.2</a>, not <a href="chapter-01.html">chapter 1</a> and 5</p>')
        self.assertIn('href="https://a.org/1(2)3-X"', self.html("[x](https://a.org/1(2)3-X)"))
        said = text.blocks(["`solve_all()`"])
        self.assertIn('<a class="fn" href="source-papers-thing-hpp.html#solve_all">', said)

    def test_no_link_within_a_link(self):
        said = self.html("[see (A 1), *figure 1.1* and `solve_all()`](../../README.md)", "chapter-05")
        self.assertEqual(said, '<p><a href="use.html">see (A\u00a01), <em>figure 1.1</em> and <code>solve_all()</code></a></p>')

    def test_boxes(self):
        said = self.html("Text.\n\n> **Misprint.** It says $a$.")
        self.assertRegex(said, r'^<div class="hoist"><details class="note misprint" id="box-1" open><summary>Misprint</summary>.*'
                               r'<p>Text.</p></div>$')
        two = self.html("Text.\n\n> **Misprint.** One.\n\n> **Left open.** Two.")
        self.assertRegex(two, r'^<div class="hoist"><details class="note misprint".*</details><details class="note open".*</details>'
                              r'<p>Text.</p></div>$')
        self.assertNotIn("open>", self.html("> **Left open.** " + "word " * 200))
        self.assertIn('class="note verdict"', self.html("> **Our verdict.** No."))
        self.assertEqual(self.html("> said"), "<blockquote>said</blockquote>")

    def test_blocks(self):
        self.assertEqual(self.html("- a\n- b\n  more"), "<ul><li>a</li><li>b more</li></ul>")
        self.assertIn('<th>a</th><th class="num">b</th>', self.html("| a | b |\n|:--|--:|\n| x | 1.5 |"))
        self.assertIn("<td>a|b</td>", self.html("| a |\n|:--|\n| a\\|b |"))
        self.assertIn("<h2 id=\"the-gap\">The gap", self.html("## The gap"))
        self.assertEqual(self.html('One.\n\n<div class="sheet"></div>\n\nTwo.'), '<p>One.</p>\n<div class="sheet"></div>\n<p>Two.</p>')
        self.assertIn('<h2 id="the-gap-1">', self.html("## The gap\n\n## The gap"))
        self.assertIn('<figure class="code wide cpp">', self.html("```cpp\n%s;\n```" % ("x" * 80)))
        self.assertIn('<figure class="code wide long cpp">', self.html("```cpp\n%s;\n```" % ("x" * 120)))
        self.assertIn('<details class="fold"><summary>Hint</summary><p>Think.</p></details>',
                      self.html("<details><summary>Hint</summary>\n\nThink.\n\n</details>"))
        self.assertIn('width="100" height="80" alt="a gap"', self.html("![a gap](../../figures/fig.svg)"))

    def test_live_figures_have_their_room(self):
        said = self.html("<!-- live press -->\n\n![Figure 1.1: a gap](../../figures/fig.svg)")
        self.assertIn('<div class="live" data-figure="press"', said)
        self.assertIn("--room:700px;--room-phone:900px", said)
        self.assertIn('<details class="live-printed" open>', said)

    def test_words_that_name_a_state(self):
        said = self.html("At <!-- set press load=0.5 top=on -->$q = 1/2$<!-- /set --> it closes.\n\n<!-- live press -->")
        self.assertRegex(said, '<p>At (<span class="nb">)?<span class="set" data-figure="press" data-set="load=0.5 top=on"><math')

    def test_search_has_words_and_no_listings(self):
        self.assertEqual(words_of("<p>one <b>two</b></p><pre>three</pre><p>f&amp;g</p>"), "one two f&g")
        seek = Seek()
        seek.add("chapter-01", "1 One", '<p>before</p><h2 id="a">Head<a class="self" href="#a">#</a></h2><p>after</p>')
        self.assertEqual(seek.rows, [[0, "", "", "before"], [0, "a", "Head", "after"]])


class Sources(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.book = Book(make(FOLDER / "sources"), FOLDER / "sources/out")

    def test_pieces(self):
        lines = "// one\n//\n//     two\nint a;\n\n  // stays\nint b;\n\n// three".split("\n")
        self.assertEqual(sources.split(lines), [[["one", "", "    two"], [(4, "int a;"), (5, ""), (6, "  // stays"), (7, "int b;")], 4],
                                                [["three"], [], 0]])

    def test_nothing_of_a_file_is_lost(self):
        for path in sorted(ROOT.glob("src/papers/*.[ch]pp")):
            lines = path.read_text(encoding="utf-8").rstrip("\n").split("\n")
            shown = {number: line for _, code, _ in sources.split(lines) for number, line in code}
            for number, line in enumerate(lines, 1):
                if line.strip() and not re.match(r"//|\s*///|\s*// \[", line):
                    self.assertEqual(shown.get(number), line, "%s:%d" % (path, number))
                elif line.startswith("//"):
                    self.assertNotIn(number, shown, "%s:%d" % (path, number))

    def test_commands_of_doxygen(self):
        self.assertEqual(sources.markdown(["Adds \\f$ a", "+ b \\f$.", "\\param a  first", "\\return the sum", "\\throws Error if"]),
                         ["Adds $a + b$.", "", "- `a`: first", "- returns the sum", "- throws `Error` if"])

    def test_names_lead_to_their_header(self):
        said = cxx.highlighted("int n = solve_all(1);  // solve_all", "cpp", cxx.linker(self.book))
        self.assertIn('<a href="source-papers-thing-hpp.html#solve_all">solve_all</a>(<span class="n">1</span>)', said)
        self.assertIn('<span class="c">// solve_all</span>', said)
        for code, links in (("  return solve_all(1);", 1), ("  int solve_all(1);", 0), ("int solve_all(int a) {", 1), ("  x.solve_all(1);", 0),
                            ("  a = b * solve_all(1);", 1), ("  f(solve_all(1));", 1)):
            self.assertEqual(cxx.highlighted(code, "cpp", cxx.linker(self.book)).count("<a "), links, code)

    def test_copies_for_doxygen_keep_their_lines(self):
        for path in ["src/papers/thing.hpp"]:
            text = Copy(self.book, path).text()
            self.assertEqual(text.count("\n"), TEXTS[path].count("\n"))
            self.assertIn("\\htmlonly <math>", text)
            self.assertIn('<a href="../chapter-01.html#eq-1">1</a>', text)
            self.assertIn('<a href="../references.html#Smith1990">[Smith1990]</a>', text)


class Generator(unittest.TestCase):
    def test_it_can_be_read(self):
        for file in sorted((ROOT / "tools/book").glob("*.py")):
            text = file.read_text(encoding="utf-8")
            self.assertLessEqual(text.count("\n"), 250, file)
            self.assertLessEqual(max(map(len, text.split("\n"))), 140, file)
            for part in ast.walk(ast.parse(text)):
                if isinstance(part, ast.FunctionDef):
                    self.assertLessEqual(part.end_lineno - part.lineno + 1, 40, "%s: %s" % (file, part.name))


def luminance(colour):
    parts = [int(colour[i:i + 2], 16) / 255 for i in (1, 3, 5)]
    red, green, blue = [p / 12.92 if p <= 0.03928 else ((p + 0.055) / 1.055)**2.4 for p in parts]
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


class Look(unittest.TestCase):
    def test_contrast(self):
        """Every colour of letters on every colour of paper, light and dark, after WCAG 2.1: 4.5."""
        sheet = (ROOT / "docs/page.css").read_text(encoding="utf-8")
        for tone in (":root {", ":root.dark {", ":root:not(.light):not(.dark) {"):
            colour = dict(re.findall(r"--([\w-]+): (#[0-9a-f]{6})", sheet[sheet.index(tone):].split("}")[0]))
            self.assertEqual(len(colour), 15, tone)
            for ground in ("paper", "tint", "side"):
                for name in set(colour) - {"paper", "tint", "side", "line"}:
                    low, high = sorted((luminance(colour[name]), luminance(colour[ground])))
                    self.assertGreaterEqual((high + 0.05) / (low + 0.05), 4.5, "%s: %s on %s" % (tone, name, ground))


class Whole(unittest.TestCase):
    def test_a_small_book(self):
        folder = make(FOLDER / "whole")
        code, said = run(folder)
        self.assertEqual((code, said[-13:]), (0, "0 complaints\n"), said)
        for name, formulas in ("index", False), ("chapter-01", True), ("chapter-05", False):    # their face is large
            self.assertEqual('href="formula.css"' in page(folder, name), formulas, name)
        cover, chapter, source = page(folder, "index"), page(folder, "chapter-01"), page(folder, "source-papers-thing-cpp")
        self.assertIn("how it begins", cover)
        self.assertLess(cover.index(">First<"), cover.index(">Reading the library<"))
        self.assertLess(cover.index(">Reading the library<"), cover.index(">Use<"))
        self.assertIn('<a class="next" href="chapter-05.html">', chapter)
        self.assertIn('<template data-for="#eq-1">', chapter)
        self.assertIn('<div class="leads"><a href="source-papers-thing-hpp.html#solve_all" class="fn"><code>solve_all()</code></a> · '
                      'chapter <a href="chapter-01.html">1</a>', source)
        self.assertIn('<span class="l" data-n="5" id="solve_all">', source)
        self.assertIn("Evening 1 · First things", source)
        for file in ("seek.js", "contracts.js", "page.css"):
            self.assertTrue((folder / "out" / file).is_file(), file)
        for text in (cover, chapter, source):
            self.assertNotIn("http", re.sub(r'xmlns="[^"]*"', "", text))

    def test_faults(self):
        one = "chapters/ch01_one/README.md"
        for what, change, complaint in (
                ("an equation that does not exist", (one, "see (1)", "see (7)"), one + ": error: no equation (7)"),
                ("an equation that the paper has not", (one, "(A 1)", "(B 1)"), one + ": error: no equation (B 1)"),
                ("a figure that does not exist", (one, "see (1), (A 1), figure 1.1", "see figure 1.2"), one + ": error: no figure 1.2"),
                ("a link that leads nowhere", (one, "Something.", "[x](../gone.md)"), one + ": error: dead link: ../gone.md"),
                ("an anchor that does not exist", (one, "Something.", "[x](#gone)"), "chapter-01.html: error: dead anchor: #gone"),
                ("an unknown command", (one, "gap $g$", "gap $\\nosuch$"), one + ": error: formula: \\nosuch is not known"),
                ("an anchor twice", (one, "Something.", '<a id="eq-1"></a>'), "chapter-01.html: error: an anchor twice: eq-1"),
                ("a picture that is not there", (one, "figures/fig.svg", "figures/gone.svg"), one + ": error: no picture"),
                ("a live figure without source", (one, "![Fig", "<!-- live gone -->\n\n![Fig"), one + ": error: no live figure gone"),
                ("a state of no live figure", (one, "Something.", "<!-- set gone load=1 -->x<!-- /set -->"),
                 one + ": error: no live figure gone on this page, set to load=1"),
                ("a reference that does not exist", ("src/papers/thing.hpp", "ref Smith1990", "ref Smith1991"), "no reference Smith1991"),
                ("a chapter in no part", ("docs/parts", "part Later: 4-99\n", ""), "docs/parts: error: chapter-05 is in no part"),
                ("another order", ("docs/parts", "0-3\npart Later: 4-99", "4-99\npart Later: 0-3"), "docs/parts: error: the order of chapters is 05 01, in"),
                ("a part that says nothing", ("docs/parts", "part First", "port First"), "docs/parts: error: expected part, paper or use")):
            folder = make(FOLDER / "fault", [change])
            code, said = run(folder)
            self.assertEqual(code, 1, what)
            self.assertIn(complaint, said, what)


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    os.makedirs(FOLDER)
    unittest.main(argv=sys.argv[:1])
