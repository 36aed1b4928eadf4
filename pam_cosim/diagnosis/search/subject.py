"""What a study of effects begins with: the model, the library that it is of, and the data with their noise."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from pam_cosim.catalogue import EffectClass, domain_of, effect_classes, origins, qualified
from pam_cosim.compiler import ClassTree, Part, read_library, read_structure
from pam_cosim.diagnosis.judgement.events import Remark
from pam_cosim.diagnosis.judgement.message import Message
from pam_cosim.diagnosis.search.stated_parameters import stated_parameters
from pam_cosim.diagnosis.search.trial import run_trial
from pam_cosim.errors import InputError
from pam_cosim.fitting import with_starts
from pam_cosim.fmu import build_model
from pam_cosim.measurement import DataSet, condensed
from pam_cosim.model.interface import Interface
from pam_cosim.model.references import is_fmu, sources_of
from pam_cosim.processes.workers import wake
from pam_cosim.simulation import AnySimulator, Simulator
from pam_cosim.simulation.models import opened
from pam_cosim.starts import starts_are_open


@dataclass(frozen=True)
class Subject:
    """A model whose effects are asked for, and the measurement.

    Attributes:
        name: of the model.
        files: further Modelica files, as stated. sources: with the model's own.
        tree: the Modelica library with these; None: the model is an FMU, to which no effect can be added.
        data: with noise levels, and the words of the model's field.
        means: where very many rows became means: a sentence on it.
    """

    name: str
    files: tuple[Path, ...]
    sources: tuple[Path, ...]
    tree: ClassTree | None
    data: DataSet
    means: str = ""

    @property
    def library(self) -> ClassTree:
        """The Modelica library of a model to which effects can be added.

        Raises:
            InputError: an FMU.
        """
        if self.tree is None:
            message = "effects can be added to a Modelica model only; an FMU can be compared, fitted and checked"
            raise InputError(message, self.name)
        return self.tree

    def simulator(self) -> AnySimulator:
        """The model, with slopes by the free parameters where it is smooth."""
        names = self.data.differentiated
        if self.tree is None:
            return opened(self.name)
        return Simulator(build_model(self.name, self.files, sensitivities=names, where_smooth=True))

    def effects(self, interface: Interface) -> list[EffectClass]:
        """All that the model may lack: effects of the library and of files, and wrong parameters that are stated."""
        if self.tree is None:
            return []
        available_effects = effect_classes(self.tree, origins(self._parts()))
        return [*available_effects, *stated_parameters(self.data, interface)]

    def _parts(self) -> Sequence[Part]:
        return read_structure(qualified(self.library, self.name), files=self.sources).parts


def subject_of(
    data: DataSet,
    model: str | None,
    files: Sequence[Path],
    workers: int | None,
    say: Callable[[Message], None],
) -> Subject:
    """The model, by default the bench of the data set, and the data; processes for trials start meanwhile.

    Very many rows become means (``measurement.condensed``).

    Args:
        data: the measurement.
        model: default: the bench of the data set.
        files: further Modelica files.
        workers: number of processes; 0: this one alone.
        say: told where rows become means.
    """
    name = data.model_for(model)
    sources = sources_of(files, name)
    tree = None if is_fmu(name) else read_library(files=sources)
    data, text = condensed(data)
    if text:
        say(Remark(text).message)
    if tree is not None:
        wake(workers, run_trial.__module__)
        data = replace(data, domain=domain_of(tree, name))
    if starts_are_open(data):
        with opened(name, files) as simulator:
            data = with_starts(simulator, data)
        for sentence in data.starts:
            say(Remark(sentence).message)
    return Subject(name, tuple(files), sources, tree, data, text)
