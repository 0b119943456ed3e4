/* verifyrun - see verifyrun.h. */
#include "verify/verifyrun.h"

#include <stdlib.h>

#define FLAT 0.0002 /* how straight the ball's way is between two places, mm */

/* The deepest that the ball, or the shaft over it, goes into the part in a rapid move. */
static void roll_rapids(const struct verifyrun_setup *s, struct verdict *v)
{
    struct ball_path rapid = {0};
    struct ballroll roll;
    ballpath_rapid(v->course, v->radius, s->holder ? 0 : s->shank, FLAT, &rapid);
    struct ballroll_setup setup = {v->radius, v->tolerance, -v->tolerance, s->threads};
    ballroll_run(&rapid, v->point->item, v->point->n, &setup, &roll);
    if (roll.gouged > 0) {
        v->rapid = roll.gouge;
        v->rapid_points = roll.gouged;
        v->rapid_at = roll.gouge_at;
        v->rapid_piece = rapid.item[roll.segment[roll.gouge_at]].piece;
    }
    ballroll_free(&roll);
    array_free(&rapid);
}

static struct holderway way_of(const struct verdict *v, const struct holder *holder,
                               struct obstacle *obstacle)
{
    return (struct holderway){.course = v->course,
                              .holder = holder,
                              .obstacle = obstacle,
                              .radius = v->radius,
                              .tolerance = v->tolerance};
}

static void follow_holder(const struct verifyrun_setup *s, struct verifyrun *run, struct verdict *v)
{
    struct obstacle part = obstacle_points(v->point->item, v->point->n);
    run->part = way_of(v, s->holder, &part);
    for (size_t i = 0; i < v->course->piece.n; i++)
        holderway_piece(&run->part, i);
    obstacle_free(&part);
    v->holder = &run->part;
}

static void cut_stock(const struct verifyrun_setup *s, struct verifyrun *run, struct verdict *v)
{
    const struct vec3 *point = v->point->item;
    size_t n = v->point->n;
    v->cell = s->cell > 0 ? s->cell : stockpart_cell(s->stock, point, n, v->radius);
    struct stock stock = stockpart_new(s->stock, point, n, v->cell);
    struct stockleft left = stockleft_new(point, n, &stock);
    struct obstacle block = obstacle_stock(&stock);
    run->stock = way_of(v, s->holder ? s->holder : &run->shape, &block);
    const struct stockrun_setup setup = {v->course,    v->cut,      v->radius, FLAT,
                                         v->tolerance, &run->stock, !s->holder};
    stockrun_run(&setup, &stock, &left, &run->run);
    v->stock = &run->run;
    v->stock_holder = &run->stock;
    obstacle_free(&block);
    stockleft_free(&left);
    stock_free(&stock);
}

void verifyrun_do(const struct verifyrun_setup *s, struct verifyrun *run, struct verdict *v)
{
    *run = (struct verifyrun){.shape = {s->shank > 0, {{v->radius, v->radius, s->shank}}}};
    ballpath_cut(v->course, v->radius, FLAT, &run->cut);
    v->cut = &run->cut;
    struct ballroll_setup setup = {v->radius, v->tolerance, s->band, s->threads};
    ballroll_run(&run->cut, v->point->item, v->point->n, &setup, &v->roll);
    roll_rapids(s, v);
    if (s->holder)
        follow_holder(s, run, v);
    if (s->stock)
        cut_stock(s, run, v);
}

void verifyrun_free(struct verifyrun *run)
{
    array_free(&run->cut);
    stockrun_free(&run->run);
}
