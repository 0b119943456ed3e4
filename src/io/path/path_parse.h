/*
 * path_parse - how a path stream is read, statement by statement: the private door of this folder.
 *
 * 1. apt.h joins lines to statements: a major word and its arguments.
 * 2. path_read.c looks up the word's row, in this order: the motions, the words of the CAM system
 *    that wrote the stream (cl_dialect.h), the head (path_head.c); or, of a `$$->` comment, its own
 *    table there.
 * 3. The row's function reads the arguments and changes `struct path_parse`, what the statements so
 *    far leave to those that follow, or adds items to its path: path_motion.c points and arcs,
 *    path_spline.h B-splines, path_cycle.c holes, path_tool.c tools, spindle and feeds.
 *
 * Plain GOTOs, most of a path, skip the first two steps (path_read_plain_gotos).
 */
#ifndef CLOUDMILL_PATH_PARSE_H
#define CLOUDMILL_PATH_PARSE_H

#include "apt.h"
#include "io/path/path.h"
#include "path_spline.h"

struct cl_dialect;

/* Axes and origin of a coordinate system, mm. */
struct frame {
    struct vec3 origin, x, y, z;
};

/* A CIRCLE, until the GOTO at its end. */
struct arc_parse {
    bool open;
    struct path_arc arc;
    double sweep; /* of MOVARC, degrees; 0: not given */
    size_t turns; /* of a helix, the last one perhaps not whole; 0: not given */
    bool lasting; /* the arc has ended; points without a word (Creo) may still lie on it */
};

/* Where GOHOME and RETRCT lead. */
struct home_parse {
    bool known, cleared; /* FROM was given; the clearance plane was */
    struct pose from;
    struct vec3 normal; /* of that plane, its points p with normal * p = height, mm */
    double height;
};

/* NURBS, KNOT and CNTRL of NX. */
struct nurbs_parse {
    bool open;
    struct doubles knot;
    struct vec3s pole; /* without the first one, which is where the tool is */
};

/* NURBS_SIEMENS of CATIA: poles, and the knot interval of each of them. */
struct catia_parse {
    bool open, turns;
    int degree;
    double length; /* from the tip to the head */
    struct doubles interval;
    struct vec3s pole, head;
};

/* What the statements read so far leave to those that follow. */
struct path_parse {
    struct path *path;
    struct reader reader;
    struct apt apt;
    struct error *error;
    const struct path_listener *listener; /* NULL: none */
    const struct cl_dialect *dialect;     /* NULL: none recognized */
    bool sniffed;                         /* it will not change any more */
    bool own;                             /* the head of this suite was read */

    double unit;                /* millimetres */
    bool unit_said, unit_asked; /* by UNITS, by the caller */
    unsigned unit_line;         /* of UNITS */
    bool feed_inch;             /* the last feed whose word says its unit is in inches ... */
    unsigned feed_line;         /* ... in this line; 0: none did */
    bool framed;                /* coordinates are in `frame` and are converted to `first` */
    size_t frames;              /* MSYS statements */
    struct frame frame, first;
    struct vec3 shift; /* TRANS less ORIGIN, mm */
    struct vec3 origin, trans;

    bool rapid;             /* RAPID: the next point is at rapid */
    bool moved;             /* `at` is known */
    struct pose at;         /* where the tool is */
    struct vec3 last_point; /* of the stream: after a hole the tool is above it */
    struct vec3 axis;       /* of points that give none */
    bool listing;           /* the statement before was a GOTO: bare numbers are points too */
    bool touches;           /* CONTCT was given for the next point */
    struct contact contact;
    struct arc_parse circle;
    struct home_parse home;
    struct vec3 tangent; /* INDIRV, where the next arc starts; zero: not given */
    struct spline_parse spline;
    struct nurbs_parse nurbs;
    struct catia_parse catia;

    double spindle;     /* rev/min, 0: not given */
    bool ccw;           /* it turns counterclockwise */
    double inverse;     /* feed as 1/min, 0: none */
    double feed;        /* mm/min, the last one that was added; 0: none */
    double by_turn;     /* the same as mm per revolution, 0: it is none */
    bool cycling;       /* points are holes of the last cycle */
    bool to_start;      /* the tool leaves them at the height of `before` */
    bool drilled;       /* the last cycle has a hole */
    struct pose before; /* where the tool was at CYCLE */
    double leave;       /* height above the mouth at which they are left otherwise, mm */

    struct path_tool tool, next_tool; /* the one in the spindle; what is known of the next */
    char tool_name[40];               /* of NX, "": none */
    bool tool_used;                   /* it has moved */
    bool guessed;                     /* its number is not known yet */

    int depth;  /* MAKINO-FF: sections begun and not ended */
    bool whole; /* what was read so far is complete without FINI */
    int matrix; /* CATIA: lines of a matrix that may still come */
    bool ended;
};

/* What to do with a statement: 0, or -1 with the error filled. */
struct path_row {
    const char *word;
    int (*read)(struct path_parse *p);
};

/* ---- path_read.c */

/* Counts an unknown word, for one warning each. */
void path_count_unknown(struct path_parse *p, const char *word);

/* Arguments from, from + 1, ... as n numbers. */
int path_numbers(struct path_parse *p, size_t from, size_t n, double *value, const char *what);

/* Three numbers in the stream's unit and coordinate system, in mm: a point; a difference of two. */
struct vec3 path_point_of(const struct path_parse *p, const double *v);
struct vec3 path_vector_of(const struct path_parse *p, const double *v);

/* A direction: as it is where its length is 1 but for its printed digits, else normalized. */
int path_direction(struct path_parse *p, const double *v, const char *what, struct vec3 *unit);

/* ---- path_head.c */

/* The row of a word in a table; among those of the head; of a comment that carries data; NULL: it
 * has none. */
const struct path_row *path_row_of_word(const struct path_row *rows, size_t n, const char *word);
const struct path_row *path_head_row(const char *word);
const struct path_row *path_comment_row(const char *word);

/* Rows: adds the statement to the path as text; ignores it. */
int path_keep_text(struct path_parse *p);
int path_ignore(struct path_parse *p);

/* ---- path_unit.c */

/* Before the first statement: inches, where nothing says the unit and feeds are in them; -1: some
 * are in mm, too. */
int path_guess_unit(struct path_parse *p);

/* ---- path_motion.c */

/* Rows; path_read_goto also reads numbers alone, after a GOTO. */
int path_read_goto(struct path_parse *p);
int path_read_godlta(struct path_parse *p);
int path_read_tlaxis(struct path_parse *p);
int path_read_from(struct path_parse *p);
int path_read_contact(struct path_parse *p);

/*
 * Reads lines of the input as long as they are plain: `GOTO/x,y,z,i,j,k` and contacts between them.
 * Most of a path is, and this takes a tenth of the time.  The first other line is left to apt_read.
 */
int path_read_plain_gotos(struct path_parse *p);

/* -1: a coordinate that no machine reaches. */
int path_expect_reach(struct path_parse *p, struct vec3 v);

/* Gives a motion its line and the contact that was given for it. */
void path_attach_contact(struct path_parse *p, struct path_item *item);

/* The motion to a pose: on the arc of the last CIRCLE if it is open, a hole under CYCLE. */
int path_move_to(struct path_parse *p, struct pose to);

/*
 * Row of CIRCLE/centre, axis[, radius]; the default radius is the distance of the tool.  With
 * eleven numbers (NX, MAKINO-FF) the arc is clockwise about its axis, and TIMES,n means that a
 * helix ends in its n-th turn.
 */
int path_read_circle(struct path_parse *p);

/* Row of MOVARC/centre, axis, radius[, ANGLE, degrees]: the same, and the arc must turn so far. */
int path_read_movarc(struct path_parse *p);

/* Opens an arc, for the next motion to end. */
int path_begin_arc(struct path_parse *p, struct path_arc arc);

/*
 * Creo lists points of an arc after its CIRCLE, without a word from the second on (PTC, CL Output
 * for Circular Interpolation): true if this one continues the arc that has just ended, which is
 * then open again.
 */
bool path_arc_continues(struct path_parse *p, struct vec3 point);

/* Row of GOHOME[/x,y,z[,i,j,k]]: at rapid to there, else to the point of FROM; counted as unknown
 * when there is none. */
int path_read_gohome(struct path_parse *p);

/* Row of RETRCT: at rapid along the tool axis to the clearance plane if that is ahead; counted as
 * unknown where there is no such plane. */
int path_read_retrct(struct path_parse *p);

/* Row of CLEARP/XYPLAN,z and CLRSRF/a,b,c,d (a x + b y + c z = d) and of either with z alone. */
int path_read_clearp(struct path_parse *p);

/* Row of ROTABL, ROTATE, ROTHED: ignored when the angle is 0, else an error. */
int path_read_rotabl(struct path_parse *p);

/* ---- path_refuse.c */

/* -1: a statement without a row that may move the tool: ignoring it would lose the motion. */
int path_refuse_motion(struct path_parse *p);

/* ---- path_cycle.c */

/* Row of CYCLE: a kind and its numbers, then a GOTO for each hole, then CYCLE/OFF. */
int path_read_cycle(struct path_parse *p);

/* Adds the hole at this pose; the tool is above it then. */
int path_add_cycle_hole(struct path_parse *p, struct pose mouth);

/* The statement of a cycle, in `text` of CYCLE_TEXT bytes. */
enum { CYCLE_TEXT = 8 * 360 + 80 };
void path_cycle_text(const struct path_cycle *cycle, char *text);

/* ---- path_passes.c */

/* Row of PASSES, in as many lines as it takes; and how path_write writes them. */
int path_read_passes(struct path_parse *p);
void path_write_passes(struct out *out, const struct path_passes *passes);

/* At the end of the input: passes that are others than PASSES says, and those of a fitter without
 * its head, are what the stage `path` could not keep. */
void path_check_passes(struct path_parse *p);

/* ---- path_tool.c */

/*
 * Rows: CUTTER; LOADTL, TOOLNO, TLCHG; LOAD/TOOL.  The first tool is in the path's head; each later
 * one is an item where it is changed.  A CUTTER before the tool has moved describes this tool, one
 * after that the next one.
 */
int path_read_cutter(struct path_parse *p);
int path_read_tool(struct path_parse *p);
int path_read_load(struct path_parse *p);

/* The shape of the tool in the spindle, or of the next one when that has moved. */
void path_tool_shape(struct path_parse *p, const double *cutter, int n);

/* A tool by its name, of a system that gives no numbers. */
void path_tool_named(struct path_parse *p, const char *name);

/* Before a motion: a new shape without a number is a change of tools too. */
void path_tool_move(struct path_parse *p);

/* Rows of SPINDL, of FEDRAT in all its units, of DELAY. */
int path_read_spindle(struct path_parse *p);
int path_read_feed(struct path_parse *p);
int path_read_delay(struct path_parse *p);

/*
 * The factor that turns a feed in the unit of this word (MMPM, IPM, PERMIN, MMPR, IPR, PERREV) into
 * mm/min; 0: the word is no unit; NAN: per revolution, and the spindle's speed is not known.
 */
double path_feed_unit(const struct path_parse *p, const char *word);

/* This word, of a feed in this line, and UNITS, which may stand before or after it, say one unit,
 * or the caller says it; -1: UNITS/MM or CM with a feed in inches.  Others of mm are kept in
 * path.feeds_mm. */
int path_feed_agrees(struct path_parse *p, const char *word);
int path_unit_agrees(struct path_parse *p);

/* -1: the feed in force is per revolution, and no speed was given. */
int path_expect_speed(struct path_parse *p);

/* Adds the feed at which this motion takes 1 / inverse minutes, under FEDRAT/INVERS. */
void path_feed_inverse(struct path_parse *p, double length);

#endif
