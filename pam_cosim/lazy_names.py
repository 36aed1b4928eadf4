"""Public names of a package that are loaded at their first use.

Their table is the block of imports under ``if TYPE_CHECKING``: the name, the module, and what it is as a comment.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path

_MODULE = re.compile(r"    from (\S+) import")
_NAME = re.compile(r"(\w+),?  # (.+)")


@dataclass(frozen=True)
class LazyNames:
    """Public names with the module of each and a line on each.

    Attributes:
        modules: by name.
        lines: what each name is, by name.
    """

    modules: dict[str, str]
    lines: dict[str, str]

    def load(self, package: str, name: str) -> object:
        """The object of a name.

        Raises:
            AttributeError: the package has no such name.
        """
        if name not in self.modules:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        return getattr(import_module(self.modules[name]), name)

    def text(self) -> str:
        """A line for each name, for ``help``."""
        width = max(map(len, self.lines))
        return "".join(f"\n    {name:<{width}}  {line}" for name, line in self.lines.items())


def lazy_names(file: str) -> LazyNames:
    """Reads the table in the source of a package."""
    names, module = LazyNames({}, {}), ""
    for line in Path(file).read_text(encoding="utf-8").splitlines():
        if match := _MODULE.match(line):
            module = match[1]
        if module and (match := _NAME.search(line)):
            names.modules[match[1]], names.lines[match[1]] = module, match[2]
    return names
