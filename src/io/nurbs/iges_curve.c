/* iges_curve - see iges_curve.h. */
#include "iges_curve.h"

#include <stdlib.h>

#include "base/array.h"

enum { DEPTH_MAX = 20, COUNT_MAX = 100000000 };

/* How deep curves within curves are, and how many more may be read: one that holds itself many
 * times over would never end. */
struct walk {
    int depth;
    size_t left;
    struct transform outer; /* of the curves that this one is part of */
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

int iges_matrix(const struct iges *iges, int number, struct transform *matrix, struct error *error)
{
    *matrix = transform_identity();
    for (int depth = 0; number != 0; depth++) {
        const struct iges_entity *e = iges_entity(iges, number);
        struct iges_values v;
        if (!e || e->type != 124 || depth == DEPTH_MAX)
            return error_at(
                error, iges->name, 0,
                "a pointer to directory entry %d as a transformation, expected an entity "
                "124",
                number);
        if (iges_values(iges, e, &v, error) < 0)
            return -1;
        struct transform t = transform_identity();
        for (size_t i = 0; i < 12; i++)
            t.m[i / 4][i % 4] = 1 + i < v.n ? v.item[1 + i].number : 0;
        size_t n = v.n, line = v.line;
        array_free(&v);
        if (n < 13)
            return error_at(error, iges->name, line, "entity 124 with %zu numbers, expected 12",
                            n - 1);
        *matrix = transform_product(t, *matrix);
        number = e->matrix;
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

static int read_curve(const struct iges *iges, const struct iges_entity *entity, struct walk *walk,
                      struct patch_loop *loop, const struct iges_entity **unknown,
                      struct error *error);

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
    for (size_t i = 0; i < (size_t)count && got == 0; i++) {
        const struct iges_entity *part;
        got = iges_pointer(s->iges, s->values, 2 + i, &part, error);
        if (got == 0)
            got = read_curve(s->iges, part, walk, loop, unknown, error);
    }
    walk->depth--;
    walk->outer = outer;
    return got;
}

static int read_known(const struct source *s, struct walk *walk, struct patch_loop *loop,
                      const struct iges_entity **unknown, struct error *error)
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
    if (type == 102)
        return composite_102(s, walk, loop, unknown, error);
    *unknown = s->entity;
    return 1;
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
    if (iges_matrix(iges, entity->matrix, &s.matrix, error) < 0 ||
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
