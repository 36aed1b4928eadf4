/* One instance of the FMU, whatever version of FMI it is seen through. pam_fmi2.c and pam_fmi3.c translate. */
#ifndef PAM_INSTANCE_H
#define PAM_INSTANCE_H

#include "pam_solver.h"

#if defined _WIN32
#define PAM_EXPORT __declspec(dllexport)
#else
#define PAM_EXPORT __attribute__((visibility("default")))
#endif

/* The numbers of fmi2Status and fmi3Status. */
typedef enum { PAM_OK, PAM_WARNING, PAM_DISCARD, PAM_ERROR, PAM_FATAL } pam_status;

/* What an instance is for; bits, so that a set of them is a mask. */
enum { MODEL_EXCHANGE = 1, CO_SIMULATION = 2, ANY_KIND = 3 };

/* The states of FMI 2.0 (figures 6 and 11) and of FMI 3.0 (section 2.3), as bits. */
enum {
    INSTANTIATED = 1,
    INITIALIZATION = 2,
    STEP = 4, /* co-simulation: between steps */
    EVENT = 8,
    CONTINUOUS = 16,
    STEP_FAILED = 32, /* co-simulation: the last step could not be completed */
    TERMINATED = 64,
    FAILED = 128,
    RUNNING = STEP | EVENT | CONTINUOUS,
    READABLE = INITIALIZATION | RUNNING | STEP_FAILED | TERMINATED,
    ANY = 255,
};

/* What a variable is a part of. */
typedef enum { STATE, DERIVATIVE, INPUT, OUTPUT, PARAMETER, LOCAL, TIME } pam_kind;

/* What the importing tool provides: memory and a log. */
typedef struct pam_host {
    pam_memory memory;
    void *environment;
    void (*logger)(void); /* the tool's own function, which log knows how to call; may be null */
    void (*log)(const struct pam_host *host, const char *instance, pam_status status, const char *category,
                const char *message);
} pam_host;

/* Plain data: with the block of doubles at pam_instance.saved and the histories this is the whole FMU state. */
typedef struct {
    int phase;
    int state_changed;  /* co-simulation: x or a parameter was set since the last step */
    int initial_known;  /* x holds x0(p) in the initialization phases */
    int unsettled;      /* no rest was found for the states that begin there */
    int keep_starts;    /* start values that were set are none to seek the rest from, but the states' own */
    int last_step;      /* pam_status of the last step */
    int stop_defined;
    int warned;         /* the model has warned since the last call that could say so */
    int plain;          /* co-simulation: the sensitivities are not followed in this run */
    double time, start_time, stop_time, tolerance;
    double holds_until; /* what the model states of itself is known to hold up to this time */
    pam_solver_scalars solver;
} pam_core;

typedef struct {
    const pam_model *model;
    pam_host host;
    int kind;    /* MODEL_EXCHANGE or CO_SIMULATION */
    int logging; /* bits of enum pam_category */
    char *name;
    pam_core core;
    size_t saved_size; /* doubles in saved */
    double *saved;
    double *x, *u, *du;              /* in saved: now */
    double *x_explicit, *x_given;    /* nx, in saved: 1 where the user set the start value; and that value */
    double *told;                    /* na, in saved: 1 where a warning was given */
    pam_solver solver;
    double *dx, *y, *w;              /* results at the present time */
    double *d, *dd;                  /* delayed inputs at the present time and their slopes */
    double *seed, *result;           /* nx + nu + np + 1; nx + ny + nw + nx */
    double *checks;                  /* na + nm: conditions, and numbers in the messages */
    double *seed_d, *rate_d;         /* nd: the seed that follows for delayed inputs; delays along the seed */
    double *held;                    /* nc: not 0 where a state does not begin at rest */
    int dx_known, y_known, w_known;
} pam_instance;

/* --- pam_lifecycle.c: from creation to the end -------------------------------------------------------- */

/* Null with a log message where it cannot be made. */
pam_instance *pam_create(const pam_host *host, int kind, const char *name, const char *guid);
void pam_free(pam_instance *c);
pam_status pam_set_experiment(pam_instance *c, int tolerance_defined, double tolerance, double start,
                              int stop_defined, double stop);
pam_status pam_enter_initialization(pam_instance *c);
pam_status pam_exit_initialization(pam_instance *c);
pam_status pam_terminate(pam_instance *c);
pam_status pam_reset(pam_instance *c);

/* --- pam_log.c: messages and checks ------------------------------------------------------------------- */

enum pam_category { LOG_WARNING = 1, LOG_DISCARD = 2, LOG_ERROR = 4, LOG_STATUS = 7, LOG_EVENTS = 8, LOG_ALL = 15 };

/* A log message of the instance's own; returns status. PAM_OK is the status of an event. */
pam_status pam_log(const pam_instance *c, pam_status status, const char *format, ...);

/* Which categories are reported: all where none is named. An unknown one is passed over with a warning. */
pam_status pam_set_logging(pam_instance *c, int on, size_t n, const char *const categories[]);

/* Null unless it is an instance of one of the kinds in one of the phases; otherwise the call is logged. */
pam_instance *pam_check(void *instance, int kinds, int phases, const char *function);

/* 1 where the arrays are there; otherwise 0 with a message. */
int pam_arrays(const pam_instance *c, const char *function, size_t n, const void *a, const void *b);

/* The variable of a value reference; null with a log message where there is none. */
const pam_variable *pam_lookup(const pam_instance *c, unsigned vr);

/* --- pam_instance.c: the model at the present time ---------------------------------------------------- */

void pam_forget(pam_instance *c);            /* results must be evaluated again */
const double *pam_derivatives(pam_instance *c);
const double *pam_outputs(pam_instance *c);
const double *pam_locals(pam_instance *c);

/* Conditions and numbers of what the model states of itself, to checks. */
void pam_check_statements(pam_instance *c);

/* Derivatives along a seed over (x, u, p, t), to result (dx, y, w); seeds of calculated start values follow
 * from the parameters in the initialization phases.
 */
void pam_directional(pam_instance *c);

/* --- pam_start.c: where the model begins --------------------------------------------------------------- */

/* x = x0(p) where not set explicitly; from initialization on with the states at rest that begin there. */
void pam_initialise_states(pam_instance *c);

/* In initialization: the seeds of states that follow from others', from inputs and from parameters. ``along`` gives
 * derivatives along the seed, to result.
 */
void pam_seed_states(pam_instance *c, void (*along)(pam_instance *c, pam_function jvp));

/* PAM_OK, or ``status`` with a message where no rest was found. */
pam_status pam_rest_known(const pam_instance *c, pam_status status);

/* --- pam_statements.c: what the model states of itself ------------------------------------------------- */

/* At the present time. PAM_ERROR, after a message, where the model cannot go on, which it then never will;
 * PAM_WARNING where something was said that was not said before.
 */
pam_status pam_state_holds(pam_instance *c);

/* The solver's question, for an instance: up to which time may its solution be used? */
int pam_accept(void *instance, double t);

/* --- pam_values.c: variables by value reference ------------------------------------------------------- */

pam_status pam_get(pam_instance *c, const unsigned vr[], size_t n, double value[]);
pam_status pam_set(pam_instance *c, const unsigned vr[], size_t n, const double value[]);

/* sensitivity = J seed and, for the adjoint, J' seed; J: d unknown / d known. */
pam_status pam_directional_derivative(pam_instance *c, const unsigned unknown[], size_t n_unknown,
                                      const unsigned known[], size_t n_known, const double seed[],
                                      double sensitivity[]);
pam_status pam_adjoint_derivative(pam_instance *c, const unsigned unknown[], size_t n_unknown,
                                  const unsigned known[], size_t n_known, const double seed[],
                                  double sensitivity[]);

/* --- pam_exchange.c: model exchange ------------------------------------------------------------------- */

pam_status pam_set_time(pam_instance *c, double time);
pam_status pam_set_states(pam_instance *c, const double x[], size_t n);
pam_status pam_get_states(pam_instance *c, double x[], size_t n);
pam_status pam_get_rates(pam_instance *c, double dx[], size_t n);
pam_status pam_get_nominals(pam_instance *c, double nominals[], size_t n);
pam_status pam_get_event_indicators(pam_instance *c, size_t n);

/* --- pam_cosimulation.c ------------------------------------------------------------------------------- */

/* PAM_DISCARD where the step could be computed in part only: core.time is then the time reached. */
pam_status pam_do_step(pam_instance *c, double now, double step);
pam_status pam_set_input_derivatives(pam_instance *c, const unsigned vr[], size_t n, const int order[],
                                     const double value[]);
pam_status pam_get_output_derivatives(pam_instance *c, const unsigned vr[], size_t n, const int order[],
                                      double value[]);

/* --- pam_snapshot.c: the FMU state -------------------------------------------------------------------- */

pam_status pam_get_state(pam_instance *c, void **state);
pam_status pam_set_state(pam_instance *c, const void *state);
pam_status pam_free_state(pam_instance *c, void **state);
pam_status pam_state_size(pam_instance *c, const void *state, size_t *size);
pam_status pam_serialise(pam_instance *c, const void *state, void *bytes, size_t size);
pam_status pam_deserialise(pam_instance *c, const void *bytes, size_t size, void **state);

#endif
