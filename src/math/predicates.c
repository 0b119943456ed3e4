/*
 * predicates - see predicates.h.
 *
 * U is the unit roundoff.  A difference of two doubles is off by at most U of itself, so is a
 * product or a sum; counted through the determinants, with all terms positive (their permanents)
 * and the second order in the last digit:
 *   orient2d   (1 + U)^3 for each product and sum, thus 3 U and a little
 *   incircle   (1 + U)^10, thus 10 U and a little
 * With pairs of doubles the same holds with 4 U^2 for U, and differences are exact.
 */
#include "math/predicates.h"

#include <float.h>
#include <stddef.h>

#include "math/elementary.h"

#include "double_double.h"

#define U (DBL_EPSILON / 2)

static const double ORIENT_BOUND = (3 + 32 * U) * U;
static const double CIRCLE_BOUND = (10 + 128 * U) * U;
static const double CIRCLE_BOUND_PAIRS = 128 * U * U;

static int sign_of(double x)
{
    return (x > 0) - (x < 0);
}

/* ---- a sum or product of doubles as two doubles: the rounded one and what it lacks */

static struct pair pair_sum(struct pair a, struct pair b)
{
    struct pair s = two_sum(a.high, b.high);

    return two_sum(s.high, s.low + (a.low + b.low));
}

static struct pair pair_product(struct pair a, struct pair b)
{
    struct pair p = two_product(a.high, b.high);

    return two_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
}

static struct pair pair_less(struct pair a)
{
    return (struct pair){-a.high, -a.low};
}

/* ---- sums of any number of doubles, without rounding: by rising size, none of them zero */

enum { SUM_MOST = 1600 }; /* 3 products of 16 by 16 terms have no more than 1,536 */

struct sum {
    size_t n;
    double *item;
};

/* Adds x to a sum that has room for one more. */
static void sum_add(struct sum *s, double x)
{
    size_t kept = 0;

    for (size_t i = 0; i < s->n; i++) {
        struct pair p = two_sum(x, s->item[i]);
        x = p.high;
        if (p.low < 0 || p.low > 0)
            s->item[kept++] = p.low;
    }
    if (x < 0 || x > 0)
        s->item[kept++] = x;
    s->n = kept;
}

/* Adds `times` a * b. */
static void sum_add_product(struct sum *s, const struct sum *a, const struct sum *b, double times)
{
    for (size_t i = 0; i < a->n; i++)
        for (size_t j = 0; j < b->n; j++) {
            struct pair p = two_product(a->item[i], times * b->item[j]);
            sum_add(s, p.low);
            sum_add(s, p.high);
        }
}

static int sum_sign(const struct sum *s)
{
    return s->n > 0 ? sign_of(s->item[s->n - 1]) : 0;
}

/* a - b, as a sum in room for two. */
static struct sum sum_of_difference(double a, double b, double room[2])
{
    struct sum s = {0, room};

    sum_add(&s, a);
    sum_add(&s, -b);
    return s;
}

/* ---- lines */

static int orient_exactly(struct uv a, struct uv b, struct uv c)
{
    double room[4][2], whole[32];
    struct sum ax = sum_of_difference(a.u, c.u, room[0]), ay = sum_of_difference(a.v, c.v, room[1]);
    struct sum bx = sum_of_difference(b.u, c.u, room[2]), by = sum_of_difference(b.v, c.v, room[3]);
    struct sum s = {0, whole};

    sum_add_product(&s, &ax, &by, 1);
    sum_add_product(&s, &ay, &bx, -1);
    return sum_sign(&s);
}

int orient2d(struct uv a, struct uv b, struct uv c)
{
    double left = (a.u - c.u) * (b.v - c.v), right = (a.v - c.v) * (b.u - c.u);
    double area = left - right;

    if (fabs(area) > ORIENT_BOUND * (fabs(left) + fabs(right)))
        return sign_of(area);
    return orient_exactly(a, b, c);
}

/* ---- circles */

/* One of the three terms of the determinant: (x^2 + y^2) (px qy - py qx). */
static void add_term(struct sum *s, const struct sum at[2], const struct sum p[2],
                     const struct sum q[2])
{
    double square[16], cross[16];
    struct sum lift = {0, square}, minor = {0, cross};

    sum_add_product(&lift, &at[0], &at[0], 1);
    sum_add_product(&lift, &at[1], &at[1], 1);
    sum_add_product(&minor, &p[0], &q[1], 1);
    sum_add_product(&minor, &p[1], &q[0], -1);
    sum_add_product(s, &lift, &minor, 1);
}

static int circle_exactly(const struct uv corner[3], struct uv d)
{
    double room[3][2][2], whole[SUM_MOST];
    struct sum at[3][2], s = {0, whole};

    for (int i = 0; i < 3; i++) {
        at[i][0] = sum_of_difference(corner[i].u, d.u, room[i][0]);
        at[i][1] = sum_of_difference(corner[i].v, d.v, room[i][1]);
    }
    for (int i = 0; i < 3; i++)
        add_term(&s, at[i], at[(i + 1) % 3], at[(i + 2) % 3]);
    return sum_sign(&s);
}

/* With pairs of doubles: the sign, or 0 where that is not certain. */
static int circle_by_pairs(const struct uv corner[3], struct uv d, double permanent)
{
    struct pair at[3][2], s = {0, 0};

    for (int i = 0; i < 3; i++) {
        at[i][0] = two_sum(corner[i].u, -d.u);
        at[i][1] = two_sum(corner[i].v, -d.v);
    }
    for (int i = 0; i < 3; i++) {
        const struct pair *p = at[(i + 1) % 3], *q = at[(i + 2) % 3];
        struct pair lift =
            pair_sum(pair_product(at[i][0], at[i][0]), pair_product(at[i][1], at[i][1]));
        struct pair minor = pair_sum(pair_product(p[0], q[1]), pair_less(pair_product(p[1], q[0])));
        s = pair_sum(s, pair_product(lift, minor));
    }
    return fabs(s.high) > CIRCLE_BOUND_PAIRS * permanent ? sign_of(s.high) : 0;
}

int incircle(struct uv a, struct uv b, struct uv c, struct uv d)
{
    double ax = a.u - d.u, ay = a.v - d.v, bx = b.u - d.u, by = b.v - d.v;
    double cx = c.u - d.u, cy = c.v - d.v;
    double bc = bx * cy, cb = by * cx, ca = cx * ay, ac = cy * ax, ab = ax * by, ba = ay * bx;
    double a2 = ax * ax + ay * ay, b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
    double inside = a2 * (bc - cb) + b2 * (ca - ac) + c2 * (ab - ba);
    double permanent =
        a2 * (fabs(bc) + fabs(cb)) + b2 * (fabs(ca) + fabs(ac)) + c2 * (fabs(ab) + fabs(ba));

    if (fabs(inside) > CIRCLE_BOUND * permanent)
        return sign_of(inside);
    struct uv corner[3] = {a, b, c};
    int sign = circle_by_pairs(corner, d, permanent);
    return sign != 0 ? sign : circle_exactly(corner, d);
}
