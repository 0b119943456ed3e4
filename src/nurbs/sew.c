/*
 * sew - borders of several patches made to share their vertices.
 *
 * The gap grows from round to round; in each round
 * 1. the border is found: the edges that one triangle alone has (sew_find_border);
 * 2. T-vertices are found: border vertices that lie on a border edge of another patch
 *    (sew_find_t_vertices);
 * 3. borders that run side by side are distinguished from those that only touch or cross
 *    (sew_match);
 * 4. vertices of matched borders get one place (join_pairs);
 * 5. T-vertices are put into the edges that they lie on (sew_insert);
 * 6. slits that are left, between an edge and others from one of its ends, are closed
 * (close_slits). At the end the vertices of each place are moved to the middle of them
 * (move_to_middles).
 */
#include "nurbs/sew.h"

#include <stdlib.h>

#include "sew_steps.h"

static const size_t NOWHERE = SIZE_MAX;

/* By the size of the whole: vertices so near are the same, even on one piece (at a pole, along a
 * seam). */
static const double SAME = 1e-9;

/* The gap of the first round by the size of the whole, and at least by the last gap; how many times
 * wider each next gap is. */
static const double FIRST = 1e-5, LEAST = 1e-3, WIDER = 5;

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
        const struct patch_mesh_vertex *a = sew_vertex(s, i);
        sew_find_near(s, a->point, s->gap, a->sheet, &found);
        for (size_t m = 0; m < found.n; m++) {
            size_t j = s->border.vertex.item[found.item[m]];
            double d = vec_distance(a->point, sew_vertex(s, j)->point);
            if (d <= s->same)
                lowest = j < lowest ? j : lowest;
            else if (j < i && !sew_are_beside(s->patches, a, sew_vertex(s, j)) &&
                     (sew_is_matched(s, i, sew_vertex(s, j)->sheet) ||
                      sew_is_matched(s, j, a->sheet)))
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
            if (sew_are_beside(s->patches, sew_vertex(s, i), sew_vertex(s, k)) &&
                vec_distance(sew_vertex(s, i)->point, sew_vertex(s, k)->point) > s->same)
                return true;
            k = sew_vertex(s, k)->next;
        } while (k != b);
        i = sew_vertex(s, i)->next;
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
        if (sew_vertex(s, p->a)->place == sew_vertex(s, p->b)->place ||
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
        size_t place[2] = {sew_vertex(s, e->from)->place, sew_vertex(s, e->to)->place};
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
        sew_find_border(s->mesh, &s->border);
        find_beside(s);
        sew_insert(s);
        sew_free_border(&s->border);
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
        if (vec_distance(sew_vertex(s, e->from)->point, sew_vertex(s, e->to)->point) <= s->same)
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
        sew_find_border(q, &s.border);
        sew_match(&s, &s.match);
        count.joined += join_pairs(&s);
        sew_insert(&s);
        count.inserted += q->vertex.n - before;
        sew_free_border(&s.border);
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
