/* step_curve - see step_geometry.h. */
#include "step_source.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "nurbs/construct.h"

void step_push_part(const struct step_source *s, struct nurbs_curve c)
{
    if (s->ends) {
        double from = c.t.from, to = c.t.to;
        double low = nurbs_curve_foot(&c, s->ends[0]), high = nurbs_curve_foot(&c, s->ends[1]);
        if (vec_distance(nurbs_curve_point(&c, from), s->ends[0]) <= STEP_NEAR)
            low = from;
        if (vec_distance(nurbs_curve_point(&c, to), s->ends[1]) <= STEP_NEAR)
            high = to;
        if (!(low < high)) { /* over the seam of a closed curve */
            struct nurbs_curve first = construct_refined(&c, c.t.degree, NULL, 0);
            first.t.from = low;
            if (low < to)
                *array_push(s->loop) = construct_refined(&first, c.t.degree, NULL, 0);
            nurbs_curve_free(&first);
            low = from;
        }
        c.t.from = low;
        c.t.to = high;
        if (!(low < high)) {
            nurbs_curve_free(&c);
            return;
        }
    }
    *array_push(s->loop) = c;
}

static struct vec3 to_local(const struct transform *t, struct vec3 p)
{
    struct vec3 d = vec_sub(p, step_axis(t, 3));
    return vec(vec_dot(d, step_axis(t, 0)), vec_dot(d, step_axis(t, 1)),
               vec_dot(d, step_axis(t, 2)));
}

/* CIRCLE, ELLIPSE, HYPERBOLA, PARABOLA: axes, then one or two lengths. */
static int read_conic(const struct step_source *s, const char *kind, struct error *error)
{
    struct transform t;
    double a, b = 0, from = 0, to = 2 * PI, t0[2] = {0, 0};
    bool two = kind[0] == 'E' || kind[0] == 'H';
    if (step_placed_axes(s, step_own(s->v, s->record, 1), &t, error) < 0 ||
        step_number(s->place->step, s->v, step_own(s->v, s->record, 2), 1e12, &a, error) < 0 ||
        (two &&
         step_number(s->place->step, s->v, step_own(s->v, s->record, 3), 1e12, &b, error) < 0))
        return -1;
    a *= s->place->mm;
    b = two ? b * s->place->mm : a;
    if (!(a > 0 && b > 0))
        return step_refuse(s->place->step, s->v, "a radius that is not positive, expected one",
                           error);
    bool open = kind[0] == 'H' || kind[0] == 'P';
    if (open && !s->ends)
        return 1;
    for (int i = 0; i < 2 && s->ends; i++) {
        struct vec3 p = to_local(&t, s->ends[i]);
        t0[i] = kind[0] == 'H'   ? asinh(p.y / b)
                : kind[0] == 'P' ? p.y / (2 * a)
                                 : atan2(p.y / b, p.x / a);
    }
    if (s->ends) {
        from = t0[0];
        to = t0[1];
        bool whole = vec_distance(s->ends[0], s->ends[1]) <= STEP_NEAR;
        if (!open && whole)
            to = from + 2 * PI;
        else if (!open && to <= from)
            to += 2 * PI;
    }
    if (!(to > from))
        return step_refuse(s->place->step, s->v, "an edge that runs against its curve", error);
    *array_push(s->loop) = kind[0] == 'H'   ? construct_hyperbola(&t, a, b, from, to)
                           : kind[0] == 'P' ? construct_parabola(&t, a, from, to)
                                            : construct_ellipse(&t, a, b, from, to);
    return 0;
}

static int read_polyline(const struct step_source *s, struct error *error)
{
    const struct step_value *list = step_own(s->v, s->record, 1), *i = step_item(list, 0);
    struct vec3s point = {0};
    int status = 0;
    for (; i && status == 0; i = step_next(list, i))
        status = step_point(s, i, array_push(&point), error);
    if (status == 0 && point.n < 2)
        status = step_refuse(s->place->step, s->v, "a polyline of less than two points", error);
    if (status == 0)
        step_push_part(s, construct_polyline(point.item, point.n));
    array_free(&point);
    return status;
}

/* ---- curves of curves */

/* The place of a line or conic at a parameter of the standard: 0, 1 when it is another curve. */
static int point_of_parameter(const struct step_source *basis, double t, struct vec3 *point,
                              struct error *error)
{
    static const char *const conics[] = {"CIRCLE", "ELLIPSE", "HYPERBOLA", "PARABOLA"};
    struct step_source s = *basis;
    struct transform axes;
    struct vec3 along;
    double a = 0, b = 0, length;
    if ((s.record = step_record(s.v, "LINE"))) {
        if (step_point(&s, step_own(s.v, s.record, 1), point, error) < 0 ||
            step_direction(&s, step_own(s.v, s.record, 2), &along, &length, error) < 0)
            return -1;
        *point = vec_along(*point, t * length, along);
        return 0;
    }
    for (size_t i = 0; i < 4; i++) {
        if (!(s.record = step_record(s.v, conics[i])))
            continue;
        if (step_placed_axes(&s, step_own(s.v, s.record, 1), &axes, error) < 0 ||
            step_number(s.place->step, s.v, step_own(s.v, s.record, 2), 1e12, &a, error) < 0 ||
            (i % 3 != 0 &&
             step_number(s.place->step, s.v, step_own(s.v, s.record, 3), 1e12, &b, error) < 0))
            return -1;
        a *= s.place->mm;
        b = i == 0 ? a : b * s.place->mm;
        double angle = t * s.place->angle;
        struct vec3 p = i < 2    ? vec(a * cos(angle), b * sin(angle), 0)
                        : i == 2 ? vec(a * cosh(t), b * sinh(t), 0)
                                 : vec(a * t * t, 2 * a * t, 0);
        *point = transform_point(&axes, p);
        return 0;
    }
    return 1;
}

/* One end of a TRIMMED_CURVE: a point, or a parameter of its basis.  1: there is neither that is
 * understood. */
static int trim_end(const struct step_source *s, const struct step_source *basis,
                    const struct step_value *list, struct vec3 *end, double *parameter,
                    struct error *error)
{
    int got = 1;
    *parameter = NAN;
    for (const struct step_value *i = step_item(list, 0); i; i = step_next(list, i)) {
        if (i->kind == STEP_REFERENCE)
            return step_point(s, i, end, error);
        if (step_number(s->place->step, s->v, i, NURBS_LARGEST, parameter, error) < 0)
            return -1;
        got = point_of_parameter(basis, *parameter, end, error);
        if (got < 0)
            return -1;
    }
    return got;
}

/* TRIMMED_CURVE: basis, two ends, whether it runs as its basis does.  Ends from outside go before
 * its own. */
static int read_trimmed(const struct step_source *s, struct error *error)
{
    struct step_values v = {0};
    struct vec3 own[2] = {{0, 0, 0}, {0, 0, 0}}, turned[2];
    double t[2];
    bool same = !step_is(step_own(s->v, s->record, 4), "F");
    size_t first = s->loop->n;
    if (step_follow(s->place->step, s->v, step_own(s->v, s->record, 1), &v, error) < 0)
        return -1;
    struct step_source basis = {.place = s->place, .v = &v};
    int got = 0;
    for (size_t i = 0; i < 2 && got >= 0 && !s->ends; i++) {
        got = trim_end(s, &basis, step_own(s->v, s->record, 2 + i), &own[i], &t[i], error);
        if (got == 1 && isfinite(t[i]))
            got = 2; /* a parameter of a spline */
        else if (got == 1)
            break;
    }
    struct step_spline sp;
    if (got == 2 && step_find_spline(&v, false, &sp)) {
        struct nurbs_curve c = {{0}, NULL};
        got = step_spline_curve(&basis, &sp, &c, error);
        double low = fmax(fmin(t[0], t[1]), c.t.from), high = fmin(fmax(t[0], t[1]), c.t.to);
        if (got == 0 && low < high) {
            c.t.from = low;
            c.t.to = high;
            *array_push(s->loop) = c;
        } else {
            nurbs_curve_free(&c);
            got = got < 0 ? -1 : 1;
        }
    } else if (got == 0) {
        const struct vec3 *ends = s->ends ? s->ends : own;
        turned[0] = ends[same ? 0 : 1];
        turned[1] = ends[same ? 1 : 0];
        got = step_curve_of(s->place, s->v, step_own(s->v, s->record, 1), turned, s->depth + 1,
                            s->loop, error);
    }
    array_free(&v);
    if (got == 0 && !same)
        patch_loop_turn(s->loop, first);
    return got > 0 ? 1 : got;
}

/* Pieces that follow each other: the part of them between the ends, or all. */
static void push_pieces(const struct step_source *s, struct patch_loop *pieces)
{
    bool whole = !s->ends || vec_distance(s->ends[0], s->ends[1]) <= STEP_NEAR;
    if (pieces->n == 1) {
        step_push_part(s, pieces->item[0]);
        pieces->n = 0;
    } else if (whole) {
        for (size_t i = 0; i < pieces->n; i++)
            *array_push(s->loop) = pieces->item[i];
        pieces->n = 0;
    } else if (pieces->n > 0) {
        step_push_part(s, construct_joined(pieces->item, pieces->n));
    }
}

/* COMPOSITE_CURVE: segments, each a curve that runs its own way or against it. */
static int read_composite(const struct step_source *s, struct error *error)
{
    const struct step_value *list = step_own(s->v, s->record, 1);
    struct patch_loop pieces = {0};
    int got = list && list->kind == STEP_LIST ? 0 : 1;
    for (const struct step_value *i = step_item(list, 0); i && got == 0; i = step_next(list, i)) {
        struct step_values v = {0};
        size_t first = pieces.n;
        if (step_follow(s->place->step, s->v, i, &v, error) < 0) {
            got = -1;
            break;
        }
        const struct step_value *r = step_record(&v, "COMPOSITE_CURVE_SEGMENT");
        r = r ? r : step_record(&v, "REPARAMETRISED_COMPOSITE_CURVE_SEGMENT");
        got =
            r ? step_curve_of(s->place, &v, step_own(&v, r, 2), NULL, s->depth + 1, &pieces, error)
              : 1;
        if (got == 0 && step_is(step_own(&v, r, 1), "F"))
            patch_loop_turn(&pieces, first);
        array_free(&v);
    }
    if (got == 0)
        push_pieces(s, &pieces);
    s->loop->rough = fmax(s->loop->rough, pieces.rough);
    patch_loop_free(&pieces);
    return got;
}

struct offset {
    const struct nurbs_curve *curve;
    struct vec3 normal;
    double distance;
};

static struct vec3 offset_point(const void *context, double t)
{
    const struct offset *o = context;
    struct vec3 along = nurbs_curve_derivative(o->curve, t);
    return vec_along(nurbs_curve_point(o->curve, t), o->distance,
                     vec_unit(vec_cross(o->normal, along)));
}

/* OFFSET_CURVE_3D: basis, distance, whether it cuts itself, a direction V: moved along V x tangent.
 * One of a line is a line between the ends. */
static int read_offset_curve(const struct step_source *s, struct error *error)
{
    struct patch_loop pieces = {0};
    struct step_values v = {0};
    struct offset o = {0};
    if (step_number(s->place->step, s->v, step_own(s->v, s->record, 2), 1e12, &o.distance, error) <
            0 ||
        step_axis_direction(s, step_own(s->v, s->record, 4), &o.normal, error) < 0 ||
        step_follow(s->place->step, s->v, step_own(s->v, s->record, 1), &v, error) < 0)
        return -1;
    o.distance *= s->place->mm;
    bool line = step_record(&v, "LINE") != NULL;
    array_free(&v);
    if (line && s->ends)
        *array_push(s->loop) = construct_line(s->ends[0], s->ends[1]);
    if (line)
        return s->ends ? 0 : 1;
    int got = step_curve_of(s->place, s->v, step_own(s->v, s->record, 1), NULL, s->depth + 1,
                            &pieces, error);
    struct patch_loop moved = {0};
    for (size_t i = 0; i < pieces.n && got == 0; i++) {
        o.curve = &pieces.item[i];
        *array_push(&moved) =
            step_approximate(&o.curve->t, offset_point, &o, STEP_NEAR, &s->loop->rough);
    }
    s->loop->rough = fmax(s->loop->rough, pieces.rough);
    push_pieces(s, &moved);
    patch_loop_free(&moved);
    patch_loop_free(&pieces);
    return got;
}

static int known_curve(const struct step_source *from, struct error *error)
{
    static const char *const conics[] = {"CIRCLE", "ELLIPSE", "HYPERBOLA", "PARABOLA"};
    static const char *const others[] = {"SURFACE_CURVE", "SEAM_CURVE", "INTERSECTION_CURVE"};
    static const char *const composite[] = {"COMPOSITE_CURVE", "COMPOSITE_CURVE_ON_SURFACE",
                                            "BOUNDARY_CURVE", "OUTER_BOUNDARY_CURVE",
                                            "BOUNDED_SURFACE_CURVE"};
    struct step_source s = *from;
    struct step_spline sp;
    if ((s.record = step_record(s.v, "LINE"))) {
        if (s.ends)
            *array_push(s.loop) = construct_line(s.ends[0], s.ends[1]);
        return s.ends ? 0 : 1;
    }
    for (size_t i = 0; i < 4; i++)
        if ((s.record = step_record(s.v, conics[i])))
            return read_conic(&s, conics[i], error);
    for (size_t i = 0; i < 3; i++)
        if ((s.record = step_record(s.v, others[i])))
            return step_curve_of(s.place, s.v, step_own(s.v, s.record, 1), s.ends, s.depth + 1,
                                 s.loop, error);
    if ((s.record = step_record(s.v, "TRIMMED_CURVE")))
        return read_trimmed(&s, error);
    for (size_t i = 0; i < 5; i++)
        if ((s.record = step_record(s.v, composite[i])))
            return read_composite(&s, error);
    if ((s.record = step_record(s.v, "PCURVE")))
        return step_pcurve(&s, error);
    if ((s.record = step_record(s.v, "OFFSET_CURVE_3D")))
        return read_offset_curve(&s, error);
    if ((s.record = step_record(s.v, "POLYLINE")))
        return read_polyline(&s, error);
    if (step_find_spline(s.v, false, &sp)) {
        struct nurbs_curve c = {{0}, NULL};
        if (step_spline_curve(&s, &sp, &c, error) < 0) {
            nurbs_curve_free(&c);
            return -1;
        }
        step_push_part(&s, c);
        return 0;
    }
    return 1;
}

int step_curve_of(const struct step_place *place, const struct step_values *from,
                  const struct step_value *reference, const struct vec3 *ends, int depth,
                  struct patch_loop *loop, struct error *error)
{
    struct step_values v = {0};
    if (depth > STEP_DEPTH_MAX)
        return step_refuse(place->step, from, "curves of curves without end, expected simple ones",
                           error);
    if (step_follow(place->step, from, reference, &v, error) < 0)
        return -1;
    struct step_source s = {.place = place, .v = &v, .ends = ends, .loop = loop, .depth = depth};
    int got = known_curve(&s, error);
    array_free(&v);
    return got;
}

int step_curve(const struct step_place *place, const struct step_values *from,
               const struct step_value *reference, const struct vec3 *ends, struct patch_loop *loop,
               struct error *error)
{
    return step_curve_of(place, from, reference, ends, 0, loop, error);
}
