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
    "wrong unit of a parameter": (
        TOML,
        '"16.2 l"',
        '"16.2 m"',
        ["experiment.toml:6", "tank.V", "m"],
    ),
    "unknown column": (CSV, HEAD, "time [s],q [kPa]", ["one.csv:1", "'q'"]),
    "text in a number": (CSV, THIRD, "2,much", ["one.csv:4", "'p'", "much"]),
    "time going back": (CSV, THIRD, "0.5,600", ["one.csv:4", "time"]),
    "NaN": (CSV, THIRD, "2,NaN", ["one.csv:4", "'p'"]),
    "infinite": (CSV, THIRD, "2,inf", ["one.csv:4", "'p'"]),
    "missing file": (CSV, None, None, ["one.csv"]),
    "empty file": (CSV, None, "", ["one.csv", "empty"]),
    "missing experiment": (TOML, None, None, ["experiment.toml"]),
    "empty experiment": (TOML, None, "", ["experiment.toml", "is missing"]),
    "not TOML": (TOML, "[fit]", "[fit", ["experiment.toml:9"]),
    "unknown bench": (
        TOML,
        "Benches.VesselOrifice",
        "Benches.VesselOriface",
        ["experiment.toml:2", "VesselOriface"],
    ),
    "unknown parameter": (TOML, '"tank.V"', '"tank.W"', ["experiment.toml:6", "tank.W"]),
    "unknown free parameter": (TOML, '"tank.n" = {', '"tank.m" = {', ["experiment.toml", "tank.m"]),
    "reversed bounds": (
        TOML,
        "min = 1.0, max = 1.4",
        "min = 1.4, max = 1.0",
        ["experiment.toml", "tank.n"],
    ),
    "path that leaves the folder": (
        TOML,
        '"one.csv"',
        '"../one.csv"',
        ["experiment.toml", "../one.csv"],
    ),
    "absolute path": (TOML, '"one.csv"', '"/etc/passwd"', ["experiment.toml", "/etc/passwd"]),
    "no run to fit": (TOML, 'role = "fit"', 'role = "holdout"', ["experiment.toml", "fit"]),
    "no runs": (TOML, '[[runs]]\nfile = "one.csv"\nrole = "fit"\n', "", ["experiment.toml", "run"]),
    "unknown role": (TOML, 'role = "fit"', 'role = "fitt"', ["experiment.toml", "role"]),
    "unknown signal": (TOML, "[signals.p]", "[signals.pp]", ["experiment.toml", "pp"]),
    "invisible character in the title": (
        TOML,
        "that empties",
        "that\\u001b[31m empties",
        ["experiment.toml:1", "x1b"],
    ),
    "line break in a name": (TOML, '"one.csv"', '"one\\n.csv"', ["experiment.toml", "not visible"]),
    "negative noise": (TOML, '"1 kPa"', '"-1 kPa"', ["experiment.toml:4", "sigma"]),
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
def test_what_is_no_data_set(
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
        (["simulate", "Vessel"], ["Vessel"]),
        (["simulate", "nothing.fmu"], ["nothing.fmu", "no such file"]),
        (["simulate", "nothing.mo"], ["nothing.mo"]),
        (["simulate", "TankFilling", "--set", "tank.W=1"], ["tank.W"]),
        (["simulate", "TankFilling", "--set", "tank.V"], ["NAME=VALUE"]),
        (["simulate", "TankFilling", "--set", "=3"], ["NAME=VALUE"]),
        (["simulate", "TankFilling", "--set", "tank.V=2 kg"], ["tank.V=2 kg"]),
        (["simulate", "TankFilling", "--set", "tank.V=nan"], ["finite"]),
        (["simulate", "TankFilling", "--set", "tank.V=-1"], ["between"]),
        (["simulate", "TankFilling", "--set", "tank.V=2 l 3"], ["tank.V=2 l 3"]),
        (["simulate", "TankFilling", "--stop-time", "-1"], ["end after its start"]),
        (["simulate", "TankFilling", "--stop-time", "0"], ["end after its start"]),
        (["simulate", "TankFilling", "--input", "none.csv"], ["none.csv"]),
        (["simulate", "TankFilling", "--input", "data/one.csv"], ["data/one.csv:1", "u_in"]),
        (["simulate", "TankFilling", "-o", "none/x.csv"], ["none/x.csv"]),
        (["simulate", "TankFilling", "--plot", "none/x.png"], ["none/x.png"]),
        (["sweep", "TankFilling", "--vary", "tank.V=1:2", "-o", "s.csv"], ["FROM:TO:N"]),
        (["sweep", "TankFilling", "--vary", "tank.V=1:2:0", "-o", "s.csv"], ["FROM:TO:N"]),
        (["sweep", "TankFilling", "--vary", "tank.V=1,x", "-o", "s.csv"], ["tank.V=1,x"]),
        (["sweep", "TankFilling", "--vary", "tank.V=", "-o", "s.csv"], ["NAME=FROM:TO:N"]),
        (["sweep", "TankFilling", "--vary", "a=1", "-o", "s.csv"], ["'a'"]),
        (
            ["sweep", "TankFilling", "--vary", "tank.n=1", "--vary", "tank.n=2", "-o", "s.csv"],
            ["twice"],
        ),
        (["sweep", "TankFilling", "--vary", "tank.n=1", "-o", "none/s.csv"], ["none/s.csv"]),
        (["compare", "data", "--model", "Nothing"], ["Nothing"]),
        (["compare", "data", "--model", "TankFilling"], ["experiment.toml"]),
        (["compare", "data", "--params", "none.json"], ["none.json"]),
        (["compare", "data", "--params", "data/one.csv"], ["data/one.csv:1", "not JSON"]),
        (["compare", "data", "--against", "none.json"], ["none.json"]),
        (["compare", "data", "--against", "data/one.csv"], ["data/one.csv:1", "not JSON"]),
        (["fit", "data", "--method", "magic"], ["magic", "least-squares"]),
        (["fit", "data", "-o", "none/p.json"], ["none/p.json"]),
        (["diagnose", "data", "--model", "any.fmu"], ["any.fmu"]),
        (["diagnose", "data", "--file", "none.mo"], ["none.mo"]),
        (["diagnose", "data", "--time-limit=-3 s"], ["time limit", "-3 s"]),
        (["diagnose", "data", "--time-limit", "20 kg"], ["time limit", "kg"]),
        (["diagnose", "data", "--time-limit", "soon"], ["time limit", "soon"]),
        (["add", "NoSuchEffect", "--to", "TankFilling", "-o", "x.mo"], ["NoSuchEffect"]),
        (["add", "EnergyGas", "--to", "Nothing", "-o", "x.mo"], ["Nothing"]),
        (["add", "EnergyGas", "--to", "TankFilling", "-o", "x.txt"], ["x.txt", ".mo"]),
        (["add", "EnergyGas", "--to", "TankFilling", "-o", "none/x.mo"], ["none/x.mo"]),
        (["add", "LinearBladder", "--to", "TankFilling", "-o", "x.mo"], ["LinearBladder"]),
        (["simulate", "TankFilling", "-o", "x.txt"], ["x.txt", ".csv or .nc or .parquet"]),
        (["simulate", "TankFilling", "-o", "valve.C_B"], ["valve.C_B", ".csv or .nc or .parquet"]),
        (["sweep", "TankFilling", "--vary", "tank.n=1", "-o", "s.xlsx"], ["s.xlsx", ".parquet"]),
        (["couple", "system.toml", "-o", "x.nc"], ["x.nc: this is written as CSV", ".csv"]),
        (["linearise", "TankFilling", "-o", "x.mat"], ["x.mat", "ends in .csv"]),
        (["diagnose", "data", "--next", "next.json"], ["next.json", "ends in .csv"]),
        (["plan", "data", "-o", "next.npz"], ["next.npz", "ends in .csv"]),
        (["predict", "data", "-o", "x.txt"], ["x.txt", "ends in .csv"]),
        (["build", "Nothing"], ["Nothing"]),
        (["effects", "--file", "none.mo"], ["none.mo"]),
    ],
    ids=lambda v: " ".join(v) if isinstance(v, list) else None,
)
def test_bad_words(
    command: Command, place: Path, data: Path, words: list[str], message: list[str]
) -> None:
    before = everything(place)
    refused(command(*words), message)
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
    refused(command("fit", "data"), ["experiment.toml", "nothing to fit"])


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
