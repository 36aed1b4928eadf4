"""Attacks with seeded inputs for some minutes, and says what was tried, how often, and what failed.

``python -m tests.hostile.fuzz MINUTES [SEED]``. Each attack takes its turn until the time is over. An attack is a
function of a random generator and a folder: it returns how many inputs it tried, and raises what nothing may raise.
"""

from __future__ import annotations

import contextlib
import json
import os
import random
import subprocess
import sys
import tempfile
import time
import traceback
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from pam_cosim import study
from pam_cosim.errors import InputError
from pam_cosim.resources import modelica_root
from pam_cosim.units import UnitError, base_unit, convert, seconds
from pam_cosim.workbench.saved import checked_content
from tests.hostile.corpora import data_sets, models
from tests.hostile.judged import judged
from tests.hostile.mutations import mutated_bytes, mutated_document
from tests.hostile.reading import make

ROOT = Path(__file__).parents[2]
BATCH = 40  # inputs of a process
PATIENCE = 600.0  # s for a batch
STRANGE = ("(" * 50, ")", "1e999", "9" * 30, "0", "-1", "end", "{", "'", '"', "..", "/0")
UNITS = [
    *"abkmgPNs°Ω%_/*^()-+. ·",
    "**",
    "99",
    "in",
    "lambda",
    "degC",
    "delta_",
    "__class__",
    "e",
    "1e999",
    "\0",
]
Attack = Callable[[random.Random, Path], int]


def outcomes(module: str, folder: Path, *words: str) -> list[dict[str, Any]]:
    """What became of the inputs in a folder, in a process of its own."""
    return judged(module, folder, *words, patience=PATIENCE, quiet=False)


def edited(text: str, chance: random.Random) -> str:
    """A text with words exchanged, doubled, left out or nested."""
    words = text.split(" ")
    for _ in range(chance.choice((1, 2, 5, 20))):
        at, other = chance.randrange(len(words)), chance.randrange(len(words))
        match chance.randrange(6):
            case 0:
                words[at] = words[other]
            case 1:
                words[at:at] = words[other : other + chance.choice((1, 10, 100))]
            case 2:
                del words[at : at + chance.choice((1, 3))]
            case 3:
                words[at] = chance.choice(STRANGE)
            case 4:
                words[at] = words[at].replace("1", "100000000", 1)
            case _:
                words[at] = "".join(chance.sample(words[at], len(words[at])))
        words = words or [""]
    return " ".join(words)


def attack_compiler(chance: random.Random, folder: Path) -> int:
    """Models of the library and of the corpus, with their texts edited."""
    library = sorted(modelica_root().rglob("Benches/*.mo")) + sorted(
        modelica_root().rglob("Components/*.mo")
    )
    texts = [*models.REFUSED.values(), *models.TAKEN.values()]
    for number in range(BATCH):
        own = chance.random() < 0.5
        text = chance.choice(library).read_text() if own else chance.choice(texts)[:20_000]
        (folder / f"{number:03}.mo").write_text(
            edited(text, chance).replace("within", "// within", 1)
        )
    for told in outcomes("compiling", folder):
        assert told["end"] in ("compiled", "refused"), (
            told,
            (folder / f"{told['name']}.mo").read_text()[:2000],
        )
        assert float(str(told["seconds"])) < 30, told
    return BATCH


def attack_data(chance: random.Random, folder: Path) -> int:
    """Data sets with bytes of their files changed, and such of the corpus together."""
    good = {data_sets.E: data_sets.experiment().encode(), data_sets.R: data_sets.GOOD.encode()}
    small = [
        c
        for c in (*data_sets.REFUSED.values(), *data_sets.TAKEN.values())
        if not any(map(callable, c.values()))
    ]
    for number in range(BATCH):
        changes = dict(chance.choice(small)) if chance.random() < 0.3 else {}
        for name, content in good.items():
            given = changes.get(name, content)
            data = given.encode() if isinstance(given, str) else given
            if chance.random() < 0.7 and isinstance(data, bytes) and data:
                changes[name] = mutated_bytes(data, chance)
        make(folder / f"set-{number:03}", changes)
    for told in outcomes("reading", folder, chance.choice(("compare", "compare", "check"))):
        assert told["status"] in (0, 1, 2) and not told["defect"] and not told["new"], told
        assert float(str(told["seconds"])) < 30 and float(str(told["peak"])) < 2000, told
        assert "Traceback" not in str(told["said"]), told
    return BATCH


def attack_products(chance: random.Random, folder: Path) -> int:
    """Saved products with other bytes, documents and arrays."""
    from tests.hostile.test_saved_products import PRODUCTS, attack

    name = chance.choice(list(PRODUCTS))
    return attack(name, chance.random(), BATCH // 4, folder)[0]


def attack_studies(chance: random.Random, folder: Path) -> int:
    """Saved studies with something else in one place."""
    steps = json.loads((ROOT / "tests/hostile/corpora/saved_studies.json").read_text())
    level = {"rms": 1.0, "noise": 1.0, "chi2": None, "text": "1 mm", "noise_text": "1 mm"}
    content = {
        "format": "pam-cosim workbench 1", "model": "Isotonic", "effects": ["A"], "values": {"a": 1.0},
        "diagnosed": [], "milestone": "", "file": "A.mo", "roles": {"run-01": "fit"}, "fit": None, "diagnosis": None,
        "ladder": [{"label": "x", "fit": {"x": level}, "holdout": {}, "chi2_fit": 1.0, "chi2_holdout": None}],
        "steps": steps["taken"], "time": 1.0,
    }  # fmt: skip
    for _ in range(BATCH * 5):
        with contextlib.suppress(ValueError):  # which names what is wrong; nothing else may come
            checked_content(mutated_document(content, chance), {"Isotonic"})
        with contextlib.suppress(ValueError):
            step = mutated_document({"step": chance.choice(steps["taken"])}, chance).get("step")
            checked_content(content | {"steps": [step]}, {"Isotonic"})
    return BATCH * 5


def attack_stores(chance: random.Random, folder: Path) -> int:
    """Sweeps and fits that are stopped, their files damaged in between."""
    from tests.hostile.test_stores import attack, fitted, swept, whole

    tried = 0
    for one in (swept, fitted):
        reference = whole(one, folder)
        for _ in range(BATCH // 10):
            attack(one, chance, folder / f"{tried}", reference)
            tried += 1
    whole.cache_clear()
    return tried


def attack_systems(chance: random.Random, folder: Path) -> int:
    """Archives of SSP with other bytes, and with other texts in their description."""
    from tests.cosimulation.test_ssp import WIRE, archive, component, system

    for number in range(BATCH):
        text = system(component("a") + component("b"), WIRE)
        file = archive(folder / f"{number}.ssp", edited(text, chance) if number % 2 else text)
        if number % 2 == 0:
            file.write_bytes(mutated_bytes(file.read_bytes(), chance))
        with contextlib.suppress(InputError):
            study.read_system(file)
    return BATCH


def attack_units(chance: random.Random, folder: Path) -> int:
    """Texts in the place of units and quantities."""
    for _ in range(BATCH * 25):
        text = "".join(chance.choices(UNITS, k=chance.randint(1, 8)))
        for read in (lambda t: convert(1.0, t, "Pa"), base_unit, seconds):
            try:
                read(text)
            except UnitError:
                continue
    return BATCH * 25


def attack_page(chance: random.Random, folder: Path) -> int:
    """Commands that no page sends, before windows that listen."""
    from pam_cosim.workbench import Session
    from tests.hostile.test_protocol import attack

    with Session(make(folder / "data", {})) as session:
        told: list[object] = []
        ends = [session.subscribe(told.append).result(PATIENCE) for _ in range(50)]
        tried = attack(session, chance, 5 * BATCH)
        for end in ends:
            end()
        assert not any(isinstance(m, str) and "should not" in m for m in told)
    return tried


def attack_runtime(chance: random.Random, folder: Path) -> int:
    """The C runtime under sanitisers, as the tests have it, with another seed."""
    environment = os.environ | {"PAM_COSIM_FUZZ_SEED": str(chance.randrange(2**31))}
    command = [
        sys.executable,
        "-m",
        "pytest",
        "--full",
        "-q",
        "-p",
        "no:cacheprovider",
        "tests/fmu/test_fuzz.py",
    ]
    made = subprocess.run(
        command, capture_output=True, text=True, cwd=ROOT, env=environment, timeout=4 * PATIENCE
    )
    assert made.returncode in (0, 5), made.stdout[-3000:]
    return 1


ATTACKS: dict[str, Attack] = {
    "units": attack_units,
    "saved studies": attack_studies,
    "saved products": attack_products,
    "data sets": attack_data,
    "sweeps and fits": attack_stores,
    "systems": attack_systems,
    "commands of the page": attack_page,
    "the compiler": attack_compiler,
    "the C runtime": attack_runtime,
}


def main(minutes: float, seed: int) -> int:
    """The number of attacks in which something failed."""
    end, tried, failed = time.monotonic() + 60 * minutes, Counter[str](), Counter[str]()
    print(f"seed {seed}, {minutes:g} min", flush=True)
    turn = 0
    while time.monotonic() < end:
        for name, attack in ATTACKS.items():
            if time.monotonic() > end or (name == "the C runtime" and turn):
                continue
            with tempfile.TemporaryDirectory(prefix="pam-cosim-fuzz-") as folder:
                try:
                    tried[name] += attack(random.Random(f"{seed} {turn} {name}"), Path(folder))
                except InputError as problem:
                    print(f"{name}, turn {turn}: left uncaught: {problem}", flush=True)
                    failed[name] += 1
                except Exception:
                    print(f"{name}, turn {turn}:\n{traceback.format_exc()[-3000:]}", flush=True)
                    failed[name] += 1
        turn += 1
    for name in ATTACKS:
        print(f"{name}: {tried[name]} inputs, {failed[name]} of {turn} turns failed", flush=True)
    return sum(failed.values())


if __name__ == "__main__":
    sys.exit(1 if main(float(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 0) else 0)
