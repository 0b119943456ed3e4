/* guard_points - see guard_points.h. */
#include "gouge/guard_points.h"

#include <stdlib.h>

#include "base/effort.h"
#include "base/parallel.h"
#include "cloud/edge_points.h"
#include "cloud/scan_lines.h"
#include "cloud/settle.h"
#include "cloud/upsample.h"
#include "curve/edge_curve.h"
#include "mesh/mesh_edges.h"
#include "math/surface_fit.h"
#include "mesh/mesh_weld.h"

enum { GUESS = 16, SAMPLE = 1500, FEWEST = 56 };

/* Noises that a point may be off its surface: of ten thousand one is off five, and the noise itself
 * is known within a tenth. */
static const double FAR = 6;

/* Of its reach: so far about the middle of a neighbourhood its surface counts for other points, as
 * long as it is certain to this part of the noise. */
static const double MIDDLE = 0.4, CERTAIN = 0.35;

/* Of the noise: a surface less certain than this at its own place, as at a border, is doubtful; and
 * so is one whose slope may be off (two standard deviations) by what sinks the ball in so far. */
static const double DOUBTFUL = 0.3, SUNK = 0.3;

/* Of the noise: where the surface through few neighbours is further off the one through many, shape
 * may have been smoothed over, and it is kept clear of, too. */
static const double DIFFERENT = 1;

/* What becomes of a point. */
struct point_result {
    struct vec3 point;
    bool moved, doubtful;
    struct vec3s between;
    double vague; /* how far the points are off the surface of these, mm */
};

struct guard_work {
    const struct guard_points_options *rule;
    const struct point_grid *point_grid;
    struct surface_fit_options fit; /* sigma: noise to take out; 0: none */
    struct upsample fill;
    bool filled;
    struct point_result *result;
};

/* A rough normal from the points about a place. */
static struct vec3 guess_normal(const struct point_grid *b, struct vec3 place)
{
    struct vec3 near[GUESS];
    size_t n = point_grid_near(b, place, GUESS, near);
    struct vec3 normal = plane_normal(near, n);
    return normal.z < 0 ? vec_scale(-1, normal) : normal;
}

/* A ball put on along a normal that is off by e sinks in by e^2 / (2 (1 / R - k)). */
static bool is_doubtful(const struct guard_work *work, const struct surface_fit *fit)
{
    double radius = work->rule->radius, sigma = work->fit.sigma;
    double fits = fmax(1 / radius - quadric_curvature(&fit->q), 0.05 / radius);

    return fit->q.variance > DOUBTFUL * DOUBTFUL ||
           2 * sigma * sigma * fit->q.tilt / fits > SUNK * sigma;
}

/* Brings a point to a surface; false when noise alone does not explain where it is. */
static bool move_to_surface(const struct guard_work *work, const struct surface_fit *fit, size_t i)
{
    struct vec3 p = work->point_grid->point[i], foot = quadric_nearest(&fit->q, p);
    struct point_result *result = &work->result[i];

    if (!surface_fit_holds(fit, work->fit.sigma) || vec_distance(p, foot) > FAR * work->fit.sigma)
        return false;
    *result =
        (struct point_result){.point = foot, .moved = true, .doubtful = is_doubtful(work, fit)};
    if (work->filled)
        upsample_on(&work->fill, i, foot, &fit->q, fit->spread, &result->between);
    return true;
}

/* How far from its middle a surface counts. */
static double valid_range(const struct surface_fit *fit)
{
    double spare = CERTAIN * CERTAIN - fit->q.variance;

    return spare > 0 ? fmin(MIDDLE * fit->reach, sqrt(spare / fit->q.tilt)) : 0;
}

/* The point of [from, to) nearest to the middle of those not done; `to` when all are. */
static size_t find_middle(const struct vec3 *point, const bool *done, size_t from, size_t to)
{
    struct vec3 sum = vec(0, 0, 0);
    double count = 0, nearest = HUGE_VAL;
    size_t middle = to;

    for (size_t i = from; i < to; i++) {
        if (!done[i - from]) {
            sum = vec_add(sum, point[i]);
            count++;
        }
    }
    for (size_t i = from; i < to; i++) {
        double distance = vec_distance(point[i], vec_scale(1 / count, sum));
        if (!done[i - from] && distance < nearest) {
            nearest = distance;
            middle = i;
        }
    }
    return middle;
}

/* The points of a cell: a surface about the middle one of those that are left serves those near to
 * it, until none is left. */
static void fit_cell(const struct guard_work *work, size_t from, size_t to,
                     struct surface_fit_hood *hood)
{
    const struct vec3 *point = work->point_grid->point;
    bool *done = mem_alloc(to - from + 1, sizeof *done);

    for (size_t i = from; i < to; i++)
        done[i - from] = false;
    for (;;) {
        struct surface_fit fit;
        size_t middle = find_middle(point, done, from, to);
        if (middle == to)
            break;
        done[middle - from] = true;
        bool fitted = surface_fit_at(&work->fit, point[middle],
                                     guess_normal(work->point_grid, point[middle]), hood, &fit);
        if (!(fitted && move_to_surface(work, &fit, middle)) && work->filled)
            upsample_about(&work->fill, middle, &work->result[middle].between);
        double range = fitted ? valid_range(&fit) : 0;
        for (size_t i = from; i < to; i++)
            if (!done[i - from] && vec_distance(point[i], point[middle]) < range &&
                move_to_surface(work, &fit, i))
                done[i - from] = true;
    }
    free(done);
}

static void fit_cells(void *context, size_t from, size_t to)
{
    const struct guard_work *work = context;
    struct surface_fit_hood *hood = surface_fit_hood_new();

    for (size_t cell = from; cell < to; cell++)
        fit_cell(work, work->point_grid->first[cell], work->point_grid->first[cell + 1], hood);
    surface_fit_hood_free(hood);
}

/* How many points to begin with, from a sample of them; there is a surface for each cell.  *near:
 * as in the header. */
static size_t neighbours_of(const struct guard_work *work, size_t *near)
{
    const struct point_grid *b = work->point_grid;
    size_t some = b->n < SAMPLE ? b->n : SAMPLE;
    struct vec3s place = {0}, guess = {0};

    for (size_t i = 0; i < some; i++) {
        *array_push(&place) = b->point[i * b->n / some];
        *array_push(&guess) = guess_normal(b, place.item[i]);
    }
    size_t neighbours =
        surface_fit_typical(&work->fit, place.item, guess.item, some, work->rule->threads);
    array_free(&place);
    array_free(&guess);
    size_t cells = b->columns * b->rows;
    double most = (double)effort_most(EFFORT_GUARD_NEAR, work->rule->effort) / (double)cells;
    double affordable = fmax(most, FEWEST);
    if ((double)neighbours <= affordable)
        return neighbours;
    *near = neighbours * cells;
    return (size_t)affordable;
}

static void fill_gaps(void *context, size_t from, size_t to)
{
    const struct guard_work *work = context;

    for (size_t i = from; i < to; i++)
        work->result[i].vague = upsample_about(&work->fill, i, &work->result[i].between);
}

/* What there is to be done; false: nothing.  *sparse, *near: as in the header. */
static bool choose_work(struct guard_work *work, bool *sparse, size_t *near)
{
    const struct guard_points_options *rule = work->rule;
    const struct point_grid *b = work->point_grid;

    work->fit = (struct surface_fit_options){b, rule->noise, 0,
                                             effort_covers(EFFORT_ALONG, rule->effort, b->n)};
    work->fill = (struct upsample){b, rule->radius, rule->sink, rule->noise, scan_lines_found(b)};
    *sparse = upsample_needed(&work->fill);
    work->filled = *sparse && effort_covers(EFFORT_GUARD_BETWEEN, rule->effort, b->n);
    if (rule->noise > 0)
        work->fit.neighbours = neighbours_of(work, near);
    return rule->noise > 0 || work->filled;
}

static void add_near_surface(void *context, size_t from, size_t to)
{
    const struct guard_work *work = context;

    for (size_t i = from; i < to; i++) {
        double sigma = work->fit.sigma;
        struct vec3 near = settle_point(work->point_grid, sigma, work->point_grid->point[i]);
        if (vec_distance(near, work->result[i].point) > DIFFERENT * sigma)
            *array_push(&work->result[i].between) = near;
    }
}

static struct guard_points gather(struct guard_work *work)
{
    const struct point_grid *b = work->point_grid;
    struct guard_points surface = {.moved = 0};

    for (size_t i = 0; i < b->n; i++) {
        struct point_result *result = &work->result[i];
        *array_push(&surface.point) = result->point;
        *array_push(result->doubtful ? &surface.doubtful : &surface.certain) = result->point;
        surface.moved += result->moved;
        surface.vague += result->vague > work->rule->vague;
        if (result->vague > surface.worst) {
            surface.worst = result->vague;
            surface.at = result->point;
        }
        surface.added += result->between.n;
        for (size_t k = 0; k < result->between.n; k++)
            *array_push(&surface.point) = result->between.item[k];
        array_free(&result->between);
    }
    return surface;
}

/* Sharp edges that the scan has no points on. */
static void add_edges(const struct guard_work *work, struct guard_points *surface)
{
    const struct guard_points_options *rule = work->rule;
    struct edge_points_options edges = {.point_grid = work->point_grid,
                                        .noise = rule->noise,
                                        .along = sqrt(8 * rule->radius * rule->sink),
                                        .sink = rule->sink,
                                        /* flanks of few points are as rough as these */
                                        .fill = work->filled && rule->noise == 0,
                                        .threads = rule->threads};
    size_t before = surface->point.n;

    surface->edges = edge_points(&edges, &surface->point, &surface->gaps);
    surface->added += surface->point.n - before - surface->edges;
}

struct guard_points guard_points_of_scan(const struct point_grid *point_grid,
                                         const struct guard_points_options *rule)
{
    struct guard_work work = {.rule = rule, .point_grid = point_grid};
    struct guard_points surface = {.moved = 0};
    bool sparse;
    size_t near = 0;

    if (!choose_work(&work, &sparse, &near)) {
        add_edges(&work, &surface);
        surface.sparse = sparse;
        array_reserve(&surface.point, point_grid->n);
        for (size_t i = 0; i < point_grid->n; i++)
            *array_push(&surface.point) = *array_push(&surface.certain) = point_grid->point[i];
        return surface;
    }
    work.result = mem_alloc(point_grid->n, sizeof *work.result);
    for (size_t i = 0; i < point_grid->n; i++)
        work.result[i] = (struct point_result){.point = point_grid->point[i]};
    if (work.fit.sigma > 0) {
        parallel_for(rule->threads, point_grid->columns * point_grid->rows, fit_cells, &work);
        parallel_for(rule->threads, point_grid->n, add_near_surface, &work);
    } else {
        parallel_for(rule->threads, point_grid->n, fill_gaps, &work);
    }
    surface = gather(&work);
    add_edges(&work, &surface);
    surface.sparse = sparse;
    surface.near = near;
    free(work.result);
    return surface;
}

/* ---- the points of a mesh */

/* A facet further than this off a vertex's normal spans a step, not a smooth surface. */
static const double SMOOTH = 0.8660254037844386; /* cos 30 degrees */

/* A curved triangle: control points of a cubic Bezier triangle, named after their corners. */
struct patch {
    struct vec3 corner[3];
    struct vec3 edge[3][2]; /* edge[i]: from corner i to the next, nearer to i first */
    struct vec3 middle;
    bool flat;
    bool shared[3]; /* the edge is sampled with the patch on its other side */
};

static struct patch patch_of(const struct vec3 *p, const struct vec3 *normal, bool flat)
{
    struct patch patch = {.flat = flat};
    struct vec3 corners = vec(0, 0, 0), edges = vec(0, 0, 0);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        patch.corner[i] = p[i];
        patch.edge[i][0] = flat ? vec_mix(p[i], p[j], 1 / 3.0) : edge_handle(p[i], normal[i], p[j]);
        patch.edge[i][1] = flat ? vec_mix(p[j], p[i], 1 / 3.0) : edge_handle(p[j], normal[j], p[i]);
        corners = vec_add(corners, p[i]);
        edges = vec_add(edges, vec_add(patch.edge[i][0], patch.edge[i][1]));
    }
    /* E + (E - V) / 2: the patch holds a quadratic surface exactly. */
    patch.middle = vec_along(vec_scale(0.25, edges), -1 / 6.0, corners);
    return patch;
}

/* The point with barycentric coordinates b[0..2]. */
static struct vec3 patch_at(const struct patch *patch, const double b[3])
{
    struct vec3 sum = vec_scale(6 * b[0] * b[1] * b[2], patch->middle);

    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        sum = vec_along(sum, b[i] * b[i] * b[i], patch->corner[i]);
        sum = vec_along(sum, 3 * b[i] * b[i] * b[j], patch->edge[i][0]);
        sum = vec_along(sum, 3 * b[i] * b[j] * b[j], patch->edge[i][1]);
    }
    return sum;
}

/* How a patch is sampled: on a triangular raster; a slender one on rows along its longest edge,
 * each with points of its own number. */
struct raster {
    int cells;   /* along the longest edge */
    int rows;    /* 0: as many as cells */
    int longest; /* edge from this corner on */
    double length, spacing;
};

static struct raster raster_of(const struct patch *patch, double spacing)
{
    const double most = 100000, slender = 0.25;
    struct raster r = {.spacing = spacing};

    for (int i = 0; i < 3; i++) {
        double length = vec_distance(patch->corner[i], patch->corner[(i + 1) % 3]);
        if (length > r.length) {
            r.length = length;
            r.longest = i;
        }
    }
    r.cells = (int)fmin(ceil(r.length / spacing), most);
    double height = vec_line_distance(patch->corner[r.longest], patch->corner[(r.longest + 1) % 3],
                                      patch->corner[(r.longest + 2) % 3]);
    if (height < slender * r.length)
        r.rows = (int)fmax(1, fmin(ceil(height / spacing), most));
    return r;
}

/* Cells of one row of a slender patch, of those from 0 on its longest edge. */
static int cells_of_row(const struct raster *r, int row)
{
    double length = r->length * (1 - (double)row / r->rows);

    return (int)fmax(1, fmin(ceil(length / r->spacing), r->cells));
}

static double raster_count(const struct raster *r)
{
    double sum = 0;

    if (r->rows == 0)
        return (r->cells + 1.0) * (r->cells + 2.0) / 2 - 3;
    for (int i = 0; i < r->rows; i++)
        sum += cells_of_row(r, i) + 1.0;
    return sum - 2;
}

/* The place with these barycentric coordinates, unless another patch has it. */
static void sample_at(const struct patch *patch, const double b[3], struct vec3s *points)
{
    for (int i = 0; i < 3; i++) {
        if (b[i] <= 0 && patch->shared[(i + 1) % 3])
            return;
    }
    *array_push(points) = patch_at(patch, b);
}

static void sample_rows(const struct patch *patch, const struct raster *r, struct vec3s *points)
{
    for (int i = 0; i < r->rows; i++) {
        int cells = cells_of_row(r, i);
        double up = (double)i / r->rows;
        for (int j = i == 0; j <= cells - (i == 0); j++) {
            double b[3], along = (double)j / cells;
            b[r->longest] = (1 - up) * (1 - along);
            b[(r->longest + 1) % 3] = (1 - up) * along;
            b[(r->longest + 2) % 3] = up;
            sample_at(patch, b, points);
        }
    }
}

/* All points of the patch but its corners and shared edges, no further apart than the raster says.
 */
static void patch_sample(const struct patch *patch, const struct raster *r, struct vec3s *points)
{
    int cells = r->cells;

    if (r->rows > 0) {
        sample_rows(patch, r, points);
        return;
    }
    for (int i = 0; i <= cells; i++) {
        for (int j = 0; j <= cells - i; j++) {
            int k = cells - i - j;
            if (i == cells || j == cells || k == cells)
                continue;
            double b[3] = {(double)i / cells, (double)j / cells, (double)k / cells};
            sample_at(patch, b, points);
        }
    }
}

static bool is_flat(const struct mesh *mesh, size_t facet)
{
    struct vec3 across = vec_unit(mesh_face_cross(mesh, facet));
    bool flat = false;

    for (int i = 0; i < 3; i++)
        flat = flat || vec_dot(mesh->normal.item[mesh->face.item[facet].v[i]], across) < SMOOTH;
    return flat;
}

static struct patch patch_of_facet(const struct mesh *mesh, size_t facet)
{
    struct vec3 p[3], normal[3];

    for (int i = 0; i < 3; i++) {
        int v = mesh->face.item[facet].v[i];
        p[i] = mesh->vertex.item[v];
        normal[i] = mesh->normal.item[v];
    }
    return patch_of(p, normal, is_flat(mesh, facet));
}

/* The raster of a facet's patch, for which its corners are enough. */
static struct raster raster_of_facet(const struct mesh *mesh, size_t facet, double spacing)
{
    struct patch patch = {.edge = {{{0}}}};

    for (int i = 0; i < 3; i++)
        patch.corner[i] = mesh->vertex.item[mesh->face.item[facet].v[i]];
    return raster_of(&patch, spacing);
}

/* How many points the facets have beside their corners. */
static double count_of_mesh(const struct mesh *mesh, double spacing)
{
    double sum = 0;

    for (size_t f = 0; f < mesh->face.n; f++) {
        struct raster raster = raster_of_facet(mesh, f, spacing);
        sum += raster_count(&raster);
    }
    return sum;
}

/* A facet has points along that edge of it: a slender one has rows along its longest alone, and one
 * that is sampled flat has edges of its own. */
static bool has_points_along(const struct mesh *mesh, const struct mesh_edges *edges, int facet,
                             int edge, double spacing)
{
    struct raster raster = raster_of_facet(mesh, (size_t)facet, spacing);

    if (is_flat(mesh, (size_t)facet))
        return false;
    return raster.rows == 0 || edges->of[facet][raster.longest] == edge;
}

double guard_points_of_mesh(const struct mesh *mesh, double spacing, double most,
                            struct vec3s *points)
{
    bool *used = mem_alloc(mesh->vertex.n, sizeof *used);
    double count = count_of_mesh(mesh, spacing);

    /* A few points a facet are left, however far apart. */
    for (int i = 0; i < 20 && count > most; i++) {
        spacing *= 1.05 * sqrt(count / most);
        count = count_of_mesh(mesh, spacing);
    }
    struct mesh_edges edges = mesh_edges_find(mesh);
    for (size_t f = 0; f < mesh->face.n; f++) {
        struct patch patch = patch_of_facet(mesh, f);
        struct raster raster = raster_of(&patch, spacing);
        for (int i = 0; i < 3; i++) {
            int edge = edges.of[f][i], beyond = mesh_edge_beyond(&edges, edge, (int)f);
            patch.shared[i] = !patch.flat && beyond >= 0 && beyond < (int)f &&
                              has_points_along(mesh, &edges, beyond, edge, spacing);
            used[mesh->face.item[f].v[i]] = true;
        }
        patch_sample(&patch, &raster, points);
    }
    for (size_t v = 0; v < mesh->vertex.n; v++) {
        if (used[v])
            *array_push(points) = mesh->vertex.item[v];
    }
    mesh_edges_free(&edges);
    free(used);
    return spacing;
}

/* ---- the sharp edges of a mesh */

/* The edge of a facet from its corner i on, by the first vertices at its ends, the smaller first.
 */
struct side {
    size_t end[2];
    size_t facet;
    int i;
};

struct sides {
    size_t n, cap;
    struct side *item;
};

static int compare_sides(const void *pa, const void *pb)
{
    const struct side *a = pa, *b = pb;

    for (int k = 0; k < 2; k++)
        if (a->end[k] != b->end[k])
            return a->end[k] < b->end[k] ? -1 : 1;
    return (a->facet > b->facet) - (a->facet < b->facet);
}

static bool same_ends(const struct side *a, const struct side *b)
{
    return a->end[0] == b->end[0] && a->end[1] == b->end[1];
}

/* Those with an end where several vertices are, in order. */
static struct sides find_sides(const struct mesh *mesh)
{
    struct sides sides = {0};
    size_t *first = mesh_first_at_place(mesh), n = mesh->vertex.n;
    bool *shared = mem_alloc(n, sizeof *shared);

    for (size_t v = 0; v < n; v++)
        shared[v] = false;
    for (size_t v = 0; v < n; v++)
        shared[first[v]] = shared[first[v]] || first[v] != v;
    for (size_t f = 0; f < mesh->face.n; f++)
        for (int i = 0; i < 3; i++) {
            const int *v = mesh->face.item[f].v;
            size_t a = first[v[i]], b = first[v[(i + 1) % 3]];
            if (shared[a] || shared[b])
                *array_push(&sides) = (struct side){{a < b ? a : b, a < b ? b : a}, f, i};
        }
    free(first);
    free(shared);
    if (sides.n > 0)
        qsort(sides.item, sides.n, sizeof *sides.item, compare_sides);
    return sides;
}

/* The two facets meet at the edge by its place alone, each with vertices of its own. */
static bool share_no_edge(const struct mesh *mesh, const struct side *a, const struct side *b)
{
    const int *v = mesh->face.item[a->facet].v, *w = mesh->face.item[b->facet].v;
    int from = v[a->i], to = v[(a->i + 1) % 3];

    return from != w[(b->i + 1) % 3] || to != w[b->i];
}

/* The corner of b off the edge lies below the plane of a. */
static bool is_convex_from(const struct mesh *mesh, const struct side *a, const struct side *b)
{
    const struct vec3 *p = mesh->vertex.item;
    struct vec3 up = mesh_face_cross(mesh, a->facet);
    struct vec3 beyond = p[mesh->face.item[b->facet].v[(b->i + 2) % 3]];

    return vec_dot(up, vec_sub(beyond, p[a->end[0]])) < 0;
}

/* The points of the scan about a place of the edge lie on the planes of its two facets. */
static bool is_borne_out(const struct mesh *mesh, const struct side *a, const struct side *b,
                         const struct point_grid *scan, struct vec3 at)
{
    enum { NEAR = 8, MOST = 6 }; /* MOST: others may be on a third flank */
    const double off = 0.05;     /* of their spacing, for flanks are curved */
    struct vec3 normal[2] = {vec_unit(mesh_face_cross(mesh, a->facet)),
                             vec_unit(mesh_face_cross(mesh, b->facet))};
    uint32_t index[NEAR];
    double distance2[NEAR];
    size_t n = point_grid_nearest(scan, at, NEAR, index, distance2), on = 0;

    for (size_t k = 0; k < n; k++) {
        struct vec3 to = vec_sub(scan->point[index[k]], at);
        double h = fmin(fabs(vec_dot(normal[0], to)), fabs(vec_dot(normal[1], to)));
        on += h <= off * sqrt(PI * distance2[n - 1] / (double)n);
    }
    return on >= MOST;
}

void guard_points_of_edges(const struct mesh *mesh, double spacing, const struct point_grid *scan,
                           struct vec3s *to)
{
    struct sides sides = find_sides(mesh);

    for (size_t k = 0, end; k < sides.n; k = end) {
        const struct side *a = &sides.item[k], *b = a + 1;
        for (end = k + 1; end < sides.n && same_ends(a, &sides.item[end]);)
            end++;
        if (end != k + 2 || !share_no_edge(mesh, a, b) || !is_convex_from(mesh, a, b) ||
            !is_convex_from(mesh, b, a))
            continue;
        struct vec3 p = mesh->vertex.item[a->end[0]], q = mesh->vertex.item[a->end[1]];
        double parts = ceil(vec_distance(p, q) / spacing);
        for (double i = 0; i <= parts; i++) {
            struct vec3 at = vec_mix(p, q, i / fmax(parts, 1));
            if (!scan || is_borne_out(mesh, a, b, scan, at))
                *array_push(to) = at;
        }
    }
    array_free(&sides);
}
