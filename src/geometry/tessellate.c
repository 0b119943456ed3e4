/* tessellate - see tessellate.h. */
#include "tessellate.h"

#include <stdlib.h>

#include "gridlines.h"

enum { DEPTH_MAX = 10, ROUNDS = 8, CELLS_MAX = 4000000 };

/* A curve in the parameters, followed on the surface. */
struct follower {
    const struct nurbs *surface;
    const struct nurbs_curve *curve;
    double tolerance;
    struct uvs *to;
};

static struct uv uv_at(const struct follower *f, double t)
{
    struct vec3 p = nurbs_curve_point(f->curve, t);
    return (struct uv){p.x, p.y};
}

static struct vec3 point_at(const struct follower *f, struct uv at)
{
    const struct nurbs *s = f->surface;
    at.u = fmin(fmax(at.u, s->u.from), s->u.to);
    at.v = fmin(fmax(at.v, s->v.from), s->v.to);
    return nurbs_point(s, at);
}

static double distance_to_chord(struct vec3 p, struct vec3 a, struct vec3 b)
{
    struct vec3 d = vec_sub(b, a), r = vec_sub(p, a);
    double l = vec_dot(d, d);
    double t = l > 0 ? fmin(fmax(vec_dot(r, d) / l, 0), 1) : 0;
    return vec_distance(p, vec_along(a, t, d));
}

/* Is the straight way in the parameters, and on the surface, near the curve at three places? */
static bool is_near(const struct follower *f, double t0, double t1)
{
    struct uv a = uv_at(f, t0), b = uv_at(f, t1);
    struct vec3 p = point_at(f, a), q = point_at(f, b);
    for (int i = 1; i < 4; i++) {
        struct uv m = {a.u + (b.u - a.u) * i / 4, a.v + (b.v - a.v) * i / 4};
        struct vec3 on = point_at(f, uv_at(f, t0 + (t1 - t0) * i / 4));
        if (distance_to_chord(on, p, q) > f->tolerance ||
            distance_to_chord(point_at(f, m), p, q) > f->tolerance)
            return false;
    }
    return true;
}

/* All points of the curve from t0 to t1 but the last. */
static void follow(const struct follower *f, double t0, double t1, int depth)
{
    if (depth == DEPTH_MAX || is_near(f, t0, t1)) {
        *array_push(f->to) = uv_at(f, t0);
        return;
    }
    double middle = t0 + (t1 - t0) / 2;
    follow(f, t0, middle, depth + 1);
    follow(f, middle, t1, depth + 1);
}

/* One curve, span by span, with its last point; a span that bends is parted first. */
static void follow_curve(const struct nurbs *surface, const struct nurbs_curve *curve,
                         double tolerance, struct uvs *to)
{
    struct follower f = {surface, curve, tolerance, to};
    const struct nurbs_axis *t = &curve->t;
    for (size_t i = (size_t)t->degree; i < t->poles; i++) {
        double from = fmax(t->knot[i], t->from), end = fmin(t->knot[i + 1], t->to);
        int parts = t->degree > 1 ? 2 : 1;
        for (int k = 0; k < parts && end > from; k++)
            follow(&f, from + (end - from) * k / parts, from + (end - from) * (k + 1) / parts, 0);
    }
    *array_push(to) = uv_at(&f, t->to);
}

static double square(struct uv a, struct uv b, const struct nurbs *s)
{
    double u = (a.u - b.u) / (s->u.to - s->u.from), v = (a.v - b.v) / (s->v.to - s->v.from);
    return u * u + v * v;
}

/* Joins a curve to the loop so far, turned round where that fits better. */
static void join(const struct nurbs *s, struct uvs *loop, struct uvs *curve, const struct uv *goal)
{
    if (curve->n == 0)
        return;
    struct uv first = curve->item[0], last = curve->item[curve->n - 1];
    bool turned = loop->n > 0 ? square(loop->item[loop->n - 1], last, s) <
                                    square(loop->item[loop->n - 1], first, s)
                              : goal && square(*goal, first, s) < square(*goal, last, s);
    for (size_t i = 0; i < curve->n; i++) {
        struct uv at = curve->item[turned ? curve->n - 1 - i : i];
        if (loop->n == 0 || square(loop->item[loop->n - 1], at, s) > 1e-18)
            *array_push(loop) = at;
    }
}

/* The nearer end of the curve that follows the first one tells which way that goes. */
static struct uv nearer_end(const struct nurbs *s, const struct uvs *first,
                            const struct nurbs_curve *next)
{
    struct vec3 a = nurbs_curve_point(next, next->t.from), b = nurbs_curve_point(next, next->t.to);
    struct uv p = {a.x, a.y}, q = {b.x, b.y}, x = first->item[0], y = first->item[first->n - 1];
    double to_p = fmin(square(x, p, s), square(y, p, s));
    return to_p <= fmin(square(x, q, s), square(y, q, s)) ? p : q;
}

void tessellate_loops(const struct patch *patch, double tolerance, struct uvloops *loops)
{
    const struct nurbs *s = &patch->surface;
    *loops = (struct uvloops){0};
    for (size_t i = 0; i < patch->loop.n; i++) {
        const struct patch_loop *l = &patch->loop.item[i];
        struct uvs loop = {0};
        for (size_t k = 0; k < l->n; k++) {
            struct uvs curve = {0};
            struct uv goal;
            follow_curve(s, &l->item[k], tolerance, &curve);
            if (k == 0 && l->n > 1)
                goal = nearer_end(s, &curve, &l->item[1]);
            join(s, &loop, &curve, k == 0 && l->n > 1 ? &goal : NULL);
            array_free(&curve);
        }
        while (loop.n > 1 && square(loop.item[0], loop.item[loop.n - 1], s) <= 1e-18)
            loop.n--;
        if (loop.n >= 3)
            *array_push(loops) = loop;
        else
            array_free(&loop);
    }
}

/* Pieces are numbered row by row: those of u first. */
static size_t breaks_of(const struct nurbs_axis *axis, double **at)
{
    size_t n = nurbs_axis_breaks(axis, NULL, 0);
    *at = mem_alloc(n + 1, sizeof **at);
    return nurbs_axis_breaks(axis, *at, n);
}

static size_t segment_of(const double *at, size_t n, double x)
{
    size_t i = 0;
    while (i < n && at[i] <= x)
        i++;
    return i;
}

static void narrow(struct nurbs_axis *axis, const double *at, size_t n, size_t segment)
{
    if (segment > 0)
        axis->from = at[segment - 1];
    if (segment < n)
        axis->to = at[segment];
}

struct nurbs tessellate_piece(const struct nurbs *surface, int piece)
{
    struct nurbs part = *surface;
    double *u, *v;
    size_t nu = breaks_of(&surface->u, &u), nv = breaks_of(&surface->v, &v);
    narrow(&part.u, u, nu, (size_t)piece % (nu + 1));
    narrow(&part.v, v, nv, (size_t)piece / (nu + 1));
    free(u);
    free(v);
    return part;
}

/* The piece that each triangle lies in. */
static void pieces_of_faces(const struct nurbs *s, const struct uvmesh *mesh, int *piece)
{
    double *u, *v;
    size_t nu = breaks_of(&s->u, &u), nv = breaks_of(&s->v, &v);
    for (size_t i = 0; i < mesh->face.n; i++) {
        const int *c = mesh->face.item[i].v;
        struct uv a = mesh->at.item[c[0]], b = mesh->at.item[c[1]], d = mesh->at.item[c[2]];
        size_t pu = segment_of(u, nu, (a.u + b.u + d.u) / 3);
        size_t pv = segment_of(v, nv, (a.v + b.v + d.v) / 3);
        piece[i] = (int)(pv * (nu + 1) + pu);
    }
    free(u);
    free(v);
}

static int add_vertex(const struct nurbs *part, int piece, struct uv at, struct sheet *sheet)
{
    struct nurbs_place p = nurbs_place(part, at);
    *array_push(&sheet->at) = at;
    *array_push(&sheet->point) = p.point;
    *array_push(&sheet->normal) = p.normal;
    *array_push(&sheet->k1) = p.k1;
    *array_push(&sheet->k2) = p.k2;
    *array_push(&sheet->piece) = piece;
    return (int)sheet->at.n - 1;
}

/* How far a place of a triangle is from the surface, along the normal there. */
static void measure(const struct nurbs *part, struct sheet *sheet, struct uv at, struct vec3 p)
{
    struct nurbs_place on = nurbs_place(part, at);
    double off = fabs(vec_dot(vec_sub(on.point, p), on.normal));
    if (off > sheet->error) {
        sheet->error = off;
        sheet->error_at = on.point;
    }
}

static void measure_face(const struct nurbs *part, struct sheet *sheet, const int v[3])
{
    struct uv a[3];
    struct vec3 p[3], sum = {0, 0, 0};
    struct uv middle = {0, 0};
    for (int k = 0; k < 3; k++) {
        a[k] = sheet->at.item[v[k]];
        p[k] = sheet->point.item[v[k]];
        sum = vec_add(sum, p[k]);
        middle.u += a[k].u / 3;
        middle.v += a[k].v / 3;
    }
    measure(part, sheet, middle, vec_scale(1.0 / 3, sum));
    for (int k = 0; k < 3; k++) {
        struct uv b = a[(k + 1) % 3];
        measure(part, sheet, (struct uv){(a[k].u + b.u) / 2, (a[k].v + b.v) / 2},
                vec_mix(p[k], p[(k + 1) % 3], 0.5));
    }
}

/* The numbers of the faces, those of the first piece first: a counting sort. */
static size_t *faces_by_piece(const int *piece, size_t n)
{
    int most = 0;
    for (size_t i = 0; i < n; i++)
        most = piece[i] > most ? piece[i] : most;
    size_t *from = mem_alloc((size_t)most + 2, sizeof *from);
    size_t *order = mem_alloc(n + 1, sizeof *order);
    for (size_t i = 0; i < n; i++)
        from[piece[i] + 1]++;
    for (int k = 0; k < most; k++)
        from[k + 1] += from[k];
    for (size_t i = 0; i < n; i++)
        order[from[piece[i]]++] = i;
    free(from);
    return order;
}

/* From the triangles in the parameters to those in space, piece by piece. */
static void lift(const struct nurbs *s, const struct uvmesh *mesh, struct sheet *sheet)
{
    int *piece = mem_alloc(mesh->face.n + 1, sizeof *piece), now = -1;
    int *where = mem_alloc(mesh->at.n + 1, sizeof *where);
    int *stamp = mem_alloc(mesh->at.n + 1, sizeof *stamp);
    struct nurbs part = *s;
    pieces_of_faces(s, mesh, piece);
    size_t *order = faces_by_piece(piece, mesh->face.n);
    for (size_t i = 0; i < mesh->face.n; i++) {
        struct face face = mesh->face.item[order[i]];
        if (piece[order[i]] != now) {
            now = piece[order[i]];
            part = tessellate_piece(s, now);
        }
        for (int k = 0; k < 3; k++) {
            int v = face.v[k];
            if (stamp[v] != now + 1) {
                stamp[v] = now + 1;
                where[v] = add_vertex(&part, now, mesh->at.item[v], sheet);
            }
            face.v[k] = where[v];
        }
        *array_push(&sheet->face) = face;
        measure_face(&part, sheet, face.v);
    }
    free(piece);
    free(where);
    free(stamp);
    free(order);
}

static void make(const struct patch *patch, const struct uvloops *loops, struct doubles *u,
                 struct doubles *v, struct sheet *sheet)
{
    struct uvmesh mesh;
    bool open = patch->open || loops->n == 0;
    trimcut(u, v, loops, open, &mesh);
    sheet_free(sheet);
    sheet->unclear = mesh.unclear;
    sheet->lines_u = u->n;
    sheet->lines_v = v->n;
    lift(&patch->surface, &mesh, sheet);
    uvmesh_free(&mesh);
}

void tessellate(const struct patch *patch, struct tessellation how, struct sheet *sheet)
{
    struct uvloops loops;
    struct doubles u = {0}, v = {0};
    double finer = 1;
    *sheet = (struct sheet){0};
    tessellate_loops(patch, how.tolerance, &loops);
    if (how.n > 0) {
        gridlines_equal(&patch->surface.u, how.n, &u);
        gridlines_equal(&patch->surface.v, how.n, &v);
        make(patch, &loops, &u, &v, sheet);
    }
    for (int round = 0; how.n == 0 && round < ROUNDS; round++) {
        gridlines_bent(&patch->surface, how.tolerance, finer, &u, &v);
        sheet->too_fine = u.n * v.n > CELLS_MAX;
        if (sheet->too_fine)
            break;
        make(patch, &loops, &u, &v, sheet);
        if (sheet->error <= how.tolerance)
            break;
        finer *= fmin(fmax(sqrt(sheet->error / how.tolerance) * 1.02, 1.05), 4);
    }
    array_free(&u);
    array_free(&v);
    uvloops_free(&loops);
}

void sheet_free(struct sheet *sheet)
{
    array_free(&sheet->at);
    array_free(&sheet->point);
    array_free(&sheet->normal);
    array_free(&sheet->k1);
    array_free(&sheet->k2);
    array_free(&sheet->piece);
    array_free(&sheet->face);
    *sheet = (struct sheet){0};
}
