"""A system as a person writes it down: a ``.toml`` file."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from typing import Any

from pam_cosim.errors import InputError
from pam_cosim.files import MOST_TEXT, read_file
from pam_cosim.model.settings import Setting
from pam_cosim.toml_text import line_of, parse_toml
from pam_cosim.units import UnitError, seconds
from pam_cosim.wording import did_you_mean, listed, shown

_KEYS = ("title", "stop_time", "components", "connections", "parameters", "samples")
_FILES = (".fmu", ".mo")


@dataclass(frozen=True)
class Written:
    """The content of such a file, not yet checked against the models.

    Attributes:
        components: name to model; one that is a file is its path, in the folder of this file.
        connections: "a.output -> b.input".
        parameters: by ``component.variable``.
        samples: distance of the samples of FMUs that act as controllers, by name.
        title: for people.
        stop_time: [s], or None.
        file, text: where all this stands.
    """

    components: dict[str, str]
    connections: list[str]
    parameters: dict[str, Setting]
    samples: dict[str, Setting]
    title: str
    stop_time: float | None
    file: Path
    text: str

    @contextmanager
    def at(self, key: str, name: str) -> Iterator[None]:
        """Gives errors that name no file the line of a name under a key, or of a connection."""
        try:
            yield
        except InputError as problem:
            if problem.file:
                raise
            raise InputError(problem.message, self.file, self._line(key, name)) from problem

    def _line(self, key: str, name: str) -> int | None:
        if key != "connections":
            return line_of(self.text, (key, name))
        first = line_of(self.text, (key,)) or 1
        lines = enumerate(self.text.split("\n")[first - 1 :], first)
        return next((n for n, line in lines if f'"{name}"' in line or f"'{name}'" in line), first)


def read_toml(file: Path) -> Written:
    """Reads the file.

    Raises:
        InputError: with the line of what cannot be used.
    """
    try:
        text = read_file(file, MOST_TEXT).decode()
    except (OSError, UnicodeDecodeError) as problem:
        raise InputError(f"cannot be read: {problem}", file) from problem
    content = parse_toml(text, file)

    def wrong(message: str, *path: str | int) -> InputError:
        return InputError(message, file, line_of(text, path))

    for key in content:
        if key not in _KEYS:
            raise wrong(f"unknown key '{key}'; {did_you_mean(key, _KEYS)}", key)
    components, connections = content.get("components"), content.get("connections", [])
    title = content.get("title", "")
    if not isinstance(components, dict) or not components:
        raise InputError("name the components under [components]: NAME = 'MODEL'", file)
    if not isinstance(title, str) or not title.isprintable():
        raise wrong("the title must be one line of text that can be printed", "title")
    if not isinstance(connections, list) or not all(isinstance(c, str) for c in connections):
        raise wrong(
            "connections must be a list of 'a.output -> b.input', above the tables", "connections"
        )
    for name, model in components.items():
        if not isinstance(model, str):
            raise wrong(
                f"component '{name}' must name a model: a bench, a class, or a file",
                "components",
                name,
            )
    parameters, samples = (
        _settings(content.get(key, {}), key, wrong) for key in ("parameters", "samples")
    )
    models = {
        name: _model(model, file, lambda m, n=name: wrong(m, "components", n))
        for name, model in components.items()
    }
    stop_time = _stop_time(content, wrong)
    return Written(models, connections, parameters, samples, title, stop_time, file, text)


def _settings(table: Any, key: str, wrong: Callable[..., InputError]) -> dict[str, Setting]:
    """A table of numbers and texts with units."""
    if not isinstance(table, dict):
        raise wrong(f"{key} must be a table", key)
    for name, value in table.items():
        if isinstance(value, bool) or not isinstance(value, (int, float, str)):
            raise wrong(
                f"'{name}' must be a number or a text with a unit; names with a dot need quotes",
                key,
                name,
            )
    return table


def _stop_time(content: dict[str, Any], wrong: Any) -> float | None:
    value = content.get("stop_time")
    if value is None:
        return None
    try:
        if isinstance(value, bool):
            raise TypeError(f"{value} is no time")
        time = seconds(value)
    except (UnitError, TypeError) as problem:
        raise wrong(f"stop_time: {problem}", "stop_time") from None
    if not time > 0:
        raise wrong("stop_time must be larger than zero", "stop_time")
    return time


def _model(model: str, file: Path, wrong: Any) -> str:
    """A model's name, or the path of a file in the folder of this one."""
    if not model.endswith(_FILES):
        return model
    path = PurePosixPath(model)
    if path.is_absolute() or ".." in path.parts or "\\" in model or ":" in model:
        raise wrong(f"{shown(model)} must lie in the folder of this file")
    path_in_folder = file.parent / Path(*path.parts)
    if not path_in_folder.is_file():
        file_names = listed(sorted(p.name for p in file.parent.iterdir() if p.suffix in _FILES))
        raise wrong(f"there is no file {shown(model)}; in the folder: {file_names}")
    return str(path_in_folder)
