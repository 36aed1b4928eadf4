"""Steps of a study that drive models from outside, as one function each: one step by step, several coupled."""

from __future__ import annotations

import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from pam_cosim.cosimulation import (
    Connection,
    Controller,
    CoupledFmu,
    Port,
    Rig,
    System,
    connect,
    couple_values,
)
from pam_cosim.cosimulation.parts import Component, check_name, check_once
from pam_cosim.errors import InputError
from pam_cosim.fmu.built_here import is_built_here
from pam_cosim.fmu.read import feedthrough, read_interface
from pam_cosim.model.references import is_fmu
from pam_cosim.model.settings import Setting
from pam_cosim.simulation import models

if TYPE_CHECKING:
    from pam_cosim.cosimulation.toml_read import Written


def start(
    model: str,
    parameters: Mapping[str, Setting] | None = None,
    *,
    outputs: Sequence[str] | None = None,
    start_time: float = 0.0,
    tolerance: float | None = None,
    files: models.Paths = (),
    timeout: float | None = None,
) -> Rig:
    """A model to be driven step by step, as a rig in the laboratory.

    ```python
    with pam.start("Isotonic", {"load.m": "5 kg"}) as rig:
        while rig["x"] < 0.02:
            rig.step("10 ms", u_in=0.35)
        print(rig)
    ```

    Args:
        model: a bench, a Modelica class, a ``.mo`` or an ``.fmu`` file.
        parameters: as in ``simulate``; inputs among them are the first ones.
        outputs: variables to record; default: every output.
        start_time: [s].
        tolerance: relative, of the FMU's solver.
        files: further Modelica files.
        timeout: as in ``simulate``.

    Raises:
        InputError: an unknown model or name, a value that cannot be used.
        SimulationFailure: the model cannot be started.
    """
    simulator = models.opened(model, files, timeout=timeout)
    try:
        return Rig(simulator, parameters, outputs, start_time, tolerance)
    except BaseException:
        simulator.close()
        raise


def couple(
    components: Mapping[str, str | Path | Controller],
    connections: Sequence[str] = (),
    parameters: Mapping[str, Setting] | None = None,
    *,
    samples: Mapping[str, float | str] | None = None,
    title: str = "",
    files: models.Paths = (),
    timeout: float | None = None,
) -> System:
    """A system of FMUs and controllers, to be simulated together.

    ```python
    system = pam.couple(
        {"gas": "CoSimulation.ValveAndGas", "muscle": "CoSimulation.MuscleAndLoad"},
        ["gas.p -> muscle.p", "muscle.V -> gas.V", "muscle.V_flow -> gas.V_flow", "muscle.A -> gas.A"],
        {"muscle.load.m": "5 kg"},
    )
    run = system.simulate(stop_time=1, step="1 ms")
    ```

    Args:
        components: by name, in the order in which Gauss-Seidel takes them: a model as in ``simulate``, or a
            ``controller``.
        connections: "a.output -> b.input"; units are converted.
        parameters: by "component.variable", as in ``simulate``.
        samples: FMUs that act at samples as a controller does, by name: their distance [s], or a text such as "10 ms".
            At each sample one makes a step with the inputs of that time; its outputs are held until the next one, and
            it is never taken back.
        title: for people.
        files: further Modelica files.
        timeout: as in ``simulate``.

    Raises:
        InputError: an unknown model or name, units that do not fit, an input with two sources.
    """
    components_by_name = {
        name: component if isinstance(component, Controller) else _part(name, str(component), files)
        for name, component in components.items()
    }
    joined = tuple(connect(text, components_by_name) for text in connections)
    return System(
        components_by_name,
        joined,
        couple_values(parameters or {}, components_by_name),
        timeout,
        title,
    ).sampling(samples or {})


def _part(name: str, model: str, files: models.Paths) -> CoupledFmu:
    path = models.build(model, files=files)
    return CoupledFmu(
        name,
        model,
        path,
        read_interface(path),
        *feedthrough(path),
        foreign=is_fmu(model) and not is_built_here(path),
    )


def read_system(
    path: Path | str,
    controllers: Mapping[str, Controller] | None = None,
    parameters: Mapping[str, Setting] | None = None,
    *,
    files: models.Paths = (),
    timeout: float | None = None,
) -> System:
    """A coupled system from a file: ``.toml`` as a person writes it, or ``.ssp`` as other tools do.

    Args:
        path: of the file.
        controllers: components in Python, by name: a file never brings code of its own.
        parameters: as in ``couple``; they go before those in the file.
        files: further Modelica files.
        timeout: as in ``simulate``.

    Raises:
        InputError: no such file, or with the place of what cannot be used in it.
    """
    file = Path(path)
    if file.suffix == ".ssp":
        return _from_ssp(file, controllers or {}, parameters or {}, timeout)
    if file.suffix != ".toml":
        raise InputError("a system is described by a .toml or an .ssp file", file)
    return _from_toml(file, controllers or {}, parameters or {}, files, timeout)


def _from_toml(
    file: Path,
    controllers: Mapping[str, Controller],
    parameters: Mapping[str, Setting],
    files: models.Paths,
    timeout: float | None,
) -> System:
    """As ``couple``, step by step, so that whatever is wrong has its line."""
    from pam_cosim.cosimulation.toml_read import read_toml

    written = read_toml(file)
    if not controllers.keys().isdisjoint(written.components):
        raise InputError(
            f"a controller has the name of a component: {', '.join(controllers)}", file
        )
    components: dict[str, Component] = {}
    for name, model in written.components.items():
        with written.at("components", name):
            check_name(name)
            components[name] = _part(name, model, files)
    components |= controllers
    joined = _connections(written, components)
    for name, value in written.parameters.items():
        if name not in parameters:
            with written.at("parameters", name):
                couple_values({name: value}, components)
                check_once(joined, {name: "a value"})
    try:
        values = couple_values({**written.parameters, **parameters}, components)
        system = System(components, joined, values, timeout, written.title, written.stop_time)
    except InputError as problem:
        raise problem if problem.file else InputError(problem.message, file) from problem
    for name, interval in written.samples.items():
        with written.at("samples", name):
            system = system.sampling({name: interval})
    return system


def _connections(written: Written, components: Mapping[str, Component]) -> tuple[Connection, ...]:
    """The connections of a file; an input with two gets an error with the line of the second one."""
    joined: list[Connection] = []
    connected_inputs: set[Port] = set()
    for text in written.connections:
        with written.at("connections", text):
            joined.append(connect(text, components))
            if joined[-1].target in connected_inputs:
                check_once(tuple(joined), {})
            connected_inputs.add(joined[-1].target)
    return tuple(joined)


def _from_ssp(
    file: Path,
    controllers: Mapping[str, Controller],
    parameters: Mapping[str, Setting],
    timeout: float | None,
) -> System:
    from pam_cosim.cosimulation.ssp_read import read_ssp

    if controllers:
        raise InputError(
            "a controller in Python has no connections in an SSP archive; describe the system as .toml",
            file,
        )
    if not file.exists():
        raise InputError("there is no such file", file)
    scratch = tempfile.TemporaryDirectory(prefix="pam-cosim-ssp-")
    try:
        archive = read_ssp(file, Path(scratch.name), lambda name, fmu: _part(name, str(fmu), ()))
        values = couple_values({**archive.parameters, **parameters}, archive.parts)
        return System(
            archive.parts,
            archive.connections,
            values,
            timeout,
            archive.title,
            archive.stop_time,
            scratch,
        )
    except InputError as problem:
        scratch.cleanup()
        raise problem if problem.file else InputError(problem.message, file) from problem


def write_system(
    system: System, path: Path | str, *, ssp: str = "1.0", connectors: bool = True
) -> Path:
    """Writes a system as an archive of SSP, ``.ssp``, with its FMUs and parameter values.

    Args:
        system: the components and their connections.
        path: the archive.
        ssp: version of the standard, "1.0" or "2.0".
        connectors: whether open inputs and all outputs are connectors of the system, by which other tools drive and
            read it; libcosim and ecos cannot open a system that has connectors.

    Raises:
        InputError: a controller in Python, which an archive cannot hold; the file cannot be written; no such version.
    """
    file = Path(path)
    if file.suffix != ".ssp":
        raise InputError("a system is written as SSP: name a file that ends in .ssp", file)
    from pam_cosim.cosimulation.ssp_write import write_ssp

    return write_ssp(system, file, version=ssp, connectors=connectors)
