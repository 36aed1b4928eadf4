"""Words to calls: the command ``pam-cosim``. No logic of its own.

A command's module, and what that needs, is loaded when the command is called.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cache, partial
from importlib import import_module
from pathlib import Path
from types import SimpleNamespace
from typing import Annotated, Any, get_args

import typer

from pam_cosim.cli.commands.common import INTERRUPTED, interrupted, remarks, results
from pam_cosim.cli.compilers import with_compiler
from pam_cosim.errors import InputError, SimulationFailure

_RUN = (
    "build",
    "describe",
    "simulate",
    "sweep",
    "couple",
    "linearise",
    "bode",
    "observe",
)
_STUDY = (
    "new",
    "check",
    "compare",
    "fit",
    "diagnose",
    "plan",
    "predict",
    "add",
    "effects",
    "bench",
)
_SHOW = ("workbench", "demo")
COMMANDS = _RUN + _STUDY + _SHOW
_STYLE: dict[str, Any] = {
    "add_completion": False,
    "pretty_exceptions_enable": False,
    "rich_markup_mode": None,
}


class _Commands(Mapping[str, Any]):
    """The commands by name, in the order in which help lists them; each is the function of its name, in its module."""

    def __getitem__(self, name: str) -> Any:
        if name not in COMMANDS:
            raise KeyError(name)
        return _command(name)

    def __iter__(self) -> Iterator[str]:
        return iter(COMMANDS)

    def __len__(self) -> int:
        return len(COMMANDS)


def _coerce(complete: Callable[[], Any], value: Any, param: Any, ctx: Any) -> Any:
    """Texts and paths as typer makes them, without pydantic, which takes as long to load as a short run.

    Args:
        complete: typer's own, which loads pydantic.
        value: what is written in the command line. param: it is of. ctx: of typer.
    """
    many = param.multiple or param.nargs == -1
    if value is None:
        return () if many else None
    kind = param.type_descriptor.annotation
    texts = [value]
    if many:
        (kind,), texts = get_args(kind), value
    # of a path that cannot be read typer has a message
    if (
        kind is str
        or kind is Path
        and all(os.access(t, os.R_OK) or not os.path.exists(t) for t in texts)
    ):
        converted = [*map(kind, texts)]
        return converted if many else converted[0]
    return complete().coerce(value, param=param, ctx=ctx)


class _Coerced:
    """A command whose parameters are made by ``_coerce``, where typer has such: from 0.29 on."""

    def get_params(self, ctx: Any) -> list[Any]:
        """All parameters, ``--help`` included."""
        parameters: list[Any] = super().get_params(ctx)  # type: ignore[misc]
        for parameter in parameters:
            complete = getattr(parameter, "get_runtime_param", None)
            if complete and not isinstance(complete, partial):
                parameter.get_runtime_param = partial(
                    SimpleNamespace, coerce=partial(_coerce, complete)
                )
        return parameters


class _Command(_Coerced, typer.core.TyperCommand):
    """A command in which an option that takes one value is given once: of two, one would be passed over in silence."""

    def parse_args(self, ctx: Any, args: list[str]) -> list[str]:
        """Also raises InputError where such an option is given twice."""
        _, _, given = self.make_parser(ctx).parse_args(args=list(args))
        for option in given:
            takes_one = not (getattr(option, "is_flag", True) or getattr(option, "multiple", True))
            if takes_one and given.count(option) > 1:
                raise InputError(
                    f"{option.opts[0]} is given {given.count(option)} times; it takes one value"
                )
        return super().parse_args(ctx, args)


@cache
def _command(name: str) -> Any:
    alone = typer.Typer(**_STYLE)
    function = getattr(import_module(f"pam_cosim.cli.commands.{name}"), name)
    alone.command(name, cls=_Command)(with_compiler(function))
    return typer.main.get_command(alone)


_COMMANDS = _Commands()


class _Group(_Coerced, typer.core.TyperGroup):
    """All commands under one name."""

    def __init__(self, **options: Any) -> None:
        super().__init__(**options | {"commands": _COMMANDS})


def load(arguments: Sequence[str]) -> None:
    """Loads what the words of a command line call, if that can be seen from the first of them."""
    if arguments and arguments[0] in COMMANDS:
        _command(arguments[0])


app = typer.Typer(
    cls=_Group,
    no_args_is_help=True,
    help="Compare models with measurements and find the physical effect they lack.",
    **_STYLE,
)


@app.callback(invoke_without_command=True)
def version(
    shown: Annotated[
        bool, typer.Option("--version", help="Print the version.", is_eager=True)
    ] = False,
) -> None:
    """Compare models with measurements and find the physical effect they lack."""
    if shown:
        from importlib.metadata import version as installed

        typer.echo(f"pam-cosim {installed('pam-cosim')}")
        raise typer.Exit


def main(arguments: list[str] | None = None) -> int:
    """Runs the command; 0 when done, 2 when the input cannot be used, 1 when a simulation failed, 130 on Ctrl-C."""
    results.clear()
    remarks.clear()
    try:
        app(args=arguments)
    except KeyboardInterrupt:
        return interrupted()
    except SystemExit as end:  # typer has printed its own message for words it does not know
        code = end.code if isinstance(end.code, int) else 1
        return interrupted() if code == INTERRUPTED else code
    except InputError as problem:
        print(f"pam-cosim: {problem}", file=sys.stderr)
        return 2
    except SimulationFailure as failure:
        print(f"pam-cosim: the simulation failed: {failure}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
