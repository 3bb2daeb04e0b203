"""printed.py: what a reader of the printed book finds, for book-pdf.py: places and pages, what is white, what can be searched.

Needs pdftoppm and pdftotext, of Debian's poppler-utils.
"""
import collections
import re
import shutil
import subprocess
import unicodedata

DOTS = 24           # per inch, to see what is white on a page
MOST = 1 / 3        # of the height of a page may be white, but on the last of a chapter
TOOLS = ("pdftoppm", "pdftotext")


def missing():
    """The programs that are not here."""
    return [name for name in TOOLS if not shutil.which(name)]


class Pdf:
    """The file as written: the number of pages, the page of every place that is linked to, headings, and bitmaps by page."""

    def __init__(self, data):
        self.objects = {int(n): body for n, body in re.findall(rb"(?s)(?:^|\n)(\d+) 0 obj\n(.*?)\nendobj", data)}
        catalog = next(body for body in self.objects.values() if b"/Type /Catalog" in body)
        self.pages = {number: i + 1 for i, number in enumerate(self.kids(self.reference(catalog, b"Pages")))}
        places = self.objects.get(self.reference(catalog, b"Dests") or -1, b"")
        self.places = {name.decode(): self.pages[int(page)] for name, page in re.findall(rb"/([\w.-]+) \[(\d+) 0 R", places)}
        self.headings = self.outline(self.reference(catalog, b"Outlines"))
        bitmaps = {n for n, body in self.objects.items() if b"/Subtype /Image" in body}
        self.bitmaps = {self.pages[n]: len(there) for n in self.pages if (there := bitmaps & self.drawn(n))}

    @staticmethod
    def reference(body, key):
        match = re.search(rb"/%s (\d+) 0 R" % key, body)
        return int(match[1]) if match else None

    def kids(self, number):
        body = self.objects[number]
        if b"/Type /Pages" not in body:
            return [number]
        inside = re.search(rb"(?s)/Kids \[(.*?)\]", body)[1]
        return [page for kid in re.findall(rb"(\d+) 0 R", inside) for page in self.kids(int(kid))]

    def outline(self, number):
        """Page, left and upper edge of every heading, in points from the lower left corner, in the order of the book."""
        found = []
        while number:
            body = self.objects[number]
            place = re.search(rb"/Dest \[(\d+) 0 R /XYZ ([\d.]+) ([\d.]+) ", body)
            if place:
                found.append((self.pages[int(place[1])], float(place[2]), float(place[3])))
            found += self.outline(self.reference(body, b"First"))
            number = self.reference(body, b"Next")
        return found

    def drawn(self, page):
        """The objects that a page draws."""
        drawn, new = set(), {page}
        while new:
            drawn |= new
            parts = [re.search(rb"(?s)/XObject <<(.*?)>>", self.objects[n]) for n in new]
            new = {int(n) for part in parts if part for n in re.findall(rb"(\d+) 0 R", part[1])} - drawn
        return drawn


class Sheet:
    """A page as it is seen, row by row, without what is in its upper and lower margin."""

    def __init__(self, rows, margins):
        upper, lower = (round(mm / 25.4 * DOTS) for mm in margins)
        self.top, self.height, self.rows = upper, len(rows), rows[upper:len(rows) - lower]

    def white(self):
        """The share of the height of the text that is white in one piece."""
        longest = blank = 0
        for row in self.rows:
            blank = blank + 1 if min(row) > 250 else 0
            longest = max(longest, blank)
        return longest / len(self.rows)

    def below(self, left, bottom, width):
        """Is something below a point of the page, in points from its lower left corner, in a column of that width?"""
        first, last, row = (round(x * DOTS / 72) for x in (left, left + width, bottom))
        return any(min(line[first:last]) < 250 for line in self.rows[self.height - row + 1 - self.top:])


def sheets(file, margins):
    """The pages of a file as they are seen, between an upper and a lower margin in mm."""
    drawn = subprocess.run(["pdftoppm", "-r", str(DOTS), "-gray", file], stdout=subprocess.PIPE, check=True).stdout
    seen, at = [], 0
    while at < len(drawn):
        head = re.compile(rb"P5\n(\d+) (\d+)\n255\n").match(drawn, at)
        width, height, at = int(head[1]), int(head[2]), head.end()
        seen.append(Sheet([drawn[at + row * width:at + (row + 1) * width] for row in range(height)], margins))
        at += width * height
    return seen


def ill_set(pdf, seen, headings):
    """What is wrong with the pages: white, headings without text; headings as told() of print.js has them."""
    if len(pdf.headings) != len(headings):
        return ["the outline has %d of %d headings" % (len(pdf.headings), len(headings))]
    ends, wrong = {len(seen)}, []
    for (page, left, top), (words, level, height, width) in zip(pdf.headings, headings):
        if level == "H1":
            ends.add(page - 1)
        if not seen[page - 1].below(left, top - height, width):
            wrong.append("page %d: a heading at its foot: %s" % (page, words))
    return wrong + ["page %d: %.0f %% of it are white" % (n, 100 * page.white())
                    for n, page in enumerate(seen, 1) if n not in ends and page.white() > MOST]


def unsearched(file, formulas):
    """The signs of formulas that the text of the file does not have as often as they."""
    text = subprocess.run(["pdftotext", file, "-"], stdout=subprocess.PIPE, check=True).stdout.decode()
    there = collections.Counter(unicodedata.normalize("NFKC", text))
    asked = collections.Counter(sign for formula in formulas for sign in unicodedata.normalize("NFKC", formula) if sign.strip())
    return ["of %d signs %s in formulas a search finds %d" % (n, sign, there[sign]) for sign, n in asked.items() if there[sign] < n]
