/*
 * sew - borders of several patches made to share their vertices.
 *
 * The gap grows from round to round; in each round
 * 1. the border is found: the edges that one triangle alone has (boundary_find);
 * 2. T-vertices are found: border vertices that lie on a border edge of another patch
 *    (find_t_vertices);
 * 3. borders that run side by side are distinguished from those that only touch or cross
 *    (match_boundaries);
 * 4. vertices of matched borders get one place (join_pairs);
 * 5. T-vertices are put into the edges that they lie on (insert_t_vertices);
 * 6. slits that are left, between an edge and others from one of its ends, are closed
 * (close_slits). At the end the vertices of each place are moved to the middle of them
 * (move_to_middles).
 */
#include "nurbs/sew.h"

#include <stdlib.h>

#include "math/earclip.h"
#include "math/kdtree.h"
#include "nurbs/tessellate.h"

static const size_t NOWHERE = SIZE_MAX;

/* By the size of the whole: vertices so near are the same, even on one piece (at a pole, along a
 * seam). */
static const double SAME = 1e-9;

/* The gap of the first round by the size of the whole, and at least by the last gap; how many times
 * wider each next gap is. */
static const double FIRST = 1e-5, LEAST = 1e-3, WIDER = 5;

/* In gaps: two borders that run side by side for less only touch. */
static const double RUN_LEAST = 10;

/* The edges that no second triangle shares. */
struct boundary {
    struct sizes edge;   /* of patch_mesh.edge */
    struct sizes vertex; /* at their ends, rising */
    struct kdtree *tree; /* of these vertices */
};

/* A vertex that lies on a border edge. */
struct t_vertex {
    double t;      /* how far along the edge, 0 to 1 */
    size_t vertex; /* whose place it takes */
    struct uv at;  /* its parameters on the surface of the edge */
};

struct t_vertices {
    size_t n, cap;
    struct t_vertex *item;
};

/* A vertex that meets the border of a sheet.  Pairs along connected border edges form a run, named
 * by the index of one of its pairs (union-find). */
struct boundary_pair {
    size_t vertex;
    int sheet;
    size_t run;
    double length; /* of the run, in the pair that names it, mm */
};

struct boundary_match {
    size_t n, cap;
    struct boundary_pair *item; /* by vertex and sheet */
};

/* One round. */
struct sewing {
    struct patch_mesh *mesh;
    const struct patches *patches;
    struct boundary border;
    struct boundary_match match;
    double gap;         /* mm: what is nearer meets */
    double slack;       /* mm: how far border edges of trimmed patches may be off the true border */
    double off_surface; /* mm: how far T-vertices may be off the surface of their edge */
    double same;        /* mm: vertices so near are one */
    bool slits;         /* T-vertices are those that an open edge joins to an end of their edge */
    size_t
        *next; /* of each place, when it is about slits: a place beside it along an open edge ... */
    size_t *last; /* ... and another one; NOWHERE: there is none, or there are more than two */
};

struct place_edge {
    size_t low, high, edge;
};

static int compare_place_edges(const void *p, const void *q)
{
    const struct place_edge *a = p, *b = q;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    return a->edge < b->edge ? -1 : a->edge > b->edge;
}

static int compare_sizes(const void *p, const void *q)
{
    const size_t *a = p, *b = q;
    return *a < *b ? -1 : *a > *b;
}

/* The edges between two places that occur once. */
static void find_open_edges(const struct patch_mesh *q, struct sizes *edge)
{
    struct place_edge *all = mem_alloc(q->edge.n + 1, sizeof *all);
    size_t n = 0;
    for (size_t i = 0; i < q->edge.n; i++) {
        size_t a = q->vertex.item[q->edge.item[i].from].place;
        size_t b = q->vertex.item[q->edge.item[i].to].place;
        if (a != b)
            all[n++] = (struct place_edge){a < b ? a : b, a < b ? b : a, i};
    }
    if (n > 0)
        qsort(all, n, sizeof *all, compare_place_edges);
    for (size_t i = 0, k; i < n; i += k) {
        for (k = 1; i + k < n && all[i + k].low == all[i].low && all[i + k].high == all[i].high;)
            k++;
        if (k == 1)
            *array_push(edge) = all[i].edge;
    }
    if (edge->n > 0)
        qsort(edge->item, edge->n, sizeof *edge->item, compare_sizes);
    free(all);
}

static void boundary_find(const struct patch_mesh *q, struct boundary *b)
{
    bool *seen = mem_alloc(q->vertex.n + 1, sizeof *seen);
    struct vec3s point = {0};
    *b = (struct boundary){0};
    find_open_edges(q, &b->edge);
    for (size_t i = 0; i < b->edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[b->edge.item[i]];
        seen[e->from] = seen[e->to] = true;
    }
    for (size_t i = 0; i < q->vertex.n; i++)
        if (seen[i]) {
            *array_push(&b->vertex) = i;
            *array_push(&point) = q->vertex.item[i].point;
        }
    b->tree = kdtree_new(point.item, point.n);
    array_free(&point);
    free(seen);
}

static void boundary_free(struct boundary *b)
{
    array_free(&b->edge);
    array_free(&b->vertex);
    kdtree_free(b->tree);
    b->tree = NULL;
}

static const struct patch_mesh_vertex *vertex_at(const struct sewing *s, size_t i)
{
    return &s->mesh->vertex.item[i];
}

/* True if the two vertices are neighbours on the same piece and not the two sides of a seam: less
 * than half the range apart. */
static bool are_beside(const struct patches *patches, const struct patch_mesh_vertex *a,
                       const struct patch_mesh_vertex *b)
{
    if (!patch_mesh_same_piece(a, b))
        return false;
    const struct nurbs *s = &patches->item[a->sheet].surface;
    return fabs(a->at.u - b->at.u) < 0.5 * (s->u.to - s->u.from) &&
           fabs(a->at.v - b->at.v) < 0.5 * (s->v.to - s->v.from);
}

static int compare_t_vertices(const void *p, const void *q)
{
    const struct t_vertex *a = p, *b = q;
    if (a->t < b->t || a->t > b->t)
        return a->t < b->t ? -1 : 1;
    return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static bool is_place_beside(const struct sewing *s, size_t i, const struct patch_mesh_vertex *of)
{
    size_t k = i;
    do {
        if (are_beside(s->patches, vertex_at(s, k), of))
            return true;
        k = vertex_at(s, k)->next;
    } while (k != i);
    return false;
}

static struct uv uv_mix(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
}

static bool has_place(const struct sewing *s, const struct t_vertices *on_edge, size_t place)
{
    for (size_t i = 0; i < on_edge->n; i++)
        if (vertex_at(s, on_edge->item[i].vertex)->place == place)
            return true;
    return false;
}

/* Does an open edge lead from the place to one of these? */
static bool joins_end(const struct sewing *s, size_t place, size_t a, size_t b)
{
    return s->next[place] == a || s->next[place] == b || s->last[place] == a || s->last[place] == b;
}

/* The border vertices within `far` of a point that a sheet may be joined to.  Places in
 * border.vertex. */
static void find_near(const struct sewing *s, struct vec3 p, double far, int sheet,
                      struct sizes *found)
{
    size_t kept = 0;
    found->n = 0;
    kdtree_within(s->border.tree, p, far, found);
    for (size_t k = 0; k < found->n; k++) {
        int other = vertex_at(s, s->border.vertex.item[found->item[k]])->sheet;
        if (patch_may_join(&s->patches->item[other], &s->patches->item[sheet]))
            found->item[kept++] = found->item[k];
    }
    found->n = kept;
}

/* How far the surface is off the chord of an edge: however unevenly the parameters run along it. */
static double bulge_of(const struct nurbs *part, const struct patch_mesh_vertex *a,
                       const struct patch_mesh_vertex *b)
{
    double most = 0;
    for (int i = 1; i < 4; i++) {
        struct vec3 on = nurbs_point(part, uv_mix(a->at, b->at, i / 4.0));
        most = fmax(most, vec_segment_distance(a->point, b->point, on));
    }
    return most;
}

/* The vertices, in the order of the edge, that lie between its ends, near its chord as far as the
 * surface and the slack allow, and within the gap of the edge's surface `part`. */
static void find_t_vertices(const struct sewing *s, const struct nurbs *part,
                            const struct patch_mesh_edge *e, struct t_vertices *on_edge)
{
    const struct patch_mesh_vertex *a = vertex_at(s, e->from), *b = vertex_at(s, e->to);
    struct vec3 d = vec_sub(b->point, a->point), middle = vec_mix(a->point, b->point, 0.5);
    struct sizes found = {0};
    double length = vec_length(d), bulge = -1;
    on_edge->n = 0;
    find_near(s, middle, length / 2 + s->gap, a->sheet, &found);
    for (size_t k = 0; k < found.n; k++) {
        size_t i = s->border.vertex.item[found.item[k]];
        const struct patch_mesh_vertex *p = vertex_at(s, i);
        if (p->place == a->place || p->place == b->place || is_place_beside(s, i, a) ||
            has_place(s, on_edge, p->place) ||
            (s->slits && !joins_end(s, p->place, a->place, b->place)))
            continue;
        if (bulge < 0)
            bulge = bulge_of(part, a, b);
        struct vec3 r = vec_sub(p->point, a->point);
        double t = vec_dot(r, d) / (length * length);
        double off = vec_length(vec_along(r, -t, d));
        if (!(t > 1e-6 && t < 1 - 1e-6) || off > 1.5 * bulge + s->slack + s->gap)
            continue;
        struct uv at = nurbs_foot(part, p->point, uv_mix(a->at, b->at, t));
        if (vec_distance(nurbs_point(part, at), p->point) <= s->off_surface)
            *array_push(on_edge) = (struct t_vertex){t, i, at};
    }
    if (on_edge->n > 1)
        qsort(on_edge->item, on_edge->n, sizeof *on_edge->item, compare_t_vertices);
    array_free(&found);
}

static int compare_boundary_pairs(const void *p, const void *q)
{
    const struct boundary_pair *a = p, *b = q;
    if (a->vertex != b->vertex)
        return a->vertex < b->vertex ? -1 : 1;
    return (a->sheet > b->sheet) - (a->sheet < b->sheet);
}

static void add_pair(struct boundary_match *c, size_t vertex, int sheet)
{
    *array_push(c) = (struct boundary_pair){.vertex = vertex, .sheet = sheet};
}

/* Pairs of vertices of two borders within the gap, and of all that share a place. */
static void add_pairs(const struct sewing *s, struct boundary_match *c)
{
    const struct patch_mesh_vertex *v = s->mesh->vertex.item;
    struct sizes found = {0};
    for (size_t k = 0; k < s->border.vertex.n; k++) {
        size_t i = s->border.vertex.item[k];
        for (size_t j = v[i].next; j != i; j = v[j].next)
            if (!are_beside(s->patches, &v[i], &v[j]))
                add_pair(c, i, v[j].sheet);
        find_near(s, v[i].point, s->gap, v[i].sheet, &found);
        for (size_t f = 0; f < found.n; f++) {
            size_t j = s->border.vertex.item[found.item[f]];
            if (j != i && !are_beside(s->patches, &v[i], &v[j]))
                add_pair(c, i, v[j].sheet);
        }
    }
    array_free(&found);
}

/* Pairs of T-vertices and the sheets whose edges they lie on. */
static void add_t_vertex_pairs(const struct sewing *s, struct boundary_match *c)
{
    const struct patch_mesh *q = s->mesh;
    struct t_vertices on_edge = {0};
    struct nurbs part = {0};
    int sheet = -1, piece = -1;
    for (size_t i = 0; i < s->border.edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[s->border.edge.item[i]];
        const struct patch_mesh_vertex *a = &q->vertex.item[e->from];
        if (a->sheet != sheet || a->piece != piece)
            part = tessellate_piece(&s->patches->item[a->sheet].surface, a->piece);
        sheet = a->sheet;
        piece = a->piece;
        find_t_vertices(s, &part, e, &on_edge);
        for (size_t k = 0; k < on_edge.n; k++) {
            size_t first = on_edge.item[k].vertex, now = first;
            do
                add_pair(c, now, sheet);
            while ((now = q->vertex.item[now].next) != first);
        }
    }
    array_free(&on_edge);
}

static struct boundary_pair *find_pair(const struct boundary_match *c, size_t vertex, int sheet)
{
    struct boundary_pair key = {.vertex = vertex, .sheet = sheet};
    return c->n > 0 ? bsearch(&key, c->item, c->n, sizeof key, compare_boundary_pairs) : NULL;
}

static size_t run_of(struct boundary_match *c, size_t i)
{
    while (c->item[i].run != i)
        i = c->item[i].run = c->item[c->item[i].run].run;
    return i;
}

/* Where both ends of a border edge meet the same sheet, their pairs belong to one run. */
static void join_runs(const struct sewing *s, struct boundary_match *c)
{
    for (size_t k = 0; k < s->border.edge.n; k++) {
        const struct patch_mesh_edge *e = &s->mesh->edge.item[s->border.edge.item[k]];
        const struct patch_mesh_vertex *v = s->mesh->vertex.item;
        double length = vec_distance(v[e->from].point, v[e->to].point);
        struct boundary_pair key = {.vertex = e->from, .sheet = -1};
        size_t low = 0, high = c->n;
        while (low < high) {
            size_t middle = low + (high - low) / 2;
            if (compare_boundary_pairs(&c->item[middle], &key) < 0)
                low = middle + 1;
            else
                high = middle;
        }
        for (; low < c->n && c->item[low].vertex == e->from; low++) {
            struct boundary_pair *other = find_pair(c, e->to, c->item[low].sheet);
            if (!other)
                continue;
            size_t a = run_of(c, low), b = run_of(c, (size_t)(other - c->item));
            c->item[a].length += length;
            if (a != b) {
                c->item[a].length += c->item[b].length;
                c->item[b].run = a;
            }
        }
    }
}

/* All pairs and the runs that they form: border edges of which both ends meet the border of one
 * other sheet, or of the same sheet half its range away. */
static void match_boundaries(const struct sewing *s, struct boundary_match *c)
{
    size_t kept = 0;
    *c = (struct boundary_match){0};
    add_pairs(s, c);
    add_t_vertex_pairs(s, c);
    if (c->n > 0)
        qsort(c->item, c->n, sizeof *c->item, compare_boundary_pairs);
    for (size_t i = 0; i < c->n; i++)
        if (i == 0 || compare_boundary_pairs(&c->item[i], &c->item[kept - 1]) != 0)
            c->item[kept++] = c->item[i];
    c->n = kept;
    for (size_t i = 0; i < c->n; i++)
        c->item[i].run = i;
    join_runs(s, c);
    for (size_t i = 0; i < c->n; i++)
        c->item[i].run = run_of(c, i);
}

/* Does the border at this vertex run along the border of the sheet? */
static bool is_matched(const struct sewing *s, size_t vertex, int sheet)
{
    const struct boundary_pair *one = find_pair(&s->match, vertex, sheet);
    return one && s->match.item[one->run].length >= RUN_LEAST * s->gap;
}

/* Drops the T-vertices of an edge of the sheet whose own border does not run along it. */
static void keep_matched(const struct sewing *s, int sheet, struct t_vertices *on_edge)
{
    size_t kept = 0;
    for (size_t i = 0; i < on_edge->n; i++)
        if (is_matched(s, on_edge->item[i].vertex, sheet))
            on_edge->item[kept++] = on_edge->item[i];
    on_edge->n = kept;
}

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
    const struct patch_mesh_vertex *a = vertex_at(s, e->from);
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
        const struct patch_mesh_vertex *a = vertex_at(s, e.from);
        if (a->place == vertex_at(s, e.to)->place)
            continue;
        if (a->sheet != sheet || a->piece != piece) {
            sheet = a->sheet;
            piece = a->piece;
            part = tessellate_piece(&s->patches->item[sheet].surface, piece);
        }
        find_t_vertices(s, &part, &e, &on_edge);
        if (!s->slits)
            keep_matched(s, a->sheet, &on_edge);
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
        if (e->face < faces && cut[e->face])
            now = bsearch(e, side.item, side.n, sizeof *e, compare_edges);
        if (now)
            e->face = now->face;
    }
    array_free(&side);
    free(cut);
}

static void insert_and_split(struct sewing *s)
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

/* Two vertices that may become one. */
struct pair {
    double distance;
    size_t a, b;
};

struct pairs {
    size_t n, cap;
    struct pair *item;
};

static int compare_pairs(const void *p, const void *q)
{
    const struct pair *a = p, *b = q;
    if (a->distance < b->distance || a->distance > b->distance)
        return a->distance < b->distance ? -1 : 1;
    if (a->a != b->a)
        return a->a < b->a ? -1 : 1;
    return a->b < b->b ? -1 : a->b > b->b;
}

/* Pairs of vertices within the gap; of those in one spot only the pair with the lowest number. */
static void find_pairs(const struct sewing *s, struct pairs *pairs)
{
    struct sizes found = {0};
    for (size_t k = 0; k < s->border.vertex.n; k++) {
        size_t i = s->border.vertex.item[k], lowest = i;
        const struct patch_mesh_vertex *a = vertex_at(s, i);
        find_near(s, a->point, s->gap, a->sheet, &found);
        for (size_t m = 0; m < found.n; m++) {
            size_t j = s->border.vertex.item[found.item[m]];
            double d = vec_distance(a->point, vertex_at(s, j)->point);
            if (d <= s->same)
                lowest = j < lowest ? j : lowest;
            else if (j < i && !are_beside(s->patches, a, vertex_at(s, j)) &&
                     (is_matched(s, i, vertex_at(s, j)->sheet) || is_matched(s, j, a->sheet)))
                *array_push(pairs) = (struct pair){d, j, i};
        }
        if (lowest < i)
            *array_push(pairs) = (struct pair){0, lowest, i};
    }
    array_free(&found);
    if (pairs->n > 0)
        qsort(pairs->item, pairs->n, sizeof *pairs->item, compare_pairs);
}

/* Would one place hold two vertices of a border that are apart, so that it folds onto itself? */
static bool would_fold(const struct sewing *s, size_t a, size_t b)
{
    size_t i = a;
    do {
        size_t k = b;
        do {
            if (are_beside(s->patches, vertex_at(s, i), vertex_at(s, k)) &&
                vec_distance(vertex_at(s, i)->point, vertex_at(s, k)->point) > s->same)
                return true;
            k = vertex_at(s, k)->next;
        } while (k != b);
        i = vertex_at(s, i)->next;
    } while (i != a);
    return false;
}

static size_t join_pairs(const struct sewing *s)
{
    struct pairs pairs = {0};
    size_t joined = 0;
    find_pairs(s, &pairs);
    for (size_t i = 0; i < pairs.n; i++) {
        const struct pair *p = &pairs.item[i];
        bool spot = p->distance <= s->same;
        if (vertex_at(s, p->a)->place == vertex_at(s, p->b)->place ||
            (!spot && would_fold(s, p->a, p->b)))
            continue;
        patch_mesh_unite(s->mesh, p->a, p->b);
        joined++;
    }
    array_free(&pairs);
    return joined;
}

/* The places beside each one along the open edges. */
static void find_beside(struct sewing *s)
{
    const struct patch_mesh *q = s->mesh;
    unsigned char *n = mem_alloc(q->vertex.n + 1, sizeof *n);

    s->next = mem_alloc(q->vertex.n + 1, sizeof *s->next);
    s->last = mem_alloc(q->vertex.n + 1, sizeof *s->last);
    for (size_t i = 0; i < q->vertex.n; i++)
        s->next[i] = s->last[i] = NOWHERE;
    for (size_t i = 0; i < s->border.edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[s->border.edge.item[i]];
        size_t place[2] = {vertex_at(s, e->from)->place, vertex_at(s, e->to)->place};
        for (int k = 0; k < 2; k++) {
            size_t of = place[k];
            n[of] = (unsigned char)(n[of] < 3 ? n[of] + 1 : 3);
            *(n[of] == 1 ? &s->next[of] : &s->last[of]) = place[1 - k];
        }
    }
    for (size_t i = 0; i < q->vertex.n; i++)
        if (n[i] > 2)
            s->next[i] = s->last[i] = NOWHERE;
    free(n);
}

/* What two borders within the gap have left open is short: no run tells that they belong together,
 * but where an edge and the next one from its end lie side by side there is nothing between. */
static size_t close_slits(struct sewing *s, double off_surface)
{
    enum { ROUNDS = 12 };
    size_t first = s->mesh->vertex.n, before = first + 1;

    s->slits = true;
    s->off_surface = off_surface;
    for (int i = 0; i < ROUNDS && s->mesh->vertex.n != before; i++) {
        before = s->mesh->vertex.n;
        boundary_find(s->mesh, &s->border);
        find_beside(s);
        insert_and_split(s);
        boundary_free(&s->border);
        free(s->next);
        free(s->last);
    }
    s->slits = false;
    return s->mesh->vertex.n - first;
}

/* Moves all vertices of a place to their middle; returns the largest move, mm. */
static double move_to_middles(struct patch_mesh *q, double same)
{
    double most = 0;
    for (size_t i = 0; i < q->vertex.n; i++) {
        struct patch_mesh_vertex *v = q->vertex.item;
        struct vec3 sum = {0, 0, 0};
        double n = 0, apart = 0;
        if (v[i].place != i || v[i].next == i)
            continue;
        size_t k = i;
        do {
            sum = vec_add(sum, v[k].point);
            apart = fmax(apart, vec_distance(v[k].point, v[i].point));
            n++;
            k = v[k].next;
        } while (k != i);
        struct vec3 middle = apart > same ? vec_scale(1 / n, sum) : v[i].point;
        do {
            most = fmax(most, vec_distance(v[k].point, middle));
            v[k].point = middle;
            k = v[k].next;
        } while (k != i);
    }
    return most;
}

/* The diagonal, roughly: the farthest vertex from the first one. */
static double size_of(const struct patch_mesh *q)
{
    double size = 0;
    for (size_t i = 0; i < q->vertex.n; i++)
        size = fmax(size, vec_distance(q->vertex.item[i].point, q->vertex.item[0].point));
    return size;
}

/* The vertices of a side that is one point, as a pole, are one: else each of them would be compared
 * with all others. */
static void join_poles(struct sewing *s)
{
    for (size_t i = 0; i < s->mesh->edge.n; i++) {
        const struct patch_mesh_edge *e = &s->mesh->edge.item[i];
        if (vec_distance(vertex_at(s, e->from)->point, vertex_at(s, e->to)->point) <= s->same)
            patch_mesh_unite(s->mesh, e->from, e->to);
    }
}

struct sew_count sew(struct patch_mesh *q, const struct patches *patches, double gap, double slack)
{
    struct sew_count count = {0};
    double size = size_of(q);
    struct sewing s = {
        .mesh = q, .patches = patches, .slack = slack, .same = fmin(SAME * size, gap)};
    join_poles(&s);
    for (s.gap = fmin(fmax(FIRST * size, LEAST * gap), gap);; s.gap = fmin(WIDER * s.gap, gap)) {
        size_t before = q->vertex.n;
        s.off_surface = s.gap;
        boundary_find(q, &s.border);
        match_boundaries(&s, &s.match);
        count.joined += join_pairs(&s);
        insert_and_split(&s);
        count.inserted += q->vertex.n - before;
        boundary_free(&s.border);
        array_free(&s.match);
        count.inserted += close_slits(&s, s.gap);
        if (s.gap >= gap)
            break;
    }
    /* A vertex of a trimmed border lies on a chord of it, off the neighbour's surface by the slack.
     */
    count.inserted += close_slits(&s, gap + slack);
    count.moved = move_to_middles(q, s.same);
    return count;
}
