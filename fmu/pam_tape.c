/* A model as data: in the place of the generated C stand lists of operations, so that no compiler is needed.
 *
 * Each operation is one that CasADi writes as C, with the same operands: the numbers are the same to the last bit.
 * Operations of one kind stand together, so that the kind is looked up once for many. It is for models that are run a
 * few times; a compiled one runs faster. The lists come from pam_cosim/fmu/tape.py.
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

/* w[to] = operation(w[a], w[b]) and so on with w[to + 1]; OUTPUT: res[to][b] = w[a]. */
typedef struct {
    int operation, count, to;
} pam_batch;

typedef struct {
    int a, b;
} pam_operands;

/* Before the first operation w holds the constants, then the arguments one after another. The operands of all batches
 * follow one another.
 */
typedef struct {
    long long count;
    const pam_batch *batches;
    const pam_operands *operands;
    const double *constants;
    int constant_count, argument_count;
    const int *argument_sizes;
} pam_tape;

/* In the order of the functions of pam_model. */
enum { RHS, OUT, LOC, CORE_RHS, LIN, VARIATION, JVP, INIT, INIT_JVP, DELAY, CHECK, START_LIN, START_VARIATION,
    START_JVP, FUNCTIONS };

static pam_tape tapes[FUNCTIONS];

pam_model pam_the_model;

#define A w[o->a]
#define B w[o->b]
#define EACH(expression) \
    for (; o != end; o++) *r++ = (expression)

static void play(const pam_tape *tape, const double **arg, double **res, double *w) {
    double *to = w + tape->constant_count;
    memcpy(w, tape->constants, sizeof(double) * (size_t)tape->constant_count);
    for (int i = 0; i < tape->argument_count; to += tape->argument_sizes[i++])
        for (int k = 0; k < tape->argument_sizes[i]; k++) to[k] = arg[i] ? arg[i][k] : 0.0;
    const pam_operands *o = tape->operands;
    const pam_batch *last = tape->batches + tape->count;
    for (const pam_batch *batch = tape->batches; batch != last; batch++) {
        const pam_operands *end = o + batch->count;
        double *r = w + batch->to;
        switch (batch->operation) {
            case OUTPUT:
                for (double *result = res[batch->to]; o != end; o++)
                    if (result) result[o->b] = A;
                break;
            case ADD: EACH(A + B); break;
            case SUB: EACH(A - B); break;
            case MUL: EACH(A * B); break;
            case DIV: EACH(A / B); break;
            case ASSIGN: EACH(A); break;
            case NEG: EACH(-A); break;
            case EXP: EACH(exp(A)); break;
            case LOG: EACH(log(A)); break;
            case POW: EACH(pow(A, B)); break;
            case CONSTPOW: EACH(pow(A, B)); break;
            case SQRT: EACH(sqrt(A)); break;
            case SQ: EACH(A * A); break;
            case TWICE: EACH(2.0 * A); break;
            case SIN: EACH(sin(A)); break;
            case COS: EACH(cos(A)); break;
            case TAN: EACH(tan(A)); break;
            case ASIN: EACH(asin(A)); break;
            case ACOS: EACH(acos(A)); break;
            case ATAN: EACH(atan(A)); break;
            case LT: EACH(A < B); break;
            case LE: EACH(A <= B); break;
            case EQ: EACH(A == B); break;
            case NE: EACH(A != B); break;
            case NOT: EACH(!(A != 0.0)); break;
            case AND: EACH(A != 0.0 && B != 0.0); break;
            case OR: EACH(A != 0.0 || B != 0.0); break;
            case FLOOR: EACH(floor(A)); break;
            case CEIL: EACH(ceil(A)); break;
            case FMOD: EACH(fmod(A, B)); break;
            case FABS: EACH(fabs(A)); break;
            case SIGN: EACH(A < 0.0 ? -1.0 : A > 0.0 ? 1.0 : A); break;
            case COPYSIGN: EACH(copysign(A, B)); break;
            case IF_ELSE_ZERO: EACH(A != 0.0 ? B : 0.0); break;
            case ERF: EACH(erf(A)); break;
            case FMIN: EACH(fmin(A, B)); break;
            case FMAX: EACH(fmax(A, B)); break;
            case INV: EACH(1.0 / A); break;
            case SINH: EACH(sinh(A)); break;
            case COSH: EACH(cosh(A)); break;
            case TANH: EACH(tanh(A)); break;
            case ASINH: EACH(asinh(A)); break;
            case ACOSH: EACH(acosh(A)); break;
            case ATANH: EACH(atanh(A)); break;
            case ATAN2: EACH(atan2(A, B)); break;
            default: EACH(NAN);
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
