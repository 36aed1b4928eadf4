"""Recordings of invented laboratories and ten loggers, each with what it holds: a table, made by a seeded script.

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
PSI = 6894.757293168


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


def _columns(heads: str, signals: Signals) -> dict[str, Array]:
    """Numbers by heading, of ``heading -> signal change; ...``."""
    made = {}
    for column in heads.split("; "):
        heading, _, rest = column.partition(" -> ")
        signal, _, change = rest.partition(" ")
        made[heading] = CHANGES[change](signals[signal])
    return made


def _text(
    signals: Signals, heads: str, separator: str = ",", decimal: str = ".",
    above: str = "", index: bool = False, encoding: str = "utf-8",
) -> bytes:  # fmt: skip
    columns = _columns(heads, signals)
    rows = np.column_stack(list(columns.values()))
    lines = [separator.join(columns)]
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


CHANGES: dict[str, Callable[[Array], Array]] = {
    "": lambda values: values, "kPa": times(1e3), "bar": times(1e5), "MPa": times(1e6), "bar_abs": times(1e5, AMBIENT / 1e5),
    "psi": times(PSI), "psia": times(PSI, AMBIENT / PSI), "mm": times(1e-3), "cm": times(1e-2),
    "left": lambda x: 1e3 * (LENGTH - x), "wire": lambda x: 312.6 - 1e3 * x, "share": times(LENGTH / 100),
    "counts": times(2e-5), "mA": times(1e-3), "volts": times(6e4), "ms": times(1e-3),
    "whole_us": lambda t: np.round(1e6 * t), "early": lambda t: (t < 20).astype(float), "degC": times(1.0, -273.15),
    "degF": lambda T: (T - 273.15) * 1.8 + 32.0, "kgf": times(9.80665), "lbf": times(4.4482216152605),
    "negative": times(-1.0), "mbar": times(1e2), "nanoseconds": lambda t: np.round(1e9 * t + 1.7008e18),
    "clock": lambda t: 22.12 + t,
}  # fmt: skip
"""How numbers of a column follow from its signal [SI]."""
LOAD = {"parameters": {"load.m": "2 kg"}}


def _case(
    lab: str,
    name: str,
    signals: Sequence[Signals],
    heads: str,
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
        "t [s] -> t; p_set [kPa] -> p_set kPa; p [kPa] -> p kPa; x [mm] -> x mm",
        held=True,
    )
    yield make(
        "german",
        three,
        "Zeit (ms) -> t ms; Solldruck (bar) -> p_set bar; Druck (bar) -> p bar; Weg (mm) -> x mm",
        separator=";",
        decimal=",",
        encoding="latin-1",
        held=True,
    )
    yield make(
        "draw wire",
        three,
        "Time (ms) -> t ms; p_soll [bar] -> p_set bar; Druck [bar] -> p bar; Weg_mm -> x wire",
        separator=";",
        decimal=",",
    )
    yield make(
        "length",
        own,
        "t [s] -> t; p_ref [bar] -> p_set bar; p_bar -> p bar; L_mm -> x left",
    )
    yield make(
        "over",
        own,
        "t/s -> t; p_soll/bar -> p_set bar; p/kPa(g) -> p kPa; x/mm -> x mm",
        separator="\t",
    )
    yield make(
        "french",
        own,
        "temps (s) -> t; consigne (bar) -> p_set bar; pression (bar) -> p bar; déplacement (mm) -> x mm",
        separator="\t",
    )
    yield make(
        "no units",
        own,
        "time -> t; setpoint -> p_set bar; pressure -> p bar; position -> x mm",
    )


def _currents() -> Iterator[Case]:
    """Bristol: two valves by their currents and a hanging load."""
    two, bench, truth = [_valves(1), _valves(2)], "HangingLoad|Isotonic", "u_in u_out p x"
    make = lambda name, heads, **more: _case(
        "valves", name, two, heads, truth, bench, **{"stated": LOAD, **more}
    )  # noqa: E731
    yield make(
        "mA",
        "t [ms] -> t ms; I_in [mA] -> u_in mA; I_out [mA] -> u_out mA; Vordruck [kPa] -> p_supply kPa; pm [kPa] -> p kPa; Kontraktion [mm] -> x mm",
        held=True,
    )
    yield make(
        "numbered",
        "Time (ms) -> t ms; Druck [bar] -> p bar; Weg_mm -> x wire; Temp -> T degC; I_valve1 (mA) -> u_in mA; I_valve2 (mA) -> u_out mA; Versorgung -> p_supply bar",
        separator=";",
        decimal=",",
    )
    yield make(
        "supply not stated",
        "time [s] -> t; i_inlet [A] -> u_in; i_exhaust [A] -> u_out; p [kPa] -> p kPa; contraction [mm] -> x mm",
        answer={"parameters": {"p_supply": "5 bar"}},
    )
    yield make(
        "pandas",
        "t [s] -> t; I_in [mA] -> u_in mA; I_out [mA] -> u_out mA; p_supply [kPa] -> p_supply kPa; p [kPa] -> p kPa; x [mm] -> x mm",
        index=True,
    )


def _presses() -> Iterator[Case]:
    """Cottbus: a press that holds the length, in MATLAB's files and texts."""
    runs = [_isometric(k, 0.01 * k) for k in range(3)]

    def mat(name: str, fields: str, **more: Any) -> Case:
        files = {
            f"press_{i}.mat": _mat({"log": _columns(fields, one)}) for i, one in enumerate(runs)
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
        "t -> t; Druck -> p kPa; Laenge -> s left; Kraft -> F",
    )
    yield mat(
        "kilograms",
        "t_ms -> t ms; p_kPa -> p kPa; L_mm -> s left; load_kg -> F kgf",
    )
    text = lambda name, heads, **more: _case(
        "press", name, runs, heads, "p s F", "Length|Isometric", **more
    )  # noqa: E731
    yield text(
        "pull below zero",
        "t [s] -> t; p [kPa] -> p kPa; L [mm] -> s left; F [N] -> F negative",
    )
    yield text(
        "contraction",
        "t [s] -> t; Druck [bar] -> p bar; s [mm] -> s mm; Kraft [N] -> F",
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
        "Zeit [s] -> t; I_ein [mA] -> u_in mA; I_aus [mA] -> u_out mA; p_abs [bar] -> p bar_abs; T_Gas [°C] -> T degC",
        separator=";",
        decimal=",",
        stated=supply,
        suffix="txt",
    )
    yield make(
        "fahrenheit",
        "time_s -> t; i_in_mA -> u_in mA; i_out_mA -> u_out mA; supply_psi -> p_supply psi; tank_p_psi -> p psi; T_degF -> T degF",
        answer={"columns": {"p": "tank_p_psi", "p_supply": "supply_psi"}},
    )
    yield make(
        "supply not stated",
        "t (s) -> t; I_in (mA) -> u_in mA; I_out (mA) -> u_out mA; p (bar) -> p bar; T (°C) -> T degC",
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
        "time_s -> t; pressure_bar_abs -> p bar_abs; T_K -> T",
    )
    yield make(
        "german",
        "Zeit (s) -> t; Druck (bar) -> p bar; Temperatur (°C) -> T degC",
        separator=";",
        decimal=",",
    )
    yield make(
        "switch beside",
        "t [s] -> t; TP3 [bar] -> p bar; gas temperature [degC] -> T degC; Pressure_switch -> t early",
    )
    yield make(
        "psia",
        "t (ms) -> t ms; Tank pressure (psia) -> p psia; Gas temperature (°C) -> T degC",
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
    yield make(
        "german",
        "t [s] -> t; Einlassventil -> u_in; Auslassventil -> u_out; Vordruck [bar] -> p_supply bar; Druck [bar] -> p bar; Weg [mm] -> x mm",
        separator=";",
        decimal=",",
    )
    yield make(
        "duty",
        "time_ms -> t ms; duty_in [%] -> u_in cm; duty_out [%] -> u_out cm; psup_kPa -> p_supply kPa; p_kPa -> p kPa; x_mm -> x mm",
    )
    yield make(
        "fill and vent",
        "t [s] -> t; fill valve -> u_in; vent valve -> u_out; supply pressure [psi] -> p_supply psi; muscle pressure [psi] -> p psi; displacement [mm] -> x mm",
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
        "t [s] -> t; valve in -> u_in; valve out -> u_out; p_supply [bar] -> p_supply bar; p [bar] -> p bar; x [mm] -> x mm",
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
    yield make("words", "pressure -> p kPa; contraction -> x mm; force -> F")
    yield make(
        "german",
        "Druck [bar] -> p bar; Kontraktion [mm] -> x mm; Kraft [N] -> F",
        separator=";",
        decimal=",",
    )
    yield make(
        "psi",
        "Pressure (psi) -> p psi; Contraction (mm) -> x mm; Force (lbf) -> F lbf",
    )
    yield make(
        "ratio",
        "p_bar -> p bar; strain_pct -> x share; F_N -> F",
        stated={"parameters": {"muscle.L0": "240 mm"}},
    )
    yield make("length", "p_MPa -> p MPa; L_mm -> x left; F_N -> F")


def _pairs() -> Iterator[Case]:
    """Graz: every signal with the times of its own."""
    own = _regulated(1)
    truth = {n: own[n] for n in ("p_set", "p", "x")}
    scaled = _columns("p_set -> p_set bar; p -> p bar; x -> x mm", own)
    nested = {"out": {n: {"Time": own["t"], "Data": v} for n, v in scaled.items()}}
    make = lambda name, files, **more: Case(f"pairs: {name}", files, truth, "HangingLoad", **more)  # noqa: E731
    yield make("structures", {"log.mat": _mat(nested)})
    for name, time, data in (
        ("dotted", "{}.Time", "{}.Data"),
        ("t first", "t_{}", "{}"),
        ("brackets", "{}.Time [s]", "{}.Data [{}]"),
    ):
        units = {"p_set": "bar", "p": "bar", "x": "mm"}
        heads = "; ".join(
            f"{time.format(n)} -> t; {data.format(n, unit)} -> {n} {unit}"
            for n, unit in units.items()
        )
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
    valves = "I_in [mA] -> u_in mA; I_out [mA] -> u_out mA; p_supply [kPa] -> p_supply kPa"
    yield make(
        "german",
        f"Zeit [s] -> t; {valves}; Druck [kPa] -> p kPa; Weg [mm] -> x mm; Kraft [N] -> F",
        separator=";",
        decimal=",",
    )
    yield make(
        "commented",
        f"t [s] -> t; {valves}; p [kPa] -> p kPa; x [mm] -> x mm; F [N] -> F",
        above="# operator: A\n# load mass: 3 kg\n",
        stated={},
    )
    yield make(
        "wire",
        f"t [s] -> t; {valves}; p [kPa] -> p kPa; wire [mm] -> x wire; F [N] -> F",
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
        "temps (s) -> t; pression (bar) -> p bar; déplacement (mm) -> x mm",
        separator="\t",
        suffix="txt",
    )
    yield make(
        "labview",
        "X_Value -> t; p (psi) -> p psi; Length (mm) -> x left",
        separator="\t",
        suffix="lvm",
    )
    yield make(
        "counter",
        "micros -> t whole_us; p_kPa -> p kPa; x_mm -> x mm",
    )
    yield make("no units", "time -> t; Druck -> p bar; Weg -> x mm")
    yield make(
        "counts",
        "t [s] -> t; p [kPa] -> p kPa; x [counts] -> x counts",
        answer={"columns": {"x": 'x * "0.02 mm"'}},
    )
    volts = "t [s] -> t; U_valve [V] -> p_set volts; p [kPa] -> p kPa; x [mm] -> x mm"
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
        heads = f"{time} -> t; {read} -> p bar; {wanted} -> p_set bar; {moved} -> x mm"
        yield _case(
            "abroad", name, [_regulated(2)], heads, "p_set p x", "HangingLoad", separator=";"
        )


def _lines(signals: Signals, heads: str, row: str, head: str) -> bytes:
    """A text with a line of a template for each sample, below a head."""
    columns = list(_columns(heads, signals).values())
    rows = zip(*(column.tolist() for column in columns), strict=True)
    return (head + "".join(row.format(*cells, i=i) + "\n" for i, cells in enumerate(rows))).encode()


def _loggers() -> Iterator[Case]:
    """Ten loggers, each with the layout that its program writes."""
    two = [_regulated(1), _regulated(3)]
    plain = "t -> t; p_set -> p_set kPa; p -> p kPa; x -> x mm"

    def make(name: str, suffix: str, files: Sequence[bytes], **more: Any) -> Case:
        content = {f"run{i + 1}.{suffix}": one for i, one in enumerate(files)}
        truth = {n: two[0][n] for n in ("p_set", "p", "x")}
        return Case(f"logger: {name}", content, truth, "HangingLoad", **more)

    arduino = "t -> t ms; p_set -> p_set kPa; p -> p kPa; x -> x mm"
    head = "Pneumatic rig v2, 115200 baud\nCalibrating... done\nmillis,soll_kPa,ist_kPa,weg_mm\n"
    yield make(
        "arduino",
        "txt",
        [_lines(one, arduino, "{0:.0f},{1:.1f},{2:.2f},{3:.3f}", head) for one in two],
    )
    lvm = (
        "LabVIEW Measurement\t\nWriter_Version\t2\nReader_Version\t2\nSeparator\tTab\nDecimal_Separator\t,\n"
        "Multi_Headings\tNo\nX_Columns\tOne\nTime_Pref\tRelative\nOperator\tlab\nDate\t2023/11/24\n"
        "Time\t14:03:22,1205\n***End_of_Header***\t\n\t\nChannels\t3\t\t\t\nSamples\t400\t400\t400\t\n"
        "Date\t2023/11/24\t2023/11/24\t2023/11/24\t\nX_Dimension\tTime\tTime\tTime\t\nX0\t0\t0\t0\t\n"
        "Delta_X\t0,01\t0,01\t0,01\t\n***End_of_Header***\t\t\t\t\nX_Value\tp_soll (bar)\tp_ist (bar)\tWeg (mm)\tComment\n"
    )
    bars = "t -> t; p_set -> p_set bar; p -> p bar; x -> x mm"
    row = "{0:.6f}\t{1:.6f}\t{2:.6f}\t{3:.6f}\t"
    yield make(
        "labview",
        "lvm",
        [lvm.encode() + _lines(one, bars, row, "").replace(b".", b",") for one in two],
    )
    dspace = [
        {
            "X": {"Name": "Host Time", "Data": one["t"], "Unit": "s"},
            "Y": np.array(
                [
                    (f"Model Root/{name}/In1", "RTProgram", unit, values)
                    for (name, values), unit in zip(
                        list(_columns(bars, one).items())[1:], ("bar", "bar", "mm"), strict=True
                    )
                ],
                dtype=[("Name", object), ("Path", object), ("Unit", object), ("Data", object)],
            ),
            "Description": {"DateTime": "24.11.2023"},
        }
        for one in two
    ]
    yield make("dspace", "mat", [_mat({"rec_001": one}) for one in dspace])
    yield make(
        "timetable",
        "csv",
        [_lines(o, plain, "{0:.2f} sec,{1:.4f},{2:.4f},{3:.5f}", "Time,p_ref_kPa,p_kPa,x_mm\n") for o in two],
    )  # fmt: skip
    excel = "sep=;\nZeit;Solldruck;Istdruck;Verkürzung\n[s];[bar];[bar];[mm]\n"
    row = "{0:.2f};{1:.3f};{2:.4f};{3:.4f}"
    yield make(
        "excel",
        "csv",
        [excel.encode("cp1252") + _lines(one, bars, row, "").replace(b".", b",") for one in two],
    )
    scope = (
        "Model,TDS2024C\nFirmware Version,v24.26\nPoint Format,Y\nHorizontal Units,s\nSample Interval,0.01\n"
        "Record Length,400\nProbe Attenuation,1,1,1\nVertical Units,V,V,V\n\nTIME,CH1,CH2,CH3\n"
    )
    volts = "t -> t; p_set -> p_set volts; p -> p volts; x -> x cm"
    answer = {"columns": {n: f'CH{i} * "{k}"' for n, i, k in (
        ("p_set", 1, "60 kPa/V"), ("p", 2, "60 kPa/V"), ("x", 3, "1 cm/V"))}}  # fmt: skip
    row = "{0:.5e},{1:.5f},{2:.5f},{3:.5f}"
    yield make(
        "oscilloscope", "csv", [_lines(one, volts, row, scope) for one in two], answer=answer
    )
    names = ("Time", "p_soll (bar)", "p_ist (bar)", "Weg (mm)")
    tdms = "," + ",".join(f"/'Messung'/'{name}'" for name in names) + "\n"
    yield make(
        "tdms",
        "csv",
        [_lines(one, bars, "{i},{0:.3f},{1:.4f},{2:.5f},{3:.4f}", tdms) for one in two],
    )
    ros = "%time,field.header.seq,field.header.stamp,field.header.frame_id,field.p_set,field.p,field.x\n"
    silent = "t -> t nanoseconds; p_set -> p_set; p -> p; x -> x"
    row = "{0:.0f},{i},{0:.0f},rig,{1:.1f},{2:.1f},{3:.6f}"
    yield make("ros", "csv", [_lines(one, silent, row, ros) for one in two])
    plc = "Datum;Uhrzeit;Druck_Soll [mbar];Druck_Ist [mbar];Position [mm]\n"
    clock = "t -> t clock; p_set -> p_set mbar; p -> p mbar; x -> x mm"
    row = "24.11.2023;14:03:{0:06.3f};{1:.0f};{2:.1f};{3:.3f}"
    yield make(
        "plc", "csv", [_lines(one, clock, row, plc).replace(b"#", b"").replace(b".", b",").replace(b"24,11,", b"24.11.") for one in two]
    )  # fmt: skip
    stream = [io.BytesIO() for _ in two]
    for one, place in zip(two, stream, strict=True):
        np.savez(place, t=one["t"], p_ref=one["p_set"], p=one["p"], pos=one["x"])
    yield make("numpy", "npz", [place.getvalue() for place in stream])


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
        _loggers,
    )
    for case in lab()
)
