"""What a study produces, as a file: any of its products, saved and loaded with every number as it was.

The file is NumPy's ``.npz``: the arrays, each once, and a text of JSON that refers to them. It holds data and nothing
that could be run.
"""

from __future__ import annotations

import io
import json
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from functools import cache
from pathlib import Path
from typing import Any, get_args

import numpy as np
from cattrs import Converter

from pam_cosim.analysis import FrequencyResponse, LinearModel, LinearModels, Observation
from pam_cosim.comparison import Comparison, ConditionTable
from pam_cosim.diagnosis import Diagnosis
from pam_cosim.diagnosis.planning import RunPlan
from pam_cosim.errors import InputError
from pam_cosim.files import check_ending, check_writable, read_file, write_bytes
from pam_cosim.fitting import Fit, HoldoutUncertainty, PredictiveBands, Profiles
from pam_cosim.ledger import Ledger
from pam_cosim.simulation import Trajectory
from pam_cosim.study.saved_content import arrays_in, check_plain, plain_value
from pam_cosim.study.tables import write_planned_runs

Product = (
    Trajectory
    | Comparison
    | ConditionTable
    | Fit
    | Profiles
    | Ledger
    | Diagnosis
    | RunPlan
    | PredictiveBands
    | LinearModel
    | LinearModels
    | FrequencyResponse
    | Observation
)
_KINDS: dict[str, type[Any]] = {kind.__name__: kind for kind in get_args(Product)}
_TEXT = "product"
_VERSION = 1  # of the form of the file
_DAMAGED = "is no saved product of a study, or was damaged"


def save(product: Product, path: Path | str) -> Path:
    """Writes a trajectory, comparison or any other product of a study; whole or not at all.

    It is written as ``.npz``; planned runs as the tables that a rig plays where the name ends in ``.csv``.

    Raises:
        InputError: another kind of thing, the name ends otherwise, or the file cannot be written.
    """
    target = Path(path)
    check_writable(target)
    kind = type(product).__name__
    if _KINDS.get(kind) is not type(product):
        raise InputError(f"a {kind} cannot be saved; only {', '.join(_KINDS)}", target)
    if isinstance(product, RunPlan) and target.suffix.lower() == ".csv":
        return write_planned_runs(target, product)[0]
    check_ending(target, f"a {kind} is saved as .npz", (".npz",))
    arrays: dict[bytes, tuple[int, np.ndarray]] = {}
    with _at_hand(arrays):
        content = {"kind": kind, "version": _VERSION, "content": _converter().unstructure(product)}
    text = np.frombuffer(json.dumps(content).encode(), dtype=np.uint8)
    file = io.BytesIO()
    arrays_by_name: dict[str, Any] = {_TEXT: text} | {
        f"array_{number}": array for number, array in arrays.values()
    }
    np.savez_compressed(file, **arrays_by_name)
    write_bytes(target, file.getvalue())
    return target


def load(path: Path | str) -> Any:
    """What ``save`` wrote: a product of a study.

    Raises:
        InputError: no such file, not such a file, or one of a later version.
    """
    source = Path(path)
    try:
        content = read_file(source)
    except OSError as problem:
        raise InputError(f"cannot be read: {problem.strerror or problem}", source) from problem
    try:
        arrays = arrays_in(content)
        document = json.loads(bytes(arrays.pop(_TEXT)).decode())
        _check_version(document["version"], source)
        check_plain(document["content"], arrays)
        with _at_hand(arrays):
            product = _converter().structure(document["content"], _KINDS[document["kind"]])
        str(product)  # what cannot say what it is holds numbers that do not belong together
        if hasattr(product, "as_dict"):
            product.as_dict()
    except InputError:
        raise
    except (
        Exception
    ) as problem:  # whatever readers of archives, arrays and JSON raise for what they do not know
        raise InputError(_DAMAGED, source) from problem
    return product


def _check_version(version: object, source: Path) -> None:
    if isinstance(version, int) and version > _VERSION:
        raise InputError(
            f"was saved by a later pam-cosim (form {version} of the file; this one reads up to {_VERSION}): "
            "pip install --upgrade pam-cosim",
            source,
        )


_arrays: ContextVar[dict[Any, Any]] = ContextVar("arrays")
"""Of the file at hand: by their bytes while it is saved, by name while it is loaded."""


@contextmanager
def _at_hand(arrays: dict[Any, Any]) -> Iterator[None]:
    token = _arrays.set(arrays)
    try:
        yield
    finally:
        _arrays.reset(token)


def _put(array: np.ndarray) -> dict[str, str]:
    """The array among those of the file, once; what stands in the text for it."""
    arrays = _arrays.get()
    key = (
        array.dtype.str.encode()
        + repr(array.shape).encode()
        + np.ascontiguousarray(array).tobytes()
    )
    number, _ = arrays.setdefault(key, (len(arrays), array))
    return {"array": f"array_{number}"}


def _taken(reference: Any) -> Any:
    """The array of the file that the text refers to."""
    return _arrays.get()[reference["array"]]


@cache
def _converter() -> Converter:
    """Products to plain data and back: one for all, since to make it takes longer than to use it."""
    converter = Converter()
    converter.register_unstructure_hook_func(_is_array, _put)
    converter.register_structure_hook_func(_is_array, lambda reference, _: _taken(reference))
    converter.register_unstructure_hook(
        HoldoutUncertainty,
        lambda v: {
            "cost": v.cost,
            "shifts": [[*key, _put(shift)] for key, shift in v.shifts.items()],
        },
    )
    converter.register_structure_hook(
        HoldoutUncertainty,
        lambda v, _: HoldoutUncertainty(
            {(r, s): _taken(a) for r, s, a in v["shifts"]}, float(v["cost"])
        ),
    )
    converter.register_unstructure_hook(Path, str)
    converter.register_structure_hook(Path, lambda text, _: Path(text))
    for kind in (str, float, int, bool):
        converter.register_structure_hook(kind, plain_value)
    return converter


def _is_array(kind: Any) -> bool:
    return kind is np.ndarray or getattr(kind, "__origin__", None) is np.ndarray
