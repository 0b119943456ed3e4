/* hollow - see hollow.h. */
#include "hollow.h"

#include <stdlib.h>

#include "array.h"
#include "parallel.h"
#include "trimloops.h"

enum { BEST = 12, LEAST = 6, ACROSS = 96, STEPS_MAX = 20000 };

struct search {
    const struct patch *patch;
    const struct uvloops *loops;
    bool flipped;
    struct hollow best[BEST]; /* of different spans, the most hollow first */
    struct nurbs span[BEST];
};

static double curvature_at(const struct search *s, const struct nurbs *part, struct uv at,
                           struct vec3 *point)
{
    bool open = s->patch->open || s->loops->n == 0;
    if (s->loops->n > 0 && !uvloops_inside(s->loops, open, at))
        return -HUGE_VAL;
    struct nurbs_place p = nurbs_place(part, at);
    *point = p.point;
    return vec_dot(p.normal, p.normal) > 0.5 ? (s->flipped ? -p.k2 : p.k1) : -HUGE_VAL;
}

/* The ends of the spans that have a length, within the range. */
static void span_ends(const struct nurbs_axis *a, struct doubles *end)
{
    *array_push(end) = a->from;
    for (size_t i = (size_t)a->degree; i <= a->poles; i++)
        if (a->knot[i] > end->item[end->n - 1] && a->knot[i] < a->to)
            *array_push(end) = a->knot[i];
    *array_push(end) = a->to;
}

static void keep(struct search *s, struct hollow found, const struct nurbs *part)
{
    size_t i = BEST;
    for (; i > 0 && found.curvature > s->best[i - 1].curvature; i--)
        if (i < BEST) {
            s->best[i] = s->best[i - 1];
            s->span[i] = s->span[i - 1];
        }
    if (i < BEST) {
        s->best[i] = found;
        s->span[i] = *part;
    }
}

static void sample_span(struct search *s, const struct nurbs *part, int nu, int nv)
{
    struct hollow most = {.curvature = -HUGE_VAL};
    for (int j = 0; j <= nv; j++)
        for (int i = 0; i <= nu; i++) {
            struct hollow h = {.at = {part->u.from + (part->u.to - part->u.from) * i / nu,
                                      part->v.from + (part->v.to - part->v.from) * j / nv}};
            h.curvature = curvature_at(s, part, h.at, &h.point);
            if (h.curvature > most.curvature)
                most = h;
        }
    keep(s, most, part);
}

/* Steps in eight directions, halved when none goes up. */
static struct hollow climb(const struct search *s, const struct nurbs *part, struct hollow h)
{
    static const int way[8][2] = {{1, 0}, {-1, 0},  {0, 1},  {0, -1},
                                  {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
    double u = part->u.to - part->u.from, v = part->v.to - part->v.from, step = 1.0 / LEAST;
    for (int turn = 0; turn < STEPS_MAX && step > 1e-12; turn++) {
        struct hollow next = h;
        for (int k = 0; k < 8; k++) {
            struct hollow t = h;
            t.at.u = fmin(fmax(h.at.u + way[k][0] * step * u, part->u.from), part->u.to);
            t.at.v = fmin(fmax(h.at.v + way[k][1] * step * v, part->v.from), part->v.to);
            t.curvature = curvature_at(s, part, t.at, &t.point);
            if (t.curvature > next.curvature)
                next = t;
        }
        step *= next.curvature > h.curvature ? 1 : 0.5;
        h = next;
    }
    return h;
}

struct hollow hollow_find(const struct patch *patch, const struct uvloops *loops, bool flipped)
{
    struct search s = {.patch = patch, .loops = loops, .flipped = flipped};
    struct doubles u = {0}, v = {0};
    struct nurbs part = patch->surface;
    for (size_t i = 0; i < BEST; i++)
        s.best[i].curvature = -HUGE_VAL;
    span_ends(&part.u, &u);
    span_ends(&part.v, &v);
    int nu = ACROSS / (int)u.n > LEAST ? ACROSS / (int)u.n : LEAST;
    int nv = ACROSS / (int)v.n > LEAST ? ACROSS / (int)v.n : LEAST;
    for (size_t j = 0; j + 1 < v.n; j++)
        for (size_t i = 0; i + 1 < u.n; i++) {
            part.u.from = u.item[i];
            part.u.to = u.item[i + 1];
            part.v.from = v.item[j];
            part.v.to = v.item[j + 1];
            sample_span(&s, &part, nu, nv);
        }
    array_free(&u);
    array_free(&v);
    struct hollow best = s.best[0];
    for (size_t i = 0; i < BEST && s.best[i].curvature > -HUGE_VAL; i++) {
        struct hollow h = climb(&s, &s.span[i], s.best[i]);
        if (h.curvature > best.curvature)
            best = h;
    }
    return best;
}

struct job {
    const struct patches *patches;
    const bool *flipped;
    struct hollow *hollow;
};

static void find_some(void *context, size_t from, size_t to)
{
    struct job *job = context;
    for (size_t i = from; i < to; i++) {
        const struct patch *patch = &job->patches->item[i];
        const struct nurbs *s = &patch->surface;
        struct uvloops loops;
        double size = vec_distance(nurbs_point(s, (struct uv){s->u.from, s->v.from}),
                                   nurbs_point(s, (struct uv){s->u.to, s->v.to}));
        trimloops(patch, fmax(1e-6 * size, 1e-6), &loops);
        job->hollow[i] = hollow_find(patch, &loops, job->flipped[i]);
        uvloops_free(&loops);
    }
}

struct hollow *hollow_find_all(const struct patches *patches, const bool *flipped, int threads)
{
    struct hollow *hollow = mem_alloc(patches->n + 1, sizeof *hollow);
    struct job job = {patches, flipped, hollow};
    parallel_for(threads, patches->n, find_some, &job);
    return hollow;
}
