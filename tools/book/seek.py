"""seek.py: what the search finds: the words of every section of every page, in one script that page.js loads when it is needed.

A page that is read from disk may load a script, but nothing else; so there is one list of sections, each with its page, its anchor,
its heading and its words, and the browser looks through it.
"""
import html
import json
import re

HEADING = re.compile(r'<h([23]) id="([^"]+)">(.*?)<a class="self".*?</h\1>', re.S)
DROPPED = re.compile(r'<(nav|svg|summary)\b.*?</\1>|<pre.*?</pre>|<div class="leads">.*?</div>|<[^>]*>', re.S)


def words_of(piece):
    """What a reader sees of a piece of HTML, without its listings."""
    piece = re.sub(r"</(?:p|li|td|th|h\d|div|figcaption|section)>", r" \g<0>", piece)
    return " ".join(html.unescape(DROPPED.sub("", piece)).split())


class Seek:
    """The sections of all pages."""

    def __init__(self):
        self.titles, self.rows = [], []

    def add(self, page, title, main):
        """The sections of a page; a source is one."""
        self.titles.append([page, html.unescape(re.sub(r"[`$*]", "", title))])
        at = len(self.titles) - 1
        body = re.sub(r'<header class="title">.*?</header>', "", main, flags=re.S)
        parts = [body] if page.startswith("source") else HEADING.split(body)
        self.row(at, "", "", parts[0])
        for k in range(1, len(parts), 4):
            self.row(at, parts[k + 1], words_of(parts[k + 2]), parts[k + 3])

    def row(self, at, anchor, heading, piece):
        words = words_of(piece)
        if words or heading:
            self.rows.append([at, anchor, heading, words])

    def write(self, folder, functions):
        """functions: page -> names that it declares."""
        text = "signoriniSeek(%s);\n" % ",\n".join(json.dumps(part, ensure_ascii=False, separators=(",", ":")).replace("</", "<\\/")
                                                  for part in (self.titles, self.rows, functions))
        (folder / "seek.js").write_text(text, encoding="utf-8")
