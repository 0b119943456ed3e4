/* trim_tidy - see trim_tidy.h. */
#include "trim_tidy.h"

#include "math/elementary.h"

/* In tolerances: corners so near the border of the range are on it, and so near each other one. */
static const double BORDER = 0.05, CORNER = 0.01;

static double width(const struct nurbs_axis *a)
{
    return a->to - a->from;
}

static double on_border(const struct nurbs_axis *a, double x, double near)
{
    return fabs(x - a->from) <= near ? a->from : fabs(x - a->to) <= near ? a->to : x;
}

/* How far the parameters may move about a place for a part of the tolerance in space. */
static struct uv uv_reach(const struct nurbs *s, struct uv at, double distance)
{
    struct vec3 d[3][3];
    nurbs_derivatives(s, at, 1, d);
    return (struct uv){fmin(1e-4 * width(&s->u), distance / fmax(vec_length(d[1][0]), 1e-300)),
                       fmin(1e-4 * width(&s->v), distance / fmax(vec_length(d[0][1]), 1e-300))};
}

static bool is_within(struct uv a, struct uv b, struct uv near)
{
    return fabs(a.u - b.u) <= near.u && fabs(a.v - b.v) <= near.v;
}

/* Drops the ways there and back again that bound nothing, such as an edge that a loop runs along
 * twice; what is left begins elsewhere where one is at the loop's beginning. */
static void drop_spurs(const struct nurbs *s, double tolerance, struct uvs *loop)
{
    size_t kept = 0, first = 0;
    for (size_t i = 0; i < loop->n; i++) {
        struct uv at = loop->item[i], near = uv_reach(s, at, CORNER * tolerance);
        loop->item[kept++] = at;
        while (kept > 2 && is_within(at, loop->item[kept - 3], near))
            kept -= 2;
    }
    while (kept > first + 2) {
        struct uv at = loop->item[first], near = uv_reach(s, at, CORNER * tolerance);
        bool begins = is_within(loop->item[first + 1], loop->item[kept - 1], near);
        if (!begins && !is_within(at, loop->item[kept - 2], near))
            break;
        first += begins;
        kept -= begins ? 1 : 2;
    }
    for (size_t i = first; i < kept; i++)
        loop->item[i - first] = loop->item[i];
    loop->n = kept - first;
}

void trim_tidy(const struct nurbs *s, double tolerance, struct uvs *loop)
{
    size_t kept = 0;
    struct uv near = {0, 0};
    for (size_t i = 0; i <= loop->n; i++) {
        bool end = i == loop->n; /* the first corner once more */
        struct uv at = loop->item[end ? 0 : i];
        if (!end) {
            near = uv_reach(s, at, BORDER * tolerance);
            at.u = on_border(&s->u, at.u, near.u);
            at.v = on_border(&s->v, at.v, near.v);
            near = (struct uv){near.u * CORNER / BORDER, near.v * CORNER / BORDER};
        }
        struct uv last = kept > 0 ? loop->item[kept - 1] : at;
        bool same = kept > 0 && is_within(at, last, near);
        if (end)
            kept -= same && kept > 3;
        else if (!same)
            loop->item[kept++] = at;
    }
    loop->n = kept;
    drop_spurs(s, tolerance, loop);
}
