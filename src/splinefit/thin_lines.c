/* thin_lines - see thin_lines.h. */
#include "thin_lines.h"

#include <stdlib.h>

#include "base/array.h"
#include "math/elementary.h"

/* How far the points between two are at most beside the line from one to the other, on which the
 * axis turns with the length of the reference. */
static struct deviation off_line(const struct reference *t, size_t from, size_t to)
{
    double whole = t->length[to] - t->length[from];
    struct deviation off = {0};

    for (size_t k = from + 1; k < to; k++) {
        double s = whole > 0 ? (t->length[k] - t->length[from]) / whole : 0;
        struct deviation here = {vec_segment_distance(t->point[from], t->point[to], t->point[k]),
                                 vec_segment_distance(t->other[from], t->other[to], t->other[k]),
                                 vec_angle(vec_mix(t->axis[from], t->axis[to], s), t->axis[k])};
        off = deviation_worst(off, here);
    }
    return off;
}

/* The numbers of the points that are kept. */
static void choose(const struct reference *t, const struct deviation *within, double least,
                   struct sizes *kept)
{
    size_t last = t->n - 1;

    *array_push(kept) = 0;
    for (size_t k = 1; k < last; k++) {
        size_t before = kept->item[kept->n - 1];
        struct deviation off = off_line(t, before, k + 1);
        if (vec_distance(t->point[k], t->point[before]) >= least || !deviation_within(&off, within))
            *array_push(kept) = k;
    }
    while (kept->n > 1 && vec_distance(t->point[kept->item[kept->n - 1]], t->point[last]) < least) {
        struct deviation off = off_line(t, kept->item[kept->n - 2], last);
        if (!deviation_within(&off, within))
            break;
        kept->n--;
    }
    *array_push(kept) = last;
}

struct reference thin_lines(const struct reference *reference, const struct deviation *within,
                            double least, struct deviation *off)
{
    struct sizes kept = {0};

    choose(reference, within, least, &kept);
    struct reference thin = {.n = kept.n,
                             .offset = reference->offset,
                             .turns = reference->turns,
                             .other_leads = reference->other_leads,
                             .point = mem_alloc(kept.n, sizeof(struct vec3)),
                             .other = mem_alloc(kept.n, sizeof(struct vec3)),
                             .axis = mem_alloc(kept.n, sizeof(struct vec3)),
                             .length = mem_alloc(kept.n, sizeof(double))};
    *off = (struct deviation){0};
    for (size_t i = 0; i < kept.n; i++) {
        size_t k = kept.item[i];
        thin.point[i] = reference->point[k];
        thin.other[i] = reference->other[k];
        thin.axis[i] = reference->axis[k];
        thin.length[i] = reference->length[k];
        if (i > 0)
            *off = deviation_worst(*off, off_line(reference, kept.item[i - 1], k));
    }
    array_free(&kept);
    return thin;
}
