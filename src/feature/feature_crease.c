/* feature_crease - the crease between two vertices, and whether it is sharp; see feature_steps.h.
 */
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "feature_steps.h"
#include "math/ridge_direction.h"
#include "base/array.h"
#include "math/pair.h"
#include "math/side_fit.h"

enum { CLOSE = 24, STRIP = 48 };

/* How far the points nearest to the crease may be off the sheets in the mean, in mean spacings:
 * further where an edge is rounded. */
static const double ROUND = 0.05;

/* Two sheets in one frame. */
struct pair {
    const struct side_fit *sheet;
    struct vec3 up;
};

/* The mean of the points' distances from the nearer sheet, and their root mean square. */
static void off_sheets(const struct pair *p, const struct vec3 *near, size_t n, double *mean,
                       double *rms)
{
    double sum = 0, sum2 = 0;

    for (size_t i = 0; i < n; i++) {
        double above[2] = {side_fit_above(&p->sheet[0], near[i]),
                           side_fit_above(&p->sheet[1], near[i])};
        double off = fabs(above[0]) < fabs(above[1]) ? above[0] : above[1];
        sum += off;
        sum2 += off * off;
    }
    *mean = sum / (double)n;
    *rms = sqrt(sum2 / (double)n);
}

/* A quadric leaves much less of n points. */
static bool leaves_more(const struct pair *p, const struct feature_cloud *cloud,
                        const struct vec3 *near, size_t n, double left)
{
    double mean, rms;

    off_sheets(p, near, n, &mean, &rms);
    return rms > 1.15 * left * sqrt((double)n / ((double)n - 6.0)) + 0.01 * cloud->spacing &&
           rms > 1.25 * cloud->noise;
}

/* The points nearest to the crease are all on one side of the sheets. */
static bool crease_gapes(const struct pair *p, const struct feature_cloud *cloud,
                         const struct vec3 *near, size_t n)
{
    double mean, rms;

    off_sheets(p, near, n, &mean, &rms);
    return fabs(mean) > 2.5 * cloud->noise / sqrt((double)n) + ROUND * cloud->spacing;
}

/* The same of the points nearest along the crease, which tell of a narrow rib. */
static bool is_rib(const struct pair *p, const struct feature_cloud *cloud, const struct vec3 *near,
                   size_t n, size_t some, struct vec3 at, struct vec3 along)
{
    struct vec3 found[STRIP];
    struct ridge_direction rib;

    if (!ridge_direction_find(near, n, at, p->up, along, some, &rib))
        return false;
    size_t all = neighbourhood_along(near, n, at, rib.way, RIDGE_DIRECTION_LONGER, some, found);
    if (leaves_more(p, cloud, found, all, rib.rms))
        return true;
    size_t third = neighbourhood_along(near, n, at, along, RIDGE_DIRECTION_LONGER, some / 3, found);
    return crease_gapes(p, cloud, found, third);
}

bool feature_test_sharp(const struct feature_cloud *cloud, const struct side_fit sheet[2],
                        struct vec3 up, struct vec3 at, struct vec3 along)
{
    struct pair p = {sheet, up};
    struct vec3 near[RIDGE_DIRECTION_LONGER * STRIP];
    struct quadric one;
    size_t n = feature_near(cloud, at, RIDGE_DIRECTION_LONGER * STRIP, near);

    if (n < CLOSE)
        return false;
    if (quadric_fit(near, CLOSE, at, up, &one) == 0 &&
        leaves_more(&p, cloud, near, CLOSE, quadric_rms(&one, near, CLOSE)))
        return false;
    return !crease_gapes(&p, cloud, near, CLOSE / 2) &&
           !is_rib(&p, cloud, near, n, CLOSE, at, along) &&
           !is_rib(&p, cloud, near, n, STRIP, at, along);
}

enum { MOST = FEATURE_MOST, TURNS = 20, FEWEST = 8, FEWEST_NEAR = 72, QUADRIC = 6, BLOCK = 8 };

static const double FLAT = 0.99026806874157036; /* cos 8 degrees */

/* How wide a neighbourhood is against the noise. */
static const double WIDE = 40;

/* What two sheets may leave, in mean spacings, beside the noise. */
static const double ROUGH = 0.05;

/* Points about a place, divided between two sheets. */
struct division {
    struct vec3 point[MOST];
    struct vec3 local[MOST]; /* the same, in the frame of the sheets */
    double u[MOST], v[MOST]; /* of these, each by itself: two fit a register */
    int64_t second[MOST];    /* 0, or all bits where it is on the second sheet */
    struct vec3 of[2][MOST]; /* all, by sheet */
    size_t n, count[2];
    size_t asked; /* the points are the so many nearest ones, 0: there are none yet, to ... */
    struct vec3 about;
    struct vec3 origin, w;
    struct side_fit sheet[2];
};

/* How far sheet 0 is above sheet 1.  Both have the same frame. */
static double step_at(const struct division *p, struct vec3 at)
{
    struct vec3 local = quadric_local(&p->sheet[0].q, at);

    return side_fit_height_local(&p->sheet[0], local) - side_fit_height_local(&p->sheet[1], local);
}

/* Planes through the points as they are divided; false when one has too few. */
static bool fit_planes(struct division *p, const struct side_sums sum[2])
{
    for (int s = 0; s < 2; s++)
        if (p->count[s] < FEWEST || side_fit_plane_of(&sum[s], &p->sheet[s]) < 0)
            return false;
    return true;
}

/* How far sheet 0, a plane, is above sheet 1, another, over a place of their frame. */
struct difference {
    double c0, c1, c2;
    int64_t turned; /* all bits: where it is above is the side of sheet 0; else 0 */
};

/* As in struct division. */
static int64_t is_second(struct difference d, double u, double v)
{
    return -(int64_t)(d.c0 + d.c1 * u + d.c2 * v > 0) ^ d.turned;
}

/* Does one of BLOCK points change sides?  Two at a time: most do not. */
static bool block_changes(const struct division *p, struct difference d, size_t from)
{
    typedef int64_t sides __attribute__((vector_size(16)));
    const pair c0 = pair_both(d.c0), c1 = pair_both(d.c1), c2 = pair_both(d.c2), zero = {0, 0};
    const sides turned = {d.turned, d.turned};
    sides change = {0, 0};

    for (size_t i = from; i < from + BLOCK; i += 2) {
        sides was;
        memcpy(&was, p->second + i, sizeof was);
        sides above = c0 + c1 * pair_at(p->u + i) + c2 * pair_at(p->v + i) > zero;
        change |= above ^ turned ^ was;
    }
    return (change[0] | change[1]) != 0;
}

/* Divides the points by the line where the two planes meet; a's side of it is sheet 0; the sums of
 * both sides, which only the points change that change sides.  True when some did. */
static bool divide_by_line(struct division *p, struct vec3 a, struct side_sums sum[2])
{
    const double *c = p->sheet[0].q.c, *e = p->sheet[1].q.c;
    struct difference d = {c[0] - e[0], c[1] - e[1], c[2] - e[2], -(int64_t)(step_at(p, a) > 0)};
    bool changed = false;

    for (size_t from = 0; from < p->n; from += BLOCK) {
        if (!block_changes(p, d, from))
            continue;
        for (size_t i = from; i < from + BLOCK && i < p->n; i++) {
            int64_t second = is_second(d, p->u[i], p->v[i]);
            if (second == p->second[i])
                continue;
            size_t side = second != 0;
            side_sums_add(&sum[side], 1, p->local[i]);
            side_sums_add(&sum[1 - side], -1, p->local[i]);
            p->count[side]++;
            p->count[1 - side]--;
            p->second[i] = second;
            changed = true;
        }
    }
    return changed;
}

/* The points in the frame of the sheets; those that fill the last block stand at its origin. */
static void bring_into_frame(struct division *p)
{
    for (int s = 0; s < 2; s++)
        p->sheet[s].q = quadric_frame(p->origin, p->w);
    quadric_local_all(&p->sheet[0].q, p->point, p->n, p->local);
    for (size_t i = 0; i < p->n; i++) {
        p->u[i] = p->local[i].x;
        p->v[i] = p->local[i].y;
    }
    for (size_t i = p->n; i % BLOCK != 0; i++) {
        p->u[i] = p->v[i] = 0;
        p->second[i] = 0;
    }
}

/* The points by sheet, in their order, and the sums of both: each in registers. */
static void add_sides(struct division *p, struct side_sums sum[2])
{
    p->count[0] = p->count[1] = 0;
    for (size_t i = 0; i < p->n; i++) {
        size_t second = p->second[i] != 0;
        p->of[0][p->count[0]] = p->of[1][p->count[1]] = p->local[i]; /* to both: no jumps */
        p->count[0] += 1 - second;
        p->count[1] += second;
    }
    for (int s = 0; s < 2; s++) {
        struct side_sums side = {.n = 0};
        for (size_t i = 0; i < p->count[s]; i++)
            side_sums_add(&side, 1, p->of[s][i]);
        sum[s] = side;
    }
}

/* Fits and divides until nothing changes, or often enough. */
static bool fit_and_divide(struct division *p, struct vec3 a)
{
    struct side_sums sum[2];
    bool moves = true;

    bring_into_frame(p);
    add_sides(p, sum);
    for (int i = 0; i < TURNS && moves; i++) {
        if (!fit_planes(p, sum))
            return false;
        moves = divide_by_line(p, a, sum);
    }
    add_sides(p, sum); /* anew: points that went and came left digits */
    return fit_planes(p, sum);
}

/* Sheets that are bent where that is better; what they leave. */
static bool bend_sheets(struct division *p)
{
    for (int s = 0; s < 2; s++) {
        const struct quadric *q = &p->sheet[s].q;
        if (side_fit_plane_local(p->of[s], p->count[s], q->origin, q->w, &p->sheet[s]) < 0)
            return false;
        side_fit_bend_local(p->of[s], p->count[s], &p->sheet[s]);
    }
    return true;
}

/* Where on the way from a to b the sheets meet; false when they do not. */
static bool find_crossing(const struct division *p, struct vec3 a, struct vec3 b, struct vec3 *at)
{
    double first = step_at(p, a), last = step_at(p, b);

    if ((first > 0) == (last > 0))
        return false;
    /* on the way the step is a parabola: first + s (slope + s bend), with one of its zeros there */
    double bend = 2 * (first - 2 * step_at(p, vec_mix(a, b, 0.5)) + last);
    double slope = last - first - bend, root = sqrt(fmax(slope * slope - 4 * bend * first, 0));
    double sum = -(slope + (slope < 0 ? -root : root)) / 2, s = first / sum;
    if (!(s >= 0 && s <= 1))
        s = fmin(fmax(sum / bend, 0), 1);
    *at = side_fit_point(&p->sheet[0], vec_mix(a, b, s));
    return true;
}

/* What the two sheets leave to each point that they do not fix. */
static double left_by_two(const struct division *p)
{
    double sum2 = 0, fixed = 6;

    for (int s = 0; s < 2; s++) {
        double rms = quadric_rms_local(&p->sheet[s].q, p->of[s], p->count[s]);
        sum2 += rms * rms * (double)p->count[s];
        fixed += p->sheet[s].q.c[3] != 0 ? 3 : 0;
    }
    return sqrt(sum2 / fmax((double)p->n - fixed, 1));
}

static bool better_than_one(const struct division *p, const struct feature_cloud *cloud)
{
    struct quadric one;

    if (quadric_fit(p->point, p->n, p->origin, p->w, &one) < 0)
        return false;
    double left = quadric_spread(&one, p->point, p->n, QUADRIC);
    double two = left_by_two(p);
    /* by more than what two fits to the same noise may differ */
    double better = 1 - 2 / sqrt((double)p->n);
    return left > cloud->noise && two < better * left &&
           two < 2 * cloud->noise + ROUGH * cloud->spacing;
}

/* The nearest points, divided by the plane half way between a and b, or by the sheets as they
 * are. */
static bool gather_points(const struct feature_cloud *cloud, struct vec3 at, size_t k,
                          struct vec3 a, struct vec3 b, bool divided, struct division *p)
{
    if (k != p->asked || vec_distance(at, p->about) > 0) {
        p->n = feature_near(cloud, at, k, p->point);
        p->asked = k;
        p->about = at;
    }
    p->count[0] = p->count[1] = 0;
    if (p->n < 2 * FEWEST)
        return false;
    bool a_above = divided && step_at(p, a) > 0;
    struct vec3 way = vec_sub(b, a);
    for (size_t i = 0; i < p->n; i++) {
        struct vec3 q = p->point[i];
        bool first = divided ? (step_at(p, q) > 0) == a_above : vec_dot(vec_sub(q, at), way) <= 0;
        p->second[i] = -(int64_t)!first;
        p->count[!first]++;
    }
    return true;
}

/* How many points reach over the edge from end to end. */
static size_t points_needed(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b)
{
    double reach = vec_distance(a, b) / 2 / cloud->spacing + 1;
    double k = fmin(fmax(PI * reach * reach, (double)feature_reach(cloud)), MOST);

    return (size_t)k;
}

size_t feature_reach(const struct feature_cloud *cloud)
{
    double reach = WIDE * cloud->noise / cloud->spacing;

    return (size_t)fmin(fmax(PI * reach * reach, FEWEST_NEAR), FEATURE_MOST);
}

size_t feature_near(const struct feature_cloud *cloud, struct vec3 at, size_t k, struct vec3 *near)
{
    uint32_t index[FEATURE_MOST];
    double distance2[FEATURE_MOST];
    size_t n = point_grid_nearest(cloud->scan, at, k, index, distance2);

    for (size_t i = 0; i < n; i++)
        near[i] = cloud->scan->point[index[i]];
    return n;
}

bool feature_has_points(const struct feature_cloud *cloud, struct vec3 at)
{
    const double near_by = 3; /* spacings */
    struct vec3 near;

    return feature_near(cloud, at, 1, &near) == 1 &&
           vec_distance(near, at) <= near_by * cloud->spacing;
}

static struct feature crease_of(const struct division *p, struct vec3 at, struct vec3 a,
                                struct vec3 b)
{
    struct feature f = {.kind = FEATURE_CREASE, .place = {at, at}};

    for (int s = 0; s < 2; s++) {
        f.normal[s] = side_fit_normal(&p->sheet[s], at);
        f.end[s] = side_fit_normal(&p->sheet[s], s == 0 ? a : b);
        f.foot[s] = side_fit_point(&p->sheet[s], s == 0 ? a : b);
    }
    f.known = vec_distance(p->point[p->n - 1], at);
    f.along = vec_unit(vec_cross(f.normal[0], f.normal[1]));
    return f;
}

/*
 * From all points between a and b to where the crease may be, then the points nearest to that; each
 * time in a frame half way between the two sheets.  With `crossed` the sheets are there to begin
 * with, and meet at *at.  Sheets that do not meet on the way at once hardly ever do later.
 */
static bool find_crease(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                        bool crossed, struct division *p, struct vec3 *at)
{
    size_t near = feature_reach(cloud);

    for (bool again = crossed;; again = true) {
        if (!gather_points(cloud, again ? *at : p->origin,
                           again ? near : points_needed(cloud, a, b), a, b, again, p) ||
            !fit_and_divide(p, a) || !find_crossing(p, a, b, at))
            return false;
        if (again)
            break;
        p->w = vec_unit(vec_add(side_fit_normal(&p->sheet[0], p->origin),
                                side_fit_normal(&p->sheet[1], p->origin)));
    }
    return bend_sheets(p) && find_crossing(p, a, b, at);
}

/* The sheets turn into each other, and by more than they turn on the way there. */
static bool sheets_turn(const struct feature *f)
{
    double bend = vec_angle(f->normal[0], f->end[0]) + vec_angle(f->normal[1], f->end[1]);

    return vec_dot(f->normal[0], f->normal[1]) < FLAT &&
           vec_angle(f->normal[0], f->normal[1]) > 1.5 * bend;
}

/* From the planes that the vertices' normals tell. */
static bool from_normals(struct division *p, struct vec3 a, struct vec3 b, struct vec3 na,
                         struct vec3 nb, struct vec3 *at)
{
    const double least = 0.1; /* cosine of a sheet's normal and the frame's */

    if (vec_dot(na, nb) >= FLAT || vec_dot(na, p->w) < least || vec_dot(nb, p->w) < least)
        return false;
    p->sheet[0] = side_fit_through(a, na, p->origin, p->w);
    p->sheet[1] = side_fit_through(b, nb, p->origin, p->w);
    return find_crossing(p, a, b, at);
}

struct feature feature_crease(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                              struct vec3 na, struct vec3 nb)
{
    struct feature none = {.kind = FEATURE_NONE};
    struct division p;
    struct vec3 at, origin = vec_mix(a, b, 0.5), sum = vec_add(na, nb);
    /* the second one across the way, for the normals may both be of one side */
    struct vec3 w[2] = {vec_unit(sum), vec_unit(vec_reject(sum, vec_unit(vec_sub(b, a))))};

    p.n = p.asked = 0;
    for (int i = 0; i < 2; i++) {
        p.origin = origin;
        p.w = w[i];
        if (!(vec_length(w[i]) > 0) || (i == 0 && !from_normals(&p, a, b, na, nb, &at)) ||
            !find_crease(cloud, a, b, i == 0, &p, &at))
            continue;
        struct feature f = crease_of(&p, at, a, b);
        if (sheets_turn(&f) && better_than_one(&p, cloud) &&
            feature_test_sharp(cloud, p.sheet, p.w, at, f.along))
            return f;
    }
    return none;
}
