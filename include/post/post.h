/*
 * post - a path as an NC program for a control and a machine: the door of this folder.
 *
 * In comes a path (io/path/path.h: cutter locations, arcs, B-splines, with tool, feeds and ledger),
 * the row of a control (control.h) and a machine (machine.h); out goes the program's file.  All of
 * it is planned and checked on printed digits before the first byte is written.  The stages:
 *
 * 1. Frame (post_frame.h).  Path, machine and tolerances are brought into the frame of the program:
 *    tilted planes (3+2), inches.  Holes stay drilling cycles where the tool stands upright in that
 *    frame; else they become motions.
 *
 * 2. Ability (dialect.h).  Control, machine and options say what the program may hold: tool centre
 *    point control or solved kinematics, vectors or rotary words, arcs, splines, digits, the kind
 *    of F.
 *
 * 3. Plan (post_plan.h).  The path becomes moves, each with its numbers as they will be printed.  A
 *    curve that the control cannot be given goes down the ladder: B-spline (post_spline.h), arc
 *    (post_arc.h), straight blocks within the tolerance.  The planner (post_planner.h) has these
 *    modules, each using those before it:
 *
 *    - post_ik: a pose as words, by the angles that are nearest and within the travel.
 *    - post_feed: F of a block, from the time that the slowest axis needs.
 *    - post_motion: a motion as blocks, halved until the control's own way keeps the tolerance.
 *    - post_rewind: retract, turn, return, where a rotary axis comes to the end of its travel.
 *    - post_item: an item of the path, as a hole or another tool; the approach before a cut and the
 *      retract after it, where the path has none.
 *    - post_lookahead: the rotary axes of a group with the fewest turns back and then the least
 *      travel, as the shortest path through a graph (machine/ik_plan.h).
 *    - post_group: the path group by group, the nearest way or along what the look ahead found.
 *
 *    What all of it takes with the axes' accelerations is in post_time.h: the time in the head, and
 *    inverse-time feeds.
 *
 * 4. Text (post_program.h).  The control's dialect (fanuc.c, siemens.c, heidenhain.c, linuxcnc.c;
 *    gcode.h is the G-code that several share: head of the program, tool, blocks, end) sets the
 *    moves down in words (post_words.h), with a comment for people at the top (post_head.h), what
 *    the path says between motions (post_statement.h) and drilling cycles (post_hole.h), in blocks
 *    (post_writer.h); post_output.h makes the files.
 *
 * A new control is a row in machine/control.h and src/post/NAME.c.
 */
#ifndef CLOUDMILL_POST_H
#define CLOUDMILL_POST_H

#include "io/path/path.h"
#include "io/path/path_part.h"
#include "machine/control.h"
#include "machine/machine.h"
#include "stage/made_moves.h"

/* How the tool axis is to be programmed: as usual for the control, or as asked. */
enum post_axis_words { POST_AXIS_USUAL, POST_AXIS_VECTORS, POST_AXIS_ROTARY };

/* What INSERT becomes: a block as it stands, a comment, an error. */
enum post_insert { POST_INSERT_PASS, POST_INSERT_COMMENT, POST_INSERT_REFUSE };

/* What the user chose. */
struct post_options {
    double chord;          /* ncpost's own share of the tolerance, mm */
    double axis_tolerance; /* of the tool axis, radians */
    double feed;           /* mm/min where the path gives none */
    bool contact_feed;     /* the path's feeds are those of the contact point */
    bool plane;            /* a tilted plane instead of tool-centre-point control */
    bool inch;
    enum post_axis_words axis;
    enum post_insert insert;
    bool no_spindle;  /* no complaint where the path has no speed or no tool's number */
    const char *name; /* number or name of the program, NULL: as usual for the control */
};

/* Which part of the program is written; how long a file may be, 0: no limit. */
struct post_extract {
    int from;    /* the pass to begin with, -1: the start */
    int explain; /* number of a block whose origin is explained instead, -1: none */
    size_t blocks, bytes;
    struct path_part part; /* only the text of these passes, to be joined; n 0: all */
};

/* What was assumed, added, and kept; lengths in mm. */
struct post_report {
    bool feed_assumed, approach_made, retract_made;
    bool steps_evened;  /* drilling cycles took the smaller step and no dwell */
    bool cutcom_off;    /* the path asks for radius compensation, and the program has none */
    bool no_spindle_on; /* it cuts before the spindle has a speed, and that was not asked for */
    bool no_tool;       /* a tool without a number, the same */
    bool no_coolant;    /* a kind of coolant for which the machine has no word */
    bool no_vectors;    /* took rotary words: with vectors an axis would run out of its travel */
    size_t turns;       /* retract, turn, return */
    size_t passes, lines, arcs, splines, rapids;
    size_t chorded; /* curves of the path that became straight blocks */
    double cut, rapid, minutes;
    size_t fast;        /* blocks that ask an axis for more than its largest speed, ... */
    unsigned fast_line; /* ... the first by its line of the path, ... */
    double fastest;     /* ... and how many times its speed at most */
    size_t peaks;       /* blocks where a control that slows down by itself has to, ... */
    double peak;        /* ... over less than 0.02 mm, and how many times the speed */
    double point, axis; /* deviation of the worst block: mm, radians */
    double ledger;      /* what all stages together spent */
};

/* A program that is planned. */
struct post;

/* 20000 blocks, 500k or 2M bytes. */
int post_limit_read(const char *text, struct post_extract *extract, struct error *error);

/* -1: the options ask for what the control, or the one that is built on it, does not know. */
int post_check(enum control_id control, const struct machine *machine,
               const struct post_options *options, struct error *error);

/*
 * Plans the program.  Path and machine are brought into the program's frame; they and the options'
 * name must outlive it.  NULL: *status is the exit status that the error deserves, EXIT_FAILED
 * (also where the machine cannot get there) or EXIT_USAGE.
 */
struct post *post_plan(enum control_id control, struct path *path, struct machine *machine,
                       const struct post_options *options, int *status, struct error *error);

/*
 * Writes the program to a file (NULL or "-": standard output), or to files with -1, -2 ... before
 * the ending of its name; *files is how many.  -1: there is no such pass or block, no room for a
 * block, or no way off the part within the travel.
 */
int post_write(struct post *post, struct post_extract extract, const char *file, size_t *files,
               struct error *error);

/* The name of a part, from 1: part-2.nc of part.nc.  To be freed. */
char *post_part_name(const char *file, size_t part);

struct post_report post_report(const struct post *post);

/* The rapid moves of its first tool that the path does not have: off the part and back to it so
 * that a rotary axis can turn, an approach, a retract.  None of a program in tilted planes.  To be
 * freed (array_free). */
struct made_moves post_made_moves(const struct post *post);

void post_free(struct post *post);

/*
 * A short path that shows on the real machine whether the signs and the centres of its rotary axes
 * are right: the tip goes to a place 100 mm above the work's zero point and stays there while the
 * rotary axes tilt the tool, first to one side and then to the others, with a stop at each.  A dial
 * indicator against a ball at that place must not move, and the tool must lean to where the comment
 * says.
 */
void post_selftest(struct path *path, const struct machine *machine);

#endif
