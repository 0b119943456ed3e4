/* edge_roll - see edge_roll.h. */
#include "toolpath/edge_roll.h"

#include "base/array.h"

void edge_roll(struct contacts *to, struct vec3 forward, struct contact last, struct contact next,
               double radius, double tolerance)
{
    if (vec_dot(next.n, forward) < vec_dot(last.n, forward))
        return;
    double step = 2 * acos(fmax(1 - tolerance / radius, 0));
    double parts = ceil(vec_angle(last.n, next.n) / step);
    for (double i = 1; i < parts; i++)
        *array_push(to) = (struct contact){vec_mix(last.p, next.p, i / parts),
                                           vec_slerp(last.n, next.n, i / parts)};
}
