"""How fast the workbench answers, measured in the browser: first page and fit, slider to redrawn curves, memory.

python -m benchmarks.workbench [--moves 1000] [--fits 20]

Six runs of 10 s with three signals of 1001 samples, from the independent rig. The time of a move begins with the event
of the slider and ends with the screen's next picture after the curves were drawn: the way to the server and back, six
simulations and the drawing lie between. The load of the machine is told beside, for all of it is shared.
"""

from __future__ import annotations

import argparse
import os
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from playwright.sync_api import sync_playwright

from benchmarks.workbench.data import six_runs
from scripts.browser import MISSING, chromium, serving

MOVES = """
async ([moves, pause]) => {
  const slider = document.querySelector("#parameters input[type=range]"), times = [];
  const shown = () => new Promise((done) => {
    const drawn = (event) => {
      if (event.detail.version <= seen) return;
      seen = event.detail.version;
      document.removeEventListener("drawn", drawn);
      requestAnimationFrame(done);
    };
    document.addEventListener("drawn", drawn);
  });
  let seen = -1;
  for (let i = 0; i <= moves; i++) {
    await new Promise((done) => setTimeout(done, pause));
    const begun = performance.now(), waiting = shown();
    slider.value = String(300 + ((i * 37) % 401));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    await waiting;
    times.push(performance.now() - begun);
  }
  return times.slice(1);
}
"""


def main() -> int:
    """Prints the figures."""
    parser = argparse.ArgumentParser(prog="python -m benchmarks.workbench", description=__doc__)
    parser.add_argument("--moves", type=int, default=1000)
    parser.add_argument("--fits", type=int, default=20)
    options = parser.parse_args()
    program = chromium()
    if program is None:
        print(MISSING, file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as playwright:
        data = six_runs(Path(folder) / "six")
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        with serving(data) as (address, process):
            page = browser.new_page(viewport={"width": 1280, "height": 800})
            told("first page [s]", [first_page(page, address)])
            told("first fit, pressed at once [s]", [first_fit(page)])
            told("a page after it [s]", [first_page(page, address) for _ in range(3)])
            moves(page, 20)
            before = memory(process)
            told("slider to redrawn curves [ms]", moves(page, options.moves))
            after = memory(process)
            print(
                f"memory of the server over {options.moves} moves: {before:.0f} MB -> {after:.0f} MB"
            )
            for _ in range(options.fits):
                fit(page)
            print(f"and over {options.fits} fits: -> {memory(process):.0f} MB")
        browser.close()
    return 0


def first_page(page: Any, address: str) -> float:
    """Seconds until curves and errors stand there."""
    begin = time.perf_counter()
    page.goto(address)
    page.locator("#ladder .fit:not(:empty)").first.wait_for()
    return time.perf_counter() - begin


def first_fit(page: Any) -> float:
    """Seconds until it is done; it is taken back."""
    begin = time.perf_counter()
    page.locator("#fit").click()
    page.locator("#status", has_text="fit is done").wait_for(timeout=120_000)
    seconds = time.perf_counter() - begin
    page.locator("#undo").click()
    return seconds


def moves(page: Any, count: int) -> list[float]:
    """Milliseconds of each move of the first slider."""
    times: list[float] = page.evaluate(MOVES, [count, 30])
    return times


def fit(page: Any) -> None:
    """One fit from where the sliders stand."""
    page.locator("#fit").click()
    page.locator("#status", has_text="fit is done").wait_for(timeout=120_000)
    moves(page, 1)
    page.wait_for_timeout(100)


def memory(process: int) -> float:
    """Resident memory of the server [MB]."""
    pages = int(Path(f"/proc/{process}/statm").read_text().split()[1])
    return pages * os.sysconf("SC_PAGE_SIZE") / 1e6


def told(what: str, values: list[float]) -> None:
    """Prints the spread of some values."""
    ordered = sorted(values)
    middle, high = ordered[len(ordered) // 2], ordered[int(0.9 * (len(ordered) - 1))]
    load = os.getloadavg()[0]
    print(
        f"{what}: least {ordered[0]:.3g}, median {middle:.3g}, 90 % below {high:.3g}, largest {ordered[-1]:.3g} "
        f"(load {load:.1f} on {os.cpu_count()} processors)",
        flush=True,
    )


if __name__ == "__main__":
    sys.exit(main())
