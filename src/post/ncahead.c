/* ncahead - see ncahead.h. */
#include "ncahead.h"

#include <stdlib.h>

#include "post_ik.h"

enum { DEPTH = 12, SPAN_PIECES = 8, HALVINGS = 45, PLACES_MAX = 10000000 };

static void add(struct nc_ahead *ahead, struct pose at, double s, bool may_turn)
{
    const struct nc_step *step = ahead->step;
    struct ik_plan_place place = {.axis = at.a, .may_turn = may_turn};
    if (vec_dot(at.p, at.p) >= step->within * step->within) {
        struct chain_solutions found = chain_angles(&step->machine->chain, at.a);
        for (int k = 0; k < found.n && !found.free; k++)
            place.shut[k] = nc_linear_over(step, at.p, found.q[k]) >= 0;
    }
    *array_push(ahead) = place;
    *array_push(&ahead->s) = s;
}

/* Where between two places, by one of the solutions, an axis comes to an end of its travel; s0: it
 * does not. */
static double end_between(const struct kinematic_chain *chain, const struct motion *motion,
                          double s0, double s1, const struct chain_solutions *a,
                          const struct chain_solutions *b, int solution)
{
    double low = s0, high = s1, share;
    if (!ik_branch_end(chain, a, b, solution, &share))
        return s0;
    for (int i = 0; i < HALVINGS; i++) { /* before the end, by less than the last digit */
        double mid = (low + high) / 2;
        struct chain_solutions at = chain_angles(chain, motion_at(motion, mid).a);
        *(ik_branch_end(chain, a, &at, solution, &share) ? &high : &low) = mid;
    }
    return low;
}

/* A place of its own there: the tool may turn, though rather at the end of a motion. */
static void add_ends(struct nc_ahead *ahead, const struct kinematic_chain *chain,
                     const struct motion *motion, double s0, double s1)
{
    struct chain_solutions a = ahead->found, b = chain_angles(chain, motion_at(motion, s1).a);
    double end[2];
    for (int k = 0; k < 2; k++)
        end[k] = end_between(chain, motion, s0, s1, &a, &b, k);
    for (int i = 0; i < 2; i++) {
        double s = i ? fmax(end[0], end[1]) : fmin(end[0], end[1]);
        if (s <= s0)
            continue;
        add(ahead, motion_at(motion, s), s, true);
        ahead->item[ahead->n - 1].inside = true;
        s0 = s;
    }
    ahead->found = b;
}

/* Places of a motion behind s0, where the direction is a0, up to s1. */
static void sample(struct nc_ahead *ahead, const struct kinematic_chain *chain,
                   const struct motion *motion, double s0, struct vec3 a0, double s1, int depth)
{
    struct pose to = motion_at(motion, s1);
    double step = fmin(ik_branch_step(chain, a0), ik_branch_step(chain, to.a));
    if (vec_angle(a0, to.a) <= step || depth == DEPTH || ahead->n > PLACES_MAX) {
        add_ends(ahead, chain, motion, s0, s1);
        add(ahead, to, s1, false);
        return;
    }
    double mid = (s0 + s1) / 2;
    sample(ahead, chain, motion, s0, a0, mid, depth + 1);
    sample(ahead, chain, motion, mid, motion_at(motion, mid).a, s1, depth + 1);
}

/* Within twice what the tool axis may be off, it may go past the singular direction in one block.
 */
static void add_leap(struct nc_ahead *ahead, const struct motion *motion, size_t start)
{
    const struct rotary *first = &ahead->step->machine->chain.rotary[0];
    double near = 2 * ahead->step->allowed.axis;
    bool past = false;
    for (size_t i = start + 1; i + 1 < ahead->n && !past; i++) {
        struct vec3 off = vec_cross(first->axis, ahead->item[i].axis);
        past = vec_dot(off, off) < near * near;
    }
    if (!past || motion->kind != MOTION_LINE || ahead->step->machine->chain.n != 2)
        return;
    ahead->item[ahead->n - 1].leap = (unsigned)(ahead->n - 1 - start);
    *array_push(&ahead->leap) = (struct nc_leap){ahead->n - 1, motion_at(motion, 0), motion->to};
}

static void sample_motion(struct nc_ahead *ahead, const struct kinematic_chain *chain,
                          const struct motion *motion)
{
    double s = 0;
    struct vec3 a = motion_at(motion, 0).a;
    size_t start = ahead->n - 1;
    ahead->found = chain_angles(chain, a);
    while (s < 1) {
        double from = s, next = motion_next_knot(motion, s);
        int pieces = motion->kind == MOTION_SPLINE ? SPAN_PIECES : 1;
        for (int i = 1; i <= pieces; i++) {
            double to = from + (next - from) * i / pieces;
            sample(ahead, chain, motion, s, a, to, 0);
            a = ahead->item[ahead->n - 1].axis;
            s = to;
        }
        s = next;
    }
    ahead->item[ahead->n - 1].may_turn = true;
    if (ahead->n > start + 2)
        add_leap(ahead, motion, start);
}

/* May a block lead from one end of a leap to the other? */
static bool leaps(const void *with, size_t from, size_t to, const double q0[], const double q1[])
{
    const struct nc_ahead *ahead = with;
    const struct nc_step *step = ahead->step;
    size_t low = 0, high = ahead->leap.n - 1;
    (void)from; /* told by where it leads to */
    while (low < high) {
        size_t mid = (low + high) / 2;
        if (ahead->leap.item[mid].end < to)
            low = mid + 1;
        else
            high = mid;
    }
    const struct nc_leap *leap = &ahead->leap.item[low];
    struct motion motion = motion_line(leap->from, leap->to);
    struct machine_pose a = nc_station(step, leap->from, q0), b = nc_station(step, leap->to, q1);
    return pose_deviation_within(interpolation_block(&step->follow, &a.at, &b.at, &motion, 0, 1),
                                 step->allowed);
}

static void sample_items(struct nc_ahead *ahead, size_t from, size_t to)
{
    const struct nc_step *step = ahead->step;
    const struct path *path = step->path;
    bool cutting = false, begun = step->state.begun;
    struct pose pose = step->state.pose;
    if (begun)
        add(ahead, pose, 1, true);
    for (size_t i = from; i < to && ahead->n < PLACES_MAX; i++) {
        const struct path_item *item = &path->item.item[i];
        bool moves =
            item->kind == PATH_POINT || item->kind == PATH_ARC || item->kind == PATH_SPLINE;
        *array_push(&ahead->start) = ahead->n ? ahead->n - 1 : 0;
        if (!moves)
            continue;
        cutting = cutting || !item->rapid || item->kind != PATH_POINT;
        if (!cutting || !begun) { /* in the clear: only where it leads to matters */
            ahead->n = ahead->s.n = 0;
            add(ahead, item->to, 1, true);
        } else {
            struct motion motion = path_item_motion(path, item, pose);
            sample_motion(ahead, &step->machine->chain, &motion);
        }
        pose = item->to;
        begun = true;
    }
    *array_push(&ahead->start) = ahead->n ? ahead->n - 1 : 0;
}

bool nc_ahead_make(struct nc_ahead *ahead, const struct nc_step *step, size_t from, size_t to)
{
    *ahead = (struct nc_ahead){.step = step};
    if (step->follow.mode == INTERPOLATE_VECTOR || step->machine->chain.n == 0)
        return false;
    sample_items(ahead, from, to);
    struct ik_plan plan = {.chain = &step->machine->chain,
                           .cone = step->allowed.axis / 2,
                           .leaps = leaps,
                           .with = ahead};
    return ahead->n > 1 && ahead->n < PLACES_MAX &&
           ik_plan_make(&plan, ahead->item, ahead->n, step->state.at.q, &ahead->cost) == 0;
}

void nc_ahead_free(struct nc_ahead *ahead)
{
    array_free(&ahead->leap);
    array_free(&ahead->start);
    array_free(&ahead->s);
    array_free(ahead);
}
