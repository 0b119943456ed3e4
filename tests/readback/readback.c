/*
 * readback - the tests' own reader: an NC program run as the control would run it, compared with
 * the path that it was made from, and rolled over the scan or over a surface known exactly; and the
 * figures of a mesh.
 *
 * Exit status: 0 all holds, 1 the program or path can't be read, 2 usage, 3 a limit is passed.
 */
#include <stdio.h>
#include <stdlib.h>

#include "base/array.h"
#include "simulate/axis_limits.h"
#include "ball.h"
#include "canon.h"
#include "cl.h"
#include "base/cli.h"
#include "io/cloud/cloud.h"
#include "math/kdtree.h"
#include "machine/machine.h"
#include "mesh_sums.h"
#include "ncread/ncread_state.h"
#include "panel.h"
#include "sweep.h"

static const struct ncread_dialect *const dialects[] = {
    &ncread_fanuc, &ncread_siemens, &ncread_heidenhain, &ncread_linuxcnc, &canon};
enum { CONTROL_NONE = sizeof dialects / sizeof *dialects };

struct options {
    int control, axes;
    bool no_tcp, reversed, panel, no_steps, mesh;
    const char *path, *scan, *machine;
    struct cli_list set;
    double tolerance, axis, radius, deeper, nodes;
};

static void count_line(const char *what, const struct nc_motion *motion)
{
    struct samples chain = {0};
    sweep_chain(motion, &chain);
    printf("%s: ", what);
    if (motion->passes)
        printf("%zu passes, ", motion->passes);
    else
        printf("%zu blocks, ", motion->blocks);
    printf("%zu lines, %zu arcs, %zu curves, %zu poles, %.1f mm cut\n", motion->lines, motion->arcs,
           motion->curves, motion->poles, sweep_length(&chain));
    array_free(&chain);
}

/* One direction of the comparison; false when it is beyond the limits. */
static bool walk(const char *what, const struct nc_motion *motion, const struct samples *from,
                 const struct samples *to, const struct options *o)
{
    struct sweep sweep = sweep_walk(from, to, o->tolerance, o->axis);
    if (from->n == 0)
        return true;
    char place[60];
    ncread_place(&motion->piece.item[from->item[sweep.tip_at].piece], place, sizeof place);
    printf("%s: tip %.6f mm at %s", what, sweep.tip, place);
    ncread_place(&motion->piece.item[from->item[sweep.tool_axis_at].piece], place, sizeof place);
    printf(", axis %.5f degrees at %s", sweep.axis, place);
    if (from->radius != 0)
        printf(", ball %.6f mm", sweep.ball);
    printf("\n");
    if (!sweep.beyond)
        return true;
    struct vec3 p = from->item[sweep.first].pose.p;
    ncread_place(&motion->piece.item[from->item[sweep.first].piece], place, sizeof place);
    say("%s: %s: beyond the tolerance first at %.3f %.3f %.3f", motion->name, place, p.x, p.y, p.z);
    return false;
}

static bool compare(const struct nc_motion *program, const struct nc_motion *path, double radius,
                    const struct options *o)
{
    double weight = fmin(100, o->tolerance / RADIANS(o->axis)); /* both limits count alike */
    struct samples from = {.weight = weight, .radius = radius}, to = from;
    struct error error;
    sweep_chain(program, &from);
    sweep_chain(path, &to);
    bool held = walk("program on path", program, &from, &to, o);
    held = walk("path on program", path, &to, &from, o) && held;
    if (sweep_rapids(program, path, o->tolerance, o->axis, &error) < 0) {
        say("%s", error.text);
        held = false;
    }
    array_free(&from);
    array_free(&to);
    return held;
}

static double scan_distance(const void *tree, struct vec3 p)
{
    size_t index;
    double distance2;
    kdtree_nearest(tree, p, 1, &index, &distance2);
    return sqrt(distance2);
}

static double exact_distance(const void *unused, struct vec3 p)
{
    (void)unused;
    return panel_distance(p);
}

static bool roll(const struct nc_motion *motion, const struct surface *surface, double radius,
                 const struct options *o)
{
    struct depth depth = ball_depth(motion, radius, surface);
    struct depth nodes = ball_nodes(motion, radius, surface);
    char place[60];
    if (motion->track == NC_MOTION_CONTACT || !(radius > 0))
        die("%s: no ball: it tracks contact points, or -r is missing", motion->name);
    if (isfinite(nodes.worst))
        printf("ball at the contact points: deepest %.6f mm\n", nodes.worst);
    ncread_place(&motion->piece.item[depth.piece], place, sizeof place);
    printf("ball: deepest %.6f mm at %s, centre %.3f %.3f %.3f\n", depth.worst, place, depth.ball.x,
           depth.ball.y, depth.ball.z);
    if (nodes.worst > o->nodes)
        say("%s: %.4f mm deep at a contact point, limit %g", motion->name, nodes.worst, o->nodes);
    if (depth.worst > o->deeper)
        say("%s: %s: the ball is %.4f mm deep in the part, limit %g", motion->name, place,
            depth.worst, o->deeper);
    return depth.worst <= o->deeper && nodes.worst <= o->nodes;
}

static bool gouges(const struct nc_motion *motion, double radius, const struct options *o)
{
    struct error error;
    struct vec3s points = {0};
    struct cloud_count count = {0};
    bool held = true;
    if (o->panel)
        held = roll(motion, &(struct surface){exact_distance, NULL}, radius, o);
    if (!o->scan)
        return held;
    if (cloud_read(o->scan, 1, &points, &count, &error) < 0)
        die_error(&error);
    struct kdtree *tree = kdtree_new(points.item, points.n);
    held = roll(motion, &(struct surface){scan_distance, tree}, radius, o) && held;
    kdtree_free(tree);
    array_free(&points);
    return held;
}

static struct machine read_machine(const struct options *o)
{
    struct machine machine = machine_default();
    struct error error;
    if (machine_read(&machine, o->machine, &error) != 0)
        die_error(&error);
    for (size_t i = 0; i < o->set.n; i++)
        if (machine_set(&machine, o->set.item[i], &error) != 0)
            die_error(&error);
    if (machine_finish(&machine, &error) != 0)
        die_error(&error);
    return machine;
}

/* How far the rotary axes turn in a rapid block in which the tip stays, degrees. */
static double turn_on_the_spot(const struct nc_motion *motion, size_t i)
{
    const struct nc_piece *piece = &motion->piece.item[i];
    if (i == 0 || !piece->rapid || piece->interpolation != AXIS_ROTARY_LINEAR)
        return 0;
    struct nc_motion_pose a = nc_motion_at(motion, piece, 0), b = nc_motion_at(motion, piece, 1);
    struct vec3 turn = vec_sub(piece->q[1], piece->q[0]);
    return vec_distance(a.p, b.p) < 0.01 ? vec_length(turn) : 0;
}

/* How far from the end of the last cut the piece starts, mm. */
static double off_cut(const struct nc_motion *motion, size_t i)
{
    size_t cut = i;
    while (cut > 0 && motion->piece.item[cut].rapid)
        cut--;
    if (motion->piece.item[cut].rapid)
        return HUGE_VAL;
    return vec_distance(nc_motion_at(motion, &motion->piece.item[cut], 1).p,
                        nc_motion_at(motion, &motion->piece.item[i], 0).p);
}

/*
 * The axes: no place beyond the travel, and how often the program turns back, by 30 degrees or more
 * in rapid blocks on the spot, off the part (the least distance from the end of the last cut).
 */
static bool drive(const struct nc_motion *motion, const struct options *o)
{
    struct machine machine = read_machine(o);
    bool combined = machine.feeds == FEEDS_COMBINED || dialects[o->control] == &ncread_heidenhain;
    struct axis_limits limits = {.combined = !machine.tcp && combined};
    size_t turns = 0, first = 0; /* piece of a turn */
    double turned = 0, least = HUGE_VAL;
    for (int k = 0; k < NC_AXES; k++) {
        limits.min[k] = machine.min[k];
        limits.max[k] = machine.max[k];
        limits.rapid[k] = machine.rapid[k];
    }
    struct axis_use load = axis_limits_check(motion, &limits);
    for (size_t i = 1; i < motion->piece.n; i++) {
        double turn = turn_on_the_spot(motion, i);
        if (turned == 0)
            first = i;
        double off = turned < 30 && turned + turn >= 30 ? off_cut(motion, first) : HUGE_VAL;
        if (off < HUGE_VAL) { /* before the first cut the axes have to turn somewhere */
            least = fmin(least, off);
            turns++;
        }
        turned = turn > 0 ? turned + turn : 0;
    }
    printf("axes: %zu turns back, %.3f mm off; beyond the travel %zu, too fast %zu, jump %.3f\n",
           turns, turns ? least : 0, load.beyond, load.fast, load.jump.value);
    if (load.beyond == 0)
        return true;
    say("%s: axis %c at %.5f, beyond its travel", motion->name, "XYZABC"[load.travel.axis],
        load.travel.value);
    return false;
}

/* The operand: a program, or itself a path. */
static void read_operand(const char *file, const struct options *o, struct nc_motion *motion,
                         double *radius)
{
    struct error error;
    struct cl path = {0};
    struct machine machine;
    struct ncread_options setup = {
        .tcp = !o->no_tcp,
        .kinematics = verify_kinematics_trunnion(o->axes ? 'B' : 'A', o->reversed ? -1 : 1)};
    if (o->machine) {
        machine = read_machine(o);
        setup.kinematics = ncread_kinematics(&machine);
        setup.tcp = machine.tcp && !o->no_tcp;
        setup.tool = machine.tool;
        setup.tools = machine.tools;
        ncread_wraps(&machine, &setup.kinematics, setup.wraps);
    }
    if (o->control != CONTROL_NONE) {
        setup.dialect = dialects[o->control];
        if (ncread_read(file, &setup, motion, &error) < 0)
            die_error(&error);
        return;
    }
    if (cl_read(file, &path, motion, &error) < 0)
        die_error(&error);
    *radius = cl_ball(&path);
}

static int run(const char *file, const struct options *o)
{
    struct error error;
    struct cl path = {0};
    struct nc_motion motion = {0}, wanted = {0};
    double radius = -1;
    bool held = true;
    read_operand(file, o, &motion, &radius);
    count_line(o->control == CONTROL_NONE ? "path" : "program", &motion);
    if (o->path) {
        if (cl_read(o->path, &path, &wanted, &error) < 0)
            die_error(&error);
        count_line("its path", &wanted);
        radius = cl_ball(&path);
        motion.track = wanted.track;
        if (o->no_steps) {
            sweep_join_steps(&motion);
            sweep_join_steps(&wanted);
        }
        double up = wanted.track == NC_MOTION_CENTRE ? -radius : radius;
        held = compare(&motion, &wanted, radius > 0 ? up : 0, o);
    }
    if (o->machine && o->control != CONTROL_NONE)
        held = drive(&motion, o) && held;
    if (o->panel || o->scan)
        held = gouges(&motion, o->radius > 0 ? o->radius : radius, o) && held;
    nc_motion_free(&motion);
    nc_motion_free(&wanted);
    return held ? EXIT_DONE : EXIT_UNMET;
}

/* Vertices, facets, area, volume, edges that are open and that are uneven, normals off one, least
 * cosine of a normal. */
static int tell_of_mesh(const char *file)
{
    struct error error;
    struct mesh_sums sums;

    if (mesh_sums_read(file, &sums, &error) < 0)
        die_error(&error);
    printf("%zu %zu %.10g %.10g %zu %zu %.9f %.4f\n", sums.vertices, sums.facets, sums.area,
           sums.volume, sums.open, sums.uneven, sums.off, sums.least);
    return EXIT_DONE;
}

int main(int argc, char **argv)
{
    struct options o = {.control = CONTROL_NONE,
                        .tolerance = 0.001,
                        .axis = 0.01,
                        .deeper = HUGE_VAL,
                        .nodes = HUGE_VAL};
    const struct cli_option option[] = {
        {'c', "control", "fanuc|siemens|heidenhain|linuxcnc|canon|none",
         "the operand is a program for this control; canon: what LinuxCNC's\n"
         "interpreter makes of it (rs274); none (default): it is a path",
         CLI_CHOICE, &o.control, 0, 0, 0, NULL},
        {'m', "machine", "NAME", "the machine: its axes, TCP or not, travel", CLI_TEXT, &o.machine,
         0, 0, 0, NULL},
        {0, "set", "KEY=VALUE", "one key of it; may be given again", CLI_LIST, &o.set, 0, 0, 0,
         NULL},
        {0, "axes", "ac|bc", "rotary axes of the machine (ac)", CLI_CHOICE, &o.axes, 0, 0, 0, NULL},
        {0, "no-tcp", NULL, "the machine has no tool centre point control", CLI_FLAG, &o.no_tcp, 0,
         0, 0, NULL},
        {0, "reversed", NULL, "its rotary axes turn against the ISO sense", CLI_FLAG, &o.reversed,
         0, 0, 0, NULL},
        {0, "path", "FILE", "the path that the program was made from", CLI_TEXT, &o.path, 0, 0, 0,
         NULL},
        {0, "no-steps", NULL, "drilling steps of program and path joined: a control has its own",
         CLI_FLAG, &o.no_steps, 0, 0, 0, NULL},
        {'e', "tolerance", "MM", "of the tip against the path (0.001)", CLI_NUMBER, &o.tolerance, 0,
         1e3, 0, NULL},
        {0, "axis", "DEG", "of the tool axis against the path (0.01)", CLI_NUMBER, &o.axis, 0, 180,
         0, NULL},
        {0, "mesh", NULL, "the operand is a mesh: its figures", CLI_FLAG, &o.mesh, 0, 0, 0, NULL},
        {0, "scan", "FILE", "roll the ball over these points", CLI_TEXT, &o.scan, 0, 0, 0, NULL},
        {0, "panel", NULL, "roll the ball over the exact panel", CLI_FLAG, &o.panel, 0, 0, 0, NULL},
        {'r', "radius", "MM", "of the ball (the path's CUTTER)", CLI_NUMBER, &o.radius,
         CLI_POSITIVE, 1e6, 0, NULL},
        {0, "deeper", "MM", "the ball must go no deeper than this", CLI_NUMBER, &o.deeper, 0, 1e6,
         0, NULL},
        {0, "nodes", "MM", "nor than this at the contact points", CLI_NUMBER, &o.nodes, 0, 1e6, 0,
         NULL},
        {0},
    };
    struct cli cli = {.tool = "readback",
                      .usage = "[options] FILE",
                      .about = "run an NC program as the control would, and judge where it goes",
                      .option = option};
    cli_parse(&cli, argc, argv);
    if (cli.files != 1)
        die_usage("one program, path or mesh at a time");
    int status = o.mesh ? tell_of_mesh(cli.file[0]) : run(cli.file[0], &o);
    array_free(&o.set);
    if (fclose(stdout) != 0)
        die("writing the report failed");
    return status;
}
