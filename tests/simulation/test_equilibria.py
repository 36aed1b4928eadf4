"""Equilibria: against closed forms, against waiting, and one independent of another."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from math import pi
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.optimize import brentq

import pam_cosim as pam
from pam_cosim.catalogue import compose
from pam_cosim.compiler import read_library
from pam_cosim.errors import InputError
from pam_cosim.fmu import build_model
from pam_cosim.simulation import Inputs, IsolatedSimulator, RunFailure, Simulator

Array = NDArray[np.float64]
Make = Callable[..., Simulator]
L0, D0, TURNS = 0.24, 0.02, 2.0
GENTLE = {"muscle.mu_fb": 0.0}
P = np.array([50e3, 120e3, 200e3, 350e3])


@pytest.fixture(scope="module")
def made(tmp_path_factory: pytest.TempPathFactory) -> Make:
    """A bench with some effects, ready to run."""
    kept: dict[object, Simulator] = {}

    def make(
        model: str, effects: Sequence[str] = (), sensitivities: Sequence[str] = (), fmi: str = "2.0"
    ) -> Simulator:
        key = (model, *effects, *sensitivities, fmi)
        if key not in kept:
            files: list[Path] = []
            if effects:
                composition = compose(read_library(), model, list(effects), "Tested")
                files = [tmp_path_factory.mktemp("models") / "Tested.mo"]
                files[0].write_text(composition.text)
                model = str(files[0])
            kept[key] = Simulator(
                build_model(model, files, sensitivities=tuple(sensitivities), fmi=fmi)
            )
        return kept[key]

    return make


def pull(p: Array | float, x: Array | float) -> Array:
    """DP (1) [N], of gauge pressure and contraction."""
    length = L0 - np.asarray(x)
    thread = L0**2 + (TURNS * pi * D0) ** 2
    return np.asarray(p * (3 * length**2 - thread) / (4 * pi * TURNS**2))


@pytest.mark.parametrize("fmi", ["2.0", "3.0"])
def test_the_pull_is_the_sleeves(made: Make, fmi: str) -> None:
    x = np.array([0.005, 0.02, 0.03, 0.05])
    run = made("QuasiStaticIsometric", fmi=fmi).equilibria({"p": P, "x": x}, parameters=GENTLE)
    np.testing.assert_allclose(run["F"], pull(P, x), rtol=1e-9)


def test_the_contraction_is_where_the_pull_carries_the_load(made: Make) -> None:
    load = np.array([10.0, 40.0, 80.0, 20.0])
    run = made("QuasiStaticIsotonic").equilibria({"p": P, "F": load}, parameters=GENTLE)
    wanted = [
        brentq(lambda x, p=p, f=f: float(pull(p, x)) - f, 0, 0.1)
        for p, f in zip(P, load, strict=True)
    ]
    np.testing.assert_allclose(run["x"], wanted, rtol=1e-6)


def test_no_point_depends_on_another(made: Make) -> None:
    simulator, order = made("QuasiStaticIsotonic"), np.array([2, 0, 3, 1])
    load = np.array([10.0, 40.0, 80.0, 20.0])
    one = simulator.equilibria({"p": P, "F": load})
    other = simulator.equilibria({"p": P[order], "F": load[order]})
    np.testing.assert_array_equal(one["x"][order], other["x"])


def test_waiting_long_enough_leads_there(made: Make) -> None:
    simulator = made("QuasiStaticIsotonic")
    found = simulator.equilibria({"p": [200e3], "F": [50.0]})["x"][0]
    held = Inputs(np.array([0.0]), {"p": np.array([200e3]), "F": np.array([50.0])})
    assert simulator.run([0.0, 60.0], inputs=held, tolerance=1e-9)["x"][-1] == pytest.approx(
        found, rel=1e-6
    )


def test_sensitivities_are_those_of_the_equilibrium(made: Make) -> None:
    names = ("muscle.D0", "muscle.stop.k")
    simulator = made("QuasiStaticIsotonic", sensitivities=names)
    inputs = {"p": np.append(0.0, P), "F": np.full(5, 40.0)}
    exact = simulator.equilibria(inputs)
    for name, step in zip(names, (1e-6, 1.0), strict=True):
        at = simulator.interface.parameters[name].start
        assert at is not None
        up, down = (
            simulator.equilibria(inputs, parameters={name: at + s})["x"] for s in (step, -step)
        )
        slope = (up - down) / (2 * step)
        np.testing.assert_allclose(
            exact[f"sensitivity.x.{name}"], slope, rtol=1e-4, atol=1e-5 * float(np.abs(slope).max())
        )


@pytest.mark.parametrize("effect", ["CoulombFriction", "DahlFriction", "MaxwellSlipFriction"])
def test_branches_differ_by_twice_the_dry_friction(made: Make, effect: str) -> None:
    simulator = made("QuasiStaticIsometric", [effect])
    inputs = {
        "p": np.repeat(P[:3], 3),
        "x": np.full(9, 0.02),
        "branch": np.tile([1.0, 0.0, -1.0], 3),
    }
    up, rest, down = (
        simulator.equilibria(inputs, parameters={"dryFriction.F_c": 7.0})["F"].reshape(3, 3).T
    )
    np.testing.assert_allclose(down - up, 14.0, rtol=1e-6)
    np.testing.assert_allclose(rest, (up + down) / 2, rtol=1e-6)


def test_what_goes_with_the_speed_is_not_there(made: Make) -> None:
    inputs = {"p": P, "x": np.full(4, 0.02), "branch": np.array([1.0, -1.0, 1.0, -1.0])}
    plain = made("QuasiStaticIsometric").equilibria(inputs)["F"]
    for effect in ("ViscousFriction", "MaxwellCreep"):
        np.testing.assert_allclose(
            made("QuasiStaticIsometric", [effect]).equilibria(inputs)["F"], plain, rtol=1e-12
        )


def test_no_equilibrium_is_one_failure_that_says_why(tmp_path: Path) -> None:
    file = tmp_path / "Drifts.mo"
    file.write_text(
        "model Drifts\n  input Real u(start=1);\n  output Real y;\n  Real x(start=0, fixed=true);\n"
        "equation\n  der(x) = u;\n  y = x;\nend Drifts;\n"
    )
    with Simulator(build_model(str(file), [file])) as simulator:
        assert simulator.equilibria({"u": [0.0]})["y"][0] == 0.0
        with pytest.raises(
            RunFailure, match=r"no equilibrium was found: 'x'.*still changes by 2 .*under u = 2"
        ):
            simulator.equilibria({"u": [0.0, 2.0]})
        assert simulator.equilibria({"u": [0.0]})["y"][0] == 0.0


@pytest.mark.parametrize("muscle", ["physical", "any-geometry", "fluidic", "DMSP-20"])
def test_a_slack_muscle_without_load_is_at_rest_where_it_hangs(tmp_path: Path, muscle: str) -> None:
    """Nothing holds its end, and nothing moves it: one point of many that must not end the others."""
    file = tmp_path / "Rig.mo"
    pam.bench("imposed-pressure", "imposed-force", muscle, None, file, static=True)
    with Simulator(build_model(str(file), [file])) as simulator:
        load, p = np.array([0.0, 0.0, 0.0, 50.0]), np.array([0.0, 10e3, 300e3, 300e3])
        x = simulator.equilibria({"p": p, "F_load": load, "branch": np.zeros(4)})["x"]
    assert abs(x[0]) < 1e-3 and abs(x[1]) < (1e-3 if muscle in ("fluidic", "DMSP-20") else 0.1)
    assert x[2] > x[3] > 0.01


def test_an_input_is_given_once_and_known(made: Make) -> None:
    simulator = made("QuasiStaticIsometric")
    with pytest.raises(InputError, match="'x' is given over time and as a constant"):
        simulator.equilibria({"p": P, "x": P * 0}, parameters={"x": 0.01})
    with pytest.raises(InputError, match="no input 'y'"):
        simulator.equilibria({"y": P})


def test_a_process_of_its_own_finds_them_and_another_tool_does_not() -> None:
    path = build_model("QuasiStaticIsometric")
    with IsolatedSimulator(path) as simulator:
        run = simulator.equilibria({"p": P, "x": np.full(4, 0.02)}, parameters=GENTLE)
    np.testing.assert_allclose(run["F"], pull(P, 0.02), rtol=1e-6)
    with Simulator(path) as simulator:
        simulator._driver.settles = False
        with pytest.raises(InputError, match="which FMUs of other tools do not find"):
            simulator.equilibria({"p": P, "x": P * 0})
