"""What a laboratory writes of its rig, and the data set that a user who knows the software drafts from it."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator

from strangers.loggers import layout, parts
from strangers.rigs import Departure, Rig, RunPlan

_PER_AMPERE, _SHUT = 1.8e-6, 0.145  # area by current [m2/A], and the current at which it begins [A]
_LOAD = {
    "hang": "McKibben muscle with a hanging mass",
    "spring": "McKibben muscle against a spring",
    "held": "McKibben muscle at held length",
    "tank": "Steel tank, filling and venting",
}
_DRIVE = {
    "pulses": "Valve commands are rectangular pulses by hand and by chance.",
    "sines": "The inlet command is the sum of two sines, the outlet stays open a little; commands follow the curve.",
    "staircase": "The outlet stays open a little, the inlet's command goes up and down in steps.",
    "controller": "Commands come from a position controller, 25 times a second, and hold between.",
}
_SENSORS = {
    "p": "pressure{} in the {} (piezo-resistive, class 0.25 of 1 MPa)",
    "x": "contraction (draw wire, resolution 0.01 mm)",
    "F": "pull (load cell, class 0.5)",
    "T": "temperature of the gas (thermocouple, 0.1 K shown)",
}
_BENCHES = {
    "hang": "PneumaticMuscle.Benches.Isotonic",
    "held": "PneumaticMuscle.Benches.Isometric",
    "tank": "PneumaticMuscle.Benches.TankFilling",
    "spring": "SpringRig.mo",
}

SPRING_RIG = """model SpringRig "A muscle that stretches a spring, fed by two valves"
  extends PneumaticMuscle.Interfaces.Rig;
  PneumaticMuscle.Interfaces.Signals.CurrentInput u_in(start=0.35) "Current of the inlet valve";
  PneumaticMuscle.Interfaces.Signals.CurrentInput u_out(start=0) "Current of the exhaust valve";
  PneumaticMuscle.Interfaces.Signals.GaugePressureInput p_supply(start=207000.0, min=-101000.0)
    "Gauge pressure of the supply";
  PneumaticMuscle.Interfaces.Signals.GaugePressureOutput p "Gauge pressure in the muscle";
  PneumaticMuscle.Interfaces.Signals.LengthOutput x "Contraction";
  PneumaticMuscle.Interfaces.Signals.TemperatureOutput T "Temperature reading";
  PneumaticMuscle.Pneumatics.Valves valve(u_in=u_in, u_out=u_out, p_supply=p_supply) "Valves";
  PneumaticMuscle.Muscles.Physical muscle(F_start=spring.F_start) "Muscle";
  PneumaticMuscle.Mechanics.Spring spring(x_start=muscle.x_start) "Spring";
  PneumaticMuscle.Instruments.Pressure pressure "Pressure transducer at the muscle";
  PneumaticMuscle.Instruments.Position position "Displacement transducer at the load end";
  PneumaticMuscle.Instruments.Temperature temperature "Thermometer in the gas";
equation
  connect(muscle.port, pressure.port);
  connect(muscle.port, temperature.port_a);
  connect(temperature.port_b, valve.port);
  connect(muscle.flange_a, position.flange);
  connect(muscle.flange_a, spring.flange);
  p = pressure.p;
  x = position.x;
  T = temperature.T;
end SpringRig;
"""


def notes(rig: Rig, files: list[list[str]]) -> str:
    """The text of notes.md: what is known of the rig, how it was recorded, and what is not known well."""
    paragraphs = [
        f"# {_LOAD[rig.truth.load]} (lab {_letter(rig.number)})",
        " ".join(_apparatus(rig)),
        " ".join(_feed(rig)),
        " ".join(_recording(rig)),
        "\n".join(_run_lines(rig, files)),
        f"Not known well: {', '.join(rig.unknown)}.",
    ]
    return "\n\n".join(p for p in paragraphs if p) + "\n"


def _letter(number: int) -> str:
    return chr(ord("A") + number % 26) * (1 + number // 26)


def _apparatus(rig: Rig) -> Iterator[str]:
    r = rig.truth
    if r.load == "tank":
        yield f"Steel tank, {1e3 * r.V_tank:g} litres (weighed with water), about twice as long as wide."
        return
    yield (
        f"Nylon braid over a rubber tube, wall {1e3 * r.t_wall:g} mm. Rest length between the fittings "
        f"{1e3 * r.L0:g} mm, diameter of the braid {1e3 * r.D0:g} mm, braid angle "
        f"{math.degrees(r.angle):.1f} deg against the axis (all at rest, the angle from a photograph)."
    )
    if r.load == "hang":
        masses = sorted({p.M for p in rig.runs}, reverse=True)
        yield f"The muscle hangs from the frame and carries {' or '.join(f'{m:g} kg' for m in masses)} (weighed)."
    if r.load == "spring":
        yield (
            f"Its free end pulls a slide of {r.M:g} kg against a steel spring of {r.k_spring / 1e3:g} N/mm with a "
            f"preload of {r.F_spring:g} N at rest length; the guide damps with about {r.d_guide:g} N s/m."
        )
    if r.load == "held":
        yield "The other end is held by a slide with a load cell, at a contraction that each run states."


def _feed(rig: Rig) -> Iterator[str]:
    r, v = rig.truth, rig.valves
    if v.unit == "-":
        yield "Two on/off valves, one from the supply, one to the room, logged as 0 (shut) and 1 (open);"
    else:
        yield (
            f"Two proportional valves, one from the supply, one to the room: closed at {v.shut:g} {v.unit}, fully open "
            f"at {v.full:g} {v.unit}, area proportional in between;"
        )
    areas = f"{1e6 * r.A_in:.3g} mm2"
    if r.A_out != r.A_in:
        areas = f"{areas} (inlet) and {1e6 * r.A_out:.3g} mm2 (outlet)"
    yield f"flow area when fully open {areas} by the data sheet, without a discharge coefficient (0.6 to 0.9 is usual)."
    if r.V_hose:
        length = next(d.what for d in rig.departures if d.name == "hose").split(",")[0]
        yield f"Valves and muscle are connected by a {length}."
    yield (
        f"Supply: regulator set to {r.p_supply / 1e3:g} kPa above ambience, not recorded. "
        f"Room {r.T_amb - 273.15:.1f} C in all runs, ambience {r.p_amb / 1e3:g} kPa."
    )


def _recording(rig: Rig) -> Iterator[str]:
    form, r = layout(rig), rig.truth
    place = "tank" if r.load == "tank" else "muscle"
    kind = " above ambience" if form.columns["p"].offset == 0 else ", absolute,"
    sensors = [_SENSORS[s].format(kind, place) for s in rig.sigma]
    yield f"Recorded at {rig.rate:g} Hz: both commands, {', '.join(sensors)}."
    if "x" in rig.sigma:
        column = form.columns["x"]
        zero = (
            f"The length is recorded: {1e3 * r.L0:g} mm at rest."
            if column.gain < 0
            else "Zero is the rest length."
        )
        yield zero
    for name, signals in rig.loggers.items():
        yield f"{' and '.join(signals)} by a logger of its own ({name} files), started by the same trigger."
    if rig.layout == "one file":
        yield "All runs are in one file, its clock ran on; the column run numbers them."
    yield _DRIVE[rig.drive]


def _run_lines(rig: Rig, files: list[list[str]]) -> Iterator[str]:
    for number, (plan, names) in enumerate(zip(rig.runs, files, strict=True), 1):
        text = "cut out of a longer recording" if plan.begin else "begins at rest"
        if not plan.begin:
            text += (
                " and empty"
                if plan.start.p == 0
                else f", the gauge at {_first_reading(rig, plan):.0f} kPa"
            )
        if rig.truth.load == "hang" and len({p.M for p in rig.runs}) > 1:
            text += f"; {plan.M:g} kg"
        if rig.truth.load == "held":
            text += (
                "; the slide moves, recorded"
                if callable(plan.imposed)
                else f"; held at a contraction of {1e3 * plan.imposed:g} mm"
            )
        if rig.layout == "one file":
            begin, end = list(parts(rig))[number - 1]
            text += f"; {begin:g} s to {end:g} s"
        yield f"- run {number} ({', '.join(names)}): {text}"


def _first_reading(rig: Rig, plan: RunPlan) -> float:
    """Of the gauge [kPa above ambience], in a run that begins at rest."""
    return (rig.truth.p_gain * plan.start.p + rig.truth.p_zero) / 1e3


# -- the data set ------------------------------------------------------------------------------


def draft(rig: Rig, files: list[list[str]]) -> str:
    """The text of experiment.toml, by one who knows the software and has read the notes."""
    r = rig.truth
    lines = [f'title = "rig {rig.number}"', f'model = "{_BENCHES[r.load]}"', ""]
    lines += ["[parameters]", *_known(rig), "", "[fit]"]
    lines += ['"valve.C_A" = { min = 0.5, max = 1.0, start = 0.7 }']
    exponent = "tank.n" if r.load == "tank" else "muscle.n_g"
    lines += [f'"{exponent}" = {{ min = 1.0, max = 1.4 }}']
    if "heat transfer" in rig.unknown:
        lines += ['"muscle.h_film" = { min = "5 W/(m2.K)", max = "200 W/(m2.K)" }']
    if rig.layout == "one file":
        lines += ["", "[recording]", 'ignore = ["run"]']
    columns = list(_maps(rig, ["time", "u_in", "u_out", *_first(rig)]))
    if columns:
        lines += ["", "[columns]", *columns]
    for number, (plan, names) in enumerate(zip(rig.runs, files, strict=True)):
        lines += ["", *_run(rig, plan, names, number)]
    return "\n".join(lines) + "\n"


def _first(rig: Rig) -> list[str]:
    apart = {s for signals in rig.loggers.values() for s in signals}
    return [s for s in rig.sigma if s not in apart]


def _known(rig: Rig) -> Iterator[str]:
    r = rig.truth
    yield f'p_supply = "{r.p_supply / 1e3:g} kPa"'
    yield f'"ambient.T" = "{r.T_amb - 273.15:g} degC"'
    yield f'"ambient.p" = "{r.p_amb / 1e3:g} kPa"'
    if r.load == "tank":
        yield f'"tank.V" = "{1e3 * r.V_tank:g} l"'
        yield f'"tank.T_start" = "{r.T_amb - 273.15:g} degC"'
        return
    turns = r.L0 * math.tan(r.angle) / (math.pi * r.D0)
    yield f'"muscle.L0" = "{1e3 * r.L0:g} mm"'
    yield f'"muscle.D0" = "{1e3 * r.D0:g} mm"'
    yield f'"muscle.turns" = {turns:.6g}'
    yield f'"muscle.t_wall" = "{1e3 * r.t_wall:g} mm"'
    yield '"muscle.fibres" = 1    # heat passes through the whole surface'
    yield '"muscle.w" = "0.01 mm"'
    yield '"muscle.mu_fb" = 0     # no friction is known'
    yield '"muscle.mu_d" = 0'
    if r.load == "hang":
        yield f'"load.m" = "{r.M:g} kg"'
    if r.load == "spring":
        yield f'"spring.m" = "{r.M:g} kg"'
        yield f'"spring.k" = "{r.k_spring:g} N/m"'
        yield f'"spring.F_0" = "{r.F_spring:g} N"'
        yield f'"spring.d" = "{r.d_guide:g} N.s/m"'


def _maps(rig: Rig, quantities: list[str]) -> Iterator[str]:
    """Lines of [columns], where a column is not what its name says."""
    columns = layout(rig).columns
    for quantity in quantities:
        column = columns[quantity]
        name = json.dumps(column.name, ensure_ascii=False)
        if quantity in ("u_in", "u_out"):
            sheet = rig.valves
            full = rig.truth.A_in if quantity == "u_in" else rig.truth.A_out
            gain = full / _PER_AMPERE / (sheet.full - sheet.shut)
            offset = _SHUT - gain * sheet.shut
            unit = "A"
            if sheet.unit in ("A", "mA", "V"):
                unit = f"A/{sheet.unit}"
            elif sheet.unit == "%":
                gain *= 100
            yield f'{quantity} = {{ column = {name}, gain = "{gain:.8g} {unit}", offset = "{offset:.8g} A" }}'
        elif quantity == "p" and column.offset:
            yield f'p = {{ column = {name}, offset = "{-rig.truth.p_amb / 1e3:g} kPa" }}'
        elif column.gain < 0:
            formula = f"\"{1e3 * rig.truth.L0:g} mm\" - '{column.name}'"
            yield f"{quantity} = {{ formula = {json.dumps(formula, ensure_ascii=False)} }}"
        elif column.name != quantity:
            yield f"{quantity} = {{ column = {name} }}"


def _run(rig: Rig, plan: RunPlan, names: list[str], number: int) -> Iterator[str]:
    yield "[[runs]]"
    yield f'file = "{names[0]}"'
    yield f'role = "{"holdout" if plan.held_out else "fit"}"'
    if rig.drive != "sines":
        yield 'interpolation = "previous"'
    rest = rig.truth.load == "tank" and not plan.begin
    if plan.begin or plan.start.p:
        yield f'start = "{"rest" if rest else "estimated"}"'
    if rig.layout == "one file":
        begin, end = list(parts(rig))[number]
        yield f'from = "{begin:g} s"'
        yield f'to = "{end:g} s"'
    known = []
    if rig.truth.load == "hang" and plan.M != rig.truth.M:
        known += [f'"load.m" = "{plan.M:g} kg"']
    if rig.truth.load == "held":
        held = plan.imposed
        at = held(plan.begin) if callable(held) else held
        known += [f'"drive.s_start" = "{1e3 * at:g} mm"']
        if not callable(held):
            known += [f's = "{1e3 * held:g} mm"']
    if rest and plan.start.p:
        known += [f'"tank.p_start" = "{_first_reading(rig, plan):.0f} kPa"']
    if known:
        yield from ["[runs.parameters]", *known]
    if callable(plan.imposed) and (columns := list(_maps(rig, ["s"]))):
        yield from ["[runs.columns]", *columns]
    for file, signals in zip(names[1:], rig.loggers.values(), strict=True):
        yield from ["[[runs.loggers]]", f'file = "{file}"', 'offset = "0 s"']
        if columns := list(_maps(rig, ["time", *signals])):
            yield from ["[runs.loggers.columns]", *columns]


def described(departure: Departure) -> dict[str, str]:
    """A departure for truth.json, without what it changes."""
    return {
        "name": departure.name,
        "family": departure.family,
        "what": departure.what,
        "size": departure.size,
    }
