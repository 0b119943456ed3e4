/* link - see link.h. */
#include "gouge/link.h"

#include "gouge/axis_smooth.h"
#include "gouge/holder_avoid.h"

enum { FEWEST_PARTS = 4, MOST_PARTS = 64 };

/* A direction flatter than this does not lead to the clearance plane: sin 10 degrees. */
static const double FLAT = 0.17364817766693033;

static const double ARCH = 0.4; /* times s (1 - s), of the length: a tenth in the middle */

/* The direction out of the material, as far as the point knows. */
static struct vec3 outward_direction(const struct run_point *p)
{
    return vec_length(p->normal) > 0 ? p->normal : p->axis;
}

/* The arch in `parts` equal parts; false if it is not clear. */
static bool try_arch(const struct gouge_lift_options *lift, const struct run_point *from,
                     const struct run_point *to, size_t parts, double limit, struct run *link)
{
    double length = vec_distance(from->ball, to->ball);
    struct run_point before = *from;

    for (size_t i = 1; i <= parts; i++) {
        double s = (double)i / (double)parts, arch = ARCH * s * (1 - s) * length;
        struct vec3 up = vec_slerp(outward_direction(from), outward_direction(to), s);
        struct run_point p = {.axis = vec_slerp(from->axis, to->axis, s)};
        p.ball = vec_along(vec_mix(from->ball, to->ball, s), arch, up);
        double rise = gouge_least_lift(lift->guard, p.ball, up, lift->offset, limit, NULL);
        p.ball = vec_along(p.ball, rise, up);
        p.tip = vec_along(p.ball, -link->radius, p.axis);
        if (rise < 0 ||
            gouge_depth_along(lift->guard, before.ball, p.ball, lift->offset) > lift->tolerance)
            return false;
        before = p;
        if (i < parts)
            *array_push(link) = p;
    }
    return true;
}

static bool find_arch(const struct link_options *options, const struct run_point *from,
                      const struct run_point *to, struct run *link)
{
    size_t n = link->n;

    if (!options->lift->guard)
        return true;
    for (size_t parts = FEWEST_PARTS; parts <= MOST_PARTS; parts *= 2) {
        link->n = n;
        if (try_arch(options->lift, from, to, parts, options->limit, link))
            return true;
    }
    link->n = n;
    return false;
}

/* Shank and holder go clear from one pose to the other. */
static bool is_holder_clear(const struct link_options *options, const struct run_point *from,
                            const struct run_point *to)
{
    const struct gouge_lift_options *lift = options->lift;
    struct holder_avoid_options rule = {lift->guard, options->holder, 0, 2 * lift->tolerance};

    return options->holder->n == 0 || !lift->guard || holder_clear_between(&rule, from, to);
}

/* The axis turns no faster than it may, and shank and holder are clear, on the link from point
 * `first` of it on. */
static bool is_link_free(const struct link_options *options, const struct run_point *from,
                         const struct run_point *to, const struct run *link, size_t first)
{
    struct run_point before = *from;

    for (size_t i = first; i <= link->n; i++) {
        struct run_point ends[2] = {before, i < link->n ? link->item[i] : *to};
        struct run both = {.n = 2, .item = ends, .radius = options->radius};
        if ((options->rate > 0 && axis_smooth_fastest(&both) > options->rate) ||
            !is_holder_clear(options, &ends[0], &ends[1]))
            return false;
        before = ends[1];
    }
    return true;
}

bool link_low(const struct link_options *options, const struct run_point *from,
              const struct run_point *to, struct run *link)
{
    size_t n = link->n;

    return find_arch(options, from, to, link) && is_link_free(options, from, to, link, n);
}

/* How far to go in a direction: to the clearance plane, which is `rise` above, or where that is
 * too flat to where the part ends. */
static double length_out(const struct link_options *options, struct vec3 from,
                         struct vec3 direction, double rise)
{
    if (direction.z > FLAT)
        return rise / direction.z;
    if (!options->lift->guard)
        return 0;
    return fmax(0, gouge_extent(options->lift->guard, from, direction) + options->lift->offset);
}

/* Shank and holder go clear from one place to the other with the axis of p. */
static bool is_move_clear(const struct link_options *options, const struct run_point *p,
                          struct vec3 from, struct vec3 to)
{
    struct run_point a = {.ball = from, .axis = p->axis}, b = {.ball = to, .axis = p->axis};

    return is_holder_clear(options, &a, &b);
}

static struct retract retract_along(const struct link_options *options, const struct run_point *p,
                                    struct vec3 direction)
{
    const struct gouge_check *guard = options->lift->guard;
    double offset = options->lift->offset, tolerance = options->lift->tolerance;
    double plane = options->clearance + options->radius * p->axis.z;
    struct retract r = {.near = vec_along(p->ball, options->approach, direction), .clear = true};
    double out = length_out(options, r.near, direction, fmax(0, plane - r.near.z));

    r.out = vec_along(r.near, out, direction);
    r.top = r.out;
    if (plane > r.out.z + 1e-6)
        r.top.z = plane;
    if (guard) {
        double depth = fmax(gouge_depth_along(guard, p->ball, r.out, offset),
                            gouge_depth_along(guard, r.out, r.top, offset));
        r.clear = depth <= fmax(gouge_depth(guard, p->ball, offset), 0) + tolerance &&
                  is_move_clear(options, p, p->ball, r.out) &&
                  is_move_clear(options, p, r.out, r.top);
    }
    return r;
}

struct retract link_retract(const struct link_options *options, const struct run_point *p)
{
    struct retract along_axis = retract_along(options, p, p->axis);
    if (along_axis.clear)
        return along_axis;
    struct retract straight_up = retract_along(options, p, vec(0, 0, 1));
    return straight_up.clear ? straight_up : along_axis;
}
