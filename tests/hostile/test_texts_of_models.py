"""Whatever a Modelica file calls its variables or says of them is data: it becomes neither code, markup nor a path."""

from __future__ import annotations

import ctypes
import re
import zipfile
from collections.abc import Iterable
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.validation import validate_fmu
from lxml import etree

from pam_cosim import study
from pam_cosim.compiler import compile_model
from pam_cosim.errors import ModelError
from pam_cosim.fmu.c_text import c_string
from pam_cosim.fmu.compile import compile_library
from pam_cosim.fmu.generate import model_source
from pam_cosim.fmu.platforms import native_platform
from pam_cosim.simulation import Simulator
from pam_cosim.simulation.failure import RunFailure

# The first two would make a file when the library is loaded, where their text became C.
_CODE = (
    "int system(const char*);__attribute__((constructor)) void f(void)"
    "{char s[]={116,111,117,99,104,32,36,77,65,68,69,0};system(s);}"  # touch $MADE
)

NAMES = {
    "trigraph": f'??/"}};{_CODE}//',
    "quotation mark": f'"}};{_CODE}//',
    "backslash": '\\\\"};int puts(const char*);//',
    "backslash at the end": "a\\\\",
    "escapes": "\\n\\0\\x41\\'\\\"\\?",
    "all trigraphs": "??=??(??/??)??'??<??!??>??-".replace("'", "\\'"),
    "comment": "*/ int x; /* // ??/",
    "formats": "%s%s%s%n%n%100000000d",
    "line splice": "a??/",
    "directive": "#include </etc/passwd>",
    "digits behind an escape": 'ä"1234567',
    "other alphabets": "Länge 長さ длина 🐍",
    "markup": "<script>alert(1)</script> &amp; ]]> <!-- <![CDATA[",
    "console markup": "[bold red]x[/] [/nothing]",
    "mathematics": "$\\\\frac{$ x_$ ^",
    "path": "../../../../tmp/x",
    "dots": "a.b.c",
    "spaces": "  a  b ",
    "template": "{{7*7}} {% raw %} ${HOME} $(touch $MADE) `touch $MADE`",
    "number like": "1e9",
    "brackets": "x [kPa]",
    "comma": 'a,b;"c"',
    "the identity": "{00000000-0000-0000-0000-000000000000}",
    "long": "x" * 5000,
    "keyword": "end",
}

MODEL = """\
model {model} "{text}"
  parameter Real {p}(min=0, max=9) = 2 "{text}";
  input Real {u}(start=0);
  Real {x}(start=1, fixed=true, nominal=1) "{text}";
  output Real {y} = {x} + {u} "{text}";
  Real {z} = 2*{x};
equation
  assert({x} > 0.05, "{text}");
  der({x}) = -{p}*{x};
  annotation(experiment(StopTime=1, Interval=0.1));
end {model};
"""


def _write(folder: Path, name: str, text: str = "", others: Iterable[str] = ()) -> Path:
    """A model of which everything has this name; its further variables have others."""
    names = {key: f"'{key} {name}'" for key in ("model", "p", "u", "x", "y", "z")}
    head, end = MODEL.format(text=text, **names).split("equation\n")
    for other in others:
        head += f"  parameter Real 'q {other}' = 3;\n  Real 'w {other}'(start='q {other}', fixed=true);\n"
        end = f"  der('w {other}') = -'w {other}';\n{end}"
    file = folder / "Hostile.mo"
    file.write_text(f"{head}equation\n{end}", encoding="utf-8")
    return file


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv(
        "MADE", str(tmp_path / "made")
    )  # absolute: FMPy loads libraries in a folder of its own
    return tmp_path


@pytest.mark.parametrize(
    ("key", "fmi"),
    [
        *[(key, "2.0") for key in ("trigraph", "path", "markup", "template")],
        pytest.param("long", "2.0", marks=pytest.mark.full),
        pytest.param("trigraph", "3.0", marks=pytest.mark.full),
    ],
)
def test_names_come_back_as_they_are(key: str, fmi: str, place: Path) -> None:
    """Through compiler, C, model description and archive; nothing but the answer comes of them."""
    name, others = NAMES[key], [other for other in NAMES.values() if other != NAMES[key]]
    file = _write(place, name, others=others)
    path = study.build(str(file), place / "made.fmu", fmi=fmi)
    with zipfile.ZipFile(path) as archive:
        etree.fromstring(archive.read("modelDescription.xml"))
        assert all(
            len(entry) < 255 and ".." not in entry and entry.isascii()
            for entry in archive.namelist()
        )
    description = fmpy.read_model_description(str(path))
    assert description.modelName == f"'model {name}'"
    known = {v.name for v in description.modelVariables}
    assert {f"'{key} {name}'" for key in "puxyz"} <= known and f"der('x {name}')" in known
    assert {f"'{key} {other}'" for key in "qw" for other in others} <= known
    assert validate_fmu(str(path)) == []
    with Simulator(path) as simulator:
        assert list(simulator.interface.outputs) == [f"'y {name}'"]
        states = [f"'w {other}'" for other in others]
        run = simulator.run(
            np.linspace(0, 1, 11), parameters={f"'p {name}'": 1.5}, outputs=[f"'y {name}'", *states]
        )
        assert run[f"'y {name}'"][-1] == pytest.approx(np.exp(-1.5), rel=1e-5)
        assert [run[w][-1] for w in states] == pytest.approx(
            [3 * np.exp(-1)] * len(states), rel=1e-5
        )
        with pytest.raises(RunFailure) as caught:
            simulator.run([0.0, 1.0], parameters={f"'p {name}'": 0.0, f"'x {name}'": -1.0})
        assert "an assertion of the model fails" in str(caught.value)
    assert sorted(p.name for p in place.iterdir()) == ["Hostile.mo", "made.fmu"]


TEXTS = {
    "trigraph": '??/\\"};int system(const char*);//',
    "formats": "%s%n%s%n%s%n%100000000d",
    "markup": "</fmiModelDescription><script>alert(1)</script>&nonsense;",
    "control characters": "\\a\\b\\f\\v\x01\x02\x1f\ufffe",
    "lines": "one\\ntwo\nthree\\r\\tfour",
    "comment": "*/ int x; /*",
    "long": "ä" * 20000,
    "the identity": "{00000000-0000-0000-0000-000000000000}",
}


@pytest.mark.parametrize("text", TEXTS.values(), ids=TEXTS.keys())
def test_comments_and_messages_are_text(text: str, place: Path) -> None:
    file = _write(place, "n", text)
    ode = compile_model(str(file))
    path = study.build(str(file))
    description = fmpy.read_model_description(str(path))
    state = next(v for v in description.modelVariables if v.name == "'x n'")
    allowed = "".join(
        c if c in "\t\n\r" or (c >= " " and c != "\ufffe") else "\ufffd" for c in ode.description
    )
    assert description.description == state.description == allowed
    with (
        Simulator(path) as simulator,
        pytest.raises(RunFailure, match="an assertion of the model fails at time"),
    ):
        simulator.run([0.0, 9.0])


@pytest.mark.parametrize("character", ["\n", "\t", "\0", "\x1b", "\u202e", "\u200b", "\u2028"])
def test_names_that_cannot_be_seen_are_refused_with_their_place(
    character: str, place: Path
) -> None:
    file = place / "M.mo"
    file.write_bytes(f"model M\n  Real 'a{character}b' = 1;\nend M;\n".encode())
    with pytest.raises(ModelError, match="a name must not hold the character") as caught:
        compile_model(str(file))
    assert (caught.value.line, caught.value.column) == (2, 10)


def test_every_byte_survives_the_way_into_c(tmp_path: Path) -> None:
    """The compiler itself says what it makes of the literals; trigraphs on, as any other compiler may have them."""
    texts = ["".join(map(chr, range(1, 256))), "??/\"??'??=", "\\0\\x41", "é1", *NAMES.values()]
    literals = ", ".join(map(c_string, texts))
    visible = '__attribute__((visibility("default")))'
    source = f"{visible} const char *const texts[] = {{{literals}}};"
    library = ctypes.CDLL(str(compile_library((), {"texts.c": source}, native_platform())))
    compiled = (ctypes.c_char_p * len(texts)).in_dll(library, "texts")
    assert [f.decode() for f in compiled if f is not None] == texts
    assert "??" not in literals


def test_source_of_a_hostile_model_holds_no_text_of_it(place: Path) -> None:
    source = model_source(
        compile_model(str(_write(place, NAMES["trigraph"], "*/ int x; /*"))), "{1}"
    )
    outside = re.sub(r'"[^"]*"', "", source)
    assert "??" not in source and "system" not in outside and "int x" not in outside
