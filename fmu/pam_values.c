/* Values and partial derivatives of the variables, by value reference. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "pam_instance.h"

pam_status pam_get(pam_instance *c, const unsigned vr[], size_t n, double value[]) {
    if (!pam_arrays(c, "reading variables", n, vr, value)) return PAM_ERROR;
    for (size_t i = 0; i < n; i++) {
        const pam_variable *v = pam_lookup(c, vr[i]);
        if (!v) return PAM_ERROR;
        switch ((pam_kind)v->kind) {
            case STATE: pam_initialise_states(c); value[i] = c->x[v->index]; break;
            case DERIVATIVE: value[i] = pam_derivatives(c)[v->index]; break;
            case INPUT: value[i] = c->u[v->index]; break;
            case OUTPUT: value[i] = pam_outputs(c)[v->index]; break;
            case PARAMETER: value[i] = c->solver.p[v->index]; break;
            case LOCAL: value[i] = pam_locals(c)[v->index]; break;
            case TIME: value[i] = c->core.time; break;
        }
    }
    return c->core.phase == INITIALIZATION ? pam_rest_known(c, PAM_DISCARD) : PAM_OK;
}

static int outside(const pam_variable *v, double value) { return value < v->min || value > v->max; }

/* A value that leaves the range of its variable is used, and the log says so once. */
static void check_range(const pam_instance *c, const pam_variable *v, double value, double before) {
    if (!outside(v, value) || outside(v, before)) return;
    char low[64] = "", high[64] = "";
    if (isfinite(v->min)) snprintf(low, sizeof low, ", at least %.6g %s", v->min, v->unit);
    if (isfinite(v->max)) snprintf(high, sizeof high, ", at most %.6g %s", v->max, v->unit);
    pam_log(c, PAM_WARNING, "%s = %.6g %s is outside the range of the model%s%s: the results may be without meaning",
            v->name, value, v->unit, low, high);
}

/* A parameter may change between steps, or in event mode, where the model allows it. */
static pam_status set_parameter(pam_instance *c, const pam_variable *v, double value) {
    double *p = c->solver.p + v->index;
    if (*p == value) return PAM_OK;
    if (!(c->core.phase & (INSTANTIATED | INITIALIZATION))) {
        if (!v->tunable)
            return pam_log(c, PAM_ERROR, "parameter '%s' is fixed: it must be set before the simulation", v->name);
        if (c->core.phase == CONTINUOUS)
            return pam_log(c, PAM_ERROR, "parameter '%s' must be set in event mode", v->name);
        pam_log(c, PAM_OK, "at time %.9g s: %s = %.9g %s", c->core.time, v->name, value, v->unit);
        c->core.state_changed = 1;
    } else
        c->core.initial_known = 0;
    check_range(c, v, value, *p);
    *p = value;
    return PAM_OK;
}

static pam_status set_one(pam_instance *c, unsigned vr, double value) {
    const pam_variable *v = pam_lookup(c, vr);
    int starting = c->core.phase & (INSTANTIATED | INITIALIZATION);
    if (!v) return PAM_ERROR;
    if (!isfinite(value)) return pam_log(c, PAM_ERROR, "the value for '%s' is not a finite number", v->name);
    switch ((pam_kind)v->kind) {
        case INPUT:
            check_range(c, v, value, c->u[v->index]);
            c->u[v->index] = value;
            if (starting) c->core.initial_known = 0;
            return PAM_OK;
        case PARAMETER: return set_parameter(c, v, value);
        case STATE:
            check_range(c, v, value, starting ? NAN : c->x[v->index]);
            c->x[v->index] = c->x_given[v->index] = value;
            if (starting) {
                c->x_explicit[v->index] = 1.0;
                c->core.initial_known = 0;
            } else
                c->core.state_changed = 1;
            return PAM_OK;
        default: return pam_log(c, PAM_ERROR, "the variable '%s' cannot be set", v->name);
    }
}

pam_status pam_set(pam_instance *c, const unsigned vr[], size_t n, const double value[]) {
    if (!pam_arrays(c, "setting variables", n, vr, value)) return PAM_ERROR;
    pam_forget(c);
    for (size_t i = 0; i < n; i++)
        if (set_one(c, vr[i], value[i]) != PAM_OK) return PAM_ERROR;
    return PAM_OK;
}

/* Where the seed of a known variable stands; -1 where it is none. */
static int seed_index(const pam_instance *c, unsigned vr) {
    const pam_model *m = c->model;
    const pam_variable *v = pam_lookup(c, vr);
    if (!v) return -1;
    if (v->kind == STATE) return v->index;
    if (v->kind == INPUT) return m->nx + v->index;
    if (v->kind == PARAMETER) return m->nx + m->nu + v->index;
    if (v->kind == TIME) return m->nx + m->nu + m->np;
    pam_log(c, PAM_ERROR, "'%s' is not a known variable", v->name);
    return -1;
}

/* The derivative of an unknown variable after pam_directional; 0 where it is none. */
static int derivative_of(const pam_instance *c, unsigned vr, double *value) {
    const pam_model *m = c->model;
    const pam_variable *v = pam_lookup(c, vr);
    if (!v) return 0;
    if (v->kind == DERIVATIVE) *value = c->result[v->index];
    else if (v->kind == OUTPUT) *value = c->result[m->nx + v->index];
    else if (v->kind == LOCAL) *value = c->result[m->nx + m->ny + v->index];
    else if (v->kind == STATE) *value = c->seed[v->index]; /* an output that is a state, or a calculated start value */
    else {
        pam_log(c, PAM_ERROR, "'%s' is not an unknown variable", v->name);
        return 0;
    }
    return 1;
}

static void clear_seed(pam_instance *c) {
    const pam_model *m = c->model;
    memset(c->seed, 0, sizeof(double) * (size_t)(m->nx + m->nu + m->np + 1));
}

pam_status pam_directional_derivative(pam_instance *c, const unsigned unknown[], size_t n_unknown,
                                      const unsigned known[], size_t n_known, const double seed[],
                                      double sensitivity[]) {
    if (!c->model->jvp) return pam_log(c, PAM_ERROR, "this model does not provide directional derivatives");
    if (!pam_arrays(c, "directional derivative", n_known, known, seed)) return PAM_ERROR;
    if (!pam_arrays(c, "directional derivative", n_unknown, unknown, sensitivity)) return PAM_ERROR;
    clear_seed(c);
    for (size_t i = 0; i < n_known; i++) {
        int at = seed_index(c, known[i]);
        if (at < 0) return PAM_ERROR;
        c->seed[at] += seed[i];
    }
    pam_directional(c);
    for (size_t i = 0; i < n_unknown; i++)
        if (!derivative_of(c, unknown[i], &sensitivity[i])) return PAM_ERROR;
    return PAM_OK;
}

/* One column of the Jacobian at a time. */
pam_status pam_adjoint_derivative(pam_instance *c, const unsigned unknown[], size_t n_unknown,
                                  const unsigned known[], size_t n_known, const double seed[],
                                  double sensitivity[]) {
    if (!c->model->jvp) return pam_log(c, PAM_ERROR, "this model does not provide adjoint derivatives");
    if (!pam_arrays(c, "adjoint derivative", n_unknown, unknown, seed)) return PAM_ERROR;
    if (!pam_arrays(c, "adjoint derivative", n_known, known, sensitivity)) return PAM_ERROR;
    for (size_t j = 0; j < n_known; j++) {
        int at = seed_index(c, known[j]);
        if (at < 0) return PAM_ERROR;
        clear_seed(c);
        c->seed[at] = 1.0;
        pam_directional(c);
        double sum = 0.0, entry;
        for (size_t i = 0; i < n_unknown; i++) {
            if (!derivative_of(c, unknown[i], &entry)) return PAM_ERROR;
            sum += seed[i] * entry;
        }
        sensitivity[j] = sum;
    }
    return PAM_OK;
}
