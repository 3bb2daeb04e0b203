"""live_probes.py: what check-live.py asks of a figure, runs in its page, where NAME stands for the figure, and compares."""
import glob
import math
import os

PART = 1e-6    # of a number, or of an axis, by which two machines may differ
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))

# Where a figure is on the page, when it is at the begin of the screen.
BOX = r"""(async () => {
  const live = document.querySelector('div.live[data-figure=NAME]');
  live.style.scrollMarginTop = '100px';
  live.scrollIntoView();
  await new Promise(r => setTimeout(r, 300));
  const b = live.getBoundingClientRect();
  return JSON.stringify([b.left + scrollX, b.top + scrollY, b.width, b.height]);
})()"""

# Waits until a figure that is nearly reached is there; whether its controls have labels, and since when the engine is there.
MOUNT = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms)), live = () => document.querySelector('div.live[data-figure=NAME]');
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  for (let i = 0; i < 400 && live() && !live().querySelector('form') && !live().matches('.failed'); ++i) {
    live().style.scrollMarginTop = innerHeight + 100 + 'px';         // not yet on the screen
    if (i % 10 === 0) live().scrollIntoView();
    await wait(50);
  }
  if (!live()?.querySelector('form')) return JSON.stringify({ gone: true });
  live().style.scrollMarginTop = '';
  for (let i = 0; i < 200 && live().getAttribute('aria-busy'); ++i) await wait(50);
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  const inputs = [...live().querySelectorAll('input, select')], status = live().querySelector('[role=status]');
  return JSON.stringify({ unlabelled: inputs.filter(i => i.labels.length !== 1).map(i => i.id), status: status?.textContent,
    asks: live().classList.contains('asks'), started: (await signoriniLive()).started });
})()"""

REVEAL = "[...document.querySelectorAll('div.live[data-figure=NAME] .live-ask button')].pop()?.click()"

# How high a figure is, and how much room the page keeps for it.
ROOM = r"""(async () => {
  const live = document.querySelector('div.live[data-figure=NAME]');
  await new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)));
  const kept = parseFloat(getComputedStyle(live).minHeight);
  live.style.minHeight = 0;
  const high = Math.ceil(live.getBoundingClientRect().height);
  live.style.minHeight = '';
  return JSON.stringify([high, kept]);
})()"""

# Moves controls, one request after the other; answers with their arrays, the axes and scales that are seen, and the time from the
# event to the frame with the answer.
ASK = r"""(async requests => {
  const live = document.querySelector('div.live[data-figure=NAME]'), form = live.querySelector('form'), out = [];
  const frame = () => new Promise(done => requestAnimationFrame(() => setTimeout(done)));
  const pack = a => { let s = ''; const b = new Uint8Array(a.buffer); for (let i = 0; i < b.length; i += 8192) s += String.fromCharCode(...b.subarray(i, i + 8192)); return btoa(s); };
  for (const settings of requests) {
    form.querySelectorAll('option').forEach(o => o.selected = o.defaultSelected);
    form.querySelectorAll('input').forEach(i => { i.type === 'checkbox' ? i.checked = i.defaultChecked : i.value = i.defaultValue; });
    for (const [name, value] of Object.entries(settings)) {
      const input = document.getElementById('live-NAME-' + name);
      input.type === 'checkbox' ? input.checked = value === 'on' : input.value = value;
    }
    const answered = new Promise(done => live.addEventListener('answered', e => done(e.detail), { once: true })), begin = performance.now();
    form.dispatchEvent(new Event('input'));
    const { words, answer, arrays } = await answered;
    await frame();
    const painted = performance.now() - begin;
    const axes = [...live.querySelectorAll('.live-panels h4, .live-stage svg > text, .live-stage svg > .grid, .live-legend li:has(.live-scale)')].map(e => e.textContent + (e.getAttribute('d') ?? ''));
    out.push({ words, answer, painted, arrays: arrays.map(pack), axes: axes.join('|'), says: live.querySelector('[role=status]').textContent });
  }
  return JSON.stringify(out);
})(REQUESTS)"""

WIDE = r"""JSON.stringify({ page: document.documentElement.scrollWidth > innerWidth + 1,
  parts: [...document.querySelectorAll('div.live :not(svg *, .live-table *, .live-tabs *)')].filter(e => e.getBoundingClientRect().right > innerWidth + 1).map(e => e.tagName + '.' + e.getAttribute('class')) })"""

# The words of the page that name a state of the figure: what they set, and where the controls then stand.
STATES = r"""(async () => {
  const live = document.querySelector('div.live[data-figure=NAME]'), out = [];
  for (const link of document.querySelectorAll('a.set[href^="#live-NAME&"]')) {
    if (link.hash !== location.hash) {
      const answered = new Promise(done => live.addEventListener('answered', done, { once: true }));
      link.click();
      await answered;
    }
    out.push([link.hash.split('&').slice(1).map(s => decodeURIComponent(s).split('=')).map(([name, value]) => {
      const input = document.getElementById('live-NAME-' + name);
      return [name, value, input ? input.type === 'checkbox' ? input.checked ? 'on' : 'off' : input.value : null];
    }), live.matches('.failed')]);
  }
  return JSON.stringify(out);
})()"""

# With the engine there, the figure comes near (100 px below the screen), or is jumped to: where it is when it answers, after how many
# milliseconds its answer is painted, and what has moved until the page was seen to its end.
COMES = r"""(async () => {
  let moved = 0, at = null, then = null;
  new PerformanceObserver(l => { for (const e of l.getEntries()) moved += e.value; }).observe({ type: 'layout-shift', buffered: true });
  const live = document.querySelector('div.live[data-figure=NAME]'), wait = ms => new Promise(r => setTimeout(r, ms)), root = document.documentElement;
  for (let i = 0; i < 200 && (root.classList.contains('loading') || document.readyState !== 'complete'); ++i) await wait(20);
  await signoriniLive();
  const high = root.scrollHeight, begin = performance.now();
  live.addEventListener('answered', () => {
    at ??= live.getBoundingClientRect().top - innerHeight;
    requestAnimationFrame(() => setTimeout(() => { then ??= performance.now() - begin; }));
  });
  const jump = 'HOW' === 'jump', top = live.getBoundingClientRect().top + scrollY;
  const early = !!live.querySelector('form'), first = top < innerHeight + 300;    // on the first screen, or near it
  scrollTo(0, jump ? top - 80 : top - innerHeight - 100);
  for (let i = 0; i < 500 && then === null && !early; ++i) await wait(20);
  for (let y = scrollY; y < root.scrollHeight - innerHeight && y < top + innerHeight + 900; y += 120) { scrollTo(0, y); await wait(16); }
  await wait(100);
  return JSON.stringify({ early, first, at, then, moved, grown: root.scrollHeight - high });
})()"""

STAYS = r"""(async () => {
  const wait = ms => new Promise(r => setTimeout(r, ms)), printed = () => document.querySelector('.live-printed img[src*="PICTURE"]');
  for (let i = 0; i < 100 && document.readyState !== 'complete'; ++i) await wait(50);
  document.querySelector('div.live')?.scrollIntoView();
  await wait(1500);
  return JSON.stringify([printed().getBoundingClientRect().width > 0, !!document.querySelector('.live form')]);
})()"""


def requests_of(name, about):
    """The settings to ask for: as at the beginning, one step of each control, each control at its ends, and the checks."""
    steps, ends = [{}], [{}]
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


def determined(panel):
    """The layers of a panel that the problem determines."""
    return [layer for layer in panel["layers"] if not layer["varies"]]


def same_panels(one, other):
    """Whether the same determined layers lie on the same axes; those where all is rounding may have others."""
    def words(panel):
        layers = [{k: v for k, v in layer.items() if k not in ("x", "y", "value")} for layer in determined(panel)]
        return {**panel, "window": len(panel["window"]), "layers": layers}
    return list(map(words, one)) == list(map(words, other)) and all(
        math.isclose(a, b, rel_tol=PART) for p, q in zip(one, other) if determined(p) for a, b in zip(p["window"], q["window"]))


def difference(panel, layer, key, a, b):
    """By how much of its axis, or of its scale, an array of the browser differs from that of the program; inf if NaNs or sizes do."""
    k = 2 * (key == "y")
    if len(a) != len(b):
        return math.inf
    low, high = (layer["least"], layer["most"]) if key == "value" else panel["window"][k:k + 2]
    of = (lambda v: math.log10(v) if v > 0 else 0) if key != "value" and panel["log_" + key] else lambda v: v
    span, worst = of(high) - of(low), 0
    for p, q in zip(a, b):
        if math.isnan(p) != math.isnan(q):
            return math.inf
        if p != q and not math.isnan(p):
            worst = max(worst, abs(of(p) - of(q)) / max(span, abs(of(q))))
    return worst
