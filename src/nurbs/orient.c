/* orient - see orient.h. */
#include "nurbs/orient.h"

#include <stdlib.h>

/* A border edge between two places; forward: from the lower number to the higher. */
struct place_edge {
    size_t low, high;
    int sheet;
    bool forward;
    double length;
};

/* Two neighbours, and the length of edge along which they agree (+) or not (-), mm. */
struct bond {
    int a, b;
    double agree;
};

struct bonds {
    size_t n, cap;
    struct bond *item;
};

static int compare_place_edges(const void *p, const void *q)
{
    const struct place_edge *a = p, *b = q;
    if (a->low != b->low)
        return a->low < b->low ? -1 : 1;
    if (a->high != b->high)
        return a->high < b->high ? -1 : 1;
    if (a->sheet != b->sheet)
        return a->sheet < b->sheet ? -1 : 1;
    return (int)a->forward - (int)b->forward;
}

static int compare_bonds(const void *p, const void *q)
{
    const struct bond *a = p, *b = q;
    if (a->a != b->a)
        return a->a < b->a ? -1 : 1;
    if (a->b != b->b)
        return a->b < b->b ? -1 : 1;
    return a->agree < b->agree ? -1 : a->agree > b->agree;
}

static struct place_edge *place_edges_of(const struct patch_mesh *q, size_t *n)
{
    struct place_edge *edge = mem_alloc(q->edge.n + 1, sizeof *edge);
    *n = 0;
    for (size_t i = 0; i < q->edge.n; i++) {
        const struct patch_mesh_edge *e = &q->edge.item[i];
        const struct patch_mesh_vertex *a = &q->vertex.item[e->from], *b = &q->vertex.item[e->to];
        if (a->place == b->place)
            continue;
        bool forward = a->place < b->place;
        edge[(*n)++] =
            (struct place_edge){forward ? a->place : b->place, forward ? b->place : a->place,
                                a->sheet, forward, vec_distance(a->point, b->point)};
    }
    if (*n > 0)
        qsort(edge, *n, sizeof *edge, compare_place_edges);
    return edge;
}

/* Neighbours are sheets that share an edge with no third; the edges of a pair are summed up. */
static void find_bonds(const struct patch_mesh *q, struct bonds *bonds, size_t *open)
{
    size_t n, kept = 0;
    struct place_edge *edge = place_edges_of(q, &n);
    *open = 0;
    for (size_t i = 0, k; i < n; i += k) {
        const struct place_edge *s = &edge[i];
        for (k = 1; i + k < n && s[k].low == s->low && s[k].high == s->high;)
            k++;
        *open += k == 1;
        if (k == 2 && s[0].sheet != s[1].sheet)
            *array_push(bonds) = (struct bond){
                s[0].sheet, s[1].sheet, s[0].forward == s[1].forward ? -s->length : s->length};
    }
    free(edge);
    if (bonds->n == 0)
        return;
    qsort(bonds->item, bonds->n, sizeof *bonds->item, compare_bonds);
    for (size_t i = 1; i < bonds->n; i++) {
        struct bond *last = &bonds->item[kept], *b = &bonds->item[i];
        if (b->a == last->a && b->b == last->b)
            last->agree += b->agree;
        else
            bonds->item[++kept] = *b;
    }
    bonds->n = kept + 1;
}

static int compare_strength(const void *p, const void *q)
{
    const struct bond *a = p, *b = q;
    double x = fabs(a->agree), y = fabs(b->agree);
    if (x > y || x < y)
        return x > y ? -1 : 1;
    return a->a != b->a ? a->a - b->a : a->b - b->b;
}

/* Joins sheets to bodies, the longest common edges first (Kruskal): body[i] is the lowest sheet of
 * the body. */
static size_t join_bodies(struct patch_mesh *q, struct bonds *bonds, int *body)
{
    size_t conflicts = 0;
    if (bonds->n > 0)
        qsort(bonds->item, bonds->n, sizeof *bonds->item, compare_strength);
    for (size_t i = 0; i < bonds->n; i++) {
        const struct bond *b = &bonds->item[i];
        bool turn = (q->flipped[b->a] != q->flipped[b->b]) != (b->agree < 0);
        int from = body[b->a] > body[b->b] ? body[b->a] : body[b->b];
        int to = body[b->a] > body[b->b] ? body[b->b] : body[b->a];
        if (from == to) {
            conflicts += turn;
            continue;
        }
        for (size_t k = 0; k < q->sheets; k++)
            if (body[k] == from) {
                body[k] = to;
                q->flipped[k] = q->flipped[k] != turn;
            }
    }
    return conflicts;
}

struct body_sum {
    struct vec3 area;
    double total, volume;
};

/* Area as a vector and as a number, and volume about the first point, of one body. */
static struct body_sum sum_body(const struct patch_mesh *q, const int *body, int which)
{
    struct body_sum sum = {{0, 0, 0}, 0, 0};
    struct vec3 origin = {0, 0, 0};
    bool begun = false;
    for (size_t i = 0; i < q->face.n; i++) {
        int sheet = q->sheet.item[i];
        if (body[sheet] != which)
            continue;
        const struct patch_mesh_vertex *v = q->vertex.item;
        const int *c = q->face.item[i].v;
        if (!begun)
            origin = v[c[0]].point;
        begun = true;
        struct vec3 a = vec_sub(v[c[0]].point, origin), b = vec_sub(v[c[1]].point, origin);
        struct vec3 d = vec_sub(v[c[2]].point, origin);
        struct vec3 cross = vec_scale(0.5, vec_cross(vec_sub(b, a), vec_sub(d, a)));
        double sign = q->flipped[sheet] ? -1 : 1;
        sum.area = vec_along(sum.area, sign, cross);
        sum.total += vec_length(cross);
        sum.volume += sign * vec_dot(a, cross) / 3;
    }
    return sum;
}

struct orient_count orient_outward(struct patch_mesh *q, const struct patches *patches,
                                   struct vec3 up)
{
    struct orient_count count = {0};
    struct bonds bonds = {0};
    int *body = mem_alloc(q->sheets + 1, sizeof *body);
    for (size_t i = 0; i < q->sheets; i++)
        body[i] = (int)i;
    find_bonds(q, &bonds, &count.open);
    count.conflicts = join_bodies(q, &bonds, body);
    for (size_t i = 0; i < q->sheets; i++) {
        if (body[i] != (int)i)
            continue;
        struct body_sum sum = sum_body(q, body, (int)i);
        double along = vec_dot(sum.area, vec_unit(up));
        bool closed = vec_length(sum.area) <= ORIENT_CLOSED * sum.total;
        if (!(sum.total > 0))
            continue; /* trimmed away, or too narrow */
        count.bodies++;
        count.unclear += !closed && fabs(along) <= ORIENT_CLOSED * sum.total;
        bool cavity = patches && patches->item[i].cavity;
        bool turn = closed ? (sum.volume < 0) != cavity : along < 0;
        for (size_t k = 0; k < q->sheets && turn; k++)
            if (body[k] == (int)i)
                q->flipped[k] = !q->flipped[k];
    }
    array_free(&bonds);
    free(body);
    return count;
}
