/*
 * meshfile - a mesh from any file that holds one, recognised by content: PLY (cloudmill-mesh(5)),
 * STL, OFF.  The door of this folder.
 *
 * In: a file.  Out: a mesh in mm.  The format decides the reader: ply.h, of any PLY and of the mesh
 * stream, which it writes too (ply_source.h the rows, ply_origin.h what the stream says of itself);
 * stl.h; off.h.
 */
#ifndef CLOUDMILL_MESHFILE_H
#define CLOUDMILL_MESHFILE_H

#include "base/error.h"
#include "base/reader.h"
#include "mesh/mesh.h"

/*
 * Reads a mesh; NULL or "-" is standard input.  What begins with `solid` is a text STL, unless what
 * follows is no text or the file has just the size of a binary one; OFF, COFF and NOFF say so; what
 * is no text is taken for a binary STL; all else has to be PLY (ply.h).
 */
int mesh_read(const char *file, struct mesh *mesh, struct error *error);

/* The same from a reader that stands at the start of the file. */
int mesh_read_from(struct reader *r, struct mesh *mesh, struct error *error);

/* True if a file that begins so says that it is an OFF file. */
bool mesh_says_off(const char *head, size_t n);

/* True if the first bytes of this file, which can be read twice, say that it is a mesh: OFF, STL,
 * or PLY with faces.  What cannot be read is none. */
bool mesh_is_there(const char *file);

#endif
