/* slice - see slice.h. */
#include "toolpath/slice.h"

#include <stdlib.h>

#include "curve/edge_curve.h"
#include "mesh/mesh_edges.h"

/* Points nearer than this say more of rounding than of a direction, mm. */
static const double CROWDED = 1e-3;

/* A vertex within this of a plane is on it, mm: coordinates of a mesh stream have 6 decimals. */
static const double ON_PLANE = 2e-6;

enum { NONE = -1 };

struct slice {
    const struct mesh *mesh;
    struct vec3 normal;
    bool smooth;
    struct mesh_edges edges;
    double *height; /* of each vertex along the normal */
    size_t *order;  /* facets by their lowest vertex */
    double *lowest; /* of the facets in that order */
    double tallest; /* of any facet */
    bool *done;     /* facets of the plane at hand */
};

void slice_chains_free(struct slice_chains *chains)
{
    array_free(&chains->point);
    array_free(&chains->chain);
}

void contacts_reverse(struct contact *c, size_t n)
{
    for (size_t i = 0, j = n; i + 1 < j; i++) {
        struct contact swap = c[i];
        c[i] = c[--j];
        c[j] = swap;
    }
}

double contacts_forward(const struct contact *c, size_t n, struct vec3 normal)
{
    double sum = 0;

    for (size_t i = 0; i + 1 < n; i++)
        sum += vec_dot(vec_sub(c[i + 1].p, c[i].p), vec_cross(normal, vec_add(c[i].n, c[i + 1].n)));
    return sum;
}

void slice_chains_end(struct slice_chains *chains, size_t from, bool closed)
{
    if (chains->point.n >= from + 2)
        *array_push(&chains->chain) = (struct slice_chain){from, chains->point.n, closed};
    else
        chains->point.n = from;
}

double slice_chains_length(const struct slice_chains *chains)
{
    double sum = 0;

    for (size_t k = 0; k < chains->chain.n; k++) {
        const struct slice_chain *chain = &chains->chain.item[k];
        for (size_t i = chain->from; i + 1 < chain->to; i++)
            sum += vec_distance(chains->point.item[i].p, chains->point.item[i + 1].p);
    }
    return sum;
}

struct facet_height {
    double lowest;
    size_t facet;
};

static int compare_heights(const void *pa, const void *pb)
{
    const struct facet_height *a = pa, *b = pb;

    if (a->lowest != b->lowest)
        return a->lowest < b->lowest ? -1 : 1;
    return (a->facet > b->facet) - (a->facet < b->facet);
}

static void sort_facets(struct slice *cut)
{
    size_t n = cut->mesh->face.n;
    struct facet_height *by = mem_alloc(n, sizeof *by);

    for (size_t f = 0; f < n; f++) {
        const int *v = cut->mesh->face.item[f].v;
        const double *h = cut->height;
        double low = fmin(fmin(h[v[0]], h[v[1]]), h[v[2]]);
        by[f] = (struct facet_height){low, f};
        cut->tallest = fmax(cut->tallest, fmax(fmax(h[v[0]], h[v[1]]), h[v[2]]) - low);
    }
    qsort(by, n, sizeof *by, compare_heights);
    cut->order = mem_alloc(n, sizeof *cut->order);
    cut->lowest = mem_alloc(n, sizeof *cut->lowest);
    for (size_t i = 0; i < n; i++) {
        cut->order[i] = by[i].facet;
        cut->lowest[i] = by[i].lowest;
    }
    free(by);
}

struct slice *slice_new(const struct mesh *mesh, struct vec3 normal, bool smooth)
{
    struct slice *cut = mem_alloc(1, sizeof *cut);

    cut->mesh = mesh;
    cut->normal = normal;
    cut->smooth = smooth;
    cut->height = mem_alloc(mesh->vertex.n, sizeof *cut->height);
    for (size_t v = 0; v < mesh->vertex.n; v++)
        cut->height[v] = vec_dot(mesh->vertex.item[v], normal);
    cut->done = mem_alloc(mesh->face.n, sizeof *cut->done);
    cut->edges = mesh_edges_find(mesh);
    sort_facets(cut);
    return cut;
}

void slice_free(struct slice *cut)
{
    if (!cut)
        return;
    free(cut->height);
    mesh_edges_free(&cut->edges);
    free(cut->order);
    free(cut->lowest);
    free(cut->done);
    free(cut);
}

double slice_low(const struct slice *cut)
{
    return cut->mesh->face.n > 0 ? cut->lowest[0] : 0;
}

double slice_high(const struct slice *cut)
{
    double high = -HUGE_VAL;

    for (size_t f = 0; f < cut->mesh->face.n; f++) {
        for (int i = 0; i < 3; i++)
            high = fmax(high, cut->height[cut->mesh->face.item[f].v[i]]);
    }
    return high;
}

static bool is_below(const struct slice *cut, int vertex, double height)
{
    return cut->height[vertex] <= height + ON_PLANE;
}

static bool crosses(const struct slice *cut, int edge, double height)
{
    const int *v = cut->edges.edge[edge].v;

    return is_below(cut, v[0], height) != is_below(cut, v[1], height);
}

/* Where the curve from below (s = 0) to above crosses the plane: bisection, for it need not rise
 * all the way. */
static double crossing(const struct edge_curve *curve, struct vec3 normal, double height)
{
    double low = 0, high = 1;

    for (int i = 0; i < 60; i++) {
        double middle = (low + high) / 2;
        if (vec_dot(edge_curve_at(curve, middle), normal) <= height)
            low = middle;
        else
            high = middle;
    }
    return low;
}

static struct contact contact_on(const struct slice *cut, int edge, double height)
{
    const int *v = cut->edges.edge[edge].v;
    bool rises = is_below(cut, v[0], height);
    int low = rises ? v[0] : v[1], high = rises ? v[1] : v[0];
    struct vec3 p = cut->mesh->vertex.item[low], q = cut->mesh->vertex.item[high];
    struct vec3 pn = cut->mesh->normal.item[low], qn = cut->mesh->normal.item[high];
    double rise = cut->height[high] - cut->height[low];
    double s = fmax((height - cut->height[low]) / rise, 0);
    struct contact c = {vec_mix(p, q, s), vec_unit(vec_mix(pn, qn, s))};

    if (cut->smooth) {
        struct edge_curve curve = edge_curve(p, pn, q, qn);
        s = crossing(&curve, cut->normal, height);
        c.p = edge_curve_at(&curve, s);
        struct vec3 along = vec_unit(edge_curve_slope(&curve, s));
        struct vec3 mixed = vec_unit(vec_mix(pn, qn, s)), across = vec_reject(mixed, along);
        c.n = vec_length(across) > 0.5 ? vec_unit(across) : mixed;
    }
    c.p = vec_along(c.p, height - vec_dot(c.p, cut->normal), cut->normal);
    return c;
}

/* The edge by which a chain leaves a facet that it came into by another one; NONE: there is none.
 */
static int next_edge(const struct slice *cut, int facet, int by, double height)
{
    for (int i = 0; i < 3; i++) {
        int edge = cut->edges.of[facet][i];
        if (edge != by && crosses(cut, edge, height))
            return edge;
    }
    return NONE;
}

static void add_point(struct contacts *to, size_t from, struct contact c)
{
    if (to->n == from || vec_distance(to->item[to->n - 1].p, c.p) > CROWDED)
        *array_push(to) = c;
}

/* Follows a chain that comes into a facet by an edge. */
static void follow_chain(struct slice *cut, int facet, int edge, double height,
                         struct slice_chains *chains)
{
    struct contacts *points = &chains->point;
    size_t from = points->n;
    struct contact last = contact_on(cut, edge, height);
    bool closed = mesh_edge_beyond(&cut->edges, edge, facet) >= 0;

    add_point(points, from, last);
    while (facet >= 0 && !cut->done[facet]) {
        cut->done[facet] = true;
        edge = next_edge(cut, facet, edge, height);
        last = contact_on(cut, edge, height);
        add_point(points, from, last);
        facet = mesh_edge_beyond(&cut->edges, edge, facet);
    }
    /* The end itself stays, whatever is near it. */
    points->item[points->n - 1] = last;
    if (points->n < from + 2) {
        points->n = from;
        return;
    }
    if (contacts_forward(points->item + from, points->n - from, cut->normal) < 0)
        contacts_reverse(points->item + from, points->n - from);
    *array_push(&chains->chain) =
        (struct slice_chain){from, points->n, closed && points->n > from + 3};
}

/* The facets that may cross the plane: [*from, *to) of the order. */
static void find_candidates(const struct slice *cut, double height, size_t *from, size_t *to)
{
    size_t n = cut->mesh->face.n, low = 0, high = n;

    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (cut->lowest[middle] <= height + ON_PLANE)
            low = middle + 1;
        else
            high = middle;
    }
    *from = *to = low;
    while (*from > 0 && cut->lowest[*from - 1] >= height - ON_PLANE - cut->tallest)
        --*from;
}

void slice_at(struct slice *cut, double height, struct slice_chains *chains)
{
    size_t from, to;

    find_candidates(cut, height, &from, &to);
    for (size_t i = from; i < to; i++)
        cut->done[cut->order[i]] = false;
    /* Chains that begin at a border first, so that what is left is closed. */
    for (int round = 0; round < 2; round++) {
        for (size_t i = from; i < to; i++) {
            int facet = (int)cut->order[i];
            for (int k = 0; k < 3 && !cut->done[facet]; k++) {
                int edge = cut->edges.of[facet][k];
                if (crosses(cut, edge, height) &&
                    (round == 1 || mesh_edge_beyond(&cut->edges, edge, facet) < 0))
                    follow_chain(cut, facet, edge, height, chains);
            }
        }
    }
}
