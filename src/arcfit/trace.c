/* trace - see trace.h. */
#include "arcfit/trace.h"

#include <stdlib.h>

struct trace trace_of(const struct run *run, size_t from, size_t n, bool centre, bool forward)
{
    struct trace t = {
        .n = n,
        .p = mem_alloc(n, sizeof *t.p),
        .other = mem_alloc(n, sizeof *t.other),
        .axis = mem_alloc(n, sizeof *t.axis),
        .tangent = mem_alloc(n, sizeof *t.tangent),
        .length = mem_alloc(n, sizeof *t.length),
        .lever = centre ? -run->radius : run->radius,
    };
    struct run alone = {.radius = run->radius};
    for (size_t i = 0; i < n; i++) {
        const struct run_point *r = &run->item[from + i];
        t.p[i] = centre ? r->ball : r->tip;
        t.axis[i] = r->axis;
        t.other[i] = vec_along(t.p[i], t.lever, r->axis);
        t.length[i] = i ? t.length[i - 1] + vec_distance(t.p[i - 1], t.p[i]) : 0;
        struct run_point *at = array_push(&alone);
        *at = centre || forward ? *r : (struct run_point){.ball = t.p[i]};
        at->ball = t.p[i];
    }
    run_tangents(&alone, forward, t.tangent);
    array_free(&alone);
    return t;
}

void trace_free(struct trace *trace)
{
    free(trace->p);
    free(trace->other);
    free(trace->axis);
    free(trace->tangent);
    free(trace->length);
    *trace = (struct trace){0};
}

size_t trace_interval(const struct trace *t, double place, double *part)
{
    double last = (double)(t->n - 1);
    place = fmin(last, fmax(0, place));
    size_t i = (size_t)place;
    if (i + 1 >= t->n)
        i = t->n > 1 ? t->n - 2 : 0;
    *part = place - (double)i;
    return i;
}

struct vec3 trace_point(const struct trace *t, double place)
{
    double part;
    size_t i = trace_interval(t, place, &part);
    return part > 0 ? vec_mix(t->p[i], t->p[i + 1], part) : t->p[i];
}

struct vec3 trace_axis(const struct trace *t, double place)
{
    double part;
    size_t i = trace_interval(t, place, &part);
    return part <= 0   ? t->axis[i]
           : part >= 1 ? t->axis[i + 1]
                       : vec_slerp(t->axis[i], t->axis[i + 1], part);
}

bool trace_axis_still(const struct trace *t, size_t from, size_t to)
{
    for (size_t i = from + 1; i <= to; i++)
        if (vec_distance(t->axis[i], t->axis[from]) > 0)
            return false;
    return true;
}

static double segment_distance2(struct vec3 q, struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(q, vec_segment_nearest(a, b, q));
    return vec_dot(d, d);
}

double trace_distance(const struct vec3 *line, size_t n, struct vec3 q, size_t *k)
{
    double here = segment_distance2(q, line[*k], line[*k + 1]);
    size_t best = *k;
    for (size_t i = *k + 1; i + 1 < n; i++) {
        double d = segment_distance2(q, line[i], line[i + 1]);
        if (d > here)
            break;
        best = d < here ? i : best;
        here = d;
    }
    for (size_t i = *k; i-- > 0;) {
        double d = segment_distance2(q, line[i], line[i + 1]);
        if (d > here)
            break;
        best = d < here ? i : best;
        here = d;
    }
    *k = best;
    return sqrt(here);
}

double trace_place(const struct trace *t, struct vec3 q, double place)
{
    if (t->n < 2)
        return 0;
    double part;
    size_t k = trace_interval(t, place, &part);
    trace_distance(t->p, t->n, q, &k);
    return (double)k + vec_segment_foot(t->p[k], t->p[k + 1], q);
}
