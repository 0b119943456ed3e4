/* tessellate - see tessellate.h. */
#include "nurbs/tessellate.h"

#include <stdlib.h>

#include "isolines.h"
#include "base/parallel.h"
#include "trim_loops.h"

/* Grids that are tried, and of them those that hardly help before it is given up. */
enum { ROUNDS = 8, IDLE = 2, CELLS_MAX = 4000000 };
static const double LITTLE = 0.3; /* of what a finer grid should help */

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

/* What the threads share: vertices, then faces. */
struct lift {
    struct sheet *sheet;
    const struct nurbs *part; /* [piece] */
    double *error;            /* [face] */
    struct vec3 *error_at;
    int places; /* of a triangle that are looked at */
};

static void place_vertices(void *context, size_t from, size_t to)
{
    struct lift *l = context;
    struct sheet *sheet = l->sheet;
    for (size_t i = from; i < to; i++) {
        struct nurbs_place p = nurbs_place(&l->part[sheet->piece.item[i]], sheet->at.item[i]);
        sheet->point.item[i] = p.point;
        sheet->normal.item[i] = p.normal;
        sheet->k1.item[i] = p.k1;
        sheet->k2.item[i] = p.k2;
    }
}

/* Where triangles are looked at: the middles of it and of its sides, then quarters. */
enum { FEW = 4, MANY = 13 };
static const double looked_at[MANY][3] = {{1 / 3.0, 1 / 3.0, 1 / 3.0},
                                          {0.5, 0.5, 0},
                                          {0, 0.5, 0.5},
                                          {0.5, 0, 0.5},
                                          {0.75, 0.25, 0},
                                          {0.25, 0.75, 0},
                                          {0, 0.75, 0.25},
                                          {0, 0.25, 0.75},
                                          {0.25, 0, 0.75},
                                          {0.75, 0, 0.25},
                                          {0.5, 0.25, 0.25},
                                          {0.25, 0.5, 0.25},
                                          {0.25, 0.25, 0.5}};

/* How far the place of a triangle is from the surface, at most: what is across the surface there,
 * and what the surface bends over what is along it. */
static double off_at(const struct nurbs *part, struct uv at, struct vec3 p, double bend,
                     struct vec3 *on)
{
    struct vec3 d[3][3];
    nurbs_derivatives(part, at, 1, d);
    struct vec3 off = vec_sub(d[0][0], p), normal = vec_unit(vec_cross(d[1][0], d[0][1]));
    double across = vec_dot(off, normal), all = vec_dot(off, off);
    *on = d[0][0];
    return fmin(sqrt(all), fabs(across) + bend / 2 * (all - across * across));
}

static void measure_faces(void *context, size_t from, size_t to)
{
    struct lift *l = context;
    const struct sheet *s = l->sheet;
    for (size_t i = from; i < to; i++) {
        const int *v = s->face.item[i].v;
        const struct nurbs *part = &l->part[s->piece.item[v[0]]];
        double bend = 0;
        for (int k = 0; k < 3; k++)
            bend = fmax(bend, fmax(fabs(s->k1.item[v[k]]), fabs(s->k2.item[v[k]])));
        for (int m = 0; m < l->places; m++) {
            struct uv at = {0, 0};
            struct vec3 p = {0, 0, 0}, on;
            for (int k = 0; k < 3; k++) {
                at.u += looked_at[m][k] * s->at.item[v[k]].u;
                at.v += looked_at[m][k] * s->at.item[v[k]].v;
                p = vec_along(p, looked_at[m][k], s->point.item[v[k]]);
            }
            double off = off_at(part, at, p, bend, &on);
            if (off > l->error[i]) {
                l->error[i] = off;
                l->error_at[i] = on;
            }
        }
    }
}

static void measure(struct lift *l, int threads)
{
    struct sheet *s = l->sheet;
    l->error = mem_alloc(s->face.n + 1, sizeof *l->error);
    l->error_at = mem_alloc(s->face.n + 1, sizeof *l->error_at);
    parallel_for(threads, s->face.n, measure_faces, l);
    for (size_t i = 0; i < s->face.n; i++)
        if (l->error[i] > s->error) {
            s->error = l->error[i];
            s->error_at = l->error_at[i];
        }
    free(l->error);
    free(l->error_at);
}

/* The vertices of the triangles, a set for each piece. */
static void number_vertices(const struct uvmesh *mesh, const int *piece, struct sheet *sheet)
{
    int now = -1;
    int *where = mem_alloc(mesh->at.n + 1, sizeof *where);
    int *stamp = mem_alloc(mesh->at.n + 1, sizeof *stamp);
    size_t *order = faces_by_piece(piece, mesh->face.n);
    for (size_t i = 0; i < mesh->face.n; i++) {
        struct face face = mesh->face.item[order[i]];
        now = piece[order[i]];
        for (int k = 0; k < 3; k++) {
            int v = face.v[k];
            if (stamp[v] != now + 1) {
                stamp[v] = now + 1;
                where[v] = (int)sheet->at.n;
                *array_push(&sheet->at) = mesh->at.item[v];
                *array_push(&sheet->piece) = now;
            }
            face.v[k] = where[v];
        }
        *array_push(&sheet->face) = face;
    }
    free(where);
    free(stamp);
    free(order);
}

static struct nurbs *all_pieces(const struct nurbs *s)
{
    size_t n = (nurbs_axis_breaks(&s->u, NULL, 0) + 1) * (nurbs_axis_breaks(&s->v, NULL, 0) + 1);
    struct nurbs *part = mem_alloc(n, sizeof *part);
    for (size_t i = 0; i < n; i++)
        part[i] = tessellate_piece(s, (int)i);
    return part;
}

/* From the triangles in the parameters to those in space, piece by piece. */
static void lift(const struct nurbs *s, const struct uvmesh *mesh, struct tessellation how,
                 struct sheet *sheet)
{
    int *piece = mem_alloc(mesh->face.n + 1, sizeof *piece);
    struct nurbs *part = all_pieces(s);
    struct lift l = {.sheet = sheet, .part = part, .places = how.n > 0 ? FEW : MANY};
    pieces_of_faces(s, mesh, piece);
    number_vertices(mesh, piece, sheet);
    size_t n = sheet->at.n;
    array_reserve(&sheet->point, n);
    array_reserve(&sheet->normal, n);
    array_reserve(&sheet->k1, n);
    array_reserve(&sheet->k2, n);
    sheet->point.n = sheet->normal.n = sheet->k1.n = sheet->k2.n = n;
    parallel_for(how.threads, n, place_vertices, &l);
    measure(&l, how.threads);
    free(piece);
    free(part);
}

static void make(const struct patch *patch, const struct uv_polygon *loops, struct tessellation how,
                 struct doubles *u, struct doubles *v, struct sheet *sheet)
{
    struct uvmesh mesh;
    bool open = patch->open || loops->n == 0;
    trim_grid(u, v, loops, open, &mesh);
    sheet_free(sheet);
    sheet->unclear = mesh.unclear;
    sheet->off = loops->off;
    sheet->lost = loops->lost;
    sheet->lines_u = u->n;
    sheet->lines_v = v->n;
    lift(&patch->surface, &mesh, how, sheet);
    uvmesh_free(&mesh);
}

void tessellate(const struct patch *patch, struct tessellation how, struct sheet *sheet)
{
    struct uv_polygon loops;
    struct doubles u = {0}, v = {0};
    double finer = 1;
    *sheet = (struct sheet){0};
    trim_loops(patch, how.tolerance, &loops);
    if (how.n > 0) {
        isolines_equal(&patch->surface.u, how.n, &u);
        isolines_equal(&patch->surface.v, how.n, &v);
        make(patch, &loops, how, &u, &v, sheet);
    }
    double last = HUGE_VAL, factor = 1;
    for (int round = 0, idle = 0; how.n == 0 && round < ROUNDS && idle < IDLE; round++) {
        isolines_bent(&patch->surface, how.tolerance, finer, &u, &v);
        sheet->too_fine = u.n * v.n > CELLS_MAX;
        if (sheet->too_fine)
            break;
        make(patch, &loops, how, &u, &v, sheet);
        if (sheet->error <= how.tolerance)
            break;
        double hope = 1 - (1 - 1 / (factor * factor)) * LITTLE;
        idle = sheet->error > hope * last ? idle + 1 : 0;
        last = sheet->error;
        factor = fmin(fmax(sqrt(last / how.tolerance) * 1.02, 1.05), 4);
        finer *= factor;
    }
    array_free(&u);
    array_free(&v);
    uv_polygon_free(&loops);
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
