/*
 * box_tree - which of many items in space is nearest to a point?  A hierarchy of boxes along X, Y
 * and Z around items of any kind, halved at the median of their middles across the widest side.
 *
 * The tree knows each item's box alone; the distance to the item itself is the caller's.  For
 * facets, which stand for meshes, polylines and clouds alike, it is here.  Lengths in mm.
 *
 * Source: bounding volume hierarchies with a median split; the search visits the nearer child
 * first (C. Ericson, Real-Time Collision Detection, 6.2 and 6.3).
 */
#ifndef CLOUDMILL_BOX_TREE_H
#define CLOUDMILL_BOX_TREE_H

#include <stdbool.h>
#include <stddef.h>

#include "math/box.h"
#include "math/vec.h"

struct box_tree;

/* The tree over n items, item i inside box[i].  The boxes are not needed any more after it. */
struct box_tree *box_tree_new(const struct box *box, size_t n);
void box_tree_free(struct box_tree *tree);

/* Squared distance of p to one item, mm^2. */
typedef double box_tree_distance2(const void *items, size_t item, struct vec3 p);

/*
 * The distance of p to the nearest item and, when that is below `within`, the item in *nearest (of
 * several as near the first); else `within` itself.  *nearest on entry: an item that may be near,
 * or n and above for none; it makes the search shorter and changes nothing else.
 */
double box_tree_nearest(const struct box_tree *tree, const void *items,
                        box_tree_distance2 *distance2, struct vec3 p, double within,
                        size_t *nearest);

/* Does something with an item; true ends the search. */
typedef bool box_tree_visit(void *context, size_t item);

/* Visits every item whose box is within `reach` of p, and some beside them; true: one ended it. */
bool box_tree_each(const struct box_tree *tree, struct vec3 p, double reach, box_tree_visit *visit,
                   void *context);

/* A triangle; with two corners at one place a straight piece, with all three a point. */
struct facet {
    struct vec3 corner[3];
};

struct facets {
    size_t n, cap;
    struct facet *item;
};

/* The point of the facet that is nearest to p. */
struct vec3 facet_nearest(const struct facet *facet, struct vec3 p);

struct box_tree *facets_tree(const struct facets *facets);

/* Distance of p to the nearest of the facets that the tree was made from; HUGE_VAL: there are none.
 */
double facets_distance(const struct box_tree *tree, const struct facets *facets, struct vec3 p);

#endif
