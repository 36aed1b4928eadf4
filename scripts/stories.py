"""The two stories of the demo: a real vessel, and a muscle with an effect that its model does not know."""

import time
from pathlib import Path

import pam_cosim as pam
from pam_cosim.files import write_json
from pam_cosim.reporting import diagnosis_report, error_ladder_figure, write_report
from rig import measurement
from rig.named import effect_of
from rig.plan import default_plan

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "demo"
HIDDEN = "elasticity:exponential"  # a spring law that no effect of the catalogue has
HIDDEN_TITLE = "Six runs of a muscle on the simulated rig"


def tell(name: str, folder: Path, story: str, model: str) -> None:
    """Diagnoses one data set, leaves report, figures, numbers and the model that has the effect, and compares that."""
    print(f"\n=== {story}", flush=True)
    begin = time.perf_counter()
    data = pam.read(folder)
    diagnosis = pam.diagnose(data, say=lambda line: print(line, flush=True))
    print(diagnosis)
    write_report(OUTPUT / f"{name}.html", diagnosis_report(diagnosis))
    write_json(OUTPUT / f"{name}.json", diagnosis.as_dict())
    error_ladder_figure(diagnosis, OUTPUT / f"{name}.png")
    better = OUTPUT / f"{model}.mo"
    pam.add(diagnosis, output=better)
    print(f"\n--- the model of the data set, as it was\n{pam.compare(data)}")
    print(f"\n--- the model with what was found, demo/{better.name}\n{pam.compare(data, str(better))}")
    print(f"report: demo/{name}.html   ({time.perf_counter() - begin:.0f} s)")


def main() -> None:
    OUTPUT.mkdir(exist_ok=True)
    for bench in pam.benches():
        pam.build(bench, ROOT / "fmu" / "build" / f"{bench}.fmu")
    tell(
        "tank-discharge",
        ROOT / "examples" / "tank-discharge",
        "a real vessel: 16.2 L of air through a 2.71 mm hole",
        "Vessel",
    )
    folder = OUTPUT / "hidden-effect-data"
    measurement.write_data_set(
        folder, measurement.measure(default_plan(), [effect_of(HIDDEN)], seed=1), title=HIDDEN_TITLE
    )
    tell("hidden-effect", folder, "six runs of a muscle with a rubber bladder that its model leaves out", "Muscle")


if __name__ == "__main__":
    main()
