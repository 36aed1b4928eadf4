"""Six parameters of the isotonic bench fitted to four runs, by pam-cosim and by estim8 from the package index.

    pip install estim8==0.1.6
    python -m benchmarks.fit_speed [--limit SECONDS] [--json FILE]

Both get the same FMU, the same data, noise levels and bounds, and begin at the same point; the data come from the
independent rig, with noise. The least-squares cost is the same. What is done once is not in the times: building and
unpacking the FMU, reading the data. estim8 gets what helps it: every method of its own that serves, FMPy's engine as
model exchange (CVode) and as co-simulation, a tolerance as tight as pam-cosim's, and an FMU without sensitivities,
which would only cost it time. A method that takes longer than the limit is ended, and what it had come to is told.

estim8's FmuModel passes no inputs over time to FMPy and does not tell a model which replicate it simulates. The
subclass below adds both, in the way estim8 foresees (a model of one's own), and changes nothing else.
"""

from __future__ import annotations

import argparse
import json
import logging
import tempfile
import warnings
from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

import pam_cosim as pam
from pam_cosim.measurement import DataSet
from rig import data_set
from rig.measurement import Noise, simulate_plan
from rig.muscle import MuscleParameters
from rig.plan import default_plan

FREE = {  # of the bench: truth in the rig, bounds
    "valve.C_A": ("calibration", 0.74, ("0.5", "0.9")),
    "muscle.n_g": ("n_g", 1.27, ("1.0", "1.4")),
    "muscle.mu_fb": ("mu_fb", 0.021, ("0.002", "0.06")),
    "muscle.h_film": ("h_film", 31.0, ('"2 W/(m2.K)"', '"100 W/(m2.K)"')),
    "muscle.mu_d": ("mu_d", 0.95, ("0.1", "2.0")),
    "muscle.D0": ("diameter", 0.0204, ('"19 mm"', '"21 mm"')),
}
SAME = 1.01  # a chi-square within one per cent is the same optimum: parameters then agree within their intervals


@dataclass(frozen=True)
class Outcome:
    """What one contender came to.

    Attributes:
        name: who, and how.
        seconds: by the clock; one process works at a time.
        evaluations: simulations of the four runs.
        chi2_reduced: reached.
        parameters: reached [SI].
        finished: it ended by itself.
        note: what else there is to say.
    """

    name: str
    seconds: float
    evaluations: int
    chi2_reduced: float
    parameters: dict[str, float]
    finished: bool = True
    note: str = ""


def write_data(folder: Path) -> Path:
    """The rig's default plan, measured with noise; bounds in [fit], the model's defaults as starts."""
    muscle = MuscleParameters(**{field: true for field, true, _ in FREE.values()})
    noise, rng = Noise().as_dict(), np.random.default_rng([6, 0])
    runs = []
    for m in simulate_plan(default_plan(), (), muscle):
        noisy = {n: y + noise[n] * rng.standard_normal(len(y)) for n, y in m.signals.items()}
        runs.append(
            data_set.Recording(
                m.run.schedule, m.run.p_supply, m.run.role, m.time, noisy, m.run.load
            )
        )
    free = {name: bounds for name, (_, _, bounds) in FREE.items()}
    about = data_set.Description("isotonic, six free", noise, ("p", "x", "T"), {}, free)
    data_set.write(folder, runs, about)
    return folder


def ours(name: str, data: DataSet, fmu: Path) -> Outcome:
    """pam-cosim's fit."""
    clock = perf_counter()
    fit = pam.fit(data, str(fmu))
    return Outcome(
        name, perf_counter() - clock, fit.evaluations, fit.residuals["fit"].chi2_reduced, fit.values
    )


class _TimeUp(Exception):
    pass


def theirs(
    name: str,
    data: DataSet,
    fmu: Path,
    start: Mapping[str, float],
    optimum: Mapping[str, float],
    limit: float,
    **how: Any,
) -> Outcome:
    """estim8's fit by one of its methods; its cost at pam-cosim's ``optimum`` tells that both minimise the same."""
    import estim8
    import fmpy
    import pandas as pd
    from estim8.models import FmuModel
    from estim8.utils import ModelHelpers

    kind, method, options = how["kind"], how["method"], how.get("options", {})

    class DrivenModel(FmuModel):  # type: ignore[misc]
        """With inputs over time, chosen by the parameter ``run``."""

        tables: list[np.ndarray]

        def simulate(
            self,
            t0: float,
            t_end: float,
            stepsize: float,
            parameters: Any = None,
            observe: Any = None,
            replicate_ID: Any = None,
            r_tol: Any = None,
            solver: str = "CVode",
        ) -> Any:
            self._fmu.reset()
            values = {**self.parameters, **(parameters or {})}
            table = self.tables[int(values.pop("run"))]
            raw = fmpy.simulate_fmu(
                filename=self._unzip_dir, start_time=t0, stop_time=t_end, output_interval=stepsize,
                relative_tolerance=r_tol or self.r_tol, output=observe, start_values=values, fmi_type=self._fmi_type,
                validate=False, solver=solver, model_description=self._model_description, fmu_instance=self._fmu,
                terminate=False, input=table,
            )  # fmt: skip
            return estim8.datatypes.Simulation(
                {"time": raw["time"], **{n: raw[n] for n in observe}}
            )

    model = DrivenModel(str(fmu), fmi_type=kind, r_tol=1e-6)
    model.parameters["run"] = 0.0
    model.parameters |= {n: v for n, v in data.parameters.items() if n in model.parameters}
    model.tables = [_input_table(run) for run in data.fit_runs]
    names = [run.name for run in data.fit_runs]
    experiments, mapping = {}, []
    for k, run in enumerate(data.fit_runs):
        values = pd.DataFrame({n: run.measurements[n] for n in data.signals}, index=run.time)
        errors = pd.DataFrame(
            {n: np.full(len(run.time), s.sigma) for n, s in data.signals.items()}, index=run.time
        )
        experiments[run.name] = estim8.datatypes.Experiment(
            values, replicate_ID=run.name, errors=errors
        )
        for parameter, value in {"run": float(k), "load.m": run.parameters["load.m"]}.items():
            mapping.append(ModelHelpers.ParameterMapper(parameter, names[k], value=value))
    bounds = {n: [f.min, f.max] for n, f in data.fit.items()}
    time = data.fit_runs[0].time
    step = float(np.median(np.diff(time)))
    estimator = estim8.Estimator(
        model,
        bounds,
        experiments,
        t=[0.0, float(time[-1]), step],
        metric="WSS",
        parameter_mapping=mapping,
    )
    samples = sum(run.sample_count(n) for run in data.fit_runs for n in data.signals)
    plain, seen, best = estimator.objective, [0], [np.inf, dict(start)]
    there = plain(np.array([optimum[n] for n in bounds])) / samples
    clock = perf_counter()

    def watched(theta: np.ndarray) -> float:
        cost = plain(theta)
        seen[0] += 1
        if cost < best[0]:
            best[:] = [cost, dict(zip(bounds, map(float, theta), strict=True))]
        if perf_counter() - clock > limit:
            raise _TimeUp
        return cost

    estimator.objective = watched
    finished, note = True, ""
    if method == "local":
        options = {"x0": np.array([start[n] for n in bounds]), **options}
    try:
        estimator.estimate(
            method=method, max_iter=how.get("max_iter", 1000), optimizer_kwargs=options
        )
    except _TimeUp:
        finished, note = False, f"ended after {limit:g} s"
    except Exception as problem:  # what does not work is told with its reason
        finished, note = False, f"{type(problem).__name__}: {problem}"[:200]
    spent = perf_counter() - clock
    note = ", ".join(filter(None, (note, f"its chi2 at pam-cosim's optimum {there:.5g}")))
    return Outcome(name, spent, seen[0], best[0] / samples, best[1], finished, note)


def _input_table(run: Any) -> np.ndarray:
    """FMPy's input: rows of time and inputs; where the inputs are held, a step is two rows at one time."""
    time, columns = run.time, list(run.inputs.values())
    rows = [(t, *(c[i] for c in columns)) for i, t in enumerate(time)]
    if run.interpolation == "previous":
        steps = [rows[0]]
        for before, row in zip(rows[:-1], rows[1:], strict=True):
            if row[1:] != before[1:]:
                steps.append((row[0], *before[1:]))
            steps.append(row)
        rows = steps
    return np.array(rows, dtype=[("time", float), *((n, float) for n in run.inputs)])


THEIRS: dict[str, dict[str, Any]] = {
    "estim8 local (L-BFGS-B), model exchange": {"kind": "ModelExchange", "method": "local"},
    "estim8 local (L-BFGS-B), co-simulation": {"kind": "CoSimulation", "method": "local"},
    "estim8 local (Powell), co-simulation": {
        "kind": "CoSimulation",
        "method": "local",
        "options": {"method": "Powell"},
    },
    "estim8 local (Nelder-Mead), co-simulation": {
        "kind": "CoSimulation",
        "method": "local",
        "options": {"method": "Nelder-Mead"},
    },
    "estim8 de, co-simulation": {"kind": "CoSimulation", "method": "de", "options": {"seed": 0}},
}


def table(outcomes: list[Outcome], best: float) -> str:
    """One line each."""
    first = next(o for o in outcomes if o.name.startswith("pam-cosim"))
    lines = [f"{'':42} {'time':>9} {'runs of 4':>9} {'chi2':>10}  same optimum"]
    for o in outcomes:
        same = "yes" if o.chi2_reduced <= SAME * best else "no"
        ratio = (
            f", {o.seconds / first.seconds:.0f} times pam-cosim's time" if o is not first else ""
        )
        note = f" ({o.note})" if o.note else ""
        lines.append(
            f"{o.name:42} {o.seconds:7.2f} s {o.evaluations:9} {o.chi2_reduced:10.5g}  {same}{ratio}{note}"
        )
    return "\n".join(lines)


def main() -> None:
    """Runs all contenders."""
    words = argparse.ArgumentParser(
        prog="python -m benchmarks.fit_speed", description=__doc__.split("\n")[0]
    )
    words.add_argument("--limit", type=float, default=300.0, help="time [s] for each contender")
    words.add_argument("--json", type=Path, help="write the figures")
    words.add_argument("--only", default="", help="contenders whose name has this")
    asked = words.parse_args()
    warnings.simplefilter("ignore")
    logging.disable(logging.WARNING)
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        data = pam.read(write_data(folder / "data"))
        plain = pam.build("Isotonic", folder / "plain" / "Isotonic.fmu")
        slopes = pam.build("Isotonic", folder / "slopes" / "Isotonic.fmu", sensitivities=list(FREE))
        interface = pam.describe("Isotonic")
        start = {n: float(interface.parameters[n].start or 0.0) for n in data.fit}
        contenders: dict[str, Callable[[], Outcome]] = {
            "pam-cosim, the same FMU": lambda: ours("pam-cosim, the same FMU", data, plain),
            "pam-cosim, FMU with sensitivities": lambda: ours(
                "pam-cosim, FMU with sensitivities", data, slopes
            ),
        }
        for name, how in THEIRS.items():
            contenders[name] = lambda name=name, how=how: theirs(  # type: ignore[misc]
                name, data, plain, start, outcomes[0].parameters, asked.limit, **how
            )
        outcomes: list[Outcome] = []
        for name, run in contenders.items():
            if asked.only in name or name.startswith("pam-cosim"):
                outcomes.append(run())
                print(
                    outcomes[-1].name,
                    f"{outcomes[-1].seconds:.2f} s",
                    f"{outcomes[-1].chi2_reduced:.6g}",
                    flush=True,
                )
    print(table(outcomes, min(o.chi2_reduced for o in outcomes)))
    if asked.json:
        asked.json.write_text(
            json.dumps([asdict(o) for o in outcomes], indent=1) + "\n", encoding="utf-8"
        )


if __name__ == "__main__":
    main()
