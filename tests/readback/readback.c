/*
 * readback - the tests' own reader: an NC program run as the control would run it, compared with
 * the path that it was made from, and rolled over the scan or over a surface known exactly.
 *
 * Exit status: 0 all holds, 1 the program or path can't be read, 2 usage, 3 a limit is passed.
 */
#include <stdio.h>
#include <stdlib.h>

#include "ball.h"
#include "canon.h"
#include "cl.h"
#include "cli.h"
#include "cloud.h"
#include "ncread.h"
#include "kdtree.h"
#include "../panel.h"
#include "sweep.h"

static const struct ncread_dialect *const dialects[] = {&ncread_fanuc, &ncread_siemens,
                                                        &ncread_heidenhain, &canon};
enum { CONTROL_NONE = sizeof dialects / sizeof *dialects };

struct options {
    int control, axes;
    bool no_tcp, reversed, panel, no_steps;
    const char *path, *scan;
    double tolerance, axis, radius, deeper, nodes;
};

static void count_line(const char *what, const struct course *course)
{
    struct chain chain = {0};
    sweep_chain(course, &chain);
    printf("%s: ", what);
    if (course->passes)
        printf("%zu passes, ", course->passes);
    else
        printf("%zu blocks, ", course->blocks);
    printf("%zu lines, %zu arcs, %zu curves, %zu poles, %.1f mm cut\n", course->lines, course->arcs,
           course->curves, course->poles, sweep_length(&chain));
    array_free(&chain);
}

/* One direction of the comparison; false when it is beyond the limits. */
static bool walk(const char *what, const struct course *course, const struct chain *from,
                 const struct chain *to, const struct options *o)
{
    struct sweep sweep = sweep_walk(from, to, o->tolerance, o->axis);
    if (from->n == 0)
        return true;
    char place[60];
    ncread_place(&course->piece.item[from->item[sweep.tip_at].piece], place, sizeof place);
    printf("%s: tip %.6f mm at %s", what, sweep.tip, place);
    ncread_place(&course->piece.item[from->item[sweep.axis_at].piece], place, sizeof place);
    printf(", axis %.5f degrees at %s\n", sweep.axis, place);
    if (!sweep.beyond)
        return true;
    struct vec3 p = from->item[sweep.first].pose.p;
    ncread_place(&course->piece.item[from->item[sweep.first].piece], place, sizeof place);
    say("%s: %s: beyond the tolerance first at %.3f %.3f %.3f", course->name, place, p.x, p.y, p.z);
    return false;
}

static bool compare(const struct course *program, const struct course *path,
                    const struct options *o)
{
    struct chain from = {0}, to = {0};
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

static bool roll(const struct course *course, const struct surface *surface, double radius,
                 const struct options *o)
{
    struct depth depth = ball_depth(course, radius, surface);
    struct depth nodes = ball_nodes(course, radius, surface);
    char place[60];
    if (course->track == COURSE_CONTACT || !(radius > 0))
        die("%s: no ball: it tracks contact points, or -r is missing", course->name);
    if (isfinite(nodes.worst))
        printf("ball at the contact points: deepest %.6f mm\n", nodes.worst);
    ncread_place(&course->piece.item[depth.piece], place, sizeof place);
    printf("ball: deepest %.6f mm at %s, centre %.3f %.3f %.3f\n", depth.worst, place,
           depth.ball.x, depth.ball.y, depth.ball.z);
    if (nodes.worst > o->nodes)
        say("%s: %.4f mm deep at a contact point, limit %g", course->name, nodes.worst, o->nodes);
    if (depth.worst > o->deeper)
        say("%s: %s: the ball is %.4f mm deep in the part, limit %g", course->name, place,
            depth.worst, o->deeper);
    return depth.worst <= o->deeper && nodes.worst <= o->nodes;
}

static bool gouges(const struct course *course, double radius, const struct options *o)
{
    struct error error;
    struct vec3s points = {0};
    struct cloud_count count = {0};
    bool held = true;
    if (o->panel)
        held = roll(course, &(struct surface){exact_distance, NULL}, radius, o);
    if (!o->scan)
        return held;
    if (cloud_read(o->scan, &points, &count, &error) < 0)
        die_error(&error);
    struct kdtree *tree = kdtree_new(points.item, points.n);
    held = roll(course, &(struct surface){scan_distance, tree}, radius, o) && held;
    kdtree_free(tree);
    array_free(&points);
    return held;
}

/* The operand: a program, or itself a path. */
static void read_operand(const char *file, const struct options *o, struct course *course,
                         double *radius)
{
    struct error error;
    struct path path = {0};
    struct ncread_setup setup = {.tcp = !o->no_tcp,
                                 .rig = rig_trunnion(o->axes ? 'B' : 'A', o->reversed ? -1 : 1)};
    if (o->control != CONTROL_NONE) {
        setup.dialect = dialects[o->control];
        if (ncread_read(file, &setup, course, &error) < 0)
            die_error(&error);
        return;
    }
    if (cl_read(file, &path, course, &error) < 0)
        die_error(&error);
    *radius = path_ball(&path);
    path_free(&path);
}

static int run(const char *file, const struct options *o)
{
    struct error error;
    struct path path = {0};
    struct course course = {0}, wanted = {0};
    double radius = -1;
    bool held = true;
    read_operand(file, o, &course, &radius);
    count_line(o->control == CONTROL_NONE ? "path" : "program", &course);
    if (o->path) {
        if (cl_read(o->path, &path, &wanted, &error) < 0)
            die_error(&error);
        count_line("its path", &wanted);
        radius = path_ball(&path);
        course.track = wanted.track;
        if (o->no_steps) {
            sweep_join_steps(&course);
            sweep_join_steps(&wanted);
        }
        held = compare(&course, &wanted, o);
        path_free(&path);
    }
    if (o->panel || o->scan)
        held = gouges(&course, o->radius > 0 ? o->radius : radius, o) && held;
    course_free(&course);
    course_free(&wanted);
    return held ? EXIT_DONE : EXIT_UNMET;
}

int main(int argc, char **argv)
{
    struct options o = {.control = CONTROL_NONE, .tolerance = 0.001, .axis = 0.01,
                        .deeper = HUGE_VAL, .nodes = HUGE_VAL};
    const struct cli_option option[] = {
        {'c', "control", "fanuc|siemens|heidenhain|canon|none",
         "the operand is a program for this control; canon: what LinuxCNC's\n"
         "interpreter makes of it (rs274); none (default): it is a path", CLI_CHOICE, &o.control, 0, 0, 0, NULL},
        {0, "axes", "ac|bc", "rotary axes of the machine (ac)", CLI_CHOICE, &o.axes, 0, 0, 0, NULL},
        {0, "no-tcp", NULL, "the machine has no tool centre point control", CLI_FLAG, &o.no_tcp,
         0, 0, 0, NULL},
        {0, "reversed", NULL, "its rotary axes turn against the ISO sense", CLI_FLAG, &o.reversed,
         0, 0, 0, NULL},
        {0, "path", "FILE", "the path that the program was made from", CLI_TEXT, &o.path, 0, 0, 0,
         NULL},
        {0, "no-steps", NULL, "drilling steps of program and path joined: a control has its own",
         CLI_FLAG, &o.no_steps, 0, 0, 0, NULL},
        {'e', "tolerance", "MM", "of the tip against the path (0.001)", CLI_NUMBER, &o.tolerance,
         0, 1e3, 0, NULL},
        {0, "axis", "DEG", "of the tool axis against the path (0.01)", CLI_NUMBER, &o.axis, 0, 180,
         0, NULL},
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
    struct cli cli = {.tool = "readback", .usage = "[options] FILE",
                      .about = "run an NC program as the control would, and judge where it goes",
                      .option = option};
    cli_parse(&cli, argc, argv);
    if (cli.files != 1)
        die_usage("one program or path at a time");
    int status = run(cli.file[0], &o);
    if (fclose(stdout) != 0)
        die("writing the report failed");
    return status;
}
