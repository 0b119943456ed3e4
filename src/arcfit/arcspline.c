/* arcspline - see arcspline.h. */
#include "arcspline.h"

#include <stdlib.h>
#include <string.h>

struct arcspline arcspline_new(size_t arcs)
{
    return (struct arcspline){.n = arcs, .joint = mem_alloc(arcs + 1, sizeof(struct joint))};
}

void arcspline_free(struct arcspline *chain)
{
    free(chain->joint);
    *chain = (struct arcspline){0};
}

void arcspline_copy(struct arcspline *to, const struct arcspline *from)
{
    memcpy(to->joint, from->joint, (from->n + 1) * sizeof *from->joint);
}

void arcspline_turn(struct arcspline *chain, size_t from)
{
    for (size_t i = from; i < chain->n; i++) {
        struct joint *a = &chain->joint[i], *b = a + 1;
        struct vec3 chord = vec_sub(b->p, a->p);
        double l2 = vec_dot(chord, chord), ahead = vec_dot(a->tangent, chord);
        b->tangent =
            l2 > 0 ? vec_along(vec_scale(-1, a->tangent), 2 * ahead / l2, chord) : a->tangent;
    }
}

void arcspline_lean(struct arcspline *chain, const struct trace *trace, size_t joint)
{
    struct joint *j = &chain->joint[joint];
    j->place = trace_place(trace, j->p, j->place);
    j->axis = trace_axis(trace, j->place);
    size_t k = (size_t)j->place < trace->n - 1 ? (size_t)j->place : trace->n - 2;
    struct vec3 ahead = vec_sub(trace->other[k + 1], trace->other[k]);
    struct vec3 side = vec_unit(vec_cross(ahead, j->axis));
    if (trace->lever != 0)
        j->axis = vec_unit(vec_along(j->axis, j->side / trace->lever, side));
}

struct arc arcspline_arc(const struct arcspline *chain, size_t i)
{
    const struct joint *j = &chain->joint[i];
    return arc_to(j->p, j->tangent, j[1].p);
}

void arcspline_pieces(const struct arcspline *chain, const struct trace *trace,
                      struct pieces *pieces)
{
    double place = chain->joint[0].place;
    for (size_t i = 0; i < chain->n; i++) {
        const struct joint *from = &chain->joint[i], *to = from + 1;
        double next = i + 1 < chain->n ? trace_place(trace, to->p, place) : to->place;
        next = fmax(place, next);
        struct arc_piece piece = arc_piece_of(trace, arcspline_arc(chain, i), place, next);
        piece.axis = from->axis;
        piece.axis_to = to->axis;
        *array_push(pieces) = piece;
        place = next;
    }
}
