/* What an instance says, and what it checks before it does anything. */
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "pam_instance.h"

static const struct {
    int bit;
    const char *name;
} CATEGORIES[] = {
    {LOG_WARNING, "logStatusWarning"},
    {LOG_DISCARD, "logStatusDiscard"},
    {LOG_ERROR, "logStatusError"},
    {LOG_EVENTS, "logEvents"},
    {LOG_ALL, "logAll"},
};

enum { CATEGORY_COUNT = sizeof CATEGORIES / sizeof *CATEGORIES };

pam_status pam_log(const pam_instance *c, pam_status status, const char *format, ...) {
    char message[PAM_MESSAGE];
    va_list args;
    va_start(args, format);
    vsnprintf(message, sizeof message, format, args);
    va_end(args);
    int which = status == PAM_OK ? 3 : status == PAM_WARNING ? 0 : status == PAM_DISCARD ? 1 : 2;
    if (c->host.logger && c->logging & CATEGORIES[which].bit)
        c->host.log(&c->host, c->name, status, CATEGORIES[which].name, message);
    return status;
}

pam_status pam_set_logging(pam_instance *c, int on, size_t n, const char *const categories[]) {
    if (on && !pam_arrays(c, "SetDebugLogging", n, categories, categories)) return PAM_ERROR;
    int chosen = on && !n ? LOG_ALL : 0;
    pam_status status = PAM_OK;
    c->logging = LOG_ALL; /* for what is said here */
    for (size_t i = 0; on && i < n; i++) {
        const char *name = categories[i] ? categories[i] : "(null)";
        int bit = 0;
        for (int k = 0; k < CATEGORY_COUNT; k++)
            if (strcmp(name, CATEGORIES[k].name) == 0) bit = CATEGORIES[k].bit;
        if (!bit) status = pam_log(c, PAM_WARNING, "there is no log category '%s'", name);
        chosen |= bit;
    }
    c->logging = chosen;
    return status;
}

static const char *phase_text(int phase) {
    switch (phase) {
        case INSTANTIATED: return "before initialization";
        case INITIALIZATION: return "in initialization mode";
        case EVENT: return "in event mode";
        case CONTINUOUS: return "in continuous-time mode";
        case STEP_FAILED: return "after a step that could not be completed";
        case TERMINATED: return "after the end of the simulation";
        case FAILED: return "after an error";
        default: return "between steps";
    }
}

pam_instance *pam_check(void *instance, int kinds, int phases, const char *function) {
    pam_instance *c = instance;
    if (!c) return NULL;
    if (!(c->kind & kinds)) {
        const char *other = kinds == MODEL_EXCHANGE ? "model exchange" : "co-simulation";
        const char *own = c->kind == MODEL_EXCHANGE ? "model exchange" : "co-simulation";
        pam_log(c, PAM_ERROR, "%s is for %s, this instance is for %s", function, other, own);
        return NULL;
    }
    if (c->core.phase & phases) return c;
    pam_log(c, PAM_ERROR, "%s must not be called %s", function, phase_text(c->core.phase));
    return NULL;
}

int pam_arrays(const pam_instance *c, const char *function, size_t n, const void *a, const void *b) {
    if (!n || (a && b)) return 1;
    pam_log(c, PAM_ERROR, "%s: an array is missing", function);
    return 0;
}

const pam_variable *pam_lookup(const pam_instance *c, unsigned vr) {
    if (vr > 0 && vr <= (unsigned)c->model->nv) return c->model->variables + vr - 1;
    pam_log(c, PAM_ERROR, "there is no variable with value reference %u", vr);
    return NULL;
}
