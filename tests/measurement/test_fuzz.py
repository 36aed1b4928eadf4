"""Whatever bytes the files hold, reading ends in a data set or in one InputError."""

from __future__ import annotations

import tempfile
from pathlib import Path

from hypothesis import given, settings
from hypothesis import strategies as st

from pam_cosim.errors import InputError
from pam_cosim.measurement import DataSet, read_data_set
from tests.measurement.bench import EXPERIMENT, MODEL, RUN_01, RUN_02, describe
from tests.measurement.test_columns import COLUMNS
from tests.measurement.test_columns import LAB as LINES

FILES = {"experiment.toml": EXPERIMENT, "run-01.csv": RUN_01, "run-02.csv": RUN_02}
TOKENS = [
    b"",
    b"\n",
    b",",
    b";",
    b'"',
    b"'",
    b"[",
    b"]]",
    b"=",
    b"{",
    b"}",
    b"\x00",
    b"\xff",
    b"\r",
    b"#",
    b"nan",
]
TOKENS += [
    b"1e999",
    b"-",
    b"..",
    b"/",
    b"\xef\xbb\xbf",
    b"[s]",
    b"degC",
    b"9**9**9",
    b"\xc2\xb5",
    b"runs",
    b"0x",
]
EDITS = st.lists(
    st.tuples(
        st.integers(0, 2000), st.integers(0, 12), st.sampled_from(TOKENS) | st.binary(max_size=6)
    ),
    min_size=1,
    max_size=4,
)


def mutated(data: bytes, edits: list[tuple[int, int, bytes]]) -> bytes:
    for start, removed, inserted in edits:
        start %= len(data) + 1
        data = data[:start] + inserted + data[start + removed :]
    return data


def read_mutated(files: dict[str, str], file: str, edits: list[tuple[int, int, bytes]]) -> None:
    """Reads a data set of which one file was mutated: it is one, or one error says what is wrong."""
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for other, text in files.items():
            content = text.encode()
            (folder / other).write_bytes(mutated(content, edits) if other == file else content)
        try:
            assert isinstance(read_data_set(folder, describe), DataSet)
        except InputError as error:
            assert error.message and error.file is not None
            assert error.line is None or error.line >= 1
            assert len(str(error)) < 2000


@settings(max_examples=300, deadline=None, derandomize=True)
@given(st.sampled_from(sorted(FILES)), EDITS)
def test_mutated_files(file, edits):
    read_mutated(FILES, file, edits)


LAB = {
    "experiment.toml": f'model = "{MODEL}"\n' + COLUMNS + '[[runs]]\nfile = "lab.csv"\n[[runs.loggers]]\n'
    'file = "two.csv"\nmatch = "x"\n[runs.loggers.columns]\neps = { formula = "x / x" }\n',
    "lab.csv": LINES,
    "two.csv": "time  x\n s  mm\n 0  1\n 1e0  2\n",
}  # fmt: skip
