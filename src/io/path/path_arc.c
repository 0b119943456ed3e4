/* path_arc - see path_arc.h. */
#include "path_arc.h"

#include <math.h>

#include "path_feed.h"
#include "path_goto.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

/* The ends of an arc may be off its circle, its start off its plane, by so much, mm. */
static const double near = 0.01;

/* Start = end is a full circle, mm: the same digits.  NX leaves arcs of their last digit behind
 * others, which are no circles. */
static const double same = 2e-6;

/* Both ends of the arc must lie on its circle, the start in its plane. */
static int expect_on_circle(struct path_parse *p, struct vec3 point, const char *which)
{
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 d = vec_sub(point, arc->centre);
    double r = vec_length(vec_reject(d, arc->axis));
    if (fabs(r - arc->radius) > near)
        return error_at(AT(p),
                        "found the %s of a CIRCLE %.4f mm from its centre, expected its "
                        "radius %.4f",
                        which, r, arc->radius);
    return 0;
}

/* An arc from where the tool is; its centre goes to the height of the start. */
static void add_arc(struct path_parse *p, struct pose to)
{
    struct path_arc arc = p->circle.arc;
    double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
    if (fabs(height) > near)
        arc.centre = vec_along(arc.centre, height, arc.axis);
    struct motion motion = motion_arc(p->at, to, arc.centre, arc.axis);
    path_feed_inverse(p, motion_length(&motion));
    path_take_contact(p, path_add_arc(p->path, to, arc));
    p->at = to;
}

/* The turn from the start to the end, 0 to 2 pi, by the right-hand rule. */
static double turn_to(const struct path_parse *p, struct vec3 to)
{
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 u = vec_reject(vec_sub(p->at.p, arc->centre), arc->axis);
    struct vec3 v = vec_reject(vec_sub(to, arc->centre), arc->axis);
    double angle = atan2(vec_dot(vec_cross(u, v), arc->axis), vec_dot(u, v));
    return angle > 0 ? angle : angle + 2 * PI;
}

/* A helix of such an angle in pieces of half a turn at most, for an arc turns less than once. */
static void add_turns(struct path_parse *p, struct pose to, double angle)
{
    struct pose from = p->at;
    struct path_arc arc = p->circle.arc;
    size_t pieces = (size_t)ceil(angle / PI - 1e-9);
    struct vec3 spoke = vec_reject(vec_sub(from.p, arc.centre), arc.axis);
    struct vec3 foot = vec_sub(from.p, spoke);
    double rise = vec_dot(vec_sub(to.p, from.p), arc.axis);
    for (size_t i = 1; i < pieces; i++) {
        double s = (double)i / (double)pieces;
        struct vec3 at = vec_add(foot, vec_turn(spoke, arc.axis, s * angle));
        add_arc(p, (struct pose){vec_along(at, s * rise, arc.axis), vec_slerp(from.a, to.a, s)});
    }
    add_arc(p, to);
}

/* The arc that was said, to its end. */
int path_arc_to(struct path_parse *p, struct pose to)
{
    struct vec3 axis = p->circle.arc.axis, way = vec_sub(to.p, p->at.p);
    double rise = vec_dot(way, axis), off = vec_length(vec_reject(way, axis));
    bool closed = off < same;
    if (expect_on_circle(p, p->at.p, "start") < 0 || expect_on_circle(p, to.p, "end") < 0)
        return -1;
    if (closed) /* start = end: a full turn, to where it began */
        to.p = fabs(rise) > near ? vec_along(p->at.p, rise, axis) : p->at.p;
    double whole = 2 * PI * (p->circle.turns ? (double)p->circle.turns : 1);
    if (closed && (p->circle.turns || fabs(rise) > near))
        add_turns(p, to, whole);
    else if (p->circle.turns > 1)
        add_turns(p, to, whole - 2 * PI + turn_to(p, to.p));
    else
        add_arc(p, to);
    p->circle.open = false;
    p->circle.lasting = true;
    return 0;
}

bool path_arc_goes_on(struct path_parse *p, struct vec3 point)
{
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 d = vec_sub(point, arc->centre);
    if (!p->circle.lasting || fabs(vec_dot(d, arc->axis)) > near ||
        fabs(vec_length(d) - arc->radius) > near || vec_distance(point, p->at.p) < near)
        return false;
    p->circle.open = turn_to(p, point) < PI;
    return p->circle.open;
}

int path_begin_arc(struct path_parse *p, struct path_arc arc)
{
    if (!p->moved)
        return error_at(AT(p), "found %.20s before any position, expected a GOTO first",
                        p->apt.word);
    if (p->cycling)
        return error_at(AT(p), "found %.20s among the holes of a CYCLE, expected CYCLE/OFF first",
                        p->apt.word);
    if (!(arc.radius > 0) || !isfinite(arc.radius))
        return error_at(AT(p), "found a CIRCLE of radius %g, expected one above 0", arc.radius);
    if (path_expect_reach(p, arc.centre) < 0)
        return -1;
    double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
    if (fabs(height) > near)
        return error_at(AT(p),
                        "found the start of a CIRCLE %.4f mm off its plane, expected it there",
                        fabs(height));
    p->circle = (struct arc_parse){.open = true, .arc = arc};
    return 0;
}

/*
 * CIRCLE/centre, axis[, radius]: without its radius the position now says it.  With eleven numbers,
 * of NX and MAKINO-FF, the arc runs clockwise about its axis, and TIMES,n are turns of a helix.
 */
int path_read_circle(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    bool clockwise = n >= 11;
    double v[7], times = 0;
    struct path_arc arc;
    if (n != 6 && n != 7 && !clockwise)
        return error_at(AT(p), "found %zu numbers in CIRCLE, expected seven: centre, axis, radius",
                        n);
    if (path_numbers(p, 0, n == 6 ? 6 : 7, v, "centre, axis, radius") < 0 ||
        path_direction(p, v + 3, "a CIRCLE's axis", &arc.axis) < 0)
        return -1;
    arc.centre = path_point_of(p, v);
    if (apt_is(&p->apt, 11, "TIMES") && path_numbers(p, 12, 1, &times, "turns") < 0)
        return -1;
    if (!(times >= 0 && times <= 10000 && times == floor(times)))
        return error_at(AT(p), "found TIMES,%g in CIRCLE, expected a whole number", times);
    if (clockwise) {
        arc.axis = vec_scale(-1, arc.axis);
        double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
        arc.centre = vec_along(arc.centre, height, arc.axis); /* a helix may have it at its end */
    }
    arc.radius =
        n == 6 ? vec_length(vec_reject(vec_sub(p->at.p, arc.centre), arc.axis)) : p->unit * v[6];
    if (path_begin_arc(p, arc) < 0)
        return -1;
    p->circle.turns = (size_t)times;
    return 0;
}
