/* box - see box.h. */
#include "math/box.h"

#include "math/pair.h"

struct box box_empty(void)
{
    return (struct box){vec(INFINITY, INFINITY, INFINITY), vec(-INFINITY, -INFINITY, -INFINITY)};
}

struct box box_around(const struct vec3 *point, size_t n)
{
    pair low = pair_both(INFINITY), high = -low;
    double bottom = INFINITY, top = -INFINITY;

    for (size_t i = 0; i < n; i++) { /* as box_add has it */
        pair at = pair_at(&point[i].x);
        low = pair_lesser(at, low);
        high = pair_greater(at, high);
        bottom = point[i].z < bottom ? point[i].z : bottom;
        top = point[i].z > top ? point[i].z : top;
    }
    return (struct box){vec(low[0], low[1], bottom), vec(high[0], high[1], top)};
}

void box_add(struct box *box, struct vec3 p)
{
    box->low = vec(fmin(box->low.x, p.x), fmin(box->low.y, p.y), fmin(box->low.z, p.z));
    box->high = vec(fmax(box->high.x, p.x), fmax(box->high.y, p.y), fmax(box->high.z, p.z));
}

void box_join(struct box *box, const struct box *other)
{
    if (other->low.x <= other->high.x) {
        box_add(box, other->low);
        box_add(box, other->high);
    }
}

double box_diagonal(const struct box *box)
{
    return box->low.x <= box->high.x ? vec_distance(box->low, box->high) : 0;
}

static double distance_outside(double low, double x, double high)
{
    return x < low ? low - x : x > high ? x - high : 0;
}

double box_distance2(const struct box *box, struct vec3 p)
{
    double x = distance_outside(box->low.x, p.x, box->high.x);
    double y = distance_outside(box->low.y, p.y, box->high.y);
    double z = distance_outside(box->low.z, p.z, box->high.z);
    return x * x + y * y + z * z;
}
