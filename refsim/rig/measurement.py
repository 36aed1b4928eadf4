"""The muscle rig: runs test plans with hidden effects, adds sensor noise, writes data sets.

python -m rig --effect elasticity:linear --seed 1 OUT_FOLDER
python -m rig --list
"""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
from scipy.optimize import least_squares

from rig import data_set
from rig.data_set import Description, Recording
from rig.integrate import Array
from rig.muscle import MuscleParameters, Trajectory, simulate_muscle
from rig.named import EFFECTS, Effect, effect_name, effect_of, effect_parameters
from rig.plan import DURATION, RATE, Plan, Run, default_plan, random_plan

TRUTH = MuscleParameters(calibration=0.72, mu_fb=0.018)
"""The muscle on the rig; its free parameters are off the model's defaults."""

BOUNDS = {"valve.C_A": (0.5, 0.9), "muscle.mu_fb": (0.005, 0.05)}
SIZES = Path(__file__).with_name("effect_sizes.json")


@dataclass(frozen=True)
class Noise:
    """Standard deviations of the sensors."""

    p: float = 500.0  # Pa
    x: float = 0.2e-3  # m
    T: float = 0.3  # K

    def as_dict(self) -> dict[str, float]:
        """By signal, SI units."""
        return {"p": self.p, "x": self.x, "T": self.T}


@dataclass(frozen=True)
class Measurement:
    """One run as measured; signals by name (p [Pa gauge], x [m], T [K]), arrays of shape (times,)."""

    run: Run
    time: Array
    signals: dict[str, Array]


def sample_times() -> Array:
    """The instants [s] of the samples."""
    return np.arange(round(DURATION * RATE) + 1) / RATE


def _signals(trajectory: Trajectory) -> dict[str, Array]:
    return {"p": trajectory.p, "x": trajectory.x, "T": trajectory.temperature}


def simulate_plan(
    plan: Plan, effects: Sequence[Effect] = (), parameters: MuscleParameters = TRUTH
) -> list[Measurement]:
    """All runs of a plan without noise."""
    times = sample_times()
    result = []
    for run in plan:
        muscle = replace(parameters, load=run.load)
        trajectory = simulate_muscle(muscle, run.p_supply, run.schedule, times, effects)
        result.append(Measurement(run, times, _signals(trajectory)))
    return result


def measure(
    plan: Plan,
    effects: Sequence[Effect] = (),
    seed: int = 0,
    noise: Noise | None = None,
    parameters: MuscleParameters = TRUTH,
) -> list[Measurement]:
    """All runs of a plan with Gaussian sensor noise; the same seed gives the same numbers."""
    rng = np.random.default_rng([seed, 0])
    sigma = (noise or Noise()).as_dict()
    measured = []
    for clean in simulate_plan(plan, effects, parameters):
        noisy = {
            name: y + sigma[name] * rng.standard_normal(len(y)) for name, y in clean.signals.items()
        }
        measured.append(replace(clean, signals=noisy))
    return measured


def effect_size(
    plan: Plan,
    effects: Sequence[Effect],
    noise: Noise | None = None,
    parameters: MuscleParameters = TRUTH,
    refit: bool = False,
) -> dict[str, float]:
    """Rms difference per signal, with against without the effects, in standard deviations of the noise.

    All runs count alike. Without `refit` the base parameters stay at their true values: the whole effect.
    With `refit` valve.C_A and muscle.mu_fb of the model without effects are fitted to the effect's noise-free
    signals in the runs of role fit (least squares within BOUNDS): what a user of the base model sees.
    """
    sigma = (noise or Noise()).as_dict()
    with_effect = simulate_plan(plan, effects, parameters)

    def deviation(base: MuscleParameters, roles: Sequence[str]) -> dict[str, Array]:
        chosen = [m for m in with_effect if m.run.role in roles]
        without = simulate_plan(tuple(m.run for m in chosen), (), base)
        pairs = list(zip(chosen, without, strict=True))
        return {
            name: np.concatenate([a.signals[name] - b.signals[name] for a, b in pairs])
            / sigma[name]
            for name in sigma
        }

    base = parameters
    if refit:
        low, high = zip(*BOUNDS.values(), strict=True)
        fit = least_squares(
            lambda theta: np.concatenate(
                list(deviation(replace(parameters, calibration=theta[0], mu_fb=theta[1]), ["fit"]).values())
            ),
            [parameters.calibration, parameters.mu_fb],
            bounds=(low, high), x_scale=[0.1, 0.01], diff_step=1e-4, max_nfev=12,
        )  # fmt: skip
        base = replace(parameters, calibration=float(fit.x[0]), mu_fb=float(fit.x[1]))
    rms = deviation(base, ["fit", "holdout"])
    return {name: float(np.sqrt(np.mean(d**2))) for name, d in rms.items()}


def write_data_set(
    folder: Path,
    measured: Sequence[Measurement],
    noise: Noise | None = None,
    title: str = "latex muscle on the simulated rig",
    signals: Sequence[str] = ("p", "x", "T"),
    step_rows: bool = False,
) -> None:
    """Write experiment.toml and one CSV file per run into a folder, which is made.

    A step of the currents is coded by samples with interpolation = "previous" or, with `step_rows`, by two
    rows close to each other, the first without measurements.
    """
    runs = [
        Recording(
            one.run.schedule, one.run.p_supply, one.run.role, one.time, one.signals, one.run.load
        )
        for one in measured
    ]
    bounds = {name: (str(low), str(high)) for name, (low, high) in BOUNDS.items()}
    sigma = (noise or Noise()).as_dict()
    data_set.write(folder, runs, Description(title, sigma, signals, free=bounds), step_rows)


def truth(effects: Sequence[Effect], parameters: MuscleParameters = TRUTH) -> dict[str, object]:
    """What a diagnosis of the data should find, SI units."""
    return {
        "parameters": {"valve.C_A": parameters.calibration, "muscle.mu_fb": parameters.mu_fb},
        "effects": [{"name": effect_name(e), "parameters": effect_parameters(e)} for e in effects],
        "families": [e.family for e in effects if e.family != "none"],
    }


def _list() -> None:
    sizes = json.loads(SIZES.read_text())["effects"]
    for kind in EFFECTS:
        values = ", ".join(f"{key}={value:g}" for key, value in effect_parameters(kind()).items())
        size = sizes.get(effect_name(kind), {})
        shown = "; ".join(
            f"{case}: " + ", ".join(f"{signal} {value:.1f}" for signal, value in per_signal.items())
            for case, per_signal in size.items()
        )
        print(f"{effect_name(kind):32} {values}")
        if shown:
            print(f"{'':32} sizes in sigma, {shown}")


def _measure_sizes() -> None:
    plan = default_plan()
    effects = {}
    for kind in EFFECTS[1:]:
        sizes = {
            "base at truth": effect_size(plan, [kind()]),
            "base refitted": effect_size(plan, [kind()], refit=True),
        }
        effects[effect_name(kind)] = {
            case: {name: round(value, 2) for name, value in size.items()}
            for case, size in sizes.items()
        }
        print(effect_name(kind), effects[effect_name(kind)], flush=True)
    unit = "rms difference over default_plan() in standard deviations of the default noise, default strengths"
    SIZES.write_text(json.dumps({"unit": unit, "effects": effects}, indent=1) + "\n")


def main(arguments: Sequence[str] | None = None) -> int:
    """Command line; returns the exit status."""
    parser = argparse.ArgumentParser(prog="python -m rig", description=__doc__)
    parser.add_argument("folder", nargs="?", type=Path, help="data set to write")
    parser.add_argument(
        "--effect", action="append", default=[], metavar="FAMILY:FORM[:NAME=VALUE,...]"
    )
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--plan", choices=["default", "random"], default="default")
    parser.add_argument("--signals", default="p,x,T", help="measured signals to write")
    parser.add_argument("--noise", type=float, default=1.0, help="factor on the sensors' noise")
    parser.add_argument("--step-rows", action="store_true", help="code a step as two rows")
    parser.add_argument("--list", action="store_true", help="list effects, strengths and sizes")
    parser.add_argument(
        "--measure-sizes", action="store_true", help=f"measure all sizes into {SIZES.name}"
    )
    options = parser.parse_args(arguments)
    if options.list:
        _list()
        return 0
    if options.measure_sizes:
        _measure_sizes()
        return 0
    if options.folder is None:
        parser.error("which folder should the data set go to?")
    try:
        effects = [effect_of(text) for text in options.effect]
    except ValueError as error:
        parser.error(str(error))
    plan = default_plan() if options.plan == "default" else random_plan(options.seed)
    unit = Noise()
    noise = Noise(unit.p * options.noise, unit.x * options.noise, unit.T * options.noise)
    measured = measure(plan, effects, options.seed, noise)
    write_data_set(
        options.folder,
        measured,
        noise,
        signals=options.signals.split(","),
        step_rows=options.step_rows,
    )
    print(json.dumps(truth(effects), indent=1))
    return 0


if __name__ == "__main__":
    sys.exit(main())
