/* surface_fit_along - surfaces along ribs and grooves; see surface_fit.h. */
#include <stdlib.h>

#include "base/array.h"
#include "math/neighbourhood_along.h"
#include "math/surface_fit.h"

/* Neighbourhoods longer one way: how much, of how many points, which ways are tried about one. */
struct longer {
    double aspect;
    size_t points;
    int tries;   /* to either side ... */
    double step; /* ... by so much, radians */
};

/* The surface through a neighbourhood that is longer along one of the directions half a turn has,
 * `step` apart about a middle one: the one it fits best.  False: none fits better than *fit. */
static bool best_along(const struct surface_fit_options *rule, const struct surface_fit_hood *wide,
                       struct vec3 vertex, struct vec3 guess, const struct longer *longer,
                       double *angle, struct surface_fit *fit)
{
    struct surface_fit_hood *hood = mem_alloc(1, sizeof *hood);
    struct vec3 normal = quadric_normal(&fit->q), u = vec_perpendicular(normal);
    struct vec3 v = vec_cross(normal, u);
    double middle = *angle;
    bool better = false;

    for (int i = -longer->tries; i <= longer->tries; i++) {
        double a = middle + i * longer->step;
        struct vec3 way = vec_along(vec_scale(cos(a), u), sin(a), v);
        struct surface_fit along;
        hood->n = neighbourhood_along_take(wide->point, wide->n, vertex, way, longer->aspect,
                                           longer->points, hood->point);
        if (surface_fit_through(hood, hood->n, vertex, normal, guess, rule->sigma, &along) < 0 ||
            along.spread >= fit->spread || surface_fit_useless(&along, rule->sigma))
            continue;
        *fit = along;
        *angle = a;
        better = true;
    }
    free(hood);
    return better;
}

void surface_fit_along(const struct surface_fit_options *rule, struct vec3 vertex,
                       struct vec3 guess, struct surface_fit_hood *hood, struct surface_fit *fit)
{
    static const struct longer rough = {3, 36, 4, PI / 9}, fine = {6, 72, 2, PI / 30};
    const double better = 0.85, sharp = 1.6;
    struct surface_fit along = *fit, best;
    double angle = 0;

    surface_fit_gather(rule->point_grid, vertex, (size_t)(rough.aspect * (double)rough.points),
                       hood);
    if (!best_along(rule, hood, vertex, guess, &rough, &angle, &along) ||
        along.spread > better * fit->spread || along.spread > sharp * rule->sigma)
        return;
    surface_fit_gather(rule->point_grid, vertex, (size_t)(fine.aspect * (double)fine.points), hood);
    best = along;
    best.spread *= 1.1; /* of fewer points and more of them */
    if (best_along(rule, hood, vertex, guess, &fine, &angle, &best))
        along = best;
    if (along.spread < sharp * rule->sigma) /* else it is a crease */
        *fit = along;
}
