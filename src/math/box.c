/* box - see box.h. */
#include "math/box.h"

struct box box_empty(void)
{
    return (struct box){vec(INFINITY, INFINITY, INFINITY), vec(-INFINITY, -INFINITY, -INFINITY)};
}

struct box box_around(const struct vec3 *point, size_t n)
{
    struct box box = box_empty();

    for (size_t i = 0; i < n; i++)
        box_add(&box, point[i]);
    return box;
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
