/* orient - see orient.h. */
#include "nurbs/orient.h"

#include <stdlib.h>

#include "math/box.h"
#include "math/elementary.h"

/* Closed bodies of loose faces, that are looked at for others around them. */
enum { NESTED_MOST = 2000 };

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

/* ---- bodies within each other */

/* A closed body of loose faces, by its lowest sheet. */
struct closed_body {
    int body;
    struct box box;
    struct vec3 asked[3]; /* places on it */
};

struct closed_bodies {
    size_t n, cap;
    struct closed_body *item;
};

static struct vec3 corner_of(const struct patch_mesh *q, size_t face, int k)
{
    return q->vertex.item[q->face.item[face].v[k]].point;
}

/* The boxes of the bodies, and the middles of some of their facets. */
static void survey(const struct patch_mesh *q, const int *body, struct closed_bodies *all)
{
    size_t *number = mem_alloc(q->sheets + 1, sizeof *number);
    size_t *seen = mem_alloc(all->n + 1, sizeof *seen);
    for (size_t i = 0; i < all->n; i++) {
        number[all->item[i].body] = i + 1;
        all->item[i].box = box_empty();
    }
    for (size_t f = 0; f < q->face.n; f++) {
        size_t n = number[body[q->sheet.item[f]]];
        if (n == 0)
            continue;
        struct closed_body *b = &all->item[n - 1];
        struct vec3 p = corner_of(q, f, 0), r = corner_of(q, f, 1), t = corner_of(q, f, 2);
        box_add(&b->box, p);
        box_add(&b->box, r);
        box_add(&b->box, t);
        /* the first facet, and those whose numbers are twice as high each time */
        size_t count = seen[n - 1]++;
        if ((count & (count - 1)) == 0)
            for (int k = 0; k < 3; k++)
                if (count == 0 || (size_t)k == count % 3)
                    b->asked[k] = vec_scale(1 / 3.0, vec_add(p, vec_add(r, t)));
    }
    free(number);
    free(seen);
}

/* How often a body goes round a place: the solid angle of its facets (Van Oosterom and Strackee
 * 1983) by that of a sphere. */
static bool is_within(const struct patch_mesh *q, const int *body, int which, struct vec3 at)
{
    double angle = 0;
    for (size_t f = 0; f < q->face.n; f++) {
        if (body[q->sheet.item[f]] != which)
            continue;
        struct vec3 a = vec_sub(corner_of(q, f, 0), at), b = vec_sub(corner_of(q, f, 1), at);
        struct vec3 c = vec_sub(corner_of(q, f, 2), at);
        double la = vec_length(a), lb = vec_length(b), lc = vec_length(c);
        double over = vec_dot(a, vec_cross(b, c));
        double under = la * lb * lc + vec_dot(a, b) * lc + vec_dot(b, c) * la + vec_dot(c, a) * lb;
        angle += (q->flipped[q->sheet.item[f]] ? -2 : 2) * atan2(over, under);
    }
    return fabs(angle) > 2 * PI;
}

/* Turns inwards what lies, with all places asked, within an odd number of others. */
static size_t turn_voids(struct patch_mesh *q, const int *body, struct closed_bodies *all)
{
    size_t voids = 0;
    bool *is_void = mem_alloc(all->n + 1, sizeof *is_void);
    survey(q, body, all);
    for (size_t i = 0; i < all->n; i++)
        for (size_t k = 0; k < all->n; k++) {
            const struct closed_body *in = &all->item[i], *out = &all->item[k];
            bool within = i != k && !(box_distance2(&out->box, in->box.low) > 0) &&
                          !(box_distance2(&out->box, in->box.high) > 0);
            for (int m = 0; m < 3 && within; m++)
                within = is_within(q, body, out->body, in->asked[m]);
            is_void[i] = is_void[i] != within;
        }
    for (size_t i = 0; i < all->n; i++) {
        voids += is_void[i];
        for (size_t k = 0; k < q->sheets && is_void[i]; k++)
            if (body[k] == all->item[i].body)
                q->flipped[k] = !q->flipped[k];
    }
    free(is_void);
    return voids;
}

struct orient_count orient_outward(struct patch_mesh *q, const struct patches *patches,
                                   struct vec3 up)
{
    struct orient_count count = {0};
    struct bonds bonds = {0};
    struct closed_bodies loose = {0};
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
        if (closed && patches && patches->item[i].body == 0)
            array_push(&loose)->body = (int)i;
        bool turn = closed ? (sum.volume < 0) != cavity : along < 0;
        for (size_t k = 0; k < q->sheets && turn; k++)
            if (body[k] == (int)i)
                q->flipped[k] = !q->flipped[k];
    }
    if (loose.n > 1 && loose.n <= NESTED_MOST)
        count.voids = turn_voids(q, body, &loose);
    array_free(&loose);
    array_free(&bonds);
    free(body);
    return count;
}
