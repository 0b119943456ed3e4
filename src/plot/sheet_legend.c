/* sheet_legend - see sheet_legend.h. */
#include "plot/sheet_legend.h"

#include <stdio.h>
#include <string.h>

#include "palette.h"
#include "plot/sheet.h"

static const double SIZE = 12, ROW = 20, SAMPLE = 26, HEIGHTS = 132;

const char *sheet_name(const char *file)
{
    const char *slash = strrchr(file, '/');
    if (strcmp(file, "-") == 0)
        return "standard input";
    return slash && slash[1] ? slash + 1 : file;
}

double sheet_bar(double most)
{
    double power = pow(10, floor(log10(most) + 1e-9));
    double first = most / power;
    return power * (first >= 5 ? 5 : first >= 2 ? 2 : 1);
}

static struct legend_item *add(struct legend *legend, const char *text)
{
    struct legend_item *item = &legend->item[legend->n];
    if (legend->n + 1 < LEGEND_ITEMS)
        legend->n++;
    *item = (struct legend_item){.ink = ""};
    snprintf(item->text, sizeof item->text, "%s", text);
    return item;
}

static void add_dot(struct legend *legend, const char *text, const char *colour)
{
    struct legend_item *item = add(legend, text);
    item->dot = true;
    snprintf(item->ink, PANE_INK, "stroke=\"%s\" stroke-width=\"50\"", colour);
}

static void add_kind(struct legend *legend, const struct pane_options *style, enum stroke_kind kind,
                     const char *text)
{
    struct stroke stroke = {.kind = kind, .number = 0};
    pane_ink(style, 0, &stroke, add(legend, text)->ink);
}

/* Twice for what comes in two colours by turns. */
static void add_turns(struct legend *legend, const struct pane_options *style,
                      enum stroke_kind kind, const char *text)
{
    struct stroke stroke = {.kind = kind, .number = 1};
    add_kind(legend, style, kind, "");
    pane_ink(style, 0, &stroke, add(legend, text)->ink);
}

static size_t count(const struct scene *scene, enum stroke_kind kind)
{
    size_t n = 0;
    for (size_t i = 0; i < scene->n; i++)
        n += scene->item[i].motions[kind];
    return n;
}

static void add_motions(struct legend *legend, const struct scene *scene,
                        const struct pane_options *style)
{
    if (style->by_layer)
        return;
    size_t cuts =
        count(scene, STROKE_LINE) + count(scene, STROKE_ARC) + count(scene, STROKE_SPLINE);
    if (style->by_pass && cuts) {
        for (size_t i = 0; i < 3; i++) {
            struct stroke stroke = {.kind = STROKE_ARC, .pass = i + 1};
            pane_ink(style, 0, &stroke,
                     add(legend, i < 2 ? "" : "passes, in six colours by turns")->ink);
        }
    }
    if (!style->by_pass && count(scene, STROKE_LINE))
        add_kind(legend, style, STROKE_LINE, "lines");
    if (!style->by_pass && count(scene, STROKE_ARC))
        add_turns(legend, style, STROKE_ARC, "arcs, by turns");
    if (!style->by_pass && count(scene, STROKE_SPLINE))
        add_turns(legend, style, STROKE_SPLINE, "B-splines, by turns");
}

static void add_rest(struct legend *legend, const struct scene *scene,
                     const struct pane_options *style)
{
    bool normals = false, axes = false, poles = false, joints = false;
    for (size_t i = 0; i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        normals |= layer->normal.n > 0;
        axes |= layer->axis.n > 0;
        joints |= style->joints && layer->joint.n > 0;
        for (size_t k = 0; k < layer->stroke.n; k++)
            poles |= layer->stroke.item[k].kind == STROKE_POLES;
    }
    if (count(scene, STROKE_RAPID))
        add_kind(legend, style, STROKE_RAPID, "rapid");
    if (poles)
        add_dot(legend, "control points", "#CC79A7");
    if (joints)
        add_dot(legend, "ends of motions", "#222");
    if (normals)
        snprintf(add(legend, "normals")->ink, PANE_INK, "stroke=\"#009E73\" stroke-width=\"12\"");
    if (axes)
        snprintf(add(legend, "tool axes")->ink, PANE_INK, "stroke=\"#444444\" stroke-width=\"12\"");
}

static void add_layers(struct legend *legend, const struct scene *scene,
                       const struct pane_options *style)
{
    char text[120];
    for (size_t i = 0; style->by_layer && i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        struct legend_item *item = add(legend, sheet_name(layer->name));
        item->dot = layer->stroke.n == 0;
        if (item->dot)
            snprintf(item->ink, PANE_INK, "stroke=\"%s\" stroke-width=\"80\"", palette_cycle(i));
        else
            pane_ink(style, i, &(struct stroke){.kind = STROKE_LINE}, item->ink);
    }
    if (style->by_layer || !(style->high.z >= style->low.z))
        return;
    snprintf(text, sizeof text, "z %.1f to %.1f mm", style->low.z, style->high.z);
    add(legend, text);
}

static double sample_width(const struct legend_item *item)
{
    return item->dot ? 8 : item->ink[0] ? SAMPLE : HEIGHTS;
}

struct legend legend_of(const struct scene *scene, const struct pane_options *style, double scale,
                        double width)
{
    struct legend legend = {.bar = sheet_bar(fmin(180, width / 3) / scale), .scale = scale};
    char text[60];
    add_layers(&legend, scene, style);
    add_motions(&legend, scene, style);
    add_rest(&legend, scene, style);
    snprintf(text, sizeof text, "%g mm", legend.bar);
    double x = legend.bar * scale + svg_text_width(SIZE, false, text) + 34;
    for (size_t i = 0; i < legend.n; i++) {
        struct legend_item *item = &legend.item[i];
        bool joined = item->text[0] == '\0'; /* the sample of the item behind it too */
        double need =
            sample_width(item) + (joined ? 4 : 8 + svg_text_width(SIZE, false, item->text));
        if (x + need > width && x > 0) {
            legend.rows++;
            x = 0;
        }
        item->x = x;
        item->row = legend.rows;
        x += need + (joined ? 0 : 18);
    }
    legend.rows++;
    return legend;
}

double legend_height(const struct legend *legend)
{
    return 10 + ROW * (double)legend->rows;
}

/* An honest bar: it holds in the plane of each view, along all axes but in the isometric one. */
static void draw_bar(const struct legend *legend, struct svg *svg, double x, double y)
{
    char text[60];
    double to = x + legend->bar * legend->scale;
    svg_path(svg, "fill=\"none\" stroke=\"#222\" stroke-width=\"12\"");
    svg_move(svg, x, y - 4);
    svg_line(svg, x, y + 4);
    svg_move(svg, x, y);
    svg_line(svg, to, y);
    svg_move(svg, to, y - 4);
    svg_line(svg, to, y + 4);
    svg_path_end(svg);
    snprintf(text, sizeof text, "%g mm", legend->bar);
    svg_text(svg, to + 8, y + 4, "start", SIZE, false, text);
}

static void draw_heights(struct svg *svg, double x, double y)
{
    for (size_t i = 0; i < PALETTE_HEIGHTS; i++) {
        char ink[60];
        double from = x + HEIGHTS / PALETTE_HEIGHTS * (double)i;
        snprintf(ink, sizeof ink, "stroke=\"%s\" stroke-width=\"100\"", palette_height(i));
        svg_path(svg, ink);
        svg_move(svg, from, y);
        svg_line(svg, from + HEIGHTS / PALETTE_HEIGHTS, y);
        svg_path_end(svg);
    }
}

void legend_draw(const struct legend *legend, struct svg *svg, double x, double y)
{
    draw_bar(legend, svg, x, y);
    for (size_t i = 0; i < legend->n; i++) {
        const struct legend_item *item = &legend->item[i];
        double at = x + item->x, row = y + ROW * (double)item->row;
        if (item->ink[0] == '\0') {
            draw_heights(svg, at, row);
        } else {
            svg_group(svg, "stroke-linecap=\"round\"");
            svg_path(svg, item->ink);
            svg_move(svg, item->dot ? at + 4 : at, row);
            svg_line(svg, at + (item->dot ? 4.1 : SAMPLE), row);
            svg_path_end(svg);
            svg_group_end(svg);
        }
        if (item->text[0])
            svg_text(svg, at + sample_width(item) + 8, row + 4, "start", SIZE, false, item->text);
    }
}
