/* edge_wide - see edge_steps.h. */
#include "base/parallel.h"
#include "edge_steps.h"
#include "math/cubic.h"
#include "math/side_fit.h"

/* Points about that a flank is looked for on, most first; turns in which it is chosen by
 * neighbours'. */
enum { MOST = 200, SIZES = 5, CHOSEN = 2 };
static const size_t ABOUT[SIZES] = {MOST, 144, 104, 72, 48};

/* What it may be; the terms of each; and squares of what its points are off by that one of more
 * terms must explain: by chance it does in one of a thousand. */
enum edge_form { PLANE, QUADRIC, CUBIC };
static const size_t TERMS[] = {3, 6, 10};
static const double CHANCE[] = {14, 16};

/* Cosines of 14 and 37 degrees: a point's own surface runs as the flank does there, and the flank
 * as about its middle. */
static const double ALIKE = 0.97, TURNED = 0.8;

/* Noises that points are off it at most, and on average, for the noise is known within a tenth;
 * by its spacing and the square of how far they are, what one that bends may be off before its
 * bends are known; so many times as much as fewer points it leaves where it is no one surface. */
static const double OFF = 3, UNEVEN = 1.15, BENT = 0.12, GROWS = 1.3;

/* Of the way to a point below: so steep is a wall. */
static const double BELOW = 2;

/* Points by terms: a neighbour's flank with so many times as many is the better one. */
static const double MORE = 1.25;

struct wide_work {
    const struct edge_work *work;
    const struct vec3 *point;
    struct vec3 *normal; /* of each point's own surface; 0: none is known */
};

/* A point and the nearest to it, with the normals of their own surfaces. */
struct wide_about {
    size_t n;
    struct vec3 point[MOST], normal[MOST];
};

/* Those of the first n points that are on the flank, `within` on average, and whose own surfaces
 * run as it does. */
static size_t gather_alike(const struct wide_about *about, const struct edge_flank *flank,
                           double within, double bend, size_t n, struct vec3 *on)
{
    struct vec3 from = about->point[0], own = quadric_normal_at(&flank->q, from), normal[MOST];
    double off[MOST];
    size_t near[MOST], some = 0, found = 0;

    quadric_off_all(&flank->q, about->point, n, off);
    for (size_t k = 0; k < n; k++) {
        struct vec3 p = about->point[k], to = vec_sub(p, from);
        double least = OFF * within + bend * vec_dot(to, to) / flank->spacing;
        on[some] = p;
        near[some] = k;
        some += fabs(off[k]) <= least;
    }
    quadric_normal_all(&flank->q, on, some, normal);
    for (size_t k = 0; k < some; k++) {
        double alike = fabs(vec_dot(normal[k], about->normal[near[k]]));
        on[found] = on[k];
        found += vec_dot(normal[k], own) > TURNED && alike > ALIKE;
    }
    return found;
}

/* A surface through some points; false: there is none. */
static bool fit_points(const struct vec3 *on, size_t n, struct vec3 w, enum edge_form form,
                       struct side_fit *fit)
{
    if (n < 3 * TERMS[form] || n < 3 * EDGE_FEWEST)
        return false;
    if (form == PLANE)
        return side_fit_plane(on, n, on[0], w, fit) == 0;
    if ((form == QUADRIC ? quadric_fit(on, n, on[0], w, &fit->q)
                         : cubic_fit(on, NULL, n, on[0], w, &fit->q)) < 0)
        return false;
    fit->rms = quadric_spread(&fit->q, on, n, (double)TERMS[form]);
    return true;
}

/* More than chance lets a surface of more terms explain is left by the one of n points, so many
 * squares of what that leaves, which across a steep flank is less than the noise. */
static bool is_coarse(const struct vec3 *on, size_t n, enum edge_form form,
                      const struct side_fit *fit, double noise)
{
    struct side_fit finer;

    if (form == CUBIC || !fit_points(on, n, fit->q.w, form + 1, &finer))
        return false;
    double left = (double)(n - TERMS[form]) * fit->rms * fit->rms;
    double less = left - (double)(n - TERMS[form + 1]) * finer.rms * finer.rms;
    return less > CHANCE[form] * pow(fmin(noise, finer.rms), 2);
}

/* The flank through those of n points that are on it, first by the one there is, with room for
 * bends, then by itself; *some: how many; false: they are on none. */
static bool settle(const struct wide_about *about, double noise, size_t n, enum edge_form form,
                   struct vec3 *on, size_t *some, struct edge_flank *flank)
{
    enum { TURNS = 3 };
    struct vec3 p = about->point[0];
    struct side_fit fit;
    double within = noise;

    for (int turn = 0; turn < TURNS; turn++) {
        double bend = form > PLANE && turn == 0 ? BENT : 0;
        *some = gather_alike(about, flank, within, bend, n, on);
        if (!fit_points(on, *some, quadric_normal_at(&flank->q, p), form, &fit) ||
            (turn > 0 && fit.rms > GROWS * flank->rms))
            return false;
        flank->q = fit.q;
        flank->rms = fit.rms;
        within = fmin(noise, fmax(fit.rms, noise / 4));
    }
    if (is_coarse(on, *some, form, &fit, noise))
        return false;
    quadric_face_up(&flank->q);
    return true;
}

/* The same, where it is even and goes through the point. */
static bool widen(const struct edge_work *work, const struct wide_about *about, size_t n,
                  enum edge_form form, struct edge_flank *flank)
{
    struct vec3 on[MOST], p = about->point[0], normal;
    size_t some;

    if (!settle(about, work->options->noise, n, form, on, &some, flank))
        return false;
    flank->wide = (double)some / (double)TERMS[form];
    double even = UNEVEN * (1 + 1 / sqrt(2 * (double)some)) * work->options->noise;
    return flank->rms <= even && quadric_normal_at(&flank->q, p).z > EDGE_UPRIGHT &&
           fabs(edge_flank_above(flank, p, &normal)) <= edge_within(work, flank->spacing);
}

/* From the fewest on, as long as these leave no more than fewer have left: noise along z is less
 * across a steep flank, and a bend would be taken for it. */
static bool widen_most(const struct edge_work *work, const struct wide_about *about,
                       enum edge_form form, struct edge_flank *flank)
{
    const struct edge_flank own = *flank;
    double most = HUGE_VAL;
    bool any = false;

    for (int k = SIZES - 1; k >= 0 && ABOUT[k] <= about->n; k--) {
        struct edge_flank more = own;
        if (!widen(work, about, ABOUT[k], form, &more))
            continue;
        if (more.rms > most)
            break;
        most = fmin(most, more.rms * (1 + 1 / sqrt(2 * (double)TERMS[form] * (more.wide - 1))));
        *flank = more;
        any = true;
    }
    return any;
}

/* Some of the nearest are on no surface of all about them. */
static bool has_rough(const struct edge_work *work, const uint32_t *index, size_t n)
{
    for (size_t k = 0; k < n && k < EDGE_NEAR; k++)
        if (work->flank[index[k]].rough)
            return true;
    return false;
}

/* A point so far below it that a wall is between, which those nearest to it need not know of: it is
 * the edge of a top, say, that what is nearest belongs to. */
static bool has_below(const struct edge_work *work, size_t i)
{
    struct edge_about about = edge_about(work, i);

    for (size_t k; edge_about_next(&about, &k);) {
        struct vec3 p = about.walk.grid->point[k];
        if (about.from.z - p.z > BELOW * edge_plan_distance(about.from, p))
            return true;
    }
    return false;
}

static void find_normals(void *context, size_t from, size_t to)
{
    const struct wide_work *wide = context;

    for (size_t i = from; i < to; i++) {
        const struct edge_flank *flank = &wide->work->flank[i];
        wide->normal[i] =
            edge_flank_known(flank) ? quadric_normal_at(&flank->q, wide->point[i]) : vec(0, 0, 0);
    }
}

static void gather_about(const struct wide_work *wide, const uint32_t *index, size_t n,
                         struct wide_about *about)
{
    about->n = n;
    for (size_t k = 0; k < n; k++) {
        about->point[k] = wide->point[index[k]];
        about->normal[k] = wide->normal[index[k]];
    }
}

static void widen_some(void *context, size_t from, size_t to)
{
    const struct wide_work *wide = context;
    const struct edge_work *work = wide->work;
    uint32_t index[MOST];
    double distance2[MOST];
    struct wide_about about;

    for (size_t i = from; i < to; i++) {
        const struct edge_flank *own = &work->flank[i];
        struct edge_flank *chosen = &work->chosen[i], more;
        *chosen = *own;
        if (!edge_flank_certain(work, own))
            continue; /* on models a wide one made many walls of what is rough */
        size_t n =
            point_grid_nearest(work->options->point_grid, wide->point[i], MOST, index, distance2);
        if (!own->valid && !has_rough(work, index, n) && !has_below(work, i))
            continue;
        gather_about(wide, index, n, &about);
        for (int form = PLANE; form <= CUBIC; form++) {
            more = *own;
            if (chosen->wide * (double)TERMS[form] < MOST && /* else it has none more */
                widen_most(work, &about, form, &more) && more.wide > chosen->wide)
                *chosen = more;
        }
    }
}

/* A neighbour's that goes through the point, too, and through more points. */
static void choose_some(void *context, size_t from, size_t to)
{
    const struct edge_work *work = context;
    struct edge_hood near;

    for (size_t i = from; i < to; i++) {
        struct edge_flank *flank = &work->chosen[i];
        *flank = work->flank[i];
        if (!(flank->wide > 0))
            continue;
        edge_hood_find(work, i, &near);
        for (size_t k = 1; k < near.n && k < EDGE_MEETING; k++) {
            const struct edge_flank *other = &work->flank[near.index[k]];
            struct vec3 normal;
            if (other->wide <= MORE * flank->wide ||
                fabs(edge_flank_above(other, near.point[0], &normal)) > OFF * work->options->noise)
                continue;
            flank->q = other->q;
            flank->rms = other->rms;
            flank->wide = other->wide;
        }
    }
}

void edge_flanks_widen(struct edge_work *work)
{
    size_t n = work->options->point_grid->n;

    if (!(work->options->noise > 0))
        return;
    struct wide_work wide = {work, work->options->point_grid->point,
                             mem_alloc(n + 1, sizeof *wide.normal)};
    parallel_for(work->options->threads, n, find_normals, &wide);
    parallel_for(work->options->threads, n, widen_some, &wide);
    free(wide.normal);
    edge_flanks_take_chosen(work);
    for (int turn = 0; turn < CHOSEN; turn++) {
        parallel_for(work->options->threads, n, choose_some, work);
        edge_flanks_take_chosen(work);
    }
}
