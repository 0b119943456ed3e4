/* iges_trim - see iges_trim.h. */
#include "iges_trim.h"

#include <stdlib.h>

#include "base/array.h"
#include "iges_curve.h"

enum { COUNT_MAX = 2147483647 };

/* By the length of a curve: its end is the same place as that of another. */
static const double RUN_NEAR = 1e-2;

static void ignore_loop(struct patch *patch, const struct iges_entity *loop,
                        const struct iges_entity *unknown)
{
    if (patch->ignored++ == 0) {
        patch->ignored_entity = loop->number;
        patch->ignored_type = unknown->type;
    }
}

/* The curve that parameter `at` points to: 0 when it was taken, 1 when there is none, or none that
 * is understood. */
static int curve_at(const struct iges_trimming *s, const struct iges_values *v, size_t at,
                    struct patch_loop *loop, const struct iges_entity **unknown,
                    struct error *error)
{
    const struct iges_entity *curve;
    if (at >= v->n || !(v->item[at].number > 0))
        return 1;
    if (iges_pointer(s->iges, v, at, &curve, error) < 0)
        return -1;
    return iges_curve(s->iges, curve, loop, unknown, error);
}

/* A 142: its curve in the parameters (the third number) or in space (the fourth), whichever the
 * file prefers, else the other one. */
static int curve_142(const struct iges_trimming *s, const struct iges_values *v,
                     struct patch_loop *loop, const struct iges_entity **unknown,
                     struct error *error)
{
    bool prefers_space =
        s->space || (v->n > 5 && v->item[5].number > 1.5 && v->item[5].number < 2.5);
    int got = 1;
    for (int i = 0; i < 2 && got == 1; i++) {
        patch_loop_free(loop);
        loop->space = prefers_space == (i == 0);
        got = curve_at(s, v, loop->space ? 4 : 3, loop, unknown, error);
    }
    return got;
}

/* A 142 whose curve in space was taken: what its curve in the parameters, where there is one, tells
 * beside it. */
static int told_142(const struct iges_trimming *s, const struct iges_values *v, struct patch *patch,
                    struct error *error)
{
    struct patch_loop told = {0};
    const struct iges_entity *unknown;
    int got = curve_at(s, v, 3, &told, &unknown, error);
    if (got == 0 && told.n > 0)
        *array_push(&patch->told) = told;
    else
        patch_loop_free(&told);
    return got < 0 ? -1 : 0;
}

/* A 141: for each curve in space the ones in the parameters; all in space where one of them has
 * none. */
static int curves_141(const struct iges_trimming *s, const struct iges_values *v,
                      struct patch_loop *loop, const struct iges_entity **unknown,
                      struct error *error)
{
    long count, parts;
    int got = 1;
    if (iges_whole(s->iges, v, 4, 1, COUNT_MAX, "count of curves", &count, error) < 0)
        return -1;
    for (int i = 0; i < 2 && got == 1; i++) {
        int space = s->space ? 1 - i : i;
        size_t at = 5;
        patch_loop_free(loop);
        loop->space = space == 1;
        got = 0;
        for (long c = 0; c < count && got == 0; c++, at += 3 + (size_t)parts) {
            if (iges_whole(s->iges, v, at + 2, 0, COUNT_MAX, "count of curves", &parts, error) < 0)
                return -1;
            if (space == 1 || parts == 0)
                got = space == 1 ? curve_at(s, v, at, loop, unknown, error) : 1;
            for (size_t k = 0; space == 0 && k < (size_t)parts && got == 0; k++)
                got = curve_at(s, v, at + 3 + k, loop, unknown, error);
        }
    }
    return got;
}

/* Curve `index` of a list of edges (504), turned round where the loop runs against it. */
static int edge_504(const struct iges_trimming *s, const struct iges_entity *list, long index,
                    bool forwards, struct patch_loop *loop, const struct iges_entity **unknown,
                    struct error *error)
{
    struct iges_values v;
    size_t first = loop->n;
    long count;
    if (iges_values(s->iges, list, &v, error) < 0)
        return -1;
    int got = iges_whole(s->iges, &v, 1, index, COUNT_MAX, "count of edges", &count, error);
    if (got == 0)
        got = curve_at(s, &v, 2 + 5 * (size_t)(index - 1), loop, unknown, error);
    array_free(&v);
    for (size_t i = first, k = loop->n; i < k && !forwards && got == 0; i++) {
        struct nurbs_curve last = loop->item[--k];
        loop->item[k] = loop->item[i];
        loop->item[i] = last;
        nurbs_curve_reverse(&loop->item[i]);
        if (i != k)
            nurbs_curve_reverse(&loop->item[k]);
    }
    return got;
}

/* A 108 of form 1: the closed curve in space around the part of its plane. */
static int curve_108(const struct iges_trimming *s, const struct iges_values *v,
                     struct patch_loop *loop, const struct iges_entity **unknown,
                     struct error *error)
{
    loop->space = true;
    return curve_at(s, v, 5, loop, unknown, error);
}

/* A 508: edges, each with a list and its number there, and vertices, which say nothing. */
static int edges_508(const struct iges_trimming *s, const struct iges_values *v,
                     struct patch_loop *loop, const struct iges_entity **unknown,
                     struct error *error)
{
    long count, index, parts, vertex;
    size_t at = 2;
    int got = 0;
    if (iges_whole(s->iges, v, 1, 1, COUNT_MAX, "count of edges", &count, error) < 0)
        return -1;
    loop->space = loop->directed = true;
    for (long i = 0; i < count && got == 0; i++, at += 5 + 2 * (size_t)parts) {
        const struct iges_entity *list;
        if (iges_whole(s->iges, v, at, 0, 1, "kind of edge", &vertex, error) < 0 ||
            iges_whole(s->iges, v, at + 2, 1, COUNT_MAX, "number of an edge", &index, error) < 0 ||
            iges_whole(s->iges, v, at + 4, 0, COUNT_MAX, "count of curves", &parts, error) < 0 ||
            iges_pointer(s->iges, v, at + 1, &list, error) < 0)
            return -1;
        bool forwards = at + 3 < v->n && v->item[at + 3].number > 0.5;
        if (vertex == 0)
            got = edge_504(s, list, index, forwards, loop, unknown, error);
    }
    return got;
}

/* Curves in space: to mm, and placed as what they trim. */
static void place_loop(const struct iges_trimming *s, struct patch_loop *loop)
{
    for (size_t i = 0; i < loop->n; i++)
        for (size_t k = 0; k < loop->item[i].t.poles; k++) {
            struct nurbs_pole *p = &loop->item[i].pole[k];
            struct vec3 at = vec_scale(1 / p->w, vec(p->wx, p->wy, p->wz));
            at = vec_scale(s->mm * p->w, transform_point(&s->outer, at));
            *p = (struct nurbs_pole){at.x, at.y, at.z, p->w};
        }
}

static struct vec3 end_of(const struct nurbs_curve *c, bool last)
{
    return nurbs_curve_point(c, last ? c->t.to : c->t.from);
}

/* Turns the curves from `from` to before `to` round: the last of them first. */
static void turn_run(struct patch_loop *loop, size_t from, size_t to)
{
    struct patch_loop run = {.n = to - from, .item = loop->item + from};
    patch_loop_turn(&run, 0);
}

/* The first of the curves from k on, each of which begins where the one before it ends, that ends
 * at the place, within the distance: the index after it, or k. */
static size_t run_to(const struct patch_loop *loop, size_t k, struct vec3 at, double near)
{
    for (size_t m = k; m < loop->n; m++) {
        struct vec3 last = end_of(&loop->item[m], true);
        if (vec_distance(last, at) <= near)
            return m + 1;
        if (m + 1 < loop->n && vec_distance(last, end_of(&loop->item[m + 1], false)) > near)
            return k;
    }
    return k;
}

/* A curve of the file that runs backwards is several here, an arc for instance, that follow each
 * other forwards: they are turned round together. */
static void turn_runs(struct patch_loop *loop)
{
    struct vec3 start, at;
    if (loop->directed || loop->n < 3)
        return;
    start = end_of(&loop->item[0], false);
    at = end_of(&loop->item[0], true);
    for (size_t k = 1; k < loop->n; k++) {
        struct vec3 first = end_of(&loop->item[k], false), last = end_of(&loop->item[k], true);
        double near = RUN_NEAR * vec_distance(first, last);
        double off = fmin(vec_distance(at, first), vec_distance(at, last));
        double other = fmin(vec_distance(start, first), vec_distance(start, last));
        size_t end = off > near ? run_to(loop, k, at, near) : k;
        if (off > near && end == k && other <= near && run_to(loop, 0, at, near) == k)
            turn_run(loop, 0, k);
        else if (end > k)
            turn_run(loop, k, end);
        at = off > near && end == k && other <= near ? start : at;
        first = end_of(&loop->item[k], false);
        last = end_of(&loop->item[k], true);
        at = vec_distance(at, last) < vec_distance(at, first) ? first : last;
    }
}

int iges_trim(const struct iges_trimming *s, struct patch *patch, const struct iges_entity *e,
              struct error *error)
{
    struct patch_loop loop = {0};
    struct iges_values v;
    const struct iges_entity *unknown = e;
    if (iges_values(s->iges, e, &v, error) < 0)
        return -1;
    int got = e->type == 142   ? curve_142(s, &v, &loop, &unknown, error)
              : e->type == 141 ? curves_141(s, &v, &loop, &unknown, error)
              : e->type == 508 ? edges_508(s, &v, &loop, &unknown, error)
              : e->type == 108 ? curve_108(s, &v, &loop, &unknown, error)
                               : 1;
    if (got == 0 && loop.space && e->type == 142 && told_142(s, &v, patch, error) < 0)
        got = -1;
    array_free(&v);
    if (got == 0 && loop.space)
        place_loop(s, &loop);
    if (got == 0)
        turn_runs(&loop);
    if (got == 0 && loop.n > 0)
        *array_push(&patch->loop) = loop;
    else
        patch_loop_free(&loop);
    if (got > 0)
        ignore_loop(patch, e, unknown);
    return got < 0 ? -1 : 0;
}
