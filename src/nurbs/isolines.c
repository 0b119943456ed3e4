/* isolines - see isolines.h. */
#include "isolines.h"

#include <stdlib.h>

/* Samples in one direction, and the most cells that a tolerance may ask for. */
enum { ACROSS = 24, ALONG = 96, CELLS_MAX = 1000000 };

/* The breaks and both ends of the range. */
static void break_lines(const struct nurbs_axis *a, struct doubles *at)
{
    size_t n = nurbs_axis_breaks(a, NULL, 0);
    array_reserve(at, n + 2);
    at->n = 0;
    at->item[at->n++] = a->from;
    nurbs_axis_breaks(a, at->item + 1, n);
    at->n += n;
    /* lines that are hardly apart make cells without area */
    double least = 1e-6 * (a->to - a->from);
    size_t kept = 1;
    for (size_t i = 1; i < at->n; i++)
        if (at->item[i] - at->item[kept - 1] > least && a->to - at->item[i] > least)
            at->item[kept++] = at->item[i];
    at->item[kept++] = a->to;
    at->n = kept;
}

void isolines_equal(const struct nurbs_axis *axis, int n, struct doubles *line)
{
    struct doubles at = {0};
    break_lines(axis, &at);
    line->n = 0;
    for (size_t i = 0; i + 1 < at.n; i++) {
        double from = at.item[i], width = at.item[i + 1] - from;
        double cells = fmax(1, floor(n * width / (axis->to - axis->from) + 0.5));
        for (double k = 0; k < cells; k++)
            *array_push(line) = from + width * (k / cells);
    }
    *array_push(line) = axis->to;
    array_free(&at);
}

/* The surface with u and v exchanged where `flip` is set, so that one function does both.
 * `border`: the line along bounds the patch, and its bend within the surface counts too. */
static double bend_at(const struct nurbs *s, bool flip, double along, double across, bool border)
{
    struct vec3 d[3][3];
    struct uv at = flip ? (struct uv){across, along} : (struct uv){along, across};
    nurbs_derivatives(s, at, 2, d);
    struct vec3 n = nurbs_normal(s, at, d);
    struct vec3 second = flip ? d[0][2] : d[2][0], first = vec_unit(flip ? d[0][1] : d[1][0]);
    double straight = fabs(vec_dot(second, n));
    double twist = fabs(vec_dot(d[1][1], n));
    const struct nurbs_axis *u = flip ? &s->v : &s->u, *v = flip ? &s->u : &s->v;
    /* twist counts as if both ranges had as many cells */
    straight += twist * (v->to - v->from) / (u->to - u->from);
    /* h^2 bend / 8 <= tolerance there, twice what lines_of asks for */
    return border ? fmax(straight, vec_length(vec_reject(second, first)) / 2) : straight;
}

/* The root of the largest bend across, at ALONG places of each interval between two breaks. */
static void measure_roots(const struct nurbs *s, bool flip, const bool border[2],
                          struct doubles *at, struct doubles *root)
{
    const struct nurbs_axis *other = flip ? &s->u : &s->v;
    break_lines(flip ? &s->v : &s->u, at);
    root->n = 0;
    array_reserve(root, (at->n - 1) * ALONG);
    for (size_t b = 0; b + 1 < at->n; b++)
        for (int i = 0; i < ALONG; i++) {
            double from = at->item[b], to = at->item[b + 1];
            double most = 0, x = from + (to - from) * (i + 0.5) / ALONG;
            for (int k = 0; k <= ACROSS; k++) {
                double y = other->from + (other->to - other->from) * k / ACROSS;
                bool bounds = (k == 0 && border[0]) || (k == ACROSS && border[1]);
                most = fmax(most, bend_at(s, flip, x, y, bounds));
            }
            root->item[root->n++] = sqrt(most);
        }
}

/* Lines between two breaks: equal shares of the integral of the root of the bend. */
static void lines_between(const double *root, double from, double to, double factor,
                          struct doubles *line)
{
    double sum[ALONG + 1] = {0};
    for (int i = 0; i < ALONG; i++)
        sum[i + 1] = sum[i] + root[i] * (to - from) / ALONG * factor;
    double cells = fmin(fmax(1, ceil(sum[ALONG])), CELLS_MAX);
    *array_push(line) = from;
    for (int i = 0, k = 1; k < cells; k++) {
        double want = sum[ALONG] * k / cells;
        while (i + 1 < ALONG && sum[i + 1] < want)
            i++;
        double part = sum[i + 1] > sum[i] ? (want - sum[i]) / (sum[i + 1] - sum[i]) : 0.5;
        *array_push(line) = from + (to - from) * (i + fmin(fmax(part, 0), 1)) / ALONG;
    }
}

static void lines_of(const struct doubles *at, const struct doubles *root, double factor,
                     struct doubles *line)
{
    line->n = 0;
    for (size_t i = 0; i + 1 < at->n; i++)
        lines_between(root->item + i * ALONG, at->item[i], at->item[i + 1], factor, line);
    *array_push(line) = at->item[at->n - 1];
}

void isolines_measure(const struct nurbs *s, const struct isolines_border *border,
                      struct isolines_bend *bend)
{
    measure_roots(s, false, border->v, &bend->at_u, &bend->root_u);
    measure_roots(s, true, border->u, &bend->at_v, &bend->root_v);
}

void isolines_bent(const struct isolines_bend *bend, double tolerance, double finer,
                   struct doubles *u, struct doubles *v)
{
    /* h^2 bend / 8 <= tolerance / 2 in each direction */
    double factor = finer / sqrt(4 * tolerance);
    lines_of(&bend->at_u, &bend->root_u, factor, u);
    lines_of(&bend->at_v, &bend->root_v, factor, v);
}

void isolines_bend_free(struct isolines_bend *bend)
{
    array_free(&bend->at_u);
    array_free(&bend->root_u);
    array_free(&bend->at_v);
    array_free(&bend->root_v);
}
