/* arcmemory - see arcmemory.h. */
#include "stage/arcmemory.h"

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

bool arcmemory_take(struct arcmemory *memory, const struct trace *trace, struct pieces *pieces,
                    struct printeds *printed, struct arc_deviation *worst)
{
    for (size_t i = 0; i < memory->n; i++) {
        struct arcmemory_part *part = &memory->item[i];
        if (part->printed.n == 0 || !same_points(&part->trace, trace))
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
                                            const struct trace *trace)
{
    for (size_t i = 0; i < memory->n; i++) {
        const struct trace *t = &memory->item[i].trace;
        if (vec_distance(t->p[0], trace->p[0]) <= 0 &&
            vec_distance(t->p[t->n - 1], trace->p[trace->n - 1]) <= 0)
            return &memory->item[i];
    }
    return NULL;
}

void arcmemory_free(struct arcmemory *memory)
{
    for (size_t i = 0; i < memory->n; i++) {
        trace_free(&memory->item[i].trace);
        array_free(&memory->item[i].pieces);
        array_free(&memory->item[i].printed);
    }
    array_free(memory);
}
