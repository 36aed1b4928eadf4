"""Two loggers: offsets stated and estimated, with the spread that is said; what cannot be known is refused."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.errors import InputError
from pam_cosim.measurement import read_data_set
from pam_cosim.measurement.clocks import ClockError, estimate_offset
from tests.measurement.bench import MODEL, describe


def course(t: np.ndarray) -> np.ndarray:
    """A signal that never repeats itself [kPa]."""
    return 80 + 30 * np.sin(1.3 * t) + 25 * np.tanh(4 * (t - 3.0)) - 20 * np.tanh(3 * (t - 7.2))


def two(seed: int, offset: float) -> tuple[tuple, tuple]:
    rng = np.random.default_rng(seed)
    t, s = np.arange(0, 10, 0.01), np.arange(1.0, 9.0, 0.033)
    y = course(t) + rng.normal(0, 1.0, len(t))
    z = 0.9 * course(s) + 4 + rng.normal(0, 0.7, len(s))  # another gain and zero
    return (t, y), (s - offset, z)


@pytest.mark.parametrize("what", ["constant", "periodic", "unlike"])
def test_what_cannot_be_known(what):
    rng = np.random.default_rng(3)
    t = np.arange(0, 20, 0.01)
    y = {
        "constant": np.full(len(t), 3.0),
        "periodic": np.sin(2 * np.pi * t),
        "unlike": rng.normal(0, 1, len(t)),
    }[what]
    z = y if what != "unlike" else rng.normal(0, 1, len(t))
    with pytest.raises(ClockError):
        estimate_offset((t, y + (what != "constant") * rng.normal(0, 0.1, len(t))), (t, z))


@pytest.fixture
def rig(tmp_path):
    def write(logger: str):
        (t, y), (s, z) = two(1, 0.5)
        u = np.where(t < 3.0, 0.0, 0.35)
        rows = "".join(f"{a:.4f},{b:g},{c:.4f}\n" for a, b, c in zip(t, u, y, strict=True))
        (tmp_path / "rig.csv").write_text("time [s],u_in [A],p [kPa]\n" + rows)
        rows = "".join(
            f"{a:.4f};{b:.4f};{a:.4f}\n".replace(".", ",") for a, b in zip(s, z, strict=True)
        )
        (tmp_path / "camera.csv").write_text("t [s];Druck [kPa];Weg [mm]\n" + rows)
        (tmp_path / "experiment.toml").write_text(
            f'model = "{MODEL}"\n[[runs]]\nfile = "rig.csv"\n[[runs.loggers]]\nfile = "camera.csv"\n{logger}\n'
            "[runs.loggers.columns]\ntime = { column = 't' }\np = { column = 'Druck' }\nx = { column = 'Weg' }\n"
        )
        return tmp_path

    return write


@pytest.mark.parametrize(
    ("logger", "tolerance"), [('offset = "500 ms"', 1e-12), ('match = "p"', 0.01)]
)
def test_a_run_of_two_loggers(rig, logger, tolerance):
    folder = rig(logger)
    data = read_data_set(folder, describe)
    run = data.runs[0]
    assert list(run.measurements) == ["p", "x"]
    assert run.sample_count("p") == 1000 and run.sample_count("x") == len(
        np.arange(1.0, 9.0, 0.033)
    )
    there = np.isfinite(run.measurements["x"])
    np.testing.assert_allclose(
        run.time[there] - 1e3 * run.measurements["x"][there], 0.5, atol=tolerance + 1e-9
    )
    np.testing.assert_allclose(run.inputs["u_in"][run.time >= 3.0], 0.35)
    assert set(data.files) == {
        folder / name for name in ("experiment.toml", "rig.csv", "camera.csv")
    }
    assert any("the clock of camera.csv" in note for note in data.notes()) == ("match" in logger)


@pytest.mark.parametrize(
    ("logger", "line", "words"),
    [
        ("", 4, ["offset = ", "match = "]),
        ('offset = "1 s"\nmatch = "p"', 6, ["offset = "]),
        ('offset = "1 mm"', 6, ["'mm'"]),
        ('offset = "1 h"', 4, ["no time in common"]),
        ('match = "T"', 6, ["rig.csv has no 'T'"]),
        ('mach = "p"', 6, ["did you mean 'match'"]),
    ],
)
def test_faults(rig, logger, line, words):
    with pytest.raises(InputError) as caught:
        read_data_set(rig(logger), describe)
    assert caught.value.line == line, caught.value
    for word in words:
        assert word in caught.value.message
