/*
 * feet - Newton's method on (C - Q) . C' = 0.
 */
#include "feet.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"

enum { STEPS = 3 };

size_t feet_kinds(const struct target *target)
{
    return target->axis != NULL ? FEET_KINDS : 1;
}

struct feet feet_new(const struct target *target)
{
    struct feet f = {0};

    f.u = mem_alloc(target->n, sizeof *f.u);
    f.off = mem_alloc(target->n * feet_kinds(target), sizeof *f.off);
    if (target->axis != NULL)
        f.v = mem_alloc(target->n, sizeof *f.v);
    return f;
}

void feet_free(struct feet *feet)
{
    free(feet->u);
    free(feet->v);
    free(feet->off);
    *feet = (struct feet){0};
}

void feet_copy(struct feet *to, const struct feet *from, const struct target *target)
{
    memcpy(to->u, from->u, target->n * sizeof *to->u);
    memcpy(to->off, from->off, target->n * feet_kinds(target) * sizeof *to->off);
    if (target->axis != NULL)
        memcpy(to->v, from->v, target->n * sizeof *to->v);
    to->worst = from->worst;
    to->where = from->where;
}

static struct vec3 vec_of(const double *value)
{
    return vec(value[0], value[1], value[2]);
}

struct stance stance_at(const struct spanform *form, const struct target *target, size_t near,
                        double u)
{
    double value[6], first[6], second[6];
    struct stance s = {.span = spanform_span(form, near, u)};

    spanform_at(form, s.span, u, value, first, second);
    s.point = vec_of(value);
    s.speed = vec_of(first);
    s.bend = vec_of(second);
    if (target->axis == NULL)
        return s;
    s.reach = vec_sub(vec_of(value + 3), s.point);
    double length = vec_length(s.reach);
    s.axis = vec_scale(1 / length, s.reach);
    s.other = vec_along(s.point, target->offset, s.axis);
    struct vec3 turn = vec_sub(vec_of(first + 3), s.speed);
    s.other_speed = vec_along(s.speed, target->offset / length, vec_reject(turn, s.axis));
    return s;
}

/* One Newton step towards the foot of the place `of` for the tracked point. */
static double step_of(struct vec3 off, struct vec3 speed, struct vec3 bend)
{
    double square = vec_dot(speed, speed), slope = square + vec_dot(off, bend);

    if (!(square > 0))
        return 0;
    return -vec_dot(off, speed) / fmax(slope, 0.25 * square);
}

static double limited(const struct spanform *form, const struct stance *s, double u, double step)
{
    const double *knot = form->knot;
    double most = spanform_half(form, s->span);
    double from = knot[0], to = knot[(size_t)form->degree + form->spans];

    u += fmin(fmax(step, -most), most);
    return fmin(fmax(u, from), to);
}

static void follow_one(const struct spanform *form, const struct target *target, size_t k,
                       size_t near, struct feet *feet)
{
    struct stance s = stance_at(form, target, near, feet->u[k]);

    for (int i = 0; i < STEPS; i++) {
        double step = step_of(vec_sub(s.point, target->point[k]), s.speed, s.bend);
        feet->u[k] = limited(form, &s, feet->u[k], step);
        s = stance_at(form, target, s.span, feet->u[k]);
    }
    double *off = &feet->off[k * feet_kinds(target)];
    off[0] = vec_distance(s.point, target->point[k]);
    if (target->axis == NULL)
        return;
    struct stance t = stance_at(form, target, s.span, feet->v[k]);
    for (int i = 0; i < STEPS; i++) {
        double step = step_of(vec_sub(t.other, target->other[k]), t.other_speed, vec(0, 0, 0));
        feet->v[k] = limited(form, &t, feet->v[k], step);
        t = stance_at(form, target, t.span, feet->v[k]);
    }
    struct vec3 axis = target->other_leads ? t.axis : s.axis;
    off[1] = vec_distance(t.other, target->other[k]);
    off[2] = vec_distance(axis, target->axis[k]) * target->tolerance / target->angle;
}

void feet_follow(const struct spanform *form, const struct target *target, struct feet *feet)
{
    size_t near = 0, kinds = feet_kinds(target);

    feet->worst = 0;
    feet->where = 0;
    for (size_t k = 0; k < target->n; k++) {
        near = spanform_span(form, near, feet->u[k]);
        follow_one(form, target, k, near, feet);
        for (size_t i = 0; i < kinds; i++)
            if (!(feet->off[k * kinds + i] <= feet->worst)) {
                feet->worst = feet->off[k * kinds + i];
                feet->where = k;
            }
    }
}
