/*
 * arcrun - a cutting run of a path as arcs and lines, proven on the digits that are printed.
 */
#ifndef CLOUDMILL_ARCRUN_H
#define CLOUDMILL_ARCRUN_H

#include "io/path/path.h"
#include "curve/run.h"
#include "arcfit/arc_piece.h"
#include "gouge/gouge_refit.h"

struct arcrun_options {
    double tolerance; /* at the tip and at the centre, mm */
    double axis;      /* of the tool axis, radians */
    bool centre;      /* what is programmed is the ball's centre, not the tip */
    bool paper;       /* a biarc for each interval, however far it is off */
    bool guarded;     /* the run may be fitted several times: less is searched for a last arc */
    double work;      /* share of the usual work, or 0, all of it: a longer search for fewer arcs of
                         smooth data takes that share of its time; of little the arcs are as the
                         search finds them: half the time, a seventh more of them */
    double least;     /* mm: no piece shorter, as long as the tolerance allows it; 0: any length */
    bool chords;      /* arcs as comments, with straight chords for them */
};

/* What became of one or more runs. */
struct arcrun_report {
    size_t points; /* of the input */
    size_t arcs, lines;
    size_t c, s;     /* pairs of arcs with a common tangent that bend the same or the other way */
    size_t loops;    /* paper: intervals where its biarc is none */
    size_t corners;  /* kept as they are */
    size_t kinks;    /* other places where the direction jumps */
    double length;   /* mm */
    double shortest; /* of the pieces, mm, */
    size_t shorter;  /* and how many are shorter than the least length asked for */
    double bend;     /* largest jump of the curvature where the direction is continuous, 1/mm, */
    double turn;     /* and of the axis' turn by the length, radians/mm */
    double spent; /* of the tolerance, mm: the largest deviation, and what the dense points take */
    struct deviation worst;
};

/* The smooth parts of a run as they were fitted, for when some of its points have moved: a part
 * that comes again as it was is not fitted again, and of one where little has moved only the pieces
 * there.  Starts as all zero. */
struct arcrun_memo {
    size_t n, cap;
    struct arcrun_part {
        struct run points;
        struct pieces pieces;
        struct path fitted;
        struct arcrun_report report;
    } * item;
};

void arcrun_memo_free(struct arcrun_memo *memo);

/*
 * Appends the run to `out`, but for its first point, which has to be there already.  The tolerance
 * is kept, on the printed digits, by both the tip and the centre and on both sides, against the
 * smooth reference of the run (run_densify) where its points are sparse, against the straight lines
 * between them where they are dense (arcfit.h: ARC_DENSE); not with `paper`.  Contacts are carried
 * to the new ends.  `memo` (NULL: none) is of the fit before with the same options, and becomes
 * that of this one.
 */
void arcrun_fit(const struct run *run, const struct arcrun_options *options,
                struct arcrun_memo *memo, struct path *out, struct arcrun_report *report);

/* What a link lies between. */
struct arcrun_link {
    struct vec3 leave, arrive; /* directions of the cuts before and after it; zero: not known */
    struct vec3 out[2];        /* of the part, where it begins and ends; zero: not known */
    double left;               /* mm: what may be left on the part */
    const struct gouge_refit_options *gouge;
};

/*
 * Appends the run, a link that touches nothing, as few pieces that are clear of the guard with the
 * whole tool as they are printed, and need not follow it closer than that (arcfit/arc_link.h).
 * False: there are none, or the ball comes so near to the part amid the link that it takes off what
 * must not be left, and has to follow it as in a cut; `out` and the report are as they were.
 */
bool arcrun_fit_link(const struct run *run, const struct arcrun_link *link,
                     const struct arcrun_options *options, struct path *out,
                     struct arcrun_report *report);

/* Adds the second report to the first. */
void arcrun_add(struct arcrun_report *sum, const struct arcrun_report *report);

#endif
