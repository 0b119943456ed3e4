/* arc_window - see arc_window.h. */
#include "arc_window.h"

/* Direction across t to which the reference bends: that in which it first is clearly off the line.
 */
static struct vec3 bend_direction(const struct reference *reference, size_t at, struct vec3 p,
                                  struct vec3 t, double tolerance)
{
    struct vec3 across = {0};
    for (size_t j = at + 1; j < reference->n && vec_length(across) < 2 * tolerance; j++) {
        j = polyline_stay_end(&reference->point_stays, j);
        across = vec_reject(vec_sub(reference->point[j], p), t);
    }
    across = vec_unit(across);
    return vec_dot(across, across) > 0.5 ? across : vec_perpendicular(t);
}

static struct arc_window open_window(struct vec3 u, struct vec3 t)
{
    struct arc_window w = {.u = u, .v = vec_cross(t, u)};
    for (int i = 0; i < 4; i++) {
        w.lo[i] = -HUGE_VAL;
        w.hi[i] = HUGE_VAL;
    }
    return w;
}

static inline int cut_bounds(struct arc_window *w, int i, double along, double radius)
{
    double lo = along - radius, hi = along + radius;
    w->lo[i] = lo > w->lo[i] ? lo : w->lo[i];
    w->hi[i] = hi < w->hi[i] ? hi : w->hi[i];
    return w->lo[i] <= w->hi[i];
}

/* Cuts the window to a disc; false when nothing is left.  All four bounds in a row, for none of
 * them has to wait for another. */
static bool cut_to_disc(struct arc_window *w, struct vec3 k, double radius)
{
    double u = vec_dot(k, w->u), v = vec_dot(k, w->v), half = sqrt(0.5);
    return cut_bounds(w, 0, u, radius) & cut_bounds(w, 1, v, radius) &
           cut_bounds(w, 2, half * (u + v), radius) & cut_bounds(w, 3, half * (u - v), radius);
}

size_t arc_look_ahead(const struct reference *reference, size_t at, struct vec3 p, struct vec3 t,
                      double tolerance, double further, struct arc_windows *windows)
{
    struct arc_window w = open_window(bend_direction(reference, at, p, t, tolerance), t);
    double start = reference->length[at], next = 0;
    size_t last = at;
    for (size_t j = at + 1; j < reference->n; j++) {
        if (reference->length[j] < next && j + 1 < reference->n)
            continue;
        next = start + (1 + further) * (reference->length[j] - start);
        struct vec3 e = vec_sub(reference->point[j], p);
        double ahead = vec_dot(e, t), e2 = vec_dot(e, e);
        if (e2 > tolerance * tolerance) {
            struct vec3 k = vec_scale(2 / e2, vec_along(e, -ahead, t));
            if (ahead <= 0 || !cut_to_disc(&w, k, 2 * tolerance / e2))
                break;
            w.point = j;
            if (windows)
                *array_push(windows) = w;
        } else {
            j = polyline_stay_end(&reference->point_stays, j);
        }
        last = j;
    }
    return last;
}

struct vec3 arc_window_curvature(const struct arc_window *w, double across, double aside)
{
    struct vec3 k = vec_scale(w->lo[0] + across * (w->hi[0] - w->lo[0]), w->u);
    return vec_along(k, w->lo[1] + aside * (w->hi[1] - w->lo[1]), w->v);
}

bool arc_window_holds_line(const struct arc_window *w)
{
    return w->lo[0] <= 0 && w->hi[0] >= 0 && w->lo[1] <= 0 && w->hi[1] >= 0;
}
