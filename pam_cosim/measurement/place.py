"""Places in ``experiment.toml``, and the quantities stated there, each with its place."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path, PureWindowsPath

from pam_cosim.errors import InputError
from pam_cosim.toml_text import line_of
from pam_cosim.units import UnitError, parse_quantity
from pam_cosim.wording import shown

KeyPath = tuple[str | int, ...]


@dataclass(frozen=True)
class Place:
    """A key of a TOML file, there or missing.

    Attributes:
        file: path of the file.
        text: content of the file.
        keys: keys of tables and numbers of list entries that lead to the key.
    """

    file: Path = Path()
    text: str = ""
    keys: KeyPath = ()

    def __truediv__(self, key: str | int) -> Place:
        return replace(self, keys=(*self.keys, key))

    def error(self, message: str) -> InputError:
        """An error about the key, with its line."""
        return InputError(message, self.file, line_of(self.text, self.keys))

    def file_inside(self, name: str) -> Path:
        """The file called ``name`` at this key: relative, and inside the folder even after symbolic links.

        Raises:
            InputError: the path leaves the folder, or no file is there.
        """
        folder = self.file.parent
        windows = PureWindowsPath(
            name
        )  # Also refuses C:\\x and ..\\x, wherever the data set is read.
        try:
            root, target = folder.resolve(), (folder / name).resolve()
            leaves = (
                windows.anchor
                or ".." in windows.parts
                or not target.is_relative_to(root)
                or target == root
            )
            exists, is_file = target.exists(), target.is_file()
        except (OSError, ValueError, RuntimeError) as error:
            reason = getattr(error, "strerror", None) or "its name cannot be used"
            raise self.error(f"the file {shown(name)} cannot be found: {reason}") from None
        if leaves:
            message = (
                f"the path {shown(name)} leaves the folder of the data set; name a file inside"
            )
            raise self.error(message)
        if not is_file:
            reason = "is not a file" if exists else "does not exist"
            raise self.error(f"the file {shown(name)} {reason} in {folder}")
        return folder / name


@dataclass(frozen=True)
class Stated:
    """A number, or a text with a unit, and its place."""

    value: str | float
    place: Place = Place()

    def quantity(self, unit: str, name: str = "", *, difference: bool = False) -> float:
        """The value in a unit.

        Args:
            unit: to convert to.
            name: subject of the error; "": the key.
            difference: convert as a difference, which matters for temperatures.

        Raises:
            InputError: no quantity, or a unit that does not fit.
        """
        try:
            return parse_quantity(self.value, unit, difference=difference)
        except UnitError as error:
            raise self.place.error(f"{name or self.place.keys[-1]}: {error}") from None

    def above_zero(self, unit: str, name: str = "", *, difference: bool = False) -> float:
        """As ``quantity``; zero and less are errors too."""
        number = self.quantity(unit, name, difference=difference)
        if number <= 0.0:
            raise self.place.error(f"{name or self.place.keys[-1]} must be greater than zero")
        return number
