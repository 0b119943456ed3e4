/* arc_reverse - see arc_reverse.h. */
#include "arcfit/arc_reverse.h"

#include <stdlib.h>

#include "base/array.h"

struct trace arc_reverse_trace(const struct trace *trace)
{
    size_t n = trace->n;
    struct trace back = {.n = n, .lever = trace->lever};

    back.p = mem_alloc(n, sizeof *back.p);
    back.other = mem_alloc(n, sizeof *back.other);
    back.axis = mem_alloc(n, sizeof *back.axis);
    back.tangent = mem_alloc(n, sizeof *back.tangent);
    back.length = mem_alloc(n, sizeof *back.length);
    for (size_t i = 0; i < n; i++) {
        size_t k = n - 1 - i;
        back.p[i] = trace->p[k];
        back.other[i] = trace->other[k];
        back.axis[i] = trace->axis[k];
        back.tangent[i] = vec_scale(-1, trace->tangent[k]);
        back.length[i] = trace->length[n - 1] - trace->length[k];
    }
    return back;
}

static struct arc_piece turned(const struct arc_piece *p, double last)
{
    const struct arc *arc = &p->arc;
    struct vec3 tangent = vec_scale(-1, arc_tangent(arc, 1));

    return (struct arc_piece){.arc = arc_straight(arc) ? arc_line(arc->to, arc->from)
                                                       : arc_to(arc->to, tangent, arc->from),
                              .from = last - p->to,
                              .to = last - p->from,
                              .axis = p->axis_to,
                              .axis_to = p->axis};
}

void arc_reverse_pieces(struct pieces *pieces, size_t points)
{
    double last = (double)points - 1;

    for (size_t i = 0, k = pieces->n; i < k--; i++) {
        struct arc_piece first = turned(&pieces->item[k], last);
        pieces->item[k] = turned(&pieces->item[i], last);
        pieces->item[i] = first;
    }
}
