/* post_travel - see post_travel.h. */
#include "post_travel.h"

#include "machine/ik_bound.h"
#include "machine/ik_choose.h"

static const double worth = 0.01; /* of the travel of the rotary axes: what a second plan saves */

bool post_travel_saves(double travel, double than)
{
    return travel < than * (1 - worth);
}

double post_travel_since(const struct nc_planner *planner, const struct nc_group_start *since)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    const double weight[ROTARY_MAX] = {ik_weight(chain, 0), ik_weight(chain, 1)};
    const double *q = since->q;
    double way = 0;
    for (size_t i = since->moves; i < planner->plan->move.n; i++) {
        const struct nc_move *move = &planner->plan->move.item[i];
        if (!nc_moves(move))
            continue;
        double sum = 0; /* ik_travel */
        for (int k = 0; k < chain->n; k++)
            sum += weight[k] * fabs(q[k] - move->q[k]);
        way += sum;
        q = move->q;
    }
    return way;
}

/* Both solutions turn alike, whatever the way: two axes at right angles, and the tool across. */
static bool solutions_turn_alike(const struct kinematic_chain *chain)
{
    const struct rotary *r = chain->rotary;
    return fabs(vec_dot(r[0].axis, r[1].axis)) < 1e-9 &&
           fabs(vec_dot(r[1].axis, chain->tool)) < 1e-9;
}

/* From where the rapids have led to the axis nearest the work stays as it is: then the other one
 * turns by what the tool axis does, and no way is shorter. */
static bool first_axis_stays(const struct nc_planner *planner, const struct nc_group_start *since)
{
    const struct nc_move *last = NULL;
    for (size_t i = since->moves; i < planner->plan->move.n; i++) {
        const struct nc_move *move = &planner->plan->move.item[i];
        if (nc_moves(move) && move->kind != NC_RAPID && last && move->q[0] != last->q[0])
            return false;
        last = nc_moves(move) ? move : last;
    }
    return true;
}

/* How far the axes turn at least, from solution k at the start on, where no planner leaves doubt;
 * 0: one does. */
static double least_travel(const struct nc_planner *planner, const struct nc_group_start *since,
                           size_t from, size_t to, int k)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    double q[ROTARY_MAX] = {since->q[0], since->q[1]}, next[ROTARY_MAX], way = 0;
    bool cutting = false;
    struct turned turned = {{1, 1}, {0, 0}};
    const struct path_item *start = NULL;
    int over;
    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &planner->path->item.item[i];
        if (!path_moves(item))
            continue;
        if (!cutting && path_is_rapid(item)) {
            start = item;
            continue;
        }
        if (!cutting) {
            if (ik_choose(chain, start ? start->to.a : item->to.a, q, true, k, next, &over) != 0)
                return HUGE_VAL;
            way = ik_travel(chain, q, next);
            q[0] = next[0], q[1] = next[1];
            turned = chain_turned(chain, q);
            cutting = true;
        }
        if (!ik_near(&planner->near, item->to.a, q, &turned, next, &turned))
            return 0;
        way += ik_travel(chain, q, next);
        q[0] = next[0], q[1] = next[1];
    }
    return way;
}

/* A lower bound of what ik_plan may find in the places of the group (post_lookahead.c), which begin
 * where the rapids have led to; 0: not known. */
static double bound_of_travel(const struct nc_planner *planner, const struct nc_group_start *since,
                              size_t from, size_t to)
{
    const struct path_item *start = NULL;
    struct ik_bound bound = ik_bound_from(&planner->near, since->q);
    bool cutting = false;
    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &planner->path->item.item[i];
        if (item->kind != PATH_POINT && item->kind != PATH_ARC && item->kind != PATH_SPLINE)
            continue;
        if (!cutting && path_is_rapid(item)) {
            start = item;
            continue;
        }
        if (!cutting && start)
            ik_bound_to(&bound, start->to.a);
        ik_bound_to(&bound, item->to.a);
        cutting = true;
    }
    return ik_bound_least(&bound);
}

bool post_travel_is_least(const struct nc_planner *planner, const struct nc_group_start *since,
                          size_t from, size_t to)
{
    const struct kinematic_chain *chain = &planner->machine->chain;
    if (planner->follow.mode == INTERPOLATE_VECTOR || chain->n < 2)
        return true;
    if (solutions_turn_alike(chain))
        return !planner->doubtful || first_axis_stays(planner, since) ||
               !post_travel_saves(bound_of_travel(planner, since, from, to),
                                  post_travel_since(planner, since));
    if (planner->doubtful)
        return false;
    double least =
        fmin(least_travel(planner, since, from, to, 0), least_travel(planner, since, from, to, 1));
    return !post_travel_saves(least, post_travel_since(planner, since));
}
