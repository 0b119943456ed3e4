/*
 * machine - machine tools and their rotary axes: the door of this folder.
 *
 * A machine is a text file of `key = value` lines (cloudmill-machine(5)).  A new machine is a file
 * in machines/, best with an `include` of one that is shipped.  `#` starts a comment;
 * `include = NAME` takes over another machine's keys, which later lines overrule.  A key that is
 * unknown, stands twice in one file, or has a value of the wrong kind is an error with its line.
 * A new key is a row in machine_keys (machine.c), a field here and an item of the manual.
 *
 * The keys make a chain of up to two rotary axes (machine_finish).  What is computed from it:
 *
 * - kinematics.h: the chain forward and inverse, both solutions of a tool axis.
 * - ik_choose.h: of the solutions and their whole turns, the nearest within the travel.
 * - ik_near.h: the same in its usual case, for millions of places.
 * - ik_branch.h: solutions and whole turns along a pass as numbered states.
 * - ik_plan.h: the states over a whole pass by dynamic programming, fewest turns back first.
 * - interpolation.h: what a control makes of a block, against the motion that is meant.
 * - rotary_spline.h: rotary angles along a B-spline as B-splines (The NURBS Book, 9.4.1).
 * - rotary_cost.h: how far the axes of any machine turn between two tool axes.
 *
 * Beside them stand control.h, the table of controls; control_text.h, a control as a text file;
 * template.h, text with fields; machine_options.h, the options -m, --set and -c.
 */
#ifndef CLOUDMILL_MACHINE_H
#define CLOUDMILL_MACHINE_H

#include <stdbool.h>

#include "base/error.h"
#include "machine/control.h"
#include "machine/control_text.h"
#include "machine/kinematics.h"

enum { MACHINE_X, MACHINE_Y, MACHINE_Z, MACHINE_A, MACHINE_B, MACHINE_C, MACHINE_AXES };

/* Feeds without tool-centre-point control: in inverse time, or in mm and degrees a minute along
 * all axes together, the square root of the sum of the squares of their ways. */
enum machine_feeds { FEEDS_INVERSE, FEEDS_COMBINED };

/* Where the rotary axes stand when tool-centre-point control is switched on: at zero, so that the
 * frame is that of the work whatever it is fixed to, or where the first motion has them. */
enum machine_tcp_frame { TCP_FRAME_ZERO, TCP_FRAME_STANDS };

/* How G49 leaves the tool's length: in the block that goes home, alone, or with a height. */
enum machine_length_off { LENGTH_OFF_HOME, LENGTH_OFF_ALONE, LENGTH_OFF_Z };

/* How rotary words are written: as is usual for the control (Siemens: of an axis that turns without
 * end DC()); the angle as it is; within 0 to 360, the control taking the shortest way; the same as
 * DC(); the same with the sign of the turn; the control's words for the shortest way. */
enum machine_rotary_words {
    ROTARY_OWN,
    ROTARY_PLAIN,
    ROTARY_WITHIN,
    ROTARY_DC,
    ROTARY_SIGNED,
    ROTARY_SHORTEST
};

/* A tool that the machine file or its table of tools describes. */
struct machine_tool {
    int number;
    double length; /* mm; NAN: not said */
    char name[40]; /* "": none */
};

enum { MACHINE_TOOLS = 100, MACHINE_OFFSETS = 20, MACHINE_AUX = 30 };

enum { MACHINE_BLOCKS = 300 };

enum machine_type { TABLE_TABLE, HEAD_TABLE, HEAD_HEAD, ONE_TABLE, ONE_HEAD, NO_ROTARY };

/* How many decimals the control is given; -1: the control's usual number. */
struct machine_digits {
    int linear, angle, vector, knot, feed;
};

struct machine {
    char name[100];
    char file[100];           /* as it was named for machine_read; "": too long for here */
    char set[MACHINE_BLOCKS]; /* what machine_set changed, blanks between, as far as it fits */
    char control[60];         /* a name or file, "": any */
    char used[60];            /* the control that was asked for or read, "": none */
    struct control_text text; /* its programs as text */
    int type;                 /* enum machine_type */
    char axes[20];            /* letters of the rotary axes, the outer (master) first: "A C" */
    struct vec3 axis[3];      /* directions of A, B, C at zero */
    struct vec3 centre[3];    /* a point on each: of a table's axis in the work frame, of a head's
                                 from the tool tip at zero (so the tool's length is in it), mm */
    bool tcp;                 /* tool-centre-point control: G43.4, TRAORI */
    bool arcs_tcp;            /* arcs also while tool-centre-point control is on */
    bool arcs_space;          /* Fanuc: G02.4 for arcs in no principal plane */
    bool arcs, splines;       /* the control has them: 3-D and planar arcs, NURBS or polynomials */
    bool vectors;             /* it has words for the tool axis as a vector, if its base has */
    double min[MACHINE_AXES]; /* travel, mm and degrees */
    double max[MACHINE_AXES];
    double rapid[MACHINE_AXES];        /* mm/min and degrees/min; X Y Z have one */
    double acceleration[MACHINE_AXES]; /* mm/s^2 and degrees/s^2, at most */
    double jerk[MACHINE_AXES];         /* mm/s^3 and degrees/s^3, at most */
    bool slows;                        /* the control slows down where F asks too much of an axis */
    double smoothing;                  /* mm of the path over which the control rounds a corner */
    double retract;                    /* mm along the tool axis, where the path has no approach */
    int tcp_frame;                     /* enum machine_tcp_frame */
    int length_off;                    /* enum machine_length_off */
    double length_z;                   /* of LENGTH_OFF_Z: where the spindle goes, mm */
    int rotary_words;                  /* enum machine_rotary_words */
    char offset[60];                   /* work offset; "": the control's own, G54 */
    int feeds;                         /* enum machine_feeds */
    double feed_max;                   /* largest F that the control takes */
    bool cycles;                       /* the control has drilling cycles */
    bool cutcom;                       /* radius compensation where the path asks for it */
    bool plane;  /* the control turns to a tilted plane where the tool axis is fixed */
    bool smooth; /* the control is to smooth the path within ncpost's tolerance */
    struct machine_templates {      /* blocks, "": none (template.h) */
        char home[MACHINE_BLOCKS];  /* retracts Z to a safe height */
        char safe[MACHINE_BLOCKS];  /* before it: what may still be on is switched off */
        char start[MACHINE_BLOCKS]; /* after the modal words at the start */
        char tool_change[MACHINE_BLOCKS];
        char tcp_on[MACHINE_BLOCKS], tcp_off[MACHINE_BLOCKS];
        char smooth_on[MACHINE_BLOCKS], smooth_off[MACHINE_BLOCKS];
        char plane_on[MACHINE_BLOCKS], plane_off[MACHINE_BLOCKS];
        char clamp_on[MACHINE_BLOCKS]; /* of the rotary axes, around a tilted plane's turn */
        char clamp_off[MACHINE_BLOCKS];
        char coolant_on[60], coolant_mist[60], coolant_off[60]; /* "": M8, M7, M9 */
        char coolant_thru[60], coolant_air[60];                 /* "": the machine has none */
        char spindle_cw[60], spindle_ccw[60], spindle_off[60];  /* after S, "": M3, M4; M5 */
        char stop[60], stop_optional[60];                       /* "": M0, M1 */
        char dwell[MACHINE_BLOCKS];
        char tap[MACHINE_BLOCKS]; /* before a tapping cycle: M29 S{rpm} */
        char end[MACHINE_BLOCKS]; /* before M30 */
    } blocks;
    bool tool_names; /* tools are called by their names, where they have one */
    bool tool_next;  /* the next tool is selected when one has been taken */
    bool tool_stop;  /* an optional stop before each tool */
    bool block_skip; /* OPSKIP of the path marks blocks */
    size_t tools;    /* how many are described */
    struct machine_tool tool[MACHINE_TOOLS];
    char tool_offset[MACHINE_OFFSETS][20]; /* work offset of the n-th tool's work, "": offset */
    struct machine_aux {
        int number;
        char blocks[60];
    } aux[MACHINE_AUX]; /* what AUXFUN/number becomes; number -1: unused */
    int number_step;    /* of block numbers, 0: none */
    int number_max;     /* after it they begin again */
    struct machine_digits digits;

    struct kinematic_chain chain; /* made of the above; travel in radians */
    int letter[ROTARY_MAX];       /* MACHINE_A ... of each axis of the chain */
};

/* Table-table A/C with tool-centre-point control, as machines/table-ac.txt. */
struct machine machine_default(void);

/*
 * Reads NAME: with a slash or an ending that file; else NAME.txt in the current folder, in
 * $CLOUDMILL_MACHINES, then among the machines installed, or built, with the running program.
 */
int machine_read(struct machine *machine, const char *name, struct error *error);

/*
 * The control's keys and sections over those of the machine, so that it is called before
 * machine_read: one of control.h, which is built in, or NAME.txt as with machine_read, in
 * $CLOUDMILL_CONTROLS and the folders `controls`, or a file.
 */
int machine_control(struct machine *machine, const char *name, struct error *error);

/* There is such a control; false with the error. */
bool machine_control_exists(const char *name, struct error *error);

/* True if there is such a file among the machines. */
bool machine_exists(const char *name);

/* One more `key=value`, as the command line has it. */
int machine_set(struct machine *machine, const char *setting, struct error *error);

/* Checks what the keys say together and makes the chain; to be called last. */
int machine_finish(struct machine *machine, struct error *error);

/* The tool of that number, NULL: it is not described. */
const struct machine_tool *machine_tool(const struct machine *machine, int number);

/* Tool lengths are described, so that centres of heads are seen from the spindle's nose. */
bool machine_has_lengths(const struct machine *machine);

/* A rotary axis turns the tool. */
bool machine_has_head(const struct machine *machine);

/* True if programs of this control can have tool-centre-point control on the machine. */
bool machine_has_tcp(const struct machine *machine, enum control_id control);

/* The letter of an axis: 'X' ... 'C'. */
char machine_letter(int axis);

#endif
