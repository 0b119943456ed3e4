/* retrace - see retrace.h. */
#include "toolpath/retrace.h"

#include <stdlib.h>

#include "math/elementary.h"

static const double BACK = 2; /* times as long as straight: a way that goes back on itself */
static const double TURN = RADIANS(30); /* of a hook, at least */

static bool is_lifted(const struct run_point *p, const struct retrace_options *o)
{
    return !run_point_touches(p) || run_point_height(p) > o->offset + o->tolerance;
}

/* The last point before `end` at which the loop that begins at point i may end; i + 1: none. */
static size_t loop_end(const struct run *run, size_t i, size_t end, const struct retrace_options *o)
{
    const struct run_point *p = run->item;
    double way = 0;
    size_t last = i + 1;

    for (size_t k = i + 1; k < end && way <= o->longest; k++) {
        way += vec_distance(p[k - 1].ball, p[k].ball);
        double apart = vec_distance(p[i].ball, p[k].ball);
        if (k > i + 1 && apart <= o->gap && way > BACK * apart &&
            gouge_clear_along(o->guard, p[i].ball, p[k].ball, o->offset, o->tolerance))
            last = k;
        if (!is_lifted(&p[k], o))
            break;
    }
    return last;
}

size_t retrace_remove(struct lifted_strip *strip, const struct retrace_options *options)
{
    struct run *run = &strip->run;
    size_t kept = 0, from = 0, n = run->n;

    for (size_t k = 0; k < strip->end.n; k++) {
        size_t end = strip->end.item[k];
        for (size_t i = from, next; i < end; i = next) {
            next = loop_end(run, i, end, options);
            run->item[kept++] = run->item[i];
        }
        from = end;
        strip->end.item[k] = kept;
    }
    run->n = kept;
    return n - kept;
}

/* The point `at`, between two others, is a hook. */
static bool is_hook(const struct run_point *before, const struct run_point *at,
                    const struct run_point *after, const struct retrace_options *o)
{
    struct vec3 in = vec_sub(at->ball, before->ball), out = vec_sub(after->ball, at->ball);
    double nearest = fmin(vec_length(in), vec_length(out));

    if (!(nearest > 0 && nearest < RETRACE_NEAR && vec_angle(in, out) > TURN))
        return false;
    if (!is_lifted(at, o) &&
        vec_segment_distance(before->ball, after->ball, at->ball) > o->tolerance)
        return false;
    return gouge_clear_along(o->guard, before->ball, after->ball, o->offset, o->tolerance);
}

size_t retrace_hooks(struct lifted_strip *strip, const struct retrace_options *options)
{
    struct run *run = &strip->run;
    size_t kept = 0, from = 0, n = run->n;

    for (size_t k = 0; k < strip->end.n; k++) {
        size_t end = strip->end.item[k];
        for (size_t i = from; i < end; i++)
            if (i == from || i + 1 == end ||
                !is_hook(&run->item[kept - 1], &run->item[i], &run->item[i + 1], options))
                run->item[kept++] = run->item[i];
        from = end;
        strip->end.item[k] = kept;
    }
    run->n = kept;
    return n - kept;
}

/* The point `at`, at which nothing is touched, is thrown up between two others. */
static bool is_spike(const struct run_point *before, const struct run_point *at,
                     const struct run_point *after, const struct retrace_options *o)
{
    struct vec3 up = vec_sub(at->ball, before->ball), down = vec_sub(at->ball, after->ball);

    return !run_point_touches(at) && vec_dot(up, down) > 0 &&
           fmin(vec_length(up), vec_length(down)) > o->offset;
}

size_t retrace_spikes(struct lifted_strip *strip, const struct retrace_options *options)
{
    struct run *run = &strip->run;
    struct sizes ends = {0};
    size_t kept = 0, from = 0, n = run->n;

    for (size_t k = 0; k < strip->end.n; k++) {
        size_t end = strip->end.item[k], begin = kept;
        for (size_t i = from; i < end; i++) {
            const struct run_point *p = &run->item[i];
            const struct run_point *before = &run->item[kept > begin ? kept - 1 : kept];
            if (kept == begin || i + 1 == end || !is_spike(before, p, p + 1, options))
                run->item[kept++] = *p;
            else if (!gouge_clear_along(options->guard, before->ball, p[1].ball, options->offset,
                                        options->tolerance))
                *array_push(&ends) = begin = kept;
        }
        from = end;
        *array_push(&ends) = kept;
    }
    array_free(&strip->end);
    strip->end = ends;
    run->n = kept;
    return n - kept;
}
