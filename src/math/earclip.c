/* earclip - see earclip.h. */
#include "math/earclip.h"

#include <stdbool.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"

/* The polygon as a ring; quality is that of the ear at a corner, below 0 where there is none. */
struct ring {
    const struct uv *at;
    size_t n;
    size_t *next, *last;
    double *quality;
    double room; /* twice the area that is left, but for a trifle */
};

/* Of the area of the polygon. */
static const double TRIFLE = 1e-9;

static double area_of(struct uv a, struct uv b, struct uv c)
{
    return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

static double square(struct uv a, struct uv b)
{
    return (b.u - a.u) * (b.u - a.u) + (b.v - a.v) * (b.v - a.v);
}

static bool triangle_holds(struct uv a, struct uv b, struct uv c, struct uv p)
{
    return area_of(a, b, p) >= 0 && area_of(b, c, p) >= 0 && area_of(c, a, p) >= 0;
}

static bool same_place(struct uv a, struct uv b)
{
    return square(a, b) <= 0;
}

/* Area over the squares of the sides, where no other corner lies in the ear. */
static double quality_of(const struct ring *r, size_t i)
{
    struct uv a = r->at[r->last[i]], b = r->at[i], c = r->at[r->next[i]];
    double area = area_of(a, b, c);
    if (!(area > 0))
        return -1;
    for (size_t k = r->next[r->next[i]]; k != r->last[i]; k = r->next[k]) {
        struct uv p = r->at[k];
        if (triangle_holds(a, b, c, p) && !same_place(p, a) && !same_place(p, b) &&
            !same_place(p, c))
            return -1;
    }
    return area / (square(a, b) + square(b, c) + square(c, a));
}

static struct ring ring_of(const struct uv *at, size_t n)
{
    struct ring r = {.at = at, .n = n};
    r.next = mem_alloc(n, sizeof *r.next);
    r.last = mem_alloc(n, sizeof *r.last);
    r.quality = mem_alloc(n, sizeof *r.quality);
    for (size_t i = 0; i < n; i++) {
        r.next[i] = (i + 1) % n;
        r.last[i] = (i + n - 1) % n;
    }
    for (size_t i = 0; i < n; i++)
        r.quality[i] = quality_of(&r, i);
    return r;
}

static double ear_area(const struct ring *r, size_t i)
{
    return area_of(r->at[r->last[i]], r->at[i], r->at[r->next[i]]);
}

/* The corner with the best ear of those that leave some area: without the last of it the corners
 * left lie on one line.  The flattest corner where there is no ear. */
static size_t best_of(const struct ring *r, size_t from)
{
    size_t best = from;
    double quality = -1;
    for (size_t k = 0, i = from; k == 0 || i != from; k++, i = r->next[i])
        if (r->quality[i] > quality && ear_area(r, i) < r->room) {
            best = i;
            quality = r->quality[i];
        }
    if (quality > 0)
        return best;
    for (size_t i = r->next[from]; i != from; i = r->next[i])
        if (r->quality[i] > r->quality[best])
            best = i;
    if (r->quality[best] > 0)
        return best;
    double least = HUGE_VAL;
    for (size_t k = 0, i = from; k == 0 || i != from; k++, i = r->next[i]) {
        double area = fabs(ear_area(r, i));
        if (area < least) {
            least = area;
            best = i;
        }
    }
    return best;
}

void earclip(const struct uv *at, const int *corner, size_t n, struct faces *face)
{
    if (n < 3)
        return;
    struct ring r = ring_of(at, n);
    size_t from = 0;
    for (size_t k = 1; k + 1 < n; k++)
        r.room += (1 - TRIFLE) * area_of(at[0], at[k], at[k + 1]);
    for (size_t left = n; left >= 3; left--) {
        size_t i = best_of(&r, from), a = r.last[i], b = r.next[i];
        r.room = left > 4 ? r.room - ear_area(&r, i) : HUGE_VAL; /* the last one takes all */
        *array_push(face) = (struct face){{corner[a], corner[i], corner[b]}};
        r.next[a] = b;
        r.last[b] = a;
        if (left > 3) {
            r.quality[a] = quality_of(&r, a);
            r.quality[b] = quality_of(&r, b);
        }
        from = a;
    }
    free(r.next);
    free(r.last);
    free(r.quality);
}
