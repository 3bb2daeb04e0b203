#!/usr/bin/env python3
"""slides.py ROOT FOLDER: every chapter of the book has a deck, nothing on its slides stands beyond 1280 x 720 pixels as a browser lays
them out, each lecture of docs/teaching.md begins at its slide; and each fault that is planted in a small book is found.  Needs chromium.
"""
import re
import shutil
import subprocess
import sys
import unittest

sys.dont_write_bytecode = True
from book import FOLDER, ROOT, make, page, run

import cut

ONE = "chapters/ch01_one/README.md"
STYLE = ("page.css", "formula.css", "page.js", "peek.js", "find.js", "panels.js", "live.js", "live.css", "slides.js", "slides.css")


def small(changes=()):
    folder = make(FOLDER / "small", changes)
    for name in STYLE:
        shutil.copy(ROOT / "docs" / name, folder / "docs")
    shutil.copytree(ROOT / "docs/fonts", folder / "docs/fonts", dirs_exist_ok=True)
    return folder


def checked(folder):
    said = subprocess.run([sys.executable, str(ROOT / "tools/check-slides.py"), str(folder)], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, encoding="utf-8", check=False)
    return said.returncode, said.stdout


class Cuts(unittest.TestCase):
    def test_sentences(self):
        self.assertEqual(cut.sentences("It is $a. B$ long, 3.5 mm. (So it is.) *Then.* `x. Y` ends?"),
                         ["It is $a. B$ long, 3.5 mm.", "(So it is.)", "*Then.*", "`x. Y` ends?"])
        self.assertEqual(cut.sentences("It says *one. Two.* So it is."), ["It says *one. Two.*", "So it is."])

    def test_what_is_told(self):
        text = "First of all a sentence that is long enough to stand on a slide, quite alone, without the next one. Then no more. " \
            "A *word* is new."
        self.assertEqual(cut.told(text, True), [text.split(" Then")[0], "A *word* is new."])
        self.assertEqual(cut.told(text, False), ["A *word* is new."])
        self.assertEqual(cut.told("*Lead.* " + text, False), ["*Lead.* " + text.split(" Then")[0]])

    def test_lectures(self):
        plan = "# Teaching\n\n## Lectures\n\n" \
            "| 1 | [1](../%s), to *The gap* | a | b | c |\n| 2 | [1](../%s), the rest | d | e | f |\n" % (ONE, ONE)
        for until, code in ("The gap", 0), ("The gop", 1):
            folder = make(FOLDER / "lectures", [(ONE, "does it.\n", "does it.\n\n## Later\n\nMore.\n")])
            (folder / "docs/teaching.md").write_text(plan.replace("The gap", until), encoding="utf-8")
            found, said = run(folder)
            self.assertEqual(found, code, said)
            if code:
                self.assertIn("docs/teaching.md: error: lecture 1: %s has no section The gop" % ONE, said)
        self.assertIn('href="slides-01.html#lecture-1"', page(folder, "slides"))
        folder = make(FOLDER / "lectures", [(ONE, "does it.\n", "does it.\n\n## Later\n\nMore.\n")])
        (folder / "docs/teaching.md").write_text(plan, encoding="utf-8")
        run(folder)
        deck = page(folder, "slides-01")
        self.assertEqual(re.findall("<h2>(?:Lecture )?(1|2|The gap|Later)</h2>", deck)[0], "1")
        self.assertLess(deck.index("lecture-1"), deck.index("<h2>The gap</h2>"))
        self.assertLess(deck.index("<h2>The gap</h2>"), deck.index("lecture-2"))
        self.assertLess(deck.index("lecture-2"), deck.index("<h2>Later</h2>"))


class Browsed(unittest.TestCase):
    def test_faults(self):
        folder = small()
        self.assertEqual(run(folder)[0], 0)
        code, said = checked(folder / "out")
        self.assertEqual(code, 0, said)
        deck = folder / "out/slides-01.html"
        for what, old, new, complaint in (
                ("too many words", "The active set", "word " * 900, "it overflows by"),
                ("a wide formula", "<mi>g</mi>", "<mi>gggggggggggggggg</mi>" * 12, "slides-01.html#"),
                ("a slide that is no slide", 'class="slide figure"', 'class="slide figure" style="height: 900px"', "1280 x 900 pixels"),
                ("keys that do not turn", '<script src="slides.js"></script>', "", "the keys do not lead to it")):
            text = page(folder, "slides-01")
            self.assertIn(old, text, what)
            deck.write_text(text.replace(old, new), encoding="utf-8")
            code, said = checked(folder / "out")
            self.assertEqual(code, 1, what)
            self.assertIn(complaint, said, what)
            deck.write_text(text, encoding="utf-8")
        deck.unlink()
        self.assertIn("chapter-01.html has no deck", checked(folder / "out")[1])

    def test_the_book(self):
        book = FOLDER / "whole"
        said = subprocess.run([sys.executable, str(ROOT / "tools/book/book.py"), str(ROOT), str(book)], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, encoding="utf-8", check=False)
        self.assertEqual(said.returncode, 0, said.stdout)
        code, found = checked(book)
        self.assertEqual(code, 0, found)
        plan = (ROOT / "docs/teaching.md").read_text(encoding="utf-8")
        for number in re.findall(r"^\| (\d+) \| \[\d+\]\(\S+README.md\)(?:, (?:to|the).*?)? \| ", plan.split("\n## ")[1], re.M):
            places = [deck for deck in book.glob("slides-*.html") if 'id="lecture-%s"' % number in deck.read_text(encoding="utf-8")]
            self.assertEqual(len(places), 1, number)


if __name__ == "__main__":
    shutil.rmtree(FOLDER, ignore_errors=True)
    FOLDER.mkdir(parents=True)
    unittest.main(argv=sys.argv[:1])
