/* ncway - see ncway.h. */
#include "ncway.h"

#include "post_ik.h"

static const double worth = 0.01; /* of the way of the rotary axes: what a second plan must save */

bool nc_way_saves(double way, double than)
{
    return way < than * (1 - worth);
}

double nc_way_since(const struct nc_step *step, const struct nc_since *since)
{
    const double *q = since->q;
    double way = 0;
    for (size_t i = since->moves; i < step->plan->move.n; i++) {
        const struct nc_move *move = &step->plan->move.item[i];
        if (!nc_moves(move))
            continue;
        way += ik_travel(&step->machine->chain, q, move->q);
        q = move->q;
    }
    return way;
}

/* Both solutions turn alike, whatever the way: two axes at right angles, and the tool across. */
static bool turn_alike(const struct kinematic_chain *chain)
{
    const struct rotary *r = chain->rotary;
    return fabs(vec_dot(r[0].axis, r[1].axis)) < 1e-9 &&
           fabs(vec_dot(r[1].axis, chain->tool)) < 1e-9;
}

/* From where the rapids have led to the axis nearest the work stays as it is: then the other one
 * turns by what the tool axis does, and no way is shorter. */
static bool first_stays(const struct nc_step *step, const struct nc_since *since)
{
    const struct nc_move *last = NULL;
    for (size_t i = since->moves; i < step->plan->move.n; i++) {
        const struct nc_move *move = &step->plan->move.item[i];
        if (nc_moves(move) && move->kind != NC_RAPID && last && move->q[0] != last->q[0])
            return false;
        last = nc_moves(move) ? move : last;
    }
    return true;
}

/* How far the axes turn at least, from solution k at the start on, where no step leaves doubt; 0:
 * one does. */
static double way_of(const struct nc_step *step, const struct nc_since *since, size_t from,
                     size_t to, int k)
{
    const struct kinematic_chain *chain = &step->machine->chain;
    double q[ROTARY_MAX] = {since->q[0], since->q[1]}, next[ROTARY_MAX], way = 0;
    bool cutting = false;
    struct turned turned = {{1, 1}, {0, 0}};
    const struct path_item *start = NULL;
    int over;
    for (size_t i = from; i < to; i++) {
        const struct path_item *item = &step->path->item.item[i];
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
        if (!ik_near(&step->ways, item->to.a, q, &turned, next, &turned))
            return 0;
        way += ik_travel(chain, q, next);
        q[0] = next[0], q[1] = next[1];
    }
    return way;
}

bool nc_way_surely_shortest(const struct nc_step *step, const struct nc_since *since, size_t from,
                            size_t to)
{
    const struct kinematic_chain *chain = &step->machine->chain;
    if (step->follow.mode == INTERPOLATE_VECTOR || chain->n < 2)
        return true;
    if (turn_alike(chain))
        return !step->doubt || first_stays(step, since);
    if (step->doubt)
        return false;
    double least = fmin(way_of(step, since, from, to, 0), way_of(step, since, from, to, 1));
    return !nc_way_saves(least, nc_way_since(step, since));
}
