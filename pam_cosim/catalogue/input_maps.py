"""A model some of whose inputs follow from what was recorded by a map with parameters, as Modelica text.

The map is part of the compiled model, so that its gain and offset are parameters like all others: fits have the exact
sensitivities to them, and effects find their places as in the model that is extended.
"""

from __future__ import annotations

from collections.abc import Sequence

from pam_cosim.catalogue.compose import Composition
from pam_cosim.compiler import ClassTree, names
from pam_cosim.compiler.printing import string_text
from pam_cosim.model.input_map import InputMap, constant_of, gain_of, offset_of, raw_of
from pam_cosim.model.interface import Interface
from pam_cosim.units import quotient


def with_input_maps(
    tree: ClassTree, base: str, interface: Interface, maps: Sequence[InputMap]
) -> Composition:
    """The class that extends a model and binds some of its inputs.

    Args:
        tree: the library and the user's files.
        base: full name of the model.
        interface: of the model.
        maps: one for each of these inputs.
    """
    name = names.identifier(
        f"{names.unquoted(names.last(base))}With{'And'.join(_title(one) for one in maps)}"
    )
    bindings = ", ".join(f"{one.name}={_binding(one)}" for one in maps)
    says = f"{names.last(base)}, with {' and '.join(_says(one) for one in maps)}"
    lines = [f"model {name} {string_text(says)}", f"  extends {base}({bindings});"]
    lines += [f"  {line};" for one in maps for line in _declarations(one, interface)]
    experiment = tree.classes[base].annotations.get("experiment")
    lines += [f"  annotation ({experiment});"] if experiment else []
    return Composition(name, "\n".join([*lines, f"end {name};", ""]), {}, base)


def _title(one: InputMap) -> str:
    return f"{'Constant' if one.raw is None else 'Mapped'}_{one.name}"


def _says(one: InputMap) -> str:
    return f"{one.name} constant" if one.raw is None else f"{one.name} from its record"


def _binding(one: InputMap) -> str:
    if one.raw is None:
        return constant_of(one.name)
    return f"{gain_of(one.name)}*{raw_of(one.name)} + {offset_of(one.name)}"


def _declarations(one: InputMap, interface: Interface) -> list[str]:
    known = interface.inputs[one.name]
    if one.raw is None:
        ends = [
            f"{key}={end!r}"
            for key, end in (("min", known.min), ("max", known.max))
            if end is not None
        ]
        says = f"{known.description or one.name}, the same all the time"
        return [_parameter(constant_of(one.name), one.unit, one.offset, says, ends)]
    start = ((known.start or 0.0) - one.offset) / one.gain if one.gain else 0.0
    return [
        f'input Real {raw_of(one.name)}(unit="{one.raw}", start={start!r}) '
        f"{string_text(f'What was recorded in the place of {one.name}')}",
        _parameter(
            gain_of(one.name),
            quotient(one.unit, one.raw),
            one.gain,
            f"{one.name} by what was recorded",
        ),
        _parameter(
            offset_of(one.name), one.unit, one.offset, f"{one.name} where what was recorded is zero"
        ),
    ]


def _parameter(name: str, unit: str, value: float, says: str, ends: Sequence[str] = ()) -> str:
    attributes = ", ".join([f'unit="{unit}"', *ends, f"nominal={abs(value) or 1.0!r}"])
    return f"parameter Real {name}({attributes}) = {value!r} {string_text(says)}"
