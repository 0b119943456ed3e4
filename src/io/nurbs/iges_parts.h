/*
 * iges_parts - where the parts of an IGES file stand: solids and their instances (186, 184, 430),
 * shells (514), subfigures and their instances (308, 408), groups (402).
 */
#ifndef CLOUDMILL_IGES_PARTS_H
#define CLOUDMILL_IGES_PARTS_H

#include "iges.h"
#include "math/transform.h"

/* A face or surface, and what places it besides its own transformation, in the file's lengths. */
struct iges_part {
    const struct iges_entity *entity;
    struct transform to;
    int body;    /* the shell of a solid that it belongs to, from *bodies on; 0: none */
    bool cavity; /* which bounds a void */
};

struct iges_parts {
    size_t n, cap;
    struct iges_part *item;
};

/*
 * All entities for which `counts` is true, as often as the file places them; those that only a
 * definition holds are placed where its instances are.  `bodies` grows by the shells of solids.
 * The caller frees the list (array_free).
 */
int iges_parts(const struct iges *iges, bool (*counts)(int type), int *bodies,
               struct iges_parts *parts, struct error *error);

#endif
