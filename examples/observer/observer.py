"""The pull of a muscle estimated from pressure and contraction at 10 and 80 Hz, against an independent simulation.

The rig of this repository (SciPy, other states, other formulas) lifts a load while something that nobody measures pulls
on it. Its pressure and contraction are sampled with noise; the observer knows neither the rig's force nor the pull.

python examples/observer/observer.py [FOLDER FOR PICTURES]
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parents[1]))  # the rig is no part of the installed package

import pam_cosim as pam  # noqa: E402
from rig.effect import Effect, Now  # noqa: E402
from rig.flow import G  # noqa: E402
from rig.muscle import MuscleParameters, simulate_muscle  # noqa: E402
from rig.schedule import Phase, Schedule  # noqa: E402

SUPPLY, LOAD, END = 207e3, 2.27, 12.0  # Pa, kg, s
NOISE = {"p": 500.0, "x": 0.2e-3}  # Pa, m
STATES = ("muscle.gas.p", "load.s", "load.v")
PHASES = [
    (1.2, 0.35, 0),
    (2.0, 0, 0),
    (1.0, 0, 0.3),
    (1.6, 0.3, 0),
    (2.2, 0, 0),
    (1.0, 0, 0.25),
    (3.0, 0.28, 0),
]


def pull(t: np.ndarray) -> np.ndarray:
    """What pulls on the load [N]: 15 N from 2.5 s on, and a sine from 6 s on."""
    late = 0.5 + 0.5 * np.tanh((t - 6) / 0.1)
    return 7.5 * (1 + np.tanh((t - 2.5) / 0.05)) + 6 * late * np.sin(2 * np.pi * 0.7 * (t - 6))


@dataclass(frozen=True)
class Pull(Effect):
    """That force on the rig; its state is a clock."""

    atol = (1e-9,)

    def initial(self, rest: object) -> tuple[float, ...]:
        return (0.0,)

    def rates(self, q: tuple[float, ...], now: Now) -> tuple[float, ...]:
        return (1.0,)

    def force(self, q: tuple[float, ...], x: float, v: float, p_gauge: float) -> float:
        return float(pull(np.array(q[0])))


@dataclass(frozen=True)
class Bladder(Effect):
    """A bladder that the observer's model does not have [N/m]."""

    stiffness: float = 60.0

    def force(self, q: tuple[float, ...], x: float, v: float, p_gauge: float) -> float:
        return self.stiffness * x


def truth(*effects: Effect) -> tuple[np.ndarray, pam.Trajectory]:
    """The independent run at 2 kHz, and in it the pull of the muscle on the load, by Newton's law."""
    time = np.linspace(0, END, int(2000 * END) + 1)
    schedule = Schedule.of([Phase(*phase) for phase in PHASES])
    run = simulate_muscle(
        MuscleParameters(load=LOAD), SUPPLY, schedule, time, (Pull(), *effects), method="BDF"
    )
    stop = np.where(run.x < 0, np.maximum(0, -2e5 * run.x - 500 * run.v), 0)
    force = LOAD * (np.gradient(run.v, time) + G) + pull(time) - stop
    return force, pam.Trajectory(time, {"p": run.p, "x": run.x}, {"p": "Pa", "x": "m"})


def sampled(run: pam.Trajectory, rate: float, seed: int) -> pam.Trajectory:
    """What an acquisition at so many Hz records: currents as commanded, pressure and contraction with noise."""
    chance, every = np.random.default_rng(seed), round(2000 / rate)
    time = run.time[::every]
    currents = np.array([Schedule.of([Phase(*phase) for phase in PHASES]).at(t) for t in time])
    columns = {"u_in": currents[:, 0], "u_out": currents[:, 1]}
    for name, size in NOISE.items():
        columns[name] = run[name][::every] + size * chance.standard_normal(time.size)
    return pam.Trajectory(time, columns, {"u_in": "A", "u_out": "A", "p": "Pa", "x": "m"})


def observed(recording: pam.Trajectory, force: np.ndarray, change: float) -> pam.Observation:
    """The filter: it is told the sensors' noise, and by how many newtons a pull may change in a second."""
    estimate = pam.observe(
        str(HERE / "PulledMuscle.mo"), recording, {"p_supply": SUPPLY, "load.m": LOAD}, noise=NOISE, outputs=["F"],
        unknown={"F_ext": (5, change)}, drift={"muscle.gas.p": "0.05 kPa"}, interpolation="previous",
        spread={"load.s": "0.1 mm", "load.v": "1 mm/s", "muscle.gas.p": "0.3 kPa"},
    )  # fmt: skip
    every = (force.size - 1) // (recording.time.size - 1)
    return estimate.with_truth({"F": force[::every], "F_ext": pull(recording.time)})


def without_filter(recording: pam.Trajectory, force: np.ndarray) -> float:
    """The rms error of the force equation on the noisy readings themselves, speed by the last difference."""
    par, t = MuscleParameters(), recording.time
    p, x, v = (
        recording["p"],
        recording["x"],
        np.diff(recording["x"], prepend=recording["x"][0]) / (t[1] - t[0]),
    )
    friction = p * (
        par.crossing_area * par.mu_d * np.tanh(par.k_f * v) + par.mu_fb * par.fibre_area
    )
    raw = np.array([a * par.volume_slope(b) for a, b in zip(p, x, strict=True)]) - friction
    every, lifted = (force.size - 1) // (t.size - 1), x > 1e-3
    return float(np.sqrt(np.mean((raw - force[::every])[lifted] ** 2)))


def draw(
    results: dict[float, pam.Observation], force: np.ndarray, time: np.ndarray, path: Path
) -> None:
    """The pull of the muscle and the unknown pull, true and estimated, for each rate; normalised innovations."""
    figure, axes = plt.subplots(
        3, len(results), figsize=(11, 7.2), sharex=True, sharey="row", layout="constrained"
    )
    for column, (rate, observation) in zip(axes.T, results.items(), strict=True):
        for axis, name, true in ((column[0], "F", force), (column[1], "F_ext", pull(time))):
            axis.plot(time, true, color="#2b2f33", lw=1.0, label="independent simulation")
            value, around = observation[name], 1.96 * observation.deviations[name]
            axis.fill_between(
                observation.time, value - around, value + around, color="#0072b2", alpha=0.25, lw=0
            )
            axis.plot(observation.time, value, color="#0072b2", lw=1.2, label="observer, 95 %")
        for (name, values), colour in zip(
            observation.innovations.items(), ("#009e73", "#d55e00"), strict=True
        ):
            column[2].plot(observation.time, values, ".", color=colour, ms=3, label=name)
        column[2].axhspan(-1.96, 1.96, color="#e4e7ea", zorder=0)
        column[0].set_title(f"{rate:g} Hz", loc="left")
        column[2].set_xlabel("time [s]")
    axes[0, 0].set(ylabel="pull of the muscle [N]", ylim=(0, None))
    axes[1, 0].set_ylabel("pull on the load [N]")
    axes[2, 0].set(ylabel="normalised innovations", ylim=(-6, 6))
    for axis in axes[:, 0]:
        axis.legend(frameon=False, fontsize=8, ncols=2)
    for axis in axes.flat:
        axis.grid(color="#e4e7ea")
    figure.savefig(path, dpi=110)
    print(f"written: {path}")


def main(folder: Path) -> None:
    """How fast a pull changes is found in one recording; others show two rates, and a bladder that the model lacks."""
    plt.switch_backend("Agg")
    folder.mkdir(parents=True, exist_ok=True)
    force, run = truth()
    results = {}
    trial = sampled(run, 80.0, seed=8)
    tried = {
        change: observed(trial, force, change).log_likelihood
        for change in (1.0, 2.0, 5.0, 10.0, 20.0)
    }
    change = max(tried, key=tried.__getitem__)
    print(
        "log-likelihood by change in a second:",
        ", ".join(f"{c:g} N: {value:.0f}" for c, value in tried.items()),
    )
    for rate in (10.0, 80.0):
        recording = sampled(run, rate, seed=7)
        results[rate] = observed(recording, force, change)
        print(f"{rate:g} Hz: {results[rate]}")
        print(
            f"the force equation on the readings themselves: rms {without_filter(recording, force):.2f} N\n"
        )
    draw(results, force, run.time, folder / "observer.png")
    force, run = truth(Bladder())
    off = observed(sampled(run, 80.0, seed=7), force, change)
    print(f"with a bladder of 60 N/m that the model lacks, 80 Hz: {off}")


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
