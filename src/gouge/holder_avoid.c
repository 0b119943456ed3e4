/* holder_avoid - see holder_avoid.h. */
#include "gouge/holder_avoid.h"

#include <stdlib.h>

enum { TRIALS = 5, SWEEPS = 30, SIDES = 16, ROUNDS = 12, HALVINGS = 14 };

static const double MARGIN = 0.05;              /* mm: what a lean leaves free; more where it */
static const double WIDER = 3;                  /* must, by this factor for each trial */
static const double STEP = 0.04363323129985824; /* 2.5 degrees */
static const double RAMP = 0.05;                /* of the lean, 1/mm */
static const double OUTSIDE = 0.05;             /* cosine of axis and normal, at least */
static const double FINE = 0.02; /* mm: poses no further apart need no more between */

static double clearance(const struct holder_avoid_options *rule, const struct run_point *p,
                        double below)
{
    return gouge_holder(rule->guard, rule->holder, p->ball, p->axis, below);
}

static bool is_clear(const struct holder_avoid_options *rule, const struct run_point *p,
                     double least)
{
    return gouge_holder_clear(rule->guard, rule->holder, p->ball, p->axis, least);
}

/* Between two poses no point of the holder moves farther than the centre moves plus the reach
 * times the turn.  So where the two clearances together are more than that, some clearance is left
 * everywhere between. */
static bool is_clear_between(const struct holder_avoid_options *rule, struct run_point a,
                             double clear_a, struct run_point b, double clear_b, int halvings)
{
    double moved =
        vec_distance(a.ball, b.ball) + holder_reach(rule->holder) * vec_angle(a.axis, b.axis);

    if (fmin(clear_a, clear_b) < -rule->slack)
        return false;
    if (clear_a + clear_b + 2 * rule->slack >= moved || moved <= FINE || halvings == 0)
        return true;
    struct run_point m = {.ball = vec_mix(a.ball, b.ball, 0.5),
                          .axis = vec_slerp(a.axis, b.axis, 0.5)};
    double clear_m = clearance(rule, &m, moved);
    return is_clear_between(rule, a, clear_a, m, clear_m, halvings - 1) &&
           is_clear_between(rule, m, clear_m, b, clear_b, halvings - 1);
}

bool holder_clear_between(const struct holder_avoid_options *rule, const struct run_point *from,
                          const struct run_point *to)
{
    double moved = vec_distance(from->ball, to->ball) +
                   holder_reach(rule->holder) * vec_angle(from->axis, to->axis) + MARGIN;

    return is_clear_between(rule, *from, clearance(rule, from, moved), *to,
                            clearance(rule, to, moved), HALVINGS);
}

/* The least lean off `rule_axis` from `least` on that clears the point; of equal ones that nearest
 * to `before`.  False when there is none. */
static bool find_lean(const struct holder_avoid_options *rule, const struct run_point *p,
                      double margin, struct vec3 rule_axis, double least, struct vec3 before,
                      struct vec3 *found)
{
    *found = rule_axis;
    struct vec3 side = vec_perpendicular(rule_axis);
    bool any = false;

    for (double lean = least; lean <= rule->limit + 1e-9 && !any; lean += STEP) {
        for (int k = 0; k < SIDES; k++) {
            struct vec3 about = vec_turn(side, rule_axis, 2 * PI * k / SIDES);
            struct run_point q = *p;
            q.axis = vec_turn(rule_axis, about, lean);
            if ((vec_length(p->normal) > 0 && vec_dot(q.axis, p->normal) < OUTSIDE) ||
                !is_clear(rule, &q, margin))
                continue;
            if (!any || vec_dot(q.axis, before) > vec_dot(*found, before))
                *found = q.axis;
            any = true;
        }
    }
    return any;
}

/* The lean of each point: what is left of the largest after the distance between, and of its own
 * what that does not have. */
static void spread_leans(struct run *run, const struct vec3 *rule_axis, const struct vec3 *own)
{
    for (size_t i = 0; i < run->n; i++) {
        struct vec3 lean = own[i];
        double most = vec_length(lean);
        for (int step = -1; step <= 1; step += 2) {
            double along = 0;
            size_t j = i;
            while (step < 0 ? j > 0 : j + 1 < run->n) {
                size_t k = step < 0 ? j - 1 : j + 1;
                along += vec_distance(run->item[j].ball, run->item[k].ball);
                j = k;
                if (along * RAMP > 2)
                    break;
                double left = vec_length(own[j]) - RAMP * along;
                if (left > most) {
                    most = left;
                    lean = vec_scale(left, vec_unit(own[j]));
                }
            }
        }
        struct vec3 mine = vec_unit(own[i]);
        lean = vec_along(lean, fmax(0, vec_length(own[i]) - vec_dot(lean, mine)), mine);
        struct run_point *p = &run->item[i];
        p->axis = most > 0 ? vec_unit(vec_add(rule_axis[i], lean)) : rule_axis[i];
        p->tip = vec_along(p->ball, -run->radius, p->axis);
    }
}

/* Leans of the points that still need one, larger than before; false when none does. */
static bool lean_more(const struct holder_avoid_options *rule, const struct run *run,
                      const double *margin, const struct vec3 *rule_axis, struct vec3 *own)
{
    bool any = false;

    for (size_t i = 0; i < run->n; i++) {
        const struct run_point *p = &run->item[i];
        struct vec3 axis;
        if (is_clear(rule, p, 0.9 * margin[i]))
            continue;
        double least = STEP + 2 * asin(fmin(vec_length(own[i]) / 2, 1));
        if (!find_lean(rule, p, margin[i], rule_axis[i], least, i > 0 ? p[-1].axis : p->axis,
                       &axis))
            continue;
        own[i] = vec_sub(axis, rule_axis[i]);
        any = true;
    }
    return any;
}

/* Neighbouring axes brought nearer to each other where that leaves the holder clear. */
static void smooth_axes(const struct holder_avoid_options *rule, struct run *run,
                        const double *margin, const struct vec3 *rule_axis)
{
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        for (size_t i = 1; i + 1 < run->n; i++) {
            struct run_point p = run->item[i];
            const struct run_point *before = &run->item[i - 1], *after = &run->item[i + 1];
            struct vec3 mean = vec_unit(vec_add(before->axis, after->axis));
            if (vec_distance(mean, p.axis) < 1e-6 || vec_angle(mean, rule_axis[i]) > rule->limit ||
                (vec_length(p.normal) > 0 && vec_dot(mean, p.normal) < OUTSIDE))
                continue;
            p.axis = mean;
            p.tip = vec_along(p.ball, -run->radius, mean);
            if (is_clear(rule, &p, 0.9 * margin[i]))
                run->item[i] = p;
        }
    }
}

/* Which points the holder touches at, or on the way to; where it touches between two points, both
 * get a wider margin.  False if there are none of these. */
static bool find_touches(const struct holder_avoid_options *rule, const struct run *run,
                         double *margin, bool *touches)
{
    bool between = false;

    for (size_t i = 0; i < run->n; i++) {
        const struct run_point *p = &run->item[i];
        touches[i] = !is_clear(rule, p, -rule->slack);
        if (touches[i] || i == 0 || touches[i - 1] || holder_clear_between(rule, p - 1, p))
            continue;
        touches[i] = between = true;
        margin[i] *= WIDER;
        margin[i - 1] *= WIDER;
    }
    return between;
}

double holder_avoid(const struct holder_avoid_options *rule, struct run *run, bool *touches)
{
    struct vec3 *rule_axis = mem_alloc(run->n + 1, sizeof *rule_axis);
    struct vec3 *own = mem_alloc(run->n + 1, sizeof *own);
    double *margin = mem_alloc(run->n + 1, sizeof *margin), most = 0;
    bool again = true;

    for (size_t i = 0; i < run->n; i++) {
        rule_axis[i] = run->item[i].axis;
        own[i] = vec(0, 0, 0);
        margin[i] = MARGIN;
    }
    for (int trial = 0; trial < TRIALS && again; trial++) {
        bool leaned = false;
        for (int round = 0; round < ROUNDS && lean_more(rule, run, margin, rule_axis, own);
             round++) {
            spread_leans(run, rule_axis, own);
            leaned = true;
        }
        if (leaned)
            smooth_axes(rule, run, margin, rule_axis);
        again = find_touches(rule, run, margin, touches) && rule->limit > 0;
    }
    for (size_t i = 0; i < run->n; i++)
        most = fmax(most, vec_angle(run->item[i].axis, rule_axis[i]));
    free(rule_axis);
    free(own);
    free(margin);
    return most;
}
