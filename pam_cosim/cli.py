"""Words to calls: the command ``pam-cosim``. No logic of its own."""

from __future__ import annotations

import sys
from importlib.metadata import version as installed
from typing import Annotated

import typer

from pam_cosim.commands.add import add
from pam_cosim.commands.bench import bench
from pam_cosim.commands.bode import bode
from pam_cosim.commands.build import build
from pam_cosim.commands.check import check
from pam_cosim.commands.common import INTERRUPTED, interrupted, remarks, results
from pam_cosim.commands.compare import compare
from pam_cosim.commands.couple import couple
from pam_cosim.commands.describe import describe
from pam_cosim.commands.diagnose import diagnose
from pam_cosim.commands.effects import effects
from pam_cosim.commands.fit import fit
from pam_cosim.commands.linearise import linearise
from pam_cosim.commands.new import new
from pam_cosim.commands.observe import observe
from pam_cosim.commands.simulate import simulate
from pam_cosim.commands.sweep import sweep
from pam_cosim.commands.track import track
from pam_cosim.commands.workbench import workbench
from pam_cosim.errors import InputError, SimulationFailure

app = typer.Typer(
    no_args_is_help=True,
    add_completion=False,
    pretty_exceptions_enable=False,
    rich_markup_mode=None,
    help="Compare models with measurements and find the physical effect they lack.",
)


@app.callback(invoke_without_command=True)
def version(
    shown: Annotated[bool, typer.Option("--version", help="Say which version this is.", is_eager=True)] = False,
) -> None:
    """Compare models with measurements and find the physical effect they lack."""
    if shown:
        typer.echo(f"pam-cosim {installed('pam-cosim')}")
        raise typer.Exit


_RUN = (build, describe, simulate, sweep, couple, linearise, bode, observe, track)
_STUDY = (new, check, compare, fit, diagnose, add, effects, bench, workbench)
for _command in _RUN + _STUDY:
    app.command()(_command)


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
