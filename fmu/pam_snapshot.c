/* The FMU state: everything that changes while an instance lives, as one block of bytes. */
#include <string.h>

#include "pam_instance.h"

/* After the header: the instance's saved numbers; then for each delayed input the number of segments of its
 * history, and the segments.
 */
typedef struct {
    char guid[64];
    size_t size; /* bytes in all */
    pam_core core;
    double numbers[];
} pam_snapshot;

static size_t history_count(const pam_history *h) { return h->end - h->first; }

static size_t snapshot_size(const pam_instance *c) {
    size_t numbers = c->saved_size;
    for (int i = 0; i < c->model->nd; i++) numbers += 1 + PAM_SEGMENT_SIZE * history_count(&c->solver.past[i]);
    return sizeof(pam_snapshot) + numbers * sizeof(double);
}

static void *allocate(pam_instance *c, size_t size) {
    void *block = c->callbacks.allocateMemory(1, size);
    if (block) memset(block, 0, size);
    return block;
}

fmi2Status fmi2GetFMUstate(fmi2Component component, fmi2FMUstate *state) {
    pam_instance *c = pam_check(component, ANY & ~FAILED, "fmi2GetFMUstate");
    if (!c || !state) return fmi2Error;
    size_t size = snapshot_size(c);
    if (*state && ((pam_snapshot *)*state)->size != size) {
        c->callbacks.freeMemory(*state);
        *state = NULL;
    }
    if (!*state) *state = allocate(c, size);
    pam_snapshot *s = *state;
    if (!s) return pam_log(c, fmi2Error, "out of memory");
    strncpy(s->guid, c->model->guid, sizeof s->guid - 1);
    s->size = size;
    s->core = c->core;
    memcpy(s->numbers, c->saved, c->saved_size * sizeof(double));
    double *numbers = s->numbers + c->saved_size;
    for (int i = 0; i < c->model->nd; i++) {
        const pam_history *h = &c->solver.past[i];
        size_t count = history_count(h);
        *numbers++ = (double)count;
        if (count) memcpy(numbers, h->segments + h->first, count * sizeof *h->segments);
        numbers += PAM_SEGMENT_SIZE * count;
    }
    return fmi2OK;
}

fmi2Status fmi2SetFMUstate(fmi2Component component, fmi2FMUstate state) {
    pam_instance *c = pam_check(component, ANY, "fmi2SetFMUstate");
    const pam_snapshot *s = state;
    if (!c || !s) return fmi2Error;
    c->core = s->core;
    memcpy(c->saved, s->numbers, c->saved_size * sizeof(double));
    pam_forget(c);
    const double *numbers = s->numbers + c->saved_size;
    for (int i = 0; i < c->model->nd; i++) {
        size_t count = (size_t)*numbers++;
        if (pam_history_restore(&c->solver.past[i], &c->solver.memory, numbers, count)) {
            c->core.phase = FAILED;
            return pam_log(c, fmi2Error, "out of memory");
        }
        numbers += PAM_SEGMENT_SIZE * count;
    }
    return fmi2OK;
}

fmi2Status fmi2FreeFMUstate(fmi2Component component, fmi2FMUstate *state) {
    pam_instance *c = pam_check(component, ANY, "fmi2FreeFMUstate");
    if (!c) return fmi2Error;
    if (!state || !*state) return fmi2OK;
    c->callbacks.freeMemory(*state);
    *state = NULL;
    return fmi2OK;
}

fmi2Status fmi2SerializedFMUstateSize(fmi2Component component, fmi2FMUstate state, size_t *size) {
    pam_instance *c = pam_check(component, ANY, "fmi2SerializedFMUstateSize");
    if (!c || !state || !size) return fmi2Error;
    *size = ((const pam_snapshot *)state)->size;
    return fmi2OK;
}

fmi2Status fmi2SerializeFMUstate(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size) {
    pam_instance *c = pam_check(component, ANY, "fmi2SerializeFMUstate");
    if (!c || !state || !bytes) return fmi2Error;
    size_t needed = ((const pam_snapshot *)state)->size;
    if (size < needed) return pam_log(c, fmi2Error, "the buffer for the FMU state is too small");
    memcpy(bytes, state, needed);
    return fmi2OK;
}

/* Whether the numbers of segments add up to the size; bytes may come from anywhere. */
static int is_whole(const pam_instance *c, const pam_snapshot *s, size_t size) {
    size_t at = c->saved_size, all = (size - sizeof *s) / sizeof(double);
    if (s->size != size || (size - sizeof *s) % sizeof(double)) return 0;
    for (int i = 0; i < c->model->nd; i++) {
        if (at >= all) return 0;
        double count = s->numbers[at++];
        if (!(count >= 0.0 && count <= (double)((all - at) / PAM_SEGMENT_SIZE))) return 0;
        at += PAM_SEGMENT_SIZE * (size_t)count;
    }
    return at == all;
}

fmi2Status fmi2DeSerializeFMUstate(fmi2Component component, const fmi2Byte bytes[], size_t size,
                                   fmi2FMUstate *state) {
    pam_instance *c = pam_check(component, ANY, "fmi2DeSerializeFMUstate");
    if (!c || !bytes || !state) return fmi2Error;
    const char *foreign = "the serialized FMU state does not belong to this FMU";
    if (size < sizeof(pam_snapshot) || strncmp(bytes, c->model->guid, sizeof((pam_snapshot *)0)->guid) != 0)
        return pam_log(c, fmi2Error, foreign);
    pam_snapshot *made = allocate(c, size);
    if (!made) return pam_log(c, fmi2Error, "out of memory");
    memcpy(made, bytes, size);
    if (!is_whole(c, made, size)) {
        c->callbacks.freeMemory(made);
        return pam_log(c, fmi2Error, foreign);
    }
    if (*state) c->callbacks.freeMemory(*state);
    *state = made;
    return fmi2OK;
}
