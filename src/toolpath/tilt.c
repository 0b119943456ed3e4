/* tilt - see tilt.h. */
#include "toolpath/tilt.h"

#include <stdlib.h>

#include "arcfit/arcfit.h"

struct frame {
    struct vec3 n, b; /* unit; zero: none */
};

static const double AGREE = 0.1; /* a Frenet normal nearer to perpendicular keeps its own sign */

static void darboux(const struct run *run, struct frame *frame)
{
    struct vec3 *tangent = mem_alloc(run->n, sizeof *tangent);
    run_tangents(run, false, tangent);
    for (size_t i = 0; i < run->n; i++) {
        struct vec3 n = run->item[i].normal;
        struct vec3 b = vec_unit(vec_cross(n, tangent[i]));
        if (vec_dot(b, b) > 0.5)
            frame[i] = (struct frame){n, b};
    }
    free(tangent);
}

/* Turns the frames found so far where the curve bends; takes over the one before where not. */
static void frenet(const struct run *run, struct frame *frame)
{
    struct reference reference = reference_of(run, 0, run->n, true, true);
    struct pieces pieces = {0};
    arcfit_each(&reference, &pieces);
    bool begun = false;
    for (size_t k = 0; k < pieces.n; k++) {
        const struct arc_piece *piece = &pieces.item[k];
        bool last = k + 1 == pieces.n;
        if (piece->from > floor(piece->from) && !last)
            continue; /* the second half of a biarc */
        size_t i = last ? run->n - 1 : (size_t)piece->from;
        const struct arc *arc = &piece->arc;
        struct vec3 t = arc_tangent(arc, last ? 1 : 0);
        struct vec3 n = vec_cross(arc_axis(arc), t);
        struct vec3 before = begun ? frame[i - 1].n : run->item[i].normal;
        if (vec_dot(n, n) < 0.5) {
            if (begun)
                frame[i] = frame[i - 1];
            continue;
        }
        double with = vec_dot(n, run->item[i].normal);
        if (fabs(with) < AGREE)
            with = vec_dot(n, before);
        n = vec_scale(with < 0 ? -1 : 1, n);
        frame[i] = (struct frame){n, vec_cross(n, t)};
        begun = true;
    }
    array_free(&pieces);
    reference_free(&reference);
}

void tilt_run(struct run *run, double angle, bool paper, struct vec3 *side)
{
    struct frame *frame = mem_alloc(run->n + 1, sizeof *frame);
    darboux(run, frame);
    if (paper)
        frenet(run, frame);
    struct vec3 mean = {0};
    for (size_t i = 0; i < run->n; i++)
        mean = vec_add(mean, frame[i].b);
    double sign = vec_dot(mean, *side) < 0 ? -1 : 1;
    if (vec_dot(mean, mean) > 0)
        *side = vec_scale(sign, vec_unit(mean));
    for (size_t i = 0; i < run->n; i++) {
        struct run_point *p = &run->item[i];
        if (vec_dot(frame[i].n, frame[i].n) < 0.5)
            continue;
        struct vec3 a = vec_scale(cos(angle), frame[i].n);
        p->axis = vec_unit(vec_along(a, sign * sin(angle), frame[i].b));
        p->tip = vec_along(p->ball, -run->radius, p->axis);
    }
    free(frame);
}
