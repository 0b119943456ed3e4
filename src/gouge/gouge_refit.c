/* gouge_refit - see gouge_refit.h. */
#include "gouge/gouge_refit.h"

#include <stdlib.h>

enum { HALVINGS = 16, ROUNDS = 8 };

static const double SAFE = 0.92; /* of the tolerance: lifted from there; the scan is not the part */
static const double PIECE = 1;   /* mm: of a motion, looked at as one place */
static const double USELESS = 0.95; /* of the depth before: it did not help */
static const double NEAR = 0.5;     /* mm: points this near to a place are lifted all the way */

struct walk {
    const struct gouge_refit_options *rule;
    const struct motion *motion;
    double flat;
    struct gouges *deeps;
};

static struct vec3 ball_at(const struct walk *w, double s)
{
    struct pose pose = motion_at(w->motion, s);

    return w->rule->centre ? pose.p : vec_along(pose.p, w->rule->radius, pose.a);
}

static void halve(const struct walk *w, double s0, struct vec3 a, double s1, struct vec3 b,
                  int halvings);

/* A piece of the way, straight within w->flat.  Where that much decides, it is looked at closer. */
static void look(const struct walk *w, double s0, struct vec3 a, double s1, struct vec3 b,
                 int halvings)
{
    const double finest = 1e-3, finer = 1.0 / 8; /* of the tolerance; of the last */
    double tolerance = SAFE * w->rule->tolerance, may = tolerance - w->flat;
    double deeper = gouge_depth_along(w->rule->guard, a, b, w->rule->radius - may);

    if (deeper <= 0)
        return;
    if (deeper > 2 * w->flat || w->flat < finest * tolerance || halvings == 0) {
        *array_push(w->deeps) = (struct gouge){vec_mix(a, b, 0.5), deeper + may};
        return;
    }
    struct walk closer = *w;
    closer.flat *= finer;
    halve(&closer, s0, a, s1, b, halvings);
}

static void halve(const struct walk *w, double s0, struct vec3 a, double s1, struct vec3 b,
                  int halvings)
{
    double s = (s0 + s1) / 2;
    struct vec3 m = ball_at(w, s);
    bool straight = vec_distance(a, b) <= PIECE && vec_line_distance(a, b, m) <= w->flat &&
                    vec_line_distance(a, b, ball_at(w, (s0 + s) / 2)) <= w->flat &&
                    vec_line_distance(a, b, ball_at(w, (s + s1) / 2)) <= w->flat;

    if (straight || halvings == 0) {
        look(w, s0, a, s1, b, halvings);
        return;
    }
    halve(w, s0, a, s, m, halvings - 1);
    halve(w, s, m, s1, b, halvings - 1);
}

void gouge_refit_motion(const struct gouge_refit_options *rule, const struct motion *motion,
                        struct gouges *deeps)
{
    struct walk w = {rule, motion, rule->tolerance / 20, deeps};
    double s0 = 0;

    if (!rule->guard)
        return;
    while (s0 < 1) {
        double s1 = motion_next_knot(motion, s0), middle = (s0 + s1) / 2;
        struct vec3 m = ball_at(&w, middle);
        /* halved once at least: a full turn ends where it begins */
        halve(&w, s0, ball_at(&w, s0), middle, m, HALVINGS);
        halve(&w, middle, m, s1, ball_at(&w, s1), HALVINGS);
        s0 = s1;
    }
}

/* So far from a place there are points on both sides of it. */
static double reach_of(const struct run *run, struct vec3 place)
{
    double nearest = HUGE_VAL, apart = 0;

    for (size_t i = 0; i < run->n; i++) {
        double distance = vec_distance(run->item[i].ball, place);
        if (distance >= nearest)
            continue;
        nearest = distance;
        apart = 0;
        if (i > 0)
            apart = vec_distance(run->item[i].ball, run->item[i - 1].ball);
        if (i + 1 < run->n)
            apart = fmax(apart, vec_distance(run->item[i].ball, run->item[i + 1].ball));
    }
    return fmax(NEAR, nearest + apart);
}

double gouge_refit_lift(const struct gouge_refit_options *rule, const struct gouges *deeps,
                        struct run *run)
{
    double *lift = mem_alloc(run->n, sizeof *lift), highest = 0;

    for (size_t i = 0; i < run->n; i++)
        lift[i] = 0;
    for (size_t k = 0; k < deeps->n; k++) {
        const struct gouge *deep = &deeps->item[k];
        double reach = reach_of(run, deep->ball), whole = deep->depth - rule->tolerance / 2;
        for (size_t i = 1; i + 1 < run->n; i++) {
            double beyond = vec_distance(run->item[i].ball, deep->ball) / reach - 1;
            double share = beyond <= 0 ? 1 : beyond >= 2 ? 0 : (1 + cos(beyond * PI / 2)) / 2;
            lift[i] = fmax(lift[i], share * whole);
        }
    }
    for (size_t i = 0; i < run->n; i++) {
        struct run_point *p = &run->item[i];
        struct vec3 up = vec_length(p->normal) > 0.5 ? p->normal : p->axis;
        p->ball = vec_along(p->ball, lift[i], up);
        p->tip = vec_along(p->tip, lift[i], up);
        highest = fmax(highest, lift[i]);
    }
    free(lift);
    return highest;
}

struct gouge gouge_refit_deepest(const struct gouges *deeps)
{
    struct gouge deepest = {.depth = 0};

    for (size_t i = 0; i < deeps->n; i++)
        if (deeps->item[i].depth > deepest.depth)
            deepest = deeps->item[i];
    return deepest;
}

struct gouge gouge_refit_beyond(const struct gouge_refit_options *rule, const struct gouges *deeps)
{
    const double printed = 0.001; /* of the tolerance: what the digits of the points leave */
    struct gouge deepest = gouge_refit_deepest(deeps);

    if (deepest.depth <= (1 + printed) * rule->tolerance)
        deepest.depth = 0;
    return deepest;
}

struct gouge_refit_result gouge_refit_fit(const struct gouge_refit_options *rule, struct run *run,
                                          void (*fit)(void *context, const struct run *run,
                                                      struct gouges *deeps),
                                          void *context)
{
    struct gouge_refit_result result = {.lift = 0};
    struct gouges deeps = {0};

    fit(context, run, &deeps);
    for (int round = 1; round < ROUNDS && deeps.n > 0; round++) {
        size_t before = deeps.n;
        double depth = gouge_refit_deepest(&deeps).depth;
        result.lift += gouge_refit_lift(rule, &deeps, run);
        deeps.n = 0;
        fit(context, run, &deeps);
        if (deeps.n >= before && gouge_refit_deepest(&deeps).depth > USELESS * depth && round > 2)
            break; /* as at an end */
    }
    result.deepest = gouge_refit_beyond(rule, &deeps);
    array_free(&deeps);
    return result;
}
