/* outliers_kept - see outliers_kept.h. */
#include "outliers_kept.h"

#include <stdlib.h>

#include "base/array.h"
#include "cloud/edge_points.h"
#include "math/quadric.h"

/* Points that are looked at about one; of those seen from above at most. */
enum { NEAR = OUTLIERS_NEAR, MOST = 512 };

/* Points that make a feature, or a row, together; what out[] says while these are looked for. */
enum { FEATURE = OUTLIERS_FEATURE, ROW = OUTLIERS_ROW, MARKED = 1, GROUPED, DONE };

/* Seen from above, where a surface ends there is so wide an angle without points: 135 degrees. */
static const double RIM = 0.75 * PI;

/* In spacings: points of a row follow each other no nearer and no farther. */
static const double NEXT = 1.2, FURTHEST = 3;

/* In spacings: points so near seen from above are looked at; of that, so far from a place at a rim
 * their middle is (0.42 where the rim is straight), and half a spacing may the wall be undercut. */
static const double SEEN = 2.5, LOPSIDED = 0.25, UNDERCUT = 0.5;

/* In spacings: points so far about each other that stand as high are of one thin feature, and are
 * not all so near. */
static const double FEATURE_WITHIN = 6, FEATURE_LONG = 3;

/* Of their height over what is about them: thin features are as high to this; points of one stand
 * over it by so much. */
static const double LEVEL = 0.2, STANDS = 0.6;

/* In spacings: members of a group are so near to the next, and one to a point not marked. */
static const double REACH = 1.5, ATTACHED = 2.5;

/* A feature that the marked points make: those near each other. */
struct group {
    struct sizes member;
    size_t kept;   /* points near a member that were marked and are kept */
    bool attached; /* to points that are not marked */
};

bool outliers_hood_find(const struct point_grid *b, size_t i, struct outliers_hood *hood)
{
    uint32_t index[NEAR + 1];
    size_t n = 0;

    if (point_grid_nearest(b, b->point[i], NEAR + 1, index, hood->distance2) < NEAR + 1)
        return false;
    for (size_t k = 0; k <= NEAR && n < NEAR; k++)
        if (index[k] != i) {
            hood->index[n] = index[k];
            hood->point[n++] = b->point[index[k]];
        }
    hood->spacing = sqrt(PI * hood->distance2[NEAR] / NEAR);
    return true;
}

double outliers_least(const struct outliers_hood *hood, double sigma)
{
    return fmax(OUTLIERS_SIGMAS * sigma, OUTLIERS_BELOW * hood->spacing);
}

/* One quadric takes in point i and its neighbours, far apart as they may be: a smooth wall that was
 * seen at a few places. */
static bool is_on_one_surface(const struct point_grid *b, double sigma, size_t i)
{
    struct vec3 p = b->point[i];
    struct outliers_hood hood;
    struct quadric q;
    double off[NEAR];

    if (!outliers_hood_find(b, i, &hood))
        return false;
    double least = outliers_least(&hood, sigma);
    struct vec3 across = plane_normal(hood.point, NEAR);
    if (quadric_fit(hood.point, NEAR, p, across, &q) < 0 ||
        quadric_settle(hood.point, NEAR, p, across, &q) < 0 || quadric_distance(&q) > least)
        return false;
    quadric_off_all(&q, hood.point, NEAR, off);
    for (size_t k = 0; k < NEAR; k++)
        if (fabs(off[k]) > least)
            return false;
    return true;
}

/* The points about point i: those marked and near go to the group, and are unmarked; others attach
 * the group. */
static void spread_group(const struct point_grid *b, const bool *kept, size_t i, unsigned char *out,
                         struct group *group)
{
    const double near = REACH * point_grid_spacing(b), far = ATTACHED * point_grid_spacing(b);
    uint32_t index[NEAR];
    double distance2[NEAR];
    size_t n = point_grid_nearest(b, b->point[i], NEAR, index, distance2);

    for (size_t k = 0; k < n && distance2[k] <= far * far; k++) {
        if (index[k] == i)
            continue;
        if (out[index[k]] == MARKED && distance2[k] <= near * near) {
            out[index[k]] = GROUPED;
            *array_push(&group->member) = index[k];
        } else if (!out[index[k]]) {
            group->attached = true;
            group->kept += kept[index[k]] && distance2[k] <= near * near;
        }
    }
}

/* The point goes on the way of its two nearest, which no point off a surface does: the second is
 * half as far again and more, in the same direction. */
static bool is_on_needle(const struct point_grid *b, size_t i)
{
    enum { SOME = 8 };
    const double reach = REACH * point_grid_spacing(b);
    const double further = 1.5, furthest = 3, straight = 0.9; /* cosine of 26 degrees */
    uint32_t index[SOME];
    double distance2[SOME];
    size_t n = point_grid_nearest(b, b->point[i], SOME, index, distance2);

    if (n < 3 || distance2[1] > reach * reach)
        return false;
    struct vec3 first = vec_sub(b->point[index[1]], b->point[i]);
    for (size_t k = 2; k < n; k++) {
        struct vec3 next = vec_sub(b->point[index[k]], b->point[i]);
        double part = sqrt(distance2[k] / distance2[1]);
        if (part > further && part < furthest &&
            vec_dot(first, next) > straight * vec_length(first) * vec_length(next))
            return true;
        if (part <= further)
            return false;
    }
    return false;
}

/* Points of a row are marked, or no point of a surface is near to them either. */
static bool may_be_in_row(const struct point_grid *b, const unsigned char *out, size_t i)
{
    const double near = NEXT * point_grid_spacing(b);
    uint32_t index[2];
    double distance2[2];

    return out[i] || (point_grid_nearest(b, b->point[i], 2, index, distance2) == 2 &&
                      distance2[1] >= near * near);
}

/* The next such point from point i, as far as scan lines may be; b->n: there is none. */
static size_t next_in_row(const struct point_grid *b, const unsigned char *out, size_t i)
{
    enum { MANY = 2 * NEAR };
    const double near = NEXT * point_grid_spacing(b), far = FURTHEST * point_grid_spacing(b);
    uint32_t index[MANY];
    double distance2[MANY];
    size_t n = point_grid_nearest(b, b->point[i], MANY, index, distance2);

    for (size_t k = 1; k < n && distance2[k] <= far * far; k++)
        if (distance2[k] >= near * near && may_be_in_row(b, out, index[k]))
            return index[k];
    return b->n;
}

/* How many of them follow point i, each as far on from the one before, along `step`. */
static size_t count_in_row(const struct point_grid *b, const unsigned char *out, size_t i,
                           struct vec3 step)
{
    const double even = 0.4; /* of a step: so far points of a line are off the middle of a rib */
    double least = even * vec_length(step);
    size_t found = 0;

    for (struct vec3 at = b->point[i]; found < ROW; found++) {
        uint32_t index;
        double distance2;
        if (point_grid_nearest(b, vec_add(at, step), 1, &index, &distance2) < 1 ||
            distance2 > least * least || !may_be_in_row(b, out, index))
            break;
        step = vec_sub(b->point[index], at);
        at = b->point[index];
    }
    return found;
}

/* The point is one of several in a row, as far apart as scan lines are: each line saw the top of a
 * thin rib once. */
static bool is_in_row(const struct point_grid *b, const unsigned char *out, size_t i)
{
    size_t next = next_in_row(b, out, i);

    if (next == b->n)
        return false;
    struct vec3 step = vec_sub(b->point[next], b->point[i]);
    return 1 + count_in_row(b, out, i, step) + count_in_row(b, out, i, vec_scale(-1, step)) >= ROW;
}

/* The points not marked that are near point i seen from above, of very many only some, and how many
 * of them are above and below it. */
static size_t gather_seen_from_above(const struct point_grid *b, const unsigned char *out, size_t i,
                                     struct vec3 *near, size_t *above, size_t *below)
{
    const double within = SEEN * point_grid_spacing(b);
    const struct vec3 p = b->point[i];
    size_t column = point_grid_column(b, p.x), row = point_grid_row(b, p.y), n = 0;
    size_t r0 = row > 0 ? row - 1 : 0, r1 = row + 1 < b->rows ? row + 1 : row;
    size_t c0 = column > 0 ? column - 1 : 0, c1 = column + 1 < b->columns ? column + 1 : column;
    for (size_t r = r0; r <= r1; r++)
        for (size_t k = b->first[r * b->columns + c0]; k < b->first[r * b->columns + c1 + 1]; k++) {
            struct vec3 q = b->point[k];
            if (k == i || out[k] || n == MOST || hypot(q.x - p.x, q.y - p.y) > within)
                continue;
            near[n++] = q;
            *above += q.z > p.z;
            *below += q.z < p.z;
        }
    return n;
}

/* Their heights differ by so much that they go up or down a cliff. */
static bool is_cliff(const struct point_grid *b, const struct vec3 *near, size_t n)
{
    const double steep = 10 * point_grid_spacing(b); /* over five spacings at most: 63 degrees */
    double low = INFINITY, high = -INFINITY;

    for (size_t k = 0; k < n; k++) {
        low = fmin(low, near[k].z);
        high = fmax(high, near[k].z);
    }
    return high - low > steep;
}

/* Where the middle of the points about p is, seen from above. */
static struct vec3 middle_of(const struct vec3 *near, size_t n, struct vec3 p)
{
    struct vec3 sum = vec(0, 0, 0);

    for (size_t k = 0; k < n; k++)
        sum = vec_add(sum, vec(near[k].x - p.x, near[k].y - p.y, 0));
    return n > 0 ? vec_scale(1 / (double)n, sum) : sum;
}

/* The widest angle about p, seen from above, without a point; 2 pi where there is none. */
static double widest_gap(const struct vec3 *near, size_t n, struct vec3 p)
{
    double angle[MOST];

    for (size_t k = 0; k < n; k++)
        angle[k] = atan2(near[k].y - p.y, near[k].x - p.x);
    doubles_sort(angle, n);
    double widest = n > 0 ? angle[0] + 2 * PI - angle[n - 1] : 2 * PI;
    for (size_t k = 1; k < n; k++)
        widest = fmax(widest, angle[k] - angle[k - 1]);
    return widest;
}

/* The surface that is seen about point i ends there. */
static bool is_at_rim(const struct point_grid *b, const struct vec3 *near, size_t n, size_t i)
{
    struct vec3 p = b->point[i], in = middle_of(near, n, p);
    struct vec3 out = vec_along(p, -UNDERCUT * point_grid_spacing(b), vec_unit(in));

    return vec_length(in) > LOPSIDED * SEEN * point_grid_spacing(b) &&
           (widest_gap(near, n, p) > RIM || widest_gap(near, n, out) > RIM);
}

/* A point of a step or a cliff that was seen from above has few others on the wall near to it: but
 * the surface comes from below it and goes on above it, and those points go up a cliff, or are
 * about as little on one smooth surface as it is; or the surface ends above it, as at the outline
 * of a part, where the wall goes on down to where nothing was seen. */
static bool is_on_step(const struct point_grid *b, const unsigned char *out, size_t i)
{
    enum { EACH_SIDE = 2 };
    const double much = 6;
    struct vec3 near[MOST];
    struct quadric q;
    size_t above = 0, below = 0, n = gather_seen_from_above(b, out, i, near, &above, &below);
    double squares = 0;

    if (above < EACH_SIDE)
        return false;
    if (is_at_rim(b, near, n, i))
        return true;
    if (below < EACH_SIDE)
        return false;
    if (is_cliff(b, near, n) || quadric_fit(near, n, b->point[i], vec(0, 0, 1), &q) < 0)
        return true;
    for (size_t k = 0; k < n; k++) {
        double off = quadric_off(&q, near[k]);
        squares += off * off;
    }
    return fabs(quadric_off(&q, b->point[i])) <= much * sqrt(squares / (double)n);
}

bool outliers_is_beneath(const struct point_grid *b, const unsigned char *out, size_t i)
{
    enum { FEWEST = 2, TIMES = 3 };
    struct vec3 near[MOST];
    size_t above = 0, below = 0;

    gather_seen_from_above(b, out, i, near, &above, &below);
    return above >= FEWEST && above > TIMES * below;
}

/* How far point i is over the middle one of those not marked near it, seen from above. */
static double height_over(const struct point_grid *b, const unsigned char *out, size_t i)
{
    struct vec3 near[MOST];
    double z[MOST];
    size_t above = 0, below = 0, n = gather_seen_from_above(b, out, i, near, &above, &below);

    for (size_t k = 0; k < n; k++)
        z[k] = near[k].z;
    doubles_sort(z, n);
    return n > 0 ? b->point[i].z - z[n / 2] : 0;
}

/*
 * Keeps marked point i, and the marked ones about it, where several stand as high over what is
 * about them and are not in one place as a clump is: a thin rib whose points are anywhere.  Stray
 * points stand as high as others by chance alone.
 */
static void keep_as_high(const struct point_grid *b, const unsigned char *out, size_t i, bool *kept)
{
    double spacing = point_grid_spacing(b), high = height_over(b, out, i), widest = 0;
    struct sizes about = {0}, alike = {0};

    if (high > spacing)
        point_grid_within(b, b->point[i], FEATURE_WITHIN * spacing, &about);
    for (size_t k = 0; k < about.n; k++) {
        size_t j = about.item[k];
        if (fabs(b->point[j].z - b->point[i].z) > LEVEL * high ||
            height_over(b, out, j) < STANDS * high)
            continue;
        *array_push(&alike) = j;
        widest = fmax(widest, vec_distance(b->point[i], b->point[j]));
    }
    for (size_t k = 0; alike.n >= ROW && widest > FEATURE_LONG * spacing && k < alike.n; k++)
        kept[alike.item[k]] = true;
    array_free(&about);
    array_free(&alike);
}

void outliers_keep(const struct point_grid *b, double sigma, unsigned char *out)
{
    struct group group = {.attached = false};
    bool *kept = mem_alloc(b->n + 1, sizeof *kept);

    for (size_t i = 0; i < b->n; i++)
        kept[i] =
            out[i] == MARKED && (edge_flank_holds(b, sigma, i) || is_on_one_surface(b, sigma, i) ||
                                 is_on_step(b, out, i) || is_in_row(b, out, i));
    for (size_t i = 0; i < b->n; i++)
        if (out[i] == MARKED && !kept[i])
            keep_as_high(b, out, i, kept);
    for (size_t i = 0; i < b->n; i++)
        if (kept[i])
            out[i] = 0;
    for (size_t i = 0; i < b->n; i++) {
        if (out[i] != MARKED)
            continue;
        group.member.n = 0;
        group.kept = 0;
        group.attached = false;
        out[i] = GROUPED;
        *array_push(&group.member) = i;
        for (size_t k = 0; k < group.member.n; k++)
            spread_group(b, kept, group.member.item[k], out, &group);
        bool feature = group.member.n + group.kept >= FEATURE || is_on_needle(b, i);
        for (size_t k = 0; k < group.member.n; k++)
            out[group.member.item[k]] = group.attached && feature ? 0 : DONE;
    }
    for (size_t i = 0; i < b->n; i++)
        out[i] = out[i] != 0;
    array_free(&group.member);
    free(kept);
}
