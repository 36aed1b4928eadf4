"""Valves that follow their command late."""

from __future__ import annotations

from typing import ClassVar

from rig.effect import Effect, Now, Rest, State, law
from rig.schedule import Currents


@law
class ValveLag(Effect):
    """Both currents act through a first-order lag."""

    form = "lag"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-9)
    tau: float = 0.08  # s

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        return (now.command[0] - q[0]) / self.tau, (now.command[1] - q[1]) / self.tau

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[1]


@law
class ValveDeadTime(Effect):
    """Both currents act after a dead time."""

    form = "dead_time"
    dead_time: float = 0.05  # s

    def delay(self) -> float:
        return self.dead_time


@law
class ValveSecondOrder(Effect):
    """Both currents act through a damped oscillator: u'' = omega^2 (command - u) - 2 zeta omega u'."""

    form = "second_order"
    atol: ClassVar[tuple[float, ...]] = (1e-9, 1e-7, 1e-9, 1e-7)
    omega: float = 25.0  # rad/s
    zeta: float = 0.7

    def initial(self, rest: Rest) -> tuple[float, ...]:
        return (0.0, 0.0, 0.0, 0.0)

    def rates(self, q: State, now: Now) -> tuple[float, ...]:
        square, damping = self.omega**2, 2 * self.zeta * self.omega
        return (
            q[1], square * (now.command[0] - q[0]) - damping * q[1],
            q[3], square * (now.command[1] - q[2]) - damping * q[3],
        )  # fmt: skip

    def current(self, q: State, command: Currents) -> Currents:
        return q[0], q[2]
