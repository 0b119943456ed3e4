/*
 * planecut - parallel planes through a mesh to a path: contact points, normals, tool centres, tool
 * axes, tips (paper 2, 2.1 and 2.2).
 */
#include <stdlib.h>

#include "cutpart.h"
#include "cutting.h"
#include "onsurface.h"
#include "parallel.h"
#include "passes.h"
#include "scallop.h"
#include "surfaces.h"

static const double MOST_PLANES = 100000;

/* By the longest edge of the mesh: how far beyond its trimming a surface counts. */
static const double BESIDE = 0.002;

static double step, scallop, angle, plane[3], gap = 0.1;
static struct cli_list surfaces;
static bool step_given, scallop_given, angle_given, plane_given;

/* clang-format off */
static const struct cli_option options[] = {
    {'r', "radius", "R", "radius of the ball (needed)",
     CLI_NUMBER, &cutting.radius, CLI_POSITIVE, 0, 0, NULL},
    {'s', "step", "MM", "distance of the planes; made a little smaller, so that all are equal",
     CLI_NUMBER, &step, CLI_POSITIVE, 0, 0, &step_given},
    {0, "scallop", "H", "planes as far apart as leaves no cusp higher than H between passes\n"
     "(0.01 without -s)", CLI_NUMBER, &scallop, CLI_POSITIVE, 0, 0, &scallop_given},
    {'a', "angle", "DEG", "direction of upright planes, about z from x towards y (0)",
     CLI_NUMBER, &angle, 0, 0, 0, &angle_given},
    {0, "plane", "I,J,K", "the planes' normal, instead of -a: 0,0,1 cuts at constant height",
     CLI_NUMBERS, plane, 0, 0, 3, &plane_given},
    {0, "gap", "MM", "go on with the tool down over gaps of at most this in the part (0.1)",
     CLI_NUMBER, &gap, 0, 1000, 0, NULL},
    {0, "surface", "FILE", "put each point on the surfaces of this file, IGES or NURBS text, which\n"
     "the mesh was made from (may be given several times)", CLI_LIST, &surfaces, 0, 0, 0, NULL},
    {0, "oneway", NULL, "the same as --one-way", CLI_FLAG, &cutting.one_way, 0, 0, 0, NULL},
    {0}};
/* clang-format on */

/* The planes, and how their passes run. */
struct planes {
    struct pass_rule rule;
    struct meshcut *cut;
    struct doubles height;
    double widest;   /* distance of two planes, mm */
    bool steep;      /* the scallop that was asked for can't be kept */
    size_t left_out; /* points that face away */
    struct patches patches;
    struct onsurface *on; /* NULL: points stay on the mesh */
    double reach;         /* of a point to its surface, mm */
    size_t beside;        /* points without a surface */
    int threads;
};

static void check_options(struct axis_rule *axis)
{
    struct error error;

    if (cutting_check(axis, &error) != 0)
        die_usage("%s", error.text);
    if (step_given && scallop_given)
        die_usage("found -s and --scallop, expected one of them");
    if (angle_given && plane_given)
        die_usage("found -a and --plane, expected one of them");
    if (plane_given && vec_length(vec(plane[0], plane[1], plane[2])) == 0)
        die_usage("option --plane: found a direction of no length");
    if (scallop >= cutting.radius)
        die_usage("option --scallop: found %g, expected less than the radius", scallop);
    if (!step_given && !scallop_given)
        scallop = fmin(0.01, cutting.radius / 2);
}

/* The ball must not be larger than the smallest hollow (paper 2, 2.1), unless it is lifted there.
 */
static void check_radius(const char *file, const struct mesh *mesh)
{
    struct cutpart_hollow h = cutpart_hollow(mesh, cutting.radius);

    if (!h.known && !cutting.paper)
        say("%s: the mesh has no curvatures (kmax), so that it can't be told whether the ball "
            "fits everywhere: it is lifted where it does not",
            file);
    if (!h.known || h.tighter == 0 || cutting.avoid || cutting.guards.n > 0)
        return;
    die_unmet("%s: found a hollow of radius %.3f at %.3f %.3f %.3f%s%s, expected none "
              "below the ball's, %g (%zu %s too tight for it): take a smaller ball, or --avoid",
              file, h.radius, h.at.x, h.at.y, h.at.z, h.surface ? " in surface " : "",
              h.surface ? h.surface : "", cutting.radius, h.tighter,
              h.surface ? "surfaces" : "vertices");
}

/* A border that is straight along the planes has the first of them on it, another one just inside.
 */
static double first_height(struct meshcut *cut, double inside)
{
    double low = meshcut_low(cut), length[2];

    for (int i = 0; i < 2; i++) {
        struct chains chains = {0};
        meshcut_at(cut, low + i * inside, &chains);
        length[i] = chains_length(&chains);
        chains_free(&chains);
    }
    return length[0] > 0.9 * length[1] ? low : low + inside;
}

static void find_planes(const struct mesh *mesh, struct planes *p)
{
    p->cut = meshcut_new(mesh, p->rule.normal, !cutting.paper);
    double low = meshcut_low(p->cut), high = meshcut_high(p->cut);
    double least = step_given ? step : scallop_step(scallop, cutting.radius, 0) / 10;

    if ((high - low) / least > MOST_PLANES)
        die_usage("found a distance of planes for more than %g of them", MOST_PLANES);
    if (step_given) {
        scallop_equal(low, high, step, &p->height);
        p->widest = step;
    } else {
        struct scallop_report report =
            scallop_heights(mesh, p->rule.normal, low, high, scallop, cutting.radius, &p->height);
        p->widest = report.widest;
        p->steep = report.steep > 0;
        note("planes %.4f to %.4f mm apart", report.narrowest, report.widest);
        if (p->steep)
            say("%zu facets stand within 6 degrees of the planes, the first at %.3f %.3f %.3f: "
                "there the cusps are higher than %g",
                report.steep, report.steep_at.x, report.steep_at.y, report.steep_at.z, scallop);
    }
    double distance = p->height.n > 1 ? p->height.item[1] - p->height.item[0] : high - low;
    p->height.item[0] = first_height(p->cut, 0.01 * distance);
}

static void set_rule(const struct axis_rule *axis, bool closed, struct planes *p)
{
    struct pass_rule *rule = &p->rule;
    double a = RADIANS(angle);

    *rule = (struct pass_rule){.along = vec(cos(a), sin(a), 0),
                               .normal = vec(-sin(a), cos(a), 0),
                               .gap = gap,
                               .facing = vec(0, 0, 1),
                               .faced = closed || axis->kind == AXIS_FIXED,
                               .radius = cutting.radius,
                               .tolerance = 0.002};
    /* From the lower left to the upper right, whatever the angle. */
    if (rule->normal.x + rule->normal.y < 0)
        rule->normal = vec_scale(-1, rule->normal);
    if (plane_given) {
        rule->normal = vec_unit(vec(plane[0], plane[1], plane[2]));
        rule->along = passes_along(rule->normal);
    }
    if (axis->kind == AXIS_FIXED)
        rule->facing = axis->direction;
}

static void read_surfaces(struct mesh *mesh, struct planes *p)
{
    struct surfaces_unit unit;
    struct error error;
    double longest = 0, slack = isfinite(mesh->origin.ledger) ? mesh->origin.ledger : 0;

    for (size_t i = 0; i < surfaces.n; i++) {
        if (surfaces_read(surfaces.item[i], 0, &p->patches, &unit, &error) < 0)
            die_error(&error);
    }
    if (surfaces.n == 0)
        return;
    for (size_t f = 0; f < mesh->face.n; f++) {
        const int *v = mesh->face.item[f].v;
        longest = fmax(longest, vec_distance(mesh->vertex.item[v[0]], mesh->vertex.item[v[1]]));
    }
    p->on = onsurface_new(&p->patches, fmax(slack, BESIDE * longest));
    p->reach = longest / 2;
    mesh->origin.ledger = NAN; /* points leave the mesh: what it was off is not spent */
}

/* What the threads share. */
struct putting {
    const struct planes *planes;
    struct contact *point;
    bool *beside;
};

static void put_some(void *context, size_t from, size_t to)
{
    struct putting *p = context;

    for (size_t i = from; i < to; i++)
        p->beside[i] = onsurface_put(p->planes->on, p->planes->rule.normal, p->planes->reach,
                                     &p->point[i]) < 0;
}

static void put_on_surfaces(struct planes *p, struct contacts *points)
{
    struct putting put = {p, points->item, mem_alloc(points->n + 1, sizeof *put.beside)};

    if (p->on)
        parallel_for(p->threads, points->n, put_some, &put);
    for (size_t i = 0; i < points->n; i++)
        p->beside += put.beside[i];
    free(put.beside);
}

static void make_pass(struct planes *p, size_t plane_number, size_t pass, struct toolpath *t)
{
    struct chains chains = {0}, strips = {0};
    bool back = !cutting.one_way && pass % 2 == 0;

    meshcut_at(p->cut, p->height.item[plane_number], &chains);
    put_on_surfaces(p, &chains.point);
    p->left_out += passes_make(&chains, &p->rule, &strips);
    if (back)
        passes_reverse(&strips);
    for (size_t k = 0; k < strips.chain.n; k++) {
        const struct chain *chain = &strips.chain.item[k];
        t->lift.feed.side = p->rule.normal;
        t->lift.feed.plane = passes_forward(&strips, k, p->rule.normal);
        toolpath_strip(t, pass, &strips.point.item[chain->from], chain->to - chain->from,
                       vec_scale(back ? -1 : 1, p->rule.along));
    }
    chains_free(&chains);
    chains_free(&strips);
}

static void make_path(struct planes *p, struct toolpath *t)
{
    size_t pass = 1;

    for (int layer = cutting.layers - 1; layer >= 0; layer--) {
        t->lift.offset = cutting.radius + layer * cutting.depth;
        for (size_t i = 0; i < p->height.n; i++) {
            make_pass(p, i, pass++, t);
            progress("planes", i + 1, p->height.n);
        }
    }
    toolpath_end(t);
    if (t->pass == 0)
        die("found nothing that the planes cross and that faces the tool");
    if (p->beside > 0)
        say("%zu points have no surface near them and stay on the mesh", p->beside);
    if (p->left_out > 0)
        say("%zu points face away from the tool and are left out", p->left_out);
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "planecut",
                      .usage = "-r R [-s MM | --scallop H] [-a DEG] [options] [FILE]",
                      .about = "Makes a tool path from parallel planes through a mesh: mesh (PLY, "
                               "STL, OFF) in, path\nstream out.",
                      .option = options,
                      .more = cutting_options};
    struct mesh mesh = {0};
    struct path path = {0};
    struct planes planes = {0};
    struct toolpath t = {.path = &path};
    struct guard *guard;
    struct error error;
    bool closed;

    cli_parse(&cli, argc, argv);
    t.threads = cli.threads;
    check_options(&t.lift.axis);
    if (cli.files > 1)
        die_usage("found %d files, expected one mesh", cli.files);
    if (cutpart_read(cli.file[0], vec(0, 0, 1), &mesh, &closed, &error) != 0)
        die_error(&error);
    check_radius(cli.file[0], &mesh);
    set_rule(&t.lift.axis, closed, &planes);
    find_planes(&mesh, &planes);
    read_surfaces(&mesh, &planes);
    if (cutting_guard(&mesh, fmax(planes.widest, cutting.radius), cli.threads, &guard,
                      &error) != 0)
        die_error(&error);
    if (cutting_rules(&mesh, guard, planes.widest, &t, &error) != 0)
        die_usage("%s", error.text);

    make_path(&planes, &t);
    cutting_head(&mesh, "planecut", &t);
    struct out *out = out_open(cli.output);
    path_write(out, &path);
    out_close(out);
    note("%zu planes", planes.height.n);
    int status = toolpath_conclude(&t);

    meshcut_free(planes.cut);
    array_free(&planes.height);
    onsurface_free(planes.on);
    patches_free(&planes.patches);
    path_free(&path);
    guard_free(guard);
    mesh_free(&mesh);
    return planes.steep && scallop_given ? EXIT_UNMET : status;
}
