"""Small systems of linear equations, solved inside other kernels: without a library, whose last bits depend on the
processor, and whose calls take longer than the sums.
"""

from __future__ import annotations

from numba import njit

from roam_core.arrays import Array


@njit(nogil=True, cache=True, error_model="numpy")
def solve_positive(matrix: Array, right: Array) -> None:
    """Solve `matrix (n, n) x = right (n, m)` in place: `right` becomes x, and `matrix` is overwritten.

    The matrix must be symmetric and positive definite, of which only the lower triangle is read; else x is infinite or
    not a number. By L D L' (Golub and Van Loan, "Matrix Computations", 4th edition, 4.1.2).
    """
    n, m = right.shape
    for j in range(n):
        for k in range(j):
            scaled = matrix[j, k] * matrix[k, k]
            for i in range(j, n):
                matrix[i, j] -= matrix[i, k] * scaled
        for i in range(j + 1, n):
            matrix[i, j] /= matrix[j, j]
        for c in range(m):
            for k in range(j):
                right[j, c] -= matrix[j, k] * right[k, c]
    for j in range(n - 1, -1, -1):
        for c in range(m):
            right[j, c] /= matrix[j, j]
            for i in range(j + 1, n):
                right[j, c] -= matrix[i, j] * right[i, c]
