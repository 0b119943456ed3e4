/*
 * ik_near - the rotary angles of a tool axis beside those where the axes stand, for each of
 * millions of places: hence inline, and with as little trigonometry as can be.
 */
#ifndef CLOUDMILL_IK_NEAR_H
#define CLOUDMILL_IK_NEAR_H

#include "machine/kinematics.h"

/*
 * What does not change of a chain of two axes while ik_near is asked again and again.  In the
 * frame of the first axis and two directions across it, component i of the tool axis is
 * still[i] + cosine[i] cos q1 + sine[i] sin q1, before the first axis turns.
 */
struct ik_near_table {
    const struct kinematic_chain *chain;
    struct vec3 up, side, front;
    double still[3], cosine[3], sine[3];
    double h, h2, per; /* length of cosine[0], sine[0]; its square, and 1 by that */
};

struct ik_near_table ik_near_table(const struct kinematic_chain *chain);

/* Component i of the tool in the frame of the table, when the second axis is turned. */
static inline double ik_component(const struct ik_near_table *w, int i, double c1, double s1)
{
    return w->still[i] + w->cosine[i] * c1 + w->sine[i] * s1;
}

#define IK_TURNED_MOST 0.01 /* radians */

/* Each angle by[i] further, no more than IK_TURNED_MOST: to 1e-15. */
static inline struct turned ik_turned_on(const struct turned *from, const double by[])
{
    struct turned t;
    for (int i = 0; i < ROTARY_MAX; i++) {
        double d = by[i], d2 = d * d, c = 1 - d2 * (1.0 / 2), s = d - d * d2 * (1.0 / 6);
        if (d2 > 1e-8) {
            c = 1 - d2 * (1.0 / 2 - d2 * (1.0 / 24 - d2 * (1.0 / 720)));
            s = d * (1 - d2 * (1.0 / 6 - d2 * (1.0 / 120)));
        }
        t.cosine[i] = from->cosine[i] * c - from->sine[i] * s;
        t.sine[i] = from->sine[i] * c + from->cosine[i] * s;
    }
    return t;
}

/* chain_axis_of for a chain of two axes. */
static inline struct vec3 ik_near_axis(const struct ik_near_table *w, const struct turned *at)
{
    double c0 = at->cosine[0], s0 = at->sine[0], c1 = at->cosine[1], s1 = at->sine[1];
    double side = ik_component(w, 1, c1, s1), front = ik_component(w, 2, c1, s1);
    struct vec3 a = vec_scale(ik_component(w, 0, c1, s1), w->up);
    return vec_along(vec_along(a, c0 * side - s0 * front, w->side), s0 * side + c0 * front,
                     w->front);
}

/* The angle of that cosine and sine nearest to `from`, whose own are in `was`: by the sine's
 * inverse series where it is near. */
static inline double ik_angle_near(double from, const struct turned *was, int i, double cosine,
                                   double sine)
{
    double s = sine * was->cosine[i] - cosine * was->sine[i], s2 = s * s;
    if (s2 < 1e-4 && cosine * was->cosine[i] + sine * was->sine[i] > 0)
        return from + s * (1 + s2 * (1.0 / 6 + s2 * (3.0 / 40)));
    double q = atan2(sine, cosine);
    return q + 2 * PI * round((from - q) / (2 * PI));
}

/* 1 / |a|, for unit vectors without a root. */
static inline double ik_inverse_length(struct vec3 a)
{
    double l2 = vec_dot(a, a);
    return fabs(l2 - 1) < 1e-8 ? 1.5 - 0.5 * l2 : 1 / sqrt(l2);
}

/*
 * ik_choose with `smooth` in the usual case, in a fraction of the time: two axes, a direction
 * half a degree or more from the singular one, and the solution on the side where `from` is moves
 * less than the other one can.  `was` belongs to `from` and `now` to q; they may be the same.
 * False: look closer, nothing is changed.
 *
 * The component of a along u0 is k0 + b cos q1 + c sin q1, so with root^2 = b^2 + c^2 - k^2 the
 * cosine and sine of both q1 are known without an angle.  Turned by q1, t is as far from u0 as a
 * is: the lengths of what is across u0 need no root either, but one step of Newton's.
 */
static inline bool ik_near(const struct ik_near_table *w, struct vec3 axis, const double from[],
                           const struct turned *was, double q[], struct turned *now)
{
    const double steep = 1e-4; /* of h^2: half a degree from the singular direction */
    const struct kinematic_chain *chain = w->chain;
    const struct rotary *r0 = &chain->rotary[0], *r1 = &chain->rotary[1];
    if (chain->n != 2)
        return false;
    double unit = ik_inverse_length(axis), up = unit * vec_dot(w->up, axis);
    double b = w->cosine[0], c = w->sine[0], k = up - w->still[0];
    double root2 = w->h2 - k * k, flat = 1 - up * up;
    if (!(root2 > steep * w->h2 && flat > steep))
        return false;
    double root = sqrt(root2), per = w->per;
    double sign = c * was->cosine[1] - b * was->sine[1] > 0 ? -root : root;
    double c1 = (b * k - c * sign) * per, s1 = (c * k + b * sign) * per;
    double x = unit * vec_dot(w->side, axis), y = unit * vec_dot(w->front, axis);
    double side = ik_component(w, 1, c1, s1), front = ik_component(w, 2, c1, s1);
    double c0 = side * x + front * y, s0 = side * y - front * x;
    double scale = 1 / flat, far2 = (c0 * c0 + s0 * s0) * scale * scale;
    c0 *= scale;
    s0 *= scale;
    double q0 = ik_angle_near(from[0], was, 0, c0, s0);
    double q1 = ik_angle_near(from[1], was, 1, c1, s1);
    if (q0 > r0->max || q0 < r0->min || q1 > r1->max || q1 < r1->min)
        return false;
    double move0 = fabs(q0 - from[0]), move1 = fabs(q1 - from[1]);
    if (!(2 * root > w->h * (2 * move1 + move0 + 1e-6))) /* twice the sine: the other's way */
        return false;
    q[0] = q0; /* last, for q may be where `from` stands */
    q[1] = q1;
    far2 = 1.5 - 0.5 * far2;
    *now = (struct turned){{far2 * c0, c1}, {far2 * s0, s1}};
    return true;
}

#endif
