/* rest_passes - see rest_passes.h. */
#include "toolpath/rest_passes.h"

#include <stdlib.h>

#include "rest_chain.h"

enum { AHEAD = 64, EVENED = 2 };

static const double FACING = 0.7; /* a plane serves where its normal is so far off the surface's */
static const double LITTLE = 0.3; /* of the step: nearer points on a strip are one */
static const double BESIDE = 0.4; /* of the step: a strip cuts what is no further beside it */
static const double ALIKE = 0.5;  /* cosine: points of a strip face the same way */

/* A family of planes: their normal, and two directions in them. */
struct family {
    struct vec3 normal, a, b;
};

/* A point that is left, on the plane it goes to. */
struct place {
    int family, turned; /* turned: strips run rather along b */
    long plane;
    double at; /* along the strip */
    size_t index;
    struct contact given, contact; /* as it is, and on the plane */
};

static int compare_places(const void *pa, const void *pb)
{
    const struct place *a = pa, *b = pb;

    if (a->family != b->family)
        return a->family - b->family;
    if (a->plane != b->plane)
        return a->plane < b->plane ? -1 : 1;
    if (a->turned != b->turned)
        return a->turned - b->turned;
    if (a->at != b->at)
        return a->at < b->at ? -1 : 1;
    return (a->index > b->index) - (a->index < b->index);
}

static void find_families(const struct rest_options *o, struct family family[3])
{
    struct vec3 up = vec(0, 0, 1), across = vec_cross(o->planes, up);

    if (vec_length(across) < 0.1) /* level planes */
        across = vec(1, 0, 0);
    across = vec_unit(across);
    struct vec3 side = vec_cross(up, across);
    struct vec3 first = o->turned ? side : across, second = o->turned ? across : side;
    family[0] = (struct family){first, second, up};
    family[1] = (struct family){second, first, up};
    family[2] = (struct family){up, first, second};
}

static struct place place_of(const struct family family[3], const struct rest_options *o,
                             const struct coverage_point *point, size_t index)
{
    struct contact given = {point->p, point->normal};
    struct place place = {.index = index, .given = given, .contact = given};
    struct vec3 n = point->normal;

    while (place.family < 2 && fabs(vec_dot(n, family[place.family].normal)) >= FACING)
        place.family++;
    const struct family *f = &family[place.family];
    double height = vec_dot(point->p, f->normal);
    place.plane = lround(height / o->step);
    struct vec3 level = vec_reject(f->normal, n), tangent = vec_cross(f->normal, n);
    double way = ((double)place.plane * o->step - height) / vec_dot(level, level);
    if (!o->rough)
        place.contact.p = vec_along(point->p, way, level);
    place.turned = fabs(vec_dot(tangent, f->b)) > fabs(vec_dot(tangent, f->a));
    place.at = vec_dot(place.contact.p, place.turned ? f->b : f->a);
    return place;
}

/* The next place of the group [i, n) after place i: the nearest of those ahead within the gap that
 * face the same way; n: there is none. */
static size_t next_place(const struct place *place, const bool *used, size_t i, size_t n,
                         const struct rest_options *o)
{
    size_t best = n, last = i + AHEAD < n ? i + AHEAD : n;
    double least = o->gap;

    for (size_t k = i + 1; k < last && place[k].at - place[i].at < least; k++) {
        double far = vec_distance(place[k].contact.p, place[i].contact.p);
        if (!used[k] && far < least && vec_dot(place[k].contact.n, place[i].contact.n) > ALIKE) {
            least = far;
            best = k;
        }
    }
    return best;
}

/* Normals that do not flutter from point to point. */
static void even_normals(struct contacts *c)
{
    struct vec3 *n = mem_alloc(c->n + 1, sizeof *n);

    for (size_t i = 0; i < c->n; i++) {
        size_t from = i > EVENED ? i - EVENED : 0, to = i + EVENED < c->n ? i + EVENED : c->n - 1;
        for (size_t k = from; k <= to; k++)
            n[i] = vec_add(n[i], c->item[k].n);
    }
    for (size_t i = 0; i < c->n; i++)
        c->item[i].n = vec_unit(n[i]);
    free(n);
}

/* A strip of one point gets two beside it, to be one. */
static void widen_point(struct contacts *c, struct vec3 planes, double step)
{
    struct contact at = c->item[0];
    struct vec3 along = vec_unit(vec_cross(planes, at.n));

    c->n = 0;
    for (int i = -1; i <= 1; i++)
        *array_push(c) = (struct contact){vec_along(at.p, i * LITTLE * step, along), at.n};
}

static double length_of(const struct contacts *c)
{
    double length = 0;

    for (size_t i = 1; i < c->n; i++)
        length += vec_distance(c->item[i - 1].p, c->item[i].p);
    return length;
}

/* Strips of the places [from, to), which lie on one plane; the points of those that are too short
 * go to `few`. */
static void chain_places(const struct place *place, size_t from, size_t to, struct vec3 planes,
                         const struct rest_options *o, bool *used, struct rest_strips *strips,
                         struct contacts *few)
{
    for (size_t first = from; first < to; first++) {
        struct rest_strip strip = {.planes = planes};
        size_t before = few->n;
        for (size_t i = first; i < to; i = next_place(place, used, i, to, o)) {
            struct contacts *c = &strip.contact;
            if (used[i])
                break;
            used[i] = true;
            *array_push(few) = place[i].given;
            if (c->n == 0 ||
                vec_distance(c->item[c->n - 1].p, place[i].contact.p) > LITTLE * o->step)
                *array_push(c) = place[i].contact;
        }
        if (strip.contact.n == 0)
            continue;
        if (length_of(&strip.contact) < o->longest) {
            array_free(&strip.contact);
            continue;
        }
        few->n = before;
        if (strip.contact.n == 1)
            widen_point(&strip.contact, planes, o->step);
        else if (!o->rough)
            even_normals(&strip.contact);
        *array_push(strips) = strip;
    }
}

/* Strips through the points that are few. */
static void chain_few(const struct contacts *few, const struct rest_options *o,
                      struct rest_strips *strips)
{
    size_t first = strips->n;

    rest_chain_points(few, o->gap, BESIDE * o->step, strips);
    for (size_t k = first; k < strips->n; k++)
        if (strips->item[k].contact.n == 1)
            widen_point(&strips->item[k].contact, strips->item[k].planes, o->step);
}

/* Each next strip begins, turned round if need be, nearest to where the one before ends. */
static void order_strips(struct rest_strips *strips)
{
    for (size_t k = 0; k + 1 < strips->n; k++) {
        const struct contacts *c = &strips->item[k].contact;
        struct vec3 end = c->item[c->n - 1].p;
        double least = HUGE_VAL;
        size_t best = k + 1;
        bool turned = false;
        for (size_t i = k + 1; i < strips->n; i++) {
            const struct contacts *next = &strips->item[i].contact;
            double first = vec_distance(end, next->item[0].p);
            double last = vec_distance(end, next->item[next->n - 1].p);
            if (fmin(first, last) < least) {
                least = fmin(first, last);
                turned = last < first;
                best = i;
            }
        }
        struct rest_strip swap = strips->item[k + 1];
        strips->item[k + 1] = strips->item[best];
        strips->item[best] = swap;
        if (turned)
            contacts_reverse(strips->item[k + 1].contact.item, strips->item[k + 1].contact.n);
    }
}

struct rest_strips rest_passes_find(const struct coverage_point *point, size_t n,
                                    const struct rest_options *options)
{
    struct rest_strips strips = {0};
    struct contacts few = {0};
    struct family family[3];
    struct place *place = mem_alloc(n + 1, sizeof *place);
    bool *used = mem_alloc(n + 1, sizeof *used);
    size_t places = 0;

    find_families(options, family);
    for (size_t i = 0; i < n; i++)
        if (point[i].state == COVERAGE_LEFT)
            place[places++] = place_of(family, options, &point[i], i);
    qsort(place, places, sizeof *place, compare_places);
    for (size_t from = 0, to; from < places; from = to) {
        for (to = from + 1; to < places && place[to].family == place[from].family &&
                            place[to].plane == place[from].plane &&
                            place[to].turned == place[from].turned;)
            to++;
        chain_places(place, from, to, family[place[from].family].normal, options, used, &strips,
                     &few);
    }
    chain_few(&few, options, &strips);
    array_free(&few);
    free(place);
    free(used);
    order_strips(&strips);
    return strips;
}

void rest_strips_free(struct rest_strips *strips)
{
    for (size_t i = 0; i < strips->n; i++)
        array_free(&strips->item[i].contact);
    array_free(strips);
}
