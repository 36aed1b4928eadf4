/* A model as data: in the place of the generated C stand lists of operations, so that no compiler is needed.
 *
 * Each operation is the one that CasADi writes as C, in the same order: the numbers are the same to the last bit. It
 * is for models that are run a few times; a compiled one runs faster. The lists come from pam_cosim/fmu/tape.py.
 */
#include <math.h>
#include <stddef.h>
#include <string.h>

#define PAM_MODEL_CONST
#include "pam_model.h"

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

/* In the order of OPERATIONS in pam_cosim/fmu/tape.py. */
enum {
    OUTPUT, ASSIGN, ADD, SUB, MUL, DIV, NEG, EXP, LOG, POW, CONSTPOW, SQRT, SQ, TWICE, SIN, COS, TAN, ASIN, ACOS, ATAN,
    LT, LE, EQ, NE, NOT, AND, OR, FLOOR, CEIL, FMOD, FABS, SIGN, COPYSIGN, IF_ELSE_ZERO, ERF, FMIN, FMAX, INV, SINH,
    COSH, TANH, ASINH, ACOSH, ATANH, ATAN2
};

/* w[to] = operation(w[a], w[b]); OUTPUT: res[to][b] = w[a], and there is a w[b] too. */
typedef struct {
    int operation, to, a, b;
} pam_operation;

/* Before the first operation w holds the constants, then the arguments one after another. */
typedef struct {
    long long count;
    const pam_operation *operations;
    const double *constants;
    int constant_count, argument_count;
    const int *argument_sizes;
} pam_tape;

/* In the order of the functions of pam_model. */
enum { RHS, OUT, LOC, CORE_RHS, LIN, VARIATION, JVP, INIT, INIT_JVP, DELAY, CHECK, START_LIN, START_VARIATION,
    START_JVP, FUNCTIONS };

static pam_tape tapes[FUNCTIONS];

pam_model pam_the_model;

static void play(const pam_tape *tape, const double **arg, double **res, double *w) {
    double *to = w + tape->constant_count;
    memcpy(w, tape->constants, sizeof(double) * (size_t)tape->constant_count);
    for (int i = 0; i < tape->argument_count; to += tape->argument_sizes[i++])
        for (int k = 0; k < tape->argument_sizes[i]; k++) to[k] = arg[i] ? arg[i][k] : 0.0;
    const pam_operation *end = tape->operations + tape->count;
    for (const pam_operation *o = tape->operations; o != end; o++) {
        const double a = w[o->a], b = w[o->b];
        double *const r = w + o->to;
        switch (o->operation) {
            case ADD: *r = a + b; break;
            case SUB: *r = a - b; break;
            case MUL: *r = a * b; break;
            case DIV: *r = a / b; break;
            case OUTPUT:
                if (res[o->to]) res[o->to][o->b] = a;
                break;
            case ASSIGN: *r = a; break;
            case NEG: *r = -a; break;
            case EXP: *r = exp(a); break;
            case LOG: *r = log(a); break;
            case POW: *r = pow(a, b); break;
            case CONSTPOW: *r = pow(a, b); break;
            case SQRT: *r = sqrt(a); break;
            case SQ: *r = a * a; break;
            case TWICE: *r = 2.0 * a; break;
            case SIN: *r = sin(a); break;
            case COS: *r = cos(a); break;
            case TAN: *r = tan(a); break;
            case ASIN: *r = asin(a); break;
            case ACOS: *r = acos(a); break;
            case ATAN: *r = atan(a); break;
            case LT: *r = a < b; break;
            case LE: *r = a <= b; break;
            case EQ: *r = a == b; break;
            case NE: *r = a != b; break;
            case NOT: *r = !(a != 0.0); break;
            case AND: *r = a != 0.0 && b != 0.0; break;
            case OR: *r = a != 0.0 || b != 0.0; break;
            case FLOOR: *r = floor(a); break;
            case CEIL: *r = ceil(a); break;
            case FMOD: *r = fmod(a, b); break;
            case FABS: *r = fabs(a); break;
            case SIGN: *r = a < 0.0 ? -1.0 : a > 0.0 ? 1.0 : a; break;
            case COPYSIGN: *r = copysign(a, b); break;
            case IF_ELSE_ZERO: *r = a != 0.0 ? b : 0.0; break;
            case ERF: *r = erf(a); break;
            case FMIN: *r = fmin(a, b); break;
            case FMAX: *r = fmax(a, b); break;
            case INV: *r = 1.0 / a; break;
            case SINH: *r = sinh(a); break;
            case COSH: *r = cosh(a); break;
            case TANH: *r = tanh(a); break;
            case ASINH: *r = asinh(a); break;
            case ACOSH: *r = acosh(a); break;
            case ATANH: *r = atanh(a); break;
            case ATAN2: *r = atan2(a, b); break;
            default: *r = NAN;
        }
    }
}

#define FUNCTION(name, number)                                                                  \
    static int name(const double **arg, double **res, long long *iw, double *w, int mem) {      \
        (void)iw;                                                                               \
        (void)mem;                                                                              \
        play(tapes + (number), arg, res, w);                                                    \
        return 0;                                                                               \
    }

FUNCTION(rhs, RHS)
FUNCTION(out, OUT)
FUNCTION(loc, LOC)
FUNCTION(core_rhs, CORE_RHS)
FUNCTION(lin, LIN)
FUNCTION(variation, VARIATION)
FUNCTION(jvp, JVP)
FUNCTION(init, INIT)
FUNCTION(init_jvp, INIT_JVP)
FUNCTION(delay, DELAY)
FUNCTION(check, CHECK)
FUNCTION(start_lin, START_LIN)
FUNCTION(start_variation, START_VARIATION)
FUNCTION(start_jvp, START_JVP)

/* What the library is a model of from now on, as long as the memory that is given here lasts; to be called before
 * there is an instance. A function without operations is none: count is negative.
 */
EXPORT void pam_use_tapes(const pam_model *model, const pam_tape given[]) {
    static const pam_function functions[FUNCTIONS] = {rhs, out,  loc,      core_rhs, lin,  variation,
                                                      jvp, init, init_jvp, delay,    check,
                                                      start_lin, start_variation, start_jvp};
    pam_function *slots[FUNCTIONS] = {
        &pam_the_model.rhs,       &pam_the_model.out, &pam_the_model.loc,  &pam_the_model.core_rhs, &pam_the_model.lin,
        &pam_the_model.variation, &pam_the_model.jvp, &pam_the_model.init, &pam_the_model.init_jvp, &pam_the_model.delay,
        &pam_the_model.check, &pam_the_model.start_lin, &pam_the_model.start_variation, &pam_the_model.start_jvp,
    };
    pam_the_model = *model;
    for (int i = 0; i < FUNCTIONS; i++) {
        tapes[i] = given[i];
        *slots[i] = given[i].count < 0 ? NULL : functions[i];
    }
}
