"""The words of a field, read from the records ``Domain`` and ``Vocabulary`` of its library."""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any, TypeVar

from pam_cosim.cache import cached, digest
from pam_cosim.catalogue.place import libraries, library_of, qualified
from pam_cosim.compiler import ClassTree, flat_hash, read_library
from pam_cosim.compiler.class_tree import Constant
from pam_cosim.errors import ModelError
from pam_cosim.model import domain as words
from pam_cosim.model.domain import Domain
from pam_cosim.model.references import is_modelica
from pam_cosim.model.vocabulary import Vocabulary

_Record = TypeVar("_Record", Domain, Vocabulary)


def domain_of(tree: ClassTree, model: str) -> Domain:
    """The domain of the library that a model is made from: that of its class, of a base, or of a component.

    A model of no library, or an FMU of another tool, is described in the words of the first library.

    Args:
        tree: the library and the user's files.
        model: a class, by its full name or as ``qualified`` takes it, a ``.mo`` file, or an FMU's model name.

    Raises:
        ModelError: the record of the library is not what it must be.
    """
    name = _class_in(tree, model) if is_modelica(model) else qualified(tree, model)
    return next(_records(tree, [*_origins(tree, name), *libraries(tree)], Domain), Domain())


def vocabulary_of(tree: ClassTree, model: str | None = None) -> Vocabulary:
    """The words of the library that a model is made from; without a model, those of all libraries together.

    Args:
        tree: the library and the user's files.
        model: as in ``domain_of``, or None.

    Raises:
        ModelError: as ``domain_of``.
    """
    name = (_class_in(tree, model) if is_modelica(model) else model) if model else ""
    vocabularies = list(_records(tree, _origins(tree, name), Vocabulary))
    together = vocabularies[:1] or list(_records(tree, libraries(tree)[::-1], Vocabulary))
    joined: dict[str, Any] = {
        field.name: tuple(row for vocabulary in together for row in getattr(vocabulary, field.name))
        for field in fields(Vocabulary)
    }
    return Vocabulary(**joined)


def _records(tree: ClassTree, packages: Iterable[str], kind: type[_Record]) -> Iterator[_Record]:
    """The record of a kind of each library that has one."""
    records = (f"{package}.{kind.__name__}" for package in dict.fromkeys(packages))
    return (_read(tree, record, kind) for record in records if record in tree.classes)


def known_domain(model: str, sources: Sequence[Path] = ()) -> Domain:
    """As ``domain_of``, where the library need not be read: the domain is kept by what it was read from.

    Args:
        model: as in ``domain_of``. What an FMU calls itself is a name, never a file that is read.
        sources: the user's files, that of the model among them.

    Raises:
        ModelError: as ``domain_of``; the library, or a file, cannot be read.
    """

    def content() -> bytes:
        return json.dumps(asdict(domain_of(read_library(files=sources), model))).encode()

    code = (Path(str(module)).read_bytes() for module in (__file__, words.__file__))
    key = digest(model, flat_hash("", files=sources), *code)
    file = cached("domains", key, ".json", content)
    return Domain(**{name: _tuples(value) for name, value in json.loads(file.read_bytes()).items()})


def _tuples(value: Any) -> Any:
    return tuple(map(_tuples, value)) if isinstance(value, list) else value


def _class_in(tree: ClassTree, file: str) -> str:
    """The model that a file stands for: its last one."""
    return next(reversed(tree.models_in(Path(file))), "")


def _origins(tree: ClassTree, name: str) -> list[str]:
    if name not in tree.classes:
        return []
    classes = [name, *tree.bases(name), *(c.type for c in tree.components(name))]
    return [library_of(c) for c in classes]


def _read(tree: ClassTree, record: str, kind: type[_Record]) -> _Record:
    """Every field is a constant of the record, an array of as many dimensions and columns."""
    values: dict[str, Any] = {}
    for field in fields(kind):
        value = tree.constant(record, field.name)
        if value is None:
            continue
        if not _fits(value, _ROWS[field.name]):
            info = tree.classes[record]
            raise ModelError(
                f"{record}: {field.name} must be {_FORMS[_ROWS[field.name]]}", info.file, info.line
            )
        values[field.name] = value
    return kind(**values)


_ROWS = {
    "tested": -1,
    "balances": 0,
    "moving": 0,
    "axes": 0,
    "planes": 2,
    "instruments": 2,
    "confused": 3,
    "ranges": 3,
    "phases": 4,
    "kinds": 4,
    "roles": 3,
    "units": 2,
    "spellings": 2,
    "counts": 0,
    "sure": 2,
    "data_sheets": 5,
    "nominal": 3,
    "directions": 2,
    "calibrated": 0,
    "uncertain": 0,
    "chosen": 0,
    "walls": 0,
    "fibres": 0,
    "measures": 2,
    "neutral": 2,
}
_FORMS = {
    -1: "a text",
    0: "texts in braces",
    2: "rows of 2 texts",
    3: "rows of 3 texts",
    4: "rows of 4 texts",
    5: "rows of 5 texts",
}


def _fits(value: Constant, columns: int) -> bool:
    if columns < 0:
        return isinstance(value, str)
    if not isinstance(value, tuple):
        return False
    if columns == 0:
        return all(isinstance(v, str) for v in value)
    return all(isinstance(row, tuple) and len(row) == columns and _fits(row, 0) for row in value)
