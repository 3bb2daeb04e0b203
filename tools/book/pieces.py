"""pieces.py: what stands between the paragraphs of a text: formulas, listings, figures, live figures, boxes, tables."""
import html
import os
import re

import cxx
from shelf import slug

BOX = re.compile(r"\*\*(Misprint|Left open|Our verdict)\.\*\* ?(.*)", re.S)
HOIST = re.compile(r'<div class="hoist">((?:<details class="note .*?</details>)+)(.*)</div>', re.S)
LONG_BOX = 700              # signs; a longer one is folded
WIDE_LINE = 66              # columns; a listing with longer lines is as wide as column and margin together
LONGEST_LINE = 100          # columns that a screen of 1280 pixels shows; longer lines are broken
ROOM = (900, 1500)          # pixels of a live figure that nobody has measured, at 1280 and at 390
NUMBER = re.compile(r"[−+±–-]?[\d.,]+(e[-+]?\d+)?\D{0,12}$|[−–-]?$")


def attribute(name, value):
    return ' %s="%s"' % (name, value) if value else ""


def signs(piece):
    """How many signs of a piece of HTML are seen."""
    return len(re.sub(r"<[^>]*>", "", piece))


def fence(text, code, language):
    """A listing, or a formula on a line of its own."""
    anchor, source, text.source = text.take_anchor(), text.source, ""
    if language == "math":
        mathml, tag = text.inline.math(code, True)
        number = " ".join(filter(None, [text.book.paper_of(text.page) if tag and tag.isdigit() else "", tag]))
        wide = signs(mathml) - 0.5 * len(re.findall("<msu[bp]", mathml)) + 3 * code.count("qquad") > 42
        link = '<a class="tag" href="#%s">(%s)</a>' % (anchor, number) if tag else ""
        return '<div class="eq%s"%s><div class="scroll">%s</div>%s</div>' % (" wide" if wide else "", attribute("id", anchor), mathml, link)
    head = '<figcaption><a href="%s">%s</a></figcaption>' % (
        text.book.href(text.page, source), os.path.basename(source)) if source else ""
    columns = max(map(len, code.split("\n")))
    wide = (" wide" if columns > WIDE_LINE else "") + (" long" if columns > LONGEST_LINE else "")
    shown = cxx.highlighted(code, language, cxx.linker(text.book))
    return '<figure class="code%s %s"%s>%s<pre><code>%s</code></pre></figure>' % (
        wide, language or "text", attribute("id", anchor), head, shown)


def figure(text, words, url, printed=False):
    """A picture and its caption; `printed`: the same as the live figure before it shows, folded where that computes."""
    img, width, height = text.book.picture(text.page, url, html.escape(re.sub(r"[$`\\*]", "", words)))
    m = re.match(r"Figure (\d+\.\d+): ?(.*)", words)
    wide = " wide" if width / height > 1.75 and width > 560 else ""    # no letters larger than the text's
    caption = "<b>Figure %s</b> %s" % (m[1], text.html(m[2][:1].upper() + m[2][1:], False)) if m else text.html(words, False)
    whole = '<figure class="picture%s"%s><figcaption>%s</figcaption>%s</figure>' % (
        wide, attribute("id", "fig-" + m[1].replace(".", "-") if m else ""), caption, img)
    if not printed:
        return whole
    return '<details class="live-printed"%s><summary>%s, as printed</summary>%s</details>' % (
        "" if text.book.engine else " open", words.split(":")[0], whole)


def live(text, name):
    """The place of a figure that computes, as high as the figure will be: nothing moves when it comes."""
    found = sorted(text.book.root.glob("chapters/*/live/%s.cpp" % name))
    if not found:
        text.book.complain(text.book.path[text.page], "no live figure %s: expected chapters/*/live/%s.cpp" % (name, name))
        return ""
    path = str(found[0].relative_to(text.book.root))
    wide, narrow = text.book.rooms.get(name, ROOM)
    return '<div class="live" data-figure="%s" id="live-%s" data-source="%s.html" data-label="live/%s.cpp" %s></div>' % (
        name, name, text.book.source_page(path), name, 'style="--room:%dpx;--room-phone:%dpx"' % (wide, narrow))


def box(text, lines):
    """A quotation; Misprint, Left open and Our verdict are notes in the margin, beside what they comment."""
    said = " ".join(lines)
    m = BOX.match(said)
    if not m:
        text.out.append("<blockquote>%s</blockquote>" % text.html(said))
        return
    text.boxes += 1
    note = '<details class="note %s" id="%s"%s><summary>%s</summary><p>%s</p></details>' % (
        m[1].split()[-1].lower(), text.take_anchor() or "box-%d" % text.boxes,
        " open" if len(re.sub(r"<!--.*?-->", "", m[2])) < LONG_BOX else "", m[1], text.html(m[2]))
    m = HOIST.fullmatch(text.out[-1]) if text.out else None
    if m:    # two in a row stand above each other, beside what both comment
        text.out[-1:], note = [m[2]], m[1] + note
    k = beside(text.out, note)
    text.out[k:] = ['<div class="hoist">%s%s</div>' % (note, "".join(text.out[k:]))]    # page.css puts it last where there is no margin


def beside(out, note):
    """Before which of the last blocks a note comes, so that it stands beside them and nothing wide has to wait for its end."""
    def height(piece, of_line, of_text):
        return signs(piece) / of_line * of_text + 30
    k, room, need = len(out), 0, height(note, 34, 21) * 0.7
    while k and len(out) - k < 4 and room < need and re.match(r'<p|<ul|<div class="eq"', out[k - 1]):
        k -= 1
        room += 90 if out[k].startswith("<div") else height(out[k], 66, 28)
    return k


def cells_of(row):
    return [cell.strip().replace("\1", "|") for cell in re.sub(r"\\\|", "\1", re.sub(r"`[^`]*`", lambda m: m[0].replace("|", "\1"),
                                                                                   row.strip())).strip("|").split("|")]


def table(text, rows):
    """A table; columns of numbers stand to the right, whatever the source says of columns of words."""
    head, rule, *body = [cells_of(row) for row in rows] + ([[]] if len(rows) < 2 else [])
    right = [mark.endswith(":") and not mark.startswith(":-") for mark in rule]
    right = [r and sum(bool(NUMBER.match(plain(row[k]))) for row in body if k < len(row)) > len(body) / 2 for k, r in enumerate(right)]

    def cell(tag, words, k):
        return "<%s%s>%s</%s>" % (tag, ' class="num"' if k < len(right) and right[k] else "", text.html(words, False), tag)

    lines = ""
    for row in body:
        key = slug(re.sub(r"^an? ", "", row[0])) if text.page == "glossary" else ""
        lines += "<tr%s>%s</tr>" % (attribute("id", key), "".join(cell("td", words, k) for k, words in enumerate(row)))
    wide = len(head) > 5 or sum(map(len, head)) > 55 or any(len(plain(words)) > 60 for row in body for words in row)
    return '<div class="table%s%s"><table><thead><tr>%s</tr></thead><tbody>%s</tbody></table></div>' % (
        " dense" if len(head) > 7 else "", " wide" if wide else "", "".join(cell("th", words, k) for k, words in enumerate(head)), lines)


def plain(words):
    """The words of a cell without their marks and links."""
    return re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", re.sub(r"<!--.*?-->", "", words)).strip("*`$ ")
