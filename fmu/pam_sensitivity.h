/* Forward sensitivities S = dx/ds of the states with respect to ns chosen parameters s.
 *
 * They obey the linear equation S' = J(t) S + F(t), J = df/dx, F = df/ds, along the solution. Over each step that
 * the solver has accepted it is solved by collocation at the three nodes of Radau IIA (order 5, stiffly accurate;
 * Hairer and Wanner, Solving ODEs II, IV.5) with J and F exact at the nodes, where the state is known from the
 * dense output. The steps are the solver's: they follow the error of the state. States on which others depend, but
 * not the other way round, as those of a drive before a muscle, are solved for before these, block after block.
 */
#ifndef PAM_SENSITIVITY_H
#define PAM_SENSITIVITY_H

#include <stddef.h>

#include "pam_model.h"

enum { PAM_NODES = 3 };

typedef struct {
    double *nodes;         /* saved; 2 nc ns: S at the first two nodes of the pending step */
    double *jac, *forcing; /* per node, nc x nc by columns and nc x ns by rows */
    double *matrix, *rhs;  /* of a block of k states 3 k x 3 k by columns, 3 k x ns by rows; k is nc at most */
    int *pivot;            /* 3 nc */
} pam_sensitivity;

struct pam_solver;

size_t pam_sensitivity_saved_size(const pam_model *m);
size_t pam_sensitivity_scratch_size(const pam_model *m);

/* Takes the arrays from the ends of the solver's blocks. */
void pam_sensitivity_bind(pam_sensitivity *s, const pam_model *m, double *saved, double *scratch, int *pivot);

/* Brings S over the step the solver has just accepted. Returns 0, or 1 with the solver's message set. */
int pam_sensitivity_step(struct pam_solver *v);

/* S, nc x ns by rows, at a time the pending step covers. */
void pam_sensitivity_state(const struct pam_solver *v, double t, double *sensitivities);

#endif
