/*
 * cubic - normal equations from the moments of the points about the origin, in units of their
 * reach, solved by Cholesky's method; see cubic.h.
 */
#include "math/cubic.h"

#include <string.h>
#include "math/pair.h"

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
    pair s0[4], s1[3], s2[3];
    memcpy(s0, m->power[0], sizeof s0);
    memcpy(s1, m->power[1], sizeof s1);
    memcpy(s2, m->power[2], sizeof s2);
    for (size_t k = 0; k < b->n; k++) {
        double u = b->u[k], one = b->part[k] * u, two = one * u, three = two * u;
        double four = three * u, five = four * u, six = five * u;
        pair v = pair_both(b->v[k]);
        pair p0 = {b->part[k], one}, p1 = {two, three}, p2 = {four, five}, p3 = {six, six * u};
        s0[0] += p0, s0[1] += p1, s0[2] += p2, s0[3] += p3;
        p0 *= v, p1 *= v, p2 *= v;
        s1[0] += p0, s1[1] += p1, s1[2] += p2;
        p0 *= v, p1 *= v, p2 *= v;
        s2[0] += p0, s2[1] += p1, s2[2] += p2;
    }
    memcpy(m->power[0], s0, sizeof s0);
    memcpy(m->power[1], s1, sizeof s1);
    memcpy(m->power[2], s2, sizeof s2);
}

/* The others. */
static void add_high(struct moments *m, const struct block *b)
{
    pair s3[2], s4[2], s5, s6, h[5];
    memcpy(s3, m->power[3], sizeof s3);
    memcpy(s4, m->power[4], sizeof s4);
    memcpy(&s5, m->power[5], sizeof s5);
    memcpy(&s6, m->power[6], sizeof s6);
    memcpy(h, m->w, sizeof h);
    for (size_t k = 0; k < b->n; k++) {
        double u = b->u[k], part = b->part[k], one = part * u, two = one * u;
        pair v = pair_both(b->v[k]), p0 = {part, one}, p1 = {two, two * u};
        p0 = p0 * v * v * v, p1 = p1 * v * v * v;
        s3[0] += p0, s3[1] += p1;
        p0 *= v, p1 *= v;
        s4[0] += p0, s4[1] += p1;
        p0 *= v;
        s5 += p0;
        p0 *= v;
        s6 += p0;
        double pw = part * b->w[k], pwu = pw * u;
        pair uv = {u, b->v[k]}, square = uv * uv, pws = pair_both(pw), second = pws * square;
        h[0] += (pair){pw, pwu};
        h[1] += (pair){pw * uv[1], second[0]};  // cppcheck-suppress constStatement
        h[2] += (pair){pwu * uv[1], second[1]}; // cppcheck-suppress constStatement
        h[3] += pair_both(second[0]) * uv;
        h[4] += (pair){pwu, second[1]} * (pair){square[1], uv[1]};
    }
    memcpy(m->power[3], s3, sizeof s3);
    memcpy(m->power[4], s4, sizeof s4);
    memcpy(m->power[5], &s5, sizeof s5);
    memcpy(m->power[6], &s6, sizeof s6);
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

/* The factor of the sums of products, in the upper half of a; -1 when a term depends on others.
 * What is below the diagonal means nothing: two columns are worked on at a time. */
static int factor(const struct moments *m, double a[TERMS][TERMS])
{
    for (int i = 0; i < TERMS; i++)
        for (int j = 0; j < TERMS; j++)
            a[i][j] = m->power[V[i] + V[j]][U[i] + U[j]];
    for (int k = 0; k < TERMS; k++) {
        if (!(a[k][k] > INDEPENDENT * m->power[2 * V[k]][2 * U[k]]))
            return -1;
        double root = sqrt(a[k][k]);
        for (int j = k & ~1; j < TERMS; j += 2)
            pair_put(a[k] + j, pair_at(a[k] + j) / pair_both(root));
        a[k][k] = root;
        for (int i = k + 1; i < TERMS; i++)
            for (int j = i & ~1; j < TERMS; j += 2)
                pair_put(a[i] + j, pair_at(a[i] + j) - pair_both(a[k][i]) * pair_at(a[k] + j));
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
        pair low = pair_at(y[i]) / pair_both(a[i][i]);
        pair high = pair_at(y[i] + 2) / pair_both(a[i][i]);
        pair_put(y[i], low);
        pair_put(y[i] + 2, high);
        for (int j = i + 1; j < TERMS; j++) {
            pair part = pair_both(a[i][j]);
            pair_put(y[j], pair_at(y[j]) - part * low);
            pair_put(y[j] + 2, pair_at(y[j] + 2) - part * high);
        }
    }
}

/* Covariance of two coefficients; of one with itself, its variance. */
static double covariance_of(double y[TERMS][SIDES], int term, int other)
{
    double sum = 0;
    for (int i = other; i < TERMS; i++)
        sum += y[i][PICKED + term] * y[i][PICKED + other];
    return sum;
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
    double slope_u = covariance_of(y, 1, 1), slope = slope_u + covariance_of(y, 2, 2);
    if (slope * m.power[0][0] > UNCERTAIN)
        return -1;
    cubic->variance = covariance_of(y, 0, 0);
    cubic->tilt = slope / (size * size);
    cubic->tilt_u = slope_u / (size * size);
    cubic->tilt_uv = covariance_of(y, 1, 2) / (size * size);
    return 0;
}
