/* holder_sweep - see holder_sweep.h. */
#include "gouge/holder_sweep.h"

enum { HALVINGS = 14 };

static const double BEYOND = 0.05; /* mm: a clearance is looked for a little beyond the need */
static const double STILL = 1e-12; /* radians: an axis that turns by no more stays as it is */

double holder_sweep_clearance(const struct holder_sweep *sweep, const struct run_point *p,
                              double most)
{
    return gouge_holder(sweep->guard, sweep->holder, p->ball, p->axis, most);
}

/* Between two poses no point of the holder moves farther than the centre moves plus the reach
 * times the turn.  So where the two clearances together are more than that, some clearance is left
 * everywhere between. */
static bool is_clear_between(const struct holder_sweep *sweep, struct run_point a, double clear_a,
                             struct run_point b, double clear_b, int halvings)
{
    double moved =
        vec_distance(a.ball, b.ball) + holder_reach(sweep->holder) * vec_angle(a.axis, b.axis);

    if (fmin(clear_a, clear_b) < -sweep->slack)
        return false;
    if (clear_a + clear_b + 2 * sweep->slack >= moved || moved <= GOUGE_STEP || halvings == 0)
        return true;
    struct run_point m = {.ball = vec_mix(a.ball, b.ball, 0.5),
                          .axis = vec_slerp(a.axis, b.axis, 0.5)};
    double clear_m = holder_sweep_clearance(sweep, &m, moved);
    return is_clear_between(sweep, a, clear_a, m, clear_m, halvings - 1) &&
           is_clear_between(sweep, m, clear_m, b, clear_b, halvings - 1);
}

bool holder_sweep_clear_between(const struct holder_sweep *sweep, const struct run_point *from,
                                double clear_from, const struct run_point *to, double clear_to)
{
    if (sweep->holder->n > 0 && fmin(clear_from, clear_to) >= -sweep->slack &&
        vec_angle(from->axis, to->axis) <= STILL)
        return gouge_holder_clear_along(sweep->guard, sweep->holder, from->ball, to->ball,
                                        from->axis, -sweep->slack, NULL);
    return sweep->holder->n == 0 ||
           is_clear_between(sweep, *from, clear_from, *to, clear_to, HALVINGS);
}

bool holder_sweep_clear(const struct holder_sweep *sweep, const struct run_point *from,
                        const struct run_point *to)
{
    double moved = vec_distance(from->ball, to->ball) +
                   holder_reach(sweep->holder) * vec_angle(from->axis, to->axis) + BEYOND;

    if (sweep->holder->n == 0)
        return true;
    return holder_sweep_clear_between(sweep, from, holder_sweep_clearance(sweep, from, moved), to,
                                      holder_sweep_clearance(sweep, to, moved));
}
