#!/usr/bin/env python3
"""check-live.py [BOOK] [LIVE] [PICTURES]

Opens every page of BOOK (default build/book) that has a figure that computes, in headless Chromium, moves each control to its
ends or through all its choices, asks what the .checks of the figure ask, and compares with what LIVE (default build/bin/live),
the same code compiled for this machine, answers: sets exactly, numbers to 1e-6 of them. Checks labels, the keyboard, that
nothing is wider than a window of 1280 or 390 pixels, that the figure fits the room that docs/rooms keeps for it, so that nothing
moves when it comes, and that the console is silent; keeps screenshots in PICTURES (default build/live), and tells how long answers
take. Then that the printed figures stay where scripts or workers are missing.
Needs python3 and chromium.
"""
import base64
import glob
import json
import os
import re
import statistics
import subprocess
import sys
import time

sys.dont_write_bytecode = True
from browser import Browser, Tab, chromium

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# Runs in a page: waits until a figure that is nearly reached is there, returns its controls.
MOUNT = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms)), live = () => document.querySelector('div.live[data-figure=NAME]');
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  for (let i = 0; i < 400 && live() && !live().querySelector('dl > *') && !live().matches('.failed'); ++i) {
    live().style.scrollMarginTop = innerHeight + 100 + 'px';         // not yet on the screen
    if (i % 10 === 0) live().scrollIntoView();
    await wait(50);
  }
  if (!live()) return JSON.stringify({ gone: true });
  live().style.scrollMarginTop = '';
  for (let i = 0; i < 200 && live().getAttribute('aria-busy'); ++i) await wait(50);
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  const inputs = [...live().querySelectorAll('input, select')], status = live().querySelector('[role=status]');
  return JSON.stringify({ unlabelled: inputs.filter(i => i.labels.length !== 1).map(i => i.id), status: status?.textContent,
    started: (await signoriniLive()).started });
})()"""

# Runs in a page: how high a figure is that stands as at the beginning, and how much room the page keeps for it.
ROOM = r"""(async () => {
  const live = document.querySelector('div.live[data-figure=NAME]');
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  const kept = parseFloat(getComputedStyle(live).minHeight);
  live.style.minHeight = 0;
  const high = Math.ceil(live.getBoundingClientRect().height);
  live.style.minHeight = '';
  return JSON.stringify([high, kept]);
})()"""

# Runs in a page: moves controls, one request after the other, returns the answers.
ASK = r"""(async requests => {
  const live = document.querySelector('div.live[data-figure=NAME]'), form = live.querySelector('form'), out = [];
  for (const settings of requests) {
    form.querySelectorAll('option').forEach(o => o.selected = o.defaultSelected);
    form.querySelectorAll('input').forEach(i => { i.type === 'checkbox' ? i.checked = i.defaultChecked : i.value = i.defaultValue; });
    for (const [name, value] of Object.entries(settings)) {
      const input = document.getElementById('live-NAME-' + name);
      input.type === 'checkbox' ? input.checked = value === 'on' : input.value = value;
    }
    const answered = new Promise(done => live.addEventListener('answered', e => done(e.detail), { once: true }));
    form.dispatchEvent(new Event('input'));
    const { words, answer, milliseconds, total } = await answered;
    out.push({ words, answer, milliseconds, total, says: live.querySelector('[role=status]').textContent });
  }
  return JSON.stringify(out);
})(REQUESTS)"""

WIDE = r"""JSON.stringify({ page: document.documentElement.scrollWidth > innerWidth + 1,
  parts: [...document.querySelectorAll('div.live :not(svg *, .live-table *)')].filter(e => e.getBoundingClientRect().right > innerWidth + 1).map(e => e.tagName + '.' + e.getAttribute('class')) })"""

STAYS = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms)), printed = () => document.querySelector('img[src*="PICTURE"]');
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  document.querySelector('div.live')?.scrollIntoView();
  await wait(1500);
  return JSON.stringify([printed().getBoundingClientRect().width > 0, !!document.querySelector('.live form')]);
})()"""


def requests_of(name, about):
    """The settings to ask for: as at the beginning, one step of each control, each control at its ends, and the checks."""
    steps, ends = [{}], []
    for c in about["controls"]:
        if "choices" in c:
            ends += [{c["name"]: choice} for choice in c["choices"]]
        else:
            further = c["value"] + c["step"] if c["value"] + c["step"] <= c["most"] else c["value"] - c["step"]
            steps.append({c["name"]: "%.10g" % further})
            ends += [{c["name"]: "%.10g" % c["least"]}, {c["name"]: "%.10g" % c["most"]}]
    for checks in glob.glob(os.path.join(ROOT, "chapters/*/live/%s.checks" % name)):
        for line in open(checks):
            words = line.partition(":")[0].split()
            if ":" in line and not line.startswith("#"):
                ends.append(dict(word.split("=") for word in words))
    return steps, ends


class Check:
    """The figures of a book, and what is wrong with them."""

    def __init__(self, browser, folder, native, pictures):
        self.browser, self.folder, self.pictures, self.bad = browser, folder, pictures, []
        self.native = subprocess.Popen([native], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        os.makedirs(pictures, exist_ok=True)

    def expected(self, words):
        self.native.stdin.write(words + "\n")
        self.native.stdin.flush()
        return json.loads(self.native.stdout.readline())

    def fault(self, name, what):
        self.bad.append("%s: %s" % (name, what))

    def compare(self, name, got):
        want, answer = self.expected(got["words"]), got["answer"]
        if ("error" in want) != ("error" in answer) or want.get("sets") != answer.get("sets"):
            self.fault(name, "'%s' answers %s, expected %s" % (
                got["words"], answer.get("error", answer.get("sets")), want.get("error", want.get("sets"))))
            return
        shown = {n["name"]: n for n in answer.get("numbers", [])}
        for n in want.get("numbers", []):
            a, b = shown[n["name"]]["value"], n["value"]
            if not n["varies"] and a != b and (a is None or b is None or abs(a - b) > 1e-6 * abs(b)):
                self.fault(name, "'%s': %s is %s, expected %s" % (got["words"], n["name"], a, b))

    def size(self, tab, width, name, scheme):
        call = self.browser.call
        call("Emulation.setDeviceMetricsOverride", tab.session, width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
        call("Runtime.evaluate", tab.session, awaitPromise=True, expression="document.querySelector('div.live[data-figure=%s]').scrollIntoView();"
             "document.documentElement.classList.toggle('dark', %s); new Promise(r => setTimeout(r, 300))" % (name, json.dumps(scheme == "dark")))
        wide = json.loads(call("Runtime.evaluate", tab.session, expression=WIDE, returnByValue=True)["result"]["value"])
        if wide["page"] or wide["parts"]:
            self.fault(name, "wider than %d pixels: %s" % (width, ", ".join(wide["parts"][:4]) or "the page"))
        picture = call("Page.captureScreenshot", tab.session, format="png")["data"]
        with open(os.path.join(self.pictures, "%s-%d-%s.png" % (name, width, scheme)), "wb") as file:
            file.write(base64.b64decode(picture))

    def room(self, tab, name):
        """The figure as at the beginning is as high as the room that the page keeps for it, up to 40 pixels that stay empty."""
        measured = []
        for width in (1280, 390):
            self.browser.call("Emulation.setDeviceMetricsOverride", tab.session, width=width, height=900, deviceScaleFactor=1, mobile=width < 600)
            got = self.browser.call("Runtime.evaluate", tab.session, expression=ROOM.replace("NAME", name), awaitPromise=True, returnByValue=True)
            measured.append(json.loads(got["result"]["value"]))
        self.browser.call("Emulation.setDeviceMetricsOverride", tab.session, width=1280, height=900, deviceScaleFactor=1, mobile=False)
        if any(high > kept + 2 or kept > high + 40 for high, kept in measured):
            self.fault(name, "docs/rooms keeps %s pixels for it, expected: %s %d %d" % (
                " and ".join("%.0f" % kept for _, kept in measured), name, measured[0][0] + 24, measured[1][0] + 24))

    def keyboard(self, tab, name):
        first = "document.querySelector('div.live[data-figure=%s] input[type=range]')" % name
        value = lambda: self.browser.call("Runtime.evaluate", tab.session, expression=first + ".value", returnByValue=True)["result"]["value"]
        if not self.browser.call("Runtime.evaluate", tab.session, expression="!!%s && (%s.focus(), true)" % (first, first), returnByValue=True)["result"]["value"]:
            return
        before, moved = value(), False
        for key, code in (("ArrowRight", 39), ("ArrowLeft", 37)):
            for kind in ("rawKeyDown", "keyUp"):
                self.browser.call("Input.dispatchKeyEvent", tab.session, type=kind, key=key, code=key, windowsVirtualKeyCode=code)
            moved = moved or value() != before
        if not moved:
            self.fault(name, "its slider does not follow the keyboard")

    def figure(self, page, name):
        about = self.expected("figure " + name)
        tab = Tab(self.browser, self.folder)
        self.browser.call("Emulation.setDeviceMetricsOverride", tab.session, width=1280, height=900, deviceScaleFactor=1, mobile=False)
        mounted = json.loads(tab.visit(page, MOUNT.replace("NAME", name)))
        if "gone" in mounted:
            self.fault(name, "is not there")
            return
        if mounted["unlabelled"] or not mounted["status"]:
            self.fault(name, "labels or status: %s" % mounted)
        self.room(tab, name)
        steps, ends = requests_of(name, about)
        events, times = [], []
        for requests in [ends] + 5 * [steps]:
            script = ASK.replace("NAME", name).replace("REQUESTS", json.dumps(requests))
            got = self.browser.call("Runtime.evaluate", tab.session, events, expression=script, awaitPromise=True, returnByValue=True)
            if "value" not in got["result"]:
                self.fault(name, "the check itself failed: " + json.dumps(got)[:300])
                return
            answers = json.loads(got["result"]["value"])
            if requests is steps:
                times += [a["total"] for a in answers]
            slowest = max(answers, key=lambda a: a["total"]) if requests is ends else slowest
            for answer in answers:
                self.compare(name, answer)
        for width, scheme in ((1280, "light"), (1280, "dark"), (390, "light")):
            self.size(tab, width, name, scheme)
        self.keyboard(tab, name)
        tab.listen(events)
        for _, what in sorted(tab.bad):
            self.fault(name, what)
        self.browser.call("Page.close", tab.session)
        print("%-16s %3d requests; answers after %4.0f ms (median of controls moved by one step), %4.0f ms at most (%s); engine after %.0f ms" % (
            name, len(ends) + 5 * len(steps), statistics.median(times), slowest["total"], slowest["words"], mounted["started"]))

    def stays(self, page, name):
        """Without workers or scripts the printed figure is seen."""
        text = open(os.path.join(self.folder, page), encoding="utf-8").read()
        picture = re.search(r'<div class="live" data-figure="%s"[^>]*></div>.*?<img src="([^"]+)"' % name, text, re.S).group(1)
        for what, take in (("workers", "window.Worker = undefined"), ("WebAssembly", "delete window.WebAssembly")):
            tab = Tab(self.browser, self.folder)
            self.browser.call("Page.addScriptToEvaluateOnNewDocument", tab.session, source=take)
            seen, computes = json.loads(tab.visit(page, STAYS.replace("PICTURE", picture)))
            if not seen or computes:
                self.fault(name, "the printed figure is not seen without " + what)
            self.browser.call("Page.close", tab.session)
        tab = Tab(self.browser, self.folder)
        self.browser.call("Emulation.setScriptExecutionDisabled", tab.session, value=True)
        self.browser.call("Page.navigate", tab.session, url="file://" + os.path.join(self.folder, page))
        time.sleep(2)
        document = self.browser.call("DOM.getDocument", tab.session)["root"]["nodeId"]
        image = self.browser.call("DOM.querySelector", tab.session, nodeId=document, selector='img[src="%s"]' % picture)["nodeId"]
        if self.browser.call("DOM.getBoxModel", tab.session, nodeId=image)["model"]["width"] <= 0:
            self.fault(name, "the printed figure is not seen without scripts")


def main():
    words = sys.argv[1:] + [None] * 3
    folder = os.path.abspath(words[0] or "build/book")
    program = chromium()
    if not program:
        sys.exit("check-live.py: no chromium found, run: tools/setup.sh check")
    if not os.path.exists(os.path.join(folder, "engine.js")):
        sys.exit("check-live.py: no engine in %s, run: make live" % folder)
    figures = [(page, name) for page in sorted(os.listdir(folder)) if page.endswith(".html")
               for name in re.findall(r'<div class="live" data-figure="(\w+)"', open(os.path.join(folder, page), encoding="utf-8").read())]
    browser = Browser(program)
    try:
        check = Check(browser, folder, os.path.abspath(words[1] or "build/bin/live"), words[2] or "build/live")
        for page, name in figures:
            check.figure(page, name)
        check.stays(*figures[0])
        check.native.stdin.close()
    finally:
        browser.close()
    for what in check.bad:
        print(what)
    print("%d live figures on %d pages: %s" % (len(figures), len({p for p, _ in figures}), "%d problems" % len(check.bad) if check.bad else "all fine"))
    sys.exit(1 if check.bad or not figures else 0)


main()
