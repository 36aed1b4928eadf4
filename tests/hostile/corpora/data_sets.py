# ruff: noqa: E501  # texts of files
"""Hostile data sets: what is put in the place of files of a good one; a text, bytes, or something made by a function."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

Content = str | bytes | Callable[[Path], None]

CSV = "time [s],u_in [A],u_out [A],p_supply [kPa],p [kPa],x [mm],T [degC]\n"
ROW = "{t},0.35,0,207,{p},{x},20\n"


def recording(*rows: str, header: str = CSV) -> str:
    return header + "".join(rows)


def rows(p: str = "1", x: str = "1", count: int = 40) -> list[str]:
    return [ROW.format(t=round(0.02 * i, 3), p=p, x=x) for i in range(count)]


def experiment(
    more: str = "", top: str = "", run: str = "", fit: str = "", signal: str = 'sigma = "0.5 kPa"'
) -> str:
    return (
        f'model = "PneumaticMuscle.Benches.Isotonic"\n{top}\n[signals.p]\n{signal}\n[signals.x]\nsigma = "0.2 mm"\n'
        f'[fit]\n"valve.C_A" = {{ min = 0.5, max = 0.9 }}\n{fit}\n[[runs]]\nfile = "run-01.csv"\ninterpolation = "previous"\n{run}\n{more}\n'
    )


def fifo(path: Path) -> None:
    os.mkfifo(path)


def endless(path: Path) -> None:
    path.symlink_to("/dev/zero")


def circle(path: Path) -> None:
    path.symlink_to(path.name)


def folder(path: Path) -> None:
    path.mkdir()


def sparse(path: Path) -> None:
    with path.open("wb") as file:
        file.truncate(1 << 40)


E, R = "experiment.toml", "run-01.csv"
GOOD = recording(*rows())
LONG = 1_000_000

REFUSED: dict[str, dict[str, Content]] = {
    # files
    "the description is a pipe": {E: fifo},
    "the description is endless": {E: endless},
    "the description is a folder": {E: folder},
    "the description is a terabyte": {E: sparse},
    "the recording is a pipe": {R: fifo},
    "the recording is endless": {R: endless},
    "the recording is /dev/zero by its name": {E: experiment().replace("run-01.csv", "/dev/zero")},
    "nothing": {E: b""},
    "bytes": {E: bytes(range(256)) * 100},
    "only zeros": {R: b"\0" * 100_000},
    # lengths
    "a cell of a million digits": {R: recording(*rows(p="1" * LONG, count=1), *rows())},
    "a cell of a million blanks in quotes": {
        R: recording(*rows(p='"x' + " " * LONG + '"', count=1), *rows())
    },
    "a cell of groups": {R: recording(*rows(p="1.234" + ".567" * 250_000, count=1), *rows())},
    "a heading of a million letters": {R: recording(*rows(), header="x" * LONG + CSV)},
    "a heading of a million blanks": {
        R: recording(*rows(), header="time [s],x" + " " * LONG + "y,a,b,c,d,e\n")
    },
    "a unit of a million letters": {R: recording(*rows(), header=CSV.replace("mm", "m" * LONG))},
    "a line of a million cells": {R: recording("0," * LONG + "\n", *rows())},
    "a header of 100000 columns": {
        R: ",".join(f"c{i}" for i in range(100_000)) + "\n" + ",".join("1" * 100_000) + "\n"
    },
    "quotes that do not close": {R: recording(*[f'"{row}' for row in rows(count=5000)])},
    "a key of a million letters": {E: experiment(more="k" * LONG + " = 1")},
    "a key of 100000 parts": {E: experiment(top=".".join("k" * 100_000) + " = 1")},
    "an unknown key of 2000 lines": {E: experiment(more="unknown = [\n" + "1,\n" * 2000 + "]")},
    "20000 unknown keys": {E: experiment(more="".join(f"unknown{i} = 1\n" for i in range(20_000)))},
    "arrays 10000 deep": {E: experiment(more="unknown = " + "[" * 10_000 + "]" * 10_000)},
    "tables 2000 deep": {E: experiment(more="unknown = " + "{a = " * 2000 + "1" + "}" * 2000)},
    "a number of 5000 digits": {E: experiment(more="unknown = " + "9" * 5000)},
    "a value of a million blanks": {
        E: experiment(run='parameters = {"load.m" = "1' + " " * LONG + 'x"}')
    },
    "a unit of powers": {E: experiment(run='parameters = {"load.m" = "1 ' + "kg^99" * 10 + '"}')},
    "a formula of 300 brackets": {
        E: experiment(more='[columns]\nx = { formula = "' + "(" * 149 + "1" + ")" * 149 + '" }')
    },
    "a name of a file of 100000 letters": {E: experiment().replace("run-01.csv", "x" * 100_000)},
    "10000 runs": {E: experiment(more='[[runs]]\nfile = "none.csv"\n' * 10_000)},
    # numbers
    "a value of 1e400": {R: recording(*rows(p="1e400"))},
    "a mass of 1e300": {E: experiment(run='parameters = {"load.m" = "1e300 kg"}')},
    "values of 1e300": {R: recording(*rows(p="1e300", x="-1e300"))},
    "a noise of 1e300": {E: experiment(signal='sigma = "1e300 kPa"')},
    "one signal without samples": {R: recording(*rows(p=""))},
    "resampled to zero": {E: experiment(top='[recording]\nresample = "0 s"')},
    "resampled to eternity": {E: experiment(top='[recording]\nresample = "1e300 s"')},
    "a noise that is negative in another unit": {E: experiment(signal='sigma = "-1e-320 kPa"')},
    "a fit to infinity": {E: experiment(fit='"muscle.mu_fb" = { min = 0, max = inf }')},
    "time that stands": {R: recording(*[ROW.format(t=0, p=1, x=1)] * 40)},
    "a length in hertz": {R: recording(*rows(), header=CSV.replace("mm", "Hz"))},
    "time of 1e300": {R: recording(*[ROW.format(t=f"{i}e300", p=1, x=1) for i in range(40)])},
    "a foreign model with slashes": {
        E: experiment().replace("PneumaticMuscle.Benches.Isotonic", "../../etc/passwd")
    },
    "markup in a title": {
        E: experiment(top='title = "[bold]x[/] <script>alert(1)</script> \\u001b[31m"')
    },
}
"""One sentence on standard error with the file's name, status 2, nothing written."""

TAKEN: dict[str, dict[str, Content]] = {
    "time of 1e90": {R: recording(*[ROW.format(t=f"{i}e90", p=1, x=1) for i in range(40)])},
    "resampled to nothing": {E: experiment(top='[recording]\nresample = "1e-300 s"')},
    "one sample": {R: recording(*rows(p=""), ROW.format(t=5, p=1, x=2))},
    "no signals": {
        E: experiment().replace("[signals.p]", "[signals.T]").replace('"0.5 kPa"', '"1 K"')
    },
    "a title with dollars and markup": {
        E: experiment(
            top='title = "$(touch MADE) `touch MADE` </title><script>x</script> $\\\\frac{$ [red]"'
        )
    },
}
"""Strange, but data: a result with status 0, or a sentence with status 1 or 2; never a traceback."""
