/* iges_ruled - see iges_ruled.h. */
#include "iges_ruled.h"

#include <stdlib.h>

#include "base/array.h"
#include "iges_curve.h"
#include "math/box.h"
#include "nurbs/approximate.h"
#include "nurbs/construct.h"

/* Parts nearer than this are one; places between two kinks in which two curves are compared. */
static const double SAME = 1e-11;
enum { LOOKS = 64 };

static void measure_pieces(struct iges_side *s)
{
    s->length = mem_alloc(s->piece.n, sizeof *s->length);
    for (size_t i = 0; i < s->piece.n; i++) {
        s->length[i] = curve_length(&s->piece.item[i]);
        s->whole += s->length[i].length[s->length[i].n];
    }
}

static int read_side(const struct iges *iges, const struct iges_values *v, size_t index,
                     bool by_length, struct iges_side *s, struct error *error)
{
    const struct iges_entity *e, *unknown;
    if (iges_pointer(iges, v, index, &e, error) < 0)
        return -1;
    int got = by_length ? iges_curve(iges, e, &s->piece, &unknown, error)
                        : iges_curve_ranges(iges, e, &s->piece, &s->range, &unknown, error);
    if (got != 0 || s->piece.n == 0 || (!by_length && s->range.n == 0))
        return got != 0 ? got : 1;
    if (by_length)
        measure_pieces(s);
    else
        s->whole = s->range.item[s->range.n - 1].to - s->range.item[0].from;
    return 0;
}

int iges_ruled_read(const struct iges *iges, const struct iges_entity *entity,
                    struct iges_side side[2], struct error *error)
{
    struct iges_values v;
    side[0] = side[1] = (struct iges_side){0};
    if (iges_values(iges, entity, &v, error) < 0)
        return -1;
    int got = 0;
    for (size_t k = 0; k < 2 && got == 0; k++)
        got = read_side(iges, &v, 1 + k, entity->form == 0, &side[k], error);
    side[1].back = v.n > 3 && v.item[3].number > 0.5;
    array_free(&v);
    return got;
}

/* The piece that is at a part of the side, and its own parameter there. */
static size_t place_at(const struct iges_side *s, double part, double *own)
{
    size_t i = 0;
    double at = (s->back ? 1 - part : part) * s->whole;
    if (s->length) {
        while (i + 1 < s->piece.n && at > s->length[i].length[s->length[i].n]) {
            at -= s->length[i].length[s->length[i].n];
            i++;
        }
        *own = curve_length_at(&s->length[i], at);
    } else {
        at += s->range.item[0].from;
        i = iges_range_of(&s->range, at);
        *own = iges_parameter(&s->piece.item[i], &s->range.item[i], at);
    }
    return i;
}

double iges_ruled_own(const struct iges_side *s, double part)
{
    double own;
    size_t i = place_at(s, part, &own);
    const struct nurbs_axis *t = &s->piece.item[i].t;
    double at = ((double)i + (own - t->from) / (t->to - t->from)) / (double)s->piece.n;
    return s->back ? 1 - at : at;
}

static struct vec3 side_point(const void *context, double part)
{
    const struct iges_side *s = context;
    double own;
    size_t i = place_at(s, part, &own);
    return nurbs_curve_point(&s->piece.item[i], own);
}

/* The part of the side at which piece i has its own parameter. */
static double part_at(const struct iges_side *s, size_t i, double own)
{
    double at = 0;
    if (s->length) {
        for (size_t k = 0; k < i; k++)
            at += s->length[k].length[s->length[k].n];
        at += curve_length_to(&s->length[i], own);
    } else {
        at = iges_parameter_back(&s->piece.item[i], &s->range.item[i], own) - s->range.item[0].from;
    }
    at = s->whole > 0 ? at / s->whole : 0;
    return s->back ? 1 - at : at;
}

static int compare(const void *a, const void *b)
{
    const double *x = a, *y = b;
    return (*x > *y) - (*x < *y);
}

/* The parts at which either curve may have a kink, from 0 to 1. */
static void kinks_of(const struct iges_side side[2], struct doubles *at)
{
    struct doubles all = {0};
    for (int k = 0; k < 2; k++)
        for (size_t i = 0; i < side[k].piece.n; i++) {
            const struct nurbs_axis *t = &side[k].piece.item[i].t;
            size_t n = nurbs_axis_breaks(t, NULL, 0);
            double *own = mem_alloc(n + 1, sizeof *own);
            nurbs_axis_breaks(t, own, n);
            own[n] = t->to;
            for (size_t m = 0; m <= n; m++)
                *array_push(&all) = part_at(&side[k], i, own[m]);
            free(own);
        }
    if (all.n > 0)
        qsort(all.item, all.n, sizeof *all.item, compare);
    *array_push(at) = 0;
    for (size_t i = 0; i < all.n; i++)
        if (all.item[i] > at->item[at->n - 1] + 1e-9 && all.item[i] < 1 - 1e-9)
            *array_push(at) = all.item[i];
    *array_push(at) = 1;
    array_free(&all);
}

bool iges_ruled_exact(const struct iges_side side[2])
{
    struct doubles at = {0};
    bool same = true;
    kinks_of(side, &at);
    for (size_t i = 0; i + 1 < at.n && same; i++)
        for (int k = 0; k <= LOOKS && same; k++) {
            double part = at.item[i] + (at.item[i + 1] - at.item[i]) * k / LOOKS;
            same = fabs(iges_ruled_own(&side[0], part) - iges_ruled_own(&side[1], part)) <= SAME;
        }
    array_free(&at);
    return same;
}

static struct nurbs_curve joined(const struct iges_side *s)
{
    struct nurbs_curve c = s->piece.n == 1 ? construct_unit_range(&s->piece.item[0])
                                           : construct_joined(s->piece.item, s->piece.n);
    if (s->back)
        nurbs_curve_reverse(&c);
    return c;
}

/* A side as one NURBS curve, approximated between the kinks. */
static struct nurbs_curve approximated(const struct iges_side *s, const struct doubles *kink,
                                       double *rough)
{
    struct box box = box_empty();
    for (size_t i = 0; i + 1 < kink->n; i++)
        for (int k = 0; k <= LOOKS; k++)
            box_add(&box,
                    side_point(s, kink->item[i] + (kink->item[i + 1] - kink->item[i]) * k / LOOKS));
    double off, near = fmax(APPROXIMATE_OFFSET * box_diagonal(&box), 1e-12);
    struct nurbs_curve c = approximate_curve(side_point, s, kink->item, kink->n - 1, near, &off);
    *rough = fmax(*rough, off);
    return c;
}

struct nurbs iges_ruled_surface(const struct iges_side side[2], const struct transform *place,
                                double *rough)
{
    struct nurbs_curve c[2];
    struct doubles kink = {0};
    bool exact = iges_ruled_exact(side);
    kinks_of(side, &kink);
    for (int k = 0; k < 2; k++) {
        *rough = fmax(*rough, side[k].piece.rough);
        c[k] = exact ? joined(&side[k]) : approximated(&side[k], &kink, rough);
        construct_move(place, c[k].pole, c[k].t.poles);
    }
    struct nurbs s = construct_ruled(&c[0], &c[1]);
    nurbs_curve_free(&c[0]);
    nurbs_curve_free(&c[1]);
    array_free(&kink);
    return s;
}

void iges_ruled_free(struct iges_side side[2])
{
    for (int k = 0; k < 2; k++) {
        for (size_t i = 0; i < side[k].piece.n && side[k].length; i++)
            curve_length_free(&side[k].length[i]);
        free(side[k].length);
        patch_loop_free(&side[k].piece);
        array_free(&side[k].range);
    }
}
