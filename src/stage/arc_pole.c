/* arc_pole - see arc_pole.h. */
#include "arc_pole.h"

#include "math/elementary.h"

static const double NONE = 1e-12;           /* of a unit vector: the axis is at the pole */
static const double STRAIGHT = RADIANS(10); /* between the planes before and after, no more */

static struct vec3 level(struct vec3 axis)
{
    return vec(axis.x, axis.y, 0);
}

bool arc_pole_at(const struct run *run, size_t i)
{
    const struct run_point *p = &run->item[i];

    return vec_length(level(p->axis)) < NONE && vec_length(level(p[-1].axis)) > NONE &&
           vec_length(level(p[1].axis)) > NONE;
}

struct vec3 arc_pole_plane(const struct run *run, size_t i)
{
    struct vec3 before = level(run->item[i - 1].axis), after = level(run->item[i + 1].axis);

    if (vec_dot(vec_unit(before), vec_unit(after)) > -cos(STRAIGHT))
        return vec(0, 0, 0);
    return vec_unit(vec_sub(before, after));
}

struct vec3 arc_pole_into(struct vec3 axis, struct vec3 plane)
{
    double lean = vec_length(level(axis));

    return vec_along(vec(0, 0, axis.z), vec_dot(axis, plane) < 0 ? -lean : lean, plane);
}

void arc_pole_turn(struct pieces *pieces, bool end, struct vec3 plane)
{
    struct arc_piece *before = &pieces->item[end ? pieces->n - 2 : 0], *after = before + 1;

    before->axis_to = after->axis = arc_pole_into(after->axis, plane);
}

void arc_pole_divide(const struct reference *reference, struct pieces *pieces, bool end, double s,
                     struct vec3 plane)
{
    size_t at = end ? pieces->n - 1 : 0;
    struct arc_piece whole = pieces->item[at], a = whole, b = whole;

    s = end ? 1 - s : s;
    struct vec3 joint = arc_at(&whole.arc, s);
    a.arc = arc_to(whole.arc.from, whole.arc.tangent, joint);
    b.arc = arc_to(joint, arc_tangent(&whole.arc, s), whole.arc.to);
    a.to = b.from = reference_place(reference, joint, whole.from + s * (whole.to - whole.from));
    a.biarc = b.biarc = false;
    a.axis_to = b.axis = reference_axis(reference, a.to);
    array_push(pieces);
    for (size_t i = pieces->n - 1; i > at + 1; i--)
        pieces->item[i] = pieces->item[i - 1];
    pieces->item[at] = a;
    pieces->item[at + 1] = b;
    arc_pole_turn(pieces, end, plane);
}
