/* tessellate - see tessellate.h. */
#include "nurbs/tessellate.h"

#include <stdlib.h>

#include "base/parallel.h"
#include "isolines.h"
#include "trim_grid.h"

/* Grids that are tried, and of them those that hardly help before it is given up. */
enum { ROUNDS = 8, IDLE = 2 };

/* So many times the cells of the first grid: the bound asks for more than the surface does. */
static const double CROWDED = 32;

/* Chords of the trimming, each time so much finer, till it does not cross itself. */
enum { TRIM_ROUNDS = 4, TRIM_FINER = 6 };
static const double POLE = 1e-9; /* of the longer derivative */
static const double FAR_ABOVE = 4;
static const double LITTLE = 0.3; /* of the gain that a finer grid should bring */

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

static void narrow_range(struct nurbs_axis *axis, const double *at, size_t n, size_t segment)
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
    narrow_range(&part.u, u, nu, (size_t)piece % (nu + 1));
    narrow_range(&part.v, v, nv, (size_t)piece / (nu + 1));
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
struct evaluation {
    struct sheet *sheet;
    const struct nurbs *part; /* [piece] */
    double *error;            /* [face] */
    struct vec3 *error_at;
    int places;   /* of a triangle that are measured */
    double exact; /* mm: bounds above this are replaced by the distance itself; 0: none */
};

static void place_vertices(void *context, size_t from, size_t to)
{
    struct evaluation *l = context;
    struct sheet *sheet = l->sheet;
    for (size_t i = from; i < to; i++) {
        struct nurbs_place p = nurbs_place(&l->part[sheet->piece.item[i]], sheet->at.item[i]);
        sheet->point.item[i] = p.point;
        sheet->normal.item[i] = p.normal;
        sheet->k1.item[i] = p.k1;
        sheet->k2.item[i] = p.k2;
    }
}

/* Where triangles are measured: their middle and those of their sides, then quarters. */
enum { FEW = 4, MANY = 13 };
static const double sample[MANY][3] = {{1 / 3.0, 1 / 3.0, 1 / 3.0},
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

/* A bound on how far a point of a triangle is from the surface: the distance across the surface,
 * and what the surface bends over the distance along it. */
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

/* Is a side of the range, at this place, one point? */
static bool is_pole(const struct nurbs *part, struct uv at)
{
    struct vec3 d[3][3];
    nurbs_derivatives(part, at, 1, d);
    double u = vec_length(d[1][0]) * (part->u.to - part->u.from);
    double v = vec_length(d[0][1]) * (part->v.to - part->v.from);
    return fmin(u, v) <= POLE * fmax(u, v);
}

/* The largest curvature at the corners of a triangle.  That of a pole does not count where it is
 * far above the others: at the apex of a cone it has no bound. */
static double largest_curvature(const struct sheet *s, const struct nurbs *part, const int *v)
{
    double bend[3], most = 0;
    for (int k = 0; k < 3; k++)
        bend[k] = fmax(fabs(s->k1.item[v[k]]), fabs(s->k2.item[v[k]]));
    for (int k = 0; k < 3; k++) {
        double others = fmax(bend[(k + 1) % 3], bend[(k + 2) % 3]);
        if (!(bend[k] > FAR_ABOVE * others && is_pole(part, s->at.item[v[k]])))
            most = fmax(most, bend[k]);
    }
    return most;
}

static void measure_faces(void *context, size_t from, size_t to)
{
    struct evaluation *l = context;
    const struct sheet *s = l->sheet;
    for (size_t i = from; i < to; i++) {
        const int *v = s->face.item[i].v;
        const struct nurbs *part = &l->part[s->piece.item[v[0]]];
        double bend = largest_curvature(s, part, v);
        for (int m = 0; m < l->places; m++) {
            struct uv at = {0, 0};
            struct vec3 p = {0, 0, 0}, on;
            for (int k = 0; k < 3; k++) {
                at.u += sample[m][k] * s->at.item[v[k]].u;
                at.v += sample[m][k] * s->at.item[v[k]].v;
                p = vec_along(p, sample[m][k], s->point.item[v[k]]);
            }
            double off = off_at(part, at, p, bend, &on);
            if (l->exact > 0 && off > l->exact)
                off = fmin(off, vec_distance(p, nurbs_point(part, nurbs_foot(part, p, at))));
            if (off > l->error[i]) {
                l->error[i] = off;
                l->error_at[i] = on;
            }
        }
    }
}

static void measure(struct evaluation *l, int threads)
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

/* NOLINTBEGIN(clang-analyzer-unix.Malloc): array_free leaves an array that can be filled again */

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

/* The triangles in the parameters brought into space, piece by piece. */
static void evaluate_sheet(const struct nurbs *s, const struct uvmesh *mesh,
                           struct tessellate_options how, bool exact, struct sheet *sheet)
{
    int *piece = mem_alloc(mesh->face.n + 1, sizeof *piece);
    struct nurbs *part = all_pieces(s);
    struct evaluation l = {.sheet = sheet,
                           .part = part,
                           .places = how.n > 0 ? FEW : MANY,
                           .exact = exact ? how.tolerance : 0};
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

static void make_sheet(const struct patch *patch, const struct uv_polygon *loops,
                       struct tessellate_options how, bool exact, struct doubles *u,
                       struct doubles *v, struct sheet *sheet)
{
    struct uvmesh mesh;
    bool open = patch->open || loops->open || loops->n == 0;
    trim_grid(u, v, loops, open, &mesh);
    sheet_free(sheet);
    sheet->unclear = mesh.unclear + uv_polygon_crossings(loops, &patch->surface, how.tolerance);
    sheet->off = loops->off;
    sheet->gap = loops->gap;
    sheet->gap_at = loops->gap_at;
    sheet->lost = loops->lost;
    sheet->side = loops->side;
    sheet->lines_u = u->n;
    sheet->lines_v = v->n;
    evaluate_sheet(&patch->surface, &mesh, how, exact, sheet);
    uvmesh_free(&mesh);
}

/* Grids to a tolerance, each finer than the one before it, until one keeps it or finer ones hardly
 * help. */
static void refine(const struct patch *patch, const struct uv_polygon *loops,
                   const struct isolines_bend *bend, struct tessellate_options how, bool exact,
                   struct sheet *sheet)
{
    struct doubles u = {0}, v = {0};
    double finer = 1, last = HUGE_VAL, factor = 1, first = 0;
    for (int round = 0, idle = 0; round < ROUNDS && idle < IDLE; round++) {
        isolines_bent(bend, how.tolerance, finer, &u, &v);
        double cells = (double)u.n * (double)v.n;
        first = round == 0 ? cells : first;
        if (!exact && cells > CROWDED * first)
            break;
        sheet->too_fine = u.n * v.n > TESSELLATE_CELLS_MAX;
        if (sheet->too_fine)
            break;
        make_sheet(patch, loops, how, exact, &u, &v, sheet);
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
}

/* Does a side of a loop run along an end of a range?  What is beside it there has no vertices but
 * those of the grid: it is the grid that must follow such a border. */
static void find_borders(const struct uvs *loop, const struct nurbs *s, struct isolines_border *b)
{
    for (size_t i = 0, k = loop->n - 1; i < loop->n; k = i++) {
        struct uv p = loop->item[k], q = loop->item[i];
        b->u[0] = b->u[0] || fmax(p.u, q.u) <= s->u.from;
        b->u[1] = b->u[1] || fmin(p.u, q.u) >= s->u.to;
        b->v[0] = b->v[0] || fmax(p.v, q.v) <= s->v.from;
        b->v[1] = b->v[1] || fmin(p.v, q.v) >= s->v.to;
    }
}

static struct isolines_border borders_of(const struct patch *patch, const struct uv_polygon *loops)
{
    struct isolines_border border = {{false, false}, {false, false}};
    if (patch->open || loops->open || loops->n == 0)
        return (struct isolines_border){{true, true}, {true, true}};
    for (size_t i = 0; i < loops->n; i++)
        find_borders(&loops->item[i], &patch->surface, &border);
    return border;
}

/* Where the parameters rest, at a pole for instance, the bound on the distance is too large,
 * however fine the grid: then the distance itself is sought. */
static void tessellate_once(const struct patch *patch, struct tessellate_options how,
                            double trimming, struct sheet *sheet)
{
    struct uv_polygon loops;
    struct doubles u = {0}, v = {0};
    *sheet = (struct sheet){0};
    trim_loops(patch, trimming, &loops);
    if (how.n > 0) {
        isolines_equal(&patch->surface.u, how.n, &u);
        isolines_equal(&patch->surface.v, how.n, &v);
        make_sheet(patch, &loops, how, false, &u, &v, sheet);
    } else {
        struct isolines_bend bend = {0};
        struct isolines_border border = borders_of(patch, &loops);
        isolines_measure(&patch->surface, &border, &bend);
        refine(patch, &loops, &bend, how, false, sheet);
        if (sheet->error > how.tolerance)
            refine(patch, &loops, &bend, how, true, sheet);
        isolines_bend_free(&bend);
    }
    array_free(&u);
    array_free(&v);
    uv_polygon_free(&loops);
}

/* Chords of curves that run close beside each other may cross where the curves do not. */
void tessellate(const struct patch *patch, struct tessellate_options how, struct sheet *sheet)
{
    double trimming = how.tolerance;
    tessellate_once(patch, how, trimming, sheet);
    for (int round = 1; round < TRIM_ROUNDS && sheet->unclear > 0; round++) {
        sheet_free(sheet);
        trimming /= TRIM_FINER;
        tessellate_once(patch, how, trimming, sheet);
    }
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

/* NOLINTEND(clang-analyzer-unix.Malloc) */
