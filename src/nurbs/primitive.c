/* primitive - see primitive.h. */
#include "nurbs/primitive.h"

#include <stdlib.h>

#include "base/array.h"
#include "nurbs/construct.h"

/* Samples of each span of a curve; of the extent: how much further a surface reaches. */
enum { SAMPLES = 8 };
static const double MARGIN = 0.01;

/* One part of a torus is the one that is meant if points are so much nearer to it. */
static const double NEAR_PART = 1e-2;

static void sample_curve(const struct nurbs_curve *c, struct vec3s *points)
{
    size_t n = SAMPLES * (c->t.poles - (size_t)c->t.degree);
    for (size_t m = 0; m <= n; m++) {
        double t = c->t.from + (c->t.to - c->t.from) * (double)m / (double)n;
        *array_push(points) = nurbs_curve_point(c, t);
    }
}

void primitive_points(const struct patch_loops *loops, struct vec3s *points)
{
    for (size_t i = 0; i < loops->n; i++)
        for (size_t k = 0; k < loops->item[i].n && loops->item[i].space; k++) {
            const struct nurbs_curve *c = &loops->item[i].item[k];
            sample_curve(c, points);
            for (size_t m = 0; m < c->t.poles; m++) /* curves may bend between samples */
                if (c->t.degree > 1 && c->pole[m].w > 0)
                    *array_push(points) = vec_scale(
                        1 / c->pole[m].w, vec(c->pole[m].wx, c->pole[m].wy, c->pole[m].wz));
        }
}

static struct vec3 axis_of(const struct transform *t, int column)
{
    return vec(t->m[0][column], t->m[1][column], t->m[2][column]);
}

struct extent {
    struct vec3 low, high;
};

/* The box of the points in the place's own coordinates, with its margin. */
static struct extent extent_of(const struct transform *t, const struct vec3s *points)
{
    struct extent e = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (size_t i = 0; i < points->n; i++) {
        struct vec3 d = vec_sub(points->item[i], axis_of(t, 3));
        struct vec3 p = {vec_dot(d, axis_of(t, 0)), vec_dot(d, axis_of(t, 1)),
                         vec_dot(d, axis_of(t, 2))};
        e.low = vec(fmin(e.low.x, p.x), fmin(e.low.y, p.y), fmin(e.low.z, p.z));
        e.high = vec(fmax(e.high.x, p.x), fmax(e.high.y, p.y), fmax(e.high.z, p.z));
    }
    double margin = MARGIN * vec_distance(e.low, e.high);
    struct vec3 m = {margin, margin, margin};
    e.low = vec_sub(e.low, m);
    e.high = vec_add(e.high, m);
    return e;
}

static struct vec3 at_height(const struct transform *t, double x, double z)
{
    return vec_along(vec_along(axis_of(t, 3), x, axis_of(t, 0)), z, axis_of(t, 2));
}

/* How far the points are from the circle that the tube's is to the side of the axis, and from that
 * on the other side, at most. */
static void part_distances(const struct primitive *p, const struct vec3s *points, double *outer,
                           double *inner)
{
    for (size_t i = 0; i < points->n; i++) {
        struct vec3 d = vec_sub(points->item[i], axis_of(&p->place, 3));
        double x = vec_dot(d, axis_of(&p->place, 0)), y = vec_dot(d, axis_of(&p->place, 1));
        double z = vec_dot(d, axis_of(&p->place, 2)), r = hypot(x, y);
        *outer = fmax(*outer, fabs(hypot(r - p->radius, z) - p->other));
        *inner = fmax(*inner, fabs(hypot(r + p->radius, z) - p->other));
    }
}

enum primitive_part primitive_part_of(const struct primitive *p, const struct patch_loops *loops)
{
    struct vec3s points = {0};
    double outer = 0, inner = 0;
    if (p->kind != PRIMITIVE_TORUS || !(p->radius < p->other))
        return PRIMITIVE_WHOLE;
    for (size_t i = 0; i < loops->n; i++)
        for (size_t k = 0; k < loops->item[i].n && loops->item[i].space; k++)
            sample_curve(&loops->item[i].item[k], &points);
    part_distances(p, &points, &outer, &inner);
    array_free(&points);
    if (fmin(outer, inner) > NEAR_PART * fmax(outer, inner) || !(fmax(outer, inner) > 0))
        return PRIMITIVE_WHOLE;
    return outer < inner ? PRIMITIVE_OUTER : PRIMITIVE_INNER;
}

/* The straight line of a cylinder or a cone, from below to above; a cone ends at its apex. */
static int turn_line(const struct primitive *p, struct extent e, struct nurbs *surface)
{
    double slope = p->kind == PRIMITIVE_CONE ? tan(p->other) : 0, r = p->radius;
    double low = e.low.z, high = e.high.z;
    if (fabs(slope) > 1e-12) {
        double apex = -r / slope;
        bool above = (r + slope * (low + high) / 2 > 0) == (slope > 0);
        low = above ? fmax(low, apex) : low;
        high = above ? high : fmin(high, apex);
    }
    if (!(low < high) || (fabs(slope) <= 1e-12 && !(r > 0)))
        return -1;
    struct nurbs_curve line = construct_line(at_height(&p->place, r + slope * low, low),
                                             at_height(&p->place, r + slope * high, high));
    *surface = construct_revolution(&line, axis_of(&p->place, 3), axis_of(&p->place, 2), 0, 2 * PI);
    nurbs_curve_free(&line);
    return 0;
}

/* The circle of a sphere or a torus: in the plane of x and z. */
static int turn_circle(const struct primitive *p, struct nurbs *surface)
{
    bool sphere = p->kind == PRIMITIVE_SPHERE;
    double r = sphere ? p->radius : p->other, out = sphere ? 0 : p->radius;
    if (!(r > 0) || !(out >= 0))
        return -1;
    struct transform side = construct_place(
        at_height(&p->place, out, 0), vec_scale(-1, axis_of(&p->place, 1)), axis_of(&p->place, 0));
    double from = sphere ? -PI / 2 : 0, to = sphere ? PI / 2 : 2 * PI;
    if (p->part != PRIMITIVE_WHOLE && out < r) { /* from the axis to the axis */
        double angle = acos(-out / r);
        from = p->part == PRIMITIVE_OUTER ? -angle : angle;
        to = p->part == PRIMITIVE_OUTER ? angle : 2 * PI - angle;
    }
    struct nurbs_curve circle = construct_ellipse(&side, r, r, from, to);
    *surface =
        construct_revolution(&circle, axis_of(&p->place, 3), axis_of(&p->place, 2), 0, 2 * PI);
    nurbs_curve_free(&circle);
    return 0;
}

int primitive_surface(const struct primitive *p, const struct vec3s *points, struct nurbs *surface)
{
    if (p->kind == PRIMITIVE_SPHERE || p->kind == PRIMITIVE_TORUS)
        return turn_circle(p, surface);
    if (points->n == 0)
        return -1;
    struct extent e = extent_of(&p->place, points);
    if (p->kind != PRIMITIVE_PLANE)
        return turn_line(p, e, surface);
    if (!(e.low.x < e.high.x && e.low.y < e.high.y))
        return -1;
    *surface = construct_plane(&p->place, e.low.x, e.high.x, e.low.y, e.high.y);
    return 0;
}

struct vec3 primitive_point(const struct primitive *p, double u, double v)
{
    double r = p->radius, x = u, y = v, z = 0;
    switch (p->kind) {
    case PRIMITIVE_PLANE:
        break;
    case PRIMITIVE_CYLINDER:
    case PRIMITIVE_CONE:
        r += p->kind == PRIMITIVE_CONE ? v * tan(p->other) : 0;
        z = v;
        break;
    case PRIMITIVE_SPHERE:
        z = r * sin(v);
        r *= cos(v);
        break;
    case PRIMITIVE_TORUS:
        r += p->other * cos(v);
        z = p->other * sin(v);
        break;
    }
    if (p->kind != PRIMITIVE_PLANE) {
        x = r * cos(u);
        y = r * sin(u);
    }
    return transform_point(&p->place, vec(x, y, z));
}

void primitive_parameters(const struct primitive *p, struct vec3 point, double *u, double *v)
{
    struct vec3 d = vec_sub(point, axis_of(&p->place, 3));
    double x = vec_dot(d, axis_of(&p->place, 0)), y = vec_dot(d, axis_of(&p->place, 1));
    double z = vec_dot(d, axis_of(&p->place, 2)), r = hypot(x, y);
    *u = p->kind == PRIMITIVE_PLANE ? x : atan2(y, x);
    *v = p->kind == PRIMITIVE_PLANE    ? y
         : p->kind == PRIMITIVE_SPHERE ? atan2(z, r)
         : p->kind == PRIMITIVE_TORUS  ? atan2(z, r - p->radius)
                                       : z;
}

int primitive_offset(struct primitive *p, double distance)
{
    switch (p->kind) {
    case PRIMITIVE_PLANE: {
        struct vec3 by = vec_scale(distance, axis_of(&p->place, 2));
        p->place = transform_product(transform_shift(by), p->place);
        return 0;
    }
    case PRIMITIVE_CONE:
        p->radius += distance / cos(p->other);
        return 0;
    case PRIMITIVE_TORUS:
        p->other += distance;
        return p->other > 0 ? 0 : -1;
    default:
        p->radius += distance;
        return p->radius > 0 ? 0 : -1;
    }
}
