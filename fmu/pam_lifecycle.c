/* Creation, initialization, end. */
#include <math.h>
#include <string.h>

#include "pam_instance.h"

static void *allocate(const pam_host *host, size_t n, size_t size) {
    void *block = host->memory.allocate(n ? n : 1, size);
    if (block) memset(block, 0, (n ? n : 1) * size);
    return block;
}

void pam_free(pam_instance *c) {
    void (*release)(void *) = c->host.memory.release;
    for (int i = 0; c->solver.past && i < c->model->nd; i++)
        if (c->solver.past[i].segments) release(c->solver.past[i].segments);
    void *blocks[] = {c->solver.past, c->solver.pivot, c->solver.iw, c->solver.k, c->saved, c->dx, c->name, c};
    for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++)
        if (blocks[i]) release(blocks[i]);
}

/* The blocks of memory behind an instance; 0 where memory has run out. */
static int allocate_arrays(pam_instance *c) {
    const pam_model *m = c->model;
    const pam_host *host = &c->host;
    size_t solver_size = pam_solver_saved_size(m), nx = (size_t)m->nx, nu = (size_t)m->nu, np = (size_t)m->np,
           nd = (size_t)m->nd, na = (size_t)m->na;
    size_t results = nx + (size_t)(m->ny + m->nw);
    c->saved_size = solver_size + 3 * nx + 2 * nu + na;
    c->saved = allocate(host, c->saved_size, sizeof(double));
    double *scratch = allocate(host, pam_solver_scratch_size(m), sizeof(double));
    int *pivot = allocate(host, pam_solver_pivots(m), sizeof(int));
    long long *iw = allocate(host, (size_t)m->size_iw, sizeof(long long));
    c->dx = allocate(host, results + (nx + nu + np + 1) + (results + nx) + 4 * nd + na + (size_t)(m->nm + m->nc),
                     sizeof(double));
    c->solver.past = allocate(host, nd, sizeof *c->solver.past);
    c->solver.memory = host->memory;
    if (c->saved && scratch) pam_solver_bind(&c->solver, m, &c->core.solver, c->saved, scratch, pivot, iw);
    if (!c->saved || !scratch || !pivot || !iw || !c->dx || !c->solver.past) {
        c->solver.k = scratch;
        c->solver.pivot = pivot;
        c->solver.iw = iw;
        return 0;
    }
    c->x = c->saved + solver_size;
    c->x_explicit = c->x + nx;
    c->x_given = c->x_explicit + nx;
    c->u = c->x_given + nx;
    c->du = c->u + nu;
    c->told = c->du + nu;
    c->y = c->dx + nx;
    c->w = c->y + m->ny;
    c->seed = c->dx + results;
    c->result = c->seed + nx + nu + np + 1;
    c->d = c->result + results + nx;
    c->dd = c->d + nd;
    c->seed_d = c->dd + nd;
    c->rate_d = c->seed_d + nd;
    c->held = c->rate_d + nd;
    c->checks = c->held + m->nc;
    c->solver.accept = na ? pam_accept : NULL;
    c->solver.owner = c;
    return 1;
}

static pam_instance *refuse(const pam_host *host, const char *name, const char *why) {
    if (host->logger) host->log(host, name ? name : "", PAM_ERROR, "logStatusError", why);
    return NULL;
}

pam_instance *pam_create(const pam_host *host, int kind, const char *name, const char *guid) {
    if (!name || !*name) return refuse(host, name, "an instance needs a name");
    if (!guid || strcmp(guid, pam_the_model.guid) != 0)
        return refuse(host, name, "the GUID does not belong to this FMU (FMI 3.0: the instantiation token)");
    if (kind == MODEL_EXCHANGE && pam_the_model.nd)
        return refuse(host, name, "a model with delayed inputs cannot be used for model exchange");
    pam_instance *c = allocate(host, 1, sizeof *c);
    if (!c) return refuse(host, name, "out of memory");
    c->host = *host;
    c->model = &pam_the_model;
    c->kind = kind;
    c->logging = LOG_ALL;
    c->name = allocate(host, strlen(name) + 1, 1);
    if (!c->name || !allocate_arrays(c)) {
        pam_free(c);
        return refuse(host, name, "out of memory");
    }
    strcpy(c->name, name);
    pam_reset(c);
    return c;
}

pam_status pam_reset(pam_instance *c) {
    const pam_model *m = c->model;
    memset(&c->core, 0, sizeof c->core);
    memset(c->saved, 0, c->saved_size * sizeof *c->saved);
    c->core.phase = INSTANTIATED;
    c->core.tolerance = m->tolerance;
    c->core.last_step = PAM_OK;
    for (int i = 0; i < m->nu; i++) c->u[i] = m->input_starts[i];
    for (int i = 0; i < m->np; i++) c->solver.p[i] = m->parameter_starts[i];
    for (int i = 0; i < m->nd; i++) c->solver.past[i].first = c->solver.past[i].end = 0;
    pam_forget(c);
    return PAM_OK;
}

pam_status pam_set_experiment(pam_instance *c, int tolerance_defined, double tolerance, double start,
                              int stop_defined, double stop) {
    if (!isfinite(start) || (stop_defined && !(stop >= start)))
        return pam_log(c, PAM_ERROR, "start time %g s and stop time %g s do not make an interval", start, stop);
    if (tolerance_defined && !(tolerance > 0.0 && tolerance < 1.0))
        return pam_log(c, PAM_ERROR, "the tolerance must lie between 0 and 1, not %g", tolerance);
    if (tolerance_defined) c->core.tolerance = fmax(tolerance, 1e-12);
    c->core.time = c->core.start_time = start;
    c->core.stop_defined = stop_defined;
    c->core.stop_time = stop;
    pam_forget(c);
    return PAM_OK;
}

pam_status pam_enter_initialization(pam_instance *c) {
    c->core.phase = INITIALIZATION;
    c->core.initial_known = 0;
    pam_forget(c);
    return PAM_OK;
}

pam_status pam_exit_initialization(pam_instance *c) {
    pam_initialise_states(c);
    if (pam_rest_known(c, PAM_ERROR) != PAM_OK) {
        c->core.phase = FAILED;
        return PAM_ERROR;
    }
    for (int i = 0; i < c->model->nx; i++)
        if (!isfinite(c->x[i])) {
            c->core.phase = FAILED;
            return pam_log(c, PAM_ERROR, "the start value of '%s' is not a finite number", c->model->state_names[i]);
        }
    pam_status status = pam_state_holds(c);
    if (status > PAM_WARNING) return status;
    if (c->kind == MODEL_EXCHANGE) {
        c->core.phase = EVENT;
        return status;
    }
    if (c->model->nx) memcpy(c->solver.x, c->x, sizeof(double) * (size_t)c->model->nx);
    if (pam_solver_begin(&c->solver, c->core.time, c->u, c->du, c->core.tolerance)) {
        c->core.phase = FAILED;
        return pam_log(c, PAM_ERROR, "%s", c->solver.message);
    }
    if (c->core.plain) pam_solver_leave_sensitivities(&c->solver);
    pam_forget(c);
    c->core.state_changed = 0;
    c->core.phase = STEP;
    return status;
}

pam_status pam_terminate(pam_instance *c) {
    c->core.phase = TERMINATED;
    return PAM_OK;
}
