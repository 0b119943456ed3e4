/* feature_wall - the wall between two vertices; see feature_steps.h. */
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "feature_steps.h"
#include "math/plane_fit.h"
#include "math/side_fit.h"
#include "math/ridge_direction.h"

enum { NEAR = 24, FEWEST = 6, TRIMS = 10, TALL = 4, SEEDS = 8, WAYS = 24 };

/* Of more points than these some are as good, to find the level of an end. */
enum { ENOUGH = 600 };

static const double LEAN = 0.26; /* z of a wall's normal, at most: 75 degrees */

/* Rise of an edge by its length, of a wall. */
static const double SLOPE = 0.5;

static const struct vec3 UP = {0, 0, 1};

/* Points of one end, and the sheet through them. */
struct level {
    struct vec3s point;
    struct side_fit sheet;
};

/* Leaves out what is more than two and a half times the rms off the sheet: the last points of a
 * wall. */
static bool fit_trimmed(struct level *l, struct vec3 origin)
{
    if (side_fit_plane(l->point.item, l->point.n, origin, UP, &l->sheet) < 0)
        return false;
    for (int i = 0; i < TRIMS; i++) {
        double most = 2.5 * l->sheet.rms + 1e-6;
        size_t kept = 0;
        for (size_t k = 0; k < l->point.n; k++)
            if (fabs(side_fit_above(&l->sheet, l->point.item[k])) <= most)
                l->point.item[kept++] = l->point.item[k];
        if (kept == l->point.n)
            break;
        l->point.n = kept;
        if (side_fit_plane(l->point.item, kept, origin, UP, &l->sheet) < 0)
            return false;
    }
    return true;
}

/* The points about an end that are nearer to its height than to the other's. */
static bool find_level(const struct feature_cloud *cloud, struct vec3 end, struct vec3 other,
                       double reach, struct level *l)
{
    struct sizes found = {0};

    point_grid_within(cloud->scan, end, reach, &found);
    for (size_t i = 0; i < found.n; i += found.n / ENOUGH + 1) {
        struct vec3 p = cloud->scan->point[found.item[i]];
        if (fabs(p.z - end.z) < fabs(p.z - other.z))
            *array_push(&l->point) = p;
    }
    array_free(&found);
    return fit_trimmed(l, vec_mix(end, other, 0.5));
}

/* What a surface may leave of the points on it, to be one. */
static double allowed_rms(const struct feature_cloud *cloud)
{
    return 2.5 * cloud->noise + 0.15 * cloud->spacing;
}

/* Points on walls, those nearest to a place first. */
struct walled {
    size_t n, index[FEATURE_MOST];
};

static size_t tall_of(size_t most)
{
    return TALL * most < FEATURE_MOST ? TALL * most : FEATURE_MOST;
}

static void find_walled(const struct feature_cloud *cloud, struct vec3 at, size_t most,
                        struct walled *walled)
{
    walled->n =
        cloud->walls ? kdtree_nearest(cloud->walls, at, tall_of(most), walled->index, NULL) : 0;
}

/* Of the points on a wall that are nearest to `at`, lengths upright counting less, those between
 * its top and foot.  `walled` has as many points about that place as these may be of, or more. */
static size_t near_among(const struct feature_cloud *cloud, const struct walled *walled,
                         const struct level level[2], struct vec3 at, size_t most,
                         struct vec3 *near)
{
    size_t n = 0, all = tall_of(most) < walled->n ? tall_of(most) : walled->n;
    struct vec3 found[FEATURE_MOST];
    double step = side_fit_height(&level[0].sheet, at) - side_fit_height(&level[1].sheet, at);

    for (size_t i = 0; i < all; i++) {
        struct vec3 p = cloud->wall[walled->index[i]];
        double part = -side_fit_above(&level[0].sheet, p) / step; /* of the way down from level 0 */
        if (part > 0.02 && part < 0.98 && hypot(p.x - at.x, p.y - at.y) < 6 * cloud->spacing)
            found[n++] = p;
    }
    return n > 0 ? neighbourhood_along(found, n, at, UP, TALL, most, near) : 0;
}

static size_t near_wall(const struct feature_cloud *cloud, const struct level level[2],
                        struct vec3 at, size_t most, struct vec3 *near)
{
    struct walled walled;

    find_walled(cloud, at, most, &walled);
    return near_among(cloud, &walled, level, at, most, near);
}

/* Keeps the points within `most` of the plane, or those that are not, in their order. */
static size_t filter_by_plane(struct vec3 *near, size_t n, const struct plane_fit *plane,
                              double most, bool within)
{
    size_t kept = 0;

    for (size_t i = 0; i < n; i++) {
        double off = fabs(vec_dot(vec_sub(near[i], plane->centre), plane->normal));
        if ((off <= most) == within)
            near[kept++] = near[i];
    }
    return kept;
}

/* The upright plane through one of the points that most of them are on, within `most`. */
static void find_upright_plane(const struct vec3 *near, size_t n, double most,
                               struct plane_fit *plane)
{
    size_t best = 0, step = n / SEEDS + 1;

    for (int k = 0; k < WAYS; k++) {
        struct vec3 normal = vec(cos(k * PI / WAYS), sin(k * PI / WAYS), 0);
        for (size_t i = 0; i < n; i += step) {
            size_t on = 0;
            for (size_t j = 0; j < n; j++)
                on += fabs(vec_dot(vec_sub(near[j], near[i]), normal)) < most;
            if (on <= best)
                continue;
            best = on;
            *plane = (struct plane_fit){.centre = near[i], .normal = normal, .rms = most};
        }
    }
}

/* The plane through most of n points, without those of a wall that meets this one at a corner: it
 * leaves less than `most`. */
static bool fit_plane(const struct vec3 *near, size_t n, double most, struct plane_fit *plane)
{
    const double least = 0.01; /* points may lie on a plane to the last digit */
    struct vec3 some[FEATURE_MOST];
    size_t left = 0;

    if (n < FEWEST)
        return false;
    if (plane_fit(near, n, plane) < 0 || !(plane->rms < most))
        find_upright_plane(near, n, 2 * most, plane);
    for (int i = 0; i < TRIMS; i++) {
        memcpy(some, near, n * sizeof *near);
        double far = fmax(2.5 * fmin(plane->rms, most), least * most);
        size_t kept = filter_by_plane(some, n, plane, far, true);
        if (kept < FEWEST || plane_fit(some, kept, plane) < 0)
            return false;
        if (kept == left)
            break;
        left = kept;
    }
    return 3 * left > n && plane->rms < most && fabs(plane->normal.z) < LEAN;
}

/* The plane of the wall at `at`, none of whose points are on the plane `but` (NULL: any); false:
 * there are too few points of it, or it is no wall.  Where there is noise, as wide a neighbourhood
 * as is a plane but for that. */
static bool plane_of_wall(const struct feature_cloud *cloud, const struct level level[2],
                          struct vec3 at, const struct plane_fit *but, struct plane_fit *plane)
{
    struct vec3 near[FEATURE_MOST];
    bool noisy = cloud->noise > 0.01 * cloud->spacing;
    double tight = 1.3 * cloud->noise + 0.03 * cloud->spacing;
    size_t widest = noisy ? 8 * NEAR : NEAR;
    struct walled walled;

    find_walled(cloud, at, widest, &walled);
    for (size_t most = widest; most >= NEAR; most /= 2) {
        size_t n = near_among(cloud, &walled, level, at, most, near);
        if (but)
            n = filter_by_plane(near, n, but, allowed_rms(cloud), false);
        /* what is rough, or rounded, last */
        if (fit_plane(near, n, most > NEAR ? 1.1 * cloud->noise : tight, plane) ||
            (most == NEAR && fit_plane(near, n, allowed_rms(cloud), plane)))
            return true;
    }
    return false;
}

/* The sheet of level s where the way from a to b comes to the wall, up to `over` beyond its ends.
 */
static bool meet_wall(const struct level *level, const struct plane_fit *plane, struct vec3 a,
                      struct vec3 b, struct vec3 *at)
{
    const double over = 0.25;
    struct vec3 p = side_fit_point(&level->sheet, a), q = side_fit_point(&level->sheet, b);
    double from = vec_dot(vec_sub(p, plane->centre), plane->normal);
    double to = vec_dot(vec_sub(q, plane->centre), plane->normal);

    if (!(fabs(to - from) > 0))
        return false;
    double s = from / (from - to);
    *at = side_fit_point(&level->sheet, vec_mix(a, b, s));
    return s > -over && s < 1 + over;
}

/* One wall between a and b, as in plane_of_wall. */
static bool trace_wall(const struct feature_cloud *cloud, const struct level level[2],
                       struct vec3 a, struct vec3 b, const struct plane_fit *but, struct feature *f,
                       struct plane_fit *plane)
{
    struct vec3 at = vec_mix(a, b, 0.5);

    for (int i = 0; i < 2; i++) {
        struct plane_fit found;
        if (!plane_of_wall(cloud, level, at, but, &found))
            return i > 0;
        *plane = found;
        if (!meet_wall(&level[0], plane, a, b, &f->place[0]) ||
            !meet_wall(&level[1], plane, a, b, &f->place[1]))
            return false;
        f->wall = plane->normal;
        at = vec_mix(f->place[0], f->place[1], 0.5);
    }
    return true;
}

/* How far the points of a wall are from where it was found, seen from above. */
static double unsupported_distance(const struct feature_cloud *cloud, const struct level level[2],
                                   const struct feature *f, const struct plane_fit *plane)
{
    struct vec3 near[2 * NEAR], at = vec_mix(f->place[0], f->place[1], 0.5);
    double least = INFINITY;
    size_t n = near_wall(cloud, level, at, 2 * NEAR, near);

    n = filter_by_plane(near, n, plane, allowed_rms(cloud), true);
    for (size_t i = 0; i < n; i++)
        least = fmin(least, hypot(near[i].x - at.x, near[i].y - at.y));
    return least;
}

/* Is the material within both walls, not within either: are the points of the one beyond the
 * other?  `out`: out of that other one. */
static bool juts_out(const struct feature_cloud *cloud, const struct level level[2], struct vec3 at,
                     const struct plane_fit *one, const struct plane_fit *other, struct vec3 out)
{
    struct vec3 near[4 * NEAR], sum = {0, 0, 0};
    size_t n = near_wall(cloud, level, at, 4 * NEAR, near);

    n = filter_by_plane(near, n, one, allowed_rms(cloud), true);
    for (size_t i = 0; i < n; i++)
        sum = vec_add(sum, vec_sub(near[i], other->centre));
    return vec_dot(sum, out) < 0;
}

/* Near a corner the way from a to b crosses the planes of two walls: of one that juts out it meets
 * the first one coming from above, else the last. */
static bool find_wall(const struct feature_cloud *cloud, const struct level level[2], struct vec3 a,
                      struct vec3 b, struct feature *f)
{
    const double near = 1, far = 1.5; /* mean spacings */
    const double same = 0.94;         /* cosine between two walls */
    struct feature other = *f;
    struct plane_fit plane, second;
    bool found = trace_wall(cloud, level, a, b, NULL, f, &plane);
    double off = found ? unsupported_distance(cloud, level, f, &plane) : INFINITY;

    if (found && trace_wall(cloud, level, a, b, &plane, &other, &second) &&
        fabs(vec_dot(plane.normal, second.normal)) < same) {
        double other_off = unsupported_distance(cloud, level, &other, &second);
        struct vec3 top = a.z > b.z ? a : b, down = vec_sub(a.z > b.z ? b : a, top);
        struct vec3 out =
            vec_dot(second.normal, down) < 0 ? vec_scale(-1, second.normal) : second.normal;
        bool later = vec_dot(vec_sub(other.place[0], f->place[0]), vec(down.x, down.y, 0)) > 0;
        bool both = off < near * cloud->spacing && other_off < near * cloud->spacing;
        bool juts = both && juts_out(cloud, level, other.place[0], &plane, &second, out);
        if (both ? later != juts : other_off < off) {
            *f = other;
            off = other_off;
        }
    }
    return off < far * cloud->spacing;
}

/* How far about the ends of an edge a level is looked at. */
static double reach_of(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b)
{
    return 1.2 * hypot(b.x - a.x, b.y - a.y) + 2.5 * cloud->spacing;
}

/* The levels at both ends, each no rougher than a surface is. */
static bool find_levels(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b,
                        struct level level[2])
{
    double reach = reach_of(cloud, a, b);

    return find_level(cloud, a, b, reach, &level[0]) && level[0].sheet.rms < allowed_rms(cloud) &&
           find_level(cloud, b, a, reach, &level[1]) && level[1].sheet.rms < allowed_rms(cloud);
}

/* The step is what it was taken for: much higher than the noise, and no slope that goes on beyond
 * it. */
static bool is_step(const struct feature *f, struct vec3 a, struct vec3 b,
                    const struct feature_cloud *cloud)
{
    double step = fabs(f->place[0].z - f->place[1].z), rise = fabs(a.z - b.z);

    return (f->place[0].z > f->place[1].z) == (a.z > b.z) && step > 0.5 * rise &&
           step > fmax(6 * cloud->noise, cloud->spacing);
}

bool feature_steep(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b)
{
    double length = hypot(a.x - b.x, a.y - b.y), distance2;
    size_t nearest;

    return fabs(a.z - b.z) > SLOPE * length && cloud->walls &&
           kdtree_nearest(cloud->walls, vec_mix(a, b, 0.5), 1, &nearest, &distance2) == 1 &&
           4 * distance2 < vec_dot(vec_sub(a, b), vec_sub(a, b));
}

struct feature feature_wall(const struct feature_cloud *cloud, struct vec3 a, struct vec3 b)
{
    struct feature f = {.kind = FEATURE_NONE};
    struct level level[2] = {{.point = {0}}, {.point = {0}}};

    if (find_levels(cloud, a, b, level) && find_wall(cloud, level, a, b, &f) &&
        is_step(&f, a, b, cloud)) {
        struct vec3 down = a.z > b.z ? vec_sub(b, a) : vec_sub(a, b);
        down.z = 0;
        f.kind = FEATURE_WALL;
        f.wall = vec_dot(f.wall, down) < 0 ? vec_scale(-1, f.wall) : f.wall;
        f.wall.z = fmax(f.wall.z, 0); /* nothing is seen of an overhang from above */
        f.wall = vec_unit(f.wall);
        f.known = reach_of(cloud, a, b);
        f.along = vec_unit(vec_cross(UP, f.wall));
        for (int s = 0; s < 2; s++) {
            f.normal[s] = side_fit_normal(&level[s].sheet, f.place[s]);
            f.end[s] = side_fit_normal(&level[s].sheet, s == 0 ? a : b);
            f.foot[s] = side_fit_point(&level[s].sheet, s == 0 ? a : b);
        }
    }
    array_free(&level[0].point);
    array_free(&level[1].point);
    return f;
}
