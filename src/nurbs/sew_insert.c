/* sew_insert - see sew_steps.h: T-vertices are put into the edges that they lie on, whose triangles
 * are divided. */
#include <stdlib.h>

#include "math/earclip.h"
#include "sew_steps.h"

/* The vertices put into one side of a triangle: n from `first` on, in the order of the side. */
struct insertion {
    size_t face, first, n;
    int side;
};

struct insertions {
    size_t n, cap;
    struct insertion *item;
};

/* A new vertex on the edge, of the same place as the T-vertex, put on its own surface. */
static size_t add_t_vertex(struct sewing *s, const struct nurbs *part,
                           const struct patch_mesh_edge *e, const struct t_vertex *g)
{
    const struct patch_mesh_vertex *a = sew_vertex(s, e->from);
    struct nurbs_place on = nurbs_place(part, g->at);
    size_t n = s->mesh->vertex.n;
    struct patch_mesh_vertex v = {.point = on.point,
                                  .normal = on.normal,
                                  .k1 = on.k1,
                                  .k2 = on.k2,
                                  .at = g->at,
                                  .sheet = a->sheet,
                                  .piece = a->piece,
                                  .place = n,
                                  .next = n};
    *array_push(&s->mesh->vertex) = v;
    patch_mesh_unite(s->mesh, n, g->vertex);
    return n;
}

static int side_of(const struct face *f, size_t from)
{
    return (size_t)f->v[0] == from ? 0 : (size_t)f->v[1] == from ? 1 : 2;
}

/* Replaces the edge by its pieces between T-vertices. */
static void split_edge(struct sewing *s, const struct nurbs *part, size_t edge,
                       const struct t_vertices *on_edge, struct insertions *to)
{
    struct patch_mesh *q = s->mesh;
    struct patch_mesh_edge e = q->edge.item[edge];
    size_t last = e.from;
    *array_push(to) =
        (struct insertion){e.face, q->vertex.n, on_edge->n, side_of(&q->face.item[e.face], e.from)};
    for (size_t k = 0; k < on_edge->n; k++) {
        size_t v = add_t_vertex(s, part, &e, &on_edge->item[k]);
        struct patch_mesh_edge half = {last, v, e.face};
        if (k == 0)
            q->edge.item[edge] = half;
        else
            *array_push(&q->edge) = half;
        last = v;
    }
    *array_push(&q->edge) = (struct patch_mesh_edge){last, e.to, e.face};
}

static void insert_t_vertices(struct sewing *s, struct insertions *to)
{
    struct patch_mesh *q = s->mesh;
    struct t_vertices on_edge = {0};
    int sheet = -1, piece = -1;
    struct nurbs part = {0};
    for (size_t i = 0; i < s->border.edge.n; i++) {
        size_t edge = s->border.edge.item[i];
        struct patch_mesh_edge e = q->edge.item[edge];
        const struct patch_mesh_vertex *a = sew_vertex(s, e.from);
        if (a->place == sew_vertex(s, e.to)->place)
            continue;
        if (a->sheet != sheet || a->piece != piece) {
            sheet = a->sheet;
            piece = a->piece;
            part = tessellate_piece(&s->patches->item[sheet].surface, piece);
        }
        sew_find_t_vertices(s, &part, &e, &on_edge);
        if (!s->slits)
            sew_keep_matched(s, a->sheet, &on_edge);
        else if (on_edge.n > 1)
            on_edge.n = 1; /* one at a time: the others may have found their own */
        if (on_edge.n > 0)
            split_edge(s, &part, edge, &on_edge, to);
    }
    array_free(&on_edge);
}

static int compare_insertions(const void *p, const void *q)
{
    const struct insertion *a = p, *b = q;
    if (a->face != b->face)
        return a->face < b->face ? -1 : 1;
    return a->side - b->side;
}

/* Triangulates anew a triangle with vertices put into its sides. */
static void split_face(struct patch_mesh *q, const struct insertion *in, size_t n,
                       const struct nurbs *s)
{
    struct ints corner = {0};
    struct uvs at = {0};
    struct faces cut = {0};
    struct face f = q->face.item[in->face];
    double u = s->u.to - s->u.from, v = s->v.to - s->v.from;
    for (int side = 0; side < 3; side++) {
        *array_push(&corner) = f.v[side];
        for (size_t i = 0; i < n; i++)
            for (size_t k = 0; in[i].side == side && k < in[i].n; k++)
                *array_push(&corner) = (int)(in[i].first + k);
    }
    for (size_t i = 0; i < corner.n; i++) {
        struct uv p = q->vertex.item[corner.item[i]].at;
        *array_push(&at) = (struct uv){p.u / u, p.v / v};
    }
    earclip(at.item, corner.item, corner.n, &cut);
    int sheet = q->sheet.item[in->face];
    q->face.item[in->face] = cut.item[0];
    for (size_t i = 1; i < cut.n; i++) {
        *array_push(&q->face) = cut.item[i];
        *array_push(&q->sheet) = sheet;
    }
    array_free(&corner);
    array_free(&at);
    array_free(&cut);
}

static int compare_edges(const void *p, const void *q)
{
    const struct patch_mesh_edge *a = p, *b = q;
    if (a->from != b->from)
        return a->from < b->from ? -1 : 1;
    return a->to < b->to ? -1 : a->to > b->to;
}

/* Gives border edges of triangles that were split the triangle that has them now; `faces` is the
 * count before the splits. */
static void find_faces(struct patch_mesh *q, const struct insertions *in, size_t faces)
{
    bool *cut = mem_alloc(faces + 1, sizeof *cut);
    struct patch_mesh_edges side = {0};
    for (size_t i = 0; i < in->n; i++)
        cut[in->item[i].face] = true;
    for (size_t i = 0; i < q->face.n; i++)
        for (int k = 0; k < 3 && (i >= faces || cut[i]); k++) {
            const int *v = q->face.item[i].v;
            *array_push(&side) = (struct patch_mesh_edge){(size_t)v[k], (size_t)v[(k + 1) % 3], i};
        }
    if (side.n > 0)
        qsort(side.item, side.n, sizeof *side.item, compare_edges);
    for (size_t i = 0; i < q->edge.n; i++) {
        struct patch_mesh_edge *e = &q->edge.item[i], *now = NULL;
        if (side.n > 0 && e->face < faces && cut[e->face])
            now = bsearch(e, side.item, side.n, sizeof *e, compare_edges);
        if (now)
            e->face = now->face;
    }
    array_free(&side);
    free(cut);
}

void sew_insert(struct sewing *s)
{
    struct patch_mesh *q = s->mesh;
    struct insertions in = {0};
    size_t faces = q->face.n;
    insert_t_vertices(s, &in);
    if (in.n > 0)
        qsort(in.item, in.n, sizeof *in.item, compare_insertions);
    for (size_t i = 0, n; i < in.n; i += n) {
        for (n = 1; i + n < in.n && in.item[i + n].face == in.item[i].face;)
            n++;
        int sheet = q->sheet.item[in.item[i].face];
        split_face(q, &in.item[i], n, &s->patches->item[sheet].surface);
    }
    find_faces(q, &in, faces);
    array_free(&in);
}
