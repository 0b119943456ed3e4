/*
 * arcrun - a cutting run of a path as arcs and lines, proven on the digits that are printed.
 */
#ifndef CLOUDMILL_ARCRUN_H
#define CLOUDMILL_ARCRUN_H

#include "stage/arcmemory.h"
#include "io/path/path.h"
#include "curve/run.h"
#include "arcfit/arc_piece.h"

/* The items [from, to) of a path, all of them points, as a run.  The path tracks the tip or the
 * centre; radius 0 when the tool is no ball. */
struct run arcrun_read(const struct path *path, size_t from, size_t to);

struct arcrun_options {
    double tolerance; /* at the tip and at the centre, mm */
    double axis;      /* of the tool axis, radians */
    bool centre;      /* what is programmed is the ball's centre, not the tip */
    bool paper;       /* a biarc for each interval, whatever it strays */
    bool chords;      /* arcs as comments, with straight chords for them */
};

/* What became of one or more runs. */
struct arcrun_report {
    size_t points; /* of the input */
    size_t arcs, lines;
    size_t c, s;    /* pairs of arcs with a common tangent that bend the same or the other way */
    size_t loops;   /* paper: intervals where its biarc is none */
    size_t corners; /* kept as they are */
    size_t kinks;   /* other places where the direction jumps */
    double length;  /* mm */
    double spent;   /* of the tolerance, mm: what is strayed and what the reference takes */
    struct deviation worst;
};

/*
 * Appends the run to `out`, but for its first point, which has to be there already.  The tolerance
 * is kept, on the printed digits, by both the tip and the centre and on both sides, against the
 * smooth reference of the run (run_densify) where its points are sparse, against the straight lines
 * between them where they are dense; not with `paper`.  Contacts are carried to the new ends.
 *
 * With a memory (NULL: none) the parts between corners whose points are as they were in the last
 * call become the pieces that they became then.
 */
void arcrun_fit(const struct run *run, const struct arcrun_options *options,
                struct arcmemory *memory, struct path *out, struct arcrun_report *report);

void arcrun_forget(struct arcmemory *memory);

/* Adds the second report to the first. */
void arcrun_add(struct arcrun_report *sum, const struct arcrun_report *report);

#endif
