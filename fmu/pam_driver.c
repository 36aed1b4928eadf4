/* Runs a co-simulation instance of FMI 2.0 or 3.0 over given communication points by the standard functions, so
 * that no interpreter stands between two steps. Works with any FMU.
 */
#include <float.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "fmi2FunctionTypes.h"
#include "fmi3FunctionTypes.h"

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

/* Where the instance's messages of status warning and worse are collected. */
typedef struct {
    size_t used;
    char text[8192];
} driver_log;

EXPORT void pam_driver_logger(fmi2ComponentEnvironment environment, fmi2String instance, fmi2Status status,
                              fmi2String category, fmi2String message, ...) {
    driver_log *log = environment;
    (void)instance;
    (void)category;
    if (!log || !message || status == fmi2OK || log->used + 2 >= sizeof log->text) return;
    size_t room = sizeof log->text - log->used - 1;
    va_list args;
    va_start(args, message);
    int length = vsnprintf(log->text + log->used, room, message, args);
    va_end(args);
    if (length < 0) return;
    log->used += (size_t)length < room ? (size_t)length : room - 1;
    log->text[log->used++] = '\n';
    log->text[log->used] = '\0';
}

EXPORT void *pam_driver_allocate(size_t n, size_t size) { return calloc(n, size); }

EXPORT void pam_driver_free(void *block) { free(block); }

typedef void (*driver_function)(void); /* of the type that its version of FMI gives it */

/* Value references of one type. Mirrored by pam_cosim/simulation/values.py. */
typedef struct {
    int32_t type; /* see value_type */
    driver_function set, get;
    size_t n;
    const uint32_t *references;
    size_t n_values; /* of all of them: an array has several */
} driver_group;

typedef struct {
    size_t n;
    const driver_group *groups;
    size_t n_values;
} driver_variables;

/* One run. Mirrored by pam_cosim/simulation/driver.py. */
typedef struct {
    driver_function reset, setup, enter, leave, set_values, get_values, set_slopes, do_step, terminate, settle;
    driver_function real_status, boolean_status; /* of version 2, or null */
    void *instance;
    int32_t version; /* of FMI: 2 or 3; the latter has no function for setup */
    int32_t must_reset, tolerance_defined;
    double tolerance, max_seconds; /* max_seconds: of processor time; 0: no limit */
    void (*follow)(void *instance, int on); /* pam_follow_sensitivities of our own FMUs, or null */
    void (*keep_starts)(void *instance, int on); /* pam_keep_starts of our own FMUs, or null */
    int32_t plain; /* whether nobody asks for sensitivities */
    int32_t settle_start; /* 0: the run begins with the start values, 1: what is not among those set settles, 2: all does */
    int (*settle_at)(void *instance, int keep); /* pam_settle_start of our own FMUs, or null */
    void (*statistics)(const void *instance, long long values[5]); /* pam_get_statistics of our own FMUs, or null */
    int64_t max_steps; /* of the solver, rejected ones among them; 0: no limit */
    int32_t at_rest; /* each point is an equilibrium under its own inputs, found from the start values, not a time */
    driver_variables parameters;
    const double *parameter_values;
    const char *const *texts; /* of the parameters that are strings */
    driver_variables inputs;
    const double *input_values, *input_slopes; /* knots by inputs; slopes null where they are not understood */
    size_t n_slopes;                           /* of the first inputs, which are continuous */
    const int32_t *orders;                     /* n_slopes ones */
    driver_variables outputs;
    double *output_values; /* rows by outputs */
    void *buffer;          /* for the values of any group, of 8 bytes each */
    size_t n_points;
    const double *times;
    const int64_t *knots;       /* per point: row of the inputs to set there, or -1 */
    const int64_t *means;       /* per point: row of the inputs to set for the step from there on, or -1; or null */
    const int64_t *rows_before; /* per point: row of output values before the inputs are set, or -1 */
    const int64_t *rows_after;  /* and after */
    /* results */
    double time_reached;
    uint64_t calls; /* that were made; this and the next may be read while the run goes on */
    int32_t active; /* number of the function that is called, in the order above */
    int32_t stage; /* number of the function that failed, in the order above; -1: none */
    int32_t status;
    const driver_group *group; /* that was set or read last */
    int32_t ended;             /* whether the instance has ended the simulation, at time_reached */
} driver_run;

enum { RESET, SETUP, ENTER, LEAVE, SET_VALUES, GET_VALUES, SET_SLOPES, DO_STEP, TERMINATE, SETTLE, REAL_STATUS, BOOLEAN_STATUS, TOO_SLOW, TOO_MANY_STEPS };

/* The status codes of both versions agree, and so do the arguments of functions without any but the instance. */
enum { OK = 0, WARNING = 1, DISCARD = 2 };

#define CALL(number, call)                 \
    do {                                   \
        begin_call(r, (number));           \
        int status_ = (int)(call);         \
        if (status_ > WARNING) {           \
            r->stage = (number);           \
            r->status = (int32_t)status_;  \
            return;                        \
        }                                  \
    } while (0)

/* Another thread may ask how far the run is. */
static void begin_call(driver_run *r, int32_t number) {
    r->active = number;
    r->calls++;
}

static int call(const driver_run *r, driver_function f) { return (int)((fmi2ResetTYPE *)f)(r->instance); }

/* Types of values, and the greatest, which a double may round up; those of all others are doubles already. */
#define VALUE_TYPES(X)                                                                                              \
    X(1, float, FLT_MAX) X(2, int8_t, INT8_MAX) X(3, uint8_t, UINT8_MAX) X(4, int16_t, INT16_MAX)                   \
    X(5, uint16_t, UINT16_MAX) X(6, int32_t, INT32_MAX) X(7, uint32_t, UINT32_MAX) X(8, int64_t, INT64_MAX)         \
    X(9, uint64_t, UINT64_MAX)
enum { TEXT = 10 };

typedef int set_2(void *instance, const uint32_t *references, size_t n, const void *values);
typedef int set_3(void *instance, const uint32_t *references, size_t n, const void *values, size_t n_values);
typedef int get_2(void *instance, const uint32_t *references, size_t n, void *values);
typedef int get_3(void *instance, const uint32_t *references, size_t n, void *values, size_t n_values);

static const void *typed(const driver_run *r, const driver_group *g, const double *values) {
    if (g->type == TEXT) return r->texts;
    switch (g->type) {
#define TO_TYPE(number, type, greatest)                                                              \
    case number:                                                                                     \
        for (size_t i = 0; i < g->n_values; i++)                                                     \
            ((type *)r->buffer)[i] = values[i] < (double)(greatest) ? (type)values[i] : (greatest);  \
        return r->buffer;
        VALUE_TYPES(TO_TYPE)
    }
    return values;
}

static void untyped(const driver_run *r, const driver_group *g, double *values) {
    switch (g->type) {
#define FROM_TYPE(number, type, greatest)                                                         \
    case number:                                                                                  \
        for (size_t i = 0; i < g->n_values; i++) values[i] = (double)((const type *)r->buffer)[i]; \
        return;
        VALUE_TYPES(FROM_TYPE)
    }
}

static int set_values(driver_run *r, const driver_variables *v, const double *values) {
    int worst = OK;
    for (size_t k = 0; k < v->n && worst <= WARNING; k++) {
        const driver_group *g = &v->groups[k];
        r->group = g;
        const void *given = typed(r, g, values);
        int status = r->version == 2 ? ((set_2 *)g->set)(r->instance, g->references, g->n, given)
                                     : ((set_3 *)g->set)(r->instance, g->references, g->n, given, g->n_values);
        worst = status > worst ? status : worst;
        values += g->n_values;
    }
    return worst;
}

static int get_values(driver_run *r, const driver_variables *v, double *values) {
    int worst = OK;
    for (size_t k = 0; k < v->n && worst <= WARNING; k++) {
        const driver_group *g = &v->groups[k];
        r->group = g;
        void *place = g->type ? r->buffer : values;
        int status = r->version == 2 ? ((get_2 *)g->get)(r->instance, g->references, g->n, place)
                                     : ((get_3 *)g->get)(r->instance, g->references, g->n, place, g->n_values);
        untyped(r, g, values);
        worst = status > worst ? status : worst;
        values += g->n_values;
    }
    return worst;
}

static int enter(const driver_run *r) {
    if (r->version == 2) return call(r, r->enter);
    return (int)((fmi3EnterInitializationModeTYPE *)r->enter)(r->instance, r->tolerance_defined != 0, r->tolerance,
                                                              r->times[0], fmi3False, 0.0);
}

/* In FMI 2.0 a step that was discarded may be the end of the simulation. */
static int do_step_2(driver_run *r, double from, double step) {
    int status = (int)((fmi2DoStepTYPE *)r->do_step)(r->instance, from, step, fmi2True);
    if (status != DISCARD || !r->boolean_status || !r->real_status) return status;
    fmi2Boolean ended = fmi2False;
    fmi2Real reached = from;
    ((fmi2GetBooleanStatusTYPE *)r->boolean_status)(r->instance, fmi2Terminated, &ended);
    ((fmi2GetRealStatusTYPE *)r->real_status)(r->instance, fmi2LastSuccessfulTime, &reached);
    r->ended = ended != fmi2False;
    r->time_reached = reached;
    return r->ended ? OK : status;
}

/* An instance of FMI 3.0 must not return early here, except to end the simulation. */
static int do_step(driver_run *r, double from, double step) {
    if (r->version == 2) return do_step_2(r, from, step);
    fmi3Boolean event = fmi3False, terminate = fmi3False, early = fmi3False;
    fmi3Float64 reached = from;
    int status = (int)((fmi3DoStepTYPE *)r->do_step)(r->instance, from, step, fmi3True, &event, &terminate, &early,
                                                     &reached);
    r->ended = status <= WARNING && terminate;
    if (r->ended || early) r->time_reached = reached;
    return status <= WARNING && early && !terminate ? DISCARD : status;
}

static int set_inputs(driver_run *r, int64_t knot) {
    const double *values = r->input_values + (size_t)knot * r->inputs.n_values;
    begin_call(r, SET_VALUES);
    int status = set_values(r, &r->inputs, values);
    r->stage = SET_VALUES;
    if (status <= WARNING && r->input_slopes && r->n_slopes) {
        const double *slopes = r->input_slopes + (size_t)knot * r->inputs.n_values;
        fmi2SetRealInputDerivativesTYPE *set_slopes = (fmi2SetRealInputDerivativesTYPE *)r->set_slopes;
        begin_call(r, SET_SLOPES);
        status = (int)set_slopes(r->instance, r->inputs.groups->references, r->n_slopes, r->orders, slopes);
        r->stage = SET_SLOPES;
    }
    r->status = (int32_t)status;
    if (status > WARNING) return 1;
    r->stage = -1;
    return 0;
}

static void initialise(driver_run *r, int64_t knot) {
    if (r->must_reset) CALL(RESET, call(r, r->reset));
    if (r->follow) r->follow(r->instance, !r->plain);
    if (r->keep_starts) r->keep_starts(r->instance, 1);
    if (r->parameters.n) CALL(SET_VALUES, set_values(r, &r->parameters, r->parameter_values));
    if (r->version == 2) {
        fmi2SetupExperimentTYPE *setup = (fmi2SetupExperimentTYPE *)r->setup;
        CALL(SETUP, setup(r->instance, r->tolerance_defined, r->tolerance, r->times[0], fmi2False, 0.0));
    }
    CALL(ENTER, enter(r));
    if (r->inputs.n && knot >= 0 && set_inputs(r, knot)) return;
    CALL(LEAVE, call(r, r->leave));
    if (r->settle_start) CALL(SETTLE, r->settle_at(r->instance, r->settle_start == 1));
}

static void read_outputs(driver_run *r, int64_t row) {
    if (row < 0 || !r->outputs.n) return;
    double *values = r->output_values + (size_t)row * r->outputs.n_values;
    CALL(GET_VALUES, get_values(r, &r->outputs, values));
}

/* The clock of the process costs as much as a step: it is asked at some points, and when another second of the day has
 * begun, which costs next to nothing to know.
 */
typedef struct {
    clock_t begin;
    time_t second;
} driver_clock;

static driver_clock start_clock(void) { return (driver_clock){clock(), time(NULL)}; }

static int too_slow(driver_run *r, driver_clock *c, size_t point) {
    if (!(r->max_seconds > 0.0)) return 0;
    time_t now = time(NULL);
    if (point % 64 && now == c->second) return 0;
    c->second = now;
    if ((double)(clock() - c->begin) / CLOCKS_PER_SEC <= r->max_seconds) return 0;
    r->stage = TOO_SLOW;
    return 1;
}

static int too_many_steps(driver_run *r) {
    long long n[5];
    if (!r->statistics || r->max_steps <= 0) return 0;
    r->statistics(r->instance, n);
    if (n[0] + n[1] <= r->max_steps) return 0;
    r->stage = TOO_MANY_STEPS;
    return 1;
}

static void loop(driver_run *r) {
    driver_clock begin = start_clock();
    for (size_t k = 0; k < r->n_points; k++) {
        if (too_slow(r, &begin, k) || too_many_steps(r)) return;
        if (k > 0) {
            double from = r->times[k - 1], step = r->times[k] - from;
            CALL(DO_STEP, do_step(r, from, step));
            if (r->ended && r->time_reached < r->times[k] - 1e-9 * step) return;
            r->time_reached = r->times[k];
            read_outputs(r, r->rows_before[k]);
            if (r->stage >= 0) return;
            if (r->inputs.n && r->knots[k] >= 0 && set_inputs(r, r->knots[k])) return;
        } else {
            read_outputs(r, r->rows_before[k]);
            if (r->stage >= 0) return;
        }
        read_outputs(r, r->rows_after[k]);
        if (r->stage >= 0 || r->ended) return;
        if (r->means && r->means[k] >= 0 && set_inputs(r, r->means[k])) return;
    }
}

/* Every point begins anew, so that none depends on those before it. */
static void rest_at_each(driver_run *r) {
    driver_clock begin = start_clock();
    for (size_t k = 0; k < r->n_points; k++) {
        if (too_slow(r, &begin, k)) return;
        r->time_reached = r->times[k];
        initialise(r, r->knots[k]);
        if (r->stage >= 0) return;
        r->must_reset = 1;
        CALL(SETTLE, call(r, r->settle));
        read_outputs(r, r->rows_after[k]);
        if (r->stage >= 0) return;
    }
}

EXPORT void pam_driver_run(driver_run *r) {
    r->stage = -1;
    r->status = OK;
    r->ended = 0;
    r->time_reached = r->times[0];
    if (r->at_rest) {
        rest_at_each(r);
        return;
    }
    initialise(r, r->knots[0]);
    if (r->stage < 0) loop(r);
    if (r->stage < 0 && !r->ended) CALL(TERMINATE, call(r, r->terminate));
}
