/*
 * ply_head - the head of a PLY file: its format, elements and properties, and what the mesh stream
 * says of itself in comments.
 */
#ifndef CLOUDMILL_PLY_HEAD_H
#define CLOUDMILL_PLY_HEAD_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"
#include "mesh/mesh.h"
#include "base/reader.h"

enum ply_format { PLY_ASCII, PLY_LITTLE_ENDIAN, PLY_BIG_ENDIAN };

enum ply_type {
    PLY_INT8,
    PLY_UINT8,
    PLY_INT16,
    PLY_UINT16,
    PLY_INT32,
    PLY_UINT32,
    PLY_FLOAT32,
    PLY_FLOAT64
};

enum { PLY_NAME_MAX = 32 };

struct ply_property {
    char name[PLY_NAME_MAX]; /* cut short when longer: then it is none that we know */
    enum ply_type type;      /* of the value, or of each value of a list */
    bool list;
    enum ply_type length_type; /* of a list's length */
};

struct ply_element {
    char name[PLY_NAME_MAX];
    size_t count; /* rows, as the head says: to be believed when they have been read */
    struct {
        size_t n, cap;
        struct ply_property *item;
    } property;
};

struct ply_head {
    enum ply_format format;
    struct {
        size_t n, cap;
        struct ply_element *item;
    } element;
};

/*
 * Reads from `ply` to `end_header`; comments of the mesh stream go to *origin.  What is no PLY
 * head, an unknown format or type, or a count that is no whole number is an error.  The head is to
 * be freed in either case.
 */
int ply_head_read(struct reader *r, struct ply_head *head, struct mesh_origin *origin,
                  struct error *error);

void ply_head_free(struct ply_head *head);

/* The element of this name, NULL when there is none; the same for an element's property, not a
 * list: its index, or -1. */
const struct ply_element *ply_head_element(const struct ply_head *head, const char *name);
int ply_element_property(const struct ply_element *element, const char *name);

#endif
