/* cone_tip - see cone_tip.h. */
#include "cone_tip.h"

#include <stdlib.h>

#include "math/band.h"
#include "math/pair.h"

/* Of the spacing across the axis: the search begins on a raster so far apart, and with these steps;
 * it ends below the last. */
static const double APART = 0.3, FIRST = 0.15, LAST = 1e-4;

/* And so far from the highest point a tip may be: from afar a cone is as smooth as anything. */
static const double FAR = 1.2, ROUND = 0.7;

/* A fit that is so many times too bad on the raster, after the first step, after each halving of
 * it, becomes none: of 8,000 that ended as one (exact shapes, shapes with noise, a face) the worst
 * were 4.4, 2.9, 1.58, 1.06 and 1.03 times. */
enum { RASTER = 3, HALVINGS = 14, EARLY = 5 };
static const double HOPELESS[EARLY] = {8, 5, 3, 2, 1.5};

static const double POINTED = 0.36; /* slopes of two lines opposite each other together */

static void terms_at(double u, double v, double x[CONE_TERMS])
{
    double r2 = u * u + v * v, r = sqrt(r2), c = r > 0 ? u / r : 1, s = r > 0 ? v / r : 0;
    double c2 = c * c - s * s, s2 = 2 * c * s;

    x[0] = 1;
    x[1] = -r;
    x[2] = -u;
    x[3] = -v;
    x[4] = -r * c2;
    x[5] = -r * s2;
    x[6] = -r * (c2 * c - s2 * s);
    x[7] = -r * (s2 * c + c2 * s);
    x[8] = -r2;
}

static double height_of(const struct cone_tip *tip, const double x[CONE_TERMS])
{
    double sum = 0;

    for (int i = 0; i < CONE_TERMS; i++)
        sum += tip->c[i] * x[i];
    return sum;
}

static double height_at(const struct cone_tip *tip, double u, double v)
{
    double x[CONE_TERMS];

    terms_at(u, v, x);
    return height_of(tip, x);
}

/* The terms at each of n points, and the height there; to fours, for they are summed in blocks of
 * two by four. */
enum { CONE_ROW = CONE_TERMS + 1, CONE_FOURS = (CONE_ROW + 3) / 4 * 4 };
typedef double cone_rows[CONE_POINTS][CONE_FOURS];

/* The sums over n points of the products of terms i and i + 1 with four from term j on, in
 * registers: none of them has to wait for another. */
static void sum_block(cone_rows x, size_t n, size_t i, size_t j, double sum[2][4])
{
    pair a = {0, 0}, b = a, c = a, d = a;

    for (size_t k = 0; k < n; k++) {
        pair first = pair_both(x[k][i]), second = pair_both(x[k][i + 1]);
        pair left = pair_at(&x[k][j]), right = pair_at(&x[k][j + 2]);
        a += first * left;
        b += first * right;
        c += second * left;
        d += second * right;
    }
    pair_put(&sum[0][0], a);
    pair_put(&sum[0][2], b);
    pair_put(&sum[1][0], c);
    pair_put(&sum[1][2], d);
}

/* The sums of the products of the terms, and in c with the heights. */
static struct band sum_terms(cone_rows x, size_t n, double c[CONE_TERMS])
{
    struct band a = band_new(CONE_TERMS, CONE_TERMS - 1);
    double sum[2][4];

    for (size_t i = 0; i < CONE_ROW; i += 2)
        for (size_t j = 0; j < i + 2 && j < CONE_TERMS; j += 4) {
            sum_block(x, n, i, j, sum);
            for (size_t row = i; row < i + 2; row++)
                for (size_t k = j; k < j + 4 && k <= row && k < CONE_TERMS; k++)
                    *(row < CONE_TERMS ? band_at(&a, row, k) : &c[k]) = sum[row - i][k - j];
        }
    return a;
}

/* The cone's terms with its tip over tip->u, v, and their factors; false: the points determine
 * none. */
static bool solve_there(const struct vec3 *local, size_t n, cone_rows x, struct cone_tip *tip)
{
    for (size_t k = 0; k < n; k++) {
        terms_at(local[k].x - tip->u, local[k].y - tip->v, x[k]);
        for (size_t i = CONE_TERMS; i < CONE_FOURS; i++)
            x[k][i] = local[k].z;
    }
    struct band a = sum_terms(x, n, tip->c);
    bool solved = band_factor(&a);
    if (solved)
        band_solve(&a, tip->c, 1);
    band_free(&a);
    return solved;
}

/* The same, and how far the points are off; false also where that is more than `rms`. */
static bool fit_there(const struct vec3 *local, size_t n, double rms, struct cone_tip *tip)
{
    const double rounding = 1e-9;
    cone_rows x;
    double sum2 = 0;

    if (!solve_there(local, n, x, tip))
        return false;
    tip->worst = 0;
    double across = hypot(1, tip->c[1]); /* across the lines */
    double room = (1 + rounding) * rms * rms * (double)(n - CONE_TERMS - 2);
    for (size_t k = 0; k < n; k++) {
        double off = (local[k].z - height_of(tip, x[k])) / across;
        tip->worst = fmax(tip->worst, fabs(off));
        sum2 += off * off;
        if (sum2 > room)
            return false;
    }
    tip->rms = sqrt(sum2 / (double)(n - CONE_TERMS - 2));
    return true;
}

/* The best place of a raster about the origin. */
static void search_coarsely(const struct vec3 *local, size_t n, double spacing,
                            struct cone_tip *tip)
{
    struct cone_tip other = *tip;

    tip->rms = HUGE_VAL;
    for (int i = -RASTER; i <= RASTER; i++)
        for (int j = -RASTER; j <= RASTER; j++) {
            other.u = APART * spacing * i;
            other.v = APART * spacing * j;
            if (fit_there(local, n, tip->rms, &other) && other.rms < tip->rms)
                *tip = other;
        }
}

/* `steps` are made since the raster. */
static bool is_hopeless(const struct cone_tip *tip, double rms, int steps)
{
    return tip->rms > HOPELESS[steps < EARLY ? steps : EARLY - 1] * rms;
}

/* Moves the tip to where the fit is best, by steps that are halved. */
static bool search(const struct vec3 *local, size_t n, double spacing, double rms,
                   struct cone_tip *tip)
{
    static const int way[8][2] = {{1, 0}, {0, 1},  {-1, 0},  {0, -1},
                                  {1, 1}, {-1, 1}, {-1, -1}, {1, -1}};
    double step = FIRST * spacing;

    search_coarsely(local, n, spacing, tip);
    if (is_hopeless(tip, rms, 0))
        return false;
    for (int halving = 0; halving < HALVINGS && step > LAST * spacing; halving++, step /= 2) {
        int last[2] = {2, 2}; /* where the tip came from: beside that all was looked at */
        for (int turn = 0, still = 0; turn < 4 && !still; turn++) {
            struct cone_tip best = *tip;
            int from[2] = {last[0], last[1]};
            for (int k = 0; k < 8; k++) {
                struct cone_tip other = *tip;
                if (abs(way[k][0] + from[0]) < 2 && abs(way[k][1] + from[1]) < 2)
                    continue;
                other.u += step * way[k][0];
                other.v += step * way[k][1];
                if (hypot_compare(other.u, other.v, FAR * spacing) < 0 &&
                    fit_there(local, n, best.rms, &other) && other.rms < best.rms) {
                    best = other;
                    last[0] = way[k][0];
                    last[1] = way[k][1];
                }
            }
            still = best.rms >= tip->rms;
            *tip = best;
        }
        if (is_hopeless(tip, rms, halving + 1))
            return false;
    }
    return tip->rms <= rms;
}

/* How far the points go round the tip: the nearest point of the emptiest sector of the farthest. */
static double find_reach(const struct vec3 *local, size_t n, const struct cone_tip *tip)
{
    enum { SECTORS = 6 };
    double farthest[SECTORS] = {0}, reach = HUGE_VAL;

    for (size_t k = 0; k < n; k++) {
        double u = local[k].x - tip->u, v = local[k].y - tip->v;
        int sector = (int)((atan2(v, u) + PI) / (2 * PI) * SECTORS) % SECTORS;
        farthest[sector] = fmax(farthest[sector], hypot(u, v));
    }
    for (int s = 0; s < SECTORS; s++)
        reach = fmin(reach, farthest[s]);
    return reach;
}

static double slope_at(const struct cone_tip *tip, double t)
{
    double x[CONE_TERMS], sum = 0;

    terms_at(cos(t), sin(t), x);
    for (int i = 1; i + 1 < CONE_TERMS; i++)
        sum -= tip->c[i] * x[i];
    return sum;
}

static bool is_pointed(const struct cone_tip *tip)
{
    enum { WAYS = 12 };

    for (int k = 0; k < WAYS; k++)
        if (slope_at(tip, PI * k / WAYS) + slope_at(tip, PI * k / WAYS + PI) < POINTED)
            return false;
    return true;
}

/* The same with heights along `up` (unit). */
static int fit_along(const struct vec3 *point, size_t n, struct vec3 up, double rms,
                     struct cone_tip *tip)
{
    struct vec3 local[CONE_POINTS];
    double far = 0;

    *tip = (struct cone_tip){.frame = quadric_frame(point[0], up)};
    for (size_t k = 0; k < n; k++) {
        local[k] = quadric_local(&tip->frame, point[k]);
        far = fmax(far, hypot(local[k].x, local[k].y));
    }
    double spacing = far * sqrt(PI / (double)n);
    if (!search(local, n, spacing, rms, tip) || !is_pointed(tip))
        return -1;
    tip->reach = find_reach(local, n, tip);
    return tip->reach > ROUND * spacing ? 0 : -1;
}

int cone_tip_fit(const struct vec3 *point, size_t n, double rms, struct cone_tip *tip)
{
    if (n < 2 * CONE_TERMS + 2 || n > CONE_POINTS)
        return -1;
    /* The plane nearest to the points of a slender one is upright; seen along a way that leans, the
     * terms do not describe it as well. */
    struct vec3 up = plane_normal(point, n);
    struct cone_tip above;
    int leaning = fit_along(point, n, up.z < 0 ? vec_scale(-1, up) : up, rms, tip);
    int upright = fit_along(point, n, vec(0, 0, 1), rms, &above);
    if (upright == 0 && (leaning != 0 || above.rms < tip->rms))
        *tip = above;
    return leaning == 0 || upright == 0 ? 0 : -1;
}

struct vec3 cone_tip_at(const struct cone_tip *tip, double r, double t)
{
    const struct quadric *q = &tip->frame;
    double u = r * cos(t), v = r * sin(t);
    struct vec3 p = vec_along(q->origin, tip->u + u, q->u);

    return vec_along(vec_along(p, tip->v + v, q->v), height_at(tip, u, v), q->w);
}
