"""Makes the files of a release; ``./scripts/release`` calls it."""

from __future__ import annotations

import argparse
import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
import venv
from collections.abc import Sequence
from pathlib import Path

from scripts import repository
from scripts.releasing import licences, versions
from scripts.releasing.versions import ROOT

OUTPUT = ROOT / "dist"
TOOLS = ROOT / ".release-tools"
LOCKS = ROOT / "scripts" / "locks"
CHECKED = {
    "vendor.citation-file-format": ["CITATION.cff"],
    "vendor.github-workflows": [".github/workflows/*.yml"],
}


def run(*words: str | Path, place: Path = ROOT) -> None:
    """Runs a program; it must succeed."""
    print("+", *words, flush=True)
    subprocess.run([str(word) for word in words], cwd=place, check=True)


def tools() -> Path:
    """The folder of the tools' programs, in an environment of their own; PAM_COSIM_RELEASE_TOOLS names another one."""
    stated = os.environ.get("PAM_COSIM_RELEASE_TOOLS")
    home = Path(stated) if stated else TOOLS
    programs = home / ("Scripts" if os.name == "nt" else "bin")
    if not stated and not (programs / "twine").exists():
        venv.create(home, with_pip=False)
        python = [
            sys.executable,
            "-m",
            "pip",
            "--python",
            str(programs / "python"),
            "install",
            "--quiet",
        ]
        run(*python, "--requirement", LOCKS / "release.in")
    return programs


def committed(folder: Path) -> Path:
    """A copy of what is committed, and nothing else."""
    archive = folder / "committed.tar"
    run("git", "archive", "--output", archive, "HEAD")
    copy = folder / "copy"
    shutil.unpack_archive(archive, copy, filter="data")
    return copy


def not_committed() -> list[str]:
    """What keeps the commit from being what is here."""
    why = repository.missing()
    return [why] if why else [f"not committed: {line}" for line in repository.changed()]


def distributions(programs: Path, copy: Path, with_models: bool) -> None:
    """Wheel and source distribution, and whether an index would take them."""
    if with_models:
        run(sys.executable, "-m", "scripts.shipped_models", place=copy)
    # both from the copy: a wheel that is made from the source distribution would have no compiled models
    run(
        programs / "python",
        "-m",
        "build",
        "--no-isolation",
        "--sdist",
        "--wheel",
        "--outdir",
        OUTPUT,
        copy,
    )
    run(programs / "twine", "check", "--strict", *OUTPUT.glob("pam_cosim-*"))


def documents(programs: Path, copy: Path, version: str, with_site: bool) -> None:
    """What changed, what it is made of, under which licences, and the documentation."""
    (OUTPUT / "CHANGES.md").write_text(
        f"# pam-cosim {version}\n\n{versions.notes(version)}\n", encoding="utf-8"
    )
    (OUTPUT / "LICENCES.md").write_text(licences.page(LOCKS / "base.txt"), encoding="utf-8")
    bill = OUTPUT / f"pam-cosim-{version}.cdx.json"
    words = ["requirements", "--pyproject", copy / "pyproject.toml", "--mc-type", "application"]
    run(programs / "cyclonedx-py", *words, "--output-reproducible", "-o", bill, LOCKS / "base.txt")
    if with_site:
        os.environ["NO_MKDOCS_2_WARNING"] = "1"
        run(
            sys.executable,
            "-m",
            "mkdocs",
            "build",
            "--strict",
            "--site-dir",
            copy / "site",
            place=copy,
        )
        shutil.make_archive(
            str(OUTPUT / f"pam-cosim-{version}-documentation"), "zip", copy / "site"
        )


def checksums() -> None:
    """SHA-256 of every file, as ``sha256sum --check`` reads it."""
    files = sorted(file for file in OUTPUT.iterdir() if file.name != "SHA256SUMS")
    lines = (f"{hashlib.sha256(file.read_bytes()).hexdigest()}  {file.name}\n" for file in files)
    (OUTPUT / "SHA256SUMS").write_text("".join(lines), encoding="utf-8")


def main(words: Sequence[str]) -> int:
    """Returns the exit status."""
    parser = argparse.ArgumentParser(prog="./scripts/release", description=__doc__)
    parser.add_argument(
        "--set-version", metavar="VERSION", help="write it to every place that states it, and end"
    )
    parser.add_argument(
        "--without-models",
        action="store_true",
        help="no compiled models in the wheel: minutes less",
    )
    parser.add_argument("--without-site", action="store_true", help="no documentation as a site")
    asked = parser.parse_args(words)
    try:
        if asked.set_version:
            versions.set_version(asked.set_version)
            return 0
    except ValueError as problem:
        parser.error(str(problem))
    wrong = [*versions.faults(), *not_committed()]
    if wrong:
        print("no release can be made:", *wrong, sep="\n  ", file=sys.stderr)
        return 2
    programs, version = tools(), versions.version()
    for schema, patterns in CHECKED.items():
        files = [file for pattern in patterns for file in sorted(ROOT.glob(pattern))]
        run(programs / "check-jsonschema", "--builtin-schema", schema, *files)
    shutil.rmtree(OUTPUT, ignore_errors=True)
    OUTPUT.mkdir()
    with tempfile.TemporaryDirectory() as folder:
        copy = committed(Path(folder))
        distributions(programs, copy, not asked.without_models)
        documents(programs, copy, version, not asked.without_site)
    checksums()
    for file in sorted(OUTPUT.iterdir()):
        print(f"{file.stat().st_size / 1e6:8.2f} MB  dist/{file.name}")
    print("nothing was published")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
