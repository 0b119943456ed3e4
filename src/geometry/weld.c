/* weld - see weld.h. */
#include "weld.h"

#include <stdlib.h>

#include "earclip.h"
#include "kdtree.h"

/* Vertices so near are the same, even of one piece: at a pole, along a seam. */
static const double SAME = 1e-9;

struct work {
    struct quilt *q;
    double gap, slack, same;
    struct sizes border; /* vertices on borders */
    struct kdtree *tree; /* of these */
    size_t *next;        /* ring of the vertices of a place */
};

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

static const struct quilt_vertex *vertex(const struct work *w, size_t i)
{
    return &w->q->vertex.item[i];
}

static bool same_piece(const struct quilt_vertex *a, const struct quilt_vertex *b)
{
    return a->sheet == b->sheet && a->piece == b->piece;
}

static void find_border_vertices(struct work *w)
{
    struct quilt *q = w->q;
    bool *seen = mem_alloc(q->vertex.n + 1, sizeof *seen);
    struct vec3s point = {0};
    for (size_t i = 0; i < q->edge.n; i++)
        seen[q->edge.item[i].from] = seen[q->edge.item[i].to] = true;
    for (size_t i = 0; i < q->vertex.n; i++)
        if (seen[i]) {
            *array_push(&w->border) = i;
            *array_push(&point) = q->vertex.item[i].point;
        }
    w->tree = kdtree_new(point.item, point.n);
    array_free(&point);
    free(seen);
}

/* Pairs within the gap; of those in one spot only the one with the lowest number. */
static void find_pairs(const struct work *w, struct pairs *pairs)
{
    struct sizes found = {0};
    for (size_t k = 0; k < w->border.n; k++) {
        size_t i = w->border.item[k], lowest = i;
        const struct quilt_vertex *a = vertex(w, i);
        found.n = 0;
        kdtree_within(w->tree, a->point, w->gap, &found);
        for (size_t m = 0; m < found.n; m++) {
            size_t j = w->border.item[found.item[m]];
            double d = vec_distance(a->point, vertex(w, j)->point);
            if (d <= w->same)
                lowest = j < lowest ? j : lowest;
            else if (j < i && !same_piece(a, vertex(w, j)))
                *array_push(pairs) = (struct pair){d, j, i};
        }
        if (lowest < i)
            *array_push(pairs) = (struct pair){0, lowest, i};
    }
    array_free(&found);
    if (pairs->n > 0)
        qsort(pairs->item, pairs->n, sizeof *pairs->item, compare_pairs);
}

/* Would one place hold two vertices of a piece that are apart? */
static bool clash(const struct work *w, size_t a, size_t b)
{
    size_t i = a;
    do {
        size_t k = b;
        do {
            if (same_piece(vertex(w, i), vertex(w, k)) &&
                vec_distance(vertex(w, i)->point, vertex(w, k)->point) > w->same)
                return true;
            k = w->next[k];
        } while (k != b);
        i = w->next[i];
    } while (i != a);
    return false;
}

static void unite(const struct work *w, size_t a, size_t b)
{
    struct quilt_vertex *v = w->q->vertex.item;
    size_t pa = v[a].place, pb = v[b].place, keep = pa < pb ? pa : pb, swap;
    size_t from = keep == pa ? b : a, i = from;
    do {
        v[i].place = keep;
        i = w->next[i];
    } while (i != from);
    swap = w->next[a];
    w->next[a] = w->next[b];
    w->next[b] = swap;
}

static size_t join_pairs(struct work *w)
{
    struct pairs pairs = {0};
    size_t joined = 0;
    w->next = mem_alloc(w->q->vertex.n + 1, sizeof *w->next);
    for (size_t i = 0; i < w->q->vertex.n; i++)
        w->next[i] = i;
    find_pairs(w, &pairs);
    for (size_t i = 0; i < pairs.n; i++) {
        const struct pair *p = &pairs.item[i];
        bool spot = p->distance <= w->same;
        if (vertex(w, p->a)->place == vertex(w, p->b)->place || (!spot && clash(w, p->a, p->b)))
            continue;
        unite(w, p->a, p->b);
        joined++;
    }
    array_free(&pairs);
    return joined;
}

/* A vertex to be put into a border edge. */
struct guest {
    double t;
    size_t vertex; /* whose place it takes */
    struct uv at;
};

struct guests {
    size_t n, cap;
    struct guest *item;
};

static int compare_guests(const void *p, const void *q)
{
    const struct guest *a = p, *b = q;
    if (a->t < b->t || a->t > b->t)
        return a->t < b->t ? -1 : 1;
    return a->vertex < b->vertex ? -1 : a->vertex > b->vertex;
}

static bool place_has_piece(const struct work *w, size_t i, const struct quilt_vertex *of)
{
    size_t k = i;
    do {
        if (same_piece(vertex(w, k), of))
            return true;
        k = w->next[k];
    } while (k != i);
    return false;
}

static struct uv uv_mix(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
}

/* The places of other pieces that lie on the border edge: near its chord as far as the surface is,
 * and on the surface within the gap. */
static void find_guests(const struct work *w, const struct nurbs *part, const struct quilt_edge *e,
                        struct sizes *found, struct guests *guests)
{
    const struct quilt_vertex *a = vertex(w, e->from), *b = vertex(w, e->to);
    struct vec3 d = vec_sub(b->point, a->point), middle = vec_mix(a->point, b->point, 0.5);
    double length = vec_length(d);
    guests->n = found->n = 0;
    kdtree_within(w->tree, middle, length / 2 + w->gap, found);
    double bulge = -1;
    for (size_t m = 0; m < found->n; m++) {
        size_t i = w->border.item[found->item[m]];
        const struct quilt_vertex *p = vertex(w, i);
        if (p->place != i || i == a->place || i == b->place || place_has_piece(w, i, a))
            continue;
        if (bulge < 0)
            bulge = vec_distance(middle, nurbs_point(part, uv_mix(a->at, b->at, 0.5)));
        struct vec3 r = vec_sub(p->point, a->point);
        double t = vec_dot(r, d) / (length * length);
        double off = vec_length(vec_along(r, -t, d));
        if (!(t > 1e-6 && t < 1 - 1e-6) || off > 1.5 * bulge + w->slack + w->gap)
            continue;
        struct uv at = nurbs_foot(part, p->point, uv_mix(a->at, b->at, t));
        if (vec_distance(nurbs_point(part, at), p->point) <= w->gap)
            *array_push(guests) = (struct guest){t, i, at};
    }
    if (guests->n > 1)
        qsort(guests->item, guests->n, sizeof *guests->item, compare_guests);
}

/* What is put into one side of a triangle: vertices n from first on, in the order of the side. */
struct insertion {
    size_t face, first, n;
    int side;
};

struct insertions {
    size_t n, cap;
    struct insertion *item;
};

static size_t add_guest(struct work *w, const struct nurbs *part, const struct quilt_edge *e,
                        const struct guest *g)
{
    const struct quilt_vertex *a = vertex(w, e->from);
    struct nurbs_place on = nurbs_place(part, g->at);
    struct quilt_vertex v = {on.point, on.normal, on.k1,    on.k2,
                             g->at,    a->sheet,  a->piece, vertex(w, g->vertex)->place};
    *array_push(&w->q->vertex) = v;
    return w->q->vertex.n - 1;
}

static int side_of(const struct face *f, size_t from)
{
    return (size_t)f->v[0] == from ? 0 : (size_t)f->v[1] == from ? 1 : 2;
}

/* All border edges looked through; an edge with guests is replaced by the pieces of it. */
static void insert_guests(struct work *w, const struct patches *patches, struct insertions *to)
{
    struct quilt *q = w->q;
    struct sizes found = {0};
    struct guests guests = {0};
    int sheet = -1, piece = -1;
    struct nurbs part = {0};
    size_t edges = q->edge.n;
    for (size_t i = 0; i < edges; i++) {
        struct quilt_edge e = q->edge.item[i];
        const struct quilt_vertex *a = vertex(w, e.from);
        if (a->place == vertex(w, e.to)->place)
            continue;
        if (a->sheet != sheet || a->piece != piece) {
            sheet = a->sheet;
            piece = a->piece;
            part = tessellate_piece(&patches->item[sheet].surface, piece);
        }
        find_guests(w, &part, &e, &found, &guests);
        if (guests.n == 0)
            continue;
        struct insertion in = {e.face, q->vertex.n, guests.n,
                               side_of(&q->face.item[e.face], e.from)};
        *array_push(to) = in;
        size_t last = e.from;
        for (size_t k = 0; k < guests.n; k++) {
            size_t v = add_guest(w, &part, &e, &guests.item[k]);
            struct quilt_edge half = {last, v, e.face};
            if (k == 0)
                q->edge.item[i] = half;
            else
                *array_push(&q->edge) = half;
            last = v;
        }
        *array_push(&q->edge) = (struct quilt_edge){last, e.to, e.face};
    }
    array_free(&found);
    array_free(&guests);
}

static int compare_insertions(const void *p, const void *q)
{
    const struct insertion *a = p, *b = q;
    if (a->face != b->face)
        return a->face < b->face ? -1 : 1;
    return a->side - b->side;
}

/* A triangle with vertices put into its sides, cut up anew. */
static void split_face(struct quilt *q, const struct insertion *in, size_t n, const struct nurbs *s)
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

struct weld_count weld(struct quilt *q, const struct patches *patches, double gap, double slack)
{
    struct work w = {.q = q, .gap = gap, .slack = slack};
    struct insertions in = {0};
    struct weld_count count = {0};
    size_t before = q->vertex.n;
    double size = 0;
    for (size_t i = 0; i < q->vertex.n; i++)
        size = fmax(size, vec_distance(q->vertex.item[i].point, q->vertex.item[0].point));
    w.same = fmin(SAME * size, gap);
    find_border_vertices(&w);
    count.joined = join_pairs(&w);
    insert_guests(&w, patches, &in);
    count.inserted = q->vertex.n - before;
    if (in.n > 0)
        qsort(in.item, in.n, sizeof *in.item, compare_insertions);
    for (size_t i = 0, n; i < in.n; i += n) {
        for (n = 1; i + n < in.n && in.item[i + n].face == in.item[i].face;)
            n++;
        int sheet = q->sheet.item[in.item[i].face];
        split_face(q, &in.item[i], n, &patches->item[sheet].surface);
    }
    kdtree_free(w.tree);
    array_free(&w.border);
    array_free(&in);
    free(w.next);
    return count;
}
