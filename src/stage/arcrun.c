/*
 * arcrun - see arcrun.h.  A run is parted where its direction jumps and where the axis passes the
 * pole; each part is fitted by itself (arcrun_part.h), unless it was before.
 */
#include "stage/arcrun.h"

#include <stdlib.h>

#include "arc_carry.h"
#include "arcrun_part.h"
#include "arc_output.h"
#include "arc_pole.h"
#include "arcfit/arcfit.h"

/* The printed pieces become items of a path. */
static void write_pieces(const struct arcrun_work *f, struct path *out,
                         struct arcrun_report *report)
{
    const struct arc_output output = {f->options, &f->dense->item[f->first], &f->reference};

    arc_output_add(&output, &f->printed, out, report);
}

/* The dense reference as its digits will say it; returns what it takes of the tolerance. */
static double dense_run_of(const struct run *run, const struct arcrun_options *options,
                           struct run *dense)
{
    double part = arcrun_part_hurried(options) ? ARC_REFERENCE_HURRIED : ARC_REFERENCE_MAX;
    double taken = part * options->tolerance;
    double off = run_densify(run, taken, dense);
    if (off <= ARC_DENSE * options->tolerance) {
        dense->n = 0;
        for (size_t i = 0; i < run->n; i++)
            *array_push(dense) = run->item[i];
        return 0;
    }
    for (size_t i = 0; i < dense->n; i++) {
        struct run_point *p = &dense->item[i];
        p->axis = vec_unit(vec_round(p->axis, PATH_VECTOR));
        if (options->centre)
            p->ball = vec_round(p->ball, PATH_COORDINATE);
        else
            p->tip = vec_round(p->tip, PATH_COORDINATE);
    }
    return taken;
}

/* The way of the balls between two points is shorter than `least`. */
static bool is_near(const struct run *run, size_t from, size_t to, double least)
{
    double length = 0;
    while (from < to && length < least) {
        length += vec_distance(run->item[from].ball, run->item[from + 1].ball);
        from++;
    }
    return length < least;
}

/* A smooth part would end at point i.  One shorter than a piece may be is one with its neighbour,
 * but for those that end at the pole. */
static void end_part(const struct run *run, size_t i, double least, struct sizes *end)
{
    bool stays = i + 1 == run->n || arc_pole_at(run, i);
    while (stays && end->n > 0 && !arc_pole_at(run, end->item[end->n - 1]) &&
           is_near(run, end->item[end->n - 1], i, least))
        end->n--;
    if (stays || !is_near(run, end->n > 0 ? end->item[end->n - 1] : 0, i, least))
        *array_push(end) = i;
}

/* Where the smooth parts of what is programmed end: at its corners, where the axis passes the pole,
 * and at the end of the run. */
static struct sizes parts_of(const struct run *dense, const struct arcrun_options *options)
{
    struct run programmed = {.radius = dense->radius, .edges = dense->edges};
    for (size_t i = 0; i < dense->n; i++) {
        struct run_point *p = array_push(&programmed);
        *p = dense->item[i];
        p->ball = options->centre ? p->ball : p->tip;
    }
    struct sizes end = {0}, corner = {0};
    if (!options->paper)
        run_corners(&programmed, &corner);
    for (size_t i = 1, k = 0; i + 1 < dense->n && !options->paper; i++) {
        bool turns = k < corner.n && corner.item[k] == i;
        k += turns;
        if (turns || arc_pole_at(dense, i))
            end_part(&programmed, i, fmin(options->least, ARC_SHORTEST), &end);
    }
    end_part(&programmed, dense->n - 1, fmin(options->least, ARC_SHORTEST), &end);
    array_free(&corner);
    array_free(&programmed);
    return end;
}

/* ---- what was fitted before */

static void part_free(struct arcrun_part *part)
{
    array_free(&part->points);
    array_free(&part->pieces);
    path_free(&part->fitted);
}

void arcrun_memo_free(struct arcrun_memo *memo)
{
    for (size_t i = 0; i < memo->n; i++)
        part_free(&memo->item[i]);
    array_free(memo);
}

/* The part of the memo with these points, NULL: there is none. */
static const struct arcrun_part *find_part(const struct arcrun_memo *memo,
                                           const struct run_point *point, size_t n)
{
    for (size_t k = 0; memo && k < memo->n; k++) {
        const struct run *old = &memo->item[k].points;
        size_t same = 0;
        while (old->n == n && same < n && arc_carry_same(&old->item[same], &point[same]))
            same++;
        if (n > 0 && same == n)
            return &memo->item[k];
    }
    return NULL;
}

/* The part of the memo of which these are the points, some of them moved. */
static const struct arcrun_part *find_moved(const struct arcrun_memo *memo, const struct run *now)
{
    for (size_t k = 0; memo && k < memo->n; k++)
        if (arc_carry_alike(&memo->item[k].points, now))
            return &memo->item[k];
    return NULL;
}

/* The reference's part of the dense run, fitted now or before. */
static void fit_smooth_part(struct arcrun_work *f, size_t n, const struct arcrun_memo *memo,
                            double within, struct arcrun_part *part)
{
    const struct run_point *point = &f->dense->item[f->first];
    const struct arcrun_part *before = find_part(memo, point, n);

    for (size_t i = 0; i < n; i++)
        *array_push(&part->points) = point[i];
    if (before) {
        path_add_items(&part->fitted, &before->fitted, 0, before->fitted.item.n);
        for (size_t i = 0; i < before->pieces.n; i++)
            *array_push(&part->pieces) = before->pieces.item[i];
        part->report = before->report;
        return;
    }
    f->reference = reference_of(f->dense, f->first, n, f->options->centre, false);
    arcrun_part_fit(f, within, find_moved(memo, &part->points), &part->points);
    write_pieces(f, &part->fitted, &part->report);
    for (size_t i = 0; i < f->pieces.n; i++)
        *array_push(&part->pieces) = f->pieces.item[i];
    part->report.worst = f->worst;
    reference_free(&f->reference);
}

void arcrun_fit(const struct run *run, const struct arcrun_options *options,
                struct arcrun_memo *memo, struct path *out, struct arcrun_report *report)
{
    struct arcrun_memo now = {0};
    struct run dense = {.radius = run->radius, .edges = run->edges};
    double taken = dense_run_of(run, options, &dense);
    if (options->chords)
        taken += ARC_CHORD * options->tolerance;
    struct sizes end = parts_of(&dense, options);
    struct arcrun_work f = {.options = options, .dense = &dense};
    for (size_t i = 0; i < end.n; i++) {
        size_t n = end.item[i] - f.first + 1;
        if (options->paper) {
            f.reference = reference_of(&dense, f.first, n, options->centre, false);
            arcrun_part_each(&f, run, report);
            write_pieces(&f, out, report);
            report->worst = deviation_worst(report->worst, f.worst);
            reference_free(&f.reference);
        } else {
            struct arcrun_part part = {.points = {.radius = run->radius}};
            fit_smooth_part(&f, n, memo, options->tolerance - taken, &part);
            path_add_items(out, &part.fitted, 0, part.fitted.item.n);
            arcrun_add(report, &part.report);
            *array_push(&now) = part;
        }
        f.first = end.item[i];
    }
    if (memo) {
        arcrun_memo_free(memo);
        *memo = now;
    } else {
        arcrun_memo_free(&now);
    }
    report->points += run->n;
    report->corners += end.n - 1;
    report->spent = fmax(report->worst.point, report->worst.other) + taken;
    array_free(&f.pieces);
    array_free(&f.printed);
    array_free(&end);
    array_free(&dense);
}

void arcrun_add(struct arcrun_report *sum, const struct arcrun_report *report)
{
    bool any = report->arcs + report->lines > 0, had = sum->arcs + sum->lines > 0;
    if (any)
        sum->shortest = had ? fmin(sum->shortest, report->shortest) : report->shortest;
    sum->shorter += report->shorter;
    sum->bend = fmax(sum->bend, report->bend);
    sum->turn = fmax(sum->turn, report->turn);
    sum->points += report->points;
    sum->arcs += report->arcs;
    sum->lines += report->lines;
    sum->c += report->c;
    sum->s += report->s;
    sum->loops += report->loops;
    sum->corners += report->corners;
    sum->kinks += report->kinks;
    sum->length += report->length;
    sum->spent = fmax(sum->spent, report->spent);
    sum->worst = deviation_worst(sum->worst, report->worst);
}
