/* What the model states of itself: conditions that must hold, and what is said where they do not. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "pam_instance.h"

/* Adds to a text that ends at *used; what there is no room for is left out. */
static void append(char *text, size_t size, size_t *used, const char *more) {
    size_t length = strlen(more), room = size - 1 - *used;
    if (length > room) length = room;
    memcpy(text + *used, more, length);
    *used += length;
    text[*used] = '\0';
}

/* The message of a statement with the numbers that were found with its condition. */
static void tell(const pam_instance *c, int which, double t, char *text, size_t size) {
    const pam_statement *s = c->model->statements + which;
    const double *value = c->checks + c->model->na;
    for (int i = 0; i < which; i++) value += c->model->statements[i].values;
    char number[64];
    size_t used = 0;
    snprintf(number, sizeof number, "at time %.9g s: ", t);
    append(text, size, &used, "an assertion of the model fails ");
    append(text, size, &used, number);
    append(text, size, &used, s->texts[0]);
    for (int i = 0; i < s->values; i++) {
        snprintf(number, sizeof number, "%.*g", s->digits[i], value[i]);
        append(text, size, &used, number);
        append(text, size, &used, s->texts[i + 1]);
    }
}

/* The first statement of a level that does not hold and was not yet said; -1: there is none. */
static int broken(const pam_instance *c, int is_error) {
    const pam_statement *s = c->model->statements;
    int starting = c->core.phase == INITIALIZATION;
    for (int i = 0; i < c->model->na; i++)
        if (s[i].is_error == is_error && (starting || !s[i].at_start) && c->checks[i] == 0.0 && c->told[i] == 0.0)
            return i;
    return -1;
}

static pam_status warn(pam_instance *c, int which, double t) {
    char text[PAM_MESSAGE];
    tell(c, which, t, text, sizeof text);
    c->told[which] = 1.0;
    c->core.warned = 1;
    return pam_log(c, PAM_WARNING, "%s", text);
}

pam_status pam_state_holds(pam_instance *c) {
    if (!c->model->na) return PAM_OK;
    pam_status status = PAM_OK;
    double t = c->core.time;
    pam_check_statements(c);
    int failed = broken(c, 1);
    if (failed >= 0) {
        char text[PAM_MESSAGE];
        tell(c, failed, t, text, sizeof text);
        c->core.phase = FAILED;
        return pam_log(c, PAM_ERROR, "%s", text);
    }
    for (int i = broken(c, 0); i >= 0; i = broken(c, 0)) status = warn(c, i, t);
    c->core.holds_until = t;
    return status;
}

/* Conditions and numbers at a time that the solution is known for. */
static void check_at(pam_instance *c, double t) {
    pam_solver *v = &c->solver;
    if (v->model->nx) pam_solver_core_state(v, t, v->stage);
    pam_solver_input_values(v, t, v->u_stage);
    pam_solver_delayed_values(v, t, v->d_stage, c->rate_d);
    const double *arg[] = {&t, v->stage, v->u_stage, v->d_stage, v->p};
    double *res[] = {c->checks, c->checks + v->model->na};
    v->model->check(arg, res, v->iw, v->w, 0);
}

/* Between two times, at the second of which a level is broken: the first at which it is, and *holds just before it. */
static double locate(pam_instance *c, int is_error, double *holds, double fails) {
    for (;;) {
        double middle = *holds + (fails - *holds) / 2.0;
        if (!(middle > *holds && middle < fails)) break;
        check_at(c, middle);
        if (broken(c, is_error) < 0) *holds = middle;
        else fails = middle;
    }
    check_at(c, fails);
    return fails;
}

int pam_accept(void *instance, double t) {
    pam_instance *c = instance;
    pam_core *core = &c->core;
    double since = fmax(core->holds_until, core->solver.t), holds = since;
    check_at(c, t);
    int failed = broken(c, 1) >= 0;
    if (failed) {
        t = locate(c, 1, &holds, t);
        tell(c, broken(c, 1), t, c->solver.message, sizeof c->solver.message);
    }
    core->holds_until = failed ? holds : t;
    while (broken(c, 0) >= 0) {
        holds = since;
        double at = locate(c, 0, &holds, t);
        warn(c, broken(c, 0), at);
        check_at(c, t);
    }
    return failed;
}
