/* sheet - a whole picture: title and figures, views in rows of two at one scale, captions, legend
 * and scale bar; see plot.h. */
#include "plot/plot.h"

#include <stdio.h>
#include <string.h>

#include "base/array.h"
#include "palette.h"
#include "pane.h"

enum { MARKS = 16000 }; /* in one view, about; half of it where there are more */

static const double MARGIN = 24, GAP = 36, CAPTION = 26, TITLE = 18, SMALL = 12.5, HEIGHT = 680;

static const char *const caption[VIEW_NAMES] = {
    [VIEW_PLAN] = "plan (x right, y up)",
    [VIEW_ISO] = "isometric",
    [VIEW_FRONT] = "front (x right, z up)",
    [VIEW_SIDE] = "side (y right, z up)",
};

/* ---- the legend: a scale bar, what the colours and lines mean */

enum { LEGEND_ITEMS = 16 };

struct legend_item {
    char text[120];
    char ink[PANE_INK]; /* of its sample; empty: heights by colour */
    bool dot;           /* its sample is a dot, not a line */
    double x;           /* of the sample, from the left */
    size_t row;
};

struct legend {
    size_t n, rows;
    struct legend_item item[LEGEND_ITEMS];
    double bar, scale; /* mm; px in a mm */
};

static const double LEGEND_SIZE = 12, LEGEND_ROW = 20, LEGEND_SAMPLE = 26, LEGEND_HEIGHTS = 132;

const char *sheet_name(const char *file)
{
    const char *slash = strrchr(file, '/');
    if (strcmp(file, "-") == 0)
        return "standard input";
    return slash && slash[1] ? slash + 1 : file;
}

/* The length of a scale bar, 1, 2 or 5 times a power of ten, at most `most` mm. */
static double bar_length(double most)
{
    double power = pow(10, floor(log10(most) + 1e-9));
    double first = most / power;
    return power * (first >= 5 ? 5 : first >= 2 ? 2 : 1);
}

static struct legend_item *add_item(struct legend *legend, const char *text)
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
    struct legend_item *item = add_item(legend, text);
    item->dot = true;
    snprintf(item->ink, PANE_INK, "stroke=\"%s\" stroke-width=\"50\"", colour);
}

static void add_kind(struct legend *legend, const struct pane_options *style, enum stroke_kind kind,
                     const char *text)
{
    struct stroke stroke = {.kind = kind, .number = 0};
    pane_ink(style, 0, &stroke, add_item(legend, text)->ink);
}

/* Twice for what comes in two colours by turns. */
static void add_turns(struct legend *legend, const struct pane_options *style,
                      enum stroke_kind kind, const char *text)
{
    struct stroke stroke = {.kind = kind, .number = 1};
    add_kind(legend, style, kind, "");
    pane_ink(style, 0, &stroke, add_item(legend, text)->ink);
}

static size_t count_motions(const struct scene *scene, enum stroke_kind kind)
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
    size_t cuts = count_motions(scene, STROKE_LINE) + count_motions(scene, STROKE_ARC) +
                  count_motions(scene, STROKE_SPLINE);
    if (style->by_speed && cuts) {
        struct legend_item *item = add_item(legend, "speed: none to the whole feed");
        item->ink[0] = '\0';
        return;
    }
    if (style->by_pass && cuts) {
        for (size_t i = 0; i < 3; i++) {
            struct stroke stroke = {.kind = STROKE_ARC, .pass = i + 1};
            pane_ink(style, 0, &stroke,
                     add_item(legend, i < 2 ? "" : "passes, in six colours by turns")->ink);
        }
    }
    if (!style->by_pass && count_motions(scene, STROKE_LINE))
        add_kind(legend, style, STROKE_LINE, "lines");
    if (!style->by_pass && count_motions(scene, STROKE_ARC))
        add_turns(legend, style, STROKE_ARC, "arcs, by turns");
    if (!style->by_pass && count_motions(scene, STROKE_SPLINE))
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
    if (count_motions(scene, STROKE_RAPID))
        add_kind(legend, style, STROKE_RAPID, "rapid");
    if (poles)
        add_dot(legend, "control points", "#CC79A7");
    if (joints)
        add_dot(legend, "ends of motions", "#222");
    if (normals)
        snprintf(add_item(legend, "normals")->ink, PANE_INK,
                 "stroke=\"#009E73\" stroke-width=\"12\"");
    if (axes)
        snprintf(add_item(legend, "tool axes")->ink, PANE_INK,
                 "stroke=\"#444444\" stroke-width=\"12\"");
}

static void add_layers(struct legend *legend, const struct scene *scene,
                       const struct pane_options *style)
{
    char text[120];
    for (size_t i = 0; style->by_layer && i < scene->n; i++) {
        const struct layer *layer = &scene->item[i];
        struct legend_item *item = add_item(legend, sheet_name(layer->name));
        item->dot = layer->stroke.n == 0;
        if (item->dot)
            snprintf(item->ink, PANE_INK, "stroke=\"%s\" stroke-width=\"80\"", palette_cycle(i));
        else
            pane_ink(style, i, &(struct stroke){.kind = STROKE_LINE}, item->ink);
    }
    if (style->by_layer || !(style->high.z >= style->low.z))
        return;
    snprintf(text, sizeof text, "z %.1f to %.1f mm", style->low.z, style->high.z);
    add_item(legend, text);
}

static double sample_width(const struct legend_item *item)
{
    return item->dot ? 8 : item->ink[0] ? LEGEND_SAMPLE : LEGEND_HEIGHTS;
}

/* What there is in the scene, in rows no wider than `width` px. */
static struct legend legend_of(const struct scene *scene, const struct pane_options *style,
                               double scale, double width)
{
    struct legend legend = {.bar = bar_length(fmin(180, width / 3) / scale), .scale = scale};
    char text[60];
    add_layers(&legend, scene, style);
    add_motions(&legend, scene, style);
    add_rest(&legend, scene, style);
    snprintf(text, sizeof text, "%g mm", legend.bar);
    double x = legend.bar * scale + svg_text_width(LEGEND_SIZE, false, text) + 34;
    for (size_t i = 0; i < legend.n; i++) {
        struct legend_item *item = &legend.item[i];
        bool joined = item->text[0] == '\0'; /* the sample of the next item too */
        double need =
            sample_width(item) + (joined ? 4 : 8 + svg_text_width(LEGEND_SIZE, false, item->text));
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

static double legend_height(const struct legend *legend)
{
    return 10 + LEGEND_ROW * (double)legend->rows;
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
    svg_text(svg, to + 8, y + 4, "start", LEGEND_SIZE, false, text);
}

static void draw_heights(struct svg *svg, double x, double y)
{
    for (size_t i = 0; i < PALETTE_HEIGHTS; i++) {
        char ink[60];
        double from = x + LEGEND_HEIGHTS / PALETTE_HEIGHTS * (double)i;
        snprintf(ink, sizeof ink, "stroke=\"%s\" stroke-width=\"100\"", palette_height(i));
        svg_path(svg, ink);
        svg_move(svg, from, y);
        svg_line(svg, from + LEGEND_HEIGHTS / PALETTE_HEIGHTS, y);
        svg_path_end(svg);
    }
}

static void draw_legend(const struct legend *legend, struct svg *svg, double x, double y)
{
    draw_bar(legend, svg, x, y);
    for (size_t i = 0; i < legend->n; i++) {
        const struct legend_item *item = &legend->item[i];
        double at = x + item->x, row = y + LEGEND_ROW * (double)item->row;
        if (item->ink[0] == '\0') {
            draw_heights(svg, at, row);
        } else {
            svg_group(svg, "stroke-linecap=\"round\"");
            svg_path(svg, item->ink);
            svg_move(svg, item->dot ? at + 4 : at, row);
            svg_line(svg, at + (item->dot ? 4.1 : LEGEND_SAMPLE), row);
            svg_path_end(svg);
            svg_group_end(svg);
        }
        if (item->text[0])
            svg_text(svg, at + sample_width(item) + 8, row + 4, "start", LEGEND_SIZE, false,
                     item->text);
    }
}

/* ---- the layout */

struct placed_pane {
    enum view_name name;
    struct pane pane;
    size_t row;
    double wide, high; /* mm */
};

struct layout {
    size_t n, rows;
    struct placed_pane place[4];
    double scale, width, height, head; /* px */
};

static size_t choose_views(enum sheet_views views, enum view_name name[4])
{
    static const enum view_name all[] = {VIEW_PLAN, VIEW_ISO, VIEW_FRONT, VIEW_SIDE};
    size_t n = views == SHEET_ALL ? 4 : views == SHEET_BOTH ? 2 : 1;
    memcpy(name, all, sizeof all);
    if (n == 1)
        name[0] = all[views - SHEET_PLAN];
    return n;
}

/* Sum of the widths and greatest height of a row, mm. */
static void row_size(const struct layout *l, size_t row, double *wide, double *high, size_t *panes)
{
    *wide = *high = 0;
    *panes = 0;
    for (size_t i = 0; i < l->n; i++)
        if (l->place[i].row == row) {
            *wide += l->place[i].wide;
            *high = fmax(*high, l->place[i].high);
            ++*panes;
        }
}

/* The scale at which the widest row fits, and all rows together are not too high. */
static void find_scale(struct layout *l, double width)
{
    double sum = 0, wide, high;
    size_t panes;
    l->scale = INFINITY;
    for (size_t row = 0; row < l->rows; row++) {
        row_size(l, row, &wide, &high, &panes);
        l->scale = fmin(l->scale, (width - 2 * MARGIN - GAP * (double)(panes - 1)) / wide);
        sum += high;
    }
    l->scale = fmin(l->scale, (l->rows > 1 ? 1.5 : 1) * HEIGHT * (width / 1000) / sum);
    l->width = 0;
    for (size_t row = 0; row < l->rows; row++) {
        row_size(l, row, &wide, &high, &panes);
        l->width = fmax(l->width, wide * l->scale + GAP * (double)(panes - 1));
    }
    l->width = fmax(l->width + 2 * MARGIN, fmin(width, 480));
}

static void place_panes(struct layout *l)
{
    double top = l->head;
    for (size_t row = 0; row < l->rows; row++) {
        double wide, high, column = 0;
        size_t panes;
        row_size(l, row, &wide, &high, &panes);
        double spare = l->width - 2 * MARGIN - wide * l->scale;
        double gap = spare / (double)(panes + 1); /* the same beside and between */
        double x = panes > 1 ? MARGIN : MARGIN + gap;
        gap = panes > 1 ? spare / (double)(panes - 1) : gap;
        for (size_t i = 0; i < l->n; i++) {
            struct placed_pane *p = &l->place[i];
            if (p->row != row)
                continue;
            p->pane.x = x + column;
            p->pane.y = top + (high - p->high) * l->scale / 2;
            p->pane.scale = l->scale;
            column += p->wide * l->scale + gap;
        }
        top += high * l->scale + CAPTION;
    }
    l->height = top;
}

static struct layout lay_out(const struct scene *scene, const struct sheet_options *options,
                             const struct pane_options *style)
{
    enum view_name name[4];
    struct layout l = {.n = choose_views(options->views, name)};
    for (size_t i = 0; i < l.n; i++) {
        struct placed_pane *p = &l.place[i];
        p->name = name[i];
        p->row = i / 2;
        p->pane = (struct pane){.view = view_from(name[i]), .options = style};
        p->pane.box = scene_box(scene, &p->pane.view, style->tick);
        struct vec3 size = vec_sub(p->pane.box.high, p->pane.box.low);
        p->wide = fmax(size.x, 1e-6);
        p->high = fmax(size.y, 1e-6);
    }
    l.rows = (l.n + 1) / 2;
    find_scale(&l, options->width);
    return l;
}

/* A text from y on in as many lines as it takes, broken after commas; the next y. */
static double draw_text(struct svg *svg, double y, double width, const char *text)
{
    char line[400];
    while (*text) {
        size_t n = strlen(text), cut = n;
        snprintf(line, sizeof line, "%s", text);
        while (svg_text_width(SMALL, false, line) > width) {
            while (cut > 0 && text[--cut] != ',')
                continue;
            if (cut == 0)
                break;
            snprintf(line, sizeof line, "%.*s", (int)cut + 1, text);
        }
        if (cut == 0)
            cut = n;
        if (svg)
            svg_text(svg, MARGIN, y, "start", SMALL, false, line);
        y += 17;
        text += cut < n ? cut + 1 : n;
        text += strspn(text, " ");
    }
    return y;
}

/* Title and figures; the y below them.  Without svg only measured. */
static double draw_head(struct svg *svg, const struct scene *scene,
                        const struct sheet_options *options, double width)
{
    double y = MARGIN + TITLE - 4;
    double room = width - 2 * MARGIN;
    double full = svg_text_width(TITLE, true, options->title);
    double size =
        full > room ? fmax(TITLE * room / full, SMALL) : TITLE; /* a long one is smaller */
    if (svg)
        svg_text(svg, MARGIN, y, "start", size, true, options->title);
    y += 20;
    for (size_t i = 0; i < scene->n; i++) {
        char text[400];
        const struct layer *layer = &scene->item[i];
        snprintf(text, sizeof text, scene->n > 1 ? "%.100s: %s" : "%.0s%s", sheet_name(layer->name),
                 layer->figures);
        y = draw_text(svg, y, width - 2 * MARGIN, text);
    }
    for (size_t i = 0; options->remarks && i < options->remarks->n; i++)
        y = draw_text(svg, y, width - 2 * MARGIN, options->remarks->item[i].text);
    return y + 6;
}

static void draw_caption(struct svg *svg, const struct placed_pane *p, double bottom)
{
    svg_text(svg, p->pane.x + p->wide * p->pane.scale / 2, bottom, "middle", 12, false,
             caption[p->name]);
}

static void draw_panes(struct layout *l, const struct scene *scene, struct svg *svg)
{
    for (size_t i = 0; i < l->n; i++) {
        struct placed_pane *p = &l->place[i];
        double bottom = 0;
        for (size_t k = 0; k < l->n; k++)
            if (l->place[k].row == p->row)
                bottom = fmax(bottom, l->place[k].pane.y + l->place[k].high * l->scale);
        pane_draw(&p->pane, scene, svg);
        draw_caption(svg, p, bottom + 18);
    }
}

static struct pane_options style_of(const struct scene *scene, const struct sheet_options *options)
{
    struct pane_options style = {.by_pass = options->by_pass,
                                 .by_speed = options->by_speed,
                                 .by_layer = options->by_layer,
                                 .joints = options->joints};
    struct box all = box_empty(), clouds = box_empty();
    for (size_t i = 0; i < scene->n; i++) {
        struct box box = layer_box(&scene->item[i], 0);
        box_join(&all, &box);
        for (size_t k = 0; k < scene->item[i].point.n; k++)
            box_add(&clouds, scene->item[i].point.item[k]);
    }
    style.low = clouds.low;
    style.high = clouds.high;
    style.tick = 0.05 * box_diagonal(&all);
    return style;
}

void sheet_write(struct out *out, const struct scene *scene, const struct sheet_options *options)
{
    struct pane_options style = style_of(scene, options);
    struct layout l = lay_out(scene, options, &style);
    style.marks = l.n > 1 ? MARKS / 2 : MARKS;
    l.head = draw_head(NULL, scene, options, l.width);
    place_panes(&l);
    struct legend legend = legend_of(scene, &style, l.scale, l.width - 2 * MARGIN);
    double height = l.height + legend_height(&legend) + MARGIN / 2;

    struct svg svg;
    char description[500];
    snprintf(description, sizeof description, "%s", scene->item[0].figures);
    svg_begin(&svg, out, l.width, height, options->title, description);
    draw_head(&svg, scene, options, l.width);
    draw_panes(&l, scene, &svg);
    draw_legend(&legend, &svg, MARGIN, l.height + 10);
    svg_end(&svg);
}
