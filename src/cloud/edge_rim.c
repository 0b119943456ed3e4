/* edge_rim - see edge_steps.h. */
#include "edge_steps.h"

#include "math/elementary.h"

/* In spacings: half a step round may be off by the first; over one along it the rim bends by no
 * more than the second. */
static const double SLACK = 0.08, BEND = 0.06;

/* In spacings: points so far away bear it out, or where these make no rim, nearer ones. */
enum { WINDOWS = 3 };
static const double WINDOW[WINDOWS] = {EDGE_REACH, 2.1, 1.6};

static bool is_within(struct vec3 from, struct vec3 p, double reach)
{
    return hypot_compare(p.x - from.x, p.y - from.y, reach) <= 0;
}

/* So near to a point under it, by the distance of one on it, a flank does not end by chance; and
 * where one is so near to a point of it, in spacings, the scan has two layers and this tells
 * nothing. */
static const double COVERED = 0.3, LAYERED = 0.1;

/* How far p is ahead of the point towards (u, v), mm, aside as a rim that bends would have it. */
static double ahead_of(struct vec3 from, struct vec3 p, double u, double v, double bend)
{
    double x = p.x - from.x, y = p.y - from.y, aside = u * y - v * x;

    return u * x + v * y + bend * aside * aside;
}

/* Beside the place, seen from above, is a point that is below the flank, no further than
 * `radius`. */
static bool is_over_any(const struct edge_work *work, size_t i, struct vec3 at, double radius)
{
    const struct point_grid *b = work->options->point_grid;
    const struct edge_flank *flank = &work->flank[i];
    size_t first = point_grid_column(b, at.x - radius), last = point_grid_column(b, at.x + radius);
    size_t top = point_grid_row(b, at.y + radius);
    struct vec3 normal;

    for (size_t row = point_grid_row(b, at.y - radius); row <= top; row++) {
        size_t end = b->first[row * b->columns + last + 1];
        for (size_t k = b->first[row * b->columns + first]; k < end; k++) {
            double least = fmax(edge_within(work, flank->spacing),
                                EDGE_STEP * vec_distance(b->point[k], b->point[i]));
            if (is_within(at, b->point[k], radius) &&
                edge_flank_above(flank, b->point[k], &normal) < -least)
                return true;
        }
    }
    return false;
}

/* By points no further away than that, as seen from above. */
static void find_within(struct vec3 from, const struct vec3s *on, const struct vec3s *under,
                        double reach, double spacing, struct edge_rim *rim)
{
    double bend = BEND / spacing;

    rim->n = 0;
    for (int k = 0; k < EDGE_ROUND; k++) {
        double u = cos(2 * PI * k / EDGE_ROUND), v = sin(2 * PI * k / EDGE_ROUND);
        double inner = 0, outer = HUGE_VAL;
        for (size_t i = 0; i < on->n; i++)
            if (is_within(from, on->item[i], reach))
                inner = fmax(inner, ahead_of(from, on->item[i], u, v, -bend));
        for (size_t i = 0; i < under->n; i++)
            if (is_within(from, under->item[i], reach))
                outer = fmin(outer, ahead_of(from, under->item[i], u, v, bend));
        outer += SLACK * spacing;
        if (inner > outer)
            continue;
        rim->u[rim->n] = u;
        rim->v[rim->n] = v;
        rim->most[rim->n++] = outer;
    }
}

struct edge_rim edge_rim_find(const struct edge_work *work, size_t i, const struct vec3s *on,
                              const struct vec3s *under)
{
    double spacing = point_grid_spacing(work->options->point_grid);
    struct vec3 from = work->options->point_grid->point[i];
    struct edge_rim rim = {.layered = is_over_any(work, i, from, LAYERED * spacing)};

    for (int k = 0; k < WINDOWS && under->n > 0 && rim.n == 0; k++) {
        rim.reach = WINDOW[k] * spacing;
        find_within(from, on, under, rim.reach, spacing, &rim);
    }
    return rim;
}

double edge_rim_way(const struct edge_rim *rim, double u, double v)
{
    double way = rim->n == 0 ? 1 : 0, far = hypot(u, v);

    for (int k = 0; k < rim->n && way < 1; k++) {
        double ahead = rim->u[k] * u + rim->v[k] * v;
        way = fmax(way, ahead > rim->most[k] ? rim->most[k] / ahead : 1);
    }
    return rim->n > 0 && way * far > rim->reach ? rim->reach / far : way;
}

bool edge_rim_allows(const struct edge_work *work, const struct edge_rim *rim, size_t i,
                     struct vec3 at)
{
    struct vec3 from = work->options->point_grid->point[i];
    double u = at.x - from.x, v = at.y - from.y;

    return edge_rim_way(rim, u, v) == 1 &&
           (rim->layered || !is_over_any(work, i, at, COVERED * hypot(u, v)));
}
