/*
 * track - the arrays that a fitter of splines works on.
 */
#include "splinefit/track.h"

#include <stdlib.h>

#include "base/array.h"

static const double REPEATED = 1e-7; /* mm */

/* How far two points of a run are apart; the axis counts at the end of the radius, or of 1 mm. */
static double chord_between(const struct run *run, size_t i, size_t j)
{
    const struct run_point *a = &run->item[i], *b = &run->item[j];
    double radius = run->radius > 0 ? run->radius : 1;
    struct vec3 tip = vec_sub(b->tip, a->tip);
    struct vec3 end = vec_along(tip, radius, vec_sub(b->axis, a->axis));

    return sqrt((vec_dot(tip, tip) + vec_dot(end, end)) / 2);
}

/* The points that stay; at least the first one. */
static struct sizes without_repeats(const struct run *run)
{
    struct sizes keep = {0};

    *array_push(&keep) = 0;
    for (size_t i = 1; i < run->n; i++)
        if (chord_between(run, keep.item[keep.n - 1], i) > REPEATED)
            *array_push(&keep) = i;
    if (keep.n > 1)
        keep.item[keep.n - 1] = run->n - 1;
    return keep;
}

static bool axis_is_fixed(const struct run *run)
{
    for (size_t i = 1; i < run->n; i++)
        if (vec_distance(run->item[i].axis, run->item[0].axis) > 2e-9)
            return false;
    return true;
}

struct track track_new(const struct run *run, bool centre)
{
    struct sizes keep = without_repeats(run);
    double radius = run->radius > 0 ? run->radius : 0;
    struct track t = {.n = keep.n, .offset = centre ? -radius : radius};

    t.point = mem_alloc(t.n, sizeof *t.point);
    t.other = mem_alloc(t.n, sizeof *t.other);
    t.axis = mem_alloc(t.n, sizeof *t.axis);
    t.chord = mem_alloc(t.n, sizeof *t.chord);
    if (!axis_is_fixed(run))
        t.head = mem_alloc(t.n, sizeof *t.head);
    for (size_t k = 0; k < t.n; k++) {
        const struct run_point *p = &run->item[keep.item[k]];
        t.point[k] = centre ? p->ball : p->tip;
        t.axis[k] = p->axis;
        t.other[k] = vec_along(t.point[k], t.offset, p->axis);
        if (t.head != NULL)
            t.head[k] = vec_along(t.point[k], TRACK_LENGTH, p->axis);
        if (k > 0)
            t.chord[k - 1] = chord_between(run, keep.item[k - 1], keep.item[k]);
    }
    array_free(&keep);
    return t;
}

void track_free(struct track *track)
{
    free(track->point);
    free(track->other);
    free(track->axis);
    free(track->head);
    free(track->chord);
    *track = (struct track){0};
}

struct bspline track_curve(const struct track *track, int degree, size_t poles)
{
    struct bspline curve = bspline_new(degree, poles, track->head != NULL);

    curve.length = TRACK_LENGTH;
    return curve;
}

static void set_pole(struct bspline *curve, size_t i, const struct track *track, size_t k)
{
    curve->pole[i] = track->point[k];
    if (track->head != NULL)
        curve->head[i] = track->head[k];
}

struct bspline track_straight(const struct track *track)
{
    struct bspline curve = track_curve(track, 1, 2);

    set_pole(&curve, 0, track, 0);
    set_pole(&curve, 1, track, track->n - 1);
    curve.knot[2] = curve.knot[3] = 1;
    return curve;
}

struct bspline track_polyline(const struct track *track)
{
    struct bspline curve = track_curve(track, 1, track->n);

    for (size_t k = 0; k < track->n; k++)
        set_pole(&curve, k, track, k);
    for (size_t k = 1; k < track->n; k++)
        curve.knot[k + 1] = curve.knot[k] + track->chord[k - 1];
    curve.knot[track->n + 1] = curve.knot[track->n];
    return curve;
}
