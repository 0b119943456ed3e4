/* edge_along - see edge_steps.h. */
#include "edge_steps.h"
#include "math/ridge_direction.h"

/* Points that neighbours along a rib are taken from; of these; directions tried to begin with,
 * which are looked about by 20 degrees to either side; the fewest on the top of a wall. */
enum { MANY = 200, SOME = 24, WAYS = 5, LEVEL = 8 };

/* The quadric through neighbours along the way that serves it best. */
static bool find_along(const struct vec3 *point, size_t n, struct ridge_direction *best)
{
    struct vec3 up = plane_normal(point, EDGE_NEAR);
    struct quadric frame = quadric_frame(point[0], up);
    struct ridge_direction rib;

    best->rms = HUGE_VAL;
    for (int k = 0; k < WAYS; k++) {
        double t = PI * k / WAYS;
        struct vec3 way = vec_along(vec_scale(cos(t), frame.u), sin(t), frame.v);
        if (ridge_direction_find(point, n, point[0], up, way, SOME, &rib) && rib.rms < best->rms)
            *best = rib;
    }
    return best->rms < HUGE_VAL;
}

/* The point stands out from those about it: a ball may sink in beside it. */
static bool stands_out(const struct vec3 *point)
{
    struct vec3 up = plane_normal(point, SOME), mean = vec(0, 0, 0);

    for (size_t k = 0; k < SOME; k++)
        mean = vec_along(mean, 1. / SOME, point[k]);
    return vec_dot(up, vec_sub(point[0], mean)) * up.z > 0;
}

/* The way that n points lie along, seen from above; false: they lie along none. */
static bool find_strip(const struct vec3 *point, size_t n, struct vec3 *way)
{
    enum { TURNS = 20 };
    const double narrow = 0.4;
    struct vec3 mean = vec(0, 0, 0), axis = vec_sub(point[n - 1], point[0]);
    double all = 0, along = 0;

    for (size_t k = 0; k < n; k++)
        mean = vec_along(mean, 1 / (double)n, point[k]);
    for (int turn = 0; turn < TURNS; turn++) {
        struct vec3 next = vec(0, 0, 0);
        axis = vec_unit(vec(axis.x, axis.y, 0));
        all = along = 0;
        for (size_t k = 0; k < n; k++) {
            struct vec3 to = vec(point[k].x - mean.x, point[k].y - mean.y, 0);
            double part = vec_dot(to, axis);
            next = vec_along(next, part, to);
            all += vec_dot(to, to);
            along += part * part;
        }
        axis = next;
    }
    *way = vec_unit(axis);
    return all - along < narrow * narrow * along;
}

/* Straight lines through a point, level across `way` (unit, level itself). */
struct level_line {
    struct vec3 from, way;
    double slope;
};

static double above_line(const struct level_line *line, struct vec3 p)
{
    struct vec3 off = vec_sub(p, line->from);

    return off.z - line->slope * vec_dot(off, line->way);
}

/* None of n points is above the line, and to both sides of it some are below. */
static bool is_crest(const struct level_line *line, const struct vec3 *point, size_t n,
                     double within)
{
    const double tilt = 0.1;
    struct vec3 side = vec_cross(vec(0, 0, 1), line->way);
    size_t below[2] = {0, 0};

    for (size_t k = 0; k < n; k++) {
        double h = above_line(line, point[k]);
        double beside = vec_dot(vec_sub(point[k], line->from), side);
        if (h > within + tilt * fabs(beside))
            return false;
        below[beside > 0] += h < -within;
    }
    return below[0] > 0 && below[1] > 0;
}

/* Those of n points, EDGE_NEAR at most, on the line through the first that most of them are on; 0
 * where it is no crest. */
static size_t gather_level(const struct vec3 *point, size_t n, struct vec3 way, double within,
                           struct vec3 *on)
{
    const double steepest = 1;
    struct level_line best = {point[0], way, 0};
    size_t most = 0, found = 0;

    for (size_t k = 1; k < n; k++) {
        struct vec3 to = vec_sub(point[k], point[0]);
        struct level_line line = {point[0], way, to.z / vec_dot(to, way)};
        size_t count = 0;
        for (size_t j = 0; j < n && fabs(line.slope) < steepest; j++)
            count += fabs(above_line(&line, point[j])) <= within;
        if (count > most) {
            most = count;
            best = line;
        }
    }
    for (size_t j = 0; j < n && found < EDGE_NEAR && most > 0; j++)
        if (fabs(above_line(&best, point[j])) <= within)
            on[found++] = point[j];
    return is_crest(&best, point, n, within) ? found : 0;
}

/* Through the points of a narrow strip; across it is level where they do not tell: beside each are
 * two that hardly count. */
static bool fit_strip(const struct vec3 *on, size_t n, struct vec3 way, struct quadric *q)
{
    const double little = 0.03, beside = 0.6;
    struct vec3 guest[3 * EDGE_NEAR], up = vec(0, 0, 1), side = vec_cross(up, way);
    double weight[3 * EDGE_NEAR], along2 = 0;

    for (size_t k = 0; k < n; k++) {
        double along = vec_dot(vec_sub(on[k], on[0]), way);
        along2 += along * along / (double)n;
    }
    for (size_t k = 0; k < 3 * n; k++) {
        double off = beside * sqrt(along2) * ((double)(k % 3) - 1);
        weight[k] = k % 3 == 1 ? 1 : little;
        guest[k] = vec_along(on[k / 3], off, side);
    }
    return quadric_fit_weighted(guest, weight, 3 * n, on[0], up, q) == 0;
}

/* The top of a narrow wall that the first of n points is on, from those of it; the wall is where
 * the nearest lie along a line. */
static bool find_top(const struct vec3 *point, size_t n, double within, struct edge_flank *flank)
{
    struct vec3 way, on[EDGE_NEAR];

    for (size_t some = SOME; some >= SOME / 2; some -= SOME / 4) {
        if (!find_strip(point, some, &way))
            continue;
        size_t level = gather_level(point, n, way, within, on);
        if (level < LEVEL || !fit_strip(on, level, way, &flank->q))
            continue;
        flank->rms = quadric_spread(&flank->q, on, level, 5);
        if (flank->rms <= within && fabs(quadric_off(&flank->q, point[0])) <= within)
            return true;
    }
    return false;
}

static size_t find_points(const struct point_grid *b, size_t i, struct vec3 *point)
{
    uint32_t index[MANY];
    double distance2[MANY];
    size_t n = point_grid_nearest(b, b->point[i], MANY, index, distance2);

    for (size_t k = 0; k < n; k++)
        point[k] = b->point[index[k]];
    return n;
}

void edge_along_find(const struct edge_work *work, size_t i)
{
    const struct point_grid *b = work->options->point_grid;
    double spacing = work->flank[i].spacing > 0 ? work->flank[i].spacing : point_grid_spacing(b);
    struct edge_flank flank = work->flank[i];
    struct vec3 point[MANY];
    struct ridge_direction rib;
    size_t n = find_points(b, i, point);

    if (n < EDGE_NEAR)
        return;
    if (!find_top(point, n / 2, edge_even(work, spacing), &flank)) {
        if (edge_flank_known(&flank) || !stands_out(point) || !find_along(point, n, &rib))
            return;
        flank.q = rib.q;
        flank.rms = rib.rms * sqrt(SOME / (SOME - 6.)); /* a quadric has six terms */
        quadric_face_up(&flank.q);
        if (flank.rms > edge_even(work, spacing) || quadric_normal(&flank.q).z < EDGE_UPRIGHT)
            return;
    }
    flank.spacing = spacing;
    flank.along = flank.valid = true;
    work->flank[i] = flank;
}
