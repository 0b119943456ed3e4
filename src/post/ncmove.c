/* ncmove - see ncmove.h. */
#include "ncmove.h"

#include "base/array.h"
#include "base/num.h"

/* fmax for what is a number, without a call. */
static inline double larger(double a, double b)
{
    return a > b ? a : b;
}

/* The way of all axes together, mm and degrees. */
static double joint_way(const struct nc_step *step, const struct block_pose *a,
                        const struct block_pose *b)
{
    double way = vec_distance(a->p, b->p);
    for (int i = 0; i < step->machine->chain.n; i++)
        way = hypot(way, DEGREES(b->q[i] - a->q[i]));
    return way;
}

/* What a turn about a tip that stands counts, mm: as it has degrees, or as the ball goes. */
static double turn_way(const struct nc_step *step, const struct block_pose *a,
                       const struct block_pose *b)
{
    double way = 0;
    for (int i = 0; i < step->machine->chain.n; i++)
        way = hypot(way, DEGREES(b->q[i] - a->q[i]));
    return larger(way / step->wish.unit, fabs(step->follow.ball) * vec_distance(a->a, b->a));
}

/*
 * F for a block of that length, *minutes what it takes: never 0, never beyond the control's, and
 * rounded down where an axis would be too fast else.  Where the tip stays, as printed, F counts
 * degrees.
 */
static double feed_word(const struct nc_step *step, const struct machine_pose *stance,
                        double length, const struct nc_along *along, double *minutes)
{
    const struct nc_ability *ability = &step->plan->ability;
    const struct block_pose *from = &step->state.at, *to = &stance->at;
    bool tip = ability->feeds == NC_FEEDS_TIP;
    if (tip && !along)
        length = vec_distance(from->p, to->p);
    bool still = length < 1 / num_ten[ability->digits.linear], stays = tip && length == 0;
    double feed = step->state.feed * step->state.faster, wished = length / feed;
    if (still) /* else the tip alone says how fast it goes */
        wished = larger(length, turn_way(step, from, to)) / feed;
    *minutes = nc_block_minutes(step, stance, length, along, wished);
    bool slow = *minutes > wished;
    if (ability->feeds == NC_FEEDS_INVERSE)
        feed = 1 / larger(*minutes, 1e-9);
    else if (!tip || stays)
        feed = joint_way(step, from, to) / larger(*minutes, 1e-9);
    else if (slow || still)
        feed = length / *minutes;
    for (int i = 0; stays && step->follow.mode == INTERPOLATE_VECTOR && i < step->machine->chain.n;
         i++)
        feed = fmin(feed, step->machine->rapid[step->machine->letter[i]]); /* now one, now both */
    double may = feed < ability->feed_max ? feed : ability->feed_max;
    int digits = nc_feed_digits(ability, may);
    double said = num_round(may, digits), least = 1 / num_ten[digits];
    if (said > feed * (1 + 1e-9) && slow)
        said = num_round(said - least, digits);
    return said > 0 ? said : least;
}

struct nc_move *nc_move_to(struct nc_step *step, enum nc_kind kind,
                           const struct machine_pose *stance)
{
    const struct block_pose *to = &stance->at;
    struct nc_plan *plan = step->plan;
    struct nc_state *state = &step->state;
    struct nc_move *move = array_push(&plan->move);
    *move = (struct nc_move){.kind = kind,
                             .why = state->why,
                             .line = state->line,
                             .p = to->p,
                             .q = {to->q[0], to->q[1]}};
    if (step->follow.mode == INTERPOLATE_VECTOR) {
        move->vector = (unsigned)plan->vector.n;
        *array_push(&plan->vector) = to->a;
    }
    state->at = *to;
    state->turned = stance->turned;
    state->off.point = state->off.axis = NAN;
    step->first = false;
    return move;
}

void nc_add_move(struct nc_step *step, enum nc_kind kind, const struct machine_pose *stance,
                 double length, size_t index, const struct nc_along *along)
{
    struct nc_total *total = &step->plan->total;
    double minutes, feed = 0;
    if (kind == NC_RAPID) {
        minutes = nc_axes_minutes(step, &step->state.at, &stance->at);
        minutes = larger(minutes, length / step->machine->rapid[MACHINE_X]);
        total->rapid += length;
        total->rapids++;
    } else {
        feed = feed_word(step, stance, length, along, &minutes);
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
static bool same_station(const struct block_pose *a, const struct block_pose *b, bool vectors)
{
    bool same = a->p.x == b->p.x && a->p.y == b->p.y && a->p.z == b->p.z;
    if (vectors)
        return same && a->a.x == b->a.x && a->a.y == b->a.y && a->a.z == b->a.z;
    return same && a->q[0] == b->q[0] && a->q[1] == b->q[1];
}

void nc_add_straight(struct nc_step *step, enum nc_kind kind, const struct machine_pose *to,
                     const struct pose *goal)
{
    struct nc_state *state = &step->state;
    if (!same_station(&state->at, &to->at, step->follow.mode == INTERPOLATE_VECTOR))
        nc_add_move(step, kind, to, vec_distance(state->pose.p, goal->p), 0, NULL);
    state->off.point = state->off.axis = NAN;
    state->pose = *goal;
}
