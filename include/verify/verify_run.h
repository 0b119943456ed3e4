/*
 * verify_run - what ncverify does with a program: the ball, shank and holder moved along it, over
 * the part and through the stock.
 */
#ifndef CLOUDMILL_VERIFY_RUN_H
#define CLOUDMILL_VERIFY_RUN_H

#include "simulate/stock_init.h"
#include "verify/verdict.h"

struct verify_run_options {
    double band;  /* as of deviation_map, mm */
    double shank; /* length of a shaft as thick as the ball, which rapid moves keep clear, mm */
    const struct holder *holder;       /* NULL: that shaft alone */
    const struct stock_options *stock; /* NULL: none */
    double cell;                       /* of the stock, mm; 0: by its size */
    int threads;
};

/* What the verdict points at. */
struct verify_run {
    struct centre_path cut;
    struct holder shape;
    struct holder_collision part, stock;
    struct stock_simulate run;
};

/* Fills what the verdict is judged by; its nc_motion, points, radius and tolerance are given. */
void verify_run_do(const struct verify_run_options *setup, struct verify_run *run,
                   struct verdict *verdict);

void verify_run_free(struct verify_run *run);

#endif
