/*
 * stream - which of the suite's streams a file is, by its content.
 */
#ifndef CLOUDMILL_STREAM_H
#define CLOUDMILL_STREAM_H

#include <stddef.h>

#include "base/error.h"

enum stream_kind { STREAM_CLOUD, STREAM_MESH, STREAM_PATH, STREAM_PROGRAM };

/* By the first n bytes of a file: PLY with facets, STL (text) and OFF are meshes, APT statements a
 * path, blocks of an NC program a program; all else is left to the reader of clouds. */
enum stream_kind stream_tell(const char *head, size_t n);

/*
 * What the file is (NULL or "-": standard input), and *name, by which its reader then opens it.  A
 * pipe, which can be read only once, is copied to a file without a name that becomes standard
 * input, and *name is "-".
 */
int stream_find(const char *file, enum stream_kind *kind, const char **name, struct error *error);

/* Standard input from its start once more, when it was stream_find that named it. */
int stream_again(const char *name, struct error *error);

#endif
