/* The adaptive stiff solver of the co-simulation FMU.
 *
 * Its steps do not end at communication points: a step may reach beyond the time asked for, on the assumption
 * that the inputs go on as they are, and values in between come from the dense output. Where an input, its
 * slope or a state changes instead, the rest of the pending step is dropped and the solver starts again from
 * exactly that time. A delayed input changes at times known beforehand: steps end there, and a pending step
 * that was made before such a change was known is used up to there only.
 *
 * It integrates the first nc states; sensitivities follow them in the same steps, see pam_sensitivity.h.
 */
#ifndef PAM_SOLVER_H
#define PAM_SOLVER_H

#include <stddef.h>

#include "pam_history.h"
#include "pam_model.h"
#include "pam_sensitivity.h"

enum { PAM_MESSAGE = 1024 };

typedef struct {
    long long steps, rejected, rhs, jacobians, restarts;
} pam_statistics;

/* Scalars of the solver; plain data, saved and restored as a whole. */
typedef struct {
    double t;              /* [s] start of the pending step */
    double h;              /* [s] its length; 0: there is none */
    double until;          /* [s] what it may be used for: its end, or the next change of a delayed input */
    double h_next;         /* [s] proposed length of the step after it; 0: to be estimated */
    double input_time;     /* [s] the inputs are u + du (time - input_time) */
    double error_previous; /* error norm of the last accepted step, for the PI controller */
    double rtol;
    int estimate;          /* 1: the next step begins with a jump, its length must be checked */
    int truncated;         /* 1: the pending step may not be used to its end */
    int plain;             /* 1: the sensitivities are not followed; they are no numbers then */
    pam_statistics statistics;
} pam_solver_scalars;

typedef struct pam_solver {
    const pam_model *model;
    pam_solver_scalars *s;
    /* saved with the scalars */
    double *x, *x1, *dense; /* nx, nx, 3 nc: start, end and shape of the pending step */
    double *u, *du;         /* nu: the inputs the pending step assumes */
    double *p;              /* np */
    double *scale;          /* nc: absolute scale of each state */
    double *delay;          /* nd [s] */
    pam_history *past;      /* nd */
    pam_memory memory;      /* for the past, which grows */
    pam_sensitivity sensitivity;
    /* scratch */
    double *k, *f, *ft, *stage, *u_stage, *d, *dd, *d_stage, *jac, *lu, *rhs, *w;
    int *pivot;
    long long *iw;
    int starting;              /* what vanishes at the start is sought, not a rest of all that moves */
    const double *held;        /* nc: not 0 where a state keeps its value while the others settle; or null */
    char message[PAM_MESSAGE]; /* why pam_solver_advance failed */
    /* Asked for each time up to which the solution is about to be used, in order; 1 with a message: no further.
     * May be null. The solution is known at all times since the one before. */
    int (*accept)(void *owner, double t);
    void *owner;
} pam_solver;

enum { PAM_MAX_STEPS_PER_CALL = 100000 };

/* Numbers of doubles, and of integers for pivots, that a solver needs. */
size_t pam_solver_pivots(const pam_model *m);
size_t pam_solver_saved_size(const pam_model *m);
size_t pam_solver_scratch_size(const pam_model *m);

/* Lays the solver's arrays out in two blocks of those sizes; integer work space is given by the caller. */
void pam_solver_bind(pam_solver *v, const pam_model *m, pam_solver_scalars *s, double *saved, double *scratch,
                     int *pivot, long long *iw);

/* Begins at time t with state x (already in v->x), inputs u with slope du, and parameters in v->p.
 * Returns 0, or 1 with a message.
 */
int pam_solver_begin(pam_solver *v, double t, const double *u, const double *du, double rtol);

/* Leaves the sensitivities out of the run that has begun. */
void pam_solver_leave_sensitivities(pam_solver *v);

/* Writes to the sensitivities among all states, or among their rates, that they are no numbers. */
void pam_solver_no_numbers(const pam_model *m, double *x);

/* Tells the solver the inputs from time t on; drops the pending step where they are not as assumed.
 * Returns 0, or 1 with a message.
 */
int pam_solver_inputs(pam_solver *v, double t, const double *u, const double *du);

/* Replaces the state at time t. */
void pam_solver_set_state(pam_solver *v, double t, const double *x);

/* Makes the solution known up to time t. Returns 0, or 1 with a message. */
int pam_solver_advance(pam_solver *v, double t);

/* Goes from the state where it has begun to an equilibrium under the inputs, whose slopes must be zero; with its
 * sensitivities. Returns 0, or 1 with a message. In pam_equilibrium.c.
 */
int pam_solver_settle(pam_solver *v);

/* Likewise at the start itself, before any step, with delayed inputs as they are there. Where ``held`` is not 0 (nc, or
 * null) a state keeps its value and its sensitivities.
 */
int pam_solver_settle_start(pam_solver *v, const double *held);

/* Turns what the rates do along a seed of all that is known (nc) into what the states do that have settled beside it; 0
 * for those that are held. After pam_solver_settle_start.
 */
void pam_solver_rest_along(pam_solver *v, const double *held, double *along);

/* The first nc states at a time the pending step covers. */
void pam_solver_core_state(const pam_solver *v, double t, double *x);

/* The state at a time the pending step covers, with the sensitivities. */
void pam_solver_state(const pam_solver *v, double t, double *x);

/* The inputs at time t as the solver assumes them. */
void pam_solver_input_values(const pam_solver *v, double t, double *u);

/* The delayed inputs and their slopes at a time that the solution is known for. */
void pam_solver_delayed_values(const pam_solver *v, double t, double *d, double *dd);

#endif
