/* concave_radius - see concave_radius.h. */
#include "nurbs/concave_radius.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
#include "trim_loops.h"

/* Starts of the pattern search; samples over the whole range, least in a span, and where there are
 * more than MANY spans; steps of one search. */
enum { BEST = 12, ACROSS = 96, LEAST = 6, FEW = 3, MANY = 64, STEPS_MAX = 20000 };

/* By the size of the patch, and in mm: how exactly its trimming is followed. */
static const double TRIM_TOLERANCE = 1e-6;

struct search {
    const struct patch *patch;
    const struct uv_polygon *loops;
    bool flipped;
    struct concave_radius best[BEST]; /* of different spans, the most concave first */
    struct nurbs span[BEST];
};

static double curvature_at(const struct search *s, const struct nurbs *part, struct uv at,
                           struct vec3 *point)
{
    bool open = s->patch->open || s->loops->open || s->loops->n == 0;
    if (s->loops->n > 0 && !uv_polygon_inside(s->loops, open, at))
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

/* Keeps the BEST samples, in order. */
static void keep_best(struct search *s, struct concave_radius found, const struct nurbs *part)
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

/* The spans of the knots, and the most concave sample of each. */
struct spans {
    const struct search *search;
    struct doubles u, v;
    int nu, nv;
    struct concave_radius *most;
};

static struct nurbs span_of(const struct spans *s, size_t index)
{
    struct nurbs part = s->search->patch->surface;
    size_t i = index % (s->u.n - 1), j = index / (s->u.n - 1);
    part.u.from = s->u.item[i];
    part.u.to = s->u.item[i + 1];
    part.v.from = s->v.item[j];
    part.v.to = s->v.item[j + 1];
    return part;
}

static void sample_spans(void *context, size_t from, size_t to)
{
    struct spans *s = context;
    for (size_t k = from; k < to; k++) {
        struct nurbs part = span_of(s, k);
        struct concave_radius most = {.curvature = -HUGE_VAL};
        for (int j = 0; j <= s->nv; j++)
            for (int i = 0; i <= s->nu; i++) {
                struct concave_radius h = {
                    .at = {part.u.from + (part.u.to - part.u.from) * i / s->nu,
                           part.v.from + (part.v.to - part.v.from) * j / s->nv}};
                h.curvature = curvature_at(s->search, &part, h.at, &h.point);
                if (h.curvature > most.curvature)
                    most = h;
            }
        s->most[k] = most;
    }
}

/* How many samples in each of n spans. */
static int samples_per_span(size_t n)
{
    int each = ACROSS / (int)n;
    return each > LEAST ? each : n > MANY ? FEW : LEAST;
}

/* Pattern search: steps in eight directions, halved when none goes up. */
static struct concave_radius climb(const struct search *s, const struct nurbs *part,
                                   struct concave_radius h)
{
    static const int direction[8][2] = {{1, 0}, {-1, 0},  {0, 1},  {0, -1},
                                        {1, 1}, {-1, -1}, {1, -1}, {-1, 1}};
    double u = part->u.to - part->u.from, v = part->v.to - part->v.from, step = 1.0 / LEAST;
    for (int turn = 0; turn < STEPS_MAX && step > 1e-12; turn++) {
        struct concave_radius next = h;
        for (int k = 0; k < 8; k++) {
            struct concave_radius t = h;
            t.at.u = fmin(fmax(h.at.u + direction[k][0] * step * u, part->u.from), part->u.to);
            t.at.v = fmin(fmax(h.at.v + direction[k][1] * step * v, part->v.from), part->v.to);
            t.curvature = curvature_at(s, part, t.at, &t.point);
            if (t.curvature > next.curvature)
                next = t;
        }
        step *= next.curvature > h.curvature ? 1 : 0.5;
        h = next;
    }
    return h;
}

static struct concave_radius find_inside(const struct patch *patch, const struct uv_polygon *loops,
                                         bool flipped, int threads)
{
    struct search s = {.patch = patch, .loops = loops, .flipped = flipped};
    struct spans spans = {.search = &s};
    for (size_t i = 0; i < BEST; i++)
        s.best[i].curvature = -HUGE_VAL;
    span_ends(&patch->surface.u, &spans.u);
    span_ends(&patch->surface.v, &spans.v);
    spans.nu = samples_per_span(spans.u.n);
    spans.nv = samples_per_span(spans.v.n);
    size_t n = (spans.u.n - 1) * (spans.v.n - 1);
    spans.most = mem_alloc(n, sizeof *spans.most);
    parallel_for(threads, n, sample_spans, &spans);
    for (size_t k = 0; k < n; k++) {
        struct nurbs part = span_of(&spans, k);
        keep_best(&s, spans.most[k], &part);
    }
    array_free(&spans.u);
    array_free(&spans.v);
    free(spans.most);
    struct concave_radius best = s.best[0];
    for (size_t i = 0; i < BEST && s.best[i].curvature > -HUGE_VAL; i++) {
        struct concave_radius h = climb(&s, &s.span[i], s.best[i]);
        if (h.curvature > best.curvature)
            best = h;
    }
    return best;
}

struct concave_radius concave_radius_find(const struct patch *patch, bool flipped, int threads)
{
    const struct nurbs *s = &patch->surface;
    struct uv_polygon loops;
    double size = vec_distance(nurbs_point(s, (struct uv){s->u.from, s->v.from}),
                               nurbs_point(s, (struct uv){s->u.to, s->v.to}));
    trim_loops(patch, fmax(TRIM_TOLERANCE * size, TRIM_TOLERANCE), &loops);
    struct concave_radius found = find_inside(patch, &loops, flipped, threads);
    uv_polygon_free(&loops);
    return found;
}

/* What the threads share: a patch is a unit of work. */
struct concave_search {
    const struct patches *patches;
    const bool *flipped;
    int threads; /* for one patch */
    struct concave_radius *found;
};

static void find_some(void *context, size_t from, size_t to)
{
    struct concave_search *s = context;
    for (size_t i = from; i < to; i++)
        s->found[i] = concave_radius_find(&s->patches->item[i], s->flipped[i], s->threads);
}

struct concave_radius *concave_radius_find_all(const struct patches *patches, const bool *flipped,
                                               int threads)
{
    struct concave_radius *found = mem_alloc(patches->n + 1, sizeof *found);
    bool few = patches->n < 8; /* then the threads share each, else each takes one */
    struct concave_search search = {patches, flipped, few ? threads : 1, found};
    parallel_for(few ? 1 : threads, patches->n, find_some, &search);
    return found;
}
