/* polyline_boxes - see polyline_boxes.h. */
#include "polyline_boxes.h"

#include <stdint.h>
#include <stdlib.h>

#include "math/box.h"

enum { LEVELS = 16, BITS = 3 }; /* a box has so many times as much in it as one a level below */

struct polyline_boxes {
    struct polyline b;
    size_t n;      /* pieces looked at, */
    size_t *piece; /* their numbers, rising, */
    double *way;   /* and up to each vertex, mm */
    int levels;
    struct box *box[LEVELS]; /* box k of level l: pieces k << BITS (l + 1) on */
};

static size_t boxes_of(const struct polyline_boxes *boxes, int level)
{
    return ((boxes->n - 1) >> (BITS * (level + 1))) + 1;
}

static void find_pieces(struct polyline_boxes *boxes, struct polyline b)
{
    boxes->piece = mem_alloc(b.n, sizeof *boxes->piece);
    boxes->way = mem_alloc(b.n, sizeof *boxes->way);
    for (size_t j = 0; j + 1 < b.n; j++) {
        boxes->way[j + 1] = boxes->way[j] + vec_distance(b.point[j], b.point[j + 1]);
        if (j + 2 == b.n || !polyline_stays(b, j) || !polyline_stays(b, j + 1))
            boxes->piece[boxes->n++] = j;
    }
}

struct polyline_boxes *polyline_boxes_new(struct polyline b)
{
    struct polyline_boxes *boxes = mem_alloc(1, sizeof *boxes);

    boxes->b = b;
    find_pieces(boxes, b);
    for (int l = 0; l < LEVELS && (l == 0 || boxes_of(boxes, l - 1) > 1); l++) {
        size_t n = boxes_of(boxes, l), parts = l > 0 ? boxes_of(boxes, l - 1) : boxes->n;
        boxes->box[l] = mem_alloc(n, sizeof *boxes->box[l]);
        for (size_t k = 0; k < n; k++)
            boxes->box[l][k] = box_empty();
        for (size_t i = 0; i < parts; i++) {
            struct box *box = &boxes->box[l][i >> BITS];
            if (l > 0) {
                box_join(box, &boxes->box[l - 1][i]);
                continue;
            }
            box_add(box, b.point[boxes->piece[i]]);
            box_add(box, b.point[boxes->piece[i] + 1]);
        }
        boxes->levels = l + 1;
    }
    return boxes;
}

void polyline_boxes_free(struct polyline_boxes *boxes)
{
    for (int l = 0; boxes && l < boxes->levels; l++)
        free(boxes->box[l]);
    if (boxes) {
        free(boxes->piece);
        free(boxes->way);
    }
    free(boxes);
}

/* The first piece looked at whose number is not below `number`. */
static size_t place_of(const struct polyline_boxes *boxes, size_t number)
{
    size_t lo = 0, hi = boxes->n;

    while (lo < hi) {
        size_t middle = (lo + hi) / 2;
        if (boxes->piece[middle] < number)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}

/* The first piece looked at, from number `at` on, that is `most` mm and more behind vertex
 * `from`. */
static size_t place_beyond(const struct polyline_boxes *boxes, size_t at, size_t from, double most)
{
    size_t lo = at, hi = boxes->n;

    while (lo < hi) {
        size_t middle = (lo + hi) / 2;
        if (boxes->way[boxes->piece[middle]] - boxes->way[from] > most)
            hi = middle;
        else
            lo = middle + 1;
    }
    return lo;
}

/* The same backwards, among those before number `at`: behind the last one that is so far before
 * vertex `to`. */
static size_t place_before(const struct polyline_boxes *boxes, size_t at, size_t to, double most)
{
    size_t lo = 0, hi = at;

    while (lo < hi) {
        size_t middle = (lo + hi) / 2;
        if (boxes->way[to] - boxes->way[boxes->piece[middle] + 1] > most)
            lo = middle + 1;
        else
            hi = middle;
    }
    return lo;
}

struct search {
    const struct polyline_boxes *boxes;
    struct vec3 q;
    size_t from, to; /* of the pieces looked at */
    struct foot best;
    size_t tie; /* from this piece on one that is as near is taken */
};

static void look_at_piece(struct search *s, size_t j)
{
    if (polyline_is_farther(s->boxes->b, j, s->q, s->best.distance))
        return;
    struct foot f = polyline_on_piece(s->boxes->b, j, s->q);
    if (f.distance > s->best.distance || (f.distance >= s->best.distance && j < s->tie))
        return;
    s->best = f;
    s->tie = j;
}

/* The parts of a box that are near enough, the nearest first: one that has been found makes others
 * too far away. */
static void look_into_box(struct search *s, int level, size_t k)
{
    const double surely = 1 + 1e-9;
    enum { PARTS = 1 << BITS };
    size_t part[PARTS], n = 0, all = level > 0 ? boxes_of(s->boxes, level - 1) : s->boxes->n;
    double off2[PARTS];

    for (size_t i = k << BITS; i < all && i < (k + 1) << BITS; i++) {
        size_t first = i << (BITS * level), end = (i + 1) << (BITS * level), at = n;
        if (end <= s->from || first >= s->to)
            continue;
        if (level <= 0) {
            look_at_piece(s, s->boxes->piece[i]);
            continue;
        }
        double d2 = box_distance2(&s->boxes->box[level - 1][i], s->q);
        for (; at > 0 && off2[at - 1] > d2; at--) {
            off2[at] = off2[at - 1];
            part[at] = part[at - 1];
        }
        off2[at] = d2;
        part[at] = i;
        n++;
    }
    for (size_t i = 0; i < n; i++)
        if (off2[i] <= surely * s->best.distance * s->best.distance)
            look_into_box(s, level - 1, part[i]);
}

static void look_between(struct search *s, size_t from, size_t to, size_t tie)
{
    s->from = from;
    s->to = to;
    s->tie = tie;
    if (from < to)
        look_into_box(s, s->boxes->levels - 1, 0);
}

struct foot polyline_boxes_foot(const struct polyline_boxes *boxes, struct foot from, double reach,
                                struct vec3 q)
{
    struct polyline b = boxes->b;
    struct search s = {.boxes = boxes, .q = q, .best = polyline_on_piece(b, from.segment, q)};
    double length = polyline_piece_length(b, from.segment);

    double most = polyline_farthest(reach, s.best.distance) - (1 - from.t) * length;
    size_t at = place_of(boxes, from.segment + 1);
    look_between(&s, at, place_beyond(boxes, at, from.segment + 1, most), 0);
    most = polyline_farthest(reach, s.best.distance) - from.t * length;
    at = place_of(boxes, from.segment);
    look_between(&s, place_before(boxes, at, from.segment, most), at, SIZE_MAX);
    return s.best;
}
