"""Compiles every bench with every effect of the library into shipped/, which the wheel then carries; minutes.

python -m scripts.shipped_models [BENCH...]
"""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Iterator, Sequence
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
from pam_cosim.fmu.odes import write_archives

SHIPPED = Path(__file__).resolve().parents[1] / "shipped"


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


def main(names: Sequence[str]) -> int:
    """Writes the archives; returns the exit status."""
    tree, library = read_library(), library_hash()
    effects = [effect.name for effect in effect_classes(tree)]
    chosen = [bench for bench in benches(tree) if not names or last(bench) in names]
    archives = {}
    for bench in chosen:
        archives[f"{last(bench)}.xz"] = dict(models_of(tree, bench, effects, library))
        print(f"{last(bench)}: {len(archives[f'{last(bench)}.xz'])} models", flush=True)
    write_archives(SHIPPED, archives)
    size = sum(file.stat().st_size for file in SHIPPED.iterdir())
    print(f"{SHIPPED}: {size / 1e6:.2f} MB")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
