/* trim_clip - see trim_clip.h. */
#include "trim_clip.h"

#include <stdlib.h>

/* An end of a chain on the border of its cell. */
struct end {
    int side;
    double along;
    bool enters;
    size_t chain;
};

static int compare_ends(const void *p, const void *q)
{
    const struct end *a = p, *b = q;
    if (a->side != b->side)
        return a->side < b->side ? -1 : 1;
    if (a->along < b->along || a->along > b->along)
        return a->along < b->along ? -1 : 1;
    return a->chain < b->chain ? -1 : a->chain > b->chain;
}

static void add_corner(struct polygons *p, size_t first, int id)
{
    if (p->id.n == first || p->id.item[p->id.n - 1] != id)
        *array_push(&p->id) = id;
}

/* Round one polygon from a chain on: along it, along the border to the next that enters, and so
 * on. */
static bool round_polygon(struct trim_chain *chain, const int *id, const struct end *end,
                          size_t ends, const int corner[4], size_t start, struct polygons *p)
{
    size_t now = start, first = p->id.n;
    do {
        struct trim_chain *k = &chain[now];
        k->used = true;
        for (size_t i = 0; i < k->n; i++)
            add_corner(p, first, id[k->first + i]);
        size_t e = 0;
        while (end[e].chain != now || end[e].enters)
            e++;
        size_t next = (e + 1) % ends;
        if (!end[next].enters)
            return false;
        int side = end[e].side;
        bool wraps = next <= e;
        while (wraps || side != end[next].side) {
            side = (side + 1) % 4;
            add_corner(p, first, corner[side]);
            wraps = wraps && side != 0;
        }
        now = end[next].chain;
    } while (!chain[now].used);
    if (p->id.n > first + 1 && p->id.item[first] == p->id.item[p->id.n - 1])
        p->id.n--;
    *array_push(&p->end) = p->id.n;
    return now == start;
}

bool trim_clip(struct trim_chain *chain, size_t n, const int *id, const int corner[4],
               struct polygons *polygons)
{
    struct end *end = mem_alloc(2 * n, sizeof *end);
    bool sound = true;
    polygons->id.n = polygons->end.n = 0;
    for (size_t i = 0; i < n; i++) {
        end[2 * i] = (struct end){chain[i].side_in, chain[i].in, true, i};
        end[2 * i + 1] = (struct end){chain[i].side_out, chain[i].out, false, i};
    }
    qsort(end, 2 * n, sizeof *end, compare_ends);
    for (size_t i = 0; i < n && sound; i++)
        if (!chain[i].used)
            sound = round_polygon(chain, id, end, 2 * n, corner, i, polygons);
    free(end);
    return sound;
}

void polygons_free(struct polygons *polygons)
{
    array_free(&polygons->id);
    array_free(&polygons->end);
}
