"""How much of another form of a family the catalogue can take away.

The forms (``blind_cases.table_further``) are those of a second author, who knew the rig and not the diagnosis.
Each is put on the isotonic bench of the independent rig without noise. The base model, with its base parameters fitted,
leaves so much of it; the base model with one effect of the catalogue, fitted together with the base parameters, so much
less. What is left is a share of squared error, in standard deviations of the usual noise.

python -m tests.library.family_shares [--family F] [--effect E] [--write]
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

from blind_cases.form import Form
from blind_cases.table_further import FORMS
from pam_cosim import study
from pam_cosim.fitting import Fit, FitOptions, Free, base_parameters, fit
from pam_cosim.fmu import build_model, build_source
from pam_cosim.measurement import DataSet, read_data_set
from pam_cosim.model.interface import Interface
from pam_cosim.simulation import Simulator
from rig.effect import Effect
from rig.measurement import BOUNDS, simulate_plan, write_data_set
from rig.muscle import MuscleParameters
from rig.plan import Plan, default_plan
from tests.library.catalogue import BENCH, effects, on_bench

ROOT = Path(__file__).parents[2]
RESULTS = Path(__file__).with_name("family_shares.json")
PAGE = ROOT / "benchmarks" / "families" / "README.md"
BEGIN, END = "<!-- shares: begin -->", "<!-- shares: end -->"
ENOUGH = 0.02  # share of squared error left
LEAST_SIZE = 0.1  # standard deviations; less is nothing to take away
FORMLESS = {e.name: e.family for e in effects() if e.general or e.name.startswith("Flexible")}
"""Members whose law is a function with coefficients, and their families."""
FAMILIES = tuple(dict.fromkeys(form.family for form in FORMS))


@dataclass(frozen=True)
class Share:
    """What is left of one form.

    Attributes:
        family, form: as the table has them.
        size: rms of what the base model leaves of it, in standard deviations of the noise.
        effect: of the catalogue.
        left: share of that squared error which the base model with the effect leaves.
        seconds: that the fit took.
    """

    family: str
    form: str
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


def shares(form: Form, names: Sequence[str] = ()) -> list[Share]:
    """What effects of the catalogue leave of a form: by default the general and flexible members of its family.

    Where more than ``ENOUGH`` is left, the fit is tried again from more starts.
    """
    seed = np.random.default_rng(FORMS.index(form))
    data = data_of(form.make(seed, MuscleParameters())(1.0), fit_runs())
    base = fitted_base(data).residuals["fit"]
    size = float(np.sqrt(base.chi2 / base.samples))
    made = []
    for name in names or [n for n, family in FORMLESS.items() if family == form.family]:
        begin = time.perf_counter()
        left = fitted_with(name, data).residuals["fit"].chi2 / base.chi2
        if left > ENOUGH:
            left = min(left, fitted_with(name, data, THOROUGH).residuals["fit"].chi2 / base.chi2)
        seconds = time.perf_counter() - begin
        made.append(Share(form.family, form.name, size, name, left, seconds))
    return made


def table(every: Sequence[Share]) -> str:
    """Markdown: what the general and flexible members of the family leave of each form, the best of each."""
    lines = [
        "| family | form | size | general member leaves | flexible member leaves |",
        "|---|---|---|---|---|",
    ]
    for form in FORMS:
        own = [s for s in every if (s.family, s.form) == (form.family, form.name)]
        flexible = [s.left for s in own if s.effect.startswith("Flexible")]
        general = [s.left for s in own if not s.effect.startswith("Flexible")]
        shown = [
            _percent(min(left)) if left and own[0].size > LEAST_SIZE else ""
            for left in (general, flexible)
        ]
        lines.append(f"| `{form.family}` | {form.name} | {own[0].size:.1f} | {' | '.join(shown)} |")
    return "\n".join(lines)


def _percent(share: float) -> str:
    return f"{100 * share:.2g} %" if share >= 1e-5 else "below 0.001 %"


def read_results() -> list[Share]:
    """What was measured last."""
    return [Share(**one) for one in json.loads(RESULTS.read_text())] if RESULTS.exists() else []


def write_results(new: Sequence[Share]) -> None:
    """Puts shares in the place of those of the same forms and effects, and the table on its page."""
    key = {(s.family, s.form, s.effect): s for s in [*read_results(), *new]}
    order = sorted(key.values(), key=lambda s: (FAMILIES.index(s.family), s.form, s.effect))
    RESULTS.write_text("[\n" + ",\n".join(json.dumps(asdict(s)) for s in order) + "\n]\n")
    if PAGE.exists():
        head, _, rest = PAGE.read_text().partition(BEGIN)
        PAGE.write_text(f"{head}{BEGIN}\n{table(order)}\n{END}{rest.partition(END)[2]}")


def main() -> None:
    """Command line."""
    parser = argparse.ArgumentParser(prog="python -m tests.library.family_shares")
    parser.add_argument("--family", action="append", choices=FAMILIES)
    parser.add_argument("--effect", action="append", default=[], help="of the catalogue")
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    for form in FORMS:
        if form.family in (options.family or FAMILIES):
            made = shares(form, options.effect)
            for s in made:
                print(
                    f"{s.family:17} {s.form:20} size {s.size:6.2f}  {s.effect:22} "
                    f"left {100 * s.left:8.3f} %  {s.seconds:5.1f} s",
                    flush=True,
                )
            if options.write:
                write_results(made)


if __name__ == "__main__":
    main()
