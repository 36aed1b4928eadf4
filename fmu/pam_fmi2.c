/* FMI 2.0: each function checks the phase and asks the core. */
#include <string.h>

#include "pam_instance.h"

/* The importer's header; that of the release beside this file where there is none. */
#if defined __has_include
#if __has_include(<fmi2Functions.h>)
#include <fmi2Functions.h>
#define PAM_HAS_FMI_HEADER
#endif
#endif
#ifndef PAM_HAS_FMI_HEADER
#include "fmi2Functions.h"
#endif

/* The instance c behind the component, or the end of the function. */
#define ENTER(kinds, phases)                                              \
    pam_instance *c = pam_check(component, kinds, phases, __func__);      \
    if (!c) return fmi2Error

#define ASK(kinds, phases, call)        \
    do {                                \
        ENTER(kinds, phases);           \
        return (fmi2Status)(call);      \
    } while (0)

const char *fmi2GetTypesPlatform(void) { return fmi2TypesPlatform; }

const char *fmi2GetVersion(void) { return fmi2Version; }

/* --- the life of an instance ---------------------------------------------------------------------------- */

static void log_message(const pam_host *host, const char *instance, pam_status status, const char *category,
                        const char *message) {
    char format[2 * PAM_MESSAGE], *to = format;
    for (const char *from = message; *from; from++) {
        if (*from == '%' || *from == '#') *to++ = *from; /* FMI 2.0.4, section 2.1.5: for printf, and a reference */
        *to++ = *from;
    }
    *to = '\0';
    fmi2CallbackLogger logger = (fmi2CallbackLogger)host->logger;
    logger(host->environment, instance, (fmi2Status)status, category, format);
}

fmi2Component fmi2Instantiate(fmi2String name, fmi2Type type, fmi2String guid, fmi2String resources,
                              const fmi2CallbackFunctions *f, fmi2Boolean visible, fmi2Boolean logging) {
    (void)resources;
    (void)visible;
    if (!f || !f->allocateMemory || !f->freeMemory) return NULL;
    const pam_host host = {{f->allocateMemory, f->freeMemory}, f->componentEnvironment, (void (*)(void))f->logger,
                           log_message};
    pam_instance *c = pam_create(&host, type == fmi2ModelExchange ? MODEL_EXCHANGE : CO_SIMULATION, name, guid);
    if (c && !logging) c->logging = LOG_STATUS; /* what goes wrong is always reported */
    return c;
}

void fmi2FreeInstance(fmi2Component component) {
    if (component) pam_free(component);
}

fmi2Status fmi2SetDebugLogging(fmi2Component component, fmi2Boolean on, size_t n, const fmi2String categories[]) {
    ASK(ANY_KIND, ANY, pam_set_logging(c, on, n, categories));
}

fmi2Status fmi2SetupExperiment(fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance,
                               fmi2Real start, fmi2Boolean stop_defined, fmi2Real stop) {
    ASK(ANY_KIND, INSTANTIATED, pam_set_experiment(c, tolerance_defined, tolerance, start, stop_defined, stop));
}

fmi2Status fmi2EnterInitializationMode(fmi2Component component) {
    ASK(ANY_KIND, INSTANTIATED, pam_enter_initialization(c));
}

fmi2Status fmi2ExitInitializationMode(fmi2Component component) {
    ASK(ANY_KIND, INITIALIZATION, pam_exit_initialization(c));
}

fmi2Status fmi2Terminate(fmi2Component component) { ASK(ANY_KIND, RUNNING | STEP_FAILED, pam_terminate(c)); }

fmi2Status fmi2Reset(fmi2Component component) { ASK(ANY_KIND, ANY, pam_reset(c)); }

/* --- values --------------------------------------------------------------------------------------------- */

fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference vr[], size_t n, fmi2Real value[]) {
    ASK(ANY_KIND, ANY, pam_get(c, vr, n, value));
}

fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference vr[], size_t n, const fmi2Real value[]) {
    ASK(ANY_KIND, INSTANTIATED | INITIALIZATION | RUNNING, pam_set(c, vr, n, value));
}

/* The model has real variables alone. */
#define NO_VARIABLES(function, type)                                                                       \
    fmi2Status function(fmi2Component component, const fmi2ValueReference vr[], size_t n, type value[]) {   \
        ENTER(ANY_KIND, ANY);                                                                              \
        (void)vr;                                                                                          \
        (void)value;                                                                                       \
        if (!n) return fmi2OK;                                                                             \
        return (fmi2Status)pam_log(c, PAM_ERROR, #function ": all variables of this FMU are of type Real"); \
    }
NO_VARIABLES(fmi2GetInteger, fmi2Integer)
NO_VARIABLES(fmi2GetBoolean, fmi2Boolean)
NO_VARIABLES(fmi2GetString, fmi2String)
NO_VARIABLES(fmi2SetInteger, const fmi2Integer)
NO_VARIABLES(fmi2SetBoolean, const fmi2Boolean)
NO_VARIABLES(fmi2SetString, const fmi2String)

fmi2Status fmi2GetDirectionalDerivative(fmi2Component component, const fmi2ValueReference unknown[],
                                        size_t n_unknown, const fmi2ValueReference known[], size_t n_known,
                                        const fmi2Real seed[], fmi2Real sensitivity[]) {
    ASK(ANY_KIND, READABLE, pam_directional_derivative(c, unknown, n_unknown, known, n_known, seed, sensitivity));
}

/* --- the FMU state -------------------------------------------------------------------------------------- */

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state) {
    ASK(ANY_KIND, ANY & ~FAILED, pam_get_state(c, state));
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
    ASK(ANY_KIND, ANY, pam_set_state(c, state));
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state) {
    ASK(ANY_KIND, ANY, pam_free_state(c, state));
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size) {
    ASK(ANY_KIND, ANY, pam_state_size(c, state, size));
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    ASK(ANY_KIND, ANY, pam_serialise(c, state, bytes, size));
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
    ASK(ANY_KIND, ANY, pam_deserialise(c, bytes, size, state));
}

/* --- model exchange ------------------------------------------------------------------------------------- */

fmi2Status fmi2EnterEventMode(fmi2Component component) {
    ENTER(MODEL_EXCHANGE, EVENT | CONTINUOUS);
    c->core.phase = EVENT;
    return fmi2OK;
}

fmi2Status fmi2NewDiscreteStates(fmi2Component component, fmi2EventInfo *info) {
    ENTER(MODEL_EXCHANGE, EVENT);
    if (!pam_arrays(c, __func__, 1, info, info)) return fmi2Error;
    memset(info, 0, sizeof *info); /* every flag fmi2False, no next event */
    return (fmi2Status)pam_state_holds(c);
}

fmi2Status fmi2EnterContinuousTimeMode(fmi2Component component) {
    ENTER(MODEL_EXCHANGE, EVENT);
    c->core.phase = CONTINUOUS;
    return fmi2OK;
}

fmi2Status fmi2CompletedIntegratorStep(fmi2Component component, fmi2Boolean no_set_state, fmi2Boolean *enter_event,
                                       fmi2Boolean *terminate) {
    ENTER(MODEL_EXCHANGE, CONTINUOUS);
    (void)no_set_state;
    if (!pam_arrays(c, __func__, 1, enter_event, terminate)) return fmi2Error;
    *enter_event = fmi2False;
    *terminate = fmi2False;
    return (fmi2Status)pam_state_holds(c);
}

fmi2Status fmi2SetTime(fmi2Component component, fmi2Real time) {
    ASK(MODEL_EXCHANGE, EVENT | CONTINUOUS, pam_set_time(c, time));
}

fmi2Status fmi2SetContinuousStates(fmi2Component component, const fmi2Real x[], size_t n) {
    ASK(MODEL_EXCHANGE, EVENT | CONTINUOUS, pam_set_states(c, x, n));
}

fmi2Status fmi2GetDerivatives(fmi2Component component, fmi2Real derivatives[], size_t n) {
    ASK(MODEL_EXCHANGE, READABLE, pam_get_rates(c, derivatives, n));
}

fmi2Status fmi2GetEventIndicators(fmi2Component component, fmi2Real indicators[], size_t n) {
    (void)indicators;
    ASK(MODEL_EXCHANGE, READABLE, pam_get_event_indicators(c, n));
}

fmi2Status fmi2GetContinuousStates(fmi2Component component, fmi2Real x[], size_t n) {
    ASK(MODEL_EXCHANGE, READABLE, pam_get_states(c, x, n));
}

fmi2Status fmi2GetNominalsOfContinuousStates(fmi2Component component, fmi2Real nominals[], size_t n) {
    ASK(MODEL_EXCHANGE, READABLE, pam_get_nominals(c, nominals, n));
}

/* --- co-simulation -------------------------------------------------------------------------------------- */

fmi2Status fmi2SetRealInputDerivatives(fmi2Component component, const fmi2ValueReference vr[], size_t n,
                                       const fmi2Integer order[], const fmi2Real value[]) {
    ASK(CO_SIMULATION, INSTANTIATED | INITIALIZATION | STEP, pam_set_input_derivatives(c, vr, n, order, value));
}

fmi2Status fmi2GetRealOutputDerivatives(fmi2Component component, const fmi2ValueReference vr[], size_t n,
                                        const fmi2Integer order[], fmi2Real value[]) {
    ASK(CO_SIMULATION, STEP | STEP_FAILED | TERMINATED, pam_get_output_derivatives(c, vr, n, order, value));
}

fmi2Status fmi2DoStep(fmi2Component component, fmi2Real now, fmi2Real step, fmi2Boolean no_set_state) {
    (void)no_set_state;
    ASK(CO_SIMULATION, STEP, pam_do_step(c, now, step));
}

fmi2Status fmi2CancelStep(fmi2Component component) {
    ASK(CO_SIMULATION, ANY, pam_log(c, PAM_ERROR, "fmi2CancelStep: no step runs in the background"));
}

/* A status that the instance can give, of the kind asked for; fmi2Discard where it cannot. */
#define STATUS(function, type, known, found)                                                \
    fmi2Status function(fmi2Component component, const fmi2StatusKind kind, type *value) {   \
        ENTER(CO_SIMULATION, ANY);                                                          \
        if (!pam_arrays(c, __func__, 1, value, value)) return fmi2Error;                    \
        if (!(known)) return fmi2Discard;                                                   \
        *value = (found);                                                                   \
        return fmi2OK;                                                                      \
    }
STATUS(fmi2GetStatus, fmi2Status, kind == fmi2DoStepStatus, (fmi2Status)c->core.last_step)
STATUS(fmi2GetRealStatus, fmi2Real, kind == fmi2LastSuccessfulTime, c->core.time)
STATUS(fmi2GetBooleanStatus, fmi2Boolean, kind == fmi2Terminated, fmi2False)
STATUS(fmi2GetIntegerStatus, fmi2Integer, ((void)kind, 0), 0)
STATUS(fmi2GetStringStatus, fmi2String, ((void)kind, 0), NULL)
