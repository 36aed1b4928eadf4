/* FMI 3.0: each function checks the phase and the lengths and asks the core. All variables are scalar Float64;
 * there are no clocks, no structural parameters, no events and no scheduled execution.
 */
#include <stdlib.h>

#include "pam_instance.h"

/* The importer's header; that of the release beside this file where there is none. */
#if defined __has_include
#if __has_include(<fmi3Functions.h>)
#include <fmi3Functions.h>
#define PAM_HAS_FMI_HEADER
#endif
#endif
#ifndef PAM_HAS_FMI_HEADER
#include "fmi3Functions.h"
#endif

/* The instance c, or the end of the function. */
#define ENTER(kinds, phases)                                             \
    pam_instance *c = pam_check(instance, kinds, phases, __func__);      \
    if (!c) return fmi3Error

#define ASK(kinds, phases, call)        \
    do {                                \
        ENTER(kinds, phases);           \
        return (fmi3Status)(call);      \
    } while (0)

/* Scalars: as many values as references. */
static pam_status lengths(const pam_instance *c, const char *function, size_t references, size_t values) {
    if (references == values) return PAM_OK;
    return pam_log(c, PAM_ERROR, "%s: %zu values are needed for %zu variables, not %zu", function, references,
                   references, values);
}

static fmi3Status refuse(const pam_instance *c, const char *function, const char *why) {
    return (fmi3Status)pam_log(c, PAM_ERROR, "%s: %s", function, why);
}

const char *fmi3GetVersion(void) { return fmi3Version; }

/* --- the life of an instance ---------------------------------------------------------------------------- */

static void log_message(const pam_host *host, const char *instance, pam_status status, const char *category,
                        const char *message) {
    (void)instance;
    ((fmi3LogMessageCallback)host->logger)(host->environment, (fmi3Status)status, category, message);
}

static fmi3Instance create(int kind, fmi3String name, fmi3String token, fmi3Boolean logging,
                           fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger, const char *why_not) {
    const pam_host host = {{calloc, free}, environment, (void (*)(void))logger, log_message};
    if (why_not) {
        if (logger && logging) logger(environment, fmi3Error, "logStatusError", why_not);
        return NULL;
    }
    pam_host quiet = host;
    if (!logging) quiet.logger = NULL;
    pam_instance *c = pam_create(&quiet, kind, name, token);
    if (!c) return NULL;
    c->host = host;
    c->logging = logging ? LOG_ALL : 0;
    return c;
}

fmi3Instance fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources,
                                          fmi3Boolean visible, fmi3Boolean logging,
                                          fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger) {
    (void)resources;
    (void)visible;
    return create(MODEL_EXCHANGE, name, token, logging, environment, logger, NULL);
}

fmi3Instance fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources,
                                         fmi3Boolean visible, fmi3Boolean logging, fmi3Boolean event_mode_used,
                                         fmi3Boolean early_return_allowed,
                                         const fmi3ValueReference intermediate_variables[],
                                         size_t n_intermediate_variables, fmi3InstanceEnvironment environment,
                                         fmi3LogMessageCallback logger,
                                         fmi3IntermediateUpdateCallback intermediate_update) {
    (void)resources;
    (void)visible;
    (void)early_return_allowed;
    (void)intermediate_variables;
    (void)intermediate_update;
    const char *why_not = event_mode_used ? "this FMU has no event mode: eventModeUsed must be false"
                        : n_intermediate_variables ? "this FMU provides no intermediate update" : NULL;
    return create(CO_SIMULATION, name, token, logging, environment, logger, why_not);
}

fmi3Instance fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources,
                                               fmi3Boolean visible, fmi3Boolean logging,
                                               fmi3InstanceEnvironment environment, fmi3LogMessageCallback logger,
                                               fmi3ClockUpdateCallback clock_update,
                                               fmi3LockPreemptionCallback lock,
                                               fmi3UnlockPreemptionCallback unlock) {
    (void)resources;
    (void)visible;
    (void)clock_update;
    (void)lock;
    (void)unlock;
    return create(0, name, token, logging, environment, logger, "this FMU has no scheduled execution");
}

void fmi3FreeInstance(fmi3Instance instance) {
    if (instance) pam_free(instance);
}

fmi3Status fmi3SetDebugLogging(fmi3Instance instance, fmi3Boolean on, size_t n, const fmi3String categories[]) {
    ASK(ANY_KIND, ANY, pam_set_logging(c, on, n, categories));
}

fmi3Status fmi3EnterInitializationMode(fmi3Instance instance, fmi3Boolean tolerance_defined, fmi3Float64 tolerance,
                                       fmi3Float64 start, fmi3Boolean stop_defined, fmi3Float64 stop) {
    ENTER(ANY_KIND, INSTANTIATED);
    pam_status status = pam_set_experiment(c, tolerance_defined, tolerance, start, stop_defined, stop);
    return (fmi3Status)(status == PAM_OK ? pam_enter_initialization(c) : status);
}

fmi3Status fmi3ExitInitializationMode(fmi3Instance instance) {
    ASK(ANY_KIND, INITIALIZATION, pam_exit_initialization(c));
}

fmi3Status fmi3EnterConfigurationMode(fmi3Instance instance) {
    ENTER(ANY_KIND, ANY);
    return refuse(c, __func__, "the model has no structural parameters");
}

fmi3Status fmi3ExitConfigurationMode(fmi3Instance instance) {
    ENTER(ANY_KIND, ANY);
    return refuse(c, __func__, "the model has no structural parameters");
}

fmi3Status fmi3Terminate(fmi3Instance instance) { ASK(ANY_KIND, RUNNING | STEP_FAILED, pam_terminate(c)); }

fmi3Status fmi3Reset(fmi3Instance instance) { ASK(ANY_KIND, ANY, pam_reset(c)); }

/* --- values --------------------------------------------------------------------------------------------- */

fmi3Status fmi3GetFloat64(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, fmi3Float64 values[],
                          size_t n_values) {
    ENTER(ANY_KIND, ANY);
    if (lengths(c, __func__, n, n_values)) return fmi3Error;
    return (fmi3Status)pam_get(c, vr, n, values);
}

fmi3Status fmi3SetFloat64(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                          const fmi3Float64 values[], size_t n_values) {
    ENTER(ANY_KIND, INSTANTIATED | INITIALIZATION | RUNNING);
    if (lengths(c, __func__, n, n_values)) return fmi3Error;
    return (fmi3Status)pam_set(c, vr, n, values);
}

#define OTHER_TYPE(n) return (n) ? refuse(c, __func__, "all variables of this FMU are of type Float64") : fmi3OK

#define NO_VARIABLES(type)                                                                                   \
    fmi3Status fmi3Get##type(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,                  \
                             fmi3##type values[], size_t n_values) {                                         \
        ENTER(ANY_KIND, ANY);                                                                                \
        (void)vr, (void)values, (void)n_values;                                                              \
        OTHER_TYPE(n);                                                                                       \
    }                                                                                                        \
    fmi3Status fmi3Set##type(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,                  \
                             const fmi3##type values[], size_t n_values) {                                   \
        ENTER(ANY_KIND, ANY);                                                                                \
        (void)vr, (void)values, (void)n_values;                                                              \
        OTHER_TYPE(n);                                                                                       \
    }
NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(Int32)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

fmi3Status fmi3GetBinary(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, size_t sizes[],
                         fmi3Binary values[], size_t n_values) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)sizes, (void)values, (void)n_values;
    OTHER_TYPE(n);
}

fmi3Status fmi3SetBinary(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, const size_t sizes[],
                         const fmi3Binary values[], size_t n_values) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)sizes, (void)values, (void)n_values;
    OTHER_TYPE(n);
}

/* --- derivatives and dependencies ----------------------------------------------------------------------- */

fmi3Status fmi3GetDirectionalDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[],
                                        size_t n_unknowns, const fmi3ValueReference knowns[], size_t n_knowns,
                                        const fmi3Float64 seed[], size_t n_seed, fmi3Float64 sensitivity[],
                                        size_t n_sensitivity) {
    ENTER(ANY_KIND, READABLE);
    if (lengths(c, __func__, n_knowns, n_seed) || lengths(c, __func__, n_unknowns, n_sensitivity)) return fmi3Error;
    return (fmi3Status)pam_directional_derivative(c, unknowns, n_unknowns, knowns, n_knowns, seed, sensitivity);
}

fmi3Status fmi3GetAdjointDerivative(fmi3Instance instance, const fmi3ValueReference unknowns[], size_t n_unknowns,
                                    const fmi3ValueReference knowns[], size_t n_knowns, const fmi3Float64 seed[],
                                    size_t n_seed, fmi3Float64 sensitivity[], size_t n_sensitivity) {
    ENTER(ANY_KIND, READABLE);
    if (lengths(c, __func__, n_unknowns, n_seed) || lengths(c, __func__, n_knowns, n_sensitivity)) return fmi3Error;
    return (fmi3Status)pam_adjoint_derivative(c, unknowns, n_unknowns, knowns, n_knowns, seed, sensitivity);
}

static const char *const NO_DEPENDENCIES = "the model description tells the dependencies; they never change";

fmi3Status fmi3GetNumberOfVariableDependencies(fmi3Instance instance, fmi3ValueReference vr, size_t *n) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)n;
    return refuse(c, __func__, NO_DEPENDENCIES);
}

fmi3Status fmi3GetVariableDependencies(fmi3Instance instance, fmi3ValueReference dependent, size_t elements[],
                                       fmi3ValueReference independents[], size_t element_indices[],
                                       fmi3DependencyKind kinds[], size_t n) {
    ENTER(ANY_KIND, ANY);
    (void)dependent, (void)elements, (void)independents, (void)element_indices, (void)kinds, (void)n;
    return refuse(c, __func__, NO_DEPENDENCIES);
}

/* --- the FMU state -------------------------------------------------------------------------------------- */

fmi3Status fmi3GetFMUState(fmi3Instance instance, fmi3FMUState *state) {
    ASK(ANY_KIND, ANY & ~FAILED, pam_get_state(c, state));
}

fmi3Status fmi3SetFMUState(fmi3Instance instance, fmi3FMUState state) {
    ASK(ANY_KIND, ANY, pam_set_state(c, state));
}

fmi3Status fmi3FreeFMUState(fmi3Instance instance, fmi3FMUState *state) {
    ASK(ANY_KIND, ANY, pam_free_state(c, state));
}

fmi3Status fmi3SerializedFMUStateSize(fmi3Instance instance, fmi3FMUState state, size_t *size) {
    ASK(ANY_KIND, ANY, pam_state_size(c, state, size));
}

fmi3Status fmi3SerializeFMUState(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size) {
    ASK(ANY_KIND, ANY, pam_serialise(c, state, bytes, size));
}

fmi3Status fmi3DeserializeFMUState(fmi3Instance instance, const fmi3Byte bytes[], size_t size,
                                   fmi3FMUState *state) {
    ASK(ANY_KIND, ANY, pam_deserialise(c, bytes, size, state));
}

/* --- clocks: there are none ----------------------------------------------------------------------------- */

#define NO_CLOCKS(n) return (n) ? refuse(c, __func__, "the model has no clocks") : fmi3OK

fmi3Status fmi3GetClock(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, fmi3Clock values[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)values;
    NO_CLOCKS(n);
}

fmi3Status fmi3SetClock(fmi3Instance instance, const fmi3ValueReference vr[], size_t n, const fmi3Clock values[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)values;
    NO_CLOCKS(n);
}

fmi3Status fmi3GetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                  fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)intervals, (void)qualifiers;
    NO_CLOCKS(n);
}

fmi3Status fmi3GetIntervalFraction(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                   fmi3UInt64 counters[], fmi3UInt64 resolutions[],
                                   fmi3IntervalQualifier qualifiers[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)counters, (void)resolutions, (void)qualifiers;
    NO_CLOCKS(n);
}

fmi3Status fmi3GetShiftDecimal(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                               fmi3Float64 shifts[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)shifts;
    NO_CLOCKS(n);
}

fmi3Status fmi3GetShiftFraction(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                fmi3UInt64 counters[], fmi3UInt64 resolutions[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)counters, (void)resolutions;
    NO_CLOCKS(n);
}

fmi3Status fmi3SetIntervalDecimal(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                  const fmi3Float64 intervals[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)intervals;
    NO_CLOCKS(n);
}

fmi3Status fmi3SetIntervalFraction(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                   const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)counters, (void)resolutions;
    NO_CLOCKS(n);
}

fmi3Status fmi3SetShiftDecimal(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                               const fmi3Float64 shifts[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)shifts;
    NO_CLOCKS(n);
}

fmi3Status fmi3SetShiftFraction(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]) {
    ENTER(ANY_KIND, ANY);
    (void)vr, (void)counters, (void)resolutions;
    NO_CLOCKS(n);
}

fmi3Status fmi3ActivateModelPartition(fmi3Instance instance, fmi3ValueReference clock, fmi3Float64 time) {
    ENTER(ANY_KIND, ANY);
    (void)clock, (void)time;
    return refuse(c, __func__, "this FMU has no scheduled execution");
}

/* --- events --------------------------------------------------------------------------------------------- */

fmi3Status fmi3EnterEventMode(fmi3Instance instance) {
    ENTER(MODEL_EXCHANGE, CONTINUOUS);
    c->core.phase = EVENT;
    return fmi3OK;
}

fmi3Status fmi3EvaluateDiscreteStates(fmi3Instance instance) {
    ENTER(ANY_KIND, INITIALIZATION | EVENT);
    return refuse(c, __func__, "the model has no discrete states");
}

fmi3Status fmi3UpdateDiscreteStates(fmi3Instance instance, fmi3Boolean *need_update, fmi3Boolean *terminate,
                                    fmi3Boolean *nominals_changed, fmi3Boolean *values_changed,
                                    fmi3Boolean *next_event_defined, fmi3Float64 *next_event_time) {
    ENTER(MODEL_EXCHANGE, EVENT);
    fmi3Boolean *flags[] = {need_update, terminate, nominals_changed, values_changed, next_event_defined};
    for (size_t i = 0; i < sizeof flags / sizeof *flags; i++) {
        if (!pam_arrays(c, __func__, 1, flags[i], next_event_time)) return fmi3Error;
        *flags[i] = fmi3False;
    }
    *next_event_time = 0.0;
    return (fmi3Status)pam_state_holds(c);
}

/* --- model exchange ------------------------------------------------------------------------------------- */

fmi3Status fmi3EnterContinuousTimeMode(fmi3Instance instance) {
    ENTER(MODEL_EXCHANGE, EVENT);
    c->core.phase = CONTINUOUS;
    return fmi3OK;
}

fmi3Status fmi3CompletedIntegratorStep(fmi3Instance instance, fmi3Boolean no_set_state, fmi3Boolean *enter_event,
                                       fmi3Boolean *terminate) {
    ENTER(MODEL_EXCHANGE, CONTINUOUS);
    (void)no_set_state;
    if (!pam_arrays(c, __func__, 1, enter_event, terminate)) return fmi3Error;
    *enter_event = fmi3False;
    *terminate = fmi3False;
    return (fmi3Status)pam_state_holds(c);
}

fmi3Status fmi3SetTime(fmi3Instance instance, fmi3Float64 time) {
    ASK(MODEL_EXCHANGE, EVENT | CONTINUOUS, pam_set_time(c, time));
}

fmi3Status fmi3SetContinuousStates(fmi3Instance instance, const fmi3Float64 x[], size_t n) {
    ASK(MODEL_EXCHANGE, EVENT | CONTINUOUS, pam_set_states(c, x, n));
}

fmi3Status fmi3GetContinuousStateDerivatives(fmi3Instance instance, fmi3Float64 derivatives[], size_t n) {
    ASK(MODEL_EXCHANGE, READABLE, pam_get_rates(c, derivatives, n));
}

fmi3Status fmi3GetEventIndicators(fmi3Instance instance, fmi3Float64 indicators[], size_t n) {
    (void)indicators;
    ASK(MODEL_EXCHANGE, READABLE, pam_get_event_indicators(c, n));
}

fmi3Status fmi3GetContinuousStates(fmi3Instance instance, fmi3Float64 x[], size_t n) {
    ASK(MODEL_EXCHANGE, READABLE, pam_get_states(c, x, n));
}

fmi3Status fmi3GetNominalsOfContinuousStates(fmi3Instance instance, fmi3Float64 nominals[], size_t n) {
    ASK(MODEL_EXCHANGE, READABLE, pam_get_nominals(c, nominals, n));
}

fmi3Status fmi3GetNumberOfEventIndicators(fmi3Instance instance, size_t *n) {
    ENTER(MODEL_EXCHANGE, ANY);
    if (!pam_arrays(c, __func__, 1, n, n)) return fmi3Error;
    *n = 0;
    return fmi3OK;
}

fmi3Status fmi3GetNumberOfContinuousStates(fmi3Instance instance, size_t *n) {
    ENTER(MODEL_EXCHANGE, ANY);
    if (!pam_arrays(c, __func__, 1, n, n)) return fmi3Error;
    *n = (size_t)c->model->nx;
    return fmi3OK;
}

/* --- co-simulation -------------------------------------------------------------------------------------- */

fmi3Status fmi3EnterStepMode(fmi3Instance instance) {
    ENTER(CO_SIMULATION, ANY);
    return refuse(c, __func__, "this FMU has no event mode to come from");
}

fmi3Status fmi3GetOutputDerivatives(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                    const fmi3Int32 orders[], fmi3Float64 values[], size_t n_values) {
    ENTER(CO_SIMULATION, STEP | STEP_FAILED | TERMINATED);
    if (lengths(c, __func__, n, n_values)) return fmi3Error;
    return (fmi3Status)pam_get_output_derivatives(c, vr, n, orders, values);
}

/* A step that cannot be completed is discarded: early return is for events and for the importer's wishes. */
fmi3Status fmi3DoStep(fmi3Instance instance, fmi3Float64 now, fmi3Float64 step, fmi3Boolean no_set_state,
                      fmi3Boolean *event_handling_needed, fmi3Boolean *terminate, fmi3Boolean *early_return,
                      fmi3Float64 *last_successful_time) {
    ENTER(CO_SIMULATION, STEP);
    (void)no_set_state;
    if (!pam_arrays(c, __func__, 1, event_handling_needed, terminate)
        || !pam_arrays(c, __func__, 1, early_return, last_successful_time))
        return fmi3Error;
    *event_handling_needed = *terminate = *early_return = fmi3False;
    pam_status status = pam_do_step(c, now, step);
    *last_successful_time = c->core.time;
    return (fmi3Status)status;
}

/* Beside FMI, which took it out in version 3.0: the slopes of inputs, as fmi2SetRealInputDerivatives. */
PAM_EXPORT int pam_set_input_slopes(fmi3Instance instance, const fmi3ValueReference vr[], size_t n,
                                    const fmi3Int32 orders[], const fmi3Float64 values[]) {
    ASK(CO_SIMULATION, INSTANTIATED | INITIALIZATION | STEP, pam_set_input_derivatives(c, vr, n, orders, values));
}
