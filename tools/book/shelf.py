"""shelf.py: what the book consists of and what can be pointed at: texts, chapters by parts, equations, figures, words, references.

Everything is found in the repository: docs/parts names the parts and the papers, and no number of chapters is known here.
"""
import os
import re
from pathlib import Path

NOT_IN_THE_BOOK = {"docs/instructor.md"}    # answers are no pages for readers


def slug(words):
    """The anchor that a heading gets where the repository is browsed."""
    return re.sub(r"[^\w\- ]", "", re.sub(r"<[^>]*>", "", words).lower()).replace(" ", "-")


def numbers(words):
    """The chapters that '1-3, 9, 5' names, in this order."""
    ranges = (piece.partition("-") for piece in words.split(","))
    return [n for first, _, last in ranges for n in range(int(first), int(last or first) + 1)]


class Book:
    """The texts of a repository, and where the pages are written."""

    def __init__(self, root, out):
        self.root, self.out, self.complaints = Path(root), Path(out), []
        self.page, self.text, self.sources, self.copied = {}, {}, {}, set()    # path -> page; page -> text; source -> page; files
        self.parts, self.papers, self.use = [], [], []
        self.evenings, self.evening_of, self.order, self.leads = [], {}, [], {}    # filled by evenings.py
        self.reference, self.rooms, self.engine, self.seek = {}, {}, False, None   # filled by book.py
        self.read_parts()
        for path, name in self.texts():
            if (self.root / path).is_file():
                self.page[path], self.text[name] = name, (self.root / path).read_text(encoding="utf-8")
        self.path = {name: path for path, name in self.page.items()}
        self.title = {name: re.search(r"^# (.*)", text, re.M)[1] for name, text in self.text.items()}
        reading = [n for _, inside in self.parts for n in inside]
        self.chapters = sorted((name for name in self.text if name.startswith("chapter-")),
                               key=lambda name: [*reading, int(name[-2:])].index(int(name[-2:])))
        for name in self.chapters:
            if int(name[-2:]) not in reading:
                self.complain("docs/parts", "%s is in no part" % name)
        told = ["chapter-" + n for n in re.findall(r"^\| \[\d+ .*?\]\(ch(\d\d)_", self.text.get("ways", ""), re.M)]
        if told != self.chapters:
            self.complain("docs/parts", "the order of chapters is %s, in chapters/README.md it is %s" % tuple(
                " ".join(name[-2:] for name in names) for names in (self.chapters, told)))
        self.equation, self.figure, self.entry, self.words = {}, {}, {}, {}
        self.find_places()

    def complain(self, where, what):
        if (where, what) not in self.complaints:
            self.complaints.append((where, what))

    def read_parts(self):
        for line in (self.root / "docs/parts").read_text(encoding="utf-8").splitlines():
            if not line.strip() or line.startswith("#"):
                continue
            kind, rest = line.split(" ", 1)
            name, _, what = rest.rpartition(": ") if kind != "use" else rest.partition(": ")
            if kind == "part":
                self.parts.append((name, numbers(what)))
            elif kind == "paper":
                letter, key = name.split()
                self.papers.append((letter, key, numbers(what)))
            elif kind == "use":
                self.use.append((name, what))
            else:
                self.complain("docs/parts", "expected part, paper or use: " + line)

    def texts(self):
        """Paths of texts and names of their pages."""
        for path, _ in self.use:
            yield path, "use" if path == "README.md" else "ways" if path == "chapters/README.md" else \
                "scenes" if path == "examples/README.md" else Path(path).stem.lower()
        for path in sorted(self.root.glob("docs/*.md")):
            path = str(path.relative_to(self.root))
            if path not in NOT_IN_THE_BOOK and path not in dict(self.use):
                self.use.append((path, None))
                yield path, Path(path).stem.lower()
        for path in sorted(self.root.glob("chapters/ch*/README.md")) + sorted(self.root.glob("chapters/ch*/exercises/*/README.md")):
            path = str(path.relative_to(self.root))
            m = re.match(r"chapters/ch(\d\d)_[^/]+/(?:exercises/ex(\d+)_)?", path)
            yield path, "exercise-%s-%s" % (m[1], m[2]) if m[2] else "chapter-" + m[1]

    def find_places(self):
        for name in self.chapters:
            chapter = int(name[-2:])
            for m in re.finditer(r'<a id="eq-(\w+)"></a>\s*```math\n(.*?)```', self.text[name], re.S):
                self.equation[chapter, m[1]] = (name, m[2])
            for m in re.finditer(r"^!\[Figure (\d+\.\d+): (.*)\]\((\S+)\)$", self.text[name], re.M):
                self.figure[m[1]] = (name, m[2], m[3])
        for m in re.finditer(r'<a id="(\w+)"></a>\n((?:.+\n?)+)', self.text.get("references", "")):
            self.entry[m[1]] = m[2]
        for m in re.finditer(r"^\| ([^|`*]+?) \|[^|]*\| (.*?) \|$", self.text.get("glossary", ""), re.M):
            if m[1] not in ("word", ":--") and not m[1].startswith("to "):
                self.words[re.sub(r"^an? ", "", m[1])] = m[2]

    def chapter_of(self, page):
        """The number of a chapter, of an exercise's, of a program's; None of other pages."""
        m = re.match(r"(?:chapter-|exercise-|chapters/ch)(\d\d)", page)
        return int(m[1]) if m else None

    def paper_of(self, page):
        """The letter of the paper whose equations a page has, or nothing."""
        return next((letter for letter, _, inside in self.papers if self.chapter_of(page) in inside), "")

    def part_of(self, page):
        chapter = self.chapter_of(page)
        return next((name for name, inside in self.parts if chapter in inside), "")

    def find_equation(self, page, number, letter=None):
        """(page, TeX) of equation (12) as said on this page, or of (A 12); a letter as number belongs to its page."""
        own = self.chapter_of(page)
        if letter:
            chapters = next((inside for name, _, inside in self.papers if name == letter), ())
        else:
            chapters = [own] + [c for _, _, inside in self.papers if own in inside and not number.isalpha() for c in inside if c != own]
        return next((self.equation[c, number] for c in chapters if (c, number) in self.equation), None)

    def equation_of_paper(self, key, number):
        """Where equation `number` of the paper with this key is explained, or None."""
        chapters = next((inside for _, name, inside in self.papers if name == key), ())
        return next(("%s.html#eq-%s" % (self.equation[c, number][0], number) for c in chapters if (c, number) in self.equation), None)

    def source_page(self, path):
        """The page of a source; asked for, it is made."""
        if path not in self.sources:
            self.sources[path] = "source-" + re.sub(r"[/.]", "-", re.sub(r"^(src/(signorini/)?|chapters/)", "", path))
        return self.sources[path]

    def resolved(self, page, url):
        """The path in the repository that a link of this page names, and its anchor."""
        path, _, anchor = url.partition("#")
        here = self.path.get(page, page)
        return (os.path.normpath(os.path.join(os.path.dirname(here), path)) if path else here), anchor

    def href(self, page, url):
        """Where a link of the Markdown leads; None: to a folder, which has no page.  What does not exist is a complaint."""
        if re.match(r"\w+:", url):
            return url
        full, anchor = self.resolved(page, url)
        anchor = "#" + anchor if anchor else ""
        if full in self.page:
            return ("" if self.page[full] == page and anchor else self.page[full] + ".html") + anchor
        if not (self.root / full).exists():
            self.complain(self.path.get(page, page), "dead link: " + url)
            return None
        if (self.root / full).is_dir():
            return self.page[full + "/README.md"] + ".html" if full + "/README.md" in self.page else None
        if re.search(r"\.[ch]pp$", full):
            return self.source_page(full) + ".html" + anchor
        self.copied.add(full)
        return "files/%s%s" % (full, "" if Path(full).suffix in (".svg", ".png") else ".txt")

    def picture(self, page, url, words):
        """An img with its size, so that nothing moves when it comes; width and height."""
        full, _ = self.resolved(page, url)
        file = self.root / full
        box = re.search(r'viewBox="0 0 ([\d.]+) ([\d.]+)"', file.read_text(encoding="utf-8", errors="ignore")) if file.is_file() else None
        if not box:
            self.complain(self.path.get(page, page), "no picture " + url)
            return "", 1, 1
        width, height = map(float, box.groups())
        script = file.with_suffix(".gp")
        field = script.is_file() and re.search(r"^[^#]*\bpalette\b", script.read_text(encoding="utf-8"), re.M)
        self.copied.add(full)
        return '<img src="files/%s" width="%.0f" height="%.0f" alt="%s" decoding="async"%s>' % (
            full, width, height, words, ' class="field"' if field else ""), width, height
