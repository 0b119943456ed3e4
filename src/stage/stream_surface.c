/* stream_surface - see stream_surface.h. */
#include "stream_surface.h"

#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "base/num.h"
#include "cloud/noise.h"
#include "cloud/outliers.h"
#include "meshing/node_heights.h"
#include "stage/cloud_prepare.h"
#include "stream_bands.h"

/* Rows beside a band on which its vertices depend: normals that face down take those of the facets
 * about the vertices as they were moved, which took theirs of those about the nodes, which took
 * theirs of the points. */
enum { MARGIN = 3 };

/* How far from a vertex its surface is looked for, in mean spacings of the points: as far as the
 * 1,800 nearest are (scan_normals.h takes 40, and up to 1,280 from laser lines); for the sample, as
 * far as the 1,024 nearest of a corner are, the most that surface_fit.h takes; at a node; and where
 * noise is measured, of the cells about. */
static const double FAR = 24, FARTHEST = 36, NEAR = 8;
enum { AROUND = 3 };

enum { SAMPLE = 200 /* vertices that say how many points a surface takes */ };

/* ---- how many points are where */

struct stream_counts *stream_counts_new(const struct cloud_stream *s)
{
    struct stream_counts *c = mem_alloc(1, sizeof *c);

    c->cells = point_grid_lattice(s->box.low, s->box.high, s->n, s->mean);
    c->of_cell = mem_alloc(c->cells.columns * c->cells.rows, sizeof *c->of_cell);
    c->of_row = mem_alloc((size_t)s->nodes.grid.rows, sizeof *c->of_row);
    return c;
}

void stream_counts_add(struct stream_counts *c, const struct grid *grid, const struct vec3 *point,
                       size_t n)
{
    for (size_t i = 0; i < n; i++) {
        c->of_cell[point_grid_cell(&c->cells, point[i])]++;
        c->of_row[stream_row(grid, &point[i])]++;
    }
}

void stream_counts_free(struct stream_counts *c)
{
    if (c) {
        free(c->of_cell);
        free(c->of_row);
        free(c);
    }
}

/* ---- the work */

struct work {
    struct cloud_stream *stream;
    struct stream_counts *counts;
    size_t at_a_time;                /* points in memory */
    double sigma;                    /* that vertices are rid of, mm; 0: none */
    struct surface_fit_options rule; /* with noise */
    struct smooth_nodes smooth;
    double variance;      /* sum */
    struct vec3s point;   /* of a band */
    struct mesh mesh;     /* of it and the rows beside it: room that is used again */
    struct vec3s before;  /* the vertices of the rows before a band, as they were */
    struct vec3 farthest; /* the vertex that was moved farthest */
    size_t next;          /* vertices that are done */
};

/* Sorts points into the cells of the scan, without those that are there twice. */
static int sort_points(const struct work *w, struct vec3s *points, struct point_grid *scan,
                       struct error *error)
{
    if (point_grid_make_in(&w->counts->cells, points->item, points->n, w->stream->threads, scan,
                           error) < 0)
        return -1;
    unsigned char *out = mem_alloc(points->n, 1);
    if (outliers_twice(scan, out) > 0)
        point_grid_remove(scan, out);
    free(out);
    return 0;
}

/* Vertices at their nodes, and what is known of them; NULL: nothing is. */
static double *stand_at_nodes(const struct work *w, const struct point_grid *scan,
                              struct mesh *mesh)
{
    const struct cloud_stream *s = w->stream;
    struct node_heights_options how = {s->mean, fmax(w->sigma, mesh->origin.noise), s->threads};

    if (s->options.scan_nodes)
        return NULL;
    double *certain = w->sigma > 0 ? NULL : mem_alloc(mesh->vertex.n, sizeof *certain);
    node_heights(mesh, &s->nodes.grid, scan, &how, certain);
    return certain;
}

/* ---- points about the places that are looked at for all */

struct sample {
    const struct point_grid *cells;
    unsigned char *mark; /* of each cell, whether its points are wanted */
    struct vec3s point;
    size_t places, vertices;
    struct {
        uint32_t cell, rank; /* of the cell's points in order */
    } place[NOISE_PLACES];
    int row[SAMPLE], column[SAMPLE];
};

static void mark_around(struct sample *s, struct vec3 place, double radius)
{
    const struct point_grid *b = s->cells;
    size_t left = point_grid_column(b, place.x - radius);
    size_t right = point_grid_column(b, place.x + radius);

    for (size_t row = point_grid_row(b, place.y - radius),
                high = point_grid_row(b, place.y + radius);
         row <= high; row++)
        memset(s->mark + row * b->columns + left, 1, right - left + 1);
}

/* Where noise_measure looks. */
static void choose_places(struct sample *s, const uint32_t *of_cell, size_t n)
{
    const struct point_grid *b = s->cells;
    size_t cell = 0, before = 0;

    s->places = n < NOISE_PLACES ? n : NOISE_PLACES;
    for (size_t i = 0; i < s->places; i++) {
        size_t at = noise_place(i, n);
        while (before + of_cell[cell] <= at)
            before += of_cell[cell++];
        s->place[i].cell = (uint32_t)cell;
        s->place[i].rank = (uint32_t)(at - before);
        size_t column = cell % b->columns, row = cell / b->columns;
        struct vec3 middle =
            vec(b->x + b->cell * ((double)column + 0.5), b->y + b->cell * ((double)row + 0.5), 0);
        mark_around(s, middle, AROUND * b->cell);
    }
}

/* Where surface_fit_typical looks: the points about the vertex, and about those beside it. */
static void choose_vertices(struct sample *s, const struct cloud_stream *stream)
{
    static const int RIGHT[7] = {0, 1, 0, -1, -1, 0, 1}, UP[7] = {0, 0, 1, 1, 0, -1, -1};
    size_t number[SAMPLE], n = stream->facets.vertices;

    s->vertices = n < SAMPLE ? n : SAMPLE;
    for (size_t i = 0; i < s->vertices; i++)
        number[i] = i * n / s->vertices;
    grid_facets_numbered(&stream->facets, number, s->vertices, s->row, s->column);
    for (size_t i = 0; i < s->vertices; i++)
        for (int k = 0; k < 7; k++) {
            const struct node_choice *c =
                reposition_node(&stream->nodes, s->column[i] + RIGHT[k], s->row[i] + UP[k]);
            if (c)
                mark_around(s, c->at,
                            (k == 0 ? FARTHEST : NEAR) * stream->mean + stream->options.spacing);
        }
}

static void see_sample(void *context, const struct vec3 *point, size_t n)
{
    struct sample *s = context;

    for (size_t i = 0; i < n; i++)
        if (s->mark[point_grid_cell(s->cells, point[i])])
            *array_push(&s->point) = point[i];
}

static double measure_noise(const struct sample *s, const struct point_grid *scan, int threads)
{
    uint32_t place[NOISE_PLACES];

    for (size_t i = 0; i < s->places; i++) {
        uint32_t cell = s->place[i].cell, last = scan->first[cell + 1] - 1;
        place[i] = scan->first[cell] + s->place[i].rank;
        place[i] = place[i] < last ? place[i] : last; /* some may have been there twice */
    }
    struct noise noise = noise_measure_at(scan, place, s->places, threads);
    return noise.even > 0 ? noise.even : noise.sigma;
}

/* A vertex of the sample at its node, and the normal of the facets about it. */
static void sample_vertex(const struct work *w, const struct point_grid *scan, int row, int column,
                          double noise, struct vec3 *place, struct vec3 *normal)
{
    const struct reposition *nodes = &w->stream->nodes;
    int low = row > 2 ? row - 2 : 0, left = column > 2 ? column - 2 : 0;
    int high = row + 2 < nodes->grid.rows ? row + 2 : nodes->grid.rows - 1;
    struct mesh mesh = {.origin = {.ledger = NAN, .noise = noise}};

    grid_facets_part(&w->stream->facets, low, high, left, column + 2, &mesh);
    free(stand_at_nodes(w, scan, &mesh));
    mesh_normals_facet(&mesh);
    for (size_t v = 0; v < mesh.vertex.n; v++)
        if (mesh.row.item[v] == row && mesh.col.item[v] == column) {
            *place = mesh.vertex.item[v];
            *normal = mesh.normal.item[v];
        }
    mesh_free(&mesh);
}

static void choose_rule(struct work *w, const struct sample *s, const struct point_grid *scan,
                        double noise)
{
    const struct cloudmesh_options *o = &w->stream->options;
    struct smooth_nodes_options options = {w->sigma, (size_t)o->neighbours, o->effort,
                                           w->stream->threads, false};
    struct vec3 place[SAMPLE], normal[SAMPLE];

    for (size_t i = 0; i < s->vertices && o->neighbours == 0; i++)
        sample_vertex(w, scan, s->row[i], s->column[i], noise, &place[i], &normal[i]);
    w->rule = smooth_nodes_rule(scan, &options, w->stream->facets.vertices, place, normal,
                                s->vertices, &w->smooth);
}

/* The noise, and with it how surfaces are fitted. */
static int look_at_sample(struct work *w, double asked, struct error *error)
{
    struct cloud_stream *stream = w->stream;
    const struct point_grid *cells = &w->counts->cells;
    struct sample *s = mem_alloc(1, sizeof *s);
    struct point_grid scan = {.first = NULL};

    s->cells = cells;
    s->mark = mem_alloc(cells->columns * cells->rows, 1);
    choose_places(s, w->counts->of_cell, stream->n);
    choose_vertices(s, stream);
    int status = cloud_stream_look(stream, see_sample, s, error);
    if (status == 0)
        status = sort_points(w, &s->point, &scan, error);
    if (status == 0) {
        double measured = measure_noise(s, &scan, stream->threads);
        note("noise of the scan %.4f mm (one standard deviation)", measured);
        stream->noise = asked >= 0 ? asked : measured;
        w->sigma = cloud_prepare_noise(asked, measured, stream->mean);
        if (w->sigma > 0)
            choose_rule(w, s, &scan, stream->noise);
    }
    point_grid_free(&scan);
    array_free(&s->point);
    free(s->mark);
    free(s);
    return status;
}

/* ---- bands */

/* How far from a vertex its surface is looked for: with noise, as far as four times as many points
 * are at a corner as surfaces begin with, and a tenth more. */
static double far_of(const struct work *w)
{
    double corner = sqrt(4 * 4 * (double)w->rule.neighbours / PI);

    return w->sigma > 0 ? fmin(1.1 * corner, FARTHEST) : FAR;
}

static struct stream_bands bands_of(const struct work *w)
{
    const struct grid *g = &w->stream->nodes.grid;
    int about = MARGIN - 1 + (int)ceil(far_of(w) * w->stream->mean / (g->t * GRID_SLANT)) + 1;

    return stream_bands_of(g, w->counts->of_row, about, w->at_a_time);
}

/* The mesh of a band and of the rows beside it, its vertices where no band has moved them. */
static void mesh_band(struct work *w, const struct stream_band *b)
{
    const struct grid *grid = &w->stream->nodes.grid;
    struct mesh *mesh = &w->mesh;
    int low = b->first > MARGIN ? b->first - MARGIN : 0, end = grid->rows - 1;

    mesh->vertex.n = mesh->row.n = mesh->col.n = mesh->face.n = mesh->normal.n = 0;
    grid_facets_part(&w->stream->facets, low, b->last + MARGIN < end ? b->last + MARGIN : end, 0,
                     grid->columns - 1, mesh);
    if (w->before.n > 0)
        memcpy(mesh->vertex.item, w->before.item, w->before.n * sizeof *mesh->vertex.item);
    w->before.n = 0;
    for (size_t v = 0; v < mesh->vertex.n; v++)
        if (mesh->row.item[v] > b->last - MARGIN && mesh->row.item[v] <= b->last)
            *array_push(&w->before) = mesh->vertex.item[v];
}

/* Normals and curvatures, and with noise the vertices on the surface.  off[]: of each, how far it
 * is off the quadric, or was moved. */
static void fit_band(struct work *w, const struct point_grid *scan, size_t from, size_t to,
                     double *off)
{
    struct mesh *mesh = &w->mesh;
    const struct cloudmesh_options *o = &w->stream->options;
    int threads = w->stream->threads;
    double *certain = stand_at_nodes(w, scan, mesh);

    if (w->sigma > 0) {
        double *variance = mem_alloc(mesh->vertex.n, sizeof *variance), far = w->smooth.farthest;
        w->rule.point_grid = scan;
        mesh_normals_facet(mesh);
        smooth_nodes_fit(mesh, &w->rule, threads, variance, off);
        smooth_nodes_count(variance + from, off + from, to - from, from, &w->smooth, &w->variance);
        if (w->smooth.farthest > far)
            w->farthest = mesh->vertex.item[w->smooth.at];
        free(variance);
    } else {
        struct scan_normals_options how = {o->neighbours ? o->neighbours : NORMALS_NEIGHBOURS,
                                           threads, certain};
        scan_normals_fit(mesh, scan, &how, off);
    }
    free(certain);
    mesh_normals_seen(mesh);
}

static int32_t nine_digits(double x)
{
    int64_t integer = 0;

    num_scaled(x, 9, &integer);
    return (int32_t)(x < 0 ? -integer : integer);
}

static void keep_vertex(struct work *w, size_t v, double off)
{
    const struct mesh *mesh = &w->mesh;
    const struct vec3 *normal = &mesh->normal.item[v];
    struct stream_vertex *to = &w->stream->vertex[w->next++];

    to->normal[0] = nine_digits(normal->x);
    to->normal[1] = nine_digits(normal->y);
    to->normal[2] = nine_digits(normal->z);
    to->kmax = mesh->kmax.item[v];
    to->off = (float)off;
    reposition_move(&w->stream->nodes, mesh->col.item[v], mesh->row.item[v], mesh->vertex.item[v]);
}

static int do_band(struct work *w, struct stream_bands *bands, size_t k, struct error *error)
{
    const struct stream_band *b = &bands->item[k];
    struct point_grid scan = {.first = NULL};

    w->point.n = 0;
    if (stream_bands_points(bands, k, w->stream, &w->point, error) < 0 ||
        sort_points(w, &w->point, &scan, error) < 0)
        return -1;
    mesh_band(w, b);
    const struct mesh *mesh = &w->mesh;
    size_t from = 0, to = mesh->vertex.n;
    while (from < to && mesh->row.item[from] < b->first)
        from++;
    while (to > from && mesh->row.item[to - 1] > b->last)
        to--;
    double *off = mem_alloc(mesh->vertex.n, sizeof *off);
    fit_band(w, &scan, from, to, off);
    for (size_t v = from; v < to; v++)
        keep_vertex(w, v, off[v]);
    free(off);
    point_grid_free(&scan);
    return 0;
}

static int look_at_bands(struct work *w, struct error *error)
{
    w->mesh.origin = (struct mesh_origin){.ledger = NAN, .noise = w->stream->noise};
    struct stream_bands bands = bands_of(w);
    int status = 0;

    for (size_t k = 0; k < bands.n && status == 0; k++)
        status = do_band(w, &bands, k, error);
    note("points in memory for %zu band%s of rows, one after the other", bands.n,
         bands.n == 1 ? "" : "s");
    stream_bands_free(&bands);
    return status;
}

/* ---- what is said of all */

static double say_normals(const struct work *w)
{
    struct cloud_stream *s = w->stream;
    size_t n = s->facets.vertices;
    double *off = mem_alloc(n, sizeof *off);

    for (size_t i = 0; i < n; i++)
        off[i] = s->vertex[i].off;
    struct scan_normals r = scan_normals_summary(off, n);
    free(off);
    say_fitted(&r, n, grid_facets_vertex(&s->facets, r.at));
    return r.sigma;
}

static double say_moved(struct work *w)
{
    const struct cloudmesh_options *o = &w->stream->options;
    struct normals_options said = {.noise = w->sigma, .effort = o->effort};
    struct smooth_nodes *r = &w->smooth;

    r->error = r->moved > 0 ? w->sigma * sqrt(w->variance / (double)r->moved) : 0;
    say_smoothed(r, w->stream->facets.vertices, w->farthest, &said);
    return r->error;
}

size_t cloud_stream_at_a_time(const struct cloud_stream *s)
{
    const size_t least = 1 << 21;
    size_t some = s->facets.vertices / 5 * 2;

    return some > least ? some : least;
}

int cloud_stream_surface(struct cloud_stream *s, double noise, size_t at_a_time,
                         struct error *error)
{
    struct work w = {.stream = s, .counts = s->counts, .at_a_time = at_a_time};

    int status = look_at_sample(&w, noise, error);
    if (status == 0) {
        s->vertex = mem_alloc(s->facets.vertices, sizeof *s->vertex);
        free(w.counts->of_cell);
        w.counts->of_cell = NULL;
        status = look_at_bands(&w, error);
    }
    array_free(&w.before);
    array_free(&w.point);
    mesh_free(&w.mesh);
    if (status < 0)
        cloud_stream_free(s);
    else
        s->ledger = LEDGER_SIGMAS * (w.sigma > 0 ? say_moved(&w) : say_normals(&w));
    return status;
}
