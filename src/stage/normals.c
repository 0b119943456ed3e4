/* normals - see normals.h. */
#include "stage/normals.h"

#include <stdio.h>
#include <string.h>

#include "base/cli.h"
#include "base/effort.h"
#include "meshing/meshing.h"

static void say_thin(size_t thin, size_t vertices)
{
    if (thin > 0)
        say("%zu of %zu vertices have too few points about them for a quadric: their normals are "
            "the facets'",
            thin, vertices);
}

void say_fitted(const struct scan_normals *r, size_t vertices, struct vec3 at)
{
    say_thin(r->thin, vertices);
    note("vertices are off their quadrics by %.4f mm at worst (at %.3f %.3f %.3f), %.4f mm rms; "
         "three sigma of the noise %.4f mm",
         r->worst, at.x, at.y, at.z, r->rms, LEDGER_SIGMAS * r->sigma);
}

/* The least and the most are of parts that had a vertex moved, if there is one. */
static void add_to(struct smoothed_parts *all, const struct smooth_nodes *r, size_t vertices,
                   const struct normals_options *o)
{
    bool first = all->moved == 0;

    if (first || r->moved > 0) {
        all->points[0] = first || r->typical < all->points[0] ? r->typical : all->points[0];
        all->points[1] = first || r->typical > all->points[1] ? r->typical : all->points[1];
        all->error[0] = first ? r->error : fmin(r->error, all->error[0]);
        all->error[1] = first ? r->error : fmax(r->error, all->error[1]);
    }
    all->n++;
    all->noise = o->noise;
    all->vertices += vertices;
    all->thin += o->explained ? 0 : r->thin;
    all->moved += r->moved;
    all->kept += r->kept;
}

void say_smoothed_parts(const struct smoothed_parts *all)
{
    char parts[40] = "", points[48], error[48];

    if (all->n == 0)
        return;
    if (all->n > 1)
        snprintf(parts, sizeof parts, "in %zu parts ", all->n);
    snprintf(points, sizeof points, all->points[0] < all->points[1] ? "%zu to %zu" : "%zu",
             all->points[0], all->points[1]);
    snprintf(error, sizeof error, all->error[0] < all->error[1] ? "%.4f to %.4f" : "%.4f",
             all->error[0], all->error[1]);
    say_thin(all->thin, all->vertices);
    say("noise %.4f mm (one standard deviation): %s%zu of %zu vertices moved onto surfaces through "
        "about %s points, to within %s mm (one standard deviation)",
        all->noise, parts, all->moved, all->vertices, points, error);
    if (all->kept > 0)
        say("%zu vertices not moved: no surface explains the points about them", all->kept);
}

void say_smoothed(const struct smooth_nodes *r, size_t vertices, struct vec3 at,
                  const struct normals_options *o)
{
    struct smoothed_parts one = {.n = 0};

    add_to(o->parts ? o->parts : &one, r, vertices, o);
    say_smoothed_parts(&one);
    if (!o->explained)
        effort_say(EFFORT_ALONG, o->effort, vertices);
    if (r->typical < r->wanted)
        effort_say(EFFORT_NEIGHBOURS, o->effort, r->wanted * vertices);
    note("moved by %.4f mm at most, to %.3f %.3f %.3f", r->farthest, at.x, at.y, at.z);
}

/* Normals of the points as they are; returns the standard deviation of the vertices. */
static double fit_points(struct mesh *mesh, const struct normals_options *o,
                         const struct point_grid *scan)
{
    int neighbours = o->neighbours ? o->neighbours : NORMALS_NEIGHBOURS;
    struct scan_normals_options how = {neighbours, o->threads, o->certain};
    struct scan_normals r = scan_normals_quadric(mesh, scan, &how);
    if (!o->silent)
        say_fitted(&r, mesh->vertex.n, mesh->vertex.item[r.at]);
    return r.sigma;
}

/* Vertices moved onto the surface, and its normals; returns their standard deviation. */
static double move_vertices(struct mesh *mesh, const struct normals_options *o,
                            const struct point_grid *scan)
{
    struct smooth_nodes_options options = {o->noise, (size_t)o->neighbours, o->effort, o->threads,
                                           o->explained};
    struct smooth_nodes r = smooth_nodes(mesh, scan, &options);
    if (!o->silent)
        say_smoothed(&r, mesh->vertex.n, mesh->vertex.item[r.at], o);
    return r.error;
}

static int of_quadrics(struct mesh *mesh, const struct normals_options *o, struct error *error)
{
    struct point_grid own = {.first = NULL};
    const struct point_grid *scan = o->scan;

    if (!scan) {
        if (point_grid_make(o->point, o->n, o->spacing, o->threads, &own, error) < 0)
            return -1;
        scan = &own;
    }
    double sigma = o->noise > 0 ? move_vertices(mesh, o, scan) : fit_points(mesh, o, scan);
    mesh->origin.ledger = LEDGER_SIGMAS * sigma;
    mesh->origin.maker = mem_string("cloud2mesh", strlen("cloud2mesh"));
    point_grid_free(&own);
    return 0;
}

static int of_facets(struct mesh *mesh, const struct normals_options *o, struct error *error)
{
    (void)o;
    (void)error;
    mesh_normals_facet(mesh);
    return 0;
}

/* The mesh's own. */
static int as_given(struct mesh *mesh, const struct normals_options *o, struct error *error)
{
    if (mesh->normal.n > 0)
        return 0;
    say("the mesh has no normals: taking the mean of the facets'");
    return of_facets(mesh, o, error);
}

static int of_neighbours(struct mesh *mesh, const struct normals_options *o, struct error *error)
{
    if (mesh->normal.n == 0)
        of_facets(mesh, o, error);
    mesh_normals_gouraud(mesh);
    return 0;
}

static int of_differences(struct mesh *mesh, const struct normals_options *o, struct error *error)
{
    (void)o;
    return mesh_normals_central(mesh, error);
}

/* As of paper 1: the mean of the facets' normals is eq 8, that of the neighbours' eq 7. */
static const struct normal_estimator estimators[] = {
    {"mesh", false, true, false, as_given},          {"quadric", true, false, true, of_quadrics},
    {"facet", true, true, false, of_facets},         {"gouraud", false, true, false, of_neighbours},
    {"central", false, true, false, of_differences},
};

enum { ESTIMATORS = sizeof estimators / sizeof *estimators };

static bool tool_has(const struct normal_estimator *e, bool of_scan)
{
    return of_scan ? e->of_scan : e->of_mesh;
}

const char *normals_words(bool of_scan)
{
    static char words[2][20 * ESTIMATORS];
    char *to = words[of_scan];
    int n = 0;

    to[0] = '\0';
    for (int i = 0; i < ESTIMATORS; i++)
        if (tool_has(&estimators[i], of_scan))
            n += snprintf(to + n, sizeof *words - (size_t)n, "%s%s", n > 0 ? "|" : "",
                          estimators[i].name);
    return to;
}

const struct normal_estimator *normals_find(bool of_scan, int k)
{
    for (int i = 0; i < ESTIMATORS; i++)
        if (tool_has(&estimators[i], of_scan) && k-- == 0)
            return &estimators[i];
    return NULL;
}

const struct normal_estimator *normals_of(const char *name)
{
    int i = 0;

    while (i < ESTIMATORS - 1 && strcmp(estimators[i].name, name) != 0)
        i++;
    return &estimators[i];
}
