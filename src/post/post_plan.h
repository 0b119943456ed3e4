/*
 * post_plan - a path turned into the blocks that a control and a machine can be given: what each
 * block says, as numbers already rounded, and how far it is off the path.
 *
 * Whatever a control cannot do exactly goes down the ladder: B-spline, arc, straight blocks within
 * the tolerance.  All of it is done and checked before the first byte of a program is written.
 */
#ifndef CLOUDMILL_POST_PLAN_H
#define CLOUDMILL_POST_PLAN_H

#include "io/path/path.h"
#include "machine/machine.h"
#include "post_arc.h"
#include "post_spline.h"

/* What F means. */
enum nc_feeds {
    NC_FEEDS_TIP,     /* mm/min of the tracked point: G94 */
    NC_FEEDS_INVERSE, /* 1/min, in each block: G93 */
    NC_FEEDS_COMBINED /* along all axes together, in mm and degrees, a minute */
};

/* What the program may hold, from the control, the machine and the options. */
struct nc_ability {
    enum interpolation_mode mode;
    bool tcp; /* the program switches tool-centre-point control on */
    enum nc_feeds feeds;
    double feed_max;
    double unit;   /* mm, see struct nc_plan_options */
    bool doubtful; /* vectors, but the control may turn its rotary axes evenly: blocks keep to both
                    */
    enum nc_arcs arcs;
    enum nc_splines splines;
    struct machine_digits digits; /* all given */
    double radius_error;          /* of an arc's two ends, mm */
    double smoothing;             /* mm that the control may be off by its own smoothing, 0: none */
};

/* What the user asks for. */
struct nc_plan_options {
    double chord;          /* ncpost's own share of the tolerance, mm */
    double axis_tolerance; /* of the tool axis, radians */
    double feed;           /* mm/min where the path gives none */
    bool contact_feed;     /* the path's feeds are those of the contact point */
    double unit;           /* mm of one unit of all lengths: 1, or 25.4 when they are inches */
};

/* What made a block. */
enum nc_why {
    NC_WHY_PATH,     /* the path */
    NC_WHY_DIVIDED,  /* a motion in several blocks, for the tolerance */
    NC_WHY_CHORD,    /* a curve in straight pieces */
    NC_WHY_TURN,     /* retract, turn, return */
    NC_WHY_APPROACH, /* the path starts with a cut */
    NC_WHY_RETRACT,  /* the path ends in a cut */
    NC_WHY_PART      /* the program is a part of the whole, with its own approach and retract */
};

enum nc_kind {
    NC_RAPID,
    NC_LINE,
    NC_ARC,
    NC_SPLINE,
    NC_HOLE, /* a hole of a canned cycle, to where the tool leaves it */
    NC_PASS,
    NC_TEXT,
    NC_TOOL,
    NC_PLANE /* another tilted plane; index: of the path's planes (post_frame.h) */
};

/* Along the program's Z. */
struct nc_hole {
    struct vec3 mouth;
    const struct path_cycle *cycle; /* the path's */
    double feed;                    /* mm/min, or inches */
    double depth, clear, retract;   /* of the cycle, as printed */
};

/* 64 bytes, for there may be millions. */
struct nc_move {
    enum nc_kind kind : 8;
    enum nc_why why : 8;
    unsigned line;   /* of the path, 0: made here */
    unsigned index;  /* ARC, SPLINE, HOLE: element of the plan; TEXT, TOOL: of the path; PASS:
                        its number */
    unsigned vector; /* element of the plan, in INTERPOLATE_VECTOR */
    double feed;     /* as printed, see enum nc_feeds */
    struct vec3 p;   /* RAPID, LINE, ARC, SPLINE, HOLE: where it ends, see struct block_pose */
    double q[ROTARY_MAX];
};

struct nc_total {
    size_t rapids, lines, arcs, splines, holes, passes;
    size_t chorded;    /* arcs and B-splines of the path that became straight blocks */
    size_t turns;      /* retract, turn, return */
    double cut, rapid; /* length, mm */
    double minutes;
    size_t fast;                 /* blocks that ask an axis for more than its largest speed, ... */
    unsigned fast_line;          /* ... the first of them by its line of the path, ... */
    double fastest;              /* ... and how many times its speed at most */
    size_t peaks;                /* blocks that do so over less than 0.02 mm, at `slows`, ... */
    double peak;                 /* ... and how many times there */
    struct pose_deviation spent; /* the worst of all blocks at feed */
    bool feed_assumed, approach_made, retract_made;
};

struct nc_plan {
    struct nc_ability ability;
    struct {
        size_t n, cap;
        struct nc_move *item;
    } move;
    struct vec3s vector; /* tool axes as printed */
    struct {
        size_t n, cap;
        struct nc_arc *item;
    } arc;
    struct {
        size_t n, cap;
        struct nc_spline *item;
    } spline;
    struct {
        size_t n, cap;
        struct nc_hole *item;
    } hole;
    struct nc_total total;
    double top;      /* z above which the path never cuts, NAN: not known */
    bool no_vectors; /* rotary words instead: with vectors the control would find no way */
    bool unmet;      /* nc_plan_make failed because the machine cannot get there: exit status 3 */
};

/* Where a move ends, as it says it. */
struct block_pose nc_plan_pose(const struct nc_plan *plan, const struct kinematic_chain *chain,
                               const struct nc_move *move);

void nc_plan_free(struct nc_plan *plan);

/* The move takes the tool elsewhere. */
static inline bool nc_moves(const struct nc_move *move)
{
    return move->kind <= NC_HOLE;
}

#endif
