/* cloud_prepare - see cloud_prepare.h. */
#include "stage/cloud_prepare.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/cli.h"
#include "base/out.h"
#include "io/cloud/cloud.h"
#include "cloud/cloud.h"
#include "io/cloud/matrix.h"

void say_no_data(const char *file, const struct cloud_count *c)
{
    if (c->no_data > 0)
        say("%s: left out %zu row%s with a height of %g, which stands for no data", file,
            c->no_data, c->no_data == 1 ? "" : "s", c->mark);
}

void say_skipped(const char *file, const struct cloud_count *c)
{
    if (c->heads > 0)
        say("%s: ignored %zu heading line%s", file, c->heads, c->heads == 1 ? "" : "s");
    if (c->comments > 0)
        say("%s: ignored %zu comment%s", file, c->comments, c->comments == 1 ? "" : "s");
    if (c->indexed)
        say("%s: the first column numbers the rows: x y z are the three after it", file);
    if (c->placed)
        say("%s: the heading says which columns are x y z", file);
    if (c->placed && c->columns > 3)
        say("%s: ignored the others of %zu columns", file, c->columns);
    else if (c->columns > 3 + (size_t)c->indexed)
        say("%s: ignored the columns after the %s (up to %zu)", file,
            c->indexed ? "fourth" : "third", c->columns);
    if (c->facets > 0)
        say("%s: a mesh: the corners of its %zu facets are taken as points (planecut cuts the "
            "facets)",
            file, c->facets);
    if (c->withheld > 0)
        say("%s: left out %zu point%s that the file marks as withheld", file, c->withheld,
            c->withheld == 1 ? "" : "s");
    if (c->not_finite > 0 && c->first_not_finite == 0)
        say("%s: left out %zu point%s with nan, inf or a number out of range", file, c->not_finite,
            c->not_finite == 1 ? "" : "s");
    else if (c->not_finite > 0)
        say("%s:%zu: left out %zu row%s with nan, inf or a number out of range, this is the first",
            file, c->first_not_finite, c->not_finite, c->not_finite == 1 ? "" : "s");
    if (c->open_end > 0)
        say("%s:%zu: the last row has no line end: its last number may have been cut short", file,
            c->open_end);
    say_no_data(file, c);
    if (c->not_measured > 0)
        say("%s: left out %zu cell%s without a measurement", file, c->not_measured,
            c->not_measured == 1 ? "" : "s");
}

int cloud_prepare_read(char **file, int files, int threads, struct vec3s *points,
                       struct scan_sources *scan, size_t *left_out, struct error *error)
{
    *left_out = 0;
    for (int i = 0; i < files; i++) {
        struct cloud_count count = {0};
        size_t from = points->n;
        if (cloud_read(file[i], threads, points, &count, error) < 0)
            return -1;
        say_skipped(file[i], &count);
        scan_sources_add(scan, file[i], points->item + from, points->n - from);
        *left_out += cloud_left_out(&count);
    }
    return 0;
}

int cloud_prepare_place(struct vec3s *points, const char *unit, const char *matrix, bool to_origin,
                        struct mesh_origin *origin, struct error *error)
{
    struct transform total = transform_scale(cloud_unit(unit)), placing;
    if (matrix) {
        if (matrix_read(matrix, &placing, error) < 0)
            return -1;
        if (transform_determinant(&placing) < 0)
            say("%s: the matrix makes a mirror image of the part", matrix);
        total = transform_product(placing, total);
    }
    if (!transform_is_identity(&total))
        transform_points(&total, points->item, points->n);
    if (to_origin && points->n > 0) {
        struct plan_extent f = plan_extent_of(points->item, points->n, 0);
        struct transform shift = transform_shift(vec(-f.xmin, -f.ymin, 0));
        transform_points(&shift, points->item, points->n);
        total = transform_product(shift, total);
    }
    origin->placed = !transform_is_identity(&total);
    origin->place = total;
    return 0;
}

void say_sheets(const struct sheets *sheets)
{
    if (sheets->places > 0)
        say("two sheets of points lie over each other, %.3f mm apart (at %zu of %zu places looked "
            "at, at most %.3f mm at %.3f %.3f %.3f): scans that do not meet",
            sheets->distance, sheets->places, sheets->looked, sheets->widest, sheets->at.x,
            sheets->at.y, sheets->at.z);
}

double cloud_prepare_noise(double asked, double measured, double spacing)
{
    const double least = 0.004; /* in spacings */

    if (asked >= 0)
        return asked;
    return measured < least * spacing ? 0 : measured;
}

static void say_cleaned(const struct cloud_prepare *c, bool drop)
{
    const char *left = drop ? "left out" : "found, and kept,";
    if (c->twice > 0)
        say("left out %zu point%s that %s there already", c->twice, c->twice == 1 ? "" : "s",
            c->twice == 1 ? "was" : "were");
    if (c->outliers > 0)
        say("%s %zu outlier%s", left, c->outliers, c->outliers == 1 ? "" : "s");
    if (c->under > 0)
        say("%s %zu point%s under others, out of reach from above", left, c->under,
            c->under == 1 ? "" : "s");
}

/* Marks points under others beside what is marked already; those to be taken out are kept. */
static void cover(const struct point_grid *point_grid, bool drop, int threads, unsigned char *out,
                  struct cloud_prepare *done)
{
    unsigned char *before = mem_alloc(point_grid->n, 1);

    memcpy(before, out, point_grid->n);
    done->under = outliers_under_roof(point_grid, threads, out);
    for (size_t i = 0; drop && i < point_grid->n; i++)
        if (out[i] && !before[i])
            *array_push(&done->covered) = point_grid->point[i];
    free(before);
}

int cloud_prepare_clean(struct vec3s *points, double spacing, double noise,
                        enum cloud_prepare_drop drop, int threads,
                        struct cloud_prepare *cloud_prepare, struct error *error)
{
    struct point_grid point_grid;
    *cloud_prepare = (struct cloud_prepare){0};
    if (point_grid_make(points->item, points->n, spacing, threads, &point_grid, error) < 0)
        return -1;
    unsigned char *out = mem_alloc(points->n, 1);
    cloud_prepare->twice = outliers_twice(&point_grid, out);
    point_grid_remove(&point_grid, out);
    memset(out, 0, points->n);
    const struct believed_options believe = {.noise = noise, .threads = threads};
    struct believed believed = believed_in_grid(&point_grid, &believe, out);
    cloud_prepare->noise = believed.noise.even > 0 ? believed.noise.even : believed.noise.sigma;
    cloud_prepare->outliers = believed.outliers;
    if (drop != CLOUD_PREPARE_DROP_OUTLIERS)
        cover(&point_grid, drop == CLOUD_PREPARE_DROP, threads, out, cloud_prepare);
    if (drop != CLOUD_PREPARE_KEEP)
        point_grid_remove(&point_grid, out);
    points->n = point_grid.n;
    say_sheets(&believed.sheets);
    say_cleaned(cloud_prepare, drop != CLOUD_PREPARE_KEEP);
    free(out);
    point_grid_free(&point_grid);
    return 0;
}

static void write_points(const char *file, const char *what, const char *name,
                         const struct vec3s *raw, const unsigned char *out, bool wanted)
{
    struct out *o = out_open(file);
    size_t n = 0;

    for (size_t i = 0; i < raw->n; i++)
        n += (out[i] != 0) == wanted;
    out_printf(o, "# %zu %s of ", n, what);
    for (const char *p = name; *p; p++)
        out_bytes(o, (unsigned char)*p < ' ' ? "?" : p, 1);
    out_text(o, "\n");
    for (size_t i = 0; i < raw->n; i++) {
        if ((out[i] != 0) != wanted)
            continue;
        out_exact(o, raw->item[i].x);
        out_text(o, " ");
        out_exact(o, raw->item[i].y);
        out_text(o, " ");
        out_exact(o, raw->item[i].z);
        out_text(o, "\n");
    }
    out_close(o);
}

int cloud_prepare_write_clean(const char *file, const char *name, const struct vec3s *raw,
                              const struct vec3s *placed, double noise, int threads,
                              struct vec3s *kept, struct error *error)
{
    const struct believed_options options = {.noise = noise, .threads = threads};
    const char *suffix = ".outliers";
    unsigned char *out = mem_alloc(raw->n, 1);
    size_t length = strlen(file);
    struct believed believed;

    if (believed_find(placed->item, placed->n, &options, out, &believed, error) < 0) {
        free(out);
        return -1;
    }
    for (size_t i = 0; i < raw->n; i++)
        if (!out[i])
            *array_push(kept) = raw->item[i];
    write_points(file, "points believed", name, raw, out, false);
    char *other = mem_alloc(length + strlen(suffix) + 1, 1);
    memcpy(other, file, length);
    memcpy(other + length, suffix, strlen(suffix) + 1);
    write_points(other, "outliers", name, raw, out, true);
    free(other);
    free(out);
    return 0;
}
