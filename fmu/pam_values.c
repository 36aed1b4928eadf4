/* Values and partial derivatives of the variables, by value reference. */
#include <math.h>
#include <string.h>

#include "pam_instance.h"

pam_status pam_get(pam_instance *c, const unsigned vr[], size_t n, double value[]) {
    if (!pam_arrays(c, "reading variables", n, vr, value)) return PAM_ERROR;
    for (size_t i = 0; i < n; i++) {
        pam_kind kind;
        int index;
        if (!pam_lookup(c, vr[i], &kind, &index)) return PAM_ERROR;
        switch (kind) {
            case STATE: pam_initialise_states(c); value[i] = c->x[index]; break;
            case DERIVATIVE: value[i] = pam_derivatives(c)[index]; break;
            case INPUT: value[i] = c->u[index]; break;
            case OUTPUT: value[i] = pam_outputs(c)[index]; break;
            case PARAMETER: value[i] = c->solver.p[index]; break;
            case LOCAL: value[i] = pam_locals(c)[index]; break;
            case TIME: value[i] = c->core.time; break;
        }
    }
    return c->core.phase == INITIALIZATION ? pam_rest_known(c, PAM_DISCARD) : PAM_OK;
}

static pam_status set_one(pam_instance *c, unsigned vr, double value) {
    pam_kind kind;
    int index, starting = c->core.phase & (INSTANTIATED | INITIALIZATION);
    if (!pam_lookup(c, vr, &kind, &index)) return PAM_ERROR;
    if (!isfinite(value))
        return pam_log(c, PAM_ERROR, "the value for value reference %u is not a finite number", vr);
    switch (kind) {
        case INPUT:
            c->u[index] = value;
            if (starting) c->core.initial_known = 0;
            return PAM_OK;
        case PARAMETER:
            if (!starting)
                return pam_log(c, PAM_ERROR, "parameter %d is fixed: it must be set before the simulation", index);
            c->solver.p[index] = value;
            c->core.initial_known = 0;
            return PAM_OK;
        case STATE:
            c->x[index] = c->x_given[index] = value;
            if (starting) {
                c->x_explicit[index] = 1.0;
                c->core.initial_known = 0;
            } else
                c->core.state_changed = 1;
            return PAM_OK;
        default: return pam_log(c, PAM_ERROR, "the variable with value reference %u cannot be set", vr);
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
    pam_kind kind;
    int index;
    if (!pam_lookup(c, vr, &kind, &index)) return -1;
    if (kind == STATE) return index;
    if (kind == INPUT) return m->nx + index;
    if (kind == PARAMETER) return m->nx + m->nu + index;
    if (kind == TIME) return m->nx + m->nu + m->np;
    pam_log(c, PAM_ERROR, "value reference %u is not a known variable", vr);
    return -1;
}

/* The derivative of an unknown variable after pam_directional; 0 where it is none. */
static int derivative_of(const pam_instance *c, unsigned vr, double *value) {
    const pam_model *m = c->model;
    pam_kind kind;
    int index;
    if (!pam_lookup(c, vr, &kind, &index)) return 0;
    if (kind == DERIVATIVE) *value = c->result[index];
    else if (kind == OUTPUT) *value = c->result[m->nx + index];
    else if (kind == LOCAL) *value = c->result[m->nx + m->ny + index];
    else if (kind == STATE) *value = c->seed[index]; /* an output that is a state, or a calculated start value */
    else {
        pam_log(c, PAM_ERROR, "value reference %u is not an unknown variable", vr);
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
