/* step_assembly - see step_assembly.h. */
#include "step_assembly.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "step_geometry.h"

/* Two instances that belong together. */
struct pair {
    long a, b;
};

struct pairs {
    size_t n, cap;
    struct pair *item;
};

/* What the relations are checked with. */
struct structure {
    const struct step *step;
    struct step_assembly *assembly;
    struct pairs same;       /* representations that are one */
    struct pairs shape;      /* PRODUCT_DEFINITION_SHAPE, what it is the shape of */
    struct pairs definition; /* what has a shape, its representation */
    struct pairs occurrence; /* relation, PRODUCT_DEFINITION_SHAPE of the use of a part */
    struct pairs item;       /* item, representation */
};

long step_reference(const struct step_value *value)
{
    return value && value->kind == STEP_REFERENCE ? (long)value->number : 0;
}

bool step_is_representation(const struct step_value *record)
{
    static const char end[] = "REPRESENTATION", picture[] = "PRESENTATION_REPRESENTATION";
    size_t n = sizeof end - 1, k = sizeof picture - 1;
    if (!record || record->length < n || memcmp(record->text + record->length - n, end, n) != 0)
        return false;
    return record->length < k || memcmp(record->text + record->length - k, picture, k) != 0;
}

struct transform step_assembly_inverse(const struct transform *t)
{
    struct transform r = transform_identity();
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++)
            r.m[i][k] = t->m[k][i];
        r.m[i][3] = -(t->m[0][i] * t->m[0][3] + t->m[1][i] * t->m[1][3] + t->m[2][i] * t->m[2][3]);
    }
    return r;
}

/* ---- pairs */

static int compare_pairs(const void *p, const void *q)
{
    const struct pair *x = p, *y = q;
    int by = (x->a > y->a) - (x->a < y->a);
    return by != 0 ? by : (x->b > y->b) - (x->b < y->b);
}

static void sort_pairs(struct pairs *pairs)
{
    if (pairs->n > 0)
        qsort(pairs->item, pairs->n, sizeof *pairs->item, compare_pairs);
}

/* The first pair of sorted ones that is not before (a, b); n when there is none. */
static size_t find_pair(const struct pairs *pairs, long a, long b)
{
    struct pair key = {a, b};
    size_t from = 0, to = pairs->n;
    while (from < to) {
        size_t mid = from + (to - from) / 2;
        if (compare_pairs(&pairs->item[mid], &key) < 0)
            from = mid + 1;
        else
            to = mid;
    }
    return from;
}

static bool has_pair(const struct pairs *pairs, long a, long b)
{
    size_t i = find_pair(pairs, a, b);
    return i < pairs->n && pairs->item[i].a == a && pairs->item[i].b == b;
}

/* The partner of `a`, the first when there are several, or 0. */
static long partner(const struct pairs *pairs, long a)
{
    size_t i = find_pair(pairs, a, 0);
    return i < pairs->n && pairs->item[i].a == a ? pairs->item[i].b : 0;
}

static void push_pair(struct pairs *pairs, long a, long b)
{
    if (a > 0 && b > 0)
        *array_push(pairs) = (struct pair){a, b};
}

/* ---- representations that are one */

static int compare_aliases(const void *p, const void *q)
{
    const struct step_alias *a = p, *b = q;
    return (a->id > b->id) - (a->id < b->id);
}

static struct step_alias *find_alias(const struct step_assembly *assembly, long id)
{
    struct step_alias key = {.id = id};
    return assembly->alias.n > 0
               ? bsearch(&key, assembly->alias.item, assembly->alias.n, sizeof key, compare_aliases)
               : NULL;
}

bool step_assembly_is_alias(const struct step_assembly *assembly, long id)
{
    return find_alias(assembly, id) != NULL;
}

long step_assembly_leader(const struct step_assembly *assembly, long id)
{
    struct step_alias *a = find_alias(assembly, id);
    while (a && a->same != a->id) {
        struct step_alias *up = find_alias(assembly, a->same);
        if (!up)
            break;
        a->same = up->same;
        a = up;
    }
    return a ? a->id : id;
}

/* From pairs to one that stands for each group. */
static void join_aliases(struct structure *s)
{
    struct step_assembly *to = s->assembly;
    size_t kept = 0;
    for (size_t i = 0; i < s->same.n; i++)
        for (int k = 0; k < 2; k++) {
            long id = k == 0 ? s->same.item[i].a : s->same.item[i].b;
            *array_push(&to->alias) = (struct step_alias){id, id};
        }
    if (to->alias.n > 0)
        qsort(to->alias.item, to->alias.n, sizeof *to->alias.item, compare_aliases);
    for (size_t i = 0; i < to->alias.n; i++)
        if (i == 0 || to->alias.item[i].id != to->alias.item[kept - 1].id)
            to->alias.item[kept++] = to->alias.item[i];
    to->alias.n = kept;
    for (size_t i = 0; i < s->same.n; i++) {
        long a = step_assembly_leader(to, s->same.item[i].a);
        long b = step_assembly_leader(to, s->same.item[i].b);
        if (a != b)
            find_alias(to, a > b ? a : b)->same = a > b ? b : a;
    }
}

/* ---- reading */

/* A relation with a transformation. */
static int add_component(struct structure *s, const struct step_values *v,
                         const struct step_value *pair, const struct step_value *with,
                         struct error *error)
{
    struct step_values t;
    if (step_follow(s->step, v, step_item(with, 0), &t, error) < 0)
        return -1;
    const struct step_value *item = step_record(&t, "ITEM_DEFINED_TRANSFORMATION");
    struct step_component c = {.relation = v->instance->id,
                               .child = step_reference(step_item(pair, 2)),
                               .parent = step_reference(step_item(pair, 3)),
                               .child_axes = step_reference(step_item(item, 2)),
                               .parent_axes = step_reference(step_item(item, 3))};
    int status = item && step_axes(s->step, &t, step_item(item, 2), &c.to, error) == 0 &&
                         step_axes(s->step, &t, step_item(item, 3), &c.at, error) == 0
                     ? 0
                     : -1;
    if (!item)
        status = error_at(error, s->step->name, t.instance->line,
                          "#%ld: no ITEM_DEFINED_TRANSFORMATION, expected one", t.instance->id);
    array_free(&t);
    if (status == 0)
        *array_push(&s->assembly->component) = c;
    return status;
}

/* What one instance says of the structure of products. */
static void read_product(struct structure *s, const struct step_values *v)
{
    long id = v->instance->id;
    const struct step_value *r = step_item(v->item, 0);
    const struct step_value *shape = step_record(v, "PRODUCT_DEFINITION_SHAPE");
    const struct step_value *has = step_record(v, "SHAPE_DEFINITION_REPRESENTATION");
    const struct step_value *use = step_record(v, "CONTEXT_DEPENDENT_SHAPE_REPRESENTATION");
    if (shape)
        push_pair(&s->shape, id, step_reference(step_item(shape, 2)));
    if (has)
        push_pair(&s->definition, step_reference(step_item(has, 0)),
                  step_reference(step_item(has, 1)));
    if (use)
        push_pair(&s->occurrence, step_reference(step_item(use, 0)),
                  step_reference(step_item(use, 1)));
    const struct step_value *list = step_is_representation(r) ? step_item(r, 1) : NULL;
    for (const struct step_value *i = step_item(list, 0); i; i = step_next(list, i))
        push_pair(&s->item, step_reference(i), id);
}

static int read_relations(struct structure *s, struct error *error)
{
    int status = 0;
    for (size_t i = 0; i < s->step->instance.n && status == 0; i++) {
        struct step_values v;
        if (step_values(s->step, &s->step->instance.item[i], &v, error) < 0)
            return -1;
        const struct step_value *pair = step_record(&v, "REPRESENTATION_RELATIONSHIP");
        const struct step_value *with =
            step_record(&v, "REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION");
        const struct step_value *same = step_record(&v, "SHAPE_REPRESENTATION_RELATIONSHIP");
        same = same && step_item(same, 3) ? same : pair;
        if (pair && with)
            status = add_component(s, &v, pair, with, error);
        else if (same)
            push_pair(&s->same, step_reference(step_item(same, 2)),
                      step_reference(step_item(same, 3)));
        else
            read_product(s, &v);
        array_free(&v);
    }
    return status;
}

/* ---- which of two is the part */

/* Is one of the representations of this product among those that are one with `rep`? */
static bool is_of_product(const struct structure *s, long product, long rep)
{
    long group = step_assembly_leader(s->assembly, rep);
    for (size_t i = find_pair(&s->definition, product, 0);
         i < s->definition.n && s->definition.item[i].a == product; i++)
        if (step_assembly_leader(s->assembly, s->definition.item[i].b) == group)
            return true;
    return false;
}

/* The products of an occurrence: the whole and the part; false when it names none. */
static bool products_of(const struct structure *s, long occurrence, struct pair *products)
{
    struct step_values v;
    struct error ignored;
    const struct step_instance *at = step_find(s->step, occurrence);
    if (!at || step_values(s->step, at, &v, &ignored) < 0)
        return false;
    static const char *const kind[] = {"NEXT_ASSEMBLY_USAGE_OCCURRENCE",
                                       "PRODUCT_DEFINITION_RELATIONSHIP"};
    bool found = false;
    for (int i = 0; i < 2 && !found; i++) {
        const struct step_value *r = step_record(&v, kind[i]);
        *products = (struct pair){step_reference(step_item(r, 3)), step_reference(step_item(r, 4))};
        found = products->a > 0 && products->b > 0;
    }
    array_free(&v);
    return found;
}

/* Names the relation of this component the assembly first? */
static bool is_turned(const struct structure *s, const struct step_component *c)
{
    struct pair product;
    long use = partner(&s->shape, partner(&s->occurrence, c->relation));
    if (use == 0 || !products_of(s, use, &product))
        return false;
    if (is_of_product(s, product.b, c->child) && is_of_product(s, product.a, c->parent))
        return false;
    return is_of_product(s, product.a, c->child) && is_of_product(s, product.b, c->parent);
}

static void swap_axes(struct step_component *c)
{
    struct transform t = c->to;
    long axes = c->child_axes;
    c->to = c->at;
    c->at = t;
    c->child_axes = c->parent_axes;
    c->parent_axes = axes;
}

/* Are the axes those of the other representation each, and not of their own? */
static bool is_crossed(const struct structure *s, const struct step_component *c)
{
    return has_pair(&s->item, c->child_axes, c->parent) &&
           !has_pair(&s->item, c->child_axes, c->child) &&
           has_pair(&s->item, c->parent_axes, c->child) &&
           !has_pair(&s->item, c->parent_axes, c->parent);
}

/* A product's shape by the shape of its definition: what has a shape is the product itself. */
static void resolve_shapes(struct structure *s)
{
    size_t n = s->definition.n;
    for (size_t i = 0; i < n; i++) {
        struct pair has = s->definition.item[i];
        push_pair(&s->definition, partner(&s->shape, has.a), has.b);
    }
    sort_pairs(&s->definition);
}

int step_assembly_read(const struct step *step, struct step_assembly *assembly, struct error *error)
{
    struct structure s = {.step = step, .assembly = assembly};
    int status = read_relations(&s, error);
    join_aliases(&s);
    sort_pairs(&s.shape);
    sort_pairs(&s.occurrence);
    sort_pairs(&s.item);
    resolve_shapes(&s);
    for (size_t i = 0; i < assembly->component.n; i++) {
        struct step_component *c = &assembly->component.item[i];
        if (is_turned(&s, c)) {
            long child = c->parent;
            c->parent = c->child;
            c->child = child;
            swap_axes(c);
        }
        if (is_crossed(&s, c))
            swap_axes(c);
        c->to = step_assembly_inverse(&c->to);
    }
    array_free(&s.same);
    array_free(&s.shape);
    array_free(&s.definition);
    array_free(&s.occurrence);
    array_free(&s.item);
    return status;
}

void step_assembly_free(struct step_assembly *assembly)
{
    array_free(&assembly->component);
    array_free(&assembly->alias);
}
