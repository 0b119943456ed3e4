/* ncplot - a picture of any stream of the suite, or of several together. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/cli.h"
#include "io/cloud/cloud.h"
#include "plot/plot.h"
#include "stage/cloud_options.h"
#include "base/out.h"

enum colour { COLOUR_AUTO, COLOUR_PASS, COLOUR_KIND };

struct settings {
    int view, colour, unit, width;
    bool compare, poles, points, normals, axes, cut, speed;
    const char *title, *machine;
};

static struct settings read_settings(struct cli *cli, int argc, char **argv)
{
    static struct settings s = {.width = 1000};
    static const struct cli_option options[] = {
        {0, "view", "both|plan|iso|front|side|all",
         "plan and isometric (both, the default), one, or all", CLI_CHOICE, &s.view, 0, 0, 0, NULL},
        {0, "colour", "auto|pass|kind",
         "the colours of a path say its passes, or what is a line, an arc, a\n"
         "B-spline (default: passes where all is lines)",
         CLI_CHOICE, &s.colour, 0, 0, 0, NULL},
        {0, "compare", NULL,
         "draw the streams over each other and say how far each\n"
         "is from the first, with a ring at the largest",
         CLI_FLAG, &s.compare, 0, 0, 0, NULL},
        {0, "speed", NULL, "colour a program by the speed that the machine reaches", CLI_FLAG,
         &s.speed, 0, 0, 0, NULL},
        {0, "points", NULL, NULL, CLI_ALIAS, "joints", 0, 0, 0, NULL},
        {0, "ends", NULL, NULL, CLI_ALIAS, "joints", 0, 0, 0, NULL},
        {0, "joints", NULL, "mark where the motions of a path end", CLI_FLAG, &s.points, 0, 0, 0,
         NULL},
        {0, "poles", NULL, "show the control points of B-splines", CLI_FLAG, &s.poles, 0, 0, 0,
         NULL},
        {0, "normals", NULL, NULL, CLI_ALIAS, "show-normals", 0, 0, 0, NULL},
        {0, "show-normals", NULL, "show the normals of a mesh or of contact points", CLI_FLAG,
         &s.normals, 0, 0, 0, NULL},
        {0, "axes", NULL, "show the tool axis", CLI_FLAG, &s.axes, 0, 0, 0, NULL},
        {0, "cut", NULL, "do not draw rapid moves", CLI_FLAG, &s.cut, 0, 0, 0, NULL},
        {0, "title", "TEXT", "title (default: the names of the files)", CLI_TEXT, &s.title, 0, 0, 0,
         NULL},
        {0, "width", "PX", "largest width of the picture (1000)", CLI_COUNT, &s.width, 300, 10000,
         0, NULL},
        {'m', "machine", "MACHINE", "machine of a program (default: as its head says)", CLI_TEXT,
         &s.machine, 0, 0, 0, NULL},
        UNIT_OPTION("units of clouds (default: mm)", &s.unit, NULL),
        {0},
    };
    cli->option = options;
    cli_parse(cli, argc, argv);
    if (s.compare && cli->files < 2)
        die_usage("option --compare: found one file, expected two or more");
    if (s.speed && (s.compare || s.colour != COLOUR_AUTO))
        die_usage("found --speed and %s, expected one of them",
                  s.compare ? "--compare" : "--colour");
    return s;
}

static struct scene read_scene(const struct cli *cli, const struct settings *s)
{
    struct layer_options options = {.unit = cloud_unit(unit_name[s->unit]),
                                    .poles = s->poles,
                                    .normals = s->normals,
                                    .axes = s->axes,
                                    .cut = s->cut,
                                    .speed = s->speed,
                                    .chord = s->compare ? 5e-4 : 0,
                                    .machine = s->machine};
    struct scene scene = {0};
    struct error error;
    for (int i = 0; i < cli->files; i++) {
        struct layer layer;
        if (layer_read(cli->file[i], &options, &layer, &error) < 0)
            die_error(&error);
        if (layer.point.n + layer.mesh.vertex.n + layer.node.n == 0)
            die("%s: nothing to draw, expected points, facets or motions", layer.name);
        if (s->speed && !layer.speeds)
            die("%s: found no speeds, expected a program (option --speed)", layer.name);
        if (*layer.told)
            say("%s: %s", layer.name, layer.told);
        note("%s: %s", layer.name, layer.figures);
        *array_push(&scene) = layer;
    }
    return scene;
}

/* Colours by pass where all is lines; arcs and B-splines have colours by kind. */
static bool by_pass(const struct scene *scene, int colour)
{
    for (size_t i = 0; colour == COLOUR_AUTO && i < scene->n; i++)
        if (scene->item[i].motions[STROKE_ARC] + scene->item[i].motions[STROKE_SPLINE] > 0)
            return false;
    return colour != COLOUR_KIND;
}

/* The names of the files, separated by commas. */
static char *title_of(const struct scene *scene)
{
    struct {
        size_t n, cap;
        char *item;
    } text = {0};
    for (size_t i = 0; i < scene->n; i++) {
        const char *name = sheet_name(scene->item[i].name);
        for (const char *p = i ? ", " : ""; *p; p++)
            *array_push(&text) = *p;
        for (const char *p = name; *p; p++)
            *array_push(&text) = *p;
    }
    *array_push(&text) = '\0';
    return text.item;
}

/* How far `from` is from `to`, as text; the worst place is marked. */
static void compare(const struct layer *from, const struct layer *to, int threads,
                    struct scene *scene, char text[REMARK])
{
    struct layer_distance d = layer_distance_of(from, to, threads);
    *text = '\0';
    if (d.n == 0)
        return;
    snprintf(text, REMARK,
             "%.60s from %.60s: worst %.4f mm at %.3f %.3f %.3f, 95%% %.4f, rms %.4f mm",
             sheet_name(from->name), sheet_name(to->name), d.worst, d.at.x, d.at.y, d.at.z,
             d.most95, d.rms);
    say("%s", text);
    *array_push(&scene->mark) = d.at;
}

/* All layers with the first, both ways; the lines of figures, for the title. */
static struct remarks compare_all(struct scene *scene, int threads)
{
    struct remarks remarks = {0};
    for (size_t i = 1; i < scene->n; i++) {
        const struct layer *first = &scene->item[0], *other = &scene->item[i];
        compare(other, first, threads, scene, array_push(&remarks)->text);
        compare(first, other, threads, scene, array_push(&remarks)->text);
    }
    return remarks;
}

int main(int argc, char **argv)
{
    struct cli cli = {.tool = "ncplot",
                      .usual = "view compare cut speed machine title width",
                      .usage = "[options] [STREAM...]",
                      .about = "Draws a cloud, a mesh, a path or a program as SVG."};
    struct settings s = read_settings(&cli, argc, argv);
    struct scene scene = read_scene(&cli, &s);
    char *names = title_of(&scene);
    struct remarks remarks = {0};
    if (s.compare)
        remarks = compare_all(&scene, cli.threads);
    struct sheet_options options = {.title = s.title ? s.title : names,
                                    .views = (enum sheet_views)s.view,
                                    .width = s.width,
                                    .by_pass = by_pass(&scene, s.colour),
                                    .by_layer = s.compare,
                                    .by_speed = s.speed,
                                    .joints = s.points,
                                    .remarks = &remarks};

    struct out *out = out_open(cli.output);
    sheet_write(out, &scene, &options);
    out_close(out);
    free(names);
    array_free(&remarks);
    scene_free(&scene);
    return EXIT_DONE;
}
