"""Rodas5P itself: one step of fixed length against exact solutions."""

from __future__ import annotations

import ctypes
from functools import cache

import numpy as np
import pytest
from numpy.typing import NDArray
from scipy.integrate import solve_ivp

from pam_cosim.fmu.compile import compile_library
from pam_cosim.fmu.generate import model_source
from pam_cosim.fmu.platforms import native_platform
from pam_cosim.resources import fmu_runtime
from tests.fmu.models import forced

Array = NDArray[np.float64]

_HARNESS = """
#include <stdlib.h>
__attribute__((visibility("default")))
int fixed_step(double t, const double *x, double h, double s, double *end, double *inside, double *error) {
    const pam_model *m = &pam_the_model;
    pam_solver v;
    pam_solver_scalars scalars;
    double *saved = calloc(pam_solver_saved_size(m) + 1, sizeof(double));
    double *scratch = calloc(pam_solver_scratch_size(m) + 1, sizeof(double));
    int *pivot = calloc((size_t)m->nx + 1, sizeof(int));
    long long *iw = calloc((size_t)m->size_iw + 1, sizeof(long long));
    pam_solver_bind(&v, m, &scalars, saved, scratch, pivot, iw);
    memcpy(v.x, x, sizeof(double) * (size_t)m->nx);
    pam_solver_begin(&v, t, NULL, NULL, 1e-6);
    linearise(&v);
    int bad = factorise(&v, h) || stages(&v, h) >= 0;
    dense_output(&v);
    v.s->h = h;
    pam_solver_state(&v, t + h, end);
    pam_solver_state(&v, t + s * h, inside);
    memcpy(error, v.k + 7 * m->nx, sizeof(double) * (size_t)m->nx);
    free(saved); free(scratch); free(pivot); free(iw);
    return bad;
}
"""


@cache
def _library() -> ctypes.CDLL:
    solver = (fmu_runtime() / "pam_solver.c").read_text()
    sources = {"model.c": model_source(forced(), "guid"), "harness.c": solver + _HARNESS}
    library = ctypes.CDLL(
        str(compile_library(("pam_history.c", "pam_sensitivity.c"), sources, native_platform()))
    )
    library.fixed_step.argtypes = [
        ctypes.c_double,
        ctypes.c_void_p,
        ctypes.c_double,
        ctypes.c_double,
    ] + [ctypes.c_void_p] * 3
    return library


def _step(t: float, x: Array, h: float, s: float) -> tuple[Array, Array, Array]:
    """End of the step, dense output at the fraction s of it, error estimate."""
    end, inside, error = np.empty(2), np.empty(2), np.empty(2)
    addresses = [a.ctypes.data for a in (end, inside, error)]
    assert _library().fixed_step(t, np.ascontiguousarray(x).ctypes.data, h, s, *addresses) == 0
    return end, inside, error


@cache
def _exact() -> object:
    def f(t: float, x: Array) -> list[float]:
        return [x[0] * np.cos(t), -(x[1] ** 2) * x[0] * (1 + np.sin(t) ** 2)]

    return solve_ivp(
        f, (0.0, 3.0), [1.0, 1.0], method="DOP853", rtol=3e-14, atol=1e-15, dense_output=True
    ).sol


def _solve(steps: int) -> Array:
    x, h = np.ones(2), 3.0 / steps
    for i in range(steps):
        x = _step(i * h, x, h, 0.5)[0]
    return x


def test_global_order_is_five() -> None:
    exact = _exact()(3.0)  # type: ignore[operator]
    errors = [np.abs(_solve(n) - exact).max() for n in (20, 40, 80)]
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 4.8) and np.all(orders < 5.6), orders


@pytest.mark.parametrize("s", [0.2, 0.5, 0.8])
def test_dense_output_has_order_four(s: float) -> None:
    """Its local error falls with the fifth power of the step."""
    errors = []
    for h in (0.4, 0.2, 0.1):
        starts = np.arange(0.0, 2.5, 0.25)
        local_errors = [_step(t, _exact()(t), h, s)[1] - _exact()(t + s * h) for t in starts]  # type: ignore[operator]
        errors.append(np.abs(local_errors).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 4.6), orders


def test_error_estimate_has_order_four() -> None:
    errors = []
    for h in (0.04, 0.02, 0.01):
        estimates = [_step(t, _exact()(t), h, 0.5)[2] for t in np.arange(0.0, 2.5, 0.25)]  # type: ignore[operator]
        errors.append(np.abs(estimates).max())
    orders = np.log2(np.array(errors[:-1]) / errors[1:])
    assert np.all(orders > 4.7) and np.all(orders < 5.3), orders
