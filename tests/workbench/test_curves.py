"""Curves for the screen: nothing that stands out is lost, and a frame is read as it was written."""

from __future__ import annotations

import asyncio

import numpy as np
import pytest

from pam_cosim.workbench.curves import MOST_POINTS, shown_times, thinned
from pam_cosim.workbench.frames import PlottedCurve, frame, is_model, read_frame


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
    message = frame("measured", 3, curves, "label", answers=7)
    header, arrays = read_frame(message)
    assert (header["kind"], header["version"], header["label"], header["answers"]) == (
        "measured",
        3,
        "label",
        7,
    )
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
