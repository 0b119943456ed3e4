/*
 * meshnorm - rows of a mesh to a path: contact points, normals, tool centres, tool axes, tips
 * (paper 1, 3.3 to 3.5).
 */
#include <stdlib.h>
#include <string.h>

#include "cli.h"
#include "part.h"
#include "rows.h"
#include "scan.h"
#include "toolpath.h"

static double radius, tilt = 15, lead, feed = 800, plunge, spindle = 8000, clearance = NAN;
static double approach = 5, depth = 0.3, tolerance, limit;
static double fixed_axis[3], to_point[3], from_point[3], circle[7];
static int normals, tool = 1, coolant = 1, layers = 1;
static bool one_way, paper, fixed_given, to_given, from_given, circle_given, lean_given;
static const char *partno;
static struct cli_list guards;

/* clang-format off */
static const struct cli_option options[] = {
    {'r', "radius", "R", "radius of the ball (needed)",
     CLI_NUMBER, &radius, CLI_POSITIVE, 0, 0, NULL},
    {'g', "guard", "FILE", "keep the ball clear of all points of this scan, not only of the mesh\n"
     "(may be given several times)", CLI_LIST, &guards, 0, 0, 0, NULL},
    {'e', "tolerance", "E", "put points between the nodes: straight lines stay within E of the\n"
     "smooth curve and no deeper in the part (0.01 with -g, else nodes only)",
     CLI_NUMBER, &tolerance, 0.0001, 10, 0, NULL},
    {0, "paper", NULL, "as published: nodes only, nothing is lifted, links are not checked",
     CLI_FLAG, &paper, 0, 0, 0, NULL},
    {0, "normals", "mesh|facet|gouraud|central", "the mesh's own (default), the mean of the "
     "facets' (eq 8) or of the\nneighbours' (eq 7), central differences on a regular grid",
     CLI_CHOICE, &normals, 0, 0, 0, NULL},
    {0, "limit", "H", "lift no centre by more than H, and exit 3 where it takes more\n"
     "(default: the radius; what can't be reached is passed over and told)",
     CLI_NUMBER, &limit, CLI_POSITIVE, 0, 0, NULL},
    {0, "tilt", "DEG", "lean the axis off the normal, sideways, positive to the next row (15)",
     CLI_NUMBER, &tilt, -80, 80, 0, &lean_given},
    {0, "lead", "DEG", "lean it in the direction of the feed (0)",
     CLI_NUMBER, &lead, -80, 80, 0, &lean_given},
    {0, "fixed", "I,J,K", "the same axis everywhere, from the tip to the spindle",
     CLI_NUMBERS, fixed_axis, 0, 0, 3, &fixed_given},
    {0, "to-point", "X,Y,Z", "the spindle points to a point above the part",
     CLI_NUMBERS, to_point, 0, 0, 3, &to_given},
    {0, "from-point", "X,Y,Z", "the spindle points away from a point below the surface",
     CLI_NUMBERS, from_point, 0, 0, 3, &from_given},
    {0, "circle", "X,Y,Z,I,J,K,R", "the axis goes through the nearest point of a circle: centre,\n"
     "axis, radius", CLI_NUMBERS, circle, 0, 0, 7, &circle_given},
    {0, "one-way", NULL, "cut all rows in one direction (default: zig-zag)",
     CLI_FLAG, &one_way, 0, 0, 0, NULL},
    {0, "layers", "N", "cut in N layers, the outermost first (1)",
     CLI_COUNT, &layers, 1, 1000, 0, NULL},
    {0, "depth", "MM", "what a layer takes off, along the normal (0.3)",
     CLI_NUMBER, &depth, CLI_POSITIVE, 0, 0, NULL},
    {0, "clearance", "Z", "height of the tip on the clearance plane (default: top of the part and\n"
     "its layers + radius + 10)", CLI_NUMBER, &clearance, 0, 0, 0, NULL},
    {0, "approach", "MM", "last bit of the way down, at the plunge feed (5)",
     CLI_NUMBER, &approach, CLI_POSITIVE, 0, 0, NULL},
    {0, "feed", "F", "cutting feed, mm/min (800)", CLI_NUMBER, &feed, CLI_POSITIVE, 0, 0, NULL},
    {0, "plunge", "F", "feed of the last bit down (default: half the cutting feed)",
     CLI_NUMBER, &plunge, CLI_POSITIVE, 0, 0, NULL},
    {0, "spindle", "RPM", "speed of the spindle (8000)",
     CLI_NUMBER, &spindle, CLI_POSITIVE, 0, 0, NULL},
    {0, "tool", "N", "number of the tool (1)", CLI_COUNT, &tool, 1, 99999999, 0, NULL},
    {0, "coolant", "off|on|mist", "coolant (on)", CLI_CHOICE, &coolant, 0, 0, 0, NULL},
    {0, "partno", "TEXT", "name of the part (default: after the mesh's source)",
     CLI_TEXT, &partno, 0, 0, 0, NULL},
    {0}};
/* clang-format on */

static struct vec3 vec_of(const double v[3])
{
    return vec(v[0], v[1], v[2]);
}

static struct vec3 unit_of(const double v[3], const char *option)
{
    struct vec3 u = vec_unit(vec_of(v));

    if (vec_length(u) == 0)
        die_usage("option %s: found a direction of no length", option);
    return u;
}

static struct axis_rule axis_rule(void)
{
    struct axis_rule rule = {.kind = AXIS_LEAN, .tilt = RADIANS(tilt), .lead = RADIANS(lead)};

    if (fixed_given + to_given + from_given + circle_given + lean_given > 1)
        die_usage("found two rules for the axis, expected one of --tilt/--lead, --fixed, "
                  "--to-point, --from-point, --circle");
    if (fixed_given) {
        rule.kind = AXIS_FIXED;
        rule.direction = unit_of(fixed_axis, "--fixed");
    } else if (to_given) {
        rule.kind = AXIS_TO_POINT;
        rule.point = vec_of(to_point);
    } else if (from_given) {
        rule.kind = AXIS_FROM_POINT;
        rule.point = vec_of(from_point);
    } else if (circle_given) {
        rule.kind = AXIS_CIRCLE;
        rule.point = vec_of(circle);
        rule.direction = unit_of(circle + 3, "--circle");
        rule.radius = circle[6];
    }
    return rule;
}

static void check_options(void)
{
    if (radius == 0)
        die_usage("found no radius of the ball, expected -r R");
    if (paper && (guards.n > 0 || tolerance > 0))
        die_usage("found --paper with -g or -e: the paper has neither");
    if (plunge == 0)
        plunge = feed / 2;
    if (tolerance == 0 && guards.n > 0)
        tolerance = 0.01;
}

static void read_mesh(const char *file, struct mesh *mesh, struct rows *rows)
{
    struct error error;

    if (part_read(file, (enum part_normals)normals, mesh, &error) != 0)
        die_error(&error);
    if (rows_find(mesh, rows, &error) != 0)
        die("%s: %s", file, error.text);
    if (rows->loose > 0)
        say("%zu nodes belong to no facet and are left out", rows->loose);
}

/* The whole scan, or the mesh so finely that the ball sinks in by less than 0.002 mm. */
static struct guard *make_guard(const struct mesh *mesh, const struct rows *rows)
{
    struct error error;

    if (paper)
        return NULL;
    if (guards.n == 0)
        return guard_from_mesh(mesh, sqrt(6 * 0.002 * radius));
    struct guard *guard = scan_guard(&guards, mesh, rows->distance, &error);
    if (!guard)
        die_error(&error);
    return guard;
}

/* The clearance plane: what was asked for, if it is above everything, or a safe one. */
static double clearance_plane(const struct mesh *mesh, const struct guard *guard)
{
    double top = fmax(part_top(mesh), guard ? guard_top(guard) : -HUGE_VAL);

    top += (layers - 1) * depth;
    if (clearance < top)
        die_usage("option --clearance: found %g, expected more than the top of the part, %g",
                  clearance, top);
    return isnan(clearance) ? top + radius + 10 : clearance;
}

static void set_rules(const struct mesh *mesh, const struct rows *rows, const struct guard *guard,
                      struct toolpath *t)
{
    t->rule = (struct toolpath_rule){.radius = radius,
                                     .feed = feed,
                                     .plunge = plunge,
                                     .clearance = clearance_plane(mesh, guard),
                                     .approach = approach,
                                     .longest = 3 * rows->distance,
                                     .reach = limit > 0};
    t->lift.guard = guard;
    t->lift.limit = limit > 0 ? limit : radius;
    t->lift.tolerance = tolerance > 0 ? tolerance : 0.01;
    t->lift.between = tolerance > 0;
    t->lift.step = 0.05;
    t->lift.feed.side = rows->side;
}

static void make_head(const struct mesh *mesh, const struct toolpath *t)
{
    const struct mesh_origin *origin = &mesh->origin;
    const char *name = partno ? partno : part_name(mesh);
    const double cutter[7] = {2 * radius, radius, 0, radius, 0, 0, fmax(60, 4 * radius)};
    struct path_head *head = &t->path->head;

    head->partno = mem_string(name, strlen(name));
    head->multax = t->lift.axis.kind != AXIS_FIXED || t->lift.axis.direction.z < 1;
    memcpy(head->cutter, cutter, sizeof cutter);
    head->cutter_n = 7;
    head->tool = tool;
    head->spindle = spindle;
    head->coolant = coolant + 1;
    head->clearance = t->rule.clearance;
    if (origin->maker && isfinite(origin->ledger))
        path_spend(t->path, origin->maker, origin->ledger);
    /* Between nodes the straight lines are what was checked; without points between, it is the
     * smooth curve, and who goes straight leaves it. */
    if (tolerance > 0)
        path_spend(t->path, "meshnorm", tolerance);
    head->chord = tolerance > 0 ? NAN : t->chord;
}

/* All strips of the row that begins with strip s, in one pass; returns the first of the next. */
static size_t make_pass(const struct mesh *mesh, const struct rows *rows, size_t s, size_t pass,
                        struct toolpath *t)
{
    bool back = !one_way && pass % 2 == 0;
    size_t end = s;
    struct contact *contact = mem_alloc(rows->node.n, sizeof *contact);

    while (end < rows->strip.n && rows->strip.item[end].row == rows->strip.item[s].row)
        end++;
    for (size_t i = s; i < end; i++) {
        struct strip strip = rows->strip.item[back ? end - 1 - (i - s) : i];
        size_t n = strip.to - strip.from;
        for (size_t k = 0; k < n; k++) {
            size_t v = rows->node.item[back ? strip.to - 1 - k : strip.from + k];
            contact[k] = (struct contact){mesh->vertex.item[v], mesh->normal.item[v]};
        }
        toolpath_strip(t, pass, contact, n, vec_scale(back ? -1 : 1, rows->along));
    }
    free(contact);
    return end;
}

static void make_path(const struct mesh *mesh, const struct rows *rows, struct toolpath *t)
{
    size_t pass = 1;

    for (int layer = layers - 1; layer >= 0; layer--) {
        t->lift.offset = radius + layer * depth;
        for (size_t s = 0; s < rows->strip.n; pass++) {
            s = make_pass(mesh, rows, s, pass, t);
            progress("rows", s, rows->strip.n);
        }
    }
    toolpath_end(t);
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "meshnorm",
                      .usage = "-r R [options] [FILE]",
                      .about = "Makes a tool path from the rows of a mesh: mesh stream in, path "
                               "stream out.",
                      .option = options};
    struct mesh mesh = {0};
    struct rows rows = {0};
    struct path path = {0};

    cli_parse(&cli, argc, argv);
    check_options();
    if (cli.files > 1)
        die_usage("found %d files, expected one mesh", cli.files);
    struct toolpath t = {.path = &path, .lift = {.axis = axis_rule()}};
    read_mesh(cli.file[0], &mesh, &rows);
    struct guard *guard = make_guard(&mesh, &rows);
    set_rules(&mesh, &rows, guard, &t);

    make_path(&mesh, &rows, &t);
    make_head(&mesh, &t);
    struct out *out = out_open(cli.output);
    path_write(out, &path);
    out_close(out);
    note("%zu nodes in %zu strips", rows.node.n, rows.strip.n);
    int status = toolpath_conclude(&t);

    path_free(&path);
    guard_free(guard);
    rows_free(&rows);
    mesh_free(&mesh);
    return status;
}
