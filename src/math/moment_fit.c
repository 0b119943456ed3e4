/* moment_fit - see moment_fit.h. */
#include "math/moment_fit.h"

#include <stdbool.h>
#include <string.h>
#include "math/pair.h"

enum { QUADRIC = 6, CUBIC = 10, POWERS = 28, FRAMES = 2 };

/* Part of a term that the terms before it must leave over. */
static const double INDEPENDENT = 1e-3;

/* Slope of a surface against its frame from which on it gets one of its own. */
static const double SKEW = 0.2;

static const double HIGHEST = 20; /* so many times the points that fit are looked at, at most */

/* The points in the ball, from the place. */
struct ball {
    size_t n;
    struct vec3 d[MOMENT_FIT_MOST + 1]; /* the last for one too many */
};

/* Sums of u^i v^j, by degree and from u^degree to v^degree; of u^i v^j w; and of w^2. */
struct sums {
    double power[POWERS], w[CUBIC], ww;
};

double moment_fit_radius(double k, double spacing, struct vec3 normal)
{
    const double least = 0.25;

    return spacing * sqrt(k / (PI * fmax(fabs(normal.z), least)));
}

/* False: there are too many. */
static bool gather(const struct point_grid *b, struct vec3 place, double radius, struct ball *ball)
{
    size_t left = point_grid_column(b, place.x - radius);
    size_t right = point_grid_column(b, place.x + radius);
    size_t low = point_grid_row(b, place.y - radius), high = point_grid_row(b, place.y + radius);
    double radius2 = radius * radius;
    const pair at = {place.x, place.y};
    size_t looked = 0, n = 0;

    for (size_t row = low; row <= high; row++) {
        uint32_t from = b->first[row * b->columns + left];
        uint32_t to = b->first[row * b->columns + right + 1];
        looked += to - from;
        if (looked > (size_t)(HIGHEST * MOMENT_FIT_MOST))
            return false;
        for (const struct vec3 *p = b->point + from, *end = b->point + to; p < end; p++) {
            pair d = pair_at(&p->x) - at, squares = d * d;
            double z = p->z - place.z;
            pair_put(&ball->d[n].x, d); /* each, and one in three is in the ball: no jumps */
            ball->d[n].z = z;
            n += squares[0] + squares[1] + z * z <= radius2;
            if (n > MOMENT_FIT_MOST)
                return false;
        }
    }
    ball->n = n;
    return n >= MOMENT_FIT_LEAST;
}

/* Of u and v in units of the radius, and w in mm.  The sums of u^i v^j and of v^i u^j are pairs. */
static struct sums add_up(const struct quadric *frame, double radius, const struct ball *ball)
{
    const pair none = {0, 0};
    pair d1 = none, d2 = none, d3 = none, d21 = none, d4 = none, d31 = none, d5 = none;
    pair d41 = none, d32 = none, d6 = none, d51 = none, d42 = none;
    pair w1 = none, w2 = none, w3 = none, w21 = none, same = none, w0 = none;
    double u3v3 = 0, ww = 0;
    struct vec3 u = vec_scale(1 / radius, frame->u), v = vec_scale(1 / radius, frame->v);
    const pair x = {u.x, v.x}, y = {u.y, v.y}, z = {u.z, v.z};

    for (size_t i = 0; i < ball->n; i++) {
        const struct vec3 d = ball->d[i];
        pair e = pair_both(d.x) * x + pair_both(d.y) * y + pair_both(d.z) * z, o = pair_swap(e);
        double w = vec_dot(d, frame->w), uv = e[0] * e[1];
        pair e2 = e * e, e3 = e2 * e, e21 = e2 * o, h = pair_both(w);
        d1 += e, d2 += e2, d3 += e3, d21 += e21, d4 += e2 * e2;
        d31 += e3 * o, d5 += e3 * e2, d41 += e3 * pair_both(uv), d32 += e3 * pair_swap(e2);
        d6 += e3 * e3, d51 += e3 * e21, d42 += e3 * pair_swap(e21);
        w1 += e * h, w2 += e2 * h, w3 += e3 * h, w21 += e21 * h;
        same += (pair){uv, e2[0] * e2[1]};
        w0 += (pair){w, uv * w};
        u3v3 += e3[0] * e3[1];
        ww += w * w;
    }
    return (struct sums){
        .power = {(double)ball->n, d1[0],  d1[1],  d2[0],  same[0], d2[1],   d3[0],
                  d21[0],          d21[1], d3[1],  d4[0],  d31[0],  same[1], d31[1],
                  d4[1],           d5[0],  d41[0], d32[0], d32[1],  d41[1],  d5[1],
                  d6[0],           d51[0], d42[0], u3v3,   d42[1],  d51[1],  d6[1]},
        .w = {w0[0], w1[0], w1[1], w2[0], w0[1], w2[1], w3[0], w21[0], w21[1], w3[1]},
        .ww = ww};
}

/* Powers of u and v in each term, in the order of quadric.c and cubic.c. */
static const int U[CUBIC] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0};
static const int V[CUBIC] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};

/* Where the product of two terms stands among the sums. */
static const unsigned char PRODUCT[CUBIC][CUBIC] = {
    {0, 1, 2, 3, 4, 5, 6, 7, 8, 9},          {1, 3, 4, 6, 7, 8, 10, 11, 12, 13},
    {2, 4, 5, 7, 8, 9, 11, 12, 13, 14},      {3, 6, 7, 10, 11, 12, 15, 16, 17, 18},
    {4, 7, 8, 11, 12, 13, 16, 17, 18, 19},   {5, 8, 9, 12, 13, 14, 17, 18, 19, 20},
    {6, 10, 11, 15, 16, 17, 21, 22, 23, 24}, {7, 11, 12, 16, 17, 18, 22, 23, 24, 25},
    {8, 12, 13, 17, 18, 19, 23, 24, 25, 26}, {9, 13, 14, 18, 19, 20, 24, 25, 26, 27},
};

/* a' a = the sums of products, a upper triangular, with 1 / a[i][i] in inverse[]; -1 when a term
 * depends on those before it.  What is below the diagonal means nothing: two columns are worked on
 * at a time, and rows from their beginning, so that each is as long as the next. */
static int factor(const struct sums *s, double a[CUBIC][CUBIC], double inverse[CUBIC])
{
    for (int i = 0; i < CUBIC; i++)
        for (int j = 0; j < CUBIC; j++)
            a[i][j] = s->power[PRODUCT[i][j]];
    for (int k = 0; k < CUBIC; k++) {
        if (!(a[k][k] > INDEPENDENT * s->power[PRODUCT[k][k]]))
            return -1;
        inverse[k] = 1 / sqrt(a[k][k]);
        pair row[CUBIC / 2];
        for (int j = 0; j < CUBIC / 2; j++) {
            row[j] = pair_at(a[k] + 2 * j) * pair_both(inverse[k]);
            pair_put(a[k] + 2 * j, row[j]);
        }
        for (int i = k + 1; i < CUBIC; i++) {
            pair part = pair_both(a[k][i]);
            for (int j = 0; j < CUBIC / 2; j++)
                pair_put(a[i] + 2 * j, pair_at(a[i] + 2 * j) - part * row[j]);
        }
    }
    return 0;
}

/* What is solved at once: the heights, and the unit vectors of the first three terms. */
enum { HEIGHTS, PICKED, SIDES = 4 };

/* a' y = b for all of them; y is b to begin with. */
static void solve_forward(double a[CUBIC][CUBIC], const double inverse[CUBIC],
                          double y[CUBIC][SIDES])
{
    for (int k = 0; k < CUBIC; k++) {
        pair low = pair_at(y[k]) * pair_both(inverse[k]);
        pair high = pair_at(y[k] + 2) * pair_both(inverse[k]);
        pair_put(y[k], low);
        pair_put(y[k] + 2, high);
        for (int i = k + 1; i < CUBIC; i++) {
            pair part = pair_both(a[k][i]);
            pair_put(y[i], pair_at(y[i]) - part * low);
            pair_put(y[i] + 2, pair_at(y[i] + 2) - part * high);
        }
    }
}

/* The coefficients of the surface with the first so many terms, in mm. */
static void solve_back(double a[CUBIC][CUBIC], const double inverse[CUBIC], double y[CUBIC][SIDES],
                       int terms, double radius, double c[CUBIC])
{
    double scale[4] = {1, 1 / radius, 0, 0};

    scale[2] = scale[1] * scale[1];
    scale[3] = scale[2] * scale[1];
    for (int i = 0; i < CUBIC; i++)
        c[i] = 0;
    for (int i = terms - 1; i >= 0; i--) {
        c[i] = y[i][HEIGHTS];
        for (int j = i + 1; j < terms; j++)
            c[i] -= a[i][j] * c[j];
        c[i] *= inverse[i];
    }
    for (int i = 0; i < terms; i++)
        c[i] *= scale[U[i] + V[i]];
}

/* Of c0, of c1 and c2 together, and what these have in common, by the products of the first so many
 * terms. */
static void find_variances(double y[CUBIC][SIDES], double radius, struct moment_fit *fit)
{
    double variance[3][2] = {{0}}, both[2] = {0};

    for (int i = 0; i < CUBIC; i++) {
        for (int term = 0; term < 3; term++)
            variance[term][i >= QUADRIC] += y[i][PICKED + term] * y[i][PICKED + term];
        both[i >= QUADRIC] += y[i][PICKED + 1] * y[i][PICKED + 2];
    }
    double radius2 = radius * radius, tilt = variance[1][0] + variance[2][0];
    fit->quadric.variance = variance[0][0];
    fit->quadric.tilt = tilt / radius2;
    fit->quadric.tilt_u = variance[1][0] / radius2;
    fit->quadric.tilt_uv = both[0] / radius2;
    fit->cubic.variance = variance[0][0] + variance[0][1];
    fit->cubic.tilt = (tilt + variance[1][1] + variance[2][1]) / radius2;
    fit->cubic.tilt_u = (variance[1][0] + variance[1][1]) / radius2;
    fit->cubic.tilt_uv = (both[0] + both[1]) / radius2;
}

/* Spread of what a surface with so many terms leaves. */
static double spread_of(const struct sums *s, double y[CUBIC][SIDES], int terms)
{
    double left = s->ww;

    for (int i = 0; i < terms; i++)
        left -= y[i][HEIGHTS] * y[i][HEIGHTS];
    return sqrt(fmax(left, 0) / fmax(s->power[0] - terms, 1));
}

static int fit_in_frame(struct vec3 place, struct vec3 w, double radius, const struct ball *ball,
                        struct moment_fit *fit)
{
    double a[CUBIC][CUBIC], inverse[CUBIC], y[CUBIC][SIDES];

    fit->cubic = fit->quadric = quadric_frame(place, w);
    struct sums s = add_up(&fit->cubic, radius, ball);
    if (factor(&s, a, inverse) < 0)
        return -1;
    for (int i = 0; i < CUBIC; i++) {
        y[i][HEIGHTS] = s.w[i];
        for (int k = PICKED; k < SIDES; k++)
            y[i][k] = i == k - PICKED;
    }
    solve_forward(a, inverse, y);
    solve_back(a, inverse, y, CUBIC, radius, fit->cubic.c);
    solve_back(a, inverse, y, QUADRIC, radius, fit->quadric.c);
    find_variances(y, radius, fit);
    fit->quadric_spread = spread_of(&s, y, QUADRIC);
    fit->cubic_spread = spread_of(&s, y, CUBIC);
    fit->lean = sqrt(s.power[1] * s.power[1] + s.power[2] * s.power[2]) / s.power[0];
    fit->n = ball->n;
    return 0;
}

int moment_fit_ball(const struct point_grid *scan, struct vec3 place, struct vec3 guess,
                    double radius, struct moment_fit *fit)
{
    struct ball ball;

    if (!gather(scan, place, radius, &ball))
        return -1;
    for (int frame = 0; frame < FRAMES; frame++) {
        if (fit_in_frame(place, guess, radius, &ball, fit) < 0)
            return -1;
        const double *c = fit->cubic.c;
        if (c[1] * c[1] + c[2] * c[2] < SKEW * SKEW)
            break;
        guess = quadric_normal(&fit->cubic);
    }
    return 0;
}

/* The quadric's slopes are off by a bias and less uncertain: the cubic's are nearer to the truth
 * where the squared difference is more than four times its variance (Hausman 1978: that of the
 * cubic's less that of the quadric's). */
static bool cubic_is_nearer(const struct moment_fit *fit)
{
    double du = fit->cubic.c[1] - fit->quadric.c[1], dv = fit->cubic.c[2] - fit->quadric.c[2];
    double sigma = fit->cubic_spread;

    return du * du + dv * dv > 4 * sigma * sigma * (fit->cubic.tilt - fit->quadric.tilt);
}

const struct quadric *moment_fit_better(const struct moment_fit *fit)
{
    return cubic_is_nearer(fit) ? &fit->cubic : &fit->quadric;
}

double moment_fit_spread(const struct moment_fit *fit)
{
    return cubic_is_nearer(fit) ? fit->cubic_spread : fit->quadric_spread;
}
