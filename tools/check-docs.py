#!/usr/bin/env python3
"""check-docs.py [BOOK] [WORD]

Opens every page of BOOK (default build/book) in headless Chromium and checks that every formula was typeset,
every image is there, nothing comes from outside, the console is silent, every link inside the book leads
somewhere, and the search box finds WORD.  Needs python3 and chromium, no further packages: Chromium is driven
through its debugging pipe.
"""
import json
import os
import re
import select
import shutil
import subprocess
import sys
import tempfile
import time
import urllib.parse

# Runs in a page: waits for the formulas, then reports what it finds.
PROBE = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms));
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  const formulas = /\\[[(]/.test(document.querySelector('.contents')?.textContent) || document.querySelector('script[type^="math/tex"],.MathJax_SVG');
  if (formulas && document.querySelector('script[src*="MathJax"]')) {
    for (let i = 0; i < 400 && !(window.MathJax && MathJax.Hub && MathJax.isReady); ++i) await wait(25);
    if (window.MathJax && MathJax.Hub)
      await Promise.race([new Promise(done => MathJax.Hub.Queue(done)), wait(20000)]);
  }
  const there = i => i.complete && i.naturalWidth > 0;    // under load a picture may come late
  for (let k = 0; k < 60 && ![...document.images].every(there); ++k) {
    if (k % 20 === 10) for (const i of document.images) if (!there(i)) i.src = i.src;
    await wait(100);
  }
  const raw = [], walk = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let n; (n = walk.nextNode());) {
    if (n.parentElement.closest('script,style,pre,code,.fragment,.tt,.MathJax_SVG,svg,noscript')) continue;
    if (/\\[\[\]()]|\\(frac|sum|int|alpha|begin|end|mathrm|left|right)\b|\\f[\$\[\]]|\$[^\s$](?:[^$]*[^\s$])?\$|[@\\](ref|subpage|anchor|PaperEq)\b|<!--/.test(n.textContent) ||
        n.parentElement.matches('.textblock p, .textblock li, .textblock td') && /(^|[\s(-])\*[A-Za-z]/.test(n.textContent))
      raw.push(n.textContent.trim().slice(0, 80));
  }
  const all = (selector, f) => [...document.querySelectorAll(selector)].map(f);
  return JSON.stringify({ raw,
    math: all('.MathJax_SVG', e => e.getBoundingClientRect().width),
    left: all('.MathJax_Error,.merror,.MathJax_SVG text[fill=red],.MathJax_SVG_Processing', e => e.textContent.slice(0, 80)),
    images: all('img', i => [i.getAttribute('src'), i.complete && i.naturalWidth > 0, i.alt]),
    ids: all('[id],a[name]', e => e.id || e.name),
    links: all('a[href]:not(.summary a)', a => a.getAttribute('href')),  // some Doxygens list private classes there
    wide: document.documentElement.scrollWidth > innerWidth + 2 });
})()"""

# Runs in a page: types a word into the search box, returns the number of hits.
SEARCH = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms)), box = document.getElementById('MSearchField');
  if (!box) return -1;
  box.focus(); box.value = WORD;
  for (const t of ['keydown', 'keyup']) box.dispatchEvent(new KeyboardEvent(t, { key: WORD.at(-1), keyCode: 65, bubbles: true }));
  if (window.searchBox) searchBox.OnSearchFieldChange({ keyCode: 65, which: 65, shiftKey: false, preventDefault() {} });
  for (let i = 0; i < 60; ++i) {
    await wait(100);
    const inner = Array.from({ length: frames.length }, (_, i) => { try { return frames[i].document } catch { return null } });
    let n = 0;
    for (const d of [document, ...inner])
      if (d) n += [...d.querySelectorAll('.SRResult')].filter(e => getComputedStyle(e).display !== 'none').length;
    if (n) return n;
  }
  return 0;
})()"""


class Browser:
    """A Chromium process and its debugging pipe: JSON messages separated by zero bytes."""

    def __init__(self, program):
        self.profile = tempfile.mkdtemp()
        to_browser, self.out = os.pipe()
        self.inp, from_browser = os.pipe()

        def child():  # Chromium reads from 3 and writes to 4
            a, b = os.dup(to_browser), os.dup(from_browser)
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--no-first-run",
             "--allow-file-access-from-files", "--window-size=1300,900", "--user-data-dir=" + self.profile],
            pass_fds=(3, 4, to_browser, from_browser), preexec_fn=child,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.buffer, self.count, self.events = b"", 0, []

    def message(self, timeout=60):
        end = time.time() + timeout
        while b"\0" not in self.buffer:
            if not select.select([self.inp], [], [], max(0, end - time.time()))[0]:
                raise TimeoutError("Chromium says nothing for %d seconds" % timeout)
            data = os.read(self.inp, 1 << 20)
            if not data:
                raise EOFError("Chromium ended")
            self.buffer += data
        line, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(line)

    def call(self, method, session=None, **params):
        self.count += 1
        request = {"id": self.count, "method": method, "params": params}
        if session:
            request["sessionId"] = session
        os.write(self.out, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message()
            if answer.get("id") == request["id"]:
                if "error" in answer:
                    raise RuntimeError(method + ": " + answer["error"]["message"])
                return answer["result"]
            if "method" in answer:
                self.events.append(answer)

    def close(self):
        try:
            self.call("Browser.close")
        except (OSError, EOFError, RuntimeError):
            pass
        try:
            self.process.wait(10)
        except subprocess.TimeoutExpired:
            self.process.kill()
        shutil.rmtree(self.profile, ignore_errors=True)


def complaint(event):
    """What an event of the browser says about the page, or None."""
    method, p = event["method"], event["params"]
    if method == "Runtime.exceptionThrown":
        return "script error: " + p["exceptionDetails"].get("exception", {}).get("description", "?").split("\n")[0]
    if method == "Log.entryAdded" and p["entry"]["level"] in ("error", "warning"):
        return "console: " + p["entry"]["text"]
    if method == "Runtime.consoleAPICalled" and p["type"] in ("error", "warning"):
        return "console: " + " ".join(str(a.get("value", "")) for a in p["args"])
    if method == "Network.requestWillBeSent" and not re.match("file:|data:|blob:", p["request"]["url"]):
        return "fetches " + p["request"]["url"]
    if method == "Network.loadingFailed" and not p.get("canceled"):
        return "a file is missing: " + p["errorText"]
    return None


class Check:
    """The pages of a folder, seen through a browser."""

    def __init__(self, browser, folder):
        self.browser, self.folder = browser, folder
        self.bad, self.links, self.ids, self.formulas, self.images = set(), [], {}, 0, 0
        target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            browser.call(domain + ".enable", self.session)

    def visit(self, page, script):
        """Opens a page, notes what the browser complains about, and returns what the script returns."""
        b = self.browser
        b.events.clear()
        b.call("Page.navigate", self.session, url="file://" + urllib.parse.quote(os.path.join(self.folder, page)))
        end = time.time() + 30
        while not any(e["method"] == "Page.loadEventFired" for e in b.events) and time.time() < end:
            event = b.message()
            if "method" in event:
                b.events.append(event)
        result = b.call("Runtime.evaluate", self.session, expression=script, awaitPromise=True, returnByValue=True)
        self.bad |= {(page, c) for c in map(complaint, b.events) if c}
        if "exceptionDetails" in result:
            self.bad.add((page, "the check itself failed: " + json.dumps(result["exceptionDetails"])[:200]))
        return result["result"].get("value")

    def page(self, page):
        found = json.loads(self.visit(page, PROBE) or "null")
        if not found:
            self.bad.add((page, "cannot be looked at"))
            return
        self.formulas += len(found["math"])
        self.images += len(found["images"])
        self.ids[page] = set(found["ids"])
        self.links += [(page, link) for link in found["links"]]
        self.bad |= {(page, "raw TeX or command in the text: " + t) for t in found["raw"]}
        self.bad |= {(page, "formula not typeset: " + t) for t in found["left"]}
        self.bad |= {(page, "formula without width") for w in found["math"] if w <= 0}
        self.bad |= {(page, "image does not load: " + src) for src, loaded, alt in found["images"] if not loaded}
        if found["wide"]:
            self.bad.add((page, "the page is wider than the window"))

    def check_links(self):
        for page, link in self.links:
            if re.match("(https?|mailto|javascript|doi):", link):
                continue
            path, _, anchor = link.partition("#")
            path, anchor = urllib.parse.unquote(path) or page, urllib.parse.unquote(anchor)
            if not os.path.exists(os.path.join(self.folder, path)):
                self.bad.add((page, "dead link: " + link))
            elif anchor and path in self.ids and not anchor.startswith("index_") and anchor not in self.ids[path]:
                self.bad.add((page, "dead anchor: " + link))


def main():
    folder = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/book")
    word = sys.argv[2] if len(sys.argv) > 2 else "notation"
    found = [os.environ.get("CHROMIUM")] + [shutil.which(p) for p in ("chromium", "chromium-browser", "google-chrome")]
    program = next((p for p in found if p), None)
    if not program:
        sys.exit("check-docs.py: no chromium found, run: tools/setup.sh check")
    pages = sorted(f for f in os.listdir(folder) if f.endswith(".html"))
    if "index.html" not in pages:
        sys.exit("check-docs.py: no pages in %s, run: make book" % folder)
    browser = Browser(program)
    try:
        check = Check(browser, folder)
        for page in pages:
            check.page(page)
        check.check_links()
        hits = check.visit("index.html", SEARCH.replace("WORD", json.dumps(word))) or 0
        if hits < 1:
            check.bad.add(("search", "'%s' is not found" % word))
    finally:
        browser.close()
    for page, what in sorted(check.bad):
        print(page + ": " + what)
    print("%d pages, %d formulas, %d images, %d links, %d hits for '%s': %s" % (
        len(pages), check.formulas, check.images, len(check.links), hits, word,
        "%d problems" % len(check.bad) if check.bad else "all fine"))
    sys.exit(1 if check.bad else 0)


main()
