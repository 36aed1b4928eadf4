"""Draws the pictures of the workbench in docs/pictures from a real study, which it does on the page.

Run as ``python -m scripts.workbench_pictures``; takes some minutes, most of them the diagnosis. The data come from the
independent rig, with a spring law that the catalogue lacks.
"""

from __future__ import annotations

import io
import shutil
import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

from PIL import Image, ImageChops
from playwright.sync_api import sync_playwright

from scripts.browser import MISSING, chromium, serving

ROOT = Path(__file__).resolve().parent.parent
PICTURES = ROOT / "docs" / "pictures"
DATA = ROOT / "examples" / "hidden-spring"
SIZE = {"width": 1280, "height": 800}
SMALL = (960, 600)  # px, of the moving picture
COLOURS = 80
REST, MOVE = 1400, 300  # ms that a picture stands
LONG = 1_200_000  # ms, for a diagnosis


class Film:
    """Pictures of a page, one after another, those that show nothing new left out."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.frames: list[Image.Image] = []
        self.times: list[int] = []

    def take(self, stands: int = MOVE) -> None:
        """Adds the page as it is, to stand for some milliseconds."""
        picture = (
            Image.open(io.BytesIO(self.page.screenshot()))
            .convert("RGB")
            .resize(SMALL, Image.Resampling.LANCZOS)
        )
        if self.frames and ImageChops.difference(self.frames[-1], picture).getbbox() is None:
            self.times[-1] += stands
            return
        self.frames.append(picture)
        self.times.append(stands)

    def until(self, done: Callable[[], bool]) -> None:
        """Films until something holds, and how it stands then."""
        while not done():
            self.take()
        self.page.wait_for_timeout(700)  # what is told last
        self.take(REST)

    def save(self, path: Path) -> None:
        """Writes a GIF; all its pictures share one set of colours."""
        several = Image.new("RGB", (SMALL[0], 3 * SMALL[1]))
        for k, frame in enumerate(
            (self.frames[0], self.frames[len(self.frames) // 2], self.frames[-1])
        ):
            several.paste(frame, (0, k * SMALL[1]))
        palette = several.quantize(COLOURS, dither=Image.Dither.NONE)
        flat = [frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in self.frames]
        flat[0].save(
            path, save_all=True, append_images=flat[1:], duration=self.times, loop=0, optimize=True
        )


def main() -> int:
    """Does the study and draws."""
    program = chromium()
    if program is None:
        print(MISSING, file=sys.stderr)
        return 2
    with tempfile.TemporaryDirectory() as place, sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=program, args=["--no-sandbox"])
        folder = Path(place) / "my-rig"
        shutil.copytree(DATA, folder)
        with serving(folder) as (address, _):
            cut(browser, address)
        with serving(folder) as (address, _):
            study(browser, address)
        with serving(Path(place) / "new-rig") as (address, _):
            dropped(browser, address, folder, Path(place))
        browser.close()
    return 0


def study(browser: Any, address: str) -> None:
    """From the first look to the error at the noise; the film of it, and stills."""
    light = browser.new_context(viewport=SIZE, color_scheme="light")
    page = opened(light, address)
    film = Film(page)
    film.take(REST)
    for share in range(5):
        slide(page, "valve.C_A", 500 + 45 * share)
        film.take()
    film.take(REST // 2)
    page.locator("#fit").click()
    film.until(lambda: ended(page, "fit"))

    page.locator("#diagnose").click()
    page.locator(".ranking tbody tr").nth(5).wait_for(timeout=LONG)
    film.take(REST // 2)
    until = time.monotonic() + LONG / 1000
    count = 0
    while not ended(page, "diagnosis") and time.monotonic() < until:
        rows = page.locator(".ranking tbody tr").count()
        if rows >= count + 4:
            film.take()
            count = rows
        page.wait_for_timeout(300)
    page.locator(".verdict button").wait_for()
    page.locator("#diagnosis").evaluate("panel => panel.scrollTo(0, 0)")
    film.take(2 * REST)
    still(page, "workbench-verdict")
    page.locator("#tab-balances").click()
    still(page, "workbench-balances")

    page.locator("#tab-curves").click()
    page.locator("#tab-diagnosis").click()
    page.locator(".verdict button").click()
    page.locator(".effect.on").wait_for()
    page.locator("#tab-curves").click()
    page.wait_for_timeout(1500)
    film.take(2 * REST)
    page.locator(".effect.on .about summary").click()
    still(page, "workbench")
    film.save(PICTURES / "workbench.gif")
    light.close()


def cut(browser: Any, address: str) -> None:
    """A run whose beginning is dragged off, and where it begins then."""
    page = opened(browser.new_context(viewport=SIZE, color_scheme="light"), address)
    box = page.locator(".curve").first.bounding_box()
    left, height = box["x"] + 53, box["y"] + box["height"] / 3
    page.mouse.move(left, height)
    page.mouse.down()
    page.mouse.move(left + 14, height)
    page.mouse.move(left + 28, height)
    page.mouse.up()
    first = page.locator('.start[data-run="run-01"] > summary')
    first.filter(has_text="estimated").wait_for()
    first.click()
    page.locator(".run button").first.click()
    still(page, "workbench-cut")
    page.context.close()


def dropped(browser: Any, address: str, folder: Path, place: Path) -> None:
    """A recording with a word where a number belongs; then, without it, what each quantity is read from."""
    lines = (folder / "run-02.csv").read_text().splitlines()
    cells = lines[41].split(",")
    lines[41] = ",".join([*cells[:5], "n/a?", *cells[6:]])
    broken = place / "run-02.csv"
    broken.write_text("\n".join(lines) + "\n")
    page = opened(browser.new_context(viewport=SIZE, color_scheme="light"), address, ".zone")
    page.set_input_files("#recordings", [folder / "run-01.csv", broken])
    page.locator(".problem").wait_for()
    still(page, "workbench-drop")
    page.get_by_role("button", name="Remove run-02.csv").click()
    page.set_input_files("#recordings", [folder / "run-02.csv", folder / "run-03.csv"])
    page.locator(".draft:not(.waiting) tr", has_text="run-03").wait_for()
    page.locator("#drop h3", has_text="What each quantity").evaluate(
        "head => head.scrollIntoView()"
    )
    still(page, "workbench-draft")


def opened(context: Any, address: str, wait: str = "#ladder .fit:not(:empty)") -> Any:
    """The page, when it stands."""
    page = context.new_page()
    page.goto(address)
    page.locator(wait).first.wait_for()
    page.wait_for_timeout(800)
    return page


def slide(page: Any, parameter: str, place: int) -> None:
    """Moves a slider to a place of 0 to 1000."""
    move = "(slider, place) => { slider.value = place; slider.dispatchEvent(new Event('input', { bubbles: true })); }"
    page.locator(f'input[type=range][data-parameter="{parameter}"]').evaluate(move, str(place))
    page.wait_for_timeout(250)


def ended(page: Any, what: str) -> bool:
    """Whether a fit or a diagnosis is over."""
    return f"The {what} is done" in page.locator("#status").inner_text()


def still(page: Any, name: str) -> None:
    """A picture of the page as it is."""
    page.mouse.move(5, 5)
    page.wait_for_timeout(400)
    picture = (
        Image.open(io.BytesIO(page.screenshot()))
        .convert("RGB")
        .quantize(128, dither=Image.Dither.NONE)
    )
    picture.save(PICTURES / f"{name}.png", optimize=True)
    print(f"docs/pictures/{name}.png", flush=True)


if __name__ == "__main__":
    sys.exit(main())
