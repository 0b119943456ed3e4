/* coverage - see coverage.h. */
#include "toolpath/coverage.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "math/quadric.h"
#include "math/sphere_grid.h"

/* AXES: over the upper half */
enum { ABOUT = 12, ABOUT_IT = 6, WIDE = 30, TURNS = 60, AXES = 120 };

/* By how much the centre may be nearer between two samples of the path than at them, mm. */
static const double SAGITTA = 0.001;

/* Of the radius: guard points that are nearer to the point itself say nothing of a direction. */
static const double NEAREST = 1e-6;

struct coverage {
    size_t n;
    struct coverage_point *point;
    bool *known;   /* has been found: ... */
    double *reach; /* ... how near the ball can come to the point, mm, ... */
    bool *kept;    /* ... and that what is assumed keeps it off */
    size_t done;   /* centres of the path that have been looked at */
    struct kdtree *tree;
    struct kdtree *roof; /* of the points that face up; NULL: not made yet, for few need it */
};

struct coverage *coverage_new(const struct vec3 *point, size_t n, int threads)
{
    struct coverage *coverage = mem_alloc(1, sizeof *coverage);

    coverage->n = n;
    coverage->roof = NULL;
    coverage->point = mem_alloc(n + 1, sizeof *coverage->point);
    coverage->known = mem_alloc(n + 1, sizeof *coverage->known);
    coverage->reach = mem_alloc(n + 1, sizeof *coverage->reach);
    coverage->kept = mem_alloc(n + 1, sizeof *coverage->kept);
    coverage->tree = kdtree_new_by(point, n, threads);
    for (size_t i = 0; i < n; i++)
        coverage->point[i] =
            (struct coverage_point){.p = point[i], .state = COVERAGE_LEFT, .height = HUGE_VAL};
    return coverage;
}

void coverage_free(struct coverage *coverage)
{
    if (!coverage)
        return;
    kdtree_free(coverage->tree);
    if (coverage->roof)
        kdtree_free(coverage->roof);
    free(coverage->point);
    free(coverage->known);
    free(coverage->reach);
    free(coverage->kept);
    free(coverage);
}

void coverage_restart(struct coverage *coverage)
{
    coverage->done = 0;
    for (size_t i = 0; i < coverage->n; i++) {
        coverage->point[i].state = COVERAGE_LEFT;
        coverage->point[i].height = HUGE_VAL;
    }
}

const struct coverage_point *coverage_points(const struct coverage *coverage, size_t *n)
{
    *n = coverage->n;
    return coverage->point;
}

/* ---- what is cut */

/* Places along the path no further apart than that; points that are crowded count once. */
static void sample_path(const struct vec3s *centre, size_t from, const struct sizes *end,
                        double apart, struct vec3s *sample)
{
    for (size_t k = 0; k <= end->n; k++) {
        size_t to = k < end->n ? end->item[k] : centre->n;
        struct vec3 last = {0, 0, 0};
        for (size_t i = from; i < to; i++) {
            struct vec3 c = centre->item[i];
            double far = i > from ? vec_distance(last, c) : 0, parts = ceil(far / apart);
            if (i > from && i + 1 < to && far < apart / 2)
                continue;
            for (double s = 1; s <= parts; s++)
                *array_push(sample) = vec_mix(last, c, s / parts);
            if (i == from)
                *array_push(sample) = c;
            last = c;
        }
        from = to > from ? to : from;
    }
}

/* ---- what can be reached */

/* What the threads share. */
struct covering {
    struct coverage *coverage;
    const struct coverage_options *options;
    const struct kdtree *path;
    bool *unsure; /* by point: what was found of it waits for the roof */
};

/* The normal of the points about p, on the side of the mesh's or, without one, upward. */
static struct vec3 guess_normal(const struct covering *w, struct vec3 p)
{
    const struct coverage_options *o = w->options;
    size_t index[WIDE], n = kdtree_nearest(w->coverage->tree, p, WIDE, index, NULL), vertex;
    struct vec3 near[WIDE], side = vec(0, 0, 1);
    struct quadric q;

    for (size_t i = 0; i < n; i++)
        near[i] = w->coverage->point[index[i]].p;
    struct vec3 normal = plane_normal(near, n < ABOUT ? n : ABOUT);
    if (quadric_settle(near, n, p, normal, &q) == 0) /* exact at a border too */
        normal = quadric_normal(&q);
    if (o->vertex && kdtree_nearest(o->vertex, p, 1, &vertex, NULL) == 1)
        side = o->normal[vertex];
    return vec_dot(normal, side) < 0 ? vec_scale(-1, normal) : normal;
}

/* Turns d until the ball that touches p along it is clear, or nearly so; how far off p along d the
 * ball is then clear, mm. */
static double find_touch(const struct coverage_options *o, struct vec3 p, struct vec3 *d)
{
    struct vec3 turning = *d, q = p; /* what the ball was deepest at before, it is likely again */
    double best = HUGE_VAL, before = HUGE_VAL;

    for (int turn = 0; turn < TURNS && best > o->tolerance / 2; turn++) {
        struct vec3 c = vec_along(p, o->radius, turning);
        double within = fmin(o->radius, vec_distance(c, q));
        double depth = o->radius - gouge_nearest(o->guard, c, within, &q);
        if (depth < best) {
            best = depth;
            *d = turning;
        }
        if (turn % 12 == 11 && best > 0.8 * before)
            break;
        before = turn % 12 == 11 ? best : before;
        struct vec3 v = vec_sub(q, p);
        double v2 = vec_dot(v, v);
        if (best <= o->tolerance / 2 || v2 < NEAREST * o->radius * o->radius)
            break;
        turning = vec_along(turning, -(vec_dot(turning, v) - v2 / (2 * o->radius)) / v2, v);
        if (vec_length(turning) < 0.1)
            break;
        turning = vec_unit(turning);
    }
    if (best <= o->tolerance)
        return 0;
    double lift =
        gouge_least_lift(o->guard, vec_along(p, o->radius, *d), *d, o->radius, o->near, NULL);
    return lift < 0 ? HUGE_VAL : lift;
}

/* Direction k of n, evenly over the sphere from the top down. */
static struct vec3 spread(int k, int n)
{
    return sphere_spiral(k, 1 - (2 * k + 1.0) / n);
}

/* What was in the way of the tool before, of each way and each axis. */
struct hindrance {
    struct gouge_ways ways;
    struct kdtree_touch *axis; /* of the axes that there are, else of AXES */
};

static struct hindrance hindrance_new(const struct coverage_options *o)
{
    size_t n = o->axes.n > AXES ? o->axes.n : AXES;
    struct hindrance h = {.axis = mem_alloc(n, sizeof *h.axis)};

    for (size_t k = 0; k < n; k++)
        h.axis[k].n = 0;
    return h;
}

/* Of the guard, and of what is assumed beside it. */
struct hindrances {
    struct hindrance guard, assumed;
};

static struct hindrances hindrances_new(const struct coverage_options *o)
{
    return (struct hindrances){hindrance_new(o), hindrance_new(o)};
}

static void hindrances_free(struct hindrances *h)
{
    free(h->guard.axis);
    free(h->assumed.axis);
}

static bool comes_along(const struct coverage_options *o, struct vec3 c, struct vec3 axis,
                        struct kdtree_touch *touch)
{
    return gouge_holder_clear(o->guard, o->holder, c, axis, -o->tolerance, touch);
}

static bool comes_by(const struct coverage_options *o, struct vec3 c, struct vec3 d,
                     struct vec3 axis, struct kdtree_touch *touch)
{
    const double flattest = 0.05; /* cosine */

    return vec_dot(axis, d) > flattest && comes_along(o, c, axis, touch);
}

/* True if the tool can stand at a ball that touches along d: on its only axis, on any of those that
 * there are, or of many that come from above, on the ball's side. */
static bool has_axis(const struct coverage_options *o, struct vec3 c, struct vec3 d,
                     struct hindrance *h)
{
    if (o->upright)
        return gouge_open(o->guard, c, o->axis, o->radius, o->tolerance);
    if (!gouge_open_anyhow(o->guard, c, d, o->radius, o->tolerance, &h->ways))
        return false;
    for (size_t k = 0; k < o->axes.n; k++)
        if (comes_by(o, c, d, o->axes.item[k], &h->axis[k]))
            return true;
    if (o->axes.n > 0)
        return false;
    if (!o->holder || o->holder->n == 0 || (d.z >= 0 && comes_along(o, c, d, NULL)))
        return true;
    for (int k = 0; k < AXES; k++)
        if (comes_by(o, c, d, spread(k, 2 * AXES), &h->axis[k]))
            return true;
    return false;
}

/* Cosines: between a ball's direction and the normal, at least; Z of a normal that faces up, and of
 * one that may be either side's. */
static const double AHEAD = 0.75, FACES_UP = 0.5, UPRIGHT = 0.3;

/* A point's normal, and whether it is known on which side of the points the part is: it faces up,
 * or all of the mesh about it faces to that side, as beside a thin rib it does not. */
struct side {
    struct vec3 normal;
    bool sure;
    size_t n;
    struct vec3 about[ABOUT_IT]; /* normals of the mesh about it */
};

static struct side side_of(const struct covering *w, struct vec3 p)
{
    const double alike = 0.5; /* cosine */
    const struct coverage_options *o = w->options;
    struct side side = {.normal = guess_normal(w, p)};
    size_t vertex[ABOUT_IT];
    bool all = true;

    if (o->vertex)
        side.n = kdtree_nearest(o->vertex, p, ABOUT_IT, vertex, NULL);
    for (size_t i = 0; i < side.n; i++) {
        side.about[i] = o->normal[vertex[i]];
        all = all && vec_dot(side.about[i], side.normal) >= alike;
    }
    side.sure = side.normal.z > UPRIGHT || (side.n > 0 && all);
    return side;
}

/* A ball that touches along d is in the part: behind a point whose side is known, or behind all of
 * the mesh about it. */
static bool is_behind(const struct side *side, struct vec3 d)
{
    bool all = side->n > 0;

    for (size_t i = 0; i < side->n; i++)
        all = all && vec_dot(d, side->about[i]) <= 0;
    return vec_dot(d, side->normal) <= 0 && (side->sure || all);
}

/* How near a ball and its tool come to p, mm, from some directions to begin with; HUGE_VAL: nothing
 * comes as near as what is there is worth.  *direction: of the nearest, else as it was.  Behind the
 * points is material, though none stands for it. */
static double find_reach(const struct coverage_options *o, struct vec3 p, const struct side *side,
                         const struct vec3 begin[3], struct vec3 *direction, struct hindrance *h)
{
    double nearest = HUGE_VAL;

    for (int k = 0; k < 3 && nearest > 0; k++) {
        struct vec3 d = begin[k];
        if (vec_length(d) < 0.5)
            continue;
        double lift = o->guard ? find_touch(o, p, &d) : 0;
        if (lift >= nearest || is_behind(side, d))
            continue;
        if (!o->guard || has_axis(o, vec_along(p, o->radius + lift, d), d, h)) {
            *direction = d;
            nearest = lift;
        }
    }
    return nearest;
}

/* The area that a point stands for: that of the disc with its nearest neighbours, by their number.
 */
static double area_of(const struct coverage *coverage, struct vec3 p)
{
    size_t index[ABOUT];
    double distance2[ABOUT];
    size_t n = kdtree_nearest(coverage->tree, p, ABOUT, index, distance2);

    return n > 1 ? PI * distance2[n - 1] / (double)(n - 1) : 0;
}

/* Mean distances of points that a ball may be beside them; of the radius, where that may be more
 * nothing is known; in radii how far over the ball's centre points count. */
static const double BESIDE = 0.75, SPARSE = 0.6, OVERHEAD = 4;

struct facing {
    const struct covering *work;
    bool *up;
};

static void look_which_face_up(void *context, size_t from, size_t to)
{
    const struct facing *f = context;

    for (size_t i = from; i < to; i++)
        f->up[i] = guess_normal(f->work, f->work->coverage->point[i].p).z > FACES_UP;
}

/* The points that face up. */
static void find_roof(const struct covering *w)
{
    size_t n = w->coverage->n;
    struct facing facing = {w, mem_alloc(n + 1, sizeof *facing.up)};
    struct vec3s roof = {0};

    parallel_for(w->options->threads, n, look_which_face_up, &facing);
    for (size_t i = 0; i < n; i++)
        if (facing.up[i])
            *array_push(&roof) = w->coverage->point[i].p;
    w->coverage->roof = kdtree_new_by(roof.item, roof.n, w->options->threads);
    array_free(&roof);
    free(facing.up);
}

/* A point that faces up is so near over a ball at c.  Where no point is, none that faces up is;
 * where one is and the roof is not known, point i has to wait for it: true. */
static bool is_under_roof(const struct covering *w, size_t i, struct vec3 c, double within)
{
    const struct coverage *coverage = w->coverage;
    double radius = w->options->radius;
    struct vec3 low = vec_along(c, radius, vec(0, 0, 1));
    struct vec3 high = vec_along(c, OVERHEAD * radius, vec(0, 0, 1));

    if (coverage->roof)
        return kdtree_any_beside(coverage->roof, low, high, within);
    w->unsure[i] = kdtree_any_beside(coverage->tree, low, high, within);
    return w->unsure[i];
}

/* How near to point i along d a ball is clear of the points, in the open, and its tool comes, mm;
 * HUGE_VAL: not so near that it cuts the point. */
static double find_open_along(const struct covering *w, size_t i, struct vec3 d,
                              struct hindrance *h)
{
    const struct coverage_options *o = w->options;
    struct vec3 p = w->coverage->point[i].p, c = vec_along(p, o->radius, d);
    double lift = gouge_least_lift(o->guard, c, d, o->radius, o->near, NULL);
    double smaller = o->near + BESIDE * sqrt(area_of(w->coverage, p));

    if (lift < 0)
        return HUGE_VAL;
    c = vec_along(c, lift, d);
    if (smaller <= SPARSE * o->radius && is_under_roof(w, i, c, o->radius - smaller))
        return HUGE_VAL;
    return has_axis(o, c, d, h) ? lift : HUGE_VAL;
}

/* Along the normal and BALLS directions evenly over the sphere: the first that serves, in
 * *direction, and how near it comes. */
static double find_open(const struct covering *w, size_t i, const struct side *side,
                        struct vec3 *direction, struct hindrance *h)
{
    enum { BALLS = 160 };
    double near = HUGE_VAL;

    for (int k = -1; k < BALLS && near == HUGE_VAL && !w->unsure[i]; k++) {
        struct vec3 d = k < 0 ? side->normal : spread(k, BALLS);
        double share = vec_dot(d, side->normal);
        if ((side->sure ? share : fabs(share)) < AHEAD)
            continue;
        near = find_open_along(w, i, d, h);
        *direction = near < HUGE_VAL ? d : *direction;
    }
    return near;
}

/* What is known of a point that is not cut, once.  What turning does not find a search about
 * may. */
static void look_at_point(const struct covering *w, size_t i, struct hindrances *h)
{
    const struct coverage_options *o = w->options;
    struct coverage_point *point = &w->coverage->point[i];
    const struct side side = side_of(w, point->p);
    struct vec3 normal = side.normal, up = vec(0, 0, 1), direction;
    struct vec3 begin[3] = {normal, vec_unit(vec_add(normal, up)), up};

    point->normal = normal;
    w->coverage->kept[i] = false;
    w->coverage->reach[i] = find_reach(o, point->p, &side, begin, &point->normal, &h->guard);
    if (o->guard && w->coverage->reach[i] > o->near)
        w->coverage->reach[i] = find_open(w, i, &side, &point->normal, &h->guard);
    if (!o->assumed || w->coverage->reach[i] > o->near)
        return;
    struct coverage_options assumed = *o;
    assumed.guard = o->assumed;
    struct vec3 again[3] = {point->normal, normal, up};
    w->coverage->kept[i] =
        find_reach(&assumed, point->p, &side, again, &direction, &h->assumed) > o->near;
    if (!w->coverage->kept[i])
        point->normal = direction;
}

static enum coverage_state state_of(const struct covering *w, size_t i)
{
    double limit = w->options->limit;

    if (!(w->coverage->point[i].height > limit && w->coverage->reach[i] <= w->options->near))
        return COVERAGE_OUT;
    return w->coverage->kept[i] ? COVERAGE_KEPT : COVERAGE_LEFT;
}

static void cover_points(void *context, size_t from, size_t to)
{
    const struct covering *w = context;
    const struct coverage_options *o = w->options;
    double within = o->radius + o->limit;
    struct hindrances h = hindrances_new(o);

    for (size_t i = from; i < to; i++) {
        struct coverage_point *point = &w->coverage->point[i];
        size_t nearest;
        if (point->state == COVERAGE_CUT)
            continue;
        if (kdtree_any_beside(w->path, point->p, point->p, within)) {
            point->state = COVERAGE_CUT;
            continue;
        }
        double far = point->height + o->radius;
        far = kdtree_nearest_segment(w->path, point->p, point->p, far, &nearest);
        point->height = far - o->radius;
        if (!w->coverage->known[i] && point->height > o->limit)
            look_at_point(w, i, &h);
        w->coverage->known[i] = true;
        point->state = state_of(w, i);
    }
    hindrances_free(&h);
}

static bool any_unsure(const struct covering *w)
{
    for (size_t i = 0; i < w->coverage->n; i++)
        if (w->unsure[i])
            return true;
    return false;
}

/* At the points that waited for the roof. */
static void look_again(void *context, size_t from, size_t to)
{
    const struct covering *w = context;
    struct hindrances h = hindrances_new(w->options);

    for (size_t i = from; i < to; i++) {
        if (!w->unsure[i])
            continue;
        w->unsure[i] = false;
        look_at_point(w, i, &h);
        w->coverage->point[i].state = state_of(w, i);
    }
    hindrances_free(&h);
}

void coverage_cut(struct coverage *coverage, const struct coverage_options *options,
                  const struct vec3s *centre, const struct sizes *end)
{
    struct vec3s sample = {0};

    sample_path(centre, coverage->done, end, sqrt(8 * options->radius * SAGITTA), &sample);
    struct kdtree *path = kdtree_new_by(sample.item, sample.n, options->threads);
    struct covering work = {coverage, options, path,
                            mem_alloc(coverage->n + 1, sizeof *work.unsure)};
    array_free(&sample);
    parallel_for(options->threads, coverage->n, cover_points, &work);
    if (any_unsure(&work)) {
        find_roof(&work);
        parallel_for(options->threads, coverage->n, look_again, &work);
    }
    coverage->done = centre->n;
    kdtree_free(path);
    free(work.unsure);
}

/* ---- the report */

struct coverage_report coverage_report(const struct coverage *coverage)
{
    struct coverage_report report = {.points = coverage->n};
    struct coverage_share *share[] = {[COVERAGE_LEFT] = &report.left,
                                      [COVERAGE_KEPT] = &report.kept,
                                      [COVERAGE_OUT] = &report.out};

    for (size_t i = 0; i < coverage->n; i++) {
        const struct coverage_point *p = &coverage->point[i];
        if (p->state == COVERAGE_CUT)
            continue;
        share[p->state]->n++;
        share[p->state]->area += area_of(coverage, p->p);
        if (p->height > share[p->state]->highest) {
            share[p->state]->highest = p->height;
            share[p->state]->at = p->p;
        }
    }
    return report;
}
