/* spline_guard - see spline_guard.h. */
#include "splinefit/spline_guard.h"

#include <stdlib.h>

enum { ROUNDS = 6 }; /* of straight lines put in */

struct work {
    const struct spline_guard *guard;
    struct spline_run *pieces;
};

static void look(const struct spline_guard *guard, const struct run *run,
                 const struct spline_run_piece *piece, struct gouges *deeps)
{
    const struct run_point *from = &run->item[piece->from];
    struct pose pose = {guard->rule.centre ? from->ball : from->tip, from->axis};
    struct motion motion = motion_spline(pose, pose, &piece->fit.curve);

    if (!piece->still)
        gouge_refit_motion(&guard->rule, &motion, deeps);
}

static void fit(void *context, const struct run *run, struct gouges *deeps)
{
    struct work *work = context;
    const struct spline_guard *g = work->guard;

    if (work->pieces->n == 0)
        spline_run_fit(run, g->rule.centre, g->paper, &g->fit, work->pieces);
    else
        spline_run_refit(run, g->rule.centre, g->paper, &g->fit, work->pieces);
    for (size_t k = 0; g->rule.guard && k < work->pieces->n; k++)
        look(g, run, &work->pieces->item[k], deeps);
}

/* The interval of the piece, told by its first point, over which the place is the least detour. */
static size_t interval_at(const struct run *run, const struct spline_run_piece *piece,
                          struct vec3 place)
{
    double least = HUGE_VAL;
    size_t at = piece->from;

    for (size_t i = piece->from; i < piece->to; i++) {
        struct vec3 a = run->item[i].ball, b = run->item[i + 1].ball;
        double detour = vec_distance(a, place) + vec_distance(place, b) - vec_distance(a, b);
        if (detour < least) {
            least = detour;
            at = i;
        }
    }
    return at;
}

/* In each piece that goes too deep, the line between the two points next to the deepest place.
 * False when there was none. */
static bool straighten(const struct work *work, const struct run *run)
{
    const struct spline_guard *g = work->guard;
    struct gouges deeps = {0};
    bool done = false;

    for (size_t k = work->pieces->n; k-- > 0;) { /* what is parted, grows behind */
        const struct spline_run_piece *piece = &work->pieces->item[k];
        deeps.n = 0;
        look(g, run, piece, &deeps);
        struct gouge deepest = gouge_refit_beyond(&g->rule, &deeps);
        if (deepest.depth == 0 || piece->to == piece->from + 1)
            continue;
        spline_run_part(run, g->rule.centre, &g->fit, k, interval_at(run, piece, deepest.ball),
                        work->pieces);
        done = true;
    }
    array_free(&deeps);
    return done;
}

/* The points as they are: what is too deep is only told. */
static struct gouge_refit_result fit_once(struct work *work, const struct run *run)
{
    struct gouge_refit_result result = {.lift = 0};
    struct gouges deeps = {0};

    fit(work, run, &deeps);
    result.deepest = gouge_refit_beyond(&work->guard->rule, &deeps);
    array_free(&deeps);
    return result;
}

struct gouge_refit_result spline_guard_fit(const struct spline_guard *guard, struct run *run,
                                           struct spline_run *pieces)
{
    struct work work = {guard, pieces};

    spline_run_free(pieces);
    if (guard->paper)
        return fit_once(&work, run);
    struct gouge_refit_result result = gouge_refit_fit(&guard->rule, run, fit, &work);
    for (int round = 0; round < ROUNDS && result.deepest.depth > 0; round++) {
        if (!straighten(&work, run))
            break;
        struct gouge_refit_result more = gouge_refit_fit(&guard->rule, run, fit, &work);
        result.deepest = more.deepest;
        result.lift += more.lift;
    }
    return result;
}
