"""FMUs of others: descriptions and archives that cannot be, and binaries that take what they find."""

from __future__ import annotations

import re
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from pam_cosim import study
from pam_cosim.cli.app import main
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fmu.compile import compile_library
from pam_cosim.fmu.platforms import native_platform
from pam_cosim.fmu.read import read_interface
from pam_cosim.processes.memory import MOST_MEMORY
from pam_cosim.simulation import IsolatedSimulator

DESCRIPTION = "modelDescription.xml"


def changed(source: Path, target: Path, pattern: str = "", by: str = "", extra: str = "") -> Path:
    """An FMU with something else in its description, or one more file."""
    with zipfile.ZipFile(source) as old, zipfile.ZipFile(target, "w") as new:
        for name in old.namelist():
            content = old.read(name)
            if name == DESCRIPTION and pattern:
                text, count = re.subn(pattern, by, content.decode(), count=1)
                assert count
                content = text.encode()
            new.writestr(name, content)
        if extra:
            new.writestr(extra, b"x")
    return target


@pytest.fixture(scope="module")
def fmu() -> Path:
    return study.build("TankFilling")


NUMBERS = {
    "a stop time of letters": (r'stopTime="[^"]*"', 'stopTime="abc"'),
    "a stop time that is none": (r'stopTime="[^"]*"', 'stopTime="nan"'),
    "a step size of letters": (r'stepSize="[^"]*"', 'stepSize="abc"'),
    "a start of letters": (r' start="[0-9.e+-]+"', ' start="abc"'),
    "a start of a million digits": (r' start="[0-9.e+-]+"', ' start="' + "9" * 1_000_000 + 'x"'),
    "a value reference beyond 32 bits": (r'valueReference="[0-9]+"', 'valueReference="4294967296"'),
    "a negative value reference": (r'valueReference="[0-9]+"', 'valueReference="-1"'),
    "a value reference of letters": (r'valueReference="[0-9]+"', 'valueReference="abc"'),
    "an earlier version": (r'fmiVersion="2.0"', 'fmiVersion="1.0"'),
    "no version": (r'fmiVersion="2.0"', ""),
    "an identifier that is a path": (
        r'modelIdentifier="[^"]*"',
        'modelIdentifier="../../../../../x"',
    ),
    "an identifier that is none": (r'modelIdentifier="[^"]*"', 'modelIdentifier="a b"'),
    "an index of no variable": (r'<Unknown index="[0-9]+"', '<Unknown index="0"'),
    "an index beyond the variables": (r'<Unknown index="[0-9]+"', '<Unknown index="99999"'),
    "two variables of one name": (r' name="tank.V"', ' name="p"'),
    "a name that turns letters": (r' name="p"', ' name="p\u202e"'),
    "entities in entities": (
        r"<fmiModelDescription",
        '<!DOCTYPE x [<!ENTITY a "' + "x" * 999 + '">]><fmiModelDescription',
    ),
    "no description": (r"(?s).*", ""),
}
NAMES = (
    "/etc/passwd",
    "../../escaped",
    "resources/../../../escaped",
    "C:\\x",
    "x" * 300,
    "a/" * 600 + "b",
    "a\x1bb",
)


@pytest.mark.parametrize("name", NUMBERS)
def test_descriptions_that_cannot_be(fmu: Path, tmp_path: Path, name: str) -> None:
    file = changed(fmu, tmp_path / "evil.fmu", *NUMBERS[name])
    try:
        read_interface(file)
        assert name == "entities in entities"
    except InputError as problem:
        assert problem.file == file and problem.message.isprintable() and len(problem.message) < 400


@pytest.mark.parametrize(
    "name", NAMES, ids=lambda name: name[:20].encode("unicode_escape").decode()
)
def test_archives_that_leave_their_folder(fmu: Path, tmp_path: Path, name: str) -> None:
    file = changed(fmu, tmp_path / "evil.fmu", extra=name)
    with pytest.raises(InputError, match="the archive has a file") as caught:
        read_interface(file)
    assert len(caught.value.message) < 200
    assert [p.name for p in tmp_path.iterdir()] == ["evil.fmu"]


COMMANDS_OF_TERMINALS = "\u009b31m\u0085\u202e\u2066\u200b"


def test_texts_that_command_a_terminal(
    fmu: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """What an FMU says of its model and variables is shown, and those letters are blank in it."""
    file = fmu
    for i, attribute in enumerate(("modelName", "description", "unit", "displayUnit")):
        file = changed(
            file, tmp_path / f"{i}.fmu", rf'(<.*[^ ]* {attribute}=")', rf"\1{COMMANDS_OF_TERMINALS}"
        )
    with zipfile.ZipFile(file) as archive:
        assert archive.read(DESCRIPTION).decode().count("\u202e") == 4
    for words in (["describe", str(file), "--all"], ["simulate", str(file), "--stop-time", "1"]):
        assert main(words) == 0
        said = "".join(capsys.readouterr())
        assert all(line.isprintable() for line in said.split("\n")), said


BINARIES = {
    "takes all memory": "for (;;) { char *p = malloc(1 << 24); if (p) memset(p, 1, 1 << 24); else abort(); }",
    "closes all files": "for (int i = 3; i < 256; i++) close(i);",
    "writes into all files": "for (int k = 0; k < 64; k++) for (int i = 3; i < 64; i++) write(i, text, sizeof text);",
    "writes to standard output": "for (int k = 0; k < 1000; k++) write(1, text, sizeof text);",
    "kills its parent": "kill(getppid(), 9);",
    "stops its parent": "kill(getppid(), SIGSTOP); pause();",
    "turns all files into the terminal": "for (int i = 0; i < 64; i++) if (i != 2) dup2(2, i);",
    "floods the terminal": 'for (int i = 0; i < 100000; i++) write(2, "\\x1b[31mred\\n", 9); _exit(0);',
    "ends": "_exit(0);",
    "crashes": "*(volatile int *)0 = 1;",
}


@pytest.mark.parametrize(
    "name",
    [
        pytest.param(name, marks=[pytest.mark.full] * (name == "takes all memory"))
        for name in BINARIES
    ],
)
@pytest.mark.skipif(not sys.platform.startswith("linux"), reason="signals and limits of Linux")
def test_binaries_that_take_what_they_find(
    fmu: Path, tmp_path: Path, name: str, capfd: pytest.CaptureFixture[str]
) -> None:
    """The harm is done when the library is loaded; the study goes on and says what happened."""
    code = (
        "#define _GNU_SOURCE\n#include <stdlib.h>\n#include <string.h>\n#include <unistd.h>\n#include <signal.h>\n"
        "static const char text[4096] = {1};\n"
        "__attribute__((constructor)) static void harm(void) { (void)text; "
        + BINARIES[name]
        + " }\n"
    )
    library = compile_library((), {"harm.c": code}, native_platform()).read_bytes()
    file = tmp_path / "evil.fmu"
    with zipfile.ZipFile(fmu) as old, zipfile.ZipFile(file, "w") as new:
        for entry in old.namelist():
            new.writestr(entry, library if entry.startswith("binaries/") else old.read(entry))
    with (
        IsolatedSimulator(file, 10.0) as simulator,
        pytest.raises((InputError, SimulationFailure)) as caught,
    ):
        simulator.run([0.0, 1.0])
    assert str(caught.value).isprintable() and "evil.fmu" in str(caught.value)
    assert capfd.readouterr().err.replace("\n", "").isprintable()
    left = (
        subprocess.run(["ps", "-eo", "args"], capture_output=True, text=True).stdout
        if Path("/bin/ps").exists()
        else ""
    )
    assert "evil.fmu" not in left
    assert MOST_MEMORY <= 2e9
