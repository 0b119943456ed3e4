/*
 * plot - a picture, as SVG, of any stream of the suite or of several together.  The door of the
 * folder.
 *
 * In: files that hold a cloud, a mesh, a path or an NC program, recognized by content.  Out: a
 * sheet with a title, views, a legend and a scale bar; or how far one stream is from another.
 *
 * Stages:
 *   1. layer_read        a stream as a layer of a scene (plot/scene.h): points, facets, strokes;
 *   2. layer_distance_of from one layer to the nearest place of another (math/box_tree.h);
 *   3. sheet_write       the layout of views at one scale and the legend.  Private: pane.h one view
 *                        and its order of drawing, raster.h what hides what (a depth buffer),
 *                        decimate.h chains with no more points than can be seen (Williams 1978,
 *                        Zhao and Saalfeld 1997), palette.h colours (Okabe and Ito; viridis),
 *                        view.h projections, svg.h the text of the picture.
 */
#ifndef CLOUDMILL_PLOT_H
#define CLOUDMILL_PLOT_H

#include "base/error.h"
#include "plot/scene.h"

struct out;

/* ---- layers */

struct layer_options {
    double unit;         /* mm in a unit of a cloud */
    bool poles;          /* of B-splines */
    bool normals;        /* of a mesh, of contact points */
    bool axes;           /* of the tool */
    bool cut;            /* no rapid moves */
    bool speed;          /* strokes end where the speed changes: programs alone have one */
    double chord;        /* mm: curves in pieces no further off than this; 0: as can be seen */
    const char *machine; /* that a program is for (machine.h), NULL: the default one */
};

/* Reads the file (NULL or "-": standard input), whatever it holds. */
int layer_read(const char *file, const struct layer_options *options, struct layer *layer,
               struct error *error);

/* ---- how far one layer is from another */

struct layer_distance {
    size_t n;          /* places measured; 0: nothing to measure */
    double worst, rms; /* mm */
    double most95;     /* mm: 95 in 100 places are no further */
    struct vec3 at;    /* where the worst is */
};

/*
 * From the places of `from` (points; vertices of a mesh; what is cut of a path or program, at its
 * nodes and between them no coarser than a thousandth of its extent) to the nearest place of `to`:
 * its points, facets, or straight pieces of what is cut.  On `threads` threads (parallel.h).
 */
struct layer_distance layer_distance_of(const struct layer *from, const struct layer *to,
                                        int threads);

/* ---- the sheet */

enum sheet_views { SHEET_BOTH, SHEET_PLAN, SHEET_ISO, SHEET_FRONT, SHEET_SIDE, SHEET_ALL };

enum { REMARK = 300 };

struct remarks {
    size_t n, cap;
    struct remark {
        char text[REMARK];
    } * item;
};

struct sheet_options {
    const char *title;
    enum sheet_views views; /* BOTH: plan and isometric */
    double width;           /* px, at most */
    bool by_pass, by_layer, by_speed, joints;
    const struct remarks *remarks; /* further lines of figures, NULL: none */
};

/* Writes the scene, which has something to draw, as SVG. */
void sheet_write(struct out *out, const struct scene *scene, const struct sheet_options *options);

/* The name of a file without its folder. */
const char *sheet_name(const char *file);

#endif
