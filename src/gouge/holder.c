/* holder - see holder.h. */
#include "gouge/holder.h"

static const double ROUNDING = 1e-9; /* mm */

struct holder holder_cornered(const struct holder *holder, double by)
{
    struct holder out = {.n = 0};

    if (holder->n == 0 || 2 * holder->n + 1 > HOLDER_MOST)
        return *holder;
    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        struct holder_part *below = i > 0 ? &out.part[out.n - 1] : NULL;
        if (below && part->low > below->high) {
            double lower = fmin(by, below->length);
            below->length -= lower;
            out.part[out.n++] = (struct holder_part){part->low, part->low, lower};
        }
        out.part[out.n++] = *part;
    }
    double top = out.part[out.n - 1].high;
    out.part[out.n++] = (struct holder_part){top, top, by};
    return out;
}

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

static bool is_cylinder(const struct holder *holder)
{
    return holder->n == 1 && holder->part[0].low == holder->part[0].high;
}

/* Signed distance of one cylinder, for most tools are no more, of a place so far outside it across
 * the axis and along it: a rectangle beside the axis. */
static double outside(double aside, double along)
{
    double most = aside > along ? aside : along;
    if (aside > 0 && along > 0)
        return sqrt(aside * aside + along * along);
    return most;
}

/* How far a height is beyond a part's ends. */
static double beyond(const struct holder_part *part, double h)
{
    return fabs(h - part->length / 2) - part->length / 2;
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
    if (is_cylinder(holder))
        return outside(at.r - holder->part[0].low, beyond(&holder->part[0], at.h));
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

/* How far a place, or all that is so far along from it either way, is outside the cylinders about
 * the parts; not above 0 if it is inside one. */
static double outside_all(const struct holder *holder, struct place at, double along)
{
    double least = HUGE_VAL;

    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        double apart = fmax(beyond(part, at.h) + part->length / 2 - along, 0) - part->length / 2;
        least = smaller(least, outside(at.r + smaller(-part->low, -part->high), apart));
        at.h -= part->length;
    }
    return least;
}

/* Of more than a cylinder; what is outside all parts by more is soon said. */
static double stack_distance_below(const struct holder *holder, struct vec3 centre,
                                   struct vec3 axis, struct vec3 p, double below)
{
    struct vec3 d = vec_sub(p, centre);
    double h = vec_dot(d, axis), least = below > 0 ? below : 0;
    const struct place at = {vec_length(vec_along(d, -h, axis)), h};

    if (outside_all(holder, at, 0) - ROUNDING > least)
        return least;
    return holder_distance(holder, centre, axis, p);
}

double holder_distance_below(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                             struct vec3 p, double below)
{
    const struct holder_part *part = &holder->part[0];

    if (!is_cylinder(holder))
        return stack_distance_below(holder, centre, axis, p, below);
    struct vec3 d = vec_sub(p, centre);
    double h = vec_dot(d, axis), along = beyond(part, h), far = part->low + below;
    if (along >= below)
        return along;
    struct vec3 aside = vec_along(d, -h, axis);
    double aside2 = vec_dot(aside, aside);
    if (far <= 0 || aside2 > far * far * (1 + 1e-12))
        return below;
    return outside(sqrt(aside2) - part->low, along);
}

/* How far a box that reaches `half` along X, Y and Z does along another direction. */
static double reach_along(struct vec3 half, struct vec3 way)
{
    return half.x * fabs(way.x) + half.y * fabs(way.y) + half.z * fabs(way.z);
}

/* X, Y or Z, if the box is flat along it. */
static bool is_flat(struct vec3 half, struct vec3 *along)
{
    const double flat = 0.1; /* of its largest reach */
    double least = fmin(half.x, fmin(half.y, half.z)), most = fmax(half.x, fmax(half.y, half.z));

    if (least > flat * most)
        return false;
    *along = half.x <= least ? vec(1, 0, 0) : half.y <= least ? vec(0, 1, 0) : vec(0, 0, 1);
    return true;
}

/* How near to the axis a box comes, whose middle is at d from a place of it and lies `aside`,
 * across the axis: on the way to the middle; or, of a flat box, as of a wall, across that. */
static double nearest_aside(struct vec3 axis, struct vec3 d, struct vec3 aside, struct vec3 half)
{
    const double upright = 0.5; /* of X, Y or Z across the axis, at least */
    double r = vec_length(aside), near = r > 0 ? r - reach_along(half, aside) / r : 0;
    struct vec3 e;

    if (is_flat(half, &e)) {
        struct vec3 across = vec_along(e, -vec_dot(e, axis), axis);
        double length = vec_length(across);
        if (length > upright)
            near = fmax(near, (fabs(vec_dot(d, across)) - reach_along(half, across)) / length);
    }
    return near > 0 ? near : 0;
}

static double cylinder_bound(const struct holder_part *part, struct vec3 axis, struct vec3 d,
                             struct vec3 half, double below)
{
    double h = vec_dot(d, axis), from = fabs(h - part->length / 2) - reach_along(half, axis);
    if (from - part->length / 2 > below) /* along it alone: that is quick to say */
        return from - part->length / 2 - ROUNDING;
    struct vec3 aside = vec_along(d, -h, axis);
    double near = nearest_aside(axis, d, aside, half);

    from = from > 0 ? from : 0;
    return outside(near - part->low, from - part->length / 2) - ROUNDING;
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

/* The largest radius between two heights; 0: no part is there. */
static double widest_between(const struct holder *holder, double from, double to)
{
    double widest = 0, height = 0;

    for (int i = 0; i < holder->n; i++) {
        const struct holder_part *part = &holder->part[i];
        if (height <= to && height + part->length >= from)
            widest = fmax(widest, fmax(part->low, part->high));
        height += part->length;
    }
    return widest;
}

double holder_bound(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                    struct vec3 middle, struct vec3 half)
{
    return holder_bound_below(holder, centre, axis, middle, half, HUGE_VAL);
}

double holder_bound_below(const struct holder *holder, struct vec3 centre, struct vec3 axis,
                          struct vec3 middle, struct vec3 half, double below)
{
    if (is_cylinder(holder))
        return cylinder_bound(&holder->part[0], axis, vec_sub(middle, centre), half, below);
    struct vec3 d = vec_sub(middle, centre);
    double h = vec_dot(d, axis), depth2 = HUGE_VAL, spread = vec_length(half);
    struct vec3 aside = vec_along(d, -h, axis);
    const struct place at = {vec_length(aside), h};
    const struct place reach = {spread, reach_along(half, axis)};
    double near = nearest_aside(axis, d, aside, half);
    double away = outside_all(holder, (struct place){near, h}, reach.h) - ROUNDING;
    if (away > 0 && away > below)
        return away;
    double bound =
        fmax(holder_distance(holder, centre, axis, middle) - spread, away > 0 ? away : -HUGE_VAL);
    if (bound >= 0)
        return bound;
    /* none is deeper than it is beside the outline at its height */
    bound = fmax(bound, near - widest_between(holder, h - reach.h, h + reach.h) - ROUNDING);
    if (bound > below)
        return bound;
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
