/*
 * cloud2surf - scanned points to a NURBS surface: the indirect way that paper 1 reviews, by least
 * squares (Bradley, Park), by Ferguson patches (Lee) or by Bezier patches (Kawabe).
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/cli.h"
#include "cloud/plan_extent.h"
#include "io/nurbs/surfaces_scan.h"
#include "math/box.h"
#include "io/nurbs/surfaces_write.h"
#include "stage/cloud_options.h"
#include "stage/cloud_prepare.h"
#include "stage/cloud_surface.h"

struct settings {
    struct cloud_surface_options fit;
    bool bspline, ferguson, bezier, iges, origin, noise_given, error_given;
    bool smooth_given;
    double noise;
    int unit, knots, outliers;
    const char *matrix; /* file, NULL: none */
};

static const char *const kind_name[] = {"a B-spline by least squares", "Ferguson patches",
                                        "Bezier patches"};

static void check_options(struct settings *s)
{
    if (s->bspline + s->ferguson + s->bezier > 1)
        die_usage("found two of --bspline, --ferguson and --bezier, expected one of them");
    s->fit.kind = s->ferguson ? CLOUD_SURFACE_FERGUSON
                  : s->bezier ? CLOUD_SURFACE_BEZIER
                              : CLOUD_SURFACE_BSPLINE;
    if (s->fit.kind == CLOUD_SURFACE_BSPLINE && s->fit.spacing > 0)
        die_usage("found -t, expected --ferguson or --bezier with it: a B-spline has no net");
    if (s->fit.kind != CLOUD_SURFACE_BSPLINE && (s->knots > 0 || s->smooth_given))
        die_usage("found %s, expected --bspline with it", s->knots > 0 ? "--knots" : "--bending");
    if (s->fit.spacing > 0 && s->error_given)
        die_usage("found -t with -e, expected one of them");
    s->fit.uniform = s->knots == 1;
}

static struct settings read_options(struct cli *cli, int argc, char **argv)
{
    struct settings s = {.fit = {.smooth = 1e-5}};
    const struct cli_option option[] = {
        {0, "bspline", NULL, "a cubic B-spline surface by least squares (default)", CLI_FLAG,
         &s.bspline, 0, 0, 0, NULL},
        {0, "ferguson", NULL, "Ferguson patches, without twist, on a net", CLI_FLAG, &s.ferguson, 0,
         0, 0, NULL},
        {0, "bezier", NULL, "Bezier patches between two families of curves", CLI_FLAG, &s.bezier, 0,
         0, 0, NULL},
        {'e', "tolerance", "MM",
         "largest distance of a point from the surface (default: 0.01, or five\n"
         "standard deviations of the noise if that is more)",
         CLI_NUMBER, &s.fit.error, CLI_POSITIVE, 0, 0, &s.error_given},
        {'t', "spacing", "MM", "spacing of the net, instead of -e", CLI_NUMBER, &s.fit.spacing,
         CLI_POSITIVE, 0, 0, NULL},
        {0, "knots", "error|uniform",
         "knots of the B-spline where the error is, or at equal distances\n"
         "(default: error)",
         CLI_CHOICE, &s.knots, 0, 0, 0, NULL},
        {0, "smooth", "X", NULL, CLI_ALIAS, "bending", 0, 0, 0, NULL},
        {0, "bending", "X", "weight of the bending energy against the points (default: 0.00001)",
         CLI_NUMBER, &s.fit.smooth, 1e-12, 1e6, 0, &s.smooth_given},
        UNIT_OPTION("units of the points (default: mm)", &s.unit, NULL),
        {'a', "direction", "DEG", "direction of u, from x towards y (default: 0)", CLI_NUMBER,
         &s.fit.direction, 0, 0, 0, NULL},
        MATRIX_OPTION(&s.matrix),
        ORIGIN_OPTION(&s.origin),
        {0, "max-gap", "MM",
         "an empty disc wider than this is a hole (default: six times the mean\n"
         "spacing of the points)",
         CLI_NUMBER, &s.fit.gap, CLI_POSITIVE, 0, 0, NULL},
        OUTLIERS_OPTION("(default: drop)", &s.outliers, NULL),
        {0, "keep-outliers", NULL, NULL, CLI_ALIAS, "outliers=keep", 0, 0, 0, NULL},
        {0, "noise", "MM", "standard deviation of the points (default: measured)", CLI_NUMBER,
         &s.noise, 0, 1e6, 0, &s.noise_given},
        {0, "untrimmed", NULL, "the whole rectangle, also where there are no points", CLI_FLAG,
         &s.fit.untrimmed, 0, 0, 0, NULL},
        {0, "iges", NULL, "write IGES (default: only if -o ends in .igs or .iges)", CLI_FLAG,
         &s.iges, 0, 0, 0, NULL},
        {0}};
    cli->option = option;
    cli_parse(cli, argc, argv);
    check_options(&s);
    return s;
}

/* What is no part of the surface taken out; the rest of the options from the cloud. */
static void prepare(const char *name, struct settings *s, struct vec3s *points, int threads)
{
    const double least = 0.01, sigmas = 5;
    struct cloud_prepare found;
    struct error error;

    if (plan_extent_check(points->item, points->n, &error) < 0)
        die("%s: %s", name, error.text);
    struct plan_extent f = plan_extent_of(points->item, points->n, s->fit.direction);
    s->fit.mean = plan_extent_spacing(&f, points->item, points->n);
    if (cloud_prepare_clean(points, s->fit.mean, s->noise_given ? s->noise : -1,
                            s->outliers == OUTLIERS_KEEP ? CLOUD_PREPARE_KEEP : CLOUD_PREPARE_DROP,
                            threads, &found, &error) < 0)
        die("%s: %s", name, error.text);
    array_free(&found.covered);
    s->fit.noise = s->noise_given ? s->noise : found.noise;
    s->fit.threads = threads;
    if (!(s->fit.gap > 0))
        s->fit.gap = 6 * s->fit.mean;
    if (s->error_given || s->fit.spacing > 0)
        return;
    s->fit.error = fmax(least, sigmas * s->fit.noise);
    say("tolerance %g mm (-e)", s->fit.error);
}

/* Bytes that no line of text can have do not get into the head. */
static void write_surface(const struct cli *cli, const struct settings *s, const char *name,
                          size_t points, const struct scan_sources *scan,
                          const struct cloud_surface *result)
{
    char remark[1000];
    const char *end = cli->output ? strrchr(cli->output, '.') : NULL;
    bool iges = s->iges || (end && (strcmp(end, ".igs") == 0 || strcmp(end, ".iges") == 0));

    snprintf(
        remark, sizeof remark,
        "cloudmill cloud2surf: %s\nof %zu points of %.50s\nthese are within %.6f mm, %.6f rms\n",
        kind_name[s->fit.kind], points, name, result->worst, result->rms);
    for (char *c = remark; *c; c++)
        if (*c != '\n' && (*c < ' ' || *c > '~'))
            *c = '?';
    char *sources = surfaces_scan_text(scan);
    char *head = mem_alloc(strlen(remark) + strlen(sources) + 1, 1);
    sprintf(head, "%s%s", remark, sources);
    struct out *out = out_open(cli->output);
    if (iges)
        surfaces_write_iges(out, &result->patches, head);
    else
        surfaces_write_text(out, &result->patches, head);
    out_close(out);
    free(sources);
    free(head);
}

static void report(const struct settings *s, const struct cloud_surface *r)
{
    const struct patch *patch = &r->patches.item[0];
    size_t u = patch->surface.u.poles, v = patch->surface.v.poles, corners = 0;

    if (s->fit.kind == CLOUD_SURFACE_BSPLINE)
        note("%zu fits tried", r->fits);
    else
        say("net of %g mm", r->spacing);
    say("%s: %zu x %zu = %zu control points", kind_name[s->fit.kind], u, v, u * v);
    say("the points are within %.4f mm of the surface at worst (at %.3f %.3f %.3f), %.4f mm rms",
        r->worst, r->at.x, r->at.y, r->at.z, r->rms);
    for (size_t k = 0; k < patch->loop.n; k++)
        corners += patch->loop.item[k].n;
    if (patch->loop.n == 0)
        say("%s", s->fit.untrimmed ? "not trimmed: it goes on where there are no points"
                                   : "not trimmed: the points reach the border of the rectangle");
    else
        say("trimmed by the border of the scan: %zu loop%s of %zu lines", patch->loop.n,
            patch->loop.n == 1 ? "" : "s", corners);
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "cloud2surf",
                      .usual = "bspline ferguson bezier tolerance spacing units matrix iges",
                      .usage = "[options] [FILE...]",
                      .about = "Fits a NURBS surface to scanned points (several files are one "
                               "cloud)."};
    struct settings s = read_options(&cli, argc, argv);
    struct vec3s points = {0};
    struct mesh_origin origin = {0};
    struct scan_sources scan = {0};
    struct cloud_surface result;
    struct error error;
    size_t left_out;

    const char *name = cli.file[0];
    if (cloud_prepare_read(cli.file, cli.files, cli.threads, &points, &scan, &left_out, &error) <
            0 ||
        cloud_prepare_place(&points, unit_name[s.unit], s.matrix, s.origin, &origin, &error) < 0)
        die_error(&error);
    struct box box = box_around(points.item, points.n);
    struct vec3 size = vec_sub(box.high, box.low);
    say_unlikely_size(name, fmax(size.x, fmax(size.y, size.z)));
    say_far_away(name, box);
    prepare(name, &s, &points, cli.threads);
    if (cloud_surface_make(&s.fit, &points, &result, &error) < 0)
        die("%s: %s", name, error.text);
    scan.placed = origin.placed;
    scan.place = origin.place;
    write_surface(&cli, &s, name, points.n, &scan, &result);
    report(&s, &result);
    patches_free(&result.patches);
    scan_sources_free(&scan);
    array_free(&points);
    if (s.fit.error > 0 && result.worst > s.fit.error)
        die_unmet("%s: a point at %.3f %.3f %.3f is %.4f mm off the surface, expected %g mm: more "
                  "control points would be as many as points, or too much work",
                  name, result.at.x, result.at.y, result.at.z, result.worst, s.fit.error);
    return EXIT_DONE;
}
