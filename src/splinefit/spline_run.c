/*
 * spline_run - corners, dense data, fallback points.
 */
#include "splinefit/spline_run.h"

#include <stdlib.h>
#include <string.h>

#include "curve/flatten.h"

static const double CORNER = PI / 3;    /* a turn above this is a corner ... */
static const double ROUGH = PI / 6;     /* a turn above this, at ... */
static const double ROUGH_POINTS = 0.1; /* ... this part of the points: no smooth path is meant */

static void piece_free(struct spline_run_piece *piece)
{
    splinefit_free(&piece->fit);
    array_free(&piece->fallback);
    array_free(&piece->gouges);
}

void spline_run_free(struct spline_run *pieces)
{
    for (size_t i = 0; i < pieces->n; i++)
        piece_free(&pieces->item[i]);
    array_free(&pieces->fitted);
    array_free(pieces);
}

/* From the corner to the first point before (step -1) or after it that is `reach` mm away. */
static struct vec3 direction_to(const struct run *run, size_t corner, int step, double reach)
{
    struct vec3 at = run->item[corner].ball, d = {0, 0, 0};

    for (size_t i = corner; step < 0 ? i > 0 : i + 1 < run->n;) {
        i = step < 0 ? i - 1 : i + 1;
        d = vec_sub(run->item[i].ball, at);
        if (vec_length(d) >= reach)
            break;
    }
    return d;
}

/* Indices where pieces end, the last point among them. */
static struct sizes piece_ends(const struct run *run, double tolerance)
{
    struct sizes corner = {0}, end = {0};

    run_corners(run, &corner);
    for (size_t k = 0; k < corner.n; k++) {
        struct vec3 in = direction_to(run, corner.item[k], -1, SPLINE_CORNER * tolerance);
        struct vec3 out = direction_to(run, corner.item[k], 1, SPLINE_CORNER * tolerance);
        if (PI - vec_angle(in, out) > CORNER)
            *array_push(&end) = corner.item[k];
    }
    *array_push(&end) = run->n - 1;
    array_free(&corner);
    return end;
}

static void fill_fallback(struct spline_run_piece *piece, const struct run *run, bool centre,
                          double offset, double tolerance)
{
    const struct run_point *last = &run->item[piece->to];
    struct flat flat = {0};

    flatten(&piece->fit.curve, offset, last->axis, SPLINE_FALLBACK * tolerance, &flat);
    for (size_t i = 1; i + 1 < flat.u.n; i++)
        *array_push(&piece->fallback) = (struct pose){flat.point.item[i], flat.axis.item[i]};
    *array_push(&piece->fallback) = (struct pose){centre ? last->ball : last->tip, last->axis};
    flat_free(&flat);
}

/* True when the points turn so much that they are noise more than places of a smooth path.  Not
 * where the axis turns: straight between points, it takes the ball off the straight line. */
static bool is_rough(const struct run *run)
{
    size_t turns = 0;

    for (size_t i = 1; i + 1 < run->n; i++) {
        if (vec_distance(run->item[i].axis, run->item[0].axis) > 2e-9)
            return false;
        turns += vec_angle(vec_sub(run->item[i].ball, run->item[i - 1].ball),
                           vec_sub(run->item[i + 1].ball, run->item[i].ball)) > ROUGH;
    }
    return (double)turns > ROUGH_POINTS * (double)run->n;
}

/* The curve through all points of a piece, as far as it is off the smooth path through them. */
static void fit_through(const struct run *part, const struct spline_run_options *options,
                        const struct reference *whole, const struct splinefit_options *within,
                        struct splinefit *fit)
{
    struct reference points = reference_distinct(part, options->centre);

    splinefit_through(&points, whole, within, options->ends, fit);
    reference_free(&points);
}

/* Fits one piece; `options` with the whole tolerance; `before`: as it was for nearly the same
 * points, or NULL. */
static void fit_piece(const struct run *run, const struct spline_run_options *options,
                      const struct splinefit *before, struct spline_run_piece *piece)
{
    struct run part = {.n = piece->to - piece->from + 1,
                       .item = run->item + piece->from,
                       .radius = run->radius,
                       .edges = run->edges};
    struct splinefit_options o = options->fit;
    struct run dense = {.radius = run->radius};
    const struct run *data = &part;

    if (!options->paper && !is_rough(&part) &&
        run_densify(&part, SPLINE_DENSE * o.tolerance, &dense) > SPLINE_SPARSE * o.tolerance) {
        data = &dense;
        piece->smooth = SPLINE_DENSE * o.tolerance;
        o.tolerance -= piece->smooth;
    }
    struct reference reference = reference_distinct(data, options->centre);
    piece->still = reference.n < 2;
    if (!piece->still) {
        if (options->through)
            fit_through(&part, options, &reference, &o, &piece->fit);
        else if (options->paper)
            splinefit_paper(&reference, &o, &piece->fit);
        else if (before)
            splinefit_again(&reference, &o, before, &piece->fit);
        else
            splinefit_search(&reference, &o, &piece->fit);
        fill_fallback(piece, run, options->centre, reference.offset, options->fit.tolerance);
    }
    reference_free(&reference);
    array_free(&dense);
}

/* ---- where a piece has no curve */

enum {
    FEW_LINES = 4,  /* a polyline of no more is not divided */
    DIVISIONS = 12, /* of a piece: what has trouble everywhere is meant as a polyline */
};

static bool has_no_curve(const struct spline_run_piece *piece)
{
    return !piece->still && piece->fit.kind == SPLINEFIT_POLYLINE &&
           piece->to - piece->from > FEW_LINES;
}

static void push_piece(const struct run *run, const struct spline_run_options *options, size_t from,
                       size_t to, struct spline_run *pieces)
{
    struct spline_run_piece piece = {.from = from, .to = to};

    fit_piece(run, options, NULL, &piece);
    *array_push(pieces) = piece;
}

static bool is_polyline(const struct run *run, const struct spline_run_options *options,
                        size_t from, size_t to)
{
    struct spline_run_piece piece = {.from = from, .to = to};

    fit_piece(run, options, NULL, &piece);
    bool none = has_no_curve(&piece);
    piece_free(&piece);
    return none;
}

/* Halves a piece that has no curve until a few lines are left that have none; *from and *to the
 * same: both halves have one, and it is the place between them. */
static void find_trouble(const struct run *run, const struct spline_run_options *options,
                         size_t *from, size_t *to)
{
    while (*to - *from > FEW_LINES) {
        size_t middle = *from + (*to - *from) / 2;
        if (is_polyline(run, options, *from, middle))
            *to = middle;
        else if (is_polyline(run, options, middle, *to))
            *from = middle;
        else
            *from = *to = middle;
    }
}

static size_t poles_of(const struct spline_run *pieces)
{
    size_t n = 0;

    for (size_t i = 0; i < pieces->n; i++)
        n += pieces->item[i].fit.curve.poles;
    return n;
}

static void divide_last(const struct run *run, const struct spline_run_options *options, int *left,
                        struct spline_run *pieces);

/* Pieces before and behind the lines from..to that have no curve, and these. */
static void divide_at(const struct run *run, const struct spline_run_options *options, int *left,
                      const struct spline_run_piece *whole, struct spline_run *parts)
{
    size_t from = whole->from, to = whole->to;

    find_trouble(run, options, &from, &to);
    if (from > whole->from) {
        push_piece(run, options, whole->from, from, parts);
        divide_last(run, options, left, parts);
    }
    if (to > from)
        push_piece(run, options, from, to, parts);
    if (whole->to > to) {
        push_piece(run, options, to, whole->to, parts);
        divide_last(run, options, left, parts);
    }
}

/* The last piece, if it has no curve, gives way to curves before and behind a few lines that have
 * none, as where the tip turns back while the axis goes over: as long as there are divisions
 * `left`, and if they have fewer poles. */
static void divide_last(const struct run *run, const struct spline_run_options *options, int *left,
                        struct spline_run *pieces)
{
    bool asked = options->fit.params >= 0 || options->fit.knots >= 0; /* for this very way */
    struct spline_run_piece *last = &pieces->item[pieces->n - 1];
    struct spline_run parts = {0};

    if (options->paper || options->through || asked || !has_no_curve(last) || (*left)-- <= 0)
        return;
    divide_at(run, options, left, last, &parts);
    if (poles_of(&parts) < last->fit.curve.poles) {
        piece_free(last);
        pieces->n--;
        for (size_t i = 0; i < parts.n; i++)
            *array_push(pieces) = parts.item[i];
        parts.n = 0;
    }
    spline_run_free(&parts);
}

/* Other pieces in place of piece k. */
static void replace_piece(struct spline_run *pieces, size_t k, const struct spline_run *by)
{
    array_reserve(pieces, pieces->n + by->n);
    memmove(&pieces->item[k + by->n], &pieces->item[k + 1],
            (pieces->n - k - 1) * sizeof *pieces->item);
    for (size_t i = 0; i < by->n; i++)
        pieces->item[k + i] = by->item[i];
    pieces->n += by->n - 1;
}

static void keep_points(const struct run *run, struct spline_run *pieces)
{
    pieces->fitted.n = 0;
    for (size_t i = 0; i < run->n; i++)
        *array_push(&pieces->fitted) = run->item[i];
}

void spline_run_fit(const struct run *run, const struct spline_run_options *options,
                    struct spline_run *pieces)
{
    struct sizes end = {0};

    if (options->paper)
        *array_push(&end) = run->n - 1;
    else
        end = piece_ends(run, options->fit.tolerance);
    size_t from = 0;
    for (size_t k = 0; k < end.n; k++) {
        int left = DIVISIONS;
        push_piece(run, options, from, end.item[k], pieces);
        divide_last(run, options, &left, pieces);
        from = end.item[k];
    }
    array_free(&end);
    keep_points(run, pieces);
}

static bool same_place(const struct run_point *a, const struct run_point *b)
{
    return vec_distance(a->ball, b->ball) == 0 && vec_distance(a->axis, b->axis) == 0 &&
           a->straight == b->straight;
}

static bool has_moved(const struct run *run, const struct spline_run *pieces,
                      const struct spline_run_piece *piece)
{
    for (size_t i = piece->from; i <= piece->to; i++)
        if (!same_place(&run->item[i], &pieces->fitted.item[i]))
            return true;
    return false;
}

/* The length of the piece up to point i of the run, which may be off its end. */
static double length_to(const double *length, const struct spline_run_piece *piece, size_t i)
{
    return length[(i < piece->from ? piece->from : i > piece->to ? piece->to : i) - piece->from];
}

/* Where points have moved, and as far beside them as that bends the way between the others: pairs
 * of places, parts of the piece's length. */
static void find_moved(const struct run *run, const struct spline_run *pieces,
                       const struct spline_run_piece *piece, bool centre, struct doubles *moved)
{
    const size_t beside = 2; /* points */
    size_t n = piece->to - piece->from;
    double *length = mem_alloc(n + 1, sizeof *length);

    length[0] = 0;
    for (size_t i = 1; i <= n; i++) {
        const struct run_point *p = &run->item[piece->from + i];
        length[i] = length[i - 1] +
                    (centre ? vec_distance(p[-1].ball, p->ball) : vec_distance(p[-1].tip, p->tip));
    }
    for (size_t i = piece->from; i <= piece->to; i++) {
        if (same_place(&run->item[i], &pieces->fitted.item[i]))
            continue;
        double whole = length[n] > 0 ? length[n] : 1;
        size_t before = i > beside ? i - beside : 0;
        *array_push(moved) = length_to(length, piece, before) / whole;
        *array_push(moved) = length_to(length, piece, i + beside) / whole;
    }
    free(length);
}

void spline_run_refit(const struct run *run, const struct spline_run_options *options,
                      struct spline_run *pieces)
{
    struct spline_run_options again = *options;
    struct doubles moved = {0};

    again.fit.moved = &moved;
    for (size_t k = pieces->n; k-- > 0;) { /* a piece that is divided grows upwards */
        struct spline_run_piece before = pieces->item[k], piece = {.from = before.from};
        struct spline_run parts = {0};
        int left = DIVISIONS;
        if (!has_moved(run, pieces, &before))
            continue;
        moved.n = 0;
        find_moved(run, pieces, &before, options->centre, &moved);
        piece.to = before.to;
        fit_piece(run, &again, before.still ? NULL : &before.fit, &piece);
        *array_push(&parts) = piece;
        divide_last(run, options, &left, &parts);
        replace_piece(pieces, k, &parts);
        array_free(&parts);
        piece_free(&before);
    }
    array_free(&moved);
    keep_points(run, pieces);
}

/*
 * Splits piece k, of more than two points, so that the interval of the run from point i of it to
 * the next one is a piece by itself, and fits what is new.
 */
static void split_piece(const struct run *run, const struct spline_run_options *options, size_t k,
                        size_t i, struct spline_run *pieces)
{
    struct spline_run_piece whole = pieces->item[k];
    size_t end[] = {whole.from, i, i + 1, whole.to};
    struct spline_run parts = {0};

    for (size_t e = 0; e < 3; e++)
        if (end[e] < end[e + 1])
            push_piece(run, options, end[e], end[e + 1], &parts);
    replace_piece(pieces, k, &parts);
    array_free(&parts);
    piece_free(&whole);
}

/* ---- kept clear of the part */

enum { ROUNDS = 3 }; /* of straight lines put in */

static const double SHORTEST = 0.05; /* mm: no shorter piece is made by it */

struct guarded_fit {
    const struct spline_run_options *options;
    const struct gouge_refit_options *gouge;
    struct spline_run *pieces;
    struct gouge_track *track;
};

/* Of a piece that is as it was when it was swept, they are known. */
static void find_gouges(const struct guarded_fit *f, const struct run *run,
                        struct spline_run_piece *piece, struct gouges *gouges)
{
    const struct run_point *from = &run->item[piece->from];
    struct pose pose = {f->options->centre ? from->ball : from->tip, from->axis};
    struct motion motion = motion_spline(pose, pose, &piece->fit.curve);

    if (!piece->still && !piece->swept)
        gouge_refit_motion(f->gouge, &motion, f->track, &piece->gouges);
    piece->swept = true;
    for (size_t i = 0; i < piece->gouges.n; i++)
        *array_push(gouges) = piece->gouges.item[i];
}

static void fit_and_check(void *context, const struct run *run, struct gouges *gouges)
{
    struct guarded_fit *f = context;

    if (f->pieces->n == 0)
        spline_run_fit(run, f->options, f->pieces);
    else
        spline_run_refit(run, f->options, f->pieces);
    for (size_t k = 0; f->gouge->guard && k < f->pieces->n; k++)
        find_gouges(f, run, &f->pieces->item[k], gouges);
}

/* The tracked point hardly moves from one point to the other: a control would creep there. */
static bool is_too_short(const struct guarded_fit *f, const struct run *run, size_t from, size_t to)
{
    double length = 0;

    for (size_t i = from; i < to; i++)
        length += f->options->centre ? vec_distance(run->item[i].ball, run->item[i + 1].ball)
                                     : vec_distance(run->item[i].tip, run->item[i + 1].tip);
    return from < to && length < SHORTEST;
}

/* In each piece that goes too deep, puts in the line between the two points next to the deepest
 * place.  False when there is none. */
static bool insert_lines(const struct guarded_fit *f, const struct run *run)
{
    struct gouges gouges = {0};
    bool done = false;

    for (size_t k = f->pieces->n; k-- > 0;) { /* a piece that is split grows upwards */
        struct spline_run_piece *piece = &f->pieces->item[k];
        gouges.n = 0;
        find_gouges(f, run, piece, &gouges);
        struct gouge deepest = gouge_refit_beyond(f->gouge, &gouges);
        if (deepest.depth == 0 || piece->to == piece->from + 1)
            continue;
        size_t i = run_motion_at(run, piece->from, piece->to, deepest.ball);
        if (is_too_short(f, run, piece->from, i) || is_too_short(f, run, i, i + 1) ||
            is_too_short(f, run, i + 1, piece->to))
            continue;
        split_piece(run, f->options, k, i, f->pieces);
        done = true;
    }
    array_free(&gouges);
    return done;
}

/* The points as they are: what is too deep is only reported. */
static struct gouge_refit_result fit_once(struct guarded_fit *f, const struct run *run)
{
    struct gouge_refit_result result = {.lift = 0};
    struct gouges gouges = {0};

    fit_and_check(f, run, &gouges);
    result.deepest = gouge_refit_beyond(f->gouge, &gouges);
    result.left = gouges;
    return result;
}

/* Until it is clear, and with straight lines where nothing else helps. */
static struct gouge_refit_result fit_clear(struct guarded_fit *f, struct run *run)
{
    struct gouge_refit_result result = gouge_refit_fit(f->gouge, run, fit_and_check, f);

    for (int round = 0; round < ROUNDS && result.deepest.depth > 0; round++) {
        if (!insert_lines(f, run))
            break;
        struct gouge_refit_result more = gouge_refit_fit(f->gouge, run, fit_and_check, f);
        array_free(&result.left);
        result.left = more.left;
        result.deepest = more.deepest;
        result.lift += more.lift;
    }
    return result;
}

struct gouge_refit_result spline_run_fit_guarded(struct run *run,
                                                 const struct spline_run_options *options,
                                                 const struct gouge_refit_options *gouge,
                                                 struct spline_run *pieces)
{
    struct gouge_track track = {0};
    struct guarded_fit f = {options, gouge, pieces, &track};

    spline_run_free(pieces);
    struct gouge_refit_result result = options->paper ? fit_once(&f, run) : fit_clear(&f, run);
    gouge_track_free(&track);
    return result;
}
