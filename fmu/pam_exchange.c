/* FMI 2.0 for model exchange. The model has no events of its own. */
#include <math.h>
#include <string.h>

#include "pam_instance.h"

static pam_instance *check(fmi2Component component, int phases, const char *function) {
    pam_instance *c = pam_check(component, phases, function);
    if (c && c->type != fmi2ModelExchange) {
        pam_log(c, fmi2Error, "%s is for model exchange, this instance is for co-simulation", function);
        return NULL;
    }
    return c;
}

/* Also checks the length of a vector of continuous states. */
static pam_instance *check_vector(fmi2Component component, int phases, const char *function, const void *x,
                                  size_t n) {
    pam_instance *c = check(component, phases, function);
    if (!c) return NULL;
    if (n == (size_t)c->model->nx && (x || !n)) return c;
    pam_log(c, fmi2Error, "%s: the model has %d continuous states", function, c->model->nx);
    return NULL;
}

static void copy(double *to, const double *from, size_t n) {
    if (n) memcpy(to, from, n * sizeof *to);
}

fmi2Status fmi2EnterEventMode(fmi2Component component) {
    pam_instance *c = check(component, EVENT | CONTINUOUS, "fmi2EnterEventMode");
    if (!c) return fmi2Error;
    c->core.phase = EVENT;
    return fmi2OK;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component component, fmi2EventInfo *info) {
    pam_instance *c = check(component, EVENT, "fmi2NewDiscreteStates");
    if (!c || !info) return fmi2Error;
    info->newDiscreteStatesNeeded = fmi2False;
    info->terminateSimulation = fmi2False;
    info->nominalsOfContinuousStatesChanged = fmi2False;
    info->valuesOfContinuousStatesChanged = fmi2False;
    info->nextEventTimeDefined = fmi2False;
    info->nextEventTime = 0.0;
    return fmi2OK;
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component component) {
    pam_instance *c = check(component, EVENT, "fmi2EnterContinuousTimeMode");
    if (!c) return fmi2Error;
    c->core.phase = CONTINUOUS;
    return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component component, fmi2Boolean no_set_state, fmi2Boolean *enter_event,
                                       fmi2Boolean *terminate) {
    pam_instance *c = check(component, CONTINUOUS, "fmi2CompletedIntegratorStep");
    (void)no_set_state;
    if (!c || !enter_event || !terminate) return fmi2Error;
    *enter_event = fmi2False;
    *terminate = fmi2False;
    return fmi2OK;
}

fmi2Status fmi2SetTime(fmi2Component component, fmi2Real time) {
    pam_instance *c = check(component, EVENT | CONTINUOUS, "fmi2SetTime");
    if (!c) return fmi2Error;
    if (!isfinite(time)) return pam_log(c, fmi2Error, "the time is not a finite number");
    c->core.time = time;
    pam_forget(c);
    return fmi2OK;
}

fmi2Status fmi2SetContinuousStates(fmi2Component component, const fmi2Real x[], size_t n) {
    pam_instance *c = check_vector(component, EVENT | CONTINUOUS, "fmi2SetContinuousStates", x, n);
    if (!c) return fmi2Error;
    copy(c->x, x, n);
    pam_forget(c);
    return fmi2OK;
}

fmi2Status fmi2GetDerivatives(fmi2Component component, fmi2Real derivatives[], size_t n) {
    pam_instance *c = check_vector(component, INITIALIZATION | EVENT | CONTINUOUS | TERMINATED, "fmi2GetDerivatives",
                                   derivatives, n);
    if (!c) return fmi2Error;
    copy(derivatives, pam_derivatives(c), n);
    for (size_t i = 0; i < n; i++)
        if (!isfinite(derivatives[i]))
            return pam_log(c, fmi2Discard, "the derivative of '%s' is not a finite number at time %.9g s",
                           c->model->state_names[i], c->core.time);
    return fmi2OK;
}

fmi2Status fmi2GetEventIndicators(fmi2Component component, fmi2Real indicators[], size_t n) {
    pam_instance *c = check(component, INITIALIZATION | EVENT | CONTINUOUS | TERMINATED, "fmi2GetEventIndicators");
    (void)indicators;
    if (!c) return fmi2Error;
    return n ? pam_log(c, fmi2Error, "the model has no event indicators") : fmi2OK;
}

fmi2Status fmi2GetContinuousStates(fmi2Component component, fmi2Real x[], size_t n) {
    pam_instance *c = check_vector(component, INITIALIZATION | EVENT | CONTINUOUS | TERMINATED,
                                   "fmi2GetContinuousStates", x, n);
    if (!c) return fmi2Error;
    pam_initialise_states(c);
    copy(x, c->x, n);
    return fmi2OK;
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component component, fmi2Real nominals[], size_t n) {
    pam_instance *c = check_vector(component, INITIALIZATION | EVENT | CONTINUOUS | TERMINATED,
                                   "fmi2GetNominalsOfContinuousStates", nominals, n);
    if (!c) return fmi2Error;
    for (size_t i = 0; i < n; i++) {
        double nominal = c->model->state_nominals[i];
        nominals[i] = nominal > 0.0 ? nominal : 1.0;
    }
    return fmi2OK;
}
