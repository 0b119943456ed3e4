/* segment - see segment.h. */
#include "cloud/segment.h"

#include <stdbool.h>
#include <stdlib.h>

#include "segment_steps.h"
#include "math/kdtree.h"

enum { DIRECTIONS = 33 };

static const double SERVED = 0.64278760968653936; /* cos 50 degrees */
static const double FACING = 0.34202014332566873; /* cos 70 degrees */
static const double FEW = 0.002;                  /* of the cloud, that are not worth a direction */

struct division {
    const struct vec3 *point;
    size_t n;
    size_t *neighbour;
    double spacing;
    struct vec3 *normal;
    struct vec3 direction[DIRECTIONS]; /* the chosen ones first, then those to choose from */
    int chosen;
    int *label; /* of each point: its direction */
};

/* Straight up; then 16 level ones, and 8 each half way up and half way down. */
static void make_directions(struct vec3 direction[DIRECTIONS])
{
    int n = 0;

    direction[n++] = vec(0, 0, 1);
    for (int ring = 0; ring < 3; ring++) {
        double up = ring == 0 ? 0 : ring == 1 ? PI / 4 : -PI / 4;
        for (int i = 0; i < (ring == 0 ? 16 : 8); i++) {
            double turn = 2 * PI * i / (ring == 0 ? 16 : 8);
            direction[n++] = vec(cos(up) * cos(turn), cos(up) * sin(turn), sin(up));
        }
    }
}

static bool is_served(const struct division *d, size_t i)
{
    for (int k = 0; k < d->chosen; k++)
        if (vec_dot(d->normal[i], d->direction[k]) >= SERVED)
            return true;
    return false;
}

/* What a direction serves: how many points, and the sum of their cosines. */
struct served {
    size_t n;
    double straight;
};

static bool serves_more(const struct served *a, const struct served *b)
{
    return a->n > b->n || (a->n == b->n && a->straight > b->straight);
}

static void count_served(const struct division *d, struct served count[DIRECTIONS])
{
    for (size_t i = 0; i < d->n; i++) {
        if (is_served(d, i))
            continue;
        for (int k = d->chosen; k < DIRECTIONS; k++) {
            double cosine = vec_dot(d->normal[i], d->direction[k]);
            if (cosine < SERVED)
                continue;
            count[k].n++;
            count[k].straight += cosine;
        }
    }
}

/* The direction that serves most of what the chosen ones do not, and of several the one that looks
 * at it straightest, to the end of these; false when what is left is not worth one. */
static bool choose_direction(struct division *d)
{
    struct served count[DIRECTIONS] = {{0, 0}};
    int best = d->chosen;

    count_served(d, count);
    for (int k = d->chosen; k < DIRECTIONS; k++)
        best = serves_more(&count[k], &count[best]) ? k : best;
    if (best >= DIRECTIONS || (double)count[best].n <= FEW * (double)d->n)
        return false;
    struct vec3 found = d->direction[best];
    d->direction[best] = d->direction[d->chosen];
    d->direction[d->chosen++] = found;
    return true;
}

static void label_points(struct division *d)
{
    for (size_t i = 0; i < d->n; i++) {
        d->label[i] = 0;
        for (int k = 1; k < d->chosen; k++)
            if (vec_dot(d->normal[i], d->direction[k]) >
                vec_dot(d->normal[i], d->direction[d->label[i]]))
                d->label[i] = k;
    }
}

static struct segment frame_of(struct vec3 up, double direction)
{
    struct segment part = {.up = up};

    part.along = vec(cos(RADIANS(direction)), sin(RADIANS(direction)), 0);
    if (up.z < 1)
        part.along = vec_unit(vec_cross(vec(0, 0, 1), up));
    part.across = vec_cross(part.up, part.along);
    return part;
}

/* The points of part number k, then those of others near to them, and places beyond its edges. */
static void fill_segment(const struct division *d, const struct components *pieces, const int *of,
                         int k, double overlap, struct segment *part)
{
    const double beyond = 2 / 3.0;
    bool *in = mem_alloc(d->n, sizeof *in);
    struct extend_edges edges = {d->point, d->normal, d->neighbour, d->n, in};

    struct sizes own = {0};

    for (size_t i = 0; i < d->n; i++) {
        in[i] = of[i] == k;
        if (!in[i])
            continue;
        *array_push(&part->point) = d->point[i];
        *array_push(&own) = i;
    }
    part->own = part->point.n;
    struct kdtree *tree = kdtree_new(part->point.item, part->own);
    for (size_t i = 0; i < d->n; i++) {
        size_t nearest;
        double distance2;
        if (of[i] != k && vec_dot(d->normal[i], part->up) > FACING &&
            kdtree_nearest(tree, d->point[i], 1, &nearest, &distance2) == 1 &&
            distance2 < overlap * overlap && components_smooth(pieces, i, own.item[nearest])) {
            *array_push(&part->point) = d->point[i];
            in[i] = true;
        }
    }
    kdtree_free(tree);
    extend_edges_find(&edges, d->spacing, beyond * overlap, &part->point);
    array_free(&own);
    free(in);
}

/* From above round and down: by height of the direction, then by its turn. */
static int in_order(const void *a, const void *b)
{
    const struct vec3 *p = &((const struct segment *)a)->up;
    const struct vec3 *q = &((const struct segment *)b)->up;
    double turn = atan2(p->y, p->x) - atan2(q->y, q->x);

    if (fabs(p->z - q->z) > 1e-9)
        return p->z > q->z ? -1 : 1;
    return (turn > 0) - (turn < 0);
}

struct segments segments_find(const struct vec3 *point, size_t n,
                              const struct segments_options *options)
{
    struct segments parts = {0};
    struct division d = {.point = point, .n = n, .chosen = 1};
    struct ints up = {0};

    if (n <= SEGMENTS_LEAST) {
        parts.left_out = n;
        return parts;
    }
    d.neighbour = cloud_neighbours(point, n, options->threads);
    d.normal = mem_alloc(n, sizeof *d.normal);
    d.label = mem_alloc(n, sizeof *d.label);
    parts.spacing = d.spacing = cloud_spacing(point, n, d.neighbour);
    double overlap = options->overlap > 0 ? options->overlap : 4.5 * parts.spacing;
    int *of = mem_alloc(n, sizeof *of);
    cloud_normals(point, n, d.neighbour, options->outside, options->threads, d.normal);
    make_directions(d.direction);
    while (d.chosen < DIRECTIONS && choose_direction(&d))
        ;
    label_points(&d);
    struct components pieces = {n, d.neighbour, d.normal, d.direction, d.label};
    components_settle(&pieces);
    components_find(&pieces, of, &up);
    for (size_t k = 0; k < up.n; k++) {
        *array_push(&parts) = frame_of(d.direction[up.item[k]], options->direction);
        fill_segment(&d, &pieces, of, (int)k, overlap, &parts.item[k]);
    }
    for (size_t i = 0; i < n; i++)
        parts.left_out += of[i] == COMPONENT_NONE;
    if (parts.n > 0)
        qsort(parts.item, parts.n, sizeof *parts.item, in_order);
    array_free(&up);
    free(of);
    free(d.label);
    free(d.normal);
    free(d.neighbour);
    return parts;
}

void segments_normals(const struct vec3 *point, size_t n, struct vec3 outside, int threads,
                      struct vec3 *normal)
{
    size_t *neighbour = cloud_neighbours(point, n, threads);

    cloud_normals(point, n, neighbour, outside, threads, normal);
    free(neighbour);
}

void segments_free(struct segments *parts)
{
    for (size_t i = 0; i < parts->n; i++)
        array_free(&parts->item[i].point);
    array_free(parts);
}

struct vec3 segment_in(const struct segment *part, struct vec3 p)
{
    return vec(vec_dot(part->along, p), vec_dot(part->across, p), vec_dot(part->up, p));
}

struct vec3 segment_out(const struct segment *part, struct vec3 p)
{
    return vec_along(vec_along(vec_scale(p.x, part->along), p.y, part->across), p.z, part->up);
}
