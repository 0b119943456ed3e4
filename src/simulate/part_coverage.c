/* part_coverage - see part_coverage.h. */
#include "simulate/part_coverage.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

#include "base/parallel.h"
#include "math/box.h"
#include "math/kdtree.h"
#include "math/quadric.h"
#include "math/sphere_grid.h"
#include "simulate/unseen_wall.h"

enum {
    AXES = 500,   /* over the whole sphere, of which the upper half counts */
    BALLS = 160,  /* directions of the ball's centre from a point, over the whole sphere */
    TRIES = 12,   /* balls that are clear, for which the tool is looked at ... */
    LEANS = 48,   /* ... in so many directions that are clear close by */
    NEAR = 13,    /* points that the normal is from, ... */
    BESIDE = 7,   /* ... and the area, the point itself the first */
    FAILURES = 2, /* points of a cell out of reach, after which the others are taken as alike */
    GROUP = 16    /* cells that one thread looks at, at a time */
};

#define CELL 0.25        /* of the radius: width of a cell */
#define SPARSE 0.34      /* of the radius: the points that stand for all are so far apart */
#define STEEP 0.3        /* a normal is upright with less than this of Z */
#define LEANS_LEAST 0.03 /* Z of a normal that is not upright ... */
#define SIGMAS 3         /* ... by so many standard deviations more */
#define AHEAD 0.75       /* cosine between the normal and the ball's direction, at least */
#define FREE 0.1         /* mm: less play has no way in for the tool that would be looked for */
#define LINE 0.9     /* of the radius: thickness of the middle line that has to come from outside */
#define FACES_UP 0.5 /* Z of a normal, at least, of what is material below */
#define OVERHEAD 4   /* radii above the ball's centre that are looked at for it */
#define BESIDE_GAP 0.75 /* mean distances of points that the ball may be beside them unnoticed */
#define CORNER 0.5 /* mean distances of points: so far a corner is out between two feet of a wall */
#define COLUMN 0.2 /* of the radius: points over the foot of a wall are so far apart */
#define TOO_SPARSE 0.6 /* of the radius: where it could be further, nothing is known */

/* ---- directions */

/* The k-th of n directions spread evenly over the sphere, from the top down. */
static struct vec3 spread(int k, int n)
{
    return sphere_spiral(k, 1 - (2 * k + 1.0) / n);
}

static bool machine_reaches(const struct verify_kinematics *kinematics, struct vec3 axis)
{
    const double at_zero[VERIFY_KINEMATICS_AXES] = {0};
    double q[VERIFY_KINEMATICS_AXES] = {0};
    if (!verify_kinematics_angles(kinematics, axis, at_zero, 0.01, q))
        return false;
    for (int i = 0; i < kinematics->n; i++)
        if (q[i] < kinematics->axis[i].min - 1e-6 || q[i] > kinematics->axis[i].max + 1e-6)
            return false;
    return true;
}

/* A single rotary axis: the directions of all its angles. */
static void add_turns(const struct verify_kinematics *kinematics, struct vec3s *axes)
{
    const struct verify_kinematics_axis *rotary = &kinematics->axis[0];
    for (double angle = -180; angle < 180; angle += 5) {
        const double q[VERIFY_KINEMATICS_AXES] = {angle};
        struct vec3 axis = verify_kinematics_axis_at(kinematics, q);
        if (angle >= rotary->min && angle <= rotary->max && axis.z >= 0)
            *array_push(axes) = axis;
    }
}

struct vec3s part_coverage_axes(const struct verify_kinematics *kinematics)
{
    struct vec3s axes = {0};
    *array_push(&axes) = kinematics->tool;
    if (kinematics->n == 1)
        add_turns(kinematics, &axes);
    for (int k = 0; k < AXES / 2 && kinematics->n == 2; k++)
        if (machine_reaches(kinematics, spread(k, AXES)))
            *array_push(&axes) = spread(k, AXES);
    return axes;
}

/* ---- the points, in several orders */

struct reach {
    const struct vec3 *point;
    const double *deviation;
    const unsigned char *under;
    size_t n;
    const struct part_coverage_options *options;
    struct kdtree *tree;
    struct vec3s solid; /* what is in the way: the points, and the curtain */
    struct kdtree *solid_tree;
    struct vec3s sparse; /* few of them, one of each small cell ... */
    struct kdtree *sparse_tree;
    double far;         /* further away than that is outside */
    struct sizes order; /* points with more than the limit, by cell */
    struct sizes first; /* cell k: order[first[k]] up to first[k + 1] */
    unsigned char *of;
    double *area;
    bool *up;                 /* of each point: the surface faces up there */
    struct kdtree *roof_tree; /* of these points */
    struct vec3s wall;        /* places where walls may stand that have no points */
    struct kdtree *wall_tree;
    struct vec3 ball[BALLS]; /* directions of a ball's centre from its point */
};

/* Which cell of a grid of this width a point is in, as a number to sort by. */
static uint64_t cell_of(struct vec3 p, struct vec3 low, double width)
{
    uint64_t x = (uint64_t)((p.x - low.x) / width), y = (uint64_t)((p.y - low.y) / width),
             z = (uint64_t)((p.z - low.z) / width);
    return (x << 42) | (y << 21) | z;
}

struct keyed {
    uint64_t key;
    size_t index;
};

static int by_key(const void *a, const void *b)
{
    const struct keyed *p = a, *q = b;
    if (p->key != q->key)
        return p->key < q->key ? -1 : 1;
    return p->index < q->index ? -1 : p->index > q->index;
}

/* n points by their cells. */
static struct keyed *sort_points(const struct vec3 *point, size_t n, double width)
{
    struct keyed *keyed = mem_alloc(n, sizeof *keyed);
    struct box box = box_around(point, n);
    for (size_t i = 0; i < n; i++)
        keyed[i] = (struct keyed){cell_of(point[i], box.low, width), i};
    qsort(keyed, n, sizeof *keyed, by_key);
    return keyed;
}

static void add_solid(struct reach *r)
{
    const struct vec3s *curtain = r->options->curtain;
    for (size_t i = 0; i < r->n; i++)
        *array_push(&r->solid) = r->point[i];
    for (size_t i = 0; curtain && i < curtain->n; i++)
        *array_push(&r->solid) = curtain->item[i];
    r->solid_tree = kdtree_new_by(r->solid.item, r->solid.n, r->options->threads);
}

static void thin_points(struct reach *r)
{
    const struct vec3s *solid = &r->solid;
    struct keyed *keyed = sort_points(solid->item, solid->n, SPARSE * r->options->radius);
    for (size_t i = 0; i < solid->n; i++)
        if (i == 0 || keyed[i].key != keyed[i - 1].key)
            *array_push(&r->sparse) = solid->item[keyed[i].index];
    free(keyed);
}

static void sort_into_cells(struct reach *r)
{
    struct keyed *keyed = sort_points(r->point, r->n, CELL * r->options->radius);
    uint64_t last = 0;
    for (size_t i = 0; i < r->n; i++) {
        if (r->deviation[keyed[i].index] <= r->options->limit)
            continue;
        if (r->order.n == 0 || keyed[i].key != last)
            *array_push(&r->first) = r->order.n;
        last = keyed[i].key;
        *array_push(&r->order) = keyed[i].index;
    }
    *array_push(&r->first) = r->order.n;
    free(keyed);
}

/* ---- one point */

/* A direction of the ball from its point and one of the tool that were clear. */
struct access {
    bool known, inside; /* inside: for a ball that only sparse points let through, too */
    struct vec3 ball;
    size_t axis; /* by its number */
};

/* What the search at one point needs. */
struct look {
    const struct reach *r;
    struct kdtree_touch *met;    /* of each axis: what the tool met last, likely so again */
    struct kdtree_touch *beyond; /* and what was in the way over it */
    struct sizes near;           /* sparse points about the tool; 0: not yet looked for */
    double *share;               /* of each axis: cosine to the ball's direction */
    size_t *left, n;             /* the n axes that were not looked at, by their numbers */
};

/* The ball's centre, as little out along `d` as leaves it clear; false: so far that it would leave
 * more on its point than one that could cut it. */
static bool ball_clears(const struct reach *r, struct vec3 p, struct vec3 d, struct vec3 *centre)
{
    double budget = r->options->near;
    struct vec3 at = vec_along(p, r->options->radius, d);
    double out = kdtree_leave(r->solid_tree, at, d, r->options->radius, budget, NULL);
    *centre = vec_along(at, out, d);
    return out <= budget;
}

/*
 * The surface that faces up goes on over the ball, near above it: it would stand in the material
 * below, past a wall that the scan has too few points of.  So that points beside the ball do not
 * count, its silhouette is smaller by their distance.
 */
static bool ball_is_inside(const struct reach *r, size_t i, struct vec3 centre)
{
    double radius = r->options->radius;
    double smaller = r->options->near + BESIDE_GAP * sqrt(r->area[i]);
    return smaller <= TOO_SPARSE * radius &&
           kdtree_any_beside(r->roof_tree, vec_along(centre, radius, vec(0, 0, 1)),
                             vec_along(centre, OVERHEAD * radius, vec(0, 0, 1)), radius - smaller);
}

/* A wall that has no points may stand within the ball, or so much before the feet that were seen as
 * a corner stands out between two of them. */
static bool ball_is_in_wall(const struct reach *r, size_t i, struct vec3 centre)
{
    double radius = r->options->radius;
    size_t k;
    double distance2;

    if (kdtree_nearest(r->wall_tree, centre, 1, &k, &distance2) == 0)
        return false;
    if (distance2 < radius * radius)
        return true;
    struct vec3 to = vec_sub(r->wall.item[k], centre);
    double beside = hypot(to.x, to.y), nearer = fmin(CORNER * sqrt(r->area[i]), beside);
    if (distance2 >= (radius + nearer) * (radius + nearer))
        return false;
    struct vec3 moved = vec_along(centre, nearer / beside, vec(to.x, to.y, 0));
    return kdtree_any_beside(r->wall_tree, moved, moved, radius);
}

/* The ball is in the material for all that the scan tells. */
static bool ball_may_be_inside(const struct reach *r, size_t i, struct vec3 centre)
{
    return ball_is_inside(r, i, centre) || ball_is_in_wall(r, i, centre);
}

/* A tool that stands somewhere. */
struct stand {
    const struct tool_shape *tool;
    struct vec3 centre, axis;
};

static double stand_distance(const void *context, struct vec3 p, double below)
{
    (void)below;
    const struct stand *s = context;
    return tool_shape_distance(s->tool, s->centre, s->axis, p);
}

static double stand_bound(const void *context, struct vec3 middle, struct vec3 half, double below)
{
    (void)below;
    const struct stand *s = context;
    return tool_shape_bound(s->tool, s->centre, s->axis, middle, half);
}

/* Something is nearer than `least` to flute, shank or holder.  The tree has boxes of a wall's
 * points, too, which stand one over the other in plan. */
static bool tool_is_blocked(const struct reach *r, struct vec3 centre, struct vec3 axis,
                            double least, struct kdtree_touch *met)
{
    struct stand s = {r->options->tool, centre, axis};
    const struct kdtree_field field = {stand_distance, stand_bound, &s};
    return s.tool->n > 0 && kdtree_any_lower(r->solid_tree, &field, least, met);
}

/* The tool with axis k over a ball at `centre`, moved out along `d` by what has to be free: along a
 * wall that the ball touches the shaft may go. */
static bool tool_clears(struct look *l, struct vec3 centre, struct vec3 d, size_t k)
{
    const struct reach *r = l->r;
    struct vec3 axis = r->options->axis->item[k];
    double clear = r->options->radius;
    return !tool_is_blocked(r, vec_along(centre, FREE, d), axis, 0.9 * FREE, &l->met[k]) &&
           !kdtree_find_beside(r->solid_tree, vec_along(centre, 2 * clear, axis),
                               vec_along(centre, r->far, axis), LINE * clear, &l->beyond[k]);
}

/* No sparse point is in the tool that stands at `centre` with that axis. */
static bool is_axis_open(struct look *l, struct vec3 centre, struct vec3 axis)
{
    const double rounding = 1 + 1e-9;
    const struct reach *r = l->r;
    const struct tool_shape *tool = r->options->tool;
    double widest = tool_shape_widest(tool), reach = tool_shape_reach(tool);
    if (tool->n == 0 || !kdtree_any_beside(r->sparse_tree, centre, vec_along(centre, reach, axis),
                                           widest * rounding))
        return true;
    if (l->near.n == 0)
        kdtree_within(r->sparse_tree, centre, reach, &l->near);
    for (size_t i = 0; i < l->near.n; i++) {
        struct vec3 d = vec_sub(r->sparse.item[l->near.item[i]], centre);
        double h = vec_dot(d, axis), off2 = vec_dot(d, d) - h * h;
        double thick = h > 0 && off2 < widest * widest ? tool_shape_radius(tool, h) : 0;
        if (thick > 0 && off2 < thick * thick)
            return false;
    }
    return true;
}

/* Takes of the axes that are left the nearest to the ball's direction. */
static size_t take_nearest(struct look *l)
{
    size_t best = 0;
    for (size_t k = 1; k < l->n; k++) {
        double more = l->share[l->left[k]] - l->share[l->left[best]];
        if (more > 0 || (more >= 0 && l->left[k] < l->left[best]))
            best = k;
    }
    size_t axis = l->left[best];
    l->left[best] = l->left[--l->n];
    return axis;
}

/* An axis for the ball at `centre`, of those that are free the nearest to `d` first. */
static bool find_axis(struct look *l, struct vec3 centre, struct vec3 d, size_t *found)
{
    const struct vec3s *axis = l->r->options->axis;
    struct vec3 out = vec_along(centre, FREE, d);
    l->near.n = 0;
    for (l->n = 0; l->n < axis->n; l->n++) {
        l->share[l->n] = vec_dot(axis->item[l->n], d);
        l->left[l->n] = l->n;
    }
    for (int tries = 0; tries < LEANS && l->n > 0;) {
        *found = take_nearest(l);
        if (!is_axis_open(l, out, axis->item[*found]))
            continue;
        if (tool_clears(l, centre, d, *found))
            return true;
        tries++;
    }
    return false;
}

/* Balls on one side of the surface, straight up from it first: those that are not in the material,
 * or those that are. */
static bool find_on_side(struct look *l, size_t i, struct vec3 normal, bool inside,
                         struct access *access)
{
    const struct reach *r = l->r;
    int tries = 0;
    for (int k = -1; k < BALLS && tries < TRIES; k++) {
        struct vec3 d = k < 0 ? normal : r->ball[k], centre;
        if (vec_dot(d, normal) < AHEAD || !ball_clears(r, r->point[i], d, &centre) ||
            ball_may_be_inside(r, i, centre) != inside)
            continue;
        tries++;
        if (find_axis(l, centre, d, &access->axis)) {
            access->ball = d;
            access->known = !inside;
            return true;
        }
    }
    return false;
}

static size_t points_about(const struct reach *r, size_t i, struct vec3 near[NEAR])
{
    size_t index[NEAR];
    size_t n = kdtree_nearest(r->tree, r->point[i], NEAR, index, NULL);
    for (size_t k = 0; k < n; k++)
        near[k] = r->point[index[k]];
    return n;
}

/* Of points about a place, on the side of what is seen from above. */
static struct vec3 upper_normal(const struct vec3 *near, size_t n)
{
    struct vec3 normal = plane_normal(near, n);
    return normal.z < 0 ? vec_scale(-1, normal) : normal;
}

/* That is its side: it leans more than it may be wrong. */
static bool surely_leans(const struct vec3 *near, size_t n, struct vec3 normal)
{
    struct vec3 mean = {0, 0, 0}, up = vec_unit(vec_reject(vec(0, 0, 1), normal));
    double off2 = 0, high2 = 0;
    for (size_t k = 0; k < n; k++)
        mean = vec_along(mean, 1 / (double)n, near[k]);
    for (size_t k = 0; k < n; k++) {
        struct vec3 d = vec_sub(near[k], mean);
        off2 += vec_dot(d, normal) * vec_dot(d, normal);
        high2 += vec_dot(d, up) * vec_dot(d, up);
    }
    double wrong = n > 3 && high2 > 0 ? sqrt(off2 / ((double)(n - 3) * high2)) : 1;
    return normal.z > LEANS_LEAST + SIGMAS * wrong;
}

/* Balls on either side of a surface that stands upright. */
static bool find_access(struct look *l, size_t i, struct vec3 normal, bool inside,
                        struct access *access)
{
    return find_on_side(l, i, normal, inside, access) ||
           (normal.z < STEEP && find_on_side(l, i, vec_scale(-1, normal), inside, access));
}

/* LEFT, KEPT_OFF or OUT_OF_REACH.  A ball behind a surface that surely leans is in the part, where
 * the scan is open above it too: within a hollow body, or under a slope that is steep all the way
 * up. */
static enum part_class class_of(struct look *l, size_t i, struct access *access)
{
    const struct reach *r = l->r;
    struct vec3 centre;
    if (access->known && ball_clears(r, r->point[i], access->ball, &centre) &&
        !ball_may_be_inside(r, i, centre) && tool_clears(l, centre, access->ball, access->axis))
        return COVERAGE_LEFT;
    struct vec3 near[NEAR];
    size_t n = points_about(r, i, near);
    struct vec3 normal = upper_normal(near, n);
    if (find_on_side(l, i, normal, false, access))
        return COVERAGE_LEFT;
    if (normal.z < STEEP && find_on_side(l, i, vec_scale(-1, normal), false, access)) {
        access->known = !surely_leans(near, n, normal);
        return access->known ? COVERAGE_LEFT : COVERAGE_KEPT_OFF;
    }
    if (r->options->left_only)
        return COVERAGE_OUT_OF_REACH;
    return find_access(l, i, normal, true, access) ? COVERAGE_KEPT_OFF : COVERAGE_OUT_OF_REACH;
}

/* Another point of the cell is not likely to be reached: of a part that is whole one that is kept
 * off tells that, too, while a scan has too few points here and enough there. */
static bool is_failure(const struct reach *r, enum part_class class)
{
    return class == COVERAGE_OUT_OF_REACH || (r->options->whole && class == COVERAGE_KEPT_OFF);
}

static struct look look_new(const struct reach *r)
{
    size_t n = r->options->axis->n;
    struct look l = {.r = r,
                     .met = mem_alloc(n, sizeof *l.met),
                     .beyond = mem_alloc(n, sizeof *l.beyond),
                     .share = mem_alloc(n, sizeof *l.share),
                     .left = mem_alloc(n, sizeof *l.left)};

    for (size_t k = 0; k < n; k++)
        l.met[k].n = l.beyond[k].n = 0;
    return l;
}

static void look_free(struct look *l)
{
    array_free(&l->near);
    free(l->met);
    free(l->beyond);
    free(l->share);
    free(l->left);
}

static void look_at_cells(void *context, size_t from, size_t to)
{
    struct reach *r = context;
    struct look l = look_new(r);
    for (size_t cell = from * GROUP; cell < to * GROUP && cell + 1 < r->first.n; cell++) {
        struct access access = {0};
        enum part_class last = COVERAGE_OUT_OF_REACH;
        int failures = 0;
        for (size_t k = r->first.item[cell]; k < r->first.item[cell + 1]; k++) {
            size_t i = r->order.item[k];
            bool under = r->under && r->under[i];
            enum part_class found = COVERAGE_OUT_OF_REACH;
            if (!under && (failures < FAILURES || r->options->left_only))
                last = found = class_of(&l, i, &access);
            else if (!under)
                found = last;
            failures += !under && is_failure(r, found) && !access.known;
            r->of[i] = (unsigned char)found;
        }
    }
    look_free(&l);
}

/* ---- all */

/* The area that a point stands for, which its neighbours share by the circle that they reach, and
 * its side */
static void measure_areas(void *context, size_t from, size_t to)
{
    struct reach *r = context;
    for (size_t i = from; i < to; i++) {
        size_t index[BESIDE];
        double distance2[BESIDE];
        size_t n = kdtree_nearest(r->tree, r->point[i], BESIDE, index, distance2);
        r->area[i] = n > 1 ? PI * distance2[n - 1] / ((double)n - 1) : 0;
        struct vec3 near[NEAR];
        r->up[i] = upper_normal(near, points_about(r, i, near)).z > FACES_UP;
    }
}

static void find_roofs(struct reach *r)
{
    struct vec3s roof = {0};
    for (size_t i = 0; i < r->n; i++)
        if (r->up[i])
            *array_push(&roof) = r->point[i];
    r->roof_tree = kdtree_new(roof.item, roof.n);
    array_free(&roof);
}

/* Heights of walls over points that are farther than any ball reaches which touches one of those
 * asked for: below zero. */
static void leave_out_far(const struct reach *r, double *height)
{
    double far = 2 * r->options->radius, top = box_around(r->point, r->n).high.z;
    struct vec3s asked = {0};

    for (size_t k = 0; k < r->order.n; k++) {
        size_t i = r->order.item[k];
        far = fmax(far, 2 * r->options->radius + r->options->limit + CORNER * sqrt(r->area[i]));
        *array_push(&asked) = r->point[i];
    }
    struct kdtree *tree = kdtree_new_by(asked.item, asked.n, r->options->threads);
    for (size_t i = 0; i < r->n; i++)
        height[i] =
            kdtree_any_beside(tree, r->point[i], vec(r->point[i].x, r->point[i].y, top), far) ? 0
                                                                                              : -1;
    kdtree_free(tree);
    array_free(&asked);
}

/* Columns over the feet of walls that may stand there. */
static void find_walls(struct reach *r)
{
    const double gap = COLUMN * r->options->radius;
    double *spacing = mem_alloc(r->n, sizeof *spacing), *height = mem_alloc(r->n, sizeof *height);

    for (size_t i = 0; i < r->n; i++)
        spacing[i] = sqrt(r->area[i]);
    if (!r->options->whole) {
        leave_out_far(r, height);
        unseen_wall_find(r->point, spacing, r->n, r->tree, r->options->threads, height);
    }
    for (size_t i = 0; i < r->n; i++) {
        double parts = ceil(height[i] / gap);
        for (double k = 1; k <= parts; k++)
            *array_push(&r->wall) = vec_along(r->point[i], k / parts * height[i], vec(0, 0, 1));
    }
    r->wall_tree = kdtree_new_by(r->wall.item, r->wall.n, r->options->threads);
    free(spacing);
    free(height);
}

static void sum_up(const struct reach *r, struct part_coverage *coverage)
{
    for (size_t i = 0; i < r->n; i++) {
        struct part_coverage_sum *sum = &coverage->sum[r->of[i]];
        sum->points++;
        sum->area += r->area[i];
        if (sum->points == 1 || r->deviation[i] > sum->worst) {
            sum->worst = r->deviation[i];
            sum->at = i;
        }
    }
}

void part_coverage_run(const struct vec3 *point, const double *deviation,
                       const unsigned char *under, size_t n,
                       const struct part_coverage_options *options, struct part_coverage *coverage)
{
    struct reach r = {point, deviation, under, n, options, .tree = NULL};
    *coverage = (struct part_coverage){.of = mem_alloc(n, 1)};
    if (n == 0)
        return;
    struct box box = box_around(point, n);
    r.of = coverage->of;
    r.area = mem_alloc(n, sizeof *r.area);
    r.up = mem_alloc(n, sizeof *r.up);
    r.tree = kdtree_new(point, n);
    r.far = vec_distance(box.low, box.high) + 4 * options->radius;
    for (int k = 0; k < BALLS; k++)
        r.ball[k] = spread(k, BALLS);
    add_solid(&r);
    thin_points(&r);
    r.sparse_tree = kdtree_new(r.sparse.item, r.sparse.n);
    sort_into_cells(&r);
    parallel_for(options->threads, n, measure_areas, &r);
    find_roofs(&r);
    find_walls(&r);
    parallel_for(options->threads, (r.first.n + GROUP - 1) / GROUP, look_at_cells, &r);
    sum_up(&r, coverage);
    kdtree_free(r.tree);
    kdtree_free(r.solid_tree);
    kdtree_free(r.sparse_tree);
    kdtree_free(r.roof_tree);
    kdtree_free(r.wall_tree);
    free(r.up);
    array_free(&r.solid);
    array_free(&r.wall);
    array_free(&r.sparse);
    array_free(&r.order);
    array_free(&r.first);
    free(r.area);
}

void part_coverage_free(struct part_coverage *coverage)
{
    free(coverage->of);
    *coverage = (struct part_coverage){0};
}
