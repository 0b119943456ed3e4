/*
 * quadric - normal equations about the middle of the neighbourhood, in units of its size, solved
 * by Cholesky's method; see quadric.h.
 */
#include "math/quadric.h"

#include <stdbool.h>
#include <stdlib.h>

#include "base/array.h"
#include "math/pair.h"

enum {
    TERMS = 6,
    COLUMNS = 8,
    SOME = 1024 /* points that are brought into the frame on the stack */
};

/* Part of a term that the terms before it must leave over. */
static const double INDEPENDENT = 0.02;

/* Width of a neighbourhood by its length, up to which it is a strip. */
static const double NARROW = 0.1;

/* What the fit works in: (u - u0) / size, (v - v0) / size. */
struct span {
    double u0, v0, size;
    bool wide; /* the neighbourhood is no strip */
};

/* The eigenvalues of the sums are the squares of length and width.  Most neighbourhoods are far
 * from a strip, and need no roots to tell. */
static inline bool is_wide(double uu, double vv, double uv)
{
    const double surely = 0.976; /* width by length is 0.11 */
    double mean = (uu + vv) / 2, off = (uu - vv) / 2;

    if (off * off + uv * uv < surely * surely * mean * mean)
        return true;
    double half = hypot(off, uv);
    return mean + half > 0 && sqrt(fmax(mean - half, 0) / (mean + half)) > NARROW;
}

/* The middle of the neighbourhood and its size. */
static inline struct span span_of(const struct vec3 *local, const double *weight, size_t n)
{
    double count = 0, uv = 0;
    pair sum = {0, 0}, square = {0, 0};
    if (n == 0)
        return (struct span){0, 0, 0, false};
    pair first = pair_at(&local[0].x); /* near the middle: no digits are lost */
    for (size_t i = 0; i < n; i++) {
        double part = weight ? weight[i] : 1;
        pair at = pair_at(&local[i].x) - first, parts = weight ? pair_both(part) * at : at;
        count += part;
        sum += parts;
        square += parts * at;
        uv += parts[0] * at[1];
    }
    pair mid = sum / pair_both(count);
    square -= pair_both(count) * mid * mid;
    uv -= count * mid[0] * mid[1];
    return (struct span){first[0] + mid[0], first[1] + mid[1],
                         sqrt((square[0] + square[1]) / count), is_wide(square[0], square[1], uv)};
}

/* Sums of the products of all terms with each other and, beside them, with w: the products of two
 * terms are powers u^i v^j of which many are the same; those of u^i v^j and v^i u^j are pairs, and
 * so are others that stand alone, for then all sums stay in registers. */
static inline void add_up(struct span s, const struct vec3 *local, const double *weight, size_t n,
                          double sum[TERMS][COLUMNS])
{
    const pair none = {0, 0}, middle = {s.u0, s.v0}, shrink = pair_both(1 / s.size);
    pair d1 = none, d2 = none, d3 = none, d21 = none, d4 = none, d31 = none, w1 = none, w2 = none;
    pair both = none, alone = none;
    double count = 0;
    for (size_t k = 0; k < n; k++) {
        double part = weight ? weight[k] : 1, w = local[k].z;
        pair e = (pair_at(&local[k].x) - middle) * shrink, e2 = e * e, h = pair_both(w);
        pair p1 = weight ? pair_both(part) * e : e, p2 = p1 * e;
        double uv = p1[0] * e[1];
        if (weight)
            count += part;
        alone += (pair){weight ? part * w : w, p2[0] * e2[1]};
        both += (pair){uv, uv * w};
        d1 += p1, d2 += p2, d3 += p2 * e, d21 += p2 * pair_swap(e);
        d4 += p2 * e2, d31 += pair_both(uv) * e2;
        w1 += p1 * h, w2 += p2 * h;
    }
    const double m[5][5] = {{weight ? count : (double)n, d1[1], d2[1], d3[1], d4[1]},
                            {d1[0], both[0], d21[1], d31[1]},
                            {d2[0], d21[0], alone[1]},
                            {d3[0], d31[0]},
                            {d4[0]}};
    const double mw[TERMS] = {alone[0], w1[0], w1[1], w2[0], both[1], w2[1]};
    static const int power[TERMS][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 0}, {1, 1}, {0, 2}};
    for (int i = 0; i < TERMS; i++) {
        for (int j = 0; j < TERMS; j++)
            sum[i][j] = m[power[i][0] + power[j][0]][power[i][1] + power[j][1]];
        sum[i][TERMS] = mw[i];
        sum[i][TERMS + 1] = 0;
    }
}

/* Row i of the factor of the symmetric matrix whose upper half stands in `a`, beside the right
 * side; -1 when its term depends on those before.  What is below the diagonal means nothing: two
 * columns are worked on at a time. */
static inline int factor_row(double a[TERMS][COLUMNS], int i)
{
    double whole = a[i][i];
    pair row[COLUMNS / 2];
    for (int j = i / 2; j < COLUMNS / 2; j++)
        row[j] = pair_at(a[i] + 2 * j);
    for (int k = 0; k < i; k++)
        for (int j = i / 2; j < COLUMNS / 2; j++)
            row[j] -= pair_both(a[k][i]) * pair_at(a[k] + 2 * j);
    double left = row[i / 2][i % 2];
    if (!(left > INDEPENDENT * whole))
        return -1;
    double root = sqrt(left);
    for (int j = i / 2; j < COLUMNS / 2; j++)
        pair_put(a[i] + 2 * j, row[j] / pair_both(root));
    a[i][i] = root;
    return 0;
}

/* Solves the system that stands in `a`; -1 when a term depends on the others.  Row by row, so that
 * each has loops of known length. */
static inline int solve(double a[TERMS][COLUMNS], double x[TERMS])
{
    if (factor_row(a, 0) < 0 || factor_row(a, 1) < 0 || factor_row(a, 2) < 0 ||
        factor_row(a, 3) < 0 || factor_row(a, 4) < 0 || factor_row(a, 5) < 0)
        return -1;
    for (int i = TERMS - 1; i >= 0; i--) {
        x[i] = a[i][TERMS];
        for (int j = i + 1; j < TERMS; j++)
            x[i] -= a[i][j] * x[j];
        x[i] /= a[i][i];
    }
    return 0;
}

/* Variances of the sums of part[i] x[i], of two at a time: |y|^2, U' y = part, where U' U are the
 * sums of products; `a` holds U, as solve leaves it.  *both: their covariance. */
static pair variances_of(double a[TERMS][COLUMNS], const pair part[TERMS], double *both)
{
    pair y[TERMS], sum2 = {0, 0};
    *both = 0;
    for (int i = 0; i < TERMS; i++) {
        y[i] = part[i];
        for (int k = 0; k < i; k++)
            y[i] -= pair_both(a[k][i]) * y[k];
        y[i] /= pair_both(a[i][i]);
        sum2 += y[i] * y[i];
        *both += y[i][0] * y[i][1];
    }
    return sum2;
}

/* Of the surface over the origin, which is at u, v in units of size, and of its slopes there. */
static void find_variances(double a[TERMS][COLUMNS], struct span s, struct quadric *q)
{
    double u = -s.u0 / s.size, v = -s.v0 / s.size;
    const pair value[TERMS] = {{1, 1},         {u, u},         {v, v},
                               {u * u, u * u}, {u * v, u * v}, {v * v, v * v}};
    const pair slope[TERMS] = {{0, 0}, {1, 0}, {0, 1}, {2 * u, 0}, {v, u}, {0, 2 * v}};
    double both, size2 = s.size * s.size;
    q->variance = variances_of(a, value, &both)[0];
    pair tilt = variances_of(a, slope, &both);
    q->tilt = (tilt[0] + tilt[1]) / size2;
    q->tilt_u = tilt[0] / size2;
    q->tilt_uv = both / size2;
}

int quadric_fit(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 guess,
                struct quadric *quadric)
{
    return quadric_fit_weighted(point, NULL, n, origin, guess, quadric);
}

struct quadric quadric_frame(struct vec3 origin, struct vec3 w)
{
    struct quadric q = {.origin = origin, .w = w, .u = vec_perpendicular(w)};

    q.v = vec_cross(w, q.u);
    return q;
}

void quadric_local_all(const struct quadric *q, const struct vec3 *point, size_t n,
                       struct vec3 *local)
{
    for (size_t i = 0; i < n; i++)
        local[i] = quadric_local(q, point[i]);
}

static inline int fit_sums(const struct vec3 *local, const double *weight, size_t n, bool variances,
                           struct quadric *q)
{
    double sum[TERMS][COLUMNS], x[TERMS], *c = q->c;
    if (n < TERMS)
        return -1;
    struct span s = span_of(local, weight, n);
    if (!s.wide)
        return -1;
    add_up(s, local, weight, n, sum);
    if (solve(sum, x) < 0)
        return -1;
    if (variances)
        find_variances(sum, s, q);
    /* back to u and v: w = x0 + x1 (u - u0) / size + ... */
    double a = x[1] / s.size, b = x[2] / s.size, size2 = s.size * s.size;
    c[3] = x[3] / size2;
    c[4] = x[4] / size2;
    c[5] = x[5] / size2;
    c[1] = a - 2 * c[3] * s.u0 - c[4] * s.v0;
    c[2] = b - 2 * c[5] * s.v0 - c[4] * s.u0;
    c[0] =
        x[0] - a * s.u0 - b * s.v0 + c[3] * s.u0 * s.u0 + c[4] * s.u0 * s.v0 + c[5] * s.v0 * s.v0;
    return 0;
}

/* Most points have no weights, and need not be multiplied by them. */
static int fit_local(const struct vec3 *local, const double *weight, size_t n, struct quadric *q)
{
    return weight ? fit_sums(local, weight, n, true, q) : fit_sums(local, NULL, n, true, q);
}

int quadric_fit_local(const struct vec3 *local, size_t n, const struct quadric *frame,
                      struct quadric *quadric)
{
    *quadric = (struct quadric){frame->origin, frame->u, frame->v, frame->w, .tilt = 0};
    return fit_sums(local, NULL, n, false, quadric);
}

int quadric_fit_weighted(const struct vec3 *point, const double *weight, size_t n,
                         struct vec3 origin, struct vec3 guess, struct quadric *quadric)
{
    struct vec3 few[SOME], *local = few;

    *quadric = quadric_frame(origin, guess);
    if (n < TERMS)
        return -1;
    if (n > SOME)
        local = mem_alloc(n, sizeof *local);
    quadric_local_all(quadric, point, n, local);
    int status = fit_local(local, weight, n, quadric);
    if (local != few)
        free(local);
    return status;
}

int quadric_settle(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 guess,
                   struct quadric *q)
{
    const double still = 1e-4; /* radians */

    for (int turn = 0; turn < 4; turn++) {
        if (quadric_fit(point, n, origin, guess, q) < 0)
            return -1;
        struct vec3 normal = quadric_normal(q);
        if (vec_distance(normal, guess) < still)
            return 0;
        guess = normal;
    }
    return 0;
}

/* The plane z = a x + b y + c by least squares has the normal (-a, -b, 1) D, D the determinant of
 * the sums in x and y; of the three ways to call the axes the one with the largest D counts. */
struct vec3 plane_normal(const struct vec3 *point, size_t n)
{
    struct vec3 mean = vec(0, 0, 0);
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;

    for (size_t i = 0; i < n; i++)
        mean = vec_along(mean, 1 / (double)n, point[i]);
    for (size_t i = 0; i < n; i++) {
        struct vec3 d = vec_sub(point[i], mean);
        xx += d.x * d.x;
        xy += d.x * d.y;
        xz += d.x * d.z;
        yy += d.y * d.y;
        yz += d.y * d.z;
        zz += d.z * d.z;
    }
    double x = yy * zz - yz * yz, y = xx * zz - xz * xz, z = xx * yy - xy * xy;
    struct vec3 normal;
    if (x > y && x > z)
        normal = vec_unit(vec(x, xz * yz - xy * zz, xy * yz - xz * yy));
    else if (y > z)
        normal = vec_unit(vec(xz * yz - xy * zz, y, xy * xz - yz * xx));
    else
        normal = vec_unit(vec(xy * yz - xz * yy, xy * xz - yz * xx, z));
    return vec_length(normal) > 0 ? normal : vec(0, 0, 1);
}

int quadric_fit_steep(const struct vec3 *point, size_t n, struct vec3 origin, struct vec3 guess,
                      struct quadric *quadric)
{
    const double steep = cos(PI / 4);
    struct quadric other;
    int fitted = quadric_settle(point, n, origin, guess, quadric);
    if (guess.z >= steep || quadric_settle(point, n, origin, vec(0, 0, 1), &other) < 0)
        return fitted;
    if (fitted < 0 || quadric_rms(&other, point, n) < quadric_rms(quadric, point, n))
        *quadric = other;
    return 0;
}

int quadric_fit_free(const struct vec3 *point, size_t n, struct vec3 origin,
                     struct quadric *quadric)
{
    return quadric_settle(point, n, origin, plane_normal(point, n), quadric);
}

/* ---- a quadric or cubic evaluated */

struct vec3 quadric_normal(const struct quadric *q)
{
    return vec_unit(vec_along(vec_along(q->w, -q->c[1], q->u), -q->c[2], q->v));
}

double quadric_tilt_along(const struct quadric *q, struct vec3 way)
{
    double u = vec_dot(way, q->u), v = vec_dot(way, q->v), length2 = u * u + v * v;
    double sum = u * u * q->tilt_u + 2 * u * v * q->tilt_uv + v * v * (q->tilt - q->tilt_u);
    return length2 > 0 ? sum / length2 : 0;
}

void quadric_face_up(struct quadric *q)
{
    if (quadric_normal(q).z >= 0)
        return;
    q->w = vec_scale(-1, q->w);
    q->v = vec_scale(-1, q->v);
    for (int k = 0; k < 10; k++)
        q->c[k] = -q->c[k];
    /* v and w both turned: terms with an odd power of v keep their sign. */
    q->c[2] = -q->c[2];
    q->c[4] = -q->c[4];
    q->c[7] = -q->c[7];
    q->c[9] = -q->c[9];
    q->tilt_uv = -q->tilt_uv;
}

double quadric_distance(const struct quadric *q)
{
    return fabs(q->c[0]) / sqrt(1 + q->c[1] * q->c[1] + q->c[2] * q->c[2]);
}

struct vec3 quadric_foot(const struct quadric *q)
{
    double slope2 = 1 + q->c[1] * q->c[1] + q->c[2] * q->c[2];
    struct vec3 across = vec_along(vec_along(q->w, -q->c[1], q->u), -q->c[2], q->v);
    return vec_along(q->origin, q->c[0] / slope2, across);
}

/* The eigenvalues k of the second fundamental form with respect to the first:
 * (EG - F^2) k^2 - (EN - 2FM + GL) k + (LN - M^2) = 0. */
double quadric_curvature(const struct quadric *q)
{
    double wu = q->c[1], wv = q->c[2], slope = sqrt(1 + wu * wu + wv * wv);
    double E = 1 + wu * wu, F = wu * wv, G = 1 + wv * wv;
    double L = 2 * q->c[3] / slope, M = q->c[4] / slope, N = 2 * q->c[5] / slope;
    double a = E * G - F * F, b = E * N - 2 * F * M + G * L, c = L * N - M * M;
    return (b + sqrt(fmax(b * b - 4 * a * c, 0))) / (2 * a);
}

/* How far a point in the frame is off the first six terms, and the slopes of these there. */
static inline double off_square(const double c[10], struct vec3 at, double *wu, double *wv)
{
    double u = at.x, v = at.y;

    *wu = c[1] + 2 * c[3] * u + c[4] * v;
    *wv = c[2] + 2 * c[5] * v + c[4] * u;
    return at.z - (c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v));
}

/* The same with the cubic terms. */
static inline double off_cubic(const double c[10], struct vec3 at, double *wu, double *wv)
{
    double u = at.x, v = at.y, off = off_square(c, at, wu, wv);

    *wu += 3 * c[6] * u * u + 2 * c[7] * u * v + c[8] * v * v;
    *wv += c[7] * u * u + 2 * c[8] * u * v + 3 * c[9] * v * v;
    return off - (u * u * (c[6] * u + c[7] * v) + v * v * (c[8] * u + c[9] * v));
}

/* Most surfaces have none of these: they cost as much as the others. */
static bool is_cubic(const struct quadric *q)
{
    return q->c[6] != 0 || q->c[7] != 0 || q->c[8] != 0 || q->c[9] != 0;
}

/* Of a point in the frame. */
static inline double off_local(const struct quadric *q, struct vec3 at, bool cubic)
{
    double wu, wv, off = cubic ? off_cubic(q->c, at, &wu, &wv) : off_square(q->c, at, &wu, &wv);

    return off / sqrt(1 + wu * wu + wv * wv);
}

double quadric_off(const struct quadric *q, struct vec3 point)
{
    return off_local(q, quadric_local(q, point), is_cubic(q));
}

/* Of two points, each as off_local has it. */
static inline pair off_two(const struct quadric *q, const struct vec3 point[2], bool cubic)
{
    struct vec3 a = quadric_local(q, point[0]), b = quadric_local(q, point[1]);
    const pair u = {a.x, b.x}, v = {a.y, b.y}, w = {a.z, b.z};
    const double *c = q->c;
    pair wu = c[1] + 2 * c[3] * u + c[4] * v, wv = c[2] + 2 * c[5] * v + c[4] * u;
    pair off = w - (c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v));

    if (cubic) {
        wu += 3 * c[6] * u * u + 2 * c[7] * u * v + c[8] * v * v;
        wv += c[7] * u * u + 2 * c[8] * u * v + 3 * c[9] * v * v;
        off -= u * u * (c[6] * u + c[7] * v) + v * v * (c[8] * u + c[9] * v);
    }
    pair square = 1 + wu * wu + wv * wv, root = {sqrt(square[0]), sqrt(square[1])};
    return off / root;
}

static inline void off_twos(const struct quadric *q, const struct vec3 *point, size_t n, bool cubic,
                            double *off)
{
    size_t i = 0;

    for (; i + 1 < n; i += 2)
        pair_put(off + i, off_two(q, point + i, cubic));
    if (i < n)
        off[i] = off_local(q, quadric_local(q, point[i]), cubic);
}

void quadric_off_all(const struct quadric *q, const struct vec3 *point, size_t n, double *off)
{
    if (is_cubic(q))
        off_twos(q, point, n, true, off);
    else
        off_twos(q, point, n, false, off);
}

/* Of points in the frame or, where they are not, brought into it one by one. */
static inline double squares_of(const struct quadric *q, const struct vec3 *point, size_t n,
                                bool local, bool cubic)
{
    double sum2 = 0;

    for (size_t i = 0; i < n; i++) {
        double off = off_local(q, local ? point[i] : quadric_local(q, point[i]), cubic);
        sum2 += off * off;
    }
    return sum2;
}

double quadric_rms_local(const struct quadric *q, const struct vec3 *local, size_t n)
{
    double sum2 =
        is_cubic(q) ? squares_of(q, local, n, true, true) : squares_of(q, local, n, true, false);

    return sqrt(sum2 / (double)n);
}

double quadric_rms(const struct quadric *q, const struct vec3 *point, size_t n)
{
    double sum2 =
        is_cubic(q) ? squares_of(q, point, n, false, true) : squares_of(q, point, n, false, false);

    return sqrt(sum2 / (double)n);
}

struct vec3 quadric_at(const struct quadric *q, double u, double v)
{
    const double *c = q->c;
    double w = c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v) +
               u * u * (c[6] * u + c[7] * v) + v * v * (c[8] * u + c[9] * v);

    return vec_along(vec_along(vec_along(q->origin, u, q->u), v, q->v), w, q->w);
}

/* Slopes of the height w along u and v. */
static void slopes_at(const struct quadric *q, double u, double v, double *wu, double *wv)
{
    const double *c = q->c;

    *wu = c[1] + 2 * c[3] * u + c[4] * v + u * (3 * c[6] * u + 2 * c[7] * v) + c[8] * v * v;
    *wv = c[2] + 2 * c[5] * v + c[4] * u + v * (3 * c[9] * v + 2 * c[8] * u) + c[7] * u * u;
}

struct vec3 quadric_normal_at(const struct quadric *q, struct vec3 point)
{
    struct vec3 at = quadric_local(q, point);
    double wu, wv;

    slopes_at(q, at.x, at.y, &wu, &wv);
    return vec_unit(vec_along(vec_along(q->w, -wu, q->u), -wv, q->v));
}

/* Of two points, each as quadric_normal_at has it. */
static inline void normals_two(const struct quadric *q, const struct vec3 point[2], bool cubic,
                               struct vec3 normal[2])
{
    struct vec3 a = quadric_local(q, point[0]), b = quadric_local(q, point[1]);
    const pair u = {a.x, b.x}, v = {a.y, b.y};
    const double *c = q->c;
    pair wu = c[1] + 2 * c[3] * u + c[4] * v, wv = c[2] + 2 * c[5] * v + c[4] * u;

    if (cubic) {
        wu = wu + u * (3 * c[6] * u + 2 * c[7] * v) + c[8] * v * v;
        wv = wv + v * (3 * c[9] * v + 2 * c[8] * u) + c[7] * u * u;
    }
    pair x = q->w.x + -wu * q->u.x + -wv * q->v.x, y = q->w.y + -wu * q->u.y + -wv * q->v.y;
    pair z = q->w.z + -wu * q->u.z + -wv * q->v.z, square = x * x + y * y + z * z;
    pair part = 1 / (pair){sqrt(square[0]), sqrt(square[1])};
    x *= part;
    y *= part;
    z *= part;
    normal[0] = vec(x[0], y[0], z[0]);
    normal[1] = vec(x[1], y[1], z[1]);
}

void quadric_normal_all(const struct quadric *q, const struct vec3 *point, size_t n,
                        struct vec3 *normal)
{
    const bool cubic = is_cubic(q);
    size_t i = 0;

    for (; i + 1 < n; i += 2)
        normals_two(q, point + i, cubic, normal + i);
    if (i < n)
        normal[i] = quadric_normal_at(q, point[i]);
}

struct vec3 quadric_nearest(const struct quadric *q, struct vec3 point)
{
    const double still = 1e-9; /* mm */
    struct vec3 at = quadric_local(q, point);
    double u = at.x, v = at.y;

    for (int turn = 0; turn < 8; turn++) {
        double wu, wv;
        slopes_at(q, u, v, &wu, &wv);
        struct vec3 off = vec_sub(point, quadric_at(q, u, v));
        double height = vec_dot(off, q->w), slope2 = 1 + wu * wu + wv * wv;
        double su = vec_dot(off, q->u) + height * wu, sv = vec_dot(off, q->v) + height * wv;
        double skew = (wu * su + wv * sv) / slope2; /* of the inverse of the first form */
        u += su - wu * skew;
        v += sv - wv * skew;
        if (hypot_compare(su, sv, still) < 0)
            break;
    }
    return quadric_at(q, u, v);
}

/* The surface is off by no more than its height under the point; and the steps towards the foot get
 * shorter fast where it bends little within that height. */
bool quadric_surely_within(const struct quadric *q, struct vec3 point, double limit)
{
    const double spare = 0.9, little = 0.05;
    const double *c = q->c;
    struct vec3 at = quadric_local(q, point), under = quadric_at(q, at.x, at.y);
    double height = fabs(vec_dot(vec_sub(point, under), q->w));
    double far = fabs(at.x) + fabs(at.y) + height;
    double square = fabs(c[3]) + fabs(c[4]) + fabs(c[5]);
    double cube = fabs(c[6]) + fabs(c[7]) + fabs(c[8]) + fabs(c[9]);

    return height <= spare * limit && (2 * square + 6 * far * cube) * height <= little;
}

double quadric_spread(const struct quadric *quadric, const struct vec3 *point, size_t n,
                      double terms)
{
    return quadric_rms(quadric, point, n) * sqrt((double)n / fmax((double)n - terms, 1));
}
