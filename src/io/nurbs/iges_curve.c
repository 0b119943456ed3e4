/* iges_curve - see iges_curve.h. */
#include "iges_curve.h"

#include <stdlib.h>

#include "base/array.h"
#include "nurbs/approximate.h"
#include "nurbs/construct.h"
#include "nurbs/curve_length.h"

enum { DEPTH_MAX = 20, COUNT_MAX = 100000000 };

/* How deep curves within curves are, and how many more may be read: one that holds itself many
 * times over would never end. */
struct walk {
    int depth;
    size_t left;
    struct transform outer;     /* of the curves that this one is part of */
    struct iges_ranges *ranges; /* the file's parameters along the curves that are read, or NULL */
};

/* What a reader of one kind of curve works on. */
struct source {
    const struct iges *iges;
    const struct iges_entity *entity;
    const struct iges_values *values;
    struct transform matrix;
};

static double value_at(const struct source *s, size_t index)
{
    return index < s->values->n ? s->values->item[index].number : 0;
}

static struct nurbs_pole pole_at(const struct source *s, struct vec3 p, double w)
{
    p = transform_point(&s->matrix, p);
    return (struct nurbs_pole){w * p.x, w * p.y, w * p.z, w};
}

static int too_few_values(const struct source *s, size_t need, struct error *error)
{
    return error_at(error, s->iges->name, s->values->line,
                    "entity %d with %zu numbers, expected %zu", s->entity->type, s->values->n,
                    need);
}

int iges_matrix(const struct iges *iges, int number, size_t line, struct transform *matrix,
                struct error *error)
{
    *matrix = transform_identity();
    for (int depth = 0; number != 0; depth++) {
        const struct iges_entity *e = iges_entity(iges, number);
        struct iges_values v;
        if (!e || e->type != 124 || depth == DEPTH_MAX)
            return error_at(
                error, iges->name, line,
                "a pointer to directory entry %d as a transformation, expected an entity "
                "124",
                number);
        if (iges_values(iges, e, &v, error) < 0)
            return -1;
        struct transform t = transform_identity();
        for (size_t i = 0; i < 12; i++)
            t.m[i / 4][i % 4] = 1 + i < v.n ? v.item[1 + i].number : 0;
        size_t n = v.n, here = v.line;
        array_free(&v);
        if (n < 13)
            return error_at(error, iges->name, here, "entity 124 with %zu numbers, expected 12",
                            n - 1);
        *matrix = transform_product(t, *matrix);
        number = e->matrix;
        line = e->at;
    }
    return 0;
}

static int line_110(const struct source *s, struct patch_loop *loop, struct error *error)
{
    if (s->values->n < 7)
        return too_few_values(s, 7, error);
    struct nurbs_curve c = patch_curve(1, 2);
    for (size_t i = 0; i < 2; i++)
        c.pole[i] = pole_at(
            s, vec(value_at(s, 1 + 3 * i), value_at(s, 2 + 3 * i), value_at(s, 3 + 3 * i)), 1);
    *array_push(loop) = c;
    return 0;
}

/* Counter-clockwise from start to end, in pieces of up to a quarter (The NURBS Book, eq 7.33). */
static int arc_100(const struct source *s, struct patch_loop *loop, struct error *error)
{
    if (s->values->n < 8)
        return too_few_values(s, 8, error);
    double z = value_at(s, 1), x = value_at(s, 2), y = value_at(s, 3);
    double x0 = value_at(s, 4) - x, y0 = value_at(s, 5) - y;
    double x1 = value_at(s, 6) - x, y1 = value_at(s, 7) - y, r = hypot(x0, y0);
    double from = atan2(y0, x0), turn = atan2(y1, x1) - from;
    if (turn <= 1e-12)
        turn += 2 * PI;
    int pieces = (int)ceil(turn / (PI / 2) - 1e-9);
    for (int i = 0; i < pieces; i++) {
        double half = turn / pieces / 2, middle = from + half * (2 * i + 1);
        struct nurbs_curve c = patch_curve(2, 3);
        for (int k = 0; k < 3; k++) {
            double a = middle + half * (k - 1), w = k == 1 ? cos(half) : 1;
            double out = k == 1 ? r / cos(half) : r;
            c.pole[k] = pole_at(s, vec(x + out * cos(a), y + out * sin(a), z), w);
        }
        *array_push(loop) = c;
    }
    return 0;
}

static int polyline_106(const struct source *s, struct patch_loop *loop, struct error *error)
{
    long kind, count;
    if (iges_whole(s->iges, s->values, 1, 1, 3, "kind of points", &kind, error) < 0 ||
        iges_whole(s->iges, s->values, 2, 2, COUNT_MAX, "count of points", &count, error) < 0)
        return -1;
    size_t n = (size_t)count, step = kind == 1 ? 2 : kind == 2 ? 3 : 6, first = kind == 1 ? 4 : 3;
    if (s->values->n < first + step * n)
        return too_few_values(s, first + step * n, error);
    struct nurbs_curve c = patch_curve(1, n);
    for (size_t i = 0; i < n; i++) {
        double z = kind == 1 ? value_at(s, 3) : value_at(s, first + step * i + 2);
        c.pole[i] =
            pole_at(s, vec(value_at(s, first + step * i), value_at(s, first + step * i + 1), z), 1);
        c.t.knot[1 + i] = (double)i / (double)(n - 1);
    }
    c.t.knot[n + 1] = 1;
    *array_push(loop) = c;
    return 0;
}

static int spline_126(const struct source *s, struct patch_loop *loop, struct error *error)
{
    long k, m;
    if (iges_whole(s->iges, s->values, 1, 1, COUNT_MAX, "upper index (K)", &k, error) < 0 ||
        iges_whole(s->iges, s->values, 2, 1, NURBS_DEGREE_MAX, "degree", &m, error) < 0)
        return -1;
    size_t n = (size_t)k + 1, knots = n + (size_t)m + 1, need = 7 + knots + 4 * n;
    if (s->values->n < need)
        return too_few_values(s, need, error);
    struct nurbs_curve c = patch_curve((int)m, n);
    struct error why;
    for (size_t i = 0; i < knots; i++)
        c.t.knot[i] = value_at(s, 7 + i);
    bool range = s->values->n >= need + 2;
    c.t.from = range ? value_at(s, need) : c.t.knot[m];
    c.t.to = range ? value_at(s, need + 1) : c.t.knot[n];
    bool positive = true;
    for (size_t i = 0; i < n; i++) {
        size_t at = 7 + knots + n + 3 * i;
        double w = value_at(s, 7 + knots + i);
        c.pole[i] = pole_at(s, vec(value_at(s, at), value_at(s, at + 1), value_at(s, at + 2)), w);
        positive = positive && w > 0;
    }
    int status = nurbs_axis_check(&c.t, "t", &why);
    if (status == 0 && !positive)
        status = error_set(&why, "a weight that is not positive, expected positive ones");
    if (status == 0) {
        *array_push(loop) = c;
        return 0;
    }
    nurbs_curve_free(&c);
    return error_at(error, s->iges->name, s->values->line, "entity 126: %s", why.text);
}

/* Ellipse or hyperbola a x^2 + b xy + c y^2 + d x + e y + f = 0 about its middle. */
static struct nurbs_curve central_conic(const double k[6], const double end[4], double z,
                                        bool *turned)
{
    double det = k[0] * k[2] - k[1] * k[1] / 4;
    double x = (k[1] * k[4] / 4 - k[2] * k[3] / 2) / det;
    double y = (k[1] * k[3] / 4 - k[0] * k[4] / 2) / det;
    double f = k[5] + (k[3] * x + k[4] * y) / 2, angle = atan2(k[1], k[0] - k[2]) / 2;
    double c = cos(angle), s = sin(angle);
    double first = k[0] * c * c + k[1] * c * s + k[2] * s * s, second = k[0] + k[2] - first;
    bool hyperbola = det < 0;
    if (hyperbola && -f / first < 0) {
        double other = first;
        first = second;
        second = other;
        angle += PI / 2;
    }
    double a = sqrt(fabs(f / first)), b = sqrt(fabs(f / second)), t[2];
    if (hyperbola && (end[0] - x) * cos(angle) + (end[1] - y) * sin(angle) < 0)
        angle += PI;
    struct vec3 along = {cos(angle), sin(angle), 0};
    struct transform place = construct_place(vec(x, y, z), vec(0, 0, 1), along);
    for (int i = 0; i < 2; i++) {
        double p = (end[2 * i] - x) * along.x + (end[2 * i + 1] - y) * along.y;
        double q = (end[2 * i + 1] - y) * along.x - (end[2 * i] - x) * along.y;
        t[i] = hyperbola ? asinh(q / b) : atan2(q / b, p / a);
    }
    *turned = hyperbola && t[1] < t[0];
    if (hyperbola)
        return construct_hyperbola(&place, a, b, fmin(t[0], t[1]), fmax(t[0], t[1]));
    return construct_ellipse(&place, a, b, t[0], t[1] <= t[0] + 1e-12 ? t[1] + 2 * PI : t[1]);
}

/* The parabola of these coefficients. */
static struct nurbs_curve parabola(const double k[6], const double end[4], double z, bool *turned)
{
    double angle = atan2(k[1], k[0] - k[2]) / 2 + PI / 2; /* of its axis */
    double c = cos(angle), s = sin(angle), l = k[0] + k[2];
    double d = k[3] * c + k[4] * s, e = k[4] * c - k[3] * s;
    double y = -e / (2 * l), x = (l * y * y - k[5]) / d, a = -d / (4 * l), t[2];
    struct vec3 along = {c, s, 0}, top = {x * c - y * s, x * s + y * c, z};
    if (a < 0) {
        a = -a;
        along = vec_scale(-1, along);
    }
    struct transform place = construct_place(top, vec(0, 0, 1), along);
    for (int i = 0; i < 2; i++)
        t[i] = ((end[2 * i + 1] - top.y) * along.x - (end[2 * i] - top.x) * along.y) / (2 * a);
    *turned = t[1] < t[0];
    return construct_parabola(&place, a, fmin(t[0], t[1]), fmax(t[0], t[1]));
}

/* 104: six coefficients, a height, start and end; an ellipse runs counter-clockwise. */
static int conic_104(const struct source *s, struct patch_loop *loop, struct error *error)
{
    double k[6], end[4], size = 0;
    bool turned = false;
    if (s->values->n < 12)
        return too_few_values(s, 12, error);
    for (size_t i = 0; i < 6; i++)
        k[i] = value_at(s, 1 + i);
    for (size_t i = 0; i < 4; i++)
        end[i] = value_at(s, 8 + i);
    for (size_t i = 0; i < 3; i++)
        size = fmax(size, fabs(k[i]));
    bool bent = fabs(k[0] * k[2] - k[1] * k[1] / 4) > 1e-12 * size * size;
    struct nurbs_curve c = bent ? central_conic(k, end, value_at(s, 7), &turned)
                                : parabola(k, end, value_at(s, 7), &turned);
    for (size_t i = 0; i < c.t.poles; i++)
        if (!isfinite(c.pole[i].wx + c.pole[i].wy) || !(c.t.from < c.t.to)) {
            nurbs_curve_free(&c);
            return error_at(error, s->iges->name, s->values->line,
                            "entity 104 whose coefficients make no conic, expected one");
        }
    if (turned)
        nurbs_curve_reverse(&c);
    construct_move(&s->matrix, c.pole, c.t.poles);
    *array_push(loop) = c;
    return 0;
}

/* 112: breakpoints, then four coefficients of each coordinate for each piece. */
static int spline_112(const struct source *s, struct patch_loop *loop, struct error *error)
{
    long count;
    if (iges_whole(s->iges, s->values, 4, 1, COUNT_MAX, "count of pieces", &count, error) < 0)
        return -1;
    size_t n = (size_t)count, first = 6 + n;
    if (s->values->n < first + 12 * n)
        return too_few_values(s, first + 12 * n, error);
    double *t = mem_alloc(n + 1, sizeof *t), *c = mem_alloc(12 * n, sizeof *c);
    bool rises = true;
    for (size_t i = 0; i <= n; i++) {
        t[i] = value_at(s, 5 + i);
        rises = rises && (i == 0 || t[i] > t[i - 1]);
    }
    for (size_t i = 0; i < 12 * n; i++)
        c[i] = value_at(s, first + i);
    if (rises) {
        struct nurbs_curve curve = construct_spline_curve(t, n, c);
        construct_move(&s->matrix, curve.pole, curve.t.poles);
        *array_push(loop) = curve;
    }
    free(t);
    free(c);
    return rises ? 0
                 : error_at(error, s->iges->name, s->values->line,
                            "entity 112 with breakpoints that do not rise, expected rising ones");
}

static int read_curve(const struct iges *iges, const struct iges_entity *entity, struct walk *walk,
                      struct patch_loop *loop, const struct iges_entity **unknown,
                      struct error *error);

/* The distance of an offset: one, or changing between two places, or as a coordinate of a curve
 * does; over the base's parameter or over its length. */
struct distance_130 {
    long kind;
    double value[2], at[2], scale;
    bool by_length;
    struct patch_loop curve;
    struct iges_ranges range;
    int coordinate;
};

/* A curve moved in its plane. */
struct offset_130 {
    const struct nurbs_curve *curve;
    const struct iges_range *range;
    const struct distance_130 *distance;
    struct vec3 normal;
    const struct curve_length *length; /* of the curve, where it counts */
    double before;                     /* of the curves before this one */
};

static double distance_at(const struct offset_130 *o, double t, double own)
{
    const struct distance_130 *d = o->distance;
    if (d->kind == 1 || (d->kind == 2 && !(d->at[1] > d->at[0])))
        return d->value[0];
    if (d->by_length)
        t = (o->before + curve_length_to(o->length, own)) / d->scale;
    if (d->kind == 2)
        return d->value[0] + (d->value[1] - d->value[0]) * (t - d->at[0]) / (d->at[1] - d->at[0]);
    size_t i = iges_range_of(&d->range, t);
    const struct nurbs_curve *c = &d->curve.item[i];
    struct vec3 p = nurbs_curve_point(c, iges_parameter(c, &d->range.item[i], t));
    return d->scale * (d->coordinate == 1 ? p.x : d->coordinate == 2 ? p.y : p.z);
}

/* Over the parameters of the file. */
static struct vec3 offset_point(const void *context, double t)
{
    const struct offset_130 *o = context;
    double own = iges_parameter(o->curve, o->range, t);
    struct vec3 side = vec_cross(o->normal, nurbs_curve_derivative(o->curve, own));
    return vec_along(nurbs_curve_point(o->curve, own), distance_at(o, t, own), vec_unit(side));
}

/* The offset between two parameters of the file. */
static void push_offset(struct offset_130 *o, double from, double to, struct patch_loop *loop)
{
    const struct nurbs_curve *c = o->curve;
    struct doubles at = {0};
    size_t n = nurbs_axis_breaks(&c->t, NULL, 0);
    double *kink = mem_alloc(n + 1, sizeof *kink), off;
    nurbs_axis_breaks(&c->t, kink, n);
    *array_push(&at) = from;
    for (size_t i = 0; i < n; i++) {
        double t = iges_parameter_back(c, o->range, kink[i]);
        if (t > at.item[at.n - 1] && t < to)
            *array_push(&at) = t;
    }
    *array_push(&at) = to;
    *array_push(loop) = approximate_curve(offset_point, o, at.item, at.n - 1, 1e-6, &off);
    loop->rough = fmax(loop->rough, off);
    array_free(&at);
    free(kink);
}

/* The distance of a 130, in the lengths of what it is part of: 0, 1 when its curve is not read, or
 * -1. */
static int read_distance(const struct source *s, struct walk *walk, struct distance_130 *d,
                         const struct iges_entity **unknown, struct error *error)
{
    const struct iges_entity *function;
    long coordinate = 0, measure = 2;
    if (iges_whole(s->iges, s->values, 2, 1, 3, "flag of the distance", &d->kind, error) < 0)
        return -1;
    d->scale = cbrt(fabs(transform_determinant(&s->matrix)));
    for (size_t i = 0; i < 2; i++) {
        d->value[i] = d->scale * value_at(s, 6 + 2 * i);
        d->at[i] = value_at(s, 7 + 2 * i);
    }
    if (d->kind > 1 && value_at(s, 5) > 0 &&
        iges_whole(s->iges, s->values, 5, 1, 2, "measure of the distance", &measure, error) < 0)
        return -1;
    d->by_length = measure == 1;
    if (d->kind < 3)
        return 0;
    if (iges_whole(s->iges, s->values, 4, 1, 3, "coordinate of the distance", &coordinate, error) <
            0 ||
        iges_pointer(s->iges, s->values, 3, &function, error) < 0)
        return -1;
    d->coordinate = (int)coordinate;
    struct walk own = *walk;
    own.outer = transform_identity();
    own.depth++;
    own.ranges = &d->range;
    int got = read_curve(s->iges, function, &own, &d->curve, unknown, error);
    walk->left = own.left;
    return got;
}

/* 130: a plane curve, a distance, the normal of the plane, and between which parameters of the
 * curve; the offset is to the side of normal x tangent. */
static int offset_130(const struct source *s, struct walk *walk, struct patch_loop *loop,
                      const struct iges_entity **unknown, struct error *error)
{
    const struct iges_entity *base;
    struct patch_loop pieces = {0};
    struct iges_ranges range = {0};
    struct distance_130 d = {0};
    if (s->values->n < 13)
        return too_few_values(s, 13, error);
    if (iges_pointer(s->iges, s->values, 1, &base, error) < 0)
        return -1;
    int got = read_distance(s, walk, &d, unknown, error);
    struct walk own = *walk;
    own.outer = s->matrix;
    own.depth++;
    own.ranges = &range;
    if (got == 0)
        got = read_curve(s->iges, base, &own, &pieces, unknown, error);
    walk->left = own.left < walk->left ? own.left : walk->left;
    struct vec3 zero = {0, 0, 0}, v = {value_at(s, 10), value_at(s, 11), value_at(s, 12)};
    v = vec_unit(vec_sub(transform_point(&s->matrix, v), transform_point(&s->matrix, zero)));
    double from = value_at(s, 13), to = value_at(s, 14), before = 0;
    bool part =
        from < to && range.n > 0 && from < range.item[range.n - 1].to && to > range.item[0].from;
    for (size_t i = 0; i < pieces.n && got == 0; i++) {
        const struct iges_range *r = &range.item[i];
        double low = part ? fmax(r->from, from) : r->from, high = part ? fmin(r->to, to) : r->to;
        struct curve_length length = {0};
        if (d.by_length)
            length = curve_length(&pieces.item[i]);
        struct offset_130 o = {&pieces.item[i], r, &d, v, &length, before};
        if (low < high) {
            push_offset(&o, low, high, loop);
            if (walk->ranges)
                *array_push(walk->ranges) = (struct iges_range){low, high, false};
        }
        before += d.by_length ? length.length[length.n] : 0;
        curve_length_free(&length);
    }
    loop->rough = fmax(loop->rough, fmax(pieces.rough, d.curve.rough));
    patch_loop_free(&pieces);
    patch_loop_free(&d.curve);
    array_free(&range);
    array_free(&d.range);
    return got;
}

/* The ranges from `before` on follow those from `first` on, which begin at 0. */
static void append_ranges(struct iges_ranges *r, size_t first, size_t before)
{
    if (before == r->n)
        return;
    double shift = (before > first ? r->item[before - 1].to : 0) - r->item[before].from;
    for (size_t i = before; i < r->n; i++) {
        r->item[i].from += shift;
        r->item[i].to += shift;
    }
}

static int composite_102(const struct source *s, struct walk *walk, struct patch_loop *loop,
                         const struct iges_entity **unknown, struct error *error)
{
    long count;
    if (iges_whole(s->iges, s->values, 1, 1, COUNT_MAX, "count of curves", &count, error) < 0)
        return -1;
    if (s->values->n < 2 + (size_t)count)
        return too_few_values(s, 2 + (size_t)count, error);
    struct transform outer = walk->outer;
    int got = 0;
    walk->outer = s->matrix;
    walk->depth++;
    size_t first = walk->ranges ? walk->ranges->n : 0;
    for (size_t i = 0; i < (size_t)count && got == 0; i++) {
        const struct iges_entity *part;
        size_t before = walk->ranges ? walk->ranges->n : 0;
        got = iges_pointer(s->iges, s->values, 2 + i, &part, error);
        if (got == 0)
            got = read_curve(s->iges, part, walk, loop, unknown, error);
        if (got == 0 && walk->ranges)
            append_ranges(walk->ranges, first, before);
    }
    walk->depth--;
    walk->outer = outer;
    return got;
}

/* The file's parameters along the curves of one entity, from `first` on: an arc's are angles from 0
 * to one turn on, a polyline's count its points.  False: they are not understood. */
static bool push_ranges(const struct source *s, const struct patch_loop *loop, size_t first,
                        struct iges_ranges *ranges)
{
    int type = s->entity->type;
    size_t n = loop->n - first;
    double from = atan2(value_at(s, 5) - value_at(s, 3), value_at(s, 4) - value_at(s, 2));
    double to = atan2(value_at(s, 7) - value_at(s, 3), value_at(s, 6) - value_at(s, 2));
    double turn = to - from <= 1e-12 ? to - from + 2 * PI : to - from;
    from += from < 0 ? 2 * PI : 0;
    for (size_t i = 0; i < n; i++) {
        const struct nurbs_curve *c = &loop->item[first + i];
        struct iges_range r = {c->t.from, c->t.to, type == 104};
        if (type == 110)
            r = (struct iges_range){0, 1, false};
        if (type == 106)
            r = (struct iges_range){0, (double)(c->t.poles - 1), false};
        if (type == 100)
            r = (struct iges_range){from + turn * (double)i / (double)n,
                                    from + turn * (double)(i + 1) / (double)n, true};
        if (type == 104 && r.from < 0) {
            r.from += 2 * PI;
            r.to += 2 * PI;
        }
        *array_push(ranges) = r;
    }
    double k = value_at(s, 2);
    return type != 104 || value_at(s, 1) * value_at(s, 3) > k * k / 4;
}

static int read_simple(const struct source *s, struct patch_loop *loop, struct error *error)
{
    int type = s->entity->type, form = s->entity->form;
    if (type == 110 && form == 0)
        return line_110(s, loop, error);
    if (type == 100)
        return arc_100(s, loop, error);
    if (type == 126)
        return spline_126(s, loop, error);
    if (type == 106 && (form == 11 || form == 12 || form == 63))
        return polyline_106(s, loop, error);
    if (type == 104)
        return conic_104(s, loop, error);
    if (type == 112)
        return spline_112(s, loop, error);
    return 1;
}

/* Surfaces, solids and what they are made of, which no curve can be. */
static bool is_no_curve(int type)
{
    static const int kind[] = {108, 114, 118, 120, 122, 123, 124, 128, 140, 143, 144,
                               186, 190, 192, 194, 196, 198, 502, 504, 508, 510, 514};
    for (size_t i = 0; i < sizeof kind / sizeof *kind; i++)
        if (type == kind[i])
            return true;
    return false;
}

static int read_known(const struct source *s, struct walk *walk, struct patch_loop *loop,
                      const struct iges_entity **unknown, struct error *error)
{
    size_t first = loop->n;
    if (is_no_curve(s->entity->type))
        return error_at(error, s->iges->name, s->values->line,
                        "entity %d (directory entry %d) where another points for a curve, "
                        "expected a curve",
                        s->entity->type, s->entity->number);
    if (s->entity->type == 130)
        return offset_130(s, walk, loop, unknown, error);
    if (s->entity->type == 102)
        return composite_102(s, walk, loop, unknown, error);
    int got = read_simple(s, loop, error);
    if (got == 0 && walk->ranges && !push_ranges(s, loop, first, walk->ranges))
        got = 1;
    if (got > 0)
        *unknown = s->entity;
    return got;
}

static int read_curve(const struct iges *iges, const struct iges_entity *entity, struct walk *walk,
                      struct patch_loop *loop, const struct iges_entity **unknown,
                      struct error *error)
{
    struct iges_values values;
    struct source s = {iges, entity, &values, transform_identity()};
    if (walk->left-- == 0 || walk->depth == DEPTH_MAX)
        return error_at(error, iges->name, entity->at,
                        "curves within curves without end, expected simple ones");
    if (iges_matrix(iges, entity->matrix, entity->at, &s.matrix, error) < 0 ||
        iges_values(iges, entity, &values, error) < 0)
        return -1;
    if (iges_numbers(iges, &values, 1, values.n, NURBS_LARGEST, error) < 0) {
        array_free(&values);
        return -1;
    }
    s.matrix = transform_product(walk->outer, s.matrix);
    int got = read_known(&s, walk, loop, unknown, error);
    array_free(&values);
    return got;
}

int iges_curve(const struct iges *iges, const struct iges_entity *entity, struct patch_loop *loop,
               const struct iges_entity **unknown, struct error *error)
{
    struct walk walk = {.left = 2 * iges->entity.n, .outer = transform_identity()};
    return read_curve(iges, entity, &walk, loop, unknown, error);
}

int iges_curve_ranges(const struct iges *iges, const struct iges_entity *entity,
                      struct patch_loop *loop, struct iges_ranges *ranges,
                      const struct iges_entity **unknown, struct error *error)
{
    struct walk walk = {
        .left = 2 * iges->entity.n, .outer = transform_identity(), .ranges = ranges};
    return read_curve(iges, entity, &walk, loop, unknown, error);
}
