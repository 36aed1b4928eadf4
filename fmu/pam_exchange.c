/* Model exchange. The model has no events of its own. */
#include <math.h>
#include <string.h>

#include "pam_instance.h"

/* Whether a vector has one element for each continuous state. */
static int is_state_vector(const pam_instance *c, const void *x, size_t n) {
    if (n == (size_t)c->model->nx && (x || !n)) return 1;
    pam_log(c, PAM_ERROR, "a vector of %zu elements is given; the model has %d continuous states", x ? n : (size_t)0,
            c->model->nx);
    return 0;
}

static void copy(double *to, const double *from, size_t n) {
    if (n) memcpy(to, from, n * sizeof *to);
}

pam_status pam_set_time(pam_instance *c, double time) {
    if (!isfinite(time)) return pam_log(c, PAM_ERROR, "the time is not a finite number");
    c->core.time = time;
    pam_forget(c);
    return PAM_OK;
}

pam_status pam_set_states(pam_instance *c, const double x[], size_t n) {
    if (!is_state_vector(c, x, n)) return PAM_ERROR;
    copy(c->x, x, n);
    pam_forget(c);
    return PAM_OK;
}

pam_status pam_get_states(pam_instance *c, double x[], size_t n) {
    if (!is_state_vector(c, x, n)) return PAM_ERROR;
    pam_initialise_states(c);
    copy(x, c->x, n);
    return PAM_OK;
}

pam_status pam_get_rates(pam_instance *c, double dx[], size_t n) {
    if (!is_state_vector(c, dx, n)) return PAM_ERROR;
    copy(dx, pam_derivatives(c), n);
    for (size_t i = 0; i < n; i++)
        if (!isfinite(dx[i]))
            return pam_log(c, PAM_DISCARD, "the derivative of '%s' is not a finite number at time %.9g s",
                           c->model->state_names[i], c->core.time);
    return PAM_OK;
}

pam_status pam_get_nominals(pam_instance *c, double nominals[], size_t n) {
    if (!is_state_vector(c, nominals, n)) return PAM_ERROR;
    for (size_t i = 0; i < n; i++) {
        double nominal = c->model->state_nominals[i];
        nominals[i] = nominal > 0.0 ? nominal : 1.0;
    }
    return PAM_OK;
}

pam_status pam_get_event_indicators(pam_instance *c, size_t n) {
    return n ? pam_log(c, PAM_ERROR, "the model has no event indicators") : PAM_OK;
}
