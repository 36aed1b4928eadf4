"""A small bench and a valid data set for it."""

from __future__ import annotations

from pam_cosim.errors import ModelError
from pam_cosim.model.interface import Interface, Variable

MODEL = "Rig.Benches.Isotonic"


def variables(*items: Variable) -> dict[str, Variable]:
    return {item.name: item for item in items}


BENCH = Interface(
    model=MODEL,
    inputs=variables(Variable("u_in", "A"), Variable("u_out", "A"), Variable("p_supply", "Pa")),
    outputs=variables(
        Variable("p", "Pa"), Variable("x", "m"), Variable("T", "K"), Variable("eps", "1")
    ),
    parameters=variables(
        Variable("valve.C_A", "1", start=0.7, min=0.1, max=2.0),
        Variable("load.m", "kg", start=2.0, min=0.0),
        Variable("muscle.mu_fb", "1", start=0.02),
        Variable("tank.T_start", "K", start=293.15),
        Variable("wall.h", "W/(m2.K)", start=8.0),
    ),
)

EXPERIMENT = """\
# A comment first.
title = "latex muscle, steps"
model = "Rig.Benches.Isotonic"

[signals.p]
sigma = "0.5 kPa"
[signals.x]
sigma = "0.2 mm"
[signals.T]
sigma = "0.5 degC"

[parameters]
"load.m" = "2.27 kg"
"tank.T_start" = "20 degC"
"muscle.mu_fb" = 0.015

[fit]
"valve.C_A" = { min = 0.5, max = 0.9 }
"muscle.mu_fb" = { min = 0, max = "10 %" }

[[runs]]
file = "run-01.csv"

[[runs]]
file = "run-02.csv"
role = "holdout"
interpolation = "previous"
[runs.parameters]
"load.m" = "5 kg"
"""

RUN_01 = """\
time [s],u_in [A],u_out [A],p_supply [kPa],p [kPa],x [mm],T [degC]
0,0,0.1,207,0,0.0,20
0.1,0,0.1,207,1.5,,20.5
0.1,0.35,0.1,207,1.6,0.1,
0.2,0.35,0.1,207,20,1.25,21
"""

RUN_02 = """\
time [ms],u_in [mA],u_out [A],p [bar],eps [%]
0,350,0,0,0
100,350,0,1,12.5
"""


def describe(model: str) -> Interface:
    if model != MODEL:
        raise ModelError(f"there is no class '{model}'")
    return BENCH
