#include "pam_sensitivity.h"

#include <stdio.h>
#include <string.h>

#include "pam_lu.h"
#include "pam_solver.h"

/* Nodes and coefficients of Radau IIA with three stages; sqrt(6) = 2.449... */
#define ROOT6 2.4494897427831780982
static const double NODE[PAM_NODES] = {(4.0 - ROOT6) / 10.0, (4.0 + ROOT6) / 10.0, 1.0};
static const double A[PAM_NODES][PAM_NODES] = {
    {(88.0 - 7.0 * ROOT6) / 360.0, (296.0 - 169.0 * ROOT6) / 1800.0, (-2.0 + 3.0 * ROOT6) / 225.0},
    {(296.0 + 169.0 * ROOT6) / 1800.0, (88.0 + 7.0 * ROOT6) / 360.0, (-2.0 - 3.0 * ROOT6) / 225.0},
    {(16.0 - ROOT6) / 36.0, (16.0 + ROOT6) / 36.0, 1.0 / 9.0},
};

size_t pam_sensitivity_saved_size(const pam_model *m) { return (size_t)(2 * m->nc * m->ns); }

size_t pam_sensitivity_scratch_size(const pam_model *m) {
    if (!m->ns) return 0;
    int n = m->nc;
    return (size_t)(PAM_NODES * (n * n + 2 * n * m->ns) + PAM_NODES * PAM_NODES * n * n);
}

void pam_sensitivity_bind(pam_sensitivity *s, const pam_model *m, double *saved, double *scratch, int *pivot) {
    int n = m->nc;
    s->nodes = saved;
    s->jac = scratch;
    s->forcing = s->jac + PAM_NODES * n * n;
    s->rhs = s->forcing + PAM_NODES * n * m->ns;
    s->matrix = s->rhs + PAM_NODES * n * m->ns;
    s->pivot = pivot;
}

/* J and F at the nodes of the pending step. */
static void linearise(pam_solver *v) {
    const pam_model *m = v->model;
    pam_sensitivity *s = &v->sensitivity;
    for (int q = 0; q < PAM_NODES; q++) {
        double t = v->s->t + NODE[q] * v->s->h;
        pam_solver_core_state(v, t, v->stage);
        pam_solver_input_values(v, t, v->u_stage);
        for (int i = 0; i < m->nd; i++) v->d_stage[i] = v->d[i] + v->dd[i] * (t - v->s->t);
        const double *arg[] = {&t, v->stage, v->u_stage, v->d_stage, v->p};
        double *res[] = {s->jac + q * m->nc * m->nc, s->forcing + q * m->nc * m->ns};
        m->variation(arg, res, v->iw, v->w, 0);
    }
}

/* S_i - h sum_j a_ij J_j S_j = S_0 + h sum_j a_ij F_j for the values S_i at the nodes. */
static void assemble(const pam_solver *v) {
    const pam_sensitivity *s = &v->sensitivity;
    int n = v->model->nc, size = n * v->model->ns, rows = PAM_NODES * n;
    for (int i = 0; i < PAM_NODES; i++) {
        double a[PAM_NODES];
        for (int j = 0; j < PAM_NODES; j++) a[j] = v->s->h * A[i][j];
        const double *f = s->forcing;
        for (int e = 0; e < size; e++)
            s->rhs[i * size + e] = v->x[n + e] + a[0] * f[e] + a[1] * f[size + e] + a[2] * f[2 * size + e];
        for (int j = 0; j < PAM_NODES; j++)
            for (int c = 0; c < n; c++)
                for (int r = 0; r < n; r++)
                    s->matrix[i * n + r + (j * n + c) * rows] =
                        (i == j && r == c ? 1.0 : 0.0) - a[j] * s->jac[j * n * n + r + c * n];
    }
}

int pam_sensitivity_step(pam_solver *v) {
    const pam_sensitivity *s = &v->sensitivity;
    int n = v->model->nc, size = n * v->model->ns;
    linearise(v);
    assemble(v);
    if (lu_factorise(PAM_NODES * n, s->matrix, s->pivot)) {
        snprintf(v->message, sizeof v->message, "the sensitivities cannot be solved for at time %.9g s (step %.3g s)",
                 v->s->t, v->s->h);
        return 1;
    }
    lu_solve_many(PAM_NODES * n, s->matrix, s->pivot, v->model->ns, s->rhs);
    memcpy(s->nodes, s->rhs, sizeof(double) * (size_t)(2 * size));
    memcpy(v->x1 + n, s->rhs + 2 * size, sizeof(double) * (size_t)size);
    return 0;
}

void pam_sensitivity_state(const pam_solver *v, double t, double *sensitivities) {
    int n = v->model->nc, size = n * v->model->ns;
    const double *start = v->x + n, *first = v->sensitivity.nodes, *second = first + size, *end = v->x1 + n;
    double s = v->s->h > 0.0 ? (t - v->s->t) / v->s->h : 0.0;
    if (s <= 0.0 || s >= 1.0) {
        memcpy(sensitivities, s <= 0.0 ? start : end, sizeof(double) * (size_t)size);
        return;
    }
    double weight[PAM_NODES + 1];
    const double node[PAM_NODES + 1] = {0.0, NODE[0], NODE[1], NODE[2]};
    for (int i = 0; i <= PAM_NODES; i++) {
        weight[i] = 1.0;
        for (int j = 0; j <= PAM_NODES; j++)
            if (j != i) weight[i] *= (s - node[j]) / (node[i] - node[j]);
    }
    for (int e = 0; e < size; e++)
        sensitivities[e] = weight[0] * start[e] + weight[1] * first[e] + weight[2] * second[e] + weight[3] * end[e];
}
