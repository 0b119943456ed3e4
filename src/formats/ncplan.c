/*
 * ncplan - see ncplan.h.
 *
 * A path is planned in groups: from a rapid, where the tool is off the part and the rotary axes
 * may go to either solution, up to the next rapid.  A group that runs out of a rotary axis's
 * travel with one solution is planned again with the other; when neither serves, a look ahead over
 * the whole group finds with which to start and where the tool retracts, turns and returns.
 */
#include "ncplan.h"

#include <stdlib.h>

#include "ncahead.h"
#include "ncitem.h"
#include "ncreach.h"
#include "ncturn.h"
#include "num.h"

/* What a group that is planned again has to take back. */
struct mark {
    struct nc_state state;
    struct nc_total total;
    size_t moves, vectors, arcs, splines, holes;
};

static struct mark mark_of(const struct nc_step *step)
{
    const struct nc_plan *plan = step->plan;
    return (struct mark){step->state, plan->total,    plan->move.n, plan->vector.n,
                         plan->arc.n, plan->spline.n, plan->hole.n};
}

static void back_to(struct nc_step *step, const struct mark *mark)
{
    struct nc_plan *plan = step->plan;
    for (size_t i = mark->splines; i < plan->spline.n; i++)
        nc_spline_free(&plan->spline.item[i]);
    step->state = mark->state;
    plan->total = mark->total;
    plan->unmet = false;
    plan->move.n = mark->moves;
    plan->vector.n = mark->vectors;
    plan->arc.n = mark->arcs;
    plan->spline.n = mark->splines;
    plan->hole.n = mark->holes;
}

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

struct station nc_plan_station(const struct nc_plan *plan, const struct chain *chain,
                               const struct nc_move *move)
{
    struct station at = {.p = move->p, .q = {move->q[0], move->q[1]}};
    at.a = plan->ability.mode == FOLLOW_VECTOR ? plan->vector.item[move->vector]
                                               : chain_axis(chain, move->q);
    return at;
}

static bool begins_anew(const struct path_item *item)
{
    return item->kind == PATH_TOOL || item->kind == PATH_PLANE;
}

/* Behind the group that starts at `from`: the next rapid that comes after a cut, or tool. */
static size_t group_end(const struct path *path, size_t from)
{
    bool cutting = false;
    for (size_t i = from; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        bool rapid = item->kind == PATH_POINT && item->rapid;
        if ((rapid && cutting) || (begins_anew(item) && i > from))
            return i;
        cutting = cutting || (path_moves(item) && !rapid);
    }
    return path->item.n;
}

/* The turns strictly inside of the motion between two places. */
static void add_stops(struct nc_step *step, const struct nc_ahead *ahead, size_t from, size_t to)
{
    step->stops.n = 0;
    for (size_t i = from + 1; i < to; i++) {
        const double *q = ahead->item[i + 1].q;
        if (ahead->item[i].turn)
            *array_push(&step->stops) = (struct nc_stop){ahead->s.item[i], {q[0], q[1]}};
    }
}

/* ahead: what was found by looking ahead over the group, NULL: nothing. */
static int plan_items(struct nc_step *step, const struct nc_ahead *ahead, size_t from, size_t to)
{
    step->first = true;
    step->tilted = from;
    for (size_t i = from; i < to; i++) {
        step->next = i + 1;
        size_t place = ahead ? ahead->start.item[i - from] : 0;
        bool moves = path_moves(&step->path->item.item[i]);
        step->aim = ahead && place == 0 ? ahead->item[0].q : NULL;
        if (ahead && moves && place + 1 < ahead->n && ahead->item[place].turn &&
            nc_step_turn(step, ahead->item[place + 1].q) != 0)
            return -1;
        if (ahead)
            add_stops(step, ahead, place, ahead->start.item[i - from + 1]);
        if (nc_item(step, &step->path->item.item[i]) != 0)
            return -1;
    }
    return 0;
}

static int plan_group(struct nc_step *step, size_t from, size_t to)
{
    static const struct nc_branch attempt[] = {{-1, -1, 0},  {0, -1, 0}, {1, -1, 0}, {-1, -1, 1},
                                               {-1, -1, -1}, {0, 0, 0},  {1, 1, 0}};
    struct mark mark = mark_of(step);
    step->may_turn = false;
    for (size_t i = 0; i < sizeof attempt / sizeof *attempt; i++) {
        step->branch = attempt[i];
        if (plan_items(step, NULL, from, to) == 0)
            return 0;
        if (!step->plan->unmet)
            return -1;
        back_to(step, &mark);
    }
    step->branch = attempt[0];
    step->may_turn = true;
    struct nc_ahead ahead;
    bool found = nc_ahead_make(&ahead, step, from, to);
    int result = found ? plan_items(step, &ahead, from, to) : -1;
    nc_ahead_free(&ahead);
    step->aim = NULL;
    step->stops.n = 0;
    if (found && (result == 0 || !step->plan->unmet))
        return result;
    back_to(step, &mark);
    return plan_items(step, NULL, from, to);
}

/* The clearance plane or, where the path names none, its highest rapid. */
static double clear_height(const struct path *path)
{
    double z = path->head.clearance;
    for (size_t i = 0; i < path->item.n && isnan(path->head.clearance); i++)
        if (path->item.item[i].kind == PATH_POINT && path->item.item[i].rapid)
            z = fmax(z, path->item.item[i].to.p.z);
    return z;
}

/* The travel to the last digit within it, so that no angle is beyond it once it is rounded. */
static void trim_travel(struct chain *chain, int digits)
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
                 struct nc_ability ability, struct nc_wish wish, struct error *error)
{
    *plan = (struct nc_plan){.ability = ability};
    struct nc_step step = {.path = path,
                           .machine = machine,
                           .plan = plan,
                           .wish = wish,
                           .error = error,
                           .branch = {-1, -1, 0}};
    if (path->head.track == TRACK_CONTACT)
        return error_set(error,
                         "%s: found a path of contact points (TRACK/CONTACT), expected one of tool "
                         "tips or ball centres",
                         path->name);
    struct machine own = *machine;
    trim_travel(&own.chain, ability.digits.angle);
    step.machine = &own;
    step.follow = (struct follow){.mode = ability.mode, .chain = &own.chain};
    step.clear = clear_height(path);
    array_reserve(&plan->move, path->item.n + path->item.n / 16); /* most are blocks as they are */
    step.ways = chain_ways(&own.chain);
    step.within = nc_surely_within(machine);
    step.state.faster = 1;
    step.state.turned = chain_turned(&machine->chain, step.state.at.q);
    nc_item_tool(&step, path_ball(path));
    int result = 0;
    for (size_t from = 0; from < path->item.n && result == 0;) {
        size_t to = group_end(path, from);
        result = plan_group(&step, from, to);
        from = to;
    }
    array_free(&step.stops);
    if (result == 0 && !step.state.begun)
        return error_set(error, "%s: found no motion, expected at least one GOTO", path->name);
    return result == 0 ? nc_item_depart(&step) : -1;
}
