"""Writes the files of this version that later ones must read: ``python -m tests.saved.write`` once for each release.

A folder that is there already is never written again: what lies in it was promised to be read.
"""

from __future__ import annotations

import shutil
import sys
from dataclasses import replace
from importlib.metadata import version
from pathlib import Path

import pam_cosim as pam
from pam_cosim.files import write_json
from pam_cosim.fitting import write_parameters
from tests.reporting.synthetic import make_comparison, make_data, make_diagnosis, make_fit
from tests.reporting.test_ledger_learned_next import make_learned, make_ledger

HERE = Path(__file__).parent
ROOT = HERE.parents[1]


def main() -> int:
    """Makes the folder of the version that is installed; returns the exit status."""
    folder = HERE / version("pam-cosim")
    if folder.exists():
        print(f"{folder} is there already, and stays as it is", file=sys.stderr)
        return 2
    folder.mkdir()
    data = make_data()
    learned, ledger = make_learned(data), make_ledger()
    vessel = pam.read(ROOT / "examples" / "tank-discharge")
    fit, swarm = pam.fit(vessel), pam.fit(vessel, method="particle-swarm")
    products = {
        "comparison": make_comparison(data, 2.0),
        "fit": make_fit(data, 2.0),
        "vessel-fit": replace(fit, linear=None),
        "swarm-fit": replace(swarm, linear=None),
        "ledger": ledger,
        "ambiguous": make_diagnosis("ambiguous", data),
        "unknown": make_diagnosis("unknown", data, learned=learned, ledger=ledger),
        "trajectory": pam.simulate("VesselOrifice", stop_time=1.0, interval=0.1),
        "linear-model": pam.linearise("VesselOrifice", at=1.0),
    }
    for name, product in products.items():
        pam.save(product, folder / f"{name}.npz")
        if hasattr(product, "as_dict"):
            write_json(folder / f"{name}.json", product.as_dict())
    write_parameters(folder / "fitted.json", fit)
    write_parameters(folder / "fitted.ssv", fit)
    write_json(
        folder / "compared.json",
        pam.compare(vessel).as_dict(),
    )
    shutil.copytree(
        ROOT / "examples" / "tank-discharge",
        folder / "data-set",
        ignore=shutil.ignore_patterns("carried-on", "*.py"),
    )
    return 0


if __name__ == "__main__":
    sys.exit(main())
