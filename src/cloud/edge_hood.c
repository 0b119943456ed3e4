/* edge_hood - see edge_steps.h. */
#include "cloud/scan_lines.h"
#include "edge_steps.h"

/* In spacings: the most that lines are taken to be apart. */
static const double LINES = 3;

/* How far the scan lines about a place are apart: so many mean spacings as the nearest points are
 * nearer. */
static double line_distance(const double *distance2, double spacing)
{
    enum { NEXT = 4 }; /* two to each side on the line */

    return spacing * spacing / fmax(sqrt(distance2[NEXT]) / 2, spacing / LINES);
}

/* Of MANY nearest points those that are not too near to each other: no denser along lines than a
 * half of the mean spacing, or `wide`, than a good half of what the lines are apart, and so on more
 * lines than the nearest alone.  Through the nearest alone, on three lines, a smooth surface goes
 * whatever is between; but across a narrow flank only many on a line tell of it. */
static void thin_hood(const struct point_grid *b, size_t i, bool wide, struct edge_hood *near)
{
    enum { MANY = 8 * EDGE_NEAR };
    const double half = 0.5, good_half = 0.7;
    uint32_t index[MANY];
    double distance2[MANY];
    size_t n = point_grid_nearest(b, b->point[i], wide ? MANY : MANY / 2, index, distance2);

    near->n = 0;
    near->spacing = n >= EDGE_NEAR ? sqrt(PI * distance2[EDGE_NEAR - 1] / EDGE_NEAR) : 0;
    if (n < EDGE_NEAR)
        return;
    double least =
        wide ? good_half * line_distance(distance2, near->spacing) : half * near->spacing;
    for (size_t k = 0; k < n && near->n < EDGE_NEAR; k++) {
        struct vec3 p = b->point[index[k]];
        bool apart_from_all = true;
        for (size_t j = 0; j < near->n && apart_from_all; j++) {
            struct vec3 to = vec_sub(p, near->point[j]);
            apart_from_all = vec_dot(to, to) >= least * least;
        }
        if (!apart_from_all)
            continue;
        near->index[near->n] = index[k];
        near->distance2[near->n] = distance2[k];
        near->point[near->n++] = p;
    }
}

void edge_hood_find(const struct edge_work *work, size_t i, struct edge_hood *near)
{
    const struct point_grid *b = work->options->point_grid;

    if (work->lines) {
        thin_hood(b, i, work->wide, near);
        return;
    }
    near->n =
        near_lists_nearest(work->options->near, b, i, EDGE_NEAR, near->index, near->distance2);
    for (size_t k = 0; k < near->n; k++)
        near->point[k] = b->point[near->index[k]];
    near->spacing =
        near->n >= EDGE_NEAR ? sqrt(PI * near->distance2[EDGE_NEAR - 1] / EDGE_NEAR) : 0;
}

double edge_hood_out(const struct edge_hood *near, size_t n)
{
    struct vec3 up = plane_normal(near->point, n), mean = vec(0, 0, 0);

    for (size_t k = 0; k < n; k++)
        mean = vec_along(mean, 1 / (double)n, near->point[k]);
    double out = vec_dot(up, vec_sub(near->point[0], mean));
    return up.z < 0 ? -out : out;
}

double edge_plan_distance(struct vec3 a, struct vec3 b)
{
    return hypot(b.x - a.x, b.y - a.y);
}

struct edge_about edge_about_place(const struct point_grid *b, struct vec3 from, double reach)
{
    double within = fmin(reach, b->cell);

    return (struct edge_about){point_grid_about(b, from, within), from, SIZE_MAX, within};
}

struct edge_about edge_about(const struct edge_work *work, size_t i)
{
    const struct point_grid *b = work->options->point_grid;
    struct edge_about about = edge_about_place(b, b->point[i], EDGE_REACH * point_grid_spacing(b));

    about.i = i;
    return about;
}

bool edge_about_next(struct edge_about *a, size_t *k)
{
    while (point_grid_next(&a->walk, k)) {
        struct vec3 p = a->walk.grid->point[*k];
        if (*k != a->i && hypot_compare(p.x - a->from.x, p.y - a->from.y, a->reach) < 0)
            return true;
    }
    return false;
}
