/*
 * path - the path stream (cloudmill-path(5)): APT CL text in, APT CL text out.  The door of this
 * folder.
 *
 * In memory a path is a head and a list of items in the order of the stream.  Lengths are mm and
 * feeds mm/min, for any units of the stream.  path_read reads streams of this suite and CL files of
 * CAM systems (the stages: path_parse.h), path_write writes them; path_run.h makes a run of a path
 * a run for the fitters.
 */
#ifndef CLOUDMILL_PATH_H
#define CLOUDMILL_PATH_H

#include <stdbool.h>

#include "base/array.h"
#include "curve/bspline.h"
#include "base/error.h"
#include "curve/motion.h"
#include "base/out.h"
#include "base/unmet.h"
#include "gouge/holder.h"
#include "math/region.h"
#include "mesh/scan_source.h"

enum path_kind {
    PATH_POINT,  /* straight to a pose (GOTO) */
    PATH_ARC,    /* on an arc to a pose (CIRCLE, GOTO) */
    PATH_SPLINE, /* on a B-spline to a pose (MOVNRB/ON ... MOVNRB/OFF) */
    PATH_HOLE,   /* a hole of a drilling cycle at a pose (GOTO after CYCLE) */
    PATH_TOOL,   /* a change of tools (LOADTL) */
    PATH_PASS,   /* a pass begins ($$-> PASS/number) */
    PATH_FEED,   /* the feed from here on (FEDRAT) */
    PATH_TEXT,   /* a statement that is kept as text */
    PATH_PLANE   /* a new tilted plane: ncpost's own (post_frame.h), in no stream */
};

/* 64 bytes, since there may be millions. */
struct path_item {
    enum path_kind kind : 8;
    bool rapid : 1;   /* POINT: at rapid */
    bool touches : 1; /* POINT, ARC, SPLINE: the contact where it ends is known */
    unsigned line;    /* of the input, 0: not read */
    unsigned index;   /* ARC, SPLINE, HOLE, TOOL, TEXT: element of path.arc, .spline, .cycle, .tool,
                         .text; PASS: number */
    unsigned contact; /* when it touches: element of path.contact */
    union {
        struct pose to; /* POINT, ARC, SPLINE; HOLE: its mouth and the axis out of it */
        double feed;    /* FEED: mm/min */
    };
};

/* An arc about `axis` by the right-hand rule, from the pose before; start = end: a full circle.
 * An end at another height along `axis` makes it a helix of less than a turn.  The tool axis turns
 * on the great circle, in proportion to the angle. */
struct path_arc {
    struct vec3 centre, axis;
    double radius;
};

struct path_spline {
    struct bspline curve;
    struct poses fallback; /* the same motion in straight pieces, without its start */
};

enum path_cycle_kind {
    CYCLE_DRILL, /* down at feed, out at rapid */
    CYCLE_DEEP,  /* in steps, with a retract out of the hole after each */
    CYCLE_BREAK, /* in steps, with a short retract after each, to break the chip */
    CYCLE_TAP,   /* down at feed, the spindle reverses, out at feed */
    CYCLE_BORE,  /* down and out at feed: boring, reaming */
    CYCLE_DRAG,  /* down at feed, the spindle stops, out at rapid: boring */
    CYCLE_MANUAL /* down at feed, spindle and program stop, out at rapid: boring; written out */
};

/* A drilling cycle.  Heights are relative to the mouth of the hole, along the tool axis, mm. */
struct path_cycle {
    enum path_cycle_kind kind;
    double depth;      /* of the bottom below the mouth, above 0 */
    double clear;      /* the feed begins at this height above it */
    double retract;    /* and the tool retracts to this height, no less than clear */
    double step, next; /* DEEP, BREAK: the first step and each that follows; 0: all at once */
    double dwell;      /* at the bottom, seconds */
    double feed;       /* mm/min, 0: the one in force */
    double pitch;      /* TAP: mm per revolution, 0: not given */
};

enum { PATH_TOOL_NAME = 40 };

struct path_tool {
    int number;                /* 0: none was given */
    int offset;                /* number of its length's offset (OSETNO), 0: that of the tool */
    char name[PATH_TOOL_NAME]; /* "": none was given */
    double cutter[7];          /* as in path_head */
    int cutter_n;
};

/* The part of the tolerance that a stage spent, mm ($$-> LEDGER/stage,spent). */
struct ledger_entry {
    char *stage;
    double spent;
    bool by_pass; /* the largest of those that stand where a pass ends */
};

/* What a stage spent in one pass, written where it ends, before this item of the path. */
struct path_spent {
    size_t before;
    struct ledger_entry entry;
};

/* The largest number of a pass. */
enum { PATH_PASS_MOST = 1000000000 };

/* Numbers of passes in their order: each entry goes by ones from `from` up or down to `to`. */
struct path_passes {
    size_t n, cap;
    struct path_pass_range {
        unsigned from, to;
    } * item;
};

enum path_track { TRACK_TIP, TRACK_CENTRE, TRACK_CONTACT };

enum path_coolant {
    COOLANT_NOT_GIVEN,
    COOLANT_OFF,
    COOLANT_ON, /* flood */
    COOLANT_MIST,
    COOLANT_THRU, /* through the tool */
    COOLANT_AIR
};

struct path_head {
    char *partno;     /* text after PARTNO/, NULL: none */
    bool multax;      /* MULTAX/ON */
    double cutter[7]; /* CUTTER/ d, r, e, f, alpha, beta, h (mm, degrees) */
    int cutter_n;     /* how many of them were given, 0: no CUTTER */
    int tool;         /* LOADTL/, 0: none */
    int offset;       /* as in path_tool */
    char tool_name[PATH_TOOL_NAME];
    double spindle;        /* rev/min, 0: none */
    bool spindle_ccw;      /* CCLW */
    int coolant;           /* enum path_coolant */
    bool body_given;       /* $$-> TOOL/ ... */
    struct tool_body body; /* ... what the tool is above its ball */
    enum path_track track;
    double chord;     /* $$-> CHORD/: distance of the smooth path from the straight lines
                         between its points, mm; a fitter removes it; NAN: not given */
    double clearance; /* $$-> CLEAR/: z of the clearance plane, mm; NAN: not given */
    double scallop;   /* $$-> SCALLOP/: what passes leave between them at most, mm; 0: not said */
    bool noise_given; /* $$-> NOISE/: ... */
    double noise;     /* ... what the scan was said to have, one standard deviation, mm */
    struct path_runs {
        size_t points; /* $$-> RUNS/: how many its cutting runs have, 0: not said ... */
        double feed;   /* ... and the largest feed, mm/min: a fitter can begin before the end */
    } runs;
    struct path_passes passes; /* $$-> PASSES/: all that the path has, in their order; none: it is
                                  not said */
    struct {
        size_t n, cap;
        struct ledger_entry *item;
    } ledger;
    struct region region;     /* $$-> REGION/: that is cut; none: all, or it is not said which */
    bool regions;             /* a second one was said of it: none is known then */
    struct scan_sources scan; /* $$-> SCAN/, PLACE/: that it is guarded by */
    struct scan_sources mesh; /* $$-> MESH/: that it was made on and is kept clear of, where no
                                 scan is known */
    struct unmets unmet;      /* $$-> UNMET/: what the stages so far could not keep */
    struct unmets unfitted;   /* $$-> UNFITTED/: what a fitter's tolerance makes up for, and ncpost
                                 takes for unmet: no fitter passes it on */
};

struct path {
    const char *name;      /* of the file, for messages */
    const char *system;    /* that wrote it, as its words show, "NX"; NULL: this suite or unknown */
    struct path_head head; /* with its first tool */
    struct {
        size_t n, cap;
        struct path_item *item;
    } item;
    struct contacts contact;
    struct {
        size_t n, cap;
        struct path_arc *item;
    } arc;
    struct {
        size_t n, cap;
        struct path_spline *item;
    } spline;
    struct {
        size_t n, cap;
        struct path_cycle *item;
    } cycle;
    struct {
        size_t n, cap;
        struct path_tool *item;
    } tool;
    struct {
        size_t n, cap;
        struct path_spent *item;
    } spent;               /* in the order of `before`; what a stage that writes by passes adds */
    bool inches_taken;     /* the stream does not say its unit, but feeds in inches */
    unsigned feeds_mm;     /* line of the first feed in mm under UNITS/INCHES; 0: there is none */
    size_t tools_numbered; /* tools without a number that got one, in their order */
    struct {
        size_t n, cap;
        char **item;
    } text;
    struct {
        size_t n, cap;
        struct path_unknown {
            char *word;
            size_t times;
            unsigned line;
        } * item;
    } unknown; /* unknown post-processor words, for one warning each */
};

/*
 * Reads a whole path (NULL or "-": standard input) up to FINI, from this suite or from a CAM system
 * (cl_dialect.h).  Without its end, with an unknown geometry word, a number that is not finite, an
 * axis of no length, an arc whose ends are off its circle by more than 0.01 mm: -1.
 */
int path_read(const char *file, struct path *path, struct error *error);

/* The same for lengths in this unit where the stream does not say it: -1 too where it says another.
 * PATH_UNIT_SAID: millimetres, or inches where feeds are in IPM or IPR (path.inches_taken), -1
 * where feeds are in both or in inches under UNITS/MM. */
enum path_unit { PATH_UNIT_SAID, PATH_UNIT_MM, PATH_UNIT_INCH };
int path_read_as(const char *file, enum path_unit unit, struct path *path, struct error *error);

/* Who wants to know of a path while it is read. */
struct path_listener {
    void (*pass)(void *context, const struct path *path); /* a pass begins after these items */
    void *context;
};

/* path_read; the listener may be NULL. */
int path_read_listened(const char *file, const struct path_listener *listener, struct path *path,
                       struct error *error);

/* Writes the stream with its head and FINI.  Coordinates with 6 decimals, vectors with 9. */
void path_write(struct out *out, const struct path *path);

/* The same in pieces: the head, items as often as there are more, what is unmet, and the end with
 * what the head knows of that. */
void path_write_head(struct out *out, const struct path_head *head);
void path_write_items(struct out *out, const struct path *path);
void path_write_unmet(struct out *out, const struct unmets *unmet);
void path_write_end(struct out *out, const struct path_head *head);

void path_free(struct path *path);

/* True if the item moves the tool. */
static inline bool path_moves(const struct path_item *item)
{
    return item->kind <= PATH_HOLE;
}

static inline bool path_is_rapid(const struct path_item *item)
{
    return item->kind == PATH_POINT && item->rapid;
}

/* Takes over the head of another path (copies its strings), for a stage that writes a new one; not
 * its list of passes. */
void path_head_copy(struct path_head *to, const struct path_head *from);

/* The coolant that a COOLNT statement's argument names: ON, FLOOD, TAPKUL, MIST, THRU, AIR, OFF, or
 * nothing (ON); COOLANT_NOT_GIVEN: another word. */
enum path_coolant path_coolant_of(const char *word);

/* Adds a stage and what it spent to the ledger. */
void path_spend(struct path *path, const char *stage, double spent);

/* The same for one pass: written before this item, the first after the pass. */
void path_spend_pass(struct path *path, const char *stage, double spent, size_t before);

/* Sum of the ledger, mm. */
double path_spent(const struct path *path);

/* Radius of the ball, mm: CUTTER's d/2 when its corner radius says ball nose; else -1. */
double path_ball(const struct path *path);
double path_tool_ball(const struct path_tool *tool);

/* The stack above the ball that the path's maker kept clear (TOOL), or the usual one of its ball;
 * empty for BALL-ONLY and without a ball. */
struct holder path_holder(const struct path *path);

/* Each appends one item. */
struct path_item *path_add_point(struct path *path, struct pose to, bool rapid);
struct path_item *path_add_arc(struct path *path, struct pose to, struct path_arc arc);
struct path_item *path_add_spline(struct path *path, struct pose to, struct path_spline spline);
void path_add_hole(struct path *path, struct pose mouth, size_t cycle);
void path_add_tool(struct path *path, struct path_tool tool);
void path_add_pass(struct path *path, size_t number);
void path_add_feed(struct path *path, double feed);
void path_add_text(struct path *path, const char *text);

/* How many of the statements that are kept as text begin with this word. */
size_t path_statements(const struct path *path, const char *word);

/* Sets the contact at the end of an item. */
void path_set_contact(struct path *path, struct path_item *item, struct contact contact);

/* The passes of a path; the caller frees it.  A stage whose parts are joined has them in its head,
 * and path_read holds what it finds against them: what differs is in head.unmet, as of `path`. */
struct path_passes path_passes_of(const struct path *path);

/* Appends items [from, to) of another path, unchanged (deep copies of what they point at). */
void path_add_items(struct path *path, const struct path *other, size_t from, size_t to);

/* The motion that an item of the path is, from the pose before it. */
struct motion path_item_motion(const struct path *path, const struct path_item *item,
                               struct pose from);

/*
 * Replaces the holes of drilling cycles by straight motions: at rapid above the mouth, down to
 * `clear`, at feed to the bottom (in steps), out to `retract`.  A step begins at rapid
 * PATH_PECK_GAP above the bottom of the one before, or half of it.
 */
void path_expand_cycles(struct path *path);

#define PATH_PECK_GAP 0.254 /* mm, LinuxCNC's */

/*
 * The cutting runs of a path, for fitters: the first run at or after item *from as [*from, *to).
 * A run is a longest sequence of PATH_POINT items at feed, with nothing else between, that all
 * carry a contact (in a path without any contact: of all points at feed).  A run starts at the pose
 * of its first item: the motion *to* it is not part of the run.  Runs of one item are skipped.
 * False if there is none left.
 */
bool path_next_run(const struct path *path, size_t *from, size_t *to);

#endif
