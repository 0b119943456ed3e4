/* arcmemory - see arcmemory.h. */
#include "arcmemory.h"

#include <stdlib.h>

static bool same_points(const struct trace *a, const struct trace *b)
{
    if (a->n != b->n)
        return false;
    for (size_t i = 0; i < a->n; i++)
        if (vec_distance(a->p[i], b->p[i]) > 0 || vec_distance(a->other[i], b->other[i]) > 0 ||
            vec_distance(a->axis[i], b->axis[i]) > 0)
            return false;
    return true;
}

bool arcmemory_take(struct arcmemory *memory, const struct trace *trace, struct printeds *printed,
                    struct stray *worst)
{
    for (size_t i = 0; i < memory->n; i++) {
        struct arcmemory_part *part = &memory->item[i];
        if (part->printed.n == 0 || !same_points(&part->trace, trace))
            continue;
        array_free(printed);
        *printed = part->printed;
        *worst = part->worst;
        part->printed = (struct printeds){0};
        return true;
    }
    return false;
}

void arcmemory_free(struct arcmemory *memory)
{
    for (size_t i = 0; i < memory->n; i++) {
        trace_free(&memory->item[i].trace);
        array_free(&memory->item[i].printed);
    }
    array_free(memory);
}
