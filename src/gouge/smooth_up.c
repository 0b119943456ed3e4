/* smooth_up - see smooth_up.h. */
#include "smooth_up.h"

#include <stdlib.h>

#include "base/array.h"

enum { SWEEPS = 60 };

static const double RELAX = 1.5, SHORTEST = 1e-3; /* mm: points nearer than that count as so far */

/* The curve bends at point i by a[i][0] p[i - 1] + a[i][1] p[i] + a[i][2] p[i + 1], over a length
 * of `along`. */
struct bend {
    double a[3], along;
    struct vec3 curvature;
};

static void find_bend(const struct vec3 *p, struct bend *bend)
{
    double before = fmax(vec_distance(p[-1], p[0]), SHORTEST);
    double after = fmax(vec_distance(p[0], p[1]), SHORTEST);

    bend->along = (before + after) / 2;
    bend->a[0] = 1 / (before * bend->along);
    bend->a[2] = 1 / (after * bend->along);
    bend->a[1] = -bend->a[0] - bend->a[2];
    bend->curvature = vec_add(vec_scale(bend->a[0], p[-1]),
                              vec_add(vec_scale(bend->a[1], p[0]), vec_scale(bend->a[2], p[1])));
}

/* Moves one point to where the curve bends least. */
static void move_point(struct bend *bend, struct vec3 up, double most, size_t i, size_t n,
                       double *rise)
{
    double slope = 0, stiff = 0;
    size_t from = i < 2 ? 1 : i - 1, to = i + 2 < n ? i + 1 : n - 2;

    for (size_t k = from; k <= to; k++) {
        double a = bend[k].a[i + 1 - k];
        slope += bend[k].along * a * vec_dot(bend[k].curvature, up);
        stiff += bend[k].along * a * a;
    }
    double next = fmax(0, fmin(*rise - RELAX * slope / stiff, most)), move = next - *rise;
    if (move == 0)
        return;
    for (size_t k = from; k <= to; k++)
        bend[k].curvature = vec_along(bend[k].curvature, move * bend[k].a[i + 1 - k], up);
    *rise = next;
}

void smooth_up(const struct vec3 *point, const struct vec3 *up, const double *most, size_t n,
               double *rise)
{
    for (size_t i = 0; i < n; i++)
        rise[i] = 0;
    if (n < 3)
        return;
    struct bend *bend = mem_alloc(n, sizeof *bend);
    for (size_t i = 1; i + 1 < n; i++)
        find_bend(point + i, &bend[i]);
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (size_t k = 1; k + 1 < n; k++) {
            size_t i = sweep % 2 ? n - 1 - k : k;
            move_point(bend, up[i], most[i], i, n, &rise[i]);
        }
    free(bend);
}
