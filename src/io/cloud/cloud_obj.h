/* cloud_obj - the vertices of a Wavefront OBJ file. */
#ifndef CLOUDMILL_CLOUD_OBJ_H
#define CLOUDMILL_CLOUD_OBJ_H

#include <stdbool.h>

#include "cloud_source.h"

int cloud_obj_read(struct cloud_source *source, struct error *error);

/* The line is a statement of an OBJ file: one of its keywords and a blank behind. */
bool cloud_obj_statement(const char *line, size_t n);

#endif
