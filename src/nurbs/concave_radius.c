/* concave_radius - see concave_radius.h. */
#include "nurbs/concave_radius.h"

#include <stdlib.h>

#include "base/array.h"
#include "base/parallel.h"
#include "trim_loops.h"

/* Starts of the pattern search, and those in one span; samples over the whole range, least in a
 * span, and where there are more than MANY spans; steps of one search. */
enum { BEST = 24, EACH = 3, ACROSS = 96, LEAST = 6, FEW = 3, MANY = 64, STEPS_MAX = 20000 };

/* By the size of the patch, and in mm: how exactly its trimming is followed. */
static const double TRIM_TOLERANCE = 1e-6;

/* Curvatures that differ by so much of them, or by so much in 1/mm, are one: of a cylinder, and of
 * a plane. */
static const double EVEN = 1e-9, FLAT = 1e-12;

struct search {
    const struct patch *patch;
    const struct uv_polygon *loops;
    const struct uv_rows *rows; /* of the loops */
    bool flipped;
    struct concave_radius best[BEST]; /* the most concave first */
    struct nurbs span[BEST];
};

static double curvature_at(const struct search *s, const struct nurbs *part, struct uv at,
                           struct vec3 *point)
{
    bool open = s->patch->open || s->loops->open || s->loops->n == 0;
    if (s->loops->n > 0 && !uv_rows_inside(s->rows, open, at))
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

/* The spans of the knots, and the EACH most concave samples of each that no neighbour exceeds. */
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

/* True when no neighbour in the span is more concave. */
static bool is_peak(const struct spans *s, const struct concave_radius sample[], int i, int j)
{
    double own = sample[j * (s->nu + 1) + i].curvature;
    for (int b = j > 0 ? j - 1 : 0; b <= j + 1 && b <= s->nv; b++)
        for (int a = i > 0 ? i - 1 : 0; a <= i + 1 && a <= s->nu; a++)
            if (sample[b * (s->nu + 1) + a].curvature > own)
                return false;
    return own > -HUGE_VAL;
}

static void keep_peaks(const struct spans *s, const struct concave_radius sample[],
                       struct concave_radius most[])
{
    for (int i = 0; i < EACH; i++)
        most[i].curvature = -HUGE_VAL;
    for (int k = 0; k < (s->nu + 1) * (s->nv + 1); k++) {
        if (!(sample[k].curvature > most[EACH - 1].curvature) ||
            !is_peak(s, sample, k % (s->nu + 1), k / (s->nu + 1)))
            continue;
        int i = EACH - 1;
        for (; i > 0 && sample[k].curvature > most[i - 1].curvature; i--)
            most[i] = most[i - 1];
        most[i] = sample[k];
    }
}

static void sample_spans(void *context, size_t from, size_t to)
{
    struct spans *s = context;
    size_t n = (size_t)(s->nu + 1) * (size_t)(s->nv + 1);
    struct concave_radius *sample = mem_alloc(n, sizeof *sample);
    for (size_t k = from; k < to; k++) {
        struct nurbs part = span_of(s, k);
        for (int j = 0; j <= s->nv; j++)
            for (int i = 0; i <= s->nu; i++) {
                struct concave_radius h = {
                    .at = {part.u.from + (part.u.to - part.u.from) * i / s->nu,
                           part.v.from + (part.v.to - part.v.from) * j / s->nv}};
                h.curvature = curvature_at(s->search, &part, h.at, &h.point);
                sample[j * (s->nu + 1) + i] = h;
            }
        keep_peaks(s, sample, s->most + EACH * k);
    }
    free(sample);
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
        step *= next.curvature > h.curvature ? 2 : 0.5; /* along a narrow ridge it grows again */
        h = next;
    }
    return h;
}

/* Place t of a loop: t's whole part counts its corners, the rest is how far on to the next. */
static struct concave_radius border_place(const struct search *s, const struct uvs *loop, double t)
{
    const struct nurbs *f = &s->patch->surface;
    double n = (double)loop->n, whole = floor(t), part = t - whole;
    size_t i = (size_t)(whole - n * floor(whole / n)) % loop->n;
    struct uv a = loop->item[i], b = loop->item[(i + 1) % loop->n];
    struct concave_radius h = {
        .at = {fmin(fmax(a.u + part * (b.u - a.u), f->u.from), f->u.to),
               fmin(fmax(a.v + part * (b.v - a.v), f->v.from), f->v.to)},
    };
    struct nurbs_place p = nurbs_place(f, h.at);
    bool known = vec_dot(p.normal, p.normal) > 0.5;
    h.point = p.point;
    h.curvature = known ? (s->flipped ? -p.k2 : p.k1) : -HUGE_VAL;
    return h;
}

/* The most concave place of a loop: from each corner that is more so than its neighbours, steps
 * along the loop, halved when neither way goes up. */
static struct concave_radius climb_border(const struct search *s, const struct uvs *loop)
{
    struct concave_radius best = {.curvature = -HUGE_VAL}, at[3];
    at[1] = border_place(s, loop, -1);
    at[2] = border_place(s, loop, 0);
    for (size_t i = 0; i < loop->n; i++) {
        at[0] = at[1], at[1] = at[2], at[2] = border_place(s, loop, (double)i + 1);
        struct concave_radius h = at[1];
        if (h.curvature < at[0].curvature || h.curvature < at[2].curvature)
            continue;
        double lower = fmin(at[0].curvature, at[2].curvature);
        if (h.curvature - lower <= fmax(EVEN * fabs(h.curvature), FLAT)) { /* no way up */
            best = h.curvature > best.curvature ? h : best;
            continue;
        }
        double t = (double)i, step = 0.5;
        for (int turn = 0; turn < STEPS_MAX && step > 1e-9; turn++) {
            struct concave_radius low = border_place(s, loop, t - step);
            struct concave_radius high = border_place(s, loop, t + step);
            bool up = fmax(low.curvature, high.curvature) > h.curvature;
            bool back = low.curvature > high.curvature;
            t += up ? (back ? -step : step) : 0;
            h = up ? (back ? low : high) : h;
            step *= up ? 1 : 0.5;
        }
        best = h.curvature > best.curvature ? h : best;
    }
    return best;
}

/* The border of the range, once round. */
static struct uvs range_border(const struct nurbs *f)
{
    const struct uv corner[4] = {
        {f->u.from, f->v.from}, {f->u.to, f->v.from}, {f->u.to, f->v.to}, {f->u.from, f->v.to}};
    struct uvs rim = {0};
    for (int i = 0; i < 4 * ACROSS; i++) {
        struct uv a = corner[i / ACROSS], b = corner[(i / ACROSS + 1) % 4];
        double part = i % ACROSS / (double)ACROSS;
        *array_push(&rim) = (struct uv){a.u + part * (b.u - a.u), a.v + part * (b.v - a.v)};
    }
    return rim;
}

static struct concave_radius find_inside(const struct patch *patch, const struct uv_polygon *loops,
                                         bool flipped, int threads)
{
    struct uv_rows rows;
    uv_rows_make(loops, &rows);
    struct search s = {.patch = patch, .loops = loops, .rows = &rows, .flipped = flipped};
    struct spans spans = {.search = &s};
    for (size_t i = 0; i < BEST; i++)
        s.best[i].curvature = -HUGE_VAL;
    span_ends(&patch->surface.u, &spans.u);
    span_ends(&patch->surface.v, &spans.v);
    spans.nu = samples_per_span(spans.u.n);
    spans.nv = samples_per_span(spans.v.n);
    size_t n = (spans.u.n - 1) * (spans.v.n - 1);
    spans.most = mem_alloc(EACH * n, sizeof *spans.most);
    parallel_for(threads, n, sample_spans, &spans);
    for (size_t k = 0; k < EACH * n; k++) {
        struct nurbs part = span_of(&spans, k / EACH);
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
    /* a search in eight directions stalls at a slanted border, and where a ridge leads to one */
    struct uvs rim = loops->n == 0 ? range_border(&patch->surface) : (struct uvs){0};
    for (size_t i = 0; i < loops->n || i == 0; i++) {
        struct concave_radius h = climb_border(&s, loops->n ? &loops->item[i] : &rim);
        if (h.curvature > best.curvature)
            best = h;
    }
    array_free(&rim);
    uv_rows_free(&rows);
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
