"""The record of a search over all of the bounds, before any descent."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from pam_cosim.arrays import Array
from pam_cosim.files import Plain
from pam_cosim.fitting.objective import Objective


@dataclass(frozen=True)
class GlobalSearch(Plain):
    """A search by generation, for reports.

    Attributes:
        name: of the method, in words.
        parameters: the best point that it has been at, by name [unit].
        units: SI units, by name.
        chi2_reduced: the lowest so far: of the first points, then after each generation.
        evaluations: simulations of the set of fit runs that it took.
    """

    json_keys = (
        "name best_point=_best_point chi2_reduced=_lowest chi2_by_generation=chi2_reduced "
        "generations evaluations"
    )

    name: str
    parameters: dict[str, float]
    units: dict[str, str]
    chi2_reduced: tuple[float, ...]
    evaluations: int

    @property
    def generations(self) -> int:
        """After the first points."""
        return len(self.chi2_reduced) - 1

    @property
    def _best_point(self) -> dict[str, object]:
        return {n: {"value": v, "unit": self.units[n]} for n, v in self.parameters.items()}

    @property
    def _lowest(self) -> float:
        return self.chi2_reduced[-1]

    def __str__(self) -> str:
        first, last = (f"{c:.4g}" for c in (self.chi2_reduced[0], self.chi2_reduced[-1]))
        generations = f"{self.generations} generations, {self.evaluations} simulations"
        lines = [f"  {self.name}: chi2 {first} to {last} in {generations}; its own best point:"]
        for name, value in self.parameters.items():
            unit = "" if self.units[name] == "1" else self.units[name]
            lines.append(f"    {name} = {value:.4g} {unit}".rstrip())
        return "\n".join(lines)


def searched(
    name: str, objective: Objective, best: Array, costs: Iterable[float], before: int
) -> GlobalSearch:
    """The record of a search that ended.

    Args:
        name: of the method, in words.
        objective: that was searched.
        best: (k,) the best point, in search coordinates.
        costs: the lowest sum of squares so far: of the first points, then after each generation.
        before: evaluations of the objective when it began.
    """
    parameters = {f.name: f.to_value(float(z)) for f, z in zip(objective.free, best, strict=True)}
    chi2 = tuple(float(c) / max(objective.samples, 1.0) for c in costs)
    units = {f.name: f.unit for f in objective.free}
    return GlobalSearch(name, parameters, units, chi2, objective.evaluations - before)
