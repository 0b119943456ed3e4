/* sheet - layout: views in rows of two, at one scale; see sheet.h. */
#include "plot/sheet.h"

#include <stdio.h>
#include <string.h>

#include "plot/sheet_legend.h"

enum { MARKS = 16000 }; /* in one view, about; half of it where there are more */

static const double MARGIN = 24, GAP = 36, CAPTION = 26, TITLE = 18, SMALL = 12.5, HEIGHT = 680;

static const char *const caption[VIEW_NAMES] = {
    [VIEW_PLAN] = "plan (x right, y up)",
    [VIEW_ISO] = "isometric",
    [VIEW_FRONT] = "front (x right, z up)",
    [VIEW_SIDE] = "side (y right, z up)",
};

struct place {
    enum view_name name;
    struct pane pane;
    size_t row;
    double wide, high; /* mm */
};

struct layout {
    size_t n, rows;
    struct place place[4];
    double scale, width, height, head; /* px */
};

static size_t choose(enum sheet_views views, enum view_name name[4])
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

static void put_panes(struct layout *l)
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
            struct place *p = &l->place[i];
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
    struct layout l = {.n = choose(options->views, name)};
    for (size_t i = 0; i < l.n; i++) {
        struct place *p = &l.place[i];
        p->name = name[i];
        p->row = i / 2;
        p->pane = (struct pane){.view = view_from(name[i]), .style = style};
        p->pane.box = scene_box(scene, &p->pane.view, style->tick);
        struct vec3 size = vec_sub(p->pane.box.high, p->pane.box.low);
        p->wide = fmax(size.x, 1e-6);
        p->high = fmax(size.y, 1e-6);
    }
    l.rows = (l.n + 1) / 2;
    find_scale(&l, options->width);
    return l;
}

/* A text from y on in as many lines as it takes, broken behind commas; the next y. */
static double put_text(struct svg *svg, double y, double width, const char *text)
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
static double put_head(struct svg *svg, const struct scene *scene,
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
        y = put_text(svg, y, width - 2 * MARGIN, text);
    }
    for (size_t i = 0; options->remarks && i < options->remarks->n; i++)
        y = put_text(svg, y, width - 2 * MARGIN, options->remarks->item[i].text);
    return y + 6;
}

static void put_caption(struct svg *svg, const struct place *p, double bottom)
{
    char text[120], times[24];
    const size_t every = p->pane.every;
    snprintf(times, sizeof times, every == 2 ? "2nd" : "%zuth", every);
    snprintf(text, sizeof text, every > 1 ? "%s, every %s pass" : "%s", caption[p->name], times);
    svg_text(svg, p->pane.x + p->wide * p->pane.scale / 2, bottom, "middle", 12, false, text);
}

static void draw_panes(struct layout *l, const struct scene *scene, struct svg *svg)
{
    for (size_t i = 0; i < l->n; i++) {
        struct place *p = &l->place[i];
        double bottom = 0;
        for (size_t k = 0; k < l->n; k++)
            if (l->place[k].row == p->row)
                bottom = fmax(bottom, l->place[k].pane.y + l->place[k].high * l->scale);
        pane_draw(&p->pane, scene, svg);
        put_caption(svg, p, bottom + 18);
    }
}

static struct pane_options style_of(const struct scene *scene, const struct sheet_options *options)
{
    struct pane_options style = {
        .by_pass = options->by_pass, .by_layer = options->by_layer, .joints = options->joints};
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
    l.head = put_head(NULL, scene, options, l.width);
    put_panes(&l);
    struct legend legend = legend_of(scene, &style, l.scale, l.width - 2 * MARGIN);
    double height = l.height + legend_height(&legend) + MARGIN / 2;

    struct svg svg;
    char description[500];
    snprintf(description, sizeof description, "%s", scene->item[0].figures);
    svg_begin(&svg, out, l.width, height, options->title, description);
    put_head(&svg, scene, options, l.width);
    draw_panes(&l, scene, &svg);
    legend_draw(&legend, &svg, MARGIN, l.height + 10);
    svg_end(&svg);
}
