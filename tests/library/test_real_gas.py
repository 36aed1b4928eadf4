"""A gas that is not ideal: its balances in a vessel against exact integrals, and what its film refers to."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from rig.flow import P_ATM
from tests.library.ode import Model, Values

R, GAMMA = 287.05, 1.4
LIBRARY = "PneumaticMuscle"
P_START = 800e3 - P_ATM  # gauge
GASES = ("RealGas", "GeneralGas")
COVERED = f"""model Covered "A vessel without heat"
  model Cover extends {LIBRARY}.Interfaces.Wall;
  equation heatPort.Q_flow = 0; outside.Q_flow = 0; end Cover;
  extends {LIBRARY}.Benches.VesselOrifice(tank(redeclare model Wall = Cover,
    redeclare model Gas = {LIBRARY}.Effects.GasEnergy.GAS)); end Covered;"""


def covered(gas: str, b: float, e: float, folder: Path, **more: float) -> tuple[Model, np.ndarray]:
    model = Model("Covered", COVERED.replace("GAS", gas), folder)
    own = {"tank.gas.b": b, "tank.gas.e": e} | {f"tank.{n}": v for n, v in more.items()}
    return model, model.parameters(own)


def until_half_of_it_is_left(model: Model, p: np.ndarray) -> Values:
    """The vessel when half of its mass is gone."""
    u, start = model.inputs(), model.initial(p)
    m_0 = model.at(start, u, p)["tank.gas.m"]

    def f(_: float, x: np.ndarray) -> np.ndarray:
        now = model.at(x, u, p)
        return np.array([now[f"der({s.name})"] for s in model.ode.states])

    def half(_: float, x: np.ndarray) -> float:
        return model.at(x, u, p)["tank.gas.m"] - m_0 / 2

    half.terminal = True  # type: ignore[attr-defined]
    run = solve_ivp(f, (0.0, 1e3), start, "LSODA", rtol=1e-9, atol=1e-9, events=half)
    assert run.status == 1
    return model.at(run.y_events[0][0], u, p)


# du = -p dv with u = p (v - e b)/(gamma - 1), from 800 kPa absolute and 293.15 K to twice the specific volume:
# p (v - e b)^gamma stays. The ideal gas has 303.1 kPa and 222.2 K.
HALVED = [
    (-3e-3, 0.6, 306.9e3, 221.7),
    (7e-3, 0.6, 295.1e3, 223.5),
    (-3e-3, 1.0, 309.3e3, 223.4),
    (-3e-3, 0.0, 303.1e3, 219.0),
    (0.0, 0.6, 303.1e3, 222.2),
]


@pytest.mark.parametrize("gas", GASES)
@pytest.mark.parametrize(("b", "e", "pressure", "temperature"), HALVED)
def test_what_stays_in_a_vented_vessel_expands_without_heat(
    gas: str, b: float, e: float, pressure: float, temperature: float, tmp_path: Path
) -> None:
    after = until_half_of_it_is_left(*covered(gas, b, e, tmp_path, p_start=P_START))
    v = R * 293.15 / 800e3 + b
    p = 800e3 * ((v - e * b) / (2 * v - e * b)) ** GAMMA
    assert after["tank.gas.p"] == pytest.approx(p, rel=1e-6)
    assert after["tank.gas.T"] == pytest.approx(p * (2 * v - b) / R, rel=1e-6)
    assert after["tank.gas.p"] == pytest.approx(pressure, abs=50)
    assert after["tank.gas.T"] == pytest.approx(temperature, abs=0.05)


@pytest.mark.parametrize("gas", GASES)
@pytest.mark.parametrize(
    ("p_start", "p_outside"), [(P_START, 0.0), (0.0, 600e3)], ids=("out", "in")
)
def test_energy_balances_with_the_enthalpy_of_such_a_gas(
    gas: str, p_start: float, p_outside: float, tmp_path: Path
) -> None:
    """U = p (V - e b m)/(gamma - 1); what flows has c_p T and, at the pressure inside, p b (gamma - e)/(gamma - 1)."""
    b, e = 7e-3, 0.6
    model, _ = covered(gas, b, e, tmp_path)
    own = {"tank.gas.b": b, "tank.gas.e": e, "tank.p_start": p_start, "p_outside": p_outside}

    def enthalpy(v: Values) -> float:
        more = v["tank.gas.p"] * b * (GAMMA - e) / (GAMMA - 1)
        return v["tank.port.H_flow"] + v["tank.port.m_flow"] * more

    def stored(v: Values) -> float:
        return (v["tank.gas.p"] * (v["tank.gas.V"] - e * b * v["tank.gas.m"])) / (GAMMA - 1)

    before, after, flowed, passed = model.ledger(
        10.0, enthalpy, model.inputs(), model.parameters(own), rtol=1e-9
    )
    assert passed > 1e3
    assert stored(after) - stored(before) == pytest.approx(flowed, abs=1e-7 * passed)
