/* iges_groups - see iges_groups.h. */
#include "iges_groups.h"

#include <stdlib.h>

#include "base/array.h"
#include "iges_curve.h"

static bool is_group(const struct iges_entity *e)
{
    return e->type == 402 && (e->form == 1 || e->form == 7 || e->form == 14 || e->form == 15);
}

/* Marks what one group holds; as many pointers as it says, or as there are. */
static int mark_group(const struct iges *iges, const struct iges_entity *e, int number, int *group,
                      struct error *error)
{
    struct iges_values v;
    const struct iges_entity *held;
    int status = 0;
    if (iges_values(iges, e, &v, error) < 0)
        return -1;
    size_t n = v.n > 1 && v.item[1].number > 0 ? (size_t)v.item[1].number : 0;
    for (size_t k = 2; k < n + 2 && k < v.n && status == 0; k++) {
        status = iges_pointer(iges, &v, k, &held, error);
        if (status == 0 && group[held - iges->entity.item] == 0)
            group[held - iges->entity.item] = number;
    }
    array_free(&v);
    return status;
}

int *iges_groups(const struct iges *iges, struct error *error)
{
    int *group = mem_alloc(iges->entity.n + 1, sizeof *group), number = 0;
    for (size_t i = 0; i < iges->entity.n; i++) {
        const struct iges_entity *e = &iges->entity.item[i];
        if (is_group(e) && mark_group(iges, e, ++number, group, error) < 0) {
            free(group);
            return NULL;
        }
    }
    return group;
}
