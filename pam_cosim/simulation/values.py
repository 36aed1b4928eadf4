"""Numbers by name to and from the typed functions of FMI, such as ``fmi2SetBoolean``: types, arrays, texts."""

from __future__ import annotations

import ctypes
import re
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from pam_cosim.arrays import Array
from pam_cosim.fmu.read import Slot, integer_span
from pam_cosim.model.settings import Text

# Of the functions, by major version of FMI and type in the description, where they differ.
_FUNCTIONS = {2: {"Enumeration": "Integer"}, 3: {"Enumeration": "Int64"}}
# As pam_driver.c numbers them; a type that is not listed is passed as double precision.
_NUMBERS = {
    "Float32": 1,
    "Int8": 2,
    "UInt8": 3,
    "Int16": 4,
    "UInt16": 5,
    "Int32": 6,
    "UInt32": 7,
    "Int64": 8,
    "UInt64": 9,
    "String": 10,
    "Integer": 6,
}
_BOOLEAN = {2: 6, 3: 3}
_INTEGERS = {"Integer", "Boolean", *(name for name in _NUMBERS if "Int" in name)}
# FMI 2.0.4, 2.1.5: "#r12#" in a message is the variable of type Real with the value reference 12.
_REFERENCE = re.compile(r"#([ribs])(\d+)#")
_LETTERS = {"r": "Real", "i": "Integer", "b": "Boolean", "s": "String"}


def named_references(text: str, slots: Mapping[str, Slot]) -> str:
    """A message of an FMU of FMI 2.0 with the names of variables in place of references."""
    if "#" not in text:
        return text
    names = {(s.scalar.type, s.scalar.valueReference): name for name, s in slots.items()}

    def name(match: re.Match[str]) -> str:
        return names.get((_LETTERS[match[1]], int(match[2])), match[0])

    return _REFERENCE.sub(name, text)


class DriverGroup(ctypes.Structure):
    """References of one type, as ``pam_driver.c`` has them."""

    _fields_ = [
        ("type", ctypes.c_int32),
        ("set", ctypes.c_void_p),
        ("get", ctypes.c_void_p),
        ("n", ctypes.c_size_t),
        ("references", ctypes.c_void_p),
        ("n_values", ctypes.c_size_t),
    ]


class Group(NamedTuple):
    """Value references whose values one call of FMI sets or gets.

    Attributes:
        function: the type in the names of the functions, such as "Boolean".
        is_slope: the values can be given with their slopes: they are continuous and of double precision.
        references: of variables.
        begin, end: which values of all.
    """

    function: str
    is_slope: bool
    references: tuple[int, ...]
    begin: int
    end: int

    @property
    def places(self) -> slice:
        """Of its values among all."""
        return slice(self.begin, self.end)


class Selection:
    """Variables that are set or read together; those with slopes come first, and an array is set and read as a whole.

    Args:
        names: of variables or elements of arrays.
        slots: by name.
        version: major version of FMI.

    Attributes:
        names: as given.
        groups: of references.
        width: number of values of all of them.
        places: (n,) of the named values among them.
        is_discrete: (n,) whether each changes at events alone.
    """

    def __init__(self, names: Sequence[str], slots: Mapping[str, Slot], version: int) -> None:
        self.names, self.version = tuple(names), version
        chosen = [slots[name] for name in names]
        functions = _FUNCTIONS[version]
        by_group: dict[tuple[bool, str], dict[int, Slot]] = {}
        for slot in chosen:
            kind = functions.get(slot.scalar.type, slot.scalar.type)
            is_slope = kind in ("Real", "Float64") and slot.scalar.variability == "continuous"
            by_group.setdefault((not is_slope, kind), {})[slot.scalar.valueReference] = slot
        self.groups: list[Group] = []
        starts: list[float] = []
        begins: dict[tuple[str, int], int] = {}
        for (is_held, kind), slots_of_group in sorted(by_group.items()):
            begin = len(starts)
            for reference, slot in slots_of_group.items():
                begins[kind, reference] = len(starts)
                starts += [v if isinstance(v, float) else 0.0 for v in slot.starts]
            references = tuple(slots_of_group)
            self.groups.append(Group(kind, not is_held, references, begin, len(starts)))
        self.width = len(starts)
        kinds = [functions.get(s.scalar.type, s.scalar.type) for s in chosen]
        self.places: NDArray[np.intp] = np.array(
            [
                begins[kind, s.scalar.valueReference] + s.place
                for kind, s in zip(kinds, chosen, strict=True)
            ],
            dtype=np.intp,
        )
        self.is_discrete = np.array(
            [s.kind != "Real" or s.scalar.variability == "discrete" for s in chosen], dtype=bool
        )
        self._starts = np.array(starts)
        self.is_plain = self.places.tolist() == list(range(self.width))

    def spread(self, values: Array, defaults: Array | float | None = None) -> Array:
        """(..., width) of (..., n) values; elements without a name have their start values, or the ``defaults``."""
        if self.is_plain:
            return np.ascontiguousarray(values, dtype=float)
        base = self._starts if defaults is None else defaults
        widened = np.empty((*np.shape(values)[:-1], self.width))
        widened[...] = base
        widened[..., self.places] = values
        return widened

    def named(self, values: Array) -> Array:
        """(..., n) of (..., width)."""
        return values if self.is_plain else values[..., self.places]

    def texts(self, values: Sequence[float]) -> list[bytes]:
        """Of the values of type String, in the order of their references."""
        by_place = {
            place: v.text
            for place, v in zip(self.places, values, strict=True)
            if isinstance(v, Text)
        }
        return [by_place[place].encode() for place in sorted(by_place)]

    def driver_groups(self, addresses: Any) -> tuple[Any, list[Any]]:
        """The groups as an array for C, and what must live as long; ``addresses`` finds a function by its name."""
        kept: list[Any] = []
        groups = (DriverGroup * max(1, len(self.groups)))()
        for at, group in zip(groups, self.groups, strict=False):
            references = np.array(group.references, dtype=np.uint32)
            kept.append(references)
            number = _NUMBERS.get(group.function, 0)
            at.type = _BOOLEAN[self.version] if group.function == "Boolean" else number
            at.set = addresses(f"fmi{self.version}Set{group.function}")
            at.get = addresses(f"fmi{self.version}Get{group.function}")
            at.n, at.references = len(references), references.ctypes.data
            at.n_values = group.end - group.begin
        return groups, kept


class Values:
    """Sets and gets variables of an instance by FMPy.

    Args:
        instance: FMPy's face of it.
        slots: by name.
        version: major version of FMI.
    """

    def __init__(self, instance: Any, slots: Mapping[str, Slot], version: int) -> None:
        self._instance, self._slots, self._version = instance, slots, version
        self._selections: dict[tuple[str, ...], Selection] = {}
        self._arrays: dict[str, float] = {}  # elements that were set, for those set without them

    def selection(self, names: Sequence[str]) -> Selection:
        """The variables of these names; each selection is made once."""
        key = tuple(names)
        if key not in self._selections:
            self._selections[key] = Selection(key, self._slots, self._version)
        return self._selections[key]

    def kinds(self, names: Sequence[str]) -> str:
        """The type in the names of the functions that set or get these: the first, where there are several."""
        return next((group.function for group in self.selection(names).groups), "")

    def set(self, values: Mapping[str, float]) -> None:
        """Sets values by name."""
        if not values:
            return
        arrays = {n: v for n, v in values.items() if self._slots[n].size > 1}
        self._arrays |= arrays
        chosen = values if not arrays else {**self._arrays, **values}
        selection, numbers = self.selection([*chosen]), list(chosen.values())
        spread = selection.spread(np.array(numbers, dtype=float))
        for group in selection.groups:
            elements: list[Any] = spread[group.places].tolist()
            if group.function == "String":
                elements = [text.decode() for text in selection.texts(numbers)]
            elif group.function in _INTEGERS:
                most = 1 if group.function == "Boolean" else integer_span(group.function)[1]
                elements = [
                    min(int(value), most) for value in elements
                ]  # a double may round the greatest up
            getattr(self._instance, f"set{group.function}")(list(group.references), elements)

    def get(self, names: Sequence[str]) -> list[float]:
        """Values by name."""
        if not names:
            return []
        selection = self.selection(names)
        values = np.empty(selection.width)
        for group in selection.groups:
            count = () if self._version == 2 else (group.end - group.begin,)
            get = getattr(self._instance, f"get{group.function}")
            values[group.places] = get(list(group.references), *count)
        return list(map(float, selection.named(values)))
