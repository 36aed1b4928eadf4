"""What a data sheet states of a valve: an area or a flow at an input, as parameter and scale of the inputs."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass

from pam_cosim.arrays import Array
from pam_cosim.drafting.benches import Bench
from pam_cosim.drafting.columns import RecordedColumn
from pam_cosim.drafting.headings import VALVES, Headings
from pam_cosim.errors import InputError
from pam_cosim.model.interface import Variable
from pam_cosim.units import UnitError, convert, parse_quantity
from pam_cosim.wording import shown

EXAMPLES = (
    "--valve '0.8 mm2 at 250 mA', or --valve '120 l/min at 300 mA from 40 mA' where it opens later; of valves that "
    "differ --valve 'u_in=0.8 mm2 at 250 mA; u_out=1.2 mm2 at 250 mA'"
)
_RATING = re.compile(
    r"\s*(?:(?P<input>[\w.]+) *= *)?(?:[a-z]+ )?(?P<size>[\d.]+ *[^\s\d]\S*)"
    r"(?: at (?P<at>[\d.]+ *\S*?))?(?: from (?P<begin>[\d.]+ *\S*))?\s*",
    re.IGNORECASE,
)


Rating = Mapping[str, str]
"""What a data sheet states of a valve, in its own units.

The ``size``, an area or a nominal flow, is that at the input ``at``; the valve begins to open at ``begin``, "": zero.
``input`` opens it, "": it is of both valves. ``text`` is all of it.
"""


@dataclass(frozen=True)
class Scale:
    """How a recorded input [``unit``] becomes the model's: less ``less``, times ``gain``, plus ``offset`` [SI]."""

    unit: str
    less: float
    gain: float
    offset: float
    model_unit: str

    def entry(self, column: RecordedColumn) -> tuple[str, dict[int, Array]]:
        """The formula of ``[columns]`` of an input, and its numbers.

        Raises:
            InputError: the column has another unit.
        """
        term = column.formula or column.term
        less = f'({term} - "{self.less:.6g} {self.unit}")' if self.less else f"({term})"
        gain = f"{self.gain:.6g} {self.model_unit}/({self.unit})"
        try:
            numbers = {
                i: (convert(v, column.unit, self.unit) - self.less) * self.gain + self.offset
                for i, v in column.values.items()
            }
        except UnitError as error:
            message = f"{column.name}, which opens a valve: {error}"
            raise InputError(f"{message}; state --valve at such an input, as {EXAMPLES}") from None
        return f'{less} * "{gain}" + "{self.offset:.6g} {self.model_unit}"', numbers


def rating_of(text: str) -> Rating:
    """Reads what a user states of a valve.

    Raises:
        InputError: it is written otherwise.
    """
    match = _RATING.fullmatch(text)
    if match is None:
        raise InputError(f"--valve {shown(text)} is not understood; write {EXAMPLES}")
    return {**match.groupdict(default=""), "text": text}


def opening_unit(text: str) -> str:
    """The unit of what opens the valves by their data sheets; "" where they state none.

    Raises:
        InputError: they are written otherwise.
    """
    return next((unit for rating in _ratings_in(text) if (unit := _unit_at(rating))), "")


def _ratings_in(text: str) -> Iterator[Rating]:
    """The sentences of a text, which semicolons separate."""
    return map(rating_of, filter(str.strip, text.split(";")))


def _unit_at(rating: Rating) -> str:
    return rating["at"].lstrip("0123456789. ")


def ratings(text: str, bench: Bench) -> tuple[dict[str, Scale], dict[str, float]]:
    """What data sheets state of valves: scales of the inputs that open them, and values of parameters by name.

    Sentences are separated by semicolons, each of one valve ("u_in=0.8 mm2 at 250 mA") or of both. An area is
    that of the opening: what the jet leaves of it stays with the parameter that calibrates the valves.

    Raises:
        InputError: it is written otherwise, the bench has no such valve, or a unit does not fit.
    """
    scales, values = dict[str, Scale](), dict[str, float]()
    for rating in _ratings_in(text):
        inputs = {
            n: v for n, v in bench.interface.inputs.items() if bench.meanings[n].roles & VALVES
        }
        if rating["input"] and rating["input"] not in inputs:
            valves = f"the valves of {', '.join(inputs)}" if inputs else "none"
            message = f"no valve has this input; the bench has {valves}"
            raise InputError(f"--valve {shown(rating['text'])}: {message}")
        name, scale = _calibration(rating, inputs, bench)
        if isinstance(scale, Scale):
            scales |= dict.fromkeys([rating["input"]] if rating["input"] else inputs, scale)
        elif rating["input"] or values:
            message = f"the bench has one area for both valves, {name}; state one --valve without an input"
            raise InputError(f"--valve {shown(rating['text'])}: {message}")
        else:
            values[name] = scale
    return scales, values


def _calibration(
    rating: Rating, inputs: Mapping[str, Variable], bench: Bench
) -> tuple[str, Scale | float]:
    """The parameter that calibrates the valves, and the scale of their inputs, or its value where there is none."""
    unit_at = _unit_at(rating)
    for last, unit, input_unit, slope, begin in bench.headings.vocabulary.data_sheets:
        name = next((n for n in bench.interface.parameters if n.rpartition(".")[2] == last), None)
        if name is None or not inputs or {v.unit for v in inputs.values()} != {input_unit}:
            continue
        try:
            size = _size(rating, unit, bench.headings)
            per_input = parse_quantity(slope, f"{unit}/({input_unit})" if begin else unit)
            if not begin:
                return name, size / per_input / (_number(rating["at"], "1") or 1.0)
            full, less = _number(rating["at"], unit_at), _number(rating["begin"], unit_at)
            if full <= less:
                raise InputError(
                    f"--valve {shown(rating['text'])}: state at which input, as {EXAMPLES}"
                )
            gain = size / per_input / (full - less)
            return name, Scale(unit_at, less, gain, parse_quantity(begin, input_unit), input_unit)
        except UnitError as error:
            raise InputError(
                f"--valve {shown(rating['text'])}: {error}; write {EXAMPLES}"
            ) from None
    raise InputError("--valve: the bench has no valve whose area a data sheet states; leave it out")


def _size(rating: Rating, unit: str, headings: Headings) -> float:
    """The size [``unit``], of a nominal flow by the convention of the vocabulary."""
    for other, of_unit, factor in headings.vocabulary.nominal:
        try:
            size = parse_quantity(rating["size"], other)
        except UnitError:
            continue
        if of_unit == unit:
            return size * parse_quantity(factor, f"{unit}/({other})")
    return parse_quantity(rating["size"], unit)


def _number(text: str, unit: str) -> float:
    """A quantity in a unit; 0 of none."""
    return parse_quantity(text, unit) if text else 0.0
