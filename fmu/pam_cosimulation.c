/* Co-simulation: from one communication point to the next. */
#include <math.h>
#include <string.h>

#include "pam_instance.h"

pam_status pam_set_input_derivatives(pam_instance *c, const unsigned vr[], size_t n, const int order[],
                                     const double value[]) {
    if (!pam_arrays(c, "derivatives of inputs", n, vr, order) || !pam_arrays(c, "derivatives of inputs", n, vr, value))
        return PAM_ERROR;
    for (size_t i = 0; i < n; i++) {
        const pam_variable *v = pam_lookup(c, vr[i]);
        if (!v) return PAM_ERROR;
        if (v->kind != INPUT) return pam_log(c, PAM_ERROR, "'%s' is not an input", v->name);
        if (order[i] != 1)
            return pam_log(c, PAM_ERROR, "only first derivatives of inputs are used, not order %d", order[i]);
        if (!isfinite(value[i]))
            return pam_log(c, PAM_ERROR, "the slope of '%s' is not a finite number", v->name);
        c->du[v->index] = value[i];
    }
    return PAM_OK;
}

pam_status pam_get_output_derivatives(pam_instance *c, const unsigned vr[], size_t n, const int order[],
                                      double value[]) {
    const pam_model *m = c->model;
    if (!pam_arrays(c, "derivatives of outputs", n, vr, order)
        || !pam_arrays(c, "derivatives of outputs", n, vr, value))
        return PAM_ERROR;
    if (!m->jvp) return pam_log(c, PAM_ERROR, "this model does not provide derivatives of outputs");
    memset(c->seed, 0, sizeof(double) * (size_t)(m->nx + m->nu + m->np + 1));
    if (m->nx) memcpy(c->seed, pam_derivatives(c), sizeof(double) * (size_t)m->nx);
    if (m->nu) memcpy(c->seed + m->nx, c->du, sizeof(double) * (size_t)m->nu);
    c->seed[m->nx + m->nu + m->np] = 1.0;
    pam_directional(c);
    for (size_t i = 0; i < n; i++) {
        const pam_variable *v = pam_lookup(c, vr[i]);
        if (!v) return PAM_ERROR;
        if (order[i] != 1)
            return pam_log(c, PAM_ERROR, "only first derivatives of outputs are known, not order %d", order[i]);
        if (v->kind == OUTPUT) value[i] = c->result[m->nx + v->index];
        else if (v->kind == STATE) value[i] = c->dx[v->index];
        else return pam_log(c, PAM_ERROR, "'%s' is not an output", v->name);
    }
    return PAM_OK;
}

/* Brings the instance's values to a time that the solver has reached. */
static void move_to(pam_instance *c, double time) {
    c->core.time = time;
    if (c->model->nx) pam_solver_state(&c->solver, time, c->x);
    pam_solver_input_values(&c->solver, time, c->u);
    pam_forget(c);
}

/* The solver cannot go on; the instance stays where it could get to. */
static pam_status discard(pam_instance *c) {
    c->core.phase = STEP_FAILED;
    c->core.last_step = PAM_DISCARD;
    return pam_log(c, PAM_DISCARD, "%s", c->solver.message);
}

pam_status pam_do_step(pam_instance *c, double now, double step) {
    pam_core *core = &c->core;
    double target = now + step, slack = 1e-9 * (fabs(core->time) + fabs(step));
    if (!(fabs(now - core->time) <= slack))
        return pam_log(c, PAM_ERROR, "the step starts at %.9g s but the FMU is at %.9g s", now, core->time);
    if (!(step > 0.0) || !isfinite(target))
        return pam_log(c, PAM_ERROR, "the communication step must be positive, not %g s", step);
    if (core->stop_defined && target > core->stop_time + slack)
        return pam_log(c, PAM_ERROR, "the step to %.9g s goes beyond the stop time %.9g s", target, core->stop_time);
    if (core->state_changed) pam_solver_set_state(&c->solver, core->time, c->x);
    core->state_changed = 0;
    if (pam_solver_inputs(&c->solver, core->time, c->u, c->du)) return discard(c);
    core->warned = 0;
    if (c->model->na && pam_accept(c, core->time)) return discard(c); /* the inputs may have changed */
    if (pam_solver_advance(&c->solver, target)) {
        double reached = c->model->na ? core->holds_until : core->solver.t;
        if (reached > core->time) move_to(c, reached);
        return discard(c);
    }
    move_to(c, target);
    core->last_step = core->warned ? PAM_WARNING : PAM_OK;
    return (pam_status)core->last_step;
}

/* Beside FMI, before initialization ends: whether the sensitivities are integrated in this run, as they are where nobody
 * says otherwise. Those that are not are no numbers.
 */
PAM_EXPORT void pam_follow_sensitivities(void *instance, int on) { ((pam_instance *)instance)->core.plain = !on; }

/* Beside FMI, after initialization: takes the model to an equilibrium under the present inputs. */
PAM_EXPORT int pam_settle(void *instance) {
    pam_instance *c = pam_check(instance, CO_SIMULATION, STEP, "pam_settle");
    if (!c) return PAM_ERROR;
    if (pam_solver_settle(&c->solver)) return discard(c);
    move_to(c, c->solver.s->t);
    return pam_state_holds(c);
}

/* Beside FMI, right after initialization: the run begins at an equilibrium under the inputs; ``keep``: with those start
 * values as they are that were set, and only the others so that they are at rest beside them.
 */
PAM_EXPORT int pam_settle_start(void *instance, int keep) {
    pam_instance *c = pam_check(instance, CO_SIMULATION, STEP, "pam_settle_start");
    if (!c) return PAM_ERROR;
    if (pam_solver_settle_start(&c->solver, keep ? c->x_explicit : NULL)) return discard(c);
    move_to(c, c->core.time);
    return pam_state_holds(c);
}

/* Beside FMI: steps, rejected steps, evaluations of f, Jacobians and restarts since initialization. */
PAM_EXPORT void pam_get_statistics(const void *instance, long long values[5]) {
    const pam_instance *c = instance;
    const pam_statistics *s = &c->core.solver.statistics;
    values[0] = s->steps;
    values[1] = s->rejected;
    values[2] = s->rhs;
    values[3] = s->jacobians;
    values[4] = s->restarts;
}
