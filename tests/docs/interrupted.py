#!/usr/bin/env python3
"""interrupted.py PROGRAM SOURCES FOLDER

What PROGRAM says while a run lasts, on a terminal and elsewhere, and what an interruption leaves: a word, the signal as its end, files
that are whole, and a state from which a run goes on. Writes to FOLDER. No run is expected to take any time: each lasts until it has said
what is waited for, and is then interrupted.
"""
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import sys
import time

program, sources, folder = (os.path.abspath(path) for path in sys.argv[1:])
STEPS = """
[[body]]
name = "slab"
mesh = { kind = "block", size = [4, 1], cells = [8, 2] }
material = { youngs_modulus = 1000, poisson_ratio = 0.3 }
pressure = { top = { value = 2, history = "press" } }
traction = { right = { value = [1, 0], history = "drag" } }
[[contact]]
source = "bottom"
target = { kind = "half_plane", point = [0, 0], normal = [0, 1] }
friction = 0.5
[[steps]]
values = { press = 1 }
[[steps]]
count = %d
values = { drag = 0.1 }
"""
LONG = 900000  # steps, more than a test waits for
PATIENCE = 120  # until something is wrong [s]
failures = []


def check(what, good, shown=""):
    if not good:
        failures.append("%s%s" % (what, ": " + repr(shown[-600:]) if shown else ""))


def default_signals():
    """For a program that is to be interrupted even where the test itself was told not to be."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def on_terminal(words, wanted):
    """Runs on a terminal of its own and types Ctrl-C when `wanted` has been said. Returns how it ended and all that was said."""
    pid, terminal = pty.fork()
    if pid == 0:
        default_signals()
        os.execv(program, [program, *words])
    said, typed, begin = "", False, time.time()
    while True:
        ready, _, _ = select.select([terminal], [], [], 0.1)
        try:
            part = os.read(terminal, 1 << 16) if ready else b""
        except OSError:  # the program has ended
            break
        if ready and not part:
            break
        said += part.decode()
        if not typed and re.search(wanted, said):
            os.write(terminal, b"\x03")
            typed = True
        if time.time() - begin > PATIENCE:
            os.kill(pid, signal.SIGKILL)
    return os.waitpid(pid, 0)[1], said


def stopped(words, wanted, number):
    """Runs without a terminal and sends a signal when `wanted` is a file that is there. Returns the status and the error stream."""
    run = subprocess.Popen([program, *words], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, preexec_fn=default_signals)
    begin = time.time()
    while not os.path.exists(wanted) and run.poll() is None and time.time() - begin < PATIENCE:
        time.sleep(0.02)
    time.sleep(0.3)  # somewhere in the steps
    run.send_signal(number)
    said = run.communicate(timeout=PATIENCE)[1]
    return run.returncode, said


def last_time(table):
    if not os.path.exists(table):
        return "none"
    with open(table) as lines:
        return lines.read().splitlines()[-1].split(",")[0]


def left():
    return sorted(name for name in os.listdir(".") if "draft" in name or name.endswith(".lock"))


def main():
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    os.chdir(folder)
    for name, count in ("long", LONG), ("short", 20):
        with open(name + ".toml", "w") as scene:
            scene.write(STEPS % count)

    # Load steps on a terminal.
    files = ["--state", "a.state", "--csv", "a.csv"]
    status, said = on_terminal(["solve", "long.toml", *files], r"step \d+ at time \S+, \d+ to go, about \S+ s left: \d+ s so far")
    check("steps on a terminal", os.WIFSIGNALED(status) and os.WTERMSIG(status) == signal.SIGINT, said)
    word = re.search(r"signorini: interrupted after \S+ s(?: \(step.*\))?; the steps up to time (\S+) are kept; "
                     r"to go on: signorini (solve long\.toml --from a\.state --state a\.state --csv a\.csv)\r\n$", said)
    check("the word on steps", word, said)
    if word:
        check("the last row is of another time than the word: " + last_time("a.csv"), last_time("a.csv") == word.group(1))
        status, said = on_terminal(word.group(2).split(), "goes on from time (.|\n)*so far")
        check("going on from what was kept", "goes on from time " + word.group(1) in said and os.WIFSIGNALED(status), said)
    check("no first line before two seconds", not re.search(r"\b[01] s so far", said), said)

    # Without a terminal there are no lines, but there is a word.
    status, said = stopped(["solve", "long.toml", "--csv", "b.csv"], "b.csv", signal.SIGINT)
    check("steps without a terminal end with %d" % status, status == -signal.SIGINT)
    check("without a terminal", re.fullmatch(r"signorini: interrupted after \S+ s( \(.*\))?; the files have the steps up to time (\S+); "
                                             r"with --state FILE a run can go on from there, by --from FILE\n", said), said)
    check("the table is whole", said.split("up to time ")[-1].startswith(last_time("b.csv") + ";"), said)
    status, said = stopped(["solve", "long.toml", "--csv", "c.csv"], "c.csv", signal.SIGTERM)
    check("SIGTERM ends with %d" % status, status == -signal.SIGTERM and "signorini: interrupted" in said, said)

    # A refinement, and a shell that calls the end 130.
    cantilever = os.path.join(sources, "examples/cantilever.toml")
    status, said = on_terminal(["solve", cantilever, "--accuracy", "1e-9", "--unknowns", "1e7", "--vtu", "d.vtu"],
                               r"mesh \d+, refined from one of \d+ unknowns: \d+ s so far")
    check("a refinement", os.WIFSIGNALED(status) and re.search(r"interrupted .*\(mesh .*\); nothing was written\r\n$", said), said)
    shell = subprocess.Popen(["sh", "-c", "trap : INT; '%s' solve long.toml --state e.state > e.out; echo status $?" % program],
                             stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, start_new_session=True, preexec_fn=default_signals)
    while not os.path.exists("e.state") and shell.poll() is None:
        time.sleep(0.02)
    os.killpg(shell.pid, signal.SIGINT)
    check("a shell", shell.communicate(timeout=PATIENCE)[0] == "status 130\n")

    # Who is told to ignore the signal ignores it.
    ignoring = subprocess.Popen([program, "solve", "short.toml", "--csv", "f.csv"], stdout=subprocess.DEVNULL,
                                preexec_fn=lambda: signal.signal(signal.SIGINT, signal.SIG_IGN))
    for _ in range(20):
        ignoring.send_signal(signal.SIGINT)
        time.sleep(0.005)
    check("an ignored signal", ignoring.wait(PATIENCE) == 0)
    status, said = on_terminal(["solve", "short.toml"], "never said")
    check("a short run says nothing of itself", status == 0 and "so far" not in said, said)
    check("files were left: %s" % left(), not left() and not os.path.exists("d.vtu"))
    print("\n".join("interrupted.py: " + failure for failure in failures) or "all runs ended as they should")
    return 1 if failures else 0


sys.exit(main())
