/*
 * arcfit - a pass as the fewest arcs and lines that follow it within a tolerance.
 *
 * In: a reference (curve/reference.h), the points of a smooth part of a cutting run, and what the
 * arcs may be off it.  Out: a chain of pieces from the first point of the reference to the last,
 * each an arc or a line along which the tool axis turns on a great circle (arc_piece.h).  Each
 * starts where the one before ended, in its direction (G1: to within ARCFIT_KINK where a line is
 * next to an arc).  Only where nothing else stays within the tolerance the chain goes straight from
 * point to point, with a kink.
 *
 * The stages, each of which leaves a chain that keeps the tolerance:
 *
 *   1. arcfit_beam    a search from the first point on, arc by arc, with free tangents
 *                     (arc_beam.c over arc_window.h and arc_axis.h; where it finds no arc,
 *                     a greedy biarc: arcfit.c)
 *   2. arcfit_reduce  one arc fewer after the other, all joints moved together by least squares
 *                     (arcspline_reduce.c over arcspline.h)
 *   3. arcfit_lengthen   no piece shorter than a control likes, where the tolerance allows it
 *   4. arcfit_bridge    and none so short that a block would be over before the next is read
 *   5. arcfit_calm      and its axes turned at a speed that changes little
 *   6. arcfit_reverse_*  the first two from the last point back, where that takes fewer arcs
 *
 * Their driver is stage/arcrun.h, which makes the reference, prints the pieces and proves the
 * printed digits.  arcfit_each is paper 1's fit, a biarc for each interval.
 *
 * Sources: biarcs of paper 1, 3.4 (curve/biarc.h); an arc spline, given by its joints and the
 * tangent at its start; Levenberg and Marquardt's method with p-norms rising towards the largest
 * distance.
 *
 * Who spends what of the tolerance (biarcfit -e; E below):
 *
 *   constant           of      what for
 *   ARC_REFERENCE_MAX  E       dense points put between sparse ones, off the smooth path; this much
 *                              is taken from E before a fit begins; ...
 *   ARC_REFERENCE_HURRIED   E  ... where very many points leave little time for each
 *   ARC_DENSE          E       points whose straight lines are this near to the smooth path are the
 *                              reference themselves, and nothing is taken
 *   ARC_CHORD          E       --linear-arcs: chords off their arcs; taken from E, too
 *   ARC_PRINTED        1 mm    what rounding to the printed digits may add; left free
 *   ARC_RETRY          what is left   each time that the printed digits do not keep E after all
 *   ARC_ENOUGH         what is left   a chain of moved joints is near enough; ARC_ENOUGH_STEP less
 *                              each time that its proof fails
 *   ARC_JOINT_OFF      what is left   a joint of the search off the reference, across
 *   ARC_AXIS_OFF       what is left   an axis at a joint turned off the reference's so that the
 *                              other point follows better
 */
#ifndef CLOUDMILL_ARCFIT_H
#define CLOUDMILL_ARCFIT_H

#include "arcfit/arc_piece.h"

#define ARC_REFERENCE_MAX 0.02
#define ARC_REFERENCE_HURRIED 0.06
#define ARC_DENSE 0.25
#define ARC_CHORD 0.25
#define ARC_PRINTED 1e-6
#define ARC_RETRY 0.995
#define ARC_ENOUGH 0.995
#define ARC_ENOUGH_STEP 0.005
#define ARC_JOINT_OFF 0.85
#define ARC_AXIS_OFF 0.6

/* Radians: an axis that leans little off Z turns a rotary axis about Z by no more, for it comes to
 * the pole, or leaves it, at one turn. */
#define ARC_BEARING 0.02

#define ARCFIT_KINK RADIANS(0.01)

/* mm: pieces are no shorter where the tolerance leaves any room; 0.02 with digits to spare. */
#define ARC_SHORTEST 0.0205

/*
 * Greedy biarcs: from each joint the longest biarc within the tolerance, over 15 ratios of its legs
 * from 0.1 to 10; outer joints are points of the reference with its tangents.  A single arc or a
 * line where that reaches as far.  The length is found by doubling and bisection, each try checked
 * in full.
 */
void arcfit_biarcs(const struct reference *reference, const struct deviation *within,
                   struct pieces *pieces);

/* Where a chain has come to: near which point of the reference, in what direction, with what axis.
 */
struct chain_end {
    size_t at;
    struct vec3 p, tangent, axis;
};

/*
 * One step of the above from anywhere near a point of the reference, in any direction: appends one
 * or two pieces and returns the point of the reference at which they end.
 */
size_t arcfit_step(const struct reference *reference, const struct deviation *within,
                   const struct chain_end *from, struct pieces *pieces);

/*
 * Paper 1: a biarc for each interval of the reference, the one with the least a + b, whatever its
 * deviation.  Returns in how many intervals there is none because one of its legs is negative and
 * its arc a loop: those get equal legs (or a line where the points coincide).
 */
size_t arcfit_each(const struct reference *reference, struct pieces *pieces);

/* What a search may cost. */
enum arcfit_effort {
    ARCFIT_THOROUGH, /* as much as finds fewer arcs */
    ARCFIT_QUICK,    /* as long a search, but with fewer points looked at: a fifth less time */
    ARCFIT_HURRIED   /* with fewer chains, too: half the time, a fiftieth more arcs */
};

/*
 * The tangent-relaxed search: appends the fewest single arcs.  Each starts at the point and in the
 * direction where the last one ended, and ends beside a point of the reference, up to ARC_JOINT_OFF
 * across: freeing the tangents saves a third of the arcs of any biarc fit.  The axis at a joint may
 * be off the reference's too.  Of the chains with equally many arcs a beam is kept: those from
 * which the next arc can reach furthest.
 *
 * Each piece is proven by arc_piece_deviation, with joints rounded to `digits` decimals.  Where
 * single arcs do not do everywhere, there are never more pieces than arcfit_biarcs makes.
 */
void arcfit_beam(const struct reference *reference, const struct deviation *within, int digits,
                 enum arcfit_effort effort, struct pieces *pieces);

/*
 * Replaces parts of the chain `pieces`, which keep `within` of the reference, by fewer pieces that
 * keep it, proven by arc_piece_deviation with joints rounded to `digits` decimals.  All joints and
 * the tangent at the start (where the tool axis turns, its directions at the joints too) move at
 * once; one arc fewer is tried from joints spaced anew until none holds.  Kinks stay where they
 * are.  `feet` above 0: from many spacings of the joints also where the axis turns, until feet of
 * points on arcs have been looked for so often, by the points up to there.  That takes ten times as
 * long as what came before for a twentieth fewer arcs of smooth data, half of these by 100 a point,
 * and hardly any of a scan.
 */
void arcfit_reduce(const struct reference *reference, const struct deviation *within, int digits,
                   double feet, struct pieces *pieces);

/*
 * Moves the joints beside pieces shorter than `least` mm apart, with a piece fewer where that
 * holds, proven as by arcfit_reduce.  Those that `within`, a kink or an end leaves no room for stay
 * short.
 */
void arcfit_lengthen(const struct reference *reference, const struct deviation *within, int digits,
                     double least, struct pieces *pieces);

/*
 * Turns the axes at the joints between the pieces [from, to) so that their lean off Z and its
 * bearing, which are the angles of a machine's rotary axes, change their speed along the way as
 * little as `within` allows: one joint after the other to the least sum of squares of the changes
 * there and at its neighbours.  What is programmed stays.  Axes beside Z stay.
 */
void arcfit_calm(const struct reference *reference, const struct deviation *within, size_t from,
                 size_t to, struct pieces *pieces);

/*
 * Goes round each piece whose ends are nearer than `least` mm, a few hundredths, by an arc or a
 * biarc from a place before it to one after it, over further pieces where these are short, too,
 * each as near as keeps `within`, all pieces as long and the direction; a kink on one side of it
 * stays, or where nothing else is found goes with it.
 * Proven by arc_piece_deviation with joints rounded to `digits` decimals.  Returns how many short
 * ones are left.
 */
size_t arcfit_bridge(const struct reference *reference, const struct deviation *within, int digits,
                     double least, struct pieces *pieces);

/* The same by a line with a kink at either end, for those that arcfit_bridge leaves: an arc that
 * turns within a few hundredths of a millimetre is no smoother. */
size_t arcfit_cut(const struct reference *reference, const struct deviation *within, int digits,
                  double least, struct pieces *pieces);

/*
 * Fits the pieces [from, to) anew where their part of the reference has moved a little, between the
 * directions of those beside them: as many pieces, from their joints as they are, proven as by
 * arcfit_reduce; or, but in a hurry, spaced anew, or up to two more: one in eight is found
 * so, in twice the time of all else here.  What does not touch them stays.  False: all stay.
 */
bool arcfit_refit(const struct reference *reference, const struct deviation *within, int digits,
                  size_t from, size_t to, enum arcfit_effort effort, struct pieces *pieces);

/*
 * Searches for the pieces [from, to) anew, as arcfit_beam, from where the first begins in its
 * direction to where a later one begins, at `to` or as far behind as it takes: a biarc meets it in
 * its direction.  False: none was met, and all after `from` is new.
 */
bool arcfit_again(const struct reference *reference, const struct deviation *within, int digits,
                  enum arcfit_effort effort, size_t from, size_t to, struct pieces *pieces);

/* No direction jumps between the pieces [from, to). */
bool arcfit_smooth(const struct pieces *pieces, size_t from, size_t to);

/* The length of the shortest of the pieces [from, to), mm. */
double arcfit_shortest(const struct pieces *pieces, size_t from, size_t to);

/* The reference from its last point to its first; the caller frees it (reference_free). */
struct reference arcfit_reverse_reference(const struct reference *reference);

/* Turns round the pieces of a reference of `points` points that was turned round. */
void arcfit_reverse_pieces(struct pieces *pieces, size_t points);

#endif
