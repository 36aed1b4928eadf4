"""Public names of a package that are loaded at their first use.

Their table is the block of imports under ``if TYPE_CHECKING``: the name, the module, and what it is as a comment.
Every command reads it first, so that this module loads no other.
"""

from __future__ import annotations

from importlib import import_module


class LazyNames:
    """Public names with the module of each and a line on each.

    Args:
        file: the source of the package.

    Attributes:
        modules: by name.
        lines: what each name is, by name.
    """

    def __init__(self, file: str) -> None:
        self.modules: dict[str, str] = {}
        self.lines: dict[str, str] = {}
        module = ""
        with open(file, encoding="utf-8") as source:
            for line in source:
                if line.startswith("    from "):
                    module = line.split()[1]
                code, mark, comment = line.partition("  # ")
                if module and mark:
                    name = code.split()[-1].rstrip(",")
                    self.modules[name], self.lines[name] = module, comment.rstrip()

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
