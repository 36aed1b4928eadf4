#include "pam_instance.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

fmi2Status pam_log(pam_instance *c, fmi2Status status, const char *format, ...) {
    char message[1024];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    if (c->callbacks.logger)
        c->callbacks.logger(c->callbacks.componentEnvironment, c->name, status,
                            status == fmi2Warning ? "logStatusWarning" : "logStatusError", "%s", message);
    return status;
}

pam_instance *pam_check(fmi2Component component, int phases, const char *function) {
    pam_instance *c = component;
    if (!c) return NULL;
    if (c->core.phase & phases) return c;
    const char *now = c->core.phase == INSTANTIATED     ? "before initialization"
                      : c->core.phase == INITIALIZATION ? "in initialization mode"
                      : c->core.phase == TERMINATED     ? "after fmi2Terminate"
                      : c->core.phase == FAILED         ? "after an error"
                                                        : "in this mode";
    pam_log(c, fmi2Error, "%s must not be called %s", function, now);
    return NULL;
}

int pam_lookup(pam_instance *c, fmi2ValueReference vr, pam_kind *kind, int *index) {
    const pam_model *m = c->model;
    const int sizes[] = {m->nx, m->nx, m->nu, m->ny, m->np, m->nw, 1};
    fmi2ValueReference rest = vr;
    for (int k = STATE; k <= TIME; k++) {
        if (rest < (fmi2ValueReference)sizes[k]) {
            *kind = (pam_kind)k;
            *index = (int)rest;
            return 1;
        }
        rest -= (fmi2ValueReference)sizes[k];
    }
    pam_log(c, fmi2Error, "there is no variable with value reference %u", vr);
    return 0;
}

void pam_forget(pam_instance *c) { c->dx_known = c->y_known = c->w_known = 0; }

void pam_reset(pam_instance *c) {
    const pam_model *m = c->model;
    memset(&c->core, 0, sizeof c->core);
    memset(c->saved, 0, c->saved_size * sizeof *c->saved);
    c->core.phase = INSTANTIATED;
    c->core.tolerance = m->tolerance;
    c->core.last_step = fmi2OK;
    for (int i = 0; i < m->nu; i++) c->u[i] = m->input_starts[i];
    for (int i = 0; i < m->np; i++) c->solver.p[i] = m->parameter_starts[i];
    pam_forget(c);
}

void pam_initialise_states(pam_instance *c) {
    const pam_model *m = c->model;
    if (c->core.initial_known || !(c->core.phase & (INSTANTIATED | INITIALIZATION))) return;
    const double *arg[] = {c->solver.p};
    double *res[] = {c->result};
    m->init(arg, res, c->solver.iw, c->solver.w, 0);
    for (int i = 0; i < m->nx; i++)
        if (c->x_explicit[i] == 0.0) c->x[i] = c->result[i];
    c->core.initial_known = 1;
}

static void evaluate(pam_instance *c, pam_function f, double *to) {
    pam_initialise_states(c);
    const double *arg[] = {&c->core.time, c->x, c->u, c->solver.p};
    double *res[] = {to};
    f(arg, res, c->solver.iw, c->solver.w, 0);
}

const double *pam_derivatives(pam_instance *c) {
    if (!c->dx_known) evaluate(c, c->model->rhs, c->dx);
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

void pam_directional(pam_instance *c) {
    const pam_model *m = c->model;
    double *sx = c->seed, *su = sx + m->nx, *sp = su + m->nu, *st = sp + m->np;
    double *rx = c->result, *ry = rx + m->nx, *rw = ry + m->ny, *start = rw + m->nw;
    pam_initialise_states(c);
    if (c->core.phase == INITIALIZATION) {
        const double *arg[] = {c->solver.p, sp};
        double *res[] = {start};
        m->init_jvp(arg, res, c->solver.iw, c->solver.w, 0);
        for (int i = 0; i < m->nx; i++)
            if (c->x_explicit[i] == 0.0) sx[i] += start[i];
    }
    const double *arg[] = {&c->core.time, c->x, c->u, c->solver.p, st, sx, su, sp};
    double *res[] = {rx, ry, rw};
    m->jvp(arg, res, c->solver.iw, c->solver.w, 0);
}
