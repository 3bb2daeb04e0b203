"""cut.py: what of a chapter goes to slides: the marks are those that a text has anyway, and nothing is written twice.

A heading begins slides.  On them stand the first sentence of a section; a paragraph's lead-in, *Euler-Bernoulli.*, with the sentence
that follows; a sentence that sets a new word in italics; a formula with the sentence before it; figures, boxes, short tables and
short listings; "Predict, then check" and its answer; lists.  Where this is not enough, <!-- slide --> before a paragraph takes it whole.
"""
import re

from blocks import Text

MASKED = re.compile(r"`[^`]*`|\$`.*?`\$|\$[^$]*\$|\]\([^)]*\)|<[^>]*>|\([^()]*[^.?!()]\)|\b(?:e\.g|i\.e|cf|No|Fig)\.")
EMPHASISED = re.compile(r"(?<![\w*])(\*\*?)([^*]+)([^*])\1")
END = re.compile(r"[.?!][*)]{0,2}(?=\s+[A-Z*`$\[“\"(]|\s*$)")
LEAD = re.compile(r"(\*\*?)(?=[^\s*])[^*]{2,60}[.?!:]\1(?= )")
NEW_WORD = re.compile(r"(?<![\w*])\*[a-z][^*]{2,40}\*(?![\w*])")
LONGEST = 330             # signs of a sentence on a slide that lists sentences
SHORT = 90                # a shorter one takes the next with it
LINE, GAP = 41, 16        # pixels of a line, and between sentences
WIDEST = 110              # signs of TeX in a row of a formula
LEFT_OUT = ("Possible extensions",)


def plain(words):
    """A sentence without the marks of its links, formulas and numbers, to be measured."""
    return re.sub(r"\]\([^)]*\)|<!--.*?-->|[\[*`$\\{}]", "", words)


def sentences(words):
    """The sentences of a paragraph."""
    words = re.sub(r"<!--.*?-->", "", " ".join(words.split()))
    hidden = MASKED.sub(lambda m: m[0][0] + "x" * (len(m[0]) - 1), words)
    hidden = EMPHASISED.sub(lambda m: m[1] + "x" * len(m[2]) + m[3] + m[1], hidden)    # ends within emphasis are none
    ends = [m.end() for m in END.finditer(hidden)]
    cuts = [0] + ends + ([len(words)] if not ends or words[ends[-1]:].strip() else [])
    return [words[a:b].strip() for a, b in zip(cuts, cuts[1:]) if words[a:b].strip()]


def grown(said, begun):
    """The first sentence, and more if it is short: `begun`, no more than a lead-in."""
    words = " ".join(said[:2] if begun else said[:1])
    rest = said[2:] if begun else said[1:]
    if rest and len(plain(words)) < SHORT and len(plain(words + rest[0])) <= LONGEST and not rest[0].endswith((",", ":")):
        words += " " + rest[0]
    return words


def told(paragraph, first):
    """The sentences of a paragraph that go to a slide; `first`: it begins its section."""
    said = sentences(paragraph)
    lead = LEAD.match(paragraph)
    if lead and said:    # the lead-in may be a sentence of its own
        return [grown(said, said[0] == lead[0])]
    keep = [grown(said, False)] if first else []
    keep += [s for s in said if NEW_WORD.search(s) and s not in " ".join(keep)]
    return [s for s in keep if len(plain(s)) <= LONGEST and not s.endswith((",", ":"))]


class Piece:
    """A part of a slide: its kind, its HTML and how high it is, in pixels of a slide of 1280 x 720."""

    def __init__(self, kind, html, high=0, head=None):
        self.kind, self.html, self.high, self.head = kind, html, high, head


def lines_of(words, of_line=78):
    return -(-len(plain(words)) // of_line)


def height_of_formula(tex):
    rows = tex.count("\\\\") + 1
    return 24 + (92 if re.search(r"\\frac|\\int|\\sum|pmatrix|cases", tex) else 52) * rows


class Cut(Text):
    """The slides of one chapter, as sections: (heading, anchor, pieces)."""

    def __init__(self, book, page):
        super().__init__(book, page)
        self.parts, self.before, self.whole, self.first, self.live = [("", "", [])], "", False, True, ""

    def add(self, kind, html, high=0, head=None):
        self.parts[-1][2].append(Piece(kind, html, high, head))

    def sentence(self, words):
        self.add("point", "<p>%s</p>" % self.html(words), LINE * lines_of(words) + GAP)

    def cut(self):
        """Goes through the text, block by block."""
        lines, i = self.book.text[self.page].split("\n"), 0
        while i < len(lines):
            if lines[i].startswith("<!-- slide"):
                self.whole = True
            self.out = []
            j = self.mark(lines, i)
            if j is None:
                j = self.block(lines, i)
                self.take("\n".join(lines[i:j]), "".join(self.out))
            elif self.out:
                self.live = "".join(self.out)
            i = j
        return [part for part in self.parts if part[2] and part[0] not in LEFT_OUT]

    def take(self, text, html):
        """One block."""
        kind = re.match(r"#+ |!\[|> |\||(?:```)\w*|<details>|[*-] |\d+\. |", text)[0].strip()
        if kind.startswith("#"):
            self.heading_of_slides(text, html)
        elif kind == "![":
            self.figure(html)
        elif kind == ">":
            self.box(text)
        elif kind == "|":
            self.table(text, html)
        elif kind == "```math":
            self.formula(text, html)
        elif kind.startswith("```"):
            self.listing(text, html)
        elif kind == "<details>":
            self.answer(text)
        elif kind:
            self.list(text)
        else:
            self.paragraph_of_slides(text)
        self.before = text if not kind else ""

    def heading_of_slides(self, text, html):
        if text.startswith("## "):
            anchor = re.search('id="([^"]+)"', html)[1]
            self.parts.append((text[3:], anchor, []))
            self.first = True

    def figure(self, html):
        live, self.live = self.live, ""
        self.add("computed" if live else "figure", live + html)

    def box(self, text):
        m = re.match(r"\*\*(Misprint|Left open|Our verdict)\.\*\* *(.*)", " ".join(t[1:].strip() for t in text.split("\n")))
        if not m:
            return
        kept, room = [], 12
        for said in sentences(m[2]):
            room -= lines_of(said)
            if room < 0:
                break
            kept.append(said)
        self.add("box " + m[1].split()[-1].lower(), "<p>%s</p>" % self.html(" ".join(kept)), 0, m[1])

    def table(self, text, html):
        rows = [[len(plain(re.sub("<!--.*?-->", "", cell)).strip()) for cell in row.strip("| ").split("|")] for row in text.split("\n")]
        wide = sum(max(row[k] for row in rows if k < len(row)) + 3 for k in range(len(rows[0])))
        if len(rows) <= 11 and wide <= 92:
            self.add("table", html, 42 * (len(rows) - 1) + 20)

    def formula(self, text, html):
        row = max(map(len, re.sub(r"\\(?:left|right|tag\{.*?\}|q+uad)|\\[a-zA-Z]+", "x", text).split("\\\\")))
        html = '<div class="small">%s</div>' % html if row > WIDEST else html
        last = sentences(self.before)[-1] if self.before else ""
        lead = last if len(plain(last)) <= LONGEST and last.endswith((",", ":", ".")) else ""
        if lead and not any(self.html(lead) in piece.html for piece in self.parts[-1][2]):
            html, high = "<p>%s</p>%s" % (self.html(lead), html), LINE * lines_of(lead) + GAP
        else:
            high = 0
        self.add("formula", html, high + height_of_formula(text))

    def listing(self, text, html):
        rows = text.split("\n")[1:-1]
        if 3 < len(rows) <= 20 and max(map(len, rows)) <= 100 and not text.startswith("```sh"):
            self.add("listing", html, 26 * len(rows) + 90)

    def answer(self, text):
        head = re.sub("<.*?>", "", text.split("\n")[0])
        inside = re.sub("</?details>|<summary>.*?</summary>", "", text).split("\n\n")
        said = [s for s in inside if s.strip() and not s.startswith(("|", "`"))]
        if said and self.parts[-1][2] and self.parts[-1][2][-1].kind == "predict":
            self.add("answer", "".join("<p>%s</p>" % self.html(" ".join(s.split())) for s in said), 0, head)

    def list(self, text):
        whole = self.parts[-1][0] in ("Key ideas", "Exercises")
        for item in re.split(r"\n(?=[*-] |\d+\. )", text):
            said = sentences(re.sub(r"^([*-]|\d+\.) ", "", item))
            if not said:
                continue
            lead = LEAD.match(" ".join(said))
            words = " ".join(said) if whole else grown(said, lead and said[0] == lead[0])
            if self.parts[-1][0] == "Exercises":
                words = re.sub(r" `make ex[\d.]+`$", "", words)
            if len(plain(words)) <= LONGEST or whole:
                self.add("point", "<p class='item'>%s</p>" % self.html(words), LINE * lines_of(words, 75) + GAP)

    def paragraph_of_slides(self, text):
        words = " ".join(text.split())
        learn = re.match(r"\*\*What you will learn\.?\*\* (.*)", words)
        if learn:
            self.parts.append(("What you will learn", "", []))
            for said in re.split(r"(?<=;) (?:and )?", re.split(r" (?:Paper|Papers|Program|Programs|Signs and words): ", learn[1])[0]):
                self.sentence(said[:1].upper() + said[1:].rstrip(";").rstrip(".") + ".")
            self.parts.append(("", "", []))
        elif re.match(r"\*\*Predict, then check\.?\*\*", words):
            self.add("predict", "<p>%s</p>" % self.html(re.sub(r"^\*\*.*?\*\* ", "", words)), 0, "Predict, then check")
        elif self.whole:
            self.sentence(words)
        elif self.parts[-1][1]:
            for said in told(words, self.first):
                self.sentence(said)
        self.first = self.first and not self.parts[-1][1]
        self.whole = False
