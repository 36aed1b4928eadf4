/* Calls the functions of an FMU in random order with good and bad arguments. No call may crash, hang or return
 * anything but OK, Warning, Discard or Error; afterwards a reset instance must repeat a run bit by bit.
 *
 * Compiled together with the sources of an FMU, with -DFMI=2 or 3 and -DGUID="...".
 * Arguments: seed, number of calls, number of value references, 1 where model exchange is there.
 */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if FMI == 2
#include "fmi2Functions.h"
#define F(name) fmi2##name
typedef fmi2Component instance;
typedef fmi2Boolean boolean;
typedef fmi2FMUstate saved;
typedef fmi2Byte byte;
#else
#include "fmi3Functions.h"
#define F(name) fmi3##name
typedef fmi3Instance instance;
typedef fmi3Boolean boolean;
typedef fmi3FMUState saved;
typedef fmi3Byte byte;
#endif

enum { COUNT = 6, SLOTS = 4, ROOM = 1 << 16 };

static uint64_t state = 1;
static long counts[5], messages;
static unsigned n_variables;

static unsigned below(unsigned n) {
    state ^= state << 13;
    state ^= state >> 7;
    state ^= state << 17;
    return (unsigned)((state * 2685821657736338717u) >> 33) % n;
}

static int rarely(void) { return below(16) == 0; }

static double number(void) {
    const double odd[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 1e-300};
    return rarely() ? odd[below(6)] : (int)below(2001) * 1e-3 - 1.0;
}

static unsigned reference(void) { return rarely() ? 0xffffffffu - below(4) : below(n_variables + 2); }

static void check(const char *name, int status) {
    if (status < 0 || status > 3) {
        fprintf(stderr, "%s returned %d\n", name, status);
        exit(2);
    }
    counts[status]++;
}

/* The call, and once in a while the same without an instance, which is an error. */
#define CALL(name, ...)                                                                \
    do {                                                                               \
        if (rarely()) {                                                                \
            if ((int)F(name)(NULL, ##__VA_ARGS__) != 3) {                              \
                fprintf(stderr, #name " takes a null instance\n");                     \
                exit(2);                                                               \
            }                                                                          \
        } else check(#name, (int)F(name)(c, ##__VA_ARGS__));                           \
    } while (0)

#if FMI == 2
static void logger(fmi2ComponentEnvironment e, fmi2String name, fmi2Status status, fmi2String category,
                   fmi2String format, ...) {
    (void)e, (void)name, (void)status, (void)format;
    messages += (long)strlen(category) > 0;
}
static const fmi2CallbackFunctions CALLBACKS = {logger, calloc, free, NULL, NULL};
static instance make(int exchange, const char *guid) {
    return fmi2Instantiate("fuzz", exchange ? fmi2ModelExchange : fmi2CoSimulation, guid, NULL, &CALLBACKS, 0, 0);
}
#else
static void logger(fmi3InstanceEnvironment e, fmi3Status status, fmi3String category, fmi3String message) {
    (void)e, (void)status;
    messages += (long)(strlen(category) + strlen(message)) > 0;
}
static instance make(int exchange, const char *guid) {
    if (exchange) return fmi3InstantiateModelExchange("fuzz", guid, NULL, 0, 1, NULL, logger);
    return fmi3InstantiateCoSimulation("fuzz", guid, NULL, 0, 1, 0, 0, NULL, 0, NULL, logger, NULL);
}
#endif

static double time_of(instance c) {
    double t = 0.0;
#if FMI == 2
    fmi2GetRealStatus(c, fmi2LastSuccessfulTime, &t);
#else
    unsigned vr = n_variables; /* time is the last variable */
    fmi3GetFloat64(c, &vr, 1, &t, 1);
#endif
    return t;
}

/* One random call. */
static void call(instance c, saved slots[SLOTS], byte *bytes) {
    unsigned vr[COUNT], known[COUNT];
    double values[COUNT], results[COUNT];
    int orders[COUNT];
    for (int i = 0; i < COUNT; i++) {
        vr[i] = reference();
        known[i] = reference();
        values[i] = number();
        orders[i] = rarely() ? (int)below(4) - 1 : 1;
    }
    size_t n = below(COUNT + 1), m = below(COUNT + 1), size = 0;
    const unsigned *v = rarely() ? NULL : vr, *k = rarely() ? NULL : known;
    const double *in = rarely() ? NULL : values;
    double *out = rarely() ? NULL : results;
    const int *order = rarely() ? NULL : orders;
    saved *slot = &slots[below(SLOTS)];
    boolean flags[5], on = (boolean)below(2), *flag = rarely() ? NULL : flags;
    double now = rarely() ? number() : time_of(c), step = rarely() ? number() : 0.01 * (1 + below(30));
    const char *categories[] = {"logStatusError", rarely() ? NULL : "logStatusWarning", rarely() ? "x" : "logStatusDiscard"};
#if FMI == 2
#define REFERENCES(name) CALL(name, v, n, (void *)out)
    switch (below(40)) {
        case 0: case 1: CALL(SetupExperiment, on, number(), number(), on, number()); break;
        case 2: case 3: CALL(EnterInitializationMode); break;
        case 4: case 5: CALL(ExitInitializationMode); break;
        case 6: if (rarely()) CALL(Terminate); break;
        case 7: if (rarely()) CALL(Reset); break;
        case 8: case 9: CALL(GetReal, v, n, out); break;
        case 10: case 11: CALL(SetReal, v, n, in); break;
        case 12: REFERENCES(GetInteger); break;
        case 13: REFERENCES(GetBoolean); break;
        case 14: REFERENCES(GetString); break;
        case 15: REFERENCES(SetInteger); REFERENCES(SetBoolean); REFERENCES(SetString); break;
        case 16: case 17: CALL(GetDirectionalDerivative, v, n, k, m, in, out); break;
        case 18: CALL(EnterEventMode); break;
        case 19: { fmi2EventInfo info; CALL(NewDiscreteStates, rarely() ? NULL : &info); break; }
        case 20: CALL(EnterContinuousTimeMode); break;
        case 21: CALL(CompletedIntegratorStep, on, flag, flag); break;
        case 22: CALL(SetTime, number()); break;
        case 23: CALL(SetContinuousStates, in, n); break;
        case 24: CALL(GetDerivatives, out, n); break;
        case 25: CALL(GetEventIndicators, out, n); break;
        case 26: CALL(GetContinuousStates, out, n); break;
        case 27: CALL(GetNominalsOfContinuousStates, out, n); break;
        case 28: CALL(SetRealInputDerivatives, v, n, order, in); break;
        case 29: CALL(GetRealOutputDerivatives, v, n, order, out); break;
        case 30: case 31: case 32: CALL(DoStep, now, step, on); break;
        case 33: CALL(CancelStep); break;
        case 34: { fmi2Status s; double d; int i; const char *t; fmi2StatusKind kind = (fmi2StatusKind)below(5);
                   CALL(GetStatus, kind, rarely() ? NULL : &s); CALL(GetRealStatus, kind, rarely() ? NULL : &d);
                   CALL(GetIntegerStatus, kind, &i); CALL(GetBooleanStatus, kind, &i); CALL(GetStringStatus, kind, &t);
                   break; }
        case 35: CALL(SetDebugLogging, on, below(4), rarely() ? NULL : categories); break;
        case 36: CALL(GetFMUstate, rarely() ? NULL : slot); break;
        case 37: CALL(SetFMUstate, *slot); break;
        case 38: CALL(FreeFMUstate, rarely() ? NULL : slot); break;
        case 39:
            CALL(SerializedFMUstateSize, *slot, &size);
            size = 0;
            if (*slot && (int)fmi2SerializedFMUstateSize(c, *slot, &size) == 0 && size <= ROOM) {
                CALL(SerializeFMUstate, *slot, rarely() ? NULL : bytes, rarely() ? below((unsigned)size) : size);
                if (below(2)) bytes[below((unsigned)size)] ^= (byte)(1 + below(255));
                CALL(DeSerializeFMUstate, bytes, rarely() ? below((unsigned)size) : size, slot);
            }
            break;
    }
#else
    size_t nv = rarely() ? below(COUNT + 1) : n, nm = rarely() ? below(COUNT + 1) : m, sizes[COUNT];
    unsigned char more[64];
#define OTHER(type) CALL(Get##type, v, n, (void *)more, nv); CALL(Set##type, v, n, (void *)more, nv); break
    switch (below(46)) {
        case 0: case 1: CALL(EnterInitializationMode, on, number(), number(), on, number()); break;
        case 2: case 3: CALL(ExitInitializationMode); break;
        case 4: CALL(EnterConfigurationMode); CALL(ExitConfigurationMode); break;
        case 5: CALL(EnterStepMode); CALL(EvaluateDiscreteStates); break;
        case 6: if (rarely()) CALL(Terminate); break;
        case 7: if (rarely()) CALL(Reset); break;
        case 8: case 9: CALL(GetFloat64, v, n, out, nv); break;
        case 10: case 11: CALL(SetFloat64, v, n, in, nv); break;
        case 12: OTHER(Float32);
        case 13: OTHER(Int8);
        case 14: OTHER(UInt8);
        case 15: OTHER(Int16);
        case 16: OTHER(UInt16);
        case 17: OTHER(Int32);
        case 18: OTHER(UInt32);
        case 19: OTHER(Int64);
        case 20: OTHER(UInt64);
        case 21: OTHER(Boolean);
        case 22: OTHER(String);
        case 23: CALL(GetBinary, v, n, sizes, (void *)more, nv); CALL(SetBinary, v, n, sizes, (void *)more, nv); break;
        case 24: CALL(GetClock, v, n, (void *)more); CALL(SetClock, v, n, (void *)more); break;
        case 25: CALL(GetIntervalDecimal, v, n, out, NULL); CALL(GetIntervalFraction, v, n, NULL, NULL, NULL);
                 CALL(GetShiftDecimal, v, n, out); CALL(GetShiftFraction, v, n, NULL, NULL);
                 CALL(SetIntervalDecimal, v, n, in); CALL(SetIntervalFraction, v, n, NULL, NULL);
                 CALL(SetShiftDecimal, v, n, in); CALL(SetShiftFraction, v, n, NULL, NULL); break;
        case 26: CALL(GetDirectionalDerivative, v, n, k, m, in, nm, out, nv); break;
        case 27: CALL(GetAdjointDerivative, v, n, k, m, in, nv, out, nm); break;
        case 28: CALL(GetNumberOfVariableDependencies, vr[0], &size); CALL(ActivateModelPartition, vr[0], now);
                 CALL(GetVariableDependencies, vr[0], NULL, NULL, NULL, NULL, 0); break;
        case 29: CALL(EnterEventMode); break;
        case 30: CALL(UpdateDiscreteStates, flag, flag, flags, flags, flag, rarely() ? NULL : results); break;
        case 31: CALL(EnterContinuousTimeMode); break;
        case 32: CALL(CompletedIntegratorStep, on, flag, flag); break;
        case 33: CALL(SetTime, number()); break;
        case 34: CALL(SetContinuousStates, in, n); break;
        case 35: CALL(GetContinuousStateDerivatives, out, n); CALL(GetEventIndicators, out, n); break;
        case 36: CALL(GetContinuousStates, out, n); CALL(GetNominalsOfContinuousStates, out, n); break;
        case 37: CALL(GetNumberOfEventIndicators, rarely() ? NULL : &size);
                 CALL(GetNumberOfContinuousStates, rarely() ? NULL : &size); break;
        case 38: CALL(GetOutputDerivatives, v, n, order, out, nv); break;
        case 39: case 40: CALL(DoStep, now, step, on, flag, flags, flag, rarely() ? NULL : results); break;
        case 41: CALL(SetDebugLogging, on, below(4), rarely() ? NULL : categories); break;
        case 42: CALL(GetFMUState, rarely() ? NULL : slot); break;
        case 43: CALL(SetFMUState, *slot); break;
        case 44: CALL(FreeFMUState, rarely() ? NULL : slot); break;
        case 45:
            CALL(SerializedFMUStateSize, *slot, &size);
            size = 0;
            if (*slot && (int)fmi3SerializedFMUStateSize(c, *slot, &size) == 0 && size <= ROOM) {
                CALL(SerializeFMUState, *slot, rarely() ? NULL : bytes, rarely() ? below((unsigned)size) : size);
                if (below(2)) bytes[below((unsigned)size)] ^= (byte)(1 + below(255));
                CALL(DeserializeFMUState, bytes, rarely() ? below((unsigned)size) : size, slot);
            }
            break;
    }
#endif
}

/* A plain run; the values of all variables at its end. */
static void run(instance c, int exchange, double *end) {
    int bad = 0;
#if FMI == 2
    bad |= fmi2SetupExperiment(c, 1, 1e-6, 0.0, 0, 0.0) | fmi2EnterInitializationMode(c) | fmi2ExitInitializationMode(c);
    for (int i = 0; !exchange && i < 10; i++) bad |= (int)fmi2DoStep(c, i * 0.01, 0.01, 1);
    for (unsigned i = 1; i <= n_variables; i++) bad |= (int)fmi2GetReal(c, &i, 1, &end[i - 1]);
#else
    boolean b;
    double t;
    bad |= fmi3EnterInitializationMode(c, 1, 1e-6, 0.0, 0, 0.0) | fmi3ExitInitializationMode(c);
    for (int i = 0; !exchange && i < 10; i++) bad |= (int)fmi3DoStep(c, i * 0.01, 0.01, 1, &b, &b, &b, &t);
    for (unsigned i = 1; i <= n_variables; i++) bad |= (int)fmi3GetFloat64(c, &i, 1, &end[i - 1], 1);
#endif
    if (bad) {
        fprintf(stderr, "a plain run fails\n");
        exit(3);
    }
}

static void fuzz(int exchange, long calls) {
    instance c = make(exchange, GUID), fresh = make(exchange, GUID);
    if (!c || !fresh || make(exchange, "{another}") || make(exchange, NULL)) exit(4);
    saved slots[SLOTS] = {NULL};
    byte *bytes = calloc(ROOM, 1);
    double *a = calloc(n_variables, sizeof *a), *b = calloc(n_variables, sizeof *b);
    for (long i = 0; i < calls; i++) {
        if (i % 400 == 399) (void)F(Reset)(c);
        call(c, slots, bytes);
    }
    (void)F(Reset)(c);
    run(c, exchange, a);
    run(fresh, exchange, b);
    if (memcmp(a, b, n_variables * sizeof *a) != 0) {
        fprintf(stderr, "a reset instance differs from a fresh one\n");
        exit(5);
    }
    for (int i = 0; i < SLOTS; i++)
#if FMI == 2
        fmi2FreeFMUstate(c, &slots[i]);
#else
        fmi3FreeFMUState(c, &slots[i]);
#endif
    F(FreeInstance)(c);
    F(FreeInstance)(fresh);
    F(FreeInstance)(NULL);
    free(bytes);
    free(a);
    free(b);
}

int main(int argc, char **argv) {
    if (argc != 5) return 1;
    state = strtoull(argv[1], NULL, 10) * 2654435769u + 1;
    n_variables = (unsigned)atoi(argv[3]);
    fuzz(0, atol(argv[2]));
    if (atoi(argv[4])) fuzz(1, atol(argv[2]));
    printf("%ld %ld %ld %ld %ld\n", counts[0], counts[1], counts[2], counts[3], messages);
    return 0;
}
