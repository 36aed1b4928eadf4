"""C source of one model: the functions and tables that ``pam_model.h`` declares."""

from __future__ import annotations

import itertools
import math
import re
from collections.abc import Sequence, Set
from typing import Any

import casadi as ca

from pam_cosim.compiler.ode import Ode, Statement
from pam_cosim.errors import ModelError
from pam_cosim.fmu.c_text import c_array, c_string
from pam_cosim.fmu.functions import model_functions
from pam_cosim.fmu.table import Kind, VariableEntry, table

# A model whose equations mention time may change without notice: never step over more of the run than this.
_STEPS_OF_TIMED_MODEL = 100


def model_source(ode: Ode, guid: str, lean: bool = False, fmi: str = "2.0") -> str:
    """One C file, complete but for ``pam_model.h``; it is the same for the same model, GUID and version of FMI.

    ``lean``: without directional derivatives, rates of sensitivities and ranges.
    """
    functions = model_functions(ode, lean)
    generator = ca.CodeGenerator("model", {"with_header": False})
    for function in functions:
        generator.add(function)
    generated = _unguarded(_without_helpers(generator.dump()))
    if ode.sensitivities and not lean:
        generated = _seldom("pam_jvp", generated)
    numbers = numbers_of(ode, functions, lean, fmi)
    parts = [
        f"static const char guid[] = {c_string(guid)};",  # first: what a model calls itself may look like one
        '#include "pam_model.h"\n#define CASADI_SYMBOL_EXPORT static',
        generated,
        c_array("const char *const", "state_names", map(c_string, numbers["state_names"])),
        *(c_array("const double", name, map(repr, numbers[name])) for name in DOUBLES),
        *(c_array("const int", name, map(str, numbers[name])) for name in INTEGERS),
        *_statements(ode),
        *_variables(numbers["variables"]),
        "const pam_model pam_the_model = {",
        f"    guid, {', '.join(str(numbers[name]) for name in SIZES)},",
        f"    {numbers['tolerance']!r}, {numbers['max_step']!r},",
        f"    {', '.join(('state_names', *DOUBLES, *INTEGERS))},",
        f"    {', '.join(_slots({f.name() for f in functions}))},",
        "    statements, variables,",
        "};\n",
    ]
    return "\n".join(parts)


def numbers_of(
    ode: Ode, functions: Sequence[ca.Function], lean: bool = False, fmi: str = "2.0"
) -> dict[str, Any]:
    """The tables of ``pam_model`` by the names that they have there, and what the model states of itself.

    Args:
        ode: the model.
        functions: of ``model_functions``.
        lean: without ranges and aliases.
        fmi: version of the interface.

    Raises:
        ModelError: a start value is not finite.
    """
    interface = ode.interface
    blocks, entries = _blocks(ode), table(ode, fmi, lean=lean)
    timed = ca.jacobian_sparsity(ode.derivatives, ode.t).nnz() > 0 if ode.states else False
    return {
        **_sizes(ode, functions, sum(not entry.alias for entry in entries), len(blocks)),
        "tolerance": _finite(interface.tolerance),
        "max_step": _finite(interface.stop_time / _STEPS_OF_TIMED_MODEL if timed else 0.0),
        "state_names": [s.name for s in ode.states],
        "state_nominals": [_nominal(s.nominal) for s in ode.states],
        "input_starts": [_finite(e.start or 0.0) for e in entries if e.causality == "input"],
        "parameter_starts": [_finite(v.start) for v in interface.parameters.values()],
        "delayed_inputs": [-1 if d.input is None else d.input for d in ode.delays],
        "direct_inputs": [int(direct) for direct in _direct_inputs(ode)],
        "start_of": _start_of(ode),
        "resting": _resting(ode),
        "block_states": [state for block in blocks for state in block],
        "block_ends": list(itertools.accumulate(map(len, blocks))),
        "statements": [_statement_row(statement) for statement in ode.statements],
        "variables": [_variable_row(entry, lean) for entry in entries if not entry.alias],
    }


def _variable_row(entry: VariableEntry, lean: bool) -> list[Any]:
    """A row of ``pam_variable``; an infinite limit is None."""
    variable, limits = entry.variable, (entry.variable.min, entry.variable.max)
    ranged = not lean and (entry.causality in ("input", "parameter") or entry.kind is Kind.STATE)
    given = [x if ranged and x is not None and math.isfinite(x) else None for x in limits]
    tunable = int(entry.causality == "parameter" and entry.variability == "tunable")
    return [
        variable.name,
        variable.unit,
        list(Kind).index(entry.kind),
        entry.index,
        tunable,
        *given,
    ]


def _sizes(
    ode: Ode, functions: Sequence[ca.Function], variables: int, blocks: int
) -> dict[str, int]:
    """How many there are of each, and the working memory that the functions need, in the order of ``SIZES``."""
    sizes = [
        len(ode.states),
        *(part.numel() for part in (ode.u, ode.d, ode.outputs, ode.p, ode.locals)),
        ode.core,
        len(ode.sensitivities),
        len(ode.statements),
        sum(len(statement.values) for statement in ode.statements),
        variables,
        blocks,
        max(function.sz_iw() for function in functions),
        max(function.sz_w() for function in functions),
    ]
    return dict(zip(SIZES, sizes, strict=True))


def _statement_row(statement: Statement) -> dict[str, Any]:
    return {
        "is_error": int(statement.is_error),
        "at_start": int(statement.at_start),
        "texts": list(statement.texts),
        "digits": [digits for _, digits in statement.values],
    }


# In the order of ``pam_model``.
_SIZES = "nx nu nd ny np nw nc ns na nm nv nb size_iw size_w"
SIZES = tuple(_SIZES.split())
DOUBLES = ("state_nominals", "input_starts", "parameter_starts")
INTEGERS = ("delayed_inputs", "direct_inputs", "start_of", "resting", "block_states", "block_ends")
_FUNCTIONS = """
pam_rhs pam_out pam_loc pam_core_rhs pam_lin pam_variation pam_jvp pam_init pam_init_jvp pam_delay pam_check
pam_start_lin pam_start_variation pam_start_jvp
"""
FUNCTIONS = tuple(_FUNCTIONS.split())


def _slots(there: Set[str]) -> list[str]:
    return [name if name in there else "0" for name in FUNCTIONS]


def _statements(ode: Ode) -> list[str]:
    """The table of what must hold, with the parts of its messages."""
    lines, rows = [], []
    for i, s in enumerate(ode.statements):
        lines.append(c_array("const char *const", f"texts_{i}", map(c_string, s.texts)))
        lines.append(c_array("const int", f"digits_{i}", [str(digits) for _, digits in s.values]))
        rows.append(
            f"{{{int(s.is_error)}, {int(s.at_start)}, {len(s.values)}, texts_{i}, digits_{i}}}"
        )
    return [*lines, c_array("const pam_statement", "statements", rows or ["{0}"])]


def _variables(rows: Sequence[Sequence[Any]]) -> list[str]:
    """The table of variables."""
    lines = []
    for name, unit, kind, index, tunable, low, high in rows:
        limits = (
            "-INFINITY" if low is None else repr(low),
            "INFINITY" if high is None else repr(high),
        )
        lines.append(
            f"    {{{c_string(name)}, {c_string(unit)}, {kind}, {index}, {tunable}, {', '.join(limits)}}},"
        )
    return ["static const pam_variable variables[] = {", *(lines or ["    {0}"]), "};"]


def _start_of(ode: Ode) -> list[int]:
    """For each sensitivity, the number of the state whose start value it is with respect to; -1: of a parameter."""
    states = [state.name for state in ode.states[: ode.core]]
    return [states.index(name) if name in states else -1 for name in ode.sensitivities]


def _resting(ode: Ode) -> list[int]:
    """Of each state 1 where it begins at rest, 2 where it follows what does."""
    following = dict(ode.following)
    names = [state.name for state in ode.states[: ode.core]]
    return [1 if name in ode.resting else 2 if name in following else 0 for name in names]


def _blocks(ode: Ode) -> list[list[int]]:
    """The states of which each depends on every other, those first that others depend on."""
    core = ode.core
    slopes = ca.jacobian_sparsity(ode.derivatives[:core], ode.x[:core])
    count, states, ends = slopes.T.scc()
    return [sorted(states[ends[i] : ends[i + 1]]) for i in range(count)]


def _direct_inputs(ode: Ode) -> list[bool]:
    """For each input, whether a derivative depends on its present value."""
    if not ode.states:
        return [False] * ode.u.numel()
    columns = ca.jacobian_sparsity(ode.derivatives, ode.u).get_col()
    return [i in columns for i in range(ode.u.numel())]


_HELPERS = "|".join(
    (
        "checkout",
        "release",
        "incref",
        "decref",
        "n_in",
        "n_out",
        "default_in",
        "name_in",
        "name_out",
        "sparsity_in",
        "sparsity_out",
        "work",
        "work_bytes",
    )
)
_HELPER = re.compile(
    rf"(?ms)^CASADI_SYMBOL_EXPORT [^\n]*?\w+_(?:{_HELPERS})\([^\n]*(?:}}|\{{\n.*?^}})\n+"
)


_START = re.compile(r"(?m)^(?=/\* pam_\w+:)")
_ASKED_FOR = re.compile(r"if \(res\[\d+\]!=0\) ")
_GIVEN = re.compile(r"arg\[\d+\]\? (arg\[\d+\]\[\d+\]) : 0")


def _unguarded(source: str) -> str:
    """Without CasADi's questions whether each argument and result is there at all.

    The runtime gives and takes all of them, but for the delays; a branch at every number makes the functions
    slower, and the compiler much slower.
    """
    parts = _START.split(source)
    return "".join(
        p if p.startswith("/* pam_delay:") else _GIVEN.sub(r"\1", _ASKED_FOR.sub("", p))
        for p in parts
    )


def _seldom(name: str, source: str) -> str:
    """Marks a function whose speed is not worth the time that it takes to make it fast.

    Where the model integrates its sensitivities, who fits it has no need of directional derivatives, and to optimise
    those takes a third of the time in which the model is compiled.
    """
    return re.sub(rf"(?m)^(/\* {name}:.*\*/\n)static", r"\1PAM_SELDOM static", source, count=1)


_UNUSED = re.compile(
    r"(?ms)^static const casadi_int casadi_s\d+\[[^\n]*\n"
    r"|^CASADI_SYMBOL_EXPORT [^\n]* model_casadi_\w+\([^\n]*(?:\}|\{\n.*?^\})\n"
)
_SHARED = re.compile(r"(?m)^(?=casadi_real casadi_\w+\()")


def _without_helpers(source: str) -> str:
    """Leaves out what CasADi adds for its own importer, which is not used here."""
    return _SHARED.sub("static ", _UNUSED.sub("", _HELPER.sub("", source)))


def _nominal(value: float | None) -> float:
    return abs(float(value)) if value is not None and math.isfinite(value) else 0.0


def _finite(value: float | None) -> float:
    if value is None or not math.isfinite(value):
        raise ModelError("a start value of the model is not a finite number")
    return float(value)
