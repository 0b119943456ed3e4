/* tessellate - see tessellate.h. */
#include "tessellate.h"

#include <stdlib.h>

#include "gridlines.h"
#include "trimloops.h"

enum { ROUNDS = 8, CELLS_MAX = 4000000 };

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
    sheet->off = loops->off;
    sheet->lost = loops->lost;
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
    trimloops(patch, how.tolerance, &loops);
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
