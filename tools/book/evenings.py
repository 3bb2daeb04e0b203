"""evenings.py: the order in which the library is read, src/evenings, as texts of the book: what each evening is about and its pages."""
import os
import re
import subprocess

from sources import markdown, split, title_of


def read_list(book):
    """[title, what it is about, files] of each evening."""
    found = []
    for line in (book.root / "src/evenings").read_text(encoding="utf-8").split("\n"):
        m = re.match(r"evening \d+: (.+)", line)
        if m:
            found.append((m[1], [], []))
        elif found and line.startswith(" "):
            found[-1][1].append(line.strip())
        elif found and re.match(r"\w[\w/]*$", line):
            found[-1][2].extend(path for path in ("src/%s.hpp" % line, "src/%s.cpp" % line) if (book.root / path).is_file())
    return found


def first_sentence(text):
    """What the comment at the head of a file begins with; empty if that is a formula."""
    prose = markdown([line for line in split(text.split("\n"))[0][0] if not re.match(r"# |This header is internal", line)])
    m = re.match(r"\s*(.*?[.:])(?:\s|$)", "\n".join(prose), re.S)
    return re.sub(r":$", ".", " ".join(m[1].split())) if m and "```" not in m[1] and not m[1].lstrip().startswith("- ") else ""


def line_of(book, path):
    text = (book.root / path).read_text(encoding="utf-8")
    title = title_of(text)
    return "- %s[`%s`](%s), %d lines. %s" % (
        title + ": " if title else "", os.path.basename(path), path[4:], text.count("\n"), first_sentence(text))


def add(book):
    """Puts the evenings among the texts of the book, and their files among its sources."""
    evenings = read_list(book)
    pages = ["# Reading Signorini in six evenings", "",
             "The library is short enough to be read. Its files stand here in an order in which what is used is explained before.",
             "Each is a page, made from the file itself, and every function leads to its contract, its tests, the chapters that use",
             "it and the equations of the papers. Two more evenings are for what the papers print.", ""]
    for n, (title, about, files) in enumerate(evenings, 1):
        lines = sum((book.root / path).read_text(encoding="utf-8").count("\n") for path in files)
        pages.append("- [Evening %d: %s](evening-%d), %d files, %d lines" % (n, title, n, len(files), lines))
        text = ["# Evening %d: %s" % (n, title), "", *about, "", *(line_of(book, path) for path in files)]
        put(book, "evening-%d" % n, "src/evening-%d" % n, text)
        for path in files:
            own = title_of((book.root / path).read_text(encoding="utf-8"))
            book.title[book.source_page(path)] = own or os.path.basename(path)
            book.evening_of[path] = ("evening-%d" % n, "Evening %d · %s" % (n, title))
            book.order.append(path)
    put(book, "evenings", "src/evenings", pages)
    book.evenings = ["evenings"] + ["evening-%d" % n for n in range(1, len(evenings) + 1)]


def put(book, name, path, lines):
    book.page[path], book.path[name], book.text[name], book.title[name] = name, path, "\n".join(lines), lines[0][2:]


def read_leads(book):
    """path -> line -> what leads from the functions that begin there, from tools/evenings.pl."""
    said = subprocess.run(["perl", str(book.root / "tools/evenings.pl"), "--leads", str(book.root)], stdout=subprocess.PIPE, check=True,
                          encoding="utf-8").stdout
    for line in said.splitlines():
        path, number, lead = line.split("\t")
        book.leads.setdefault(path, {}).setdefault(int(number), []).append(lead)
