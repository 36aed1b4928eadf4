"""A muscle is filled step by step until it has lifted its load by 30 mm, and then held there by hand.

python examples/co-simulation/stepping.py [OUTPUT.csv]
"""

import sys

import pam_cosim as pam

with pam.start("Isotonic", {"load.m": "5 kg"}) as rig:
    while rig.time < 10 and rig["x"] < 0.030:
        rig.step("10 ms", u_in="350 mA")
    lifted = rig.save()
    print(rig)

    rig.step(1, u_in=0)
    print(
        f"valves shut: {rig.readings}, length of the muscle {rig.read('muscle.braid.L', 'mm'):.1f} mm"
    )

    rig.restore(lifted)
    rig.step(1, u_in=0, u_out="300 mA")
    print(f"outlet opened instead: {rig.readings}")

    if len(sys.argv) > 1:
        print(f"written: {rig.trajectory.to_csv(sys.argv[1])}")
