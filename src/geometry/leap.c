/* leap - see leap.h. */
#include "leap.h"

#include "kdtree.h"

#define RISES 0.5 /* cosine between the tool axis and the way up, at least */

struct search {
    const struct course *course;
    const struct ball_path *path;
    const struct vec3 *point;
    size_t n;
    const struct leap_setup *setup;
    struct kdtree *part; /* made when it is needed */
    struct leap leap;
};

/* Does the way go on from one segment to the next as one curve, or as straight blocks do? */
static bool goes_on(const struct search *s, size_t from, size_t to)
{
    const struct piece *piece = s->course->piece.item;
    unsigned p = s->path->item[from].piece, q = s->path->item[to].piece;
    if (p == q)
        return true;
    if (q != p + 1 || piece[p].shape != piece[q].shape || piece[p].shape == SHAPE_ARC)
        return false;
    return piece[p].shape != SHAPE_SPLINE || piece[p].index == piece[q].index;
}

/* Straight blocks from one segment to another: are they two, there and back? */
static bool spike(const struct search *s, size_t from, size_t to)
{
    const struct ball_segment *a = &s->path->item[from], *b = &s->path->item[to];
    if (b->piece != a->piece + 1)
        return false;
    size_t top = from;
    while (s->path->item[top].piece == a->piece)
        top++;
    struct vec3 corner = s->path->item[top].a;
    return vec_dot(vec_sub(a->a, corner), vec_sub(b->b, corner)) > 0;
}

static double clearance(struct search *s, struct vec3 centre)
{
    size_t index;
    double distance2;
    if (!s->part)
        s->part = kdtree_new(s->point, s->n);
    kdtree_nearest(s->part, centre, 1, &index, &distance2);
    return sqrt(distance2) - s->setup->radius;
}

/* From the straight line between two places to a third, at right angles. */
static struct vec3 rise(struct vec3 from, struct vec3 to, struct vec3 p)
{
    struct vec3 chord = vec_sub(to, from), up = vec_sub(p, from);
    double l2 = vec_dot(chord, chord);
    double t = l2 > 0 ? fmin(fmax(vec_dot(chord, up) / l2, 0), 1) : 0;
    return vec_along(up, -t, chord);
}

/* A stretch of segments off the part, both ends among them. */
static void look(struct search *s, size_t from, size_t to)
{
    const struct ball_segment *segment = s->path->item;
    struct vec3 a = segment[from].a, b = segment[to].b;
    size_t top = from;
    double most = 0;
    if (s->course->piece.item[segment[from].piece].shape == SHAPE_LINE && !spike(s, from, to))
        return;
    for (size_t i = from; i < to; i++) {
        double high = vec_length(rise(a, b, segment[i].b));
        top = high > most ? i : top;
        most = fmax(most, high);
    }
    if (most <= s->setup->band)
        return;
    const struct piece *piece = &s->course->piece.item[segment[top].piece];
    struct vec3 axis = course_at(s->course, piece, (double)segment[top].s[1]).a;
    double height = clearance(s, segment[top].b);
    if (vec_dot(axis, rise(a, b, segment[top].b)) < RISES * most || height <= s->setup->band ||
        clearance(s, a) > s->setup->band || clearance(s, b) > s->setup->band)
        return;
    s->leap.leaps++;
    if (height > s->leap.height) {
        s->leap.height = height;
        s->leap.piece = segment[top].piece;
        s->leap.at = segment[top].b;
    }
}

struct leap leap_find(const struct course *course, const struct ball_path *path,
                      const struct vec3 *point, size_t n, const struct leap_setup *setup)
{
    struct search s = {course, path, point, n, setup, NULL, {0}};
    for (size_t i = 0; n > 0 && i < path->n; i++) {
        size_t from = i;
        if (path->item[i].on)
            continue;
        while (i + 1 < path->n && !path->item[i + 1].on && goes_on(&s, i, i + 1))
            i++;
        look(&s, from, i);
    }
    if (s.part)
        kdtree_free(s.part);
    return s.leap;
}
