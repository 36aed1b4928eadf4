"""C source of one model: the functions and tables that ``pam_model.h`` asks for."""

from __future__ import annotations

import json
import math
import re
from collections.abc import Iterable, Sequence

import casadi as ca

from pam_cosim.compiler.ode import Ode
from pam_cosim.errors import ModelError
from pam_cosim.fmu.table import table

# A model whose equations mention time may change without notice: never step over more of the run than this.
_STEPS_OF_TIMED_MODEL = 100


def model_functions(ode: Ode) -> list[ca.Function]:
    """The functions the runtime calls, with the inputs and outputs listed in ``pam_model.h``.

    Raises:
        ModelError: an expression holds a symbol that is neither time, state, input nor parameter.
    """
    t, x, u, p = ode.t, ode.x, ode.u, ode.p
    f, y, w = (ca.densify(ca.SX(e)) for e in (ode.derivatives, ode.outputs, ode.locals))
    x0 = ca.densify(ca.SX(ode.initial))
    du = ca.SX.sym("du", u.numel())
    sx, su, sp, st = (ca.SX.sym(n, s.numel()) for n, s in (("sx", x), ("su", u), ("sp", p), ("st", t)))
    total = ca.jtimes(f, ca.vertcat(t, u), ca.vertcat(ca.SX(1), du))
    # One seed for everything at once: the derivative along (st, sx, su, sp).
    along = [ca.jtimes(e, ca.vertcat(t, x, u, p), ca.vertcat(st, sx, su, sp)) for e in (f, y, w)]
    return [
        _function("pam_rhs", [t, x, u, p], [f]),
        _function("pam_out", [t, x, u, p], [y]),
        _function("pam_loc", [t, x, u, p], [w]),
        _function("pam_lin", [t, x, u, du, p], [f, ca.jacobian(f, x), total]),
        _function("pam_jvp", [t, x, u, p, st, sx, su, sp], along),
        _function("pam_init", [p], [x0]),
        _function("pam_init_jvp", [p, sp], [ca.jtimes(x0, p, sp)]),
    ]


def _function(name: str, inputs: Sequence[ca.SX], outputs: Sequence[ca.SX]) -> ca.Function:
    dense = [ca.densify(output) for output in ca.cse(list(outputs))]
    symbols = ca.symvar(ca.vertcat(*[ca.vec(output) for output in dense]))
    known = {str(s) for i in inputs for s in ca.symvar(i)}
    foreign = [str(s) for s in symbols if str(s) not in known]
    if foreign:
        raise ModelError(f"the model's equations use {', '.join(foreign)}, which has no value here")
    return ca.Function(name, list(inputs), dense)


def model_source(ode: Ode, guid: str) -> str:
    """One C file, complete but for ``pam_model.h``; it is the same for the same model and GUID."""
    functions = model_functions(ode)
    generator = ca.CodeGenerator("model", {"with_header": False})
    for function in functions:
        generator.add(function)
    face = ode.interface
    timed = ca.jacobian_sparsity(ode.derivatives, ode.t).nnz() > 0 if ode.states else False
    max_step = face.stop_time / _STEPS_OF_TIMED_MODEL if timed else 0.0
    inputs = [entry.start or 0.0 for entry in table(ode) if entry.causality == "input"]
    sizes = [len(ode.states), ode.u.numel(), ode.outputs.numel(), ode.p.numel(), ode.locals.numel()]
    work = [max(f.sz_iw() for f in functions), max(f.sz_w() for f in functions)]
    parts = [
        '#include "pam_model.h"\n#define CASADI_SYMBOL_EXPORT static',
        _without_helpers(generator.dump()),
        _array("const char *const", "state_names", (json.dumps(s.name) for s in ode.states)),
        _array("const double", "state_nominals", (_nominal(s.nominal) for s in ode.states)),
        _array("const double", "input_starts", (_double(v) for v in inputs)),
        _array("const double", "parameter_starts", (_double(v.start) for v in face.parameters.values())),
        "const pam_model pam_the_model = {",
        f"    {json.dumps(guid)}, {', '.join(str(n) for n in sizes + work)},",
        f"    {_double(face.tolerance)}, {_double(max_step)},",
        "    state_names, state_nominals, input_starts, parameter_starts,",
        f"    {', '.join(f.name() for f in functions)},",
        "};\n",
    ]
    return "\n".join(parts)


_HELPERS = "|".join(
    ("checkout", "release", "incref", "decref", "n_in", "n_out", "default_in", "name_in", "name_out",
     "sparsity_in", "sparsity_out", "work", "work_bytes")
)  # fmt: skip
_HELPER = re.compile(rf"(?ms)^CASADI_SYMBOL_EXPORT [^\n]*?\w+_(?:{_HELPERS})\([^\n]*(?:}}|\{{\n.*?^}})\n+")


def _without_helpers(source: str) -> str:
    """Leaves out what CasADi adds for its own importer and nobody calls here."""
    return _HELPER.sub("", source)


def _array(kind: str, name: str, items: Iterable[str]) -> str:
    text = ", ".join(items)
    return f"static {kind} {name}[] = {{{text or '0'}}};"


def _nominal(value: float | None) -> str:
    return _double(abs(value)) if value is not None and math.isfinite(value) else "0"


def _double(value: float | None) -> str:
    if value is None or not math.isfinite(value):
        raise ModelError("a start value of the model is not a finite number")
    return repr(float(value))
