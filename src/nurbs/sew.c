/* sew - see sew.h. */
#include "nurbs/sew.h"

#include <stdlib.h>

#include "boundary.h"
#include "sew_insert.h"

/* Vertices so near are the same, even of one piece: at a pole, along a seam. */
static const double SAME = 1e-9;

/* The first gap by the size of the whole, and at least by the last one; how much wider the next is.
 */
static const double FIRST = 1e-5, LEAST = 1e-3, WIDER = 5;

struct work {
    struct patch_mesh *q;
    struct meeting m;
    struct boundary_match company;
    double same;
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

static const struct patch_mesh_vertex *vertex(const struct work *w, size_t i)
{
    return &w->q->vertex.item[i];
}

/* Pairs within the gap; of those in one spot only the one with the lowest number. */
static void find_pairs(const struct work *w, struct pairs *pairs)
{
    struct sizes found = {0};
    for (size_t k = 0; k < w->m.border->vertex.n; k++) {
        size_t i = w->m.border->vertex.item[k], lowest = i;
        const struct patch_mesh_vertex *a = vertex(w, i);
        found.n = 0;
        kdtree_within(w->m.border->tree, a->point, w->m.gap, &found);
        for (size_t m = 0; m < found.n; m++) {
            size_t j = w->m.border->vertex.item[found.item[m]];
            double d = vec_distance(a->point, vertex(w, j)->point);
            if (d <= w->same)
                lowest = j < lowest ? j : lowest;
            else if (j < i && !t_vertices_beside(w->m.patches, a, vertex(w, j)) &&
                     (boundary_match_has(&w->company, i, vertex(w, j)->sheet) ||
                      boundary_match_has(&w->company, j, a->sheet)))
                *array_push(pairs) = (struct pair){d, j, i};
        }
        if (lowest < i)
            *array_push(pairs) = (struct pair){0, lowest, i};
    }
    array_free(&found);
    if (pairs->n > 0)
        qsort(pairs->item, pairs->n, sizeof *pairs->item, compare_pairs);
}

/* Would one place hold two vertices of a border that are apart? */
static bool clash(const struct work *w, size_t a, size_t b)
{
    size_t i = a;
    do {
        size_t k = b;
        do {
            if (t_vertices_beside(w->m.patches, vertex(w, i), vertex(w, k)) &&
                vec_distance(vertex(w, i)->point, vertex(w, k)->point) > w->same)
                return true;
            k = vertex(w, k)->next;
        } while (k != b);
        i = vertex(w, i)->next;
    } while (i != a);
    return false;
}

static size_t join_pairs(const struct work *w)
{
    struct pairs pairs = {0};
    size_t joined = 0;
    find_pairs(w, &pairs);
    for (size_t i = 0; i < pairs.n; i++) {
        const struct pair *p = &pairs.item[i];
        bool spot = p->distance <= w->same;
        if (vertex(w, p->a)->place == vertex(w, p->b)->place || (!spot && clash(w, p->a, p->b)))
            continue;
        patch_mesh_unite(w->q, p->a, p->b);
        joined++;
    }
    array_free(&pairs);
    return joined;
}

/* All vertices of a place to the middle of them: how far one goes at most. */
static double settle(struct patch_mesh *q, double same)
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

struct sew_count sew(struct patch_mesh *q, const struct patches *patches, double gap, double slack)
{
    struct boundary border;
    struct work w = {.q = q, .m = {q, patches, &border, 0, slack}};
    struct sew_count count = {0};
    double size = 0;
    for (size_t i = 0; i < q->vertex.n; i++)
        size = fmax(size, vec_distance(q->vertex.item[i].point, q->vertex.item[0].point));
    w.same = fmin(SAME * size, gap);
    for (w.m.gap = fmin(fmax(FIRST * size, LEAST * gap), gap);;
         w.m.gap = fmin(WIDER * w.m.gap, gap)) {
        size_t before = q->vertex.n;
        boundary_find(q, &border);
        boundary_match_find(&w.m, &w.company);
        count.joined += join_pairs(&w);
        sew_insert(q, &w.m, &w.company);
        count.inserted += q->vertex.n - before;
        boundary_free(&border);
        boundary_match_free(&w.company);
        if (w.m.gap >= gap)
            break;
    }
    count.moved = settle(q, w.same);
    return count;
}
