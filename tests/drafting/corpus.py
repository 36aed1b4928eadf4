"""Recordings of thirteen invented laboratories, each with what it holds: a table, made by a seeded script.

The signals are those of ``labs``: of another form than the library's, with noise. A case is one recording, or a few of
one rig, as a logger writes them; ``truth`` has the signals of the first run under the names of the bench [SI], and
``answer`` is the one thing that a laboratory would state where the file does not say it.
"""

# ruff: noqa: E501, E731 -- a table, a line for each recording
from __future__ import annotations

import io
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np
import scipy.io

from tests.drafting.labs import LENGTH, Array, force, lag, lift, steps

AMBIENT = 101_325.0
PSI, INCH = 6894.757293168, 0.0254


@dataclass(frozen=True)
class Case:
    """One rig as a laboratory hands it over."""

    name: str
    files: Mapping[str, bytes]
    truth: Mapping[str, Array]
    bench: str
    answer: Mapping[str, Any] = field(default_factory=dict)
    stated: Mapping[str, Any] = field(default_factory=dict)
    held: bool | None = None

    def write(self, folder: Path) -> list[Path]:
        """Writes the files into a folder."""
        folder.mkdir(parents=True, exist_ok=True)
        for name, content in self.files.items():
            (folder / name).write_bytes(content)
        return [folder / name for name in self.files]


Signals = dict[str, Array]
Head = tuple[str, str, Callable[[Array], Array]]
"""A heading, the signal below it, and how its numbers follow from that."""


def _noise(values: Array, sigma: float, seed: int) -> Array:
    return np.asarray(values + np.random.default_rng(seed).normal(0.0, sigma, len(values)))


def _regulated(seed: int, mass: float = 2.0) -> Signals:
    """Set point, pressure, contraction and pull of a load that hangs on a muscle."""
    time, p_set = steps([2e5 + 2e4 * seed, 3e5, 1e5], 1.0, 0.01)
    p = lag(p_set, 0.01)
    x = lift(p, 0.01, mass)
    pull = mass * (
        9.81 - np.gradient(np.gradient(np.convolve(x, np.ones(9) / 9, "same"), 0.01), 0.01)
    )
    return {
        "t": time, "p_set": p_set, "p": _noise(p, 300.0, seed), "x": _noise(x, 4e-5, seed + 1),
        "F": _noise(np.clip(pull, 0.5 * mass * 9.81, 2 * mass * 9.81), 0.1, seed + 2),
    }  # fmt: skip


def _valves(seed: int, mass: float = 2.0) -> Signals:
    """Currents of two valves that hold their values, supply, pressure, contraction and temperature."""
    own = _regulated(seed, mass)
    time = own["t"]
    u_in = np.where(
        (time >= 1.0) & (time < 1.4), 0.35, np.where((time >= 2.0) & (time < 2.3), 0.3, 0.0)
    )
    u_out = np.where(time >= 3.0, 0.35, 0.0)
    warm = 294.0 + 4.0 * lag(own["p_set"], 0.01, 0.3) / 3e5
    return own | {
        "u_in": u_in, "u_out": u_out, "p_supply": _noise(np.full(len(time), 5e5), 500.0, seed + 3),
        "T": _noise(warm, 0.2, seed + 4),
    }  # fmt: skip


def _isometric(seed: int, held: float) -> Signals:
    time = 0.01 * np.arange(500)
    p = 4e5 * np.clip(np.sin(np.pi * (time - 1.0) / 4.0), 0.0, None) * (time > 1.0)
    pull = np.asarray(force(p, np.full(500, held)))
    return {
        "t": time, "p": _noise(p, 300.0, seed), "F": _noise(pull, 0.3, seed + 1),
        "s": _noise(np.full(500, held), 1e-5, seed + 2),
    }  # fmt: skip


def _tank(seed: int) -> Signals:
    time = 0.05 * np.arange(400)
    u_in = np.where((time > 2) & (time < 6), 0.3, 0.0)
    u_out = np.where(time > 12, 0.25, 0.0)
    target = np.where(time > 12, 0.0, np.where(time > 2, 4.2e5 + 2e4 * seed, 0.0))
    p = lag(target, 0.05, 2.0)
    T = 293.0 + 6.0 * np.gradient(p, 0.05) / 1e5
    return {
        "t": time, "u_in": u_in, "u_out": u_out, "p": _noise(p, 400.0, seed),
        "T": _noise(T, 0.2, seed + 1), "p_supply": np.full(400, 6e5),
    }  # fmt: skip


def _vessel(seed: int) -> Signals:
    time = 0.1 * np.arange(300)
    p = (6e5 + 2e4 * seed) * np.exp(-time / (4.0 + 0.3 * seed))
    return {
        "t": time,
        "p": _noise(p, 500.0, seed),
        "T": _noise(293.0 - 20 * np.sin(np.minimum(time / 9, 3.0)), 0.3, 1),
    }


def _switched(seed: int) -> Signals:
    own = _regulated(seed)
    time = own["t"]
    return own | {
        "u_in": ((time >= 1) & (time < 1.5)).astype(float), "u_out": (time >= 3).astype(float),
        "p_supply": np.full(len(time), 5e5),
    }  # fmt: skip


def _map(seed: int) -> Signals:
    p, x = (
        one.ravel()
        for one in np.meshgrid(1e5 * np.arange(1.0, 6.0), 0.005 * np.arange(8.0), indexing="ij")
    )
    return {"p": p, "s": x, "x": x, "F": _noise(np.asarray(force(p, x)), 0.5, seed)}


def _text(
    signals: Signals, heads: Sequence[Head], separator: str = ",", decimal: str = ".",
    above: str = "", index: bool = False, encoding: str = "utf-8",
) -> bytes:  # fmt: skip
    rows = np.column_stack([change(signals[name]) for _, name, change in heads])
    lines = [separator.join(head for head, _, _ in heads)]
    lines += [separator.join(f"{v:.6f}".replace(".", decimal) for v in row) for row in rows]
    if index:
        lines = [f"{'' if i == 0 else i - 1}{separator}{line}" for i, line in enumerate(lines)]
    return (above + "\n".join(lines) + "\n").encode(encoding)


def _mat(content: Mapping[str, Any]) -> bytes:
    stream = io.BytesIO()
    scipy.io.savemat(stream, dict(content))
    return stream.getvalue()


def times(factor: float, zero: float = 0.0) -> Callable[[Array], Array]:
    """Numbers of a unit that large [SI], from a zero [unit] on."""
    return lambda values: values / factor + zero


def _same(values: Array) -> Array:
    return values


KPA, BAR, MM, MA, MS = times(1e3), times(1e5), times(1e-3), times(1e-3), times(1e-3)
ABS_BAR = times(1e5, AMBIENT / 1e5)
CELSIUS = times(1.0, -273.15)
FAHRENHEIT: Callable[[Array], Array] = lambda T: (T - 273.15) * 1.8 + 32.0
LEFT: Callable[[Array], Array] = lambda x: 1e3 * (LENGTH - x)
WIRE: Callable[[Array], Array] = lambda x: 312.6 - 1e3 * x
T_S: Head = ("t [s]", "t", _same)
LOAD = {"parameters": {"load.m": "2 kg"}}


def _case(
    lab: str,
    name: str,
    signals: Sequence[Signals],
    heads: Sequence[Head],
    truth: str,
    bench: str,
    **more: Any,
) -> Case:
    """A case of text files, one for each set of signals."""
    kept = {key: more.pop(key) for key in ("answer", "stated", "held") if key in more}
    suffix, stem = more.pop("suffix", "csv"), more.pop("stem", "run")
    files = {f"{stem}{i + 1}.{suffix}": _text(one, heads, **more) for i, one in enumerate(signals)}
    return Case(f"{lab}: {name}", files, {n: signals[0][n] for n in truth.split()}, bench, **kept)


def _regulators() -> Iterator[Case]:
    """Aachen: a regulator and a hanging load."""
    own, three = [_regulated(1)], [_regulated(1), _regulated(2), _regulated(3)]
    bench, truth = "HangingLoad", "p_set p x"
    make = lambda name, signals, heads, **more: _case(
        "regulator", name, signals, heads, truth, bench, **more
    )  # noqa: E731
    yield make(
        "plain",
        three,
        [T_S, ("p_set [kPa]", "p_set", KPA), ("p [kPa]", "p", KPA), ("x [mm]", "x", MM)],
        held=True,
    )
    yield make(
        "german",
        three,
        [
            ("Zeit (ms)", "t", MS),
            ("Solldruck (bar)", "p_set", BAR),
            ("Druck (bar)", "p", BAR),
            ("Weg (mm)", "x", MM),
        ],
        separator=";",
        decimal=",",
        encoding="latin-1",
        held=True,
    )
    yield make(
        "draw wire",
        three,
        [
            ("Time (ms)", "t", MS),
            ("p_soll [bar]", "p_set", BAR),
            ("Druck [bar]", "p", BAR),
            ("Weg_mm", "x", WIRE),
        ],
        separator=";",
        decimal=",",
    )
    yield make(
        "length",
        own,
        [T_S, ("p_ref [bar]", "p_set", BAR), ("p_bar", "p", BAR), ("L_mm", "x", LEFT)],
    )
    yield make(
        "over",
        own,
        [
            ("t/s", "t", _same),
            ("p_soll/bar", "p_set", BAR),
            ("p/kPa(g)", "p", KPA),
            ("x/mm", "x", MM),
        ],
        separator="\t",
    )
    yield make(
        "french",
        own,
        [
            ("temps (s)", "t", _same),
            ("consigne (bar)", "p_set", BAR),
            ("pression (bar)", "p", BAR),
            ("déplacement (mm)", "x", MM),
        ],
        separator="\t",
    )
    yield make(
        "no units",
        own,
        [
            ("time", "t", _same),
            ("setpoint", "p_set", BAR),
            ("pressure", "p", BAR),
            ("position", "x", MM),
        ],
    )


def _currents() -> Iterator[Case]:
    """Bristol: two valves by their currents and a hanging load."""
    two, bench, truth = [_valves(1), _valves(2)], "HangingLoad|Isotonic", "u_in u_out p x"
    make = lambda name, heads, **more: _case(
        "valves", name, two, heads, truth, bench, **{"stated": LOAD, **more}
    )  # noqa: E731
    yield make(
        "mA",
        [
            ("t,ms".replace(",", " [") + "]", "t", MS),
            ("I_in [mA]", "u_in", MA),
            ("I_out [mA]", "u_out", MA),
            ("Vordruck [kPa]", "p_supply", KPA),
            ("pm [kPa]", "p", KPA),
            ("Kontraktion [mm]", "x", MM),
        ],
        held=True,
    )
    yield make(
        "numbered",
        [
            ("Time (ms)", "t", MS),
            ("Druck [bar]", "p", BAR),
            ("Weg_mm", "x", WIRE),
            ("Temp", "T", CELSIUS),
            ("I_valve1 (mA)", "u_in", MA),
            ("I_valve2 (mA)", "u_out", MA),
            ("Versorgung", "p_supply", BAR),
        ],
        separator=";",
        decimal=",",
    )
    yield make(
        "supply not stated",
        [
            ("time [s]", "t", _same),
            ("i_inlet [A]", "u_in", _same),
            ("i_exhaust [A]", "u_out", _same),
            ("p [kPa]", "p", KPA),
            ("contraction [mm]", "x", MM),
        ],
        answer={"parameters": {"p_supply": "5 bar"}},
    )
    yield make(
        "pandas",
        [
            T_S,
            ("I_in [mA]", "u_in", MA),
            ("I_out [mA]", "u_out", MA),
            ("p_supply [kPa]", "p_supply", KPA),
            ("p [kPa]", "p", KPA),
            ("x [mm]", "x", MM),
        ],
        index=True,
    )


def _presses() -> Iterator[Case]:
    """Cottbus: a press that holds the length, in MATLAB's files and texts."""
    runs = [_isometric(k, 0.01 * k) for k in range(3)]

    def mat(name: str, fields: Sequence[Head], **more: Any) -> Case:
        files = {
            f"press_{i}.mat": _mat({"log": {head: change(one[n]) for head, n, change in fields}})
            for i, one in enumerate(runs)
        }
        return Case(
            f"press: {name}",
            files,
            {n: runs[0][n] for n in ("p", "s", "F")},
            "Length|Isometric",
            **more,
        )

    yield mat(
        "no units",
        [("t", "t", _same), ("Druck", "p", KPA), ("Laenge", "s", LEFT), ("Kraft", "F", _same)],
    )
    yield mat(
        "kilograms",
        [
            ("t_ms", "t", MS),
            ("p_kPa", "p", KPA),
            ("L_mm", "s", LEFT),
            ("load_kg", "F", times(9.80665)),
        ],
    )
    text = lambda name, heads, **more: _case(
        "press", name, runs, heads, "p s F", "Length|Isometric", **more
    )  # noqa: E731
    yield text(
        "pull below zero",
        [T_S, ("p [kPa]", "p", KPA), ("L [mm]", "s", LEFT), ("F [N]", "F", times(-1.0))],
    )
    yield text(
        "contraction",
        [T_S, ("Druck [bar]", "p", BAR), ("s [mm]", "s", MM), ("Kraft [N]", "F", _same)],
    )


def _tanks() -> Iterator[Case]:
    """Dresden: a steel tank that is filled and emptied."""
    two = [_tank(1), _tank(2)]
    supply = {"parameters": {"p_supply": "6 bar"}}
    make = lambda name, heads, **more: _case(
        "tank", name, two, heads, "u_in u_out p T", "TankFilling", **more
    )  # noqa: E731
    yield make(
        "german",
        [
            ("Zeit [s]", "t", _same),
            ("I_ein [mA]", "u_in", MA),
            ("I_aus [mA]", "u_out", MA),
            ("p_abs [bar]", "p", ABS_BAR),
            ("T_Gas [°C]", "T", CELSIUS),
        ],
        separator=";",
        decimal=",",
        stated=supply,
        suffix="txt",
    )
    yield make(
        "fahrenheit",
        [
            ("time_s", "t", _same),
            ("i_in_mA", "u_in", MA),
            ("i_out_mA", "u_out", MA),
            ("supply_psi", "p_supply", times(PSI)),
            ("tank_p_psi", "p", times(PSI)),
            ("T_degF", "T", FAHRENHEIT),
        ],
        answer={"columns": {"p": "tank_p_psi", "p_supply": "supply_psi"}},
    )
    yield make(
        "supply not stated",
        [
            ("t (s)", "t", _same),
            ("I_in (mA)", "u_in", MA),
            ("I_out (mA)", "u_out", MA),
            ("p (bar)", "p", BAR),
            ("T (°C)", "T", CELSIUS),
        ],
        answer=supply,
    )


def _vessels() -> Iterator[Case]:
    """Urbana: a vessel that empties through an orifice."""
    two = [_vessel(1), _vessel(2)]
    make = lambda name, heads, **more: _case(
        "vessel", name, two, heads, "p T", "VesselOrifice", **more
    )  # noqa: E731
    yield make(
        "absolute",
        [("time_s", "t", _same), ("pressure_bar_abs", "p", ABS_BAR), ("T_K", "T", _same)],
    )
    yield make(
        "german",
        [("Zeit (s)", "t", _same), ("Druck (bar)", "p", BAR), ("Temperatur (°C)", "T", CELSIUS)],
        separator=";",
        decimal=",",
    )
    yield make(
        "switch beside",
        [
            T_S,
            ("TP3 [bar]", "p", BAR),
            ("gas temperature [degC]", "T", CELSIUS),
            ("Pressure_switch", "t", lambda t: (t < 20).astype(float)),
        ],
    )
    yield make(
        "psia",
        [
            ("t (ms)", "t", MS),
            ("Tank pressure (psia)", "p", times(PSI, AMBIENT / PSI)),
            ("Gas temperature (°C)", "T", CELSIUS),
        ],
        answer={"columns": {"p": "Tank pressure"}},
    )


def _switches() -> Iterator[Case]:
    """Trondheim: valves that are open or shut."""
    two = [_switched(1), _switched(2)]
    make = lambda name, heads, **more: _case(
        "switches",
        name,
        two,
        heads,
        "u_in u_out p x",
        "HangingLoad|SwitchedMuscle",
        **{"stated": LOAD, "held": True, **more},
    )  # noqa: E731
    supply = ("p_supply [bar]", "p_supply", BAR)
    yield make(
        "german",
        [
            ("t [s]", "t", _same),
            ("Einlassventil", "u_in", _same),
            ("Auslassventil", "u_out", _same),
            ("Vordruck [bar]", "p_supply", BAR),
            ("Druck [bar]", "p", BAR),
            ("Weg [mm]", "x", MM),
        ],
        separator=";",
        decimal=",",
    )
    yield make(
        "duty",
        [
            ("time_ms", "t", MS),
            ("duty_in [%]", "u_in", times(0.01)),
            ("duty_out [%]", "u_out", times(0.01)),
            ("psup_kPa", "p_supply", KPA),
            ("p_kPa", "p", KPA),
            ("x_mm", "x", MM),
        ],
    )
    yield make(
        "fill and vent",
        [
            T_S,
            ("fill valve", "u_in", _same),
            ("vent valve", "u_out", _same),
            ("supply pressure [psi]", "p_supply", times(PSI)),
            ("muscle pressure [psi]", "p", times(PSI)),
            ("displacement [mm]", "x", MM),
        ],
    )
    words: Callable[[bytes], bytes] = lambda text: b"\n".join(
        b",".join(
            [cells[0], *(b"ON" if c == b"1.000000" else b"OFF" for c in cells[1:3]), *cells[3:]]
        )
        if i
        else line
        for i, line in enumerate(text.splitlines())
        for cells in [line.split(b",")]
    )
    plain = make(
        "words",
        [
            T_S,
            ("valve in", "u_in", _same),
            ("valve out", "u_out", _same),
            supply,
            ("p [bar]", "p", BAR),
            ("x [mm]", "x", MM),
        ],
    )
    yield Case(
        plain.name,
        {n: words(c) for n, c in plain.files.items()},
        plain.truth,
        plain.bench,
        stated=LOAD,
        held=True,
    )


def _maps() -> Iterator[Case]:
    """Esslingen: points at rest in a table."""
    make = lambda name, heads, **more: _case(
        "map", name, [_map(1)], heads, "p s F", "QuasiStaticIsometric", **more
    )  # noqa: E731
    yield make("words", [("pressure", "p", KPA), ("contraction", "x", MM), ("force", "F", _same)])
    yield make(
        "german",
        [("Druck [bar]", "p", BAR), ("Kontraktion [mm]", "x", MM), ("Kraft [N]", "F", _same)],
        separator=";",
        decimal=",",
    )
    yield make(
        "psi",
        [
            ("Pressure (psi)", "p", times(PSI)),
            ("Contraction (mm)", "x", MM),
            ("Force (lbf)", "F", times(4.4482216152605)),
        ],
    )
    yield make(
        "ratio",
        [("p_bar", "p", BAR), ("strain_pct", "x", times(LENGTH / 100)), ("F_N", "F", _same)],
        stated={"parameters": {"muscle.L0": "240 mm"}},
    )
    yield make("length", [("p_MPa", "p", times(1e6)), ("L_mm", "x", LEFT), ("F_N", "F", _same)])


def _pairs() -> Iterator[Case]:
    """Graz: every signal with the times of its own."""
    own = _regulated(1)
    truth = {n: own[n] for n in ("p_set", "p", "x")}
    scaled = {"p_set": BAR(own["p_set"]), "p": BAR(own["p"]), "x": MM(own["x"])}
    nested = {"out": {n: {"Time": own["t"], "Data": v} for n, v in scaled.items()}}
    make = lambda name, files, **more: Case(f"pairs: {name}", files, truth, "HangingLoad", **more)  # noqa: E731
    yield make("structures", {"log.mat": _mat(nested)})
    for name, time, data in (
        ("dotted", "{}.Time", "{}.Data"),
        ("t first", "t_{}", "{}"),
        ("brackets", "{}.Time [s]", "{}.Data [{}]"),
    ):
        units = {"p_set": "bar", "p": "bar", "x": "mm"}
        heads: list[Head] = [
            h
            for n in scaled
            for h in (
                (time.format(n), "t", _same),
                (data.format(n, units[n]), n, MM if n == "x" else BAR),
            )
        ]
        yield make(name, {"log.csv": _text(own, heads)})
    yield make("simulink", {"scope.mat": _mat({"sim": {"time": own["t"], **scaled}})})


def _cells() -> Iterator[Case]:
    """Lyon: a load that hangs on a load cell."""
    two = [_valves(1, 3.0), _valves(2, 3.0)]
    load = {"parameters": {"load.m": "3 kg"}}
    make = lambda name, heads, **more: _case(
        "load cell",
        name,
        two,
        heads,
        "u_in u_out p x F",
        "HangingLoad|Isotonic",
        **{"stated": load, **more},
    )  # noqa: E731
    valves = [
        ("I_in [mA]", "u_in", MA),
        ("I_out [mA]", "u_out", MA),
        ("p_supply [kPa]", "p_supply", KPA),
    ]
    yield make(
        "german",
        [
            ("Zeit [s]", "t", _same),
            *valves,
            ("Druck [kPa]", "p", KPA),
            ("Weg [mm]", "x", MM),
            ("Kraft [N]", "F", _same),
        ],
        separator=";",
        decimal=",",
    )
    yield make(
        "commented",
        [T_S, *valves, ("p [kPa]", "p", KPA), ("x [mm]", "x", MM), ("F [N]", "F", _same)],
        above="# operator: A\n# load mass: 3 kg\n",
        stated={},
    )
    yield make(
        "wire",
        [T_S, *valves, ("p [kPa]", "p", KPA), ("wire [mm]", "x", WIRE), ("F [N]", "F", _same)],
        answer={"columns": {"x": "wire"}},
    )


def _imposed() -> Iterator[Case]:
    """Osaka: a pressure that is imposed, and a load that the name of the file tells."""
    two = [_regulated(1), _regulated(2)]
    make = lambda name, heads, **more: _case(
        "imposed", name, two, heads, "p x", "VerticalLoad|HangingLoad", **{"stem": "w2kg_", **more}
    )  # noqa: E731
    yield make(
        "french",
        [("temps (s)", "t", _same), ("pression (bar)", "p", BAR), ("déplacement (mm)", "x", MM)],
        separator="\t",
        suffix="txt",
    )
    yield make(
        "labview",
        [("X_Value", "t", _same), ("p (psi)", "p", times(PSI)), ("Length (mm)", "x", LEFT)],
        separator="\t",
        suffix="lvm",
    )
    yield make(
        "counter",
        [("micros", "t", lambda t: np.round(1e6 * t)), ("p_kPa", "p", KPA), ("x_mm", "x", MM)],
    )
    yield make("no units", [("time", "t", _same), ("Druck", "p", BAR), ("Weg", "x", MM)])
    yield make(
        "counts",
        [T_S, ("p [kPa]", "p", KPA), ("x [counts]", "x", times(2e-5))],
        answer={"columns": {"x": 'x * "0.02 mm"'}},
    )
    volts = [T_S, ("U_valve [V]", "p_set", times(6e4)), ("p [kPa]", "p", KPA), ("x [mm]", "x", MM)]
    yield _case(
        "imposed",
        "volts",
        two,
        volts,
        "p_set p x",
        "HangingLoad",
        answer={"columns": {"p_set": 'U_valve * "60 kPa/V"'}},
        stem="w2kg_",
    )


def _abroad() -> Iterator[Case]:
    """Turin, Gdansk, Osaka: words that no vocabulary has; what steps and what follows is seen by the numbers."""
    words = {
        "italian": ("tempo (s)", "pressione impostata (bar)", "pressione relativa (bar)", "corsa (mm)"),
        "polish": ("czas [s]", "ciśnienie zadane [bar]", "ciśnienie [bar]", "skok [mm]"),
        "japanese": ("時間[s]", "指令圧力[bar]", "圧力[bar]", "変位[mm]"),
        "paths": ("time [s]", "Ctrl/p_soll [bar]", "Model Root/ADC/p [bar]", "Plant.muscle.x [mm]"),
    }  # fmt: skip
    for name, (time, wanted, read, moved) in words.items():
        heads: list[Head] = [(time, "t", _same), (read, "p", BAR), (wanted, "p_set", BAR), (moved, "x", MM)]  # fmt: skip
        yield _case(
            "abroad", name, [_regulated(2)], heads, "p_set p x", "HangingLoad", separator=";"
        )


CASES: tuple[Case, ...] = tuple(
    case
    for lab in (
        _regulators,
        _currents,
        _presses,
        _tanks,
        _vessels,
        _switches,
        _maps,
        _pairs,
        _cells,
        _imposed,
        _abroad,
    )
    for case in lab()
)
