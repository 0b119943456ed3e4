/*
 * nc_motion - what a tool does, as a list of pieces that can be evaluated anywhere.
 *
 * A program as its control runs it (ncread/ncread.h) becomes one.  Everything is evaluated by
 * formulas of this file alone, so that no mistake of the suite's own arcs and splines is made
 * twice.  Lengths in mm, rotary axes in degrees.
 */
#ifndef CLOUDMILL_NC_MOTION_H
#define CLOUDMILL_NC_MOTION_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "simulate/verify_kinematics.h"

/* The tool's tip and the unit vector along its axis, from the tip to the spindle. */
struct nc_motion_pose {
    struct vec3 p, a;
};

enum shape {
    SHAPE_LINE,
    SHAPE_ARC,        /* about `normal`, its radius and height changing evenly where they change */
    SHAPE_POLYNOMIAL, /* in s, of the fifth degree at most */
    SHAPE_SPLINE      /* part of a rational B-spline */
};

/* What the second channel q of a piece holds, and how the axis follows from it. */
enum axis_interpolation {
    AXIS_GREAT_CIRCLE,  /* the axis: on the great circle, in proportion to s */
    AXIS_ROTARY_LINEAR, /* the machine's angles in degrees (x, y), each in proportion to s */
    AXIS_BY_HEAD        /* a second point on the tool axis */
};

struct nc_motion_spline {
    int order;
    size_t n;           /* poles */
    double *knot;       /* n + order */
    struct vec3 *p, *q; /* poles of both channels; q NULL: it does not change */
    double *weight;     /* NULL: all 1 */
};

/* A piece of shape ARC: about a line through `centre`, by the right-hand rule. */
struct nc_motion_arc {
    struct vec3 centre, normal;
    double angle; /* radians */
};

enum { NC_MOTION_DEGREE = 5 }; /* of the polynomials that controls know */

/* A piece of shape POLYNOMIAL: the coefficients of s, s^2 and so on of both channels. */
struct nc_motion_polynomial {
    struct vec3 p[NC_MOTION_DEGREE], q[NC_MOTION_DEGREE];
    bool turns; /* q holds; else the second channel is linear */
};

struct nc_piece {
    unsigned char shape, interpolation; /* enum shape, enum axis_interpolation */
    bool rapid;
    bool table;    /* p is the place of the linear axes: verify_kinematics_tip */
    bool touches;  /* a contact point was given for its end */
    bool dark;     /* from a place whose X or Y is not known, such as the machine's home */
    bool inverse;  /* feed is one over the minutes that it takes */
    int block;     /* its N number, -1: none */
    size_t line;   /* of the program or stream */
    size_t index;  /* ARC, POLYNOMIAL, SPLINE: of its element in the array of these */
    double feed;   /* mm/min, 0: none given */
    double length; /* of the tool, from the spindle's nose; 0: centres are seen from the tip */
    double beyond; /* the length that the control reckons with is greater by so much */
    double u[2];   /* SPLINE: from, to */
    struct vec3 p[2], q[2]; /* both channels at the start and the end */
};

/* What the first channel is: the tool's tip, or the ball's centre. */
enum nc_motion_track { NC_MOTION_TIP, NC_MOTION_CENTRE, NC_MOTION_CONTACT };

/* What only some paths ask for: other speeds of the spindle, or another way round, amid a tool;
 * blocks that a switch of the control leaves out. */
enum nc_asked { NC_ASKED_SPEEDS = 1, NC_ASKED_SKIPS = 2 };

/* What a reader finds wrong with a program that can be run all the same. */
struct nc_remark {
    size_t line;
    int block; /* -1: none */
    char text[120];
    bool notice;     /* no fault: nobody knows that it was not meant so */
    unsigned unless; /* of enum nc_asked: nothing is wrong where the path asks for it */
};

/* A move at rapid that is no piece, for nothing tells where the tip goes: X, Y or a rotary axis
 * from where the last piece ended, its Z not home yet; or Z, a rotary axis not known to be at
 * zero. */
struct nc_blind {
    size_t line;
    int block;     /* -1: none */
    size_t pieces; /* that were before it */
    bool nose;     /* without the tool's length: Z is the spindle's */
    bool turned;   /* without tool centre point control, the rotary axes not known to be at zero */
    bool z_said;   /* Z goes to: */
    double z;      /* mm */
};

struct nc_motion {
    const char *name; /* of the file */
    struct verify_kinematics kinematics;
    enum nc_motion_track track;
    struct {
        size_t n, cap;
        struct nc_piece *item;
    } piece;
    struct {
        size_t n, cap;
        struct nc_motion_arc *item;
    } arc;
    struct {
        size_t n, cap;
        struct nc_motion_polynomial *item;
    } polynomial;
    struct {
        size_t n, cap;
        struct nc_motion_spline *item;
    } spline;
    struct {
        size_t n, cap;
        struct nc_remark *item;
    } remark;
    struct {
        size_t n, cap;
        struct nc_blind *item;
    } blind;
    struct {
        double most; /* by so much a block lets the control round corners, in the program's unit */
        size_t line;
        int block;                     /* -1: none */
    } rounding;                        /* 0: none does; HUGE_VAL: as far as it likes */
    double unit;                       /* of the lengths in the program, mm; 0: 1 */
    bool coolant;                      /* is on at the first cut */
    char work[60];                     /* the work offset there, as its words say it; "": none */
    int turns;                         /* the spindle there: 1 clockwise, -1, 0: not known */
    double speed;                      /* rev/min, 0: none is said */
    unsigned asked;                    /* of a path, or by the head of a program: enum nc_asked */
    int tool, offset;                  /* number, -1: a name, and that of its length; 0: none */
    size_t blocks;                     /* lines with something in them */
    double dwell;                      /* minutes that the tool stands still */
    size_t passes;                     /* the path stream's */
    size_t lines, arcs, curves, poles; /* as programmed: straight moves, and so on */
};

void nc_motion_free(struct nc_motion *m);

/* -1 with the line and block where moves of more than 10 m, which no machine makes, are 100 m
 * together: to follow them in steps that a part needs takes time and memory without bound. */
int nc_motion_bounded(const struct nc_motion *m, struct error *error);

/* Where the tool is at s from 0 to 1 of a piece. */
struct nc_motion_pose nc_motion_at(const struct nc_motion *m, const struct nc_piece *piece,
                                   double s);

/* The same, but for where the ball's centre is where the tip is tracked; `radius` of the ball, mm. */
struct nc_motion_pose nc_motion_ball(const struct nc_motion *m, size_t piece, double s,
                                     double radius);

/* The angles of the rotary axes there, degrees, if the piece gives them (AXIS_ROTARY_LINEAR); else
 * false, and they follow from the pose's axis. */
bool nc_motion_angles(const struct nc_motion *m, const struct nc_piece *piece, double s,
                      double turn[VERIFY_KINEMATICS_AXES]);

/* The machine with the tool that makes the piece. */
struct verify_kinematics nc_motion_kinematics(const struct nc_motion *m,
                                              const struct nc_piece *piece);

/* What a degree counts where F is along all axes, mm: an inch in a program in inches. */
double nc_motion_degree(const struct nc_motion *m);

/* Adds a piece for each knot span of the spline, which the motion takes over. */
void nc_motion_add_spline(struct nc_motion *m, struct nc_motion_spline spline,
                          const struct nc_piece *as);

#endif
