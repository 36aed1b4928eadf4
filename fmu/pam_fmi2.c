/* The functions that FMI 2.0 co-simulation and model exchange share. */
#include <math.h>
#include <string.h>

#include "pam_instance.h"

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }

const char *fmi2GetVersion(void) { return fmi2Version; }

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, size_t n, const fmi2String categories[]) {
    pam_instance *c = pam_check(component, ANY, "fmi2SetDebugLogging");
    (void)n;
    (void)categories;
    if (!c) return fmi2Error;
    c->logging = on == fmi2True;
    return fmi2OK;
}

/* --- creation ------------------------------------------------------------------------------------------- */

static void *allocate(const fmi2CallbackFunctions *f, size_t n, size_t size) {
    void *block = f->allocateMemory(n ? n : 1, size);
    if (block) memset(block, 0, (n ? n : 1) * size);
    return block;
}

static void release(pam_instance *c) {
    void (*freeMemory)(void *) = c->callbacks.freeMemory;
    for (int i = 0; c->solver.past && i < c->model->nd; i++)
        if (c->solver.past[i].segments) freeMemory(c->solver.past[i].segments);
    void *blocks[] = {c->solver.past, c->solver.pivot, c->solver.iw, c->solver.k, c->saved, c->dx, c->name, c};
    for (size_t i = 0; i < sizeof blocks / sizeof *blocks; i++)
        if (blocks[i]) freeMemory(blocks[i]);
}

/* The blocks of memory behind an instance; 0 where memory has run out. */
static int allocate_arrays(pam_instance *c) {
    const pam_model *m = c->model;
    const fmi2CallbackFunctions *f = &c->callbacks;
    size_t solver_size = pam_solver_saved_size(m), nx = (size_t)m->nx, nu = (size_t)m->nu, np = (size_t)m->np,
           nd = (size_t)m->nd;
    size_t results = nx + (size_t)(m->ny + m->nw);
    c->saved_size = solver_size + 2 * nx + 2 * nu;
    c->saved = allocate(f, c->saved_size, sizeof(double));
    double *scratch = allocate(f, pam_solver_scratch_size(m), sizeof(double));
    int *pivot = allocate(f, pam_solver_pivots(m), sizeof(int));
    long long *iw = allocate(f, (size_t)m->size_iw, sizeof(long long));
    c->dx = allocate(f, results + (nx + nu + np + 1) + (results + nx) + 4 * nd, sizeof(double));
    c->solver.past = allocate(f, nd, sizeof *c->solver.past);
    c->solver.memory = (pam_memory){f->allocateMemory, f->freeMemory};
    if (c->saved && scratch) pam_solver_bind(&c->solver, m, &c->core.solver, c->saved, scratch, pivot, iw);
    if (!c->saved || !scratch || !pivot || !iw || !c->dx || !c->solver.past) {
        c->solver.k = scratch;
        c->solver.pivot = pivot;
        c->solver.iw = iw;
        return 0;
    }
    c->x = c->saved + solver_size;
    c->x_explicit = c->x + nx;
    c->u = c->x_explicit + nx;
    c->du = c->u + nu;
    c->y = c->dx + nx;
    c->w = c->y + m->ny;
    c->seed = c->dx + results;
    c->result = c->seed + nx + nu + np + 1;
    c->d = c->result + results + nx;
    c->dd = c->d + nd;
    c->seed_d = c->dd + nd;
    c->rate_d = c->seed_d + nd;
    return 1;
}

static fmi2Component refuse(const fmi2CallbackFunctions *f, fmi2String name, const char *why) {
    if (f->logger) f->logger(f->componentEnvironment, name ? name : "", fmi2Error, "logStatusError", "%s", why);
    return NULL;
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *f, fmi2Boolean visible, fmi2Boolean logging) {
    (void)resources;
    (void)visible;
    if (!f || !f->allocateMemory || !f->freeMemory) return NULL;
    if (!name || !*name) return refuse(f, name, "fmi2Instantiate needs an instance name");
    if (!guid || strcmp(guid, pam_the_model.guid) != 0)
        return refuse(f, name, "the GUID does not belong to this FMU");
    if (type == fmi2ModelExchange && pam_the_model.nd)
        return refuse(f, name, "a model with delayed inputs cannot be used for model exchange");
    pam_instance *c = allocate(f, 1, sizeof *c);
    if (!c) return refuse(f, name, "out of memory");
    c->callbacks = *f;
    c->model = &pam_the_model;
    c->type = type;
    c->logging = logging == fmi2True;
    c->name = allocate(f, strlen(name) + 1, 1);
    if (!c->name || !allocate_arrays(c)) {
        release(c);
        return refuse(f, name, "out of memory");
    }
    strcpy(c->name, name);
    pam_reset(c);
    return c;
}

void fmi2FreeInstance(fmi2Component component) {
    if (component) release(component);
}

/* --- initialization ------------------------------------------------------------------------------------- */

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
    pam_instance *c = pam_check(component, INSTANTIATED, "fmi2SetupExperiment");
    if (!c) return fmi2Error;
    if (!isfinite(start) || (stop_defined && !(stop >= start)))
        return pam_log(c, fmi2Error, "start time %g s and stop time %g s do not make an interval", start, stop);
    if (tolerance_defined && !(tolerance > 0.0 && tolerance < 1.0))
        return pam_log(c, fmi2Error, "the tolerance must lie between 0 and 1, not %g", tolerance);
    if (tolerance_defined) c->core.tolerance = fmax(tolerance, 1e-12);
    c->core.time = c->core.start_time = start;
    c->core.stop_defined = stop_defined == fmi2True;
    c->core.stop_time = stop;
    pam_forget(c);
    return fmi2OK;
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
    pam_instance *c = pam_check(component, INSTANTIATED, "fmi2EnterInitializationMode");
    if (!c) return fmi2Error;
    c->core.phase = INITIALIZATION;
    return fmi2OK;
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
    pam_instance *c = pam_check(component, INITIALIZATION, "fmi2ExitInitializationMode");
    if (!c) return fmi2Error;
    pam_initialise_states(c);
    for (int i = 0; i < c->model->nx; i++)
        if (!isfinite(c->x[i])) {
            c->core.phase = FAILED;
            return pam_log(c, fmi2Error, "the start value of '%s' is not a finite number", c->model->state_names[i]);
        }
    if (c->type == fmi2ModelExchange) {
        c->core.phase = EVENT;
        return fmi2OK;
    }
    if (c->model->nx) memcpy(c->solver.x, c->x, sizeof(double) * (size_t)c->model->nx);
    if (pam_solver_begin(&c->solver, c->core.time, c->u, c->du, c->core.tolerance)) {
        c->core.phase = FAILED;
        return pam_log(c, fmi2Error, "%s", c->solver.message);
    }
    pam_forget(c);
    c->core.state_changed = 0;
    c->core.phase = STEP;
    return fmi2OK;
}

fmi2Status fmi2Terminate(fmi2Component component) {
    pam_instance *c = pam_check(component, STEP | EVENT | CONTINUOUS, "fmi2Terminate");
    if (!c) return fmi2Error;
    c->core.phase = TERMINATED;
    return fmi2OK;
}

fmi2Status fmi2Reset(fmi2Component component) {
    pam_instance *c = pam_check(component, ANY, "fmi2Reset");
    if (!c) return fmi2Error;
    pam_reset(c);
    return fmi2OK;
}

/* --- values --------------------------------------------------------------------------------------------- */

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
    pam_instance *c = pam_check(component, ANY, "fmi2GetReal");
    if (!c || (n && (!vr || !value))) return fmi2Error;
    for (size_t i = 0; i < n; i++) {
        pam_kind kind;
        int index;
        if (!pam_lookup(c, vr[i], &kind, &index)) return fmi2Error;
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
    return fmi2OK;
}

static fmi2Status set_one(pam_instance *c, fmi2ValueReference vr, double value) {
    pam_kind kind;
    int index, starting = c->core.phase & (INSTANTIATED | INITIALIZATION);
    if (!pam_lookup(c, vr, &kind, &index)) return fmi2Error;
    if (!isfinite(value))
        return pam_log(c, fmi2Error, "the value for value reference %u is not a finite number", vr);
    switch (kind) {
        case INPUT: c->u[index] = value; return fmi2OK;
        case PARAMETER:
            if (!starting)
                return pam_log(c, fmi2Error, "parameter %d is fixed: it must be set before the simulation", index);
            c->solver.p[index] = value;
            c->core.initial_known = 0;
            return fmi2OK;
        case STATE:
            c->x[index] = value;
            if (starting) c->x_explicit[index] = 1.0;
            else c->core.state_changed = 1;
            return fmi2OK;
        default: return pam_log(c, fmi2Error, "the variable with value reference %u cannot be set", vr);
    }
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference vr[], size_t n, const fmi2Real value[]) {
    pam_instance *c = pam_check(component, INSTANTIATED | INITIALIZATION | STEP | EVENT | CONTINUOUS, "fmi2SetReal");
    if (!c || (n && (!vr || !value))) return fmi2Error;
    pam_forget(c);
    for (size_t i = 0; i < n; i++)
        if (set_one(c, vr[i], value[i]) != fmi2OK) return fmi2Error;
    return fmi2OK;
}

/* The model has real variables alone. */
#define NO_VARIABLES(function, type)                                                                              \
    fmi2Status function(fmi2Component component, const fmi2ValueReference vr[], size_t n, type value[]) {          \
        pam_instance *c = pam_check(component, ANY, #function);                                                    \
        (void)value;                                                                                               \
        if (!c) return fmi2Error;                                                                                  \
        return n ? pam_log(c, fmi2Error, #function ": value reference %u is of another type", vr ? vr[0] : 0u)    \
                 : fmi2OK;                                                                                         \
    }
NO_VARIABLES(fmi2GetInteger, fmi2Integer)
NO_VARIABLES(fmi2GetBoolean, fmi2Boolean)
NO_VARIABLES(fmi2GetString, fmi2String)
NO_VARIABLES(fmi2SetInteger, const fmi2Integer)
NO_VARIABLES(fmi2SetBoolean, const fmi2Boolean)
NO_VARIABLES(fmi2SetString, const fmi2String)

/* --- derivatives ---------------------------------------------------------------------------------------- */

/* Where the seed of a known variable stands; -1 where it is none. */
static int seed_index(pam_instance *c, fmi2ValueReference vr) {
    const pam_model *m = c->model;
    pam_kind kind;
    int index;
    if (!pam_lookup(c, vr, &kind, &index)) return -1;
    if (kind == STATE) return index;
    if (kind == INPUT) return m->nx + index;
    if (kind == PARAMETER) return m->nx + m->nu + index;
    if (kind == TIME) return m->nx + m->nu + m->np;
    pam_log(c, fmi2Error, "value reference %u is not a known variable", vr);
    return -1;
}

/* The derivative of an unknown variable after pam_directional; 0 where it is none. */
static int derivative_of(pam_instance *c, fmi2ValueReference vr, double *value) {
    const pam_model *m = c->model;
    pam_kind kind;
    int index;
    if (!pam_lookup(c, vr, &kind, &index)) return 0;
    if (kind == DERIVATIVE) *value = c->result[index];
    else if (kind == OUTPUT) *value = c->result[m->nx + index];
    else if (kind == LOCAL) *value = c->result[m->nx + m->ny + index];
    else if (kind == STATE) *value = c->seed[index]; /* an output that is a state, or a calculated start value */
    else {
        pam_log(c, fmi2Error, "value reference %u is not an unknown variable", vr);
        return 0;
    }
    return 1;
}

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknown[],
                                        size_t n_unknown, const fmi2ValueReference known[], size_t n_known,
                                        const fmi2Real seed[], fmi2Real sensitivity[]) {
    pam_instance *c = pam_check(component, INITIALIZATION | STEP | EVENT | CONTINUOUS | TERMINATED,
                                "fmi2GetDirectionalDerivative");
    if (!c || (n_known && (!known || !seed)) || (n_unknown && (!unknown || !sensitivity))) return fmi2Error;
    const pam_model *m = c->model;
    memset(c->seed, 0, sizeof(double) * (size_t)(m->nx + m->nu + m->np + 1));
    for (size_t i = 0; i < n_known; i++) {
        int at = seed_index(c, known[i]);
        if (at < 0) return fmi2Error;
        c->seed[at] += seed[i];
    }
    pam_directional(c);
    for (size_t i = 0; i < n_unknown; i++)
        if (!derivative_of(c, unknown[i], &sensitivity[i])) return fmi2Error;
    return fmi2OK;
}
