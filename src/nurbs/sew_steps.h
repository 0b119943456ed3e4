/*
 * sew_steps - what the steps of sew.h share: the border of the mesh, and one round of sewing.
 */
#ifndef CLOUDMILL_SEW_STEPS_H
#define CLOUDMILL_SEW_STEPS_H

#include "base/array.h"
#include "math/kdtree.h"
#include "nurbs/patch.h"
#include "nurbs/patch_mesh.h"

/* The edges that no second triangle shares. */
struct boundary {
    struct sizes edge;   /* of patch_mesh.edge */
    struct sizes vertex; /* at their ends, rising */
    struct kdtree *tree; /* of these vertices */
};

/* A vertex that lies on a border edge. */
struct t_vertex {
    double t;      /* how far along the edge, 0 to 1 */
    size_t vertex; /* whose place it takes */
    struct uv at;  /* its parameters on the surface of the edge */
};

struct t_vertices {
    size_t n, cap;
    struct t_vertex *item;
};

/* A vertex that meets the border of a sheet.  Pairs along connected border edges form a run, named
 * by the index of one of its pairs (union-find). */
struct boundary_pair {
    size_t vertex;
    int sheet;
    size_t run;
    double length; /* of the run, in the pair that names it, mm */
};

struct boundary_match {
    size_t n, cap;
    struct boundary_pair *item; /* by vertex and sheet */
};

/* One round. */
struct sewing {
    struct patch_mesh *mesh;
    const struct patches *patches;
    struct boundary border;
    struct boundary_match match;
    double gap;         /* mm: what is nearer meets */
    double slack;       /* mm: how far border edges of trimmed patches may be off the true border */
    double off_surface; /* mm: how far T-vertices may be off the surface of their edge */
    double same;        /* mm: vertices so near are one */
    bool slits;         /* T-vertices are those that an open edge joins to an end of their edge */
    size_t
        *next; /* of each place, when it is about slits: a place beside it along an open edge ... */
    size_t *last; /* ... and another one; NOWHERE: there is none, or there are more than two */
};

/* The vertex of that number; a place on the straight line between two. */
static inline const struct patch_mesh_vertex *sew_vertex(const struct sewing *s, size_t i)
{
    return &s->mesh->vertex.item[i];
}

static inline struct uv sew_uv_between(struct uv a, struct uv b, double t)
{
    return (struct uv){a.u + t * (b.u - a.u), a.v + t * (b.v - a.v)};
}

/* ---- sew_border: the border, and vertices that lie on edges of it */

/* The border of the mesh, which sew_free_border frees. */
void sew_find_border(const struct patch_mesh *q, struct boundary *b);
void sew_free_border(struct boundary *b);

/* True if the two vertices are neighbours on the same piece and not the two sides of a seam: less
 * than half the range apart. */
bool sew_are_beside(const struct patches *patches, const struct patch_mesh_vertex *a,
                    const struct patch_mesh_vertex *b);

/* The border vertices within `far` of a point that a sheet may be joined to.  Places in
 * border.vertex. */
void sew_find_near(const struct sewing *s, struct vec3 p, double far, int sheet,
                   struct sizes *found);

/* The vertices, in the order of the edge, that lie between its ends, near its chord as far as the
 * surface and the slack allow, and within the gap of the edge's surface `part`. */
void sew_find_t_vertices(const struct sewing *s, const struct nurbs *part,
                         const struct patch_mesh_edge *e, struct t_vertices *on_edge);

/* ---- sew_match: borders that run side by side */

/* All pairs and the runs that they form: border edges of which both ends meet the border of one
 * other sheet, or of the same sheet half its range away. */
void sew_match(const struct sewing *s, struct boundary_match *c);

/* Does the border at this vertex run along the border of the sheet? */
bool sew_is_matched(const struct sewing *s, size_t vertex, int sheet);

/* Drops the T-vertices of an edge of the sheet whose own border does not run along it. */
void sew_keep_matched(const struct sewing *s, int sheet, struct t_vertices *on_edge);

/* ---- sew_insert: vertices put into edges */

/* Puts the T-vertices of all border edges into them, and splits their triangles. */
void sew_insert(struct sewing *s);

#endif
