/*
 * knotstep - banded normal equations by the moments of each span.
 *
 * In a span everything that acts is a polynomial in s: the derivative of the curve by an unknown is
 * sum_k c_k s^k.  So the places of a span need not be taken one by one: with the moments
 * S_m = sum s^m W over them, element (i, j) is  sum_kl c_ik' S_(k+l) c_jl.
 */
#include "knotstep.h"

#include <stdlib.h>
#include <string.h>

#include "array.h"

enum {
    ORDER = BSPLINE_DEGREE_MAX + 1,
    WIDTH = 6,
    COLUMNS = ORDER * WIDTH + 2 * BSPLINE_DEGREE_MAX
};

static const double APPROACH = 0.4; /* of the way to its neighbour, at most, for a knot in a step */

/* W and g of the quadratic form  x' W x / 2 + g' x  that one place adds, x a movement of point and
 * head there. */
struct form {
    double w[WIDTH][WIDTH], g[WIDTH];
};

struct moments {
    double w[2 * ORDER][WIDTH][WIDTH], g[ORDER][WIDTH];
};

struct knotstep knotstep_new(const struct bspline *curve)
{
    struct knotstep s = {0};
    size_t p = (size_t)curve->degree, width = curve->head != NULL ? 6 : 3, at = 0;
    size_t early = (p + 1) / 2; /* a knot stands among the poles behind the one in its middle */

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
    size_t band = 2 * p * (width + 1);
    s.normal = band_new(at, band < at ? band : at - 1);
    s.factor = band_new(at, s.normal.width);
    s.right = mem_alloc(at, sizeof *s.right);
    s.step = mem_alloc(at, sizeof *s.step);
    s.scale = mem_alloc(at, sizeof *s.scale);
    return s;
}

void knotstep_free(struct knotstep *s)
{
    free(s->pole);
    free(s->knot);
    band_free(&s->normal);
    band_free(&s->factor);
    free(s->right);
    free(s->step);
    free(s->scale);
    *s = (struct knotstep){0};
}

/* r^(power / 2 - 1), the weight of a place whose square is r times the largest. */
static double weight_of(double r, int power)
{
    double w = 1;

    for (int k = power / 2 - 1; k > 0; k /= 2, r *= r)
        if (k % 2 == 1)
            w *= r;
    return w;
}

/* weight (I - tt' + (power - 2) dd') for the distance `off`, perpendicular to the speed. */
static void norm_form(struct vec3 off, struct vec3 speed, double weight, int power, double w[3][3],
                      double g[3])
{
    struct vec3 t = vec_unit(speed), d;

    off = vec_reject(off, t);
    d = vec_unit(off);
    double tv[3] = {t.x, t.y, t.z}, dv[3] = {d.x, d.y, d.z}, o[3] = {off.x, off.y, off.z};
    for (int i = 0; i < 3; i++) {
        g[i] = weight * o[i];
        for (int j = 0; j < 3; j++)
            w[i][j] = weight * ((i == j) - tv[i] * tv[j] + (power - 2) * dv[i] * dv[j]);
    }
}

/* Adds the form of a movement A x_point + B x_head, B = part (I - aa'), A = whole I - B. */
static void add_turned(struct form *f, double w[3][3], const double g[3], double whole, double part,
                       struct vec3 axis)
{
    double a[3] = {axis.x, axis.y, axis.z}, m[3][WIDTH];

    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            double b = part * ((i == j) - a[i] * a[j]);
            m[i][j] = whole * (i == j) - b;
            m[i][j + 3] = b;
        }
    for (int i = 0; i < WIDTH; i++)
        for (int k = 0; k < 3; k++) {
            double mw = m[0][i] * w[0][k] + m[1][i] * w[1][k] + m[2][i] * w[2][k];
            for (int j = 0; j < WIDTH; j++)
                f->w[i][j] += mw * m[k][j];
            f->g[i] += m[k][i] * g[k];
        }
}

static double weight_at(const struct feet *feet, size_t i, int power)
{
    double r = feet->off[i] / feet->worst;
    return weight_of(r * r, power);
}

/* Nothing else holds the head at its distance: a little. */
static void add_length(struct form *f, const struct stance *s)
{
    static const double hold = 1e-6;
    double a[3] = {s->axis.x, s->axis.y, s->axis.z};
    double off = vec_length(s->reach) - TRACK_LENGTH;

    for (int i = 0; i < 3; i++) {
        f->g[i] -= hold * off * a[i];
        f->g[i + 3] += hold * off * a[i];
        for (int j = 0; j < 3; j++) {
            double w = hold * a[i] * a[j];
            f->w[i][j] += w;
            f->w[i + 3][j + 3] += w;
            f->w[i][j + 3] -= w;
            f->w[i + 3][j] -= w;
        }
    }
}

static void point_form(const struct target *target, const struct feet *feet, size_t k,
                       const struct stance *s, int power, struct form *f)
{
    double w[3][3], g[3];

    norm_form(vec_sub(s->point, target->point[k]), s->speed,
              weight_at(feet, k * feet_kinds(target), power), power, w, g);
    for (int i = 0; i < 3; i++) {
        f->g[i] += g[i];
        for (int j = 0; j < 3; j++)
            f->w[i][j] += w[i][j];
    }
}

static void other_form(const struct target *target, const struct feet *feet, size_t k,
                       const struct stance *s, int power, struct form *f)
{
    double w[3][3], g[3];

    norm_form(vec_sub(s->other, target->other[k]), s->other_speed,
              weight_at(feet, k * FEET_KINDS + 1, power), power, w, g);
    add_turned(f, w, g, 1, target->offset / vec_length(s->reach), s->axis);
}

static void axis_form(const struct target *target, const struct feet *feet, size_t k,
                      const struct stance *s, int power, struct form *f)
{
    double w[3][3], g[3], scale = target->tolerance / target->angle;
    struct vec3 off = vec_scale(scale, vec_sub(s->axis, target->axis[k]));

    norm_form(off, vec(0, 0, 0), weight_at(feet, k * FEET_KINDS + 2, power), power, w, g);
    add_turned(f, w, g, 0, scale / vec_length(s->reach), s->axis);
    add_length(f, s);
}

static void add_moments(struct moments *m, int degree, int width, double s, const struct form *f)
{
    double power = 1;

    for (int k = 0; k <= 2 * degree; k++) {
        for (int i = 0; i < width; i++)
            for (int j = 0; j < width; j++)
                m->w[k][i][j] += power * f->w[i][j];
        for (int i = 0; k <= degree && i < width; i++)
            m->g[k][i] += power * f->g[i];
        power *= s;
    }
}

/* The columns of a span: how point and head move with each unknown, by powers of s. */
struct columns {
    int n;
    size_t unknown[COLUMNS];
    double c[COLUMNS][ORDER][WIDTH];
};

static void span_columns(const struct knotstep *s, const struct spanform *form, size_t poles,
                         size_t span, struct columns *columns)
{
    size_t p = (size_t)form->degree, order = p + 1, width = (size_t)form->width;

    columns->n = 0;
    for (size_t i = span == 0 ? 1 : 0; i <= p && span + i + 1 < poles; i++)
        for (size_t w = 0; w < width; w++) {
            columns->unknown[columns->n] = s->pole[span + i] + w;
            double(*c)[WIDTH] = columns->c[columns->n++];
            for (size_t k = 0; k <= p; k++) {
                memset(c[k], 0, sizeof c[k]);
                c[k][w] = form->basis[(span * order + i) * order + k];
            }
        }
    for (size_t i = 0; i < 2 * p; i++) {
        size_t j = span + 1 + i;
        if (j <= p || j >= poles)
            continue;
        columns->unknown[columns->n] = s->knot[j];
        double(*c)[WIDTH] = columns->c[columns->n++];
        for (size_t k = 0; k <= p; k++)
            memcpy(c[k], &form->slope[((span * 2 * p + i) * order + k) * width],
                   width * sizeof(double));
    }
}

/* y_k = sum_l S_(k+l) c_l */
static void times_moments(const struct moments *m, int degree, int width, double c[ORDER][WIDTH],
                          double y[ORDER][WIDTH])
{
    for (int k = 0; k <= degree; k++)
        for (int i = 0; i < width; i++) {
            double sum = 0;
            for (int l = 0; l <= degree; l++)
                for (int j = 0; j < width; j++)
                    sum += m->w[k + l][i][j] * c[l][j];
            y[k][i] = sum;
        }
}

static double times(int degree, int width, double a[ORDER][WIDTH], double b[ORDER][WIDTH])
{
    double sum = 0;

    for (int k = 0; k <= degree; k++)
        for (int i = 0; i < width; i++)
            sum += a[k][i] * b[k][i];
    return sum;
}

static void add_span(struct knotstep *s, const struct spanform *form, struct moments *m,
                     struct columns *columns)
{
    int degree = form->degree, width = form->width;
    double y[ORDER][WIDTH];

    for (int i = 0; i < columns->n; i++) {
        size_t row = columns->unknown[i];
        times_moments(m, degree, width, columns->c[i], y);
        s->right[row] -= times(degree, width, columns->c[i], m->g);
        for (int j = 0; j < columns->n; j++)
            if (columns->unknown[j] <= row)
                *band_at(&s->normal, row, columns->unknown[j]) +=
                    times(degree, width, columns->c[j], y);
    }
}

/* A pole is damped by the mean of its diagonal elements: none of them may be near zero. */
static void fill_scale(struct knotstep *s, const struct spanform *form, size_t poles)
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

static void clear(struct knotstep *s)
{
    memset(s->normal.item, 0, s->unknowns * (s->normal.width + 1) * sizeof(double));
    memset(s->right, 0, s->unknowns * sizeof(double));
}

void knotstep_equations(struct knotstep *s, const struct spanform *form,
                        const struct target *target, const struct feet *feet, int power)
{
    size_t poles = form->spans + (size_t)form->degree;
    struct moments *m = mem_alloc(form->spans, sizeof *m);
    struct columns *columns = mem_alloc(1, sizeof *columns);
    size_t near = 0;

    clear(s);
    for (size_t k = 1; k + 1 < target->n; k++) {
        struct stance at = stance_at(form, target, near, feet->u[k]);
        near = at.span;
        struct form f = {0};
        point_form(target, feet, k, &at, power, &f);
        if (target->axis != NULL && !target->other_leads)
            axis_form(target, feet, k, &at, power, &f);
        add_moments(&m[near], form->degree, form->width, spanform_place(form, near, feet->u[k]),
                    &f);
        if (target->axis == NULL)
            continue;
        at = stance_at(form, target, near, feet->v[k]);
        f = (struct form){0};
        other_form(target, feet, k, &at, power, &f);
        if (target->other_leads)
            axis_form(target, feet, k, &at, power, &f);
        add_moments(&m[at.span], form->degree, form->width,
                    spanform_place(form, at.span, feet->v[k]), &f);
    }
    for (size_t span = 0; span < form->spans; span++) {
        span_columns(s, form, poles, span, columns);
        add_span(s, form, &m[span], columns);
    }
    fill_scale(s, form, poles);
    free(columns);
    free(m);
}

static bool solve(struct knotstep *s, double damping)
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

static struct vec3 moved(struct vec3 p, const double *step)
{
    return vec_add(p, vec(step[0], step[1], step[2]));
}

bool knotstep_move(struct knotstep *s, double damping, double nearest, const struct bspline *from,
                   struct bspline *to)
{
    size_t p = (size_t)from->degree;

    if (!solve(s, damping))
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
        to->pole[i] = moved(from->pole[i], &s->step[s->pole[i]]);
        if (from->head != NULL)
            to->head[i] = moved(from->head[i], &s->step[s->pole[i] + 3]);
    }
    return true;
}
