/* post_plan - see post_plan.h. */
#include "post_plan.h"

#include <stdlib.h>

#include "base/num.h"
#include "post_ik.h"
#include "post_item.h"
#include "post_lookahead.h"

void nc_plan_free(struct nc_plan *plan)
{
    for (size_t i = 0; i < plan->spline.n; i++)
        nc_spline_free(&plan->spline.item[i]);
    array_free(&plan->move);
    array_free(&plan->vector);
    array_free(&plan->arc);
    array_free(&plan->spline);
    array_free(&plan->hole);
}

struct block_pose nc_plan_pose(const struct nc_plan *plan, const struct kinematic_chain *chain,
                               const struct nc_move *move)
{
    struct block_pose at = {.p = move->p, .q = {move->q[0], move->q[1]}};
    at.a = plan->ability.mode == INTERPOLATE_VECTOR ? plan->vector.item[move->vector]
                                                    : chain_axis(chain, move->q);
    return at;
}

/* The clearance plane or, where the path names none, its highest rapid. */
static double clear_height(const struct path *path)
{
    double z = path->head.clearance;
    for (size_t i = 0; i < path->item.n && isnan(path->head.clearance); i++)
        if (path_is_rapid(&path->item.item[i]))
            z = fmax(z, path->item.item[i].to.p.z);
    return z;
}

/* The travel to the last digit within it, so that no angle is beyond it once it is rounded. */
static void trim_travel(struct kinematic_chain *chain, int digits)
{
    const double slack = 1e-9;
    for (int i = 0; i < chain->n; i++) {
        struct rotary *r = &chain->rotary[i];
        double min = DEGREES(r->min) * num_ten[digits], max = DEGREES(r->max) * num_ten[digits];
        if (fabs(min) < 1e12 && fabs(max) < 1e12 && ceil(min - slack) <= floor(max + slack)) {
            r->min = RADIANS(ceil(min - slack) / num_ten[digits]);
            r->max = RADIANS(floor(max + slack) / num_ten[digits]);
        }
    }
}

int nc_plan_make(struct nc_plan *plan, const struct path *path, const struct machine *machine,
                 struct nc_ability ability, struct nc_plan_options options, struct error *error)
{
    *plan = (struct nc_plan){.ability = ability};
    struct nc_planner planner = {
        .path = path, .machine = machine, .plan = plan, .options = options, .error = error};
    if (path->head.track == TRACK_CONTACT)
        return error_set(error,
                         "%s: found a path of contact points (TRACK/CONTACT), expected one of tool "
                         "tips or ball centres",
                         path->name);
    struct machine own = *machine;
    trim_travel(&own.chain, ability.digits.angle);
    planner.machine = &own;
    planner.follow = (struct interpolation){.mode = ability.mode, .chain = &own.chain};
    planner.clearance = clear_height(path);
    array_reserve(&plan->move, path->item.n + path->item.n / 16); /* most are blocks as they are */
    planner.near = ik_near_table(&own.chain);
    planner.safe_radius = post_ik_safe_radius(machine);
    planner.state.faster = 1;
    planner.state.off = (struct pose_deviation){NAN, NAN};
    for (int i = 0; i < own.chain.n; i++) /* at zero, or as near as the travel lets them be */
        planner.state.at.q[i] = fmin(fmax(0, own.chain.rotary[i].min), own.chain.rotary[i].max);
    planner.state.turned = chain_turned(&machine->chain, planner.state.at.q);
    post_item_tool(&planner, path_ball(path));
    int result = 0;
    for (size_t from = 0; from < path->item.n && result == 0;) {
        size_t to = post_lookahead_end(path, from);
        result = post_lookahead_plan(&planner, from, to);
        from = to;
    }
    array_free(&planner.rewinds);
    if (result == 0 && !planner.state.begun)
        return error_set(error, "%s: found no motion, expected at least one GOTO", path->name);
    return result == 0 ? post_item_retract(&planner) : -1;
}
