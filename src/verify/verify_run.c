/* verify_run - see verify_run.h. */
#include "verify/verify_run.h"

#include <stdlib.h>

#define FLAT 0.0002 /* how straight the ball's way is between two places, mm */

/* The deepest that the ball, or the shaft over it, goes into the part in a rapid move. */
static void roll_rapids(const struct verify_run_options *s, struct verdict *v)
{
    struct centre_path rapid = {0};
    struct deviation_map roll;
    centre_path_rapid(v->nc_motion, v->radius, s->holder ? 0 : s->shank, FLAT, &rapid);
    struct deviation_map_options setup = {v->radius, v->tolerance, -v->tolerance, s->threads};
    deviation_map_run(&rapid, v->point->item, v->point->n, &setup, &roll);
    if (roll.gouged > 0) {
        v->rapid = roll.gouge;
        v->rapid_points = roll.gouged;
        v->rapid_at = roll.gouge_at;
        v->rapid_piece = rapid.item[roll.segment[roll.gouge_at]].piece;
    }
    deviation_map_free(&roll);
    array_free(&rapid);
}

static struct holder_collision way_of(const struct verdict *v, const struct holder *holder,
                                      struct collision_body *obstacle)
{
    return (struct holder_collision){.nc_motion = v->nc_motion,
                                     .holder = holder,
                                     .obstacle = obstacle,
                                     .radius = v->radius,
                                     .tolerance = v->tolerance};
}

static void interpolation_holder(const struct verify_run_options *s, struct verify_run *run,
                                 struct verdict *v)
{
    struct collision_body part = collision_body_points(v->point->item, v->point->n);
    run->part = way_of(v, s->holder, &part);
    for (size_t i = 0; i < v->nc_motion->piece.n; i++)
        holder_collision_piece(&run->part, i);
    collision_body_free(&part);
    v->holder = &run->part;
}

static void cut_stock(const struct verify_run_options *s, struct verify_run *run, struct verdict *v)
{
    const struct vec3 *point = v->point->item;
    size_t n = v->point->n;
    v->cell = s->cell > 0 ? s->cell : stock_init_cell(s->stock, point, n, v->radius);
    struct stock stock = stock_init_new(s->stock, point, n, v->cell);
    struct stock_rest left = stock_rest_new(point, n, &stock);
    struct collision_body block = collision_body_stock(&stock);
    run->stock = way_of(v, s->holder ? s->holder : &run->shape, &block);
    const struct stock_simulate_options setup = {v->nc_motion, v->cut,      v->radius, FLAT,
                                                 v->tolerance, &run->stock, !s->holder};
    stock_simulate_run(&setup, &stock, &left, &run->run);
    v->stock = &run->run;
    v->stock_holder = &run->stock;
    collision_body_free(&block);
    stock_rest_free(&left);
    stock_free(&stock);
}

void verify_run_do(const struct verify_run_options *s, struct verify_run *run, struct verdict *v)
{
    *run = (struct verify_run){.shape = {s->shank > 0, {{v->radius, v->radius, s->shank}}}};
    centre_path_cut(v->nc_motion, v->radius, FLAT, &run->cut);
    v->cut = &run->cut;
    struct deviation_map_options setup = {v->radius, v->tolerance, s->band, s->threads};
    deviation_map_run(&run->cut, v->point->item, v->point->n, &setup, &v->roll);
    roll_rapids(s, v);
    if (s->holder)
        interpolation_holder(s, run, v);
    if (s->stock)
        cut_stock(s, run, v);
}

void verify_run_free(struct verify_run *run)
{
    array_free(&run->cut);
    stock_simulate_free(&run->run);
}
