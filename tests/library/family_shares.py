"""How much of a random member of a family the catalogue can take away.

Members are drawn by the independent rig from the places where the family's cause can act (``rig.family_members``), not
from the catalogue. Each is put on the isotonic bench without noise. The base model, with its base parameters fitted,
leaves so much of it; the base model with one effect of the catalogue, fitted together with the base parameters, so much
less. What is left is a share of squared error, in standard deviations of the usual noise.

python -m tests.library.family_shares [--family F] [--members N] [--effect E] [--write]
"""

from __future__ import annotations

import argparse
import json
import time
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from pam_cosim import study
from pam_cosim.fitting import Fit, FitOptions, Free, base_parameters, fit
from pam_cosim.fmu import build_model, build_source
from pam_cosim.measurement import DataSet, read_data_set
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Simulator
from rig.effect import Effect
from rig.family_members import FAMILIES, PLACES, draw
from rig.measurement import BOUNDS, simulate_plan, write_data_set
from rig.plan import Plan, default_plan
from tests.library.shelf import BENCH, effects, on_bench

ROOT = Path(__file__).parents[2]
RESULTS = Path(__file__).with_name("family_shares.json")
PAGE = ROOT / "benchmarks" / "families" / "README.md"
BEGIN, END = "<!-- shares: begin -->", "<!-- shares: end -->"
ENOUGH = 0.02  # share of squared error left
LEAST_SIZE = 0.1  # standard deviations; less is nothing to take away


@dataclass(frozen=True)
class Share:
    """What is left of one random member.

    Attributes:
        family, place: of the member; ``number``: by which it is drawn.
        size: rms of what the base model leaves of it, in standard deviations of the noise.
        effect: of the catalogue.
        left: share of that squared error which the base model with the effect leaves.
        seconds: that the fit took.
    """

    family: str
    place: str
    number: int
    size: float
    effect: str
    left: float
    seconds: float


def fit_runs() -> Plan:
    """The runs of the usual plan that are for fits."""
    return tuple(run for run in default_plan() if run.role == "fit")


def data_of(member: Effect, plan: Plan) -> DataSet:
    """What ideal instruments read of the rig with the effect."""
    with TemporaryDirectory() as folder:
        write_data_set(Path(folder), simulate_plan(plan, [member]))
        return read_data_set(Path(folder), study.describe)


@cache
def base_model() -> Path:
    """The base model with sensitivities to the base parameters."""
    return build_model(BENCH, sensitivities=tuple(BOUNDS), brief=True)


@cache
def model_with(effect: str) -> Path:
    """The base model with an effect."""
    composition = on_bench(effect, BENCH)
    free = (*BOUNDS, *composition.parameters[effect])
    return build_source(composition.name, composition.text, sensitivities=free, brief=True)


def fitted_base(data: DataSet) -> Fit:
    """The base model with its base parameters fitted."""
    with Simulator(base_model()) as simulator:
        return fit(simulator, data)


QUICK = FitOptions(screened_starts=3, evaluations=40, precision=1e-3)
THOROUGH = FitOptions(screened_starts=8, descents=3, precision=1e-3)


def fitted_with(effect: str, data: DataSet, options: FitOptions = QUICK) -> Fit:
    """The base model with an effect, all parameters fitted, from several starts."""
    with Simulator(model_with(effect)) as simulator:
        own = [
            _free(simulator.interface, name) for name in on_bench(effect, BENCH).parameters[effect]
        ]
        free = (*base_parameters(data, simulator.interface), *own)
        starts = [start for one in own for start in _off(one)]
        return fit(simulator, data, free, starts=starts, options=options)


def _free(interface: Interface, name: str) -> Free:
    v = interface.parameters[name]
    assert v.min is not None and v.max is not None and v.start is not None
    return Free(name, v.min, v.max, v.start, v.unit, v.nominal)


def _off(one: Free) -> list[dict[str, float]]:
    """The parameter ten times larger and smaller, or a quarter of its range off."""
    if one.logarithmic:
        values = [one.start * factor for factor in (0.1, 10.0)]
    else:
        values = [one.start + part * (one.high - one.low) for part in (-0.25, 0.25)]
    return [
        {one.name: min(max(v, one.low), one.high)}
        for v in values
        if one.low < v < one.high or one.logarithmic
    ]


def shares(
    family: str, number: int, names: Sequence[str] = (), plan: Plan = (), thorough: bool = False
) -> list[Share]:
    """What effects of the catalogue leave of a random member: by default the general member of its family.

    ``thorough``: where more than ``ENOUGH`` is left, the fit is tried again from more starts.
    """
    place, member = draw(family, number)
    data = data_of(member, plan or fit_runs())
    base = fitted_base(data).residuals["fit"]
    size = float(np.sqrt(base.chi2 / base.samples))
    chosen = names or [e.name for e in effects() if e.family == family and e.general]
    told = []
    for name in chosen:
        begin = time.perf_counter()
        left = fitted_with(name, data).residuals["fit"].chi2 / base.chi2
        if left > ENOUGH and thorough:
            left = min(left, fitted_with(name, data, THOROUGH).residuals["fit"].chi2 / base.chi2)
        told.append(Share(family, place, number, size, name, left, time.perf_counter() - begin))
    return told


def listed(family: str) -> list[str]:
    """The members of a family that are no general ones."""
    return [e.name for e in effects() if e.family == family and not e.general]


def table(every: Sequence[Share]) -> str:
    """Markdown: by family and place, what the general member leaves, and another member where that was tried."""
    lines = [
        "| family | place | members | size | general member leaves | at worst | another member leaves |",
        "|---|---|---|---|---|---|---|",
    ]
    for family in FAMILIES:
        own = [s for s in every if s.family == family and s.size >= LEAST_SIZE]
        if own:
            lines.append(_row(f"`{family}`", "all", own, others=False))
            lines += [
                _row("", place, [s for s in own if s.place == place]) for place in PLACES[family]
            ]
    return "\n".join(line for line in lines if line)


def _row(family: str, place: str, own: Sequence[Share], others: bool = True) -> str:
    general = {e.name for e in effects() if e.general}
    whole = [s for s in own if s.effect in general]
    if not whole:
        return ""
    left = [s.left for s in whole]
    size = float(np.median([s.size for s in whole]))
    rest = sorted((s.left, s.effect) for s in own if s.effect not in general) if others else []
    other = f"{rest[0][1]} {_percent(rest[0][0])}" if rest else ""
    median = float(np.median(left))
    cells = [
        family,
        place,
        str(len(whole)),
        f"{size:.1f}",
        _percent(median),
        _percent(max(left)),
        other,
    ]
    return f"| {' | '.join(cells)} |"


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %" if share >= 1e-5 else "below 0.001 %"


def read_results() -> list[Share]:
    """What was measured last."""
    return [Share(**one) for one in json.loads(RESULTS.read_text())] if RESULTS.exists() else []


def write_results(new: Sequence[Share]) -> None:
    """Puts shares in the place of those of the same members and effects, and the table on its page."""
    key = {(s.family, s.number, s.effect): s for s in [*read_results(), *new]}
    order = sorted(key.values(), key=lambda s: (FAMILIES.index(s.family), s.number, s.effect))
    RESULTS.write_text("[\n" + ",\n".join(json.dumps(asdict(s)) for s in order) + "\n]\n")
    if PAGE.exists():
        head, _, rest = PAGE.read_text().partition(BEGIN)
        PAGE.write_text(f"{head}{BEGIN}\n{table(order)}\n{END}{rest.partition(END)[2]}")


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog="python -m tests.library.family_shares")
    parser.add_argument("--family", action="append", choices=FAMILIES)
    parser.add_argument(
        "--members", type=int, default=0, help="numbers up to this; default: one for each place"
    )
    parser.add_argument("--number", type=int, action="append", help="this member alone")
    parser.add_argument(
        "--effect",
        action="append",
        default=[],
        help="of the catalogue; 'listed': all but the general",
    )
    parser.add_argument(
        "--thorough", action="store_true", help="try again from more starts where much is left"
    )
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    for family in options.family or FAMILIES:
        names = listed(family) if options.effect == ["listed"] else options.effect
        for number in options.number or range(options.members or len(PLACES[family])):
            told = shares(family, number, names, thorough=options.thorough)
            for s in told:
                print(
                    f"{s.family:17} {s.place:34} {s.number:3} size {s.size:6.2f}  {s.effect:22}",
                    end=" ",
                )
                print(f"left {100 * s.left:8.3f} %  {s.seconds:5.1f} s", flush=True)
            if options.write:
                write_results(told)


if __name__ == "__main__":
    main()
