/* post_way - see post_way.h. */
#include "post_way.h"

#include <string.h>

#include "base/num.h"
#include "math/elementary.h"
#include "post_ik.h"

enum { LOOKS = 12 /* on a way */, PLACES = 16 /* between a place and 0 */ };

/* The linear axes where they stand, with the tip there. */
static struct nc_over over_of(const struct nc_planner *planner, struct vec3 tip, struct vec3 linear)
{
    const double at[] = {linear.x, linear.y, linear.z};
    int axis = post_ik_out_of_travel(planner, at);
    return (struct nc_over){axis >= 0, axis, axis >= 0 ? at[axis] : 0, tip};
}

static struct nc_over over_at(const struct nc_planner *planner, struct vec3 tip, const double q[])
{
    if (vec_dot(tip, tip) < planner->safe_radius * planner->safe_radius)
        return (struct nc_over){.tip = tip};
    return over_of(planner, tip, chain_linear(&planner->machine->chain, tip, q));
}

/* The way is so short a turn that it bulges by less than half of a last digit. */
static bool hardly_turns(const struct nc_planner *planner, const struct block_pose *from,
                         const struct block_pose *to)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double turn = ik_most_turn(chain, from->q, to->q);
    double far = fmax(vec_length(from->p), vec_length(to->p));
    for (int i = 0; i < chain->n; i++)
        far += 2 * vec_length(chain->rotary[i].centre);
    return far * turn * turn < 2 / num_ten[planner->plan->ability.digits.linear];
}

/* In the mode in which the rotary axes turn in proportion, or by the vector that turns evenly. */
static struct nc_over over_between(const struct nc_planner *planner, enum interpolation_mode mode,
                                   const struct block_pose *from, const struct block_pose *to)
{
    const struct interpolation follow = {.mode = mode, .chain = &planner->machine->chain};
    struct nc_over over = {0};
    double q[ROTARY_MAX] = {from->q[0], from->q[1]};
    for (int i = 1; i < LOOKS && !over.is; i++) {
        double s = (double)i / LOOKS, next[ROTARY_MAX] = {0};
        struct pose at = interpolation_pose(&follow, from, to, s);
        if (mode == INTERPOLATE_VECTOR && post_ik_nearest(follow.chain, at.a, q, next))
            memcpy(q, next, sizeof q);
        for (int k = 0; k < ROTARY_MAX && mode != INTERPOLATE_VECTOR; k++)
            q[k] = from->q[k] + s * (to->q[k] - from->q[k]);
        over = over_at(planner, at.p, q);
    }
    return over.is ? over : over_at(planner, to->p, to->q);
}

struct nc_over post_way_over(const struct nc_planner *planner, const struct block_pose *from,
                             const struct block_pose *to)
{
    if (post_way_is_safe(planner, from, to))
        return (struct nc_over){0};
    if (planner->follow.mode == INTERPOLATE_JOINT) {
        struct nc_over over = over_of(planner, to->p, to->p);
        over.tip = over.is ? chain_tip(&planner->machine->chain, to->p, to->q) : to->p;
        return over;
    }
    if (hardly_turns(planner, from, to))
        return over_at(planner, to->p, to->q);
    return over_between(planner, planner->follow.mode, from, to);
}

/* To a place with the rotary axes at zero, or as near as their travel lets them be; there they
 * turn, in whichever way. */
static struct nc_over over_from_zero(const struct nc_planner *planner, const struct block_pose *to)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    struct block_pose zero = {.p = to->p};
    chain_zero(chain, zero.q);
    zero.a = chain_axis(chain, zero.q);
    struct nc_over over = over_at(planner, zero.p, zero.q);
    if (!over.is)
        over = over_between(planner, INTERPOLATE_ROTARY, &zero, to);
    if (!over.is && planner->follow.mode == INTERPOLATE_VECTOR)
        over = over_between(planner, INTERPOLATE_VECTOR, &zero, to);
    return over;
}

struct nc_over post_way_from_home(const struct nc_planner *planner, const struct block_pose *to,
                                  struct vec3 axis, struct block_pose *by)
{
    struct nc_over none = {0};
    *by = *to;
    if (!planner->plan->ability.tcp || planner->machine->tcp_frame != TCP_FRAME_ZERO ||
        planner->machine->chain.n == 0 || planner->follow.mode == INTERPOLATE_JOINT)
        return none;
    struct nc_over over = over_from_zero(planner, to);
    int digits = planner->plan->ability.digits.linear;
    double top = planner->plan->top - 0.5 / num_ten[digits] - 1e-6; /* as it is printed */
    if (!over.is || !(axis.z > 0) || !(to->p.z > top))
        return over;
    for (int i = PLACES - 1; i >= 0; i--) {
        double share = (double)i / PLACES;
        by->p = vec_round(vec(share * to->p.x, share * to->p.y, to->p.z), digits);
        if (!over_from_zero(planner, by).is)
            return none;
    }
    *by = *to;
    return over;
}

int post_way_tell(struct nc_planner *planner, const struct nc_over *over, const char *what)
{
    return post_ik_tell_over(planner, over->tip, over->axis, what, over->value);
}
