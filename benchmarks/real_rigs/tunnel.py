"""The wind tunnel of Gamella, Peters and Bühlmann (2025), read off the figures of its authors' notebook, as data sets.

    python -m benchmarks.real_rigs.tunnel FOLDER [--mirror FOLDER]

Its recordings (CC BY 4.0) lie in an object store; this takes what their paper's repository shows of them, the courses
of ``wt_test_v1/zero_load`` (figure 11) and ``wt_test_v1/steps`` (figure 7, and another of its first 100 samples with
the current), to about half a pixel: 10 rpm, 0.2 Pa, 1 mA and 0.02 s. The figures count samples. How long one takes is
read off a figure too: 0.151 s, with which the published model A2 runs through the curve that its authors drew from the
true times. Nothing that is written belongs into a repository.

Three rigs are written: ``tunnel`` as its story uses it, and for the table ``tunnel-in`` and ``tunnel-out``, with the
same fitted rows, of which the speed of one fan is scored.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.real_rigs.folders import Array, Rig, Run, write_rig
from benchmarks.real_rigs.printed_curves import Panel, picture
from benchmarks.real_rigs.sources import FetchError, Source, Store, opened

PAPER = Source(
    "juangamella",
    "causal-chamber-paper",
    "e20e785ef4ffe797e9a2028b6b9d67f8498831cf",
    "notebook: MIT; recordings: CC BY 4.0, cite Gamella, Peters and Bühlmann, Nature Machine Intelligence 2025",
)
NOTEBOOK, MODELS = "plots_appendices.ipynb", "case_studies/mechanistic_models.ipynb"
SAMPLE = 0.151  # s
HELD_OUT = 150  # sample of "steps" from which on nothing is fitted
IDLE = 45  # samples of "steps" before anything happens
COVERED = 60.0  # rpm: two lines that are nearer cover one another
LIBRARY = "wind-tunnel/WindTunnel"
RPM = np.pi / 30  # rad/s
BLUE, ORANGE, YELLOW, VIOLET, MAGENTA = "#648fff", "#fe6100", "#ffb000", "#785ef0", "#dc267f"

OFF = Panel(
    (108, 252),
    [(0, 100.5), (50, 163.5), (100, 225.5), (150, 288.5), (200, 351.5), (250, 413.5), (300, 476.5)],
    [(3000, 107.5), (2000, 154.5), (1000, 200.5), (0, 246.5)],
    300,
)
SPEEDS = Panel(
    (103, 261),
    [(0, 402.5), (100, 474.5), (200, 545.5), (300, 617.5)],
    [(3000, 105.5), (2000, 160.5), (1000, 215.5)],
    300,
)
PRESSURES = Panel(
    (103, 261),
    [(0, 108.5), (100, 180.5), (200, 251.5), (300, 323.5)],
    [(96360, 144.5), (96340, 193.5), (96320, 242.5)],
    300,
)
CURRENT = Panel((44, 95), [(0, 462), (50, 534), (100, 605)], [(0.25, 60), (0.20, 79)], 100)
HEAD = """model = "WindTunnel.Benches.TwoFans"
start = "rest"  # at the speeds that are stated

# Read off printed curves.
[signals.w_in]
sigma = "12 rpm"

[signals.w_out]
sigma = "12 rpm"

[parameters]
"intake.I" = "3.481e-5 kg.m2"
"exhaust.I" = "3.481e-5 kg.m2"
"fans.L_min" = 0.1
"intake.w_start" = "300 rpm"
"exhaust.w_start" = "300 rpm"

[fit]
"fans.tau_max" = { min = "5e-4 N.m", max = "5e-2 N.m" }
"fans.K" = { min = "5e-9 N.m.s2/rad2", max = "5e-7 N.m.s2/rad2" }
"fans.C_max" = { min = "0.2 A", max = "0.4 A" }
"""


CURRENT_HEAD = """[signals.i_in]
sigma = "6 mA"
"""


def rig(store: Store) -> Rig:
    """Fitted: ``zero_load``, and ``steps`` up to the sample 149 with the current; outside: ``steps`` from 150 on."""
    notebook = store.read(NOTEBOOK)
    off, steps = picture(notebook, 21), picture(notebook, 19)
    power = _run(
        _speeds(off, OFF, BLUE, 233),
        _loads((100, 1.0), (150, 0.01)),
        _loads((125, 0.0), (200, 0.01)),
    )
    dead = np.arange(125, 206)
    power["w_out [rpm]"][dead] = np.nan
    stepped = _run(
        _speeds(steps, SPEEDS, ORANGE, 254), _loads((50, 1.0), (250, 0.01)), _loads((150, 1.0))
    )
    stepped["hatch [1]"] = _loads((100, 1.0), (200, 0.0), idle=0.0)
    pressure = PRESSURES.course(steps, YELLOW, [ORANGE, VIOLET], 199)
    stepped["p [Pa]"] = pressure - np.nanmean(pressure[:IDLE])
    later = np.arange(300) >= HELD_OUT
    measured = ("w_in [rpm]", "w_out [rpm]", "p [Pa]")
    rest = {k: np.where(later, v, np.nan) if k in measured else v for k, v in stepped.items()}
    first = {k: v[~later] for k, v in stepped.items() if k != "p [Pa]"}
    current = CURRENT.course(picture(store.read(MODELS), 27), BLUE, [MAGENTA], 91)
    first["i_in [A]"] = np.concatenate([current, np.full(HELD_OUT - len(current), np.nan)])
    return Rig(
        name="tunnel",
        title="A wind tunnel with two fans",
        signal="w_in",
        inputs=("L_in", "L_out", "hatch"),
        head=HEAD,
        heads={"fitted": CURRENT_HEAD},
        runs={
            "fitted": [Run("zero_load", power, steps=True), Run("steps-first", first, steps=True)],
            "outside": [Run("steps", rest, SAMPLE * HELD_OUT, steps=True)],
        },
        step=SAMPLE,
        library=LIBRARY,
    )


def rigs(store: Store) -> Iterator[Rig]:
    """``tunnel``, and the rigs of the table, where every speed is scored from the held-out sample on.

    There the held-out run begins where it was begun, as in the other rigs: a method that starts from first samples
    gets those, and not the samples of a moment at which both fans turn.
    """
    whole = rig(store)
    yield whole
    first, (later,) = whole.runs["fitted"][1].columns, whole.runs["outside"]
    known = {
        name: np.concatenate([first[name], later.columns[name][HELD_OUT:]])
        for name in ("w_in [rpm]", "w_out [rpm]")
    }
    kept = {name: values for name, values in later.columns.items() if name != "p [Pa]"}
    scored = replace(later, columns=_si(kept | known))
    fitted = [replace(run, columns=_si(run.columns)) for run in whole.runs["fitted"]]
    for end in ("in", "out"):
        yield replace(
            whole,
            name=f"tunnel-{end}",
            signal=f"w_{end}",
            runs={"fitted": fitted, "outside": [scored]},
        )


def _si(columns: Mapping[str, Array]) -> dict[str, Array]:
    """The same with speeds in rad/s, as the bench has them."""
    return {
        k.replace("[rpm]", "[rad/s]"): v * RPM if "[rpm]" in k else v for k, v in columns.items()
    }


def _speeds(image: Array, panel: Panel, intake: str, first: float) -> tuple[Array, Array]:
    """Speeds [rpm] of intake and exhaust; the latter is drawn last and may cover the former."""
    above = panel.course(image, YELLOW, [intake], first)
    below = panel.course(image, intake, [YELLOW], first)
    below[np.abs(below - above) < COVERED] = np.nan
    return below, above


def _loads(*changes: tuple[int, float], idle: float = 0.01) -> Array:
    """(300,) what is set at each sample; what is set before a sample holds from the one before on."""
    values = np.full(300, idle)
    for sample, value in changes:
        values[sample - 1 :] = value
    return values


def _run(speeds: tuple[Array, Array], load_in: Array, load_out: Array) -> dict[str, Array]:
    measured: Mapping[str, Array] = dict(zip(("w_in [rpm]", "w_out [rpm]"), speeds, strict=True))
    return {
        "time [s]": SAMPLE * np.arange(300),
        "L_in [1]": load_in,
        "L_out [1]": load_out,
        "hatch [1]": np.zeros(300),
        **measured,
    }


def main() -> int:
    """Exit status 2 where something is missing or is not what was used here."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--mirror", type=Path)
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    try:
        store = opened(PAPER, asked.folder / "sources", asked.mirror)
        for one in rigs(store):
            write_rig(asked.folder, one)
    except (FetchError, ValueError) as error:
        print(f"tunnel: {error}", file=sys.stderr)
        return 2
    print(f"{PAPER.owner}/{PAPER.name}: {PAPER.terms}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
