/*
 * cloud_stream - the mesh of a cloud that is nowhere whole in memory: its points are read again for
 * each look at it, and what is kept goes with the nodes of the grid.  To read their text takes
 * longer than to look at them: the points of a small file may be kept, and those of a larger one go
 * into a spool (io/cloud/cloud_spool.h) in the first look; where there is no room for that the file
 * is read again.
 *
 * Nodes and normals of the facets (--normals facet) need no more: the same mesh as cloudmesh.h
 * makes, byte by byte.  The looks:
 *
 *   1. the extent, how many points, their hash
 *   2. the mean spacing (again where the cloud has gaps), and whether there is an area
 *   3. which point each node takes (meshing/reposition.h); where the spacing is given, in look 2
 *   4. which cells have points (cloud/holes.h), and points for the nodes left empty
 *
 * About 40 bytes a node, and a bit for each quarter of a point.
 *
 * Normals of quadrics are the same as cloudmesh.h makes, too (of a cloud of which no point is taken
 * out, without creases, walls and ribs), by points that are in memory for a band of rows at a time
 * (stream_surface.h).  More looks:
 *
 *   5. the points about places that tell the noise, and how many points a surface takes
 *   6. into which bands of rows they go (stream_bands.h), of which one at a time is in memory: two
 *      points for five vertices, but two million at least
 *
 * About 80 bytes a node, half a byte a point, and 100 MB.
 */
#ifndef CLOUDMILL_CLOUD_STREAM_H
#define CLOUDMILL_CLOUD_STREAM_H

#include "base/out.h"
#include "io/cloud/cloud.h"
#include "math/box.h"
#include "meshing/grid_facets.h"
#include "stage/cloudmesh.h"

/* A vertex on the surface of the scan. */
struct stream_vertex {
    int32_t normal[3]; /* in 1e-9: the digits that are written */
    float off;         /* from its quadric, mm; negative: it has none */
    double kmax;       /* mesh.h */
};

struct cloud_stream {
    const char *file;
    bool once;                       /* it can be read but once, as a pipe: the spool is needed */
    struct transform place;          /* from its units to mm */
    int threads;                     /* one reads, the other works on what was read */
    struct cloud_count count;        /* what was read, and what was skipped */
    size_t n;                        /* points */
    struct vec3s kept;               /* as placed, of a small file; empty where it is larger */
    struct cloud_spool *spool;       /* as placed, of a larger one; NULL: there is no room for it */
    uint64_t hash;                   /* scan_source.h */
    struct box box;                  /* as placed, mm */
    struct plan_extent flat, turned; /* in direction 0, and in that of the rows */
    double mean;                     /* spacing of the points, mm */
    struct cloudmesh_options options; /* with the spacing that was taken */
    struct reposition nodes;
    struct holes holes;
    struct grid_facets facets;
    struct stream_counts *counts; /* stream_surface.h */
    struct stream_vertex *vertex; /* in order; NULL: normals are those of the facets */
    double noise, ledger;         /* with them: mesh_origin has them */
};

/* May a mesh be made so: a grid of one spacing, one projection, nodes on points, normals of facets?
 */
bool cloud_stream_serves(const struct cloudmesh_options *options);

enum { CLOUD_STREAM_KEEP = (32 << 20) / sizeof(struct vec3) /* points that are no great matter */ };

/* The first two looks, at a file whose points `place` puts into mm; they are kept where there are
 * no more than `keep`.  With 0 it may be a pipe.  1: it is no regular file, or its points carry no
 * surface; -1: an error, of a pipe that too. */
int cloud_stream_begin(const char *file, const struct transform *place,
                       const struct cloudmesh_options *options, size_t keep, int threads,
                       struct cloud_stream *stream, struct error *error);

/* The others.  -1: as cloudmesh_make. */
int cloud_stream_nodes(struct cloud_stream *stream, struct error *error);

/* Where normals are those of the surface (normals.h), after that: vertices at their nodes, normals,
 * curvatures, `noise` and ledger.  `noise` is what the user says of it, negative: it is measured;
 * `at_a_time` points are in memory, unless one row needs more: of which the result does not depend.
 * -1: the file cannot be read again. */
int cloud_stream_surface(struct cloud_stream *stream, double noise, size_t at_a_time,
                         struct error *error);

/* As many as are no great matter beside the nodes: two for five vertices, two million
 * at least. */
size_t cloud_stream_at_a_time(const struct cloud_stream *stream);

void cloud_stream_free(struct cloud_stream *stream);

/* The mesh stream. */
void cloud_stream_write(struct out *out, const struct cloud_stream *stream,
                        const struct mesh_origin *origin);

#endif
