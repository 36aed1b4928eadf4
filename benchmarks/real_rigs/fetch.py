"""Fetches recordings of others and converts them into data sets, in a folder outside the repository.

    python -m benchmarks.real_rigs.fetch FOLDER [--mirror FOLDER] [--sums]

Needs git and a network, or ``--mirror``, a folder with a git directory ``OWNER+NAME`` for each source. Every file that
is read is checked against ``SHA256SUMS``; ``--sums`` prints the sums of what is there instead. Nothing that is written
belongs into a repository: see the terms that are printed.
"""

from __future__ import annotations

import argparse
import hashlib
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path

from benchmarks.real_rigs import at_hand, fluidic, hoses
from benchmarks.real_rigs.folders import Rig, write_rig
from benchmarks.real_rigs.sources import HOSES, MUSCLES, FetchError, Store, opened

LEAKING = (1, 2, 4, 5, 6, 7)


def rigs(hose: Store, muscle: Store, bench: str) -> Iterator[Rig]:
    """All rigs, the repeats of the verdict among them."""
    yield from (at_hand.robot(name) for name in at_hand.JUMPS)
    yield from (at_hand.vessel(), at_hand.chamber(), at_hand.printed_map())
    yield from (hoses.rig(hose, length) for length in range(8, 1, -1))
    yield fluidic.isometric(muscle, bench)
    yield fluidic.isometric(muscle, bench, (4, 8), "muscle-repeat")
    yield fluidic.static_map(muscle)
    yield from (fluidic.leak(muscle, n) for n in LEAKING)


def used(store: Store, folders: Sequence[str]) -> list[str]:
    """The files of a source that are read."""
    starts = ("tube_l", "20mm_30cm_", "20mm_40cm_", "Experiment")
    return [
        p for f in folders for p in store.paths(f) if p.removeprefix(f"{f}/").startswith(starts)
    ]


def print_sums(stores: Sequence[tuple[Store, Sequence[str]]]) -> None:
    """SHA-256 sums of all that may be read, as ``sha256sum`` writes them."""
    for store, folders in stores:
        for path in used(store, folders):
            value = hashlib.sha256(store.content(path)).hexdigest()
            print(f"{value}  {store.source.slug}/{path}")


def main() -> int:
    """Exit status 2 where something is missing or is not what was used here."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--mirror", type=Path)
    parser.add_argument("--sums", action="store_true")
    asked = parser.parse_args()
    asked.folder.mkdir(parents=True, exist_ok=True)
    try:
        hose, muscle = (opened(s, asked.folder / "sources", asked.mirror) for s in (HOSES, MUSCLES))
        if asked.sums:
            print_sums([(hose, [hoses.FOLDER]), (muscle, fluidic.FOLDERS)])
            return 0
        for rig in rigs(hose, muscle, isometric_bench()):
            write_rig(asked.folder, rig)
            print(f"{rig.name}: {sum(len(r) for r in rig.runs.values())} runs")
    except (FetchError, ValueError) as error:
        print(f"fetch: {error}", file=sys.stderr)
        return 2
    for source in (HOSES, MUSCLES):
        print(f"{source.owner}/{source.name}: {source.terms}")
    return 0


def isometric_bench() -> str:
    """The rig of the fluidic muscles, put together from parts of the library."""
    import pam_cosim as pam

    return pam.bench("imposed-pressure", "imposed-length", measure="F")


if __name__ == "__main__":
    sys.exit(main())
