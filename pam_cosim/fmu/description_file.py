"""A model description of FMI 2.0 or 3.0 as plain objects.

FMPy has such objects too, but takes as long to load as a run. These hold what a run, a fit or a coupling needs, under
the names that FMI gives it.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import IO
from xml.parsers import expat

from pam_cosim.errors import InputError
from pam_cosim.wording import shown

_TRUE = ("true", "1")
_TYPES = frozenset(
    (
        *("Real", "Float32", "Float64", "Integer", "Boolean", "String", "Enumeration"),
        *(f"{sign}Int{bits}" for sign in ("", "U") for bits in (8, 16, 32, 64)),
        *("Binary", "Clock"),
    )
)
# By variability, the causalities whose kind of initial value FMI prescribes; others must state it.
_INITIAL = {
    "constant": ("output", "local"),
    **dict.fromkeys(
        ("fixed", "tunable"),
        ("structuralParameter", "parameter", "calculatedParameter", "local"),
    ),
    "discrete": ("input", "output", "local"),
    "continuous": ("input", "output", "local", "independent"),
}
_PARAMETERS = ("parameter", "calculatedParameter", "structuralParameter")
# Elements of the model structure in FMI 2.0, as FMI 3.0 names what they list.
_LISTS = {"Outputs": "Output", "Derivatives": "ContinuousStateDerivative", "InitialUnknowns": ""}
_STRUCTURE = (
    "Output",
    "ContinuousStateDerivative",
    "ClockedState",
    "InitialUnknown",
    "EventIndicator",
)


class Element:
    """An element of XML.

    Attributes:
        tag: its name.
        attributes: by name.
        line: where it begins.
        children: elements in it.
    """

    __slots__ = ("attributes", "children", "line", "tag")

    def __init__(self, tag: str, attributes: dict[str, str], line: int) -> None:
        self.tag, self.attributes, self.line = tag, attributes, line
        self.children: list[Element] = []

    def get(self, name: str) -> str | None:
        """The attribute; None: it has none of this name."""
        return self.attributes.get(name)

    def all(self, *tags: str) -> Iterator[Element]:
        """Children of these names."""
        return (child for child in self.children if child.tag in tags)

    def first(self, tag: str) -> Element | None:
        """The first child of this name."""
        return next(self.all(tag), None)

    def inside(self, tag: str) -> list[Element]:
        """The elements in the children of this name."""
        return [inner for child in self.all(tag) for inner in child.children]


@dataclass(eq=False, repr=False)
class InterfaceType:
    """What co-simulation or model exchange needs and can do, as ``CoSimulation`` or ``ModelExchange`` declares it."""

    modelIdentifier: str | None
    canGetAndSetFMUState: bool
    canSerializeFMUState: bool
    canHandleVariableCommunicationStepSize: bool
    canInterpolateInputs: bool
    fixedInternalStepSize: str | None
    needsCompletedIntegratorStep: bool
    providesDirectionalDerivatives: bool


@dataclass(eq=False, repr=False)
class DefaultExperiment:
    """Default times of a run, as texts."""

    startTime: str | None
    stopTime: str | None
    tolerance: str | None
    stepSize: str | None


@dataclass(eq=False, repr=False)
class Quantity:
    """What is stated of the numbers of a type or of a variable, as texts."""

    unit: str | None
    displayUnit: str | None
    quantity: str | None
    min: str | None
    max: str | None
    nominal: str | None


@dataclass(eq=False, repr=False)
class SimpleType(Quantity):
    """A declared type; ``items`` are the names and numbers of an enumeration."""

    items: Sequence[tuple[str, str]]


@dataclass(eq=False, repr=False)
class ModelVariable(Quantity):
    """A variable; numbers are texts, and an array has several in one.

    Attributes:
        type: name of its element, such as "Real" or "UInt8".
        shape: of an array.
        start: of Strings in an array one text each.
        derivative: the variable that this one is the derivative of.
    """

    name: str
    valueReference: int
    type: str
    description: str | None
    causality: str
    variability: str
    start: str | list[str | None] | None
    declaredType: SimpleType | None
    shape: tuple[int, ...] = ()
    derivative: ModelVariable | None = None


@dataclass(eq=False, repr=False)
class Unknown:
    """An entry of the model structure; ``dependencies`` is None where none are declared."""

    variable: ModelVariable
    dependencies: list[ModelVariable] | None


@dataclass(eq=False, repr=False)
class ModelDescription:
    """What an FMU says of itself."""

    fmiVersion: str
    modelName: str | None
    guid: str | None
    generationTool: str | None
    numberOfEventIndicators: int
    defaultExperiment: DefaultExperiment | None
    coSimulation: InterfaceType | None
    modelExchange: InterfaceType | None
    modelVariables: list[ModelVariable]
    outputs: list[Unknown]
    derivatives: list[Unknown]

    @property
    def numberOfContinuousStates(self) -> int:
        """The number of continuous states; each element of an array is one."""
        return sum(math.prod(unknown.variable.shape) for unknown in self.derivatives)


def parse(file: IO[bytes]) -> ModelDescription:
    """Reads a model description.

    Raises:
        InputError: another version of FMI; an index of no variable, or an undefined type.
        Exception: whatever else is wrong with it: ``ExpatError``, ``ValueError``, ``KeyError``.
    """
    root = _root(file)
    version = str(root.get("fmiVersion"))
    if not (version == "2.0" or version.startswith("3.")):
        raise InputError(f"an FMU of FMI 2.0 or 3.0 is needed; this is FMI {shown(version)}")
    return (_Fmi2 if version == "2.0" else _Fmi3)(root, version).description()


def _root(file: IO[bytes]) -> Element:
    """The outermost element."""
    parser = expat.ParserCreate(namespace_separator="}")
    document = Element("", {}, 0)
    open_elements = [document]

    def begin(tag: str, attributes: dict[str, str]) -> None:
        element = Element(tag, attributes, parser.CurrentLineNumber)
        open_elements[-1].children.append(element)
        open_elements.append(element)

    parser.StartElementHandler = begin
    parser.EndElementHandler = lambda tag: open_elements.pop()
    parser.ParseFile(file)
    return document.children[0]


class _Reader:
    """What both versions of FMI have in common.

    Args:
        root: of the document.
        version: of FMI.
    """

    guid: str

    def __init__(self, root: Element, version: str) -> None:
        self._root, self._version = root, version
        self._types = {
            name: self._simple_type(element)
            for name, element in self._declared_types()
            if name is not None
        }
        if root.first("ModelVariables") is None:
            raise ValueError("its description has no ModelVariables")
        self._variables: list[ModelVariable] = []
        self._derivatives: list[tuple[ModelVariable, str]] = []
        self._elements: list[Element] = []
        for element in root.inside("ModelVariables"):
            if element.get("name") is not None:
                self._elements.append(element)
                self._variables.append(self._variable(element, self._value(element)))

    def description(self) -> ModelDescription:
        """All of it."""
        self._shape_arrays()
        for variable, text in self._derivatives:
            variable.derivative = self._referred(text)
        self._variables += self._aliases()
        root, structure = self._root, self._structure()
        experiments = [*root.all("DefaultExperiment")]
        return ModelDescription(
            self._version,
            root.get("modelName"),
            root.get(self.guid),
            root.get("generationTool"),
            self._event_indicators(structure),
            self._experiment(experiments[-1]) if experiments else None,
            self._interface_type("CoSimulation"),
            self._interface_type("ModelExchange"),
            self._variables,
            [unknown for kind, unknown in structure if kind == "Output"],
            [unknown for kind, unknown in structure if kind == "ContinuousStateDerivative"],
        )

    @staticmethod
    def _experiment(element: Element) -> DefaultExperiment:
        return DefaultExperiment(
            *map(element.get, ("startTime", "stopTime", "tolerance", "stepSize"))
        )

    def _interface_type(self, tag: str) -> InterfaceType | None:
        elements = [*self._root.all(tag)]
        if not elements:
            return None
        element = elements[-1]

        def is_true(*names: str) -> bool:
            return any(element.get(name) in _TRUE for name in names)

        return InterfaceType(
            element.get("modelIdentifier"),
            is_true("canGetAndSetFMUState", "canGetAndSetFMUstate"),
            is_true("canSerializeFMUState", "canSerializeFMUstate"),
            is_true("canHandleVariableCommunicationStepSize"),
            is_true("canInterpolateInputs"),
            element.get("fixedInternalStepSize"),
            self._needs_completed_step(element),
            is_true("providesDirectionalDerivatives", "providesDirectionalDerivative"),
        )

    @staticmethod
    def _simple_type(element: Element) -> SimpleType:
        items = [
            (item.attributes["name"], item.attributes["value"]) for item in element.all("Item")
        ]
        return SimpleType(
            unit=element.get("unit"),
            displayUnit=element.get("displayUnit"),
            quantity=element.get("quantity"),
            min=element.get("min"),
            max=element.get("max"),
            nominal=element.get("nominal"),
            items=items,
        )

    def _variable(self, element: Element, value: Element) -> ModelVariable:
        """A variable.

        Args:
            element: with its name.
            value: with its type and start value.
        """
        name, place = element.attributes["name"], f"(line {element.line})"
        declared = value.get("declaredType")
        if declared is not None and declared not in self._types:
            raise InputError(f"{shown(name)} {place} has the undefined type {shown(declared)}")
        causality = element.get("causality") or "local"
        variability = element.get("variability") or self._usual_variability(value.tag, causality)
        if element.get("initial") is None and causality not in _INITIAL.get(variability, ()):
            raise InputError(
                f"{shown(name)} {place} cannot have the causality {shown(causality)} and the variability "
                f"{shown(variability)}"
            )
        real = value.attributes if value.tag in ("Real", "Float32", "Float64") else {}
        number = value.attributes if value.tag not in ("Boolean", "String") else {}
        variable = ModelVariable(
            name=name,
            valueReference=int(element.attributes["valueReference"]),
            type=value.tag,
            description=element.get("description"),
            causality=causality,
            variability=variability,
            start=self._start(value),
            unit=real.get("unit"),
            displayUnit=real.get("displayUnit"),
            quantity=number.get("quantity"),
            min=number.get("min"),
            max=number.get("max"),
            nominal=real.get("nominal"),
            declaredType=None if declared is None else self._types[declared],
        )
        derivative = real.get("derivative")
        if derivative is not None:
            self._derivatives.append((variable, derivative))
        return variable

    def _unknown(self, element: Element, reference: str) -> Unknown:
        dependencies = element.get("dependencies")
        return Unknown(
            self._referred(element.attributes[reference]),
            None if dependencies is None else [*map(self._referred, dependencies.split())],
        )

    def _start(self, value: Element) -> str | list[str | None] | None:
        return value.get("start")

    def _shape_arrays(self) -> None:
        pass

    def _aliases(self) -> list[ModelVariable]:
        return []

    def _declared_types(self) -> Iterator[tuple[str | None, Element]]:
        raise NotImplementedError

    def _value(self, element: Element) -> Element:
        raise NotImplementedError

    def _usual_variability(self, type: str, causality: str) -> str:
        raise NotImplementedError

    def _needs_completed_step(self, element: Element) -> bool:
        raise NotImplementedError

    def _referred(self, text: str) -> ModelVariable:
        raise NotImplementedError

    def _structure(self) -> list[tuple[str, Unknown]]:
        raise NotImplementedError

    def _event_indicators(self, structure: Sequence[tuple[str, Unknown]]) -> int:
        raise NotImplementedError


class _Fmi2(_Reader):
    """FMI 2.0: a variable has an element for its type, and is referred to by its place."""

    guid = "guid"

    def _declared_types(self) -> Iterator[tuple[str | None, Element]]:
        for element in self._root.inside("TypeDefinitions"):
            if element.tag == "SimpleType":
                yield element.get("name"), element.children[0]

    def _value(self, element: Element) -> Element:
        for child in element.children:
            if child.tag in _TYPES:
                return child
        raise InputError(f"{shown(element.get('name'))} (line {element.line}) has no type")

    def _usual_variability(self, type: str, causality: str) -> str:
        return "continuous"

    def _needs_completed_step(self, element: Element) -> bool:
        return element.get("completedIntegratorStepNotNeeded") not in _TRUE

    def _referred(self, text: str) -> ModelVariable:
        count = len(self._variables)
        if not (text.isdecimal() and 1 <= int(text[:20]) <= count):
            raise InputError(f"the index {shown(text)} is of none of {count} variables")
        return self._variables[int(text) - 1]

    def _structure(self) -> list[tuple[str, Unknown]]:
        return [
            (_LISTS[group.tag], self._unknown(element, "index"))
            for group in self._root.inside("ModelStructure")
            if group.tag in _LISTS
            for element in group.all("Unknown")
        ]

    def _event_indicators(self, structure: Sequence[tuple[str, Unknown]]) -> int:
        return int(self._root.get("numberOfEventIndicators") or 0)


class _Fmi3(_Reader):
    """FMI 3.0: a variable is an element of its type, may be an array, and is referred to by its value reference."""

    guid = "instantiationToken"

    def _declared_types(self) -> Iterator[tuple[str | None, Element]]:
        for element in self._root.inside("TypeDefinitions"):
            if element.tag.removesuffix("Type") in _TYPES:
                yield element.get("name"), element

    def _value(self, element: Element) -> Element:
        if element.tag not in _TYPES:
            raise InputError(
                f"{shown(element.get('name'))} (line {element.line}) has the unknown type {shown(element.tag)}"
            )
        return element

    def _usual_variability(self, type: str, causality: str) -> str:
        if causality in _PARAMETERS:
            return "fixed"
        return "continuous" if type in ("Float32", "Float64") else "discrete"

    def _needs_completed_step(self, element: Element) -> bool:
        return element.get("needsCompletedIntegratorStep") in _TRUE

    def _start(self, value: Element) -> str | list[str | None] | None:
        if value.tag not in ("String", "Binary"):
            return value.get("start")
        starts = [start.get("value") for start in value.all("Start")]
        return starts if len(starts) > 1 else next(iter(starts), None)

    def _shape_arrays(self) -> None:
        self._by_reference = {v.valueReference: v for v in self._variables}
        for variable, element in zip(self._variables, self._elements, strict=True):
            variable.shape = tuple(map(self._extent, element.all("Dimension")))

    def _aliases(self) -> list[ModelVariable]:
        return [
            replace(
                variable,
                name=alias.attributes["name"],
                description=alias.get("description") or variable.description,
                displayUnit=alias.get("displayUnit") or variable.displayUnit,
            )
            for variable, element in zip(self._variables, self._elements, strict=True)
            for alias in element.all("Alias")
        ]

    def _extent(self, dimension: Element) -> int:
        start = dimension.get("start")
        if start is None:
            start = str(self._referred(dimension.attributes["valueReference"]).start)
        return int(start)

    def _referred(self, text: str) -> ModelVariable:
        if int(text) not in self._by_reference:
            raise InputError(f"the value reference {shown(text)} is of no variable")
        return self._by_reference[int(text)]

    def _structure(self) -> list[tuple[str, Unknown]]:
        return [
            (element.tag, self._unknown(element, "valueReference"))
            for element in self._root.inside("ModelStructure")
            if element.tag in _STRUCTURE
        ]

    def _event_indicators(self, structure: Sequence[tuple[str, Unknown]]) -> int:
        return sum(math.prod(u.variable.shape) for kind, u in structure if kind == "EventIndicator")
