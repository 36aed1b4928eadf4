"""Recordings that are dropped: what is recognised, what is wrong at its cell, and the data set in the end."""

from __future__ import annotations

import codecs
import math
from collections.abc import Iterator
from pathlib import Path

import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.workbench import Workbench, drop
from pam_cosim.workbench.paths import free_name, inside, is_name_here, safe_name
from tests.workbench.conftest import PATIENCE, Window


@pytest.fixture
def window(tmp_path: Path) -> Iterator[Window]:
    with Workbench(tmp_path / "new-rig") as workbench:
        yield Window(workbench)


def put(window: Window, name: str, content: bytes) -> None:
    window.session.put(name, content).result(PATIENCE)


def test_a_folder_that_is_not_there_is_where_recordings_are_dropped(
    window: Window, recorded: Path
) -> None:
    assert window.last("study")["state"] == "drop" and window.last("dropped")["files"] == []
    put(window, "run-01.csv", (recorded / "run-01.csv").read_bytes())
    (file,) = window.last("dropped")["files"]
    assert file["name"] == "run-01.csv" and file["lines"][0].startswith("time")
    with pytest.raises(InputError, match="drop recordings first"):
        window.do(do="fit")
    window.do(do="remove", names=["run-01.csv"])
    assert window.last("dropped")["files"] == []
    window.do(do="draft")
    assert "at least one" in window.last("draft")["failed"]["text"]
    assert not window.session.folder.exists()


def test_what_is_wrong_is_shown_at_its_cell(window: Window, recorded: Path) -> None:
    lines = (recorded / "run-01.csv").read_text().splitlines()
    cells = lines[20].split(",")
    lines[20] = ",".join([*cells[:4], "soft", *cells[5:]])
    put(window, "run-01.csv", "\n".join(lines).encode())
    window.do(do="draft")
    draft = window.last("draft")
    failed, excerpt = draft["failed"], draft["excerpt"]
    assert (
        "'soft' is not a number" in failed["text"]
        and failed["line"] == 21
        and failed["file"] == "run-01.csv"
    )
    assert excerpt["line"] == 21
    assert excerpt["lines"][excerpt["line"] - excerpt["first"]].split(",")[4] == "soft"
    with pytest.raises(InputError, match="soft"):
        window.do(do="create")
    assert not window.session.folder.exists()


@pytest.mark.full
def test_it_ends_as_a_data_set_as_if_written_by_hand(window: Window, recorded: Path) -> None:
    for name in ("run-01", "run-02"):
        put(window, f"{name}.csv", (recorded / f"{name}.csv").read_bytes())
    wishes = {
        "title": "<b>mine</b>",
        "parameters": {"load.m": "2.27 kg"},
        "roles": {"run-02": "holdout"},
    }
    window.do(do="draft", wishes=wishes)
    draft = window.last("draft")
    assert (
        draft["failed"] is None
        and draft["model"].endswith("Isotonic")
        and draft["guesses"]
        and draft["to_check"]
    )
    assert [run["role"] for run in draft["runs"]] == ["fit", "holdout"] and "load.m" in draft[
        "toml"
    ]
    assert {n["name"] for n in draft["names"] if n["input"]} >= {"u_in", "u_out"}
    assert all(math.isfinite(v) for v in draft["curves"][0]["values"])
    assert not window.session.folder.exists()
    window.do(do="create", wishes=wishes)
    assert (
        window.last("study")["state"] == "open" and window.last("study")["title"] == "<b>mine</b>"
    )
    assert {header["kind"] for header, _ in window.frames} == {"measured", "model"}
    data = pam.read(window.session.folder)
    assert {run.name: run.role for run in data.runs} == {"run-01": "fit", "run-02": "holdout"}
    assert data.parameters["load.m"] == 2.27 and data.title == "<b>mine</b>"
    assert (window.session.folder / "experiment.toml").read_text() == draft["toml"]
    window.do(do="set", values={"valve.C_A": 0.7})
    assert window.last("scores")["values"]["valve.C_A"] == 0.7


def test_where_a_recording_begins_is_said_first(window: Window, recorded: Path) -> None:
    """Before anything is made of it; the model cannot say it by itself."""
    head, *rows = (recorded / "run-01.csv").read_text().splitlines()
    put(window, "run-01.csv", "\n".join([head, *rows[55:]]).encode())
    put(window, "run-02.csv", (recorded / "run-02.csv").read_bytes())
    window.do(do="draft", wishes={"parameters": {"load.m": "2.27 kg"}})
    (said, likewise) = window.last("draft")["starts"]
    assert said.startswith("run-01 begins at 47.1 kPa") and said.endswith(": estimated")
    assert likewise.startswith("run-02 begins at ") and likewise.endswith(
        ": estimated, as others are"
    )
    window.do(do="create")
    (start, other) = window.last("starts")["runs"]
    assert (start["mode"], start["text"], start["warning"]) == ("estimated", said, False)
    assert (other["mode"], other["text"]) == ("estimated", likewise)
    later = Window(window.session)
    assert not later.of("dropped") and not later.of("draft")


@pytest.mark.parametrize(
    "wishes",
    [{"columns": {"p": "no such column"}}, {"roles": {"run-09": "fit"}}, {"roles": {"run-01": "judge"}},
     {"model": "NoSuchBench"}, {"model": "../x.mo"}, {"folder": "/"}, {"parameters": {"load.m": "2.27"}},
     {"columns": ["p"]}, {"recording": {"decimal": "!"}}, {"title": 3}],
)  # fmt: skip
def test_wishes_that_cannot_be_met_are_answered_in_words(
    window: Window, recorded: Path, wishes: dict
) -> None:
    put(window, "run-01.csv", (recorded / "run-01.csv").read_bytes())
    window.do(do="draft", wishes=wishes)
    assert window.last("draft")["failed"]["text"]
    assert not window.session.folder.exists()


@pytest.mark.parametrize(
    "content",
    [
        b"",
        b"\x00\x01\x02",
        b"hello",
        b"time,p\n",
        b"time [s],p [kPa]\n1,2\n0,1\n",
        b"<script>alert(1)</script>",
    ],
)
def test_whatever_is_dropped_is_answered_in_words(window: Window, content: bytes) -> None:
    put(window, "odd.csv", content)
    window.do(do="draft")
    assert window.last("draft")["failed"]["text"]


@pytest.mark.parametrize("encoding", ["utf-8", "utf-8-sig", "cp1252", "utf-16", "utf-16-be"])
def test_letters_are_shown_as_the_file_has_them(window: Window, encoding: str) -> None:
    mark = codecs.BOM_UTF16_BE if encoding == "utf-16-be" else b""
    put(window, "Messung.csv", mark + "Zeit [s];Länge [mm];T [°C]\n0;1;20\n".encode(encoding))
    (file,) = window.last("dropped")["files"]
    assert file["lines"][0].split(";") == ["Zeit [s]", "Länge [mm]", "T [°C]"]


def test_no_letter_is_cut_where_a_file_is_long(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(drop, "_BYTES", 21)
    for encoding in ("utf-8", "cp1252", "utf-16"):
        (tmp_path / "run.csv").write_bytes("ä;b\n1;ö\n2;ö\n3;ö\n".encode(encoding))
        assert drop._lines(tmp_path / "run.csv")[:2] == ["ä;b", "1;ö"]


@pytest.mark.parametrize(
    ("name", "made"),
    [("run.csv", "run.csv"), ("../../etc/passwd", "passwd"), ("C:\\data\\run 1.csv", "run 1.csv"),
     (".hidden", "hidden"), ("Messung_ä(1).csv", "Messung_ä(1).csv"), ("a\nb.csv", "a_b.csv"), ("<b>.csv", "_b_.csv"),
     ("実験1.csv", "実験1.csv"), ("a\u0308.csv", "ä.csv"),
     (40 * "実" + ".csv", 32 * "実" + ".csv"), ("\ud800.csv", "_.csv")],
)  # fmt: skip
def test_names_become_names_of_files(name: str, made: str, tmp_path: Path) -> None:
    assert safe_name(name) == made and inside(tmp_path, safe_name(name)).parent == tmp_path


@pytest.mark.parametrize("name", ["", "..", "/", "   ", "..."])
def test_what_is_no_name_is_refused(name: str) -> None:
    with pytest.raises(InputError):
        safe_name(name)


def test_a_folder_with_other_things_is_refused(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="experiment.toml"):
        Workbench(tmp_path)


def test_what_was_said_wrong_can_be_said_otherwise(window: Window, recorded: Path) -> None:
    """The fields stay below the message, of the bench that is asked for."""
    put(window, "run-01.csv", (recorded / "run-01.csv").read_bytes())
    window.do(do="draft", wishes={})
    good = window.last("draft")
    window.do(do="draft", wishes={"columns": {"p": "no such column"}, "title": "mine"})
    bad = window.last("draft")
    assert bad["failed"]["text"] and not bad["toml"] and not bad["curves"]
    for key in ("model", "names", "parameters", "runs", "benches"):
        assert bad[key] == good[key] != []
    window.do(do="draft", wishes={"model": "Isometric", "columns": {"F": "no such column"}})
    other = window.last("draft")
    assert other["model"] == "Isometric" and "F" in {n["name"] for n in other["names"]}
    window.do(do="remove", names=["run-01.csv"])
    put(window, "odd.csv", b"hello")
    window.do(do="draft", wishes={})
    first = window.last("draft")
    assert first["names"] == [] and first["benches"] == good["benches"]


def test_a_draft_that_cannot_be_simulated_keeps_fields_and_evidence(
    window: Window, recorded: Path
) -> None:
    """A draw wire that reads 312 mm at rest: what is recognised stays beside the question."""
    head, *rows = (recorded / "run-01.csv").read_text().splitlines()
    place = next(i for i, name in enumerate(head.split(",")) if name.startswith("x "))
    cells = [row.split(",") for row in rows]
    for row in cells:
        row[place] = str(312 - float(row[place]))
    put(window, "run-01.csv", "\n".join([head, *map(",".join, cells)]).encode())
    window.do(do="draft", wishes={})
    draft = window.last("draft")
    assert "which reading is zero" in draft["failed"]["text"]
    assert draft["columns"]["x"]["formula"].startswith("-")
    assert all(draft[key] for key in ("names", "parameters", "runs", "guesses", "curves", "toml"))
    with pytest.raises(InputError, match="which reading is zero"):
        window.do(do="create", wishes={})
    assert not window.session.folder.exists()
    window.do(do="draft", wishes={"columns": {"x": '"312 mm" - x'}})
    assert window.last("draft")["failed"] is None


def test_a_column_of_another_kind_is_refused_by_its_name(window: Window, recorded: Path) -> None:
    put(window, "run-01.csv", (recorded / "run-01.csv").read_bytes())
    window.do(do="draft", wishes={"columns": {"p": "x"}})
    said = window.last("draft")["failed"]["text"]
    assert "column 'x' cannot be taken for p" in said and "mm" in said


def test_names_that_become_alike_are_numbered(window: Window) -> None:
    put(window, "F↑.csv", b"a [mm]\n1\n")
    put(window, "F↓.csv", b"b [mm]\n1\n")
    put(window, "F↑.csv", b"c [mm]\n1\n")  # the same once more replaces
    files = {f["name"]: f["lines"][0] for f in window.last("dropped")["files"]}
    assert files == {"F_.csv": "c [mm]", "F_-2.csv": "b [mm]"}
    window.do(do="remove", names=["F_.csv"])
    put(window, "f_.CSV", b"d [mm]\n1\n")
    assert {f["name"] for f in window.last("dropped")["files"]} == {"f_.CSV", "F_-2.csv"}


def test_a_numbered_name_is_one_that_a_file_here_may_have() -> None:
    long = "a" * 96 + ".csv"
    assert is_name_here(free_name(long, [long])) and free_name("b", ["B", "b-2"]) == "b-3"


def test_each_question_has_a_field_with_what_is_taken_until_it_is_answered(
    window: Window, recorded: Path
) -> None:
    text = (recorded / "run-01.csv").read_text()
    put(window, "run-01.csv", text.replace("p [kPa]", "Druck [kPa]", 1).encode())
    window.do(do="draft", wishes={"parameters": {"muscle.L0": "250 mm"}})
    draft = window.last("draft")
    assert draft["columns"]["p"] == {"column": "Druck"}
    assert draft["stated"]["muscle.L0"] == "250 mm"
    by_name = {p["name"]: p for p in draft["parameters"]}
    assert by_name["muscle.L0"]["geometry"] and not by_name["ambient.T"]["geometry"]
    assert {part["role"] for part in draft["parts"]} >= {"muscle", "pneumatics", "mechanics"}


def test_what_cannot_be_opened_leaves_nothing_that_blocks_the_next_try(
    window: Window, recorded: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    put(window, "run-01.csv", (recorded / "run-01.csv").read_bytes())
    window.do(do="draft")
    monkeypatch.setattr(window.session, "_session", _fails)
    with pytest.raises(SimulationFailure, match="too small"):
        window.do(do="create")
    assert "too small" in window.last("draft")["failed"]["text"]
    assert window.last("draft")["names"] and not window.session.folder.exists()
    monkeypatch.undo()
    window.do(do="create")
    assert window.last("study")["state"] == "open"


def _fails(complete: bool) -> None:
    raise SimulationFailure("the solver's step became too small")


def test_a_folder_of_other_files_is_no_place_for_a_data_set(tmp_path: Path) -> None:
    (tmp_path / "notes.txt").write_text("mine")
    with pytest.raises(InputError, match="there is no experiment.toml among the files.*NEW-FOLDER"):
        Workbench(tmp_path)
