#include "pam_history.h"

#include <float.h>
#include <string.h>

enum { SMALLEST_CAPACITY = 16 };

/* Room for one more segment after the last, and for `count` in all. */
static int make_room(pam_history *h, const pam_memory *memory, size_t count) {
    size_t used = h->end - h->first;
    if (h->end < h->capacity && count <= h->capacity) return 0;
    if (2 * used < h->capacity && count <= h->capacity) {
        memmove(h->segments, h->segments + h->first, used * sizeof *h->segments);
    } else {
        size_t capacity = SMALLEST_CAPACITY;
        while (capacity < 2 * used || capacity < count) capacity *= 2;
        pam_segment *segments = memory->allocate(capacity, sizeof *segments);
        if (!segments) return 1;
        if (h->segments) memcpy(segments, h->segments + h->first, used * sizeof *segments);
        if (h->segments) memory->release(h->segments);
        h->segments = segments;
        h->capacity = capacity;
    }
    h->first = 0;
    h->end = used;
    return 0;
}

int pam_history_begin(pam_history *h, const pam_memory *memory, double before, pam_segment first) {
    h->first = h->end = 0;
    if (make_room(h, memory, 2)) return 1;
    h->segments[0] = (pam_segment){-DBL_MAX, before, 0.0, 0.0};
    h->segments[1] = first;
    h->end = 2;
    return 0;
}

int pam_history_append(pam_history *h, const pam_memory *memory, pam_segment segment) {
    pam_segment *last = h->segments + h->end - 1;
    if (segment.time <= last->time) {
        if (last->jump != 0.0) segment.jump = 1.0;
        *last = segment;
        return 0;
    }
    if (make_room(h, memory, 0)) return 1;
    h->segments[h->end++] = segment;
    return 0;
}

/* Index of the segment that acts: the last one with time + delay <= t, or the first there is. */
static size_t find(const pam_history *h, double delay, double t) {
    size_t low = h->first, high = h->end;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (h->segments[middle].time + delay <= t) low = middle;
        else high = middle;
    }
    return low;
}

const pam_segment *pam_history_at(const pam_history *h, double delay, double t, const pam_segment **next) {
    size_t at = find(h, delay, t);
    if (next) *next = at + 1 < h->end ? h->segments + at + 1 : NULL;
    return h->segments + at;
}

double pam_segment_value(const pam_segment *segment, double delay, double t) {
    if (segment->slope == 0.0) return segment->value;
    return segment->value + segment->slope * (t - (segment->time + delay));
}

void pam_history_forget(pam_history *h, double delay, double t) { h->first = find(h, delay, t); }

int pam_history_restore(pam_history *h, const pam_memory *memory, const double *numbers, size_t count) {
    h->first = h->end = 0;
    if (count && make_room(h, memory, count)) return 1;
    if (count) memcpy(h->segments, numbers, count * sizeof *h->segments);
    h->end = count;
    return 0;
}
