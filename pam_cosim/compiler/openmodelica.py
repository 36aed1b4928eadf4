"""The flat model that OpenModelica makes of a class, in Base Modelica, which this compiler takes from there."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from pam_cosim.cache import cached_folder, digest
from pam_cosim.compiler.compile import found_class
from pam_cosim.compiler.hashing import flat_hash
from pam_cosim.errors import InputError, ModelError
from pam_cosim.processes.interrupts import run_tool

_PATIENCE = 300.0  # seconds
_ERROR = re.compile(
    r"(?:\[(?P<file>[^\]\n]*?):(?P<line>\d+):(?P<column>\d+)-[\d:]+\w*\] )?Error: (?P<what>.*)"
)


def flat_model(model: str, files: Sequence[Path] = ()) -> Path:
    """A file with the flat model, kept in the cache; its name is that of the class.

    Args:
        model: full name of a class, or a ``.mo`` file, of which the last class is taken.
        files: further Modelica files and folders of packages.

    Raises:
        InputError: OpenModelica is not installed.
        ModelError: there is no such class, or OpenModelica refuses it.
    """
    program = shutil.which("omc")
    if program is None:
        raise InputError(
            "OpenModelica's compiler omc is not on the path: install it, or leave --compiler out"
        )
    of, library = found_class(model, files=files)
    name, loaded = of.qualified_name, [node.source for node in library.top.values()]
    inserted = [node.source for node in library.inserted.values()]
    sources = dict.fromkeys(str(source.file) for source in (*reversed(loaded), *inserted))
    script = "".join(f"loadFile({_text(path)}, uses=false); " for path in sources)
    script += f'writeFile("flat.mo", instantiateModel({name})); getErrorString();'
    key = digest(program, script, flat_hash(model, files=files))

    def made() -> dict[str, bytes]:
        return {f"{of.name}.mo": _flat(program, script, name)}

    return cached_folder("flat", key, made) / f"{of.name}.mo"


def _flat(program: str, script: str, name: str) -> bytes:
    """What OpenModelica writes."""
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "flat.mos").write_text(script, encoding="utf-8")
        command = [program, "--baseModelica", "flat.mos"]
        try:
            ran = run_tool(command, Path(folder), os.environ, _PATIENCE)
        except subprocess.TimeoutExpired:
            text = f"OpenModelica takes more than {_PATIENCE:g} s to flatten {name}"
            raise ModelError(text) from None
        flat = Path(folder) / "flat.mo"
        content = flat.read_bytes() if flat.exists() else b""
        if not content.strip():
            raise _refusal(name, ran.stdout + ran.stderr)
        return content


def _refusal(name: str, output: str) -> ModelError:
    """The first of OpenModelica's errors, at its place."""
    error = _ERROR.search(output)
    what = error["what"] if error else "it gives no reason"
    text = f"OpenModelica refuses {name}: {what}"
    if error is None or error["file"] is None:
        return ModelError(text)
    return ModelError(text, error["file"], int(error["line"]), int(error["column"]))


def _text(path: str) -> str:
    return '"' + os.path.abspath(path).replace("\\", "/") + '"'
