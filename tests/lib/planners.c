/* planners - see planners.h. */
#include "planners.h"

#include <stdlib.h>

#include "base/array.h"
#include "chains.h"
#include "post/post_ik.h"

static struct vec3 rodrigues(struct vec3 v, struct vec3 k, double angle)
{
    struct vec3 turned = vec_scale(cos(angle), v);
    turned = vec_along(turned, sin(angle), vec_cross(k, v));
    return vec_along(turned, vec_dot(k, v) * (1 - cos(angle)), k);
}

struct vec3 bench_axis(const struct bench *bench, const double q[])
{
    const struct kinematic_chain *chain = &bench->machine.chain;
    struct vec3 a = chain->tool;
    for (int i = chain->n - 1; i >= 0; i--)
        a = rodrigues(a, chain->rotary[i].axis, q[i]);
    return a;
}

struct vec3 bench_tip(const struct bench *bench, const struct nc_move *move)
{
    if (bench->planner.follow.mode != INTERPOLATE_JOINT)
        return move->p;
    return chain_tip(&bench->machine.chain, move->p, move->q);
}

void bench_begin(struct bench *bench, int kind, enum interpolation_mode mode, struct vec3 tip,
                 const double q[])
{
    struct machine *m = &bench->machine;
    struct nc_planner *planner = &bench->planner;
    *bench = (struct bench){.path = {.name = "bench"}};
    *m = machine_default();
    machine_finish(m, &bench->error);
    m->chain = chain_of(kind);
    m->letter[0] = MACHINE_C;
    m->letter[1] = MACHINE_A;
    for (int i = 0; i < ROTARY_MAX; i++) {
        m->chain.rotary[i].min = -3 * PI;
        m->chain.rotary[i].max = 3 * PI;
        m->min[m->letter[i]] = -540;
        m->max[m->letter[i]] = 540;
    }
    bench->plan.ability =
        (struct nc_ability){.mode = mode,
                            .unit = 1,
                            .feed_max = 99999,
                            .digits = {5, 5, 8, 3, 3},
                            .feeds = mode == INTERPOLATE_JOINT ? NC_FEEDS_INVERSE : NC_FEEDS_TIP};
    *planner = (struct nc_planner){.path = &bench->path,
                                   .machine = m,
                                   .base = m,
                                   .own = m,
                                   .plan = &bench->plan,
                                   .follow = {.mode = mode, .chain = &m->chain},
                                   .options = {.feed = 1000, .unit = 1},
                                   .allowed = {0.01, RADIANS(0.1)},
                                   .clearance = NAN,
                                   .near = ik_near_table(&m->chain),
                                   .safe_radius = post_ik_safe_radius(m),
                                   .error = &bench->error};
    planner->state = (struct nc_state){.begun = true,
                                       .pose = {tip, bench_axis(bench, q)},
                                       .off = {NAN, NAN},
                                       .feed = 1000,
                                       .faster = 1};
    struct machine_pose at = post_ik_pose(planner, planner->state.pose, q);
    planner->state.at = at.at;
    planner->state.turned = at.turned;
}

void bench_free(struct bench *bench)
{
    nc_plan_free(&bench->plan);
    array_free(&bench->planner.rewinds);
}
