/* kinematics - see kinematics.h. */
#include "machine/kinematics.h"

static const double reach = 1e-6;    /* radians beyond the chain's reach that count as rounding */
static const double singular = 1e-9; /* radians from the singular direction that count as on it */

struct turned chain_turned(const struct kinematic_chain *chain, const double q[])
{
    struct turned t = {{1, 1}, {0, 0}};
    for (int i = 0; i < chain->n; i++) {
        struct sine_cosine at = elementary_sine_cosine(q[i]);
        t.cosine[i] = at.cosine;
        t.sine[i] = at.sine;
    }
    return t;
}

struct turned chain_turned_mid(const struct kinematic_chain *chain, struct turned a,
                               struct turned b)
{
    struct turned t = a;
    for (int i = 0; i < chain->n; i++) {
        double c = a.cosine[i] + b.cosine[i], s = a.sine[i] + b.sine[i];
        double scale = 1 / sqrt(c * c + s * s);
        t.cosine[i] = scale * c;
        t.sine[i] = scale * s;
    }
    return t;
}

struct vec3 chain_axis_of(const struct kinematic_chain *chain, const struct turned *at)
{
    struct vec3 a = chain->tool;
    for (int i = chain->n - 1; i >= 0; i--)
        a = vec_turn_by(a, chain->rotary[i].axis, at->cosine[i], at->sine[i]);
    return a;
}

struct vec3 chain_axis(const struct kinematic_chain *chain, const double q[])
{
    struct turned at = chain_turned(chain, q);
    return chain_axis_of(chain, &at);
}

/* p turned about the i-th axis, sense 1, or back, -1. */
static inline struct vec3 turn_about(const struct kinematic_chain *chain, int i, struct vec3 p,
                                     const struct turned *at, int sense)
{
    const struct rotary *r = &chain->rotary[i];
    struct vec3 arm = vec_sub(p, r->centre);
    return vec_add(r->centre, vec_turn_by(arm, r->axis, at->cosine[i], sense * at->sine[i]));
}

/* How far the head's axes carry the tip from where it is at zero. */
static struct vec3 head_offset(const struct kinematic_chain *chain, const struct turned *at)
{
    struct vec3 tip = vec(0, 0, 0);
    for (int i = chain->n - 1; i >= 0 && !chain->rotary[i].table; i--)
        tip = turn_about(chain, i, tip, at, 1);
    return tip;
}

struct vec3 chain_tip_of(const struct kinematic_chain *chain, struct vec3 linear,
                         const struct turned *at)
{
    struct vec3 tip = vec_add(linear, head_offset(chain, at));
    for (int i = chain->n - 1; i >= 0; i--)
        if (chain->rotary[i].table)
            tip = turn_about(chain, i, tip, at, 1);
    return tip;
}

struct vec3 chain_tip(const struct kinematic_chain *chain, struct vec3 linear, const double q[])
{
    struct turned at = chain_turned(chain, q);
    return chain_tip_of(chain, linear, &at);
}

struct vec3 chain_linear_of(const struct kinematic_chain *chain, struct vec3 tip,
                            const struct turned *at)
{
    for (int i = 0; i < chain->n; i++)
        if (chain->rotary[i].table)
            tip = turn_about(chain, i, tip, at, -1);
    bool head = chain->n > 0 && !chain->rotary[chain->n - 1].table;
    return head ? vec_sub(tip, head_offset(chain, at)) : tip;
}

struct vec3 chain_linear(const struct kinematic_chain *chain, struct vec3 tip, const double q[])
{
    struct turned at = chain_turned(chain, q);
    return chain_linear_of(chain, tip, &at);
}

/* The angle about the unit vector `axis` that turns `from` to `to`. */
static double turn_between(struct vec3 axis, struct vec3 from, struct vec3 to)
{
    from = vec_reject(from, axis);
    to = vec_reject(to, axis);
    return atan2(vec_dot(axis, vec_cross(from, to)), vec_dot(from, to));
}

static double clamp_sine(double angle)
{
    double s = sin(angle);
    return s > 0 ? s : 0;
}

static struct chain_triangle triangle_of(const struct kinematic_chain *chain)
{
    struct vec3 u0 = chain->rotary[0].axis, u1 = chain->rotary[1].axis;
    return (struct chain_triangle){vec_angle(u0, u1), vec_angle(u1, chain->tool),
                                   turn_between(u1, chain->tool, u0)};
}

void chain_measure(struct kinematic_chain *chain)
{
    chain->measured = chain->n == 2;
    if (chain->measured)
        chain->triangle = triangle_of(chain);
}

static struct chain_solutions angles_of_two(const struct kinematic_chain *chain, struct vec3 axis)
{
    struct vec3 u0 = chain->rotary[0].axis, u1 = chain->rotary[1].axis;
    struct chain_triangle triangle = chain->measured ? chain->triangle : triangle_of(chain);
    double between = triangle.between, tool = triangle.tool;
    double wanted = vec_angle(u0, axis);
    double least = fabs(between - tool), most = fmin(between + tool, 2 * PI - between - tool);
    struct chain_solutions s = {0};
    if (wanted < least - reach || wanted > most + reach)
        return s;

    /* the triangle u0, u1, a: half the angle at u1 between u0 and a, opposite to `wanted` */
    double low =
        clamp_sine((wanted + between - tool) / 2) * clamp_sine((wanted - between + tool) / 2);
    double high =
        clamp_sine((between + tool + wanted) / 2) * clamp_sine((between + tool - wanted) / 2);
    double half = 2 * atan2(sqrt(low), sqrt(high));
    s.free = wanted < singular || PI - wanted < singular;
    s.n = 2;
    for (int i = 0; i < 2; i++) {
        double q1 = angle_remainder(triangle.zero + (i ? -half : half));
        s.q[i][1] = q1;
        s.q[i][0] = s.free ? 0 : turn_between(u0, vec_turn(chain->tool, u1, q1), axis);
    }
    return s;
}

static struct chain_solutions angle_of_one(const struct kinematic_chain *chain, struct vec3 axis)
{
    struct chain_solutions s = {0};
    struct vec3 u = chain->rotary[0].axis;
    s.q[0][0] = turn_between(u, chain->tool, axis);
    s.n = vec_angle(vec_turn(chain->tool, u, s.q[0][0]), axis) <= reach;
    return s;
}

void chain_zero(const struct kinematic_chain *chain, double q[])
{
    for (int i = 0; i < ROTARY_MAX; i++) {
        const struct rotary *r = &chain->rotary[i];
        q[i] = i < chain->n ? fmin(fmax(0, r->min), r->max) : 0;
    }
}

bool chain_free(const struct kinematic_chain *chain, struct vec3 axis)
{
    struct vec3 off = vec_cross(chain->rotary[0].axis, axis);
    return chain->n == 2 && vec_dot(off, off) < singular * singular;
}

double chain_most_lean(const struct kinematic_chain *chain, struct vec3 pole)
{
    struct chain_triangle t = triangle_of(chain);
    double sum = t.between + t.tool;

    return vec_dot(pole, chain->rotary[0].axis) > 0 ? fmin(sum, 2 * PI - sum)
                                                    : PI - fabs(t.between - t.tool);
}

struct chain_solutions chain_angles(const struct kinematic_chain *chain, struct vec3 axis)
{
    if (chain->n == 2)
        return angles_of_two(chain, axis);
    if (chain->n == 1)
        return angle_of_one(chain, axis);
    return (struct chain_solutions){.n = vec_angle(chain->tool, axis) <= reach};
}
