/* The past of one delayed input: straight lines, of which the last goes on into the future. */
#ifndef PAM_HISTORY_H
#define PAM_HISTORY_H

#include "pam_names.h"

#include <stddef.h>

/* From a time on, value + slope (t - time); jump: 1 where it does not begin at the end of the line before. */
typedef struct {
    double time, value, slope, jump;
} pam_segment;

enum { PAM_SEGMENT_SIZE = sizeof(pam_segment) / sizeof(double) };

typedef struct {
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
} pam_memory;

typedef struct {
    pam_segment *segments;
    size_t first, end, capacity; /* those in use; what lies before them is forgotten */
} pam_history;

/* Begins at time t; before that the input had another value, or the same. Returns 1 where memory has run out. */
int pam_history_begin(pam_history *h, const pam_memory *memory, double before, pam_segment first);

/* From time t on, not earlier than the last one, there is a new line. Returns 1 where memory has run out. */
int pam_history_append(pam_history *h, const pam_memory *memory, pam_segment segment);

/* The segment that acts at time t after a delay (at a jump the one after it), and the one that follows it or
 * NULL. Sums are compared, knot + delay <= t, so that a step that ends at such a sum ends at the knot.
 */
const pam_segment *pam_history_at(const pam_history *h, double delay, double t, const pam_segment **next);

/* What a segment gives at time t after a delay. */
double pam_segment_value(const pam_segment *segment, double delay, double t);

/* Forgets what acted before time t. */
void pam_history_forget(pam_history *h, double delay, double t);

/* Takes over another history: count segments as plain numbers. Returns 1 where memory has run out. */
int pam_history_restore(pam_history *h, const pam_memory *memory, const double *numbers, size_t count);

#endif
