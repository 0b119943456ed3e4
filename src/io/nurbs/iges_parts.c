/* iges_parts - see iges_parts.h. */
#include "iges_parts.h"

#include <stdlib.h>

#include "base/array.h"
#include "iges_curve.h"

enum { DEPTH_MAX = 30, PARTS_MAX = 2000000, COUNT_MAX = 2147483647 };

struct walk {
    const struct iges *iges;
    bool (*counts)(int type);
    int *bodies;
    struct iges_parts *parts;
    bool cavity;
    long left; /* steps, so that what holds itself many times over ends */
};

/* The pointers of a list: from parameter `first` on, `step` apart, as many as parameter `count`
 * says. */
struct pointers {
    size_t count, first, step;
};

/* What an entity of this type holds; false: nothing that has parts. */
static bool holds(int type, struct pointers *p)
{
    switch (type) {
    case 308:
        *p = (struct pointers){3, 4, 1};
        return true;
    case 514:
        *p = (struct pointers){1, 2, 2};
        return true;
    case 184:
    case 402:
        *p = (struct pointers){1, 2, 1};
        return true;
    case 186: /* its voids; the outer shell is parameter 1 */
        *p = (struct pointers){3, 4, 2};
        return true;
    default:
        return false;
    }
}

/* The parts of an entity of this type. */
static int count_of(const struct walk *w, int type, const struct iges_values *v,
                    const struct pointers *p, size_t *n, struct error *error)
{
    long count = 0;
    if (p->count < v->n &&
        iges_whole(w->iges, v, p->count, 0, COUNT_MAX, "count of parts", &count, error) < 0)
        return -1;
    size_t most = v->n < p->first ? 0 : (v->n - p->first + p->step - 1) / p->step;
    *n = (size_t)count;
    if (*n > most && type != 402)
        return error_at(error, w->iges->name, v->line,
                        "entity %d with a count of %ld parts but %zu, expected as many", type,
                        count, most);
    *n = *n > most ? most : *n; /* groups are not all that careful */
    return 0;
}

/* What bounds a solid is a shell. */
static int check_shell(const struct walk *w, const struct iges_values *solid,
                       const struct iges_entity *shell, struct error *error)
{
    return shell->type == 514 ? 0
                              : error_at(error, w->iges->name, solid->line,
                                         "a solid (186) bounded by an entity of type %d, expected "
                                         "a shell (514)",
                                         shell->type);
}

/* Marks what definitions and solids hold: it has no place of its own. */
static int mark_inside(const struct walk *w, bool *inside, struct error *error)
{
    const struct iges_entity *first = w->iges->entity.item;
    int status = 0;
    for (size_t i = 0; i < w->iges->entity.n && status == 0; i++) {
        struct pointers p;
        struct iges_values v;
        size_t n = 0;
        bool list = holds(first[i].type, &p) && first[i].type != 402;
        if (!list && first[i].type != 430)
            continue;
        if (iges_values(w->iges, &first[i], &v, error) < 0)
            return -1;
        if (list)
            status = count_of(w, first[i].type, &v, &p, &n, error);
        for (size_t k = 0; k < n && status == 0; k++) {
            const struct iges_entity *e;
            status = iges_pointer(w->iges, &v, p.first + k * p.step, &e, error);
            if (status == 0)
                inside[e - first] = true;
        }
        if (status == 0 && (first[i].type == 186 || first[i].type == 430)) {
            const struct iges_entity *e;
            status = iges_pointer(w->iges, &v, 1, &e, error);
            if (status == 0 && first[i].type == 186)
                status = check_shell(w, &v, e, error);
            if (status == 0)
                inside[e - first] = true;
        }
        array_free(&v);
    }
    return status;
}

static double value_at(const struct iges_values *v, size_t index, double otherwise)
{
    return index < v->n && v->item[index].kind == IGES_NUMBER ? v->item[index].number : otherwise;
}

static int place(struct walk *w, const struct iges_entity *e, struct transform to, int body,
                 int depth, struct error *error);

static int place_at(struct walk *w, const struct iges_values *v, size_t index, struct transform to,
                    int body, int depth, struct error *error)
{
    const struct iges_entity *e;
    if (iges_pointer(w->iges, v, index, &e, error) < 0)
        return -1;
    return place(w, e, to, body, depth + 1, error);
}

/* All that an entity holds. */
static int place_held(struct walk *w, const struct iges_entity *e, const struct iges_values *v,
                      struct transform to, int body, int depth, struct error *error)
{
    struct pointers p;
    size_t n = 0;
    int status = 0;
    if (e->type == 408) { /* a definition, a shift, a scale */
        struct vec3 by = {value_at(v, 2, 0), value_at(v, 3, 0), value_at(v, 4, 0)};
        to = transform_product(to, transform_shift(by));
        to = transform_product(to, transform_scale(value_at(v, 5, 1)));
    }
    if (e->type == 186)
        body = ++*w->bodies;
    if (e->type == 186 || e->type == 408 || e->type == 430)
        status = place_at(w, v, 1, to, body, depth, error);
    if (status == 0 && holds(e->type, &p))
        status = count_of(w, e->type, v, &p, &n, error);
    for (size_t k = 0; k < n && status == 0; k++) {
        struct transform own = transform_identity();
        if (e->type == 184 && value_at(v, 2 + n + k, 0) > 0 &&
            iges_matrix(w->iges, (int)value_at(v, 2 + n + k, 0), e->at, &own, error) < 0)
            return -1;
        int in = e->type == 186 ? ++*w->bodies : body;
        bool was = w->cavity;
        w->cavity = was || e->type == 186;
        status = place_at(w, v, p.first + k * p.step, transform_product(to, own), in, depth, error);
        w->cavity = was;
    }
    return status;
}

static int place(struct walk *w, const struct iges_entity *e, struct transform to, int body,
                 int depth, struct error *error)
{
    struct pointers p;
    struct iges_values v;
    struct transform own;
    if (w->left-- == 0 || depth > DEPTH_MAX)
        return error_at(error, w->iges->name, e->at,
                        "parts within parts without end, expected a model that ends");
    if (w->counts(e->type)) {
        *array_push(w->parts) = (struct iges_part){e, to, body, w->cavity};
        return 0;
    }
    if (!holds(e->type, &p) && e->type != 408 && e->type != 430)
        return 0;
    if (iges_matrix(w->iges, e->matrix, e->at, &own, error) < 0 ||
        iges_values(w->iges, e, &v, error) < 0)
        return -1;
    int status = place_held(w, e, &v, transform_product(to, own), body, depth, error);
    array_free(&v);
    return status;
}

int iges_parts(const struct iges *iges, bool (*counts)(int type), int *bodies,
               struct iges_parts *parts, struct error *error)
{
    struct walk w = {iges, counts, bodies, parts, false, PARTS_MAX};
    bool *inside = mem_alloc(iges->entity.n + 1, sizeof *inside);
    int status = mark_inside(&w, inside, error);
    for (size_t i = 0; i < iges->entity.n && status == 0; i++) {
        const struct iges_entity *e = &iges->entity.item[i];
        if (!inside[i] && e->type != 308 && e->type != 402)
            status = place(&w, e, transform_identity(), 0, 0, error);
    }
    free(inside);
    return status;
}
