/* step_pcurve - PCURVE: a curve in the parameters of a surface, brought into space. */
#include <stdlib.h>

#include "base/array.h"
#include "nurbs/construct.h"
#include "step_source.h"

enum { SAMPLES = 400, TURNS = 2 };

/* Radians, or parts of a range: a place so near a line of the parameters is on it. */
static const double ON_LINE = 1e-7;

struct pcurve {
    const struct step_parametric *on;
    const struct nurbs_curve *curve;
};

static struct vec3 pcurve_point(const void *context, double t)
{
    const struct pcurve *p = context;
    struct vec3 at = nurbs_curve_point(p->curve, t);
    return step_parametric_point(p->on, at.x, at.y);
}

/* A straight line without ends in the parameters of a surface. */
struct endless {
    const struct step_parametric *on;
    struct vec3 at, along;
};

static struct vec3 line_point(const struct endless *l, double t)
{
    return step_parametric_point(l->on, l->at.x + t * l->along.x, l->at.y + t * l->along.y);
}

/* Where on the line a point of a plane, cylinder ... is: the first place after `after`, which the
 * line reaches in whole turns, or without that the one nearest to its start. */
static double primitive_place(const struct endless *l, struct vec3 q, double after)
{
    const struct primitive *p = &l->on->primitive;
    bool turns_u = p->kind != PRIMITIVE_PLANE, turns_v = p->kind == PRIMITIVE_TORUS;
    double u, v, least = HUGE_VAL, best = NAN;
    primitive_parameters(p, q, &u, &v);
    for (int pass = 0; pass < 2; pass++)
        for (int i = turns_u ? -TURNS : 0; i <= (turns_u ? TURNS : 0); i++)
            for (int k = turns_v ? -TURNS : 0; k <= (turns_v ? TURNS : 0); k++) {
                double x = (u + 2 * PI * i) / l->on->u - l->at.x;
                double y = (v + 2 * PI * k) / l->on->v - l->at.y;
                double t = x * l->along.x + y * l->along.y;
                double off = fabs(x * l->along.y - y * l->along.x) * l->on->u;
                if (isfinite(after) && t <= after + ON_LINE)
                    continue;
                if (pass == 0)
                    least = fmin(least, off);
                else if (off <= least + ON_LINE && !(fabs(t) >= fabs(best)))
                    best = t;
            }
    return best;
}

/* The same of a spline: it is sought over the whole range. */
static double spline_place(const struct endless *l, struct vec3 q)
{
    const struct nurbs *n = &l->on->spline;
    double low = -HUGE_VAL, high = HUGE_VAL, best = NAN, least = HUGE_VAL;
    const double at[2] = {l->at.x, l->at.y}, along[2] = {l->along.x, l->along.y};
    const struct nurbs_axis *axis[2] = {&n->u, &n->v};
    for (int i = 0; i < 2; i++) {
        double a = (axis[i]->from - at[i]) / along[i], b = (axis[i]->to - at[i]) / along[i];
        if (fabs(along[i]) > 1e-12) {
            low = fmax(low, fmin(a, b));
            high = fmin(high, fmax(a, b));
        }
    }
    if (!(low < high))
        return NAN;
    double step = (high - low) / SAMPLES;
    for (int i = 0; i <= SAMPLES; i++) {
        double d = vec_distance(q, line_point(l, low + step * i));
        if (d < least) {
            least = d;
            best = low + step * i;
        }
    }
    for (; step > 1e-15 * (high - low); step /= 2) {
        double was = best;
        for (int side = -1; side <= 1; side += 2) {
            double t = fmin(fmax(was + side * step, low), high);
            double d = vec_distance(q, line_point(l, t));
            if (d < least) {
                least = d;
                best = t;
            }
        }
    }
    return best;
}

/* A LINE in the parameters: between the places of the ends of its edge.  1: it has none. */
static int bounded_line(const struct step_source *s, const struct step_source *line,
                        const struct step_parametric *on, struct patch_loop *plane,
                        struct error *error)
{
    struct endless l = {.on = on};
    double from, to;
    if (!s->ends)
        return 1;
    if (step_point(line, step_own(line->v, line->record, 1), &l.at, error) < 0 ||
        step_direction(line, step_own(line->v, line->record, 2), &l.along, NULL, error) < 0)
        return -1;
    if (on->is_primitive) {
        from = primitive_place(&l, s->ends[0], NAN);
        to = primitive_place(&l, s->ends[1], from);
    } else {
        from = spline_place(&l, s->ends[0]);
        to = spline_place(&l, s->ends[1]);
    }
    if (!(from < to))
        return 1;
    *array_push(plane) =
        construct_line(vec_along(l.at, from, l.along), vec_along(l.at, to, l.along));
    return 0;
}

/* The curve of a DEFINITIONAL_REPRESENTATION, in the plane of the parameters; `bounded`: it ends
 * where the edge does. */
static int plane_curve(const struct step_source *s, const struct step_parametric *on,
                       struct patch_loop *loop, bool *bounded, struct error *error)
{
    struct step_place plane = *s->place;
    struct step_values v = {0}, line = {0};
    plane.to = transform_identity();
    plane.mm = 1;
    if (step_follow(s->place->step, s->v, step_own(s->v, s->record, 2), &v, error) < 0)
        return -1;
    const struct step_value *r = step_record(&v, "REPRESENTATION");
    const struct step_value *item = step_item(step_item(r ? r : step_item(v.item, 0), 1), 0);
    int got = step_follow(s->place->step, &v, item, &line, error);
    struct step_source of = {.place = &plane, .v = &line};
    of.record = got == 0 ? step_record(&line, "LINE") : NULL;
    *bounded = of.record != NULL;
    if (got == 0)
        got = of.record ? bounded_line(s, &of, on, loop, error)
                        : step_curve_of(&plane, &v, item, NULL, s->depth + 1, loop, error);
    array_free(&line);
    array_free(&v);
    return got;
}

int step_pcurve(const struct step_source *s, struct error *error)
{
    struct step_parametric on = {0};
    struct patch_loop plane = {0};
    bool bounded = false;
    int got = step_parametric(s->place, s->v, step_own(s->v, s->record, 1), &on, error);
    if (got == 0)
        got = plane_curve(s, &on, &plane, &bounded, error);
    for (size_t i = 0; i < plane.n && got == 0; i++) {
        struct pcurve p = {&on, &plane.item[i]};
        struct nurbs_curve c =
            step_approximate(&p.curve->t, pcurve_point, &p, STEP_NEAR, &s->loop->rough);
        if (bounded)
            *array_push(s->loop) = c;
        else
            step_push_part(s, c);
    }
    s->loop->rough = fmax(s->loop->rough, on.rough);
    patch_loop_free(&plane);
    nurbs_free(&on.spline);
    return got;
}
