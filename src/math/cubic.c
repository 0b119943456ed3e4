/*
 * cubic - normal equations from the moments of the points about the origin, in units of their
 * reach, solved by Cholesky's method; see cubic.h.
 */
#include "math/cubic.h"

#include <string.h>

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

/* Points in the frame, in units of their reach, with their weights. */
enum { BLOCK = 64 };
struct block {
    size_t n;
    double part[BLOCK], u[BLOCK], v[BLOCK], w[BLOCK];
};

/* The sums by v^0 to v^2, in registers: two of them in each. */
static void add_low(struct moments *m, const struct block *b)
{
    double s0[8], s1[6], s2[6];
    memcpy(s0, m->power[0], sizeof s0);
    memcpy(s1, m->power[1], sizeof s1);
    memcpy(s2, m->power[2], sizeof s2);
    for (size_t k = 0; k < b->n; k++) {
        double up[8], u = b->u[k], v = b->v[k];
        up[0] = b->part[k];
        for (int i = 1; i < 8; i++)
            up[i] = up[i - 1] * u;
        for (int i = 0; i < 8; i++)
            s0[i] += up[i];
        for (int i = 0; i < 6; i++)
            s1[i] += up[i] *= v;
        for (int i = 0; i < 6; i++)
            s2[i] += up[i] *= v;
    }
    memcpy(m->power[0], s0, sizeof s0);
    memcpy(m->power[1], s1, sizeof s1);
    memcpy(m->power[2], s2, sizeof s2);
}

/* The others. */
static void add_high(struct moments *m, const struct block *b)
{
    double s3[4], s4[4], s5[2], s6[2], h[10];
    memcpy(s3, m->power[3], sizeof s3);
    memcpy(s4, m->power[4], sizeof s4);
    memcpy(s5, m->power[5], sizeof s5);
    memcpy(s6, m->power[6], sizeof s6);
    memcpy(h, m->w, sizeof h);
    for (size_t k = 0; k < b->n; k++) {
        double up[4], u = b->u[k], v = b->v[k], part = b->part[k], w = b->w[k];
        up[0] = part;
        for (int i = 1; i < 4; i++)
            up[i] = up[i - 1] * u;
        for (int i = 0; i < 4; i++)
            s3[i] += up[i] = up[i] * v * v * v;
        for (int i = 0; i < 4; i++)
            s4[i] += up[i] *= v;
        for (int i = 0; i < 2; i++)
            s5[i] += up[i] *= v;
        for (int i = 0; i < 2; i++)
            s6[i] += up[i] *= v;
        double u2 = u * u, v2 = v * v, pw = part * w;
        h[0] += pw;
        h[1] += pw * u;
        h[2] += pw * v;
        h[3] += pw * u2;
        h[4] += pw * u * v;
        h[5] += pw * v2;
        h[6] += pw * u2 * u;
        h[7] += pw * u2 * v;
        h[8] += pw * u * v2;
        h[9] += pw * v2 * v;
    }
    memcpy(m->power[3], s3, sizeof s3);
    memcpy(m->power[4], s4, sizeof s4);
    memcpy(m->power[5], s5, sizeof s5);
    memcpy(m->power[6], s6, sizeof s6);
    memcpy(m->w, h, sizeof h);
}

/* The points in a frame, by their reach; returns how many count. */
static size_t add_points(struct moments *m, const struct quadric *frame, double size,
                         const struct vec3 *point, const double *weight, size_t n)
{
    size_t count = 0;
    struct block b = {.n = 0};
    for (size_t i = 0; i < n;) {
        for (b.n = 0; i < n && b.n < BLOCK; i++) {
            struct vec3 d = vec_sub(point[i], frame->origin);
            b.part[b.n] = weight ? weight[i] : 1;
            b.u[b.n] = vec_dot(d, frame->u);
            b.v[b.n] = vec_dot(d, frame->v);
            b.w[b.n] = vec_dot(d, frame->w);
            b.n += b.part[b.n] != 0;
        }
        for (size_t k = 0; k < b.n; k++) {
            b.u[k] /= size;
            b.v[k] /= size;
        }
        count += b.n;
        add_low(m, &b);
        add_high(m, &b);
    }
    return count;
}

/* The factor of the sums of products, in the upper half of a; -1 when a term depends on others. */
static int factor(const struct moments *m, double a[TERMS][TERMS])
{
    for (int i = 0; i < TERMS; i++)
        for (int j = i; j < TERMS; j++)
            a[i][j] = m->power[V[i] + V[j]][U[i] + U[j]];
    for (int k = 0; k < TERMS; k++) {
        if (!(a[k][k] > INDEPENDENT * m->power[2 * V[k]][2 * U[k]]))
            return -1;
        a[k][k] = sqrt(a[k][k]);
        for (int j = k + 1; j < TERMS; j++)
            a[k][j] /= a[k][k];
        for (int i = k + 1; i < TERMS; i++)
            for (int j = i; j < TERMS; j++)
                a[i][j] -= a[k][i] * a[k][j];
    }
    return 0;
}

/* What is solved at once: the heights, and the unit vectors that pick c0, c1 and c2, of whose
 * solutions y the variance of the coefficient is |y|^2. */
enum { HEIGHTS, PICKED, SIDES = 4 };

/* U' y = b for all of them; y is b to begin with. */
static void solve_forward(double a[TERMS][TERMS], double y[TERMS][SIDES])
{
    for (int i = 0; i < TERMS; i++) {
        for (int s = 0; s < SIDES; s++)
            y[i][s] /= a[i][i];
        for (int j = i + 1; j < TERMS; j++)
            for (int s = 0; s < SIDES; s++)
                y[j][s] -= a[i][j] * y[i][s];
    }
}

/* Variance of one coefficient. */
static double variance_of(double y[TERMS][SIDES], int term)
{
    double sum2 = 0;
    for (int i = term; i < TERMS; i++)
        sum2 += y[i][PICKED + term] * y[i][PICKED + term];
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
    double a[TERMS][TERMS], y[TERMS][SIDES], x[TERMS];
    cubic->origin = origin;
    cubic->w = guess;
    cubic->u = vec_perpendicular(guess);
    cubic->v = vec_cross(guess, cubic->u);
    double size = n > 0 ? vec_distance(point[n - 1], origin) : 0;
    if (!(size > 0))
        return -1;
    size_t count = add_points(&m, cubic, size, point, weight, n);
    if (count < TERMS || factor(&m, a) < 0)
        return -1;
    for (int i = 0; i < TERMS; i++) {
        y[i][HEIGHTS] = m.w[i];
        for (int s = PICKED; s < SIDES; s++)
            y[i][s] = i == s - PICKED;
    }
    solve_forward(a, y);
    for (int i = TERMS - 1; i >= 0; i--) {
        x[i] = y[i][HEIGHTS];
        for (int j = i + 1; j < TERMS; j++)
            x[i] -= a[i][j] * x[j];
        x[i] /= a[i][i];
    }
    for (int i = 0; i < TERMS; i++)
        cubic->c[i] = x[i] / power_of(size, U[i] + V[i]);
    double slope = variance_of(y, 1) + variance_of(y, 2);
    if (slope * m.power[0][0] > UNCERTAIN)
        return -1;
    cubic->variance = variance_of(y, 0);
    cubic->tilt = slope / (size * size);
    return 0;
}
