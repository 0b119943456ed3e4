/*
 * cubic - normal equations from the moments of the points about the origin, in units of their
 * reach, solved by Cholesky's method; see cubic.h.
 */
#include "math/cubic.h"

enum { TERMS = 10, DEGREE = 3 };

/* Part of a term that the terms before it must leave over. */
static const double INDEPENDENT = 1e-3;

/* Variance of the slope at the origin, times the weight of the points, in units of their reach:
 * some 100 where they are spread evenly, thousands where they are to one side, and from 50,000 on
 * where they are on three lines, between which a cubic may swing as it likes. */
static const double UNCERTAIN = 20000;

/* Powers of u and v in each term, in the order of quadric.c. */
static const int U[TERMS] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0};
static const int V[TERMS] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};

/* Sums of u^i v^j in power[j][i], and of each term with w. */
struct moments {
    double power[2 * DEGREE + 1][2 * DEGREE + 2];
    double w[TERMS];
};

/* All powers of u by one of v, two at a time: so many that their number is even. */
static inline void add_point(struct moments *m, double part, double u, double v, double w)
{
    double up[2 * DEGREE + 2] = {part};
    for (int i = 0; i <= 2 * DEGREE; i++)
        up[i + 1] = up[i] * u;
    for (int j = 0; j <= 2 * DEGREE; j++) {
        for (int i = 0; i < ((2 * DEGREE + 2 - j) & ~1); i++) {
            m->power[j][i] += up[i];
            up[i] *= v;
        }
    }
    double u2 = u * u, v2 = v * v, pw = part * w;
    m->w[0] += pw;
    m->w[1] += pw * u;
    m->w[2] += pw * v;
    m->w[3] += pw * u2;
    m->w[4] += pw * u * v;
    m->w[5] += pw * v2;
    m->w[6] += pw * u2 * u;
    m->w[7] += pw * u2 * v;
    m->w[8] += pw * u * v2;
    m->w[9] += pw * v2 * v;
}

/* The factor of the sums of products, in the upper half of a; -1 when a term depends on others. */
static int factor(const struct moments *m, double a[TERMS][TERMS])
{
    for (int i = 0; i < TERMS; i++) {
        for (int j = i; j < TERMS; j++) {
            a[i][j] = m->power[V[i] + V[j]][U[i] + U[j]];
            for (int k = 0; k < i; k++)
                a[i][j] -= a[k][i] * a[k][j];
            if (j > i)
                a[i][j] /= a[i][i];
            else if (!(a[i][i] > INDEPENDENT * m->power[2 * V[i]][2 * U[i]]))
                return -1;
            else
                a[i][i] = sqrt(a[i][i]);
        }
    }
    return 0;
}

/* U' y = b */
static void solve_forward(double a[TERMS][TERMS], const double b[TERMS], double y[TERMS])
{
    for (int i = 0; i < TERMS; i++) {
        y[i] = b[i];
        for (int k = 0; k < i; k++)
            y[i] -= a[k][i] * y[k];
        y[i] /= a[i][i];
    }
}

/* Variance of one coefficient: |y|^2, U' y = the unit vector that picks it. */
static double variance_of(double a[TERMS][TERMS], int term)
{
    double pick[TERMS] = {0}, y[TERMS], sum2 = 0;
    pick[term] = 1;
    solve_forward(a, pick, y);
    for (int i = term; i < TERMS; i++)
        sum2 += y[i] * y[i];
    return sum2;
}

static double power_of(double x, int n)
{
    return n == 0 ? 1 : x * power_of(x, n - 1);
}

int cubic_fit(const struct vec3 *point, const double *weight, size_t n, struct vec3 origin,
              struct vec3 guess, struct quadric *cubic)
{
    struct moments m = {{{0}}, {0}};
    double a[TERMS][TERMS], x[TERMS];
    size_t count = 0;
    cubic->origin = origin;
    cubic->w = guess;
    cubic->u = vec_perpendicular(guess);
    cubic->v = vec_cross(guess, cubic->u);
    double size = n > 0 ? vec_distance(point[n - 1], origin) : 0;
    if (!(size > 0))
        return -1;
    for (size_t i = 0; i < n; i++) {
        double part = weight ? weight[i] : 1;
        struct vec3 d = vec_sub(point[i], origin);
        if (part == 0)
            continue;
        add_point(&m, part, vec_dot(d, cubic->u) / size, vec_dot(d, cubic->v) / size,
                  vec_dot(d, cubic->w));
        count++;
    }
    if (count < TERMS || factor(&m, a) < 0)
        return -1;
    solve_forward(a, m.w, x);
    for (int i = TERMS - 1; i >= 0; i--) {
        for (int j = i + 1; j < TERMS; j++)
            x[i] -= a[i][j] * x[j];
        x[i] /= a[i][i];
    }
    for (int i = 0; i < TERMS; i++)
        cubic->c[i] = x[i] / power_of(size, U[i] + V[i]);
    double slope = variance_of(a, 1) + variance_of(a, 2);
    if (slope * m.power[0][0] > UNCERTAIN)
        return -1;
    cubic->variance = variance_of(a, 0);
    cubic->tilt = slope / (size * size);
    return 0;
}
