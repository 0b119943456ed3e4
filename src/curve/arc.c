/*
 * arc - see arc.h.
 *
 * Points are reckoned from the start and not from the centre, as from + chord (cos(u/2) t +
 * sin(u/2) inward) with the chord 2 R sin(u/2), so that an arc of a very large radius is as exact
 * as a small one.
 */
#include "curve/arc.h"

static const double SAGITTA_MIN = 1e-6; /* mm */

struct arc arc_line(struct vec3 from, struct vec3 to)
{
    return (struct arc){.from = from, .to = to, .tangent = vec_unit(vec_sub(to, from))};
}

struct arc arc_to(struct vec3 from, struct vec3 tangent, struct vec3 to)
{
    if (vec_dot(tangent, tangent) <= 0) /* of a piece of no length: it tells no plane */
        return arc_line(from, to);
    tangent = vec_unit(tangent);
    struct vec3 e = vec_sub(to, from), p = vec_reject(e, tangent);
    double ahead = vec_dot(e, tangent), aside = vec_length(p), e2 = vec_dot(e, e);
    double angle = 2 * atan2(aside, ahead);
    double sagitta = sqrt(e2) / 2 * fabs(tan(angle / 4));
    if (sagitta < SAGITTA_MIN || aside <= 0)
        return arc_line(from, to);
    return (struct arc){.from = from,
                        .to = to,
                        .tangent = tangent,
                        .inward = vec_unit(vec_reject(vec_scale(1 / aside, p), tangent)),
                        .radius = e2 / (2 * aside),
                        .angle = angle};
}

struct arc arc_about(struct vec3 from, struct vec3 to, struct vec3 centre, struct vec3 axis)
{
    struct vec3 out = vec_reject(vec_sub(from, centre), axis);
    double radius = vec_length(out);
    if (radius <= 0)
        return arc_line(from, to);
    out = vec_unit(out);
    struct vec3 ahead = vec_cross(axis, out), end = vec_sub(to, centre);
    double angle = atan2(vec_dot(end, ahead), vec_dot(end, out));
    if (angle <= 0 || vec_distance(from, to) <= 0)
        angle += 2 * PI;
    struct arc arc = {.from = from,
                      .tangent = ahead,
                      .inward = vec_scale(-1, out),
                      .radius = radius,
                      .angle = angle};
    arc.drift = vec_sub(to, arc_at(&arc, 1));
    arc.to = to;
    return arc;
}

bool arc_straight(const struct arc *arc)
{
    return arc->radius <= 0;
}

struct vec3 arc_centre(const struct arc *arc)
{
    return vec_along(arc->from, arc->radius, arc->inward);
}

struct vec3 arc_axis(const struct arc *arc)
{
    return vec_unit(vec_cross(arc->tangent, arc->inward));
}

double arc_length(const struct arc *arc)
{
    return arc_straight(arc) ? vec_distance(arc->from, arc->to) : arc->radius * arc->angle;
}

struct vec3 arc_at(const struct arc *arc, double s)
{
    if (arc_straight(arc))
        return vec_mix(arc->from, arc->to, s);
    return arc_by_half(arc, s, elementary_sine_cosine(s * arc->angle / 2));
}

struct vec3 arc_by_half(const struct arc *arc, double s, struct sine_cosine half)
{
    if (arc_straight(arc))
        return vec_mix(arc->from, arc->to, s);
    double chord = 2 * arc->radius * half.sine;
    struct vec3 p = vec_along(arc->from, chord * half.cosine, arc->tangent);
    p = vec_along(p, chord * half.sine, arc->inward);
    return vec_along(p, s, arc->drift);
}

struct vec3 arc_tangent(const struct arc *arc, double s)
{
    struct sine_cosine u = elementary_sine_cosine(s * arc->angle);
    return vec_unit(vec_along(vec_scale(u.cosine, arc->tangent), u.sine, arc->inward));
}

double arc_foot(const struct arc *arc, struct vec3 p)
{
    struct vec3 w = vec_sub(p, arc->from);
    if (arc_straight(arc)) {
        double l = vec_distance(arc->from, arc->to);
        return l > 0 ? fmin(1, fmax(0, vec_dot(w, arc->tangent) / l)) : 0;
    }
    double u = atan2(vec_dot(w, arc->tangent), arc->radius - vec_dot(w, arc->inward));
    if (u < (arc->angle - 2 * PI) / 2) /* nearer to the end, the other way round */
        u += 2 * PI;
    return fmin(1, fmax(0, u / arc->angle));
}
