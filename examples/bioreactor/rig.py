"""The bioreactor of arXiv:2604.01231, simulated: samples of the substrate with noise, as a data set.

Nothing of it comes from the Modelica library or its solver: amounts and hours are integrated by LSODA here,
concentrations and seconds there. Volumes, concentrations, yield, noise and the rate of growth (Monod) are those of the
authors' tutorial, https://docs.sciml.ai/Overview/dev/showcase/optimal_data_gathering_for_missing_physics.

    python examples/bioreactor/rig.py FOLDER                      # a batch without a feed, and one fed with care
    python examples/bioreactor/rig.py FOLDER --further next.csv   # and a run with the feed of a table
"""

from __future__ import annotations

import argparse
import csv
import math
from collections.abc import Callable, Sequence
from pathlib import Path

import numpy as np
from scipy.integrate import solve_ivp

Array = np.ndarray
Rate = Callable[[float, float], float]  # substrate, biomass [g/l] -> rate of growth [1/h]

S_IN, YIELD, VOLUME, START = 50.0, 0.777, 7.0, 1.0  # g/l, 1, l, g/l of substrate and of biomass
NOISE = 0.1  # g/l
HOURS = np.arange(16.0)  # when a sample is taken
MU_MAX, K_S = 0.421, 4.39  # 1/h, g/l
FLOWS = {"m3/s": 3.6e6, "l/h": 1.0, "L/h": 1.0, "mL/s": 3.6, "L/s": 3600.0, "L/min": 60.0}  # in l/h

RATES: dict[str, Rate] = {
    "monod": lambda s, x: MU_MAX * s / (K_S + s),
    "haldane": lambda s, x: MU_MAX * s / (K_S + s + s * s / 20),
    "contois": lambda s, x: MU_MAX * s / (1.5 * x + s),
    "tessier": lambda s, x: MU_MAX * -math.expm1(-s / K_S),
}
"""What the rate of growth is; the paper's is the first."""

Feed = tuple[
    Array, Array
]  # times [h] in order, flow [l/h]: lines between them, a step where a time stands twice
NO_FEED: Feed = (HOURS[[0, -1]], np.zeros(2))
CAREFUL: Feed = (np.array([0.0, 5.0, 5.0, 15.0]), np.array([0.0, 0.0, 0.1, 0.1]))


def substrate(rate: Rate, feed: Feed) -> Array:
    """(16,) concentration of the substrate at ``HOURS`` [g/l], without noise."""

    def slope(t: float, amounts: Array, first: int) -> list[float]:
        (t_0, t_1), (q_0, q_1) = feed[0][first : first + 2], feed[1][first : first + 2]
        q = q_0 + (q_1 - q_0) * (t - t_0) / (t_1 - t_0)
        s, x = max(amounts[0] / amounts[2], 0.0), amounts[1] / amounts[2]
        grown = rate(s, x) * amounts[1]
        return [q * S_IN - grown / YIELD, grown, q]

    state, found = np.array([START * VOLUME, START * VOLUME, VOLUME]), np.full(len(HOURS), START)
    for first, (begin, end) in enumerate(zip(feed[0][:-1], feed[0][1:], strict=True)):
        if end <= begin:
            continue
        inside = np.logical_and(begin < HOURS, end >= HOURS)
        at = np.unique([*HOURS[inside], end])
        done = solve_ivp(
            slope, (begin, end), state, "LSODA", at, args=(first,), rtol=1e-9, atol=1e-10
        )
        found[inside] = (done.y[0] / done.y[2])[np.isin(at, HOURS[inside])]
        state = done.y[:, -1]
    return found


def feed_of(file: Path) -> Feed:
    """The feed of a table with columns ``time [s]`` and ``Q_in [UNIT]``."""
    lines = [
        line for line in file.read_text(encoding="utf-8").splitlines() if not line.startswith("#")
    ]
    header, *rows = csv.reader(lines)
    values = np.array(rows, dtype=float).T
    named = dict(zip(header, values, strict=True))
    (head,) = (name for name in header if name.startswith("Q_in ["))
    return named["time [s]"] / 3600, named[head] * FLOWS[
        head.removeprefix("Q_in [").removesuffix("]")
    ]


def drawn(rng: np.random.Generator) -> Feed:
    """A feed that is set anew every hour, at random up to 10 l/h."""
    return np.repeat(HOURS, 2)[1:-1], np.repeat(rng.uniform(0, 10, len(HOURS) - 1), 2)


def write(
    folder: Path, hidden: str = "monod", feeds: Sequence[Feed] = (NO_FEED, CAREFUL), seed: int = 1
) -> None:
    """The runs as a data set; every run has noise of its own, the same in whatever set it stands."""
    folder.mkdir(parents=True, exist_ok=True)
    text = ['title = "A bioreactor"', 'model = "Bioreactor.Benches.FedBatch"', ""]
    text += ["[signals.C_S]", f'sigma = "{NOISE} g/l"']
    text += ["", "[parameters]"]
    text += [f'"vessel.{name}_start" = "{START} g/l"' for name in "SX"] + [
        f'"vessel.V_start" = "{VOLUME} l"'
    ]
    text += [f'"feed.S_in" = "{S_IN} g/l"', f'"cells.Y" = {YIELD}', "", "[fit]"]
    text += ['"cells.mu_max" = { min = "0.01 1/h", max = "3 1/h" }']
    for number, feed in enumerate(feeds):
        noise = NOISE * np.random.default_rng((seed, number)).standard_normal(len(HOURS))
        rows = zip(HOURS, substrate(RATES[hidden], feed) + noise, strict=True)
        times = np.unique([*HOURS, *feed[0]])
        name = f"run-{number + 1}.csv"
        _write_run(folder / name, feed, times, dict(rows))
        text += ["", "[[runs]]", f'file = "{name}"', 'role = "fit"']
    (folder / "experiment.toml").write_text("\n".join([*text, ""]), encoding="utf-8")


def _write_run(file: Path, feed: Feed, times: Array, samples: dict[float, float]) -> None:
    """Feed at all times; where it steps, two rows at one time, of which the later has the sample."""
    with file.open("w", newline="", encoding="utf-8") as out:
        table = csv.writer(out)
        table.writerow(["time [h]", "Q_in [l/h]", "C_S [g/l]"])
        for t in times:
            steps = feed[1][feed[0] == t] if t in feed[0] else np.array([np.interp(t, *feed)])
            for last, flow in enumerate(steps, start=1):
                sample = f"{samples[t]:.6g}" if t in samples and last == len(steps) else ""
                table.writerow([f"{t:.10g}", f"{flow:.10g}", sample])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="where the data set goes")
    parser.add_argument(
        "--hidden", choices=RATES, default="monod", help="law of the rate of growth"
    )
    parser.add_argument(
        "--further", type=Path, action="append", default=[], help="table of a further run's feed"
    )
    parser.add_argument("--seed", type=int, default=1, help="of the noise")
    words = parser.parse_args()
    write(words.folder, words.hidden, [NO_FEED, CAREFUL, *map(feed_of, words.further)], words.seed)
