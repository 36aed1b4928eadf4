"""The block tridiagonal matrix against dense linear algebra."""

from __future__ import annotations

import numpy as np
import pytest

from pam_cosim.ledger.block_tridiagonal import BlockTridiagonal, CholeskyFactor

N, B, Q = 7, 3, 2


def _matrix(q: int) -> tuple[BlockTridiagonal, np.ndarray]:
    rng = np.random.default_rng(3)
    coupling = rng.standard_normal((N - 1, B, B))
    border, half = rng.standard_normal((N, B, q)), rng.standard_normal((N, B, B))
    diagonal = half @ half.transpose(0, 2, 1) + 12 * np.eye(B)
    corner = 60 * np.eye(q)
    dense = np.zeros((N * B + q, N * B + q))
    for k in range(N):
        at = slice(k * B, k * B + B)
        dense[at, at] = diagonal[k]
        dense[at, N * B :] = border[k]
        if k < N - 1:
            dense[at, (k + 1) * B : (k + 2) * B] = coupling[k]
    dense = np.triu(dense, 1) + np.triu(dense, 1).T + np.diag(np.diag(dense))
    dense[N * B :, N * B :] = corner
    for k in range(N):
        dense[k * B : k * B + B, k * B : k * B + B] = diagonal[k]
    return BlockTridiagonal(diagonal, coupling, border, corner), dense


@pytest.mark.parametrize("q", [0, Q])
def test_solution_determinant_and_covariances(q: int) -> None:
    matrix, dense = _matrix(q)
    assert np.linalg.eigvalsh(dense)[0] > 0
    factor = CholeskyFactor(matrix)
    right = np.random.default_rng(4).standard_normal(N * B + q)
    inner, outer = factor.solve(right[: N * B].reshape(N, B), right[N * B :])
    assert np.concatenate([inner.ravel(), outer]) == pytest.approx(np.linalg.solve(dense, right))
    assert factor.log_determinant == pytest.approx(np.linalg.slogdet(dense)[1])
    blocks, corner = factor.covariances()
    inverse = np.linalg.inv(dense)
    for k in range(N):
        assert blocks[k] == pytest.approx(inverse[k * B : k * B + B, k * B : k * B + B])
    assert corner == pytest.approx(inverse[N * B :, N * B :])
