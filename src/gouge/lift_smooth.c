/* lift_smooth - see lift_smooth.h. */
#include "gouge/lift_smooth.h"

#include <stdlib.h>

#include "lift_place.h"
#include "smooth_up.h"

static const double CHORD =
    0.1; /* of the tolerance: what straight lines between points leave out */

static const double CLEAR = 2e-6;  /* mm: as deep is a ball that is clear */
static const double ALIKE = 0.7;   /* cosine: neighbours touch the same surface */
static const double BEND = 0.996;  /* cosine: normals of points that one line serves */
static const double LONGEST = 0.4; /* of the radius: what one line serves */

/* ---- points at even distances */

/* The points follow each other on one surface. */
static bool follow(const struct run_point *a, const struct run_point *b, double radius)
{
    return run_point_touches(a) && run_point_touches(b) && !a->straight &&
           vec_dot(a->normal, b->normal) > ALIKE && vec_distance(a->ball, b->ball) < radius;
}

/* Where a piece that begins at a point ends: the first that does not follow. */
static size_t piece_end(const struct run *run, size_t from, size_t end)
{
    size_t to = from + 1;

    while (to < end && follow(&run->item[to - 1], &run->item[to], run->radius))
        to++;
    return to;
}

static double spacing_of(const struct gouge_lift_options *rule)
{
    return fmax(rule->step, sqrt(rule->tolerance * rule->offset));
}

/* A place between two points: on the smooth curve if the ball is nearly clear there, else on the
 * straight line, which was looked at; and out of what it is in yet, where it takes no more than the
 * tolerance to come out: along the flank of a spike it may take a millimetre. */
static struct run_point between(const struct run_point *a, const struct vec3 *tangent, double s,
                                const struct gouge_lift_options *rule, double radius)
{
    const struct run_point *b = a + 1;
    struct run_point p = {.contact = vec_mix(a->contact, b->contact, s),
                          .normal = vec_unit(vec_mix(a->normal, b->normal, s))};
    double length = vec_distance(a->ball, b->ball), by = length * s * (1 - s);
    struct vec3 line = vec_mix(a->ball, b->ball, s), chord = vec_sub(b->ball, a->ball);
    struct vec3 bow = vec_sub(vec_scale(by * (1 - s), tangent[0]), vec_scale(by * s, tangent[1]));
    struct vec3 curve = vec_add(vec_along(line, -s * (1 - s) * (1 - 2 * s), chord), bow);
    double lift =
        gouge_least_lift(rule->guard, curve, p.normal, rule->offset, rule->tolerance / 2, NULL);

    if (lift < 0) {
        curve = line;
        lift = gouge_least_lift(rule->guard, line, p.normal, rule->offset, rule->tolerance, NULL);
    }
    lift_place_along(&p, vec_along(curve, fmax(lift, 0), p.normal), rule, radius);
    return p;
}

static bool is_clear(const struct run_point *p, size_t n, const struct gouge_lift_options *rule)
{
    for (size_t i = 1; i < n; i++)
        if (!lift_line_clear(&p[i - 1], &p[i], rule))
            return false;
    return true;
}

/* Appends the points of a piece, at even distances along it; as they were, where the way between
 * these is not clear. */
static void spread_piece(const struct run_point *p, size_t n, const struct gouge_lift_options *rule,
                         struct run *to)
{
    struct run piece = {.n = n, .item = (struct run_point *)p, .radius = to->radius};
    struct vec3 *tangent = mem_alloc(n + 1, sizeof *tangent);
    double length = 0, before = 0;
    size_t first = to->n;

    run_tangents(&piece, false, tangent);
    for (size_t i = 1; i < n; i++)
        length += vec_distance(p[i - 1].ball, p[i].ball);
    size_t parts = n > 2 ? (size_t)ceil(length / spacing_of(rule)) : 0, k = 0;
    if (parts < 3)
        parts = 0;
    for (size_t i = 0; i < (parts > 0 ? 1 : n); i++)
        *array_push(to) = p[i];
    for (size_t i = 1; i < parts; i++) {
        double at = length * (double)i / (double)parts, step;
        while ((step = vec_distance(p[k].ball, p[k + 1].ball)) + before < at && k + 2 < n) {
            before += step;
            k++;
        }
        double s = step > 0 ? fmin((at - before) / step, 1) : 0;
        *array_push(to) = between(&p[k], &tangent[k], s, rule, to->radius);
    }
    if (parts > 0)
        *array_push(to) = p[n - 1];
    if (parts > 0 && !is_clear(to->item + first, to->n - first, rule)) {
        to->n = first;
        for (size_t i = 0; i < n; i++)
            *array_push(to) = p[i];
    }
    free(tangent);
}

void lift_smooth_spread(struct lifted_strip *strip, const struct gouge_lift_options *rule)
{
    struct run even = {.radius = strip->run.radius};

    for (size_t k = 0, from = 0; k < strip->end.n; k++) {
        size_t end = strip->end.item[k];
        for (size_t to; from < end; from = to) {
            to = piece_end(&strip->run, from, end);
            spread_piece(strip->run.item + from, to - from, rule, &even);
        }
        strip->end.item[k] = even.n;
    }
    array_free(&strip->run);
    strip->run = even;
}

/* ---- raised */

struct raise {
    struct run_point *p;
    const double *room;
    size_t n;
    const struct gouge_lift_options *rule;
    double radius;
};

/* Square to the way, on the side of what is touched. */
static struct vec3 up_at(const struct raise *r, size_t i)
{
    struct vec3 way = vec_sub(r->p[i + 1].ball, r->p[i - 1].ball);
    struct vec3 up = vec_unit(vec_reject(r->p[i].normal, vec_unit(way)));

    return vec_length(up) > 0 ? up : r->p[i].normal;
}

/* The points where they would be; false: the way between them is not clear. */
static bool move_points(const struct raise *r, const struct vec3 *up, const double *rise)
{
    const struct gouge_check *guard = r->rule->guard;
    bool clear = true;

    for (size_t i = 1; i + 1 < r->n; i++) {
        struct vec3 was = r->p[i].ball, now = vec_along(was, rise[i], up[i]);
        if (!gouge_clear_along(guard, now, now, r->rule->offset, CLEAR))
            now = was;
        lift_place_along(&r->p[i], now, r->rule, r->radius);
    }
    for (size_t i = 1; i < r->n && clear; i++)
        clear = lift_line_clear(&r->p[i - 1], &r->p[i], r->rule);
    return clear;
}

static void raise_piece(const struct raise *r)
{
    struct vec3 *point = mem_alloc(r->n, sizeof *point), *up = mem_alloc(r->n, sizeof *up);
    double *most = mem_alloc(r->n, sizeof *most), *rise = mem_alloc(r->n, sizeof *rise);
    struct run_point *was = mem_alloc(r->n, sizeof *was);

    for (size_t i = 0; i < r->n; i++) {
        was[i] = r->p[i];
        point[i] = r->p[i].ball;
        bool end = i == 0 || i + 1 == r->n;
        up[i] = end ? r->p[i].normal : up_at(r, i);
        most[i] = end ? 0 : r->room[i];
    }
    smooth_up(point, up, most, r->rule->offset / 2, r->n, rise);
    if (!move_points(r, up, rise))
        for (size_t i = 0; i < r->n; i++)
            r->p[i] = was[i];
    free(was);
    free(rise);
    free(most);
    free(up);
    free(point);
}

/* ---- as few points as straight lines need */

/* One line serves for what is between two points of a piece. */
static bool serves(const struct run_point *p, size_t from, size_t to, double chord, double longest)
{
    if (vec_distance(p[from].ball, p[to].ball) > longest ||
        vec_dot(p[from].normal, p[to].normal) < BEND)
        return false;
    for (size_t i = from + 1; i < to; i++)
        if (vec_line_distance(p[from].ball, p[to].ball, p[i].ball) > chord ||
            vec_line_distance(p[from].tip, p[to].tip, p[i].tip) > chord)
            return false;
    return true;
}

static void thin_piece(const struct run_point *p, size_t n, const struct gouge_lift_options *rule,
                       struct run *to)
{
    double chord = CHORD * rule->tolerance, longest = LONGEST * rule->offset;

    for (size_t i = 0, next; i < n; i = next) {
        *array_push(to) = p[i];
        next = i + 1;
        while (next + 1 < n && serves(p, i, next + 1, chord, longest) &&
               lift_line_clear(&p[i], &p[next + 1], rule))
            next++;
    }
}

void lift_smooth_raise(struct lifted_strip *strip, const struct gouge_lift_options *rule,
                       const double *room)
{
    struct run thin = {.radius = strip->run.radius};

    for (size_t k = 0, from = 0; k < strip->end.n; k++) {
        size_t end = strip->end.item[k];
        for (size_t to; from < end; from = to) {
            to = piece_end(&strip->run, from, end);
            struct raise r = {strip->run.item + from, room + from, to - from, rule, thin.radius};
            if (r.n > 2)
                raise_piece(&r);
            thin_piece(r.p, r.n, rule, &thin);
        }
        strip->end.item[k] = thin.n;
    }
    array_free(&strip->run);
    strip->run = thin;
}
