/* scan_lines - see scan_lines.h. */
#include "cloud/scan_lines.h"

#include "math/plane_fit.h"

/* NEXT: with two to each side.  Up a flank points on a line are further apart in space, while lines
 * along it are as near as in plan. */
enum { SAMPLE = 500, NEXT = 5 };

/* Width by length of the nearest points. */
static const double SLENDER = 0.25;

static bool is_on_line(const struct point_grid *b, size_t i)
{
    struct vec3 near[NEXT];
    struct plane_fit plane;
    size_t n = point_grid_near(b, b->point[i], NEXT, near);

    return plane_fit(near, n, &plane) < 0 || plane.width < SLENDER * plane.length;
}

bool scan_lines_found(const struct point_grid *b)
{
    size_t sample = b->n < SAMPLE ? b->n : SAMPLE, on = 0;

    for (size_t s = 0; s < sample; s++)
        on += is_on_line(b, s * b->n / sample);
    return 2 * on > sample;
}
