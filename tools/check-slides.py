#!/usr/bin/env python3
"""check-slides.py [BOOK] [SHOTS]

Opens every deck of BOOK (default build/book), slides-06.html, in headless Chromium, and checks that nothing stands beyond a slide of
1280 x 720 pixels, that no picture is pressed flat, that the keys turn, that every chapter has a deck, and that the print has one
slide a page.  With SHOTS, a folder, every slide is saved there as a picture.  Needs python3 and chromium.
"""
import base64
import json
import os
import re
import sys

sys.dont_write_bytecode = True    # no __pycache__ beside the tools
from browser import Browser, Tab, chromium

# Runs in a deck, in a window that shows slides as large as they are: [slide, what is wrong].
PROBE = r"""(async () => {
  const bad = [], wait = ms => new Promise(r => setTimeout(r, ms)), press = key => dispatchTo(document.body, key);
  const dispatchTo = (e, key) => e.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  await Promise.all([...document.fonts].map(face => face.load()));
  await Promise.all([...document.images].map(image => image.decode().catch(() => 0)));
  const slides = [...document.querySelectorAll('.slide')], now = () => slides.findIndex(slide => slide.checkVisibility());
  for (const [k, slide] of slides.entries()) {
    if (now() !== k) bad.push([slide.id, 'the keys do not lead to it']);
    const box = slide.getBoundingClientRect(), inside = slide.querySelector('.inside');
    const foot = slide.querySelector('footer').getBoundingClientRect();
    if (Math.abs(box.width - 1280) > 1 || Math.abs(box.height - 720) > 1) bad.push([slide.id, `${box.width} x ${box.height} pixels`]);
    if (!inside.textContent.trim() && !inside.querySelector('img')) bad.push([slide.id, 'it is empty']);
    for (const e of inside.querySelectorAll('*')) {
      if (e.closest('math') && e.tagName !== 'math' || !e.checkVisibility()) continue;
      const r = e.getBoundingClientRect();
      if (!r.width || !r.height) continue;
      if (r.bottom > foot.top + 1 || r.right > box.right - 30 || r.left < box.left + 30 || r.top < box.top + 30) {
        const most = Math.max(r.bottom - foot.top, r.right - box.right + 30, box.left + 30 - r.left);
        bad.push([slide.id, `it overflows by ${Math.round(most)}: ` + (e.textContent.trim() || e.tagName).slice(0, 50)]);
        break;
      }
    }
    for (const e of inside.querySelectorAll('.scroll, pre'))
      if (e.scrollWidth > e.clientWidth + 1) bad.push([slide.id, 'cut off: ' + e.textContent.trim().slice(0, 50)]);
    for (const e of inside.querySelectorAll('img'))
      if (e.checkVisibility() && e.getBoundingClientRect().height < 180) bad.push([slide.id, 'a picture is pressed flat']);
    press('ArrowRight');
  }
  press('Home');
  if (now() !== 0) bad.push(['', 'Home does not lead to the first slide']);
  return JSON.stringify([slides.length, bad]);
})()"""


def check(browser, folder, page, shots):
    """The number of slides of a deck, and what is wrong with it."""
    tab = Tab(browser, folder)
    browser.call("Emulation.setDeviceMetricsOverride", tab.session, width=1280, height=760, deviceScaleFactor=1, mobile=False)
    count, bad = json.loads(tab.visit(page, PROBE) or '[0, [["", "cannot be looked at"]]]')
    bad += [["", what] for _, what in tab.bad]
    sheets = len(re.findall(rb"/Type\s*/Page\b", base64.b64decode(
        browser.call("Page.printToPDF", tab.session, preferCSSPageSize=True, printBackground=True)["data"])))
    if sheets != count:
        bad.append(["", "%d pages are printed, of %d slides" % (sheets, count)])
    for k in range(count if shots else 0):
        browser.call("Runtime.evaluate", tab.session, awaitPromise=True, expression="location.hash = "
                     "document.querySelectorAll('.slide')[%d].id; new Promise(r => setTimeout(r, 60))" % k)
        picture = browser.call("Page.captureScreenshot", tab.session, format="png")["data"]
        with open(os.path.join(shots, "%s-%02d.png" % (page[:-5], k + 1)), "wb") as file:
            file.write(base64.b64decode(picture))
    browser.call("Page.close", tab.session)
    return count, bad


def main():
    folder = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/book")
    shots = sys.argv[2] if len(sys.argv) > 2 else None
    if shots:
        os.makedirs(shots, exist_ok=True)
    program = chromium()
    if not program:
        sys.exit("check-slides.py: no chromium found, run: tools/setup.sh check")
    there, all_bad, total = set(os.listdir(folder)), [], 0
    chapters = sorted(name for name in there if re.fullmatch(r"chapter-\d\d\.html", name))
    browser = Browser(program)
    try:
        for chapter in chapters:
            deck = "slides-" + chapter[8:]
            if deck not in there:
                all_bad.append("%s has no deck" % chapter)
                continue
            count, bad = check(browser, folder, deck, shots)
            total += count
            all_bad += ["%s%s: %s" % (deck, "#" + slide if slide else "", what) for slide, what in bad]
    finally:
        browser.close()
    end = "%d problems" % len(all_bad) if all_bad else "all fine"
    print("\n".join(all_bad + ["%d decks, %d slides: %s" % (len(chapters), total, end)]))
    sys.exit(1 if all_bad else 0)


main()
