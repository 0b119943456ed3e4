/* path_options - see path_options.h. */
#include "stage/path_options.h"

#include <stdlib.h>
#include <string.h>

#include "base/effort.h"
#include "base/reader.h"
#include "gouge/guard_mesh.h"
#include "guard_read.h"
#include "machine/machine_options.h"
#include "machine/rotary_cost.h"
#include "math/box.h"
#include "mesh/mesh_distance.h"
#include "toolpath/scallop.h"

/* How deep the ball may sink between the guard points of a mesh, mm, and how many of them there may
 * be: about 100 bytes each. */
enum { LAYERS_MAX = 200 };
static const double SINK = 0.002, MOST_GUARD_POINTS = 8e6;

/* It is no guard where the ball may sink deeper than this, mm. */
static const double DEEP = 0.05;

/* Of the distance between rows on a plane: so far a row may be moved sideways to run smoothly. */
static const double ASIDE = 0.05;

/* Of the radius: the normals of a row are averaged over so much of it before and after. */
static const double EVEN = 0.4;

/* Degrees: so far within the travel of a single rotary axis its axes end. */
static const double INSIDE = 0.5;

/* Of the radius: so near the border of a region, where rows end, its points are not asked for. */
static const double BORDER = 0.25;

struct path_options path_options = {.tilt = 15,
                                    .depth = 0.3,
                                    .noise = -1,
                                    .said_noise = -1,
                                    .effort = 1,
                                    .smooth = -1,
                                    .left_share = 0.5,
                                    .lean = 85,
                                    .play = 15,
                                    .clearance = NAN,
                                    .approach = 5,
                                    .feed = 800,
                                    .spindle = 8000,
                                    .layers = 1,
                                    .tool = 1,
                                    .coolant = 1};

/* clang-format off */
const struct cli_option path_option_table[] = {
    {'g', "guard", "FILE", "keep the tool clear of this scan, or of several\n"
     "(default: the one that the mesh was made from)", CLI_LIST,
     &path_options.guard.files, 0, 0, 0, NULL},
    {0, "no-guard", NULL, "by no scan, not even the one that the mesh was made from",
     CLI_FLAG, &path_options.guard.none, 0, 0, 0, NULL},
    {0, "noise", "MM", "standard deviation of the noise to remove from the scan of -g\n"
     "(default: measured; 0: the points as they are)",
     CLI_NUMBER, &path_options.noise, 0, 10, 0, NULL},
    EFFORT_OPTION(&path_options.effort),
    {'e', "tolerance", "MM",
     "straight lines stay within MM of the smooth curve\n"
     "(0.01 with -g, --holder or a mesh of nurbs2mesh)",
     CLI_NUMBER, &path_options.tolerance, 0.0001, 10, 0, NULL},
    {0, "paper", NULL, "as published: only the mesh points, no lifting, links not checked",
     CLI_FLAG, &path_options.paper, 0, 0, 0, NULL},
    {0, "avoid", NULL, "accept material left where the ball does not fit\n"
     "(otherwise exit status 3)", CLI_FLAG, &path_options.avoid, 0, 0, 0, NULL},
    {0, "limit", "MM", "lift no centre by more than MM; places that need more are skipped\n"
     "(default: the radius)", CLI_NUMBER, &path_options.limit, CLI_POSITIVE, 0, 0, NULL},
    {0, "smooth", "MM", "lift centres by up to MM more where they run smoothly then (default:\n"
     "by tolerance and scallop; 0: not)", CLI_NUMBER, &path_options.smooth, 0, 1, 0, NULL},
    {0, "left-share", "PERCENT",
     "share of the scan's points that may stay uncut within reach of the\n"
     "tool (0.5); more gives exit status 3", CLI_NUMBER, &path_options.left_share, 0, 100, 0, NULL},
    {0, "tilt", "DEG", "tilt the axis sideways from the normal (15)",
     CLI_NUMBER, &path_options.tilt, -80, 80, 0, &path_options.lean_given},
    {0, "lead", "DEG", "tilt it in the direction of the feed (0)",
     CLI_NUMBER, &path_options.lead, -80, 80, 0, &path_options.lean_given},
    {0, "fixed", "I,J,K", "fixed axis, from the tip to the spindle",
     CLI_NUMBERS, path_options.fixed, 0, 0, 3, &path_options.fixed_given},
    {0, "to-point", "X,Y,Z", "the axis passes through this point above the part",
     CLI_NUMBERS, path_options.to_point, 0, 0, 3, &path_options.to_given},
    {0, "from-point", "X,Y,Z", "the axis points away from this point below the surface",
     CLI_NUMBERS, path_options.from_point, 0, 0, 3, &path_options.from_given},
    {0, "circle", "X,Y,Z,I,J,K,R",
     "the axis passes through the nearest point of a circle: centre,\n"
     "axis, radius", CLI_NUMBERS, path_options.circle, 0, 0, 7, &path_options.circle_given},
    {0, "least-turn", "DEG",
     "tilt the axis by the angle of --tilt and --lead, or up to DEG, in the\n"
     "direction in which rotary axes turn least", CLI_NUMBER, &path_options.turn, 0, 80, 0, NULL},
    {0, "axis-play", "DEG", "largest deviation of axes from their rule, to turn less (15)",
     CLI_NUMBER, &path_options.play, 0, 60, 0, &path_options.play_given},
    {'m', "machine", "MACHINE",
     "machine whose rotary axes are to turn little: a name or a file as for\n"
     "ncpost (default: table-ac)",
     CLI_TEXT, &path_options.machine, 0, 0, 0, NULL},
    {0, "axis-rate", "DEG", "turn axes by no more than DEG per millimetre along a pass",
     CLI_NUMBER, &path_options.rate, CLI_POSITIVE, 0, 0, NULL},
    TOOL_OPTIONS(&path_options.body),
    {0, "lean-limit", "DEG",
     "largest tilt of the axis away from its rule for the tool to be clear\n"
     "(85; with --fixed 0: a fixed axis does not lean)",
     CLI_NUMBER, &path_options.lean, 0, 85, 0, &path_options.limit_given},
    {0, "box", "X0,Y0,Z0,X1,Y1,Z1", "cut what is inside this box",
     CLI_NUMBERS, path_options.box, 0, 0, 6, &path_options.box_given},
    {0, "region", "FILE", "cut what is inside the polygons of FILE, seen along z: a corner `x y`\n"
     "a line, an empty line between two polygons",
     CLI_TEXT, &path_options.region, 0, 0, 0, NULL},
    {0, "one-way", NULL, "cut all passes in one direction (default: zig-zag)",
     CLI_FLAG, &path_options.one_way, 0, 0, 0, NULL},
    {0, "layers", "N", "cut in N layers, the outermost first (1)",
     CLI_COUNT, &path_options.layers, 1, LAYERS_MAX, 0, NULL},
    {0, "depth", "MM", "thickness of a layer, along the normal (0.3)",
     CLI_NUMBER, &path_options.depth, 0.0001, 1000, 0, NULL},
    {0, "clearance", "MM", "height of the tip on the clearance plane (default: top of the part\n"
     "and its layers + radius + 10)",
     CLI_NUMBER, &path_options.clearance, -1000000, 1000000, 0, NULL},
    {0, "approach", "MM", "distance above the part where the plunge feed begins (5)",
     CLI_NUMBER, &path_options.approach, 0.001, 10000, 0, NULL},
    {0, "feed", "MM/MIN", "cutting feed (800)",
     CLI_NUMBER, &path_options.feed, 0.1, 1000000, 0, NULL},
    {0, "plunge", "MM/MIN", "feed of the descent from there (default: half the cutting feed)",
     CLI_NUMBER, &path_options.plunge, 0.1, 1000000, 0, NULL},
    {0, "spindle", "RPM", "speed of the spindle (8000)",
     CLI_NUMBER, &path_options.spindle, CLI_POSITIVE, 0, 0, NULL},
    {0, "tool", "N", "number of the tool (1)", CLI_COUNT, &path_options.tool, 1, 99999999, 0, NULL},
    {0, "coolant", "off|on|mist", "coolant (on)", CLI_CHOICE, &path_options.coolant, 0, 0, 0, NULL},
    {0, "partno", "TEXT", "name of the part (default: that of the mesh's source)",
     CLI_TEXT, &path_options.partno, 0, 0, 0, NULL},
    {0}};
/* clang-format on */

static struct vec3 vec_of(const double v[3])
{
    return vec(v[0], v[1], v[2]);
}

static int axis_rule(struct tool_axis_options *rule, struct error *error)
{
    const struct path_options *c = &path_options;

    *rule = (struct tool_axis_options){
        .kind = AXIS_LEAN, .tilt = RADIANS(c->tilt), .lead = RADIANS(c->lead)};
    if (c->fixed_given + c->to_given + c->from_given + c->circle_given + c->lean_given > 1)
        return error_set(error, "found two rules for the axis, expected one of --tilt/--lead, "
                                "--fixed, --to-point, --from-point, --circle");
    if (c->fixed_given) {
        rule->kind = AXIS_FIXED;
        rule->direction = vec_unit(vec_of(c->fixed));
    } else if (c->to_given) {
        rule->kind = AXIS_TO_POINT;
        rule->point = vec_of(c->to_point);
    } else if (c->from_given) {
        rule->kind = AXIS_FROM_POINT;
        rule->point = vec_of(c->from_point);
    } else if (c->circle_given) {
        rule->kind = AXIS_CIRCLE;
        rule->point = vec_of(c->circle);
        rule->direction = vec_unit(vec_of(c->circle + 3));
        rule->radius = c->circle[6];
    }
    if ((c->fixed_given || c->circle_given) && vec_length(rule->direction) == 0)
        return error_set(error, "option %s: found a direction of no length",
                         c->fixed_given ? "--fixed" : "--circle");
    return 0;
}

static int check_options(struct tool_axis_options *axis, struct error *error)
{
    struct path_options *c = &path_options;

    if (tool_options_files(&c->body, &c->radius, error) != 0)
        return -1;
    if (c->radius == 0)
        return error_set(error, "found no radius of the ball, expected -r R");
    if (c->paper && (c->guard.files.n > 0 || c->tolerance > 0))
        return error_set(error, "found --paper with -g or -e: the papers have neither");
    if (c->guard.none && c->guard.files.n > 0)
        return error_set(error, "found -g and --no-guard, expected one of them");
    if (c->paper && (c->body.holder || c->play_given || c->rate > 0))
        return error_set(error,
                         "found --paper with --holder, --axis-play or --axis-rate: the papers "
                         "have none of them");
    if (c->turn > 0 &&
        (c->paper || c->fixed_given || c->to_given || c->from_given || c->circle_given))
        return error_set(error, "found --least-turn with %s, expected it with --tilt and --lead",
                         c->paper ? "--paper" : "another rule for the axis");
    if (c->paper)
        c->play = 0;
    if (c->fixed_given) {
        c->play = c->play_given ? c->play : 0;
        c->lean = c->limit_given ? c->lean : 0;
    }
    if (c->plunge == 0)
        c->plunge = c->feed / 2;
    if (c->tolerance == 0 && (c->guard.files.n > 0 || c->body.holder))
        c->tolerance = 0.01;
    return axis_rule(axis, error);
}

/* The tool above its ball. */
static int read_body(struct tool_body *body, struct error *error)
{
    const struct path_options *c = &path_options;
    struct tool_options options = c->body;

    options.ball_only = options.ball_only || c->paper;
    return tool_options_read(&options, c->radius, body, error);
}

/* One rotary axis across the tool leaves the tool a circle of axes, as far as what is fitted to
 * them stays within the travel. */
static void take_circle(struct kinematic_chain *chain, struct tool_axis_options *axis)
{
    struct rotary *r = &chain->rotary[0];

    if (vec_length(rotary_circle(chain).pole) == 0)
        return;
    double inside = fmin(RADIANS(INSIDE), (r->max - r->min) / 4);
    r->min += inside;
    r->max -= inside;
    axis->circle = rotary_circle(chain);
}

/* How far within its travel a rotary axis is planned, so that what is fitted to the path, whose
 * axis may be off it, stays within; at the end near `keep`, radians, no further than that. */
static void stay_inside(struct rotary *r, double keep)
{
    double inside = fmin(RADIANS(INSIDE), (r->max - r->min) / 4);

    if (r->max - r->min >= 2 * PI)
        return;
    r->min += keep >= r->min ? fmin(inside, keep - r->min) : inside;
    r->max -= keep <= r->max ? fmin(inside, r->max - keep) : inside;
}

/* The second axis, which stands at `upright` at the pole, is not to lean the tool off it quite as
 * far as it can, which may be less far than it travels: one at 45 degrees lays the tool flat at
 * 180. */
static void leave_reach(struct kinematic_chain *chain, struct rotary_frame frame, double upright)
{
    struct rotary *r = &chain->rotary[1];
    double most = chain_most_lean(chain, frame.pole), lean = most - RADIANS(INSIDE);
    struct chain_solutions s =
        chain_angles(chain, rotary_axis(&frame, (struct rotary_angles){.lean = lean}));

    if (most > PI - RADIANS(INSIDE) || s.n == 0)
        return;
    double turn = fabs(angle_remainder(s.q[0][1] - upright));
    r->min = fmax(r->min, upright - turn);
    r->max = fmin(r->max, upright + turn);
}

/* Two rotary axes: the second one has the pole, where the tool is upright on most machines. */
static void leave_ends(struct kinematic_chain *chain)
{
    struct rotary_frame frame = rotary_frame_of(chain);
    struct chain_solutions at_pole = chain_angles(chain, frame.pole);

    if (chain->n != 2)
        return;
    stay_inside(&chain->rotary[0], HUGE_VAL);
    stay_inside(&chain->rotary[1], at_pole.n > 0 ? at_pole.q[0][1] : HUGE_VAL);
    if (at_pole.n > 0)
        leave_reach(chain, frame, at_pole.q[0][1]);
}

/* With fewer than two rotary axes and no circle a fixed axis is left, if the machine has it. */
static int check_machine(const struct kinematic_chain *chain, const struct tool_axis_options *axis,
                         struct error *error)
{
    const struct path_options *c = &path_options;

    if (chain->n >= 2 || vec_length(axis->circle.pole) > 0 ||
        (c->fixed_given && !(c->lean > 0) && rotary_reaches(chain, axis->direction)))
        return 0;
    return error_set(error,
                     "-m %s: found %d of two rotary axes, expected --fixed with an axis it has, "
                     "and no --lean-limit",
                     path_options.machine, chain->n);
}

/* The machine whose rotary axes are to move least. */
static int read_machine(struct kinematic_chain *chain, struct tool_axis_options *axis,
                        struct error *error)
{
    const struct machine_options options = {.name = path_options.machine};
    struct machine machine;

    if (machine_options_read(&options, &machine, error) != 0)
        return -1;
    *chain = machine.chain;
    if (!path_options.fixed_given) {
        take_circle(chain, axis);
        leave_ends(chain);
    }
    return check_machine(chain, axis, error);
}

static int check_layers(struct error *error)
{
    const double most = 1e4 * path_options.radius; /* as of a part */
    double layers = (path_options.layers - 1) * path_options.depth;

    if (layers <= most)
        return 0;
    return error_set(error, "option --layers: found layers %g mm thick, expected at most %g mm",
                     layers, most);
}

/* The files of -g are there, as far as that can be seen without reading them. */
static int check_guard(struct error *error)
{
    const struct cli_list *files = &path_options.guard.files;
    struct reader r;

    for (size_t i = 0; i < files->n; i++) {
        if (reader_reads_once(files->item[i]))
            continue;
        if (reader_open(&r, files->item[i], error) != 0)
            return -1;
        reader_close(&r);
    }
    return 0;
}

/* What needs no mesh to be wrong: it may take minutes to be made. */
int path_options_check(struct tool_axis_options *axis, struct error *error)
{
    const struct mesh_region_options region = path_options_region();
    struct kinematic_chain chain;
    struct tool_body body;

    if (check_options(axis, error) != 0 || check_layers(error) != 0 ||
        mesh_region_check(&region, error) != 0 || check_guard(error) != 0)
        return -1;
    struct tool_axis_options with_circle = *axis;
    return read_machine(&chain, &with_circle, error) != 0 || read_body(&body, error) != 0 ? -1 : 0;
}

struct mesh_region_options path_options_region(void)
{
    return (struct mesh_region_options){.box = path_options.box_given ? path_options.box : NULL,
                                        .region = path_options.region,
                                        .faces = path_options.faces,
                                        .steep = path_options.steep,
                                        .polygons = &path_options.polygons,
                                        .up = {0, 0, 1},
                                        .border = BORDER * path_options.radius};
}

struct region path_options_points(void)
{
    struct mesh_region_options asked = path_options_region();

    return mesh_region_of_points(&asked);
}

/* The scan that guards, until path_options_guard. */
static struct guard_scan guard_scan;

int path_options_scan(const struct mesh *mesh, struct error *error)
{
    struct path_options *c = &path_options;
    struct scan_sources named = mesh->origin.scan;

    named.placed = mesh->origin.placed;
    named.place = mesh->origin.place;
    if (c->paper || (named.n == 0 && c->guard.files.n == 0))
        return 0;
    if (guard_scan_read(&c->guard, &named, c->radius, "the mesh", "guarded by the mesh alone",
                        &guard_scan, &c->unguarded, error) != 0)
        return -1;
    c->guarded = guard_scan.point.n > 0;
    if (c->tolerance == 0 && c->guarded)
        c->tolerance = 0.01;
    return 0;
}

/* A mesh of no scan is judged by its facets, too, unless its surfaces are at hand. */
static enum guard_facets facets_of(const struct mesh *mesh)
{
    if (mesh->normals_made)
        return GUARD_UPPER;
    return mesh->origin.scan.n > 0 || path_options.on_surfaces ? GUARD_CURVED : GUARD_NEAR;
}

/* Between the points of a mesh that guards, mm. */
static double wanted_gap(void)
{
    return sqrt(6 * SINK * path_options.radius);
}

/* NULL: so many points would be needed that it is no guard. */
static struct gouge_check *guard_of_mesh(const struct mesh *mesh, const struct mesh_edges *edges,
                                         int threads, struct error *error)
{
    struct vec3s points = {0};
    double wanted = wanted_gap();
    const struct guard_mesh_options how = {wanted, MOST_GUARD_POINTS, facets_of(mesh), threads};
    double spacing = guard_points_of_mesh(mesh, edges, &how, &points);
    double sink = spacing * spacing / (6 * path_options.radius);

    /* Slender facets have points along their longest side alone. */
    guard_points_of_edges(mesh, spacing, NULL, &points);

    if (spacing > wanted && sink > DEEP) {
        array_free(&points);
        error_set(error,
                  "the part is too large for a ball of radius %g to be kept clear of it: guard "
                  "points %.3f mm apart would be more than %g million: is the unit right? take a "
                  "larger ball, or a part of the mesh",
                  path_options.radius, wanted, MOST_GUARD_POINTS / 1e6);
        return NULL;
    }
    if (spacing > wanted)
        say("the part is large for this ball, which may sink by up to %.3f mm between guard points "
            "that are %.3f mm apart (%g million of them)",
            sink, spacing, MOST_GUARD_POINTS / 1e6);
    path_options.gap = spacing;
    return gouge_new(points, threads);
}

/* A part that is no longer than a ball can be guarded on: places along lines in it are counted; and
 * where a path may be. */
static int check_extent(const struct mesh *mesh, double radius, struct error *error)
{
    const double most = 1e4, reach = 1e8; /* as path_expect_reach */
    struct box box = box_around(mesh->vertex.item, mesh->vertex.n);
    double size = box_diagonal(&box), off = fmax(vec_length(box.low), vec_length(box.high));

    if (off >= reach)
        return error_set(error, "the part is %.6g mm from the origin, expected less than %g mm",
                         off, reach);
    if (size <= most * radius)
        return 0;
    return error_set(
        error,
        "the part is %.6g mm in size, expected at most %.6g mm for a ball of radius %g: "
        "is the unit right?",
        size, most * radius, radius);
}

/* A mesh that says neither what scan nor what surfaces it was made from, as after a tool that drops
 * comments. */
static void say_alone(const struct mesh *mesh)
{
    const struct path_options *c = &path_options;

    if (c->guard.files.n == 0 && !c->guard.none && mesh->origin.scan.n == 0 &&
        mesh->origin.surface.n == 0)
        say("the mesh names no scan: the tool is kept clear of its facets alone (-g FILE names the "
            "scan)");
}

/* Rims, edges and what is between points are guarded as of a part that is below them. */
static void check_facing(const struct mesh *mesh)
{
    const double one_side = 0.5, down = -0.2; /* length; cosine: 12 degrees */
    struct vec3 facing = mesh_facing(mesh);
    double length = vec_length(facing);

    if (path_options.guarded && length > one_side && facing.z < down * length)
        unmet_say(&path_options.unguarded,
                  "the surface faces down, along %.3f %.3f %.3f, and a scan is guarded as if the "
                  "part were below it, expected it turned over (cloud2mesh --matrix)",
                  facing.x / length, facing.y / length, facing.z / length);
}

int path_options_guard(const struct mesh *mesh, const struct mesh_edges *edges, double near,
                       int threads, struct gouge_check **guard, struct error *error)
{
    const struct path_options *c = &path_options;
    struct guard_read_options rule = {.radius = c->radius,
                                      .tolerance = c->tolerance,
                                      .noise = c->noise,
                                      .effort = c->effort,
                                      .threads = threads,
                                      .unmet = &path_options.unguarded};

    *guard = NULL;
    if (c->paper)
        return 0;
    if (check_extent(mesh, c->radius, error) != 0)
        return -1;
    say_alone(mesh);
    check_facing(mesh);
    *guard = c->guarded ? guard_read(&guard_scan, mesh, near, &rule, error)
                        : guard_of_mesh(mesh, edges, threads, error);
    path_options.said_noise = c->noise;
    path_options.noise = rule.noise;
    path_options.certain = rule.certain;
    path_options.doubtful = rule.doubtful;
    path_options.curtain = rule.curtain;
    path_options.believed = rule.believed;
    path_options.facets = rule.facets;
    if (rule.facets.n > 0)
        path_options.gap = wanted_gap();
    return *guard ? 0 : -1;
}

static void add_some(const struct vec3s *from, size_t step, struct vec3s *to)
{
    for (size_t i = 0; i < from->n; i += step)
        *array_push(to) = from->item[i];
}

/* How far a contact of the mesh may float above the scan that guards: as far as nearly all of its
 * points are off the mesh, and not so far that the ball would miss them. */
static double sink_of(const struct mesh *mesh, int threads)
{
    const double nearly = 0.995, most = 0.25; /* of the points; of the radius */
    enum { ENOUGH = 20000 };
    const struct path_options *c = &path_options;
    size_t n = c->certain.n + c->doubtful.n, step = n / ENOUGH + 1;
    struct vec3s some = {0};

    if (n == 0)
        return 0;
    add_some(&c->certain, step, &some);
    add_some(&c->doubtful, step, &some);
    double *distance = mem_alloc(some.n, sizeof *distance);
    mesh_distance(mesh, some.item, some.n, threads, distance);
    doubles_sort(distance, some.n);
    double sink = distance[(size_t)(nearly * (double)(some.n - 1))];
    free(distance);
    array_free(&some);
    return fmin(sink, most * c->radius);
}

/* Of the ball's centre: rows may run out so many radii below the part, and mm more; who judges a
 * program lets them go by a radius and 2 mm lower. */
static double floor_under(const struct mesh *mesh)
{
    const double radii = 8, more = 18;
    const struct vec3s *part = path_options.believed.n > 0 ? &path_options.believed : &mesh->vertex;

    return box_around(part->item, part->n).low.z - radii * path_options.radius - more;
}

/* The highest z of a vertex, mm. */
static double mesh_top(const struct mesh *mesh)
{
    double top = -HUGE_VAL;

    for (size_t v = 0; v < mesh->vertex.n; v++)
        top = fmax(top, mesh->vertex.item[v].z);
    return top;
}

/* The clearance plane: what was asked for, if it is above everything, or a safe one. */
static int clearance_plane(const struct mesh *mesh, const struct gouge_check *guard, double *z,
                           struct error *error)
{
    double top = fmax(mesh_top(mesh), guard ? gouge_top(guard) : -HUGE_VAL);

    top += (path_options.layers - 1) * path_options.depth;
    if (path_options.clearance < top)
        return error_set(error,
                         "option --clearance: found %g, expected more than the top of the part, %g",
                         path_options.clearance, top);
    *z = isnan(path_options.clearance) ? top + path_options.radius + 10 : path_options.clearance;
    return 0;
}

/* How much centres may be lifted to run smoothly: what is asked for, or a tenth of the tolerance
 * and over a scan where scallops are high a twentieth of them, up to the tolerance. */
static double smooth_of(double tolerance)
{
    const struct path_options *c = &path_options;
    double high = c->guarded ? fmin(tolerance, c->scallop / 20) : 0;

    return c->smooth >= 0 ? c->smooth : fmax(tolerance / 10, high);
}

double path_options_row_scallop(void)
{
    const double share = 0.7; /* of what they may be lifted: so much are those where most stays */
    const double tolerance = path_options.tolerance > 0 ? path_options.tolerance : 0.01;
    double more = smooth_of(tolerance) - tolerance / 10;

    if (path_options.paper || path_options.smooth >= 0 || more <= 0)
        return path_options.scallop;
    return path_options.scallop - share * more;
}

/* Over a scan, where less stays than scallops may be high, they may be lifted by a part of that. */
static void smooth_more(struct toolpath *t)
{
    const double raise = 1 / 3.0, full = 0.1, sigmas = 1.5; /* of scallop, and noise */
    const struct path_options *c = &path_options;

    if (c->smooth >= 0 || !c->guarded)
        return;
    t->rule.raise = raise * c->scallop;
    t->rule.full = full * c->scallop + sigmas * fmax(c->noise, 0);
}

/* As published, and of a scan that is not to be looked at, what stays is told and no more. */
static bool is_unlooked(const struct mesh *mesh)
{
    return !path_options.guarded && (path_options.paper || mesh->origin.scan.n > 0);
}

int path_options_rules(const struct mesh *mesh, const struct gouge_check *guard, double distance,
                       struct toolpath *t, struct error *error)
{
    const struct path_options *c = &path_options;

    t->rule = (struct toolpath_options){.radius = c->radius,
                                        .feed = c->feed,
                                        .plunge = c->plunge,
                                        .approach = c->approach,
                                        .longest = 3 * distance,
                                        .avoid = c->avoid || is_unlooked(mesh)};
    t->rule.skip = c->avoid;
    t->rule.scallop = c->scallop;
    t->rule.one_way = c->one_way;
    t->plane = -HUGE_VAL;
    t->rule.play = RADIANS(c->play);
    t->rule.rate = RADIANS(c->rate);
    t->rule.lean = RADIANS(c->lean);
    t->rule.turn = RADIANS(c->turn);
    t->rule.spacing = distance;
    if (read_machine(&t->rule.chain, &t->lift.axis, error) != 0)
        return -1;
    t->path->head.body_given = true;
    if (read_body(&t->path->head.body, error) != 0)
        return -1;
    if (!c->paper)
        tool_options_say(&t->path->head.body, c->radius);
    t->rule.holder = tool_body_profile(&t->path->head.body, c->radius);
    if (c->gap > 0)
        t->rule.holder = holder_cornered(&t->rule.holder, c->gap);
    t->lift.guard = guard;
    t->lift.limit = c->limit > 0 ? c->limit : c->radius;
    t->lift.tolerance = c->tolerance > 0 ? c->tolerance : 0.01;
    t->lift.between = c->tolerance > 0;
    t->lift.sink = guard ? sink_of(mesh, t->threads) : 0;
    t->lift.step = 0.05;
    t->rule.smooth = smooth_of(t->lift.tolerance);
    smooth_more(t);
    if (guard && path_options_row_scallop() < c->scallop)
        note("centres are lifted by up to %g mm more where they run smoothly then, and by %g where "
             "that leaves no more than %g: rows for scallops of %g mm",
             t->rule.smooth, t->rule.raise, c->scallop, path_options_row_scallop());
    t->lift.aside =
        t->rule.smooth > 0 && c->scallop > 0 ? ASIDE * scallop_step(c->scallop, c->radius, 0) : 0;
    bool scan = c->guarded && c->facets.n == 0; /* over facets no mean of normals: they are exact */
    t->lift.even = t->lift.aside > 0 && scan && c->avoid ? EVEN * c->radius : 0;
    t->lift.uncut = 3 * t->lift.tolerance + 2 * fmax(c->noise, 0);
    /* facets that are off by so much say no more */
    if (!c->guarded && isfinite(mesh->origin.ledger))
        t->lift.uncut += mesh->origin.ledger;
    t->rule.floor = c->paper ? -HUGE_VAL : floor_under(mesh);
    return clearance_plane(mesh, guard, &t->rule.clearance, error);
}

/* A name for the part: that of the file that its mesh was made from, or PART. */
static const char *part_name(const struct mesh *mesh)
{
    const char *source = mesh->origin.source;

    if (!source)
        return "PART";
    const char *slash = strrchr(source, '/');
    return slash ? slash + 1 : source;
}

/* `tool` spent what straight lines spend. */
static void fill_head(const struct mesh *mesh, const char *tool, const struct toolpath *t)
{
    const struct path_options *c = &path_options;
    const struct mesh_origin *origin = &mesh->origin;
    const char *name = c->partno ? c->partno : part_name(mesh);
    const double r = c->radius, cutter[7] = {2 * r, r, 0, r, 0, 0, fmax(60, 4 * r)};
    struct path_head *head = &t->path->head;

    head->partno = mem_string(name, strlen(name));
    head->multax = t->lift.axis.kind != AXIS_FIXED || t->lift.axis.direction.z < 1 || t->leaned > 0;
    memcpy(head->cutter, cutter, sizeof cutter);
    head->cutter_n = 7;
    head->tool = c->tool;
    head->spindle = c->spindle;
    head->coolant = c->coolant + 1;
    head->clearance = fmax(t->rule.clearance, t->plane);
    head->scallop = c->scallop;
    head->noise_given = c->guarded && c->said_noise >= 0;
    head->noise = c->said_noise;
    head->region = path_options_points();
    head->region.polygons = region_polygons_copy(&head->region.polygons);
    if (origin->maker && isfinite(origin->ledger))
        path_spend(t->path, origin->maker, origin->ledger);
    /* Between points of the mesh the straight lines are what was checked; without points put
     * between, it is the smooth curve, and who goes straight leaves it. */
    if (c->tolerance > 0)
        path_spend(t->path, tool, c->tolerance);
    head->chord = c->tolerance > 0 ? NAN : t->chord;
    head->scan = scan_sources_copy(&guard_scan.source);
    if (head->scan.n == 0 && origin->scan.n == 0 && !c->paper)
        head->mesh = scan_sources_copy(&origin->itself);
    unmets_add_all(&head->unmet, &origin->unmet);
    unmets_add_all(&head->unmet, &path_options.unguarded);
}

void path_options_begin(const struct mesh *mesh, const char *tool, const char *output,
                        struct toolpath *t)
{
    t->streams = path_options.tolerance > 0;
    t->output = output;
    if (t->streams)
        fill_head(mesh, tool, t);
}

void path_options_end(const struct mesh *mesh, const char *tool, struct toolpath *t)
{
    if (t->streams) {
        path_write_end(t->out, &t->path->head);
    } else {
        fill_head(mesh, tool, t);
        t->out = out_open(t->output);
        path_write(t->out, t->path);
    }
    out_close(t->out);
}
