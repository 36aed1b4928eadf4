"""Where the time of a move goes: on the server, on the way, in the page, and until the screen shows it.

python -m benchmarks.workbench.parts [--moves 300]

The same six runs as ``python -m benchmarks.workbench``. What the server does is timed in a session of its own, without
a page; the rest in the page, by when a value left it, when its curves came, when they were drawn and when the screen
showed them. Least and median are told: all of it is shared with whatever else the machine does.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

from benchmarks.workbench.data import six_runs
from pam_cosim.comparison import RunComparison
from pam_cosim.workbench import Session
from pam_cosim.workbench.curves import model_curves
from pam_cosim.workbench.frames import frame
from pam_cosim.workbench.open_study import scored_runs
from pam_cosim.workbench.protocol import text_of_message
from pam_cosim.workbench.state import State
from pam_cosim.workbench.state_events import scores_event
from scripts.browser import MISSING, chromium, serving

WATCH = """
(() => {
  const times = (window.moveTimes = {});
  const send = WebSocket.prototype.send;
  WebSocket.prototype.send = function (...content) {
    times.sent = performance.now();
    return send.apply(this, content);
  };
  const heard = Object.getOwnPropertyDescriptor(WebSocket.prototype, "onmessage");
  Object.defineProperty(WebSocket.prototype, "onmessage", {
    ...heard,
    set(handler) {
      heard.set.call(this, (event) => {
        if (typeof event.data !== "string") times.came = performance.now();
        handler(event);
      });
    },
  });
  document.addEventListener("drawn", () => (times.drawn = performance.now()));
})();
"""

MOVES = """
async (moves) => {
  const slider = document.querySelector("#parameters input[type=range]"), found = [];
  for (let i = 0; i <= moves; i++) {
    await new Promise((done) => setTimeout(done, 60));
    const times = window.moveTimes;
    const begun = performance.now();
    slider.value = String(300 + ((i * 37) % 401));
    const drawn = new Promise((done) => {
      const look = () => {
        if (!(times.came > begun)) return;
        document.removeEventListener("drawn", look);
        done();
      };
      document.addEventListener("drawn", look);
    });
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    await drawn;
    const { sent, came, drawn: ready } = times;
    await new Promise((done) => requestAnimationFrame(done));
    found.push([sent - begun, came - sent, ready - came, performance.now() - ready, performance.now() - begun]);
  }
  return found.slice(1);
}
"""


def main() -> int:
    """Prints a line for each part."""
    parser = argparse.ArgumentParser(
        prog="python -m benchmarks.workbench.parts", description=__doc__
    )
    parser.add_argument("--moves", type=int, default=300)
    options = parser.parse_args()
    program = chromium()
    if program is None:
        print(MISSING, file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        data = six_runs(Path(folder) / "six")
        server = on_the_server(data, options.moves)
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        with serving(data) as (address, _):
            page = browser.new_page(viewport={"width": 1280, "height": 800})
            page.add_init_script(WATCH)
            page.goto(address)
            page.locator("#ladder .fit:not(:empty)").first.wait_for()
            page.evaluate(MOVES, 20)
            begun, there_and_back, drawing, screen, whole = map(
                list, zip(*page.evaluate(MOVES, options.moves), strict=True)
            )
        browser.close()
    simulation, curves = server["simulation of six runs"], server["curves as a frame"]
    way = [t - least(simulation) - least(curves) for t in there_and_back]
    print(f"load {os.getloadavg()[0]:.1f} on {os.cpu_count()} processors; least and median [ms]")
    for what, times in {
        "slider to the message": begun, **server, "the way there and back": way, "drawing": drawing,
        "until the screen shows it": screen, "slider to redrawn curves": whole,
    }.items():  # fmt: skip
        print(f"{what:32} {least(times):6.1f} {sorted(times)[len(times) // 2]:6.1f}")
    return 0


def least(times: list[float]) -> float:
    """The quickest."""
    return min(times)


def on_the_server(folder: Path, moves: int) -> dict[str, list[float]]:
    """Milliseconds of what the server does for each move, before the curves are sent and after."""
    with Session(folder) as session:
        time.sleep(1.0)  # what is told a moment after the study was opened is told
        state, opened = session.state, session.opened

        def moved(i: int) -> State:
            return replace(state, values={"valve.C_A": 0.6 + 0.001 * (i % 50)})

        def run(i: int) -> tuple[RunComparison, ...]:
            return opened.simulators.run(state.data, moved(i).values)[0]

        runs = run(0)
        comparison = scored_runs(moved(0), opened, runs)
        parts: dict[str, Callable[[int], Any]] = {
            "simulation of six runs": run,
            "curves as a frame": lambda i: frame("model", i, model_curves(runs, state.data)),
            "scores, after the curves": lambda i: scored_runs(moved(i), opened, runs),
            "scores as an event, likewise": lambda i: text_of_message(
                scores_event(moved(i), opened, comparison, i)
            ),
        }
        return {what: timed(part, moves) for what, part in parts.items()}


def timed(part: Callable[[int], Any], count: int) -> list[float]:
    """Milliseconds of each call."""
    times = []
    for i in range(count):
        begin = time.perf_counter()
        part(i)
        times.append(1e3 * (time.perf_counter() - begin))
    return times


if __name__ == "__main__":
    sys.exit(main())
