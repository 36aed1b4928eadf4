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
        f"{names.unquoted(names.last(base))}With{'And'.join(_title(input_map) for input_map in maps)}"
    )
    bindings = ", ".join(f"{input_map.name}={_binding(input_map)}" for input_map in maps)
    says = f"{names.last(base)}, with {' and '.join(_says(input_map) for input_map in maps)}"
    lines = [f"model {name} {string_text(says)}", f"  extends {base}({bindings});"]
    lines += [f"  {line};" for input_map in maps for line in _declarations(input_map, interface)]
    experiment = tree.classes[base].annotations.get("experiment")
    lines += [f"  annotation ({experiment});"] if experiment else []
    return Composition(name, "\n".join([*lines, f"end {name};", ""]), {}, base)


def _title(input_map: InputMap) -> str:
    return f"{'Constant' if input_map.raw is None else 'Mapped'}_{input_map.name}"


def _says(input_map: InputMap) -> str:
    return (
        f"{input_map.name} constant"
        if input_map.raw is None
        else f"{input_map.name} from its record"
    )


def _binding(input_map: InputMap) -> str:
    if input_map.raw is None:
        return constant_of(input_map.name)
    return f"{gain_of(input_map.name)}*{raw_of(input_map.name)} + {offset_of(input_map.name)}"


def _declarations(input_map: InputMap, interface: Interface) -> list[str]:
    variable = interface.inputs[input_map.name]
    if input_map.raw is None:
        ends = [
            f"{key}={end!r}"
            for key, end in (("min", variable.min), ("max", variable.max))
            if end is not None
        ]
        says = f"{variable.description or input_map.name}, the same all the time"
        return [
            _parameter(constant_of(input_map.name), input_map.unit, input_map.offset, says, ends)
        ]
    start = ((variable.start or 0.0) - input_map.offset) / input_map.gain if input_map.gain else 0.0
    return [
        f'input Real {raw_of(input_map.name)}(unit="{input_map.raw}", start={start!r}) '
        f"{string_text(f'What was recorded in the place of {input_map.name}')}",
        _parameter(
            gain_of(input_map.name),
            quotient(input_map.unit, input_map.raw),
            input_map.gain,
            f"{input_map.name} by what was recorded",
        ),
        _parameter(
            offset_of(input_map.name),
            input_map.unit,
            input_map.offset,
            f"{input_map.name} where what was recorded is zero",
        ),
    ]


def _parameter(name: str, unit: str, value: float, says: str, ends: Sequence[str] = ()) -> str:
    attributes = ", ".join([f'unit="{unit}"', *ends, f"nominal={abs(value) or 1.0!r}"])
    return f"parameter Real {name}({attributes}) = {value!r} {string_text(says)}"
