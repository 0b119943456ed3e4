/* crest_fit - see crest_fit.h. */
#include "crest_fit.h"

#include <string.h>

#include "math/band.h"
#include "math/pair.h"

/* Terms: off, turn, bend, and those of the heights, of a sharp crest all but the last; those that
 * the nearest points tell; points on the arc of a round one. */
enum {
    SHAPE = 3,
    ALL = SHAPE + CREST_TERMS,
    ROUND = ALL - 1,
    TURNS = 20,
    FEWEST = 8,
    BEGUN = 3,
    AT_FIRST = 10,
    NEAREST = 16,
    ON_ARC = 4,
    MOST = 10
};

/* Spacings: about the point, to begin with; for a first crest; for all of it; between first crests
 * tried, and the farthest of them. */
static const double BEGIN = 2.3, FIRST = 2.6, STEP = 0.5, FARTHEST = 1.5;

/* In spacings: points of a side are spread over so much of it at least, the crest is so long;
 * points as near to the first are explained. */
static const double ACROSS = 0.6, CLOSE = 0.6, LONG = 2.2, NEXT = 2;

/* In spacings: radius of a round crest, to begin with, and at most: a rounder one is smooth. */
static const double ROUNDED = 1, ROUNDEST = 4;

static const double MUCH = 3;     /* of the first points so many times as are on a first crest */
static const double SHARP = 0.94; /* cosine of the sides' normals: 20 degrees */

bool crest_fit_local(const struct crest_fit *fit, double x, double y, double *s, double *d)
{
    double dx = x - fit->origin.x, dy = y - fit->origin.y;
    double u = dy * fit->way_x - dx * fit->way_y - fit->off;

    *s = dx * fit->way_x + dy * fit->way_y;
    double q = 2 * u + fit->bend * (u * u + *s * *s), root = 1 + fit->bend * q;
    *d = q / (1 + sqrt(fmax(0, root)));
    return root > 0;
}

/* How far the sides, of these slopes, are below their sharp crest; *slope: of that. */
static double fall(double left, double right, double radius, double d, double *slope)
{
    *slope = d > 0 ? right : -left;
    if (!(radius > 0))
        return *slope * d;
    double cos_l = 1 / sqrt(1 + left * left), cos_r = 1 / sqrt(1 + right * right);
    double touch = radius * (left * cos_l + right * cos_r) / (cos_l + cos_r);
    if (!(touch > 0) || d <= -touch * cos_l || d >= touch * cos_r)
        return *slope * d;
    double off = d + touch * cos_l - radius * left * cos_l,
           down = sqrt(radius * radius - off * off);
    *slope = off / down;
    return touch * left * cos_l + radius * cos_l - down;
}

/* *slope: downwards, with d. */
static double height(const struct crest_fit *fit, double s, double d, double *slope)
{
    const double *c = fit->c;

    return c[0] + s * (c[1] + s * c[2]) - fall(c[3] + c[4] * s, c[5] + c[6] * s, c[7], d, slope);
}

bool crest_fit_at(const struct crest_fit *fit, double s, double d, struct vec3 *place)
{
    double k = fit->bend, r = 1 + k * d, root2 = r * r - k * k * s * s;

    if (r <= 0 || root2 < 0.1 * r * r)
        return false;
    double slope, root = sqrt(root2), u = (2 * d + k * d * d - k * s * s) / (1 + root) + fit->off;
    *place = vec(fit->origin.x + s * fit->way_x - u * fit->way_y,
                 fit->origin.y + s * fit->way_y + u * fit->way_x, height(fit, s, d, &slope));
    return true;
}

/* How far a point is off its side, across it; below it: negative. */
static double distance(const struct crest_fit *fit, struct vec3 p, double *s, double *d)
{
    double slope;

    if (!crest_fit_local(fit, p.x, p.y, s, d))
        return HUGE_VAL;
    double off = p.z - height(fit, *s, *d, &slope);
    return off / sqrt(1 + slope * slope);
}

/* Makes a step in one of the terms. */
static void make_step(struct crest_fit *fit, int term, double step)
{
    double x = fit->way_x, y = fit->way_y;

    if (term == 0)
        fit->off += step;
    if (term == 1) {
        double across = hypot(1, step);
        fit->way_x = (x - step * y) / across;
        fit->way_y = (y + step * x) / across;
    }
    if (term == 2)
        fit->bend += step;
    if (term >= SHAPE)
        fit->c[term - SHAPE] += step;
}

/* What the distances of points change by with the terms, summed: the lower half of the products,
 * and in rows of pairs what is next to it. */
struct equations {
    int n, of[ALL];
    double a[ALL][ALL + 1], b[ALL], sum2, count;
};

static void set_terms(struct equations *e, const int *term, int n)
{
    e->n = n;
    for (int i = 0; i < n; i++)
        e->of[i] = term[i];
}

/* What the fall changes by with the slopes to the left and right, and with the radius; returns its
 * slope. */
static double slopes_of_fall(const double *c, double s, double d, double by[3])
{
    const double step = 1e-6;
    double left = c[3] + c[4] * s, right = c[5] + c[6] * s, slope, other;
    double down = fall(left, right, c[7], d, &slope);

    by[0] = d > 0 ? 0 : -d;
    by[1] = d > 0 ? d : 0;
    by[2] = 0;
    if (c[7] > 0) {
        by[0] = (fall(left + step, right, c[7], d, &other) - down) / step;
        by[1] = (fall(left, right + step, c[7], d, &other) - down) / step;
        by[2] = (fall(left, right, c[7] + step, d, &other) - down) / step;
    }
    return slope;
}

/* What a point's distance changes by with each of all terms, its slope's own part left out. */
static void slopes_at(const struct crest_fit *fit, struct vec3 p, double s, double d, double x[ALL])
{
    const double *c = fit->c, k = fit->bend;
    double beside = (p.y - fit->origin.y) * fit->way_x - (p.x - fit->origin.x) * fit->way_y;
    double u = beside - fit->off, g = u * u + s * s, q = 2 * u + k * g;
    double root = sqrt(fmax(1 + k * q, 1e-6)), one = 1 + root;
    double d_u = (1 + k * u) / root, d_s = k * s / root;
    double d_bend = g / one - q * (q + k * g) / (2 * root * one * one);
    double by[3], slope = slopes_of_fall(c, s, d, by), across = sqrt(1 + slope * slope);
    double h_d = -slope / across;
    double h_s = (c[1] + 2 * c[2] * s - by[0] * c[4] - by[1] * c[6]) / across;

    x[0] = h_d * d_u;
    x[1] = -h_s * beside - h_d * (d_s * beside - d_u * s);
    x[2] = -h_d * d_bend;
    x[3] = -1 / across;
    x[4] = -s / across;
    x[5] = -s * s / across;
    x[6] = by[0] / across;
    x[7] = s * x[6];
    x[8] = by[1] / across;
    x[9] = s * x[8];
    x[ROUND] = by[2] / across;
}

static void add_point(const struct crest_fit *fit, struct vec3 p, double off, double s, double d,
                      struct equations *e)
{
    double x[ALL], by[ALL + 1];

    slopes_at(fit, p, s, d, x);
    for (int i = 0; i < e->n; i++)
        by[i] = x[e->of[i]];
    by[e->n] = 0;
    for (int i = 0; i < e->n; i++) {
        for (int j = 0; j <= i; j += 2)
            pair_put(&e->a[i][j], pair_at(&e->a[i][j]) + pair_both(by[i]) * pair_at(&by[j]));
        e->b[i] -= by[i] * off;
    }
}

/* The equations of those within `least` of the crest; the others count as if they were so far
 * off. */
static void sum_points(const struct crest_fit *fit, const struct vec3 *point, size_t n,
                       double least, struct equations *e)
{
    double s, d;

    e->sum2 = e->count = 0;
    memset(e->a, 0, sizeof e->a);
    memset(e->b, 0, sizeof e->b);
    for (size_t k = 0; k < n; k++) {
        double off = distance(fit, point[k], &s, &d);
        double part = fmin(fabs(off), least);
        e->sum2 += part * part;
        e->count += fabs(off) < least;
        if (fabs(off) < least)
            add_point(fit, point[k], off, s, d, e);
    }
}

/* The sum of squares alone, or when it is beyond `most` what it has come to. */
static double sum_squares(const struct crest_fit *fit, const struct vec3 *point, size_t n,
                          double least, double most)
{
    double s, d, sum2 = 0;

    for (size_t k = 0; k < n && sum2 < most; k++) {
        double part = fmin(fabs(distance(fit, point[k], &s, &d)), least);
        sum2 += part * part;
    }
    return sum2;
}

static bool solve(const struct equations *e, double damp, double *x)
{
    double room[ALL * ALL];
    struct band a = {(size_t)e->n, (size_t)e->n - 1, room};

    for (int i = 0; i < e->n; i++) {
        x[i] = e->b[i];
        for (int j = 0; j <= i; j++)
            *band_at(&a, (size_t)i, (size_t)j) = e->a[i][j] * (i == j ? 1 + damp : 1);
    }
    if (!band_factor(&a))
        return false;
    band_solve(&a, x, 1);
    return true;
}

static void make_steps(struct crest_fit *fit, const struct equations *e, const double *x)
{
    for (int i = 0; i < e->n; i++)
        make_step(fit, e->of[i], x[i]);
}

/* Steps that make the sum less, of points within `least` of where they begin. */
static void settle(struct crest_fit *fit, const struct vec3 *point, size_t n, double least,
                   struct equations *e)
{
    double damp = 1e-4, x[ALL];

    sum_points(fit, point, n, least, e);
    for (int turn = 0; turn < TURNS; turn++) {
        struct crest_fit next = *fit;
        if (e->count < e->n || !solve(e, damp, x))
            return;
        make_steps(&next, e, x);
        double then = sum_squares(&next, point, n, least, e->sum2);
        if (!(then < e->sum2)) {
            damp *= 20;
            continue;
        }
        bool done = then > 0.999 * e->sum2;
        damp /= 10;
        *fit = next;
        if (done)
            return;
        sum_points(fit, point, n, least, e);
    }
}

/* How many of n points, nearest first, are as near as that to the first, as seen from above; `some`
 * at least. */
static size_t count_near(const struct vec3 *point, size_t n, double reach, size_t some)
{
    some = some < n ? some : n;

    while (some < n &&
           hypot_compare(point[some].x - point[0].x, point[some].y - point[0].y, reach) <= 0)
        some++;
    return some;
}

static bool is_sharp(const struct crest_fit *fit)
{
    double a = fit->c[3], b = fit->c[5];

    return a + b > 0 && (1 - a * b) < SHARP * sqrt((1 + a * a) * (1 + b * b));
}

/* The terms of a crest whose sides are planes: height and slope along it, and their slopes. */
enum { PLANES = 4 };
static const int PLANE[PLANES] = {3, 4, 6, 8};

/* As sum_points, of a straight crest that is level all about so far, for these terms. */
static void sum_level(const struct crest_fit *fit, const struct vec3 *point, size_t n,
                      struct equations *e)
{
    memset(e, 0, sizeof *e);
    set_terms(e, PLANE, PLANES);
    for (size_t k = 0; k < n; k++) {
        double dx = point[k].x - fit->origin.x, dy = point[k].y - fit->origin.y;
        double d = dy * fit->way_x - dx * fit->way_y - fit->off;
        double x[PLANES] = {-1, -(dx * fit->way_x + dy * fit->way_y), d > 0 ? 0 : -d,
                            d > 0 ? d : 0};
        for (int i = 0; i < PLANES; i++) {
            for (int j = 0; j <= i; j++)
                e->a[i][j] += x[i] * x[j];
            e->b[i] -= x[i] * (point[k].z - fit->c[0]);
        }
    }
}

/* The straight crest along a direction and beside the first point that the nearest fit best; of
 * those whose sum of squares is not below `most` any. */
static struct crest_fit begin_along(const struct vec3 *point, size_t n, double spacing, double turn,
                                    double most)
{
    struct crest_fit best = {.rms = HUGE_VAL};
    struct sine_cosine way = elementary_sine_cosine(turn);

    for (double off = -FARTHEST; off <= FARTHEST; off += STEP) {
        struct crest_fit fit = {.origin = point[0],
                                .way_x = way.cosine,
                                .way_y = way.sine,
                                .off = off * spacing,
                                .c = {point[0].z}};
        struct equations e;
        double x[ALL];
        sum_level(&fit, point, n, &e);
        if (!solve(&e, 1e-9, x))
            continue;
        make_steps(&fit, &e, x);
        fit.rms = sum_squares(&fit, point, n, spacing / 4, fmin(most, best.rms));
        if (fit.c[3] + fit.c[5] > 0 && fit.rms < best.rms)
            best = fit;
    }
    return best;
}

/* Those of all directions, the BEGUN best of them, best first. */
static void begin(const struct vec3 *point, size_t n, double spacing, struct crest_fit *best)
{
    enum { WAYS = 12 };

    for (int k = 0; k < BEGUN; k++)
        best[k].rms = HUGE_VAL;
    for (int way = 0; way < WAYS; way++) {
        struct crest_fit fit = begin_along(point, n, spacing, PI * way / WAYS, best[BEGUN - 1].rms);
        for (int k = 0; k < BEGUN; k++)
            if (fit.rms < best[k].rms) {
                struct crest_fit other = best[k];
                best[k] = fit;
                fit = other;
            }
    }
}

void crest_fit_roles(const struct crest_fit *fit, const struct vec3 *point, size_t n,
                     double spacing, double within, enum crest_role *role)
{
    double s, d;

    for (size_t k = 0; k < n; k++) {
        double off = distance(fit, point[k], &s, &d);
        role[k] = CREST_OTHER;
        if (off > within && fabs(d) > spacing)
            role[k] = CREST_FOOT;
        if (fabs(off) <= within)
            role[k] = CREST_SIDE;
    }
}

/* The terms that it has. */
static int terms_of(const struct crest_fit *fit)
{
    return fit->c[7] > 0 ? ALL : ROUND;
}

/* A place is on the arc between the sides. */
static bool is_on_arc(const struct crest_fit *fit, double s, double d)
{
    const double *c = fit->c;
    double left = c[3] + c[4] * s, right = c[5] + c[6] * s, slope;

    fall(left, right, c[7], d, &slope);
    return slope < right && slope > -left;
}

/* How far it goes by its points; false: it has too few, or they are not near it or none on its arc,
 * or there are too many others. */
static bool measure(struct crest_fit *fit, const struct vec3 *point, size_t n, double spacing,
                    const enum crest_role *role)
{
    size_t count[2] = {0, 0}, other = 0, arc = 0;
    double near[2] = {HUGE_VAL, HUGE_VAL}, sum2 = 0, s, d;

    fit->far[0] = fit->far[1] = fit->from = fit->to = 0;
    for (size_t k = 0; k < n; k++) {
        double off = distance(fit, point[k], &s, &d);
        int side = d > 0;
        other += role[k] == CREST_OTHER;
        if (role[k] != CREST_SIDE)
            continue;
        sum2 += off * off;
        count[side]++;
        arc += is_on_arc(fit, s, d);
        near[side] = fmin(near[side], fabs(d));
        fit->far[side] = fmax(fit->far[side], fabs(d));
        fit->from = fmin(fit->from, s);
        fit->to = fmax(fit->to, s);
    }
    for (int side = 0; side < 2; side++)
        if (count[side] < FEWEST || fit->far[side] - near[side] < ACROSS * spacing ||
            near[side] > CLOSE * spacing)
            return false;
    fit->rms = sqrt(sum2 / ((double)(count[0] + count[1]) - terms_of(fit) + 1));
    return (fit->c[7] == 0 || arc >= ON_ARC) && MOST * other <= n &&
           fit->to - fit->from > LONG * spacing;
}

/* A crest that is begun, of the points next to it alone, bent to all of them; false: it explains
 * not all that are next to it. */
static bool finish(struct crest_fit *fit, bool follows, const struct vec3 *point, size_t n,
                   double spacing, double within, double even, enum crest_role *role)
{
    static const int all[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, ROUND};
    static const double then[] = {0.2, 0.1, 0.05};
    size_t next = count_near(point, n, NEXT * spacing, 1);
    struct equations e;

    set_terms(&e, all, terms_of(fit));
    for (int k = 0; k < 3 && !follows; k++)
        settle(fit, point, n, then[k] * spacing, &e);
    settle(fit, point, n, within, &e);
    crest_fit_roles(fit, point, n, spacing, within, role);
    if (!is_sharp(fit) || fabs(fit->off) > FARTHEST * spacing || !(fit->c[7] >= 0) ||
        fit->c[7] > ROUNDEST * spacing || !measure(fit, point, n, spacing, role) || fit->rms > even)
        return false;
    for (size_t k = 0; k < next; k++)
        if (role[k] == CREST_OTHER)
            return false;
    return true;
}

/* The same, of as many points as it explains. */
static bool finish_any(const struct crest_fit *begun, bool follows, const struct vec3 *point,
                       size_t n, double spacing, double within, double even, struct crest_fit *fit,
                       enum crest_role *role)
{
    static const double reach[] = {4, 3.2};

    for (int i = 0; i < 2; i++) {
        *fit = *begun;
        if (!finish(fit, follows, point, count_near(point, n, reach[i] * spacing, 1), spacing,
                    within, even, role))
            continue;
        crest_fit_roles(fit, point, n, spacing, within, role); /* those beyond its reach, too */
        return true;
    }
    return false;
}

/* Of the crest as it is where the place is beside it. */
static bool move_origin(struct crest_fit *fit, struct vec3 to)
{
    const struct crest_fit old = *fit;
    double s, d, *c = fit->c;

    if (!crest_fit_local(&old, to.x, to.y, &s, &d))
        return false;
    double turn = -old.bend * s, upright = 1 - turn * turn;
    if (!(upright > 0.1))
        return false;
    upright = sqrt(upright);
    fit->origin = to;
    fit->way_x = upright * old.way_x - turn * old.way_y;
    fit->way_y = upright * old.way_y + turn * old.way_x;
    fit->off = -d;
    c[0] += s * (c[1] + s * c[2]);
    c[1] += 2 * s * c[2];
    c[3] += s * c[4];
    c[5] += s * c[6];
    return true;
}

int crest_fit_follow(const struct vec3 *point, size_t n, double spacing, double within, double even,
                     const struct crest_fit *from, struct crest_fit *fit, enum crest_role *role)
{
    struct crest_fit begun = *from;

    return move_origin(&begun, point[0]) &&
                   finish_any(&begun, true, point, n, spacing, within, even, fit, role)
               ? 0
               : -1;
}

/* The first crests settled by the points about; returns how many are left, best first. */
static int begin_straight(const struct vec3 *point, size_t n, double spacing,
                          struct crest_fit *begun)
{
    static const int straight[] = {0, 1, 3, 4, 6, 8};
    static const double first[] = {0.5, 0.25, 0.12};
    size_t nearest = count_near(point, n, BEGIN * spacing, NEAREST);
    size_t some = count_near(point, n, FIRST * spacing, NEAREST + NEAREST / 4);
    struct equations e;
    int left = 0;

    if (nearest < AT_FIRST)
        return 0;
    begin(point, nearest, spacing, begun);
    set_terms(&e, straight, 6);
    for (int k = 0; k < BEGUN && begun[k].rms < HUGE_VAL; k++) {
        struct crest_fit fit = begun[k];
        for (int i = 0; i < 3; i++)
            settle(&fit, point, some, first[i] * spacing, &e);
        if (e.count >= AT_FIRST && MUCH * e.count >= (double)some && is_sharp(&fit))
            begun[left++] = fit;
    }
    return left;
}

/* A sharp one, or the best of these rounded if that is fitted much better. */
int crest_fit_find(const struct vec3 *point, size_t n, double spacing, double within, double even,
                   struct crest_fit *fit, enum crest_role *role)
{
    const double better = 0.3;
    struct crest_fit begun[BEGUN], round;
    int left = begin_straight(point, n, spacing, begun);
    bool found = false;

    for (int k = 0; k < left && !found; k++)
        found = finish_any(&begun[k], false, point, n, spacing, within, even, fit, role);
    double rms = found ? better * fit->rms : even;
    begun[0].c[7] = ROUNDED * spacing;
    if (left > 0 && finish_any(&begun[0], false, point, n, spacing, within, rms, &round, role)) {
        *fit = round;
        return 0;
    }
    if (found)
        crest_fit_roles(fit, point, n, spacing, within, role);
    return found ? 0 : -1;
}
