/*
 * footpoints - Newton's method on (C - Q) . C' = 0.
 */
#include "footpoints.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

enum { STEPS = 3 };
/* A foot is found when the step to it is below a thousandth of the distance, or of the tolerance:
 * beyond its reach the distance changes by the square of that. */
static const double SMALL = 0.05;

size_t footpoints_kinds(const struct target *target)
{
    return target->axis != NULL ? FOOTPOINT_KINDS : 1;
}

struct footpoints footpoints_new(const struct target *target)
{
    struct footpoints f = {0};

    f.u = mem_alloc(target->n, sizeof *f.u);
    f.off = mem_alloc(target->n * footpoints_kinds(target), sizeof *f.off);
    f.point = mem_alloc(target->n, sizeof *f.point);
    if (target->axis != NULL) {
        f.v = mem_alloc(target->n, sizeof *f.v);
        f.other = mem_alloc(target->n, sizeof *f.other);
    }
    return f;
}

void footpoints_free(struct footpoints *feet)
{
    free(feet->u);
    free(feet->v);
    free(feet->off);
    free(feet->point);
    free(feet->other);
    *feet = (struct footpoints){0};
}

void footpoints_copy(struct footpoints *to, const struct footpoints *from,
                     const struct target *target)
{
    memcpy(to->u, from->u, target->n * sizeof *to->u);
    if (target->axis != NULL)
        memcpy(to->v, from->v, target->n * sizeof *to->v);
    to->worst = from->worst;
    to->where = from->where;
}

/* The curve at u, of the point that is followed: the tracked one, or the other end of the radius.
 */
struct place {
    struct vec3 off, speed, bend; /* bend: of the tracked point only */
    struct vec3 axis;
    double reach;
};

static struct vec3 vec_of(const double *value)
{
    return vec(value[0], value[1], value[2]);
}

static void evaluate(const struct ppform *form, const struct target *target, size_t k, bool other,
                     const struct footpoint *at, struct place *p)
{
    double value[6], first[6], second[6];

    ppform_at(form, at->span, at->u, value, first, second);
    struct vec3 point = vec_of(value);
    p->speed = vec_of(first);
    p->bend = vec_of(second);
    if (target->axis != NULL) {
        struct vec3 reach = vec_sub(vec_of(value + 3), point);
        p->reach = vec_length(reach);
        p->axis = vec_scale(1 / p->reach, reach);
    }
    if (other) {
        struct vec3 turn = vec_sub(vec_of(first + 3), p->speed);
        point = vec_along(point, target->offset, p->axis);
        p->speed = vec_along(p->speed, target->offset / p->reach, vec_reject(turn, p->axis));
        p->bend = vec(0, 0, 0);
    }
    p->off = vec_sub(point, other ? target->other[k] : target->point[k]);
}

/* u with a step of Newton's, inside the curve and not over half a span. */
static double stepped(const struct ppform *form, const struct footpoint *at, double step)
{
    double most = ppform_half(form, at->span);
    double from = form->knot[0], to = form->knot[(size_t)form->degree + form->spans];
    double u = at->u + (step > most ? most : step < -most ? -most : step);

    return u < from ? from : u > to ? to : u;
}

/* Follows the foot of place k from at->u.  Returns the distance there. */
static double follow(const struct ppform *form, const struct target *target, size_t k, bool other,
                     struct footpoint *at)
{
    double tiny = SMALL * target->tolerance;
    struct place p = {0};

    for (int i = 0;; i++) {
        at->span = ppform_span(form, at->span, at->u);
        evaluate(form, target, k, other, at, &p);
        double square = vec_dot(p.speed, p.speed), slope = square + vec_dot(p.off, p.bend);
        if (i == STEPS || !(square > 0))
            break;
        slope = slope > 0.25 * square ? slope : 0.25 * square;
        double u = stepped(form, at, -vec_dot(p.off, p.speed) / slope), step = u - at->u;
        at->u = u;
        if (step * step * square <= SMALL * SMALL * vec_dot(p.off, p.off) + tiny * tiny) {
            p.off = vec_along(vec_along(p.off, step, p.speed), step * step / 2, p.bend);
            p.speed = vec_along(p.speed, step, p.bend);
            break;
        }
    }
    at->off = p.off;
    at->along = vec_unit(p.speed);
    at->axis = p.axis;
    at->reach = p.reach;
    return vec_length(p.off);
}

static void interpolation_both(const struct ppform *form, const struct target *target, size_t k,
                               struct footpoints *feet)
{
    struct footpoint *point = &feet->point[k], *other = &feet->other[k];
    double *off = &feet->off[k * FOOTPOINT_KINDS];

    other->u = feet->v[k];
    other->span = point->span;
    off[1] = follow(form, target, k, true, other);
    feet->v[k] = other->u;
    struct vec3 axis = target->other_leads ? other->axis : point->axis;
    off[2] = vec_distance(axis, target->axis[k]) * target->tolerance / target->angle;
}

void footpoints_follow(const struct ppform *form, const struct target *target,
                       struct footpoints *feet)
{
    size_t near = 0, kinds = footpoints_kinds(target);

    feet->worst = 0;
    feet->where = 0;
    for (size_t k = 0; k < target->n; k++) {
        struct footpoint *point = &feet->point[k];
        point->u = feet->u[k];
        point->span = near;
        feet->off[k * kinds] = follow(form, target, k, false, point);
        feet->u[k] = point->u;
        near = point->span;
        if (target->axis != NULL)
            interpolation_both(form, target, k, feet);
        for (size_t i = 0; i < kinds; i++)
            if (!(feet->off[k * kinds + i] <= feet->worst)) {
                feet->worst = feet->off[k * kinds + i];
                feet->where = k;
            }
    }
}
