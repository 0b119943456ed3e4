/* guard_read - see guard_read.h. */
#include "guard_read.h"

#include <stdlib.h>
#include <string.h>

#include "base/effort.h"
#include "base/reader.h"
#include "io/cloud/cloud.h"
#include "io/mesh/meshfile.h"
#include "mesh/mesh_repair.h"
#include "cloud/plan_extent.h"
#include "cloud/believed.h"
#include "cloud/rim_points.h"
#include "cloud/roof.h"
#include "gouge/guard_mesh.h"
#include "gouge/guard_points.h"
#include "cloud/outliers.h"
#include "math/box.h"
#include "math/kdtree.h"
#include "math/triangle_points.h"
#include "stage/cloud_prepare.h"

/* Of the radius: points that hang down are so far apart. */
static const double CURTAIN = 0.25;

/* Points on the facets of a mesh: so far apart, by the radius; so many at most; close ones let a
 * ball sink by so much, mm. */
static const double FACETS = 0.25, MOST_OF_FACETS = 1e6, MOST_CLOSE = 4e6, SINK = 0.002;

/* Appends a file's points; says what was left out of them. */
static int read_file(const char *name, struct vec3s *points, struct error *error)
{
    struct cloud_count count = {0};
    size_t from = points->n;

    if (cloud_read(name, 1, points, &count, error) != 0)
        return -1;
    if (points->n == from)
        return error_at(error, name, 0, "found no points");
    if (count.not_finite > 0)
        say("%s: %zu rows without finite numbers left out, the first in line %zu", name,
            count.not_finite, count.first_not_finite);
    say_no_data(name, &count);
    if (count.facets > 0 && reader_reads_once(name))
        say("%s: a mesh that is piped in: only the corners of its %zu facets guard", name,
            count.facets);
    return 0;
}

/* Points on those facets that have a side longer than the spacing. */
static void fill_facets(const struct mesh *mesh, double spacing, struct vec3s *points)
{
    for (size_t i = 0; i < mesh->face.n; i++) {
        struct vec3 corner[3];
        for (int k = 0; k < 3; k++)
            corner[k] = mesh->vertex.item[mesh->face.item[i].v[k]];
        if (triangle_longest(corner) > spacing)
            triangle_points(corner, spacing, points);
    }
}

/* Close points of its facets, so that a ball of this radius sinks by little; not of so many that
 * they are no guard. */
static void fill_closely(const struct mesh *mesh, double area, double radius, struct vec3s *points)
{
    const double part = 0.65; /* triangle_points.h */

    fill_facets(mesh, fmax(sqrt(2 * radius * SINK) / part, sqrt(2 * area / MOST_CLOSE)), points);
}

/* Some piece of it has a border; what it takes to know spoils its vertices. */
static bool has_border(struct mesh *mesh)
{
    struct mesh_repair_report report = mesh_repair(mesh, vec(0, 0, 1), 1);

    return report.closed < report.sheets;
}

/* What is between the corners of a mesh, where these are far from each other for a ball of this
 * radius: points of its facets, placed as the corners are. */
static int add_facets(const char *name, double radius, struct guard_scan *scan, struct error *error)
{
    struct mesh mesh;
    size_t before = scan->point.n;

    if (!(radius > 0) || reader_reads_once(name) || !mesh_is_there(name))
        return 0;
    if (mesh_read(name, &mesh, error) != 0)
        return -1;
    if (scan->source.placed)
        transform_points(&scan->source.place, mesh.vertex.item, mesh.vertex.n);
    double area = mesh_area(&mesh);
    double spacing = fmax(FACETS * radius, sqrt(2 * area / MOST_OF_FACETS));
    fill_facets(&mesh, spacing, &scan->point);
    fill_closely(&mesh, area, radius, &scan->facet);
    scan->meshes++;
    scan->open += has_border(&mesh);
    if (scan->point.n > before)
        say("%s: a mesh: guarded by %zu points on its facets, too, %.3g mm apart at most", name,
            scan->point.n - before, spacing);
    mesh_free(&mesh);
    return 0;
}

/* The files of -g. */
static int read_given(const struct cli_list *files, struct guard_scan *scan, struct error *error)
{
    for (size_t f = 0; f < files->n; f++) {
        size_t from = scan->point.n;
        if (read_file(files->item[f], &scan->point, error) != 0)
            return -1;
        scan_sources_add(&scan->source, files->item[f], scan->point.item + from,
                         scan->point.n - from);
    }
    return 0;
}

/* -1, and why: what a stream names was no file. */
static int check_file(const struct scan_source *source, struct error *why)
{
    if (strcmp(source->name, "-") == 0)
        return error_set(why, "it was read from standard input");
    if (reader_reads_once(source->name))
        return error_at(why, source->name, 0, "found a pipe, expected the file that it was");
    return 0;
}

/* -1, and why: it has not the points that it had. */
static int check_points(const struct scan_source *source, const struct vec3 *point, size_t n,
                        struct error *why)
{
    if (n != source->points)
        return error_at(why, source->name, 0, "found %zu points, expected %llu: it has changed", n,
                        (unsigned long long)source->points);
    if (scan_source_hash(point, n) != source->hash)
        return error_at(why, source->name, 0, "found other points, as many: it has changed");
    return 0;
}

/* The file that a stream names, if it is still what it was; -1, and why not. */
static int read_named(const struct scan_source *source, struct vec3s *points, struct error *why)
{
    size_t from = points->n;

    if (check_file(source, why) != 0 || read_file(source->name, points, why) != 0)
        return -1;
    return check_points(source, points->item + from, points->n - from, why);
}

int guard_mesh_read(const struct scan_source *named, double radius, struct vec3s *points,
                    struct error *why)
{
    struct mesh mesh;

    if (check_file(named, why) != 0 || mesh_read(named->name, &mesh, why) != 0)
        return -1;
    int result = check_points(named, mesh.vertex.item, mesh.vertex.n, why);
    if (result == 0) {
        vec3s_add(points, mesh.vertex.item, mesh.vertex.n);
        fill_closely(&mesh, mesh_area(&mesh), radius, points);
    }
    mesh_free(&mesh);
    return result;
}

/* The files that a stream names, all of them or none; -1: one is there and cannot be read. */
static int read_all_named(const struct scan_sources *named, const char *stream, const char *instead,
                          struct guard_scan *scan, struct unmets *unmet, struct error *why)
{
    for (size_t f = 0; f < named->n; f++)
        if (read_named(&named->item[f], &scan->point, why) != 0) {
            array_free(&scan->point);
            if (why->system)
                return -1;
            unmet_warn(unmet, "the scan that %s names does not guard: %s; %s%s", stream, why->text,
                       instead, unmet ? " (-g FILE names it)" : ""); /* else there is no -g */
            break;
        }
    scan->source = scan_sources_copy(named);
    return 0;
}

/* The same files with the same points, whatever their names. */
static bool is_same_scan(const struct scan_sources *a, const struct scan_sources *b)
{
    bool same = a->n == b->n;

    for (size_t i = 0; same && i < a->n; i++)
        same = a->item[i].points == b->item[i].points && a->item[i].hash == b->item[i].hash;
    return same;
}

int guard_scan_read(const struct guard_choice *choice, const struct scan_sources *named,
                    double radius, const char *stream, const char *instead, struct guard_scan *scan,
                    struct unmets *unmet, struct error *error)
{
    *scan = (struct guard_scan){.point = {0}};
    if (choice->none)
        return 0;
    if ((choice->files.n == 0 ? read_all_named(named, stream, instead, scan, unmet, error)
                              : read_given(&choice->files, scan, error)) != 0)
        return -1;
    scan->named = is_same_scan(&scan->source, named);
    scan->source.placed = named->placed;
    scan->source.place = named->place;
    if (scan->point.n > 0 && named->placed) {
        transform_points(&named->place, scan->point.item, scan->point.n);
        say("the scan to guard is placed as the mesh was");
    }
    for (size_t f = 0; scan->point.n > 0 && f < scan->source.n; f++)
        if (add_facets(scan->source.item[f].name, radius, scan, error) != 0)
            return -1;
    return 0;
}

void guard_scan_free(struct guard_scan *scan)
{
    array_free(&scan->point);
    array_free(&scan->facet);
    scan_sources_free(&scan->source);
}

/* Points of the scan stand within `near` beside the upright through the place, both over and under
 * it: it is on a wall, whose points lie far apart for who looks from above. */
static bool is_on_wall(const struct kdtree *tree, struct box box, struct vec3 p, double near)
{
    return kdtree_any_beside(tree, p, vec(p.x, p.y, fmax(p.z, box.high.z)), near) &&
           kdtree_any_beside(tree, p, vec(p.x, p.y, fmin(p.z, box.low.z)), near);
}

/* How many places have no point of the scan within `near`, and are on none of its walls. */
static size_t far_places(const struct vec3s *place, const struct vec3s *scan, double near,
                         int threads)
{
    const double rounding = 1e-12;
    struct kdtree *tree = kdtree_new_by(scan->item, scan->n, threads);
    struct box box = box_around(scan->item, scan->n);
    size_t far = 0;

    near *= 1 + rounding;
    for (size_t i = 0; i < place->n; i++)
        far += !kdtree_any_beside(tree, place->item[i], place->item[i], near) &&
               !is_on_wall(tree, box, place->item[i], near);
    kdtree_free(tree);
    return far;
}

/* Heights that were rounded may be anywhere within half a step, unless each point is believed as it
 * is. */
static void unround(const struct vec3s *points, const struct guard_read_options *rule)
{
    double rounded = believed_unround(points->item, points->n, rule->noise, rule->threads);

    if (rounded > 0)
        say("heights of the scan that guards were rounded to %.3g mm: taken to be anywhere within "
            "half of it (--noise 0 believes them)",
            rounded);
}

static void say_outliers(const struct believed *believed)
{
    size_t out = believed->outliers - believed->beneath;

    if (out > 0)
        say("left out %zu outlier%s of the scan that guards", out, out == 1 ? "" : "s");
    if (believed->beneath > 0)
        say("%zu outlier%s of the scan, no higher than what is about %s, guard%s all the same",
            believed->beneath, believed->beneath == 1 ? "" : "s",
            believed->beneath == 1 ? "it" : "them", believed->beneath == 1 ? "s" : "");
}

/* What the scan is to be taken as; its outliers go, but for those beneath its surface. */
static struct believed believe(struct point_grid *point_grid, double noise, int threads)
{
    const struct believed_options options = {.noise = noise, .threads = threads};
    unsigned char *out = mem_alloc(point_grid->n, 1);

    memset(out, 0, point_grid->n);
    outliers_twice(point_grid, out);
    point_grid_remove(point_grid, out);
    memset(out, 0, point_grid->n);
    struct believed believed = believed_in_grid(point_grid, &options, out);
    say_outliers(&believed);
    believed_keep_beneath(out, point_grid->n);
    point_grid_remove(point_grid, out);
    free(out);
    say_sheets(&believed.sheets);
    return believed;
}

static double spacing_of(const struct vec3s *points)
{
    struct plan_extent f = plan_extent_of(points->item, points->n, 0);
    double spacing = plan_extent_spacing(&f, points->item, points->n);

    return spacing > 0 ? spacing : 1; /* upright or a single point: any cell will do */
}

/* The mesh knows better than the scan where its sharp edges are. */
static void add_edges(const struct mesh *mesh, double spacing, const struct point_grid *point_grid,
                      struct vec3s *points)
{
    size_t before = points->n;

    guard_points_of_edges(mesh, spacing, point_grid, points);
    if (points->n > before)
        note("and by %zu points on sharp edges of the mesh", points->n - before);
}

/* Radii: so far below the scan's lowest points no tool comes in under these; so far apart are what
 * keeps it out. */
static const double CELLAR = 25, CELLAR_GAP = 0.5;

/* Under the roof that is no higher than the ball over the scan's lowest point the part goes on, or
 * what it stands on: an axis may lean so far that the shaft would pass there. */
static void add_cellar(const struct point_grid *point_grid, const unsigned char *roof,
                       struct box box, struct guard_read_options *rule)
{
    size_t n = point_grid->n;
    unsigned char *low = mem_alloc(n + 1, 1);
    double wide = fmax(box.high.x - box.low.x, box.high.y - box.low.y);
    double deep = fmin(CELLAR * rule->radius, wide);

    for (size_t i = 0; i < n; i++)
        low[i] = roof[i] && point_grid->point[i].z <= box.low.z + rule->radius;
    roof_curtain(point_grid, low, CELLAR_GAP * rule->radius, box.low.z - deep, rule->threads,
                 &rule->curtain);
    free(low);
}

/* Under the scan is material, that no point stands for: so that no tool comes in from beside. */
static void add_curtain(const struct point_grid *point_grid, struct guard_read_options *rule,
                        struct vec3s *points)
{
    struct box box = box_around(point_grid->point, point_grid->n);
    unsigned char *roof = mem_alloc(point_grid->n + 1, 1);

    if (roof_find(point_grid, ROOF_GUARD, rule->threads, roof) > 0) {
        roof_curtain(point_grid, roof, CURTAIN * rule->radius, box.low.z, rule->threads,
                     &rule->curtain);
        add_cellar(point_grid, roof, box, rule);
    }
    free(roof);
    vec3s_add(points, rule->curtain.item, rule->curtain.n);
    if (rule->curtain.n > 0)
        note("and by %zu points under the rims of the scan", rule->curtain.n);
}

/* Beyond the rim of a scan the part goes on, unseen. */
static void add_rim(const struct point_grid *point_grid, const struct guard_read_options *rule,
                    double sink, struct vec3s *points)
{
    const struct rim_points_options options = {.pitch = sqrt(8 * rule->radius * sink),
                                               .gap = CURTAIN * rule->radius,
                                               .radius = rule->radius,
                                               .noise = rule->noise,
                                               .threads = rule->threads};
    size_t before = points->n, rim = rim_points(point_grid, &options, points);

    if (rim > 0)
        note("and by %zu points beyond %zu at the rim of the scan", points->n - before, rim);
}

static void say_bounded(const struct guard_points *surface, const struct guard_read_options *rule,
                        size_t points)
{
    if (surface->sparse)
        effort_say(EFFORT_GUARD_BETWEEN, rule->effort, points);
    if (rule->noise > 0)
        effort_say(EFFORT_ALONG, rule->effort, points);
    effort_say(EFFORT_GUARD_NEAR, rule->effort, surface->near);
}

/* Of `points` so many that more is unknown than of any scan of a real thing, of which some stand
 * out of what is about them: one in two hundred, or one in a thousand if of two thousand not one by
 * much.  Where the surface is certain nearly everywhere, groups of them as at its rims, beyond the
 * first, one for 500 points, if of a thousand not one by much, and no spur.  A quarter of all
 * this was no safer: by their models seven scans with more are cut as deep as three with less. */
static bool are_many(const struct edge_gaps *gaps, size_t points)
{
    const double even = 0.6, groups = 1.0 / 500, sure = 1.0 / 1000;
    const double rough = 1.0 / 1000, small = 1.0 / 200, large = 1.0 / 2000;
    double n = (double)points, unknown = (double)gaps->unknown;

    if ((double)gaps->certain > even * n)
        return (double)gaps->features > groups * n - 1 || (double)gaps->large > sure * n ||
               gaps->spurs > 0;
    return unknown > ((double)gaps->large > large * n ? rough : small) * n;
}

/* Where they are not many they are said alone. */
static void say_edges(const struct edge_gaps *gaps, size_t points, struct unmets *unmet)
{
    struct vec3 at = gaps->at;

    if (gaps->n > 0)
        say("edge not resolved at %.3f %.3f %.3f, one of %zu such points: the nearest points below "
            "are up to %.3f mm beside; guarded as if the upper side went on as far, and so much of "
            "the lower side may stay",
            at.x, at.y, at.z, gaps->n, gaps->widest);
    at = gaps->unknown_at;
    if (gaps->unknown > 0)
        unmet_say(
            are_many(gaps, points) ? unmet : NULL,
            "sharp edge not resolved at %.3f %.3f %.3f, one of %zu such points: by the points "
            "beside it the part may go on up to %.3f mm in front of it, and further between such "
            "points; only so far it is guarded",
            at.x, at.y, at.z, gaps->unknown, gaps->depth);
}

/* Of what points are apart: noise of so much hides shapes that small; what may be noise or shape,
 * and is so much, may be steps. */
static const double MUCH = 0.125, STEPPED = 0.05;

/* So much noise, measured of the scan: steps and ribs that a few points each are on may be it; or
 * edges of facets, where a part of it may be shape. */
static void say_rough(const struct believed *found, double spacing,
                      const struct guard_read_options *rule)
{
    const double many = 5; /* times the tolerance */

    if (found->sigma > MUCH * spacing && found->sigma > many * rule->tolerance)
        unmet_say(
            rule->unmet,
            "noise of %.2g mm is much for points that are %.2g mm apart: shapes so small cannot "
            "be told from it, and are not guarded",
            found->sigma, spacing);
    else if (found->noise.mixed && found->sigma > rule->tolerance)
        unmet_say(rule->unmet,
                  "noise of %.2g mm may be shape in part, as edges of facets a few points wide: "
                  "these are not guarded (--noise)",
                  found->sigma);
}

/* What is left by smooth surfaces where no noise was found and it may be of both; else 0. */
static double rough_of(const struct believed *found, double least)
{
    bool unknown = !(found->sigma > 0) && !(found->apart > 0) && found->noise.sigma > least;

    return unknown ? found->noise.sigma : 0;
}

static void say_unknown(double rough)
{
    if (rough > 0)
        say("noise cannot be told from the shape of the scan, which is %.2g mm off smooth "
            "surfaces: taken as none; where it is some, edges among it may not be found (--noise)",
            rough);
}

/* Near so many points the surface between them is uncertain.  Where it is so near most of them, and
 * they are far apart for the ball, nothing keeps it off between them: less far, where they are off
 * smooth surfaces, or two sheets are apart, by what may be steps. */
static void say_vague(const struct guard_points *surface, size_t points, bool stepped,
                      const struct guard_read_options *rule)
{
    const double most = 0.5, many = 0.8, all = 0.95;          /* of the points */
    const double farther = 0.6, coarse = 1 / 3.0, far = 0.25; /* of the radius */
    double vague = (double)surface->vague / (double)points, gap = surface->gap / rule->radius;
    bool nowhere = (vague > most && gap > farther) || (vague > many && gap > coarse) ||
                   (vague > all && gap > far && stepped);

    if (surface->vague > 0)
        unmet_say(nowhere ? rule->unmet : NULL,
                  "the scan is too sparse at %zu points for a tolerance of %g: the surface between "
                  "them is uncertain, at worst by %.3f mm at %.3f %.3f %.3f",
                  surface->vague, rule->tolerance, surface->worst, surface->at.x, surface->at.y,
                  surface->at.z);
}

/* How far points of two sheets may be off the surface half way between them for it to stand for
 * both: not much more than the tolerance. */
static double apart_of(double apart, const struct guard_read_options *rule)
{
    const double most = 5; /* times the tolerance */

    return apart <= most * rule->tolerance ? apart : 0;
}

/* A scan's surface, less the noise of its points, of which outliers are left out. */
static struct guard_points surface_of_scan(struct point_grid *grid, double spacing, double sink,
                                           struct guard_read_options *rule)
{
    const double little = 0.1; /* of the tolerance */
    size_t points = grid->n;
    struct believed found = believe(grid, rule->noise, rule->threads);
    bool noisy = found.sigma > little * rule->tolerance;
    if (rule->noise < 0 && noisy)
        effort_say(EFFORT_GUARD_NOISE, rule->effort, points);
    bool removed = noisy && effort_covers(EFFORT_GUARD_NOISE, rule->effort, points);
    bool stays = rule->noise < 0 && noisy && !removed; /* points stand out by it alone */
    bool sided = rule->noise < 0 && found.noise.sided;
    double rough = rule->noise < 0 ? rough_of(&found, rule->tolerance) : 0;
    if (rule->noise < 0) {
        say_rough(&found, spacing, rule);
        say_unknown(rough);
        rule->noise = removed ? found.sigma : 0;
    }
    struct guard_points_options how = {.radius = rule->radius,
                                       .sink = sink,
                                       .noise = rule->noise,
                                       .edged = sided && rule->noise > 0,
                                       .rough = rough,
                                       .apart = apart_of(found.apart, rule),
                                       .vague = rule->tolerance,
                                       .effort = rule->effort,
                                       .threads = rule->threads};
    struct guard_points surface = guard_points_of_scan(grid, &how);
    say_bounded(&surface, rule, grid->n);
    if (rule->noise > 0)
        say("noise of %.2g mm taken out of the scan that guards (%zu of %zu points moved)",
            rule->noise, surface.moved, grid->n);
    bool stepped = rough > STEPPED * spacing || found.apart > 2 * STEPPED * spacing;
    say_vague(&surface, grid->n, stepped, rule);
    note("guarded by %zu points of the scan and %zu inserted between them", grid->n, surface.added);
    if (surface.edges > 0)
        note("and by %zu points on sharp edges that its surfaces meet in", surface.edges);
    say_edges(&surface.gaps, grid->n, stays ? NULL : rule->unmet);
    return surface;
}

/* That of meshes: their corners, and close points of their facets, which are the part as they
 * are. */
static struct guard_points surface_of_facets(const struct point_grid *grid,
                                             const struct guard_scan *scan,
                                             struct guard_read_options *rule)
{
    struct guard_points surface = {.sparse = false};

    rule->noise = 0;
    vec3s_add(&surface.certain, grid->point, grid->n);
    vec3s_add(&surface.point, grid->point, grid->n);
    vec3s_add(&surface.point, scan->facet.item, scan->facet.n);
    note("guarded by the facets of a mesh: %zu points", surface.point.n);
    return surface;
}

/* NULL: more points than can be sorted. */
static struct gouge_check *gouge_of(const struct guard_scan *scan, const struct mesh *mesh,
                                    struct guard_read_options *rule, struct error *error)
{
    const struct vec3s *points = &scan->point;
    bool faceted = scan->meshes == scan->source.n && !(rule->noise > 0);
    double spacing = spacing_of(points), sink = rule->tolerance / 5;
    struct point_grid point_grid;

    if (!faceted)
        unround(points, rule);
    if (point_grid_make(points->item, points->n, spacing, rule->threads, &point_grid, error) < 0)
        return NULL;
    struct guard_points surface = faceted ? surface_of_facets(&point_grid, scan, rule)
                                          : surface_of_scan(&point_grid, spacing, sink, rule);
    if (mesh && faceted) /* who judges takes them for the part */
        vec3s_add(&rule->facets, surface.point.item, surface.point.n);
    if (mesh) {
        vec3s_add(&rule->believed, point_grid.point, point_grid.n);
        add_edges(mesh, sqrt(8 * rule->radius * sink), &point_grid, &surface.point);
    }
    if (!faceted) /* a mesh ends where it ends */
        add_rim(&point_grid, rule, sink, &surface.point);
    if (!faceted || scan->open > 0)
        add_curtain(&point_grid, rule, &surface.point);
    if (!faceted)
        vec3s_add(&surface.point, scan->facet.item, scan->facet.n);
    point_grid_free(&point_grid);
    rule->certain = surface.certain;
    rule->doubtful = surface.doubtful;
    return gouge_new(surface.point, rule->threads);
}

int guard_scan_near(const struct guard_scan *scan, const struct vec3s *place, const char *what,
                    double near, int threads, struct error *error)
{
    const double half = 0.5, extended = 0.95; /* by its own width: nine times its area, and more */
    size_t far = far_places(place, &scan->point, near, threads);

    if ((double)far <= (scan->named ? extended : half) * (double)place->n)
        return 0;
    return error_at(
        error, scan->source.item[0].name, 0,
        "found %zu of %zu %s further than %.3g mm from the scan, expected the scan that "
        "the mesh was made from, or a mesh as fine as the ball",
        far, place->n, what, near);
}

struct gouge_check *guard_read(struct guard_scan *scan, const struct mesh *mesh, double near,
                               struct guard_read_options *rule, struct error *error)
{
    struct gouge_check *guard = NULL;

    if (guard_scan_near(scan, &mesh->vertex, "mesh vertices", near, rule->threads, error) == 0)
        guard = gouge_of(scan, mesh, rule, error);
    array_free(&scan->point);
    array_free(&scan->facet);
    return guard;
}

struct gouge_check *guard_read_scan(struct guard_scan *scan, struct guard_read_options *rule,
                                    struct error *error)
{
    return gouge_of(scan, NULL, rule, error);
}
