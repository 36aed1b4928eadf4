/* The model's functions at the present time. */
#include "pam_instance.h"

void pam_forget(pam_instance *c) { c->dx_known = c->y_known = c->w_known = 0; }

/* Whether a delayed input is the present input: before the run, and where the delay is zero. */
static int is_present(const pam_instance *c, int i) {
    const pam_history *h = &c->solver.past[i];
    return h->first == h->end || c->solver.delay[i] == 0.0;
}

static void find_delayed(pam_instance *c) {
    const pam_model *m = c->model;
    for (int i = 0; i < m->nd; i++) {
        int input = m->delayed_inputs[i];
        if (is_present(c, i) && input >= 0) {
            c->d[i] = c->u[input];
            c->dd[i] = c->du[input];
            continue;
        }
        c->d[i] = c->dd[i] = 0.0;
        if (c->solver.past[i].first == c->solver.past[i].end) continue;
        const pam_segment *now = pam_history_at(&c->solver.past[i], c->solver.delay[i], c->core.time, NULL);
        c->d[i] = pam_segment_value(now, c->solver.delay[i], c->core.time);
        c->dd[i] = now->slope;
    }
}

static void evaluate(pam_instance *c, pam_function f, double *to) {
    pam_initialise_states(c);
    find_delayed(c);
    const double *arg[] = {&c->core.time, c->x, c->u, c->d, c->solver.p};
    double *res[] = {to};
    f(arg, res, c->solver.iw, c->solver.w, 0);
}

const double *pam_derivatives(pam_instance *c) {
    const pam_model *m = c->model;
    if (!c->dx_known) {
        evaluate(c, m->rhs ? m->rhs : m->core_rhs, c->dx);
        if (!m->rhs) pam_solver_no_numbers(m, c->dx);
    }
    c->dx_known = 1;
    return c->dx;
}

const double *pam_outputs(pam_instance *c) {
    if (!c->y_known) evaluate(c, c->model->out, c->y);
    c->y_known = 1;
    return c->y;
}

const double *pam_locals(pam_instance *c) {
    if (!c->w_known) evaluate(c, c->model->loc, c->w);
    c->w_known = 1;
    return c->w;
}

void pam_check_statements(pam_instance *c) {
    pam_initialise_states(c);
    find_delayed(c);
    const double *arg[] = {&c->core.time, c->x, c->u, c->d, c->solver.p};
    double *res[] = {c->checks, c->checks + c->model->na};
    c->model->check(arg, res, c->solver.iw, c->solver.w, 0);
}

/* d(t) = u(t - T): the present input does not count, time and the delay do. */
static void seed_delayed(pam_instance *c, double st, const double *su, const double *sp) {
    const pam_model *m = c->model;
    const double *arg[] = {c->solver.p, sp};
    double *res[] = {NULL, c->rate_d};
    if (m->nd) m->delay(arg, res, c->solver.iw, c->solver.w, 0);
    for (int i = 0; i < m->nd; i++) {
        int input = m->delayed_inputs[i];
        c->seed_d[i] = is_present(c, i) && input >= 0 ? su[input] : c->dd[i] * (st - c->rate_d[i]);
    }
}

static void derive_along(pam_instance *c, pam_function jvp) {
    const pam_model *m = c->model;
    const double *sx = c->seed, *su = sx + m->nx, *sp = su + m->nu, *st = sp + m->np;
    double *rx = c->result, *ry = rx + m->nx, *rw = ry + m->ny;
    find_delayed(c);
    seed_delayed(c, st[0], su, sp);
    const double *arg[] = {&c->core.time, c->x, c->u, c->d, c->solver.p, st, sx, su, c->seed_d, sp};
    double *res[] = {rx, ry, rw};
    jvp(arg, res, c->solver.iw, c->solver.w, 0);
}

void pam_directional(pam_instance *c) {
    pam_initialise_states(c);
    if (c->core.phase == INITIALIZATION) pam_seed_states(c, derive_along);
    derive_along(c, c->model->jvp);
}
