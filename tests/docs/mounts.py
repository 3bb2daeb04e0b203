#!/usr/bin/env python3
"""mounts.py ROOT FOLDER: in a browser, a live figure is there before it is seen, or soon after a jump, and nothing moves when it comes;
the printed figure stays until the first answer; axes stay, what was visited stays; the address has the state, words of the text set it;
a slider plays, an object is dragged, a guess is drawn; on a phone the controls stay and one panel is seen; without an engine the printed
figure stands in its place; previews and search work from disk.  The engine of this test answers at once.  Needs chromium.
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
  const heap = new Float64Array(8), about = { title: "A press", controls: [
    { name: "load", label: "load", least: 0, most: 1, step: 0.1, value: 0.5, plays: true },
    { name: "kind", label: "kind", least: 0, most: 1, step: 1, value: 0, choices: ["soft", "stiff"] }] };
  const panel = (title, more, ...layers) => ({ title, x: "x", y: "y", window: [0, 1, 0, 2], drag: [], question: "", layers, ...more });
  const answer = (load, kind) => ({ says: "It rests under " + load + ".", numbers: [{ name: "f", label: "force", text: load, unit: "N", value: 1 }],
    sets: [], table: [], panels: [
      panel("gap", { drag: [{ control: "load", x: 0, y: 0.5, from: 0 }], grab: true }, { x: 0, y: 1, look: "line", label: "gap" }),
      panel("force over load", { question: "Draw it." }, { x: 2, y: 3, look: "trail", series: kind, label: "so far" }),
      panel("points", {}, { x: 0, y: 1, look: "closed", label: "pairs" })] });
  function told(words) {
    if (words.startsWith("figure ")) return about;
    const [, load, kind] = /load=(\\S+) kind=(\\S+)/.exec(words);
    heap.set([0, 1, 0, +load, 0, 0, 0, 0]);
    heap[4] = +load; heap[5] = 2 * load * (kind === "soft" ? 0.5 : 1);
    return answer(load, kind);
  }
  return { HEAPF64: heap, ccall: (name, kind, types, [k]) => name === "live_size" ? [2, 2, 1, 1][k] ?? -1 :
    name === "live_data" ? 8 * [0, 2, 4, 5][k] : JSON.stringify(told(k)) };
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
# The printed figure is seen until the first answer, at each frame of that time.
WAITS = """(async () => { %s let seen = 0, empty = 0, done = false;
  live.addEventListener('answered', () => { done = true; });
  const look = () => { if (done) return; live.querySelector('.live-wait img')?.getBoundingClientRect().height > 50 ? ++seen : ++empty; requestAnimationFrame(look); };
  look();
  live.scrollIntoView();
  for (let i = 0; i < 150 && !done; ++i) await wait(20);
  await wait(100);
  return JSON.stringify([seen, empty, !!live.querySelector('form'), !!live.querySelector('.live-wait')]); })()""" % WATCH
# What a reader does with a figure, one after the other; what is seen then.
USES = """(async () => { %s const out = {}, $ = s => live.querySelector(s), all = s => [...live.querySelectorAll(s)];
  const seen = e => !!e && e.checkVisibility({ visibilityProperty: true }) && e.getBoundingClientRect().height > 0;
  const answered = () => new Promise(done => live.addEventListener('answered', done, { once: true }));
  const axes = () => all('.live-stage svg > text, .live-stage svg > .grid').map(e => e.outerHTML).join();
  const pointer = (stage, type, x, y, buttons = 1) => { const r = stage.getBoundingClientRect();
    stage.dispatchEvent(new PointerEvent(type, { bubbles: true, buttons, clientX: r.left + 60 + x * (r.width - 72), clientY: r.bottom - 40 - y * (r.height - 50) })); };
  const first = answered();
  live.scrollIntoView();
  await first;
  await wait(100);
  const input = $('input'), list = $('select');
  out.asks = [live.classList.contains('asks'), all('.live-panels > div').filter(seen).length, seen($('dl')), $('[role=status]').textContent, $('.live-ask button').disabled];
  const stage = $('.live-stage.guessing');
  pointer(stage, 'pointerdown', 0, 0.1);
  for (let k = 1; k <= 20; ++k) pointer(stage, 'pointermove', k / 20, 0.1 + 0.04 * k);
  pointer(stage, 'pointerup', 1, 0.9, 0);
  out.drawn = $('.live-ask button').disabled;
  $('.live-ask button').click();
  out.beside = all('.live-tabs button').findIndex(t => t.getAttribute('aria-pressed') === 'true');
  out.plays = [live.classList.contains('asks'), !!$('path.guess'), !!$('.playing')];
  for (let i = 0; i < 200 && $('.playing'); ++i) await wait(20);
  out.high = live.getBoundingClientRect().height;
  out.end = [input.value, all('.live-stage .trail circle').length];
  await wait(400);
  out.address = location.hash;
  const old = axes();
  list.value = 'stiff';
  const now = answered();
  list.dispatchEvent(new Event('input', { bubbles: true }));
  await now;
  out.other = [all('.live-stage .trail.other circle').length, all('.live-stage .trail:not(.other) circle').length, axes() === old];
  document.querySelector('a.set').click();
  await answered();
  out.set = [input.value, list.value, location.hash];
  all('.live-tabs button')[0].click();
  const held = $('.live-stage.grab');
  pointer(held, 'pointerdown', 0.5, 0.5);
  pointer(held, 'pointermove', 0.5, 0.7);
  await wait(100);
  out.dragged = input.value;
  const tabs = all('.live-tabs button'), form = $('form');
  scrollTo(0, live.getBoundingClientRect().top + scrollY - 400);    // its end is below the screen
  await wait(50);
  out.phone = [seen(tabs[0]), all('.live-panels > div').filter(seen).length, form.getBoundingClientRect().bottom <= innerHeight + 1, seen(form)];
  form.querySelector('[type=reset]').click();
  await answered();
  out.reset = [input.value, list.value, all('.live-stage .trail circle').length];
  return JSON.stringify(out); })()""" % WATCH
# A page opened with a state in its address.
OPENED = """(async () => { %s for (let i = 0; i < 150 && !live.querySelector('form'); ++i) await wait(20);
  await wait(100);
  const box = live.getBoundingClientRect();
  return JSON.stringify([live.querySelector('input')?.value, live.querySelector('select')?.value, live.classList.contains('asks'), box.top < innerHeight && box.bottom > 0]); })()""" % WATCH
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


ROOM = (880, 680)    # pixels of the figure of this test, at 1280 and at 390


def pack(text):
    return base64.b64encode(gzip.compress(text.encode())).decode()


def book(with_engine):
    """A small book with a live figure three screens below its top."""
    folder = make(FOLDER / ("engine" if with_engine else "printed"), [
        ("chapters/ch01_one/README.md", "![Figure 1.1", "%s<!-- live press -->\n\n![Figure 1.1" % ("A line of text.\n\n" * 60)),
        ("chapters/ch01_one/README.md", "does it.\n", "does it.\n\nSee <!-- set press load=0.3 -->0.3<!-- /set -->.\n\n" + "And then.\n\n" * 60),
        ("docs/rooms", "press 700 900", "press %d %d" % ROOM)])
    for name in ("page.css", "formula.css", "page.js", "peek.js", "find.js", "panels.js", "live.js", "live.css"):
        shutil.copy(ROOT / "docs" / name, folder / "docs")
    shutil.copytree(ROOT / "docs/fonts", folder / "docs/fonts", dirs_exist_ok=True)
    os.makedirs(folder / "out")
    if with_engine:
        (folder / "out/engine.js").write_text('self.signoriniEngine = { glue: "%s", wasm: "%s" };' % (pack(GLUE), pack("")), encoding="utf-8")
    code, said = run(folder)
    assert code == 0, said
    return str(folder / "out")


def looked_at(browser, folder, script, width=1280, page="chapter-01.html"):
    tab = Tab(browser, folder)
    browser.call("Emulation.setDeviceMetricsOverride", tab.session, width=width, height=800, deviceScaleFactor=1, mobile=width < 600)
    found = tab.visit(page, script)
    assert not tab.bad, tab.bad
    browser.call("Page.close", tab.session)
    return json.loads(found)


def used(check, found, width):
    """What a reader does with a figure."""
    check("a question hides the answer", found["asks"] == [True, 1, False, "Draw it.", True], found["asks"])
    check("a guess is drawn", found["drawn"] is False, found["drawn"])
    check("the guess is seen beside the answer", found["beside"] == 1, found["beside"])
    check("the answer comes with the guess, and plays", found["plays"] == [False, True, True], found["plays"])
    check("the answer fits the room of the question", found["high"] <= ROOM[width < 600] + 2, found["high"])
    check("it plays to the end and leaves a trail", found["end"][0] == "1" and found["end"][1] == 6, found["end"])
    check("the state is in the address", found["address"] == "#live-press&load=1", found["address"])
    check("another series is another trail, on the same axes", found["other"] == [6, 1, True], found["other"])
    check("words of the text set a state", found["set"] == ["0.3", "soft", "#live-press&load=0.3"], found["set"])
    check("an object follows the pointer", found["dragged"] == "0.5", found["dragged"])
    check("panels and controls", found["phone"] == ([True, 1, True, True] if width < 600 else [False, 3, True, True]), found["phone"])
    check("all is as at the beginning", found["reset"] == ["0.5", "soft", 1], found["reset"])


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
            check("the figure fits its room, at %d" % width, height <= ROOM[width < 600] + 2, found)
            at, moved, grown = found = looked_at(browser, folder, JUMPS, width)
            check("a figure is there after a jump to below it, at %d" % width, at is not None, found)
            check("nothing moves after a jump, at %d" % width, moved == 0 and abs(grown) <= 2, found)
            seen, empty, form, waits = found = looked_at(browser, folder, WAITS, width)
            check("the printed figure is seen until the first answer, at %d" % width, seen > 0 and empty == 0 and form and not waits, found)
            used(lambda what, right, found: check("%s, at %d" % (what, width), right, found), looked_at(browser, folder, USES, width), width)
        found = looked_at(browser, folder, OPENED, page="chapter-01.html#live-press&load=0.8&kind=stiff")
        check("an address has a state", found == ["0.8", "stiff", False, True], found)
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
