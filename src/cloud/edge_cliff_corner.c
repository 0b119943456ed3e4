/* edge_cliff_corner - see edge_steps.h and edge_cliff.h. */
#include <stdlib.h>

#include "edge_cliff.h"
#include "math/triangles.h"

/* Seen from above the flank is open about a point of a corner by more: its sides make less than 75
 * degrees.  Before blunter ones a ball is held off by the walls of both sides. */
static const double CORNER_OPEN = RADIANS(285);

/* Points of the flank that show how its sides run. */
enum { CORNER_FEWEST = 2 };

/* ---- tips over a place */

/* A point, seen from above, as turned from the way (x, y) at a place: between -PI and PI. */
static double turned(struct vec3 p, struct vec3 at, double x, double y)
{
    double u = p.x - at.x, v = p.y - at.y;

    return atan2(x * v - y * u, x * u + y * v);
}

/* No point below is in the quarter of the plane that begins at this turn. */
static bool is_free(const struct edge_cliff *cliff, struct vec3 at, double x, double y,
                    double begin)
{
    const double slack = 1e-9;

    for (size_t k = 0; k < cliff->below.n; k++) {
        double t = turned(cliff->below.item[k], at, x, y) - begin;
        t += t < 0 ? 2 * PI : 0;
        if (t > slack && t < PI / 2 - slack)
            return false;
    }
    return true;
}

/* The upper points may be those of a square corner whose tip is over the place: there is one that
 * holds all of them, and none of those below. */
static bool is_corner_tip(const struct edge_cliff *cliff, struct vec3 at)
{
    double x = cliff->from.x - at.x, y = cliff->from.y - at.y, low = 0, high = 0;

    for (size_t k = 0; k < cliff->on.n; k++) {
        x += cliff->on.item[k].x - at.x;
        y += cliff->on.item[k].y - at.y;
    }
    for (size_t k = 0; k <= cliff->on.n; k++) {
        double t = turned(k < cliff->on.n ? cliff->on.item[k] : cliff->from, at, x, y);
        low = k == 0 ? t : fmin(low, t);
        high = k == 0 ? t : fmax(high, t);
    }
    if (!(high - low < PI / 2))
        return false;
    if (is_free(cliff, at, x, y, low) || is_free(cliff, at, x, y, high - PI / 2))
        return true;
    for (size_t k = 0; k < cliff->below.n; k++) {
        double t = turned(cliff->below.item[k], at, x, y);
        t -= t > 0 ? PI / 2 : 0; /* as the end of the quarter, or as its begin */
        if (t > high - PI / 2 && t < low && is_free(cliff, at, x, y, t))
            return true;
    }
    return false;
}

/* Points below are ahead on both sides of the way to the place, as at no border of the scan. */
static bool is_amid(const struct edge_cliff *cliff, double u, double v)
{
    bool left = false, right = false;

    for (size_t k = 0; k < cliff->below.n; k++) {
        double x = cliff->below.item[k].x - cliff->from.x;
        double y = cliff->below.item[k].y - cliff->from.y, aside = u * y - v * x;
        if (u * x + v * y > 0) {
            left = left || aside > 0;
            right = right || aside < 0;
        }
    }
    return left && right;
}

/* The wall of a corner whose tip may be over a place; false: none is. */
static bool add_tip(const struct edge_cliff *cliff, double u, double v, struct vec3s *to)
{
    if (hypot_compare(u, v, cliff->reach) > 0 || !edge_cliff_is_before(cliff, u, v) ||
        !is_amid(cliff, u, v))
        return false;
    struct vec3 at = edge_cliff_place(cliff, cliff->from.x + u, cliff->from.y + v);
    if (!edge_cliff_reaches(cliff, at) || !is_corner_tip(cliff, at))
        return false;
    *array_push(to) = at;
    edge_wall_add(cliff->work, at, edge_cliff_nearest_below(cliff, at), to);
    return true;
}

/* Places of tips that are so far apart, in the triangles about a place (u, v), but not there. */
static void add_tips_about(const struct edge_cliff *cliff, double u, double v, double pitch,
                           struct vec3s *to)
{
    for (int a = -1; a <= 1; a++)
        for (int b = -1; b <= 1; b++) {
            double x, y;
            triangles_at(pitch, b, a, &x, &y);
            if (a != 0 || b != 0)
                add_tip(cliff, u + x, v + y, to);
        }
}

void edge_cliff_add_tips(const struct edge_cliff *cliff, struct vec3s *to)
{
    enum { CLOSER = 3 };
    double pitch = EDGE_CLIFF_PITCH * cliff->work->options->along;
    int rings = (int)fmin(triangles_rings(cliff->reach, pitch), EDGE_CLIFF_RINGS);
    struct edge_cliff wider = *cliff;

    wider.corner = EDGE_REACH * point_grid_spacing(cliff->work->options->point_grid);
    for (int j = -rings; j <= rings; j++)
        for (int k = -rings; k <= rings; k++) {
            double u, v;
            triangles_at(pitch, k, j, &u, &v);
            if (add_tip(&wider, u, v, to))
                add_tips_about(&wider, u, v, pitch / CLOSER, to);
        }
}

/* ---- how far a corner stands out */

/* The widest angle about the point, seen from above, without points of its flank; *amid: its
 * middle. */
static double open_angle(const struct edge_cliff *cliff, double *amid)
{
    size_t n = cliff->on.n;
    double *turn = mem_alloc(n + 1, sizeof *turn), widest = 0;

    for (size_t k = 0; k < n; k++)
        turn[k] = atan2(cliff->on.item[k].y - cliff->from.y, cliff->on.item[k].x - cliff->from.x);
    doubles_sort(turn, n);
    turn[n] = n > 0 ? turn[0] + 2 * PI : 0;
    for (size_t k = 0; k < n; k++)
        if (turn[k + 1] - turn[k] > widest) {
            widest = turn[k + 1] - turn[k];
            *amid = turn[k] + widest / 2;
        }
    free(turn);
    return widest;
}

/* To the nearest point down a wall there; 0: it is no wall. */
static double room_ahead(const struct edge_cliff *cliff, double turn)
{
    const double beside = 0.7;
    double x = cos(turn), y = sin(turn), least = HUGE_VAL;

    for (size_t k = 0; k < cliff->below.n; k++) {
        struct vec3 to = vec_sub(cliff->below.item[k], cliff->from);
        double far = hypot(to.x, to.y);
        if (to.x * x + to.y * y > beside * far && -to.z > far)
            least = fmin(least, far);
    }
    return least < HUGE_VAL ? least : 0;
}

double edge_cliff_corner(const struct edge_work *work, size_t i, struct vec3 *ahead)
{
    const struct edge_flank *flank = &work->flank[i];

    if (!edge_flank_certain(work, flank) || quadric_normal(&flank->q).z <= EDGE_CLIFF_LEVEL)
        return 0;
    struct edge_cliff cliff = edge_cliff_find(work, i);
    double amid = 0, open = open_angle(&cliff, &amid);
    double depth = cliff.on.n >= CORNER_FEWEST && open > CORNER_OPEN ? room_ahead(&cliff, amid) : 0;
    double x = cos(amid), y = sin(amid), up = 0;

    if (depth > 0)
        up = edge_cliff_place(&cliff, cliff.from.x + depth * x, cliff.from.y + depth * y).z -
             cliff.from.z;
    *ahead = vec(x, y, depth > 0 ? up / depth : 0);
    edge_cliff_free(&cliff);
    return depth;
}
