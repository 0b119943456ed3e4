/*
 * meshfile - a mesh from any file that holds one, recognised by content: PLY (cloudmill-mesh(5)),
 * STL, OFF.
 */
#ifndef CLOUDMILL_MESHFILE_H
#define CLOUDMILL_MESHFILE_H

#include "base/error.h"
#include "mesh/mesh.h"

/*
 * Reads a mesh; NULL or "-" is standard input.  What begins with `solid` is a text STL, unless what
 * follows is no text or the file has just the size of a binary one; OFF, COFF and NOFF say so; what
 * is no text is taken for a binary STL; all else has to be PLY (ply.h).
 */
int mesh_read(const char *file, struct mesh *mesh, struct error *error);

#endif
