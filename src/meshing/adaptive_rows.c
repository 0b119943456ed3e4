/* adaptive_rows - see adaptive_rows.h. */
#include "meshing/adaptive_rows.h"

#include <stdbool.h>
#include <stdlib.h>

#include "adaptive_rows_steps.h"
#include "cloud/scan_lines.h"

/* Part of the error that the rows may be off along themselves; the rest is for between them. */
static const double ALONG = 0.4;

/* What is measured of one strip. */
struct strip {
    struct faces face; /* as strip_triangulate numbers them */
    double worst, sum2;
    struct vec3 at;
    size_t points, out, bridges;
    size_t lost; /* points between its rows that no facet is above or below */
    bool done;
};

/* A point's place across the rows. */
struct across {
    double v;
    size_t point;
};

struct refinement {
    const struct point_grid *point_grid;
    const struct cell_surfaces *cells;
    const struct plan_extent *plan_extent;
    const struct holes *holes;
    double error, spacing, out;
    struct row_simplify_options rule;
    struct {
        size_t n, cap;
        struct row_simplify *item;
    } row;
    struct {
        size_t n, cap;
        struct strip *item; /* between row i and row i + 1 */
    } strip;
    unsigned char *covered; /* by point: 1, a facet is above or below it */
    struct across *across;  /* of all points, by rising v */
};

static int by_v(const void *a, const void *b)
{
    const struct across *p = a, *q = b;

    if (p->v < q->v || p->v > q->v)
        return p->v < q->v ? -1 : 1;
    return (p->point > q->point) - (p->point < q->point);
}

static void sort_across(struct refinement *w)
{
    w->across = mem_alloc(w->point_grid->n, sizeof *w->across);
    for (size_t i = 0; i < w->point_grid->n; i++)
        w->across[i] =
            (struct across){plan_extent_turn(w->plan_extent, w->point_grid->point[i]).y, i};
    qsort(w->across, w->point_grid->n, sizeof *w->across, by_v);
}

/* The first of the points that is no lower. */
static size_t first_across(const struct refinement *w, double v)
{
    size_t low = 0, high = w->point_grid->n;

    while (low < high) {
        size_t middle = low + (high - low) / 2;
        if (w->across[middle].v < v)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

static struct row_simplify row_at(const struct refinement *w, double v, double longest)
{
    return row_simplify_make(w->point_grid, w->plan_extent, v, &w->rule, longest);
}

/* The points above and below one facet (in the scan's axes). */
static void measure_face(struct refinement *w, struct strip *s, struct vec3 a, struct vec3 b,
                         struct vec3 c)
{
    const double border = 1e-9 * w->spacing * w->spacing; /* points on a border belong to it */
    struct vec3 normal = vec_unit(vec_cross(vec_sub(b, a), vec_sub(c, a)));
    struct sizes over = {0};
    point_grid_over(w->point_grid, a, b, c, border, &over);
    for (size_t k = 0; k < over.n; k++) {
        struct vec3 p = w->point_grid->point[over.item[k]];
        double off = fabs(vec_dot(normal, vec_sub(p, a)));
        w->covered[over.item[k]] = 1;
        if (w->rule.zone && feature_zone_near(w->rule.zone, p.x, p.y))
            continue;
        s->points++;
        s->out += off > w->error;
        s->sum2 += off * off;
        if (off > s->worst) {
            s->worst = off;
            s->at = p;
        }
    }
    array_free(&over);
}

/* Along the rows, of a vertex of the strip between two. */
static double x_of(const struct row_simplify *low, const struct row_simplify *high, size_t v)
{
    return v < low->node.n ? low->node.item[v].x : high->node.item[v - low->node.n].x;
}

/* Does a facet of a strip hang on the end of one row by a corner, beyond where that row goes? */
static bool overhangs_row(const struct refinement *w, const struct face *face,
                          const struct row_simplify *low, const struct row_simplify *high)
{
    size_t n = low->node.n, m = high->node.n;

    for (int i = 0; i < 3; i++) {
        size_t tip = (size_t)face->v[i], a = (size_t)face->v[(i + 1) % 3];
        size_t b = (size_t)face->v[(i + 2) % 3];
        if ((tip < n) == (a < n) || (tip < n) == (b < n))
            continue;
        double x = x_of(low, high, tip), xa = x_of(low, high, a), xb = x_of(low, high, b);
        return ((tip + 1 == n || tip + 1 == n + m) && fmin(xa, xb) > x + w->rule.gap) ||
               ((tip == 0 || tip == n) && fmax(xa, xb) < x - w->rule.gap);
    }
    return false;
}

static void make_strip(struct refinement *w, size_t index)
{
    const double nothing = 1e-12;
    struct strip *s = &w->strip.item[index];
    const struct row_simplify *low = &w->row.item[index], *high = &w->row.item[index + 1];
    size_t first = first_across(w, low->v), end = first_across(w, high->v);
    struct faces all = {0};
    for (size_t i = first; i < end; i++)
        w->covered[w->across[i].point] = 0;
    strip_triangulate(w->cells, w->plan_extent, w->error, low, high, &all);
    for (size_t f = 0; f < all.n; f++) {
        struct vec3 p[3];
        for (int i = 0; i < 3; i++) {
            size_t v = (size_t)all.item[f].v[i];
            p[i] = plan_extent_turn_back(w->plan_extent, v < low->node.n
                                                             ? low->node.item[v]
                                                             : high->node.item[v - low->node.n]);
        }
        if (!(vec_orient_xy(p[0], p[1], p[2]) > nothing * w->spacing * w->spacing))
            continue;
        if (overhangs_row(w, &all.item[f], low, high) ||
            holes_bridged(w->holes, p[0], p[1], p[2])) {
            s->bridges++;
            continue;
        }
        measure_face(w, s, p[0], p[1], p[2]);
        *array_push(&s->face) = all.item[f];
    }
    array_free(&all);
    for (size_t i = first; i < end; i++)
        s->lost += !w->covered[w->across[i].point];
    s->done = true;
}

/* A row halfway between a row and the next. */
static void halve(struct refinement *w, size_t index)
{
    double low = w->row.item[index].v, high = w->row.item[index + 1].v;
    struct row_simplify row = row_at(w, (low + high) / 2, w->row.item[index].longest);
    array_push(&w->row);
    for (size_t i = w->row.n - 1; i > index + 1; i--)
        w->row.item[i] = w->row.item[i - 1];
    w->row.item[index + 1] = row;
    array_free(&w->strip.item[index].face);
    array_push(&w->strip);
    for (size_t i = w->strip.n - 1; i > index + 1; i--)
        w->strip.item[i] = w->strip.item[i - 1];
    w->strip.item[index] = w->strip.item[index + 1] = (struct strip){0};
}

static void first_rows(struct refinement *w, double widest)
{
    double height = w->plan_extent->ymax - w->plan_extent->ymin;
    size_t n = (size_t)fmax(ceil(height / widest), 2);
    for (size_t i = 0; i <= n; i++) {
        struct row_simplify row =
            row_at(w, w->plan_extent->ymin + height * (double)i / (double)n, INFINITY);
        *array_push(&w->row) = row;
        if (i > 0)
            *array_push(&w->strip) = (struct strip){0};
    }
}

/* Makes a row's pieces no longer than that; the strips beside it are to be made again. */
static void shorten(struct refinement *w, size_t index, double longest)
{
    struct row_simplify *row = &w->row.item[index];
    double v = row->v;
    if (row->longest <= longest)
        return;
    row_simplify_free(row);
    *row = row_at(w, v, longest);
    for (size_t i = index > 0 ? index - 1 : 0; i <= index && i < w->strip.n; i++) {
        array_free(&w->strip.item[i].face); /* NOLINT(clang-analyzer-unix.Malloc): of each strip */
        w->strip.item[i] = (struct strip){0};
    }
}

/* Is the strip wider than edges across a crease or wall may be, and is one in it? */
static bool is_too_wide(const struct refinement *w, size_t index)
{
    const struct feature_zone *zone = w->rule.zone;
    double low = w->row.item[index].v, high = w->row.item[index + 1].v;

    for (size_t i = 0; zone && high - low > zone->fine && i < zone->place.n; i++) {
        double v = plan_extent_turn(w->plan_extent, zone->place.item[i]).y;
        if (v >= low && v <= high)
            return true;
    }
    return false;
}

/* A strip with too many points off it gets triangles no longer than it is wide, then it is halved.
 * Facets over a hole, and borders that run aslant, hide how far the rest of a strip is off: there
 * it is halved too, down to rows three spacings apart. */
static void refine(struct refinement *w)
{
    const double few = 0.01, rim = 6, slender = 2, square = 1.2;
    for (size_t i = 0; i < w->strip.n;) {
        struct strip *s = &w->strip.item[i];
        double pitch = w->row.item[i + 1].v - w->row.item[i].v;
        if (is_too_wide(w, i)) {
            halve(w, i);
            continue;
        }
        if (!s->done)
            make_strip(w, i);
        double points = (double)(s->points + s->lost);
        bool hidden = (double)s->lost > few * points;
        bool bridged = (s->bridges > 0 || hidden) && pitch >= rim * w->spacing;
        bool few_out = !hidden && s->bridges == 0 && (double)s->out <= w->out * points;
        if (!bridged && (s->worst <= w->error || few_out)) {
            i++;
        } else if (fmax(w->row.item[i].longest, w->row.item[i + 1].longest) > slender * pitch) {
            double longest = fmax(square * pitch, 2 * w->spacing);
            shorten(w, i, fmin(longest, slender * pitch));
            shorten(w, i + 1, fmin(longest, slender * pitch));
            i -= i > 0;
        } else if (bridged || pitch >= 2 * w->spacing) {
            halve(w, i);
        } else {
            i++;
        }
    }
}

static void add_vertices(const struct refinement *w, struct mesh *mesh)
{
    for (size_t r = 0; r < w->row.n; r++)
        for (size_t i = 0; i < w->row.item[r].node.n; i++) {
            *array_push(&mesh->vertex) =
                plan_extent_turn_back(w->plan_extent, w->row.item[r].node.item[i]);
            *array_push(&mesh->row) = (int)r;
            *array_push(&mesh->col) = w->row.item[r].col.item[i];
        }
}

static struct adaptive_rows collect_mesh(const struct refinement *w, struct mesh *mesh)
{
    struct adaptive_rows result = {.rows = w->row.n};
    size_t first = 0, points = 0;
    double sum2 = 0;
    add_vertices(w, mesh);
    for (size_t i = 0; i < w->strip.n; i++) {
        const struct strip *s = &w->strip.item[i];
        for (size_t f = 0; f < s->face.n; f++) {
            struct face face = s->face.item[f];
            for (int k = 0; k < 3; k++)
                face.v[k] += (int)first;
            *array_push(&mesh->face) = face;
        }
        first += w->row.item[i].node.n;
        points += s->points;
        sum2 += s->sum2;
        result.bridges += s->bridges;
        if (s->worst > result.worst) {
            result.worst = s->worst;
            result.at = s->at;
        }
    }
    for (size_t i = 0; i < mesh->col.n; i++)
        result.columns =
            mesh->col.item[i] >= result.columns ? mesh->col.item[i] + 1 : result.columns;
    result.rms = points > 0 ? sqrt(sum2 / (double)points) : 0;
    for (size_t i = 0; i < w->point_grid->n; i++)
        result.beside += !w->covered[i];
    return result;
}

struct adaptive_rows adaptive_rows_make(const struct point_grid *point_grid,
                                        const struct plan_extent *plan_extent,
                                        const struct holes *holes,
                                        const struct adaptive_rows_options *options,
                                        struct mesh *mesh)
{
    const double gaps = 6, reaches = scan_lines_found(point_grid) ? 2.4 : 1.2;
    struct cell_surfaces cells = cell_surfaces_make(point_grid, options->threads);
    struct refinement w = {.point_grid = point_grid,
                           .cells = &cells,
                           .plan_extent = plan_extent,
                           .holes = holes,
                           .error = options->error,
                           .spacing = options->spacing,
                           .out = options->out,
                           .rule = {options->spacing, reaches * options->spacing,
                                    gaps * options->spacing, ALONG * options->error, options->zone},
                           .covered = mem_alloc(point_grid->n, 1)};
    sort_across(&w);
    first_rows(&w, options->widest);
    refine(&w);
    struct adaptive_rows result = collect_mesh(&w, mesh);
    for (size_t i = 0; i < w.row.n; i++)
        row_simplify_free(&w.row.item[i]);
    for (size_t i = 0; i < w.strip.n; i++)
        array_free(&w.strip.item[i].face);
    array_free(&w.row);
    array_free(&w.strip);
    cell_surfaces_free(&cells);
    free(w.across);
    free(w.covered);
    return result;
}
