/*
 * dialect - the writers of the controls as tables of functions, one file a control.
 *
 * A dialect writes the motions; the blocks around them are text, the sections of the control's file
 * (post_template.h).  A new one is a row in the table of control.h and a file with its
 * `struct dialect`; one that has Fanuc's kind of G-code takes most of its functions from gcode.h.
 */
#ifndef CLOUDMILL_DIALECT_H
#define CLOUDMILL_DIALECT_H

#include "machine/control.h"
#include "post/post.h"
#include "post_frame.h"
#include "post_plan.h"
#include "post_writer.h"

/* What is in the spindle and how it turns, as the program goes on. */
struct nc_tooling {
    size_t taken;   /* how many of the path's further tools came before it */
    int number;     /* 0: none was given */
    int offset;     /* of its length; the number where nothing else was said, 1 where none was */
    double spindle; /* rev/min, 0: it stands */
    bool ccw;
    int coolant; /* as in path_head */
    size_t next; /* where the search for the program's first motion with it starts */
};

/* A program while it is written. */
struct nc_program {
    enum control_id control;
    const struct path *path;
    const struct machine *machine;
    const struct nc_plan *plan;
    struct nc_plan_options options;
    bool plane; /* the path is in tilted planes, which the control turns to */
    struct nc_planes planes;
    size_t at_plane;    /* where the program is among them */
    bool same_tool;     /* it goes back to work after a change of planes alone */
    int turned;         /* rotary axes of the machine that the control turns for them */
    size_t part, parts; /* 1 of 3; 0: the whole */
    const int *from;    /* the pass that it begins with; NULL: the first */
    size_t met;         /* the move whose block is w.wanted */
    struct nc_tooling tooling;
    struct {
        int asked, on;
    } cutcom;                   /* post_statement.h */
    const struct nc_hole *hole; /* whose drilling cycle is on, NULL: none is */
    double seconds;             /* of the dwell that is written */
    struct post_options asked;
    bool warned;        /* of a spindle that stands */
    size_t offset_said; /* number of the operation whose work offset is on, from 1 */
    const char *name;   /* number or name asked for, NULL: by the dialect */
    struct nc_writer w;
};

struct gcode;

enum { NC_NAME_MAX = 100 };

struct dialect {
    const struct gcode *gcode; /* the words of a control of that kind (gcode.h), NULL: it is none */
    struct machine_digits digits; /* usual numbers of decimals */
    bool vectors;                 /* the usual axis words under tool-centre-point control */
    bool vectors_never;           /* it knows no vectors */
    bool vectors_doubtful;        /* see struct nc_ability */
    bool inverse_never;           /* it knows no inverse-time feed */
    bool steps_alike;             /* its drilling cycles know one step, and no dwell with it */
    bool plane;                   /* it can turn to a tilted plane */
    enum nc_plane_angles plane_angles;
    enum nc_arcs arcs, arcs_vectors;
    enum nc_arcs arcs_space; /* those of a machine that has the key arcs.space */
    enum nc_splines splines, splines_vectors;

    const char *tool_named; /* how a tool is called by its name, for printf; NULL: it is not */

    /* -1: a name or number that the control does not take */
    int (*check_name)(const char *name, struct error *error);
    /* of this program, NC_NAME_MAX long with its end: what is asked for, or follows from the path
     */
    void (*name)(const struct nc_program *p, char *name);
    void (*line)(struct nc_program *p, const struct nc_move *move); /* rapids too */
    void (*arc)(struct nc_program *p, const struct nc_move *move);
    void (*spline)(struct nc_program *p, const struct nc_move *move);
    void (*hole)(struct nc_program *p, const struct nc_move *move); /* post_hole.h */
    void (*hole_end)(struct nc_program *p);
    /* another speed than that of the tool's start; NULL: S with M3 or M4 */
    void (*speed)(struct nc_program *p, double rpm, bool ccw);
};

/* The writer of a control's programs. */
const struct dialect *dialect_of(enum control_id control);

/* What a program for this control and machine may hold.  `still`: the rotary axes stay at zero, and
 * nothing needs to be said of them. */
struct nc_ability dialect_ability(enum control_id control, const struct machine *machine,
                                  enum post_axis_words axis, bool still, double unit);

#endif
