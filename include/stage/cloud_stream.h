/*
 * cloud_stream - the mesh of a cloud that is nowhere whole in memory: its file is read again for
 * each look at it, and what is kept goes with the nodes of the grid.  The points of a small file
 * may be kept, for to read them takes longer than to look at them.
 *
 * Nodes on points of the scan and normals of the facets (--normals facet) need no more: the same
 * mesh as cloudmesh.h makes, byte by byte.  The looks:
 *
 *   1. the extent, how many points, their hash
 *   2. the mean spacing (again where the cloud has gaps), and whether there is an area
 *   3. which point each node takes (meshing/reposition.h); where the spacing is given, in look 2
 *   4. which cells have points (cloud/holes.h), and points for the nodes left empty
 *
 * About 40 bytes a node, and a bit for each quarter of a point.
 */
#ifndef CLOUDMILL_CLOUD_STREAM_H
#define CLOUDMILL_CLOUD_STREAM_H

#include "base/out.h"
#include "io/cloud/cloud.h"
#include "math/box.h"
#include "meshing/grid_facets.h"
#include "stage/cloudmesh.h"

struct cloud_stream {
    const char *file;
    struct transform place;           /* from its units to mm */
    int threads;                      /* one reads, the other works on what was read */
    struct cloud_count count;         /* what was read, and what was skipped */
    size_t n;                         /* points */
    struct vec3s kept;                /* as placed, of a small file; empty where it is larger */
    uint64_t hash;                    /* scan_source.h */
    struct box box;                   /* as placed, mm */
    struct plan_extent flat, turned;  /* in direction 0, and in that of the rows */
    double mean;                      /* spacing of the points, mm */
    struct cloudmesh_options options; /* with the spacing that was taken */
    struct reposition nodes;
    struct holes holes;
    struct grid_facets facets;
};

/* May a mesh be made so: a grid of one spacing, one projection, nodes on points, normals of facets?
 */
bool cloud_stream_serves(const struct cloudmesh_options *options);

enum { CLOUD_STREAM_KEEP = (32 << 20) / sizeof(struct vec3) /* points that are no great matter */ };

/* The first two looks, at a file whose points `place` puts into mm; they are kept where there are
 * no more than `keep`.  1: it is no regular file, or its points carry no surface; -1: an error. */
int cloud_stream_begin(const char *file, const struct transform *place,
                       const struct cloudmesh_options *options, size_t keep, int threads,
                       struct cloud_stream *stream, struct error *error);

/* The others.  -1: as cloudmesh_make. */
int cloud_stream_nodes(struct cloud_stream *stream, struct error *error);

void cloud_stream_free(struct cloud_stream *stream);

/* The mesh stream. */
void cloud_stream_write(struct out *out, const struct cloud_stream *stream,
                        const struct mesh_origin *origin);

#endif
