/* run_curve - see run_curve.h. */
#include "run_curve.h"

static const double AXIS_SMOOTH = PI / 3; /* axes further apart than this: great circle */
enum { PARTS_MAX = 10000 };               /* pieces of one interval */

/*
 * The speed at the ends is that at which a cubic is nearest to a circle with these tangents:
 * 2 d / (1 + cos(turn / 2)) for a chord of length d.
 */
struct run_curve run_curve_between(struct run_curve_end a, struct run_curve_end b)
{
    double length = vec_distance(a.point->ball, b.point->ball);
    double half = sqrt(fmax(0, (1 + vec_dot(a.tangent, b.tangent)) / 2));
    double speed = 2 * length / (1 + half);
    return (struct run_curve){
        .a = a.point,
        .b = b.point,
        .va = vec_scale(speed, a.tangent),
        .vb = vec_scale(speed, b.tangent),
        .wa = vec_scale(speed, a.turn),
        .wb = vec_scale(speed, b.turn),
        .great_circle = vec_angle(a.point->axis, b.point->axis) > AXIS_SMOOTH,
    };
}

static struct vec3 hermite(struct vec3 p, struct vec3 v, struct vec3 q, struct vec3 w, double t)
{
    struct vec3 d = vec_sub(q, p);
    double s = 1 - t;
    struct vec3 r = vec_along(p, t * t * (3 - 2 * t), d);
    return vec_along(vec_along(r, t * s * s, v), -t * t * s, w);
}

struct run_point run_curve_at(const struct run_curve *c, double t, double radius)
{
    struct run_point p = {.ball = hermite(c->a->ball, c->va, c->b->ball, c->vb, t)};
    p.axis = c->great_circle ? vec_slerp(c->a->axis, c->b->axis, t)
                             : vec_unit(hermite(c->a->axis, c->wa, c->b->axis, c->wb, t));
    p.tip = vec_along(p.ball, -radius, p.axis);
    if (run_point_touches(c->a) && run_point_touches(c->b)) {
        p.normal = vec_slerp(c->a->normal, c->b->normal, t);
        double h = (1 - t) * run_point_height(c->a) + t * run_point_height(c->b);
        p.contact = vec_along(p.ball, -h, p.normal);
    }
    return p;
}

/* Largest distance between the curve and `parts` straight pieces, at the tip and the centre. */
static double chord_error(const struct run_curve *c, size_t parts, double radius)
{
    enum { SAMPLES = 4 };
    double worst = 0, n = (double)parts;
    struct run_point from = *c->a;
    for (size_t k = 0; k < parts; k++) {
        struct run_point to = k + 1 < parts ? run_curve_at(c, (double)(k + 1) / n, radius) : *c->b;
        for (int i = 1; i < SAMPLES; i++) {
            struct run_point p = run_curve_at(c, ((double)k + (double)i / SAMPLES) / n, radius);
            worst = fmax(worst, vec_segment_distance(from.ball, to.ball, p.ball));
            worst = fmax(worst, vec_segment_distance(from.tip, to.tip, p.tip));
        }
        from = to;
    }
    return worst;
}

double run_curve_densify(const struct run_curve *c, double chord, struct run *dense)
{
    size_t parts = 1;
    double whole = chord_error(c, 1, dense->radius), off = whole;
    while (off > chord && parts < PARTS_MAX) {
        double more = 1.01 * (double)parts * sqrt(off / chord);
        parts = more < PARTS_MAX ? (size_t)more + 1 : PARTS_MAX;
        off = chord_error(c, parts, dense->radius);
    }
    for (size_t k = 1; k < parts; k++)
        *array_push(dense) = run_curve_at(c, (double)k / (double)parts, dense->radius);
    *array_push(dense) = *c->b;
    return whole;
}
