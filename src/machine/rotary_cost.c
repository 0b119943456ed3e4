/* rotary_cost - see rotary_cost.h. */
#include "math/elementary.h"
#include "machine/rotary_cost.h"

static const double STEP = 5 * PI / 180;
static const double UPRIGHT = 1e-6; /* radians: an axis that leans less has no direction */

struct rotary_leaning rotary_leaning_of(struct vec3 axis)
{
    return (struct rotary_leaning){axis, atan2(hypot(axis.x, axis.y), axis.z)};
}

/* The angle between the directions of two axes, exact where it is small. */
static double turn_between(struct vec3 from, struct vec3 to)
{
    return atan2(fabs(from.x * to.y - from.y * to.x), from.x * to.x + from.y * to.y);
}

double rotary_leaning_travel_one(const struct rotary_leaning *from, const struct rotary_leaning *to)
{
    double change = fabs(to->lean - from->lean);

    return fmin(from->lean, to->lean) > UPRIGHT ? change + turn_between(from->axis, to->axis)
                                                : change;
}

double rotary_leaning_travel(const struct rotary_leaning *from, const struct rotary_leaning *to)
{
    double change = fabs(to->lean - from->lean);

    if (from->lean < UPRIGHT || to->lean < UPRIGHT)
        return change;
    double turn = turn_between(from->axis, to->axis);
    return fmin(change + turn, from->lean + to->lean + PI - turn);
}

double rotary_travel(struct vec3 from, struct vec3 to)
{
    struct rotary_leaning a = rotary_leaning_of(from), b = rotary_leaning_of(to);

    return rotary_leaning_travel(&a, &b);
}

/* Is the angle, or one a whole turn away, within the travel? */
static bool within_travel(const struct rotary *rotary, double q)
{
    double low = q + 2 * PI * ceil((rotary->min - q) / (2 * PI) - 1e-12);

    return low <= rotary->max + 1e-9;
}

/* Which solutions are within the travel, a bit each; where there is but one, or the axis nearest
 * the work is free, both or none. */
static int solutions_within(const struct kinematic_chain *chain, struct vec3 axis)
{
    struct chain_solutions s = chain_angles(chain, axis);
    int within = 0;

    for (int k = 0; k < s.n; k++) {
        bool in = true;
        for (int i = 0; i < chain->n; i++)
            in = in && ((i == 0 && s.free) || within_travel(&chain->rotary[i], s.q[k][i]));
        within |= in << k;
    }
    return within && (s.free || s.n == 1) ? 3 : within;
}

bool rotary_reaches(const struct kinematic_chain *chain, struct vec3 axis)
{
    return solutions_within(chain, axis) != 0;
}

bool rotary_allows(const struct kinematic_chain *chain, struct vec3 axis)
{
    return chain->n < 1 || rotary_reaches(chain, axis);
}

/* Where the way, so long, leans least or most off the first axis, which sets the second one's
 * angle: within that too. */
static bool reaches_extremes(const struct kinematic_chain *chain, struct vec3 from, struct vec3 to,
                             double angle)
{
    struct vec3 pole = chain->rotary[0].axis, ahead = vec_unit(vec_reject(to, from));
    double at = atan2(vec_dot(pole, ahead), vec_dot(pole, from));

    at = at < 0 ? at + PI : at; /* the one or the other, half a turn apart */
    return !(at > 0 && at < angle) || rotary_reaches(chain, vec_slerp(from, to, at / angle));
}

/* Whether a direction is reached is a matter of how far it leans off the first axis alone; and of
 * two leans that are, all between. */
static bool turns_wholly(const struct kinematic_chain *chain)
{
    return chain->n == 2 && chain->rotary[0].max - chain->rotary[0].min >= 2 * PI;
}

/* Between two directions, each of one solution, of which the other has none: where the first ends
 * the second has begun. */
static bool reaches_change(const struct kinematic_chain *chain, struct vec3 from, int first,
                           struct vec3 to, int second)
{
    enum { HALVINGS = 12 }; /* of a degree: far less than a tool axis may be off */

    for (int i = 0; i < HALVINGS; i++) {
        struct vec3 middle = vec_slerp(from, to, 0.5);
        int within = solutions_within(chain, middle);
        if (within == 0)
            return false;
        if ((within & first) && (within & second))
            return true;
        *(within & first ? &from : &to) = middle;
    }
    return true;
}

bool rotary_reaches_between(const struct kinematic_chain *chain, struct vec3 from, struct vec3 to)
{
    const double still = 1e-9;
    double angle = vec_angle(from, to), parts = fmax(4, ceil(angle / RADIANS(1)));

    if (chain->n < 1 || angle < still)
        return true;

    int before = solutions_within(chain, from);
    if (turns_wholly(chain) && before && rotary_reaches(chain, to))
        return reaches_extremes(chain, from, to, angle);
    struct vec3 last = from;
    for (double k = 1; k <= parts; k++) {
        struct vec3 axis = k < parts ? vec_slerp(from, to, k / parts) : to;
        int within = solutions_within(chain, axis);
        if (within == 0 && k < parts)
            return false;
        if (before && within && !(before & within) &&
            !reaches_change(chain, last, before, axis, within))
            return false;
        before = within;
        last = axis;
    }
    return reaches_extremes(chain, from, to, angle);
}

struct rotary_frame rotary_frame_of(const struct kinematic_chain *chain)
{
    const double beside = RADIANS(10);
    struct rotary_frame f = {.pole = chain->n > 0 ? chain->rotary[0].axis : vec(0, 0, 1)};

    if (vec_dot(f.pole, chain->tool) < 0)
        f.pole = vec_scale(-1, f.pole);
    f.x = vec_unit(vec_reject(fabs(f.pole.z) > 0.9 ? vec(1, 0, 0) : vec(0, 0, 1), f.pole));
    f.y = vec_cross(f.pole, f.x);
    f.both = chain->n == 0 || solutions_within(chain, vec_along(vec_scale(cos(beside), f.pole),
                                                                sin(beside), f.x)) == 3;
    return f;
}

struct axis_circle rotary_circle(const struct kinematic_chain *chain)
{
    const struct rotary *r = &chain->rotary[0];

    if (chain->n != 1 || fabs(vec_dot(r->axis, chain->tool)) > UPRIGHT)
        return (struct axis_circle){.min = 0};
    return (struct axis_circle){r->axis, chain->tool, r->min, r->max};
}

static double off_by(struct rotary_angles a, struct rotary_angles b)
{
    return fabs(a.lean - b.lean) + fabs(a.turn - b.turn);
}

struct rotary_angles rotary_angles_near(const struct rotary_frame *f, struct vec3 axis,
                                        struct rotary_angles to)
{
    double x = vec_dot(axis, f->x), y = vec_dot(axis, f->y), z = vec_dot(axis, f->pole);
    struct rotary_angles plus = {atan2(hypot(x, y), z), atan2(y, x)}, minus;

    if (plus.lean < UPRIGHT)
        return (struct rotary_angles){0, to.turn};
    minus = (struct rotary_angles){-plus.lean, plus.turn + PI};
    plus.turn = angle_nearest(plus.turn, to.turn);
    minus.turn = angle_nearest(minus.turn, to.turn);
    return f->both && off_by(minus, to) < off_by(plus, to) ? minus : plus;
}

struct vec3 rotary_axis(const struct rotary_frame *f, struct rotary_angles at)
{
    struct vec3 side = vec_along(vec_scale(cos(at.turn), f->x), sin(at.turn), f->y);

    return vec_along(vec_scale(cos(at.lean), f->pole), sin(at.lean), side);
}

double rotary_pole_between(struct rotary_angles from, struct rotary_angles to)
{
    double a = fabs(from.lean), b = fabs(to.lean);

    return from.lean * to.lean < 0 ? a / (a + b) : -1;
}

struct rotary_angles rotary_angles_between(struct rotary_angles from, struct rotary_angles to,
                                           double s)
{
    double a = fabs(from.lean), b = fabs(to.lean), pole = rotary_pole_between(from, to);
    double turned = s, off = s - pole;

    if (pole >= 0) { /* in proportion to the integral of the lean */
        turned = (a * pole + copysign((a + b) * off * off, off)) / (a * pole + b * (1 - pole));
    }
    return (struct rotary_angles){from.lean + s * (to.lean - from.lean),
                                  from.turn + turned * (to.turn - from.turn)};
}

static int lean_steps(double least, double most)
{
    return most > least ? (int)ceil((most - least) / STEP - 1e-9) : 0;
}

int rotary_leans(double least, double most)
{
    return ROTARY_LEAN_DIRECTIONS * (1 + lean_steps(least, most));
}

struct tool_axis_options rotary_lean(double least, double most, int i)
{
    int n = lean_steps(least, most), step = i / ROTARY_LEAN_DIRECTIONS;
    double part = n > 0 ? (double)step / n : 0, off = least + part * (most - least);
    double direction = 2 * PI * (i % ROTARY_LEAN_DIRECTIONS) / ROTARY_LEAN_DIRECTIONS;

    return (struct tool_axis_options){.kind = AXIS_LEAN,
                                      .lead = atan(tan(off) * cos(direction)),
                                      .tilt = atan(tan(off) * sin(direction))};
}
