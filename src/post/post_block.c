/* post_block - see post_block.h. */
#include "post_block.h"

#include "base/array.h"
#include "base/num.h"
#include "math/elementary.h"
#include "post_ik.h"
#include "post_way.h"

struct nc_move *post_block_append(struct nc_planner *planner, enum nc_kind kind,
                                  const struct machine_pose *target)
{
    const struct block_pose *to = &target->at;
    struct nc_plan *plan = planner->plan;
    struct nc_state *state = &planner->state;
    struct nc_move *move = array_push_inline(&plan->move);
    *move = (struct nc_move){.kind = kind,
                             .why = state->why,
                             .line = state->line,
                             .p = to->p,
                             .q = {to->q[0], to->q[1]}};
    if (planner->follow.mode == INTERPOLATE_VECTOR) {
        move->vector = (unsigned)plan->vector.n;
        *array_push_inline(&plan->vector) = to->a;
    }
    if (state->begun && !state->over.is && (kind == NC_RAPID || kind == NC_LINE) &&
        !post_way_is_safe(planner, &state->at, to))
        state->over = post_way_over(planner, &state->at, to);
    state->at = *to;
    state->turned = target->turned;
    state->off.point = state->off.axis = NAN;
    planner->off_part = false;
    return move;
}

void post_block_add(struct nc_planner *planner, enum nc_kind kind,
                    const struct machine_pose *target, double length, size_t index,
                    const struct nc_along *along)
{
    struct nc_total *total = &planner->plan->total;
    double minutes, feed = 0;
    if (kind == NC_RAPID) {
        minutes = post_feed_axes_minutes(planner, &planner->state.at, &target->at);
        minutes = larger(minutes, length / planner->machine->rapid[MACHINE_X]);
        total->rapid += length;
        total->rapids++;
    } else {
        feed = post_feed_word(planner, target, length, along, &minutes);
        total->cut += length;
        total->lines += kind == NC_LINE;
        total->arcs += kind == NC_ARC;
        total->splines += kind == NC_SPLINE;
    }
    total->minutes += minutes;
    struct nc_move *move = post_block_append(planner, kind, target);
    move->feed = feed;
    move->index = (unsigned)index;
}

/* Both say the same; of vectors with the tip at rest no more than the last digit may differ: a path
 * that is read and written again says one direction in two ways. */
static bool says_the_same(const struct nc_planner *planner, const struct block_pose *to)
{
    const struct block_pose *at = &planner->state.at;
    if (at->p.x != to->p.x || at->p.y != to->p.y || at->p.z != to->p.z)
        return false;
    if (planner->follow.mode == INTERPOLATE_VECTOR)
        return vec_distance(at->a, to->a) < 2 / num_ten[planner->plan->ability.digits.vector];
    return at->q[0] == to->q[0] && at->q[1] == to->q[1];
}

/* Of a path that stays where it is one place is rounded in two ways: half a last digit goes up or
 * down as what comes after it is, which differs where a curve ends and its end is named again. */
static bool is_rounded_apart(const struct nc_planner *planner, const struct block_pose *to,
                             const struct pose *goal)
{
    const double along = 1e-7; /* of a direction: a path's last digits are more */
    const struct machine_digits *digits = &planner->plan->ability.digits;
    const struct block_pose *at = &planner->state.at;
    double last = 1.5 / num_ten[digits->linear], turn = RADIANS(1.5 / num_ten[digits->angle]);

    if (vec_distance(planner->state.pose.a, goal->a) > along ||
        fmax(fabs(at->p.x - to->p.x), fabs(at->p.y - to->p.y)) > last ||
        fabs(at->p.z - to->p.z) > last)
        return false;
    if (planner->follow.mode == INTERPOLATE_VECTOR)
        return vec_distance(at->a, to->a) < 2 / num_ten[digits->vector];
    return fabs(at->q[0] - to->q[0]) < turn && fabs(at->q[1] - to->q[1]) < turn;
}

void post_block_straight(struct nc_planner *planner, enum nc_kind kind,
                         const struct machine_pose *to, const struct pose *goal)
{
    const double same = 1e-9; /* mm: the path stays */
    struct nc_state *state = &planner->state;
    double way = vec_distance(state->pose.p, goal->p);
    if (!says_the_same(planner, &to->at) &&
        (way > same || !is_rounded_apart(planner, &to->at, goal)))
        post_block_add(planner, kind, to, way, 0, NULL);
    state->off.point = state->off.axis = NAN;
    state->pose = *goal;
}

/* The rotary axes turn to q in n blocks alike, the tip at rest. */
void post_block_stand(struct nc_planner *planner, enum nc_kind kind, const double q[], int n)
{
    double from[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    for (int k = 1; k <= n; k++) {
        double part[ROTARY_MAX];
        for (int i = 0; i < ROTARY_MAX; i++)
            part[i] = from[i] + (q[i] - from[i]) * k / n;
        struct machine_pose to = post_ik_pose(planner, planner->state.pose, part);
        post_block_add(planner, kind, &to, 0, 0, NULL);
    }
}

void post_block_turn(struct nc_planner *planner, const double q[])
{
    double from[ROTARY_MAX] = {planner->state.at.q[0], planner->state.at.q[1]};
    double far = DEGREES(ik_most_turn(&planner->machine->chain, q, from));
    int n = planner->follow.mode == INTERPOLATE_JOINT ? (int)ceil(far / POST_BLOCK_TURN) : 1;
    post_block_stand(planner, NC_RAPID, q, n);
}
