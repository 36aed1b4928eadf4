"""A model with some effects, composed, built and kept ready to run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

from pam_cosim.files import write_text
from pam_cosim.fitting import Free, base_parameters, model_parameter
from pam_cosim.measurement import DataSet
from pam_cosim.model.references import START_VALUES, is_ratio
from pam_cosim.simulation import AnySimulator, models
from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.simulators import Simulators


@dataclass(frozen=True)
class Opened:
    """A model ready to run.

    Attributes:
        name: what a call of the public API takes for the model with its effects: the base model, or a Modelica file.
        files: further Modelica files that such a call needs.
        simulators: of that.
        parameters: what may be moved by a slider or a fit, by name.
        origin: the effect that brought a parameter, by its name; none for those of the base model.
        made_for: model, effects, and what of the data set it was made for; see ``made_for``.
    """

    name: str
    files: tuple[Path, ...]
    simulators: Simulators
    parameters: dict[str, Free]
    origin: dict[str, str]
    made_for: object

    @property
    def simulator(self) -> AnySimulator:
        """One of them."""
        return self.simulators.first

    def close(self) -> None:
        """Frees the simulators."""
        self.simulators.close()

    def start_values_in(self, values: Mapping[str, float]) -> dict[str, float]:
        """Those of the values that are where a run begins, by "state@run" [SI]."""
        states = self.simulator.interface.states
        return {
            n: v
            for n, v in values.items()
            if n not in self.parameters and n.rpartition("@")[0] in states
        }


def made_for(data: DataSet, model: str, effects: Sequence[str]) -> object:
    """What an opened model depends on: it serves other data where this is the same."""
    return model, tuple(effects), tuple(data.fit.items()), data.estimates_starts


def open_model(
    data: DataSet, model: str, effects: Sequence[str], catalogue: Catalogue, scratch: Path
) -> Opened:
    """Composes and builds a model with effects; its source is put into the folder ``scratch``.

    Raises:
        InputError: as ``Catalogue.composed``, or a model that lacks what the data set fits.
    """
    parameters_by_effect: dict[str, tuple[str, ...]] = {}
    name, source_files = model, catalogue.files
    if effects:
        composition = catalogue.composed(model, effects)
        parameters_by_effect = composition.parameters
        file = scratch / f"{composition.name}.mo"
        write_text(file, composition.text)
        name, source_files = str(file), catalogue.sources(model)
    opened = partial(models.opened, name, source_files, [START_VALUES] * data.estimates_starts)
    simulators = Simulators(opened(), opened)
    simulator = simulators.first
    try:
        parameters = {free.name: free for free in base_parameters(data, simulator.interface)}
        origin = {}
        for effect, names in parameters_by_effect.items():
            for parameter in names:
                if parameter not in parameters:
                    parameters[parameter] = model_parameter(parameter, simulator.interface)
                    origin[parameter] = effect
    except BaseException:
        simulators.close()
        raise
    key = made_for(data, model, effects)
    return Opened(name, source_files, simulators, parameters, origin, key)


def without_ratios(effects: Sequence[str]) -> tuple[str, ...]:
    """The effects that are part of a model: a ratio to what is stated is none."""
    return tuple(name for name in effects if not is_ratio(name))
