/*
 * elementary - sin, atan2, pow, hypot and their like, with the same result on every machine, C
 * library, compiler and level of optimisation.  Included in place of <math.h>, whose functions
 * differ in the last digit from one library to the next; what stands below is done by + - * / and
 * sqrt alone, which IEEE 754 rounds in one way.
 *
 * Errors are below 0.52 units in the last place for atan2, atan, asin, acos, exp, log, log10, pow;
 * 0.6 for hypot, cbrt; 0.95 for sin, cos, tan; 2 for sinh, cosh, asinh, log1p (check_elementary.c
 * measures them).  Special values are those of C11, annex F; errno and exceptions are left alone.
 *
 * Of <math.h> are exact, and used as they are: sqrt fabs floor ceil trunc round lround fmod
 * remainder ldexp frexp copysign.
 */
#ifndef CLOUDMILL_ELEMENTARY_H
#define CLOUDMILL_ELEMENTARY_H

#include <math.h>

double elementary_sin(double x);
double elementary_cos(double x);
double elementary_tan(double x);
double elementary_atan2(double y, double x);
double elementary_asin(double x);
double elementary_acos(double x);
double elementary_exp(double x);
double elementary_log(double x);
double elementary_log10(double x);
double elementary_log1p(double x);
double elementary_pow(double x, double y);
double elementary_sinh(double x);
double elementary_cosh(double x);
double elementary_asinh(double x);
double elementary_hypot(double x, double y);
double elementary_cbrt(double x);

/* Both of one angle, to the bit as elementary_sin and elementary_cos say them: the angle is reduced
 * once. */
struct sine_cosine {
    double sine, cosine;
};
struct sine_cosine elementary_sine_cosine(double x);

/* C leaves open which zero fmax(0, -0) is: here the first of two equals.  A NaN, b if b != b, gives
 * the other. */
static inline double elementary_fmax(double a, double b)
{
    return a >= b || b != b ? a : b;
}

static inline double elementary_fmin(double a, double b)
{
    return a <= b || b != b ? a : b;
}

/* fmax and fmin for what is a number, in one instruction. */
static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

static inline double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* -1 where hypot(x, y) < limit, 1 where it is above it, 0 where it is that or one of them is NaN.
 * The squares tell, but where rounding might. */
static inline int elementary_hypot_compare(double x, double y, double limit)
{
    const double tiny = 1e-200, nearly = 1e-12;
    double square = x * x + y * y, most = limit * limit;

    if (limit > 0 && most > tiny && square < (1 - nearly) * most)
        return -1;
    if (limit > 0 && most > tiny && square > (1 + nearly) * most)
        return 1;
    double h = elementary_hypot(x, y);
    return (h > limit) - (h < limit);
}

/* Formulas keep the names that they have in books. */
#define sin(x) elementary_sin(x)
#define cos(x) elementary_cos(x)
#define tan(x) elementary_tan(x)
#define atan(x) elementary_atan2(x, 1)
#define atan2(y, x) elementary_atan2(y, x)
#define asin(x) elementary_asin(x)
#define acos(x) elementary_acos(x)
#define exp(x) elementary_exp(x)
#define log(x) elementary_log(x)
#define log10(x) elementary_log10(x)
#define log1p(x) elementary_log1p(x)
#define pow(x, y) elementary_pow(x, y)
#define sinh(x) elementary_sinh(x)
#define cosh(x) elementary_cosh(x)
#define asinh(x) elementary_asinh(x)
#define hypot(x, y) elementary_hypot(x, y)
#define hypot_compare(x, y, limit) elementary_hypot_compare(x, y, limit)
#define cbrt(x) elementary_cbrt(x)
#define fmax(a, b) elementary_fmax(a, b)
#define fmin(a, b) elementary_fmin(a, b)

#endif
