/* patch_measure - see patch_measure.h. */
#include "patch_measure.h"

#include <math.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "trim_grid.h"

/* By the size: chords of the loops.  By the range: lines so near are one. */
static const double CHORD = 1e-4, SAME = 1e-5;

/* By the area: a triangle and its quarters are alike.  So often are triangles quartered, of FEW. */
static const double EVEN = 1e-6;
enum { DEPTH = 6, FEW = 20000 };

/* Lines in each direction, at least, and cells of all. */
enum { LINES = 12, CELLS_MOST = 400000 };

/* Places of the formula: the middle, and three places each of two kinds. */
enum { KINDS = 2 };
static const double middle_weight = 9 / 40.0;
static const double near[KINDS] = {0.059715871789769820, 0.797426985353087322};
static const double weight[KINDS] = {0.132394152788506181, 0.125939180544827153};

/* Every knot in the range, and `parts` equal parts between two of them. */
static void knot_lines(const struct nurbs_axis *a, size_t parts, struct doubles *line)
{
    double least = SAME * (a->to - a->from), last = a->from;
    line->n = 0;
    *array_push(line) = a->from;
    for (size_t i = 0; i <= a->poles + (size_t)a->degree; i++) {
        bool end = i == a->poles + (size_t)a->degree;
        double next = end ? a->to : a->knot[i];
        if (!(next > last + least) || (!end && !(next < a->to - least)))
            continue;
        for (size_t k = 1; k <= parts; k++)
            *array_push(line) = last + (next - last) * (double)k / (double)parts;
        last = next;
    }
    line->item[line->n - 1] = a->to;
}

/* Few spans are divided, many are not. */
static void make_lines(const struct nurbs *s, struct doubles *u, struct doubles *v)
{
    knot_lines(&s->u, 1, u);
    knot_lines(&s->v, 1, v);
    size_t nu = u->n, nv = v->n;
    knot_lines(&s->u, 1 + LINES / nu, u);
    knot_lines(&s->v, 1 + LINES / nv, v);
}

static void add_place(const struct nurbs *s, struct uv at, double w, struct vec3 origin,
                      struct patch_measure *sum)
{
    struct vec3 d[3][3];
    nurbs_derivatives(s, at, 1, d);
    struct vec3 normal = vec_cross(d[1][0], d[0][1]);
    sum->area += w * vec_length(normal);
    sum->volume += w * vec_dot(vec_sub(d[0][0], origin), normal) / 3;
}

/* By the formula of degree 5 (7 places) over a triangle of parameters. */
static struct patch_measure measure_once(const struct nurbs *s, const struct uv c[3],
                                         struct vec3 origin)
{
    struct patch_measure sum = {0};
    double half =
        ((c[1].u - c[0].u) * (c[2].v - c[0].v) - (c[1].v - c[0].v) * (c[2].u - c[0].u)) / 2;
    struct uv m = {(c[0].u + c[1].u + c[2].u) / 3, (c[0].v + c[1].v + c[2].v) / 3};
    add_place(s, m, half * middle_weight, origin, &sum);
    for (int k = 0; k < KINDS; k++)
        for (int i = 0; i < 3; i++) {
            double a = near[k], b = (1 - near[k]) / 2;
            const struct uv *p = &c[i], *q = &c[(i + 1) % 3], *r = &c[(i + 2) % 3];
            struct uv at = {a * p->u + b * (q->u + r->u), a * p->v + b * (q->v + r->v)};
            add_place(s, at, half * weight[k], origin, &sum);
        }
    return sum;
}

static struct uv middle_of(struct uv a, struct uv b)
{
    return (struct uv){(a.u + b.u) / 2, (a.v + b.v) / 2};
}

/* `whole` is what the formula finds over the triangle: where its four quarters have another area,
 * as where the surface nearly comes to a cusp, these are divided on. */
static void add_triangle(const struct nurbs *s, const struct uv c[3], struct vec3 origin,
                         struct patch_measure whole, int depth, struct patch_measure *sum)
{
    struct uv m[3] = {middle_of(c[1], c[2]), middle_of(c[2], c[0]), middle_of(c[0], c[1])};
    struct uv quarter[4][3] = {
        {c[0], m[2], m[1]}, {m[2], c[1], m[0]}, {m[1], m[0], c[2]}, {m[0], m[1], m[2]}};
    struct patch_measure part[4], all = {0};

    for (int k = 0; k < 4; k++) {
        part[k] = measure_once(s, quarter[k], origin);
        all.area += part[k].area;
        all.volume += part[k].volume;
    }
    if (depth == 0 || fabs(all.area - whole.area) <= EVEN * fabs(all.area)) {
        sum->area += all.area;
        sum->volume += all.volume;
        return;
    }
    for (int k = 0; k < 4; k++)
        add_triangle(s, quarter[k], origin, part[k], depth - 1, sum);
}

struct patch_measure patch_measure(const struct patch *patch, double size, struct vec3 origin)
{
    struct patch_measure sum = {0};
    struct uv_polygon loops;
    struct doubles u = {0}, v = {0};
    struct uvmesh mesh;
    make_lines(&patch->surface, &u, &v);
    if (u.n * v.n > CELLS_MOST) {
        array_free(&u);
        array_free(&v);
        return sum;
    }
    trim_loops_bent(patch, CHORD * size, &loops);
    trim_grid(&u, &v, &loops, patch->open || loops.open || loops.n == 0, &mesh);
    for (size_t i = 0; i < mesh.face.n; i++) {
        const int *k = mesh.face.item[i].v;
        struct uv c[3] = {mesh.at.item[k[0]], mesh.at.item[k[1]], mesh.at.item[k[2]]};
        add_triangle(&patch->surface, c, origin, measure_once(&patch->surface, c, origin),
                     mesh.face.n <= FEW ? DEPTH : 0, &sum);
    }
    sum.sound = mesh.unclear == 0 && loops.lost == 0;
    uvmesh_free(&mesh);
    uv_polygon_free(&loops);
    array_free(&u);
    array_free(&v);
    return sum;
}
