#include "course.h"

#include <stdio.h>
#include <stdlib.h>

static struct vec3 turn_x(struct vec3 v, double degrees)
{
    double c = cos(RADIANS(degrees)), s = sin(RADIANS(degrees));
    return vec(v.x, c * v.y - s * v.z, s * v.y + c * v.z);
}

static struct vec3 turn_y(struct vec3 v, double degrees)
{
    double c = cos(RADIANS(degrees)), s = sin(RADIANS(degrees));
    return vec(c * v.x + s * v.z, v.y, c * v.z - s * v.x);
}

static struct vec3 turn_z(struct vec3 v, double degrees)
{
    double c = cos(RADIANS(degrees)), s = sin(RADIANS(degrees));
    return vec(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
}

struct vec3 rotary_axis(enum rotary rotary, double master, double slave)
{
    double m = RADIANS(master), c = RADIANS(slave);
    if (rotary == ROTARY_AC)
        return vec(sin(c) * sin(m), -cos(c) * sin(m), cos(m));
    return vec(sin(m) * cos(c), sin(m) * sin(c), cos(m));
}

struct vec3 rotary_work(enum rotary rotary, double master, double slave, struct vec3 machine)
{
    struct vec3 v = rotary == ROTARY_AC ? turn_x(machine, master) : turn_y(machine, master);
    return turn_z(v, slave);
}

void course_free(struct course *m)
{
    for (size_t i = 0; i < m->spline.n; i++) {
        free(m->spline.item[i].knot);
        free(m->spline.item[i].p);
        free(m->spline.item[i].q);
        free(m->spline.item[i].weight);
    }
    array_free(&m->spline);
    array_free(&m->piece);
}

/* Last knot index whose span holds u. */
static size_t span_of(const struct nurbs *b, double u)
{
    size_t i = b->n - 1;
    while (i > (size_t)b->order - 1 && b->knot[i] > u)
        i--;
    while (i > (size_t)b->order - 1 && !(b->knot[i] < b->knot[i + 1]))
        i--;
    return i;
}

/* Both channels at u of the span that begins at knot `span`: de Boor's scheme on weighted poles. */
static void spline_at(const struct nurbs *b, size_t span, double u, struct vec3 *p, struct vec3 *q)
{
    struct vec3 dp[16], dq[16];
    double w[16];
    size_t k = (size_t)b->order, first = span + 1 - k;
    for (size_t i = 0; i < k; i++) {
        w[i] = b->weight ? b->weight[first + i] : 1;
        dp[i] = vec_scale(w[i], b->p[first + i]);
        dq[i] = b->q ? vec_scale(w[i], b->q[first + i]) : vec(0, 0, 0);
    }
    for (size_t level = 1; level < k; level++)
        for (size_t i = k - 1; i >= level; i--) {
            double from = b->knot[first + i], to = b->knot[first + i + k - level];
            double s = (u - from) / (to - from);
            w[i] = w[i - 1] + s * (w[i] - w[i - 1]);
            dp[i] = vec_mix(dp[i - 1], dp[i], s);
            dq[i] = vec_mix(dq[i - 1], dq[i], s);
        }
    *p = vec_scale(1 / w[k - 1], dp[k - 1]);
    if (b->q)
        *q = vec_scale(1 / w[k - 1], dq[k - 1]);
}

static struct vec3 arc_at(const struct piece *piece, double s)
{
    struct vec3 from = vec_sub(piece->p[0], piece->centre), to = vec_sub(piece->p[1], piece->centre);
    double rise0 = vec_dot(from, piece->normal), rise1 = vec_dot(to, piece->normal);
    struct vec3 r0 = vec_reject(from, piece->normal);
    double l0 = vec_length(r0), l1 = vec_length(vec_reject(to, piece->normal));
    double c = cos(s * piece->angle), w = sin(s * piece->angle);
    struct vec3 r = vec_add(vec_scale(c, r0), vec_scale(w, vec_cross(piece->normal, r0)));
    r = vec_scale((l0 + s * (l1 - l0)) / l0, r);
    return vec_along(vec_add(piece->centre, r), rise0 + s * (rise1 - rise0), piece->normal);
}

static struct vec3 cubic_at(struct vec3 from, const struct vec3 c[3], double s)
{
    return vec_along(from, s, vec_along(c[0], s, vec_along(c[1], s, c[2])));
}

/* On the great circle, in proportion; opposite axes have none and stay at the start. */
static struct vec3 great_circle(struct vec3 a, struct vec3 b, double s)
{
    double angle = vec_angle(a, b);
    struct vec3 side = vec_unit(vec_reject(b, a));
    return vec_add(vec_scale(cos(s * angle), a), vec_scale(sin(s * angle), side));
}

struct pose course_at(const struct course *m, const struct piece *piece, double s)
{
    struct vec3 p = vec_mix(piece->p[0], piece->p[1], s);
    struct vec3 q = vec_mix(piece->q[0], piece->q[1], s);
    if (piece->swing == SWING_GREAT)
        q = great_circle(piece->q[0], piece->q[1], s);
    if (piece->shape == SHAPE_ARC) {
        p = arc_at(piece, s);
    } else if (piece->shape == SHAPE_CUBIC) {
        p = cubic_at(piece->p[0], piece->pc, s);
        if (piece->q_cubic)
            q = cubic_at(piece->q[0], piece->qc, s);
    } else if (piece->shape == SHAPE_SPLINE) {
        const struct nurbs *b = &m->spline.item[piece->spline];
        double middle = (piece->u[0] + piece->u[1]) / 2;
        spline_at(b, span_of(b, middle), piece->u[0] + s * (piece->u[1] - piece->u[0]), &p, &q);
    }
    if (piece->swing == SWING_GREAT)
        return (struct pose){p, q};
    if (piece->swing == SWING_HEAD)
        return (struct pose){p, vec_unit(vec_sub(q, p))};
    if (piece->table)
        p = rotary_work(m->rotary, q.x, q.y, p);
    return (struct pose){p, rotary_axis(m->rotary, q.x, q.y)};
}

void course_add_spline(struct course *m, struct nurbs spline, const struct piece *as)
{
    *array_push(&m->spline) = spline;
    m->curves++;
    m->poles += spline.n;
    for (size_t i = (size_t)spline.order - 1; i < spline.n; i++) {
        if (!(spline.knot[i] < spline.knot[i + 1]))
            continue;
        struct piece *piece = array_push(&m->piece);
        *piece = *as;
        piece->shape = SHAPE_SPLINE;
        piece->spline = m->spline.n - 1;
        piece->u[0] = spline.knot[i];
        piece->u[1] = spline.knot[i + 1];
        piece->touches = as->touches && i + 1 == spline.n;
    }
}

void course_place(const struct piece *piece, char *text, size_t size)
{
    if (piece->block >= 0)
        snprintf(text, size, "N%ld (line %zu)", piece->block, piece->line);
    else
        snprintf(text, size, "line %zu", piece->line);
}
