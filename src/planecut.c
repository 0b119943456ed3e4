/*
 * planecut - parallel planes through a mesh to a path: contact points, normals, tool centres, tool
 * axes, tips (paper 2, 2.1 and 2.2).
 */
#include <stdlib.h>

#include "stage/mesh_for_path.h"
#include "stage/mesh_region.h"
#include "stage/path_coverage.h"
#include "stage/path_options.h"
#include "stage/plane_passes.h"
#include "toolpath/scallop.h"
#include "mesh/mesh_repair.h"
#include "io/nurbs/surfaces.h"

/* Of a path; a point takes some 300 bytes while it is made. */

/* By the longest edge of the mesh: how far beyond its trimming a surface counts. */
static const double BESIDE = 0.002;

/* mm: of points between those of a mesh of no scan, without -e. */
static const double TOLERANCE = 0.01;

static double step, scallop, plane[3], gap = 0.1;
static struct cli_list surfaces;
static double up[3] = {0, 0, 1};
static bool step_given, scallop_given, plane_given;
static const char *direction; /* as text: auto or degrees */

/* clang-format off */
static const struct cli_option options[] = {
    {'r', "radius", "MM", "radius of the ball (required)",
     CLI_NUMBER, &path_options.radius, 0.001, 1000, 0, NULL},
    {'s', "step", "MM", "distance of the planes, or slightly less",
     CLI_NUMBER, &step, CLI_POSITIVE, 0, 0, &step_given},
    {0, "scallop", "MM", "planes so close that no scallop is higher than MM (0.01\n"
     "without -s)", CLI_NUMBER, &scallop, CLI_POSITIVE, 0, 0, &scallop_given},
    {'a', "direction", "auto|DEG",
     "direction of the planes: auto, the shortest cut, or from\n"
     "x towards y (0)",
     CLI_TEXT, &direction, 0, 0, 0, NULL},
    {0, "angle", "DEG", NULL, CLI_ALIAS, "direction", 0, 0, 0, NULL},
    {0, "plane", "I,J,K", NULL, CLI_ALIAS, "normal", 0, 0, 0, NULL},
    {0, "normal", "I,J,K", "the planes' normal, instead of -a: 0,0,1 cuts at constant height",
     CLI_NUMBERS, plane, 0, 0, 3, &plane_given},
    {0, "up", "I,J,K", "the side that the tool comes from (0,0,1)",
     CLI_NUMBERS, up, 0, 0, 3, NULL},
    {0, "faces", "N,N-M,...", "cut these surfaces, by their numbers in the file of the model",
     CLI_TEXT, &path_options.faces, 0, 0, 0, NULL},
    {0, "steep", "A:B", "cut what is inclined by A to B degrees against --up: 0:45",
     CLI_TEXT, &path_options.steep, 0, 0, 0, NULL},
    {0, "gap", "MM", "cut on across gaps in the part of at most this width (0.1)",
     CLI_NUMBER, &gap, 0, 1000, 0, NULL},
    {0, "surface", "FILE", "project each point onto the surfaces of this file, IGES or NURBS\n"
     "text, that the mesh was made from (may be given several times)",
     CLI_LIST, &surfaces, 0, 0, 0, NULL},
    {0, "oneway", NULL, NULL, CLI_ALIAS, "one-way", 0, 0, 0, NULL},
    {0}};
/* clang-format on */

static void check_options(struct tool_axis_options *axis)
{
    struct error error;

    if (path_options_check(axis, &error) != 0)
        die_given(&error);
    if (step_given && scallop_given)
        die_usage("found -s and --scallop, expected one of them");
    if (direction && plane_given)
        die_usage("found --direction and --normal, expected one of them");
    if (direction && !plane_passes_direction_read(direction))
        die_usage("option --direction: found '%s', expected auto or degrees", direction);
    if (plane_given && vec_length(vec(plane[0], plane[1], plane[2])) == 0)
        die_usage("option --normal: found a direction of no length");
    if (vec_length(vec(up[0], up[1], up[2])) == 0)
        die_usage("option --up: found a direction of no length");
    if (scallop >= path_options.radius)
        die_usage("option --scallop: found %g, expected less than the radius", scallop);
    if (!step_given && !scallop_given)
        scallop = fmin(0.01, path_options.radius / 2);
    path_options.scallop = scallop;
}

/* The ball must not be larger than the smallest hollow (paper 2, 2.1), unless it is lifted there;
 * of sharp edges, where none fits, what is left is told when it is known. */
static void check_radius(const char *file, const struct mesh *mesh)
{
    struct tightest_hollow h = mesh_tightest_hollow(mesh, path_options.radius);

    if (!h.known && !path_options.paper)
        say("%s: the mesh has no curvatures (kmax), so that it is not known whether the ball "
            "fits everywhere: it is lifted where it does not",
            file);
    if (h.known && isfinite(h.radius))
        note("the largest ball that fits all hollows but sharp edges: radius %.4f (%.3f %.3f "
             "%.3f%s%s)",
             h.radius, h.at.x, h.at.y, h.at.z, h.surface ? ", " : "", h.surface ? h.surface : "");
    else if (h.known)
        note("nothing but sharp edges may be hollow: a ball of any radius fits every surface");
    if (!h.known || h.tighter == 0 || path_options.avoid || path_options.guarded)
        return;
    die("%s: found a hollow of radius %.3f at %.3f %.3f %.3f%s%s, expected none "
        "below the ball's, %g (%zu %s too tight for it): take a smaller ball, or --avoid",
        file, h.radius, h.at.x, h.at.y, h.at.z, h.surface ? " in surface " : "",
        h.surface ? h.surface : "", path_options.radius, h.tighter,
        h.surface ? "surfaces" : "vertices");
}

static double widest_step(void)
{
    return step_given ? step : scallop_step(scallop, path_options.radius, 0);
}

static void find_planes(const struct mesh *mesh, struct plane_passes *p)
{
    struct error error;

    if (plane_passes_bounded(mesh, p->rule.normal, widest_step(), &error) != 0)
        die_error(&error);
    if (step_given)
        plane_passes_equal(p, mesh, step);
    else
        plane_passes_scallop(p, mesh, path_options_row_scallop());
    if (plane_passes_bounded(mesh, p->rule.normal, plane_passes_apart(p), &error) != 0 ||
        plane_passes_short(p, mesh, &error) != 0)
        die_error(&error);
}

static void set_pass_options(const struct tool_axis_options *axis, const struct mesh *mesh,
                             bool closed, struct plane_passes *p)
{
    struct pass_options *rule = &p->rule;
    double turn = 0, h = step_given ? fmin(0.01, path_options.radius / 2) : scallop;

    struct error error;

    if (direction && plane_passes_bounded(mesh, vec(0, 0, 0), widest_step(), &error) != 0)
        die_error(&error);
    if (direction)
        turn = plane_passes_direction(direction, mesh, path_options.radius, h);
    *rule = plane_passes_upright(turn, path_options.radius);
    rule->gap = gap;
    rule->faced = closed || axis->kind == AXIS_FIXED || !path_options.paper;
    rule->facing = vec_unit(vec(up[0], up[1], up[2]));
    if (plane_given) {
        rule->normal = vec_unit(vec(plane[0], plane[1], plane[2]));
        rule->along = passes_along(rule->normal);
    }
    if (axis->kind == AXIS_FIXED)
        rule->facing = axis->direction;
}

static void read_surfaces(struct mesh *mesh, struct patches *patches, struct plane_passes *p)
{
    struct surfaces_unit unit;
    struct error error;
    double longest = 0, slack = isfinite(mesh->origin.ledger) ? mesh->origin.ledger : 0;

    for (size_t i = 0; i < surfaces.n; i++) {
        if (surfaces_read(surfaces.item[i], 0, patches, &unit, &error) < 0)
            die_error(&error);
    }
    if (surfaces.n == 0)
        return;
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        longest = fmax(longest, vec_distance(mesh->vertex.item[v[0]], mesh->vertex.item[v[1]]));
    }
    p->on = project_new(patches, fmax(slack, BESIDE * longest));
    p->reach = longest / 2;
    mesh->origin.ledger = NAN; /* points leave the mesh: what it was off is not spent */
}

/* Faces or slopes that are all that the mesh has. */
static bool takes_all(const struct mesh_region_options *region, const struct mesh *mesh,
                      const struct mesh *part)
{
    return !region->box && !region->region && part->face.n == mesh->face.n &&
           mesh_area(part) == mesh_area(mesh);
}

/* The part of the mesh that is cut; the mesh itself, when all of it is. */
static const struct mesh *take_region(const struct mesh *mesh, struct mesh *part)
{
    struct mesh_region_options region = path_options_region();
    struct error error;

    region.up = vec_unit(vec(up[0], up[1], up[2]));
    if (!mesh_region_given(&region))
        return mesh;
    if (mesh_region_take(&region, mesh, part, &error) != 0)
        die_given(&error);
    if (part->face.n == 0)
        die("nothing of the mesh is in the region asked for (--box, --region, --faces, --steep)");
    note("region: %zu facets of the mesh's %zu", part->face.n, mesh->face.n);
    if (!takes_all(&region, mesh, part))
        return part;
    if (region.polygons)
        region_polygons_free(region.polygons);
    return mesh;
}

/* Facets of CAD models are as long as the surface is straight: a fit through their corners alone
 * would swing out between them, and where they bend, a straight line go through the part. */
static void set_tolerance(const struct mesh *mesh)
{
    bool foreign = mesh->origin.scan.n == 0 && (mesh_is_coarse(mesh) || mesh_is_sharp(mesh));

    if (path_options.tolerance == 0 && !path_options.paper &&
        (mesh->origin.surface.n > 0 || mesh->normals_made || foreign))
        path_options.tolerance = TOLERANCE;
}

/* Of a part without outline no judge knows what of it is to be cut: the head says no scallop. */
static void promise_nothing(bool measured)
{
    say("what is asked for has no outline, being narrow, rough, or over itself: "
        "%sthe head promises no scallop",
        measured ? "" : "what stays of it is not measured, and ");
    path_options.scallop = 0;
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "planecut",
                      .usual = "radius step direction scallop up avoid tilt holder",
                      .usage = "-r R [-s MM | --scallop H] [-a DEG] [options] [FILE]",
                      .about =
                          "Makes a tool path from parallel planes through a mesh (PLY, STL, OFF).",
                      .option = options,
                      .more = path_option_table};
    struct mesh mesh = {0}, part = {0};
    struct path path = {0};
    struct patches patches = {0};
    struct plane_passes planes = {0};
    struct toolpath t = {.path = &path};
    struct gouge_check *guard;
    struct error error;
    bool closed;

    cli_parse(&cli, argc, argv);
    t.threads = planes.threads = cli.threads;
    check_options(&t.lift.axis);
    if (cli.files > 1)
        die_usage("found %d files, expected one mesh", cli.files);
    if (mesh_for_planes_read(cli.file[0], vec_unit(vec(up[0], up[1], up[2])), cli.threads, &mesh,
                             &closed, &error) != 0)
        die_error(&error);
    if (path_options_scan(&mesh, &error) != 0)
        die_error(&error);
    set_tolerance(&mesh);
    const struct mesh *region = take_region(&mesh, &part);
    check_radius(cli.file[0], region);
    set_pass_options(&t.lift.axis, region, closed, &planes);
    find_planes(region, &planes);
    read_surfaces(&mesh, &patches, &planes);
    path_options.on_surfaces = planes.on != NULL;
    const struct mesh_edges *edges = region == &mesh ? slice_edges(planes.cut) : NULL;
    if (path_options_guard(&mesh, edges, fmax(planes.widest, path_options.radius), cli.threads,
                           &guard, &error) != 0)
        die_error(&error);
    if (path_options_rules(&mesh, guard, planes.widest, &t, &error) != 0)
        die_given(&error);

    struct path_coverage coverage = {.scallop = 0};
    struct region asked = path_options_points();
    bool promised = scallop > 0 && (!path_options.guarded || region_given(&asked));
    if (promised || (region == &mesh && (path_options.guarded || mesh.normals_made)))
        coverage = path_coverage_new(&mesh, region, &t);
    t.coverage = coverage.coverage;
    if (scallop > 0 && region != &mesh && !region_given(&asked))
        promise_nothing(coverage.coverage);
    path_options_begin(&mesh, "planecut", cli.output, &t);
    planes.region = region != &mesh;
    plane_passes_run_out(&planes, &mesh);
    if (plane_passes_make(&planes, 1, &t, &error) != 0)
        die_error(&error);
    path_coverage_rest(&coverage, planes.rule.normal, &t);
    toolpath_end(&t);
    path_coverage_measure(&coverage, &t);
    note("%zu planes", planes.height.n);
    int status = toolpath_conclude(&t);
    if (unmets_status(&path_options.unguarded) != EXIT_DONE)
        status = EXIT_UNMET;
    if (path_coverage_conclude(&coverage, &path.head) != EXIT_DONE)
        status = EXIT_UNMET;
    bool measured = coverage.coverage && scallop > 0; /* rest passes cut what planes cannot */
    if (planes.steep && scallop_given && !measured) {
        unmet_say(&path.head.unmet,
                  "on slopes steeper than the planes can follow, scallops are "
                  "higher than %g mm (--scallop)",
                  scallop);
        status = EXIT_UNMET;
    }
    path_options_end(&mesh, "planecut", &t);
    path_coverage_free(&coverage);

    plane_passes_free(&planes);
    patches_free(&patches);
    toolpath_free(&t);
    path_free(&path);
    gouge_free(guard);
    mesh_free(&mesh);
    mesh_free(&part);
    return status;
}
