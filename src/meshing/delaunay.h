/*
 * delaunay - the triangulation of points seen from above whose smallest angles are the largest
 * (max-min angle criterion; Choi 1988, paper 1, fig. 6; Delaunay 1934), with edges that are kept.
 *
 * Points are put in one after the other (Lawson 1977), which splits a triangle and turns edges
 * until no triangle's circle has a point in it; an edge that is locked is not turned: the
 * triangulation is constrained by it.  All points in an order that is random at large and along a
 * Hilbert curve in detail (N. Amenta, S. Choi, G. Rote 2003): O(n log n).  The predicates are exact
 * (math/predicates.h).
 *
 * The points lie inside a triangle of three more that are DELAUNAY_FAR times as far away as the
 * points are from each other: facets whose circle is wider than that may be missing at the border.
 */
#ifndef CLOUDMILL_DELAUNAY_H
#define CLOUDMILL_DELAUNAY_H

#include <stdbool.h>

#include "base/array.h"
#include "math/uv.h"
#include "math/vec.h"

#define DELAUNAY_FAR 1e5

enum { DELAUNAY_NONE = -1 };

/* Counter-clockwise; beside[i] lies beyond the edge from v[i] to v[i + 1]. */
struct delaunay_triangle {
    int v[3], beside[3];
    unsigned char locked; /* bit i: the edge from v[i] on */
};

struct delaunay {
    int n;         /* points; n, n + 1, n + 2 are the far ones */
    struct uv *at; /* n + 3 */
    int *triangle; /* of each point: one that it is a corner of, or NONE: it is not put in */
    struct {
        size_t n, cap;
        struct delaunay_triangle *item;
    } t;
    struct ints changed; /* triangles that were made or changed since it was last emptied */
    bool record;         /* fill `changed` */
    int last;            /* a triangle near the last point */
    struct ints stack;   /* of its own */
};

/* Of n >= 1 points, none of which is put in. */
struct delaunay delaunay_new(const struct vec3 *point, size_t n);

/* Puts all points in.  Of points in one place only one becomes a corner. */
void delaunay_insert_all(struct delaunay *d);

/* Puts point i in.  False if there is another one in its place. */
bool delaunay_insert(struct delaunay *d, int i);

/* The same where the triangle is known that it lies in, or on the border of. */
bool delaunay_insert_in(struct delaunay *d, int triangle, int i);

/* A triangle that has the point in it or on its border, from the last one looked at on; not once
 * edges are locked. */
int delaunay_locate(struct delaunay *d, struct uv p);

/* The triangle with the edge from a to b, and which of its edges that is; NONE: there is none. */
int delaunay_edge(const struct delaunay *d, int a, int b, int *edge);

/* Turns edges that cross the way from a to b, as long as one next to its ends can be: where several
 * triangulations are as good.  True: there is that edge then. */
bool delaunay_force(struct delaunay *d, int a, int b);

/* Locks it on both sides. */
void delaunay_lock(struct delaunay *d, int triangle, int edge);

/* Is none of its corners far? */
bool delaunay_is_near(const struct delaunay *d, int triangle);

/* Diameter of the circle through its corners; of far ones something large. */
double delaunay_diameter(const struct delaunay *d, int triangle);

void delaunay_free(struct delaunay *d);

#endif
