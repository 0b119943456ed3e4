/* pass_extend_within - strips without what lies beyond the scan; see pass_extend.h. */
#include <stdlib.h>

#include "toolpath/pass_extend.h"

static void end_chain(size_t from, struct slice_chains *to)
{
    if (to->point.n >= from + 2)
        *array_push(&to->chain) = (struct slice_chain){from, to->point.n, false};
    else
        to->point.n = from;
}

size_t pass_extend_within(const struct border_surface *b, struct slice_chains *strips)
{
    struct slice_chains to = {0};
    size_t left_out = 0;

    for (size_t k = 0; k < strips->chain.n; k++) {
        const struct slice_chain *chain = &strips->chain.item[k];
        size_t from = to.point.n, before = left_out;
        for (size_t i = chain->from; i < chain->to; i++) {
            const struct contact *c = &strips->point.item[i];
            if (chain->closed || border_surface_within(b, c)) {
                *array_push(&to.point) = *c;
                continue;
            }
            left_out++;
            end_chain(from, &to);
            from = to.point.n;
        }
        end_chain(from, &to);
        if (left_out == before && chain->closed)
            to.chain.item[to.chain.n - 1].closed = true;
    }
    slice_chains_free(strips);
    *strips = to;
    return left_out;
}
