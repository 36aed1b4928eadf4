"""All classes that a compile can see: the library directory and the user's files."""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence
from functools import lru_cache, partial
from pathlib import Path

from pam_cosim.compiler import names
from pam_cosim.compiler.budget import LIMITS, bounded
from pam_cosim.compiler.parser import parse_source
from pam_cosim.compiler.source import SourceText
from pam_cosim.compiler.syntax import ClassDefinition
from pam_cosim.errors import ModelError
from pam_cosim.files import PACKAGE, read_file
from pam_cosim.wording import closest

Signature = tuple[tuple[str, int, int], ...]


class Library:
    """Class definitions by name.

    Attributes:
        top: classes without a package, the library's packages first.
    """

    def __init__(self, root: Path | None, files: Sequence[Path] = ()) -> None:
        self.top: dict[str, ClassDefinition] = {}
        self.inserted: dict[str, ClassDefinition] = {}
        self.user_classes: dict[Path, list[ClassDefinition]] = {}
        if root is not None:
            if not root.is_dir():
                raise ModelError("the Modelica library directory does not exist", root)
            self.top.update(_packages(root, signature_of(root)))
        self._own = frozenset(self.top)
        self._apart: set[ClassDefinition] = set()
        read: dict[Path, list[ClassDefinition]] = {}
        for file in files:  # one that is named twice, or in two ways, is one file
            folder = package_folder(file)
            place = (folder or file).resolve()
            if place not in read:
                read[place] = (
                    self._read_user_file(file)
                    if folder is None
                    else self._read_user_package(folder)
                )
            self.user_classes[file] = read[place]

    def find(self, qualified_name: str) -> ClassDefinition | None:
        """The class of that full name, without inheritance."""
        if qualified_name in self.inserted:
            return self.inserted[qualified_name]
        first, *rest = names.parts(qualified_name)
        node = self.top.get(first)
        for name in rest:
            node = node.classes.get(name) if node is not None else None
        return node

    def walk(self) -> Iterator[ClassDefinition]:
        """Every class, parents before their children, except of libraries that use none of the project's own."""
        tops = [node for node in self.top.values() if node not in self._apart]
        stack = list(reversed([*tops, *self.inserted.values()]))
        while stack:
            node = stack.pop()
            yield node
            stack.extend(reversed(list(node.classes.values())))

    def similar(self, name: str, kind: str = "") -> str:
        """A hint to classes of the same last name, or of one that is nearly the same; empty where there are none."""
        by_name: dict[str, list[str]] = {}
        for node in self.walk():
            if (node.parent is None or node.parent.kind == "package") and kind in ("", node.kind):
                by_name.setdefault(node.name.lower(), []).append(node.qualified_name)
        last = names.last(name).lower()
        suggestions = by_name.get(last) or [
            n for close in closest(last, by_name, 2) for n in by_name[close]
        ]
        return f"; did you mean {' or '.join(suggestions)}?" if suggestions else ""

    def _read_user_package(self, folder: Path) -> list[ClassDefinition]:
        package = _package(folder, signature_of(folder))
        if self._is_taken(package.name):
            raise _exists(package, package.name)
        uses = _uses(package)
        if uses is not None and not uses & self._own:
            self._apart.add(package)
        self.top[package.name] = package
        for name in sorted(uses or ()):
            self._read_used(folder.parent, name)
        return [package]

    def _read_used(self, place: Path, name: str) -> None:
        """A library that another library uses, where both are in one folder."""
        for path in (place / name, *sorted(place.glob(f"{name} *")), place / f"{name}.mo"):
            if not self._is_taken(name) and (path.suffix == ".mo" or (path / PACKAGE).is_file()):
                if path.is_file():
                    self._read_user_file(path)
                elif path.is_dir():
                    self._read_user_package(path)

    def _is_taken(self, name: str) -> bool:
        return name in self.top or name in names.PREDEFINED

    def _read_user_file(self, file: Path) -> list[ClassDefinition]:
        within, classes = parse_source(_read(file))
        for node in classes:
            if within:
                parent = self.find(".".join(within))
                if parent is None:
                    raise ModelError(
                        f"'within {'.'.join(within)}': there is no such package", file, 1, 1
                    )
                node.parent = parent
                place = node.qualified_name
                existing = self.inserted.get(place, parent.classes.get(node.name))
                if existing is not None and not _is_copy(node, existing):
                    raise _exists(node, place)
                self.inserted[place] = node
            elif node.name in self.top and _is_copy(node, self.top[node.name]):
                continue
            elif self._is_taken(node.name):
                raise _exists(node, node.name)
            else:
                self.top[node.name] = node
        return classes


def _exists(node: ClassDefinition, name: str) -> ModelError:
    return node.source.error(f"a class '{name}' exists already: choose another name", node.at)


def _is_copy(node: ClassDefinition, existing: ClassDefinition) -> bool:
    """Whether a file with one of two classes of a name stands whole in that of the other: they are one class.

    A model that is written with what it extends can so be used together with the file of that.
    """
    text, existing_text = node.source.text.strip(), existing.source.text.strip()
    return text in existing_text or existing_text in text


def source_bytes(file: Path) -> bytes:
    """What a Modelica file holds.

    Raises:
        ModelError: it is not there, or cannot be read.
        InputError: it is no file, or larger than any model.
    """
    try:
        return read_file(file, 4 * LIMITS.file)
    except FileNotFoundError:
        raise ModelError("there is no such file", file) from None
    except OSError as error:
        raise ModelError(f"the file cannot be read: {error}", file) from None


def _read(file: Path) -> SourceText:
    try:
        return SourceText(file, source_bytes(file).decode("utf-8-sig").replace("\r\n", "\n"))
    except UnicodeDecodeError as error:
        raise ModelError(f"the file cannot be read: {error}", file) from None


def package_folder(file: Path) -> Path | None:
    """The folder of a package that is kept in one, named by itself or by its ``package.mo`` (Modelica 3.6, 13.4.1).

    Raises:
        ModelError: a folder that is none of a package.
    """
    if file.is_dir():
        if not (file / PACKAGE).is_file():
            raise ModelError(f"the folder is no Modelica package: it has no {PACKAGE}", file)
        return file
    return file.absolute().parent if file.name == PACKAGE and file.is_file() else None


def modelica_files(folder: Path) -> list[Path]:
    """Every ``.mo`` file below a folder, in a fixed order."""
    return [Path(name) for name, _, _ in signature_of(folder)]


def files_of(file: Path) -> list[Path]:
    """What belongs to a user's file: itself, or all files of the package that is kept in its folder."""
    folder = package_folder(file)
    return [file] if folder is None else modelica_files(folder)


def signature_of(folder: Path) -> Signature:
    """What changes when a ``.mo`` file below a folder does, in the order of ``modelica_files``."""
    return tuple(_signed(str(folder)))


def _signed(folder: str) -> Iterator[tuple[str, int, int]]:
    """Found by one listing of each folder, for every compile."""
    try:
        with os.scandir(folder) as found:
            entries = sorted(found, key=lambda entry: entry.name)
    except OSError:  # a folder that cannot be read has no classes
        return
    for entry in entries:
        if entry.is_dir(follow_symlinks=False):
            yield from _signed(entry.path)
        elif entry.name.endswith(".mo"):
            status = entry.stat()
            yield entry.path, status.st_mtime_ns, status.st_size


def signature(files: Sequence[Path]) -> Signature:
    """What changes when a file does."""
    return tuple((str(f), s.st_mtime_ns, s.st_size) for f in files for s in [os.stat(f)])


@lru_cache(maxsize=8)
def _package(folder: Path, of: Signature) -> ClassDefinition:
    """The package in a folder; parsed again only when a file has changed."""
    return _read_package(folder, None)


@lru_cache(maxsize=8)
def _packages(root: Path, of: Signature) -> dict[str, ClassDefinition]:
    """The packages below ``root``; parsed again only when a file has changed."""
    top = {}
    for entry in sorted(root.iterdir()):
        if entry.is_dir() and (entry / PACKAGE).exists():
            package = _read_package(entry, None)
            top[package.name] = package
        elif entry.suffix == ".mo":
            top.update((node.name, node) for node in parse_source(_read(entry))[1])
    return top


def _read_package(
    directory: Path, parent: ClassDefinition | None, lazy: bool = False
) -> ClassDefinition:
    file = directory / PACKAGE
    within, classes = parse_source(_read(file))
    # a released version has its number in the name of the folder
    if len(classes) != 1 or classes[0].name not in (directory.name, directory.name.split(" ")[0]):
        raise ModelError(f"package.mo must hold the one package '{directory.name}'", file, 1, 1)
    package = classes[0]
    _check_within(within, parent, file)
    package.parent = parent
    if lazy or _uses(package) is not None:
        _read_later(directory, package)
        return package
    for entry in sorted(directory.iterdir()):
        if entry.is_dir() and (entry / PACKAGE).exists():
            _put(_read_package(entry, package), package)
        elif entry.suffix == ".mo" and entry.name != PACKAGE:
            within, children = parse_source(_read(entry))
            _check_within(within, package, entry)
            for child in children:
                child.parent = package
                _put(child, package)
    return package


def _uses(package: ClassDefinition) -> frozenset[str] | None:
    """The libraries in the annotation ``uses`` of a package (Modelica 3.6, section 18.9.1); None: it has none."""
    uses = package.annotation.argument("uses")
    return None if uses is None else frozenset(a.name for a in uses.modification.arguments)


def _read_later(directory: Path, package: ClassDefinition) -> None:
    """Classes in files of their own, each read on demand; the name of a file is that of its class."""
    for entry in sorted(directory.iterdir()):
        name = entry.name.removesuffix(".mo")
        if entry.name == PACKAGE or name in package.classes:
            continue
        if entry.suffix == ".mo":
            package.classes.later(name, partial(_read_class, entry, name, package))
        elif (entry / PACKAGE).is_file():
            package.classes.later(name, partial(_read_package, entry, package, True))


@bounded
def _read_class(file: Path, name: str, package: ClassDefinition) -> ClassDefinition:
    within, classes = parse_source(_read(file))
    _check_within(within, package, file)
    for child in classes:
        child.parent = package
        if child.name == name:
            return child
    raise ModelError(f"the file must hold the class '{name}'", file, 1, 1)


def _put(child: ClassDefinition, package: ClassDefinition) -> None:
    """Refuses two files of a folder that hold classes of the same name."""
    if child.name in package.classes:
        raise _exists(child, child.qualified_name)
    package.classes[child.name] = child


def _check_within(within: tuple[str, ...], parent: ClassDefinition | None, file: Path) -> None:
    expected = parent.qualified_name if parent is not None else ""
    if ".".join(within) != expected:
        raise ModelError(f"expected 'within {expected};' at the top of the file", file, 1, 1)
