/* A model as data: in the place of the generated C stand lists of operations, so that no compiler is needed.
 *
 * Each operation is the one that CasADi writes as C, in the same order: the numbers are the same to the last bit. It
 * is for models that are run a few times; a compiled one runs faster. The lists come from pam_cosim/fmu/tape.py.
 */
#include <math.h>
#include <stddef.h>

#define PAM_MODEL_CONST
#include "pam_model.h"

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif

/* In the order of OPERATIONS in pam_cosim/fmu/tape.py. */
enum {
    CONST, INPUT, OUTPUT, ASSIGN, ADD, SUB, MUL, DIV, NEG, EXP, LOG, POW, CONSTPOW, SQRT, SQ, TWICE, SIN, COS, TAN,
    ASIN, ACOS, ATAN, LT, LE, EQ, NE, NOT, AND, OR, FLOOR, CEIL, FMOD, FABS, SIGN, COPYSIGN, IF_ELSE_ZERO, ERF, FMIN,
    FMAX, INV, SINH, COSH, TANH, ASINH, ACOSH, ATANH, ATAN2
};

/* w[to] = operation(w[a], w[b]); INPUT: w[to] = arg[a][b]; OUTPUT: res[to][b] = w[a]; CONST: w[to] = constants[a]. */
typedef struct {
    int operation, to, a, b;
} pam_operation;

typedef struct {
    long long count;
    const pam_operation *operations;
    const double *constants;
} pam_tape;

/* In the order of the functions of pam_model. */
enum { RHS, OUT, LOC, CORE_RHS, LIN, VARIATION, JVP, INIT, INIT_JVP, DELAY, CHECK, FUNCTIONS };

static pam_tape tapes[FUNCTIONS];

pam_model pam_the_model;

static void play(const pam_tape *tape, const double **arg, double **res, double *w) {
    const pam_operation *end = tape->operations + tape->count;
    for (const pam_operation *o = tape->operations; o != end; o++) {
        double a, b;
        if (o->operation == INPUT) {
            w[o->to] = arg[o->a] ? arg[o->a][o->b] : 0.0;
            continue;
        }
        if (o->operation == OUTPUT) {
            if (res[o->to]) res[o->to][o->b] = w[o->a];
            continue;
        }
        if (o->operation == CONST) {
            w[o->to] = tape->constants[o->a];
            continue;
        }
        a = w[o->a];
        b = w[o->b];
        switch (o->operation) {
            case ASSIGN: break;
            case ADD: a = a + b; break;
            case SUB: a = a - b; break;
            case MUL: a = a * b; break;
            case DIV: a = a / b; break;
            case NEG: a = -a; break;
            case EXP: a = exp(a); break;
            case LOG: a = log(a); break;
            case POW: a = pow(a, b); break;
            case CONSTPOW: a = pow(a, b); break;
            case SQRT: a = sqrt(a); break;
            case SQ: a = a * a; break;
            case TWICE: a = 2.0 * a; break;
            case SIN: a = sin(a); break;
            case COS: a = cos(a); break;
            case TAN: a = tan(a); break;
            case ASIN: a = asin(a); break;
            case ACOS: a = acos(a); break;
            case ATAN: a = atan(a); break;
            case LT: a = a < b; break;
            case LE: a = a <= b; break;
            case EQ: a = a == b; break;
            case NE: a = a != b; break;
            case NOT: a = !(a != 0.0); break;
            case AND: a = a != 0.0 && b != 0.0; break;
            case OR: a = a != 0.0 || b != 0.0; break;
            case FLOOR: a = floor(a); break;
            case CEIL: a = ceil(a); break;
            case FMOD: a = fmod(a, b); break;
            case FABS: a = fabs(a); break;
            case SIGN: a = a < 0.0 ? -1.0 : a > 0.0 ? 1.0 : a; break;
            case COPYSIGN: a = copysign(a, b); break;
            case IF_ELSE_ZERO: a = a != 0.0 ? b : 0.0; break;
            case ERF: a = erf(a); break;
            case FMIN: a = fmin(a, b); break;
            case FMAX: a = fmax(a, b); break;
            case INV: a = 1.0 / a; break;
            case SINH: a = sinh(a); break;
            case COSH: a = cosh(a); break;
            case TANH: a = tanh(a); break;
            case ASINH: a = asinh(a); break;
            case ACOSH: a = acosh(a); break;
            case ATANH: a = atanh(a); break;
            case ATAN2: a = atan2(a, b); break;
            default: a = NAN;
        }
        w[o->to] = a;
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

/* What the library is a model of from now on, as long as the memory that is given here lasts; to be called before
 * there is an instance. A function without operations is none: count is negative.
 */
EXPORT void pam_use_tapes(const pam_model *model, const pam_tape given[]) {
    static const pam_function functions[FUNCTIONS] = {rhs, out,  loc,      core_rhs, lin,  variation,
                                                      jvp, init, init_jvp, delay,    check};
    pam_function *slots[FUNCTIONS] = {
        &pam_the_model.rhs,       &pam_the_model.out, &pam_the_model.loc,  &pam_the_model.core_rhs, &pam_the_model.lin,
        &pam_the_model.variation, &pam_the_model.jvp, &pam_the_model.init, &pam_the_model.init_jvp, &pam_the_model.delay,
        &pam_the_model.check,
    };
    pam_the_model = *model;
    for (int i = 0; i < FUNCTIONS; i++) {
        tapes[i] = given[i];
        *slots[i] = given[i].count < 0 ? NULL : functions[i];
    }
}
