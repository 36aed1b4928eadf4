"""Bad input: one line on stderr that says where, exit status 2, and nothing written."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

from tests.cli.conftest import EXPERIMENT, Outcome, everything, table
from tests.tiers import quick

Command = Callable[..., Outcome]

CSV, TOML = "one.csv", "experiment.toml"
HEAD = "time [s],p [kPa]"
THIRD = table().split("\n")[3]  # line 4, at 2 s

# name: file, text replaced (None: whole file), replacement (None: file removed), words of the message
FAULTS: dict[str, tuple[str, str | None, str | None, list[str]]] = {
    "wrong unit in a table": (CSV, HEAD, "time [s],p [kg]", ["one.csv:1", "'p'", "kg"]),
    "text in a number": (CSV, THIRD, "2,much", ["one.csv:4", "'p'", "much"]),
    "missing file": (CSV, None, None, ["one.csv"]),
    "empty experiment": (TOML, None, "", ["experiment.toml", "is missing"]),
    "not TOML": (TOML, "[fit]", "[fit", ["experiment.toml:9"]),
    "unknown parameter": (TOML, '"tank.V"', '"tank.W"', ["experiment.toml:6", "tank.W"]),
}
COMMANDS = ("compare", "fit", "diagnose")


def damage(data: Path, name: str) -> list[str]:
    file, old, new, words = FAULTS[name]
    path = data / file
    if new is None:
        path.unlink()
    elif old is None:
        path.write_text(new)
    else:
        text = path.read_text()
        assert old in text
        path.write_text(text.replace(old, new, 1))
    return words


def refused(outcome: Outcome, words: list[str]) -> None:
    assert outcome.status == 2
    assert outcome.err.startswith("pam-cosim: ") and outcome.err.endswith("\n")
    assert outcome.err.count("\n") == 1, outcome.err
    assert outcome.out == ""
    assert "Traceback" not in outcome.err
    for word in words:
        assert word in outcome.err, outcome.err


@pytest.mark.parametrize("name", FAULTS)
@pytest.mark.parametrize("verb", COMMANDS)
def test_damaged_data_set(command: Command, place: Path, data: Path, verb: str, name: str) -> None:
    (place.parent / "one.csv").write_text(table())
    words = damage(data, name)
    before = everything(place.parent)
    outputs = {
        "compare": ["--json", "r.json", "--report", "r.html"],
        "fit": ["--json", "r.json", "-o", "p.json"],
        "diagnose": ["--json", "r.json", "--report", "r.html"],
    }
    refused(command(verb, "data", *outputs[verb]), words)
    assert everything(place.parent) == before


@pytest.mark.parametrize("verb", quick(COMMANDS, COMMANDS[0]))
def test_whole_command_in_its_own_process(
    process: Command, place: Path, data: Path, verb: str
) -> None:
    words = damage(data, "text in a number")
    before = everything(place)
    refused(process(verb, data, "--json", place / "r.json"), words)
    assert everything(place) == before


@pytest.mark.parametrize("verb", COMMANDS)
@pytest.mark.parametrize("target", ["nowhere", "data/one.csv", "."])
def test_a_folder_without_a_data_set_is_refused(
    command: Command, place: Path, data: Path, verb: str, target: str
) -> None:
    refused(command(verb, target), ["experiment.toml"])


@pytest.mark.parametrize("option", ["--json", "--report"])
@pytest.mark.parametrize("verb", ["compare", "diagnose"])
@pytest.mark.parametrize("path", ["none/r.out", "data"])
def test_unwritable_output_is_found_before_the_work(
    command: Command, place: Path, data: Path, verb: str, option: str, path: str
) -> None:
    before = everything(place)
    refused(command(verb, "data", option, path), [path])
    assert everything(place) == before


@pytest.mark.parametrize(
    ("words", "message"),
    [
        ("simulate Vessel", ["Vessel"]),
        ("simulate nothing.fmu", ["nothing.fmu", "no such file"]),
        ("simulate TankFilling --set tank.W=1", ["tank.W"]),
        ("simulate TankFilling --set tank.V", ["NAME=VALUE"]),
        ("simulate TankFilling --set 'tank.V=2 kg'", ["tank.V=2 kg"]),
        ("simulate TankFilling --set tank.V=nan", ["finite"]),
        ("simulate TankFilling --stop-time -1", ["end after its start"]),
        ("simulate TankFilling --input none.csv", ["none.csv"]),
        ("simulate TankFilling --input data/one.csv", ["data/one.csv:1", "u_in"]),
        ("simulate TankFilling -o none/x.csv", ["none/x.csv"]),
        ("sweep TankFilling --vary tank.V=1:2 -o s.csv", ["FROM:TO:N"]),
        (
            "sweep TankFilling --vary tank.n=1 --vary tank.n=2 -o s.csv",
            ["twice"],
        ),
        ("compare data --model Nothing", ["Nothing"]),
        ("compare data --model TankFilling", ["experiment.toml"]),
        ("compare data --params none.json", ["none.json"]),
        ("compare data --params data/one.csv", ["data/one.csv:1", "not JSON"]),
        ("fit data --method magic", ["magic", "least-squares"]),
        ("diagnose data --model any.fmu", ["any.fmu"]),
        ("diagnose data --file none.mo", ["none.mo"]),
        ("diagnose data '--time-limit=-3 s'", ["time limit", "-3 s"]),
        ("add NoSuchEffect --to TankFilling -o x.mo", ["NoSuchEffect"]),
        ("add EnergyGas --to TankFilling -o x.txt", ["x.txt", ".mo"]),
        ("add LinearBladder --to TankFilling -o x.mo", ["LinearBladder"]),
        ("simulate TankFilling -o x.txt", ["x.txt", ".csv or .nc or .parquet"]),
        ("sweep TankFilling --vary tank.n=1 -o s.xlsx", ["s.xlsx", ".parquet"]),
        ("linearise TankFilling -o x.mat", ["x.mat", "ends in .csv"]),
        ("predict data -o x.txt", ["x.txt", "ends in .csv"]),
        ("build Nothing", ["Nothing"]),
        ("effects --file none.mo", ["none.mo"]),
    ],
    ids=lambda v: " ".join(v) if isinstance(v, list) else None,
)
def test_bad_words(
    command: Command, place: Path, data: Path, words: str, message: list[str]
) -> None:
    before = everything(place)
    refused(command(words), message)
    assert everything(place) == before


@pytest.mark.parametrize(
    "words", [["nonsense"], ["compare"], ["simulate", "TankFilling", "--stop-time", "soon"]]
)
def test_words_that_are_no_command(command: Command, place: Path, words: list[str]) -> None:
    outcome = command(*words)
    assert outcome.status == 2 and "Traceback" not in outcome.err and outcome.err


def test_fit_with_nothing_free(command: Command, place: Path, data: Path) -> None:
    (data / "experiment.toml").write_text(
        "\n".join(x for x in EXPERIMENT.split("\n") if "min =" not in x and x != "[fit]")
    )
    refused(command("fit data"), ["experiment.toml", "nothing to fit"])


SYNTAX = "model Own\n  Real x(start=1, fixed=true);\nequation\n  der(x) = -x +;\nend Own;\n"


@pytest.mark.parametrize(
    "words", [["simulate", "Own.mo"], ["build", "Own.mo"], ["compare", "data", "--model", "Own.mo"],
              ["diagnose", "data", "--model", "Own.mo"]],
    ids=" ".join,
)  # fmt: skip
def test_syntax_error_names_line_and_column(
    command: Command, place: Path, data: Path, words: list[str]
) -> None:
    (place / "Own.mo").write_text(SYNTAX)
    before = everything(place)
    refused(command(*words), ["Own.mo:4:16"])
    assert everything(place) == before
