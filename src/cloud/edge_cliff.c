/* edge_cliff - see edge_steps.h. */
#include "edge_steps.h"

#include <stdlib.h>

#include "math/triangles.h"
#include "plan_star.h"

/* A point so far below a flank, by its distance, is down a wall; where the other side is known,
 * too, and lies as far below: down a step. */
static const double WALL = 0.9, STEP = 0.1;
static const double THROWN = 8;    /* noises: a point of many is off by less */
static const double CORNER = 1.5;  /* spacings */
static const double LEVEL = 0.35;  /* least z of a flank that has corners */
static const double FACING = 0.12; /* least z of a flank that is continued over its wall */
static const double FAIR = 0.1;    /* spacings: so far off its points a flank tells of a wall yet */
static const double STEEP_STEP = 0.35; /* of the way: so high over it no surface is the same */
static const double EVEN_SINKS =
    2.5;                           /* sinkings of the ball: a flank that is even is off by less */
static const double MANY_OFF = 25; /* times as high as a flank is off its points: a step */
static const double SURELY_OFF = 100; /* and one where little about is known, too */
static const double FARTHER = 4;      /* spacings: farther than that a flank is a plane */

/* Seen from above the flank is open about a point of a corner by more: its sides make less than 75
 * degrees.  Before blunter ones a ball is held off by the walls of both sides. */
static const double CORNER_OPEN = RADIANS(285);
enum { CORNER_FEWEST = 2 };

/* Of places about a point: up to these below, which may be far off against the ball's path. */
enum { RINGS = 3 * EDGE_RINGS };

/* What is seen from above about a point of a flank: points of the flank, those so steeply below it
 * that a wall is between, and points whose flank meets it in a known edge. */
struct cliff {
    struct vec3 from;
    double reach;  /* so far the flank may go on, seen from above, mm */
    double corner; /* and so far between points below */
    const struct quadric *q;
    bool flanked; /* it is not the surface of all about */
    struct vec3s on, below;
    size_t feet;        /* of those below, the first: a wall may stand on them */
    struct vec3s under; /* all that are not on it but under it */
    struct sizes beyond;
};

/* On the plane through `from` with that normal, over (x, y). */
static struct vec3 plane_above(struct vec3 from, struct vec3 n, double x, double y)
{
    return vec(x, y, from.z - (n.x * (x - from.x) + n.y * (y - from.y)) / n.z);
}

/* A normal, or one no steeper than EDGE_STEEP. */
static struct vec3 roof_normal(struct vec3 n)
{
    n.z = fmax(n.z, hypot(n.x, n.y) / EDGE_STEEP);
    return vec_unit(n);
}

/* A place of the flank over (x, y): on a plane where by its bends it would be anywhere. */
static struct vec3 place_above(const struct cliff *cliff, double x, double y)
{
    struct vec3 n = quadric_normal_at(cliff->q, cliff->from);
    struct vec3 p = quadric_nearest(cliff->q, plane_above(cliff->from, n, x, y));

    return edge_plan_distance(p, cliff->from) <= cliff->reach
               ? p
               : plane_above(cliff->from, roof_normal(n), x, y);
}

/* The place is as near to the point as a flank that is nearly upright may go on. */
static bool is_place(const struct cliff *cliff, struct vec3 at)
{
    const double far = 3; /* times the reach */

    return vec_distance(at, cliff->from) <= far * cliff->reach;
}

/* So far off the flank of point i a point k is on it. */
static double least_off(const struct edge_work *work, size_t i, size_t k)
{
    return edge_within(work, fmax(work->flank[i].spacing, work->flank[k].spacing));
}

/* How far a point is above the flank of the point `own`: no bend of it goes on far. */
static double above_flank(const struct edge_flank *flank, struct vec3 own, struct vec3 p)
{
    struct vec3 normal;

    if (vec_distance(p, own) <= FARTHER * flank->spacing)
        return edge_flank_above(flank, p, &normal);
    return vec_dot(quadric_normal_at(&flank->q, own), vec_sub(p, own));
}

/* The same of one that walls hang from: far off it is no steeper than EDGE_STEEP. */
static double above_roof(const struct edge_flank *flank, struct vec3 own, struct vec3 p)
{
    struct vec3 n = quadric_normal_at(&flank->q, own);

    if (vec_distance(p, own) <= FARTHER * flank->spacing)
        return above_flank(flank, own, p);
    return vec_dot(roof_normal(n), vec_sub(p, own));
}

/* Its points are near enough to a flank for a wall to hang from it, though not for a rim. */
static bool is_fair(const struct edge_flank *flank)
{
    return edge_flank_known(flank) && flank->rms <= FAIR * flank->spacing;
}

/* A flank that is only even, where most about are certain: its points are off it by no more than a
 * part of what a place may be. */
static bool is_even(const struct edge_work *work, size_t i)
{
    const struct edge_flank *flank = &work->flank[i];

    return edge_flank_known(flank) && flank->rms <= EVEN_SINKS * work->options->sink &&
           flank->rms <= EDGE_EVEN * flank->spacing && edge_on_known(work, i);
}

/* A step so high is none that the surface of a flank, however far off its points, may take. */
static bool is_high(const struct edge_work *work, size_t k, double step)
{
    const struct edge_flank *flank = &work->flank[k];

    return is_fair(flank) && step > MANY_OFF * flank->rms &&
           (step > SURELY_OFF * flank->rms || edge_on_known(work, k));
}

/* A wall stands on the flank of point k, so far from the rim, which is so high over it and it over
 * the rim's: one that is only fair may, nearer, be the same surface, unless it is even, or is off
 * its points by a small part of the step, and the step so steep that it is none. */
static bool is_sure(const struct edge_work *work, size_t k, double far, double step)
{
    const struct edge_flank *flank = &work->flank[k];

    return edge_flank_certain(work, flank) ||
           (far > EDGE_FOOT * flank->spacing && is_fair(flank)) ||
           (step > STEEP_STEP * far && (is_even(work, k) || is_high(work, k, step)));
}

/* Points below the flank whose own surface the point is not above are beyond an edge. */
static void sort_by_height(const struct edge_work *work, size_t i, size_t k, struct cliff *cliff)
{
    const struct edge_flank *own = &work->flank[i], *other = &work->flank[k];
    const struct vec3 p = work->options->point_grid->point[k];
    double off = above_roof(own, cliff->from, p), least = least_off(work, i, k);

    if (fabs(off) <= least) {
        *array_push(&cliff->on) = p;
        return;
    }
    if (!(off < 0))
        return;
    *array_push(&cliff->under) = p;
    double far = vec_distance(p, cliff->from);
    double down = edge_flank_known(other) ? above_flank(other, p, cliff->from) : 0;
    if (edge_flank_known(other) && down <= least)
        *array_push(&cliff->beyond) = k;
    else if (off < -WALL * far ||
             (off < -STEP * far && down > STEP * far && is_sure(work, k, far, fmin(-off, down))))
        *array_push(&cliff->below) = p;
}

static bool may_be_off(const struct edge_work *work, size_t i)
{
    const struct vec3 *point = work->options->point_grid->point;
    struct edge_about about = edge_about(work, i);

    for (size_t k; edge_about_next(&about, &k);)
        if (!quadric_surely_within(&work->flank[i].q, point[k], least_off(work, i, k)))
            return true;
    return false;
}

/* One point alone is down a wall, and no further than noise throws one of many. */
static bool is_stray(const struct edge_work *work, size_t i, const struct cliff *cliff)
{
    return cliff->below.n == 1 && -above_roof(&work->flank[i], cliff->from, cliff->below.item[0]) <
                                      THROWN * work->options->noise;
}

/* What is under the flank is as far below it wherever it is, as no slope is: its points, though too
 * few to tell of a surface, are those of a floor, and a step is before these. */
static void find_floor(const struct edge_work *work, size_t i, struct cliff *cliff)
{
    enum { FEWEST = 3 };
    const double level = 0.25; /* of what a slope's heights differ by */
    double high = 0, low = HUGE_VAL, near = HUGE_VAL, far = 0;
    size_t sure = cliff->below.n, next = 0; /* of those under it, in their order */

    for (size_t k = 0; k < cliff->under.n; k++) {
        double drop = -above_roof(&work->flank[i], cliff->from, cliff->under.item[k]);
        double way = vec_distance(cliff->under.item[k], cliff->from);
        high = fmax(high, drop);
        low = fmin(low, drop);
        near = fmin(near, way);
        far = fmax(far, way);
    }
    if (cliff->under.n < FEWEST || (high - low) * far > level * high * (far - near))
        return;
    for (size_t k = 0; k < cliff->under.n; k++) {
        struct vec3 p = cliff->under.item[k];
        if (next < sure && vec_distance(p, cliff->below.item[next]) <= 0)
            next++;
        else if (low > STEEP_STEP * vec_distance(p, cliff->from))
            *array_push(&cliff->below) = p;
    }
}

/* Nothing where all points about are on the flank. */
static struct cliff find_cliff(const struct edge_work *work, size_t i)
{
    struct edge_about about = edge_about(work, i);
    struct cliff cliff = {.from = about.from,
                          .reach = about.reach,
                          .corner = CORNER * point_grid_spacing(work->options->point_grid),
                          .q = &work->flank[i].q,
                          .flanked = work->flank[i].valid};

    if (may_be_off(work, i))
        for (size_t k; edge_about_next(&about, &k);)
            sort_by_height(work, i, k, &cliff);
    if (cliff.beyond.n == 0)
        find_floor(work, i, &cliff);
    if (is_stray(work, i, &cliff))
        cliff.below.n = 0;
    cliff.feet = cliff.below.n;
    return cliff;
}

static void free_cliff(struct cliff *cliff)
{
    array_free(&cliff->on);
    array_free(&cliff->below);
    array_free(&cliff->under);
    array_free(&cliff->beyond);
}

/* No wall stands on points where the scan goes on as steeply as to them, nor, of a flank of few
 * points or one that is not certain, on those to which it goes down without one: these go last. */
static void keep_feet(const struct edge_work *work, bool certain, struct cliff *cliff)
{
    const struct point_grid *scan = work->options->point_grid;
    bool doubtful = !certain || cliff->on.n < EDGE_FEWEST;
    struct vec3 *below = cliff->below.item;

    cliff->feet = 0;
    for (size_t k = 0; k < cliff->below.n; k++) {
        struct vec3 foot = below[k];
        double top = place_above(cliff, foot.x, foot.y).z;
        if (doubtful && (certain ? edge_slope_climbs : edge_slope_seen)(scan, foot, top))
            continue;
        if (edge_slope_goes_on(scan, foot, vec(cliff->from.x, cliff->from.y, top)))
            continue;
        below[k] = below[cliff->feet];
        below[cliff->feet++] = foot;
    }
}

/* No other point of the flank is nearer to the place. */
static bool is_own(const struct cliff *cliff, double u, double v)
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
static bool is_before_feet(const struct cliff *cliff, double u, double v)
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

static bool is_before_wall(const struct cliff *cliff, double u, double v)
{
    return is_own(cliff, u, v) && is_before_feet(cliff, u, v);
}

/* A point under the flank is on the way to the place, seen from above: no wall stands up to
 * there. */
static bool has_between(const struct cliff *cliff, struct vec3 at, double beside)
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
static double drop_of(const struct cliff *cliff, struct vec3 p)
{
    return place_above(cliff, p.x, p.y).z - p.z;
}

/* What is behind a foot is not much lower: it is no place of a slope. */
static bool is_level_behind(const struct cliff *cliff, struct vec3 foot, double spacing)
{
    const double behind = 2.2, beside = 0.6, lower = 1.3; /* spacings; times as low as the foot */
    double u = foot.x - cliff->from.x, v = foot.y - cliff->from.y, way = hypot(u, v);
    double low = drop_of(cliff, foot);

    for (size_t k = 0; k < cliff->under.n; k++) {
        double x = cliff->under.item[k].x - foot.x, y = cliff->under.item[k].y - foot.y;
        double ahead = (u * x + v * y) / way, aside = fabs(u * y - v * x) / way;
        if (ahead > 0.3 * spacing && ahead < behind * spacing && aside < beside * spacing &&
            drop_of(cliff, cliff->under.item[k]) > lower * low)
            return false;
    }
    return true;
}

/* The place is no further than the edges that are known.  A cubic through all about a point, that
 * goes through the upper side's points, too, where these have a flank of their own, goes over the
 * wall as if it were none: if `over`, it is no edge. */
static bool is_before_edges(const struct edge_work *work, const struct cliff *cliff, struct vec3 at,
                            bool over)
{
    for (size_t k = 0; k < cliff->beyond.n; k++) {
        const struct edge_flank *other = &work->flank[cliff->beyond.item[k]];
        struct vec3 own = work->options->point_grid->point[cliff->beyond.item[k]];
        if (over && other->bent && !other->valid)
            continue;
        if (above_flank(other, own, at) > edge_within(work, other->spacing))
            return false;
    }
    return true;
}

/* Of these points, seen from above, as turned from a way at a place: between -PI and PI. */
static double turned(struct vec3 p, struct vec3 at, double x, double y)
{
    double u = p.x - at.x, v = p.y - at.y;

    return atan2(x * v - y * u, x * u + y * v);
}

/* No point below is in the quarter of the plane that begins at this turn. */
static bool is_free(const struct cliff *cliff, struct vec3 at, double x, double y, double begin)
{
    const double slack = 1e-9;

    for (size_t k = 0; k < cliff->below.n; k++) {
        double t = turned(cliff->below.item[k], at, x, y) - begin;
        t += t < 0 ? 2 * PI : 0;
        if (t > slack && t < PI / 2 - slack)
            return false;
    }
    return true;
}

/* The upper points may be those of a square corner whose tip is over the place: there is one that
 * holds all of them, and none of those below. */
static bool is_corner_tip(const struct cliff *cliff, struct vec3 at)
{
    double x = cliff->from.x - at.x, y = cliff->from.y - at.y, low = 0, high = 0;

    for (size_t k = 0; k < cliff->on.n; k++) {
        x += cliff->on.item[k].x - at.x;
        y += cliff->on.item[k].y - at.y;
    }
    for (size_t k = 0; k <= cliff->on.n; k++) {
        double t = turned(k < cliff->on.n ? cliff->on.item[k] : cliff->from, at, x, y);
        low = k == 0 ? t : fmin(low, t);
        high = k == 0 ? t : fmax(high, t);
    }
    if (!(high - low < PI / 2))
        return false;
    if (is_free(cliff, at, x, y, low) || is_free(cliff, at, x, y, high - PI / 2))
        return true;
    for (size_t k = 0; k < cliff->below.n; k++) {
        double t = turned(cliff->below.item[k], at, x, y);
        t -= t > 0 ? PI / 2 : 0; /* as the end of the quarter, or as its begin */
        if (t > high - PI / 2 && t < low && is_free(cliff, at, x, y, t))
            return true;
    }
    return false;
}

static struct vec3 nearest_below(const struct cliff *cliff, struct vec3 at)
{
    struct vec3 foot = cliff->below.item[0];

    for (size_t k = 1; k < cliff->below.n; k++)
        if (edge_plan_distance(cliff->below.item[k], at) < edge_plan_distance(foot, at))
            foot = cliff->below.item[k];
    return foot;
}

/* Points below are straight under the flank's: the wall was seen here, and is not farther on. */
static bool is_wall_seen(const struct cliff *cliff, double spacing)
{
    enum { FEWEST = 3 }; /* fewer may be of a floor */
    const double beside = 0.3;
    int under = 0;

    for (size_t k = 0; k < cliff->below.n; k++)
        under += edge_plan_distance(cliff->below.item[k], cliff->from) < beside * spacing;
    return under >= FEWEST;
}

/* Seen from above the place is amid three points that are under the flank: no wall stands there,
 * but farther back. */
static bool is_over_floor(const struct edge_work *work, size_t i, const struct cliff *cliff,
                          double u, double v)
{
    const struct point_grid *scan = work->options->point_grid;
    size_t corner[3];

    if (!plan_star_over(scan, vec(cliff->from.x + u, cliff->from.y + v, 0),
                        EDGE_REACH * point_grid_spacing(scan), corner))
        return false;
    for (int k = 0; k < 3; k++)
        if (!(above_roof(&work->flank[i], cliff->from, scan->point[corner[k]]) <
              -least_off(work, i, corner[k])))
            return false;
    return true;
}

/* The places of triangles about a point, whether they are before the wall, as far as it is known:
 * each is asked of again from those beside it. */
struct before {
    double pitch; /* mm */
    int rings;
    signed char is[2 * RINGS + 3][2 * RINGS + 3]; /* 0: nobody has asked yet */
};

static bool is_before(const struct edge_work *work, size_t i, const struct cliff *cliff,
                      struct before *before, int j, int k)
{
    signed char *is = &before->is[before->rings + 1 + j][before->rings + 1 + k];

    if (*is == 0) {
        double u, v;
        triangles_at(before->pitch, k, j, &u, &v);
        *is = is_before_feet(cliff, u, v) && !is_over_floor(work, i, cliff, u, v) ? 1 : -1;
    }
    return *is > 0;
}

/* A place beside it is not before the wall: from here it may go down. */
static bool is_last(const struct edge_work *work, size_t i, const struct cliff *cliff,
                    struct before *before, int j, int k)
{
    static const int beside[6][2] = {{0, 1}, {0, -1}, {1, 0}, {-1, 0}, {1, -1}, {-1, 1}};

    for (int b = 0; b < 6; b++)
        if (!is_before(work, i, cliff, before, j + beside[b][0], k + beside[b][1]))
            return true;
    return false;
}

/* The flank of point i goes on up to the points below: where the wall between is nobody knows. */
static void fill_cliff(const struct edge_work *work, size_t i, const struct cliff *cliff,
                       struct vec3s *to)
{
    const double dense = 0.65;
    struct before before = {.pitch = dense * work->options->along};
    int rings = (int)fmin(triangles_rings(cliff->reach, before.pitch), RINGS);
    bool hangs = !is_wall_seen(cliff, point_grid_spacing(work->options->point_grid));

    before.rings = rings;
    for (int j = -rings; j <= rings; j++)
        for (int k = -rings; k <= rings; k++) {
            double u, v;
            triangles_at(before.pitch, k, j, &u, &v);
            if (hypot_compare(u, v, cliff->reach) > 0 || !is_own(cliff, u, v) ||
                !is_before(work, i, cliff, &before, j, k))
                continue;
            struct vec3 at = place_above(cliff, cliff->from.x + u, cliff->from.y + v);
            if (!is_place(cliff, at) || !is_before_edges(work, cliff, at, false))
                continue;
            *array_push(to) = at;
            if (hangs && is_last(work, i, cliff, &before, j, k))
                edge_wall_add(work, at, nearest_below(cliff, at), to);
        }
}

/* Points below are ahead on both sides of the way to the place, as at no border of the scan. */
static bool is_amid(const struct cliff *cliff, double u, double v)
{
    bool left = false, right = false;

    for (size_t k = 0; k < cliff->below.n; k++) {
        double x = cliff->below.item[k].x - cliff->from.x;
        double y = cliff->below.item[k].y - cliff->from.y, aside = u * y - v * x;
        if (u * x + v * y > 0) {
            left = left || aside > 0;
            right = right || aside < 0;
        }
    }
    return left && right;
}

/* The wall of a corner whose tip may be over a place. */
static bool add_tip(const struct edge_work *work, const struct cliff *cliff, double u, double v,
                    struct vec3s *to)
{
    if (hypot_compare(u, v, cliff->reach) > 0 || !is_before_wall(cliff, u, v) ||
        !is_amid(cliff, u, v))
        return false;
    struct vec3 at = place_above(cliff, cliff->from.x + u, cliff->from.y + v);
    if (!is_place(cliff, at) || !is_corner_tip(cliff, at))
        return false;
    *array_push(to) = at;
    edge_wall_add(work, at, nearest_below(cliff, at), to);
    return true;
}

/* Corners of the flank stand out between points below, with their walls: places of tips, and closer
 * about these. */
static void fill_tips(const struct edge_work *work, const struct cliff *cliff, struct vec3s *to)
{
    enum { CLOSER = 3 };
    const double dense = 0.65;
    double pitch = dense * work->options->along, close = pitch / CLOSER;
    int rings = (int)fmin(triangles_rings(cliff->reach, pitch), RINGS);

    for (int j = -rings; j <= rings; j++)
        for (int k = -rings; k <= rings; k++) {
            double u, v;
            triangles_at(pitch, k, j, &u, &v);
            if (!add_tip(work, cliff, u, v, to))
                continue;
            for (int a = -1; a <= 1; a++)
                for (int b = -1; b <= 1; b++) {
                    double x, y;
                    triangles_at(close, b, a, &x, &y);
                    if (a != 0 || b != 0)
                        add_tip(work, cliff, u + x, v + y, to);
                }
        }
}

/* The wall itself may go down from there to a point below, without points that were seen. */
static void fill_wall(const struct edge_work *work, size_t i, const struct cliff *cliff,
                      bool certain, struct vec3s *to)
{
    const double nearly = 0.97, spacing = point_grid_spacing(work->options->point_grid);
    bool steep = quadric_normal_at(cliff->q, cliff->from).z < FACING;

    for (size_t k = 0; k < cliff->feet; k++) {
        struct vec3 foot = cliff->below.item[k];
        double u = nearly * (foot.x - cliff->from.x), v = nearly * (foot.y - cliff->from.y);
        if (!is_before_wall(cliff, u, v))
            continue;
        struct vec3 at = place_above(cliff, cliff->from.x + u, cliff->from.y + v);
        double way = hypot(u, v), top = steep ? fmax(at.z, cliff->from.z - EDGE_STEEP * way) : at.z;
        at = vec(cliff->from.x + u, cliff->from.y + v,
                 fmin(top, cliff->from.z + (certain ? way : 0)));
        bool over = cliff->flanked && cliff->beyond.n > 0 && !has_between(cliff, foot, spacing) &&
                    is_level_behind(cliff, foot, spacing);
        if (!is_before_edges(work, cliff, at, over) || is_over_floor(work, i, cliff, u, v))
            continue;
        if (certain)
            *array_push(to) = at; /* its rim: places on the flank end before it */
        edge_wall_add(work, at, foot, to);
    }
}

/* From the point to the nearest of those below, seen from above. */
static double width_of(const struct cliff *cliff)
{
    double least = HUGE_VAL;

    for (size_t k = 0; k < cliff->feet; k++)
        least = fmin(least, hypot(cliff->below.item[k].x - cliff->from.x,
                                  cliff->below.item[k].y - cliff->from.y));
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

static void add_edges(const struct edge_work *work, size_t i, const struct cliff *cliff,
                      struct vec3s *edge)
{
    struct sizes across = {0};

    for (size_t k = 0; k < cliff->beyond.n; k++)
        if (is_owner(work, i, cliff->beyond.item[k]))
            *array_push(&across) = cliff->beyond.item[k];
    edge_meet_across(work, i, &across, edge);
    array_free(&across);
}

double edge_cliff_add(const struct edge_work *work, size_t i, struct vec3s *edge, struct vec3s *to)
{
    const struct edge_flank *flank = &work->flank[i];
    bool certain = edge_flank_certain(work, flank) || is_even(work, i);

    if (!(certain || is_fair(flank)) || quadric_normal(&flank->q).z < EDGE_UPRIGHT)
        return 0;
    struct cliff cliff = find_cliff(work, i);
    size_t before = to->n;
    double width = 0;

    keep_feet(work, certain, &cliff);
    if (cliff.feet > 0 && certain && quadric_normal(&flank->q).z > FACING)
        fill_cliff(work, i, &cliff, to);
    if (cliff.feet > 0 && cliff.beyond.n == 0 && certain && quadric_normal(&flank->q).z > LEVEL) {
        struct cliff wider = cliff;
        wider.corner = EDGE_REACH * point_grid_spacing(work->options->point_grid);
        fill_tips(work, &wider, to);
    }
    if (cliff.feet > 0)
        fill_wall(work, i, &cliff, certain, to);
    if (certain)
        add_edges(work, i, &cliff, edge);
    if (to->n > before)
        width = width_of(&cliff);
    free_cliff(&cliff);
    return width;
}

/* ---- corners */

static int compare_angles(const void *pa, const void *pb)
{
    double a = *(const double *)pa, b = *(const double *)pb;

    return (a > b) - (a < b);
}

/* The widest angle about the point, seen from above, without points of its flank; *amid: its
 * middle. */
static double open_angle(const struct cliff *cliff, double *amid)
{
    size_t n = cliff->on.n;
    double *turn = mem_alloc(n + 1, sizeof *turn), widest = 0;

    for (size_t k = 0; k < n; k++)
        turn[k] = atan2(cliff->on.item[k].y - cliff->from.y, cliff->on.item[k].x - cliff->from.x);
    qsort(turn, n, sizeof *turn, compare_angles);
    turn[n] = n > 0 ? turn[0] + 2 * PI : 0;
    for (size_t k = 0; k < n; k++)
        if (turn[k + 1] - turn[k] > widest) {
            widest = turn[k + 1] - turn[k];
            *amid = turn[k] + widest / 2;
        }
    free(turn);
    return widest;
}

/* To the nearest point down a wall there; 0: it is no wall. */
static double room_ahead(const struct cliff *cliff, double turn)
{
    const double beside = 0.7;
    double x = cos(turn), y = sin(turn), least = HUGE_VAL;

    for (size_t k = 0; k < cliff->below.n; k++) {
        struct vec3 to = vec_sub(cliff->below.item[k], cliff->from);
        double far = hypot(to.x, to.y);
        if (to.x * x + to.y * y > beside * far && -to.z > far)
            least = fmin(least, far);
    }
    return least < HUGE_VAL ? least : 0;
}

double edge_cliff_corner(const struct edge_work *work, size_t i, struct vec3 *ahead)
{
    const struct edge_flank *flank = &work->flank[i];

    if (!edge_flank_certain(work, flank) || quadric_normal(&flank->q).z <= LEVEL)
        return 0;
    struct cliff cliff = find_cliff(work, i);
    double amid = 0, open = open_angle(&cliff, &amid);
    double depth = cliff.on.n >= CORNER_FEWEST && open > CORNER_OPEN ? room_ahead(&cliff, amid) : 0;
    double x = cos(amid), y = sin(amid), up = 0;

    if (depth > 0)
        up = place_above(&cliff, cliff.from.x + depth * x, cliff.from.y + depth * y).z -
             cliff.from.z;
    *ahead = vec(x, y, depth > 0 ? up / depth : 0);
    free_cliff(&cliff);
    return depth;
}
