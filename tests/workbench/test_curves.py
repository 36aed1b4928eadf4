"""Curves for the screen: nothing that stands out is lost, and a frame is read as it was written."""

from __future__ import annotations

import asyncio
import json
import shutil
import subprocess
from base64 import b64decode
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim.workbench
from pam_cosim.errors import InputError
from pam_cosim.workbench import Session
from pam_cosim.workbench.curves import MOST_POINTS, measured_curves, shown_times, thinned
from pam_cosim.workbench.frames import PlottedCurve, frame, is_model
from tests.workbench.conftest import Window
from tests.workbench.frames_read import read_frame

PAGE = Path(pam_cosim.workbench.__file__).parent / "page"
CLOCK = 1.7e9  # s


def test_a_long_curve_keeps_its_peaks_and_its_gaps() -> None:
    time = np.linspace(0, 10, 123_457)
    values = np.sin(time)
    values[70_001], values[70_003] = 9.0, -9.0
    values[20_000:30_000] = np.nan
    few, at = thinned(values), shown_times(time)
    assert len(few) == len(at) <= MOST_POINTS and np.all(np.diff(at) > 0)
    assert np.nanmax(few) == 9.0 and np.nanmin(few) == -9.0
    assert at[np.nanargmax(few)] < at[np.nanargmin(few)]
    inside = (at > time[20_100]) & (at < time[29_900])
    assert np.isnan(few[inside]).all() and np.isfinite(few[at > time[30_100]]).all()
    assert np.nanmax(np.abs(few - np.sin(at))[np.abs(few) < 2]) < 0.01


def test_a_short_curve_is_left_as_it_is() -> None:
    values = np.array([1.0, np.nan, 3.0])
    assert thinned(values) is values and shown_times(values) is values


def test_a_frame_is_read_as_it_was_written() -> None:
    time = np.arange(5.0)
    curves = [
        PlottedCurve("ä <b>", "x", {"time": time, "values": np.array([1, 2, np.nan, 4, 5.5])}),
        PlottedCurve("ä <b>", "p", {"time": time, "values": np.zeros(5)}),
    ]
    message = frame("measured", 3, curves, "label")
    header, arrays = read_frame(message)
    assert [header[key] for key in ("kind", "version", "label")] == ["measured", 3, "label"]
    np.testing.assert_array_equal(arrays["ä <b>", "x", "values"], [1, 2, np.nan, 4, 5.5])
    one, other = header["runs"][0]["signals"]
    assert one["time_at"] == other["time_at"]  # each array is sent once
    (length,) = np.frombuffer(message[:4], "<u4")
    assert (4 + int(length)) % 4 == 0 and len(message) == 4 + length + 4 * 15
    assert (
        not is_model(message)
        and is_model(frame("model", 3, curves))
        and not is_model(frame("reference", 1, []))
    )
    with pytest.raises(ValueError):
        read_frame(b"\x01")


def test_a_window_that_is_behind_gets_the_newest_curves_alone() -> None:
    server = pytest.importorskip(
        "pam_cosim.workbench.server", reason="the extra 'workbench' is not installed"
    )
    sent: list[str | bytes] = []

    class Socket:
        async def send_text(self, text: str) -> None:
            sent.append(text)

        async def send_bytes(self, message: bytes) -> None:
            sent.append(message)

    async def behind() -> None:
        window = server.Window(Socket(), asyncio.get_running_loop())
        for version in range(50):
            window.tell(frame("model", version, []))
            window.tell(f"scores {version}")
        sending = asyncio.create_task(window.send())
        await asyncio.sleep(0.05)
        sending.cancel()

    asyncio.run(behind())
    (model,) = [read_frame(message)[0]["version"] for message in sent if isinstance(message, bytes)]
    assert model == 49 and sent[1:] == [f"scores {version}" for version in range(50)]


def test_times_of_a_clock_that_began_long_ago_are_distinguished(shared: Session) -> None:
    """As seconds since 1970, which 32 bits hold to two minutes."""
    data = shared.state.data
    runs = [replace(run, time=run.time + CLOCK) for run in data.runs]
    message = frame("measured", 1, measured_curves(replace(data, runs=tuple(runs))))
    header, arrays = read_frame(message)
    assert {run["from"] for run in header["runs"]} == {run.time[0] for run in runs}
    for run in runs:
        np.testing.assert_allclose(arrays[run.name, "x", "time"], run.time, rtol=0, atol=1e-6)


def in_page(code: str, tmp_path: Path) -> Any:
    """What some JavaScript says that uses modules of the page, run without a browser."""
    program = shutil.which("node")
    if program is None:
        pytest.skip("node is not installed")
    for module in ("frames", "numbers", "drawing"):  # as modules, whatever lies beside them
        shutil.copy(PAGE / f"{module}.js", tmp_path / f"{module}.mjs")
    script = tmp_path / "script.mjs"
    script.write_text(code, encoding="utf-8")
    done = subprocess.run([program, script], capture_output=True, text=True, cwd=tmp_path)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def test_the_page_reads_the_times_of_such_a_clock(tmp_path: Path) -> None:
    time = np.array([0.0, 0.02, 4.0])
    curves = [PlottedCurve("run", "x", {"time": time, "values": time}, CLOCK)]
    (tmp_path / "frame").write_bytes(frame("measured", 1, curves))
    read = in_page(
        """
        import { readFileSync } from "node:fs";
        import { readFrame } from "./frames.mjs";
        const { time, values } = readFrame(new Uint8Array(readFileSync("frame")).buffer).runs.get("run").get("x");
        console.log(JSON.stringify({ time: [...time], values: [...values] }));
        """,
        tmp_path,
    )
    np.testing.assert_allclose(read["time"], CLOCK + time, rtol=0, atol=1e-6)
    np.testing.assert_allclose(read["values"], time, rtol=1e-6)


def test_the_page_draws_and_cuts_by_such_a_clock(tmp_path: Path) -> None:
    """Ten samples over a thousand pixels stand where they belong; a cut is rounded by the span of its run."""
    drawn = in_page(
        f"""
        import {{ trace }} from "./drawing.mjs";
        import {{ moment }} from "./numbers.mjs";
        const xs = Array.from({{ length: 10 }}, (_, i) => {CLOCK} + i / 9), places = [];
        const g = {{ moveTo: (x) => places.push(x), lineTo: (x) => places.push(x) }};
        trace(g, xs, xs.map(() => 0), 0, 10, (t) => 997.3 * (t - {CLOCK}), (y) => y);
        const cuts = [[{CLOCK} + 1.23456789, 4], [1.23456789, 4], [12345.678, 2e5], [0.00123456, 0.004]];
        console.log(JSON.stringify({{ places: [...new Set(places)], cuts: cuts.map(([t, s]) => moment(t, s)) }}));
        """,
        tmp_path,
    )
    assert drawn["places"] == [round(997.3 * i / 9) for i in range(10)]
    assert drawn["cuts"] == [CLOCK + 1.2346, 1.2346, 12346.0, 0.0012346]


def test_every_sample_of_a_part_of_a_long_run_is_given(
    window: Window, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A run that is thinned as a whole, a part that is not; also with a run that was cut."""
    monkeypatch.setattr("pam_cosim.workbench.curves.MOST_POINTS", 50)
    window.do(do="cut", run="run-01", begin="1 s")
    whole = window.frames[-1][1]["run-01", "p", "values"]
    assert len(whole) == 50
    answered = window.do(do="samples", run="run-01", begin=0.9, end=1.3)
    kinds = {}
    for text in answered["frames"]:
        header, arrays = read_frame(b64decode(text))
        kinds[header["kind"]] = arrays
    run = window.session.source.whole(window.session.state.data).runs[0]
    rows = slice(*np.searchsorted(run.time, (0.9, 1.3)) + [-1, 1])
    times = kinds["measured"]["run-01", "p", "time"]
    np.testing.assert_allclose(times, run.time[rows], atol=1e-6)
    np.testing.assert_allclose(
        kinds["measured"]["run-01", "p", "values"], run.measurements["p"][rows] / 1e3, rtol=1e-6
    )
    model = kinds["model"]["run-01", "p", "values"]
    assert np.isnan(model[times < 1 - 1e-6]).all() and np.isfinite(model[times > 1 - 1e-6]).all()
    for wrong in ({"run": "no"}, {"begin": "a"}, {"end": None}):
        with pytest.raises(InputError):
            window.do(**{"do": "samples", "run": "run-01", "begin": 0, "end": 1, **wrong})
