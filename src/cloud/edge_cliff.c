/* edge_cliff - see edge_steps.h and edge_cliff.h. */
#include "edge_cliff.h"

#include "math/triangles.h"
#include "plan_star.h"

static const double FACING = 0.12; /* least z of a flank that is continued over its wall */

/* ---- is a place of the flank before the wall? */

/* No other point of the flank is nearer to the place. */
static bool is_own(const struct edge_cliff *cliff, double u, double v)
{
    for (size_t k = 0; k < cliff->on.n; k++) {
        double x = cliff->on.item[k].x - cliff->from.x, y = cliff->on.item[k].y - cliff->from.y;
        if (2 * (u * x + v * y) > x * x + y * y)
            return false;
    }
    return true;
}

/* The wall may be beyond the place: this is on the way to a point below it, before all others of
 * these or, as at a corner, far beside them. */
static bool is_before_feet(const struct edge_cliff *cliff, double u, double v)
{
    const double beside = 0.7, past = 0.3; /* cosine of 45 degrees; of its way from the point */
    bool before = false;

    for (size_t k = 0; k < cliff->below.n; k++) {
        double x = cliff->below.item[k].x - cliff->from.x;
        double y = cliff->below.item[k].y - cliff->from.y, ahead = u * x + v * y;
        if (ahead > x * x + y * y &&
            (hypot(u, v) > cliff->corner || hypot(x - u, y - v) < past * hypot(u, v)))
            return false;
        before =
            before || (k < cliff->feet && ahead > beside * sqrt((u * u + v * v) * (x * x + y * y)));
    }
    return before;
}

bool edge_cliff_is_before(const struct edge_cliff *cliff, double u, double v)
{
    return is_own(cliff, u, v) && is_before_feet(cliff, u, v);
}

/* The place is no further than the edges that are known.  A cubic through all about a point, that
 * goes through the upper side's points, too, where these have a flank of their own, goes over the
 * wall as if it were none: if `over`, it is no edge. */
static bool is_before_edges(const struct edge_cliff *cliff, struct vec3 at, bool over)
{
    const struct edge_work *work = cliff->work;

    for (size_t k = 0; k < cliff->beyond.n; k++) {
        const struct edge_flank *other = &work->flank[cliff->beyond.item[k]];
        struct vec3 own = work->options->point_grid->point[cliff->beyond.item[k]];
        if (over && other->bent && !other->valid)
            continue;
        if (edge_cliff_above(other, own, at) > edge_within(work, other->spacing))
            return false;
    }
    return true;
}

/* Seen from above the place is amid three points that are under the flank: no wall stands there,
 * but farther back. */
static bool is_over_floor(const struct edge_cliff *cliff, double u, double v)
{
    const struct point_grid *scan = cliff->work->options->point_grid;
    size_t corner[3];

    return plan_star_over(scan, vec(cliff->from.x + u, cliff->from.y + v, 0),
                          EDGE_REACH * point_grid_spacing(scan), corner) &&
           edge_cliff_is_under(cliff, corner[0]) && edge_cliff_is_under(cliff, corner[1]) &&
           edge_cliff_is_under(cliff, corner[2]);
}

/* ---- places on the flank */

/* Points below are straight under the flank's: the wall was seen here, and is not farther on. */
static bool is_wall_seen(const struct edge_cliff *cliff, double spacing)
{
    enum { FEWEST = 3 }; /* fewer may be of a floor */
    const double beside = 0.3;
    int under = 0;

    for (size_t k = 0; k < cliff->below.n; k++)
        under += edge_plan_distance(cliff->below.item[k], cliff->from) < beside * spacing;
    return under >= FEWEST;
}

/* The places of triangles about a point, whether they are before the wall, as far as it is known:
 * each is asked of again from those beside it. */
struct before {
    const struct edge_cliff *cliff;
    double pitch; /* mm */
    int rings;
    signed char is[2 * EDGE_CLIFF_RINGS + 3][2 * EDGE_CLIFF_RINGS + 3]; /* 0: nobody asked yet */
};

/* Place k of row j is. */
static bool is_before(struct before *before, int j, int k)
{
    signed char *is = &before->is[before->rings + 1 + j][before->rings + 1 + k];

    if (*is == 0) {
        double u, v;
        triangles_at(before->pitch, k, j, &u, &v);
        *is = is_before_feet(before->cliff, u, v) && !is_over_floor(before->cliff, u, v) ? 1 : -1;
    }
    return *is > 0;
}

/* A place beside it is not before the wall: from here it may go down. */
static bool is_last(struct before *before, int j, int k)
{
    static const int beside[6][2] = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, -1}, {-1, 1}};

    for (int b = 0; b < 6; b++)
        if (!is_before(before, j + beside[b][0], k + beside[b][1]))
            return true;
    return false;
}

/* The flank goes on up to the points below: where the wall between is nobody knows. */
static void add_flank(const struct edge_cliff *cliff, struct vec3s *to)
{
    const struct edge_work *work = cliff->work;
    struct before before = {.cliff = cliff, .pitch = EDGE_CLIFF_PITCH * work->options->along};
    int rings = (int)fmin(triangles_rings(cliff->reach, before.pitch), EDGE_CLIFF_RINGS);
    bool hangs = !is_wall_seen(cliff, point_grid_spacing(work->options->point_grid));

    before.rings = rings;
    for (int j = -rings; j <= rings; j++)
        for (int k = -rings; k <= rings; k++) {
            double u, v;
            triangles_at(before.pitch, k, j, &u, &v);
            if (hypot_compare(u, v, cliff->reach) > 0 || !is_own(cliff, u, v) ||
                !is_before(&before, j, k))
                continue;
            struct vec3 at = edge_cliff_place(cliff, cliff->from.x + u, cliff->from.y + v);
            if (!edge_cliff_reaches(cliff, at) || !is_before_edges(cliff, at, false))
                continue;
            *array_push(to) = at;
            if (hangs && is_last(&before, j, k))
                edge_wall_add(work, at, edge_cliff_nearest_below(cliff, at), to);
        }
}

/* ---- places on the wall */

/* A point under the flank is on the way to the place, seen from above: no wall stands up to
 * there. */
static bool has_between(const struct edge_cliff *cliff, struct vec3 at, double beside)
{
    const double first = 0.1, last = 0.8; /* of the way */
    double u = at.x - cliff->from.x, v = at.y - cliff->from.y, way = hypot(u, v);

    for (size_t k = 0; k < cliff->under.n; k++) {
        double x = cliff->under.item[k].x - cliff->from.x;
        double y = cliff->under.item[k].y - cliff->from.y, t = (u * x + v * y) / (way * way);
        if (t > first && t < last && fabs(u * y - v * x) < beside * way)
            return true;
    }
    return false;
}

/* How far a point is under the flank, along z. */
static double drop_of(const struct edge_cliff *cliff, struct vec3 p)
{
    return edge_cliff_place(cliff, p.x, p.y).z - p.z;
}

/* What is behind a foot is not much lower: it is no place of a slope. */
static bool is_level_behind(const struct edge_cliff *cliff, struct vec3 foot, double spacing)
{
    const double least = 0.3, behind = 2.2, beside = 0.6; /* spacings */
    const double lower = 1.3;                             /* times as low as the foot */
    double u = foot.x - cliff->from.x, v = foot.y - cliff->from.y, way = hypot(u, v);
    double low = drop_of(cliff, foot);

    for (size_t k = 0; k < cliff->under.n; k++) {
        double x = cliff->under.item[k].x - foot.x, y = cliff->under.item[k].y - foot.y;
        double ahead = (u * x + v * y) / way, aside = fabs(u * y - v * x) / way;
        if (ahead > least * spacing && ahead < behind * spacing && aside < beside * spacing &&
            drop_of(cliff, cliff->under.item[k]) > lower * low)
            return false;
    }
    return true;
}

/* The rim right before a foot, (u, v) from the point: the flank there, no higher than a roof, nor,
 * where the flank is not `certain`, than the point. */
static struct vec3 rim_before(const struct edge_cliff *cliff, double u, double v, bool certain)
{
    double x = cliff->from.x + u, y = cliff->from.y + v, way = hypot(u, v);
    double top = edge_cliff_place(cliff, x, y).z;

    if (quadric_normal_at(&cliff->flank->q, cliff->from).z < FACING)
        top = fmax(top, cliff->from.z - EDGE_STEEP * way);
    return vec(x, y, fmin(top, cliff->from.z + (certain ? way : 0)));
}

/* The wall itself may go down from there to a point below, without points that were seen. */
static void add_wall(const struct edge_cliff *cliff, bool certain, struct vec3s *to)
{
    const double nearly = 0.97, spacing = point_grid_spacing(cliff->work->options->point_grid);

    for (size_t k = 0; k < cliff->feet; k++) {
        struct vec3 foot = cliff->below.item[k];
        double u = nearly * (foot.x - cliff->from.x), v = nearly * (foot.y - cliff->from.y);
        if (!edge_cliff_is_before(cliff, u, v))
            continue;
        struct vec3 at = rim_before(cliff, u, v, certain);
        bool over = cliff->flank->valid && cliff->beyond.n > 0 &&
                    !has_between(cliff, foot, spacing) && is_level_behind(cliff, foot, spacing);
        if (!is_before_edges(cliff, at, over) || is_over_floor(cliff, u, v))
            continue;
        if (certain)
            *array_push(to) = at; /* its rim: places on the flank end before it */
        edge_wall_add(cliff->work, at, foot, to);
    }
}

/* ---- all of it */

/* From the point to the nearest of its feet, seen from above. */
static double width_of(const struct edge_cliff *cliff)
{
    double least = HUGE_VAL;

    for (size_t k = 0; k < cliff->feet; k++)
        least = fmin(least, edge_plan_distance(cliff->from, cliff->below.item[k]));
    return least;
}

/* Of two points the upper one of an edge, whose flank is the more level, finds it, unless both
 * have flanks that meet anyhow. */
static bool is_owner(const struct edge_work *work, size_t i, size_t k)
{
    const struct edge_flank *own = &work->flank[i], *other = &work->flank[k];
    double level = quadric_normal(&own->q).z - quadric_normal(&other->q).z;

    return !(own->valid && other->valid) && edge_flank_known(other) &&
           (level > 0 || (!(level < 0) && i < k));
}

static void add_edges(const struct edge_cliff *cliff, struct vec3s *edge)
{
    struct sizes across = {0};

    for (size_t k = 0; k < cliff->beyond.n; k++)
        if (is_owner(cliff->work, cliff->i, cliff->beyond.item[k]))
            *array_push(&across) = cliff->beyond.item[k];
    edge_meet_across(cliff->work, cliff->i, &across, edge);
    array_free(&across);
}

double edge_cliff_add(const struct edge_work *work, size_t i, struct vec3s *edge, struct vec3s *to)
{
    const struct edge_flank *flank = &work->flank[i];
    double level = quadric_normal(&flank->q).z, width = 0;
    bool certain = edge_flank_certain(work, flank) || edge_cliff_is_even(work, i);

    if (!(certain || edge_cliff_is_fair(flank)) || level < EDGE_UPRIGHT)
        return 0;
    struct edge_cliff cliff = edge_cliff_find(work, i);
    size_t before = to->n;

    edge_cliff_keep_feet(&cliff, certain);
    if (cliff.feet > 0 && certain && level > FACING)
        add_flank(&cliff, to);
    if (cliff.feet > 0 && certain && level > EDGE_CLIFF_LEVEL && cliff.beyond.n == 0)
        edge_cliff_add_tips(&cliff, to);
    if (cliff.feet > 0)
        add_wall(&cliff, certain, to);
    if (certain)
        add_edges(&cliff, edge);
    if (to->n > before)
        width = width_of(&cliff);
    edge_cliff_free(&cliff);
    return width;
}
