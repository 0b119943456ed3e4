/* trim_snap - see trim_snap.h. */
#include "trim_snap.h"

#include <math.h>
#include <stdlib.h>

/* Steps over the whole grid, and how near to a line a place is taken to lie on it. */
enum { STEPS = 1 << 28, NEAR = 32 };

struct trim_lattice trim_snap_new(const struct doubles *x)
{
    struct trim_lattice a = {
        .from = x->item[0], .width = x->item[x->n - 1] - x->item[0], .n = x->n};
    a.line = mem_alloc(a.n, sizeof *a.line);
    for (size_t i = 0; i < a.n; i++)
        a.line[i] = 2 * (int64_t)floor((x->item[i] - a.from) / a.width * STEPS + 0.5);
    return a;
}

size_t trim_snap_below(const struct trim_lattice *a, int64_t x)
{
    size_t low = 0, high = a->n;
    while (low < high) {
        size_t mid = low + (high - low) / 2;
        if (a->line[mid] < x)
            low = mid + 1;
        else
            high = mid;
    }
    return low;
}

int64_t trim_snap_place(const struct trim_lattice *a, double x, double inwards)
{
    double part = fmin(fmax((x - a->from) / a->width, -0.01), 1.01);
    int64_t at = 2 * (int64_t)floor(part * STEPS) + 1;
    size_t above = trim_snap_below(a, at);
    for (size_t i = above > 0 ? above - 1 : 0; i < a->n && i <= above; i++) {
        if (llabs(a->line[i] - at) > NEAR)
            continue;
        if (i == 0)
            return a->line[i] - 1;
        if (i + 1 == a->n)
            return a->line[i] + 1;
        return a->line[i] + (inwards > 0 ? 1 : -1);
    }
    return at;
}

void trim_snap_free(struct trim_lattice *a)
{
    free(a->line);
    *a = (struct trim_lattice){0};
}
