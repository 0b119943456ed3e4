/*
 * stl - meshes from STL, text or binary.
 *
 * An STL has no units: its numbers are taken as mm.  Its normals are not used, for they say no more
 * than the order of the corners.  Vertices at one place are made one (mesh_weld.h).
 */
#ifndef CLOUDMILL_STL_H
#define CLOUDMILL_STL_H

#include <stdbool.h>

#include "base/error.h"
#include "mesh/mesh.h"
#include "base/reader.h"

/* True when the file has just the size that the count of facets in its head, its first n bytes,
 * gives a binary STL.  False when the size is not known. */
bool stl_is_binary(const struct reader *r, const char *head, size_t n);

/* True where a text of n bytes begins with this word of an STL file, in any case. */
bool stl_begins(const char *text, size_t n, const char *word);

/*
 * From a reader that stands at the start of the file.  A file that ends early, has no facets, or a
 * number that is not finite is an error; no storage is reserved on the word of a count.  In a text
 * each facet is written as `facet ... vertex x y z` three times ` ... endfacet`, in as many solids
 * as there are.
 */
int stl_read_binary(struct reader *r, struct mesh *mesh, struct error *error);
int stl_read_text(struct reader *r, struct mesh *mesh, struct error *error);

#endif
