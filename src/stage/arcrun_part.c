/* arcrun_part - see arcrun_part.h. */
#include "arcrun_part.h"

#include <stdlib.h>

#include "arc_carry.h"
#include "arc_pole.h"
#include "arcfit/arcfit.h"

static void print_pieces(struct arcrun_work *f)
{
    f->worst = arcprint_pieces(&f->reference, &f->pieces, NULL, &f->printed);
}

/* Straight from point to point: the reference itself. */
static void use_points(struct arcrun_work *f)
{
    f->pieces.n = 0;
    for (size_t i = 0; i + 1 < f->reference.n; i++)
        *array_push(&f->pieces) =
            arc_piece_of(&f->reference, arc_line(f->reference.point[i], f->reference.point[i + 1]),
                         (double)i, (double)(i + 1));
}

static size_t given_points(const struct arcrun_work *f)
{
    size_t n = 0;
    for (size_t i = 0; i < f->reference.n; i++)
        n += f->dense->item[f->first + i].given;
    return n;
}

/* Many points that were given fall to a piece.  Where they are few, as on a scan, a longer search
 * finds hardly fewer pieces; and what is guarded may be fitted several times. */
static bool is_smooth(const struct arcrun_work *f)
{
    const size_t many = f->options->guarded ? 16 : 8;
    return given_points(f) >= many * f->pieces.n;
}

bool arcrun_part_hurried(const struct arcrun_options *options)
{
    const double little = 0.25, guarded = 0.5; /* where it may be fitted several times */

    return options->work > 0 && options->work < (options->guarded ? guarded : little);
}

static enum arcfit_effort effort_of(const struct arcrun_work *f)
{
    return arcrun_part_hurried(f->options) ? ARCFIT_HURRIED
           : f->options->guarded           ? ARCFIT_QUICK
                                           : ARCFIT_THOROUGH;
}

/* Of each point, in a longer search for fewer arcs of smooth data. */
static double feet_of(const struct arcrun_work *f)
{
    const double usual = 400;
    return f->options->work > 0 ? usual * f->options->work : usual;
}

/* The pieces found from the other end, where they are fewer. */
static bool fit_from_end(const struct arcrun_work *f, const struct deviation *less,
                         struct pieces *back)
{
    struct reference reference = arcfit_reverse_reference(&f->reference);
    arcfit_beam(&reference, less, PATH_COORDINATE, effort_of(f), back);
    arcfit_reduce(&reference, less, PATH_COORDINATE, feet_of(f), back);
    arcfit_reverse_pieces(back, reference.n);
    if (back->n <= f->pieces.n)
        arcfit_reduce(&f->reference, less, PATH_COORDINATE, feet_of(f), back);
    reference_free(&reference);
    return back->n < f->pieces.n;
}

static void swap_pieces(struct pieces *a, struct pieces *b)
{
    struct pieces c = *a;
    *a = *b;
    *b = c;
}

/* The printed pieces keep the tolerance. */
static bool is_proven(struct arcrun_work *f, const struct deviation *within)
{
    print_pieces(f);
    return deviation_within(&f->worst, within);
}

/* Once: from the start, and from the end where that pays. */
static bool fit_once(struct arcrun_work *f, const struct deviation *within,
                     const struct deviation *less)
{
    struct pieces back = {0};
    bool good = false;

    f->pieces.n = 0;
    arcfit_beam(&f->reference, less, PATH_COORDINATE, effort_of(f), &f->pieces);
    if (!arcrun_part_hurried(f->options) || is_smooth(f))
        arcfit_reduce(&f->reference, less, PATH_COORDINATE, 0, &f->pieces);
    bool thorough = is_smooth(f);
    if (thorough && !reference_axis_still(&f->reference, 0, f->reference.n - 1))
        arcfit_reduce(&f->reference, less, PATH_COORDINATE, feet_of(f), &f->pieces);
    if (thorough && fit_from_end(f, less, &back)) {
        swap_pieces(&f->pieces, &back);
        if (f->options->least > 0)
            arcfit_lengthen(&f->reference, less, PATH_COORDINATE, f->options->least, &f->pieces);
        good = is_proven(f, within);
        if (!good)
            swap_pieces(&f->pieces, &back);
    }
    array_free(&back);
    if (!good && f->options->least > 0)
        arcfit_lengthen(&f->reference, less, PATH_COORDINATE, f->options->least, &f->pieces);
    return good || is_proven(f, within);
}

enum {
    BESIDE = 1,       /* pieces beside what has moved that are fitted anew with it */
    WINDOW_MOST = 24, /* pieces that are fitted anew at once */
};

/* The window's pieces fitted anew, with more beside them where these alone find no place (not in a
 * hurry: then they are searched for); none before `first`. */
static bool refit_window(struct arcrun_work *f, const struct deviation *less, struct arc_moved w,
                         size_t first)
{
    static const size_t wider[] = {0, 2, 5};
    enum arcfit_effort effort = effort_of(f);
    size_t tries = effort == ARCFIT_HURRIED ? 1 : sizeof wider / sizeof *wider;

    for (size_t i = 0; i < tries; i++) {
        size_t from = w.from > first + wider[i] ? w.from - wider[i] : first;
        size_t to = w.to + wider[i] < f->pieces.n ? w.to + wider[i] : f->pieces.n;
        if (to - from > WINDOW_MOST || !arcfit_smooth(&f->pieces, from, to))
            return false;
        if (arcfit_refit(&f->reference, less, PATH_COORDINATE, from, to, effort, &f->pieces))
            return true;
    }
    return false;
}

/* A window that has no place, or is too wide, searched for anew: that takes a part of the time of
 * the whole, where there is no time for other spacings. */
static bool search_window(struct arcrun_work *f, const struct deviation *less, struct arc_moved w)
{
    enum arcfit_effort effort = effort_of(f);

    return effort == ARCFIT_HURRIED && w.to > w.from &&
           arcfit_again(&f->reference, less, PATH_COORDINATE, effort, w.from, w.to, &f->pieces);
}

/* The pieces of the same part before some of its points moved, with those anew that touch them.
 * False where they are too many, or one of them finds no place. */
static bool fit_moved(struct arcrun_work *f, const struct arcrun_part *before,
                      const struct run *now, const struct deviation *less)
{
    const struct reference *t = &f->reference;
    struct arc_moves windows = {0};
    bool good = true, anew = false;

    f->pieces.n = 0;
    arc_carry(&before->points, now, &before->pieces, BESIDE, &f->pieces, &windows);
    struct arc_piece *first = f->pieces.item, *last = first + f->pieces.n - 1;
    first->arc.from = t->point[0]; /* the ends may have moved, too */
    first->axis = t->axis[0];
    last->arc.to = t->point[t->n - 1];
    last->axis_to = t->axis[t->n - 1];
    for (size_t k = windows.n; k-- > 0 && good;) { /* those before stay where they are */
        if (refit_window(f, less, windows.item[k], k > 0 ? windows.item[k - 1].to : 0))
            continue;
        good = search_window(f, less, windows.item[k]);
        anew = true;
    }
    array_free(&windows);
    if (good && anew && f->options->least > 0)
        arcfit_lengthen(t, less, PATH_COORDINATE, f->options->least, &f->pieces);
    return good;
}

static struct deviation part_of(struct deviation d, double part)
{
    return (struct deviation){part * d.point, part * d.other, part * d.axis};
}

/* Replaces the pieces by some that keep the tolerance, or leaves them; false: it does not. */
static bool is_better(struct arcrun_work *f, const struct deviation *within, struct pieces *some)
{
    struct printeds printed = {0}, old = f->printed;
    struct deviation worst = arcprint_pieces(&f->reference, some, &old, &printed);
    bool good = deviation_within(&worst, within);

    if (good) {
        swap_pieces(&f->pieces, some);
        f->worst = worst;
        f->printed = printed;
    }
    array_free(good ? &old : &printed);
    return good;
}

static void copy_pieces(const struct pieces *from, struct pieces *to)
{
    to->n = 0;
    for (size_t i = 0; i < from->n; i++)
        *array_push(to) = from->item[i];
}

/* The part begins or ends at the pole: its pieces lean there as those on the other side of it do,
 * in one more piece where the tolerance leaves no room for it. */
static void meet_pole(struct arcrun_work *f, const struct deviation *within, bool end)
{
    size_t at = f->first + (end ? f->reference.n - 1 : 0);
    struct vec3 plane = {0, 0, 0};
    struct pieces some = {0};
    bool good = false;

    if (at > 0 && at + 1 < f->dense->n && arc_pole_at(f->dense, at))
        plane = arc_pole_plane(f->dense, at);
    if (vec_length(plane) > 0 && f->pieces.n > 1) {
        copy_pieces(&f->pieces, &some);
        arc_pole_turn(&some, end, plane);
        good = is_better(f, within, &some);
    }
    double length = arc_length(&f->pieces.item[end ? f->pieces.n - 1 : 0].arc);
    double least = fmin(0.5, fmax(0.1, 2 * ARC_SHORTEST / fmax(length, ARC_SHORTEST)));
    for (double s = 0.5; vec_length(plane) > 0 && !good && s > least; s /= 2) {
        copy_pieces(&f->pieces, &some);
        arc_pole_divide(&f->reference, &some, end, s, plane);
        good = is_better(f, within, &some);
    }
    array_free(&some);
}

/* The pieces [from, to) that were not the same before, and two on each side. */
static void find_changed(const struct pieces *now, const struct pieces *before, size_t *from,
                         size_t *to)
{
    enum { ASIDE = 2 };
    size_t first = 0, last = 0, least = now->n < before->n ? now->n : before->n;
    while (first < least && vec_distance(now->item[first].arc.to, before->item[first].arc.to) <= 0)
        first++;
    while (last < least - first && vec_distance(now->item[now->n - 1 - last].arc.from,
                                                before->item[before->n - 1 - last].arc.from) <= 0)
        last++;
    *from = first > ASIDE ? first - ASIDE : 0;
    *to = last > ASIDE ? now->n - last + ASIDE : now->n;
}

/* How near the ends of a piece are at least, mm. */
static double nearest_ends(const struct pieces *pieces)
{
    double nearest = HUGE_VAL;
    for (size_t i = 0; i < pieces->n; i++)
        nearest = fmin(nearest, vec_distance(pieces->item[i].arc.from, pieces->item[i].arc.to));
    return nearest;
}

/* A part that is hardly longer than a piece may be is one line, where that keeps the tolerance. */
static void use_one_line(struct arcrun_work *f, const struct deviation *within, double least)
{
    const struct reference *t = &f->reference;
    struct vec3 from = t->point[0], to = t->point[t->n - 1];
    struct pieces some = {0};

    if (f->pieces.n > 1 && vec_distance(from, to) >= least &&
        t->length[t->n - 1] < (double)(f->pieces.n + 1) * least) {
        *array_push(&some) = arc_piece_of(t, arc_line(from, to), 0, (double)(t->n - 1));
        is_better(f, within, &some);
    }
    array_free(&some);
}

/* What becomes of pieces that keep the tolerance, so far as they keep it then, too.  Those that
 * were there before, if there are any, have been through this. */
static void refine(struct arcrun_work *f, const struct deviation *within,
                   const struct deviation *less, const struct pieces *before)
{
    struct pieces some = {0};
    double least = fmin(f->options->least, ARC_SHORTEST);

    if (nearest_ends(&f->pieces) < least)
        use_one_line(f, within, least);
    if (nearest_ends(&f->pieces) < least) {
        copy_pieces(&f->pieces, &some);
        arcfit_bridge(&f->reference, less, PATH_COORDINATE, least, &some);
        is_better(f, within, &some);
    }
    if (f->reference.turns) {
        size_t from = 0, to = f->pieces.n;
        copy_pieces(&f->pieces, &some);
        if (before)
            find_changed(&some, before, &from, &to);
        arcfit_calm(&f->reference, less, from, to, &some);
        is_better(f, within, &some);
    }
    meet_pole(f, within, false);
    meet_pole(f, within, true);
    array_free(&some);
}

/* A piece is shorter than a control can read the next in. */
static bool has_short(const struct arcrun_work *f)
{
    return nearest_ends(&f->pieces) < fmin(f->options->least, ARC_SHORTEST);
}

/* What is short in spite of all that is cut off by a line. */
static void cut_short(struct arcrun_work *f, const struct deviation *within)
{
    struct deviation less = part_of(*within, 1 - ARC_PRINTED / within->point);
    struct pieces some = {0};

    copy_pieces(&f->pieces, &some);
    arcfit_cut(&f->reference, &less, PATH_COORDINATE, fmin(f->options->least, ARC_SHORTEST), &some);
    is_better(f, within, &some);
    array_free(&some);
}

/*
 * Fits within less and less of the tolerance until the printed digits keep all of it, and up to
 * twice more where a piece is so short that no control likes it: with a little less there may be
 * none.  `before`: the part as it was, or NULL.
 */
void arcrun_part_fit(struct arcrun_work *f, double tolerance, const struct arcrun_part *before,
                     const struct run *now)
{
    struct deviation within = {tolerance, tolerance, f->options->axis};
    double part = 1 - ARC_PRINTED / tolerance;
    struct deviation less = part_of(within, part);
    struct pieces kept = {0}; /* the first that keep the tolerance, some of them short */

    if (before && fit_moved(f, before, now, &less) && is_proven(f, &within)) {
        refine(f, &within, &less, &before->pieces);
        if (!has_short(f))
            return;
        copy_pieces(&f->pieces, &kept);
    }
    for (int i = 0, spare = 2; i < 6 && spare >= 0; i++, part *= ARC_RETRY) {
        less = part_of(within, part);
        if (!fit_once(f, &within, &less))
            continue;
        refine(f, &within, &less, NULL);
        if (!has_short(f)) {
            array_free(&kept);
            return;
        }
        if (kept.n == 0)
            copy_pieces(&f->pieces, &kept);
        spare--;
    }
    if (kept.n == 0)
        use_points(f);
    else
        swap_pieces(&f->pieces, &kept);
    array_free(&kept);
    print_pieces(f);
    if (has_short(f))
        cut_short(f, &within);
}

/* A biarc for each interval between given points, its places those of the dense reference. */
void arcrun_part_each(struct arcrun_work *f, const struct run *run, struct arcrun_report *report)
{
    struct reference given = reference_of(run, 0, run->n, f->options->centre, true);
    report->loops += arcfit_each(&given, &f->pieces);
    size_t *at = mem_alloc(f->reference.n, sizeof *at), n = 0;
    for (size_t i = 0; i < f->reference.n; i++)
        if (f->dense->item[f->first + i].given)
            at[n++] = i;
    for (size_t i = 0; i < f->pieces.n; i++) {
        struct arc_piece *p = &f->pieces.item[i];
        double from = i > 0 ? f->pieces.item[i - 1].to : 0;
        double to = (double)at[(size_t)ceil(p->to)];
        if (p->biarc)
            to = fmin(to, fmax(from, reference_place(&f->reference, p->arc.to, (from + to) / 2)));
        bool biarc = p->biarc;
        *p = arc_piece_of(&f->reference, p->arc, from, to);
        p->biarc = biarc;
    }
    free(at);
    reference_free(&given);
    print_pieces(f);
}
