"""Conservation laws, and finite expressions wherever a solver can go."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from tests.library.catalogue import BENCH, on_bench, tree
from tests.library.ode import Model, Values

R, GAMMA = 287.05, 1.4
MASS_OFF = (
    -0.0374
)  # of the gas that passed: what DP (59) with (60) loses in filling a muscle to 207 kPa
ENERGY_OFF = (
    -0.0543
)  # of the enthalpy that flowed in: heat that n = 1.2 takes out of a vessel without a wall
LIBRARY = "PneumaticMuscle"
ENERGY_TANK = f"""model Tank extends {LIBRARY}.Benches.TankFilling(
  tank(redeclare model Gas = {LIBRARY}.Effects.GasEnergy.EnergyGas)); end Tank;"""
ENERGY_MUSCLE = f"""model Muscle extends {LIBRARY}.Benches.Isotonic(
  muscle(redeclare model Gas = {LIBRARY}.Effects.GasEnergy.EnergyGas)); end Muscle;"""


def mass(v: Values, owner: str) -> float:
    """Of the gas in a volume, by the ideal gas law [kg]."""
    return v[f"{owner}.gas.p"] * v[f"{owner}.gas.V"] / (R * v[f"{owner}.gas.T"])


def energy(v: Values, owner: str) -> float:
    """Internal energy of the gas [J]."""
    return v[f"{owner}.gas.p"] * v[f"{owner}.gas.V"] / (GAMMA - 1)


def volume_rate(model: Model, v: Values) -> float:
    """dV/dt of the muscle [m3/s] from its geometry, not from the model's own derivative."""
    p = dict(zip(model.interface.parameters, model.parameters(), strict=True))
    n, L = p["muscle.turns"], p["muscle.L0"] - v["load.s"]
    b2 = p["muscle.L0"] ** 2 + (n * np.pi * p["muscle.D0"]) ** 2
    return float(-(b2 - 3 * L**2) / (4 * np.pi * n**2) * v["load.v"])


# Mass. The ledger integrates the flow at the gas port, which the model computes from its orifices, as one more
# state of the run; it must equal the change of p V/(R T), which the model does not compute.


@pytest.mark.parametrize("n", (1.0, 1.2, 1.4))
def test_polytropic_vessel_keeps_the_mass_that_flowed_in(n: float) -> None:
    model = Model(f"{LIBRARY}.Benches.TankFilling")
    p = model.parameters({"tank.n": n})
    before, after, flowed, passed = model.ledger(
        20.0, lambda v: v["tank.port.m_flow"], model.inputs(), p
    )
    assert passed > 1e-3
    assert mass(after, "tank") - mass(before, "tank") == pytest.approx(flowed, abs=1e-8 * passed)


@pytest.mark.parametrize(("owner", "text"), (("tank", ENERGY_TANK), ("muscle", ENERGY_MUSCLE)))
def test_gas_with_energy_balance_keeps_the_mass_that_flowed_in(
    owner: str, text: str, tmp_path: Path
) -> None:
    model = Model(owner.capitalize(), text, tmp_path)
    port = f"{owner}.port.m_flow"
    before, after, flowed, passed = model.ledger(
        2.0, lambda v: v[port], model.inputs(), model.parameters()
    )
    assert passed > 1e-4
    assert mass(after, owner) - mass(before, owner) == pytest.approx(flowed, abs=1e-8 * passed)


def test_polytropic_muscle_gas_makes_up_mass_by_so_much() -> None:
    model = Model(f"{LIBRARY}.Benches.Isotonic")
    run = model.ledger(
        3.0, lambda v: v["muscle.port.m_flow"], model.inputs(), model.parameters(), rtol=1e-9
    )
    before, after, flowed, passed = run
    error = (mass(after, "muscle") - mass(before, "muscle") - flowed) / passed
    assert error == pytest.approx(MASS_OFF, abs=2e-3)


# Energy. U = p V/(gamma - 1); dU = enthalpy that flows in + heat - p dV.


def test_energy_of_a_vessel_balances(tmp_path: Path) -> None:
    model = Model("Tank", ENERGY_TANK, tmp_path)
    before, after, flowed, passed = model.ledger(
        20.0,
        lambda v: v["tank.port.H_flow"] + v["tank.gas.heatPort.Q_flow"],
        model.inputs(),
        model.parameters(),
    )
    assert energy(after, "tank") - energy(before, "tank") == pytest.approx(
        flowed, abs=1e-8 * passed
    )
    assert after["tank.gas.heatPort.Q_flow"] < -0.1  # heat takes part


@pytest.mark.parametrize("text", ("", ENERGY_MUSCLE), ids=("polytropic", "energy"))
def test_energy_of_a_muscle_balances(text: str, tmp_path: Path) -> None:
    model = Model("Muscle" if text else f"{LIBRARY}.Benches.Isotonic", text, tmp_path)

    def entry(v: Values) -> float:
        work = v["muscle.gas.p"] * volume_rate(model, v)
        return v["muscle.port.H_flow"] + v["muscle.gas.heatPort.Q_flow"] - work

    before, after, flowed, passed = model.ledger(2.0, entry, model.inputs(), model.parameters())
    assert energy(after, "muscle") - energy(before, "muscle") == pytest.approx(
        flowed, abs=1e-8 * passed
    )


def test_a_hose_that_widens_keeps_mass_and_energy(tmp_path: Path) -> None:
    """The work p dV = V e p dp is stored in the hose: V e p^2/2 [J]."""
    composition = on_bench("GeneralLine", BENCH)
    model = Model(composition.name, composition.text, tmp_path)
    names = list(model.interface.parameters)
    expansion = 4e-6  # 1/Pa
    parameters = model.parameters({"line.expansion": expansion, "line.UA": 0.0})
    volume, ambient = (parameters[names.index(n)] for n in ("line.V", "ambient.p"))

    def wide(v: Values) -> float:
        return float(volume * (1 + expansion * (v["line.gas.p"] - ambient)))

    def stored(v: Values) -> float:
        p = v["line.gas.p"]
        return float(p * wide(v) / (GAMMA - 1) + volume * expansion * p**2 / 2)

    before, after, flowed, passed = model.ledger(
        2.0, lambda v: v["line.gas.port.m_flow"], model.inputs(), parameters
    )
    gained = [v["line.gas.p"] * wide(v) / (R * v["line.gas.T"]) for v in (before, after)]
    assert gained[1] - gained[0] == pytest.approx(flowed, abs=1e-8 * passed)
    before, after, flowed, passed = model.ledger(
        2.0, lambda v: v["line.gas.port.H_flow"], model.inputs(), parameters
    )
    assert stored(after) - stored(before) == pytest.approx(flowed, abs=1e-8 * passed)


def test_polytropic_vessel_needs_heat_that_nothing_gives() -> None:
    model = Model(f"{LIBRARY}.Benches.TankFilling")
    before, after, flowed, _ = model.ledger(
        20.0, lambda v: v["tank.port.H_flow"], model.inputs(), model.parameters()
    )
    missing = (energy(after, "tank") - energy(before, "tank") - flowed) / flowed
    assert missing == pytest.approx(ENERGY_OFF, abs=2e-3)


# Virtual work: F = -p dV/dL for every sleeve whose force is derived from its volume.

BY_WORK = (
    "Laws.Forces.CylindricalBraid",
    "Laws.Forces.Gaylord",
    "Laws.Forces.ThreeElementShape",
    "Laws.Forces.TothovaPitel",
)


@pytest.mark.parametrize("braid", BY_WORK)
@pytest.mark.parametrize("eps", (0.0, 0.05, 0.15, 0.25, 0.3))
def test_force_is_the_slope_of_the_volume(braid: str, eps: float, tmp_path: Path) -> None:
    text = f"""model Held extends {LIBRARY}.Benches.StaticForce(
      muscle(L0=0.24, D0=0.02, redeclare model Braid = {LIBRARY}.{braid})); end Held;"""
    model = Model("Held", text, tmp_path)
    p, gauge, h = model.parameters(), 2e5, 1e-5

    def at(strain: float) -> Values:
        return model.at(np.zeros(0), model.inputs({"p": gauge, "eps": strain}), p)

    slope = (at(eps - h)["muscle.braid.V"] - at(eps + h)["muscle.braid.V"]) / (2 * h * 0.24)
    assert at(eps)["F"] == pytest.approx(-gauge * slope, rel=1e-6, abs=1e-3)


BY_ENERGY = ("Effects.EndShape.ElasticBraid",)
"""Sleeves that store energy themselves: ``test_elastic_braid`` has their least potential energy."""


def test_laws_of_the_pull_alone_are_known() -> None:
    """A new sleeve is either in the lists above or a law of the pull alone, which keeps the cylinder's volume."""
    sleeves = {
        n for n in tree().subtypes(f"{LIBRARY}.Interfaces.Braid") if not tree().classes[n].partial
    }
    cylinder = {n for n in sleeves if tree().is_subtype(n, f"{LIBRARY}.Interfaces.Cylinder")}
    assert sleeves - cylinder <= {f"{LIBRARY}.{name}" for name in (*BY_WORK, *BY_ENERGY)}


# Finite everywhere: states in their range of operation, inputs from nothing to more than full, parameters within
# their bounds.
