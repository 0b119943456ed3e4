/* post_arc - see post_arc.h. */
#include "post_arc.h"

#include "base/num.h"

static const double short_arc = 10; /* last digits: its centre would be anywhere */

double nc_arc_most(enum nc_arcs kind)
{
    if (kind == NC_ARCS_CENTRE || kind == NC_ARCS_FLAT)
        return 2 * PI;
    return RADIANS(kind == NC_ARCS_RADIUS ? 120 : 170);
}

/* The principal direction nearest to the arc's axis, pointing the same way; its plane. */
static struct vec3 principal_direction(struct vec3 axis, struct nc_arc *arc)
{
    double x = fabs(axis.x), y = fabs(axis.y), z = fabs(axis.z);
    struct vec3 e = z >= x && z >= y ? vec(0, 0, 1) : y >= x ? vec(0, 1, 0) : vec(1, 0, 0);
    arc->plane = e.z > 0 ? 17 : e.y > 0 ? 18 : 19;
    arc->ccw = vec_dot(axis, e) > 0;
    return vec_scale(arc->ccw ? 1 : -1, e);
}

struct motion nc_arc_motion(const struct nc_arc *arc, const struct block_pose *from,
                            const struct block_pose *to)
{
    struct pose start = {from->p, arc->axis}, end = {to->p, arc->axis};
    return motion_arc(start, end, vec_add(from->p, arc->centre), arc->axis);
}

double nc_arc_length(const struct nc_arc *arc, const struct block_pose *from,
                     const struct block_pose *to)
{
    struct motion forth = nc_arc_motion(arc, from, to), back = forth;
    back.from = forth.to;
    back.to = forth.from;
    return fmin(motion_length(&forth), motion_length(&back));
}

/*
 * I J K: the true centre moved onto the line of points that are as far from both printed ends, so
 * that rounding the ends leaves no difference of radius.
 */
static bool centre_words(struct nc_arc *arc, int digits, double radius_error, struct vec3 centre,
                         struct vec3 axis, struct vec3 from, struct vec3 to)
{
    struct vec3 chord = vec_reject(vec_sub(to, from), axis);
    struct vec3 c = vec_reject(vec_sub(centre, from), axis);
    double length2 = vec_dot(chord, chord);
    if (length2 > 0)
        c = vec_along(c, 0.5 - vec_dot(c, chord) / length2, chord);
    arc->centre = vec_round(c, digits);
    double r0 = vec_length(arc->centre), r1 = vec_distance(arc->centre, chord);
    return r0 > 0 && fabs(r0 - r1) < radius_error;
}

/* R, and with it the centre that the control will find. */
static bool radius_words(struct nc_arc *arc, int digits, double radius, double sweep,
                         struct vec3 axis, struct vec3 from, struct vec3 to)
{
    struct vec3 chord = vec_reject(vec_sub(to, from), axis);
    double half = vec_length(chord) / 2;
    arc->radius = num_round(radius, digits);
    if (half == 0 || arc->radius <= half)
        return false;
    double height = sqrt(arc->radius * arc->radius - half * half);
    struct vec3 aside = vec_unit(vec_cross(axis, chord)); /* left of the chord: less than half */
    if (sweep > PI)
        arc->radius = -arc->radius;
    arc->centre = vec_along(vec_scale(0.5, chord), sweep > PI ? -height : height, aside);
    return true;
}

/* Circle through three points: its centre from `a`, and its axis; false: too near to a line. */
static bool circle_of(struct vec3 a, struct vec3 b, struct vec3 c, int digits, struct vec3 *centre,
                      struct vec3 *axis)
{
    struct vec3 u = vec_sub(b, a), v = vec_sub(c, a), n = vec_cross(u, v);
    double n2 = vec_dot(n, n), side = fmax(vec_length(v), vec_length(u));
    if (!(sqrt(n2) > 20 * pow(10, -digits) * side)) /* the height of the triangle in last digits */
        return false;
    struct vec3 across = vec_sub(vec_scale(vec_dot(v, v), vec_cross(n, u)),
                                 vec_scale(vec_dot(u, u), vec_cross(n, v)));
    *centre = vec_scale(1 / (2 * n2), across);
    *axis = vec_scale(1 / sqrt(n2), n);
    return true;
}

static bool words_of(struct nc_arc *arc, enum nc_arcs kind, int digits, double radius_error,
                     const struct interpolation *f, const struct block_pose *from,
                     const struct block_pose *to, const struct motion *motion, double s0, double s1,
                     struct pose_deviation *d, double *point)
{
    double sweep = (s1 - s0) * motion->sweep;
    struct vec3 axis;
    *arc = (struct nc_arc){0};
    if (sweep > nc_arc_most(kind) + 1e-6)
        return false;
    if (kind == NC_ARCS_SPACE) {
        arc->middle = vec_round(motion_at(motion, (s0 + s1) / 2).p, digits);
        if (!circle_of(from->p, arc->middle, to->p, digits, &arc->centre, &axis))
            return false;
    } else {
        axis = principal_direction(motion->axis, arc);
        if (sweep < 1 && vec_distance(from->p, to->p) < short_arc * pow(10, -digits))
            return false;
        arc->full = vec_distance(from->p, to->p) == 0;
        double radius = vec_length(vec_reject(vec_sub(motion->from.p, motion->centre), axis));
        if (kind == NC_ARCS_FLAT &&
            (arc->plane != 17 || from->p.z != to->p.z || vec_distance(from->a, to->a) > 0))
            return false;
        if (kind != NC_ARCS_RADIUS &&
            !centre_words(arc, digits, radius_error, motion->centre, axis, from->p, to->p))
            return false;
        if (kind == NC_ARCS_RADIUS &&
            !radius_words(arc, digits, radius, sweep, axis, from->p, to->p))
            return false;
    }
    arc->axis = axis;
    struct motion printed = nc_arc_motion(arc, from, to);
    *d = interpolation_curve(f, from, to, &printed, motion, s0, s1, point);
    return true;
}

bool nc_arc_words(struct nc_arc *arc, enum nc_arcs kind, int digits, double radius_error,
                  const struct interpolation *f, const struct block_pose *from,
                  const struct block_pose *to, const struct motion *motion, double s0, double s1,
                  struct pose_deviation *d, double *point)
{
    if (kind != NC_ARCS_BOTH)
        return words_of(arc, kind, digits, radius_error, f, from, to, motion, s0, s1, d, point);
    struct nc_arc space;
    struct pose_deviation of_space;
    double point_of_space;
    bool flat =
        words_of(arc, NC_ARCS_CENTRE, digits, radius_error, f, from, to, motion, s0, s1, d, point);
    if (flat && *point <= radius_error)
        return true;
    if (!words_of(&space, NC_ARCS_SPACE, digits, radius_error, f, from, to, motion, s0, s1,
                  &of_space, &point_of_space))
        return flat;
    *arc = space;
    *d = of_space;
    *point = point_of_space;
    return true;
}
