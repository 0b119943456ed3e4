/* holder - see holder.h. */
#include "gouge/holder.h"

double holder_reach(const struct holder *holder)
{
    double reach = 0, height = 0;
    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        reach = fmax(reach, hypot(part->low, height));
        height += part->length;
        reach = fmax(reach, hypot(part->high, height));
    }
    return reach;
}

/* A place beside the axis: how far from it, and how high. */
struct place {
    double r, h;
};

/* Squared distance of p from the segment. */
static double to_segment2(struct place a, struct place b, struct place p)
{
    double dr = b.r - a.r, dh = b.h - a.h, l2 = dr * dr + dh * dh;
    double r = p.r - a.r, h = p.h - a.h, along = dr * r + dh * h;
    double s = along <= 0 ? 0 : along >= l2 ? 1 : along / l2;
    r -= s * dr;
    h -= s * dh;
    return r * r + h * h;
}

static double smaller(double a, double b)
{
    return a < b ? a : b;
}

/* The same of one cylinder, for most tools are no more: a rectangle beside the axis. */
static double to_cylinder(const struct holder_part *part, struct place at)
{
    double aside = at.r - part->low, along = fabs(at.h - part->length / 2) - part->length / 2;
    double most = aside > along ? aside : along;
    if (aside > 0 && along > 0)
        return sqrt(aside * aside + along * along);
    return most;
}

double holder_distance(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                       struct vec3 p)
{
    struct vec3 d = vec_sub(p, centre);
    double h = vec_dot(d, axis);
    const struct place at = {vec_length(vec_along(d, -h, axis)), h};
    struct place last = {0, 0}; /* the outline from the axis outward and up, and back to it */
    double least = HUGE_VAL;
    bool inside = false;
    if (holder->n == 0)
        return HUGE_VAL;
    if (holder->n == 1 && holder->part[0].low == holder->part[0].high)
        return to_cylinder(&holder->part[0], at);
    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        const struct place low = {part->low, last.h}, high = {part->high, last.h + part->length};
        double share = (at.h - low.h) / part->length;
        least = smaller(least, to_segment2(last, low, at));
        least = smaller(least, to_segment2(low, high, at));
        inside = inside ||
                 (share >= 0 && share <= 1 && at.r < part->low + share * (part->high - part->low));
        last = high;
    }
    least = sqrt(smaller(least, to_segment2(last, (struct place){0, last.h}, at)));
    return inside ? -least : least;
}

/* Squared distance of the segment from the corner of the box that is furthest from it. */
static double to_corners2(struct place a, struct place b, struct place middle, struct place half)
{
    double most = 0;
    for (int k = 0; k < 4; k++) {
        struct place corner = {middle.r + (k % 2 ? half.r : -half.r),
                               middle.h + (k / 2 ? half.h : -half.h)};
        corner.r = corner.r < 0 ? 0 : corner.r;
        most = -smaller(-most, -to_segment2(a, b, corner));
    }
    return most;
}

double holder_bound(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                    struct vec3 middle, struct vec3 half)
{
    double spread = vec_length(half);
    double bound = holder_distance(holder, centre, axis, middle) - spread;
    if (bound >= 0)
        return bound;
    struct vec3 d = vec_sub(middle, centre);
    double h = vec_dot(d, axis), depth2 = HUGE_VAL;
    const struct place at = {vec_length(vec_along(d, -h, axis)), h};
    const struct place reach = {spread, fabs(half.x * axis.x) + fabs(half.y * axis.y) +
                                            fabs(half.z * axis.z)};
    struct place last = {0, 0};
    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        const struct place low = {part->low, last.h}, high = {part->high, last.h + part->length};
        depth2 = smaller(depth2, to_corners2(last, low, at, reach));
        depth2 = smaller(depth2, to_corners2(low, high, at, reach));
        last = high;
    }
    depth2 = smaller(depth2, to_corners2(last, (struct place){0, last.h}, at, reach));
    return fmax(bound, -sqrt(depth2));
}

struct tool_body tool_body_usual(double radius)
{
    return (struct tool_body){.flute = TOOL_FLUTE * radius};
}

/* Adds a part, as one with the last where that goes on straight. */
static void add_part(struct holder *holder, double low, double high, double length)
{
    struct holder_part *last = &holder->part[holder->n > 0 ? holder->n - 1 : 0];
    if (length <= 0)
        return;
    if (holder->n > 0 && fabs(last->high - low) < 1e-9 &&
        fabs((last->high - last->low) * length - (high - low) * last->length) < 1e-9) {
        last->high = high;
        last->length += length;
    } else {
        holder->part[holder->n++] = (struct holder_part){low, high, length};
    }
}

/* The part between two heights of it, no thinner than `radius`. */
static void add_thickened(struct holder *holder, const struct holder_part *part, double from,
                          double to, double radius)
{
    double slope = (part->high - part->low) / part->length;
    double low = part->low + slope * from, high = part->low + slope * to;
    double cross = slope != 0 ? (radius - part->low) / slope : from;
    if (to <= from)
        return;
    if (cross <= from || cross >= to) {
        bool over = low + high > 2 * radius;
        add_part(holder, over ? low : radius, over ? high : radius, to - from);
        return;
    }
    add_part(holder, fmax(low, radius), radius, cross - from);
    add_part(holder, radius, fmax(high, radius), to - cross);
}

struct holder tool_body_profile(const struct tool_body *body, double radius)
{
    struct holder both = {0};
    double height = 0;
    if (body->ball_only)
        return both;
    for (int i = 0; i < body->above.n; i++) {
        const struct holder_part *part = &body->above.part[i];
        double beside = fmin(fmax(body->flute - height, 0), part->length);
        add_thickened(&both, part, 0, beside, radius);
        add_thickened(&both, part, beside, part->length, 0);
        height += part->length;
    }
    add_part(&both, radius, radius, body->flute - height);
    return both;
}

struct holder holder_widened(const struct holder *holder, double margin, double slope)
{
    struct holder wide = *holder;
    double height = 0;
    for (int i = 0; i < wide.n; i++) {
        struct holder_part *part = &wide.part[i];
        part->low += margin + slope * height;
        height += part->length;
        part->high += margin + slope * height;
    }
    if (wide.n > 0 && wide.n < HOLDER_MOST && margin > 0) {
        double radius = wide.part[wide.n - 1].high;
        wide.part[wide.n++] = (struct holder_part){radius, radius, margin};
    }
    return wide;
}
