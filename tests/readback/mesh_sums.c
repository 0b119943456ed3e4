/* mesh_sums - see mesh_sums.h. */
#include "mesh_sums.h"

#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "math/vec.h"

enum { LINE = 400, PLACE = 80 };

struct corner {
    struct vec3 p, normal;
    char place[PLACE];   /* as it is written */
    size_t index, first; /* of those that are written alike */
};

struct edge {
    size_t from, to;
};

struct corners {
    size_t n, cap;
    struct corner *item;
};

struct edges {
    size_t n, cap;
    struct edge *item;
};

static int by_place(const void *pa, const void *pb)
{
    const struct corner *a = *(struct corner *const *)pa, *b = *(struct corner *const *)pb;
    int order = strcmp(a->place, b->place);

    return order ? order : (a->index > b->index) - (a->index < b->index);
}

static int by_ends(const void *pa, const void *pb)
{
    const struct edge *a = pa, *b = pb;

    return a->from != b->from ? (a->from > b->from) - (a->from < b->from)
                              : (a->to > b->to) - (a->to < b->to);
}

/* The counts of the header, and whether it ends. */
static bool read_header(FILE *in, struct mesh_sums *sums)
{
    char line[LINE];
    bool text = false;

    while (fgets(line, sizeof line, in) && strcmp(line, "end_header\n") != 0) {
        text = text || strncmp(line, "format ascii", 12) == 0;
        if (sscanf(line, "element vertex %zu", &sums->vertices) != 1)
            (void)sscanf(line, "element face %zu", &sums->facets);
    }
    return text && !feof(in);
}

static bool read_corner(FILE *in, struct corner *c)
{
    char line[LINE], x[PLACE / 4], y[PLACE / 4], z[PLACE / 4];

    if (!fgets(line, sizeof line, in) || sscanf(line, "%19s %19s %19s", x, y, z) != 3)
        return false;
    snprintf(c->place, sizeof c->place, "%s %s %s", x, y, z);
    return sscanf(line, "%lf %lf %lf %lf %lf %lf", &c->p.x, &c->p.y, &c->p.z, &c->normal.x,
                  &c->normal.y, &c->normal.z) >= 3;
}

/* Of corners that are written alike the first stands for all. */
static void join_alike(struct corners *corners)
{
    struct corner **order = mem_alloc(corners->n + 1, sizeof(struct corner *));

    for (size_t i = 0; i < corners->n; i++)
        order[i] = &corners->item[i];
    qsort(order, corners->n, sizeof(struct corner *), by_place);
    for (size_t i = 0; i < corners->n; i++) {
        bool same = i > 0 && strcmp(order[i]->place, order[i - 1]->place) == 0;
        order[i]->first = same ? order[i - 1]->first : order[i]->index;
    }
    free(order);
}

static void add_facet(struct mesh_sums *sums, const struct corner *a, const struct corner *b,
                      const struct corner *c)
{
    struct vec3 n = vec_cross(vec_sub(b->p, a->p), vec_sub(c->p, a->p));
    double length = vec_length(n);
    const struct corner *at[] = {a, b, c};

    sums->area += length / 2;
    sums->volume += vec_dot(a->p, n) / 6;
    for (int k = 0; k < 3 && length > 1e-3; k++)
        sums->least = fmin(sums->least, vec_dot(n, at[k]->normal) / length);
}

/* How many edges go from one corner to another. */
static size_t count_of(const struct edges *edges, struct edge wanted)
{
    const struct edge *found =
        bsearch(&wanted, edges->item, edges->n, sizeof *edges->item, by_ends);
    size_t first = found ? (size_t)(found - edges->item) : 0, last = first;

    if (!found)
        return 0;
    while (first > 0 && by_ends(&edges->item[first - 1], &wanted) == 0)
        first--;
    while (last < edges->n && by_ends(&edges->item[last], &wanted) == 0)
        last++;
    return last - first;
}

static void count_edges(struct edges *edges, struct mesh_sums *sums)
{
    qsort(edges->item, edges->n, sizeof *edges->item, by_ends);
    for (size_t i = 0; i < edges->n; i++) {
        struct edge edge = edges->item[i];
        if (i > 0 && by_ends(&edges->item[i - 1], &edge) == 0)
            continue;
        size_t there = count_of(edges, edge);
        size_t back = count_of(edges, (struct edge){edge.to, edge.from});
        sums->open += there != 1 || back != 1;
        sums->uneven += there != back;
    }
}

static bool read_corners(FILE *in, struct mesh_sums *sums, struct corners *corners)
{
    for (size_t i = 0; i < sums->vertices; i++) {
        struct corner corner = {.index = i};
        if (!read_corner(in, &corner))
            return false;
        sums->off = fmax(sums->off, fabs(vec_length(corner.normal) - 1));
        *array_push(corners) = corner;
    }
    join_alike(corners);
    return true;
}

static bool read_facets(FILE *in, struct mesh_sums *sums, const struct corners *corners,
                        struct edges *edges)
{
    char line[LINE];

    for (size_t i = 0; i < sums->facets; i++) {
        size_t k[3];
        if (!fgets(line, sizeof line, in) ||
            sscanf(line, "3 %zu %zu %zu", &k[0], &k[1], &k[2]) != 3)
            return false;
        for (int j = 0; j < 3; j++) {
            if (k[j] >= corners->n || k[(j + 1) % 3] >= corners->n)
                return false;
            *array_push(edges) =
                (struct edge){corners->item[k[j]].first, corners->item[k[(j + 1) % 3]].first};
        }
        add_facet(sums, &corners->item[k[0]], &corners->item[k[1]], &corners->item[k[2]]);
    }
    return true;
}

int mesh_sums_read(const char *file, struct mesh_sums *sums, struct error *error)
{
    struct corners corners = {0};
    struct edges edges = {0};
    FILE *in = fopen(file, "r");

    *sums = (struct mesh_sums){.least = 1};
    bool read = in && read_header(in, sums) && read_corners(in, sums, &corners) &&
                read_facets(in, sums, &corners, &edges);
    if (read)
        count_edges(&edges, sums);
    if (in)
        fclose(in);
    array_free(&corners);
    array_free(&edges);
    return read ? 0 : error_at(error, file, 0, "found no mesh, expected a PLY as text");
}
