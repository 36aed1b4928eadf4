"""A model with some effects, composed, built and kept ready to run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path

from pam_cosim.files import write_text
from pam_cosim.fitting import Free, base_parameters, model_parameter
from pam_cosim.measurement import DataSet, FreeParameter
from pam_cosim.model.references import START_VALUES, is_ratio
from pam_cosim.simulation import AnySimulator, models
from pam_cosim.workbench.catalogue import Catalogue
from pam_cosim.workbench.simulators import Simulators


@dataclass(frozen=True)
class Opened:
    """A model ready to run.

    Attributes:
        model: the base model. effects: what it has beside.
        name: what a call of the public API takes for the model with its effects: the base model, or a Modelica file.
        files: further Modelica files that such a call needs.
        simulators: of that.
        parameters: what may be moved by a slider or a fit, by name.
        origin: the effect that brought a parameter, by its name; none for those of the base model.
        text: Modelica source of the model with effects; "" without any.
        declared: what the data set leaves free.
        estimates_starts: it tells its slopes by start values, which some run's are estimated with.
    """

    model: str
    effects: tuple[str, ...]
    name: str
    files: tuple[Path, ...]
    simulators: Simulators
    parameters: dict[str, Free]
    origin: dict[str, str]
    text: str
    declared: tuple[tuple[str, FreeParameter], ...]
    estimates_starts: bool = False

    @property
    def simulator(self) -> AnySimulator:
        """One of them."""
        return self.simulators.first

    def close(self) -> None:
        """Frees the simulators."""
        self.simulators.close()

    def is_of(self, data: DataSet, model: str, effects: Sequence[str]) -> bool:
        """Whether it is this model, for these data."""
        same = (self.model, self.effects, self.estimates_starts) == (
            model,
            tuple(effects),
            data.estimates_starts,
        )
        return same and self.declared == tuple(data.fit.items())

    def start_values_in(self, values: Mapping[str, float]) -> dict[str, float]:
        """Those of the values that are where a run begins, by "state@run" [SI]."""
        states = self.simulator.interface.states
        return {
            n: v
            for n, v in values.items()
            if n not in self.parameters and n.rpartition("@")[0] in states
        }


def open_model(
    data: DataSet, model: str, effects: Sequence[str], catalogue: Catalogue, scratch: Path
) -> Opened:
    """Composes and builds a model with effects; its source is put into the folder ``scratch``.

    Raises:
        InputError: as ``Catalogue.composed``, or a model that lacks what the data set fits.
    """
    own: dict[str, tuple[str, ...]] = {}
    text, name, needed = "", model, catalogue.files
    if effects:
        composition = catalogue.composed(model, effects)
        text, own = composition.text, composition.parameters
        file = scratch / f"{composition.name}.mo"
        write_text(file, text)
        name, needed = str(file), catalogue.sources(model)
    slopes = [START_VALUES] * data.estimates_starts
    simulators = Simulators(
        models.opened(name, needed, slopes), lambda: models.opened(name, needed, slopes)
    )
    simulator = simulators.first
    try:
        parameters = {free.name: free for free in base_parameters(data, simulator.interface)}
        origin = {}
        for effect, names in own.items():
            for one in names:
                if one not in parameters:
                    parameters[one] = model_parameter(one, simulator.interface)
                    origin[one] = effect
    except BaseException:
        simulators.close()
        raise
    declared = tuple(data.fit.items())
    estimates = data.estimates_starts
    return Opened(
        model,
        tuple(effects),
        name,
        needed,
        simulators,
        parameters,
        origin,
        text,
        declared,
        estimates,
    )


def without_ratios(effects: Sequence[str]) -> tuple[str, ...]:
    """The effects that are part of a model: a ratio to what is stated is none."""
    return tuple(name for name in effects if not is_ratio(name))
