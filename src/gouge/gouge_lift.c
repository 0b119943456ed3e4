/*
 * gouge_lift - see gouge_lift.h.
 *
 * First single points are lifted, and those between two of them that straight lines need; then the
 * points of a run are put together with what leads over jumps of the lift.
 */
#include "gouge/gouge_lift.h"

#include <stdlib.h>

#include "gouge/gouge.h"

#include "lift_place.h"
#include "smooth_aside.h"
#include "smooth_normals.h"

enum { HALVINGS = 20 }; /* of a jump of the lift, at most */

static const double SPECK = 0.5; /* of the radius: from end to end */

static const struct vec3 UP = {0, 0, 1};

/* A point with what became of it. */
struct lifted_point {
    struct run_point p;   /* its normal as it was */
    struct vec3 touching; /* the centre before the lift */
    bool unreachable; /* no lift within the limit clears it, or no tool from outside comes to it: it
                         is straight up in z as far as it takes */
    struct kdtree_touch touch; /* what stopped the ball */
};

struct lifted_points {
    size_t n, cap;
    struct lifted_point *item;
};

static void place_lifted(struct run_point *p, struct vec3 touching, double lift,
                         const struct gouge_lift_options *rule, double radius)
{
    lift_place_along(p, vec_along(touching, lift, p->normal), rule, radius);
}

/* The tool can come here, where it is clear, from outside: straight down, along its axis or, where
 * that may be another, anyhow. */
static bool is_open(const struct run_point *p, const struct gouge_lift_options *rule)
{
    double within = rule->offset - rule->tolerance;

    if (gouge_free_above(rule->guard, p->ball, within) ||
        (p->axis.z >= 0 && p->axis.z < 1 &&
         gouge_open(rule->guard, p->ball, p->axis, rule->offset, rule->tolerance)))
        return true;
    return rule->axis.kind != AXIS_FIXED &&
           gouge_open_anyhow(rule->guard, p->ball, p->normal, rule->offset, rule->tolerance, NULL);
}

/* How far the ball goes from `touching` along the normal until it touches, from above: negative,
 * down by at most rule->sink, where the points that the contact stands for lie under it.  Below the
 * sink nothing is known: there it stays.  Negative and unclear: -HUGE_VAL, no lift within the limit
 * clears it. */
static double find_lift(struct vec3 touching, struct vec3 normal,
                        const struct gouge_lift_options *rule, struct kdtree_touch *touch)
{
    const struct gouge_check *guard = rule->guard;
    struct kdtree_touch likely = *touch;
    struct vec3 sunk = vec_along(touching, -rule->sink, normal);
    double limit = rule->sink + rule->limit;

    if (rule->sink > 0) {
        double h = gouge_least_lift(guard, sunk, normal, rule->offset, limit, touch);
        struct vec3 at = vec_along(sunk, h, normal);
        if (h >= rule->sink ||
            (h > 0 && gouge_clear_along(guard, at, touching, rule->offset, 2e-6)))
            return h - rule->sink;
        *touch = likely;
    }
    double lift = gouge_least_lift(guard, touching, normal, rule->offset, rule->limit, touch);
    return lift < 0 ? -HUGE_VAL : lift;
}

/* A contact point with its normal, lifted.  `touch`: guard points likely to be in its way. */
static struct lifted_point lift_point(const struct run_point *p, const struct kdtree_touch *touch,
                                      const struct gouge_lift_options *rule, double radius)
{
    struct lifted_point l = {
        .p = *p, .touching = vec_along(p->contact, rule->offset, p->normal), .touch = *touch};
    double lift = 0;

    if (rule->guard)
        lift = find_lift(l.touching, p->normal, rule, &l.touch);
    bool blocked = lift == -HUGE_VAL;
    place_lifted(&l.p, l.touching, blocked ? 0 : lift, rule, radius);
    if (lift < 0 && !blocked)
        l.p.contact = vec_along(l.p.contact, lift, l.p.normal);
    l.unreachable = rule->guard && (blocked || !is_open(&l.p, rule));
    if (l.unreachable) {
        double rise = gouge_rise(rule->guard, l.touching, UP, rule->offset);
        lift_place(&l.p, vec_along(l.touching, rise, UP), rule, radius);
    }
    return l;
}

/* Half way between two points, not lifted. */
static struct run_point halfway_point(const struct lifted_point *a, const struct lifted_point *b,
                                      const struct gouge_lift_options *rule)
{
    struct run_point p = {.normal = vec_unit(vec_add(a->p.normal, b->p.normal))};

    if (vec_length(p.normal) == 0) /* there is no middle */
        p.normal = a->p.normal;
    p.contact = vec_along(vec_mix(a->touching, b->touching, 0.5), -rule->offset, p.normal);
    return p;
}

/* What is likely to stop a ball between two. */
static struct kdtree_touch touch_of(const struct lifted_point *a, const struct lifted_point *b)
{
    struct kdtree_touch both = a->touch;

    if (b->touch.n > 0)
        both.p[both.n++] = b->touch.p[0];
    return both;
}

/* Half way between two, lifted itself. */
static struct lifted_point lift_halfway(const struct lifted_point *a, const struct lifted_point *b,
                                        const struct gouge_lift_options *rule, double radius)
{
    struct run_point p = halfway_point(a, b, rule);
    struct kdtree_touch touch = touch_of(a, b);

    return lift_point(&p, &touch, rule, radius);
}

/* True if nothing comes between them, for where they would touch they are nearer than two steps. */
static bool are_close(const struct lifted_point *a, const struct lifted_point *b,
                      const struct gouge_lift_options *rule)
{
    /* Told by where they would touch, for the lift may jump. */
    return vec_distance(a->touching, b->touching) < 2 * rule->step;
}

static bool on_line(const struct run_point *p, const struct lifted_point *a,
                    const struct lifted_point *b, const struct gouge_lift_options *rule)
{
    return vec_line_distance(a->p.ball, b->p.ball, p->ball) <= rule->tolerance &&
           vec_line_distance(a->p.tip, b->p.tip, p->tip) <= rule->tolerance;
}

/* Appends the points between a and b that straight lines need, to stay within the tolerance of what
 * is lifted half way, or under it where the ball is clear there.  Where what stops the ball at both
 * ends holds it on the line, and the line is clear, more of the part would only lift it. */
static void add_between(const struct lifted_point *a, const struct lifted_point *b,
                        const struct gouge_lift_options *rule, double radius,
                        struct lifted_points *to)
{
    if (are_close(a, b, rule))
        return;
    struct run_point between = halfway_point(a, b, rule), least = between;
    struct kdtree_touch touch = touch_of(a, b);
    struct vec3 touching = vec_along(between.contact, rule->offset, between.normal);
    struct vec3 sunk = vec_along(touching, touch.n > 0 ? -rule->sink : 0, between.normal);
    double lift = kdtree_leave_these(&touch, sunk, between.normal, rule->offset) -
                  vec_distance(sunk, touching);
    place_lifted(&least, touching, lift, rule, radius);
    bool clear = lift_line_clear(&a->p, &b->p, rule);
    if (clear && !a->unreachable && !b->unreachable && on_line(&least, a, b, rule))
        return;
    struct lifted_point l = lift_point(&between, &touch, rule, radius);
    if (clear && on_line(&l.p, a, b, rule))
        return;
    add_between(a, &l, rule, radius, to);
    *array_push(to) = l;
    add_between(&l, b, rule, radius, to);
}

void gouge_lift_contact(struct run *run, const struct gouge_lift_options *rule, struct vec3 contact,
                        struct vec3 normal)
{
    struct run_point p = {.contact = contact, .normal = normal, .given = true};

    lift_place(&p, vec_along(contact, rule->offset, normal), rule, run->radius);
    *array_push(run) = p;
}

/* Notes what may stay uncut under a ball that touches elsewhere. */
static void check_uncut(const struct lifted_point *l, const struct gouge_lift_options *rule,
                        struct lifted_strip *to)
{
    double half = rule->offset / 2;
    struct vec3 lower = vec_along(l->p.ball, -half, l->p.normal);
    double height = gouge_distance(rule->guard, lower, vec_distance(lower, l->touch.p[0])) - half;

    if (height > rule->uncut)
        *array_push(&to->uncut) = (struct uncut){l->p.contact, height};
}

/* Appends a lifted point to the run, and to the report. */
static void add_point(struct lifted_strip *to, const struct lifted_point *l,
                      const struct gouge_lift_options *rule)
{
    struct gouge_lift_report *report = &to->report;
    struct run_point p = l->p;
    double lift = l->unreachable ? vec_distance(p.ball, l->touching)
                                 : vec_dot(vec_sub(p.ball, l->touching), p.normal);

    report->points++;
    if (l->unreachable) {
        p.normal = vec(0, 0, 0);
        report->unreachable++;
        if (lift > report->unreachable_by) {
            report->unreachable_by = lift;
            report->unreachable_at = p.contact;
        }
    } else if (lift > 1e-6) {
        report->lifted++;
        if (lift > report->highest) {
            report->highest = lift;
            report->highest_at = p.contact;
        }
        if (lift > rule->uncut)
            check_uncut(l, rule, to);
    }
    *array_push(&to->run) = p;
}

/* A jump of the lift: the centres are that much further apart than the points they belong to. */
static bool lift_jumps(const struct lifted_point *a, const struct lifted_point *b,
                       const struct gouge_lift_options *rule)
{
    double apart = vec_distance(a->p.ball, b->p.ball);

    return apart > 4 * vec_distance(a->touching, b->touching) + 2 * rule->step;
}

/* The centre half way between two, out of what is there: straight up, or where that is nearer along
 * what they touch, for up may lead over all that hangs there. */
static struct vec3 over_middle(const struct run_point *a, const struct run_point *b,
                               const struct gouge_lift_options *rule)
{
    struct vec3 middle = vec_mix(a->ball, b->ball, 0.5);
    struct vec3 normal = vec_unit(vec_add(a->normal, b->normal));
    double rise = gouge_rise(rule->guard, middle, UP, rule->offset);

    if (rise > 0 && vec_length(normal) > 0) {
        double lift = gouge_least_lift(rule->guard, middle, normal, rule->offset,
                                       fmin(rise, rule->limit), NULL);
        if (lift >= 0 && lift < rise)
            return vec_along(middle, lift, normal);
    }
    return vec_along(middle, rise, UP);
}

/* From one side of a jump to the other, over what is between; false when that is in the way too,
 * as under an overhang. */
static bool bridge(const struct run_point *a, const struct run_point *b, int halvings,
                   const struct gouge_lift_options *rule, struct run *dense)
{
    if (halvings < HALVINGS && lift_line_clear(a, b, rule))
        return true;
    if (halvings == 0)
        return false;
    struct run_point p = {.axis = vec_slerp(a->axis, b->axis, 0.5)};
    p.ball = over_middle(a, b, rule);
    p.tip = vec_along(p.ball, -dense->radius, p.axis);
    if (!bridge(a, &p, halvings - 1, rule, dense))
        return false;
    *array_push(dense) = p;
    return bridge(&p, b, halvings - 1, rule, dense);
}

/* The same, or where there is no way the end of the piece. */
static void bridge_or_end(const struct lifted_point *a, const struct lifted_point *b,
                          const struct gouge_lift_options *rule, struct lifted_strip *to)
{
    size_t n = to->run.n;

    if (bridge(&a->p, &b->p, HALVINGS, rule, &to->run))
        return;
    to->run.n = n;
    *array_push(&to->end) = n;
}

/* Between nodes alone only what the ball can't reach is bridged, for nobody looked between. */
static bool needs_bridge(const struct lifted_point *a, const struct lifted_point *b,
                         const struct gouge_lift_options *rule)
{
    if (!rule->guard)
        return false;
    if (rule->between && lift_jumps(a, b, rule))
        return true;
    return (rule->between || a->unreachable || b->unreachable) &&
           !lift_line_clear(&a->p, &b->p, rule);
}

/* Puts the points into the run, with what the tool needs to get over jumps between them. */
static void add_points(struct lifted_strip *to, const struct lifted_points *points,
                       const struct gouge_lift_options *rule)
{
    for (size_t i = 0; i < points->n; i++) {
        const struct lifted_point *l = &points->item[i];
        if (i > 0 && needs_bridge(l - 1, l, rule))
            bridge_or_end(l - 1, l, rule, to);
        add_point(to, l, rule);
    }
    *array_push(&to->end) = to->run.n;
}

/* How far a cubic with these tangents leaves the straight line between its ends, at most. */
static double cubic_sagitta(const struct lifted_point *a, struct vec3 ta,
                            const struct lifted_point *b, struct vec3 tb)
{
    struct vec3 chord = vec_sub(b->p.ball, a->p.ball);
    double length = vec_length(chord);
    struct vec3 along = vec_unit(chord);

    return 4 / 27.0 * length *
           (vec_length(vec_reject(ta, along)) + vec_length(vec_reject(tb, along)));
}

/*
 * A smooth curve through the points, as a fitter sees it, swings where long intervals meet short
 * ones at a kink of the lift.  Appends all points of `from` to `to`, and one half way where it
 * would leave the straight line by more than the tolerance; true when there was one.
 */
static bool refine(const struct lifted_points *from, const struct gouge_lift_options *rule,
                   double radius, struct lifted_points *to)
{
    struct run run = {.radius = radius};
    struct vec3 *tangent = mem_alloc(from->n, sizeof *tangent);

    for (size_t i = 0; i < from->n; i++)
        *array_push(&run) = from->item[i].p;
    run_tangents(&run, false, tangent);
    for (size_t i = 0; i < from->n; i++) {
        const struct lifted_point *l = &from->item[i];
        if (i > 0 && !are_close(l - 1, l, rule) &&
            cubic_sagitta(l - 1, tangent[i - 1], l, tangent[i]) > rule->tolerance)
            *array_push(to) = lift_halfway(l - 1, l, rule, radius);
        *array_push(to) = *l;
    }
    array_free(&run);
    free(tangent);
    return to->n > from->n;
}

static void lift_smooth(const struct run *run, const struct gouge_lift_options *rule,
                        struct lifted_points *points)
{
    struct run smooth = {.radius = run->radius};
    struct lifted_point before = {.unreachable = false};
    bool more = true;

    /* Half of the tolerance for the curve, the rest for the lift. */
    run_densify(run, rule->tolerance / 2, &smooth);
    for (size_t i = 0; i < smooth.n; i++) {
        struct lifted_point l = lift_point(&smooth.item[i], &before.touch, rule, run->radius);
        if (i > 0)
            add_between(&before, &l, rule, run->radius, points);
        *array_push(points) = before = l;
    }
    array_free(&smooth);
    while (more) {
        struct lifted_points finer = {0};
        more = refine(points, rule, run->radius, &finer);
        array_free(points);
        *points = finer;
    }
}

/* Points that follow each other with no jump and no other way between. */
struct smooth_piece {
    struct lifted_point *item;
    size_t n;
};

/* Points that have moved, and from which or to which the way is not clear, are as they were. */
static void put_back(struct smooth_piece piece, const struct lifted_point *was,
                     const struct gouge_lift_options *rule)
{
    struct lifted_point *l = piece.item;

    /* From the end, so that what is put back is looked at again with the one before it. */
    for (bool back = true; back;) {
        back = false;
        for (size_t i = piece.n - 1; i > 0; i--) {
            bool moved = vec_distance(l[i].p.ball, was[i].p.ball) > 0 ||
                         vec_distance(l[i - 1].p.ball, was[i - 1].p.ball) > 0;
            if (!moved || lift_line_clear(&l[i - 1].p, &l[i].p, rule))
                continue;
            l[i] = was[i];
            l[i - 1] = was[i - 1];
            back = true;
        }
    }
}

/* Across the way of the balls and the surface's normal at each point: a ball that touches is moved
 * there along what it touches. */
static struct vec3 *sides_of(struct smooth_piece piece)
{
    struct vec3 *side = mem_alloc(piece.n, sizeof *side);

    for (size_t i = 1; i + 1 < piece.n; i++)
        side[i] = vec_unit(vec_cross(piece.item[i].p.normal,
                                     vec_sub(piece.item[i + 1].p.ball, piece.item[i - 1].p.ball)));
    return side;
}

/* Moves them sideways to where they run more smoothly, and lifts them anew there. */
static void straighten_piece(struct smooth_piece piece, const struct gouge_lift_options *rule,
                             double radius)
{
    size_t n = piece.n;
    struct vec3 *point = mem_alloc(n, sizeof *point), *side = sides_of(piece);
    double *move = mem_alloc(n, sizeof *move);
    struct lifted_point *was = mem_alloc(n, sizeof *was);

    for (size_t i = 0; i < n; i++) {
        was[i] = piece.item[i];
        point[i] = was[i].p.ball;
    }
    smooth_aside(point, side, rule->offset / 2, rule->aside, n, move);
    for (size_t i = 0; i < n; i++) {
        struct run_point p = was[i].p;
        if (fabs(move[i]) < 1e-6)
            continue;
        p.contact = vec_along(was[i].touching, -rule->offset, p.normal);
        p.contact = vec_along(p.contact, move[i], side[i]);
        struct lifted_point l = lift_point(&p, &was[i].touch, rule, radius);
        if (!l.unreachable && vec_distance(l.p.ball, point[i]) < 2 * rule->aside)
            piece.item[i] = l;
    }
    put_back(piece, was, rule);
    free(was);
    free(move);
    free(side);
    free(point);
}

static bool follows(const struct lifted_point *a, const struct lifted_point *b,
                    const struct gouge_lift_options *rule)
{
    return !a->unreachable && !b->unreachable && !lift_jumps(a, b, rule) &&
           lift_line_clear(&a->p, &b->p, rule);
}

static void straighten_points(struct lifted_points *points, const struct gouge_lift_options *rule,
                              double radius)
{
    for (size_t from = 0, to; from < points->n; from = to) {
        for (to = from + 1;
             to < points->n && follows(&points->item[to - 1], &points->item[to], rule);)
            to++;
        struct smooth_piece piece = {points->item + from, to - from};
        straighten_piece(piece, rule, radius);
    }
}

/* The next point that is reached, no further off than a ball that is not can be seen as a speck; or
 * the point itself. */
static size_t next_reached(const struct lifted_points *points, size_t i,
                           const struct gouge_lift_options *rule)
{
    const struct lifted_point *l = points->item;

    for (size_t k = i + 1;
         k < points->n && vec_distance(l[i].touching, l[k].touching) < SPECK * rule->offset; k++)
        if (!l[k].unreachable)
            return k;
    return i;
}

/* Leaves out places that are not reached between two that are, where the way past them is clear:
 * the ball would go up over all that stands there and down again for nothing. */
static void leave_specks(struct lifted_points *points, const struct gouge_lift_options *rule)
{
    struct lifted_point *l = points->item;
    size_t kept = 0;

    for (size_t i = 0, next; i < points->n; i = next) {
        size_t reached = l[i].unreachable ? i : next_reached(points, i, rule);
        bool past = reached > i + 1 && lift_line_clear(&l[i].p, &l[reached].p, rule);
        next = past ? reached : i + 1;
        l[kept++] = l[i];
    }
    points->n = kept;
}

/* The run with its normals averaged, and what follows from them. */
static struct run even_run(const struct run *run, const struct gouge_lift_options *rule)
{
    struct run even = {.radius = run->radius};

    for (size_t i = 0; i < run->n; i++)
        *array_push(&even) = run->item[i];
    smooth_normals(&even, rule->even);
    for (size_t i = 0; i < even.n; i++) {
        struct run_point *p = &even.item[i];
        lift_place(p, vec_along(p->contact, rule->offset, p->normal), rule, run->radius);
    }
    return even;
}

void gouge_lift_run(const struct run *run, const struct gouge_lift_options *rule,
                    struct lifted_strip *to)
{
    const struct kdtree_touch nothing = {.n = 0};
    struct lifted_points points = {0};

    if (rule->between && rule->guard && rule->even > 0) {
        struct run even = even_run(run, rule);
        lift_smooth(&even, rule, &points);
        array_free(&even);
    } else if (rule->between) {
        lift_smooth(run, rule, &points);
    }
    if (rule->between && rule->guard && rule->aside > 0)
        straighten_points(&points, rule, run->radius);
    for (size_t i = 0; !rule->between && i < run->n; i++)
        *array_push(&points) = lift_point(&run->item[i], &nothing, rule, run->radius);
    if (rule->between && rule->guard)
        leave_specks(&points, rule);
    add_points(to, &points, rule);
    array_free(&points);
}

void lifted_strip_free(struct lifted_strip *lifted)
{
    array_free(&lifted->run);
    array_free(&lifted->end);
    array_free(&lifted->uncut);
}
