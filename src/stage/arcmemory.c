/* arcmemory - see arcmemory.h. */
#include "stage/arcmemory.h"

#include <stdlib.h>

static bool same_points(const struct reference *a, const struct reference *b)
{
    if (a->n != b->n)
        return false;
    for (size_t i = 0; i < a->n; i++)
        if (vec_distance(a->point[i], b->point[i]) > 0 ||
            vec_distance(a->other[i], b->other[i]) > 0 || vec_distance(a->axis[i], b->axis[i]) > 0)
            return false;
    return true;
}

bool arcmemory_take(struct arcmemory *memory, const struct reference *reference,
                    struct pieces *pieces, struct printeds *printed, struct deviation *worst)
{
    for (size_t i = 0; i < memory->n; i++) {
        struct arcmemory_part *part = &memory->item[i];
        if (part->printed.n == 0 || !same_points(&part->reference, reference))
            continue;
        array_free(pieces);
        array_free(printed);
        *pieces = part->pieces;
        *printed = part->printed;
        *worst = part->worst;
        part->pieces = (struct pieces){0};
        part->printed = (struct printeds){0};
        return true;
    }
    return false;
}

const struct arcmemory_part *arcmemory_like(const struct arcmemory *memory,
                                            const struct reference *reference)
{
    for (size_t i = 0; i < memory->n; i++) {
        const struct reference *t = &memory->item[i].reference;
        if (vec_distance(t->point[0], reference->point[0]) <= 0 &&
            vec_distance(t->point[t->n - 1], reference->point[reference->n - 1]) <= 0)
            return &memory->item[i];
    }
    return NULL;
}

void arcmemory_free(struct arcmemory *memory)
{
    for (size_t i = 0; i < memory->n; i++) {
        reference_free(&memory->item[i].reference);
        array_free(&memory->item[i].pieces);
        array_free(&memory->item[i].printed);
    }
    array_free(memory);
}
