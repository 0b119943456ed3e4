/*
 * cl_state - where the tests' reader of paths stands in a CL file, and what its parts share: cl.c
 * the words and points, cl_curve.c arcs and B-splines, cl_hole.c drilling cycles.
 */
#ifndef READBACK_CL_STATE_H
#define READBACK_CL_STATE_H

#include "base/array.h"
#include "cl.h"
#include "cl_text.h"

#define CL_INCH 25.4 /* mm */
#define CL_NEAR 0.01 /* mm: what counts as on a circle, in its plane, at a pole */

/* An orthonormal frame of NX. */
struct cl_frame {
    struct vec3 origin, x, y, z;
};

/* A CIRCLE that waits for its end. */
struct cl_arc {
    bool open;    /* its end is missing */
    bool lasting; /* it has its end, and further points may follow on it */
    struct vec3 centre, axis;
    double radius, turns; /* turns 0: none given */
};

/* A B-spline being read: MOVNRB, NURBS of NX, or NURBS_SIEMENS of CATIA. */
struct cl_spline {
    bool open, fallback, catia;
    bool five, fixed; /* 5AXIS, M3AXIS were read */
    double length;    /* from tip to head, mm */
    size_t order, knots, poles;
    struct doubles knot;
    struct vec3s tip, head;
};

enum cl_hole_kind { HOLE_DRILL, HOLE_DEEP, HOLE_BREAK, HOLE_TAP, HOLE_BORE, HOLE_STOPPED };

/* The drilling cycle that is on; heights above the mouth along the tool axis, mm. */
struct cl_hole {
    bool on, home; /* home: the tool leaves as high as it came */
    enum cl_hole_kind kind;
    double depth, clear, retract, step, next, feed;
    struct vec3 before; /* where the tool came from */
};

struct cl_state {
    const char *file;
    const struct cl_statement *statement;
    struct nc_motion *motion;
    struct cl *cl;
    struct error *error;
    bool creo, nx, makino; /* whose file it is */
    bool ended;            /* FINI, or what stands for it */
    double unit;           /* mm */
    bool known;            /* `at` is where the tool is */
    bool moved;            /* there is a motion that went there */
    struct vec3 at, axis, from;
    bool has_from;
    struct vec3 shift; /* ORIGIN and TRANS, mm */
    struct vec3 normal_of_clearance;
    double clearance; /* normal . p = clearance */
    bool has_clearance;
    bool rapid, touches;
    double feed, spindle; /* mm/min, turns a minute */
    bool inverse;
    struct vec3 tangent; /* INDIRV */
    size_t frames;
    struct cl_frame first, frame;
    struct cl_arc arc;
    struct cl_spline spline;
    struct cl_hole hole;
};

/* An error with the line of the statement. */
int cl_wrong(struct cl_state *s, const char *what);

/* n numbers from argument i on, or an error. */
int cl_expect(struct cl_state *s, size_t i, size_t n, double *value);

/* Numbers of the stream as a place in mm, and as a unit vector (false: of no length). */
struct vec3 cl_point(const struct cl_state *s, const double v[3]);
bool cl_direction(const struct cl_state *s, const double v[3], struct vec3 *direction);

/* A piece from where the tool is, with what holds for it; the tool is then at its end. */
struct nc_piece cl_piece(struct cl_state *s, struct vec3 to, struct vec3 axis);
void cl_straight(struct cl_state *s, struct vec3 to, struct vec3 axis, bool rapid);

/* ---- cl_curve.c */

int cl_read_circle(struct cl_state *s);
int cl_arc_end(struct cl_state *s, struct vec3 to, struct vec3 axis);
/* A point after an arc's end that lies further on it, which makes another arc. */
bool cl_arc_goes_on(struct cl_state *s, struct vec3 to);
int cl_read_tlon(struct cl_state *s);
int cl_read_movnrb(struct cl_state *s);
int cl_read_nurbs(struct cl_state *s);
int cl_read_nurbs_siemens(struct cl_state *s);
int cl_nurbs_siemens_end(struct cl_state *s);
/* At the first statement after those of a NURBS: the curve is complete. */
int cl_nurbs_end(struct cl_state *s);

/* ---- cl_hole.c */

int cl_read_cycle(struct cl_state *s);
int cl_drill(struct cl_state *s, struct vec3 mouth, struct vec3 axis);

#endif
