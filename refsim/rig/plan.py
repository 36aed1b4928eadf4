"""Test plans for the muscle rig: what is done to the valves, at which supply pressure and load."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from rig.schedule import Phase, Schedule

DURATION = 10.0  # s
RATE = 100.0  # Hz


@dataclass(frozen=True)
class Run:
    """One test of DURATION; the last phase is held to the end."""

    load: float  # kg
    p_supply: float  # Pa gauge
    phases: tuple[Phase, ...]
    role: str = "fit"

    @property
    def schedule(self) -> Schedule:
        """The valve currents."""
        return Schedule.of(self.phases)


Plan = tuple[Run, ...]


def _fill(duration: float, current: float = 0.35) -> Phase:
    return Phase(duration, u_in=current)


def _vent(duration: float, current: float = 0.35) -> Phase:
    return Phase(duration, u_out=current)


def _hold(duration: float) -> Phase:
    return Phase(duration)


def default_plan() -> Plan:
    """Six runs, four to fit and two to judge: steps, staircases, slow filling, partial venting."""
    stairs_up = tuple(phase for _ in range(5) for phase in (_fill(0.25), _hold(0.65)))
    stairs_down = tuple(phase for _ in range(5) for phase in (_vent(0.25), _hold(0.65)))
    return (
        Run(2.27, 207e3, (_fill(3.5), _hold(1.5), _vent(5.0))),
        Run(3.0, 100e3, (*stairs_up, _fill(0.5), *stairs_down, _vent(0.5))),
        Run(1.0, 250e3, (_fill(1.2), _hold(1.0), _vent(0.5), _hold(1.3), _fill(0.8), _hold(1.2), _vent(4.0))),
        Run(8.0, 300e3, (_fill(3.0, 0.22), _hold(1.5), _vent(1.5, 0.22), _hold(1.0), _vent(3.0))),
        Run(5.0, 180e3, (_fill(0.6), _hold(1.4), _fill(2.0, 0.25), _hold(2.0),
                         _vent(0.6), _hold(1.4), _vent(2.0)), "holdout"),
        Run(6.5, 280e3, (_fill(1.5, 0.28), _vent(0.6), _fill(1.0, 0.3), _hold(2.0),
                         _vent(1.2, 0.25), _hold(1.2), _vent(2.5)), "holdout"),
    )  # fmt: skip


def random_plan(seed: int, fits: int = 4, holdouts: int = 2) -> Plan:
    """Runs of random supply (100..300 kPa), load (1..8 kg) and phases that fill, hold and vent in parts."""
    rng = np.random.default_rng([seed, 1])
    runs = []
    for k in range(fits + holdouts):
        p_supply = float(rng.integers(100, 301)) * 1e3
        # a load that the muscle lifts well: it pulls about 2 N/kPa at rest
        heaviest = min(8.0, 0.4 * 1.9e-3 * p_supply / 9.81)
        load = round(float(rng.uniform(1.0, heaviest)), 2)
        phases: list[Phase] = []
        left = DURATION
        while left > 1e-9:
            current = round(float(rng.uniform(0.22, 0.38)), 3)
            kind = len(phases) % 4  # fill, hold, vent or fill, hold
            if kind in (1, 3):
                phase = _hold(round(float(rng.uniform(0.5, 2.0)), 2))
            elif kind == 2 and rng.random() < 0.7:
                phase = _vent(round(float(rng.uniform(0.3, 2.0)), 2), current)
            else:
                phase = _fill(round(float(rng.uniform(0.4, 2.5)), 2), current)
            phase = Phase(min(phase.duration, round(left, 2)), phase.u_in, phase.u_out)
            phases.append(phase)
            left = round(left - phase.duration, 2)
        runs.append(Run(load, p_supply, tuple(phases), "fit" if k < fits else "holdout"))
    return tuple(runs)
