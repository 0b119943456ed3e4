/* layer - see layer.h. */
#include "plot/layer.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/cloud/cloud.h"
#include "io/mesh/meshfile.h"
#include "stream.h"
#include "plot/svg.h"

double layer_chord(const struct layer_options *options, const struct box *box)
{
    double seen = box_diagonal(box) / 5000;
    return fmax(options->chord > 0 ? fmin(options->chord, seen) : seen, 1e-6);
}

/* Adds ` NUMBER what` to the figures, behind a comma when something stands there. */
static void tell(struct layer *layer, size_t number, const char *one, const char *more)
{
    size_t at = strlen(layer->figures);
    char text[SVG_COUNT];
    svg_count(text, number);
    snprintf(layer->figures + at, sizeof layer->figures - at, "%s%s %s", at ? ", " : "", text,
             number == 1 ? one : more);
}

static void tell_text(struct layer *layer, const char *text)
{
    size_t at = strlen(layer->figures);
    snprintf(layer->figures + at, sizeof layer->figures - at, "%s%s", at ? ", " : "", text);
}

/* A length in mm, or m when it is long. */
static void tell_length(struct layer *layer, double mm, const char *what)
{
    char text[80];
    snprintf(text, sizeof text, mm < 1000 ? "%.1f mm %s" : "%.2f m %s", mm < 1000 ? mm : mm / 1000,
             what);
    tell_text(layer, text);
}

static void tell_box(struct layer *layer)
{
    struct box box = layer_box(layer, 0);
    struct vec3 size = vec_sub(box.high, box.low);
    char text[120];
    snprintf(text, sizeof text, "%.1f \u00d7 %.1f \u00d7 %.1f mm", size.x, size.y, size.z);
    tell_text(layer, text);
}

static int read_cloud(const char *file, const struct layer_options *options, struct layer *layer,
                      struct error *error)
{
    struct cloud_count count;
    if (cloud_read(file, &layer->point, &count, error) < 0)
        return -1;
    for (size_t i = 0; i < layer->point.n; i++)
        layer->point.item[i] = vec_scale(options->unit, layer->point.item[i]);
    tell(layer, layer->point.n, "point", "points");
    tell_box(layer);
    return 0;
}

static size_t rows_of(const struct mesh *mesh)
{
    int last = -1;
    for (size_t i = 0; i < mesh->row.n; i++)
        if (mesh->row.item[i] > last)
            last = mesh->row.item[i];
    return (size_t)(last + 1);
}

static int read_mesh(const char *file, const struct layer_options *options, struct layer *layer,
                     struct error *error)
{
    struct mesh *mesh = &layer->mesh;
    if (mesh_read(file, mesh, error) < 0)
        return -1;
    if (options->normals && mesh->normal.n == 0)
        mesh_normals_facet(mesh);
    for (size_t i = 0; options->normals && i < mesh->vertex.n; i++)
        *array_push(&layer->normal) = (struct tick){mesh->vertex.item[i], mesh->normal.item[i]};
    tell(layer, mesh->vertex.n, "vertex", "vertices");
    tell(layer, mesh->face.n, "facet", "facets");
    if (mesh->row.n)
        tell(layer, rows_of(mesh), "row", "rows");
    if (mesh->origin.spacing > 0) {
        char text[60];
        snprintf(text, sizeof text, "grid of %g mm", mesh->origin.spacing);
        tell_text(layer, text);
    }
    tell_box(layer);
    return 0;
}

static void tell_path(struct layer *layer)
{
    if (layer->passes)
        tell(layer, layer->passes, "pass", "passes");
    if (layer->motions[STROKE_LINE])
        tell(layer, layer->motions[STROKE_LINE], "line", "lines");
    if (layer->motions[STROKE_ARC])
        tell(layer, layer->motions[STROKE_ARC], "arc", "arcs");
    if (layer->motions[STROKE_SPLINE]) {
        tell(layer, layer->motions[STROKE_SPLINE], "B-spline", "B-splines");
        size_t at = strlen(layer->figures);
        char text[SVG_COUNT];
        svg_count(text, layer->motions[STROKE_POLES]);
        if (layer->motions[STROKE_POLES])
            snprintf(layer->figures + at, sizeof layer->figures - at, " of %s control points",
                     text);
    }
    tell_length(layer, layer->cut, "of cut");
}

static int read_path(const char *file, const struct layer_options *options, struct layer *layer,
                     struct error *error)
{
    struct path path = {0};
    if (path_read(file, &path, error) < 0)
        return -1;
    int status = layer_path(&path, options, layer, error);
    path_free(&path);
    tell_path(layer);
    return status;
}

static int read_program(const char *file, const struct layer_options *options, struct layer *layer,
                        struct error *error)
{
    int status = layer_program(file, options, layer, error);
    tell_path(layer);
    return status;
}

int layer_read(const char *file, const struct layer_options *options, struct layer *layer,
               struct error *error)
{
    enum stream_kind kind;
    const char *name;
    memset(layer, 0, sizeof *layer);
    if (stream_find(file, &kind, &name, error) < 0)
        return -1;
    layer->name = name;
    switch (kind) {
    case STREAM_MESH:
        return read_mesh(name, options, layer, error);
    case STREAM_PATH:
        return read_path(name, options, layer, error);
    case STREAM_PROGRAM:
        return read_program(name, options, layer, error);
    default:
        return read_cloud(name, options, layer, error);
    }
}
