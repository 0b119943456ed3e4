/*
 * patch - a trimmed surface: a NURBS surface and the curves that trim it.
 */
#ifndef CLOUDMILL_PATCH_H
#define CLOUDMILL_PATCH_H

#include "mesh/scan_source.h"
#include "nurbs/nurbs.h"

/* A closed loop of curves in the plane of the parameters (x is u, y is v) or in space (mm), each
 * beginning where the one before it ends; a curve may run backwards, unless the loop is directed.
 */
struct patch_loop {
    size_t n, cap;
    struct nurbs_curve *item;
    bool space;
    bool directed; /* all curves run forwards, and what counts is on the left of the loop */
    double rough;  /* mm: how far they are off those of the file, which they only approximate */
};

struct patch_loops {
    size_t n, cap;
    struct patch_loop *item;
};

/* Which side of its only loop a patch is on: the file tells it, or it is taken to be ... */
enum patch_side {
    PATCH_SIDE_TOLD,
    PATCH_SIDE_LEFT,   /* ... on the left of a loop that goes round the surface ... */
    PATCH_SIDE_WITHIN, /* ... within one that crosses its seam ... */
    PATCH_SIDE_UNKNOWN /* ... or the same on a surface that closes both ways, which has no poles */
};

struct patch {
    struct nurbs surface;
    struct patch_loops loop; /* none: untrimmed */
    struct patch_loops told; /* in the parameters, roughly, the same: which side counts; or none */
    bool outer;              /* the file says that the first loop goes round the others */
    bool open;               /* the border of the range bounds it too: all loops are holes */
    bool unnamed;            /* so it is, though the file says that it has an outer loop */
    char *file;              /* where it was read from ... */
    int entity;              /* ... and its number there: in IGES its directory entry */
    int body;                /* closed shell of the file that it is a face of, from 1; 0: none */
    int group;               /* of loose faces that the file keeps together, from 1; 0: none */
    bool cavity;             /* that shell bounds a void of its solid: its outside is within */
    double rough;            /* as in a loop, of the surface */
    bool doubled;            /* it coincides with one before it, which is used (coincident.h) */
    int ignored;             /* loops of curves that are not read ... */
    int ignored_entity;      /* ... the first of them ... */
    int ignored_type;        /* ... and the type of the curve */
};

/* Surfaces of one kind that were not read. */
struct patches_left {
    char kind[40]; /* as the file calls it */
    char *file;
    int entity; /* the first of them */
    size_t count;
};

struct patches {
    size_t n, cap;
    struct patch *item;
    struct scan_sources scan; /* that they were fitted to; none: not said */
    int bodies; /* closed shells so far: faces of two of them are not joined where they touch */
    int groups; /* of loose faces, numbered up to this */
    struct {
        size_t n, cap;
        struct patches_left *item;
    } left;
};

/* Are both of one closed shell of the file, or of one group of loose faces?  Bodies that touch stay
 * apart. */
bool patch_may_join(const struct patch *a, const struct patch *b);

/* Counts a surface that is not read. */
void patches_leave_out(struct patches *patches, const char *file, const char *kind, int entity);

/* A straight line in the parameters, as a curve of degree 1. */
struct nurbs_curve patch_line(struct uv from, struct uv to);

/* A curve over 0 to 1 with clamped knots; the poles, and the inner knots where poles > degree + 1,
 * are the caller's to fill. */
struct nurbs_curve patch_curve(int degree, size_t poles);

/* The diagonal of the box of all poles, mm. */
double patches_size(const struct patches *patches);

void patch_loop_free(struct patch_loop *loop);

/* The curves from `first` on run the other way, the last of them first. */
void patch_loop_turn(struct patch_loop *loop, size_t first);
void patch_free(struct patch *patch);
void patches_free(struct patches *patches);

#endif
