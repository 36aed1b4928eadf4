/* Where the model begins: its start values, those that were set, and rest. */
#include <string.h>

#include "pam_instance.h"

/* Marks the states that do not begin at rest; whether there are others. */
static int mark_held(pam_instance *c) {
    int some = 0;
    for (int i = 0; i < c->model->nc; i++) {
        int rests = c->model->resting[i], kept = c->core.keep_starts || rests == 2;
        rests = rests && !(kept && c->x_explicit[i] != 0.0);
        c->held[i] = rests ? 0.0 : 1.0;
        some |= rests;
    }
    return some;
}

/* From x, which is where the rest is sought from, and the present inputs. */
static void settle(pam_instance *c) {
    const pam_model *m = c->model;
    pam_solver *v = &c->solver;
    memcpy(v->x, c->x, sizeof(double) * (size_t)m->nx);
    c->core.unsettled = pam_solver_begin(v, c->core.time, c->u, c->du, c->core.tolerance);
    if (c->core.plain) pam_solver_leave_sensitivities(v);
    v->starting = 1;
    if (!c->core.unsettled) c->core.unsettled = pam_solver_settle_start(v, c->held);
    v->starting = 0;
    if (!c->core.unsettled) memcpy(c->x, v->x, sizeof(double) * (size_t)(c->core.plain ? m->nc : m->nx));
    for (int i = 0; i < m->nd; i++) v->past[i].first = v->past[i].end = 0; /* the run has not begun */
}

void pam_initialise_states(pam_instance *c) {
    const pam_model *m = c->model;
    if (c->core.initial_known || !(c->core.phase & (INSTANTIATED | INITIALIZATION))) return;
    const double *arg[] = {c->solver.p, c->u};
    double *res[] = {c->result};
    m->init(arg, res, c->solver.iw, c->solver.w, 0);
    for (int i = 0; i < m->nx; i++) c->x[i] = c->x_explicit[i] == 0.0 ? c->result[i] : c->x_given[i];
    /* A start value that was set depends on nothing but itself. */
    for (int i = 0; i < m->nc; i++)
        for (int k = 0; k < m->ns && c->x_explicit[i] != 0.0; k++)
            c->x[m->nc + i * m->ns + k] = m->start_of[k] == i ? 1.0 : 0.0;
    c->core.initial_known = 1;
    c->core.unsettled = 0;
    if (c->core.phase == INITIALIZATION && mark_held(c)) settle(c);
}

void pam_seed_states(pam_instance *c, void (*along)(pam_instance *c, pam_function jvp)) {
    const pam_model *m = c->model;
    double *sx = c->seed, *start = c->result + m->nx + m->ny + m->nw;
    const double *su = sx + m->nx, *sp = su + m->nu;
    const double *arg[] = {c->solver.p, c->u, sp, su};
    double *res[] = {start};
    m->init_jvp(arg, res, c->solver.iw, c->solver.w, 0);
    for (int i = 0; i < m->nx; i++)
        if (c->x_explicit[i] == 0.0) sx[i] += start[i];
    if (!mark_held(c)) return;
    for (int i = 0; i < m->nc; i++)
        if (c->held[i] == 0.0) sx[i] = 0.0;
    along(c, m->start_jvp ? m->start_jvp : m->jvp);
    c->solver.starting = 1;
    pam_solver_rest_along(&c->solver, c->held, c->result);
    c->solver.starting = 0;
    for (int i = 0; i < m->nc; i++)
        if (c->held[i] == 0.0) sx[i] = c->result[i];
}

pam_status pam_rest_known(const pam_instance *c, pam_status status) {
    if (!c->core.unsettled) return PAM_OK;
    return pam_log(c, status, "the model does not begin at rest, as it shall: %s", c->solver.message);
}

/* Beside FMI, before initialization ends: whether states whose start values are set begin there, at rest or not. Where
 * nobody says so such a value is where their rest is sought from, FMI's initial="approx".
 */
PAM_EXPORT void pam_keep_starts(void *instance, int on) {
    pam_instance *c = instance;
    c->core.keep_starts = on;
    c->core.initial_known = 0;
}
