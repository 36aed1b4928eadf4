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

/* S at a node of the pending step, which is found block by block. */
static double *at_node(const pam_solver *v, int q) {
    return q < PAM_NODES - 1 ? v->sensitivity.nodes + q * v->model->nc * v->model->ns : v->x1 + v->model->nc;
}

/* Some states, of which every one may act on every other, and those that act on them. */
typedef struct {
    const int *states, *before;
    int count, before_count;
} block;

/* Adds to F what the states before do to a block at the nodes: J S. */
static void add_states_before(const pam_solver *v, const block *b) {
    int n = v->model->nc, m = v->model->ns;
    for (int q = 0; q < PAM_NODES; q++) {
        const double *jac = v->sensitivity.jac + q * n * n, *nodes = at_node(v, q);
        double *forcing = v->sensitivity.forcing + q * n * m;
        for (int k = 0; k < b->count; k++)
            for (int l = 0; l < b->before_count; l++) {
                double slope = jac[b->states[k] + b->before[l] * n];
                if (slope == 0.0) continue;
                for (int c = 0; c < m; c++) forcing[b->states[k] * m + c] += slope * nodes[b->before[l] * m + c];
            }
    }
}

/* S_i - h sum_j a_ij J_j S_j = S_0 + h sum_j a_ij F_j for the values S_i of a block at the nodes. */
static void assemble(const pam_solver *v, const block *b) {
    const pam_sensitivity *s = &v->sensitivity;
    int n = v->model->nc, m = v->model->ns, size = n * m, count = b->count, rows = PAM_NODES * count;
    for (int i = 0; i < PAM_NODES; i++) {
        double a[PAM_NODES];
        for (int j = 0; j < PAM_NODES; j++) a[j] = v->s->h * A[i][j];
        for (int k = 0; k < count; k++) {
            const double *f = s->forcing + b->states[k] * m, *start = v->x + n + b->states[k] * m;
            double *rhs = s->rhs + (i * count + k) * m;
            for (int c = 0; c < m; c++)
                rhs[c] = start[c] + a[0] * f[c] + a[1] * f[size + c] + a[2] * f[2 * size + c];
        }
        for (int j = 0; j < PAM_NODES; j++)
            for (int l = 0; l < count; l++)
                for (int k = 0; k < count; k++)
                    s->matrix[i * count + k + (j * count + l) * rows] =
                        (i == j && k == l ? 1.0 : 0.0) - a[j] * s->jac[j * n * n + b->states[k] + b->states[l] * n];
    }
}

/* 1: the matrix is singular. */
static int solve(const pam_solver *v, const block *b) {
    const pam_sensitivity *s = &v->sensitivity;
    int m = v->model->ns, rows = PAM_NODES * b->count;
    add_states_before(v, b);
    assemble(v, b);
    if (lu_factorise(rows, s->matrix, s->pivot)) return 1;
    lu_solve_many(rows, s->matrix, s->pivot, m, s->rhs);
    for (int q = 0; q < PAM_NODES; q++)
        for (int k = 0; k < b->count; k++)
            memcpy(at_node(v, q) + b->states[k] * m, s->rhs + (q * b->count + k) * m, sizeof(double) * (size_t)m);
    return 0;
}

int pam_sensitivity_step(pam_solver *v) {
    const pam_model *m = v->model;
    linearise(v);
    for (int i = 0, begin = 0; i < m->nb; begin = m->block_ends[i++]) {
        block b = {m->block_states + begin, m->block_states, m->block_ends[i] - begin, begin};
        if (!solve(v, &b)) continue;
        snprintf(v->message, sizeof v->message, "the sensitivities cannot be solved for at time %.9g s (step %.3g s)",
                 v->s->t, v->s->h);
        return 1;
    }
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
