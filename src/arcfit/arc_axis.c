/* arc_axis - see arc_axis.h. */
#include "arc_axis.h"

enum { SAMPLES = 8 }; /* points looked at on a piece, at most; more on very short ones */

/* Sideways at point k: across the other point's path and across the axis; only a turn of the axis
 * in this direction takes the other point off its path. */
static struct vec3 sideways_direction(const struct reference *t, size_t k)
{
    size_t before = k > 0 ? k - 1 : k, after = k + 1 < t->n ? k + 1 : k;
    struct vec3 ahead = vec_sub(t->other[after], t->other[before]);
    return vec_unit(vec_cross(vec_unit(ahead), t->axis[k]));
}

/* How far sideways_direction the other point is from point k when the piece is at s, mm. */
static double sideways_error(const struct reference *t, const struct arc_piece *piece, size_t k,
                             double s, struct vec3 side)
{
    struct vec3 axis = vec_mix(piece->axis, piece->axis_to, s);
    struct vec3 other = vec_along(arc_at(&piece->arc, s), t->offset, vec_unit(axis));
    return vec_dot(vec_sub(t->other[k], other), side);
}

static double clamp(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

struct vec3 arc_axis_end(const struct reference *reference, const struct arc_piece *piece,
                         const struct deviation *within, double part, int digits)
{
    size_t from = (size_t)piece->from, to = (size_t)piece->to;
    size_t stride = (to - from) / SAMPLES + 1;
    double sum = 0, weight = 0;
    for (size_t k = to; k > from; k = k > from + stride ? k - stride : from) {
        double s = arc_foot(&piece->arc, reference->point[k]);
        sum += s * sideways_error(reference, piece, k, s, sideways_direction(reference, k));
        weight += s * s;
    }
    struct vec3 side = sideways_direction(reference, to);
    double offset = reference->offset;
    if (weight <= 0 || offset == 0 || vec_dot(side, side) < 0.5)
        return piece->axis_to;
    double end = sideways_error(reference, piece, to, 1, side), room = part * within->other;
    double shift = clamp(sum / weight, end - room, end + room) / offset;
    double most =
        fmin(part * within->axis, ARC_BEARING * hypot(piece->axis_to.x, piece->axis_to.y));
    shift = clamp(shift, -most, most);
    struct vec3 axis = vec_unit(vec_along(piece->axis_to, shift, side));
    return vec_unit(vec_round(reference_flat_axis(reference, axis), digits));
}
