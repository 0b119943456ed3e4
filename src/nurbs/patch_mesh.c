/* patch_mesh - see patch_mesh.h. */
#include "nurbs/patch_mesh.h"

#include <stdlib.h>

static int low_end(const struct face *f, int side)
{
    int a = f->v[side], b = f->v[(side + 1) % 3];
    return a < b ? a : b;
}

static int high_end(const struct face *f, int side)
{
    int a = f->v[side], b = f->v[(side + 1) % 3];
    return a > b ? a : b;
}

/* Edges of one triangle only: all edges sorted by their lower vertex, then compared. */
static void find_borders(const struct sheet *s, size_t first_vertex, size_t first_face,
                         struct patch_mesh_edges *edge)
{
    size_t n = s->at.n;
    size_t *from = mem_alloc(n + 2, sizeof *from),
           *list = mem_alloc(3 * s->face.n + 1, sizeof *list);
    for (size_t i = 0; i < 3 * s->face.n; i++)
        from[low_end(&s->face.item[i / 3], (int)(i % 3)) + 2]++;
    for (size_t i = 0; i + 2 < n + 2; i++)
        from[i + 2] += from[i + 1];
    for (size_t i = 0; i < 3 * s->face.n; i++)
        list[from[low_end(&s->face.item[i / 3], (int)(i % 3)) + 1]++] = i;
    for (size_t v = 0; v < n; v++)
        for (size_t i = from[v]; i < from[v + 1]; i++) {
            const struct face *f = &s->face.item[list[i] / 3];
            int side = (int)(list[i] % 3), high = high_end(f, side), same = 0;
            for (size_t k = from[v]; k < from[v + 1]; k++)
                same += high_end(&s->face.item[list[k] / 3], (int)(list[k] % 3)) == high;
            if (same == 1)
                *array_push(edge) = (struct patch_mesh_edge){
                    first_vertex + (size_t)f->v[side], first_vertex + (size_t)f->v[(side + 1) % 3],
                    first_face + list[i] / 3};
        }
    free(from);
    free(list);
}

/* The mean width of a strip: twice its area by its border, whose edges begin at `edge`. */
static double width_of(const struct sheet *s, const struct patch_mesh *q, size_t edge, size_t first)
{
    double area = 0, border = 0;
    const struct vec3 *p = s->point.item;
    for (size_t k = 0; k < s->face.n; k++) {
        const int *v = s->face.item[k].v;
        struct vec3 a = vec_sub(p[v[1]], p[v[0]]), b = vec_sub(p[v[2]], p[v[0]]);
        area += vec_length(vec_cross(a, b)) / 2;
    }
    for (size_t k = edge; k < q->edge.n; k++)
        border += vec_distance(p[q->edge.item[k].from - first], p[q->edge.item[k].to - first]);
    return border > 0 ? 2 * area / border : HUGE_VAL;
}

void patch_mesh_make(const struct sheet *sheet, size_t n, double least, struct patch_mesh *q)
{
    *q = (struct patch_mesh){.sheets = n};
    q->flipped = mem_alloc(n + 1, sizeof *q->flipped);
    for (size_t i = 0; i < n; i++) {
        const struct sheet *s = &sheet[i];
        size_t first = q->vertex.n, edge = q->edge.n;
        find_borders(s, first, q->face.n, &q->edge);
        if (n > 1 && s->face.n > 0 && width_of(s, q, edge, first) < least) {
            q->edge.n = edge;
            q->narrow++;
            continue;
        }
        for (size_t k = 0; k < s->at.n; k++)
            *array_push(&q->vertex) = (struct patch_mesh_vertex){.point = s->point.item[k],
                                                                 .normal = s->normal.item[k],
                                                                 .k1 = s->k1.item[k],
                                                                 .k2 = s->k2.item[k],
                                                                 .at = s->at.item[k],
                                                                 .sheet = (int)i,
                                                                 .piece = s->piece.item[k],
                                                                 .place = first + k,
                                                                 .next = first + k};
        for (size_t k = 0; k < s->face.n; k++) {
            struct face f = s->face.item[k];
            for (int c = 0; c < 3; c++)
                f.v[c] += (int)first;
            *array_push(&q->face) = f;
            *array_push(&q->sheet) = (int)i;
        }
    }
}

bool patch_mesh_same_piece(const struct patch_mesh_vertex *a, const struct patch_mesh_vertex *b)
{
    return a->sheet == b->sheet && a->piece == b->piece;
}

void patch_mesh_unite(struct patch_mesh *q, size_t a, size_t b)
{
    struct patch_mesh_vertex *v = q->vertex.item;
    size_t pa = v[a].place, pb = v[b].place, keep = pa < pb ? pa : pb, swap;
    size_t from = keep == pa ? b : a, i = from;
    if (pa == pb)
        return;
    do {
        v[i].place = keep;
        i = v[i].next;
    } while (i != from);
    swap = v[a].next;
    v[a].next = v[b].next;
    v[b].next = swap;
}

/* All vertices ordered by place. */
static size_t *by_place(const struct patch_mesh *q, size_t *from)
{
    size_t n = q->vertex.n;
    size_t *order = mem_alloc(n + 1, sizeof *order);
    for (size_t i = 0; i < n; i++)
        from[q->vertex.item[i].place + 2]++;
    for (size_t i = 0; i < n; i++)
        from[i + 2] += from[i + 1];
    for (size_t i = 0; i < n; i++)
        order[from[q->vertex.item[i].place + 1]++] = i;
    return order;
}

static struct vec3 normal_of(const struct patch_mesh *q, const struct patch_mesh_vertex *v)
{
    return q->flipped[v->sheet] ? vec_scale(-1, v->normal) : v->normal;
}

/* The vertices of one place as vertices of the mesh: groups of alike normals about the first that
 * is in no group yet. */
static void merge_place(const struct patch_mesh *q, const size_t *member, size_t n, int *name,
                        struct mesh *mesh)
{
    double near = cos(RADIANS(PATCH_MESH_SMOOTH));
    struct vec3 point = q->vertex.item[q->vertex.item[member[0]].place].point;
    for (size_t i = 0; i < n; i++)
        name[member[i]] = -1;
    for (size_t i = 0; i < n; i++) {
        struct vec3 first = normal_of(q, &q->vertex.item[member[i]]), sum = {0, 0, 0};
        double kmax = -HUGE_VAL;
        if (name[member[i]] >= 0)
            continue;
        for (size_t k = i; k < n; k++) {
            const struct patch_mesh_vertex *v = &q->vertex.item[member[k]];
            struct vec3 normal = normal_of(q, v);
            if (name[member[k]] >= 0 || (k > i && vec_dot(normal, first) < near))
                continue;
            name[member[k]] = (int)mesh->vertex.n;
            sum = vec_add(sum, normal);
            kmax = fmax(kmax, q->flipped[v->sheet] ? -v->k2 : v->k1);
        }
        *array_push(&mesh->vertex) = point;
        *array_push(&mesh->normal) = vec_unit(sum);
        *array_push(&mesh->kmax) = kmax;
    }
}

void patch_mesh_mesh(const struct patch_mesh *q, struct mesh *mesh)
{
    size_t n = q->vertex.n;
    size_t *from = mem_alloc(n + 3, sizeof *from), *order = by_place(q, from);
    int *name = mem_alloc(n + 1, sizeof *name);
    for (size_t i = 0; i < n; i++)
        if (from[i + 1] > from[i])
            merge_place(q, order + from[i], from[i + 1] - from[i], name, mesh);
    for (size_t i = 0; i < q->face.n; i++) {
        struct face f = q->face.item[i];
        const struct patch_mesh_vertex *v = q->vertex.item;
        size_t a = v[f.v[0]].place, b = v[f.v[1]].place, c = v[f.v[2]].place;
        bool flip = q->flipped[q->sheet.item[i]];
        if (a == b || b == c || c == a)
            continue;
        *array_push(&mesh->surface) = q->sheet.item[i];
        *array_push(&mesh->face) =
            (struct face){{name[f.v[0]], name[f.v[flip ? 2 : 1]], name[f.v[flip ? 1 : 2]]}};
    }
    free(from);
    free(order);
    free(name);
}

void patch_mesh_free(struct patch_mesh *q)
{
    array_free(&q->vertex);
    array_free(&q->face);
    array_free(&q->sheet);
    array_free(&q->edge);
    free(q->flipped);
    *q = (struct patch_mesh){0};
}
