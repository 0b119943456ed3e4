/* ik_bound - see ik_bound.h. */
#include "machine/ik_bound.h"

#include "machine/ik_choose.h"

static const double SURELY = 1 - 1e-9; /* of what rounding may add up to */

struct ik_bound ik_bound_from(const struct ik_near_table *near, const double q[])
{
    const struct kinematic_chain *chain = near->chain;
    return (struct ik_bound){.near = near,
                             .weight = {ik_weight(chain, 0), ik_weight(chain, 1)},
                             .mirror = atan2(near->sine[0], near->cosine[0]),
                             .q = {q[0], q[1]},
                             .turned = chain_turned(chain, q),
                             .changed = HUGE_VAL};
}

/* The angles of the axis by the solution that the second axis is nearer to; false: none. */
static bool look_closer(struct ik_bound *b, struct vec3 axis, double q[], bool *is_free)
{
    const struct kinematic_chain *chain = b->near->chain;
    struct chain_solutions found = chain_angles(chain, axis);
    if (found.n < 2)
        return false;
    int k = fabs(angle_remainder(found.q[1][1] - b->q[1])) <
            fabs(angle_remainder(found.q[0][1] - b->q[1]));
    *is_free = found.free;
    q[0] = found.free ? b->q[0] : found.q[k][0];
    q[1] = found.q[k][1];
    b->turned = chain_turned(chain, q);
    return true;
}

void ik_bound_to(struct ik_bound *b, struct vec3 axis)
{
    double q[ROTARY_MAX];
    bool is_free = false;
    if (!ik_near(b->near, axis, b->q, &b->turned, q, &b->turned) &&
        !look_closer(b, axis, q, &is_free)) {
        b->unknown = true;
        return;
    }
    double turn = fabs(angle_remainder(q[0] - b->q[0]));
    double first = is_free || b->free ? 0 : b->weight[0]; /* a free axis may stand anywhere */
    double stay = first * turn + b->weight[1] * fabs(angle_remainder(q[1] - b->q[1]));
    double change =
        first * (PI - turn) + b->weight[1] * fabs(angle_remainder(2 * b->mirror - q[1] - b->q[1]));
    double same = b->same, changed = b->changed;
    b->same = same + stay < changed + change ? same + stay : changed + change;
    b->changed = changed + stay < same + change ? changed + stay : same + change;
    b->free = is_free;
    b->q[0] = q[0];
    b->q[1] = q[1];
}

double ik_bound_least(const struct ik_bound *b)
{
    return b->unknown ? 0 : SURELY * (b->same < b->changed ? b->same : b->changed);
}
