/*
 * path_parse - reading a path stream, statement by statement: what the modules that read words
 * share.  path_read.c has the motions, path_parse.c the head and its comments, path_tool.c,
 * path_feed.c and path_cycle.c what their names say, cl_dialect.c the words of one CAM system.
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

/* An arc that was said, until the GOTO at its end. */
struct arc_parse {
    bool open;
    struct path_arc arc;
    size_t turns; /* of a helix, the last one perhaps not whole; 0: none said */
    bool lasting; /* behind its end: Creo's points without a word may lie on it still */
};

/* Where GOHOME and RETRCT lead. */
struct home_parse {
    bool known, cleared; /* FROM was said; the clearance plane was */
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

/* NURBS_SIEMENS of CATIA: poles, and the knot interval that each of them brings. */
struct catia_parse {
    bool open, turns;
    int degree;
    double length; /* from the tip to the head */
    struct doubles interval;
    struct vec3s pole, head;
};

/* What the statements read so far leave behind for those that come. */
struct path_parse {
    struct path *path;
    struct reader reader;
    struct apt apt;
    struct error *error;
    const struct cl_dialect *dialect; /* NULL: none showed */
    bool sniffed;                     /* it will not change any more */

    double unit;   /* millimetres */
    bool framed;   /* coordinates are in `frame`, to be told in `first` */
    size_t frames; /* MSYS statements */
    struct frame frame, first;
    struct vec3 shift; /* TRANS less ORIGIN, mm */
    struct vec3 origin, trans;

    bool rapid;       /* RAPID was said: the next point is one */
    bool moved;       /* `at` is known */
    struct pose at;   /* where the tool is */
    struct vec3 said; /* the last point that was said: behind a hole the tool is above it */
    struct vec3 axis; /* of points that give none */
    bool listing;     /* the statement before was a GOTO: bare numbers are points too */
    bool touches;     /* CONTCT was said for the next point */
    struct contact contact;
    struct arc_parse circle;
    struct home_parse home;
    struct vec3 tangent; /* INDIRV, where the next arc starts; zero: not said */
    struct spline_parse spline;
    struct nurbs_parse nurbs;
    struct catia_parse catia;

    double spindle; /* rev/min, 0: not said */
    bool ccw;       /* it turns so */
    double inverse; /* feed as 1/min, 0: none */
    double feed;    /* mm/min, the last one that was added; 0: none */
    bool cycling;   /* points are holes of the last cycle */
    bool homeward;  /* the tool leaves them as high as it was at CYCLE, in `before` */
    bool drilled;   /* the last cycle has a hole */
    struct pose before;
    double leave; /* as high as they are left otherwise, mm above the mouth */

    struct path_tool tool, next_tool; /* the one in the spindle; what is known of the next */
    char tool_name[40];               /* of NX, "": none */
    bool tool_used;                   /* it has moved */
    bool guessed;                     /* its number is not said yet */

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

/* The row for a word of the head, or of a `$$->` comment; NULL: none. */
const struct path_row *path_head_row(const char *word);
const struct path_row *path_comment_row(const char *word);

/* The row of a table for a word; NULL: none. */
const struct path_row *path_find_row(const struct path_row *rows, size_t n, const char *word);

/* Rows: carries the statement along as it is; drops it. */
int path_keep_text(struct path_parse *p);
int path_drop(struct path_parse *p);

/* Counts a word that nobody knows, for one warning each. */
void path_count_unknown(struct path_parse *p, const char *word);

/* Arguments from, from + 1, ... as n numbers. */
int path_numbers(struct path_parse *p, size_t from, size_t n, double *value, const char *what);

/* Three numbers in the stream's unit as mm: a place; a way. */
struct vec3 path_point_of(const struct path_parse *p, const double *v);
struct vec3 path_way_of(const struct path_parse *p, const double *v);

/* A direction: unit length when it is that but for its printed digits, made so when it is not. */
int path_direction(struct path_parse *p, const double *v, const char *what, struct vec3 *unit);

/* The motion to a pose, on the arc that was said if one was. */
int path_move_to(struct path_parse *p, struct pose to);

/* Takes an arc for the next motion. */
int path_begin_arc(struct path_parse *p, struct path_arc arc);

#endif
