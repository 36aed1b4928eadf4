/* Equilibria by pseudo-transient continuation: steps of the linearly implicit Euler method that grow until they are
 * Newton's (Kelley and Keyes, SIAM J. Numer. Anal. 35, 1998). From the start values they go where the model would go
 * in time, so that an equilibrium that is found is as a rule a stable one, but nothing has to be waited for.
 */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "pam_lu.h"
#include "pam_solver.h"

enum { MOST_STEPS = 400 };
static const double FIRST = 1e-4, LAST = 1e9, LEAST = 1e-14; /* [s] steps */
static const double NEAREST = 1e-9;     /* [s] steps that are not made shorter because they lead far */
static const double WAIT = 1e5;         /* [s] of a step: what it hardly moves nobody would see move */
static const double UNSEEN = 1e-6;      /* part of a state's size that it moves in such a step, at most */
static const double STILL = 1e-11;      /* part of a state's size by which Newton's last step may change it */
static const double CONTRACTION = 0.5;  /* of a correction by the next one, at most (Deuflhard 2004, 2.1) */
static const double FAR = 1.0;          /* part of its size by which a state may change in one step, at most */
static const double QUICK = 0.05, GROW = 100.0, GROW_SLOWLY = 4.0, SHRINK = 0.1;

static int is_held(const pam_solver *v, int i) { return v->held && v->held[i] != 0.0; }

/* Rows of a matrix nc x nc that are of states which are held: nothing but the diagonal. */
static void hold(const pam_solver *v, double *matrix, double diagonal) {
    int n = v->model->nc;
    for (int i = 0; i < n; i++)
        for (int k = 0; k < n && is_held(v, i); k++) matrix[i + k * n] = i == k ? diagonal : 0.0;
}

/* f and df/dx at v->x, without those of states that are held; 0 where they are finite. */
static int look(pam_solver *v) {
    const pam_model *m = v->model;
    const double *arg[] = {&v->s->t, v->x, v->u, v->d, v->du, v->dd, v->p};
    double *res[] = {v->f, v->jac, v->ft};
    pam_function lin = v->starting && m->start_lin ? m->start_lin : m->lin;
    lin(arg, res, v->iw, v->w, 0);
    v->s->statistics.rhs++;
    v->s->statistics.jacobians++;
    for (int i = 0; i < m->nc; i++)
        if (!isfinite(v->f[i])) return 1;
    for (int i = 0; i < m->nc * m->nc; i++)
        if (!isfinite(v->jac[i])) return 1;
    hold(v, v->jac, 0.0);
    for (int i = 0; i < m->nc; i++)
        if (is_held(v, i)) v->f[i] = 0.0;
    return 0;
}

static int factorise(pam_solver *v, double h) {
    int n = v->model->nc;
    for (int i = 0; i < n * n; i++) v->lu[i] = -v->jac[i];
    for (int i = 0; i < n; i++) v->lu[i + i * n] += 1.0 / h;
    return lu_factorise(n, v->lu, v->pivot);
}

/* The largest change by the size of its state; which state it is. */
static double measure(const pam_solver *v, const double *change, int *worst) {
    double most = 0.0;
    for (int i = 0; i < v->model->nc; i++) {
        double part = fabs(change[i]) / (fabs(v->x[i]) + v->scale[i]);
        if (!(part <= most)) {
            most = part;
            *worst = i;
        }
    }
    return most;
}

static int fail(pam_solver *v, int worst) {
    snprintf(v->message, sizeof v->message, "no equilibrium was found: '%s', which is %.9g, still changes by %.3g per second",
             v->model->state_names[worst], v->x[worst], v->f[worst]);
    return 1;
}

/* dx/ds at the equilibrium: J S + F = 0. A state that is at rest anywhere has no slope, but for what moves it in ``h``;
 * one that is held has the slope with which it begins.
 */
static int slopes(pam_solver *v, double h) {
    const pam_model *m = v->model;
    pam_sensitivity *s = &v->sensitivity;
    const double *arg[] = {&v->s->t, v->x, v->u, v->d, v->p};
    double *res[] = {s->jac, s->forcing};
    pam_function variation = v->starting && m->start_variation ? m->start_variation : m->variation;
    variation(arg, res, v->iw, v->w, 0);
    memcpy(v->jac, s->jac, sizeof(double) * (size_t)(m->nc * m->nc));
    hold(v, v->jac, 1.0 / h - 1.0); /* makes the diagonal 1 */
    for (int i = 0; i < m->nc; i++)
        if (is_held(v, i))
            memcpy(s->forcing + i * m->ns, v->x + m->nc + i * m->ns, sizeof(double) * (size_t)m->ns);
    if (factorise(v, h)) {
        snprintf(v->message, sizeof v->message, "the sensitivities of the equilibrium cannot be solved for");
        return 1;
    }
    lu_solve_many(m->nc, v->lu, v->pivot, m->ns, s->forcing);
    memcpy(v->x + m->nc, s->forcing, sizeof(double) * (size_t)(m->nc * m->ns));
    return 0;
}

/* Where nothing pulls a state back, as an end of a slack muscle under no load, Newton's steps never end: it is at rest
 * where a long step first hardly moved it. */
static int come_to_rest(pam_solver *v, int rested, const double *there, int worst) {
    if (!rested) return fail(v, worst);
    memcpy(v->x, there, sizeof(double) * (size_t)v->model->nc);
    if (look(v)) return fail(v, worst);
    return v->model->ns && !v->s->plain ? slopes(v, WAIT) : 0;
}

/* Every delayed input has arrived by then. */
static void let_delays_pass(pam_solver *v) {
    double longest = 0.0;
    for (int i = 0; i < v->model->nd; i++) longest = fmax(longest, v->delay[i]);
    v->s->t += 2.0 * longest;
    if (v->model->nd) pam_solver_delayed_values(v, v->s->t, v->d, v->dd);
}

static int settle(pam_solver *v) {
    int n = v->model->nc, worst = 0, rested = 0;
    double h = FIRST, *step = v->k, *next = v->k + n, *before = v->k + 2 * n, *there = v->k + 3 * n;
    v->s->h = 0.0;
    v->s->estimate = 1;
    if (!n) return 0;
    if (look(v)) return fail(v, 0);
    for (int count = 0; count < MOST_STEPS && h > LEAST; count++) {
        if (factorise(v, h)) {
            h *= SHRINK;
            continue;
        }
        memcpy(step, v->f, sizeof(double) * (size_t)n);
        lu_solve(n, v->lu, v->pivot, step);
        double moved = measure(v, step, &worst);
        if (moved <= STILL && h >= LAST) return v->model->ns && !v->s->plain ? slopes(v, LAST) : 0;
        if (!rested && h >= WAIT && moved <= UNSEEN) {
            memcpy(there, v->x, sizeof(double) * (size_t)n);
            rested = 1;
        }
        if (!(moved <= FAR) && h > NEAREST) {
            h *= SHRINK;
            continue;
        }
        memcpy(before, v->x, sizeof(double) * (size_t)n);
        for (int i = 0; i < n; i++) v->x[i] += step[i];
        double contraction = INFINITY;
        if (isfinite(moved) && !look(v)) {
            for (int i = 0; i < n; i++) next[i] = v->f[i] - step[i] / h;
            lu_solve(n, v->lu, v->pivot, next);
            double left = measure(v, next, &worst);
            contraction = left <= STILL ? 0.0 : left / moved;
        }
        if (contraction <= CONTRACTION) {
            h = fmin(h * (contraction <= QUICK ? GROW : GROW_SLOWLY), LAST);
        } else {
            memcpy(v->x, before, sizeof(double) * (size_t)n);
            h *= SHRINK;
            if (look(v)) return fail(v, worst);
        }
    }
    return come_to_rest(v, rested, there, worst);
}

int pam_solver_settle(pam_solver *v) {
    v->held = NULL;
    let_delays_pass(v);
    return settle(v);
}

int pam_solver_settle_start(pam_solver *v, const double *held) {
    if (v->model->nd) pam_solver_delayed_values(v, v->s->t, v->d, v->dd);
    v->held = held;
    return settle(v);
}

void pam_solver_rest_along(pam_solver *v, const double *held, double *along) {
    v->held = held;
    for (int i = 0; i < v->model->nc; i++)
        if (is_held(v, i)) along[i] = 0.0;
    if (look(v) || factorise(v, LAST)) {
        for (int i = 0; i < v->model->nc; i++) along[i] = NAN;
        return;
    }
    lu_solve(v->model->nc, v->lu, v->pivot, along);
}
