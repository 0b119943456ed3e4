/* cloud_stream - see cloud_stream.h. */
#include "stage/cloud_stream.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "base/array.h"
#include "cloud/cloud.h"
#include "cloudmesh_steps.h"
#include "io/cloud/cloud_spool.h"
#include "io/mesh/ply.h"
#include "stream_bands.h"
#include "stream_surface.h"

enum { SHORT_ROW = 6 /* bytes */ };

/* One look at all points. */
struct look {
    void (*see)(struct look *look, const struct vec3 *point, size_t n); /* as placed */
    struct cloud_stream *stream;
    struct vec3s placed;
    struct vec3 from, far; /* the first point, and the farthest from it seen from above ... */
    double most;           /* ... by this, squared */
    bool clumps, line;     /* are there no points but near those two, or on their line? */
    struct plan_cells cells;
    bool early; /* the spacing is given: nodes take their points in the look for the mean one */
    bool empty; /* there are nodes to be filled */
    const struct viewer *viewer; /* another that looks */
};

bool cloud_stream_serves(const struct cloudmesh_options *o)
{
    return o->method == CLOUDMESH_CHUI && !o->paper && !o->subdivide && !(o->error > 0) &&
           o->smooth;
}

static void take_block(void *context, const struct vec3 *point, size_t n)
{
    struct look *l = context;

    if (n == 0)
        return;
    if (!transform_is_identity(&l->stream->place)) {
        array_reserve(&l->placed, n);
        memcpy(l->placed.item, point, n * sizeof *point);
        transform_points(&l->stream->place, l->placed.item, n);
        point = l->placed.item;
    }
    l->see(l, point, n);
}

static void see_placed(void *context, const struct vec3 *point, size_t n)
{
    struct look *l = context;
    l->see(l, point, n);
}

/* Shows all points to `see`: those that are kept or, where they are too many, those in the spool
 * or, where there was no room for it, the file's.  -1: also where they are others than before. */
static int look_again(struct look *l,
                      void (*see)(struct look *look, const struct vec3 *point, size_t n),
                      struct error *error)
{
    const char *file = l->stream->file;
    struct cloud_count count;

    l->see = see;
    if (l->stream->kept.n > 0) {
        see(l, l->stream->kept.item, l->stream->kept.n);
        return 0;
    }
    if (cloud_spool_holds(l->stream->spool))
        return cloud_spool_look(l->stream->spool, see_placed, l)
                   ? 0
                   : error_at(error, file, 0, "cannot read the copy of its points: %s",
                              strerror(errno));
    if (cloud_read_blocks(file, take_block, l, l->stream->threads, &count, error) < 0)
        return -1;
    if (count.points != l->stream->n)
        return error_at(error, file, 0,
                        "%zu points, expected the %zu that were there before: it "
                        "changes while it is read",
                        count.points, l->stream->n);
    return 0;
}

struct viewer {
    void (*see)(void *context, const struct vec3 *point, size_t n);
    void *context;
};

static void show(struct look *l, const struct vec3 *point, size_t n)
{
    l->viewer->see(l->viewer->context, point, n);
}

int cloud_stream_look(struct cloud_stream *stream,
                      void (*see)(void *context, const struct vec3 *point, size_t n), void *context,
                      struct error *error)
{
    const struct viewer viewer = {see, context};
    struct look look = {.stream = stream, .viewer = &viewer};
    int status = look_again(&look, show, error);

    array_free(&look.placed);
    return status;
}

/* ---- the first look */

static double distance2_xy(struct vec3 a, struct vec3 b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

/* Keeps the points of a small file, of which reading takes longer than all else; of a larger one
 * they go into a spool. */
static void keep_block(struct cloud_stream *s, const struct vec3 *point, size_t n)
{
    if (s->kept.n == s->n && n <= s->kept.cap - s->kept.n) {
        memcpy(s->kept.item + s->kept.n, point, n * sizeof *point);
        s->kept.n += n;
        return;
    }
    if (s->kept.n == s->n) {
        s->spool = cloud_spool_new();
        cloud_spool_add(s->spool, s->kept.item, s->kept.n);
        array_free(&s->kept);
    }
    cloud_spool_add(s->spool, point, n);
}

static void see_extent(struct look *l, const struct vec3 *point, size_t n)
{
    struct cloud_stream *s = l->stream;
    double low = s->box.low.z, high = s->box.high.z, most = l->most;

    if (s->n == 0) {
        low = high = point[0].z;
        l->from = l->far = point[0];
    }
    keep_block(s, point, n);
    plan_extent_add(&s->flat, point, n);
    if (s->options.direction != 0)
        plan_extent_add(&s->turned, point, n);
    for (size_t i = 0; i < n; i++) {
        double away2 = distance2_xy(point[i], l->from);
        low = point[i].z < low ? point[i].z : low;
        high = point[i].z > high ? point[i].z : high;
        if (away2 > most) {
            most = away2;
            l->far = point[i];
        }
    }
    l->most = most;
    s->box = (struct box){{s->flat.xmin, s->flat.ymin, low}, {s->flat.xmax, s->flat.ymax, high}};
    s->n += n;
}

/* Before they are placed, for their hash. */
static void take_first(void *context, const struct vec3 *point, size_t n)
{
    struct look *l = context;

    l->stream->hash += scan_source_hash(point, n);
    take_block(context, point, n);
}

static int begin_nodes(struct cloud_stream *s, struct error *error)
{
    struct grid grid;

    if (grid_make(&s->turned, s->n, s->options.spacing, &grid, error) < 0)
        return -1;
    return reposition_begin(&grid, s->n, REACH_NEAREST, &s->nodes, error);
}

/* ---- the mean spacing, and whether there is an area */

static void see_cells(struct look *l, const struct vec3 *point, size_t n)
{
    const double near2 = 1e-6 * distance2_xy(l->from, l->far), narrow = near2;

    for (size_t i = 0; i < n && (l->clumps || l->line); i++) {
        l->clumps = l->clumps && (distance2_xy(point[i], l->from) <= near2 ||
                                  distance2_xy(point[i], l->far) <= near2);
        l->line = l->line && !(fabs(vec_orient_xy(l->from, l->far, point[i])) > narrow);
    }
    plan_cells_add(&l->cells, point, n);
    if (l->early)
        reposition_add(&l->stream->nodes, point, n);
}

static int find_spacing(struct look *l, struct error *error)
{
    struct plan_spacing spacing = plan_spacing_begin(&l->stream->turned, l->stream->n);
    double area;

    do {
        l->cells = plan_cells_begin(&l->stream->turned, l->stream->n, plan_spacing_width(&spacing));
        int status = look_again(l, see_cells, error);
        area = plan_cells_end(&l->cells);
        l->early = false;
        if (status < 0)
            return -1;
    } while (plan_spacing_next(&spacing, area));
    l->stream->mean = spacing.spacing;
    return 0;
}

/* ---- nodes */

static void see_nodes(struct look *l, const struct vec3 *point, size_t n)
{
    reposition_add(&l->stream->nodes, point, n);
}

static void see_rest(struct look *l, const struct vec3 *point, size_t n)
{
    holes_add(&l->stream->holes, point, n);
    if (l->empty)
        reposition_fill(&l->stream->nodes, point, n);
    if (l->stream->counts)
        stream_counts_add(l->stream->counts, &l->stream->nodes.grid, point, n);
}

static int find_nodes(struct look *l, struct error *error)
{
    struct cloud_stream *s = l->stream;
    double t = s->options.spacing, mean = s->mean;
    double gap = s->options.max_gap > 0 ? s->options.max_gap : 6 * mean;
    bool seen = s->nodes.choice != NULL;

    if ((!seen && begin_nodes(s, error) < 0) ||
        holes_begin(&s->flat, gap, fmax(t / 2, 1.5 * mean), &s->holes, error) < 0 ||
        (!seen && look_again(l, see_nodes, error) < 0))
        return -1;
    l->empty = reposition_empty(&s->nodes);
    if (s->options.normals->of_surface)
        s->counts = stream_counts_new(s);
    if (look_again(l, see_rest, error) < 0)
        return -1;
    holes_end(&s->holes);
    if (l->empty)
        reposition_settle(&s->nodes);
    s->facets = grid_facets_find(&s->nodes, &s->holes);
    holes_free(&s->holes);
    if (s->facets.facets == 0)
        return error_set(error, CLOUDMESH_NO_FACET, t, s->turned.xmax - s->turned.xmin,
                         s->turned.ymax - s->turned.ymin);
    return 0;
}

int cloud_stream_nodes(struct cloud_stream *s, struct error *error)
{
    struct look look = {.stream = s};

    if (!(s->options.spacing > 0))
        s->options.spacing = cloudmesh_default_spacing(s->mean);
    int status = find_nodes(&look, error);
    array_free(&look.placed);
    if (status < 0)
        cloud_stream_free(s);
    return status;
}

/* A regular file, and how many points it may have at most. */
static bool is_regular(const char *file, size_t *most)
{
    struct stat st;
    bool regular = strcmp(file, "-") != 0 && stat(file, &st) == 0 && S_ISREG(st.st_mode);

    *most = regular ? (size_t)st.st_size / SHORT_ROW + 1 : 0;
    return regular;
}

static void gather(struct look *l, const struct vec3 *point, size_t n)
{
    vec3s_add(&l->placed, point, n);
}

/* The points seem to carry no surface: 1, whoever reads the file again says what they do; of what
 * can be read but once it is said here, -1, or 0 where they do. */
static int carries_none(struct cloud_stream *s, struct error *error)
{
    struct look look = {.stream = s};
    struct error why;

    if (!s->once)
        return 1;
    int status = s->n > 0 ? look_again(&look, gather, error) : 0;
    if (status == 0 && plan_extent_check(look.placed.item, look.placed.n, &why) < 0)
        status = error_at(error, s->file, 0, "%s", why.text);
    array_free(&look.placed);
    return status;
}

static int begin(struct look *l, struct error *error)
{
    struct cloud_stream *s = l->stream;

    l->see = see_extent;
    if (cloud_read_blocks(s->file, take_first, l, s->threads, &s->count, error) < 0)
        return -1;
    cloud_spool_end(s->spool);
    if (s->once && !cloud_spool_holds(s->spool) && s->n > 0)
        return error_at(error, s->file, 0,
                        "found no room to set its points aside in TMPDIR, /var/tmp or /tmp, "
                        "expected up to 24 bytes each: it cannot be read again as a file can");
    if (s->n < 3 || distance2_xy(l->from, l->far) == 0)
        return carries_none(s, error);
    if (!(s->options.direction != 0))
        s->turned = s->flat;
    l->early = s->options.spacing > 0 && begin_nodes(s, error) == 0; /* else it is said later */
    if (find_spacing(l, error) < 0)
        return -1;
    return l->clumps || l->line ? carries_none(s, error) : 0;
}

int cloud_stream_begin(const char *file, const struct transform *place,
                       const struct cloudmesh_options *options, size_t keep, int threads,
                       struct cloud_stream *stream, struct error *error)
{
    struct look look = {.stream = stream, .clumps = true, .line = true};

    *stream = (struct cloud_stream){.options = *options,
                                    .file = file,
                                    .place = *place,
                                    .threads = threads,
                                    .flat = plan_extent_begin(0),
                                    .turned = plan_extent_begin(options->direction)};
    size_t most;
    stream->once = !is_regular(file, &most);
    if (stream->once && keep > 0)
        return 1;
    array_reserve(&stream->kept, most < keep ? most : keep);
    int status = begin(&look, error);
    array_free(&look.placed);
    if (status != 0)
        cloud_stream_free(stream);
    return status;
}

void cloud_stream_free(struct cloud_stream *stream)
{
    array_free(&stream->kept);
    cloud_spool_free(stream->spool);
    stream->spool = NULL;
    reposition_free(&stream->nodes);
    holes_free(&stream->holes);
    grid_facets_free(&stream->facets);
    stream_counts_free(stream->counts);
    stream->counts = NULL;
    free(stream->vertex);
    stream->vertex = NULL;
}

/* ---- the mesh stream */

struct writing {
    struct out *out;
    struct ply_shape shape;
    const struct stream_vertex *next; /* NULL: normals are those of the facets */
};

static void write_vertex(void *context, struct vec3 at, struct vec3 normal, int row, int column)
{
    const double unit = 1e9;
    struct writing *w = context;
    struct ply_vertex vertex = {at, normal, row, column, 0};

    if (w->next) {
        const int32_t *n = w->next->normal;
        vertex.normal = vec(n[0] / unit, n[1] / unit, n[2] / unit);
        vertex.kmax = w->next++->kmax;
    }
    ply_vertex_write(w->out, &vertex, &w->shape);
}

static void write_face(void *context, const int corner[3])
{
    const struct writing *w = context;
    ply_face_write(w->out, corner, 0, &w->shape);
}

void cloud_stream_write(struct out *out, const struct cloud_stream *stream,
                        const struct mesh_origin *origin)
{
    struct writing w = {out,
                        {.vertices = stream->facets.vertices,
                         .faces = stream->facets.facets,
                         .normals = true,
                         .kmax = stream->vertex != NULL,
                         .rows = true},
                        stream->vertex};

    ply_head_write(out, origin, &w.shape);
    grid_facets_vertices(&stream->facets, write_vertex, &w);
    grid_facets_faces(&stream->facets, write_face, &w);
}
