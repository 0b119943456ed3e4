#include "scan.h"

#include <stdlib.h>

#include "cloud.h"
#include "scansurface.h"

static struct vec3 place(const double m[4][4], struct vec3 p)
{
    return vec(m[0][0] * p.x + m[0][1] * p.y + m[0][2] * p.z + m[0][3],
               m[1][0] * p.x + m[1][1] * p.y + m[1][2] * p.z + m[1][3],
               m[2][0] * p.x + m[2][1] * p.y + m[2][2] * p.z + m[2][3]);
}

/* `placed`: how, NULL: as they are. */
static int read_points(const struct cli_list *files, const double (*placed)[4],
                       struct vec3s *points, struct error *error)
{
    for (size_t f = 0; f < files->n; f++) {
        struct cloud_count count = {0};
        size_t from = points->n;
        if (cloud_read(files->item[f], points, &count, error) != 0)
            return -1;
        if (points->n == from)
            return error_at(error, files->item[f], 0, "found no points");
        if (count.not_finite > 0)
            say("%s: %zu rows without finite numbers left out, the first in line %zu",
                files->item[f], count.not_finite, count.first_not_finite);
        for (size_t i = from; placed && i < points->n; i++)
            points->item[i] = place(placed, points->item[i]);
    }
    if (placed)
        say("the scan to guard is placed as the mesh was");
    return 0;
}

/* How many places have no guard point within `near`. */
static size_t far_places(const struct vec3s *place, const struct guard *guard, double near)
{
    size_t far = 0;

    for (size_t i = 0; i < place->n; i++)
        far += guard_clear_along(guard, place->item[i], place->item[i], near, 0);
    return far;
}

static struct guard *guard_of(const struct vec3s *points, struct scan_rule *rule)
{
    struct scansurface_rule how = {.radius = rule->radius,
                                   .sink = rule->tolerance / 5,
                                   .noise = rule->noise,
                                   .least = rule->tolerance / 2,
                                   .threads = rule->threads};
    struct scansurface surface;

    scansurface_make(points->item, points->n, &how, &surface);
    rule->noise = surface.noise;
    if (surface.noise > 0)
        say("noise of %.2g mm taken out of the scan that guards (%zu of %zu points moved)",
            surface.noise, surface.moved, points->n);
    note("guarded by %zu points of the scan and %zu put between", points->n, surface.added);
    return guard_take(surface.point, rule->threads);
}

static struct guard *read_guard(const struct cli_list *files, const double (*placed)[4],
                                const struct vec3s *place_of, const char *what, double near,
                                struct scan_rule *rule, struct error *error)
{
    struct vec3s points = {0};
    struct guard *guard = NULL;

    if (read_points(files, placed, &points, error) == 0)
        guard = guard_of(&points, rule);
    array_free(&points);
    size_t far = guard ? far_places(place_of, guard, near) : 0;
    if (2 * far <= place_of->n)
        return guard;
    guard_free(guard);
    error_at(error, files->item[0], 0,
             "found %zu of %zu %s further than %.3g mm from the scan, expected the scan that the "
             "mesh was made from",
             far, place_of->n, what, near);
    return NULL;
}

struct guard *scan_guard(const struct cli_list *files, const struct mesh *mesh, double near,
                         struct scan_rule *rule, struct error *error)
{
    return read_guard(files, mesh->origin.placed ? mesh->origin.place : NULL, &mesh->vertex,
                      "mesh vertices", near, rule, error);
}

struct guard *scan_guard_points(const struct cli_list *files, const struct vec3s *place,
                                double near, struct scan_rule *rule, struct error *error)
{
    return read_guard(files, NULL, place, "points of the path", near, rule, error);
}
