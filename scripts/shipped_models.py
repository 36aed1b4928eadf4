"""Compiles every bench with every effect of the library into shipped/, which the wheel then carries; minutes.

python -m scripts.shipped_models [BENCH...]; of some benches alone: what is there of the others stays
"""

from __future__ import annotations

import json
import sys
import tempfile
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path

from pam_cosim.catalogue import benches, compose_on, effect_classes
from pam_cosim.compiler import (
    ClassTree,
    compile_model,
    flat_hash,
    library_hash,
    ode_bytes,
    read_library,
    read_structure,
)
from pam_cosim.compiler.names import last
from pam_cosim.errors import ModelError
from pam_cosim.files import write_bytes
from pam_cosim.fmu.odes import write_archives

SHIPPED = Path(__file__).resolve().parents[1] / "shipped"
INDEX = "index.json"  # of write_archives: the archive of each model


def models_of(
    tree: ClassTree, bench: str, effects: Sequence[str], library: str
) -> Iterator[tuple[str, bytes]]:
    """Key and content of the bench and of its compositions with one effect each."""
    yield flat_hash(bench, library=library), ode_bytes(compile_model(bench))
    structure = read_structure(bench)
    with tempfile.TemporaryDirectory() as folder:
        for effect in effects:
            composition = compose_on(tree, structure, [effect])
            if composition is None:
                continue
            file = Path(folder, f"{composition.name}.mo")
            file.write_bytes(composition.text.encode())
            try:
                ode = compile_model(composition.name, files=[file])
            except (
                ModelError
            ) as problem:  # a bench may lack the rate of an input; a diagnosis says so
                print(f"  {effect}: {problem.message}", file=sys.stderr)
                continue
            yield flat_hash(composition.name, files=[file], library=library), ode_bytes(ode)


def kept_index(archives: Collection[str]) -> dict[str, str]:
    """What the index has of other archives that are there."""
    file = SHIPPED / INDEX
    index: dict[str, str] = json.loads(file.read_bytes()) if file.exists() else {}
    return {
        key: name
        for key, name in index.items()
        if name not in archives and (SHIPPED / name).exists()
    }


def complete_index(kept: Mapping[str, str]) -> None:
    """Adds what is kept to the index, and removes the archives that it does not name."""
    file = SHIPPED / INDEX
    index = {**kept, **json.loads(file.read_bytes())}
    write_bytes(file, json.dumps(index).encode())
    for archive in SHIPPED.glob("*.xz"):
        if archive.name not in index.values():
            archive.unlink()


def main(names: Sequence[str]) -> int:
    """Writes the archives; returns the exit status."""
    tree, library = read_library(), library_hash()
    effects = [effect.name for effect in effect_classes(tree)]
    known = {last(bench): bench for bench in benches(tree)}
    unknown = [name for name in names if name not in known]
    if unknown:
        print(f"no bench: {', '.join(unknown)}; there are {', '.join(known)}", file=sys.stderr)
        return 2
    chosen = [bench for name, bench in known.items() if not names or name in names]
    archives = {}
    for bench in chosen:
        archives[f"{last(bench)}.xz"] = dict(models_of(tree, bench, effects, library))
        print(f"{last(bench)}: {len(archives[f'{last(bench)}.xz'])} models", flush=True)
    kept = kept_index(archives) if names else {}
    write_archives(SHIPPED, archives)
    complete_index(kept)
    size = sum(file.stat().st_size for file in SHIPPED.iterdir())
    print(f"{SHIPPED}: {size / 1e6:.2f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
