/*
 * verifyrun - what ncverify does with a program: the ball, shank and holder moved along it, over
 * the part and through the stock.
 */
#ifndef CLOUDMILL_VERIFYRUN_H
#define CLOUDMILL_VERIFYRUN_H

#include "simulate/stock_init.h"
#include "verify/verdict.h"

struct verifyrun_setup {
    double band;  /* as of deviation_map, mm */
    double shank; /* length of a shaft as thick as the ball, which rapid moves keep clear, mm */
    const struct holder *holder;    /* NULL: that shaft alone */
    const struct stock_spec *stock; /* NULL: none */
    double cell;                    /* of the stock, mm; 0: by its size */
    int threads;
};

/* What the verdict points at. */
struct verifyrun {
    struct centre_path cut;
    struct holder shape;
    struct holder_collision part, stock;
    struct stock_simulate run;
};

/* Fills what the verdict is judged by; its nc_motion, points, radius and tolerance are given. */
void verifyrun_do(const struct verifyrun_setup *setup, struct verifyrun *run,
                  struct verdict *verdict);

void verifyrun_free(struct verifyrun *run);

#endif
