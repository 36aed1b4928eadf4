"""Saved products with other contents: one sentence that names the file, or a product that does all that products do."""

from __future__ import annotations

import contextlib
import io
import json
import random
import warnings
import zipfile
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError
from tests.hostile.mutations import mutated_bytes, mutated_document
from tests.test_products import PRODUCTS

TRIED = 4  # mutations of each product, of each kind


def parts(path: Path) -> tuple[Any, dict[str, Any]]:
    """Document and arrays of a saved product."""
    with np.load(path) as file:
        arrays = {name: file[name] for name in file.files}
    return json.loads(bytes(arrays.pop("product")).decode()), arrays


def packed(document: Any, arrays: dict[str, Any]) -> bytes:
    file = io.BytesIO()
    named: dict[str, Any] = {
        "product": np.frombuffer(json.dumps(document).encode(), np.uint8),
        **arrays,
    }
    np.savez(file, **named)
    return file.getvalue()


def mutated_arrays(arrays: dict[str, Any], chance: random.Random) -> dict[str, Any]:
    name = chance.choice(list(arrays))
    array = arrays[name]
    others = (
        array[:-1] if array.ndim else array, array.astype(complex), np.zeros(0), np.zeros((3, 3)), np.array("x"),
        array * np.nan, np.array([None]), np.array(["2020-01-01"], "datetime64[s]"), np.zeros(3, [("a", "f8")]),
    )  # fmt: skip
    return arrays | {name: others[chance.randrange(len(others))]}


def use(file: Path, folder: Path, draw: bool) -> bool:
    """Loads it; what loads can say what it is and be saved again. Whether it loaded."""
    try:
        product = pam.load(file)
    except InputError as problem:
        assert problem.file == file and problem.message.isprintable() and len(problem.message) < 300
        return False
    assert str(product)
    if hasattr(product, "as_dict"):
        product.as_dict()
    pam.save(product, folder / "again.npz")
    if draw:
        with contextlib.suppress(InputError), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            pam.draw(product, folder / "picture.png")
    return True


def attack(name: str, seed: object, tries: int, folder: Path) -> tuple[int, int]:
    """Loads mutations of a product, each of bytes, of the document and of an array; how many were tried and loaded."""
    chance = random.Random(f"{name} {seed}")
    file = pam.save(PRODUCTS[name], folder / "product.npz")
    whole, (document, arrays) = file.read_bytes(), parts(file)
    loaded = 0
    for number in range(tries):
        for content in (
            mutated_bytes(whole, chance),
            packed(mutated_document(document, chance), arrays),
            packed(document, mutated_arrays(arrays, chance) if arrays else arrays),
        ):
            file.write_bytes(content)
            loaded += use(file, folder, draw=number == 0)
    return 3 * tries, loaded


@pytest.mark.parametrize("name", PRODUCTS)
@pytest.mark.filterwarnings("ignore::RuntimeWarning")
def test_mutations(name: str, tmp_path: Path, request: pytest.FixtureRequest) -> None:
    """All of them with ``--full``, and a third otherwise."""
    tried, loaded = attack(
        name, 0, TRIED if request.config.getoption("--full") else TRIED // 3, tmp_path
    )
    assert loaded < tried


ARCHIVES = {
    "an unknown compression": lambda whole: _patched(whole, 10, b"\x63\x00"),
    "an encrypted member": lambda whole: _patched(whole, 8, b"\x01\x00"),
    "a header that is no dictionary": lambda _: _archive(
        {"product.npy": b"\x93NUMPY\x01\x00\x10\x00(((((((((((((((("}
    ),
    "a header that does not end": lambda _: _archive(
        {"product.npy": b"\x93NUMPY\x01\x00\x10\x00'''''''''''''''"}
    ),
    "a header of 64 kB of brackets": lambda _: _archive(
        {"product.npy": b"\x93NUMPY\x01\x00\xff\xff" + b"(" * 65535}
    ),
    "an array of 8 TB": lambda _: _archive({"product.npy": _header("(1000000000000,)")}),
    "an array of negative length": lambda _: _archive({"product.npy": _header("(-1,)")}),
    "objects": lambda _: _archive(
        {"product.npy": _header("(1,)", "|O") + b"cos\nsystem\n(S'touch MADE'\ntR."}
    ),
    "JSON of 100000 brackets": lambda _: _text("[" * 100_000),
    "JSON that is no product": lambda _: _text('{"kind": "Fit", "content": {"parameters": 1}}'),
    "a number of 5000 digits": lambda _: _text('{"kind": "Fit", "content": ' + "9" * 5000 + "}"),
    "members of 10 GB of zeros": lambda _: _bomb(),
    "a name that leaves the folder": lambda _: _archive({"../../../tmp/evil.npy": b"x"}),
}


def _patched(whole: bytes, at: int, value: bytes) -> bytes:
    """The entry in the directory at the end, and the header at the beginning."""
    directory = whole.rindex(b"PK\x01\x02")
    made = bytearray(whole)
    made[directory + at : directory + at + 2] = value
    made[at - 2 : at] = value
    return bytes(made)


def _archive(members: dict[str, bytes]) -> bytes:
    file = io.BytesIO()
    with zipfile.ZipFile(file, "w") as archive:
        for name, content in members.items():
            archive.writestr(name, content)
    return file.getvalue()


def _header(shape: str, kind: str = "<f8") -> bytes:
    text = f"{{'descr': '{kind}', 'fortran_order': False, 'shape': {shape}, }}".encode()
    return b"\x93NUMPY\x01\x00" + len(text).to_bytes(2, "little") + text


def _text(text: str) -> bytes:
    file = io.BytesIO()
    np.savez(file, product=np.frombuffer(text.encode(), np.uint8))
    return file.getvalue()


def _bomb() -> bytes:
    """Said to be 3 GB; the members are not even read."""
    made = bytearray(_archive({"product.npy": b"x"}))
    at = bytes(made).rindex(b"PK\x01\x02") + 24
    made[at : at + 4] = (3_000_000_000).to_bytes(4, "little")
    return bytes(made)


@pytest.mark.parametrize("kind", ARCHIVES)
def test_archives_that_are_none(kind: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    file = pam.save(PRODUCTS["fit"], tmp_path / "product.npz")
    file.write_bytes(ARCHIVES[kind](file.read_bytes()))
    with pytest.raises(InputError, match="is no saved product of a study, or was damaged"):
        pam.load(file)
    assert [p.name for p in tmp_path.iterdir()] == ["product.npz"]
