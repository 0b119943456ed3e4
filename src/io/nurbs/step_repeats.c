/* step_repeats - see step_repeats.h. */
#include "step_repeats.h"

#include <stdlib.h>
#include <string.h>

static int compare_entities(const void *p, const void *q)
{
    int a = *(const int *)p, b = *(const int *)q;
    return (a > b) - (a < b);
}

static void sort_entities(struct ints *entity)
{
    if (entity->n > 0)
        qsort(entity->item, entity->n, sizeof *entity->item, compare_entities);
}

static bool has_entity(const struct ints *sorted, int entity)
{
    return sorted->n > 0 &&
           bsearch(&entity, sorted->item, sorted->n, sizeof entity, compare_entities) != NULL;
}

/* Drops the faces that are marked. */
static void drop_marked(struct patches *patches, size_t from, const bool *marked)
{
    size_t kept = from;
    for (size_t i = from; i < patches->n; i++) {
        if (marked[i])
            patch_free(&patches->item[i]);
        else
            patches->item[kept++] = patches->item[i];
    }
    patches->n = kept;
}

void step_drop_unplaced(struct patches *patches, const struct sizes *unplaced, size_t from)
{
    struct ints placed = {0};
    bool *marked = mem_alloc(patches->n + 1, sizeof *marked);
    for (size_t i = 0; i + 1 < unplaced->n; i += 2)
        for (size_t k = unplaced->item[i]; k < unplaced->item[i + 1]; k++)
            marked[k] = true;
    for (size_t i = from; i < patches->n; i++)
        if (!marked[i])
            *array_push(&placed) = patches->item[i].entity;
    sort_entities(&placed);
    for (size_t i = from; i < patches->n; i++)
        marked[i] = marked[i] && has_entity(&placed, patches->item[i].entity);
    drop_marked(patches, from, marked);
    array_free(&placed);
    free(marked);
}

void step_drop_named(struct patches *patches, size_t from)
{
    struct ints of_shell = {0};
    bool *marked = mem_alloc(patches->n + 1, sizeof *marked);
    for (size_t i = from; i < patches->n; i++)
        if (patches->item[i].body > 0)
            *array_push(&of_shell) = patches->item[i].entity;
    sort_entities(&of_shell);
    for (size_t i = from; i < patches->n; i++)
        marked[i] = patches->item[i].body == 0 && has_entity(&of_shell, patches->item[i].entity);
    drop_marked(patches, from, marked);
    array_free(&of_shell);
    free(marked);
}

/* A face among all. */
struct placed {
    const struct patch *patch;
    size_t index;
};

static int compare_surfaces(const struct nurbs *a, const struct nurbs *b)
{
    size_t n = a->u.poles * a->v.poles, k = b->u.poles * b->v.poles;
    return n != k ? (n > k) - (n < k) : memcmp(a->pole, b->pole, n * sizeof *a->pole);
}

/* By entity, by place, then as they come. */
static int compare_placed(const void *p, const void *q)
{
    const struct placed *a = p, *b = q;
    int by = compare_entities(&a->patch->entity, &b->patch->entity);
    if (by == 0)
        by = compare_surfaces(&a->patch->surface, &b->patch->surface);
    return by != 0 ? by : (a->index > b->index) - (a->index < b->index);
}

void step_drop_repeated(struct patches *patches, size_t from)
{
    size_t n = patches->n - from;
    struct placed *all = mem_alloc(n + 1, sizeof *all);
    bool *again = mem_alloc(patches->n + 1, sizeof *again);
    for (size_t i = 0; i < n; i++)
        all[i] = (struct placed){&patches->item[from + i], from + i};
    if (n > 0)
        qsort(all, n, sizeof *all, compare_placed);
    for (size_t i = 1; i < n; i++)
        again[all[i].index] =
            all[i].patch->entity == all[i - 1].patch->entity &&
            compare_surfaces(&all[i].patch->surface, &all[i - 1].patch->surface) == 0;
    drop_marked(patches, from, again);
    free(all);
    free(again);
}
