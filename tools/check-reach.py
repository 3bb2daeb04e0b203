#!/usr/bin/env python3
"""check-reach.py [BOOK]

Opens pages of BOOK (default build/site) in headless Chromium, light and dark, and checks the contrast of every letter against what is
behind it (4.5, large letters 3, after WCAG 2.1), and that the keyboard reaches every link and control that is seen, with a focus
that shows.  Opened are all texts and, of sources, decks and the reference, every 40th.  On the first page and a chapter the tabulator
is really pressed, through the whole page.  Needs python3 and chromium.
"""
import json
import os
import re
import sys

sys.dont_write_bytecode = True    # no __pycache__ beside the tools
from browser import Browser, Tab, chromium

EVERY = 40    # of the pages that are made by the hundred
REACHED = "a[href], button, input, select, textarea, summary, [tabindex]"

# Runs in a page: what is wrong with it.
PROBE = r"""(async () => {
  const bad = [], wait = ms => new Promise(r => setTimeout(r, ms)), root = document.documentElement;
  for (let i = 0; i < 100 && (document.readyState !== 'complete' || root.classList.contains('loading')); ++i) await wait(20);
  document.querySelectorAll('details').forEach(fold => { fold.open = true; });
  const still = document.createElement('style');
  still.textContent = '*, ::before, ::after { transition: none !important; animation: none !important; }';
  document.head.append(still);
  const pen = document.createElement('canvas').getContext('2d', { willReadFrequently: true });
  pen.canvas.width = pen.canvas.height = 1;
  function over(colours) {    // the colour that is seen when they lie on each other
    pen.clearRect(0, 0, 1, 1);
    for (const c of colours) { pen.fillStyle = c; pen.fillRect(0, 0, 1, 1); }
    return pen.getImageData(0, 0, 1, 1).data;
  }
  const linear = p => p <= 0.03928 ? p / 12.92 : ((p + 0.055) / 1.055) ** 2.4;
  const light = rgb => [0.2126, 0.7152, 0.0722].reduce((sum, w, k) => sum + w * linear(rgb[k] / 255), 0);
  function walk(e) {
    const out = [];
    for (; e; e = e.parentElement) out.push(getComputedStyle(e).backgroundColor);
    return ['white', ...out.reverse()];
  }
  function contrast(tone) {
    root.classList.remove('light', 'dark');
    root.classList.add(tone);
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT), seen = new Map();
    for (let n; (n = texts.nextNode());) {
      const e = n.parentElement;
      if (!n.data.trim() || e.closest('script, style, template, noscript, .self') || !e.checkVisibility()) continue;
      const style = getComputedStyle(e), grounds = walk(e), large = parseFloat(style.fontSize) >= (style.fontWeight >= 700 ? 18.66 : 24);
      const key = [style.color, style.fill, large, ...grounds].join();
      if (seen.has(key)) continue;
      seen.set(key, true);
      const letters = over([...grounds, e.closest('svg') ? style.fill : style.color]);
      const [low, high] = [light(over(grounds)), light(letters)].sort((a, b) => a - b);
      const ratio = (high + 0.05) / (low + 0.05);
      if (ratio < (large ? 3 : 4.5)) bad.push(`contrast ${ratio.toFixed(2)}, ${tone}: ${n.data.trim().slice(0, 40)}`);
    }
  }
  for (const tone of ['light', 'dark']) contrast(tone);
  function looks(e) {
    const s = getComputedStyle(e);
    return [s.outlineStyle, s.outlineWidth, s.boxShadow, s.backgroundColor, s.borderColor].join();
  }
  for (const e of document.querySelectorAll(REACHED)) {
    if (!e.checkVisibility({ visibilityProperty: true }) || e.disabled || e.closest('template')) continue;
    const name = (e.getAttribute('aria-label') || e.textContent || e.id || e.tagName).trim().slice(0, 40);
    if (e.tabIndex < 0) { bad.push('not reached by keyboard: ' + name); continue; }
    const before = looks(e);
    e.focus({ preventScroll: true, focusVisible: true });
    if (document.activeElement !== e) bad.push('cannot have the focus: ' + name);
    else if (looks(e) === before) bad.push('the focus does not show: ' + name);
    else { const r = e.getBoundingClientRect(); if (!r.width || !r.height) bad.push('has the focus and is not seen: ' + name); }
    e.blur();
  }
  return JSON.stringify([...new Set(bad)]);
})()"""

SEEN = "[...document.querySelectorAll('%s')].filter(e => e.tabIndex >= 0 && e.checkVisibility({ visibilityProperty: true }))" % REACHED
AT = "(() => { const e = document.activeElement; if (e === document.body) return false; e.dataset.reached = 1; return true; })()"
LEFT = SEEN + ".filter(e => !e.dataset.reached).map(e => (e.textContent || e.id || e.tagName).trim().slice(0, 40))"


def chosen(folder):
    """Texts, and some of each kind that is made by the hundred."""
    names, many = sorted(name for name in os.listdir(folder) if name.endswith(".html")), {}
    out = []
    for name in names:
        kind = (re.match(r"source-|slides-|exercise-", name) or [""])[0]
        many[kind] = many.get(kind, -1) + 1
        if many[kind] % {"": 1, "source-": EVERY}.get(kind, 8) == 0:
            out.append(name)
    return out


def ask(browser, tab, script):
    return browser.call("Runtime.evaluate", tab.session, expression=script, returnByValue=True)["result"].get("value")


def tabbed(browser, tab):
    """Presses the tabulator through the page that is open: what it does not come to."""
    count = ask(browser, tab, "document.activeElement?.blur(); scrollTo(0, 0); getSelection().setPosition(document.body, 0); " + SEEN + ".length")
    for _ in range(count + 20):
        for kind in ("rawKeyDown", "keyUp"):
            browser.call("Input.dispatchKeyEvent", tab.session, type=kind, key="Tab", code="Tab", windowsVirtualKeyCode=9)
        ask(browser, tab, AT)
    return ["the tabulator does not come to: " + name for name in ask(browser, tab, LEFT)]


def main():
    folder = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/site")
    program = chromium()
    if not program:
        sys.exit("check-reach.py: no chromium found, run: tools/setup.sh check")
    pages, bad = chosen(folder), []
    chapter = next((name for name in pages if name.startswith("chapter-")), None)
    browser = Browser(program)
    try:
        tab = Tab(browser, folder)
        browser.call("Emulation.setFocusEmulationEnabled", tab.session, enabled=True)    # the window of a headless browser has none
        for name in pages:
            found = tab.visit(name, PROBE.replace("REACHED", json.dumps(REACHED)))
            bad += ["%s: %s" % (name, what) for what in json.loads(found or '["cannot be looked at"]')]
            if name in ("index.html", chapter):
                bad += ["%s: %s" % (name, what) for what in tabbed(browser, tab)]
        bad += ["%s: %s" % one for one in sorted(tab.bad)]
    finally:
        browser.close()
    print("\n".join(bad + ["%d pages opened: %s" % (len(pages), "%d problems" % len(bad) if bad else "all fine")]))
    sys.exit(1 if bad else 0)


main()
