#!/usr/bin/env python3
"""mounts.py ROOT FOLDER: in a browser, a live figure is there before it is seen, or soon after a jump, and nothing moves when it comes;
without an engine the printed figure stands in its place; previews and search work from disk.  The engine of this test answers at once
with a panel of two points.  Needs chromium.
"""
import base64
import gzip
import json
import os
import shutil
import sys

sys.dont_write_bytecode = True
from book import FOLDER, ROOT, make, run

sys.path.insert(0, str(ROOT / "tools"))
from browser import Browser, Tab, chromium

GLUE = """var Signorini = async () => {
  const about = { title: "A press", controls: [{ name: "load", label: "load", least: 0, most: 1, step: 0.1, value: 0.5 }] };
  const answer = { says: "It rests.", numbers: [{ name: "f", label: "force", text: "1", unit: "N", value: 1 }], sets: [], table: [],
    panels: [{ title: "gap", x: "x", y: "y", window: [0, 1, 0, 1], layers: [{ x: 0, y: 1, look: "line", label: "gap" }] }] };
  return { HEAPF64: new Float64Array([0, 1, 0, 1]), ccall: (name, kind, types, [k]) => name === "live_size" ? (k < 2 ? 2 : -1) :
    name === "live_data" ? 16 * k : JSON.stringify(k.startsWith("figure ") ? about : answer) };
};"""
WATCH = """let moved = 0, at = null; new PerformanceObserver(l => { for (const e of l.getEntries()) moved += e.value; }).observe({ type: 'layout-shift', buffered: true });
  const live = document.querySelector('.live'), wait = ms => new Promise(r => setTimeout(r, ms)), high = () => document.documentElement.scrollHeight;
  for (let i = 0; i < 100 && document.documentElement.classList.contains('loading'); ++i) await wait(20);
  const before = high(), begin = () => performance.now();"""
SCROLLS = """(async () => { %s live.addEventListener('answered', () => { at ??= live.getBoundingClientRect().top - innerHeight; });
  scrollTo(0, live.getBoundingClientRect().top + scrollY - innerHeight - 100);
  for (let i = 0; i < 150 && at === null; ++i) await wait(20);
  for (let y = scrollY; y < high() - innerHeight; y += 90) { scrollTo(0, y); await wait(20); }
  await wait(100);
  return JSON.stringify([at, moved, high() - before, live.getBoundingClientRect().height]); })()""" % WATCH
JUMPS = """(async () => { %s const from = begin(); live.addEventListener('answered', () => { at ??= begin() - from; });
  scrollTo(0, live.getBoundingClientRect().bottom + scrollY + 5);
  for (let i = 0; i < 150 && at === null; ++i) await wait(20);
  return JSON.stringify([at, moved, high() - before]); })()""" % WATCH
PRINTED = """JSON.stringify([getComputedStyle(document.querySelector('.live')).display,
  document.querySelector('.live-printed img').getBoundingClientRect().width > 0])"""
PEEK = """(async () => { const wait = ms => new Promise(r => setTimeout(r, ms)), out = [];
  for (const to of ['#eq-1', 'exercise-01-2.html', 'glossary.html#active-set', 'source-papers-thing-hpp.html#solve_all']) {
    document.querySelector(`main a[href="${to}"]`).dispatchEvent(new MouseEvent('mouseover', { bubbles: true }));
    for (let i = 0; i < 40 && !document.getElementById('book-peek'); ++i) await wait(50);
    out.push(document.getElementById('book-peek')?.textContent ?? '');
    dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' })); }
  const find = document.getElementById('book-find');
  find.value = 'the active'; find.dispatchEvent(new Event('input'));
  for (let i = 0; i < 40 && !document.querySelector('.hit'); ++i) await wait(50);
  out.push(document.querySelector('.hit')?.href.replace(/.*\\//, ''));
  find.value = 'pairs nosuchword'; find.dispatchEvent(new Event('input'));
  await wait(100);
  out.push(document.getElementById('book-count').textContent + document.querySelector('.hit').textContent);
  return JSON.stringify(out); })()"""


def pack(text):
    return base64.b64encode(gzip.compress(text.encode())).decode()


def book(with_engine):
    """A small book with a live figure three screens below its top."""
    folder = make(FOLDER / ("engine" if with_engine else "printed"), [
        ("chapters/ch01_one/README.md", "![Figure 1.1", "%s<!-- live press -->\n\n![Figure 1.1" % ("A line of text.\n\n" * 60)),
        ("chapters/ch01_one/README.md", "does it.\n", "does it.\n\n" + "And then.\n\n" * 60), ("docs/rooms", "press 700 900", "press 570 585")])
    for name in ("page.css", "formula.css", "page.js", "peek.js", "find.js", "live.js", "live.css"):
        shutil.copy(ROOT / "docs" / name, folder / "docs")
    shutil.copytree(ROOT / "docs/fonts", folder / "docs/fonts", dirs_exist_ok=True)
    os.makedirs(folder / "out")
    if with_engine:
        (folder / "out/engine.js").write_text('self.signoriniEngine = { glue: "%s", wasm: "%s" };' % (pack(GLUE), pack("")), encoding="utf-8")
    code, said = run(folder)
    assert code == 0, said
    return str(folder / "out")


def looked_at(browser, folder, script, width=1280):
    tab = Tab(browser, folder)
    browser.call("Emulation.setDeviceMetricsOverride", tab.session, width=width, height=800, deviceScaleFactor=1, mobile=width < 600)
    found = tab.visit("chapter-01.html", script)
    assert not tab.bad, tab.bad
    browser.call("Page.close", tab.session)
    return json.loads(found)


def main():
    browser, faults = Browser(chromium()), []

    def check(what, right, found):
        if not right:
            faults.append("%s: %s" % (what, found))

    try:
        folder = book(True)
        for width in (1280, 390):
            at, moved, grown, height = found = looked_at(browser, folder, SCROLLS, width)
            check("a figure 100 px below the screen is there before it is seen, at %d" % width, at is not None and at > 0, found)
            check("nothing moves, at %d" % width, moved == 0 and abs(grown) <= 2, found)
            check("the figure fits its room, at %d" % width, height <= (570, 585)[width < 600] + 2, found)
            at, moved, grown = found = looked_at(browser, folder, JUMPS, width)
            check("a figure is there after a jump to below it, at %d" % width, at is not None, found)
            check("nothing moves after a jump, at %d" % width, moved == 0 and abs(grown) <= 2, found)
        found = looked_at(browser, folder, PEEK)
        for what, words, said in zip(("equation", "exercise", "word", "function", "search", "search for some"),
                                     ("(1), 1 One", "Do (1).", "pairs that are closed", "Solves all of", "chapter-01.html#the-gap",
                                      "Nothing has all of these words; these have some:Glossary"), found):
            check("preview or search: " + what, words in (said or ""), said)
        found = looked_at(browser, book(False), PRINTED)
        check("without an engine the printed figure stands there", found == ["none", True], found)
    finally:
        browser.close()
    print("\n".join(faults) or "all fine")
    sys.exit(1 if faults else 0)


main()
