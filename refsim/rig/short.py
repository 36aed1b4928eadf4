"""Data of the independent rig, short enough for tests that run on every change.

python -m rig.short --effect elasticity:linear --seed 1 OUT_FOLDER
"""

from __future__ import annotations

import argparse
import csv
import sys
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from rig.instruments import FAULTS, Fault, fault_of, readings
from rig.measurement import TRUTH, Measurement, Noise, write_data_set
from rig.muscle import simulate_muscle
from rig.named import UNLISTED, Effect, effect_of
from rig.plan import Run
from rig.schedule import Phase

DURATION, RATE = 4.0, 50.0  # s, Hz
RAMP = 2e-3  # s, steps of a current that goes along a line
FINER, LONGER = (
    10,
    0.5,
)  # what a run with faulty instruments is simulated at, by RATE, and beyond its end [s]


def _fill(duration: float, current: float = 0.35) -> Phase:
    return Phase(duration, u_in=current)


def _vent(duration: float) -> Phase:
    return Phase(duration, u_out=0.35)


def _hold(duration: float) -> Phase:
    return Phase(duration)


PLAN = (
    Run(
        2.27,
        207e3,
        (_fill(0.5), _hold(0.4), _fill(0.9, 0.3), _hold(0.4), _vent(0.4), _hold(0.4), _vent(1.0)),
    ),
    Run(4.0, 240e3, (_fill(1.2, 0.3), _hold(0.8), _vent(0.5), _hold(0.6), _vent(0.9)), "holdout"),
)
"""One run to fit and one to judge: filling fast and slow, holding at three levels, venting in parts."""


def measure_light(
    effects: Sequence[Effect] = (),
    seed: int = 0,
    further: Sequence[Run] = (),
    faults: Sequence[Fault] = (),
) -> list[Measurement]:
    """Both runs, and those asked for further, with the rig's usual noise, through instruments with these faults."""
    rng = np.random.default_rng([seed, 7])
    sigma = Noise().as_dict()
    measured = []
    for run in (*PLAN, *further):
        duration = DURATION if run in PLAN else sum(phase.duration for phase in run.phases)
        samples = np.arange(round(duration * RATE) + 1) / RATE
        fine = (
            np.arange(round((duration + LONGER) * RATE * FINER) + 1) / (RATE * FINER)
            if faults
            else samples
        )
        simulated = simulate_muscle(
            replace(TRUTH, load=run.load), run.p_supply, run.schedule, fine, effects
        )
        clean = {"p": simulated.p, "x": simulated.x, "T": simulated.temperature}
        measured.append(
            Measurement(run, samples, readings(faults, fine, clean, samples, sigma, rng))
        )
    return measured


def write_light_data(
    folder: Path,
    effects: Sequence[Effect] = (),
    seed: int = 0,
    further: Sequence[Run] = (),
    faults: Sequence[Fault] = (),
) -> Path:
    """A data set of the Isotonic bench; a further run may have lines, which are steps between samples here."""
    measured = measure_light(effects, seed, further, faults)
    write_data_set(folder, measured, step_rows=bool(further))
    return folder


def _pieces(seconds: float, u_in: tuple[float, float], u_out: tuple[float, float]) -> list[Phase]:
    """Currents that go from one value to another in a time."""
    rests = u_in[0] == u_in[1] and u_out[0] == u_out[1]
    count = 1 if rests else max(1, round(seconds / RAMP))
    shares = [(k + 0.5) / count for k in range(count)]
    between = [tuple(float(a + share * (b - a)) for a, b in (u_in, u_out)) for share in shares]
    return [Phase(seconds / count, u_in=i, u_out=o) for i, o in between]


def planned(file: Path, load: float) -> Run:
    """The run that ``pam-cosim plan`` or ``diagnose --next`` wrote, from one supply; lines become steps of RAMP."""
    with open(file, newline="") as lines:
        rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    times, u_in, u_out = (
        np.array([float(r[c]) for r in rows]) for c in ("time [s]", "u_in [A]", "u_out [A]")
    )
    phases = [
        phase
        for k in range(len(times) - 1)
        if times[k + 1] > times[k]
        for phase in _pieces(
            float(times[k + 1] - times[k]), (u_in[k], u_in[k + 1]), (u_out[k], u_out[k + 1])
        )
    ]
    return Run(load, float(rows[0]["p_supply [kPa]"]) * 1e3, tuple(phases))


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m rig.short", description=__doc__)
    parser.add_argument("folder", type=Path, help="data set to write")
    shown = (
        f"FAMILY:FORM as in python -m rig --list; {' or '.join(UNLISTED)}, which no catalogue holds"
    )
    parser.add_argument("--effect", action="append", default=[], help=shown)
    forms = ", ".join(kind.form for kind in FAULTS)
    parser.add_argument(
        "--fault",
        action="append",
        default=[],
        help=f"FORM:signal=NAME,...: of an instrument; {forms}",
    )
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument(
        "--further", type=Path, help="a run to make as well, from 'pam-cosim diagnose --next'"
    )
    parser.add_argument("--load", type=float, default=2.27, help="of the further run [kg]")
    options = parser.parse_args(arguments)
    try:
        effects = [UNLISTED.get(text) or effect_of(text) for text in options.effect]
        faults = [fault_of(text) for text in options.fault]
    except ValueError as error:
        parser.error(str(error))
    further = [planned(options.further, options.load)] if options.further else []
    write_light_data(options.folder, effects, options.seed, further, faults)
    return 0


if __name__ == "__main__":
    sys.exit(main())
