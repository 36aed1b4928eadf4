"""FMUs of others: variables of all types, arrays, fixed steps, smooth inputs, and what they say."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

import pam_cosim as pam
from pam_cosim.errors import InputError, SimulationFailure
from pam_cosim.fmu.read import integer_span, read_interface
from pam_cosim.model.settings import resolve
from pam_cosim.simulation import Inputs, IsolatedSimulator
from tests.fmu.foreign import Scalar, foreign

MODES = {
    2: '<SimpleType name="Mode"><Enumeration><Item name="slow" value="1"/><Item name="fast" value="4"/>'
    "</Enumeration></SimpleType>",
    3: '<EnumerationType name="Mode"><Item name="slow" value="1"/><Item name="fast" value="4"/></EnumerationType>',
}
LAG = "double g = $on * $gain * $mode; $p += (g * $u - $p) * (1 - exp(-h / $tau)); return 0;"
INTEGERS = [f"{u}Int{n}" for u in ("", "U") for n in (8, 16, 32, 64)]


def valve(fmi: int) -> list[Scalar]:
    """A lag behind a valve that is on or off, with parameters of every type."""
    real = "Real" if fmi == 2 else "Float64"
    return [
        Scalar("u", real, "input", "0"),
        Scalar("on", "Boolean", "input", "true", "discrete"),
        Scalar("gain", "Integer" if fmi == 2 else "UInt8", "parameter", "1", "fixed"),
        Scalar("mode", "Enumeration", "parameter", "1", "fixed", 'declaredType="Mode"'),
        Scalar("tau", real, "parameter", "0.3", "fixed"),
        Scalar("label", "String", "parameter", "none", "fixed"),
        Scalar("p", real, "output"),
        Scalar("length", "Integer" if fmi == 2 else "Int32", "output", None, "discrete"),
        Scalar("twice", real, "calculatedParameter", None, "fixed"),
    ]


def valve_fmu(folder: Path, fmi: int, **options: str) -> Path:
    """The same as a file."""
    outputs = "$length = strlen(m->text); $twice = 2 * $gain;"
    model = {"outputs": outputs, "step": LAG.replace("return 0;", ""), "types": MODES[fmi]}
    return foreign(folder / f"valve{fmi}.fmu", fmi, valve(fmi), **(model | options))  # type: ignore[arg-type]


def exact(times: np.ndarray, gain: float, tau: float = 0.3) -> np.ndarray:
    """Of the lag, filled for half a second and then shut."""
    rise = gain * (1 - np.exp(-np.minimum(times, 0.5) / tau))
    return np.asarray(rise * np.exp(-np.maximum(times - 0.5, 0) / tau))


@pytest.mark.parametrize("fmi", [2, 3])
def test_every_type_is_driven_and_set(fmi: int, tmp_path: Path) -> None:
    """The switch changes at its sample, between those of a smooth input; strings and enumerations are set."""
    with IsolatedSimulator(valve_fmu(tmp_path, fmi)) as simulator:
        words = {"gain": 3, "mode": "fast", "label": "spring"}
        settings = resolve(words, simulator.interface)
        time = np.array([0.0, 0.5, 1.0])
        inputs = Inputs(time, {"u": np.ones(3), "on": np.array([1.0, 0.0, 0.0])})
        times = np.linspace(0, 1, 21)
        run = simulator.run(times, parameters=settings, inputs=inputs)
        assert np.abs(run["p"] - exact(times, 12.0)).max() < 1e-12
        assert (run["length"] == 6.0).all()


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize(
    ("setting", "message"),
    [
        ({"mode": "quick"}, "must be one of slow, fast"),
        ({"mode": 2}, "must be one of slow, fast"),
        ({"on": "maybe"}, "must be 0 or 1"),
        ({"on": 0.5}, "must be 0 or 1"),
        ({"gain": 1.5}, "must be a whole number"),
        ({"twice": 2}, "'twice' is a calculated parameter of m: it follows from other parameters"),
        ({"length": 2}, "'length' is an output of m and cannot be set"),
    ],
)
def test_what_a_variable_cannot_be(
    fmi: int, setting: dict[str, float | str], message: str, tmp_path: Path
) -> None:
    interface = read_interface(valve_fmu(tmp_path, fmi))
    with pytest.raises(InputError, match=message):
        resolve(setting, interface)


@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_the_ends_of_every_integer(kind: str, tmp_path: Path) -> None:
    """They arrive as they are, though a double rounds the greatest of 64 bits up; the next numbers are refused."""
    ends = {t: integer_span(t) for t in INTEGERS}
    scalars = [
        *(Scalar(f"i_{t}", t, "parameter", "1", "fixed") for t in INTEGERS),
        Scalar("x", "Float64", "local", "0"),
        Scalar("der(x)", "Float64", "local"),
        *(Scalar(f"is_{end}", "Int32", "output", None, "discrete") for end in ("low", "high")),
    ]
    limits = {t: ("0" if t[0] == "U" else f"{t.upper()}_MIN", f"{t.upper()}_MAX") for t in INTEGERS}
    low, high = ([f"$i_{t} == (double){limits[t][k]}" for t in INTEGERS] for k in (0, 1))
    outputs = f"$is_low = {' && '.join(low)}; $is_high = {' && '.join(high)};"
    path = foreign(tmp_path / "i.fmu", 3, scalars, outputs=outputs, kind=kind)
    for k, output in enumerate(("is_low", "is_high")):
        run = pam.simulate(path, {f"i_{t}": str(ends[t][k]) for t in INTEGERS}, stop_time=0.1)
        assert run[output][0] == 1, output
    for t in INTEGERS:
        beyond = 2 * ends[t][1] + 1 if t.endswith("64") else ends[t][1] + 1
        with pytest.raises(InputError, match=f"a whole number from {ends[t][0]} to {ends[t][1]}"):
            resolve({f"i_{t}": str(beyond)}, read_interface(path))


@pytest.mark.parametrize("fmi", [2, 3])
@pytest.mark.parametrize("kind", ["CoSimulation", "ModelExchange"])
def test_an_fmu_that_ends_the_simulation(fmi: int, kind: str, tmp_path: Path) -> None:
    """The run up to there is the result, with a warning; a fit and a coupling fail, and say so."""
    real = "Real" if fmi == 2 else "Float64"
    scalars = [
        Scalar("x", real, "output", "0"),
        Scalar("der(x)", real, "local"),
        Scalar("end", real, "parameter", "0.42", "fixed"),
    ]
    step = "if (m->time + h > $end) { h = $end - m->time; m->ended = 1; } $x += h"
    ends = "m->ended = m->ended || m->time >= $end;"
    path = foreign(
        tmp_path / "e.fmu", fmi, scalars, step=step, outputs=ends, rate="1", kind=kind, interval=0.1
    )
    run = pam.simulate(path)
    assert "the FMU ends the simulation (simulated up to 0." in run.warnings[0]
    assert len(run.time) in (5, 6) and np.allclose(run["x"], run.time, atol=1e-6)
    assert len(pam.simulate(path, {"end": 2.0}).time) == 11
    with (
        IsolatedSimulator(path) as simulator,
        pytest.raises(SimulationFailure, match="ends the simulation"),
    ):
        simulator.run([0.0, 0.3, 0.6, 0.9])
    swept = pam.sweep(
        path, {"end": [0.42, 2.0]}
    )  # the FMU keeps that it has ended when it is reset
    assert ["ends the simulation" in one for one in swept.table.failures()] == [True, False]
    if kind == "CoSimulation":
        with pytest.raises(SimulationFailure, match="'a' .* failed: the FMU ends the simulation"):
            pam.couple({"a": path}, []).simulate(1.0, step=0.1)


@pytest.mark.parametrize(
    ("start", "stop", "interval", "rows"),
    [
        (0.0, 10.0, None, 1001),  # 0.01 s, the usual interval
        (5.0, 10.0, 0.5, 11),
        (0.0, 1e-3, None, 1001),
        (1e-5, 1e8, None, 1001),
    ],
)
def test_times_that_an_fmu_declares(
    start: float, stop: float, interval: float | None, rows: int, tmp_path: Path
) -> None:
    scalars = [Scalar("t", "Real", "output")]
    path = foreign(
        tmp_path / "t.fmu",
        2,
        scalars,
        outputs="$t = m->time;",
        start=start,
        stop=stop,
        interval=interval,
    )
    run = pam.simulate(path)
    assert (run.time[0], run.time[-1], len(run.time)) == (start, stop, rows)
    assert np.allclose(run["t"], run.time, rtol=1e-9, atol=0)


def test_an_fmu_without_outputs(tmp_path: Path) -> None:
    """The advice is followed."""
    path = foreign(tmp_path / "n.fmu", 2, [Scalar("z", "Real", "local", "2")])
    with pytest.raises(InputError, match="m has no outputs: name what to record, as --keep z"):
        pam.simulate(path)
    assert pam.simulate(path, outputs=["z"])["z"][-1] == 2


def test_arrays_by_element_and_every_integer(tmp_path: Path) -> None:
    """An element that is set leaves the others at their start values; sizes of types are kept."""
    scalars = [
        Scalar("a", "Float64", "input", "1 2 3", size=3),
        Scalar("b", "Int16", "parameter", "-7 8", "fixed", size=2),
        *(Scalar(f"i_{t}", t, "parameter", "1", "fixed") for t in INTEGERS),
        Scalar("f", "Float32", "parameter", "0.5", "fixed"),
        Scalar("y", "Float64", "output", size=2),
        Scalar("s", "Int64", "output", None, "discrete"),
        Scalar("raw", "Binary", "input", None, "discrete"),
    ]
    total = " + ".join(f"$i_{t}" for t in INTEGERS)
    outputs = f"$y[0] = $a[0] + 10 * $a[1] + 100 * $a[2]; $y[1] = $b[0] * $b[1] * $f; $s = {total};"
    path = foreign(tmp_path / "a.fmu", 3, scalars, outputs=outputs)
    with IsolatedSimulator(path) as simulator:
        settings = {"a[2]": 5.0, "b[1]": -9.0, "i_Int64": 2.0**40, "i_UInt8": 200.0, "f": 0.25}
        run = simulator.run([0.0, 1.0], parameters=settings)
    assert run["y[1]"][0] == 1 + 50 + 300 and run["y[2]"][0] == -9 * 8 * 0.25
    assert run["s"][0] == 2.0**40 + 200 + 6
    interface = read_interface(path)
    assert "'a' of m cannot be used: it is an array of 3 elements; name one, as a[1]" in (
        interface.unknown("a", "input", interface.inputs)
    )
    assert "it is of type Binary" in interface.unknown("raw", "input", interface.inputs)


@pytest.mark.parametrize("fmi", [2, 3])
def test_model_exchange_has_types_too(fmi: int, tmp_path: Path) -> None:
    real = "Real" if fmi == 2 else "Float64"
    state = [
        Scalar("x", real, "local", "0"),
        Scalar("der(x)", real, "local"),
        Scalar("p", real, "output"),
    ]
    scalars = [*(s for s in valve(fmi) if s.name != "p"), *state]
    path = foreign(
        tmp_path / "x.fmu",
        fmi,
        scalars,
        outputs="$p = $x; $length = strlen(m->text);",
        rate="($on * $gain * $mode * $u - $x) / $tau",
        kind="ModelExchange",
        types=MODES[fmi],
    )
    with IsolatedSimulator(path) as simulator:
        times = np.linspace(0, 1, 11)
        inputs = Inputs(times, {"u": np.ones(11), "on": (times < 0.45).astype(float)})
        settings = resolve({"mode": "fast", "label": "ab"}, simulator.interface)
        run = simulator.run(times, parameters=settings, inputs=inputs, tolerance=1e-8)
    assert np.abs(run["p"] - exact(times, 4.0)).max() < 1e-5 and run["length"][0] == 2


SINE = Scalar("u", "Real", "input", "0"), Scalar("p", "Real", "output", "0")
FIRST_ORDER = "$p += ($u - $p) * (1 - exp(-h / 0.3));"


def _sine(times: np.ndarray) -> np.ndarray:
    """The lag behind a sine of 1 Hz, from rest."""
    w, tau = 2 * np.pi, 0.3
    settled = np.sin(w * times) - w * tau * np.cos(w * times) + w * tau * np.exp(-times / tau)
    return np.asarray(settled / (1 + (w * tau) ** 2))


def test_smooth_inputs_are_means_over_the_step(tmp_path: Path) -> None:
    """Held values at the beginning of each step would lag by half of it: the error is of second order instead."""
    times = np.linspace(0, 2, 201)
    path = foreign(tmp_path / "s.fmu", 2, SINE, step=FIRST_ORDER, interval=0.05)
    with IsolatedSimulator(path) as simulator:
        rows = np.linspace(0, 2, 41)
        run = simulator.run(rows, inputs=Inputs(times, {"u": np.sin(2 * np.pi * times)}))
    error = np.abs(run["p"] - _sine(rows)).max()
    assert error < 0.05**2 * (2 * np.pi) / 0.3 / 4  # a held input is off by 0.05


FIXED = 'canHandleVariableCommunicationStepSize="false"'
STRICT = 'if (fabs(h - 0.1) > 1e-9) return say(m, 3, "steps of 0.1 s alone");'


@pytest.mark.parametrize("fmi", [2, 3])
def test_fixed_steps_are_kept(fmi: int, tmp_path: Path) -> None:
    """Rows between the ends of steps are interpolated, on each side of a step of the input by itself."""
    real = "Real" if fmi == 2 else "Float64"
    scalars = [Scalar("u", real, "input", "0"), Scalar("p", real, "output")]
    path = foreign(
        tmp_path / "f.fmu", fmi, scalars, step=STRICT + FIRST_ORDER, flags=FIXED, interval=0.1
    )
    rows = np.sort(np.random.default_rng(1).uniform(0, 1, 60))
    steps = Inputs(np.array([0.0, 0.5]), {"u": np.array([1.0, 0.0])}, "previous")
    with IsolatedSimulator(path) as simulator:
        run = simulator.run(rows, inputs=steps, start_time=0.0)
        on_grid = simulator.run(np.linspace(0, 1, 11), inputs=steps)
    assert np.abs(run["p"] - exact(rows, 1.0)).max() < 0.01  # a line would be off by 0.014
    assert np.abs(on_grid["p"] - exact(on_grid.time, 1.0)).max() < 1e-12
    assert on_grid.warnings == ()
    assert len(run.warnings) == 1 and "takes steps of 0.1 s alone" in run.warnings[0]


def test_messages_reach_the_reader_with_names(tmp_path: Path) -> None:
    said = 'if (m->time == 0) say(m, 1, "#r0# is low"); if (m->time > 0.5) return say(m, 3, "#r1# burst");'
    path = foreign(tmp_path / "w.fmu", 2, SINE, step=said + FIRST_ORDER)
    with IsolatedSimulator(path) as simulator:
        assert simulator.run([0.0, 0.3]).warnings == ("u is low",)
        with pytest.raises(SimulationFailure, match="p burst"):
            simulator.run([0.0, 0.6, 0.9])


def test_backslashes_in_an_archive(tmp_path: Path) -> None:
    path = foreign(tmp_path / "b.fmu", 2, SINE, step=FIRST_ORDER, slashes="\\")
    assert pam.simulate(str(path), {"u": 1.0}, stop_time=0.3)["p"][-1] == pytest.approx(
        1 - np.exp(-1.0)
    )


def _folder(path: Path, model: Path, rows: list[str], more: str = "", sigma: str = "0.01") -> Path:
    """A data set of the valve."""
    path.mkdir()
    shutil.copy(model, path)
    (path / "r.csv").write_text("\n".join(rows))
    (path / "experiment.toml").write_text(
        f'model = "{model.name}"\n{more}\n[signals.p]\nsigma = "{sigma}"\n[fit]\ntau = {{ min = 0.05, max = 3 }}\n'
        '[parameters]\nmode = "fast"\nlabel = "a"\n[[runs]]\nfile = "r.csv"\n'
    )
    return path


@pytest.mark.parametrize(
    ("on", "off"), [("1", "0"), ("on", "off"), ("TRUE", "FALSE"), ("open", "closed")]
)
def test_a_fit_with_a_switch(on: str, off: str, tmp_path: Path) -> None:
    times = np.linspace(0, 1, 101)
    noise = 0.01 * np.random.default_rng(2).standard_normal(101)
    values = exact(times, 4.0, 0.25) + noise
    rows = ["time [s],u,on,p"]
    rows += [
        f"{t:.2f},1,{on if t < 0.495 else off},{p:.5f}" for t, p in zip(times, values, strict=True)
    ]
    data = pam.read(_folder(tmp_path / "d", valve_fmu(tmp_path, 2), rows))
    tau = pam.fit(data).parameters["tau"]
    assert tau.low < 0.25 < tau.high and tau.high - tau.low < 0.01


def test_an_input_that_nothing_drives_is_named(tmp_path: Path) -> None:
    rows = ["time [s],u,p", *(f"{i / 10},1,{i}" for i in range(11))]
    compared = pam.compare(pam.read(_folder(tmp_path / "d", valve_fmu(tmp_path, 2), rows)))
    assert "r: on is neither a column nor stated" in str(compared)


def test_absolute_pressures_are_asked_for_once(tmp_path: Path) -> None:
    """Of an FMU nobody knows whether its pressures are absolute: the advice is followed."""
    scalars = [
        Scalar("u", "Real", "input", "0", further='unit="Pa"'),
        Scalar("p", "Real", "output", further='unit="Pa"'),
        *valve(2)[3:6],
    ]

    path = foreign(
        tmp_path / "p.fmu",
        2,
        scalars,
        step="$p += ($u - $p) * (1 - exp(-h / $tau));",
        types=MODES[2],
    )
    rows = [
        "time [s],u [kPa],p [kPa abs]",
        *(f"{i / 10},{200 + i % 3},{100 + i}" for i in range(21)),
    ]
    with pytest.raises(InputError, match='state pressures = "absolute" or pressures = "gauge"'):
        pam.read(_folder(tmp_path / "a", path, rows))
    made = pam.read(_folder(tmp_path / "b", path, rows, 'pressures = "absolute"', "1 kPa"))
    assert made.runs[0].measurements["p"][0] == pytest.approx(100e3)


GEAR = "double k = $gear == 1 ? 1 : $gear == 4 ? 2 : -1; $s += (k * $u - $s) * (1 - exp(-h / $tau))"


@pytest.mark.parametrize("fmi", [2, 3])
def test_a_choice_is_driven_and_a_switch_is_measured(fmi: int, tmp_path: Path) -> None:
    """The columns have the names of items, and on and off; the fit finds the time constant."""
    real = "Real" if fmi == 2 else "Float64"
    scalars = [
        Scalar("gear", "Enumeration", "input", "1", "discrete", 'declaredType="Mode"'),
        Scalar("u", real, "input", "1"),
        Scalar("tau", real, "parameter", "0.3", "fixed"),
        Scalar("s", real, "output"),
        Scalar("moving", "Boolean", "output", None, "discrete"),
    ]
    folder = tmp_path / "data"
    folder.mkdir()
    model = {"outputs": "$moving = $s > 1;", "step": GEAR, "types": MODES[fmi]}
    foreign(folder / "gear.fmu", fmi, scalars, **model)  # type: ignore[arg-type]
    times, tau = np.linspace(0, 2, 41), 0.5
    first = 1 - np.exp(-times / tau)
    at_one = 1 - np.exp(-1 / tau)
    values = np.where(times <= 1, first, 2 + (at_one - 2) * np.exp(-(times - 1) / tau))
    rows = [
        f"{t},{'slow' if t < 1 else 'fast'},1,{s!r},{'on' if s > 1 else 'off'}"
        for t, s in zip(times.tolist(), values.tolist(), strict=True)
    ]
    (folder / "r.csv").write_text("\n".join(["time [s],gear,u,s,moving", *rows]))
    (folder / "experiment.toml").write_text(
        'model = "gear.fmu"\n[signals.s]\nsigma = 0.001\n[fit]\ntau = { min = 0.1, max = 2 }\n'
        '[[runs]]\nfile = "r.csv"\nrole = "fit"\ninterpolation = "previous"\n'
    )
    fitted = pam.fit(pam.read(folder))
    assert fitted.parameters["tau"].value == pytest.approx(tau, rel=2e-3)


def test_what_has_neither_inputs_nor_states(tmp_path: Path) -> None:
    scalars = [
        Scalar("a", "Float64", "parameter", "2", "fixed"),
        Scalar("b", "Int32", "parameter", "3", "fixed"),
        Scalar("y", "Float64", "output"),
    ]
    file = foreign(tmp_path / "static.fmu", 3, scalars, outputs="$y = $a * $b;")
    made = pam.simulate(file, {"b": 4, "a": 2.5})
    assert np.array_equal(made["y"], np.full(made.time.shape, 10.0))


def test_what_new_says_of_an_fmu_is_followed(tmp_path: Path) -> None:
    """What may be free stands in the advice; nothing leads to a diagnosis, which an FMU cannot have."""
    tau = Scalar("tau", "Real", "parameter", "0.5", "fixed", 'min="0.3" max="40"')
    path = foreign(tmp_path / "v.fmu", 2, [*SINE, tau], step=FIRST_ORDER.replace("0.3", "$tau"))
    times = np.linspace(0, 2, 201)
    inputs = {"time": times, "u": np.sin(6 * times)}
    pam.simulate(path, {"tau": 0.4}, inputs).to_csv(tmp_path / "p.csv")
    rows = (tmp_path / "p.csv").read_text().splitlines()
    cells = ["u", *(f"{u!r}" for u in inputs["u"].tolist())]
    (tmp_path / "r.csv").write_text("\n".join(f"{r},{u}" for r, u in zip(rows, cells, strict=True)))
    made = pam.new(tmp_path / "d", [tmp_path / "r.csv"], model=str(path))
    entry = next(one for one in made.to_check if "such as" in one and "[fit]" in one).split(
        "such as "
    )
    assert entry[1] == '"tau" = { min = 0.3, max = 1 }'
    assert not any("diagnose" in one for one in (*made.to_check, *made.next_commands))
    with (tmp_path / "d" / "experiment.toml").open("a") as file:
        file.write(f"\n[fit]\n{entry[1]}\n")
    assert pam.fit(pam.read(tmp_path / "d")).parameters["tau"].value == pytest.approx(0.4, rel=1e-3)


def test_inputs_under_other_names(tmp_path: Path) -> None:
    """A file of inputs belongs to no data set, and nothing of one is advised."""
    path = foreign(tmp_path / "v.fmu", 2, SINE, step=FIRST_ORDER)
    (tmp_path / "in.csv").write_text("time [s],u,w\n0,1,1\n1,1,1\n")
    with pytest.raises(InputError, match="m has no input or output 'w'") as refusal:
        pam.simulate(path, inputs=tmp_path / "in.csv")
    assert "experiment" not in str(refusal.value) and "[columns]" not in str(refusal.value)


def test_signs_and_zeros_of_an_fmu_are_its_own(tmp_path: Path) -> None:
    """A pull below zero and a contraction that falls with the pressure stay as the FMU has them."""
    units = {"u": "Pa", "p": "Pa", "s": "m", "F": "N"}
    kinds = {name: "input" if name == "u" else "output" for name in units}
    scalars = [Scalar(n, "Real", k, "0", further=f'unit="{units[n]}"') for n, k in kinds.items()]
    path = foreign(
        tmp_path / "m.fmu",
        2,
        scalars,
        step=FIRST_ORDER,
        outputs="$s = -1e-7 * $p; $F = -5 - $p / 1e3;",
    )
    times = np.linspace(0, 2, 201)
    inputs = {"time": times, "u": 5e4 * (1 - np.cos(4 * times))}
    run = pam.simulate(path, inputs=inputs)
    columns = [times, inputs["u"] / 1e3, run["p"] / 1e3, run["s"] * 1e3, run["F"]]
    rows = [",".join(f"{v:.9g}" for v in row) for row in zip(*columns, strict=True)]
    (tmp_path / "r.csv").write_text("\n".join(["time [s],u [kPa],p [kPa],s [mm],F [N]", *rows]))
    pam.new(tmp_path / "d", [tmp_path / "r.csv"], model=str(path))
    compared = pam.compare(pam.read(tmp_path / "d"))
    assert all(score.nrmse < 1e-3 for score in compared.scores["fit"].values())


def test_a_table_of_start_values_that_are_outputs(tmp_path: Path) -> None:
    scalars = [Scalar("x", "Real", "output", "1"), Scalar("der(x)", "Real", "local")]
    path = foreign(tmp_path / "x.fmu", 2, scalars, step="$x *= exp(-h)", rate="-$x", interval=0.5)
    pam.sweep(path, {"x": [1.0, 2.0]}).save(tmp_path / "s.csv")
    rows = (tmp_path / "s.csv").read_text().splitlines()
    assert rows[0] == "start of x [1],time [s],x [1],failure" and rows[4] == "2.0,0.0,2.0,"
