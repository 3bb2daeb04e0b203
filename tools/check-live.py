#!/usr/bin/env python3
"""check-live.py [BOOK] [LIVE] [PICTURES]

Opens every page of BOOK (default build/book) that has a figure that computes, in headless Chromium, moves each control to its
ends or through all its choices, asks what the .checks of the figure ask, and compares with what LIVE (default build/bin/live),
the same code compiled for this machine, answers: sets exactly, numbers to 1e-6 of them, and all that is drawn to 1e-6 of its
axis. Checks that axes and scales of colours stay, that words of the text set the controls, labels, the keyboard, that nothing is
wider than a window of 1280 or 390 pixels, that the figure fits the room that docs/rooms keeps for it, that it is there before it
is seen and nothing moves when it comes, and that the console is silent; keeps screenshots in PICTURES (default build/live), and
tells how long answers take. Then that the printed figures stay where scripts or workers are missing.
Needs python3 and chromium.
"""
import array
import base64
import json
import os
import re
import statistics
import subprocess
import sys
import time

sys.dont_write_bytecode = True
import live_probes as probes
from browser import Browser, Tab, chromium



class Check:
    """The figures of a book, and what is wrong with them."""

    def __init__(self, browser, folder, native, pictures):
        self.browser, self.folder, self.pictures, self.bad = browser, folder, pictures, []
        self.native = subprocess.Popen([native, "--arrays"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.moved, self.drawn, self.states = 0, 0, 0    # what was asked for, so that nothing is left out unseen
        os.makedirs(pictures, exist_ok=True)

    def expected(self, words):
        """What the program answers, and its arrays."""
        out = self.native.stdout
        self.native.stdin.write(words.encode() + b"\n")
        self.native.stdin.flush()
        answer = json.loads(out.readline())
        return answer, [array.array("d", out.read(8 * int(size))) for size in out.readline().split()]

    def fault(self, name, what):
        self.bad.append("%s: %s" % (name, what))

    def compare(self, name, got):
        (want, arrays), answer = self.expected(got["words"]), got["answer"]
        if ("error" in want) != ("error" in answer) or want.get("sets") != answer.get("sets"):
            self.fault(name, "'%s' answers %s, expected %s" % (
                got["words"], answer.get("error", answer.get("sets")), want.get("error", want.get("sets"))))
            return
        shown = {n["name"]: n for n in answer.get("numbers", [])}
        for n in want.get("numbers", []):
            a, b = shown[n["name"]]["value"], n["value"]
            if not n["varies"] and a != b and (a is None or b is None or abs(a - b) > probes.PART * abs(b)):
                self.fault(name, "'%s': %s is %s, expected %s" % (got["words"], n["name"], a, b))
        drawn = [array.array("d", base64.b64decode(packed)) for packed in got["arrays"]]
        if not probes.same_panels(want.get("panels", []), answer.get("panels", [])):
            self.fault(name, "'%s' draws other panels or layers" % got["words"])
            return
        for panel, shown in zip(want.get("panels", []), answer.get("panels", [])):
            for layer, seen in zip(probes.determined(panel), probes.determined(shown)):
                off = max(probes.difference(panel, layer, key, drawn[seen[key]], arrays[layer[key]]) for key in ("x", "y", "value") if key in layer)
                self.drawn += 1
                if off > probes.PART:
                    self.fault(name, "'%s': '%s' of '%s' differs by %.1e of the axis" % (got["words"], layer["label"] or layer["look"], panel["title"], off))

    def evaluate(self, tab, script, events=None):
        got = self.browser.call("Runtime.evaluate", tab.session, events, expression=script, awaitPromise=True, returnByValue=True)
        if "exceptionDetails" in got:
            raise RuntimeError("the check itself failed: " + json.dumps(got)[:300])
        return json.loads(got["result"].get("value") or "null")

    def screen(self, tab, width, scheme, high=800):
        self.browser.call("Emulation.setDeviceMetricsOverride", tab.session, width=width, height=high, deviceScaleFactor=1, mobile=width < 600)
        self.browser.call("Emulation.setEmulatedMedia", tab.session, features=[{"name": "prefers-color-scheme", "value": scheme}])

    def size(self, tab, width, name, scheme, state=""):
        for high in (800, None):    # the second time as high as the figure, so that what stays on the screen is where it belongs
            self.screen(tab, width, scheme, high or int(box[3]) + 200)
            box = self.evaluate(tab, probes.BOX.replace("NAME", name))
        wide = self.evaluate(tab, probes.WIDE)
        if wide["page"] or wide["parts"]:
            self.fault(name, "wider than %d pixels: %s" % (width, ", ".join(wide["parts"][:4]) or "the page"))
        picture = self.browser.call("Page.captureScreenshot", tab.session, format="png", captureBeyondViewport=True,
                                    clip=dict(zip(("x", "y", "width", "height"), box), scale=1))["data"]
        with open(os.path.join(self.pictures, "%s%s-%d-%s.png" % (name, state, width, scheme)), "wb") as file:
            file.write(base64.b64decode(picture))

    def rooms(self, tab, name):
        measured = []
        for width in (1280, 390):
            self.screen(tab, width, "light")
            time.sleep(0.2)
            measured.append(self.evaluate(tab, probes.ROOM.replace("NAME", name)))
        self.screen(tab, 1280, "light")
        return measured

    def room(self, name, states):
        """The figure as at the beginning, before and after its question, is as high as its room, up to 40 pixels that stay empty."""
        high = [max(state[k][0] for state in states) for k in (0, 1)]
        kept = [states[0][k][1] for k in (0, 1)]
        if any(h > r + 2 or r > h + 40 for h, r in zip(high, kept)):
            self.fault(name, "docs/rooms keeps %.0f and %.0f pixels for it, expected: %s %d %d" % (*kept, name, high[0] + 12, high[1] + 12))

    def states_of(self, tab, name):
        """Words of the page that name states of the figure set its controls."""
        for controls, failed in self.evaluate(tab, probes.STATES.replace("NAME", name)):
            self.states += 1
            for control, wanted, value in controls:
                if wanted != value:
                    self.fault(name, "the text sets %s to %s, and it is %s" % (control, wanted, value))
            if failed:
                self.fault(name, "the text sets a state without an answer: %s" % controls)

    def comes(self, page, name):
        """With the engine there: mounted before it is seen, painted after a jump, and nothing moves."""
        times = []
        for how, width, scheme in (("near", 1280, "light"), ("near", 390, "dark"), ("jump", 1280, "dark"), ("jump", 390, "light")):
            tab = Tab(self.browser, self.folder)
            self.screen(tab, width, scheme)
            got = json.loads(tab.visit(page, probes.COMES.replace("NAME", name).replace("HOW", how)))
            if how == "near" and not got["first"] and not got["early"] and (got["at"] is None or got["at"] <= 0):
                self.fault(name, "100 pixels below a screen of %d it is not there before it is seen: %s" % (width, got))
            if not got["early"] and got["then"] is None:
                self.fault(name, "does not come, %s at %d: %s" % (how, width, got))
            if got["moved"] > 0.001 or abs(got["grown"]) > 2:
                self.fault(name, "moves the page when it comes, %s at %d: %s" % (how, width, got))
            times.append("seen at once" if got["early"] else "%s %.0f" % (how, got["then"] or -1))
            self.browser.call("Page.close", tab.session)
        return ", ".join(times)

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
        about, _ = self.expected("figure " + name)
        tab = Tab(self.browser, self.folder)
        self.screen(tab, 1280, "light")
        mounted = json.loads(tab.visit(page, probes.MOUNT.replace("NAME", name)))
        if "gone" in mounted:
            self.fault(name, "is not there")
            return
        if mounted["unlabelled"] or not mounted["status"]:
            self.fault(name, "labels or status: %s" % mounted)
        rooms = [self.rooms(tab, name)]
        if mounted["asks"]:
            self.size(tab, 1280, name, "light", "-asks")
            self.size(tab, 390, name, "light", "-asks")
            self.screen(tab, 1280, "light")
            self.evaluate(tab, probes.REVEAL.replace("NAME", name))
            rooms.append(self.rooms(tab, name))
        self.room(name, rooms)
        steps, ends = probes.requests_of(name, about)
        events, times = [], []
        answers = self.ask(tab, name, ends, events)
        self.axes(name, about, ends, answers)
        for answer in answers:
            self.compare(name, answer)
        for _ in range(5):
            times += [a["painted"] for a in self.ask(tab, name, steps, events)]
        for width, scheme in ((1280, "dark"), (390, "dark"), (390, "light"), (1280, "light")):
            self.size(tab, width, name, scheme)
        self.states_of(tab, name)
        self.keyboard(tab, name)
        tab.listen(events)
        for _, what in sorted(tab.bad):
            self.fault(name, what)
        self.browser.call("Page.close", tab.session)
        slowest = max(answers, key=lambda a: a["painted"])
        print("%-16s %3d requests; event to painted frame %4.0f ms (median of controls moved by one step), %4.0f at most (%s); engine after %.0f; first answer: %s ms" % (
            name, len(ends) + 5 * len(steps), statistics.median(times), slowest["painted"], slowest["words"], mounted["started"], self.comes(page, name)), flush=True)

    def ask(self, tab, name, requests, events):
        return self.evaluate(tab, probes.ASK.replace("NAME", name).replace("REQUESTS", json.dumps(requests)), events)

    def axes(self, name, about, requests, answers):
        """Axes and scales are those of the begin wherever a control stands, but for those that choose a problem."""
        free = {c["name"] for c in about["controls"] if c["own_axes"]}
        first = next(a["axes"] for r, a in zip(requests, answers) if not r)
        for settings, answer in zip(requests, answers):
            if free.isdisjoint(settings) and "error" not in answer["answer"]:
                self.moved += 1
                if answer["axes"] != first:
                    self.fault(name, "'%s' has other axes" % answer["words"])

    def stays(self, page, name):
        """Without workers or scripts the printed figure is seen."""
        text = open(os.path.join(self.folder, page), encoding="utf-8").read()
        picture = re.search(r'<div class="live" data-figure="%s"[^>]*></div>.*?<img src="([^"]+)"' % name, text, re.S).group(1)
        for what, take in (("workers", "window.Worker = undefined"), ("WebAssembly", "delete window.WebAssembly")):
            tab = Tab(self.browser, self.folder)
            self.browser.call("Page.addScriptToEvaluateOnNewDocument", tab.session, source=take)
            seen, computes = json.loads(tab.visit(page, probes.STAYS.replace("PICTURE", picture)))
            if not seen or computes:
                self.fault(name, "the printed figure is not seen without " + what)
            self.browser.call("Page.close", tab.session)
        tab = Tab(self.browser, self.folder)
        self.browser.call("Emulation.setScriptExecutionDisabled", tab.session, value=True)
        tab.open(page)
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
    figures = [(page, name) for page in sorted(os.listdir(folder)) if page.endswith(".html") and not page.startswith("slides")
               for name in re.findall(r'<div class="live" data-figure="(\w+)"', open(os.path.join(folder, page), encoding="utf-8").read())]
    browser = Browser(program)
    try:
        check = Check(browser, folder, os.path.abspath(words[1] or "build/bin/live"), words[2] or "build/live")
        size = sum(len(base64.b64decode(packed)) for packed in re.findall(r'"([^"]{100,})"', open(os.path.join(folder, "engine.js")).read()))
        for k, (page, name) in enumerate(figures):
            if name in (other for _, other in figures[:k]):    # the same on another page
                print("%-16s first answer on %s: %s ms" % (name, page, check.comes(page, name)), flush=True)
            else:
                check.figure(page, name)
        check.stays(*figures[0])
        check.native.stdin.close()
    finally:
        browser.close()
    for what in check.bad:
        print(what)
    print("%d live figures on %d pages, engine of %.2f MB packed; %d states with the same axes, %d layers compared, %d states named by texts: %s" % (
        len(figures), len({p for p, _ in figures}), size / 1e6, check.moved, check.drawn, check.states,
        "%d problems" % len(check.bad) if check.bad else "all fine"))
    sys.exit(1 if check.bad or check.moved < 20 or not check.drawn or not check.states else 0)


main()
