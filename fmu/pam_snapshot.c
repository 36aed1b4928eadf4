/* The FMU state: everything that changes while an instance lives, as one block of bytes. */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "pam_instance.h"

/* After the header: the instance's saved numbers; then for each delayed input the number of segments of its
 * history, and the segments.
 */
typedef struct {
    char guid[64];
    uint64_t hash; /* of what follows; only in the serialized form, which may come from anywhere */
    size_t size;   /* bytes in all */
    int kind;
    pam_core core;
    double numbers[];
} pam_snapshot;

static size_t history_count(const pam_history *h) { return h->end - h->first; }

static size_t snapshot_size(const pam_instance *c) {
    size_t numbers = c->saved_size;
    for (int i = 0; i < c->model->nd; i++) numbers += 1 + PAM_SEGMENT_SIZE * history_count(&c->solver.past[i]);
    return sizeof(pam_snapshot) + numbers * sizeof(double);
}

static void *allocate(const pam_instance *c, size_t size) {
    void *block = c->host.memory.allocate(1, size);
    if (block) memset(block, 0, size);
    return block;
}

static pam_status missing(const pam_instance *c) { return pam_log(c, PAM_ERROR, "an argument of the FMU state is null"); }

pam_status pam_get_state(pam_instance *c, void **state) {
    if (!state) return missing(c);
    size_t size = snapshot_size(c);
    if (*state && ((pam_snapshot *)*state)->size != size) pam_free_state(c, state);
    if (!*state) *state = allocate(c, size);
    pam_snapshot *s = *state;
    if (!s) return pam_log(c, PAM_ERROR, "out of memory");
    strncpy(s->guid, c->model->guid, sizeof s->guid - 1);
    s->size = size;
    s->kind = c->kind;
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
    return PAM_OK;
}

static int is_of_this_model(const pam_instance *c, const pam_snapshot *s) {
    return strncmp(s->guid, c->model->guid, sizeof s->guid) == 0;
}

pam_status pam_set_state(pam_instance *c, const void *state) {
    const pam_snapshot *s = state;
    if (!s) return missing(c);
    if (!is_of_this_model(c, s)) return pam_log(c, PAM_ERROR, "the FMU state is not one of this FMU");
    if (s->kind != c->kind)
        return pam_log(c, PAM_ERROR, "the FMU state was taken from an instance of the other interface type");
    c->core = s->core;
    memcpy(c->saved, s->numbers, c->saved_size * sizeof(double));
    pam_forget(c);
    const double *numbers = s->numbers + c->saved_size;
    for (int i = 0; i < c->model->nd; i++) {
        size_t count = (size_t)*numbers++;
        if (pam_history_restore(&c->solver.past[i], &c->solver.memory, numbers, count)) {
            c->core.phase = FAILED;
            return pam_log(c, PAM_ERROR, "out of memory");
        }
        numbers += PAM_SEGMENT_SIZE * count;
    }
    return PAM_OK;
}

pam_status pam_free_state(pam_instance *c, void **state) {
    if (!state || !*state) return PAM_OK;
    c->host.memory.release(*state);
    *state = NULL;
    return PAM_OK;
}

pam_status pam_state_size(pam_instance *c, const void *state, size_t *size) {
    if (!state || !size) return missing(c);
    *size = ((const pam_snapshot *)state)->size;
    return PAM_OK;
}

/* FNV-1a over everything behind the hash. */
static uint64_t hash_of(const unsigned char *bytes, size_t size) {
    uint64_t hash = 14695981039346656037u;
    for (size_t i = offsetof(pam_snapshot, size); i < size; i++) hash = (hash ^ bytes[i]) * 1099511628211u;
    return hash;
}

pam_status pam_serialise(pam_instance *c, const void *state, void *bytes, size_t size) {
    if (!state || !bytes) return missing(c);
    size_t needed = ((const pam_snapshot *)state)->size;
    if (size < needed) return pam_log(c, PAM_ERROR, "the buffer for the FMU state is too small");
    uint64_t hash = hash_of(state, needed);
    memcpy(bytes, state, needed);
    memcpy((char *)bytes + offsetof(pam_snapshot, hash), &hash, sizeof hash);
    return PAM_OK;
}

/* A history in the numbers: where the next one begins, or null where they do not hold it. Its times rise, and one that has
 * begun has a line at least.
 */
static const double *history_after(const double *numbers, const double *end, int begun) {
    if (numbers >= end) return NULL;
    double count = *numbers++;
    if (!(count >= (begun ? 1.0 : 0.0)) || count > (double)((size_t)(end - numbers) / PAM_SEGMENT_SIZE)) return NULL;
    if (count != (double)(size_t)count) return NULL;
    double last = -INFINITY;
    for (size_t k = 0; k < (size_t)count; k++, numbers += PAM_SEGMENT_SIZE) {
        if (!(numbers[0] >= last)) return NULL;
        last = numbers[0];
    }
    return numbers;
}

/* Whether a state of the right length is one that an instance can have been in; what is wrong with its numbers only, an
 * instance can bear.
 */
static int is_consistent(const pam_instance *c, const pam_snapshot *s) {
    int phase = s->core.phase, before = phase == INSTANTIATED || phase == INITIALIZATION;
    if (phase <= 0 || phase > ANY || (phase & (phase - 1))) return 0;
    if (s->kind != MODEL_EXCHANGE && s->kind != CO_SIMULATION) return 0;
    size_t count = (s->size - sizeof *s) / sizeof(double);
    if (c->saved_size > count || count * sizeof(double) != s->size - sizeof *s) return 0;
    const double *numbers = s->numbers + c->saved_size, *end = s->numbers + count;
    for (int i = 0; i < c->model->nd && numbers; i++)
        numbers = history_after(numbers, end, s->kind == CO_SIMULATION && !before);
    return numbers == end;
}

/* Whether it is this FMU's and nothing is missing or changed. */
static int is_own(const pam_instance *c, const unsigned char *bytes, size_t size) {
    if (size < sizeof(pam_snapshot)) return 0;
    pam_snapshot head;
    memcpy(&head, bytes, sizeof head);
    return is_of_this_model(c, &head) && head.size == size && head.hash == hash_of(bytes, size);
}

pam_status pam_deserialise(pam_instance *c, const void *bytes, size_t size, void **state) {
    if (!bytes || !state) return missing(c);
    pam_snapshot *made = is_own(c, bytes, size) ? allocate(c, size) : NULL;
    if (made) memcpy(made, bytes, size);
    if (made && !is_consistent(c, made)) {
        c->host.memory.release(made);
        made = NULL;
    }
    if (!made) return pam_log(c, PAM_ERROR, "the serialized FMU state is not one of this FMU, or it is damaged");
    pam_free_state(c, state);
    *state = made;
    return PAM_OK;
}
