"""Values that take the place of what a data set states, as a model file keeps them."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from pam_cosim.compiler import ClassTree
from pam_cosim.compiler.class_tree import VENDOR
from pam_cosim.compiler.printing import string_text
from pam_cosim.measurement import DataSet, Run
from pam_cosim.model.references import is_ratio, parameter_of

_TEXT = re.compile(
    r"^(?P<name>.+?) = (?P<value>\S+)(?: in place of (?P<stated>\S+))?(?P<estimated> estimated)?$"
)
KEY = "corrections"
_EQUAL = 1e-9  # relative: values are converted between units


@dataclass(frozen=True)
class Correction:
    """A value of a parameter, an input or an initial state in place of what the data set states [SI].

    Attributes:
        name: of the parameter, the input or the state.
        value: that counts.
        stated: by the data set when the value was found; None: nothing.
        run: the one run that it is of; empty: all.
        estimated: it was found where the start of its run is estimated.
    """

    name: str
    value: float
    stated: float | None = None
    run: str = ""
    estimated: bool = False

    @property
    def target(self) -> str:
        """The name, of one run with that after it."""
        return f"{self.name}@{self.run}" if self.run else self.name

    def __str__(self) -> str:
        replaced = "" if self.stated is None else f" in place of {self.stated!r}"
        return f"{self.target} = {self.value!r}{replaced}{' estimated' * self.estimated}"

    def applies_to(self, stated: float | None) -> bool:
        """Whether the data set still states what it stated when the value was found."""
        if stated is None or self.stated is None:
            return stated is None and self.stated is None
        return math.isclose(stated, self.stated, rel_tol=_EQUAL)


def corrections_of(data: DataSet, values: Mapping[str, float]) -> tuple[Correction, ...]:
    """Content of a model file in addition to parameter values, so that a comparison repeats the numbers.

    Args:
        data: as it was compared or fitted.
        values: of parameters [SI], with ratios, values of single runs and initial states ("state@run").
    """
    by_run = {run.name: _of_run(data, run, values) for run in data.runs}
    estimated = {run.name for run in data.runs if run.start.mode == "estimated"}
    corrections: list[Correction] = []
    for name in dict.fromkeys(name for of_run in by_run.values() for name in of_run):
        pairs = {of_run.get(name) for of_run in by_run.values()}
        if len(pairs) == 1 and f"{name}@{data.runs[0].name}" not in values:
            corrections.append(Correction(name, *by_run[data.runs[0].name][name]))
        else:
            corrections += [
                Correction(name, *of_run[name], run=run, estimated=run in estimated)
                for run, of_run in by_run.items()
                if name in of_run
            ]
    return tuple(corrections)


def _of_run(
    data: DataSet, run: Run, values: Mapping[str, float]
) -> dict[str, tuple[float, float | None]]:
    """By name: the value in a run, and what the data set states of it; where the two differ in origin."""
    run_parameters = data.parameters_of(run, values)
    end = f"@{run.name}"
    names = [
        *run.replaced,
        *(parameter_of(name) for name in values if is_ratio(name)),
        *(name.removesuffix(end) for name in values if name.endswith(end)),
    ]
    return {
        name: (run_parameters[name], run.replaced.get(name, run.parameters.get(name)))
        for name in dict.fromkeys(names)
        if name in run_parameters
    }


def annotation_of(corrections: Iterable[Correction]) -> str:
    """The Modelica annotation that keeps corrections; empty without any."""
    texts = ", ".join(string_text(str(correction)) for correction in corrections)
    return f"{VENDOR}({KEY}={{{texts}}})" if texts else ""


def corrections_in(tree: ClassTree, classes: Iterable[str]) -> tuple[Correction, ...]:
    """The corrections that classes keep in their annotations; those of an earlier class count before a later one's.

    Args:
        tree: the library with the user's files.
        classes: full names, the most derived one first.
    """
    corrections: dict[tuple[str, str], Correction] = {}
    for name in classes:
        annotation = tree.classes[name].annotations.get(VENDOR, "")
        if KEY not in annotation:
            continue
        for literal in re.findall(r'"((?:[^"\\]|\\.)*)"', annotation):
            correction = parsed_correction(re.sub(r"\\(.)", r"\1", literal))
            if correction is not None:
                corrections.setdefault((correction.name, correction.run), correction)
    return tuple(corrections.values())


def parsed_correction(text: str) -> Correction | None:
    """The correction that a text states, as it prints itself; None: the text is none."""
    match = _TEXT.match(text)
    if match is None:
        return None
    name, _, run = match["name"].partition("@")
    try:
        stated = None if match["stated"] is None else float(match["stated"])
        return Correction(name, float(match["value"]), stated, run, bool(match["estimated"]))
    except ValueError:
        return None
