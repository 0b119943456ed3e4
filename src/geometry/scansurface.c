/* scansurface - see scansurface.h. */
#include "scansurface.h"

#include <stdbool.h>
#include <stdlib.h>

#include "kdtree.h"
#include "parallel.h"
#include "quadric.h"

enum { FEWEST = 16, MOST = 96, SAMPLE = 1500, MANY = 400000, RINGS = 8 };

static const double WHITE = 1.35; /* spread of twice the neighbours by that of once, at most */
static const double EVEN = 3;     /* spread of the roughest tenth by that of the smoothest */
static const double UNSURE = 0.5; /* of the noise: what may be left of it in the middle of a quadric */
static const double MUCH = 1.5;   /* spread of a neighbourhood by the noise: more is none */
/* Noises that a point may be off its quadric: of ten thousand one is off five, and the noise itself
 * is known within a tenth. */
static const double FAR = 6;

/* A quadric through the neighbours of a point. */
struct patch {
    struct quadric q;
    size_t k;      /* neighbours, the point itself among them; 0: there is none */
    double spread; /* standard deviation about it, mm */
};

/* What becomes of a point. */
struct place {
    struct vec3 point;
    bool moved;
    struct vec3s between;
};

struct job {
    const struct scansurface_rule *rule;
    const struct vec3 *point;
    size_t n;
    const struct kdtree *tree;
    double noise; /* to take out */
    double gap;   /* between which the ball sinks as far as it may */
    bool fill;
    struct place *place;
};

/* A neighbourhood, nearest first. */
struct near {
    size_t n, index[MOST];
    double distance2[MOST];
    struct vec3 point[MOST];
};

static void find_near(const struct job *job, struct vec3 p, size_t k, struct near *near)
{
    near->n = kdtree_nearest(job->tree, p, k, near->index, near->distance2);
    for (size_t i = 0; i < near->n; i++)
        near->point[i] = job->point[near->index[i]];
}

static struct patch fit(const struct near *near, size_t k)
{
    struct patch patch = {.k = 0};

    if (k > near->n || quadric_settle(near->point, k, near->point[0],
                                      plane_normal(near->point, k), &patch.q) < 0)
        return patch;
    double count = (double)k;
    patch.k = k;
    patch.spread = quadric_rms(&patch.q, near->point, k) * sqrt(count / (count - 6));
    return patch;
}

/* Through the fewest neighbours that carry one: on laser lines it takes more. */
static struct patch fit_fewest(const struct near *near)
{
    struct patch patch = {.k = 0};

    for (size_t k = FEWEST; patch.k == 0 && k <= near->n && k <= 2 * FEWEST; k += FEWEST / 2)
        patch = fit(near, k);
    return patch;
}

/* What a sample of the places shows. */
struct look {
    size_t n;
    double spread[SAMPLE], wider[SAMPLE], apart[SAMPLE];
};

static struct look look_at(const struct job *job)
{
    struct look look = {.n = 0};
    size_t sample = job->n < SAMPLE ? job->n : SAMPLE;

    for (size_t i = 0; i < sample; i++) {
        struct near near;
        find_near(job, job->point[i * job->n / sample], 4 * FEWEST, &near);
        struct patch patch = fit_fewest(&near), wider = fit(&near, 2 * patch.k);
        if (patch.k == 0 || wider.k == 0)
            continue;
        look.spread[look.n] = patch.spread;
        look.wider[look.n] = wider.spread / fmax(patch.spread, 1e-9);
        look.apart[look.n++] = sqrt(near.distance2[6]);
    }
    doubles_sort(look.spread, look.n);
    doubles_sort(look.wider, look.n);
    doubles_sort(look.apart, look.n);
    return look;
}

static double noise_of(const struct look *look)
{
    size_t n = look->n;

    if (n == 0 || look->wider[n / 2] > WHITE ||
        look->spread[9 * n / 10] > EVEN * look->spread[n / 10])
        return 0;
    return look->spread[n / 2];
}

/* Spread that noise alone explains: its standard deviation, three of that of the estimate more. */
static double explained(double noise, size_t k)
{
    return noise * (1 + 3 / sqrt(2 * ((double)k - 6)));
}

/* As many neighbours as the noise spreads alike, or else those that are spread least.  What is
 * carried by a narrow strip of points says little of its middle. */
static struct patch fit_noise(const struct near *near, double noise)
{
    struct patch best = {.k = 0};

    for (size_t k = MOST; k >= FEWEST; k -= k > 64 ? 32 : k > 32 ? 16 : 8) {
        struct patch patch = fit(near, k);
        if (patch.k == 0 || patch.q.variance > UNSURE * UNSURE)
            continue;
        if (best.k == 0 || patch.spread < best.spread)
            best = patch;
        if (patch.spread <= explained(noise, k))
            return patch;
    }
    return best;
}

static struct vec3 on_patch(const struct quadric *q, double u, double v)
{
    const double *c = q->c;
    double w = c[0] + u * (c[1] + c[3] * u + c[4] * v) + v * (c[2] + c[5] * v);

    return vec_along(vec_along(vec_along(q->origin, u, q->u), v, q->v), w, q->w);
}

/* p is nearer to the first of the points than to the others, and one of these lies beyond it,
 * within 60 degrees. */
static bool between(const struct near *near, struct vec3 p)
{
    size_t k = near->n < 2 * FEWEST ? near->n : 2 * FEWEST;
    struct vec3 off = vec_sub(p, near->point[0]);
    double off2 = vec_dot(off, off);
    bool beyond = false;

    for (size_t i = 1; i < k; i++) {
        struct vec3 to = vec_sub(near->point[i], near->point[0]);
        double along = vec_dot(off, to);
        if (2 * along > near->distance2[i]) /* p lies on the far side of the middle */
            return false;
        beyond = beyond || (along > 0 && near->distance2[i] > off2 &&
                            4 * along * along > off2 * near->distance2[i]);
    }
    return beyond;
}

static void fill(const struct job *job, const struct near *near, const struct quadric *q,
                 struct place *place)
{
    double pitch = 0.75 * job->gap, reach = sqrt(near->distance2[FEWEST - 1]);
    int rings = (int)fmin(reach / pitch, RINGS);

    for (int j = -rings; j <= rings; j++) {
        for (int i = -rings; i <= rings; i++) {
            double u = pitch * (i + j / 2.0), v = pitch * j * 0.8660254037844386;
            if ((i == 0 && j == 0) || hypot(u, v) > reach)
                continue;
            struct vec3 p = on_patch(q, u, v);
            if (between(near, p))
                *array_push(&place->between) = p;
        }
    }
}

/* The ball would sink deeper between the points than they are off the quadric. */
static bool worth_filling(const struct job *job, const struct near *near,
                          const struct patch *patch)
{
    size_t sixth = near->n > 6 ? 6 : near->n - 1;
    double sink = near->distance2[sixth] / (6 * job->rule->radius);

    return patch->k > 0 && sink > job->rule->sink / 4 &&
           patch->spread <= fmax(fmax(job->rule->sink, sink / 2), MUCH * job->noise);
}

static void settle(void *context, size_t from, size_t to)
{
    const struct job *job = context;

    for (size_t i = from; i < to; i++) {
        struct place *place = &job->place[i];
        struct near near;
        struct patch patch;
        *place = (struct place){.point = job->point[i]};
        find_near(job, job->point[i], job->noise > 0 ? MOST : 2 * FEWEST, &near);
        near.point[0] = job->point[i]; /* of several in one place, this one */
        patch = job->noise > 0 ? fit_noise(&near, job->noise) : fit_fewest(&near);
        if (patch.k > 0 && job->noise > 0 && patch.spread <= MUCH * job->noise &&
            quadric_distance(&patch.q) <= FAR * job->noise) {
            place->point = on_patch(&patch.q, 0, 0);
            place->moved = true;
        }
        if (job->fill && worth_filling(job, &near, &patch))
            fill(job, &near, &patch.q, place);
    }
}

/* What there is to be done. */
static void plan(struct job *job)
{
    const struct scansurface_rule *rule = job->rule;

    job->gap = sqrt(6 * rule->radius * rule->sink);
    job->noise = fmax(rule->noise, 0);
    if (job->n > MANY || job->n == 0)
        return;
    struct look look = look_at(job);
    job->fill = look.n > 0 && look.apart[9 * look.n / 10] > job->gap;
    if (rule->noise < 0) {
        double found = noise_of(&look);
        job->noise = found > rule->least ? found : 0;
    }
}

void scansurface_make(const struct vec3 *point, size_t n, const struct scansurface_rule *rule,
                      struct scansurface *surface)
{
    /* of very many points only a noise that was given is taken out */
    bool needed = n > 0 && (n <= MANY || rule->noise > 0);
    struct kdtree *tree = needed ? kdtree_new_by(point, n, rule->threads) : NULL;
    struct job job = {.rule = rule, .point = point, .n = n, .tree = tree};

    *surface = (struct scansurface){.noise = 0};
    array_reserve(&surface->point, n);
    plan(&job);
    surface->noise = job.noise;
    if (job.noise > 0 || job.fill) {
        job.place = mem_alloc(n, sizeof *job.place);
        parallel_for(rule->threads, n, settle, &job);
    }
    kdtree_free(tree);
    for (size_t i = 0; i < n; i++) {
        struct place as_it_is = {.point = point[i]}, *place = job.place ? &job.place[i] : &as_it_is;
        *array_push(&surface->point) = place->point;
        surface->moved += place->moved;
        surface->added += place->between.n;
        for (size_t k = 0; k < place->between.n; k++)
            *array_push(&surface->point) = place->between.item[k];
        array_free(&place->between);
    }
    free(job.place);
}
