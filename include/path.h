/*
 * path - the path stream (cloudmill-path(5)): APT CL text in, APT CL text out.
 *
 * In memory a path is a head and a list of items in the order of the stream.  Lengths are mm,
 * feeds mm/min, whatever units the stream was in.
 */
#ifndef CLOUDMILL_PATH_H
#define CLOUDMILL_PATH_H

#include <stdbool.h>

#include "array.h"
#include "bspline.h"
#include "error.h"
#include "motion.h"
#include "out.h"
#include "vec.h"

enum path_kind {
    PATH_POINT,  /* straight to a pose (GOTO) */
    PATH_ARC,    /* on an arc to a pose (CIRCLE, GOTO) */
    PATH_SPLINE, /* on a B-spline to a pose (MOVNRB/ON ... MOVNRB/OFF) */
    PATH_PASS,   /* a pass begins ($$-> PASS/number) */
    PATH_FEED,   /* from here on this feed (FEDRAT) */
    PATH_TEXT    /* a statement that is carried along as it is */
};

struct path_item {
    enum path_kind kind;
    bool rapid;             /* POINT: at the machine's rapid */
    bool touches;           /* POINT, ARC, SPLINE: `contact` was given for where it ends */
    unsigned line;          /* of the input, 0: made here */
    size_t index;           /* ARC, SPLINE, TEXT: element of path.arc, .spline, .text; PASS: number */
    double feed;            /* FEED: mm/min */
    struct pose to;         /* POINT, ARC, SPLINE */
    struct contact contact; /* at `to` */
};

/* An arc about `axis` by the right-hand rule, from the pose before; start = end: a full circle.
 * The tool axis turns on the great circle, in proportion to the angle. */
struct path_arc {
    struct vec3 centre, axis;
    double radius;
};

struct path_spline {
    struct bspline curve;
    struct poses fallback; /* the same motion in straight pieces, without its start */
};

/* What a stage spent of the tolerance, mm ($$-> LEDGER/stage,spent). */
struct ledger_entry {
    char *stage;
    double spent;
};

enum path_track { TRACK_TIP, TRACK_CENTRE, TRACK_CONTACT };

struct path_head {
    char *partno;      /* text behind PARTNO/, NULL: none */
    bool multax;       /* MULTAX/ON */
    double cutter[7];  /* CUTTER/ d, r, e, f, alpha, beta, h (mm, degrees) */
    int cutter_n;      /* how many of them were given, 0: no CUTTER */
    int tool;          /* LOADTL/, 0: none */
    double spindle;    /* rev/min, 0: none */
    bool spindle_ccw;  /* CCLW */
    int coolant;       /* 0 not said, 1 off, 2 on (flood), 3 mist */
    enum path_track track;
    double chord;      /* $$-> CHORD/: how far the smooth path stands off the straight lines
                          between its points, mm; a fitter takes it out; NAN: not said */
    double clearance;  /* $$-> CLEAR/: z of the clearance plane, mm; NAN: not said */
    struct { size_t n, cap; struct ledger_entry *item; } ledger;
};

struct path {
    const char *name; /* of the file, for messages */
    struct path_head head;
    struct { size_t n, cap; struct path_item *item; } item;
    struct { size_t n, cap; struct path_arc *item; } arc;
    struct { size_t n, cap; struct path_spline *item; } spline;
    struct { size_t n, cap; char **item; } text;
    struct { size_t n, cap; struct path_unknown { char *word; size_t times; unsigned line; } *item; }
        unknown; /* post-processor words that nobody here knows, for one warning each */
};

/*
 * Reads a whole path (NULL or "-": standard input) up to FINI.  Without FINI, with an unknown
 * geometry word, a number that is not finite, an axis of no length, an arc whose ends are off its
 * circle by more than 0.01 mm: -1.
 */
int path_read(const char *file, struct path *path, struct error *error);

/* Writes the stream with its head and FINI.  Coordinates with 6 decimals, vectors with 9. */
void path_write(struct out *out, const struct path *path);

void path_free(struct path *path);

/* Takes over the head of another path (copies its strings), for a stage that writes a new one. */
void path_head_copy(struct path_head *to, const struct path_head *from);

/* Adds what a stage spent to the ledger. */
void path_spend(struct path *path, const char *stage, double spent);

/* Sum of the ledger, mm. */
double path_spent(const struct path *path);

/* Radius of the ball, mm: CUTTER's d/2 when its corner radius says ball nose; else -1. */
double path_ball(const struct path *path);

/* Each appends one item. */
struct path_item *path_add_point(struct path *path, struct pose to, bool rapid);
struct path_item *path_add_arc(struct path *path, struct pose to, struct path_arc arc);
struct path_item *path_add_spline(struct path *path, struct pose to, struct path_spline spline);
void path_add_pass(struct path *path, size_t number);
void path_add_feed(struct path *path, double feed);
void path_add_text(struct path *path, const char *text);

/* Appends items [from, to) of another path, unchanged (deep copies of what they point at). */
void path_add_items(struct path *path, const struct path *other, size_t from, size_t to);

/*
 * The cutting runs of a path, for fitters: the first run at or after item *from as [*from, *to).
 * A run is a longest row of PATH_POINT items at feed, with nothing else between, that all carry a
 * contact (in a path without any contact: of all points at feed).  The pose where a run starts is
 * that of its first item: the motion *to* it is no part of the run.  False when there is none
 * left.  Runs of one item are passed over.
 */
bool path_next_run(const struct path *path, size_t *from, size_t *to);

#endif
