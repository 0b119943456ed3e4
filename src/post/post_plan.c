/* post_plan - see post_plan.h. */
#include "post_plan.h"

#include <stdlib.h>

#include "base/array.h"

void nc_plan_free(struct nc_plan *plan)
{
    for (size_t i = 0; i < plan->spline.n; i++)
        nc_spline_free(&plan->spline.item[i]);
    array_free(&plan->move);
    array_free(&plan->vector);
    array_free(&plan->arc);
    array_free(&plan->spline);
    array_free(&plan->hole);
}

struct block_pose nc_plan_pose(const struct nc_plan *plan, const struct kinematic_chain *chain,
                               const struct nc_move *move)
{
    struct block_pose at = {.p = move->p, .q = {move->q[0], move->q[1]}};
    at.a = plan->ability.mode == INTERPOLATE_VECTOR ? plan->vector.item[move->vector]
                                                    : chain_axis(chain, move->q);
    return at;
}
