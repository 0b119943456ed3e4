/* arc_window - see arc_window.h. */
#include "arc_window.h"

#include <stdlib.h>

static const double FURTHER = 1.0 / 40; /* the next point looked at is so much further away */

/* Direction across t to which the trace bends: that in which it first is clearly off the line. */
static struct vec3 bend(const struct trace *trace, size_t at, struct vec3 p, struct vec3 t,
                        double tolerance)
{
    struct vec3 across = {0};
    for (size_t j = at + 1; j < trace->n && vec_length(across) < 2 * tolerance; j++)
        across = vec_reject(vec_sub(trace->p[j], p), t);
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

/* Cuts the window to a disc; false when nothing is left. */
static bool cut(struct arc_window *w, struct vec3 k, double radius)
{
    double u = vec_dot(k, w->u), v = vec_dot(k, w->v), half = sqrt(0.5);
    double along[4] = {u, v, half * (u + v), half * (u - v)};
    for (int i = 0; i < 4; i++) {
        double lo = along[i] - radius, hi = along[i] + radius;
        w->lo[i] = lo > w->lo[i] ? lo : w->lo[i];
        w->hi[i] = hi < w->hi[i] ? hi : w->hi[i];
        if (w->lo[i] > w->hi[i])
            return false;
    }
    return true;
}

size_t arc_window(const struct trace *trace, size_t at, struct vec3 p, struct vec3 t,
                  double tolerance, struct arc_windows *windows)
{
    struct arc_window w = open_window(bend(trace, at, p, t, tolerance), t);
    double start = trace->length[at], next = 0;
    size_t last = at;
    for (size_t j = at + 1; j < trace->n; j++) {
        if (trace->length[j] < next && j + 1 < trace->n)
            continue;
        next = start + (1 + FURTHER) * (trace->length[j] - start);
        struct vec3 e = vec_sub(trace->p[j], p);
        double ahead = vec_dot(e, t), e2 = vec_dot(e, e);
        if (e2 > tolerance * tolerance) {
            struct vec3 k = vec_scale(2 / e2, vec_along(e, -ahead, t));
            if (ahead <= 0 || !cut(&w, k, 2 * tolerance / e2))
                break;
            w.point = j;
            if (windows)
                *array_push(windows) = w;
        }
        last = j;
    }
    return last;
}

struct vec3 arc_window_at(const struct arc_window *w, double across, double aside)
{
    struct vec3 k = vec_scale(w->lo[0] + across * (w->hi[0] - w->lo[0]), w->u);
    return vec_along(k, w->lo[1] + aside * (w->hi[1] - w->lo[1]), w->v);
}

bool arc_window_straight(const struct arc_window *w)
{
    return w->lo[0] <= 0 && w->hi[0] >= 0 && w->lo[1] <= 0 && w->hi[1] >= 0;
}
