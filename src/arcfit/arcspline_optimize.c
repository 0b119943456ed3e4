/* arcspline_optimize - see arcspline_optimize.h. */
#include "arcspline_optimize.h"

#include <stdlib.h>

#include "math/pnorm.h"

enum { TRIES = 7 };

static const double MOVED = 1e-6;   /* mm or radians, for differences */
static const double SETTLED = 1e-4; /* part of the cost: a step that gains less is the last */

/*
 * Norms one after the other.  From low norms a few steps do, for what is best there is not so in
 * high ones; but a chain held at its ends comes from farther off.  A chain above `hopeless` has not
 * come within the tolerance in one of some hundred tries.
 */
static const struct stage {
    int half;        /* of p */
    int free, held;  /* steps at most */
    double hopeless; /* part of a tolerance */
    double turned;   /* radians: the end's tangent so far off counts as a tolerance */
} STAGES[] = {{1, 3, 8, 4.5, 4e-3},    {2, 3, 8, 2.2, 1e-3},     {5, 6, 8, 1.4, 1.2e-4},
              {12, 6, 8, 1.1, 1.2e-4}, {24, 6, 8, 1.04, 1.2e-4}, {60, 6, 8, 1, 1.2e-4}};

enum { N_STAGES = sizeof STAGES / sizeof *STAGES };

struct work {
    struct arcspline_optimize *m;
    struct pnorm sum; /* of the distances in tolerances, and the end's tangent in stage->turned */
    double *next, *step;
    struct arcspline kept;
    struct band factor;
};

static struct work work_new(struct arcspline_optimize *m)
{
    size_t inner = m->chain.n - 1, n = (m->start_held ? 0 : 2) + (m->lever != 0 ? 4 : 3) * inner;
    struct work w = {.m = m, .sum = pnorm_new(m->passing.n, m->lever != 0, n)};
    w.next = mem_alloc(2 * w.sum.pairs, sizeof *w.next);
    w.step = mem_alloc(n, sizeof *w.step);
    w.kept = arcspline_new(m->chain.n);
    w.factor = band_new(n, w.sum.normal.width);
    return w;
}

static void work_free(struct work *w)
{
    pnorm_free(&w->sum);
    free(w->next);
    free(w->step);
    arcspline_free(&w->kept);
    band_free(&w->factor);
}

static void in_tolerances(const struct arcspline_optimize *m, size_t from, size_t to, double *off)
{
    double *other = off + 2 * m->passing.n;
    for (size_t i = 2 * from; i < 2 * to; i++) {
        off[i] /= m->tolerance;
        if (m->lever != 0)
            other[i] /= m->other;
    }
}

static void measure(struct arcspline_optimize *m, double *off, double held[3])
{
    arcspline_residual(&m->chain, m->lever, &m->passing, off);
    in_tolerances(m, 0, m->passing.n, off);
    struct vec3 d = vec_sub(m->chain.joint[m->chain.n].tangent, m->end);
    double part = m->end_held ? 1 / STAGES[m->stage].turned : 0;
    held[0] = part * d.x;
    held[1] = part * d.y;
    held[2] = part * d.z;
}

/* Moves unknown k; the arcs [from, to) change. */
static void move(struct arcspline_optimize *m, size_t k, double by, size_t *from, size_t *to)
{
    size_t inner = m->chain.n - 1;
    *from = 0;
    *to = m->chain.n;
    if (!m->start_held) {
        struct vec3 *t = &m->chain.joint[0].tangent, u = vec_perpendicular(*t);
        if (k < 2) {
            *t = vec_unit(vec_along(*t, by, k ? vec_cross(*t, u) : u));
            return;
        }
        k -= 2;
    }
    struct joint *j = &m->chain.joint[1 + (k < 3 * inner ? k / 3 : k - 3 * inner)];
    *from = (size_t)(j - m->chain.joint) - 1;
    if (k >= 3 * inner) {
        j->side += by;
        *to = *from + 2;
    } else {
        *(k % 3 == 0 ? &j->p.x : k % 3 == 1 ? &j->p.y : &j->p.z) += by;
    }
    if (m->lever != 0)
        arcspline_lean(&m->chain, m->trace, *from + 1);
}

/* The slopes of unknown k. */
static void differ(struct work *w, size_t k)
{
    struct arcspline_optimize *m = w->m;
    struct pnorm_column *c = &w->sum.column[k];
    size_t from, to;
    move(m, k, MOVED, &from, &to);
    arcspline_turn(&m->chain, from);
    c->from = passing_first(&m->passing, from);
    c->to = passing_first(&m->passing, to);
    arcspline_residual_slope(&m->chain, m->lever, &m->passing, c->from, c->to, MOVED, c->slope);
    in_tolerances(m, c->from, c->to, c->slope);
    struct vec3 turned =
        vec_sub(m->chain.joint[m->chain.n].tangent, w->kept.joint[m->chain.n].tangent);
    double part = m->end_held ? 1 / (STAGES[m->stage].turned * MOVED) : 0;
    c->held[0] = part * turned.x;
    c->held[1] = part * turned.y;
    c->held[2] = part * turned.z;
    arcspline_copy(&m->chain, &w->kept);
}

/* Goes by the step, or back; false when the cost has not become less. */
static bool try_step(struct work *w, const struct stage *stage, double scale, double *now)
{
    struct arcspline_optimize *m = w->m;
    double held[3];
    size_t from, to;
    for (size_t k = 0; k < w->sum.unknowns; k++)
        move(m, k, w->step[k], &from, &to);
    arcspline_turn(&m->chain, 0);
    measure(m, w->next, held);
    double then = pnorm_cost(&w->sum, w->next, held, stage->half, scale);
    if (!(then < *now)) {
        arcspline_copy(&m->chain, &w->kept);
        return false;
    }
    *now = then;
    for (size_t i = 0; i < 2 * w->sum.pairs; i++)
        w->sum.off[i] = w->next[i];
    for (int i = 0; i < 3; i++)
        w->sum.held[i] = held[i];
    arcspline_copy(&w->kept, &m->chain);
    return true;
}

/* One step of Levenberg and Marquardt; false when none makes the cost less. */
static bool step(struct work *w, const struct stage *stage, double scale, double *damping,
                 double *now)
{
    measure(w->m, w->sum.off, w->sum.held);
    for (size_t k = 0; k < w->sum.unknowns; k++)
        differ(w, k);
    pnorm_equations(&w->sum, stage->half, scale);
    bool better = false;
    for (int i = 0; i < TRIES && !better; i++) {
        for (size_t k = 0; k < w->sum.unknowns * w->sum.unknowns; k++)
            w->factor.item[k] = w->sum.normal.item[k];
        for (size_t k = 0; k < w->sum.unknowns; k++) {
            *band_at(&w->factor, k, k) += *damping * *band_at(&w->sum.normal, k, k) + 1e-12;
            w->step[k] = w->sum.right[k];
        }
        if (band_factor(&w->factor)) {
            band_solve(&w->factor, w->step, 1);
            better = try_step(w, stage, scale, now);
        }
        *damping *= better ? 0.2 : 5;
    }
    return better;
}

static double largest(const struct work *w)
{
    double worst = 0;
    for (size_t i = 0; i < w->sum.pairs; i++) {
        double x = w->sum.off[2 * i], y = w->sum.off[2 * i + 1];
        worst = fmax(worst, x * x + y * y);
    }
    return sqrt(worst);
}

/* The end is reached in another direction than it should be. */
static bool kinked(const struct arcspline_optimize *m)
{
    return m->end_held &&
           vec_distance(m->chain.joint[m->chain.n].tangent, m->end) > ARCFIT_KINK / 2;
}

double arcspline_optimize_settle(struct arcspline_optimize *m, double enough)
{
    if (m->chain.n == 0)
        return HUGE_VAL;
    struct work w = work_new(m);
    double damping = 1e-4, worst = HUGE_VAL;
    arcspline_turn(&m->chain, 0);
    arcspline_copy(&w.kept, &m->chain);
    for (;; m->stage++) {
        const struct stage *stage = &STAGES[m->stage];
        int steps = m->start_held || m->end_held ? stage->held : stage->free;
        measure(m, w.sum.off, w.sum.held);
        worst = largest(&w);
        double scale = fmax(worst, 1e-3),
               now = pnorm_cost(&w.sum, w.sum.off, w.sum.held, stage->half, scale);
        for (int k = 0; k < steps && w.sum.unknowns > 0 && (worst > enough || kinked(m)); k++) {
            double before = now;
            if (!step(&w, stage, scale, &damping, &now) || before - now < SETTLED * before)
                k = steps;
            worst = largest(&w);
        }
        damping = fmin(damping, 1);
        bool settled = worst <= enough && !kinked(m);
        if (settled || worst > stage->hopeless || m->stage + 1 == N_STAGES)
            break;
    }
    work_free(&w);
    return kinked(m) ? HUGE_VAL : worst;
}
