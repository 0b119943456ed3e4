/* scansmooth - see scansmooth.h. */
#include "scansmooth.h"

#include <stdlib.h>

#include "cubic.h"
#include "longhood.h"
#include "parallel.h"

enum { FEW = 64, LEAST = 32, MOST = 362, WIDEST = 1024, STEPS = 8, SAMPLE = 200, REFITS = 2 };

/* Points to look at in all, and in any case for a vertex. */
static const double WORK = 4e6, AFFORDED = 56;

static const double TUKEY = 4.685; /* in standard deviations: 95 % efficient on normal noise */

struct job {
    struct mesh *mesh;
    const struct buckets *buckets;
    double sigma;
    size_t neighbours, most; /* to begin with, at a border */
    bool along;              /* are there few enough vertices to look along ribs? */
    double *variance;        /* of each vertex, in sigma^2; negative: not moved */
    double *distance;        /* that it was moved; negative: there was no quadric at all */
    size_t *chosen;          /* by a sample: the widest neighbourhood that agrees */
};

/* The neighbourhood of the vertex in hand, nearest first. */
struct hood {
    size_t n;
    uint32_t index[WIDEST];
    double distance2[WIDEST], weight[WIDEST];
    struct vec3 point[WIDEST];
};

/* Neighbourhoods longer one way: how much, of how many points, which ways are tried about one. */
struct longer {
    double aspect;
    size_t points;
    int tries;   /* to either side ... */
    double step; /* ... by so much, radians */
};

/* One quadric and what is judged of it. */
struct fit {
    struct quadric q;
    double offset; /* of the vertex from the surface, signed along the first guess */
    double spread; /* of the points that count, for their freedom */
    size_t n;      /* points */
};

static void gather(const struct buckets *b, struct vec3 vertex, size_t k, struct hood *hood)
{
    hood->n = buckets_nearest(b, vertex, k, hood->index, hood->distance2);
    for (size_t i = 0; i < hood->n; i++)
        hood->point[i] = b->point[hood->index[i]];
}

/* Weights of the first k points; returns their spread about the quadric.  Where it passes a good part
 * of them by it is not theirs: infinite. *farthest: the largest of their distances. */
static double weigh(const struct quadric *q, struct hood *hood, size_t k, double sigma,
                    double *farthest)
{
    const double terms = 6, most = 0.6;
    double sum = 0, sum2 = 0;
    *farthest = 0;
    for (size_t i = 0; i < k; i++) {
        double off = quadric_off(q, hood->point[i]), r = off / (TUKEY * sigma);
        *farthest = fmax(*farthest, fabs(off));
        double root = fmax(1 - r * r, 0);
        hood->weight[i] = root * root;
        sum += hood->weight[i];
        sum2 += hood->weight[i] * off * off;
    }
    return sum > fmax(terms, most * (double)k) ? sqrt(sum2 / (sum - terms)) : INFINITY;
}

/* Is the foot certain to `part` of sigma, and the normal to `tilt` radians? */
static bool is_certain(const struct quadric *q, double sigma, double part, double tilt)
{
    return q->variance < part * part && sigma * sqrt(q->tilt) < tilt;
}

/* So uncertain that a neighbourhood that is bent tells more. */
static bool is_useless(const struct quadric *q, double sigma)
{
    return !is_certain(q, sigma, 0.8, 0.06);
}

/* In the frame of a normal that is nearly right: a cubic or, where the points carry none, a quadric.
 * -1: neither. */
static int fit_weighted(const struct hood *hood, const double *weight, size_t k, struct vec3 vertex,
                        struct vec3 normal, double sigma, struct quadric *q)
{
    if (cubic_fit(hood->point, weight, k, vertex, normal, q) == 0 && !is_useless(q, sigma))
        return 0;
    return quadric_fit_weighted(hood->point, weight, k, vertex, normal, q);
}

/* Through the first k points in the frame of `normal`; what is far off counts less and less.  -1:
 * there is none. */
static int fit_in(struct hood *hood, size_t k, struct vec3 vertex, struct vec3 normal,
                  struct vec3 guess, double sigma, struct fit *fit)
{
    const double far = 3.5; /* in sigma */
    struct quadric *q = &fit->q;
    double farthest;
    if (fit_weighted(hood, NULL, k, vertex, normal, sigma, q) < 0)
        return -1;
    fit->n = k;
    fit->spread = weigh(q, hood, k, INFINITY, &farthest);
    for (int i = 0; i < REFITS && farthest > far * sigma; i++) {
        struct quadric next;
        fit->spread = weigh(q, hood, k, fmax(sigma, fit->spread), &farthest);
        if (fit_weighted(hood, hood->weight, k, vertex, quadric_normal(q), sigma, &next) < 0)
            break;
        *q = next;
        fit->spread = weigh(q, hood, k, fmax(sigma, fit->spread), &farthest);
    }
    fit->offset = vec_dot(vec_sub(quadric_foot(q), vertex), guess);
    return 0;
}

/* The surface through the first k points, in the frame of a quadric through some of them; where that
 * leads nowhere, as on laser lines it may, through all of them, or straight up.  -1: they carry
 * none. */
static int fit_to(struct hood *hood, size_t k, struct vec3 vertex, struct vec3 guess, double sigma,
                  struct fit *fit)
{
    const size_t some[] = {k < 48 ? k : 48, k, 0};
    int fitted = -1;
    for (int i = 0; i < 3 && fitted < 0; i++) {
        struct vec3 normal = vec(0, 0, 1);
        if (some[i] > 0) {
            if (quadric_fit_steep(hood->point, some[i], vertex, guess, &fit->q) < 0)
                continue;
            normal = quadric_normal(&fit->q);
        }
        fitted = fit_in(hood, k, vertex, normal, guess, sigma, fit);
    }
    return fitted;
}

/* Does noise explain by how much the feet, and the normals, of a wide neighbourhood and of its
 * nearer part differ? */
static bool agree(const struct fit *wide, const struct fit *part, double sigma)
{
    const double sigmas = 2.5, tilts = 3;
    double bent = 1 + 3 / sqrt(2 * (double)wide->n);
    /* of the difference of nested fits; of a cubic and a quadric, about that of the cubic */
    double variance = fmax(part->q.variance - wide->q.variance, wide->q.variance);
    double tilt = fmax(part->q.tilt - wide->q.tilt, wide->q.tilt);
    double turn = vec_distance(quadric_normal(&wide->q), quadric_normal(&part->q));
    return fabs(wide->offset - part->offset) <= sigmas * sigma * sqrt(variance) &&
           turn <= tilts * sigma * sqrt(tilt) &&
           wide->spread <= bent * fmax(part->spread, sigma);
}

/* Where to gather from: the foot of the vertex on a first fit, for the points nearest to one that is
 * off the surface are off to the same side. */
static struct vec3 first_foot(const struct job *job, struct vec3 vertex, struct vec3 guess,
                              struct hood *hood)
{
    const size_t some = 2 * (size_t)LEAST;
    const double far = 4;
    struct fit fit;
    gather(job->buckets, vertex, some, hood);
    if (fit_to(hood, hood->n, vertex, guess, job->sigma, &fit) < 0 ||
        is_useless(&fit.q, job->sigma) || fabs(fit.offset) > far * job->sigma)
        return vertex;
    return quadric_foot(&fit.q);
}

/* From few to many: the last neighbourhood that agrees with all within it. */
static size_t widest_that_agrees(const struct job *job, struct vec3 vertex, struct vec3 guess,
                                 struct hood *hood)
{
    struct fit fit[STEPS];
    size_t widest = LEAST, n = 0;
    vertex = first_foot(job, vertex, guess, hood);
    gather(job->buckets, vertex, MOST, hood);
    double k = LEAST;
    for (int step = 0; step < STEPS; step++, k *= sqrt(2)) {
        size_t count = (size_t)(k + 0.5);
        if (count > hood->n || fit_to(hood, count, vertex, guess, job->sigma, &fit[n]) < 0 ||
            is_useless(&fit[n].q, job->sigma))
            continue;
        for (size_t i = 0; i < n; i++)
            if (!agree(&fit[n], &fit[i], job->sigma))
                return widest;
        widest = count;
        n++;
    }
    return widest;
}

static void choose(void *context, size_t from, size_t to)
{
    const struct job *job = context;
    const struct mesh *mesh = job->mesh;
    size_t sample = mesh->vertex.n < SAMPLE ? mesh->vertex.n : SAMPLE;
    struct hood *hood = mem_alloc(1, sizeof *hood);
    for (size_t i = from; i < to; i++) {
        size_t v = i * mesh->vertex.n / sample;
        job->chosen[i] =
            widest_that_agrees(job, mesh->vertex.item[v], mesh->normal.item[v], hood);
    }
    free(hood);
}

static int by_size(const void *a, const void *b)
{
    size_t x = *(const size_t *)a, y = *(const size_t *)b;
    return (x > y) - (x < y);
}

/* What half of a sample of the vertices can take; less where there are very many of them. */
static size_t typical_neighbourhood(struct job *job, int threads)
{
    size_t sample = job->mesh->vertex.n < SAMPLE ? job->mesh->vertex.n : SAMPLE;
    job->chosen = mem_alloc(sample, sizeof *job->chosen);
    parallel_for(threads, sample, choose, job);
    qsort(job->chosen, sample, sizeof *job->chosen, by_size);
    size_t typical = job->chosen[sample / 2];
    double affordable = fmax(WORK / (double)job->mesh->vertex.n, AFFORDED);
    if ((double)typical > affordable)
        typical = (size_t)affordable;
    free(job->chosen);
    return typical;
}

/* The neighbourhood to begin with, wider where it carries no surface or, at a border, an uncertain
 * one.  Returns its size, 0: there is none. */
static size_t begin_at(const struct job *job, struct vec3 vertex, struct vec3 guess,
                       struct hood *hood, struct fit *fit)
{
    const double part = 0.35, tilt = 0.04;
    size_t began = 0;
    for (size_t k = job->neighbours; k <= WIDEST; k *= 2) {
        struct fit wide;
        gather(job->buckets, vertex, k, hood);
        if (fit_to(hood, hood->n, vertex, guess, job->sigma, &wide) == 0) {
            bool useless = began == 0 || is_useless(&fit->q, job->sigma);
            if (!useless && (k > job->most || !agree(&wide, fit, job->sigma)))
                return began;
            *fit = wide;
            began = hood->n;
            if (is_certain(&fit->q, job->sigma, part, tilt))
                return began;
        }
        if (hood->n < k)
            break;
    }
    return began;
}

/* The surface for a vertex: false when no neighbourhood has one. */
static bool fit_at(const struct job *job, struct vec3 vertex, struct vec3 guess, struct hood *hood,
                   struct fit *fit)
{
    const double narrow = 0.05; /* sigma, in widths of the neighbourhood */
    size_t k = begin_at(job, vertex, guess, hood, fit);
    if (k > 0 && job->sigma > narrow * sqrt(hood->distance2[k - 1])) {
        vertex = first_foot(job, vertex, guess, hood);
        k = begin_at(job, vertex, guess, hood, fit);
    }
    for (struct fit part; k / 2 >= LEAST && k > job->neighbours / 16; k /= 2) {
        if (fit_in(hood, k / 2, vertex, quadric_normal(&fit->q), guess, job->sigma, &part) < 0 ||
            is_useless(&part.q, job->sigma) || agree(fit, &part, job->sigma))
            break;
        *fit = part;
    }
    return k > 0;
}

/* Where the frame of the few nearest points led nowhere, as on laser lines it may: that of all of
 * them, and straight up. */
static void try_other_frames(const struct job *job, struct vec3 vertex, struct vec3 guess,
                             struct hood *hood, struct fit *fit)
{
    struct fit other;
    struct vec3 normal[2] = {guess, vec(0, 0, 1)};
    gather(job->buckets, vertex, job->neighbours, hood);
    if (quadric_fit_steep(hood->point, hood->n, vertex, guess, &other.q) == 0)
        normal[0] = quadric_normal(&other.q);
    for (int i = 0; i < 2; i++)
        if (fit_in(hood, hood->n, vertex, normal[i], guess, job->sigma, &other) == 0 &&
            other.spread < fit->spread)
            *fit = other;
}

/* The surface through a neighbourhood that is longer along one of the directions half a turn has,
 * `step` apart about a middle one: the one it fits best.  False: none fits better than *fit. */
static bool best_along(const struct job *job, const struct hood *wide, struct vec3 vertex,
                       struct vec3 guess, const struct longer *longer, double *angle,
                       struct fit *fit)
{
    struct hood *hood = mem_alloc(1, sizeof *hood);
    struct vec3 normal = quadric_normal(&fit->q), u = vec_perpendicular(normal);
    struct vec3 v = vec_cross(normal, u);
    double middle = *angle;
    bool better = false;

    for (int i = -longer->tries; i <= longer->tries; i++) {
        double a = middle + i * longer->step;
        struct vec3 way = vec_along(vec_scale(cos(a), u), sin(a), v);
        struct fit along;
        hood->n = longhood_take(wide->point, wide->n, vertex, way, longer->aspect, longer->points,
                                hood->point);
        if (fit_in(hood, hood->n, vertex, normal, guess, job->sigma, &along) < 0 ||
            along.spread >= fit->spread || is_useless(&along.q, job->sigma))
            continue;
        *fit = along;
        *angle = a;
        better = true;
    }
    free(hood);
    return better;
}

/* On a rib or a groove narrower than the neighbourhood: one that is long the way it runs.  Its
 * direction is the one in which such neighbourhoods are fitted best. */
static void try_along(const struct job *job, struct vec3 vertex, struct vec3 guess,
                      struct hood *hood, struct fit *fit)
{
    static const struct longer rough = {3, 36, 4, PI / 9}, fine = {6, 72, 2, PI / 30};
    const double better = 0.85, sharp = 1.6;
    struct fit along = *fit, best;
    double angle = 0;

    gather(job->buckets, vertex, (size_t)(rough.aspect * (double)rough.points), hood);
    if (!best_along(job, hood, vertex, guess, &rough, &angle, &along) ||
        along.spread > better * fit->spread || along.spread > sharp * job->sigma)
        return;
    gather(job->buckets, vertex, (size_t)(fine.aspect * (double)fine.points), hood);
    best = along;
    best.spread *= 1.1; /* of fewer points and more of them */
    if (best_along(job, hood, vertex, guess, &fine, &angle, &best))
        along = best;
    if (along.spread < sharp * job->sigma) /* else it is a crease */
        *fit = along;
}

static void smooth_vertices(void *context, size_t from, size_t to)
{
    const double bent = 2, rough = 1.2, far = 8; /* in sigma */
    const double down = -0.1; /* a scan seen from above: slivers may say otherwise */
    const struct job *job = context;
    struct mesh *mesh = job->mesh;
    struct hood *hood = mem_alloc(1, sizeof *hood);
    for (size_t i = from; i < to; i++) {
        struct fit fit;
        struct vec3 *vertex = &mesh->vertex.item[i], guess = mesh->normal.item[i];
        job->variance[i] = job->distance[i] = -1;
        mesh->kmax.item[i] = 0;
        if (!fit_at(job, *vertex, guess, hood, &fit))
            continue;
        if (fit.spread > bent * job->sigma)
            try_other_frames(job, *vertex, guess, hood, &fit);
        if (job->along && fit.spread > rough * job->sigma && fit.spread < far * job->sigma && fit.n <= FEW)
            try_along(job, *vertex, guess, hood, &fit);
        struct vec3 normal = quadric_normal(&fit.q);
        mesh->normal.item[i] = normal.z < down ? vec_scale(-1, normal) : normal;
        mesh->kmax.item[i] = quadric_curvature(&fit.q);
        job->distance[i] = 0;
        struct vec3 foot = quadric_foot(&fit.q);
        if (fit.spread > bent * job->sigma || vec_distance(foot, *vertex) > far * job->sigma)
            continue;
        job->variance[i] = fit.q.variance;
        job->distance[i] = vec_distance(foot, *vertex);
        *vertex = foot;
    }
    free(hood);
}

static struct scansmooth sum_up(const struct job *job)
{
    struct scansmooth s = {.typical = job->neighbours};
    double sum = 0;
    for (size_t i = 0; i < job->mesh->vertex.n; i++) {
        s.thin += job->distance[i] < 0;
        s.kept += job->distance[i] >= 0 && job->variance[i] < 0;
        if (job->variance[i] < 0)
            continue;
        s.moved++;
        sum += job->variance[i];
        if (job->distance[i] > s.farthest) {
            s.farthest = job->distance[i];
            s.at = i;
        }
    }
    s.error = s.moved > 0 ? job->sigma * sqrt(sum / (double)s.moved) : 0;
    return s;
}

struct scansmooth scansmooth(struct mesh *mesh, const struct buckets *buckets, double sigma,
                             size_t neighbours, int threads)
{
    size_t n = mesh->vertex.n;
    struct job job = {.mesh = mesh, .buckets = buckets, .sigma = sigma, .neighbours = neighbours};
    mesh_normals_facet(mesh);
    array_reserve(&mesh->kmax, n);
    mesh->kmax.n = n;
    if (neighbours == 0)
        job.neighbours = typical_neighbourhood(&job, threads);
    job.most = 4 * job.neighbours < WIDEST ? 4 * job.neighbours : WIDEST;
    job.along = (double)n * AFFORDED < WORK;
    job.variance = mem_alloc(n, sizeof *job.variance);
    job.distance = mem_alloc(n, sizeof *job.distance);
    parallel_for(threads, n, smooth_vertices, &job);
    struct scansmooth result = sum_up(&job);
    free(job.variance);
    free(job.distance);
    return result;
}
