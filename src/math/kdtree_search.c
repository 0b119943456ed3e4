/*
 * kdtree_search - see kdtree.h: the point nearest to a segment, or lowest; a visit.
 *
 * Points of a surface lie thin in the cells of the planes between the nodes, and a ball that
 * touches it reaches into all cells under it: these searches go by the boxes around the points
 * instead.
 */
#include "math/kdtree.h"

#include <stdint.h>

#include "kdtree_parts.h"

/* The nearest point to a segment so far. */
struct beside {
    const struct kdtree *tree;
    struct vec3 a, along; /* from one end to the other */
    double length2;
    double low[3], high[3]; /* the segment's box */
    double best, best2;
    size_t index;      /* as in the caller's array */
    struct vec3 place; /* of that point */
};

static struct vec3 place_of(const struct kd_point *p)
{
    return vec(p->c[0], p->c[1], p->c[2]);
}

/* From the segment's place nearest to p to p. */
static struct vec3 off_segment(const struct beside *s, struct vec3 p)
{
    struct vec3 d = vec_sub(p, s->a);
    double at = s->length2 > 0 ? vec_dot(d, s->along) / s->length2 : 0;

    return vec_along(d, -(at < 0 ? 0 : at > 1 ? 1 : at), s->along);
}

static double distance2_beside(const struct beside *s, struct vec3 p)
{
    struct vec3 off = off_segment(s, p);

    return vec_dot(off, off);
}

/* p is nearer than s->best; s->place: it is p. */
static bool is_beside(struct beside *s, struct vec3 p)
{
    if (distance2_beside(s, p) >= s->best2)
        return false;
    s->place = p;
    return true;
}

static void offer_beside(struct beside *s, const struct kd_point *p)
{
    double d2 = distance2_beside(s, vec(p->c[0], p->c[1], p->c[2]));

    if (d2 < s->best2 || (d2 == s->best2 && p->index < s->index)) {
        s->best2 = d2;
        s->best = sqrt(d2);
        s->index = p->index;
        s->place = vec(p->c[0], p->c[1], p->c[2]);
    }
}

/* No point in the box is nearer than this: the gap to the segment's own box, or to the plane across
 * the way from the segment's nearest place to the box's middle, which all of the segment is behind:
 * that is how a flat box beside the segment is told. */
static double bound2(const struct beside *s, const struct kd_box *box)
{
    double x = kd_gap(box, 0, s->low[0], s->high[0]), y = kd_gap(box, 1, s->low[1], s->high[1]);
    double z = kd_gap(box, 2, s->low[2], s->high[2]), gap2 = x * x + y * y + z * z;

    if (s->length2 == 0 || gap2 > s->best2)
        return gap2;
    struct vec3 low = vec(box->low[0], box->low[1], box->low[2]);
    struct vec3 half = vec_scale(0.5, vec_sub(vec(box->high[0], box->high[1], box->high[2]), low));
    struct vec3 off = off_segment(s, vec_add(low, half));
    double far2 = vec_dot(off, off);
    double beyond = far2 - (half.x * fabs(off.x) + half.y * fabs(off.y) + half.z * fabs(off.z));
    return beyond > 0 && beyond * beyond > gap2 * far2 ? beyond * beyond / far2 : gap2;
}

static void search_beside(struct beside *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            offer_beside(s, &s->tree->point[i]);
        return;
    }
    size_t middle = from + (to - from) / 2;
    double first = bound2(s, &s->tree->box[2 * number]);
    double second = bound2(s, &s->tree->box[2 * number + 1]);
    bool left = first <= second;

    offer_beside(s, &s->tree->point[middle]);
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) * (1 - 1e-12) > s->best2)
            continue;
        if (left)
            search_beside(s, from, middle, 2 * number);
        else
            search_beside(s, middle + 1, to, 2 * number + 1);
    }
}

static struct beside beside_of(const struct kdtree *tree, struct vec3 a, struct vec3 b,
                               double within)
{
    struct beside s = {.tree = tree,
                       .a = a,
                       .along = vec_sub(b, a),
                       .low = {fmin(a.x, b.x), fmin(a.y, b.y), fmin(a.z, b.z)},
                       .high = {fmax(a.x, b.x), fmax(a.y, b.y), fmax(a.z, b.z)},
                       .best = within,
                       .best2 = square(within),
                       .index = SIZE_MAX};

    s.length2 = vec_dot(s.along, s.along);
    return s;
}

double kdtree_nearest_segment(const struct kdtree *tree, struct vec3 a, struct vec3 b,
                              double within, size_t *index)
{
    struct beside s = beside_of(tree, a, b, within);

    if (tree->n > 0)
        search_beside(&s, 0, tree->n, 1);
    if (s.index == SIZE_MAX)
        return within;
    *index = s.index;
    return s.best;
}

double kdtree_nearest_place(const struct kdtree *tree, struct vec3 p, double within,
                            struct vec3 *place)
{
    struct beside s = beside_of(tree, p, p, within);

    if (tree->n > 0)
        search_beside(&s, 0, tree->n, 1);
    if (s.index == SIZE_MAX)
        return within;
    *place = s.place;
    return s.best;
}

double kdtree_nearest_among(const struct vec3 *point, size_t n, struct vec3 a, struct vec3 b,
                            double within)
{
    struct beside s = beside_of(NULL, a, b, within);

    for (size_t i = 0; i < n; i++) {
        double d2 = distance2_beside(&s, point[i]);
        s.best2 = d2 < s.best2 ? d2 : s.best2;
    }
    return s.best2 < square(within) ? sqrt(s.best2) : within;
}

static void collect_beside(const struct beside *s, size_t from, size_t to, size_t number,
                           struct vec3s *found)
{
    if (bound2(s, &s->tree->box[number]) * (1 - 1e-12) > s->best2)
        return;
    size_t middle = from + (to - from) / 2;
    bool leaf = to - from <= KD_LEAF;

    if (!leaf)
        collect_beside(s, from, middle, 2 * number, found);
    for (size_t i = leaf ? from : middle; i < (leaf ? to : middle + 1); i++) {
        struct vec3 p = vec(s->tree->point[i].c[0], s->tree->point[i].c[1], s->tree->point[i].c[2]);
        if (distance2_beside(s, p) <= s->best2)
            *array_push(found) = p;
    }
    if (!leaf)
        collect_beside(s, middle + 1, to, 2 * number + 1, found);
}

void kdtree_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within,
                   struct vec3s *found)
{
    struct beside s = beside_of(tree, a, b, within);

    if (tree->n > 0)
        collect_beside(&s, 0, tree->n, 1, found);
}

/* Is a point nearer than s->best?  s->place: that one. */
static bool any_beside(struct beside *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            if (is_beside(s, place_of(&s->tree->point[i])))
                return true;
        return false;
    }
    size_t middle = from + (to - from) / 2;
    double first = bound2(s, &s->tree->box[2 * number]) * (1 - 1e-12);
    double second = bound2(s, &s->tree->box[2 * number + 1]) * (1 - 1e-12);
    bool left = first <= second;

    if (is_beside(s, place_of(&s->tree->point[middle])))
        return true;
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) >= s->best2)
            continue;
        if (left ? any_beside(s, from, middle, 2 * number)
                 : any_beside(s, middle + 1, to, 2 * number + 1))
            return true;
    }
    return false;
}

bool kdtree_any_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within)
{
    return kdtree_find_beside(tree, a, b, within, NULL);
}

bool kdtree_find_beside(const struct kdtree *tree, struct vec3 a, struct vec3 b, double within,
                        struct kdtree_touch *touch)
{
    struct beside s = beside_of(tree, a, b, within);

    if (within <= 0)
        return false;
    for (size_t i = 0; touch && i < touch->n; i++)
        if (is_beside(&s, touch->p[i]))
            return true;
    if (tree->n == 0 || !any_beside(&s, 0, tree->n, 1))
        return false;
    if (touch)
        *touch = (struct kdtree_touch){1, {s.place}};
    return true;
}

/* The lowest value so far. */
struct lowest {
    const struct kdtree *tree;
    const struct kdtree_field *field;
    double best;
    struct vec3 place; /* where it is, once it is below what was asked for */
};

/* No point in the box has a lower value. */
static double lower_bound(const struct lowest *s, const struct kd_box *box)
{
    struct vec3 low = vec(box->low[0], box->low[1], box->low[2]);
    struct vec3 half = vec_scale(0.5, vec_sub(vec(box->high[0], box->high[1], box->high[2]), low));

    return s->field->bound(s->field->context, vec_add(low, half), half, s->best);
}

static void offer_lowest(struct lowest *s, struct vec3 p)
{
    double value = s->field->value(s->field->context, p, s->best);

    if (value < s->best) {
        s->best = value;
        s->place = p;
    }
}

static void search_lowest(struct lowest *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            offer_lowest(s, place_of(&s->tree->point[i]));
        return;
    }
    size_t middle = from + (to - from) / 2;
    double first = lower_bound(s, &s->tree->box[2 * number]);
    double second = lower_bound(s, &s->tree->box[2 * number + 1]);
    bool left = first <= second;

    offer_lowest(s, place_of(&s->tree->point[middle]));
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) > s->best)
            continue;
        if (left)
            search_lowest(s, from, middle, 2 * number);
        else
            search_lowest(s, middle + 1, to, 2 * number + 1);
    }
}

double kdtree_lowest(const struct kdtree *tree, const struct kdtree_field *field, double below,
                     struct kdtree_touch *touch)
{
    struct lowest s = {.tree = tree, .field = field, .best = below};

    for (size_t i = 0; touch && i < touch->n; i++)
        offer_lowest(&s, touch->p[i]);
    if (tree->n > 0)
        search_lowest(&s, 0, tree->n, 1);
    if (touch && s.best < below)
        *touch = (struct kdtree_touch){1, {s.place}};
    return s.best;
}

static bool is_lower(struct lowest *s, struct vec3 p)
{
    if (s->field->value(s->field->context, p, s->best) >= s->best)
        return false;
    s->place = p;
    return true;
}

static bool any_lower(struct lowest *s, size_t from, size_t to, size_t number)
{
    if (to - from <= KD_LEAF) {
        for (size_t i = from; i < to; i++)
            if (is_lower(s, place_of(&s->tree->point[i])))
                return true;
        return false;
    }
    size_t middle = from + (to - from) / 2;
    double first = lower_bound(s, &s->tree->box[2 * number]);
    double second = lower_bound(s, &s->tree->box[2 * number + 1]);
    bool left = first <= second;

    if (is_lower(s, place_of(&s->tree->point[middle])))
        return true;
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if ((left ? first : second) >= s->best)
            continue;
        if (left ? any_lower(s, from, middle, 2 * number)
                 : any_lower(s, middle + 1, to, 2 * number + 1))
            return true;
    }
    return false;
}

bool kdtree_any_lower(const struct kdtree *tree, const struct kdtree_field *field, double below,
                      struct kdtree_touch *touch)
{
    struct lowest s = {.tree = tree, .field = field, .best = below};

    for (size_t i = 0; touch && i < touch->n; i++)
        if (is_lower(&s, touch->p[i]))
            return true;
    if (tree->n == 0 || !any_lower(&s, 0, tree->n, 1))
        return false;
    if (touch)
        *touch = (struct kdtree_touch){1, {s.place}};
    return true;
}

static void visit_node(const struct kdtree *tree, const double from[3],
                       const struct kdtree_visitor *v, size_t first, size_t last, size_t number,
                       int depth)
{
    const struct kd_box *box = &tree->box[number];
    struct vec3 low = vec(box->low[0], box->low[1], box->low[2]);
    struct vec3 half = vec_scale(0.5, vec_sub(vec(box->high[0], box->high[1], box->high[2]), low));
    size_t middle = first + (last - first) / 2;

    if (!v->box(v->context, depth, vec_add(low, half), half))
        return;
    if (last - first <= KD_LEAF) {
        for (size_t i = first; i < last; i++) {
            const double *c = tree->point[i].c;
            v->point(v->context, depth, vec(c[0], c[1], c[2]), tree->point[i].index);
        }
        return;
    }
    const double *c = tree->point[middle].c;
    v->point(v->context, depth, vec(c[0], c[1], c[2]), tree->point[middle].index);
    bool left = kd_gap2(&tree->box[2 * number], from) <= kd_gap2(&tree->box[2 * number + 1], from);
    for (int turn = 0; turn < 2; turn++, left = !left) {
        if (left)
            visit_node(tree, from, v, first, middle, 2 * number, depth + 1);
        else
            visit_node(tree, from, v, middle + 1, last, 2 * number + 1, depth + 1);
    }
}

void kdtree_visit(const struct kdtree *tree, struct vec3 from, const struct kdtree_visitor *visitor)
{
    const double c[3] = {from.x, from.y, from.z};

    if (tree->n > 0)
        visit_node(tree, c, visitor, 0, tree->n, 1, 0);
}
