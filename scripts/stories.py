"""The two stories of the demo: a real vessel, and a muscle with an effect that its model does not know."""

import time
from pathlib import Path

import pam_cosim as pam
from pam_cosim.study.demonstration import demonstrate

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "demo"


def tell(name: str, folder: Path, story: str, model: str) -> None:
    """Diagnoses one data set, leaves report, figures, numbers and the model that has the effect, and compares that."""
    print(f"\n=== {story}", flush=True)
    begin = time.perf_counter()
    shown = demonstrate(folder, OUTPUT, name, model, say=lambda line: print(line, flush=True))
    print(shown.diagnosis)
    print(f"\n--- the model of the data set, as it was\n{shown.before}")
    print(f"\n--- the model with what was found, demo/{shown.model.name}\n{shown.after}")
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
    story = "six runs of a muscle with a rubber bladder that its model leaves out"
    tell("hidden-effect", ROOT / "examples" / "hidden-spring", story, "Muscle")


if __name__ == "__main__":
    main()
