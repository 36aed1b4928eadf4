"""Valve and gas in one FMU, muscle and load in another, and a controller in Python that lifts the load to 20 mm.

python examples/co-simulation/coupling.py [OUTPUT.csv]
"""

import sys

import pam_cosim as pam


@pam.controller(inputs={"x": "mm"}, outputs={"u_in": "mA", "u_out": "mA"}, interval="10 ms")
def lift(time, x):
    """Opens a valve the more, the further the load is from 20 mm; the valves begin to open at 145 mA."""
    u = 40 * (20 - x)
    return {"u_in": min(max(u, 0), 350), "u_out": min(max(-u, 0), 350)}


system = pam.couple(
    {"gas": "CoSimulation.ValveAndGas", "muscle": "CoSimulation.MuscleAndLoad", "lift": lift},
    [
        "gas.p -> muscle.p",
        "muscle.V -> gas.V",
        "muscle.V_flow -> gas.V_flow",
        "muscle.A -> gas.A",
        "muscle.x -> lift.x",
        "lift.u_in -> gas.u_in",
        "lift.u_out -> gas.u_out",
    ],
    {"muscle.load.m": "3 kg"},
)
print(system)

fixed = system.simulate(stop_time=1, step="1 ms")
chosen = system.simulate(stop_time=1, tolerance=1e-3)
for run in (fixed, chosen):
    print(f"{run}; the load is at {1e3 * run.trajectory['muscle.x'][-1]:.2f} mm")

if len(sys.argv) > 1:
    print(f"written: {chosen.trajectory.to_csv(sys.argv[1])}")
