#!/usr/bin/env python3
"""book-pdf.py [BOOK] [FILE] | --ready

Prints the web pages in BOOK (default build/book) as one book, FILE (default build/signorini.pdf): title, contents with
page numbers, the chapters with their exercises, notation, lists, references and hints.  Formulas are text, figures are vectors.
Ends with status 1, and without a file, if a link of the book leads nowhere, or a formula, a listing, a table or a figure
would be missing or cut or a bitmap, a sign of a formula cannot be searched, a page that is not the last of a chapter is white by
more than a third, a heading stands at its foot, or no face of this machine has a letter of the book.  The pages are named, and
lie in FILE.wrong.  Needs python3, chromium, poppler-utils and hyphen-en-gb.
With --ready it prints nothing: its status says whether browser and faces are there, its words what is missing.

A browser prints, and not TeX, because the pages are at home in it: the formulas, code and figures of the book are those of
the web pages, one source and one dialect, and the browser is there already where pages are checked.  Pandoc with XeLaTeX
would be 196 MB more to download (Debian 12, with Chinese), and would need the marks of the texts a second time.
"""
import base64
import glob
import json
import os
import re
import sys
import tempfile
import time

sys.dont_write_bytecode = True    # no __pycache__ beside the tools
from browser import Browser, chromium
from printed import Pdf, ill_set, missing, sheets, unsearched

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BEFORE, AFTER = ["index", "use", "ways"], ["notation", "glossary", "equations", "words", "references"]
MARGINS = (18, 19, 16, 19)    # of A4 in mm: top, right, bottom, left
SHEET = {"width": (210 - MARGINS[1] - MARGINS[3]) * 96 / 25.4, "height": (297 - MARGINS[0] - MARGINS[2]) * 96 / 25.4, "line": 3 * 14 * 96 / 72}
HYPHENS = "/usr/share/hyphen/hyph_en_GB.dic"
PASSES = 5       # until every number is that of its page
SECONDS = 900    # for an answer of the browser, on a busy machine

PAGE = """<!DOCTYPE html><html lang="en" class="light"><head><meta charset="utf-8"/><title>Signorini</title>
<link rel="stylesheet" href="@BOOK@/page.css"/><link rel="stylesheet" href="@BOOK@/formula.css"/>
<link rel="stylesheet" href="@DOCS@/print.css"/>
<style>@page { size: A4; margin: @MARGIN@; @bottom-center { content: counter(page); font: 9pt Pagella, serif; } }
@page :first { @bottom-center { content: none; } }</style>
<script src="@DOCS@/print.js"></script><script src="@DOCS@/flow.js"></script></head><body></body></html>
"""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def names(folder):
    """The pages that make the book, in its order."""
    there = {f[:-5] for f in os.listdir(folder) if f.endswith(".html")}
    order = [name for name in BEFORE if name in there]
    for chapter in dict.fromkeys(re.findall(r'href="(chapter-\d\d)\.html"', read(os.path.join(folder, "index.html")))):
        order.append(chapter)
        exercises = [name for name in there if re.fullmatch("exercise" + chapter[7:] + r"-\d+", name)]
        order += sorted(exercises, key=lambda name: int(name.rsplit("-", 1)[1]))
    return order + [name for name in AFTER if name in there]


def letters():
    """The signs of the book's texts."""
    texts = glob.glob(os.path.join(ROOT, "chapters/**/*.md"), recursive=True) + glob.glob(os.path.join(ROOT, "docs/*.md"))
    return "".join(sorted(set("".join(map(read, texts)))))


def wanting(printer):
    """What this machine does not have."""
    faceless = printer.ask("faceless(%s)" % json.dumps(letters()))
    wrong = ["no face has these letters: " + faceless] if faceless else []
    wrong += ["no " + name for name in missing() + [HYPHENS] * (not os.path.exists(HYPHENS))]
    return [words + ": tools/setup.sh print" for words in wrong]


class Printer:
    """One page of a browser, the book in it, and its print."""

    def __init__(self, browser, url):
        self.browser = browser
        target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        browser.call("Page.enable", self.session)
        browser.call("Emulation.setEmulatedMedia", self.session, media="print")
        browser.call("Page.navigate", self.session, url=url)
        self.wait("document.readyState === 'complete'")

    def ask(self, script):
        result = self.browser.call("Runtime.evaluate", self.session, expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in result:
            sys.exit("book-pdf.py: " + result["exceptionDetails"].get("exception", {}).get("description", "the page failed"))
        return result["result"].get("value")

    def wait(self, condition):
        end = time.time() + SECONDS
        while not self.ask(condition):
            if time.time() > end:
                sys.exit("book-pdf.py: the browser needs more than %d s for: %s" % (SECONDS, condition))
            time.sleep(0.1)

    def pdf(self):
        return base64.b64decode(self.browser.call(
            "Page.printToPDF", self.session, preferCSSPageSize=True, printBackground=True, generateDocumentOutline=True,
            generateTaggedPDF=True)["data"])


def contents(folder):
    """What print.js joins."""
    brief = re.search(r'PROJECT_BRIEF\s*=\s*"(.*?)[:"]', read(os.path.join(ROOT, "docs/Doxyfile.in")))
    cited, licence = read(os.path.join(ROOT, "CITATION.cff")), read(os.path.join(ROOT, "LICENSE"))
    authors, = re.findall(r'(?ms)^authors:\n  - name: "(.*?)"$', cited)
    version, = re.findall(r"(?m)^version: (.*)$", cited)
    right, = re.findall(r"(?m)^Copyright \(c\) (.*)$", licence)
    book = {"base": "file://" + folder + "/", "brief": brief[1], "authors": authors, "version": "Version " + version,
            "licence": "© %s. %s: free to use, copy, change and share, with this notice." % (right, licence.split("\n")[0]),
            "pages": [{"name": name, "html": read(os.path.join(folder, name + ".html"))} for name in names(folder)]}
    drawn = {src for page in book["pages"] for src in re.findall(r'<img src="([^":]+\.svg)"', page["html"])}
    book["pictures"] = {src: read(os.path.join(folder, src)) for src in drawn if os.path.exists(os.path.join(folder, src))}
    return book


def printed(printer, book, target):
    """Writes the file.  Returns words on what is in it, and what is wrong."""
    wrong = wanting(printer)
    if wrong:    # without any face a browser may wait for ever
        return "", wrong
    wrong = printer.ask("join(%s)" % json.dumps(book))
    printer.ask("settle()")
    printer.wait("ready")
    printer.ask("hyphenate(%s)" % json.dumps(read(HYPHENS)))
    printer.ask("floats(%s)" % json.dumps(SHEET))
    wrong += printer.ask("misfits()")
    if wrong:
        return "", wrong
    first = {}
    for _ in range(PASSES):    # numbers may move what they number
        data = printer.pdf()
        last = Pdf(data)
        if last.places == first:
            break
        first = last.places
        printer.ask("number(%s)" % json.dumps(first))
    with open(target, "wb") as file:
        file.write(data)
    asked = printer.ask("[...document.querySelectorAll('.page')].map(e => e.dataset.place)")
    wrong += ["its number moves " + place for place in asked if last.places.get(place) != first.get(place)]
    wrong += ["no page for " + place for place in asked if place not in last.places]
    wrong += ["page %d: bitmaps, %d of them" % item for item in last.bitmaps.items()]
    told = printer.ask("told()")
    wrong += ill_set(last, sheets(target, MARGINS[::2]), told["headings"]) + unsearched(target, told["formulas"])
    return "%d pages, %d formulas, %d places, %.1f MB" % (len(last.pages), len(told["formulas"]), len(last.places), len(data) / 1e6), wrong


def work(folder, ask):
    """What ask(printer) returns, asked of an empty sheet with the styles of the book in FOLDER."""
    program = chromium()
    if not program:
        sys.exit("book-pdf.py: no chromium found, run: tools/setup.sh print")
    browser = Browser(program, SECONDS)
    with tempfile.NamedTemporaryFile("w", suffix=".html") as sheet:
        sheet.write(PAGE.replace("@DOCS@", os.path.join(ROOT, "docs")).replace("@BOOK@", folder).replace("@MARGIN@", " ".join("%dmm" % m for m in MARGINS)))
        sheet.flush()
        try:
            return ask(Printer(browser, "file://" + sheet.name))
        except (EOFError, TimeoutError) as error:
            sys.exit("book-pdf.py: %s" % error)
        finally:
            browser.close()


def main():
    if sys.argv[1:] == ["--ready"]:
        sys.exit("\n".join(work(os.path.join(ROOT, "docs"), wanting)) or 0)
    folder = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/book")
    target = os.path.abspath(sys.argv[2] if len(sys.argv) > 2 else "build/signorini.pdf")
    if not os.path.exists(os.path.join(folder, "index.html")):
        sys.exit("book-pdf.py: no pages in %s, run: make book" % folder)
    if os.path.exists(target):
        os.remove(target)
    said, wrong = work(folder, lambda printer: printed(printer, contents(folder), target))
    if wrong:
        if os.path.exists(target):
            os.replace(target, target + ".wrong")
        sys.exit("\n".join(wrong + ["book-pdf.py: %d problems" % len(wrong)]))
    print("%s: %s" % (target, said))


main()
