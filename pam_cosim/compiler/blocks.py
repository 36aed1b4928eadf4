"""Solve the equations for the unknowns: block triangular form, linear blocks symbolically."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence, Set
from typing import NamedTuple

import casadi as ca
import numpy as np

from pam_cosim.arrays import Array
from pam_cosim.compiler.budget import check_operations
from pam_cosim.compiler.flattening import Residual
from pam_cosim.compiler.matching import Matching
from pam_cosim.compiler.nonlinear import NonlinearLoops
from pam_cosim.errors import ModelError

_LARGEST_BY_MINORS = 4
_LARGEST_BY_PIVOTS = 30  # beyond, a matrix of numbers is inverted
_POINTS = 5  # values of the symbols, at all of which a loop that is singular by itself is singular
_ZERO = 1e-13  # smallest singular value relative to the largest, of a matrix with rows and columns of size one
_PART = 1e-6  # of a unit vector, from which an equation or an unknown takes part


class Loop(NamedTuple):
    """Linear equations that are solved together.

    Attributes:
        matrix: (n, n) the coefficients of the unknowns.
        names: of the unknowns.
        places: of the equations.
    """

    matrix: ca.SX
    names: Sequence[str]
    places: Sequence[str]

    def check(self) -> None:
        """Refuses a matrix that is singular whatever the values of its symbols.

        Raises:
            ModelError: names the equations and the unknowns.
        """
        symbols = [symbol.name() for symbol in ca.symvar(self.matrix)]
        rng = np.random.default_rng(1)
        points = rng.uniform(0.5, 2.0, (_POINTS if symbols else 1, len(symbols)))
        points[1:] *= rng.choice([-1.0, 1.0], points[1:].shape)
        numbers = [
            self._numbers(dict(zip(symbols, point.tolist(), strict=True))) for point in points
        ]
        vectors = [_null_vectors(matrix) for matrix in numbers]
        if all(vectors):
            self._refuse("", vectors[0])

    def check_at(self, values: Mapping[str, float]) -> None:
        """Refuses a matrix that is singular with these values of its symbols.

        Raises:
            ModelError: as ``check``.
        """
        if values.keys() >= {symbol.name() for symbol in ca.symvar(self.matrix)}:
            self._refuse("at the start values ", _null_vectors(self._numbers(values)))

    def _numbers(self, values: Mapping[str, float]) -> Array:
        symbols = ca.symvar(self.matrix)
        given = ca.vertcat(*[values[symbol.name()] for symbol in symbols])
        return np.asarray(ca.Function("loop", [ca.vertcat(*symbols)], [self.matrix])(given))

    def _refuse(self, when: str, vectors: tuple[Array, Array] | None) -> None:
        if vectors is None:
            return
        rows, columns = ([i for i, v in enumerate(vector) if abs(v) > _PART] for vector in vectors)
        raise ModelError(
            f"{when}no equation determines {', '.join(repr(self.names[j]) for j in columns)}: these depend on "
            f"one another, or contradict: {'; '.join(dict.fromkeys(self.places[i] for i in rows))}"
        )


def _null_vectors(matrix: Array) -> tuple[Array, Array] | None:
    """How rows and columns depend on one another; None: the matrix is regular, or is no number."""
    if not np.isfinite(matrix).all():
        return None
    scaled = matrix
    for axis in (1, 0):
        largest = np.abs(scaled).max(axis=axis, keepdims=True)
        scaled = scaled / np.where(largest > 0, largest, 1.0)
    left, sizes, right = np.linalg.svd(scaled)
    return None if sizes[-1] > _ZERO * sizes[0] else (left[:, -1], right[-1])


def solve(
    residuals: Sequence[Residual],
    unknowns: Sequence[str],
    symbols: Mapping[str, ca.SX],
    wanted: Iterable[str] | None = None,
    loops: list[Loop] | None = None,
    nonlinear: NonlinearLoops | None = None,
) -> dict[str, ca.SX]:
    """Every unknown as an expression of states, inputs, parameters and time.

    ``wanted``: names of those that are requested; default all. Only what they depend on is solved for in addition.
    ``loops``: gets the linear loops that are solved.
    ``nonlinear``: solves nonlinear blocks; None: these are errors.

    Raises:
        ModelError: the system is singular, by its structure or its numbers, or a block of it is nonlinear.
    """
    if not unknowns:
        return {}
    expressions = ca.vertcat(*[residual.expression for residual in residuals])
    variables = ca.vertcat(*[symbols[name] for name in unknowns])
    structure = ca.jacobian_sparsity(expressions, variables)
    if len(residuals) != len(unknowns) or ca.sprank(structure) < len(unknowns):
        raise ModelError(_singular(residuals, unknowns, structure))
    blocks = _triangular(structure)
    held = _columns_of_rows(structure)
    if wanted is not None:
        places = {name: j for j, name in enumerate(unknowns)}
        blocks = _needed(blocks, held, [places[name] for name in wanted])
    solved: dict[str, ca.SX] = {}
    for rows, columns in blocks:
        names = [unknowns[j] for j in columns]
        present = [unknowns[j] for j in _columns_in(rows, held)]
        solved_names = [name for name in present if name in solved]
        equations = [residuals[i] for i in rows]
        loop = _solve_block(equations, names, solved_names, symbols, solved, nonlinear)
        if loops is not None and loop is not None:
            loops.append(loop)
    return solved


_Block = tuple[Sequence[int], Sequence[int]]  # rows and columns


def _triangular(structure: ca.Sparsity) -> list[_Block]:
    """The blocks on the diagonal of the block triangular form, each after those on which it depends."""
    count, rows, columns, row_bounds, column_bounds, *_ = structure.btf()
    row_blocks = [rows[row_bounds[b] : row_bounds[b + 1]] for b in range(count)]
    column_blocks = [columns[column_bounds[b] : column_bounds[b + 1]] for b in range(count)]
    return list(zip(row_blocks, column_blocks, strict=True))


def _columns_of_rows(structure: ca.Sparsity) -> list[list[int]]:
    held: list[list[int]] = [[] for _ in range(structure.size1())]
    for row, column in zip(*structure.get_triplet(), strict=True):
        held[row].append(column)
    return held


def _columns_in(rows: Iterable[int], held: Sequence[Sequence[int]]) -> list[int]:
    return sorted({column for row in rows for column in held[row]})


def _needed(
    blocks: Sequence[_Block], held: Sequence[Sequence[int]], wanted: Sequence[int]
) -> list[_Block]:
    """The blocks that determine the wanted columns and all that these depend on, in their order."""
    owner = {column: b for b, (_, columns) in enumerate(blocks) for column in columns}
    waiting, chosen = {owner[j] for j in wanted}, set[int]()
    while waiting:
        block = waiting.pop()
        chosen.add(block)
        needed = {owner[column] for column in _columns_in(blocks[block][0], held)}
        waiting |= needed - chosen
    return [blocks[b] for b in sorted(chosen)]


def _solve_block(
    equations: Sequence[Residual],
    names: Sequence[str],
    solved_names: Sequence[str],
    symbols: Mapping[str, ca.SX],
    solved: dict[str, ca.SX],
    nonlinear: NonlinearLoops | None,
) -> Loop | None:
    """Solve one block for its unknowns; the values of ``solved_names`` from earlier blocks are substituted first.

    Returns:
        The block, if it is linear and has several equations.
    """
    if len(names) == 1 and (side := _other_side(equations[0].expression, names[0])) is not None:
        solved[names[0]] = _put_in(side, solved_names, symbols, solved)
        return None
    system = _column([equation.expression for equation in equations])
    system = _put_in(system, solved_names, symbols, solved)
    variables = _column([symbols[name] for name in names])
    matrix = ca.jacobian(system, variables)
    if not matrix.is_constant() and ca.depends_on(matrix, variables):
        values = None if nonlinear is None else nonlinear.solve(system, variables, names)
        if values is None:
            raise ModelError(_nonlinear(equations, names))
        solved.update(values)
        return None
    if matrix.is_zero():
        raise ModelError(
            f"{names[0]!r} drops out of the equation that should determine it: {equations[0].place}"
        )
    offset = ca.substitute(system, variables, ca.DM.zeros(len(names)))
    if len(names) == 1:
        alone = -offset / matrix
        solved[names[0]] = ca.simplify(alone) if alone.is_constant() else alone
        return None
    loop = Loop(matrix, names, [equation.place for equation in equations])
    loop.check()
    result = _linear(matrix, -offset)
    check_operations(ca.n_nodes(result))
    for i, name in enumerate(names):
        solved[name] = ca.simplify(result[i]) if result[i].is_constant() else result[i]
    return loop


def _other_side(residual: ca.SX, name: str) -> ca.SX | None:
    """What the unknown equals where it stands alone on one side: half of the equations, and those of connections."""
    if not residual.is_op(ca.OP_SUB):
        return None
    left, right = residual.dep(0), residual.dep(1)
    for side, other in ((left, right), (right, left)):
        if side.is_symbolic() and side.name() == name:
            alone = other.is_symbolic() or other.is_constant() or not ca.depends_on(other, side)
            return other if alone else None
    return None


def _put_in(
    expression: ca.SX,
    solved_names: Sequence[str],
    symbols: Mapping[str, ca.SX],
    solved: Mapping[str, ca.SX],
) -> ca.SX:
    """The expression with the values of the unknowns that are known."""
    if not solved_names:
        return expression
    if expression.is_scalar() and expression.is_symbolic():
        return solved.get(expression.name(), expression)
    return ca.substitute(
        expression,
        _column([symbols[n] for n in solved_names]),
        _column([solved[n] for n in solved_names]),
    )


def _column(items: Sequence[ca.SX]) -> ca.SX:
    """Stacked; most blocks have one equation, and nothing to stack."""
    return items[0] if len(items) == 1 else ca.vertcat(*items)


def _linear(matrix: ca.SX, right: ca.SX) -> ca.SX:
    """Solve a small linear system: constant pivots are eliminated, the rest is solved by minors or QR.

    Minors divide by the determinant only, so the result is right wherever the system is regular.
    """
    size = matrix.shape[0]
    if size > _LARGEST_BY_PIVOTS and matrix.is_constant():
        inverse = np.linalg.inv(np.asarray(ca.evalf(matrix)))
        return ca.mtimes(ca.DM(inverse), right)
    a = [[matrix[i, j] for j in range(size)] for i in range(size)]
    b = [right[i] for i in range(size)]
    steps = _eliminate_constant_pivots(a, b)
    used_rows, used_columns = {row for row, _ in steps}, {column for _, column in steps}
    rows = [i for i in range(size) if i not in used_rows]
    columns = [j for j in range(size) if j not in used_columns]
    values = _solve_core(a, b, rows, columns)
    for row, column in reversed(steps):
        values[column] = _less_known(a[row], b[row], values) / a[row][column]
    return ca.vertcat(*[values[j] for j in range(size)])


def _eliminate_constant_pivots(a: list[list[ca.SX]], b: list[ca.SX]) -> list[tuple[int, int]]:
    """The pivots, as rows and columns: solved from the last to the first, they give the unknowns of their columns."""
    steps: list[tuple[int, int]] = []
    while (pivot := _constant_pivot(a, steps)) is not None:
        _eliminate(a, b, pivot, {row for row, _ in steps})
        check_operations(0)
        steps.append(pivot)
    return steps


def _less_known(row: Sequence[ca.SX], right: ca.SX, values: Mapping[int, ca.SX]) -> ca.SX:
    """The right side of a row, less the terms of the unknowns whose values are known."""
    for j, value in values.items():
        if not row[j].is_zero():
            right = right - row[j] * value
    return right


def _eliminate(
    a: list[list[ca.SX]], b: list[ca.SX], pivot: tuple[int, int], done: Set[int]
) -> None:
    """Takes the column of a pivot out of the rows that were no pivots' yet."""
    row, column = pivot
    for i in range(len(a)):
        if i == row or i in done or a[i][column].is_zero():
            continue
        factor = a[i][column] / a[row][column]
        a[i] = [
            x if y.is_zero() else ca.simplify(x - factor * y)
            for x, y in zip(a[i], a[row], strict=True)
        ]
        a[i][column] = ca.SX(0)
        b[i] = b[i] - factor * b[row]


def _solve_core(
    a: Sequence[Sequence[ca.SX]], b: Sequence[ca.SX], rows: Sequence[int], columns: Sequence[int]
) -> dict[int, ca.SX]:
    """Values by column, of rows without constant pivots."""
    if not rows:
        return {}
    core = ca.vertcat(*[ca.horzcat(*[a[i][j] for j in columns]) for i in rows])
    right_side = ca.vertcat(*[b[i] for i in rows])
    small = len(rows) <= _LARGEST_BY_MINORS
    check_operations(len(rows) ** 3)
    answer = ca.mtimes(ca.inv_minor(core), right_side) if small else ca.solve(core, right_side)
    return {j: answer[k] for k, j in enumerate(columns)}


def _constant_pivot(
    a: Sequence[Sequence[ca.SX]], steps: Sequence[tuple[int, int]]
) -> tuple[int, int] | None:
    """A number that is not zero, in a row and column not used yet; in the emptiest row."""
    used_rows, used_columns = {r for r, _ in steps}, {c for _, c in steps}
    best: tuple[int, int, int] | None = None
    for i, row in enumerate(a):
        if i in used_rows:
            continue
        filled = sum(not entry.is_zero() for j, entry in enumerate(row) if j not in used_columns)
        for j, entry in enumerate(row):
            if j in used_columns or not entry.is_constant() or entry.is_zero():
                continue
            if best is None or filled < best[0]:
                best = filled, i, j
            break
    return None if best is None else (best[1], best[2])


def _nonlinear(equations: Sequence[Residual], names: Sequence[str]) -> str:
    return (
        f"a nonlinear algebraic loop for {', '.join(repr(name) for name in names)} in "
        + "; ".join(equation.place for equation in equations)
        + ". Break it with a state, for example a small volume, mass or lag"
    )


def _singular(
    residuals: Sequence[Residual], unknowns: Sequence[str], structure: ca.Sparsity
) -> str:
    """Name what the maximum matching leaves over."""
    matched: Matching[str] = Matching()
    rows: list[list[str]] = [[] for _ in residuals]
    for row, column in zip(*structure.get_triplet(), strict=True):
        rows[row].append(unknowns[column])
    extra = [
        residual.place
        for i, residual in enumerate(residuals)
        if not matched.add(i, rows.__getitem__)
    ]
    free = [name for name in unknowns if name not in matched]
    return (
        f"the model has {len(residuals)} equations for {len(unknowns)} unknowns; "
        f"no equation determines {', '.join(map(repr, free)) or 'nothing more'}; "
        f"superfluous: {'; '.join(extra) or 'no equation'}"
    )
