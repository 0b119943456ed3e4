/*
 * pane_facets - facets with the light from the upper left; see pane.h.
 *
 * What is partly hidden comes first, from the far to the near; what is not hidden anywhere lies
 * over it and not over its like, so that it is drawn shade by shade.  Facets that are more than can
 * be told apart become cells of one shade.
 */
#include <stdio.h>
#include <stdlib.h>

#include "palette.h"
#include "plot/pane.h"

struct facet {
    struct vec3 p[3]; /* projected */
    double depth;
    size_t shade, layer, number;
    bool hidden; /* partly */
};

struct facets {
    size_t n, cap;
    struct facet *item;
};

static size_t shade_of(const struct vec3 p[3])
{
    struct vec3 n = vec_unit(vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0])));
    if (n.z < 0)
        n = vec_scale(-1, n);
    struct vec3 light = vec_unit(vec(-1, 1.2, 1.6));
    double bright = fmax(0, (vec_dot(n, light) + 0.35) / 1.35); /* some light from all sides */
    return (size_t)floor(fmin(bright, 0.999) * PALETTE_SHADES);
}

static struct facet facet_of(const struct pane *pane, const struct mesh *mesh, size_t i)
{
    struct facet f = {.number = i};
    for (int k = 0; k < 3; k++)
        f.p[k] = view_point(&pane->view, mesh->vertex.item[mesh->face.item[i].v[k]]);
    f.depth = f.p[0].z + f.p[1].z + f.p[2].z;
    f.shade = shade_of(f.p);
    return f;
}

static void colour(const struct pane *pane, size_t layer, size_t shade, char ink[PALETTE_COLOUR])
{
    if (pane->style->by_layer)
        palette_tint(ink, layer, shade);
    else
        palette_shade(ink, shade);
}

static int by_depth(const void *a, const void *b)
{
    const struct facet *x = a, *y = b;
    if (x->depth < y->depth || x->depth > y->depth)
        return x->depth < y->depth ? -1 : 1;
    if (x->layer != y->layer)
        return x->layer < y->layer ? -1 : 1;
    return (x->number > y->number) - (x->number < y->number);
}

/* Which facets own a cell: they are seen. */
static bool *seen_facets(const struct pane *pane, size_t n)
{
    bool *seen = mem_alloc(n, sizeof *seen);
    for (size_t i = 0; i < pane->near.columns * pane->near.rows; i++)
        if (!isinf(pane->near.depth[i]) && pane->near.owner[i] < n)
            seen[pane->near.owner[i]] = true;
    return seen;
}

static void draw_facet(const struct pane *pane, const struct facet *f, struct svg *svg)
{
    for (int k = 0; k < 3; k++) {
        struct vec3 at = pane_place(pane, f->p[k]);
        if (k == 0)
            svg_move(svg, at.x, at.y);
        else
            svg_line(svg, at.x, at.y);
    }
    svg_close(svg);
}

static void begin_shade(const struct pane *pane, size_t layer, size_t shade, struct svg *svg)
{
    char fill[PALETTE_COLOUR], ink[40];
    colour(pane, layer, shade, fill);
    snprintf(ink, sizeof ink, "fill=\"%s\"", fill);
    svg_path(svg, ink);
}

/* One path for each row of facets of the same shade. */
static void draw_in_order(const struct pane *pane, const struct facets *facets, struct svg *svg)
{
    bool open = false;
    for (size_t i = 0; i < facets->n; i++) {
        const struct facet *f = &facets->item[i];
        bool same = i > 0 && f[-1].shade == f->shade && f[-1].layer == f->layer;
        if (!f->hidden)
            continue;
        if (!open || !same) {
            if (open)
                svg_path_end(svg);
            begin_shade(pane, f->layer, f->shade, svg);
            open = true;
        }
        draw_facet(pane, f, svg);
    }
    if (open)
        svg_path_end(svg);
}

static void draw_shade(const struct pane *pane, const struct facets *facets, size_t layer,
                       size_t shade, struct svg *svg)
{
    bool open = false;
    for (size_t i = 0; i < facets->n; i++) {
        const struct facet *f = &facets->item[i];
        if (f->hidden || f->layer != layer || f->shade != shade)
            continue;
        if (!open)
            begin_shade(pane, layer, shade, svg);
        open = true;
        draw_facet(pane, f, svg);
    }
    if (open)
        svg_path_end(svg);
}

static void draw_facets(const struct pane *pane, struct facets *facets, size_t layers, bool under,
                        struct svg *svg)
{
    double area = (pane->box.high.x - pane->box.low.x) * (pane->box.high.y - pane->box.low.y);
    double size = pane->scale * sqrt(area / (double)facets->n); /* of two facets, px */
    char ink[100];
    snprintf(ink, sizeof ink, "stroke=\"%s\" stroke-width=\"%s\" stroke-linejoin=\"round\"",
             under ? "#9BA8B5" : "#4A5866", size > 5 ? "4" : "1.5");
    svg_group(svg, ink);
    for (size_t i = 0; i < facets->n; i++) {
        struct facet *f = &facets->item[i];
        f->hidden = raster_hides(&pane->near, f->p[0], f->p[1], f->p[2], pane->near.cell);
    }
    qsort(facets->item, facets->n, sizeof *facets->item, by_depth);
    draw_in_order(pane, facets, svg);
    for (size_t layer = 0; layer < layers; layer++)
        for (size_t shade = 0; shade < PALETTE_SHADES; shade++)
            draw_shade(pane, facets, layer, shade, svg);
    svg_group_end(svg);
}

/* All facets of the scene that are seen, and the shade and layer of each facet. */
static struct facets collect(const struct pane *pane, const struct scene *scene, const bool *seen)
{
    struct facets facets = {0};
    size_t number = 0;
    for (size_t layer = 0; layer < scene->n; layer++) {
        const struct mesh *mesh = &scene->item[layer].mesh;
        for (size_t i = 0; i < mesh->face.n; i++, number++) {
            if (!seen[number])
                continue;
            struct facet f = facet_of(pane, mesh, i);
            f.layer = layer;
            f.number = number;
            *array_push(&facets) = f;
        }
    }
    return facets;
}

/* The look of the middle of a cell: its shade and layer as one number, NONE where nothing is. */
static size_t look(const struct pane *pane, const size_t *look_of, double x, double y)
{
    size_t cell = raster_cell(&pane->near, x, y);
    return isinf(pane->near.depth[cell]) ? (size_t)-1 : look_of[pane->near.owner[cell]];
}

/* Runs of cells of one look, along the rows. */
static void draw_runs(const struct pane *pane, const size_t *look_of, size_t want, double cell,
                      struct svg *svg)
{
    const struct box *b = &pane->box;
    for (double y = b->high.y - cell / 2; y > b->low.y; y -= cell) {
        for (double x = b->low.x + cell / 2; x < b->high.x; x += cell) {
            if (look(pane, look_of, x, y) != want)
                continue;
            struct vec3 from = pane_place(pane, vec(x - cell / 2, y, 0));
            while (x < b->high.x && look(pane, look_of, x, y) == want)
                x += cell;
            struct vec3 to = pane_place(pane, vec(fmin(x - cell / 2, b->high.x), y, 0));
            svg_move(svg, from.x, from.y);
            svg_line(svg, to.x, to.y);
        }
    }
}

static void draw_cells(const struct pane *pane, const struct facets *facets, size_t faces,
                       size_t layers, struct svg *svg)
{
    size_t *look_of = mem_alloc(faces, sizeof *look_of);
    for (size_t i = 0; i < facets->n; i++)
        look_of[facets->item[i].number] =
            facets->item[i].layer * PALETTE_SHADES + facets->item[i].shade;
    double cell = 1.5 / pane->scale; /* px */
    for (size_t want = 0; want < layers * PALETTE_SHADES; want++) {
        char fill[PALETTE_COLOUR], ink[120];
        colour(pane, want / PALETTE_SHADES, want % PALETTE_SHADES, fill);
        snprintf(ink, sizeof ink,
                 "fill=\"none\" stroke=\"%s\" stroke-width=\"17\" "
                 "shape-rendering=\"crispEdges\"",
                 fill);
        svg_path(svg, ink);
        draw_runs(pane, look_of, want, cell, svg);
        svg_path_end(svg);
    }
    free(look_of);
}

void pane_facets(struct pane *pane, const struct scene *scene, struct svg *svg)
{
    size_t faces = 0;
    bool under = false; /* a path: its strokes are to stand out */
    for (size_t i = 0; i < scene->n; i++) {
        faces += scene->item[i].mesh.face.n;
        under |= scene->item[i].stroke.n > 0;
    }
    if (faces == 0)
        return;
    bool *seen = seen_facets(pane, faces);
    struct facets facets = collect(pane, scene, seen);
    if (facets.n <= pane->style->marks)
        draw_facets(pane, &facets, scene->n, under, svg);
    else
        draw_cells(pane, &facets, faces, scene->n, svg);
    array_free(&facets);
    free(seen);
}
