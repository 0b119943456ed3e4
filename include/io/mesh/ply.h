/*
 * ply - the mesh stream (cloudmill-mesh(5)): PLY out, any PLY in.
 */
#ifndef CLOUDMILL_PLY_H
#define CLOUDMILL_PLY_H

#include "base/error.h"
#include "mesh/mesh.h"
#include "base/out.h"
#include "base/reader.h"

/*
 * Reads a mesh from PLY, ASCII or binary of either byte order, with or without normals, rows and
 * kmax; polygons become fans of triangles.  Normals are made unit vectors.  `file` NULL or "-" is
 * standard input.  Fewer or more rows than the head says, no vertices or no faces, an index out of
 * range, a number that is not finite are errors.  No storage is reserved on the word of a count
 * alone.
 */
int ply_read(const char *file, struct mesh *mesh, struct error *error);

/* The same from a reader that stands at the start of the file. */
int ply_read_mesh(struct reader *r, struct mesh *mesh, struct error *error);

/* The vertices alone, appended to `points`, those too that are not finite, and how many faces the
 * head says; the reader stands at the start of the file. */
int ply_read_points(struct reader *r, struct vec3s *points, size_t *faces, struct error *error);

/* True if the head of this file says rows of faces; what cannot be read has none. */
bool ply_has_faces(const char *file);

/* Writes the mesh stream: ASCII PLY, doubles with 6 decimals, normals and kmax with 9.  `threads`
 * as in parallel.h: numbers become text in several; the bytes are the same. */
void ply_write(struct out *out, const struct mesh *mesh, int threads);

/* The same of a mesh that is nowhere whole: its head, then so many vertices, then so many faces. */
struct ply_shape {
    size_t vertices, faces;
    bool normals, rows, kmax, surfaces; /* what they have */
};

struct ply_vertex {
    struct vec3 at, normal;
    int row, column;
    double kmax;
};

void ply_head_write(struct out *out, const struct mesh_origin *origin,
                    const struct ply_shape *shape);
void ply_vertex_write(struct out *out, const struct ply_vertex *vertex,
                      const struct ply_shape *shape);
void ply_face_write(struct out *out, const int corner[3], int surface,
                    const struct ply_shape *shape);

#endif
