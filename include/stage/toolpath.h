/*
 * toolpath - strips of contact points made a path: tool centres lifted clear of the part, tips and
 * axes, passes, links, approach and retract.  The main header of stage: what a tool does between
 * reading and writing, with its messages.
 *
 *   cloud2mesh            cloud_prepare.h, cloudmesh.h, normals.h
 *   nurbs2mesh            nurbs_report.h
 *   meshnorm, planecut    path_options.h, mesh_for_path.h, plane_passes.h, this
 *   all of these          path_check.h: the path as printed, checked once more
 *   biarcfit, bsplfit     fitter.h, gouge_options.h; arcrun.h, path_tilt.h; path_track.h,
 *                         spline_report.h
 *   ncverify              holder_text.h
 *
 * From strip to strip the tool stays down where the link is short and clear; else it goes up to the
 * clearance plane, over with the new axis and down along that (gouge/link.h).
 */
#ifndef CLOUDMILL_TOOLPATH_H
#define CLOUDMILL_TOOLPATH_H

#include "gouge/gouge_lift.h"
#include "gouge/link_retract.h"
#include "io/path/path.h"
#include "machine/kinematics.h"
#include "stage/path_check.h"

struct toolpath_options {
    double radius;       /* of the ball, mm */
    double feed, plunge; /* mm/min: cutting, and going down the last bit */
    double clearance;    /* z of the tip on the clearance plane, mm */
    double approach;     /* the last bit, mm */
    double floor;        /* least z of the ball's centre, mm; -HUGE_VAL: any */
    double longest;      /* three rows: so near are neighbours, mm */
    double scallop;      /* between rows, mm; 0: nothing is promised of it */
    double smooth;       /* centres may be lifted by so much more, mm, so that they run smoothly; 0:
                            by nothing, also not by `raise` */
    double raise;        /* and by so much where scallops are no higher than that then, mm */
    double full;         /* but by nothing where they are higher by so much as it is, mm */
    bool one_way;        /* no strip is turned round */
    bool avoid;          /* what the ball can't reach may stay uncut ... */
    bool skip;           /* ... and what the holder keeps the tool from is skipped */
    double play;         /* how far axes may be off their rule to turn less, radians */
    double rate;         /* fastest turn of the axis along a strip, radians/mm; 0: any */
    double turn; /* LEAN: axes may lean up to this, radians, to whatever side, so that rotary
                    axes turn least; 0: as the rule of the axis says */
    struct holder holder; /* flute, shank and holder */
    double lean;          /* how far axes may be off their rule for these to be clear, radians */
    double spacing;       /* of the passes, mm */
    struct kinematic_chain chain; /* of the machine whose rotary axes are to move least */
};

/* A strip from when it is given until it is in the path. */
struct toolpath_strip {
    size_t pass;
    bool rest; /* only where it touches */
    struct gouge_lift_options lift;
    struct contacts contact;
    struct lifted_strip lifted;
    double chord;           /* between the smooth curve and the straight lines, mm */
    double leaned;          /* how far an axis is off its rule at most, radians */
    size_t skipped;         /* points left out because no axis reaches them */
    double skipped_length;  /* of the way past them, mm */
    struct vec3 skipped_at; /* the first of them */
};

/* A way between a part and the clearance plane, at a point of the part. */
struct toolpath_way {
    size_t at; /* the point; n: there is none */
    struct retract retract;
};

/* A part of a lifted strip, cut from end to end with the tool down. */
struct toolpath_part {
    size_t strip, from, to; /* points [from, to) of its lifted run */
    bool dropped;           /* a sliver */
    bool low;               /* it is come to from the part before with the tool down, ... */
    struct run link;        /* ... over these points */
    struct toolpath_way in, out;
};

/* A place where material may stay uncut, as far as its strip can tell. */
struct toolpath_uncut {
    struct uncut place;
    size_t pass;
    double offset; /* of the centre from the part there, mm */
};

struct coverage;

struct toolpath {
    struct path *path;
    struct toolpath_options rule;
    const struct coverage *coverage; /* what is to be cut, where that is known; NULL */
    struct gouge_lift_options lift;  /* of the strips, and what links must be clear of */

    /* What came of it, over all strips. */
    struct gouge_lift_report report;
    size_t unreachable_pass; /* of report.unreachable_at, 0: none */
    size_t uncut_places;     /* where the ball does not fit and, on the whole path, does not come as
                                near as it should */
    double uncut_height;     /* what stays there at most, mm */
    struct vec3 uncut_at;
    size_t uncut_pass;
    double chord;        /* between the smooth curve and the straight lines, mm */
    double leaned;       /* how far an axis is off its rule at most, radians */
    size_t skipped;      /* points left out because no axis reaches them */
    double skipped_area; /* about so much of the part, mm^2 */
    size_t skipped_pass; /* of the first of them */
    struct vec3 skipped_at;
    size_t low, high;    /* links with the tool down, links over the clearance plane */
    size_t shank;        /* points where the tool touches with more than its ball */
    size_t slivers;      /* parts left out because their neighbours cut all of them */
    size_t blocked;      /* parts left out because no way to them or from them is clear */
    double blocked_area; /* of their rows, mm^2 */
    size_t blocked_pass; /* the first of them */
    struct vec3 blocked_at;
    double plane; /* z of the tip on the clearance plane, for all axes of the path, mm */

    struct path_check check; /* of the path as it is written */

    struct axis_planner *planner; /* NULL: axes stay as their rule says */
    struct rotary_frame frame;    /* of the machine, where there is a planner */
    int threads;                  /* as of parallel_for */

    /* The path, whose head is known, is written as it is made, and not kept: to this file, NULL:
     * standard output.  What is open of it at the end. */
    bool streams;
    const char *output;
    struct out *out;

    /* The state, for toolpath.c alone. */
    struct {
        size_t n, cap;
        struct toolpath_strip *item;
    } strip;
    struct {
        size_t n, cap;
        struct toolpath_uncut *item;
    } uncut;
    bool rest;              /* strips given now are rest passes: ways over what they can't touch
                               are left out */
    size_t lifted;          /* of these strips */
    struct vec3s swept;     /* the ball's centre on them, before they are put into the path, ... */
    struct sizes swept_end; /* ... and where their parts end */
    struct vec3s ball;      /* its centre on what is cut, ... */
    struct sizes ball_end;  /* ... and where a link or rapid is between */
    struct run_point at;
    struct toolpath_part last; /* that it is at the end of */
    double height;             /* z of the tip over the clearance plane */
    size_t pass;
    bool down;
    double feed_now;
};

/*
 * One strip: n contact points in the order they are cut, in a pass of this number (rising from 1),
 * `along` the horizontal direction of the feed.  It waits for toolpath_end, with t->lift as it is
 * now.
 */
void toolpath_strip(struct toolpath *t, size_t pass, const struct contact *contact, size_t n,
                    struct vec3 along);

/* A path of this length, mm, can be made in reasonable time: half a million radii of the ball, 2 km
 * for one of 4 mm.  -1: it is longer, the error says so, and the length in the words of `said`. */
int toolpath_length_bounded(double length, double radius, const char *said, struct error *error);

/* The same of the strips of one layer, in all layers. */
int toolpath_bounded(const struct toolpath *t, int layers, struct error *error);

/* Lifts the strips that wait; more of them may follow.  Where they take the ball's centre is in
 * t->swept. */
void toolpath_cut(struct toolpath *t);

/* The same, and puts all of them into the path, with what leads from one to the next and, at the
 * end, up from the last.  Where the ball's centre has cut is in t->ball. */
void toolpath_end(struct toolpath *t);

void toolpath_free(struct toolpath *t);

/* The summary with note(), and with say() what does not hold; the tool's exit status, EXIT_DONE or
 * EXIT_UNMET. */
int toolpath_conclude(const struct toolpath *t);

#endif
