/* minimax - see minimax.h. */
#include "minimax.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "spline_lsq.h"

/* ---- Gauss-Newton steps: banded normal equations, summed up span by span */

enum { ORDER = BSPLINE_DEGREE_MAX + 1, SLOPES = 2 * BSPLINE_DEGREE_MAX };

static const double APPROACH = 0.4; /* of the way to its neighbour, at most, for a knot in a step */

/*
 * How far apart the unknowns of a span are at most: in it act the poles i .. i + p and 2 p knots,
 * of which the first comes after pole i + 1 - early and the last after i + 2 p - early.
 */
static size_t band_of(size_t p, size_t width, size_t early)
{
    size_t knots = (2 * p - 1) * (width + 1), after = (2 * p - early) * (width + 1) + width;

    return knots > after ? knots : after;
}

struct knots_step knots_step_new(const struct bspline *curve)
{
    struct knots_step s = {0};
    size_t p = (size_t)curve->degree, width = curve->head != NULL ? 6 : 3, at = 0;
    size_t early = (p + 1) / 2; /* a knot stands among the poles after the one in its middle */

    s.pole = mem_alloc(curve->poles, sizeof *s.pole);
    s.knot = mem_alloc(curve->poles, sizeof *s.knot);
    for (size_t i = 1; i + 1 < curve->poles; i++) {
        s.pole[i] = at;
        at += width;
        size_t knot = i + early;
        if (knot > p && knot < curve->poles)
            s.knot[knot] = at++;
    }
    s.unknowns = at;
    size_t band = band_of(p, width, early);
    s.normal = band_new(at, band < at ? band : at - 1);
    s.factor = band_new(at, s.normal.width);
    s.right = mem_alloc(at, sizeof *s.right);
    s.step = mem_alloc(at, sizeof *s.step);
    s.scale = mem_alloc(at, sizeof *s.scale);
    s.moments = mem_alloc((curve->poles - p) * span_moments_size(curve->degree, (int)width),
                          sizeof *s.moments);
    return s;
}

void knots_step_free(struct knots_step *s)
{
    free(s->pole);
    free(s->knot);
    band_free(&s->normal);
    band_free(&s->factor);
    free(s->right);
    free(s->step);
    free(s->scale);
    free(s->moments);
    *s = (struct knots_step){0};
}

/* The residuals of all places, each into its span. */
static void sum_moments(struct knots_step *s, const struct ppform *form,
                        const struct reference *places, const struct footpoints *feet, int power)
{
    int degree = form->degree, width = form->width;
    size_t size = span_moments_size(degree, width);
    struct residual residual;

    memset(s->moments, 0, form->spans * size * sizeof *s->moments);
    for (size_t k = 1; k + 1 < places->n; k++)
        for (int other = 0; other < (places->turns ? 2 : 1); other++) {
            const struct footpoint *at = other ? &feet->other[k] : &feet->point[k];
            residual_of(places, feet, k, other, power, &residual);
            span_moments_add(&s->moments[at->span * size], degree, width,
                             ppform_place(form, at->span, at->u), &residual);
        }
}

/* One span while its part of the equations is added. */
struct part {
    const struct ppform *form;
    const double *moments;
    size_t span, poles;
};

static bool is_inner(const struct part *part, size_t i)
{
    return part->span + i > 0 && part->span + i + 1 < part->poles;
}

static double dot_product(int n, const double *a, const double *b)
{
    double sum = 0;

    for (int i = 0; i < n; i++)
        sum += a[i] * b[i];
    return sum;
}

/* Elements of pole i of the span with the poles up to it; t: its moments (span_moments_of_basis).
 */
static void add_poles(struct knots_step *s, const struct part *part, size_t i, const double *t)
{
    size_t width = (size_t)part->form->width, order = (size_t)part->form->degree + 1;
    const double *basis = &part->form->basis[part->span * order * order];

    for (size_t j = 0; j <= i; j++) {
        double sum[RESIDUAL_WIDTH * RESIDUAL_WIDTH] = {0};
        if (!is_inner(part, j))
            continue;
        for (size_t l = 0; l < order; l++)
            for (size_t e = 0; e < width * width; e++)
                sum[e] += basis[j * order + l] * t[l * width * width + e];
        for (size_t v = 0; v < width; v++)
            for (size_t w = 0; w < (i == j ? v + 1 : width); w++)
                *band_at(&s->normal, s->pole[part->span + i] + v, s->pole[part->span + j] + w) +=
                    sum[v * width + w];
    }
}

/* The element of a symmetric matrix, in its lower triangle. */
static void add_element(struct band *band, size_t i, size_t j, double value)
{
    *(i >= j ? band_at(band, i, j) : band_at(band, j, i)) += value;
}

/* The knots that act in a span and how the curve moves with each. */
struct slopes {
    int n;
    size_t unknown[SLOPES];
    const double *c[SLOPES];
};

static struct slopes span_slopes(const struct knots_step *s, const struct part *part)
{
    size_t p = (size_t)part->form->degree, room = (p + 1) * (size_t)part->form->width;
    struct slopes slopes = {0};

    for (size_t i = 0; i < 2 * p; i++) {
        size_t j = part->span + 1 + i;
        if (j <= p || j >= part->poles)
            continue;
        slopes.unknown[slopes.n] = s->knot[j];
        slopes.c[slopes.n++] = &part->form->slope[(part->span * 2 * p + i) * room];
    }
    return slopes;
}

/* Elements of a pole with the knots. */
static void add_pole_knots(struct knots_step *s, const struct part *part, size_t i, const double *t,
                           const struct slopes *slopes)
{
    int width = part->form->width, order = part->form->degree + 1;
    size_t first = s->pole[part->span + i];

    for (int q = 0; q < slopes->n; q++) {
        double sum[RESIDUAL_WIDTH] = {0};
        for (int l = 0; l < order; l++)
            for (int v = 0; v < width; v++)
                sum[v] += dot_product(width, &t[(l * width + v) * width], &slopes->c[q][l * width]);
        for (int v = 0; v < width; v++)
            add_element(&s->normal, first + (size_t)v, slopes->unknown[q], sum[v]);
    }
}

static void add_knots(struct knots_step *s, const struct part *part, const struct slopes *slopes)
{
    int degree = part->form->degree, width = part->form->width, room = (degree + 1) * width;
    double y[ORDER * RESIDUAL_WIDTH];

    for (int q = 0; q < slopes->n; q++) {
        span_moments_times(part->moments, degree, width, slopes->c[q], y);
        for (int r = 0; r <= q; r++)
            add_element(&s->normal, slopes->unknown[q], slopes->unknown[r],
                        dot_product(room, slopes->c[r], y));
        s->right[slopes->unknown[q]] -=
            dot_product(room, slopes->c[q], span_moments_right(part->moments, degree, width));
    }
}

static void add_span(struct knots_step *s, const struct part *part)
{
    int degree = part->form->degree, width = part->form->width;
    size_t order = (size_t)degree + 1;
    struct slopes slopes = span_slopes(s, part);
    const double *right = span_moments_right(part->moments, degree, width);
    double t[ORDER * RESIDUAL_WIDTH * RESIDUAL_WIDTH];

    for (size_t i = 0; i < order; i++) {
        const double *basis = &part->form->basis[(part->span * order + i) * order];
        if (!is_inner(part, i))
            continue;
        span_moments_of_basis(part->moments, degree, width, basis, t);
        add_poles(s, part, i, t);
        add_pole_knots(s, part, i, t, &slopes);
        for (size_t k = 0; k < order; k++)
            for (size_t v = 0; v < (size_t)width; v++)
                s->right[s->pole[part->span + i] + v] -= basis[k] * right[k * (size_t)width + v];
    }
    add_knots(s, part, &slopes);
}

/* A pole is damped by the mean of its diagonal elements: none of them may be near zero. */
static void set_damping_scale(struct knots_step *s, const struct ppform *form, size_t poles)
{
    size_t width = (size_t)form->width;

    for (size_t i = 0; i < s->unknowns; i++)
        s->scale[i] = *band_at(&s->normal, i, i);
    for (size_t i = 1; i + 1 < poles; i++)
        for (size_t w = 0; w < width; w += 3) {
            double *scale = &s->scale[s->pole[i] + w], mean = (scale[0] + scale[1] + scale[2]) / 3;
            scale[0] = scale[1] = scale[2] = mean;
        }
}

static void clear_equations(struct knots_step *s)
{
    memset(s->normal.item, 0, s->unknowns * (s->normal.width + 1) * sizeof(double));
    memset(s->right, 0, s->unknowns * sizeof(double));
}

void knots_step_equations(struct knots_step *s, const struct ppform *form,
                          const struct reference *places, const struct footpoints *feet, int power)
{
    size_t poles = form->spans + (size_t)form->degree;
    size_t size = span_moments_size(form->degree, form->width);

    clear_equations(s);
    sum_moments(s, form, places, feet, power);
    for (size_t span = 0; span < form->spans; span++) {
        struct part part = {form, &s->moments[span * size], span, poles};
        add_span(s, &part);
    }
    set_damping_scale(s, form, poles);
}

static bool solve_damped(struct knots_step *s, double damping)
{
    memcpy(s->factor.item, s->normal.item, s->unknowns * (s->normal.width + 1) * sizeof(double));
    for (size_t i = 0; i < s->unknowns; i++)
        *band_at(&s->factor, i, i) += damping * s->scale[i];
    if (!band_factor(&s->factor))
        return false;
    memcpy(s->step, s->right, s->unknowns * sizeof(double));
    band_solve(&s->factor, s->step, 1);
    return true;
}

static struct vec3 moved_point(struct vec3 p, const double *step)
{
    return vec_add(p, vec(step[0], step[1], step[2]));
}

bool knots_step_move(struct knots_step *s, double damping, double nearest,
                     const struct bspline *from, struct bspline *to)
{
    size_t p = (size_t)from->degree;

    if (!solve_damped(s, damping))
        return false;
    for (size_t j = p + 1; j < from->poles; j++) {
        double before = from->knot[j] - from->knot[j - 1],
               after = from->knot[j + 1] - from->knot[j];
        double step = s->step[s->knot[j]];
        if (!isfinite(step))
            return false;
        step = fmin(step, after > nearest ? APPROACH * after : 0);
        step = fmax(step, before > nearest ? -APPROACH * before : 0);
        to->knot[j] = from->knot[j] + step;
    }
    for (size_t i = 1; i + 1 < from->poles; i++) {
        to->pole[i] = moved_point(from->pole[i], &s->step[s->pole[i]]);
        if (from->head != NULL)
            to->head[i] = moved_point(from->head[i], &s->step[s->pole[i] + 3]);
    }
    return true;
}

/* ---- p-norms rising from 2 to 64 */

enum { POWER_MAX = 64, TRIES = 6, AHEAD = 100 };
static const double SETTLED = 0.002; /* a step that gains less than this is the last of its power */
static const double NEAREST = 0.02;  /* knots, in parts of the mean span */

struct minimax {
    const struct reference *places;
    struct candidate *best;
    struct candidate trial;
    struct ppform form;
    struct knots_step step;
    double nearest, damping;
    int patience;
    double *effort;
};

bool candidate_new(const struct reference *places, const struct deviation *within,
                   const struct bspline *form, const double *knot, const double *u,
                   struct candidate *candidate)
{
    candidate->curve = bspline_new(form->degree, form->poles, places->turns);
    candidate->curve.length = HEAD_LENGTH;
    candidate->feet = footpoints_new(places, within);
    memcpy(candidate->curve.knot, knot, (form->poles + (size_t)form->degree + 1) * sizeof *knot);
    memcpy(candidate->feet.u, u, places->n * sizeof *u);
    struct vec3 *head = NULL;
    if (places->turns) {
        memcpy(candidate->feet.v, u, places->n * sizeof *u);
        head = spline_heads(places);
    }
    bool done = lsq_fit(&candidate->curve, u, places->point, head, places->n);
    free(head);
    return done;
}

void candidate_free(struct candidate *candidate)
{
    bspline_free(&candidate->curve);
    footpoints_free(&candidate->feet);
}

/* The mean of the distances by the norm, in parts of `reference`: (mean of r^power)^(1 / power). */
static double power_mean(const struct reference *places, const struct footpoints *feet, int power,
                         double reference)
{
    size_t n = places->n * footpoints_kinds(places);
    double sum = 0;

    for (size_t i = 0; i < n; i++) {
        double r = feet->off[i] / reference;
        for (int k = 1; k < power; k *= 2)
            r *= r;
        sum += r;
    }
    sum /= (double)n;
    for (int k = 1; k < power; k *= 2)
        sum = sqrt(sum);
    return sum;
}

static void swap_candidates(struct candidate *a, struct candidate *b)
{
    struct candidate c = *a;
    *a = *b;
    *b = c;
}

struct candidate candidate_copy(const struct candidate *a, const struct reference *places)
{
    struct candidate copy = {bspline_copy(&a->curve), footpoints_new(places, &a->feet.within)};

    footpoints_copy(&copy.feet, &a->feet, places);
    return copy;
}

/* Values at the places `from`, interpolated linearly at the places `to`. */
static void interpolate(const struct reference *from, const double *value,
                        const struct reference *to, double *v)
{
    size_t at = 0;

    for (size_t k = 0; k < to->n; k++) {
        while (at + 2 < from->n && from->length[at + 1] < to->length[k])
            at++;
        double part =
            (to->length[k] - from->length[at]) / (from->length[at + 1] - from->length[at]);
        v[k] = value[at] + part * (value[at + 1] - value[at]);
    }
}

struct candidate candidate_onto(const struct candidate *a, const struct reference *from,
                                const struct reference *to)
{
    struct candidate moved = {bspline_copy(&a->curve), footpoints_new(to, &a->feet.within)};
    double where = from->length[a->feet.where];

    moved.feet.worst = a->feet.worst;
    while (moved.feet.where + 1 < to->n && to->length[moved.feet.where] < where)
        moved.feet.where++;

    interpolate(from, a->feet.u, to, moved.feet.u);
    if (to->turns)
        interpolate(from, a->feet.v, to, moved.feet.v);
    return moved;
}

/* One step that makes the mean smaller, with as much damping as it takes.  Returns what part of it
 * was gained, 0: none could be found. */
static double take_step(struct minimax *w, int power)
{
    double reference = w->best->feet.worst;
    double before = power_mean(w->places, &w->best->feet, power, reference);

    ppform_curve(&w->form, &w->best->curve);
    ppform_slopes(&w->form, &w->best->curve);
    knots_step_equations(&w->step, &w->form, w->places, &w->best->feet, power);
    for (int i = 0; i < TRIES; i++, w->damping *= 8) {
        if (!knots_step_move(&w->step, w->damping, w->nearest, &w->best->curve, &w->trial.curve))
            continue;
        ppform_curve(&w->form, &w->trial.curve);
        footpoints_copy(&w->trial.feet, &w->best->feet, w->places);
        footpoints_follow(&w->form, w->places, &w->trial.feet);
        *w->effort -= (double)(w->places->n * footpoints_kinds(w->places));
        double after = power_mean(w->places, &w->trial.feet, power, reference);
        if (!(after < before))
            continue;
        if (i == 0)
            w->damping = fmax(w->damping / 4, 1e-7);
        swap_candidates(w->best, &w->trial);
        return 1 - after / before;
    }
    w->damping = 1e-3;
    return 0;
}

/* True when the mean would stay above the goal even if the next steps gained as much as the last.
 */
static bool is_out_of_reach(double mean, double gain, double goal, int patience)
{
    for (int i = 0; i < AHEAD * patience && mean > goal; i++)
        mean *= 1 - gain;
    return mean > goal;
}

static bool raise_powers(struct minimax *w, double goal)
{
    const struct footpoints *feet = &w->best->feet;

    for (int power = 2; power <= POWER_MAX; power *= 2) {
        int most = w->patience * (power == 2 || power == POWER_MAX ? 40 : 20);
        double settled = (power == 2 ? SETTLED / 4 : SETTLED) / w->patience;
        double gain = 1;
        for (int i = 0; i < most && gain > settled; i++) {
            if (feet->worst <= goal)
                return true;
            gain = take_step(w, power);
            if (*w->effort < 0 ||
                is_out_of_reach(power_mean(w->places, feet, power, 1), gain, goal, w->patience))
                return false;
        }
        if (!(feet->worst > goal))
            return feet->worst <= goal;
    }
    return false;
}

bool minimax_fit(const struct reference *places, double goal, int patience,
                 struct candidate *candidate, double *effort)
{
    struct minimax w = {.places = places,
                        .best = candidate,
                        .damping = 1e-3,
                        .patience = patience,
                        .effort = effort};

    w.form = ppform_new(&candidate->curve);
    ppform_curve(&w.form, &candidate->curve);
    footpoints_follow(&w.form, places, &candidate->feet);
    w.trial = candidate_copy(candidate, places);
    w.step = knots_step_new(&candidate->curve);
    w.nearest = NEAREST * places->length[places->n - 1] / (double)w.form.spans;
    bool reached = raise_powers(&w, goal);
    knots_step_free(&w.step);
    candidate_free(&w.trial);
    ppform_free(&w.form);
    return reached;
}
