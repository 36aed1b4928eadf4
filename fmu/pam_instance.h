/* One instance of the FMU: what fmi2Component points to. */
#ifndef PAM_INSTANCE_H
#define PAM_INSTANCE_H

#include "fmi2Functions.h"
#include "pam_solver.h"

/* The states of FMI 2.0, figures 6 and 11; bits, so that a set of them is a mask. */
enum {
    INSTANTIATED = 1,
    INITIALIZATION = 2,
    STEP = 4, /* co-simulation: between steps */
    EVENT = 8,
    CONTINUOUS = 16,
    TERMINATED = 32,
    FAILED = 64,
    ANY = 127,
};

/* Value references are one contiguous table in this order. */
typedef enum { STATE, DERIVATIVE, INPUT, OUTPUT, PARAMETER, LOCAL, TIME } pam_kind;

/* Plain data: with the block of doubles at pam_instance.saved and the histories this is the whole FMU state. */
typedef struct {
    int phase;
    int state_changed;  /* co-simulation: x was set since the last step */
    int initial_known;  /* x holds x0(p) in the initialization phases */
    int last_step;      /* fmi2Status of the last fmi2DoStep */
    int stop_defined;
    double time, start_time, stop_time, tolerance;
    pam_solver_scalars solver;
} pam_core;

typedef struct {
    const pam_model *model;
    fmi2CallbackFunctions callbacks;
    fmi2Type type;
    char *name;
    int logging;
    pam_core core;
    size_t saved_size; /* doubles in saved */
    double *saved;
    double *x, *u, *du, *x_explicit; /* in saved: now; x_explicit: 1 where the user set the start value */
    pam_solver solver;
    double *dx, *y, *w;              /* results at the present time */
    double *d, *dd;                  /* delayed inputs at the present time and their slopes */
    double *seed, *result;           /* nx + nu + np + 1; nx + ny + nw + nx */
    double *seed_d, *rate_d;         /* nd: the seed that follows for delayed inputs; delays along the seed */
    int dx_known, y_known, w_known;
} pam_instance;

/* A log message of the instance's own; returns status. */
fmi2Status pam_log(pam_instance *c, fmi2Status status, const char *format, ...);

/* Null unless c is an instance in one of the phases; otherwise the call is logged as out of order. */
pam_instance *pam_check(fmi2Component c, int phases, const char *function);

/* The kind and index of a value reference; 0 with a log message where there is none. */
int pam_lookup(pam_instance *c, fmi2ValueReference vr, pam_kind *kind, int *index);

void pam_reset(pam_instance *c);
void pam_forget(pam_instance *c);            /* results must be evaluated again */
void pam_initialise_states(pam_instance *c); /* x = x0(p) where not set explicitly */
const double *pam_derivatives(pam_instance *c);
const double *pam_outputs(pam_instance *c);
const double *pam_locals(pam_instance *c);

/* Derivatives along a seed over (x, u, p, t), to result (dx, y, w); seeds of calculated start values follow
 * from the parameters in the initialization phases. */
void pam_directional(pam_instance *c);

#endif
