/*
 * spline_report - rows of figures for people.
 */
#include "stage/spline_report.h"

double spline_report_fewer(size_t points, size_t poles)
{
    return points > 0 ? 100 * (1 - (double)poles / (double)points) : 0;
}

static const char *combination(const struct splinefit *fit)
{
    static const char *const names[3][2] = {{"uniform/uniform", "uniform/average"},
                                            {"centripetal/uniform", "centripetal/average"},
                                            {"chord/uniform", "chord/average"}};

    if (fit->kind == SPLINEFIT_FITTED)
        return names[fit->params][fit->knots];
    if (fit->kind == SPLINEFIT_FREE)
        return "free";
    if (fit->kind == SPLINEFIT_GROWN)
        return "grown";
    if (fit->kind == SPLINEFIT_THROUGH)
        return "through all";
    return fit->kind == SPLINEFIT_STRAIGHT ? "straight" : "polyline";
}

void spline_report_head(FILE *table)
{
    fprintf(table, "%5s %7s %7s %7s %9s %9s %9s %9s %9s %9s %8s  %s\n", "pass", "points", "control",
            "%fewer", "C1", "C2", "rms", "middle", "tip", "ball", "axis", "parameters/knots");
}

static void write_row(FILE *table, size_t points, size_t poles, const struct fit_error *d,
                      const struct deviation *p, const char *end)
{
    fprintf(table, "%7zu %7zu %7.2f %9.6f %9.6f %9.6f %9.6f %9.6f %9.6f %8.4f  %s\n", points, poles,
            spline_report_fewer(points, poles), d->c1, d->c2, d->rms, d->middle, p->point, p->other,
            DEGREES(p->axis), end);
}

void spline_report_totals(const struct spline_report *report, FILE *table)
{
    fprintf(table, "%5s ", "all");
    write_row(table, report->points, report->poles, &report->deviation, &report->worst, "");
}

static void keep_largest(double *largest, double value)
{
    *largest = fmax(*largest, value);
}

static void count_spans(struct spline_report *report, double least, const struct bspline *b)
{
    for (size_t i = (size_t)b->degree; i < b->poles; i++) {
        double length = bspline_span_length(b, i);
        report->shortest = report->spans++ > 0 ? fmin(report->shortest, length) : length;
        report->shorter += length < least;
    }
}

double spline_report_spent(const struct spline_run_piece *piece)
{
    return piece->smooth + fmax(piece->fit.proof.point, piece->fit.proof.other);
}

void spline_report_add(struct spline_report *report, size_t pass, double least,
                       const struct spline_run_piece *piece, FILE *table)
{
    const struct splinefit *fit = &piece->fit;
    size_t points = piece->to - piece->from + 1, poles = fit->curve.poles;

    report->points += points - (piece->from > 0); /* pieces share the corners between them */
    report->splines++;
    report->poles += poles;
    count_spans(report, least, &fit->curve);
    report->polylines += fit->kind == SPLINEFIT_POLYLINE;
    report->cut += fit->cut;
    keep_largest(&report->deviation.c1, fit->deviation.c1);
    keep_largest(&report->deviation.c2, fit->deviation.c2);
    keep_largest(&report->deviation.rms, fit->deviation.rms);
    keep_largest(&report->deviation.middle, fit->deviation.middle);
    keep_largest(&report->worst.point, fit->proof.point);
    keep_largest(&report->worst.other, fit->proof.other);
    keep_largest(&report->worst.axis, fit->proof.axis);
    keep_largest(&report->spent, spline_report_spent(piece));
    if (table != NULL) {
        fprintf(table, "%5zu ", pass);
        write_row(table, points, poles, &fit->deviation, &fit->proof, combination(fit));
    }
}
