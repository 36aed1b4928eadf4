"""Inputs as a table has them: lines between its rows, a step where two rows have one time."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

from rig.schedule import Currents, Schedule


@dataclass(frozen=True)
class PlayedSchedule(Schedule):
    """Currents along a table.

    Attributes:
        times: of the rows [s], not decreasing. rows: currents (u_in, u_out) [A]; the first and the last hold outside.
        late: by how much the valves lag behind the table [s].
    """

    times: tuple[float, ...] = ()
    rows: tuple[Currents, ...] = ()
    late: float = 0.0

    @staticmethod
    def of_table(times: Sequence[float], rows: Sequence[Currents]) -> PlayedSchedule:
        """A table; an integrator stops at each of its times."""
        stops = tuple(sorted({float(t) for t in times[1:-1]}))
        return PlayedSchedule(
            stops, (), tuple(float(t) for t in times), tuple((float(a), float(b)) for a, b in rows)
        )

    def at(self, t: float) -> Currents:
        """Currents [A] at time t [s]; a step belongs to the line that begins there."""
        return self._on(bisect_right(self.times, t - self.late + 1e-9) - 1, t)

    def within(self, left: float) -> Callable[[float], Currents]:
        """Currents [A] as a function of time, on the line that begins at `left` [s]."""
        k = bisect_right(self.times, left - self.late + 1e-9) - 1
        return lambda t: self._on(k, t)

    def _on(self, k: int, t: float) -> Currents:
        """Currents on the line that begins with a row."""
        if k < 0:
            return self.rows[0]
        if k >= len(self.times) - 1:
            return self.rows[-1]
        begin, end = self.times[k], self.times[k + 1]
        share = min(max((t - self.late - begin) / (end - begin), 0.0), 1.0) if end > begin else 1.0
        (a, b), (c, d) = self.rows[k], self.rows[k + 1]
        return a + share * (c - a), b + share * (d - b)

    def delayed(self, dead_time: float) -> PlayedSchedule:
        """The same currents, `dead_time` [s] later."""
        starts = tuple(t + dead_time for t in self.starts)
        return replace(self, starts=starts, late=self.late + dead_time)
