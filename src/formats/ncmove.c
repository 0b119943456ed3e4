/* ncmove - see ncmove.h. */
#include "ncmove.h"

#include "array.h"
#include "num.h"

/* The longest that an axis of the machine needs between two stations, minutes. */
static double axes_minutes(const struct nc_step *step, const struct station *a,
                           const struct station *b)
{
    const struct machine *m = step->machine;
    double minutes = 0;
    for (int i = 0; i < m->chain.n; i++)
        minutes = fmax(minutes, DEGREES(fabs(b->q[i] - a->q[i])) / m->rapid[m->letter[i]]);
    if (step->follow.mode == FOLLOW_JOINT)
        minutes = fmax(minutes, vec_distance(a->p, b->p) / m->rapid[MACHINE_X]);
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
    double least = 1 / num_ten[ability->digits.feed];
    double feed = step->state.feed * step->state.faster, wished = length / feed;
    bool slow = *minutes > wished;
    *minutes = fmax(*minutes, wished);
    if (ability->feeds == NC_FEEDS_INVERSE)
        feed = 1 / fmax(*minutes, 1e-9);
    else if (ability->feeds == NC_FEEDS_COMBINED)
        feed = joint_way(step, &step->state.at, to) / fmax(*minutes, 1e-9);
    else if (length > 0 && slow)
        feed = length / *minutes;
    double said = num_round(fmin(feed, ability->feed_max), ability->digits.feed);
    if (slow && said > feed)
        said = num_round(said - least, ability->digits.feed);
    return fmax(said, least);
}

struct nc_move *nc_move_to(struct nc_step *step, enum nc_kind kind, const struct stance *stance)
{
    const struct station *to = &stance->at;
    struct nc_plan *plan = step->plan;
    struct nc_move *move = array_push(&plan->move);
    *move = (struct nc_move){.kind = kind,
                             .why = step->state.why,
                             .line = step->state.line,
                             .p = to->p,
                             .q = {to->q[0], to->q[1]}};
    if (step->follow.mode == FOLLOW_VECTOR) {
        move->vector = (unsigned)plan->vector.n;
        *array_push(&plan->vector) = to->a;
    }
    step->state.at = *to;
    step->state.turned = stance->turned;
    step->first = false;
    return move;
}

void nc_add_move(struct nc_step *step, enum nc_kind kind, const struct stance *stance,
                 double length, size_t index)
{
    struct nc_total *total = &step->plan->total;
    const struct station from = step->state.at, *to = &stance->at;
    double minutes = axes_minutes(step, &from, to), feed = 0;
    if (kind == NC_RAPID) {
        minutes = fmax(minutes, length / step->machine->rapid[MACHINE_X]);
        total->rapid += length;
        total->rapids++;
    } else {
        feed = feed_word(step, to, length, &minutes);
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
