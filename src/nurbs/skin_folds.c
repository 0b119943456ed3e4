/* skin_folds - see skin_folds.h. */
#include "skin_folds.h"

#include <stdlib.h>

#include "math/elementary.h"
#include "skin_sides.h"

static struct vec3 point_of(const struct patch_mesh *q, int vertex)
{
    return q->vertex.item[q->vertex.item[vertex].place].point;
}

/* The third corner of a side's facet, by its place. */
static size_t third_place(const struct patch_mesh *q, const struct skin_side *s)
{
    return q->vertex.item[q->face.item[s->facet].v[(s->corner + 2) % 3]].place;
}

/* Marks the pairs of facets that are each other's back, or the same twice. */
static size_t mark_folds(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                         bool *out)
{
    size_t folded = 0;

    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        for (size_t a = i; k > 1 && a < i + k; a++) {
            for (size_t b = a + 1; b < i + k && !out[side[a].facet]; b++) {
                if (out[side[b].facet] || third_place(q, &side[a]) != third_place(q, &side[b]))
                    continue;
                out[side[a].facet] = out[side[b].facet] = true;
                folded++;
            }
        }
    }
    return folded;
}

void skin_drop_facets(struct patch_mesh *q, const bool *out)
{
    size_t kept = 0;

    for (size_t f = 0; f < q->face.n; f++) {
        if (out[f])
            continue;
        q->face.item[kept] = q->face.item[f];
        q->sheet.item[kept++] = q->sheet.item[f];
    }
    q->face.n = q->sheet.n = kept;
}

/* ---- slivers that lie on their neighbours */

double skin_facet_width(const struct patch_mesh *q, size_t facet)
{
    const int *v = q->face.item[facet].v;
    for (int k = 0; k < 3; k++)
        if (q->vertex.item[v[k]].sheet < 0)
            return HUGE_VAL;
    struct vec3 a = point_of(q, v[0]), b = point_of(q, v[1]), c = point_of(q, v[2]);
    double longest = fmax(vec_distance(a, b), fmax(vec_distance(b, c), vec_distance(c, a)));
    double twice = vec_length(vec_cross(vec_sub(b, a), vec_sub(c, a)));

    return longest > 0 ? twice / longest : 0;
}

/* Marks slivers with a side that three facets have, without which more sides have two. */
static size_t mark_surplus(const struct patch_mesh *q, const struct skin_side *side, size_t n,
                           double gap, bool *out)
{
    signed char *gain = mem_alloc(q->face.n + 1, sizeof *gain);
    bool *touched = mem_alloc(q->vertex.n + 1, sizeof *touched);
    bool *many = mem_alloc(q->face.n + 1, sizeof *many);
    size_t surplus = 0;

    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        int one = k == 2 ? -1 : (int)(k % 2);
        for (size_t a = i; a < i + k; a++) {
            gain[side[a].facet] = (signed char)(gain[side[a].facet] + one);
            many[side[a].facet] = many[side[a].facet] || (k > 1 && k % 2 == 1);
        }
    }
    for (size_t f = 0; f < q->face.n; f++) {
        const int *v = q->face.item[f].v;
        bool free_of = true;
        if (gain[f] <= 0 || !many[f] || out[f] || !(skin_facet_width(q, f) <= gap))
            continue;
        for (int k = 0; k < 3; k++)
            free_of = free_of && !touched[q->vertex.item[v[k]].place];
        for (int k = 0; k < 3 && free_of; k++)
            touched[q->vertex.item[v[k]].place] = true; /* one at a time about a place */
        out[f] = free_of;
        surplus += free_of;
    }
    free(gain);
    free(many);
    free(touched);
    return surplus;
}

size_t skin_drop_folds(struct patch_mesh *q, double gap)
{
    enum { ROUNDS = 20 };
    size_t n, folded = 0;

    for (int i = 0; i < ROUNDS; i++) {
        struct skin_side *side = skin_sides_find(q, &n);
        bool *out = mem_alloc(q->face.n + 1, sizeof *out);
        size_t found = mark_folds(q, side, n, out);
        found += found == 0 ? mark_surplus(q, side, n, gap, out) : 0;
        skin_drop_facets(q, out);
        folded += found;
        free(out);
        free(side);
        if (found == 0)
            break;
    }
    return folded;
}

/* ---- crumbs */

static size_t crumb_of(size_t *of, size_t f)
{
    while (of[f] != f)
        f = of[f] = of[of[f]];
    return f;
}

/* What hangs together by its sides. */
struct crumb {
    double area; /* mm^2 */
    struct vec3 low, high;
};

static void add_to_crumb(struct crumb *c, const struct patch_mesh *q, size_t facet)
{
    const int *v = q->face.item[facet].v;
    struct vec3 p[3];

    for (int k = 0; k < 3; k++) {
        p[k] = point_of(q, v[k]);
        if (c->area == 0 && k == 0)
            c->low = c->high = p[0];
        c->low = vec(fmin(c->low.x, p[k].x), fmin(c->low.y, p[k].y), fmin(c->low.z, p[k].z));
        c->high = vec(fmax(c->high.x, p[k].x), fmax(c->high.y, p[k].y), fmax(c->high.z, p[k].z));
    }
    c->area += vec_length(vec_cross(vec_sub(p[1], p[0]), vec_sub(p[2], p[0]))) / 2;
}

void skin_drop_crumbs(struct patch_mesh *q, double gap)
{
    size_t n, kept = 0;
    struct skin_side *side = skin_sides_find(q, &n);
    size_t *of = mem_alloc(q->face.n + 1, sizeof *of);
    struct crumb *crumb = mem_alloc(q->face.n + 1, sizeof *crumb);
    bool *out = mem_alloc(q->face.n + 1, sizeof *out);

    for (size_t f = 0; f < q->face.n; f++)
        of[f] = f;
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        for (size_t a = i + 1; a < i + k; a++)
            of[crumb_of(of, side[a].facet)] = crumb_of(of, side[i].facet);
    }
    for (size_t f = 0; f < q->face.n; f++)
        add_to_crumb(&crumb[crumb_of(of, f)], q, f);
    for (size_t f = 0; f < q->face.n; f++) {
        const struct crumb *c = &crumb[crumb_of(of, f)];
        out[f] = c->area <= 2 * gap * vec_distance(c->low, c->high);
        kept += !out[f];
    }
    if (kept > 0)
        skin_drop_facets(q, out);
    free(out);
    free(crumb);
    free(of);
    free(side);
}

/* ---- slivers that are turned round */

/* Counts the sides of each facet that its one neighbour has in the same direction, less the others.
 */
static void count_turned(const struct skin_side *side, size_t n, signed char *turned)
{
    for (size_t i = 0, k; i < n; i += k) {
        k = skin_sides_same(side, n, i);
        int by = side[i].forward == side[i + (k > 1)].forward ? 1 : -1;
        for (size_t a = i; a < i + k && k == 2; a++)
            turned[side[a].facet] = (signed char)(turned[side[a].facet] + by);
    }
}

void skin_turn_slivers(struct patch_mesh *q, double gap)
{
    enum { ROUNDS = 20 };
    size_t n, changed = 1;

    for (int i = 0; i < ROUNDS && changed > 0; i++) {
        struct skin_side *side = skin_sides_find(q, &n);
        signed char *turned = mem_alloc(q->face.n + 1, sizeof *turned);
        bool *touched = mem_alloc(q->vertex.n + 1, sizeof *touched);
        changed = 0;
        count_turned(side, n, turned);
        for (size_t f = 0; f < q->face.n; f++) {
            int *v = q->face.item[f].v;
            size_t place[3];
            for (int k = 0; k < 3; k++)
                place[k] = q->vertex.item[v[k]].place;
            if (turned[f] <= 0 || touched[place[0]] || touched[place[1]] || touched[place[2]] ||
                !(skin_facet_width(q, f) <= gap))
                continue;
            for (int k = 0; k < 3; k++)
                touched[place[k]] = true; /* one at a time about a place */
            int other = v[1];
            v[1] = v[2];
            v[2] = other;
            changed++;
        }
        free(side);
        free(turned);
        free(touched);
    }
}
