/* ncreach - see ncreach.h. */
#include "ncreach.h"

#include "num.h"

static struct vec3 round_point(struct vec3 p, int digits)
{
    return vec(num_round(p.x, digits), num_round(p.y, digits), num_round(p.z, digits));
}

static int over_travel(struct nc_step *step, int axis, const char *what, double value)
{
    const struct machine *m = step->machine;
    step->plan->unmet = true;
    return error_at(step->error, step->path->name, step->state.line,
                    "pass %zu: axis %c of %s: found %s %.5f, expected its travel %g to %g",
                    step->state.pass, machine_letter(axis), m->name, what, value, m->min[axis],
                    m->max[axis]);
}

double nc_surely_within(const struct machine *m)
{
    double far = HUGE_VAL;
    for (int axis = 0; axis < 3; axis++)
        far = fmin(far, fmin(m->max[axis], -m->min[axis]));
    for (int i = 0; i < m->chain.n; i++)
        far -= 2 * vec_length(m->chain.rotary[i].centre);
    return fmax(far, 0);
}

int nc_check_linear(struct nc_step *step, const struct stance *to)
{
    const struct machine *m = step->machine;
    struct vec3 p = to->at.p;
    if (step->follow.mode != FOLLOW_JOINT && vec_dot(p, p) < step->within * step->within)
        return 0;
    if (step->follow.mode != FOLLOW_JOINT)
        p = chain_linear_of(&m->chain, p, &to->turned);
    const double at[3] = {p.x, p.y, p.z};
    for (int axis = 0; axis < 3; axis++)
        if (!(at[axis] >= m->min[axis] && at[axis] <= m->max[axis]))
            return over_travel(step, axis, "a position of", at[axis]);
    return 0;
}

/* The same, where the cosines and sines of q are known. */
static struct stance stance_of(const struct nc_step *step, struct pose to, const double q[],
                               const struct turned *turned)
{
    const struct machine_digits *digits = &step->plan->ability.digits;
    const struct chain *chain = &step->machine->chain;
    struct stance s = {.at = {.a = to.a}};
    double by[ROTARY_MAX] = {0};
    for (int i = 0; i < chain->n; i++) {
        s.at.q[i] = RADIANS(num_round(DEGREES(q[i]), digits->angle));
        by[i] = s.at.q[i] - q[i];
    }
    s.turned = chain_turned_on(chain, *turned, by);
    if (step->follow.mode == FOLLOW_VECTOR)
        s.at.a = round_point(to.a, digits->vector);
    else if (chain->n)
        s.at.a = chain_axis_of(chain, &s.turned);
    if (step->follow.mode == FOLLOW_JOINT)
        to.p = chain_linear_of(chain, to.p, &s.turned);
    s.at.p = round_point(to.p, digits->linear);
    return s;
}

struct stance nc_station(const struct nc_step *step, struct pose to, const double q[])
{
    struct turned turned = chain_turned(&step->machine->chain, q);
    return stance_of(step, to, q, &turned);
}

/* The first tool axis behind the current item that is not singular, NULL: none. */
static const struct vec3 *next_tilted(struct nc_step *step)
{
    const struct path *path = step->path;
    if (step->tilted < step->next)
        step->tilted = step->next;
    for (; step->tilted < path->item.n; step->tilted++) {
        const struct path_item *item = &path->item.item[step->tilted];
        if (path_moves(item) && !chain_free(&step->machine->chain, item->to.a))
            return &item->to.a;
    }
    return NULL;
}

/*
 * In the singular direction the axis nearest the work is free.  From one such pose to the next it
 * turns to where the path will need it, so that it has the way between them for its turn instead
 * of none when the tool tilts.
 */
static void turn_ahead(struct nc_step *step, struct pose to, double q[])
{
    const struct chain *chain = &step->machine->chain;
    double then[ROTARY_MAX];
    int over, only = step->first ? step->branch.first : step->branch.then;
    if (!chain_free(chain, to.a))
        return;
    if (step->state.begun && !step->first && !chain_free(chain, step->state.pose.a))
        return;
    const struct vec3 *ahead = next_tilted(step);
    if (ahead && chain_choose(chain, *ahead, q, true, only, then, &over) == 0)
        q[0] = then[0];
}

/* The axis nearest the work a whole turn on, as the branch says, where its travel allows it. */
static void wind(const struct nc_step *step, double q[])
{
    const struct rotary *rotary = &step->machine->chain.rotary[0];
    double turned = q[0] + 2 * PI * step->branch.wind;
    if (step->machine->chain.n && turned >= rotary->min && turned <= rotary->max)
        q[0] = turned;
}

int nc_reach(struct nc_step *step, struct pose to, struct stance *s)
{
    const struct chain *chain = &step->machine->chain;
    double q[ROTARY_MAX] = {0};
    struct turned turned = step->state.turned;
    if (!step->first && !step->aim && step->branch.then < 0 &&
        chain_beside(&step->ways, to.a, step->state.at.q, q, &turned)) {
        *s = stance_of(step, to, q, &turned);
        return nc_check_linear(step, s);
    }
    int over, only = step->first ? step->branch.first : step->branch.then;
    const double *near = step->aim ? step->aim : step->state.at.q;
    if (chain_choose(chain, to.a, near, step->aim || !step->first, only, q, &over) != 0) {
        if (over < 0) {
            step->plan->unmet = true;
            return error_at(step->error, step->path->name, step->state.line,
                            "pass %zu: found tool axis %.6f %.6f %.6f, which no angles of %s reach",
                            step->state.pass, to.a.x, to.a.y, to.a.z, step->machine->name);
        }
        struct chain_solutions angles = chain_angles(chain, to.a);
        return over_travel(step, step->machine->letter[over], "angle",
                           DEGREES(angles.q[only == 1 && angles.n == 2][over]));
    }
    if (step->first && !step->aim)
        wind(step, q);
    turn_ahead(step, to, q);
    *s = nc_station(step, to, q);
    return nc_check_linear(step, s);
}
