/*
 * skin - what the joined patches are as a whole: bodies, closed or with borders, and their borders
 * as loops.
 */
#ifndef CLOUDMILL_SKIN_H
#define CLOUDMILL_SKIN_H

#include "nurbs/patch_mesh.h"

/* Open edges that hang together: a hole, a slit, or the border of an open surface. */
struct skin_loop {
    size_t edges;
    double length;  /* mm */
    double gap;     /* mm: how far its edges are, at most, from the open edges of other surfaces;
                      HUGE_VAL: there are none */
    struct vec3 at; /* there, or somewhere on it */
    int sheet;      /* of its longest edge */
};

struct skin_loops {
    size_t n, cap;
    struct skin_loop *item; /* the longest first */
};

/* Facets that hang together by their edges. */
struct skin_body {
    size_t facets, edges;
    size_t fans;         /* points of the surface: fans of facets about a place */
    size_t open;         /* edges of one facet alone */
    size_t many;         /* edges of more than two: the body touches itself there, or another */
    size_t uneven;       /* of these, those that are not as often gone along there as back */
    size_t unlike;       /* edges whose two facets are turned differently */
    double area, volume; /* mm^2; mm^3, of what is enclosed: only of a closed one */
    bool exact;          /* of the surfaces themselves (skin_measure.h), else of the facets */
    size_t number;       /* as they were found */
    bool shared;         /* facets of a surface are in another body, too */
    long genus;          /* handles, of a closed one that nowhere touches itself along an edge */
};

struct skin_bodies {
    size_t n, cap;
    struct skin_body *item; /* the largest area first */
};

struct skin {
    struct skin_loops loop;
    struct skin_bodies body;
    size_t open, many, unlike; /* edges, of all bodies */
    size_t *open_on;           /* [sheet] open edges of its facets */
    int *body_of; /* [sheet] the number of the body that it is a part of, -1: of none or several */
};

/* Closed: no open edge, and all facets turned alike; along an edge of more than two as many of them
 * go there as go back, so that the body bounds a volume although it touches itself. */
bool skin_body_closed(const struct skin_body *body);

/* Of the patches as they are joined and turned.  Facets whose corners have less than three places
 * do not count. */
struct skin skin_of(const struct patch_mesh *mesh);

void skin_free(struct skin *skin);

#endif
