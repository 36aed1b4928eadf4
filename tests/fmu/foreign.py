"""Small FMUs of no tool in particular, in C: variables of every type, arrays, fixed steps, model exchange."""

from __future__ import annotations

import re
import zipfile
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.sax.saxutils import quoteattr

import fmpy

from pam_cosim.fmu.compile import compile_library
from pam_cosim.fmu.platforms import PLATFORMS, native_platform

_C_TYPES = {
    2: {"Real": "double", "Integer": "int", "Boolean": "int"},
    3: {
        "Float64": "double",
        "Float32": "float",
        "Boolean": "_Bool",
        **{f"{u}Int{n}": f"{u.lower()}int{n}_t" for u in ("", "U") for n in (8, 16, 32, 64)},
    },
}


@dataclass(frozen=True)
class Scalar:
    """A variable of the description; ``further`` are attributes of its type."""

    name: str
    type: str
    causality: str
    start: str | None = None
    variability: str = "continuous"
    further: str = ""
    size: int = 0  # of an array; 0: none

    @property
    def values(self) -> int:
        return max(1, self.size)


_COMMON = """
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <math.h>
#define EXPORT __attribute__((visibility("default")))
typedef struct { double v[64]; char text[64]; double time; void *environment; void *logger; int exchange, ended; } M;
%(names)s
static const int OFFSET[] = {%(offsets)s}, SIZE[] = {%(sizes)s};
static const double START[] = {%(starts)s};
static int say(M *m, int status, const char *message);
static void outputs(M *m) { %(outputs)s }
static double rate(M *m) { return %(rate)s; }
static int step(M *m, double h) { %(step)s; m->time += h; return m->ended ? 2 : 0; }
static M *fresh(M *m) { memcpy(m->v, START, sizeof START); strcpy(m->text, "none"); m->time = 0; return m; }
"""
_VALUES = """
EXPORT int fmi%(fmi)dSet%(type)s(M *m, const unsigned *r, size_t n, const %(c)s *x%(count)s) {
    for (size_t i = 0; i < n; i++) for (int j = 0; j < SIZE[r[i]]; j++) m->v[OFFSET[r[i]] + j] = (double)*x++;
    return 0;
}
EXPORT int fmi%(fmi)dGet%(type)s(M *m, const unsigned *r, size_t n, %(c)s *x%(count)s) {
    outputs(m);
    for (size_t i = 0; i < n; i++) for (int j = 0; j < SIZE[r[i]]; j++) *x++ = (%(c)s)m->v[OFFSET[r[i]] + j];
    return 0;
}
"""
_VERSION = {
    2: """
typedef void log_2(void *, const char *, int, const char *, const char *, ...);
static int say(M *m, int status, const char *text) {
    if (m->logger) ((log_2 *)m->logger)(m->environment, "i", status, "all", text);
    return status;
}
EXPORT void *fmi2Instantiate(const char *n, int kind, const char *g, const char *r, void **f, int v, int on) {
    M *m = fresh(calloc(1, sizeof(M)));
    m->exchange = kind == 0; m->logger = on ? f[0] : 0; m->environment = f[4];
    return m;
}
EXPORT int fmi2SetupExperiment(M *m, int d, double tol, double t, int e, double s) { m->time = t; return 0; }
EXPORT int fmi2EnterInitializationMode(M *m) { return 0; }
EXPORT int fmi2DoStep(M *m, double t, double h, int keep) { return step(m, h); }
EXPORT int fmi2GetDerivatives(M *m, double *x, size_t n) { *x = rate(m); return 0; }
EXPORT int fmi2NewDiscreteStates(M *m, int *info) { memset(info, 0, 20); return 0; }
EXPORT int fmi2CompletedIntegratorStep(M *m, int keep, int *event, int *end) {
    outputs(m); *event = 0; *end = m->ended; return 0;
}
EXPORT int fmi2GetBooleanStatus(M *m, int kind, int *value) { *value = m->ended; return 0; }
EXPORT int fmi2GetRealStatus(M *m, int kind, double *value) { *value = m->time; return 0; }
EXPORT int fmi2SetString(M *m, const unsigned *r, size_t n, const char *const *x) { strcpy(m->text, *x); return 0; }
""",
    3: """
typedef void log_3(void *, int, const char *, const char *);
static int say(M *m, int status, const char *text) {
    if (m->logger) ((log_3 *)m->logger)(m->environment, status, "all", text);
    return status;
}
EXPORT void *fmi3InstantiateCoSimulation(const char *n, const char *g, const char *r, _Bool v, _Bool on, _Bool e,
        _Bool early, const unsigned *q, size_t k, void *environment, void *log, void *update) {
    M *m = fresh(calloc(1, sizeof(M)));
    m->logger = on ? log : 0; m->environment = environment;
    return m;
}
EXPORT void *fmi3InstantiateModelExchange(const char *n, const char *g, const char *r, _Bool v, _Bool on,
        void *environment, void *log) {
    return fmi3InstantiateCoSimulation(n, g, r, v, on, 0, 0, 0, 0, environment, log, 0);
}
EXPORT int fmi3EnterInitializationMode(M *m, _Bool d, double tol, double t, _Bool e, double s) {
    m->time = t; return 0;
}
EXPORT int fmi3DoStep(M *m, double t, double h, _Bool keep, _Bool *event, _Bool *end, _Bool *early, double *reached) {
    int status = step(m, h);
    *event = *early = 0; *end = m->ended; *reached = m->time; return m->ended ? 0 : status;
}
EXPORT int fmi3GetContinuousStateDerivatives(M *m, double *x, size_t n) { *x = rate(m); return 0; }
EXPORT int fmi3UpdateDiscreteStates(M *m, _Bool *a, _Bool *b, _Bool *c, _Bool *d, _Bool *e, double *t) {
    *a = *b = *c = *d = *e = 0; return 0;
}
EXPORT int fmi3CompletedIntegratorStep(M *m, _Bool keep, _Bool *event, _Bool *end) {
    outputs(m); *event = 0; *end = m->ended; return 0;
}
EXPORT int fmi3SetString(M *m, const unsigned *r, size_t n, const char *const *x, size_t k) {
    strcpy(m->text, *x); return 0;
}
""",
}
_PLAIN = """
EXPORT void fmi%(fmi)dFreeInstance(M *m) { free(m); }
EXPORT int fmi%(fmi)dReset(M *m) { fresh(m); return 0; }
EXPORT int fmi%(fmi)dTerminate(M *m) { return 0; }
EXPORT int fmi%(fmi)dExitInitializationMode(M *m) { return 0; }
EXPORT int fmi%(fmi)dEnterEventMode(M *m) { return 0; }
EXPORT int fmi%(fmi)dEnterContinuousTimeMode(M *m) { return 0; }
EXPORT int fmi%(fmi)dSetTime(M *m, double t) { m->time = t; return 0; }
EXPORT int fmi%(fmi)dGetContinuousStates(M *m, double *x, size_t n) { *x = STATE; return 0; }
EXPORT int fmi%(fmi)dSetContinuousStates(M *m, const double *x, size_t n) { STATE = *x; return 0; }
EXPORT int fmi%(fmi)dGetNominalsOfContinuousStates(M *m, double *x, size_t n) { *x = 1; return 0; }
EXPORT int fmi%(fmi)dGetEventIndicators(M *m, double *x, size_t n) { return 0; }
"""


def foreign(
    path: Path,
    fmi: int,
    scalars: Sequence[Scalar],
    *,
    outputs: str = "",
    step: str = "",
    rate: str = "0",
    kind: str = "CoSimulation",
    flags: str = 'canHandleVariableCommunicationStepSize="true"',
    types: str = "",
    interval: float | None = 0.01,
    start: float = 0.0,
    stop: float = 1.0,
    slashes: str = "/",
) -> Path:
    """An FMU whose variables are ``$name`` in C: ``outputs`` assigns them, ``step`` goes on by ``h``.

    A state is the variable ``x``, with the derivative ``der(x)``; ``rate`` is its value.
    """
    own = PLATFORMS[native_platform()]
    folder = own.folder if fmi == 2 else f"{own.target.split('-')[0]}-linux"
    library = compile_library(
        (), {"m.c": _source(fmi, scalars, outputs, step, rate)}, native_platform()
    )
    with zipfile.ZipFile(path, "w") as archive:
        text = _description(fmi, scalars, kind, flags, types, (interval, start, stop))
        archive.writestr("modelDescription.xml", text)
        entry = zipfile.ZipInfo("x")
        entry.filename = f"binaries/{folder}/m{own.suffix}".replace("/", slashes)
        archive.writestr(entry, library.read_bytes())
    return path


def _source(fmi: int, scalars: Sequence[Scalar], outputs: str, step: str, rate: str) -> str:
    offsets = [sum(s.values for s in scalars[:i]) for i in range(len(scalars))]
    places = [
        f"(m->v + {at})" if s.size else f"m->v[{at}]"
        for s, at in zip(scalars, offsets, strict=True)
    ]
    names = [
        f"#define ${s.name} {place}"
        for s, place in zip(scalars, places, strict=True)
        if s.name.isidentifier()
    ]
    states = [p for s, p in zip(scalars, places, strict=True) if s.name == "x"]
    names.append(f"#define STATE {(states or ['m->v[63]'])[0]}")
    starts = []
    for s in scalars:
        given = ["0"] if s.start is None or s.type == "String" else s.start.split()
        words = [{"true": "1", "false": "0"}.get(one, one) for one in given]
        starts += [words[i % len(words)] for i in range(s.values)]
    made = _COMMON % {
        "names": "\n".join(names),
        "offsets": ", ".join(map(str, offsets)),
        "sizes": ", ".join(str(s.values) for s in scalars),
        "starts": ", ".join(starts),
        "outputs": outputs,
        "rate": rate,
        "step": step,
    }
    made += _VERSION[fmi] + _PLAIN % {"fmi": fmi}
    count = ", size_t k" if fmi == 3 else ""
    for kind, c in _C_TYPES[fmi].items():
        made += _VALUES % {"fmi": fmi, "type": kind, "c": c, "count": count}
    header = Path(fmpy.__file__).parent / "c-code" / f"fmi{fmi}FunctionTypes.h"
    every = set(re.findall(rf"\b(fmi{fmi}\w+)TYPE\b", header.read_text()))
    for name in sorted(every):
        if f"{name}(" not in made:
            made += f"EXPORT int {name}(void) {{ return 3; }}\n"
    return made.replace(
        f"EXPORT int fmi{fmi}GetVersion(void) {{ return 3; }}",
        f'EXPORT const char *fmi{fmi}GetVersion(void) {{ return "{fmi}.0"; }}',
    )


def _description(
    fmi: int,
    scalars: Sequence[Scalar],
    kind: str,
    flags: str,
    types: str,
    times: tuple[float | None, float, float],
) -> str:
    numbers = {s.name: i for i, s in enumerate(scalars)}
    lines = []
    for s in scalars:
        of = "x" if s.name == "der(x)" else ""
        derivative = f' derivative="{numbers[of] + (fmi == 2)}"' if of else ""
        start = f" start={quoteattr(s.start)}" if s.start is not None else ""
        common = (
            f'name="{s.name}" valueReference="{numbers[s.name]}" causality="{s.causality}" '
            f'variability="{s.variability}"'
        )
        if fmi == 2:
            inner = f"<{s.type}{start}{derivative} {s.further}/>"
            lines.append(f"<ScalarVariable {common}>{inner}</ScalarVariable>")
            continue
        size = f'<Dimension start="{s.size}"/>' if s.size else ""
        if s.type == "String":
            size, start = f"<Start value={quoteattr(s.start or '')}/>", ""
        lines.append(f"<{s.type} {common}{start}{derivative} {s.further}>{size}</{s.type}>")
    found = [(s.name, i + 1 if fmi == 2 else i) for i, s in enumerate(scalars)]
    outputs = [i for n, i in found if scalars[numbers[n]].causality == "output"]
    rates = [i for n, i in found if n == "der(x)"]
    if fmi == 2:
        unknown = '<Unknown index="{}"/>'
        structure = f"<Outputs>{''.join(map(unknown.format, outputs))}</Outputs>" * bool(outputs)
        structure += f"<Derivatives>{''.join(map(unknown.format, rates))}</Derivatives>" * bool(
            rates
        )
        token = 'guid="g" numberOfEventIndicators="0"'
    else:
        structure = "".join(f'<Output valueReference="{i}"/>' for i in outputs)
        structure += "".join(f'<ContinuousStateDerivative valueReference="{i}"/>' for i in rates)
        token = 'instantiationToken="g"'
    if kind == "ModelExchange":
        flags = 'needsCompletedIntegratorStep="true"' if fmi == 3 else ""
    step = "" if times[0] is None else f' stepSize="{times[0]}"'
    return (
        f'<?xml version="1.0" encoding="UTF-8"?>\n<fmiModelDescription fmiVersion="{fmi}.0" modelName="m" {token}>'
        f'<{kind} modelIdentifier="m" {flags}/>'
        f"<TypeDefinitions>{types}</TypeDefinitions>"
        f'<DefaultExperiment startTime="{times[1]}" stopTime="{times[2]}"{step}/>'
        f"<ModelVariables>{''.join(lines)}</ModelVariables>"
        f"<ModelStructure>{structure}</ModelStructure></fmiModelDescription>"
    )
