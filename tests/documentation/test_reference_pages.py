"""The pages that list every key and every option name what the program has, and nothing else."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import typer

import pam_cosim as pam
from pam_cosim.cli.app import COMMANDS, app
from pam_cosim.comparison import Doubt
from pam_cosim.diagnosis import Diagnosis, FailedTrial
from pam_cosim.diagnosis.judgement.family_table import FamilyRow, FamilyTable
from pam_cosim.diagnosis.judgement.folds import Folds
from pam_cosim.diagnosis.judgement.posterior import Explanation, Posterior
from pam_cosim.diagnosis.planning.check import Check, Help
from pam_cosim.diagnosis.planning.hypothetical_measurements import Option
from pam_cosim.diagnosis.planning.identifiability import (
    ConfusedPair,
    DetectableEffect,
    Identifiability,
    ParameterPrecision,
)
from pam_cosim.files import json_text
from pam_cosim.fitting import Estimate, write_parameters
from pam_cosim.fitting.combinations import Combination
from pam_cosim.fitting.profile import Profile
from pam_cosim.measurement import experiment_tables
from pam_cosim.measurement.free_parameter import Prior
from pam_cosim.units import convert
from tests.documentation.pages import DOCS, source
from tests.fitting.models import vessel_data
from tests.reporting.synthetic import RULES, make_comparison, make_data, make_diagnosis, make_fit
from tests.reporting.test_ledger_learned_next import make_learned, make_ledger

NAMED = {
    "rms",
    "parameters",
    "signals",
    "balance",
    "outliers",
    "not_tried",
    "constants",
    "table",
    "units",
    "others",
    "values",
    "absent",
    "needed",
    "unbelievable",
    "worst",
    "families",
    "roles",
    "best_point",
    "starts",
    "profiles",
}
"""Keys of objects whose keys are names: of parameters, signals, effects, families, balances, runs or roles."""
NAMES = {"NAME", "SIGNAL", "EFFECT", "FAMILY", "BALANCE", "ROLE", "STATE", "RUN", "STATISTIC"}
PRIOR = Prior(0.7, 0.02, logarithmic=True)


def section(page: str, heading: str) -> str:
    """What stands below a heading of the second level, to the next one."""
    return source(f"{page}#{heading}")


def listed(text: str) -> set[str]:
    """The words in backticks of the first cells of all tables: of a path, each of its keys."""
    cells = re.findall(r"^\| ([^|]*) \|", text, re.MULTILINE)
    paths = [path for cell in cells for path in re.findall(r"`([^`]+)`", cell)]
    return {word for path in paths for word in re.split(r"[.@]|\[\]", path) if word}


def keys(content: Any, parent: str = "") -> Iterator[str]:
    """The keys of a JSON document, but for names."""
    if isinstance(content, list):
        for one in content:
            yield from keys(one, parent)
    elif isinstance(content, dict):
        is_named = parent in NAMED or (
            parent == "rmse" and "values" not in content
        )  # of folds, not of a table
        for key, value in content.items():
            if not is_named:
                yield key
            yield from keys(value, "" if is_named else key)


def as_json(product: Any) -> Any:
    return json.loads(json_text(product))


def diagnoses() -> list[Diagnosis]:
    """One that leaves rivals, and one that leaves structure, with all that either may have."""
    data = make_data()
    first = replace(data.runs[0], parameters={"load.m": 6.0}, replaced={"load.m": 2.27})
    data = replace(data, runs=(first, *data.runs[1:]))
    explained = Posterior((Explanation(("leak",), 0.0, 0.9),), 0.1, ("structure",))
    folds = Folds(2, {"StiffWall": 2}, {"tank.V/stated": 1.7}, {"p": 1.0}, {"p": (2.0, ("run-1",))})
    row = FamilyRow(("leak",), 0.9, ("LaminarLeak",), 0.5, {"p": 1.0})
    table = FamilyTable((row,), (row,), 0.1)
    made = [
        make_diagnosis("ambiguous", data, rivals=(("StiffWall",),)),
        make_diagnosis("unknown", data, learned=make_learned(data), ledger=make_ledger()),
    ]
    return [
        replace(
            one,
            convention="held commands fit the data much better",
            verdict=replace(one.verdict, posterior=explained, folds=folds, table=table),
        )
        for one in made
    ]


def checked() -> Check:
    known = ParameterPrecision("orifice.C_d", "1", 0.8, 0.02, 0.6)
    shown = DetectableEffect("LaminarLeak", "leak", 3.0, 0.5, {"G": 1.0}, {"G": 0.0}, {"G": "1"})
    found = Identifiability(
        (known,),
        (("orifice.C_d", "tank.n", 0.99),),
        (shown,),
        (ConfusedPair("LaminarLeak", "leak", "StorageWall", "wall_heat", 2.0),),
    )
    help_ = Help(Option("signal", "T in every run"), ("leak",), (("leak", "creep"),), (), 0.5)
    failed = FailedTrial("HotWall", "wall_heat", "energy", ("HotWall",), "no start value")
    warned = ("every run: the fibres do not fit",)
    return Check(make_data(), "M", found, ("creep",), (help_,), (failed,), warned)


def compared() -> dict[str, Any]:
    data = make_data()
    runs = [replace(run, parameters={"load.m": 2.0, "f": i}) for i, run in enumerate(data.runs)]
    comparison = make_comparison(replace(data, runs=tuple(runs)), 2.0)
    content = as_json(replace(comparison, where=RULES))
    content["runs"][0] |= {"start": "rest", "solver": ""}
    content["doubts"] = [as_json_of(Doubt("still", "p", "it never moves"))]
    return content | {"tables": [as_json(comparison.table("load.m", "f"))]}


def as_json_of(data_class: Any) -> Any:
    return json.loads(json_text(data_class))


def fitted() -> dict[str, Any]:
    fit = pam.fit(vessel_data(), method="particle-swarm")
    of_run = Estimate(0.7, 0.6, 0.8, "1", run="run-1", prior=PRIOR)
    pair = Combination(("a", "b"), "product", 1.0, 0.9, 1.1, "1")
    full = replace(
        fit,
        parameters={**fit.parameters, "a@run-1": of_run},
        starts={"p@run-1": of_run},
        combinations=(pair,),
    )
    points = np.array([0.7, 0.8])
    profile = Profile("a", "1", 0.7, points, np.zeros(2), 0.6, np.inf, {"b": points})
    content = as_json(full)
    del content["comparison"]  # as that of compare
    return content | {"comparison": {}, "profiles": {"a": as_json(profile)}}


def parameter_file(folder: Path) -> dict[str, Any]:
    write_parameters(folder / "fitted.json", make_fit(make_data(), 2.0))
    return json.loads((folder / "fitted.json").read_text())


def documents(folder: Path) -> dict[str, list[Any]]:
    """JSON by the heading of the section that describes it."""
    return {
        "`diagnose --json`": [as_json(one) for one in diagnoses()],
        "`fit --json`": [fitted()],
        "`fitted.json`, of `fit -o`": [parameter_file(folder)],
        "`compare --json`": [compared()],
        "`check --json`": [as_json(checked())],
    }


def test_every_key_of_the_json_is_on_its_page(tmp_path: Path) -> None:
    shared = listed(section("json.md", "What stands in several places"))
    seen: set[str] = set()
    for heading, contents in documents(tmp_path).items():
        own = listed(section("json.md", heading))
        there = {key for content in contents for key in keys(content)}
        assert there - own - shared == set(), heading
        assert own - there - NAMES - {"time", "learned"} - NAMED == set(), heading
        seen |= there
    assert shared - seen - {"run"} - NAMES == set()


TABLES = {
    "The top of the file": experiment_tables.Experiment,
    "`[signals.NAME]`": experiment_tables.SignalTable,
    "`[fit]`": experiment_tables.FreeTable,
    "`[recording]`": experiment_tables.RecordingTable,
    "`[columns]`": experiment_tables.ColumnTable,
    "`[effects]`": experiment_tables.EffectsTable,
    "`[[runs]]`": experiment_tables.RunTable,
    "`[[runs.loggers]]`": experiment_tables.LoggerTable,
}
WITHIN = {
    "`[fit]`": ("prior", experiment_tables.PriorTable),
    "`[columns]`": ("zero", experiment_tables.IntervalTable),
}


def keys_of(table: Any) -> set[str]:
    return {field.alias or name for name, field in table.model_fields.items()}


def test_every_table_of_the_experiment_is_on_the_page() -> None:
    tables = {one for one in vars(experiment_tables).values() if isinstance(one, type)}
    known = {one for one in tables if issubclass(one, experiment_tables.CheckedTable)}
    described = {*TABLES.values(), *(table for _, table in WITHIN.values())}
    assert known - described == {experiment_tables.CheckedTable}


@pytest.mark.parametrize("heading", TABLES)
def test_every_key_of_the_experiment_is_on_the_page(heading: str) -> None:
    expected = keys_of(TABLES[heading])
    if heading in WITHIN:
        expected |= keys_of(WITHIN[heading][1])
    text = section("experiment-toml.md", heading)
    if heading == "The top of the file":  # what is a table has a section of its own
        named = listed(text) | set(re.findall(r"`\[+([a-z]+)\]+`", text))
    else:
        named = listed(text)
    assert named == expected


def test_defaults_of_a_run() -> None:
    run = experiment_tables.RunTable(file="a.csv")
    text = section("experiment-toml.md", "`[[runs]]`")
    defaults = {"role": run.role, "interpolation": run.between_samples}
    for key, value in defaults.items():
        row = next(line for line in text.splitlines() if line.startswith(f"| `{key}`"))
        assert f'`"{value}"`' in row.split("|")[3]


PARAMETERS = {name: typer.main.get_command(app).commands[name].params for name in COMMANDS}  # type: ignore[attr-defined]


@pytest.mark.parametrize("name", COMMANDS)
def test_every_option_of_a_command_is_on_the_page(name: str) -> None:
    options = {
        word
        for one in PARAMETERS[name]
        if not getattr(one, "hidden", False)
        for word in (*one.opts, *one.secondary_opts)
        if word.startswith("-")
    }
    text = section("commands.md", name)
    rows = "".join(re.findall(r"^\| ([^|]*) \|", text, re.MULTILINE))
    also = "".join(re.findall(r"^Also: .*$", text, re.MULTILINE))
    assert set(re.findall(r"`(--?[a-z][\w-]*)", rows + also)) == options
    shared = section("commands.md", "Options of several commands")
    assert all(re.search(rf"\| `{word}[ `]", shared) for word in re.findall(r"`(--[\w-]+)`", also))


def test_every_command_is_on_the_page() -> None:
    text = (DOCS / "commands.md").read_text(encoding="utf-8")
    headings = re.findall(r"^## ([a-z]+)$", text, re.MULTILINE)
    assert sorted(headings) == sorted(COMMANDS)
    assert all(f"[`{name}`](#{name})" in text for name in COMMANDS)
    written = section("commands.md", "Files that are written")
    of_files = re.findall(r"`([a-z]+) (--?[a-z][\w-]*)", written)
    for name, option in of_files:
        assert option in {word for one in PARAMETERS[name] for word in one.opts}, (name, option)


def test_exit_statuses_are_on_the_page() -> None:
    rows = re.findall(r"^\| (\d+)", section("commands.md", "Exit statuses"), re.MULTILINE)
    assert rows == ["0", "1", "2", "130", "128"]


def test_units_of_the_page_are_read() -> None:
    rows = re.findall(
        r"^\| [^|]+ \| ([^|]+) \|$", section("experiment-toml.md", "Units"), re.MULTILINE
    )
    units = [unit.strip() for row in rows[1:] for unit in re.split("[,;]| or ", row)]
    assert len(units) > 80
    for unit in units:
        if unit != "nothing":
            convert(1.0, unit, unit)
