/* Dense LU factors with partial pivoting for the few states of a model; matrices are column-major. */
#ifndef PAM_LU_H
#define PAM_LU_H

#include <math.h>

/* Factorises a in place. Returns 0, or 1 where the matrix is singular or not finite. */
static inline int lu_factorise(int n, double *a, int *pivot) {
    for (int k = 0; k < n; k++) {
        int best = k;
        for (int i = k + 1; i < n; i++)
            if (fabs(a[i + k * n]) > fabs(a[best + k * n])) best = i;
        pivot[k] = best;
        if (!(fabs(a[best + k * n]) > 0.0) || !isfinite(a[best + k * n])) return 1;
        if (best != k)
            for (int j = 0; j < n; j++) {
                double swap = a[k + j * n];
                a[k + j * n] = a[best + j * n];
                a[best + j * n] = swap;
            }
        double inverse = 1.0 / a[k + k * n];
        a[k + k * n] = inverse;
        for (int i = k + 1; i < n; i++) a[i + k * n] *= inverse;
        for (int j = k + 1; j < n; j++) {
            double factor = a[k + j * n];
            if (factor == 0.0) continue; /* many are: few states act on few others */
            for (int i = k + 1; i < n; i++) a[i + j * n] -= a[i + k * n] * factor;
        }
    }
    return 0;
}

/* Solves with the factors of lu_factorise; b becomes the solution. The diagonal is stored inverted. */
static inline void lu_solve(int n, const double *a, const int *pivot, double *b) {
    for (int k = 0; k < n; k++) {
        double swap = b[k];
        b[k] = b[pivot[k]];
        b[pivot[k]] = swap;
    }
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n; i++) b[i] -= a[i + k * n] * b[k];
    for (int k = n - 1; k >= 0; k--) {
        b[k] *= a[k + k * n];
        for (int i = 0; i < k; i++) b[i] -= a[i + k * n] * b[k];
    }
}

/* The same for m right-hand sides at once; b is n x m, row by row. */
static inline void lu_solve_many(int n, const double *a, const int *pivot, int m, double *b) {
    for (int k = 0; k < n; k++) {
        double *x = b + k * m, *y = b + pivot[k] * m;
        for (int c = 0; c < m && x != y; c++) {
            double swap = x[c];
            x[c] = y[c];
            y[c] = swap;
        }
    }
    for (int k = 0; k < n; k++)
        for (int i = k + 1; i < n; i++) {
            double factor = a[i + k * n];
            if (factor == 0.0) continue;
            for (int c = 0; c < m; c++) b[i * m + c] -= factor * b[k * m + c];
        }
    for (int k = n - 1; k >= 0; k--) {
        for (int c = 0; c < m; c++) b[k * m + c] *= a[k + k * n];
        for (int i = 0; i < k; i++) {
            double factor = a[i + k * n];
            if (factor == 0.0) continue;
            for (int c = 0; c < m; c++) b[i * m + c] -= factor * b[k * m + c];
        }
    }
}

#endif
