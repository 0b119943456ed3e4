/* ncmove - see ncmove.h. */
#include "ncmove.h"

#include "array.h"
#include "num.h"

/* fmax for what is a number, without a call. */
static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

/* The longest that an axis of the machine needs between two stations, minutes. */
static double axes_minutes(const struct nc_step *step, const struct station *a,
                           const struct station *b)
{
    const struct machine *m = step->machine;
    double minutes = 0;
    for (int i = 0; i < m->chain.n; i++)
        minutes = larger(minutes, DEGREES(fabs(b->q[i] - a->q[i])) / m->rapid[m->letter[i]]);
    if (step->follow.mode == FOLLOW_JOINT)
        minutes = larger(minutes, vec_distance(a->p, b->p) / m->rapid[MACHINE_X]);
    return minutes;
}

/* The way of all axes together, mm and degrees. */
static double joint_way(const struct nc_step *step, const struct station *a,
                        const struct station *b)
{
    double way = vec_distance(a->p, b->p);
    for (int i = 0; i < step->machine->chain.n; i++)
        way = hypot(way, DEGREES(b->q[i] - a->q[i]));
    return way;
}

/*
 * F for a block of that length, *minutes what it takes at least: never 0, never beyond the
 * control's, and rounded down where an axis would be too fast else.
 */
static double feed_word(const struct nc_step *step, const struct station *to, double length,
                        double *minutes)
{
    const struct nc_ability *ability = &step->plan->ability;
    double feed = step->state.feed * step->state.faster, wished = length / feed;
    bool slow = *minutes > wished;
    *minutes = larger(*minutes, wished);
    if (ability->feeds == NC_FEEDS_INVERSE)
        feed = 1 / larger(*minutes, 1e-9);
    else if (ability->feeds == NC_FEEDS_COMBINED)
        feed = joint_way(step, &step->state.at, to) / larger(*minutes, 1e-9);
    else if (length > 0 && slow)
        feed = length / *minutes;
    double may = feed < ability->feed_max ? feed : ability->feed_max;
    double said = num_round(may, ability->digits.feed);
    if (said > feed && slow)
        said = num_round(said - 1 / num_ten[ability->digits.feed], ability->digits.feed);
    return said > 0 ? said : 1 / num_ten[ability->digits.feed];
}

struct nc_move *nc_move_to(struct nc_step *step, enum nc_kind kind, const struct stance *stance)
{
    const struct station *to = &stance->at;
    struct nc_plan *plan = step->plan;
    struct nc_state *state = &step->state;
    struct nc_move *move = array_push(&plan->move);
    *move = (struct nc_move){.kind = kind,
                             .why = state->why,
                             .line = state->line,
                             .p = to->p,
                             .q = {to->q[0], to->q[1]}};
    if (step->follow.mode == FOLLOW_VECTOR) {
        move->vector = (unsigned)plan->vector.n;
        *array_push(&plan->vector) = to->a;
    }
    state->at = *to;
    state->turned = stance->turned;
    state->off.point = state->off.axis = NAN;
    step->first = false;
    return move;
}

void nc_add_move(struct nc_step *step, enum nc_kind kind, const struct stance *stance,
                 double length, size_t index)
{
    struct nc_total *total = &step->plan->total;
    double minutes = axes_minutes(step, &step->state.at, &stance->at), feed = 0;
    if (kind == NC_RAPID) {
        minutes = larger(minutes, length / step->machine->rapid[MACHINE_X]);
        total->rapid += length;
        total->rapids++;
    } else {
        feed = feed_word(step, &stance->at, length, &minutes);
        total->cut += length;
        total->lines += kind == NC_LINE;
        total->arcs += kind == NC_ARC;
        total->splines += kind == NC_SPLINE;
    }
    total->minutes += minutes;
    struct nc_move *move = nc_move_to(step, kind, stance);
    move->feed = feed;
    move->index = (unsigned)index;
}

/* Both say the same. */
static bool same_station(const struct station *a, const struct station *b, bool vectors)
{
    bool same = a->p.x == b->p.x && a->p.y == b->p.y && a->p.z == b->p.z;
    if (vectors)
        return same && a->a.x == b->a.x && a->a.y == b->a.y && a->a.z == b->a.z;
    return same && a->q[0] == b->q[0] && a->q[1] == b->q[1];
}

void nc_add_straight(struct nc_step *step, enum nc_kind kind, const struct stance *to,
                     const struct pose *goal)
{
    struct nc_state *state = &step->state;
    if (!same_station(&state->at, &to->at, step->follow.mode == FOLLOW_VECTOR))
        nc_add_move(step, kind, to, vec_distance(state->pose.p, goal->p), 0);
    state->off.point = state->off.axis = NAN;
    state->pose = *goal;
}
