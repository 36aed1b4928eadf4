"""Currents of a closed loop: a controller reads an instrument with noise and sets the valves.

What comes out is what was applied; the run is then simulated and recorded with these currents as with any others.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from scipy.integrate import solve_ivp

from rig.effect import Effect
from rig.held import OPEN_CURRENT, HeldChain
from rig.integrate import within_the_numbers
from rig.muscle import ATOL, Chain, MuscleParameters
from rig.schedule import Course, Currents, SampledSchedule, Schedule

_RTOL = 1e-5  # of the integration: what is applied counts, not how the loop came to it
_SHUT = 0.145  # A, at which a valve begins to open


@dataclass(frozen=True)
class Loop:
    """A digital controller.

    Attributes:
        signal: x [m] or p [Pa gauge], which it reads. wanted: reference at the instants k step, SI.
        step: between two readings [s]. noise: standard deviation of its own instrument, SI. seed: of that noise.
        gain: A/SI, integral: A/(SI s), limit: A above the opening current. switching: on-off valves with this
            hysteresis [SI] in the place of the gains; None for proportional ones.
    """

    signal: str
    wanted: tuple[float, ...]
    step: float
    noise: float
    seed: int
    gain: float = 0.0
    integral: float = 0.0
    limit: float = 0.25
    switching: float | None = None


def _proportional(loop: Loop) -> Callable[[float], Currents]:
    total = 0.0

    def answer(error: float) -> Currents:
        nonlocal total
        total = float(np.clip(total + loop.integral * loop.step * error, -loop.limit, loop.limit))
        u = float(np.clip(loop.gain * error + total, -loop.limit, loop.limit))
        opened = round(_SHUT + abs(u), 5) if abs(u) > 2e-3 else 0.0
        return (opened, 0.0) if u > 0 else (0.0, opened)

    return answer


def _on_off(hysteresis: float) -> Callable[[float], Currents]:
    def answer(error: float) -> Currents:
        return (float(error > hysteresis), float(error < -hysteresis))

    return answer


def _run(
    chain: Chain,
    loop: Loop,
    answer: Callable[[float], Currents],
    joined: bool,
    further: Course | None,
    delay: float,
) -> list[Currents]:
    """What the controller tells the valves at its instants; one step passes between a reading and the answer."""
    rng = np.random.default_rng([loop.seed, 5])
    atol = (*ATOL, *(value for effect in chain.effects for value in effect.atol))
    y, told = np.array(chain.start()), [(0.0, 0.0)]
    scale = 1.0 if joined else OPEN_CURRENT

    def command(t: float) -> Sequence[float]:
        place = max(t - delay, 0.0) / loop.step
        k = min(int(place + 1e-9), len(told) - 1)
        u = told[k]
        if joined and k + 1 < len(told):
            share = place - k
            u = (u[0] + share * (told[k + 1][0] - u[0]), u[1] + share * (told[k + 1][1] - u[1]))
        currents = (scale * u[0], scale * u[1])
        return currents if further is None else (*currents, *further.at(t))

    def rates(t: float, y: Any) -> list[float]:
        return chain.rates(y.tolist(), command(t))

    for k in range(len(loop.wanted) - 1):
        place = 0 if loop.signal == "p" else 1
        read = chain.reading(y.tolist())[place] + loop.noise * rng.standard_normal()
        told.append(answer(loop.wanted[k] - read))
        piece = (k * loop.step, (k + 1) * loop.step)
        with within_the_numbers(*piece):
            solution = solve_ivp(rates, piece, y, method="BDF", rtol=_RTOL, atol=atol)
        if not solution.success:
            raise RuntimeError(f"the closed loop stopped at {piece[0]} s: {solution.message}")
        y = solution.y[:, -1]
    return told


def closed_loop(
    loop: Loop,
    muscle: MuscleParameters,
    p_supply: float,
    held: tuple[Course, float] | None,
    effects: Sequence[Effect],
) -> Schedule:
    """What the valves were told by a controller of one muscle.

    held: imposed contraction and the lag of its drive [s]; None where the muscle lifts its load. A schedule joined by
    lines for proportional valves, a held one for on-off valves. Raises RuntimeError when integration fails.
    """
    chain = (
        Chain(muscle, p_supply, effects)
        if held is None
        else HeldChain(muscle, p_supply, effects, held[1])
    )
    delay = sum(effect.delay() for effect in effects)
    joined = loop.switching is None
    answer = _proportional(loop) if loop.switching is None else _on_off(loop.switching)
    told = _run(chain, loop, answer, joined, held[0] if held else None, delay)
    if joined:
        return SampledSchedule.joined(told, loop.step)
    switches = [0, *(k for k in range(1, len(told)) if told[k] != told[k - 1])]
    return Schedule(
        tuple(round(k * loop.step, 9) for k in switches), tuple(told[k] for k in switches)
    )
