/* tool_shape - see tool_shape.h. */
#include "simulate/tool_shape.h"

#define THIN 1e-9 /* mm: a span lower than that is none */

/* ---- the outline */

static double span_radius(const struct tool_span *span, double height)
{
    return span->from + (span->to - span->from) * (height - span->low) / (span->high - span->low);
}

/* The span that is over a height, just above or just below it; NULL: none. */
static const struct tool_span *span_over(const struct tool_shape *shape, double height)
{
    for (int i = 0; i < shape->n; i++)
        if (height > shape->span[i].low && height < shape->span[i].high)
            return &shape->span[i];
    return NULL;
}

double tool_shape_radius(const struct tool_shape *shape, double height)
{
    double most = 0;
    for (int i = 0; i < shape->n; i++)
        if (height >= shape->span[i].low && height <= shape->span[i].high)
            most = fmax(most, span_radius(&shape->span[i], height));
    return most;
}

static bool push_span(struct tool_shape *shape, struct tool_span span)
{
    if (span.high - span.low <= THIN)
        return true;
    if (shape->n == TOOL_SPANS)
        return false;
    shape->span[shape->n++] = span;
    return true;
}

/* Between two heights at which neither outline bends: the outer of both, halved where they cross.
 */
static bool push_outer(struct tool_shape *shape, const struct tool_span *a,
                       const struct tool_span *b, double low, double high)
{
    if (!a || !b) {
        const struct tool_span *one = a ? a : b;
        return !one || push_span(shape, (struct tool_span){low, high, span_radius(one, low),
                                                           span_radius(one, high)});
    }
    double over_low = span_radius(a, low) - span_radius(b, low);
    double over_high = span_radius(a, high) - span_radius(b, high);
    if (over_low * over_high < 0) {
        double cross = low + (high - low) * over_low / (over_low - over_high);
        return push_outer(shape, over_low > 0 ? a : b, NULL, low, cross) &&
               push_outer(shape, over_high > 0 ? a : b, NULL, cross, high);
    }
    return push_outer(shape, over_low + over_high >= 0 ? a : b, NULL, low, high);
}

/* Puts a height among n others in their order. */
static int insert_height(double *height, int n, double value)
{
    int k = n;
    for (; k > 0 && height[k - 1] > value; k--)
        height[k] = height[k - 1];
    height[k] = value;
    return n + 1;
}

bool tool_shape_add(struct tool_shape *shape, struct tool_span cone)
{
    struct tool_shape joined = {0}, other = {.n = 1, .span = {cone}};
    double height[2 * TOOL_SPANS + 2];
    int n = 0;
    for (int i = 0; i < shape->n; i++) {
        n = insert_height(height, n, shape->span[i].low);
        n = insert_height(height, n, shape->span[i].high);
    }
    n = insert_height(height, n, cone.low);
    n = insert_height(height, n, cone.high);
    for (int i = 0; i + 1 < n; i++) {
        double middle = (height[i] + height[i + 1]) / 2;
        if (height[i + 1] - height[i] > THIN &&
            !push_outer(&joined, span_over(shape, middle), span_over(&other, middle), height[i],
                        height[i + 1]))
            return false;
    }
    *shape = joined;
    return true;
}

double tool_shape_reach(const struct tool_shape *shape)
{
    double reach = 0;
    for (int i = 0; i < shape->n; i++) {
        reach = fmax(reach, hypot(shape->span[i].from, shape->span[i].low));
        reach = fmax(reach, hypot(shape->span[i].to, shape->span[i].high));
    }
    return reach;
}

double tool_shape_widest(const struct tool_shape *shape)
{
    double most = 0;
    for (int i = 0; i < shape->n; i++)
        most = fmax(most, fmax(shape->span[i].from, shape->span[i].to));
    return most;
}

/* ---- distances, in the half plane of the place: r off the axis, h above the ball's centre */

struct flat {
    double r, h;
};

/* How far beyond the interval; 0 in it. */
static double beyond(double x, double low, double high)
{
    return x < low ? low - x : x > high ? x - high : 0;
}

static double square(double x)
{
    return x * x;
}

/* A place seen along and across the side of a truncated cone, and how long that is. */
struct beside {
    double along, across, side;
};

static struct beside beside_of(const struct tool_span *span, struct flat p)
{
    double rise = span->high - span->low, widen = span->to - span->from;
    double side = sqrt(rise * rise + widen * widen), r = p.r - span->from, h = p.h - span->low;
    return (struct beside){(r * widen + h * rise) / side, (r * rise - h * widen) / side, side};
}

/* Squared distance from the truncated cone, for a place outside of it: by the cone's side, seen
 * along and across.  Squares are compared, as many of these are asked for. */
static double outside_cone2(const struct tool_span *span, struct flat p)
{
    struct beside s = beside_of(span, p);
    double to_side = square(beyond(s.along, 0, s.side)) + square(s.across);
    double to_bottom = square(beyond(p.r, 0, span->from)) + square(p.h - span->low);
    double to_top = square(beyond(p.r, 0, span->to)) + square(p.h - span->high);
    return fmin(to_side, fmin(to_bottom, to_top));
}

static bool in_cone(const struct tool_span *span, struct flat p)
{
    return p.h >= span->low && p.h <= span->high && p.r < span_radius(span, p.h);
}

/* For a place in the tool, the squared distance from what lies outside of it at the heights of a
 * span: an area bounded by the span's side and by a ray outward from each of its ends. */
static double to_outside2(const struct tool_span *span, struct flat p)
{
    struct beside s = beside_of(span, p);
    double least = square(beyond(s.along, 0, s.side)) + square(s.across);
    least = fmin(least, square(fmax(0, span->from - p.r)) + square(p.h - span->low));
    return fmin(least, square(fmax(0, span->to - p.r)) + square(p.h - span->high));
}

double tool_shape_distance(const struct tool_shape *shape, struct vec3 centre, struct vec3 axis,
                           struct vec3 p)
{
    struct vec3 d = vec_sub(p, centre), off = vec_cross(d, axis);
    double h = vec_dot(d, axis), least2 = HUGE_VAL;
    struct flat at = {sqrt(vec_dot(off, off)), h};
    bool inside = false;
    for (int i = 0; i < shape->n && !inside; i++) {
        inside = in_cone(&shape->span[i], at);
        least2 = fmin(least2, outside_cone2(&shape->span[i], at));
    }
    if (!inside)
        return sqrt(least2);
    double low = shape->span[0].low, high = shape->span[shape->n - 1].high;
    double least = fmin(at.h - low, high - at.h);
    for (int i = 0; i < shape->n; i++) {
        least = fmin(least, sqrt(to_outside2(&shape->span[i], at)));
        if (i > 0 && shape->span[i].low > shape->span[i - 1].high + THIN) /* a gap between parts */
            least = fmin(
                least, fmin(fabs(at.h - shape->span[i].low), fabs(at.h - shape->span[i - 1].high)));
    }
    return -least;
}

double tool_shape_bound(const struct tool_shape *shape, struct vec3 centre, struct vec3 axis,
                        struct vec3 middle, struct vec3 half)
{
    double bound = tool_shape_distance(shape, centre, axis, middle) - vec_length(half);
    return fmax(bound, -tool_shape_widest(shape));
}
