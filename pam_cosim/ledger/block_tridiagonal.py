"""A block tridiagonal matrix with a border: the normal equations of a smoother, factored (Cholesky)."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.linalg import cho_factor, cho_solve, cho_solve_banded, cholesky_banded

from pam_cosim.arrays import Array


@dataclass(frozen=True)
class BlockTridiagonal:
    """A symmetric matrix of N blocks of size b and a border of q rows.

    Attributes:
        diagonal: (N, b, b).
        coupling: (N - 1, b, b), rows of a block, columns of the next.
        border: (N, b, q).
        corner: (q, q).
    """

    diagonal: Array
    coupling: Array
    border: Array
    corner: Array


class CholeskyFactor:
    """The Cholesky factor of a positive definite matrix."""

    def __init__(self, matrix: BlockTridiagonal) -> None:
        n, b, q = matrix.border.shape
        self._shape = (n, b)
        self._banded = cholesky_banded(
            _band(matrix), lower=True, overwrite_ab=True, check_finite=False
        )
        border = matrix.border.reshape(n * b, q)
        self._response = self._inner(border)
        schur = matrix.corner - border.T @ self._response
        self._border = border
        self._schur = cho_factor(schur, lower=True) if q else None
        self.log_determinant = 2 * float(np.log(self._banded[0]).sum())
        if self._schur is not None:
            self.log_determinant += 2 * float(np.log(np.diag(self._schur[0])).sum())

    def solve(self, blocks: Array, corner: Array) -> tuple[Array, Array]:
        """The solution for a right-hand side (N, b) and (q,)."""
        inner = self._inner(blocks.reshape(-1, 1))[:, 0]
        if self._schur is None:
            return inner.reshape(self._shape), corner
        outer = cho_solve(self._schur, corner - self._border.T @ inner)
        return (inner - self._response @ outer).reshape(self._shape), outer

    def covariances(self) -> tuple[Array, Array]:
        """Diagonal blocks of the inverse, (N, b, b), and its corner (q, q)."""
        n, b = self._shape
        diagonal, coupling = self._factor_blocks()
        inverse = np.linalg.inv(diagonal)
        own_inverse = np.einsum("nji,njk->nik", inverse, inverse)
        gain = coupling @ inverse[:-1]
        blocks = np.empty((n, b, b))
        blocks[-1] = own_inverse[-1]
        for k in range(n - 2, -1, -1):
            c = gain[k]
            blocks[k] = own_inverse[k] + c.T @ blocks[k + 1] @ c
        if self._schur is None:
            return blocks, np.zeros((0, 0))
        corner = cho_solve(self._schur, np.eye(self._response.shape[1]))
        response = self._response.reshape(n, b, -1)
        return blocks + np.einsum("niq,qr,njr->nij", response, corner, response), corner

    def _inner(self, right: Array) -> Array:
        if right.shape[1] == 0:
            return right
        solution: Array = cho_solve_banded((self._banded, True), right, check_finite=False)
        return solution

    def _factor_blocks(self) -> tuple[Array, Array]:
        """Blocks (N, b, b) on the diagonal of the lower factor, and (N - 1, b, b) below it."""
        n, b = self._shape
        diagonal, coupling = np.zeros((n, b, b)), np.zeros((n - 1, b, b))
        band = self._banded.reshape(2 * b, n, b)
        for j in range(b):
            diagonal[:, j:, j] = band[: b - j, :, j].T
            coupling[:, :, j] = band[b - j : 2 * b - j, :-1, j].T
        return diagonal, coupling


def _band(matrix: BlockTridiagonal) -> Array:
    """The matrix without its border in LAPACK's lower band form."""
    n, b, _ = matrix.border.shape
    band = np.zeros((2 * b, n, b))
    for j in range(b):
        band[: b - j, :, j] = matrix.diagonal[:, j:, j].T
        band[b - j : 2 * b - j, :-1, j] = matrix.coupling[:, j, :].T
    return band.reshape(2 * b, n * b)
