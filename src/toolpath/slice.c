/* slice - see slice.h. */
#include "toolpath/slice.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "base/parallel.h"
#include "mesh/mesh_edges.h"

/* Points nearer than this say more of rounding than of a direction, mm. */
static const double CROWDED = 1e-3;

/* A vertex within this of a plane is on it, mm: coordinates of a mesh stream have 6 decimals. */
static const double ON_PLANE = 2e-6;

enum { NONE = -1, LEAF = 8 };

struct slice {
    const struct mesh *mesh;
    struct vec3 normal;
    bool smooth;
    struct mesh_edges edges;
    double *height;  /* of each vertex along the normal */
    size_t *order;   /* facets by their lowest vertex */
    double *lowest;  /* of the facets in that order */
    double *highest; /* the highest vertex under each node of a tree over that order */
    bool *done;      /* facets of the plane at hand */
    struct sizes at; /* which these are */
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

/* A number of which those of larger heights are larger. */
static uint64_t key_of(double height)
{
    const uint64_t sign = 1ull << 63;
    uint64_t key;

    height += 0.0; /* both zeros are the same */
    memcpy(&key, &height, sizeof key);
    return key & sign ? ~key : key | sign;
}

/* By height, among equals as they are; by digits of 11 bits, the lowest first (Knuth, 5.2.5).
 * `other` is as long. */
static void sort_heights(struct facet_height *by, struct facet_height *other, size_t n)
{
    enum { BITS = 11, DIGITS = 6, VALUES = 1 << BITS };
    struct facet_height *from = by, *to = other;

    for (int digit = 0; digit < DIGITS; digit++) { /* an even number: they end where they were */
        size_t first[VALUES + 1] = {0};
        for (size_t i = 0; i < n; i++)
            first[(key_of(from[i].lowest) >> BITS * digit) % VALUES + 1]++;
        for (int v = 1; v < VALUES; v++)
            first[v] += first[v - 1];
        for (size_t i = 0; i < n; i++)
            to[first[(key_of(from[i].lowest) >> BITS * digit) % VALUES]++] = from[i];
        struct facet_height *swap = from;
        from = to;
        to = swap;
    }
}

static void sort_facets(struct slice *cut)
{
    size_t n = cut->mesh->face.n;
    struct facet_height *by = mem_alloc(n, sizeof *by), *other = mem_alloc(n, sizeof *other);

    for (size_t f = 0; f < n; f++) {
        const int *v = cut->mesh->face.item[f].v;
        const double *h = cut->height;
        double low = fmin(fmin(h[v[0]], h[v[1]]), h[v[2]]);
        by[f] = (struct facet_height){low, f};
    }
    sort_heights(by, other, n);
    free(other);
    cut->order = mem_alloc(n, sizeof *cut->order);
    cut->lowest = mem_alloc(n, sizeof *cut->lowest);
    for (size_t i = 0; i < n; i++) {
        cut->order[i] = by[i].facet;
        cut->lowest[i] = by[i].lowest;
    }
    free(by);
}

static double facet_high(const struct slice *cut, size_t place)
{
    const int *v = cut->mesh->face.item[cut->order[place]].v;

    return fmax(fmax(cut->height[v[0]], cut->height[v[1]]), cut->height[v[2]]);
}

/* Node `number` stands for the places [from, to), those under it for their halves (de Berg et al.,
 * Computational Geometry, 10.2: a priority search tree, here halved at the middle). */
static double fill_highest(struct slice *cut, size_t from, size_t to, size_t number)
{
    double high = -HUGE_VAL;

    if (to - from <= LEAF) {
        for (size_t i = from; i < to; i++)
            high = fmax(high, facet_high(cut, i));
    } else {
        size_t middle = from + (to - from) / 2;
        high = fill_highest(cut, from, middle, 2 * number);
        high = fmax(high, fill_highest(cut, middle, to, 2 * number + 1));
    }
    return cut->highest[number] = high;
}

static size_t count_nodes(size_t n)
{
    size_t nodes = 2;

    for (; n > LEAF; n = (n + 1) / 2)
        nodes *= 2;
    return nodes;
}

enum { SORTED, EDGES, PARTS };

/* What is found in the mesh, each by itself. */
static void find_parts(void *context, size_t from, size_t to)
{
    struct slice *cut = context;

    for (size_t part = from; part < to; part++) {
        if (part == EDGES) {
            cut->edges = mesh_edges_find(cut->mesh);
            continue;
        }
        sort_facets(cut);
        cut->highest = mem_alloc(count_nodes(cut->mesh->face.n), sizeof *cut->highest);
        fill_highest(cut, 0, cut->mesh->face.n, 1);
    }
}

struct slice *slice_new(const struct mesh *mesh, struct vec3 normal, bool smooth, int threads)
{
    struct slice *cut = mem_alloc(1, sizeof *cut);

    cut->mesh = mesh;
    cut->normal = normal;
    cut->smooth = smooth;
    cut->height = mem_alloc(mesh->vertex.n, sizeof *cut->height);
    for (size_t v = 0; v < mesh->vertex.n; v++)
        cut->height[v] = vec_dot(mesh->vertex.item[v], normal);
    cut->done = mem_alloc(mesh->face.n, sizeof *cut->done);
    parallel_for(threads, PARTS, find_parts, cut);
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
    free(cut->highest);
    array_free(&cut->at);
    free(cut->done);
    free(cut);
}

const struct mesh_edges *slice_edges(const struct slice *cut)
{
    return &cut->edges;
}

double slice_low(const struct slice *cut)
{
    return cut->mesh->face.n > 0 ? cut->lowest[0] : 0;
}

double slice_high(const struct slice *cut)
{
    return cut->highest[1];
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
        struct edge_curve curve = mesh_edge_curve(cut->mesh, low, high);
        s = edge_curve_crossing(&curve, cut->normal, height);
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

/* The facets that cross the plane, among the places [from, to): those that are lowest under it, and
 * highest above it. */
static void find_crossed(struct slice *cut, double height, size_t from, size_t to, size_t number)
{
    if (from == to || cut->lowest[from] > height + ON_PLANE ||
        cut->highest[number] <= height + ON_PLANE)
        return;
    if (to - from > LEAF) {
        size_t middle = from + (to - from) / 2;
        find_crossed(cut, height, from, middle, 2 * number);
        find_crossed(cut, height, middle, to, 2 * number + 1);
        return;
    }
    for (size_t i = from; i < to && cut->lowest[i] <= height + ON_PLANE; i++) {
        if (facet_high(cut, i) > height + ON_PLANE)
            *array_push(&cut->at) = cut->order[i];
    }
}

void slice_at(struct slice *cut, double height, struct slice_chains *chains)
{
    cut->at.n = 0;
    find_crossed(cut, height, 0, cut->mesh->face.n, 1);
    for (size_t i = 0; i < cut->at.n; i++)
        cut->done[cut->at.item[i]] = false;
    /* Chains that begin at a border first, so that what is left is closed. */
    for (int round = 0; round < 2; round++) {
        for (size_t i = 0; i < cut->at.n; i++) {
            int facet = (int)cut->at.item[i];
            for (int k = 0; k < 3 && !cut->done[facet]; k++) {
                int edge = cut->edges.of[facet][k];
                if (crosses(cut, edge, height) &&
                    (round == 1 || mesh_edge_beyond(&cut->edges, edge, facet) < 0))
                    follow_chain(cut, facet, edge, height, chains);
            }
        }
    }
}
