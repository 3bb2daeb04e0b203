"""browser.py: a headless Chromium, driven through its debugging pipe, for check-docs.py, check-live.py and book-pdf.py.

Needs chromium, no further packages of Python.
"""
import json
import os
import queue
import re
import shutil
import subprocess
import tempfile
import threading
import time
import urllib.parse


def chromium():
    """The program of the browser: what CHROMIUM names, or the first that is installed, or None."""
    found = [os.environ.get("CHROMIUM")] + [shutil.which(p) for p in ("chromium", "chromium-browser", "google-chrome")]
    return next((p for p in found if p), None)


class Browser:
    """A Chromium process and its debugging pipe: JSON messages separated by zero bytes."""

    def __init__(self, program, patience=120):
        self.patience = patience    # seconds for an answer
        self.profile = tempfile.mkdtemp()
        to_browser, self.out = os.pipe()
        self.inp, from_browser = os.pipe()

        def child():  # Chromium reads from 3 and writes to 4
            a, b = os.dup(to_browser), os.dup(from_browser)
            os.dup2(a, 3)
            os.dup2(b, 4)

        self.process = subprocess.Popen(
            [program, "--headless", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--remote-debugging-pipe", "--no-first-run",
             "--disable-background-timer-throttling", "--disable-renderer-backgrounding",
             "--disable-backgrounding-occluded-windows",
             "--allow-file-access-from-files", "--window-size=1280,900", "--user-data-dir=" + self.profile],
            pass_fds=(3, 4, to_browser, from_browser), preexec_fn=child,
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(to_browser)
        os.close(from_browser)
        self.lock, self.count, self.ended = threading.Lock(), 0, False
        self.inbox = {None: queue.Queue()}  # messages by session; None is the browser itself
        threading.Thread(target=self.listen, daemon=True).start()

    def listen(self):
        buffer = b""
        while data := os.read(self.inp, 1 << 20):
            *lines, buffer = (buffer + data).split(b"\0")
            for message in map(json.loads, lines):
                with self.lock:
                    inbox = self.inbox.setdefault(message.get("sessionId"), queue.Queue())
                inbox.put(message)
        with self.lock:
            self.ended = True
            for inbox in self.inbox.values():
                inbox.put(None)

    def message(self, session, timeout=None):
        timeout = self.patience if timeout is None else timeout
        with self.lock:
            inbox = self.inbox.setdefault(session, queue.Queue())
            ended = self.ended
        try:
            message = inbox.get(timeout=0.001 if ended else max(0.001, timeout))
        except queue.Empty:
            message = None
            if not ended:
                raise TimeoutError("Chromium says nothing for %d seconds" % timeout) from None
        if message is None:
            raise EOFError("Chromium ended")
        if message.get("method") == "Inspector.targetCrashed":
            raise EOFError("Chromium's page crashed, for want of memory or by a fault of its own")
        return message

    def call(self, method, session=None, events=None, **params):
        with self.lock:
            self.count += 1
            request = {"id": self.count, "method": method, "params": params}
            if session:
                request["sessionId"] = session
            os.write(self.out, json.dumps(request).encode() + b"\0")
        while True:
            answer = self.message(session)
            if answer.get("id") == request["id"]:
                if "error" in answer:
                    raise RuntimeError(method + ": " + answer["error"]["message"])
                return answer["result"]
            if "method" in answer and events is not None:
                events.append(answer)

    def close(self):
        try:
            self.call("Browser.close")
        except (OSError, EOFError, RuntimeError, TimeoutError):
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


class Tab:
    """One of several pages that a browser has open."""

    def __init__(self, browser, folder):
        self.browser, self.folder, self.page, self.bad = browser, folder, None, set()
        target = browser.call("Target.createTarget", url="about:blank", newWindow=True)["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            browser.call(domain + ".enable", self.session)

    def open(self, page):
        """Opens a page, waits until it is loaded, and returns the events till then."""
        b, events = self.browser, []
        b.call("Page.navigate", self.session, events, url="file://" + urllib.parse.quote(os.path.join(self.folder, page), safe="/#&="))
        end = time.time() + 30
        while not any(e["method"] == "Page.loadEventFired" for e in events) and time.time() < end:
            event = b.message(self.session, end - time.time())
            if "method" in event:
                events.append(event)
        return events

    def visit(self, page, script):
        """Opens a page, notes what the browser complains about, and returns what the script returns."""
        b, events = self.browser, self.open(page)
        result = b.call("Runtime.evaluate", self.session, events, expression=script, awaitPromise=True, returnByValue=True)
        self.page = page
        self.listen(events)
        if "exceptionDetails" in result:
            self.bad.add((page, "the check itself failed: " + json.dumps(result["exceptionDetails"])[:200]))
        return result["result"].get("value")

    def listen(self, events):
        """Notes what events say about the page that was visited last."""
        self.bad |= {(self.page, c) for c in map(complaint, events) if c}
