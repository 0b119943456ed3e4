/*
 * arcspline - arcs joined with common tangents, given by their joints; how far the points of a
 * reference are off them; and the joints moved until that is little.
 *
 * The joints and the tangent at the start determine all: the tangent at the end of an arc is the
 * one at its start, mirrored in the arc's chord.  So a joint that moves turns every arc after it.
 */
#ifndef CLOUDMILL_ARCSPLINE_H
#define CLOUDMILL_ARCSPLINE_H

#include "arcfit/arc_piece.h"

struct arcspline {
    size_t n; /* arcs */
    struct joint {
        struct vec3 p, tangent, axis; /* the tool axis there; both unit */
        double place;                 /* on the reference, nearest to p */
        double side; /* mm that the axis takes the other point sideways, off the reference */
    } * joint;       /* n + 1 */
};

struct arcspline arcspline_new(size_t arcs);
void arcspline_free(struct arcspline *spline);
void arcspline_copy(struct arcspline *to, const struct arcspline *from); /* equally many arcs */

/* Sets the tangents after joint `from` by the joints and the tangent there. */
void arcspline_set_tangents(struct arcspline *spline, size_t from);

/* Sets place and axis of a joint by its p and side: the axis is the reference's there, turned by
 * side. */
void arcspline_set_axis(struct arcspline *spline, const struct reference *reference, size_t joint);

/* The same, with the axis turned to its side so that it is as near as may be to the one given. */
void arcspline_lean_axis(struct arcspline *spline, const struct reference *reference, size_t joint,
                         struct vec3 axis);

/* Arc number i, between joints i and i + 1. */
struct arc arcspline_arc(const struct arcspline *spline, size_t i);

/* Appends the spline as pieces of the motion. */
void arcspline_pieces(const struct arcspline *spline, const struct reference *reference,
                      struct pieces *pieces);

/* A place of a reference, and its foot on the spline. */
struct arc_foot {
    struct vec3 p, other; /* the two points */
    struct vec3 u, v;     /* unit, across the path of p */
    struct vec3 s, w;     /* unit, across the path of the other point */
    size_t arc;           /* the foot is on this arc, */
    double part;          /* at this fraction of it, */
    double conic;         /* or this one, as a conic (arc_foot_conic), where `rest` is below 0 */
    double sine, rest;    /* of half the turn up to it; half the turn beyond it, radians */
    struct vec3 at;       /* there */
};

/* At this fraction of its arc as a conic (arcspline_normal.h). */
double arc_foot_conic(const struct arc_foot *foot);

struct arc_feet {
    size_t n;
    struct arc_foot *item;
};

/*
 * At most `most` of the points `from` to `to` of a reference, evenly, both ends left out.  Where
 * there are not so many, middles between them too: an arc with two or three points is free to leave
 * the reference from one to the next.
 */
struct arc_feet arc_feet_of(const struct reference *reference, size_t from, size_t to, size_t most);
void arc_feet_free(struct arc_feet *feet);

/* First point with its foot on this arc or a later one. */
size_t arc_feet_first(const struct arc_feet *feet, size_t arc);

/*
 * How far all points are off the spline: off[2 i] and off[2 i + 1] along u and v, mm.  With an
 * `offset` to the other point, 2 n more: how far that one is off along s and w, both at the foot of
 * p.  Sets the feet.
 */
void arcspline_residual(const struct arcspline *spline, double offset, struct arc_feet *feet,
                        double *off);

/* Cosine of half a turn: an arc that turns by more is taken as its chord where it is a conic. */
#define ARCSPLINE_BLUNT 0.05

/* A spline whose joints are moved until its largest distance from the reference is small. */
struct arcspline_fit {
    const struct reference *reference;
    struct arcspline spline;
    struct arc_feet feet;
    double tolerance; /* mm, of the programmed point */
    double offset;    /* mm to the other point; 0: it is not looked at, the axis stands still */
    double other;     /* tolerance there, mm */
    bool start_held;  /* the tangent at the start may not turn */
    bool end_held;    /* the tangent at the end shall be `end` */
    struct vec3 end;
    size_t stage; /* the norm that it has come to: 0 to begin with */
    double asked; /* feet of points that were looked for so far */
};

/* Where a spline begins that was near to a reference which has moved a little; and nearly there. */
enum { ARCSPLINE_MOVED = 2, ARCSPLINE_NEARLY = 3 };

/*
 * Moves inner joints, axes there, and the tangent at the start, until no point is off by more than
 * `enough` of its tolerance: least squares of the distances' powers by Levenberg and Marquardt's
 * method, p-norms with a rising p.  Returns the largest part of a tolerance, above 1 where it gave
 * up; it does so early where there is no hope.  Called again with less, it goes on from there.
 */
double arcspline_optimize(struct arcspline_fit *fit, double enough);

#endif
