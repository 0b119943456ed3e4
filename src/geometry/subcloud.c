/* subcloud - see subcloud.h. */
#include "subcloud.h"

#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "cloudnormals.h"
#include "kdtree.h"

enum { DIRECTIONS = 33, VOTES = 4, FEWEST = 30, NONE = -1 };

static const double SERVED = 0.64278760968653936; /* cos 50 degrees */
static const double FACING = 0.34202014332566873; /* cos 70 degrees */
static const double FEW = 0.002;                  /* of the cloud, that are not worth a direction */
static const double SMALL = 0.01;                 /* of the cloud, that are no part */

struct division {
    const struct vec3 *point;
    size_t n;
    size_t *neighbour;
    struct vec3 *normal;
    struct vec3 direction[DIRECTIONS]; /* the chosen ones first, then those to choose from */
    int chosen;
    int *label; /* of each point: its direction, and later its part */
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

static bool served(const struct division *d, size_t i)
{
    for (int k = 0; k < d->chosen; k++)
        if (vec_dot(d->normal[i], d->direction[k]) >= SERVED)
            return true;
    return false;
}

/* The direction that serves most of what the chosen ones do not, to the end of these; false when
 * what is left is not worth one. */
static bool choose_direction(struct division *d)
{
    size_t count[DIRECTIONS] = {0};
    int best = d->chosen;

    for (size_t i = 0; i < d->n; i++) {
        if (served(d, i))
            continue;
        for (int k = d->chosen; k < DIRECTIONS; k++)
            count[k] += vec_dot(d->normal[i], d->direction[k]) >= SERVED;
    }
    for (int k = d->chosen; k < DIRECTIONS; k++)
        best = count[k] > count[best] ? k : best;
    if (best >= DIRECTIONS || (double)count[best] <= FEW * (double)d->n)
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

static bool faces(const struct division *d, size_t i, int direction)
{
    return vec_dot(d->normal[i], d->direction[direction]) > FACING;
}

/* The label that most neighbours have, of those other than NONE; its own where it is among these.
 * Across a sharp edge it gets none from those that have another point's side. */
static int vote(const struct division *d, const int *label, size_t i, bool own)
{
    int best = own ? label[i] : NONE, most = 0;

    for (size_t k = 0; k < CLOUD_NEAR; k++) {
        int candidate = label[d->neighbour[i * CLOUD_NEAR + k]], count = 0;
        for (size_t m = 0; m < CLOUD_NEAR && candidate != NONE; m++)
            count += label[d->neighbour[i * CLOUD_NEAR + m]] == candidate;
        if (own && candidate != NONE && !faces(d, i, candidate))
            continue;
        if (count > most || (count == most && candidate == best)) {
            most = count;
            best = candidate;
        }
    }
    return best;
}

/* Noise leaves single points with another label than all about them. */
static void smooth_labels(struct division *d)
{
    int *old = mem_alloc(d->n, sizeof *old);

    for (int turn = 0; turn < VOTES; turn++) {
        memcpy(old, d->label, d->n * sizeof *old);
        for (size_t i = 0; i < d->n; i++)
            d->label[i] = vote(d, old, i, true);
    }
    free(old);
}

/* All of one label that hangs together with a point: appended to `piece`, in `of` their number. */
static void gather(const struct division *d, size_t start, int number, int *of, struct sizes *piece)
{
    size_t next = piece->n;

    of[start] = number;
    *array_push(piece) = start;
    while (next < piece->n) {
        size_t i = piece->item[next++];
        for (size_t k = 0; k < CLOUD_NEAR; k++) {
            size_t j = d->neighbour[i * CLOUD_NEAR + k];
            if (of[j] != NONE || d->label[j] != d->label[i])
                continue;
            of[j] = number;
            *array_push(piece) = j;
        }
    }
}

/* Pieces too small lose their number, and take one from about them. */
static void dissolve(const struct division *d, int *of)
{
    bool changed = true;
    int *old = mem_alloc(d->n, sizeof *old);

    while (changed) {
        changed = false;
        memcpy(old, of, d->n * sizeof *old);
        for (size_t i = 0; i < d->n; i++) {
            if (old[i] != NONE)
                continue;
            of[i] = vote(d, old, i, false);
            changed |= of[i] != NONE;
        }
    }
    free(old);
}

/* The pieces that are parts, with the direction of each: of[i] is the part of a point or NONE. */
static void find_pieces(const struct division *d, int *of, struct ints *direction)
{
    double least = fmax(FEWEST, SMALL * (double)d->n);
    int *seen = mem_alloc(d->n, sizeof *seen);
    struct sizes piece = {0};

    for (size_t i = 0; i < d->n; i++)
        seen[i] = of[i] = NONE;
    for (size_t i = 0; i < d->n; i++) {
        if (seen[i] != NONE)
            continue;
        piece.n = 0;
        gather(d, i, 0, seen, &piece);
        if ((double)piece.n < least)
            continue;
        for (size_t k = 0; k < piece.n; k++)
            of[piece.item[k]] = (int)direction->n;
        *array_push(direction) = d->label[i];
    }
    array_free(&piece);
    free(seen);
    dissolve(d, of);
}

static struct subcloud frame_of(struct vec3 up, double direction)
{
    struct subcloud part = {.up = up};

    part.along = vec(cos(RADIANS(direction)), sin(RADIANS(direction)), 0);
    if (up.z < 1)
        part.along = vec_unit(vec_cross(vec(0, 0, 1), up));
    part.across = vec_cross(part.up, part.along);
    return part;
}

/* The points of part number k, then those of others near to them. */
static void fill(const struct division *d, const int *of, int k, double overlap,
                 struct subcloud *part)
{
    for (size_t i = 0; i < d->n; i++)
        if (of[i] == k)
            *array_push(&part->point) = d->point[i];
    part->own = part->point.n;
    struct kdtree *tree = kdtree_new(part->point.item, part->own);
    for (size_t i = 0; i < d->n; i++) {
        size_t nearest;
        double distance2;
        if (of[i] != k && vec_dot(d->normal[i], part->up) > FACING &&
            kdtree_nearest(tree, d->point[i], 1, &nearest, &distance2) == 1 &&
            distance2 < overlap * overlap)
            *array_push(&part->point) = d->point[i];
    }
    kdtree_free(tree);
}

/* From above round and down: by height of the direction, then by its turn. */
static int in_order(const void *a, const void *b)
{
    const struct vec3 *p = &((const struct subcloud *)a)->up, *q = &((const struct subcloud *)b)->up;
    double turn = atan2(p->y, p->x) - atan2(q->y, q->x);

    if (fabs(p->z - q->z) > 1e-9)
        return p->z > q->z ? -1 : 1;
    return (turn > 0) - (turn < 0);
}

struct subclouds subclouds_find(const struct vec3 *point, size_t n, double overlap,
                                double direction, int threads)
{
    struct subclouds parts = {0};
    struct division d = {.point = point, .n = n, .chosen = 1};
    struct ints up = {0};

    if (n <= CLOUD_NEAR) {
        parts.left_out = n;
        return parts;
    }
    d.neighbour = cloud_neighbours(point, n, threads);
    d.normal = mem_alloc(n, sizeof *d.normal);
    d.label = mem_alloc(n, sizeof *d.label);
    parts.spacing = cloud_spacing(point, n, d.neighbour);
    overlap = overlap > 0 ? overlap : 4.5 * parts.spacing;
    int *of = mem_alloc(n, sizeof *of);
    cloud_normals(point, n, d.neighbour, threads, d.normal);
    make_directions(d.direction);
    while (d.chosen < DIRECTIONS && choose_direction(&d))
        ;
    label_points(&d);
    smooth_labels(&d);
    find_pieces(&d, of, &up);
    for (size_t k = 0; k < up.n; k++) {
        *array_push(&parts) = frame_of(d.direction[up.item[k]], direction);
        fill(&d, of, (int)k, overlap, &parts.item[k]);
    }
    for (size_t i = 0; i < n; i++)
        parts.left_out += of[i] == NONE;
    if (parts.n > 0)
        qsort(parts.item, parts.n, sizeof *parts.item, in_order);
    array_free(&up);
    free(of);
    free(d.label);
    free(d.normal);
    free(d.neighbour);
    return parts;
}

void subclouds_free(struct subclouds *parts)
{
    for (size_t i = 0; i < parts->n; i++)
        array_free(&parts->item[i].point);
    array_free(parts);
}

struct vec3 subcloud_in(const struct subcloud *part, struct vec3 p)
{
    return vec(vec_dot(part->along, p), vec_dot(part->across, p), vec_dot(part->up, p));
}

struct vec3 subcloud_out(const struct subcloud *part, struct vec3 p)
{
    return vec_along(vec_along(vec_scale(p.x, part->along), p.y, part->across), p.z, part->up);
}
