/* arcspline - see arcspline.h. */
#include "arcspline.h"

#include <stdlib.h>
#include <string.h>

#include "arcfit/arcfit.h"
#include "arcspline_normal.h"
#include "math/pnorm.h"

struct arcspline arcspline_new(size_t arcs)
{
    return (struct arcspline){.n = arcs, .joint = mem_alloc(arcs + 1, sizeof(struct joint))};
}

void arcspline_free(struct arcspline *spline)
{
    free(spline->joint);
    *spline = (struct arcspline){0};
}

void arcspline_copy(struct arcspline *to, const struct arcspline *from)
{
    memcpy(to->joint, from->joint, (from->n + 1) * sizeof *from->joint);
}

void arcspline_set_tangents(struct arcspline *spline, size_t from)
{
    for (size_t i = from; i < spline->n; i++) {
        struct joint *a = &spline->joint[i], *b = a + 1;
        struct vec3 chord = vec_sub(b->p, a->p);
        double l2 = vec_dot(chord, chord), ahead = vec_dot(a->tangent, chord);
        b->tangent =
            l2 > 0 ? vec_along(vec_scale(-1, a->tangent), 2 * ahead / l2, chord) : a->tangent;
    }
}

/* The turn of an axis to its side, radians: held where it leans little off Z, so that no rotary
 * axis about Z turns with it. */
static double held_turn(struct vec3 axis, double turn)
{
    double most = ARC_BEARING * hypot(axis.x, axis.y);

    return fmax(-most, fmin(turn, most));
}

/* To the side of the other point's path, square to the axis. */
static struct vec3 side_at(const struct reference *reference, double place, struct vec3 axis)
{
    size_t k = (size_t)place < reference->n - 1 ? (size_t)place : reference->n - 2;

    return vec_unit(vec_cross(vec_sub(reference->other[k + 1], reference->other[k]), axis));
}

void arcspline_set_axis(struct arcspline *spline, const struct reference *reference, size_t joint)
{
    struct joint *j = &spline->joint[joint];
    j->place = reference_place(reference, j->p, j->place);
    j->axis = reference_axis(reference, j->place);
    struct vec3 side = side_at(reference, j->place, j->axis);
    if (reference->offset != 0)
        j->axis =
            vec_unit(vec_along(j->axis, held_turn(j->axis, j->side / reference->offset), side));
    j->axis = reference_flat_axis(reference, j->axis);
}

void arcspline_lean_axis(struct arcspline *spline, const struct reference *reference, size_t joint,
                         struct vec3 axis)
{
    struct joint *j = &spline->joint[joint];
    j->side = 0;
    arcspline_set_axis(spline, reference, joint);
    double aside = vec_dot(axis, side_at(reference, j->place, j->axis));
    j->side = reference->offset * aside / fmax(vec_dot(axis, j->axis), 0.5);
    arcspline_set_axis(spline, reference, joint);
}

struct arc arcspline_arc(const struct arcspline *spline, size_t i)
{
    const struct joint *j = &spline->joint[i];
    return arc_to(j->p, j->tangent, j[1].p);
}

void arcspline_pieces(const struct arcspline *spline, const struct reference *reference,
                      struct pieces *pieces)
{
    double place = spline->joint[0].place;
    for (size_t i = 0; i < spline->n; i++) {
        const struct joint *from = &spline->joint[i], *to = from + 1;
        double next = i + 1 < spline->n ? reference_place(reference, to->p, place) : to->place;
        next = fmax(place, next);
        struct arc_piece piece = arc_piece_of(reference, arcspline_arc(spline, i), place, next);
        piece.axis = from->axis;
        piece.axis_to = to->axis;
        *array_push(pieces) = piece;
        place = next;
    }
}

/* ---- residuals */

static const double TURN_SIMPLE = 2; /* radians: no point is beside its end the other way round */

/* Two unit vectors across the path of a row of points at point k, or in the middle of what follows
 * it. */
static void unit_across(const struct vec3 *p, size_t n, size_t k, bool middle, struct vec3 *u,
                        struct vec3 *v)
{
    size_t before = k > 0 && !middle ? k - 1 : k, after = k + 1 < n ? k + 1 : k;
    struct vec3 t = vec_unit(vec_sub(p[after], p[before]));
    if (vec_dot(t, t) < 0.5)
        t = vec(1, 0, 0);
    *u = vec_perpendicular(t);
    *v = vec_cross(t, *u);
}

static struct arc_foot foot_of(const struct reference *reference, size_t k, bool middle)
{
    const struct vec3 *point = &reference->point[k], *other = &reference->other[k];
    struct arc_foot foot = {.p = *point, .other = *other};

    if (middle) {
        foot.p = vec_mix(point[0], point[1], 0.5);
        foot.other = vec_mix(other[0], other[1], 0.5);
    }
    unit_across(reference->point, reference->n, k, middle, &foot.u, &foot.v);
    unit_across(reference->other, reference->n, k, middle, &foot.s, &foot.w);
    return foot;
}

struct arc_feet arc_feet_of(const struct reference *reference, size_t from, size_t to, size_t most)
{
    size_t places = to > from ? to - from - 1 : 0;
    bool halves = to > from && places < most;
    if (halves)
        places = 2 * (to - from) - 1;
    size_t n = places < most ? places : most;
    struct arc_feet feet = {.n = n, .item = mem_alloc(n, sizeof *feet.item)};
    for (size_t i = 0; i < n; i++) {
        size_t k = 1 + (2 * i + 1) * places / (2 * n);
        feet.item[i] = halves ? foot_of(reference, from + k / 2, k % 2 == 1)
                              : foot_of(reference, from + k, false);
    }
    return feet;
}

void arc_feet_free(struct arc_feet *feet)
{
    free(feet->item);
    *feet = (struct arc_feet){0};
}

static bool is_after(const struct joint *joint, struct vec3 p)
{
    return vec_dot(vec_sub(p, joint->p), joint->tangent) > 0;
}

/* Where the arc passes the point: with the angle there, which the axis turns by. */
static void set_foot_by_angle(const struct arc *arc, struct arc_foot *q)
{
    q->part = arc_foot(arc, q->p);
    struct sine_cosine half = elementary_sine_cosine(q->part * arc->angle / 2);
    q->sine = half.sine;
    q->rest = (1 - q->part) * arc->angle / 2;
    q->at = arc_by_half(arc, q->part, half);
}

double arc_foot_conic(const struct arc_foot *q)
{
    if (q->rest < 0)
        return q->conic;
    double a = q->sine, b = sin(q->rest);
    return a + b > 0 ? a / (a + b) : q->part;
}

/* The same without: a tenth of the time.  `end` is the tangent at the arc's end. */
static void set_foot(const struct arc *arc, struct vec3 end, struct arc_foot *q)
{
    struct vec3 w = vec_sub(q->p, arc->from), beyond = vec_sub(q->p, arc->to);
    double x = vec_dot(w, arc->tangent), rest = arc->radius - vec_dot(w, arc->inward);
    double far = sqrt(x * x + rest * rest); /* from the centre, in the plane of the arc */

    q->rest = -1;
    if (x <= 0 || vec_dot(beyond, end) >= 0) {
        q->conic = x <= 0 ? 0 : 1;
        q->at = x <= 0 ? arc->from : arc->to;
        return;
    }
    q->at = vec_along(arc->from, arc->radius * x / far, arc->tangent);
    q->at = vec_along(q->at, arc->radius * x * x / (far * (far + rest)), arc->inward);
    double a = vec_distance(arc->from, q->at), b = vec_distance(q->at, arc->to);
    q->conic = a / (a + b);
}

/* How the axis turns on arc k; where there is no other point nothing. */
static struct great_circle turn_of(const struct arcspline *spline, size_t k, double offset)
{
    const struct great_circle none = {.angle = 0};
    if (offset == 0)
        return none;
    return great_circle_of(spline->joint[k].axis, spline->joint[k + 1].axis);
}

void arcspline_residual(const struct arcspline *spline, double offset, struct arc_feet *feet,
                        double *off)
{
    size_t k = 0;
    struct arc arc = arcspline_arc(spline, k);
    struct great_circle turn = turn_of(spline, k, offset);
    double *other = off + 2 * feet->n;
    for (size_t i = 0; i < feet->n; i++) {
        struct arc_foot *q = &feet->item[i];
        size_t before = k;
        while (k + 1 < spline->n && is_after(&spline->joint[k + 1], q->p))
            k++;
        if (k > before) {
            arc = arcspline_arc(spline, k);
            turn = turn_of(spline, k, offset);
        }
        q->arc = k;
        if (offset == 0 && arc.angle > 0 && arc.angle < TURN_SIMPLE)
            set_foot(&arc, spline->joint[k + 1].tangent, q);
        else
            set_foot_by_angle(&arc, q);
        struct vec3 d = vec_sub(q->p, q->at);
        off[2 * i] = vec_dot(d, q->u);
        off[2 * i + 1] = vec_dot(d, q->v);
        if (offset == 0)
            continue;
        struct vec3 axis = great_circle_at(&turn, q->part);
        d = vec_sub(q->other, vec_along(q->at, offset, axis));
        other[2 * i] = vec_dot(d, q->s);
        other[2 * i + 1] = vec_dot(d, q->w);
    }
}

size_t arc_feet_first(const struct arc_feet *feet, size_t arc)
{
    size_t lo = 0, hi = feet->n;
    while (lo < hi) {
        size_t middle = (lo + hi) / 2;
        if (feet->item[middle].arc < arc)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}

/* ---- optimization */

enum { TRIES = 7 }; /* of a damping */

static const double SETTLED = 1e-4; /* part of the cost: a step that gains less is the last */

/*
 * Norms one after the other.  From low norms a few steps do, for what is best there is not so in
 * high ones; but a spline held at its ends comes from farther off.  A spline above `hopeless` has
 * not come within the tolerance in one of some hundred tries.
 */
static const struct stage {
    int half;        /* of p */
    int free, held;  /* steps at most */
    double hopeless; /* part of a tolerance */
    double turned;   /* radians: the end's tangent so far off counts as a tolerance */
} STAGES[] = {{1, 3, 8, 4.5, 4e-3},    {2, 3, 8, 2.2, 1e-3},     {5, 6, 8, 1.4, 1.2e-4},
              {12, 6, 8, 1.1, 1.2e-4}, {24, 6, 8, 1.04, 1.2e-4}, {60, 6, 8, 1, 1.2e-4}};

enum { N_STAGES = sizeof STAGES / sizeof *STAGES };

struct optimizer {
    struct arcspline_fit *fit;
    struct arcspline_normal sum;
    size_t pairs; /* of distances, in tolerances: those of all points, then of the other ones */
    double *room, *off, *next; /* now, and after a step; both in `room` */
    double *step;
    struct arcspline kept;
    struct band factor;
};

static struct optimizer optimizer_new(struct arcspline_fit *m)
{
    struct optimizer w = {.fit = m, .sum = arcspline_normal_new(m)};
    w.pairs = m->feet.n * (m->offset != 0 ? 2 : 1);
    w.off = w.room = mem_alloc(4 * w.pairs + 1, sizeof *w.room);
    w.next = w.off + 2 * w.pairs;
    w.step = mem_alloc(w.sum.unknowns + 1, sizeof *w.step);
    w.kept = arcspline_new(m->spline.n);
    w.factor = band_new(w.sum.unknowns, w.sum.normal.width);
    return w;
}

static void optimizer_free(struct optimizer *w)
{
    arcspline_normal_free(&w->sum);
    free(w->room);
    free(w->step);
    arcspline_free(&w->kept);
    band_free(&w->factor);
}

/* By how much a radian of the end's tangent counts. */
static double end_weight(const struct arcspline_fit *m)
{
    return m->end_held ? 1 / STAGES[m->stage].turned : 0;
}

static void set_residuals(struct arcspline_fit *m, double *off, double held[3])
{
    double *other = off + 2 * m->feet.n, part = end_weight(m);
    arcspline_residual(&m->spline, m->offset, &m->feet, off);
    m->asked += (double)m->feet.n;
    for (size_t i = 0; i < 2 * m->feet.n; i++) {
        off[i] /= m->tolerance;
        if (m->offset != 0)
            other[i] /= m->other;
    }
    struct vec3 d = vec_sub(m->spline.joint[m->spline.n].tangent, m->end);
    held[0] = part * d.x;
    held[1] = part * d.y;
    held[2] = part * d.z;
}

/* Goes by the step, in the order of arcspline_unknowns. */
static void move_joints(struct arcspline_fit *m, const double *step)
{
    size_t inner = m->spline.n - 1;
    if (!m->start_held) {
        struct vec3 *t = &m->spline.joint[0].tangent, u = vec_perpendicular(*t),
                    v = vec_cross(*t, u);
        *t = vec_unit(vec_along(vec_along(*t, step[0], u), step[1], v));
        step += 2;
    }
    for (size_t i = 0; i < inner; i++) {
        struct joint *j = &m->spline.joint[i + 1];
        j->p = vec_add(j->p, vec(step[3 * i], step[3 * i + 1], step[3 * i + 2]));
        if (m->offset == 0)
            continue;
        j->side += step[3 * inner + i];
        arcspline_set_axis(&m->spline, m->reference, i + 1);
    }
    arcspline_set_tangents(&m->spline, 0);
}

/* Goes by the step, or back; false when the cost has not become less. */
static bool try_step(struct optimizer *w, const struct stage *stage, double scale, double *now)
{
    struct arcspline_fit *m = w->fit;
    double held[3];
    move_joints(m, w->step);
    set_residuals(m, w->next, held);
    double then = pnorm_cost(w->next, w->pairs, held, stage->half, scale), *before = w->off;
    if (!(then < *now)) {
        arcspline_copy(&m->spline, &w->kept);
        return false;
    }
    *now = then;
    w->off = w->next;
    w->next = before;
    arcspline_copy(&w->kept, &m->spline);
    return true;
}

/* One step of Levenberg and Marquardt from the distances at w->off and their feet; false when none
 * makes the cost less. */
static bool take_step(struct optimizer *w, const struct stage *stage, double scale, double *damping,
                      double *now)
{
    size_t n = w->sum.unknowns;
    arcspline_normal_set(w->fit, w->off, stage->half, scale, end_weight(w->fit), &w->sum);
    bool better = false;
    for (int i = 0; i < TRIES && !better; i++) {
        memcpy(w->factor.item, w->sum.normal.item, n * n * sizeof *w->factor.item);
        memcpy(w->step, w->sum.right, n * sizeof *w->step);
        for (size_t k = 0; k < n; k++)
            *band_at(&w->factor, k, k) += *damping * *band_at(&w->sum.normal, k, k) + 1e-12;
        if (band_factor(&w->factor)) {
            band_solve(&w->factor, w->step, 1);
            better = try_step(w, stage, scale, now);
        }
        *damping *= !better ? 5 : i == 0 ? 0.2 : 1;
    }
    return better;
}

static double largest(const struct optimizer *w)
{
    double worst = 0;
    for (size_t i = 0; i < w->pairs; i++) {
        double x = w->off[2 * i], y = w->off[2 * i + 1];
        worst = fmax(worst, x * x + y * y);
    }
    return sqrt(worst);
}

/* The end is reached in another direction than it should be. */
static bool ends_kinked(const struct arcspline_fit *m)
{
    return m->end_held &&
           vec_distance(m->spline.joint[m->spline.n].tangent, m->end) > ARCFIT_KINK / 2;
}

double arcspline_optimize(struct arcspline_fit *m, double enough)
{
    if (m->spline.n == 0)
        return HUGE_VAL;
    struct optimizer w = optimizer_new(m);
    double damping = 1e-4, worst = HUGE_VAL;
    arcspline_set_tangents(&m->spline, 0);
    arcspline_copy(&w.kept, &m->spline);
    for (;; m->stage++) {
        const struct stage *stage = &STAGES[m->stage];
        int steps = m->start_held || m->end_held ? stage->held : stage->free;
        double held[3];
        set_residuals(m, w.off, held);
        worst = largest(&w);
        double scale = fmax(worst, 1e-3),
               now = pnorm_cost(w.off, w.pairs, held, stage->half, scale);
        for (int k = 0; k < steps && w.sum.unknowns > 0 && (worst > enough || ends_kinked(m));
             k++) {
            double before = now;
            if (!take_step(&w, stage, scale, &damping, &now) || before - now < SETTLED * before)
                k = steps;
            worst = largest(&w);
        }
        damping = fmin(damping, 1);
        bool settled = worst <= enough && !ends_kinked(m);
        if (settled || worst > stage->hopeless || m->stage + 1 == N_STAGES)
            break;
    }
    optimizer_free(&w);
    return ends_kinked(m) ? HUGE_VAL : worst;
}
