/* arcspline_reduce - see arcspline_reduce.h. */
#include "arcfit/arcspline_reduce.h"

#include <stdlib.h>

#include "arcspline_refit.h"

enum {
    WHOLE = 32, /* arcs that are moved all together; of more a window at a time */
    WINDOW = 6, /* of so many arcs, */
    WIDE = 14   /* or so many where the axis stands still */
};

/* Puts `some` in the place of n pieces at `at`. */
static void replace(struct pieces *pieces, size_t at, size_t n, const struct pieces *some)
{
    for (size_t i = 0; i < some->n; i++)
        pieces->item[at + i] = some->item[i];
    for (size_t i = at + n; i < pieces->n; i++)
        pieces->item[i - n + some->n] = pieces->item[i];
    pieces->n -= n - some->n;
}

/* End of the smooth part that starts with piece `from`: where the direction jumps. */
static size_t smooth_end(const struct pieces *pieces, size_t from)
{
    size_t i = from + 1;
    while (i < pieces->n && vec_angle(arc_tangent(&pieces->item[i - 1].arc, 1),
                                      pieces->item[i].arc.tangent) <= 1.01 * ARCFIT_KINK)
        i++;
    return i;
}

/* n pieces from `at` on, of the smooth part [from, end), with one fewer; false where none holds. */
static bool relax_some(const struct arcspline_refit *like, size_t from, size_t end, size_t at,
                       size_t n, struct pieces *pieces)
{
    struct arcspline_refit part = *like;
    struct pieces some = {0};
    part.old = &pieces->item[at];
    part.n = n;
    part.start_held = at > from;
    part.end_held = at + n < end;
    bool good = n > 1 && arcspline_refit_fit(&part, n - 1, &some);

    if (good)
        replace(pieces, at, n, &some);
    array_free(&some);
    return good;
}

/* The smooth part [from, end) with fewer pieces; returns its new end.  Windows that hold no arc too
 * many come in rows (a scan's noise): the longer the row, the fewer of the next are tried. */
static size_t relax(const struct arcspline_refit *like, size_t from, size_t end,
                    struct pieces *pieces)
{
    bool still = trace_axis_still(like->trace, (size_t)pieces->item[from].from,
                                  (size_t)pieces->item[end - 1].to);
    size_t stride = 1, window = still ? WIDE : WINDOW;

    for (size_t i = from; end - from > window && i < end;) {
        size_t n = end - i < window ? end - i : window;
        if (relax_some(like, from, end, i, n, pieces)) {
            end--;
            stride = 1;
        } else {
            i = i + n < end ? i + stride : end;
            stride = stride < window ? stride + 1 : window;
        }
    }
    while (end - from <= WHOLE && relax_some(like, from, end, from, end - from, pieces))
        end--;
    return end;
}

void arcspline_reduce(const struct trace *trace, const struct arc_deviation *within, int digits,
                      bool thorough, struct pieces *pieces)
{
    struct arcspline_refit like = {
        .trace = trace, .within = within, .digits = digits, .thorough = thorough};

    for (size_t from = 0; from < pieces->n;)
        from = relax(&like, from, smooth_end(pieces, from), pieces);
}
