/* FMI 2.0 for co-simulation. */
#include <math.h>
#include <string.h>

#include "pam_instance.h"

/* A function of co-simulation on an instance of that type. */
static pam_instance *check(fmi2Component component, int phases, const char *function) {
    pam_instance *c = pam_check(component, phases, function);
    if (c && c->type != fmi2CoSimulation) {
        pam_log(c, fmi2Error, "%s is for co-simulation, this instance is for model exchange", function);
        return NULL;
    }
    return c;
}

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference vr[], size_t n,
                                       const fmi2Integer order[], const fmi2Real value[]) {
    pam_instance *c = check(component, INSTANTIATED | INITIALIZATION | STEP, "fmi2SetRealInputDerivatives");
    if (!c || (n && (!vr || !order || !value))) return fmi2Error;
    for (size_t i = 0; i < n; i++) {
        pam_kind kind;
        int index;
        if (!pam_lookup(c, vr[i], &kind, &index)) return fmi2Error;
        if (kind != INPUT) return pam_log(c, fmi2Error, "value reference %u is not an input", vr[i]);
        if (order[i] != 1) return pam_log(c, fmi2Error, "only first derivatives of inputs are used, not order %d", order[i]);
        if (!isfinite(value[i])) return pam_log(c, fmi2Error, "the slope of input %d is not a finite number", index);
        c->du[index] = value[i];
    }
    return fmi2OK;
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference vr[], size_t n,
                                        const fmi2Integer order[], fmi2Real value[]) {
    pam_instance *c = check(component, STEP | TERMINATED, "fmi2GetRealOutputDerivatives");
    if (!c || (n && (!vr || !order || !value))) return fmi2Error;
    const pam_model *m = c->model;
    memset(c->seed, 0, sizeof(double) * (size_t)(m->nx + m->nu + m->np + 1));
    if (m->nx) memcpy(c->seed, pam_derivatives(c), sizeof(double) * (size_t)m->nx);
    if (m->nu) memcpy(c->seed + m->nx, c->du, sizeof(double) * (size_t)m->nu);
    c->seed[m->nx + m->nu + m->np] = 1.0;
    pam_directional(c);
    for (size_t i = 0; i < n; i++) {
        pam_kind kind;
        int index;
        if (!pam_lookup(c, vr[i], &kind, &index)) return fmi2Error;
        if (order[i] != 1) return pam_log(c, fmi2Error, "only first derivatives of outputs are known, not order %d", order[i]);
        if (kind == OUTPUT) value[i] = c->result[m->nx + index];
        else if (kind == STATE) value[i] = c->dx[index];
        else return pam_log(c, fmi2Error, "value reference %u is not an output", vr[i]);
    }
    return fmi2OK;
}

static fmi2Status fail(pam_instance *c) {
    c->core.phase = FAILED;
    c->core.last_step = fmi2Error;
    return fmi2Error;
}

/* Brings the instance's values to a time that the solver has reached. */
static void move_to(pam_instance *c, double time) {
    c->core.time = time;
    if (c->model->nx) pam_solver_state(&c->solver, time, c->x);
    pam_solver_input_values(&c->solver, time, c->u);
    pam_forget(c);
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real now, fmi2Real step, fmi2Boolean no_set_state) {
    pam_instance *c = check(component, STEP, "fmi2DoStep");
    (void)no_set_state;
    if (!c) return fmi2Error;
    pam_core *core = &c->core;
    double target = now + step, slack = 1e-9 * (fabs(core->time) + fabs(step));
    if (!(fabs(now - core->time) <= slack))
        return pam_log(c, fmi2Error, "fmi2DoStep starts at %.9g s but the FMU is at %.9g s", now, core->time);
    if (!(step > 0.0) || !isfinite(target))
        return pam_log(c, fmi2Error, "the communication step must be positive, not %g s", step);
    if (core->stop_defined && target > core->stop_time + slack)
        return pam_log(c, fmi2Error, "fmi2DoStep to %.9g s goes beyond the stop time %.9g s", target, core->stop_time);
    if (core->state_changed) pam_solver_set_state(&c->solver, core->time, c->x);
    core->state_changed = 0;
    if (pam_solver_inputs(&c->solver, core->time, c->u, c->du)) {
        pam_log(c, fmi2Error, "%s", c->solver.message);
        return fail(c);
    }
    if (pam_solver_advance(&c->solver, target)) {
        if (core->solver.t > core->time) move_to(c, core->solver.t);
        pam_log(c, fmi2Error, "%s", c->solver.message);
        return fail(c);
    }
    move_to(c, target);
    core->last_step = fmi2OK;
    return fmi2OK;
}

fmi2Status fmi2CancelStep(fmi2Component component) {
    pam_instance *c = check(component, ANY, "fmi2CancelStep");
    return c ? pam_log(c, fmi2Error, "fmi2CancelStep: no step runs in the background") : fmi2Error;
}

fmi2Status fmi2GetStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Status *value) {
    pam_instance *c = check(component, ANY, "fmi2GetStatus");
    if (!c || !value) return fmi2Error;
    if (kind != fmi2DoStepStatus) return fmi2Discard;
    *value = (fmi2Status)c->core.last_step;
    return fmi2OK;
}

fmi2Status fmi2GetRealStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value) {
    pam_instance *c = check(component, ANY, "fmi2GetRealStatus");
    if (!c || !value) return fmi2Error;
    if (kind != fmi2LastSuccessfulTime) return fmi2Discard;
    *value = c->core.time;
    return fmi2OK;
}

fmi2Status fmi2GetIntegerStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Integer *value) {
    (void)kind;
    (void)value;
    return check(component, ANY, "fmi2GetIntegerStatus") ? fmi2Discard : fmi2Error;
}

fmi2Status fmi2GetBooleanStatus(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value) {
    pam_instance *c = check(component, ANY, "fmi2GetBooleanStatus");
    if (!c || !value) return fmi2Error;
    if (kind != fmi2Terminated) return fmi2Discard;
    *value = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2GetStringStatus(fmi2Component component, const fmi2StatusKind kind, fmi2String *value) {
    (void)kind;
    (void)value;
    return check(component, ANY, "fmi2GetStringStatus") ? fmi2Discard : fmi2Error;
}

/* Beside FMI: steps, rejected steps, evaluations of f, Jacobians and restarts since initialization. */
FMI2_Export void pam_get_statistics(fmi2Component component, long long values[5]) {
    const pam_instance *c = component;
    const pam_statistics *s = &c->core.solver.statistics;
    values[0] = s->steps;
    values[1] = s->rejected;
    values[2] = s->rhs;
    values[3] = s->jacobians;
    values[4] = s->restarts;
}
