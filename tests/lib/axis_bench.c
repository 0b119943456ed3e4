/* axis_bench - see axis_bench.h. */
#include "axis_bench.h"

#include <stdlib.h>

#include "machine/machine.h"

enum { RADIUS = 5 };

void axis_bench_begin(struct axis_bench *bench, double play, double (*lean)(int i))
{
    struct machine machine = machine_default();
    struct vec3s floor = {0};
    struct error error;

    *bench = (struct axis_bench){.run.radius = RADIUS};
    machine_finish(&machine, &error);
    for (int i = -20; i <= 140; i++)
        for (int k = -40; k <= 40; k++)
            *array_push(&floor) = vec(i * 0.25, k * 0.25, 0);
    bench->guard = gouge_new(floor, 1);
    struct axis_planner_options options = {.guard = bench->guard,
                                           .radius = RADIUS,
                                           .holder = {1, {{RADIUS, RADIUS, 30}}},
                                           .chain = machine.chain,
                                           .tolerance = 0.01,
                                           .between = true,
                                           .play = play,
                                           .limit = RADIANS(85)};
    bench->planner = axis_planner_new(&options);
    bench->work = (struct work){.planner = bench->planner,
                                .run = &bench->run,
                                .along = mem_alloc(AXIS_BENCH_POINTS, sizeof(double))};
    for (int i = 0; i < AXIS_BENCH_POINTS; i++) {
        struct run_point p = {.contact = vec(i * 0.5, 0, 0),
                              .normal = vec(0, 0, 1),
                              .ball = vec(i * 0.5, 0, RADIUS),
                              .axis = vec(0, sin(lean(i)), cos(lean(i)))};
        p.tip = vec_along(p.ball, -RADIUS, p.axis);
        *array_push(&bench->run) = p;
        bench->work.along[i] = i * 0.5;
    }
}

void axis_bench_nodes(struct axis_bench *bench)
{
    axis_nodes_first(&bench->work);
    axis_nodes_sort(&bench->work.nodes);
    for (size_t i = 0; i < bench->work.nodes.n; i++)
        axis_nodes_find_open(bench->planner, &bench->work.nodes.item[i]);
}

void axis_bench_free(struct axis_bench *bench)
{
    for (size_t i = 0; i < bench->work.nodes.n; i++)
        free(bench->work.nodes.item[i].state);
    array_free(&bench->work.nodes);
    free(bench->work.along);
    array_free(&bench->run);
    axis_planner_free(bench->planner);
    gouge_free(bench->guard);
}
