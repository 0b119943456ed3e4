/* ik_near - see ik_near.h. */
#include "machine/ik_near.h"

struct ik_near_table ik_near_table(const struct kinematic_chain *chain)
{
    struct ik_near_table w = {.chain = chain};
    if (chain->n != 2)
        return w;
    struct vec3 u1 = chain->rotary[1].axis, across = vec_cross(u1, chain->tool);
    struct vec3 along = vec_scale(vec_dot(u1, chain->tool), u1);
    w.up = chain->rotary[0].axis;
    w.side = vec_perpendicular(w.up);
    w.front = vec_cross(w.up, w.side);
    const struct vec3 frame[] = {w.up, w.side, w.front};
    for (int i = 0; i < 3; i++) {
        w.still[i] = vec_dot(frame[i], along);
        w.cosine[i] = vec_dot(frame[i], chain->tool) - w.still[i];
        w.sine[i] = vec_dot(frame[i], across);
    }
    w.h = hypot(w.cosine[0], w.sine[0]);
    w.h2 = w.h * w.h;
    w.per = 1 / w.h2;
    return w;
}
