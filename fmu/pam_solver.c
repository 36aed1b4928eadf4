#include "pam_solver.h"

#include <float.h>
#include <stdio.h>
#include <string.h>

#include "pam_lu.h"
#include "pam_rodas5p.h"

/* The controller's constants: Hairer and Wanner, Solving ODEs II, IV.2 and IV.8. */
static const double SAFETY = 0.9, SHRINK = 0.2, GROW = 6.0, ORDER = 5.0;
static const double INTEGRAL = 0.7, PROPORTIONAL = 0.4;

size_t pam_solver_saved_size(const pam_model *m) {
    return (size_t)(2 * m->nx + 4 * m->nc + 2 * m->nu + m->np + m->nd) + pam_sensitivity_saved_size(m);
}

size_t pam_solver_scratch_size(const pam_model *m) {
    int states = (PAM_STAGES + 3) * m->nc + m->nx, matrices = 2 * m->nc * m->nc;
    return (size_t)(states + m->nu + 3 * m->nd + matrices + m->size_w) + pam_sensitivity_scratch_size(m);
}

size_t pam_solver_pivots(const pam_model *m) { return (size_t)((m->ns ? PAM_NODES : 1) * m->nc); }

static double *take(double **block, int n) {
    double *part = *block;
    *block += n;
    return part;
}

void pam_solver_bind(pam_solver *v, const pam_model *m, pam_solver_scalars *s, double *saved, double *scratch,
                     int *pivot, long long *iw) {
    int nx = m->nc;
    v->model = m;
    v->s = s;
    v->x = take(&saved, m->nx);
    v->x1 = take(&saved, m->nx);
    v->dense = take(&saved, 3 * nx);
    v->scale = take(&saved, nx);
    v->u = take(&saved, m->nu);
    v->du = take(&saved, m->nu);
    v->p = take(&saved, m->np);
    v->delay = take(&saved, m->nd);
    v->k = take(&scratch, PAM_STAGES * nx);
    v->f = take(&scratch, nx);
    v->ft = take(&scratch, nx);
    v->stage = take(&scratch, m->nx);
    v->rhs = take(&scratch, nx);
    v->u_stage = take(&scratch, m->nu);
    v->d = take(&scratch, m->nd);
    v->dd = take(&scratch, m->nd);
    v->d_stage = take(&scratch, m->nd);
    v->jac = take(&scratch, nx * nx);
    v->lu = take(&scratch, nx * nx);
    v->w = take(&scratch, m->size_w);
    pam_sensitivity_bind(&v->sensitivity, m, saved, scratch, pivot);
    v->pivot = pivot;
    v->iw = iw;
    v->message[0] = '\0';
}

void pam_solver_input_values(const pam_solver *v, double t, double *u) {
    double dt = t - v->s->input_time;
    for (int i = 0; i < v->model->nu; i++) u[i] = v->u[i] + v->du[i] * dt;
}

void pam_solver_delayed_values(const pam_solver *v, double t, double *d, double *dd) {
    for (int i = 0; i < v->model->nd; i++) {
        const pam_segment *now = pam_history_at(&v->past[i], v->delay[i], t, NULL);
        d[i] = pam_segment_value(now, v->delay[i], t);
        dd[i] = now->slope;
    }
}

/* At any stage of a step the delayed inputs are on the lines on which it began. */
static void evaluate(pam_solver *v, double t, const double *x, double *dx) {
    pam_solver_input_values(v, t, v->u_stage);
    for (int i = 0; i < v->model->nd; i++) v->d_stage[i] = v->d[i] + v->dd[i] * (t - v->s->t);
    const double *arg[] = {&t, x, v->u_stage, v->d_stage, v->p};
    double *res[] = {dx};
    v->model->core_rhs(arg, res, v->iw, v->w, 0);
    v->s->statistics.rhs++;
}

/* f, df/dx and the total df/dt along the inputs' slope, at the start of the step. */
static void linearise(pam_solver *v) {
    pam_solver_input_values(v, v->s->t, v->u_stage);
    const double *arg[] = {&v->s->t, v->x, v->u_stage, v->d, v->du, v->dd, v->p};
    double *res[] = {v->f, v->jac, v->ft};
    v->model->lin(arg, res, v->iw, v->w, 0);
    v->s->statistics.rhs++;
    v->s->statistics.jacobians++;
}

static int first_not_finite(int n, const double *x) {
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i])) return i;
    return -1;
}

static int fail_memory(pam_solver *v) {
    snprintf(v->message, sizeof v->message, "out of memory for the past of a delayed input");
    return 1;
}

static double weight(const pam_solver *v, int i, double x) { return v->s->rtol * (fabs(x) + v->scale[i]); }

/* Delays and the beginning of the delayed inputs' past. */
static int begin_past(pam_solver *v, double t) {
    const pam_model *m = v->model;
    const double *arg[] = {v->p, NULL};
    double *res[] = {v->delay, NULL};
    if (m->nd) m->delay(arg, res, v->iw, v->w, 0);
    for (int i = 0; i < m->nd; i++) {
        int input = m->delayed_inputs[i];
        if (!(v->delay[i] >= 0.0) || !isfinite(v->delay[i])) {
            snprintf(v->message, sizeof v->message, "a delay of an input is %.9g s; it must be zero or positive",
                     v->delay[i]);
            return 1;
        }
        pam_segment start = {t, 1.0, 0.0, 1.0};
        if (input >= 0) start = (pam_segment){t, v->u[input], v->du[input], 0.0};
        double before = input >= 0 ? start.value : 0.0;
        if (pam_history_begin(&v->past[i], &v->memory, before, start)) return fail_memory(v);
    }
    return 0;
}

int pam_solver_begin(pam_solver *v, double t, const double *u, const double *du, double rtol) {
    const pam_model *m = v->model;
    memset(v->s, 0, sizeof *v->s);
    v->s->t = t;
    v->s->input_time = t;
    v->s->rtol = rtol;
    v->s->error_previous = 1.0;
    v->s->estimate = 1;
    if (m->nu) memcpy(v->u, u, sizeof(double) * (size_t)m->nu);
    if (m->nu) memcpy(v->du, du, sizeof(double) * (size_t)m->nu);
    for (int i = 0; i < m->nc; i++) {
        /* Without a declared nominal value the start value tells the scale of small quantities. */
        double nominal = m->state_nominals[i];
        v->scale[i] = nominal > 0.0 ? nominal : v->x[i] == 0.0 ? 1.0 : fmin(1.0, fmax(1e-6, fabs(v->x[i])));
    }
    return begin_past(v, t);
}

void pam_solver_no_numbers(const pam_model *m, double *x) {
    for (int i = m->nc; i < m->nx; i++) x[i] = NAN;
}

void pam_solver_leave_sensitivities(pam_solver *v) {
    v->s->plain = 1;
    pam_solver_no_numbers(v->model, v->x);
    pam_solver_no_numbers(v->model, v->x1);
}

void pam_solver_core_state(const pam_solver *v, double t, double *x) {
    int n = v->model->nc;
    double s = v->s->h > 0.0 ? (t - v->s->t) / v->s->h : 0.0;
    for (int i = 0; i < n; i++) {
        if (s <= 0.0) x[i] = v->x[i];
        else if (s >= 1.0) x[i] = v->x1[i];
        else
            x[i] = (1.0 - s) * v->x[i]
                 + s * (v->x1[i] + (1.0 - s) * (v->dense[i] + s * (v->dense[i + n] + s * v->dense[i + 2 * n])));
    }
}

void pam_solver_state(const pam_solver *v, double t, double *x) {
    pam_solver_core_state(v, t, x);
    if (v->s->plain) pam_solver_no_numbers(v->model, x);
    else if (v->model->ns) pam_sensitivity_state(v, t, x + v->model->nc);
}

/* Drops what the pending step says about times after t. */
static void cut(pam_solver *v, double t) {
    if (v->s->h > 0.0) {
        pam_solver_state(v, t, v->stage);
        memcpy(v->x, v->stage, sizeof(double) * (size_t)v->model->nx);
        if (v->s->h_next > v->s->h) v->s->h_next = v->s->h;
    }
    v->s->t = t;
    v->s->h = 0.0;
    v->s->statistics.restarts++;
}

void pam_solver_set_state(pam_solver *v, double t, const double *x) {
    cut(v, t);
    memcpy(v->x, x, sizeof(double) * (size_t)v->model->nx);
    v->s->estimate = 1;
}

enum { AS_ASSUMED, BEND, JUMP };

/* What an input does at time t. */
static int change_of(const pam_solver *v, int i, double t, double u, double du) {
    double assumed = v->u[i] + v->du[i] * (t - v->s->input_time);
    double rounding = 16.0 * DBL_EPSILON * (fabs(assumed) + fabs(u) + fabs(v->du[i]) * fabs(t));
    if (fabs(u - assumed) > rounding) return JUMP;
    return fabs(du - v->du[i]) > 1e-12 * fabs(v->du[i]) ? BEND : AS_ASSUMED;
}

/* Writes a change of an input into the past of those made from it; it acts when the delay is over. */
static int record(pam_solver *v, int input, pam_segment segment) {
    pam_solver_scalars *s = v->s;
    for (int i = 0; i < v->model->nd; i++) {
        if (v->model->delayed_inputs[i] != input) continue;
        pam_history_forget(&v->past[i], v->delay[i], s->t);
        if (pam_history_append(&v->past[i], &v->memory, segment)) return fail_memory(v);
        double acts = segment.time + v->delay[i];
        if (s->h > 0.0 && acts < s->until) {
            s->until = acts;
            s->truncated = 1;
            if (s->h_next > s->h) s->h_next = s->h;
        }
    }
    return 0;
}

int pam_solver_inputs(pam_solver *v, double t, const double *u, const double *du) {
    const pam_model *m = v->model;
    int most = AS_ASSUMED, most_direct = AS_ASSUMED;
    for (int i = 0; i < m->nu; i++) {
        int change = change_of(v, i, t, u[i], du[i]);
        if (change > most) most = change;
        if (m->direct_inputs[i] && change > most_direct) most_direct = change;
    }
    if (most == AS_ASSUMED) return 0;
    if (most_direct != AS_ASSUMED) cut(v, t);
    if (most_direct == JUMP) v->s->estimate = 1;
    for (int i = 0; i < m->nu; i++) {
        int change = change_of(v, i, t, u[i], du[i]);
        pam_segment segment = {t, u[i], du[i], change == JUMP};
        if (change != AS_ASSUMED && record(v, i, segment)) return 1;
    }
    memcpy(v->u, u, sizeof(double) * (size_t)m->nu);
    memcpy(v->du, du, sizeof(double) * (size_t)m->nu);
    v->s->input_time = t;
    return 0;
}

/* A first step length from f and its exact time derivative (Hairer, Norsett, Wanner, Solving ODEs I, II.4).
 * 0: nothing moves.
 */
static double estimate_step(const pam_solver *v) {
    int n = v->model->nc;
    double d0 = 0.0, d1 = 0.0, d2 = 0.0;
    for (int i = 0; i < n; i++) {
        double sc = weight(v, i, v->x[i]), second = v->ft[i];
        for (int j = 0; j < n; j++) second += v->jac[i + j * n] * v->f[j];
        d0 = fmax(d0, fabs(v->x[i]) / sc);
        d1 = fmax(d1, fabs(v->f[i]) / sc);
        d2 = fmax(d2, fabs(second) / sc);
    }
    if (!(d1 > 0.0) && !(d2 > 0.0)) return 0.0;
    double h0 = d0 > 1e-5 && d1 > 1e-5 ? 0.01 * d0 / d1 : DBL_MAX;
    return fmin(100.0 * h0, pow(0.01 / fmax(d1, d2), 1.0 / ORDER));
}

/* The eight stages. Returns the index of a state whose value or derivative is not finite, or -1. */
static int stages(pam_solver *v, double h) {
    int n = v->model->nc;
    double t = v->s->t;
    for (int i = 0; i < PAM_STAGES; i++) {
        double *k = v->k + i * n;
        const double *f = v->f;
        if (i > 0) {
            for (int r = 0; r < n; r++) {
                double x = i < 6 ? v->x[r] : v->stage[r] + v->k[(i - 1) * n + r];
                if (i < 6)
                    for (int j = 0; j < i; j++) x += A[i][j] * v->k[j * n + r];
                v->stage[r] = x;
            }
            evaluate(v, t + NODE[i] * h, v->stage, v->rhs);
            f = v->rhs;
        }
        for (int r = 0; r < n; r++) {
            double sum = 0.0;
            for (int j = 0; j < i; j++) sum += C[i][j] * v->k[j * n + r];
            k[r] = f[r] + h * D[i] * v->ft[r] + sum / h;
        }
        int bad = first_not_finite(n, k);
        if (bad >= 0) return bad;
        lu_solve(n, v->lu, v->pivot, k);
    }
    for (int r = 0; r < n; r++) v->x1[r] = v->stage[r] + v->k[7 * n + r];
    return first_not_finite(n, v->x1);
}

static int factorise(pam_solver *v, double h) {
    int n = v->model->nc;
    for (int i = 0; i < n * n; i++) v->lu[i] = -v->jac[i];
    for (int i = 0; i < n; i++) v->lu[i + i * n] += 1.0 / (GAMMA * h);
    return lu_factorise(n, v->lu, v->pivot);
}

/* Largest error over the states in units of the tolerance; which state it is. */
static double error_norm(const pam_solver *v, int *worst) {
    int n = v->model->nc;
    double norm = 0.0;
    for (int i = 0; i < n; i++) {
        double e = fabs(v->k[7 * n + i]) / weight(v, i, fmax(fabs(v->x[i]), fabs(v->x1[i])));
        if (!(e <= norm)) {
            norm = e;
            *worst = i;
        }
    }
    return norm;
}

static void dense_output(pam_solver *v) {
    int n = v->model->nc;
    for (int q = 0; q < 3; q++)
        for (int r = 0; r < n; r++) {
            double sum = 0.0;
            for (int j = 0; j < PAM_STAGES; j++) sum += H[q][j] * v->k[j * n + r];
            v->dense[q * n + r] = sum;
        }
}

static int fail_not_finite(pam_solver *v) {
    int n = v->model->nc, bad = first_not_finite(n, v->f);
    const char *const *names = v->model->state_names;
    if (bad >= 0) {
        snprintf(v->message, sizeof v->message, "the derivative of '%s' is not a finite number at time %.9g s",
                 names[bad], v->s->t);
        return 1;
    }
    bad = first_not_finite(n * n, v->jac);
    if (bad >= 0)
        snprintf(v->message, sizeof v->message,
                 "the slope of der('%s') with respect to '%s' is not a finite number at time %.9g s",
                 names[bad % n], names[bad / n], v->s->t);
    else
        snprintf(v->message, sizeof v->message,
                 "the slope of der('%s') with respect to time is not a finite number at time %.9g s",
                 names[first_not_finite(n, v->ft)], v->s->t);
    return 1;
}

static int fail_step(pam_solver *v, const char *what, double h, int worst, int finite) {
    snprintf(v->message, sizeof v->message,
             "%s at time %.9g s (step %.3g s); %s '%s', which is %.9g with derivative %.9g", what, v->s->t, h,
             finite ? "the largest error is in" : "values that are not finite numbers come up for",
             v->model->state_names[worst], v->x[worst], v->f[worst]);
    return 1;
}

/* Puts the step that begins now on the lines of the delayed inputs that act from now on. Returns the time of the
 * next change; one that only rounding separates from now takes place now.
 */
static double enter_lines(pam_solver *v, double smallest) {
    pam_solver_scalars *s = v->s;
    double next_change = s->t;
    while (next_change - s->t <= smallest) {
        s->t = next_change;
        next_change = INFINITY;
        for (int i = 0; i < v->model->nd; i++) {
            const pam_segment *next, *now = pam_history_at(&v->past[i], v->delay[i], s->t, &next);
            if (now->jump != 0.0 && now->time + v->delay[i] >= s->t - smallest) s->estimate = 1;
            if (next) next_change = fmin(next_change, next->time + v->delay[i]);
        }
    }
    if (v->model->nd) pam_solver_delayed_values(v, s->t, v->d, v->dd);
    return next_change;
}

/* Finds a step that meets the tolerance; it becomes the pending step. Returns 1 with a message on failure. */
static int take_step(pam_solver *v, double target, int *budget) {
    const pam_model *m = v->model;
    pam_solver_scalars *s = v->s;
    int n = m->nc, rejected = 0, worst = 0;
    double smallest = 16.0 * DBL_EPSILON * fmax(fabs(s->t), fabs(target));
    double change = enter_lines(v, smallest), room = change - s->t;
    linearise(v);
    if (first_not_finite(n, v->f) >= 0 || first_not_finite(n * n, v->jac) >= 0 || first_not_finite(n, v->ft) >= 0)
        return fail_not_finite(v);
    double h = s->h_next;
    if (s->estimate) {
        double guess = estimate_step(v);
        h = guess > 0.0 && h > 0.0 ? fmin(h, guess) : guess > 0.0 ? guess : h > 0.0 ? h : target - s->t;
        s->estimate = 0;
        s->error_previous = 1.0;
    }
    for (;;) {
        if (m->max_step > 0.0) h = fmin(h, m->max_step);
        double wished = h, error = INFINITY;
        int bad = -1, ends_at_change = h >= room;
        if (ends_at_change) h = room;
        if (!factorise(v, h) && (bad = stages(v, h)) < 0) error = error_norm(v, &worst);
        if (error <= 1.0) {
            double factor = SAFETY * pow(fmax(error, 1e-10), -INTEGRAL / ORDER)
                          * pow(s->error_previous, PROPORTIONAL / ORDER);
            factor = fmin(rejected ? 1.0 : GROW, fmax(SHRINK, factor));
            s->error_previous = fmax(error, 1e-4);
            s->h = h;
            s->until = ends_at_change ? change : s->t + h;
            s->truncated = 0;
            s->h_next = ends_at_change ? fmax(wished, h * factor) : h * factor;
            s->statistics.steps++;
            dense_output(v);
            return v->model->ns && !s->plain ? pam_sensitivity_step(v) : 0;
        }
        rejected = 1;
        s->statistics.rejected++;
        if (bad >= 0) worst = bad;
        if (--*budget <= 0) return fail_step(v, "the solver needs too many steps", h, worst, bad < 0);
        h *= isfinite(error) ? fmin(0.9, fmax(0.1, SAFETY * pow(error, -1.0 / ORDER))) : 0.25;
        if (!(h > smallest)) return fail_step(v, "the solver's step became too small", h, worst, bad < 0);
    }
}

/* Goes to where the pending step is of no more use. */
static void leave_step(pam_solver *v) {
    size_t size = sizeof(double) * (size_t)v->model->nx;
    if (v->s->truncated) {
        v->s->statistics.restarts++;
        pam_solver_state(v, v->s->until, v->stage);
        memcpy(v->x, v->stage, size);
    } else {
        memcpy(v->x, v->x1, size);
    }
    v->s->t = v->s->until;
    v->s->h = 0.0;
}

static int refused(pam_solver *v, double t) { return v->accept && v->accept(v->owner, t); }

int pam_solver_advance(pam_solver *v, double t) {
    int budget = PAM_MAX_STEPS_PER_CALL;
    if (v->model->nx == 0) {
        if (refused(v, t)) return 1;
        v->s->t = t;
        return 0;
    }
    while (v->s->h == 0.0 || v->s->until < t) {
        if (v->s->h > 0.0) {
            if (refused(v, v->s->until)) return 1;
            leave_step(v);
        }
        if (--budget <= 0) return fail_step(v, "the solver needs too many steps", v->s->h_next, 0, 1);
        if (take_step(v, t, &budget)) return 1;
    }
    return refused(v, t);
}
