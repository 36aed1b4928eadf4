"""Runs of one FMU by its model-exchange interface."""

from __future__ import annotations

from pam_cosim.arrays import Array
from pam_cosim.errors import InputError
from pam_cosim.simulation.driver import Callbacks
from pam_cosim.simulation.exchange import ExchangeDriver
from pam_cosim.simulation.instance import Instance, load_instance
from pam_cosim.simulation.plan import Steps
from pam_cosim.simulation.simulator import Simulator
from pam_cosim.simulation.stepper import Stepper


class ExchangeSimulator(Simulator):
    """As ``Simulator``, for the model-exchange interface of an FMU of FMI 2.0 or 3.0, with CVode as the solver.

    Its runs have a limit of processor time, as those of compiled models: it is not the FMU that takes the steps.
    """

    def _load(self) -> None:
        if self._description.modelExchange is None:
            raise InputError("this FMU has no model-exchange interface", self.path)
        self._callbacks = Callbacks()
        self._instance = load_instance(self.path, self._description, self._directory, exchange=True)
        self._slopes = True
        self._instantiate(self._instance)

    def _new_driver(self, instance: Instance) -> ExchangeDriver:
        return ExchangeDriver(instance, self._description, self._callbacks)

    def _steps(self, times: Array) -> Steps:
        """The solver sets inputs at any time."""
        return Steps()

    def stepper(self) -> Stepper:
        """Raises InputError: steps need co-simulation."""
        raise InputError(
            "an FMU is run step by step by its co-simulation interface, which this one lacks",
            self.path,
        )
