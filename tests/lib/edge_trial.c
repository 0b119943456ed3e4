/* edge_trial - see edge_trial.h. */
#include "edge_trial.h"

#include <check.h>
#include <stdlib.h>

#include "cloud/scan_lines.h"
#include "noisy.h"

double edge_trial_side(double x, double y)
{
    return (4 * y - x) / sqrt(17);
}

double edge_trial_roof(double x, double y)
{
    return 10 - fabs(edge_trial_side(x, y));
}

void edge_trial_of(struct edge_trial *trial, struct vec3s scan, double spacing, double sigma)
{
    size_t n = scan.n;
    struct error error;

    *trial =
        (struct edge_trial){.scan = scan, .options = {.along = 0.2, .sink = 0.002, .noise = sigma}};
    ck_assert_int_eq(point_grid_make(scan.item, n, spacing, 1, &trial->grid, &error), 0);
    trial->options.point_grid = &trial->grid;
    trial->options.threads = 1;
    trial->work = (struct edge_work){.options = &trial->options,
                                     .lines = scan_lines_found(&trial->grid),
                                     .flank = mem_alloc(n, sizeof *trial->work.flank),
                                     .chosen = mem_alloc(n, sizeof *trial->work.chosen),
                                     .found = mem_alloc(n, sizeof *trial->work.found),
                                     .gap = mem_alloc(n, sizeof *trial->work.gap)};
    for (size_t i = 0; i < n; i++) {
        trial->work.flank[i] = (struct edge_flank){.valid = false};
        trial->work.found[i] = (struct vec3s){0};
        trial->work.gap[i] = 0;
    }
}

void edge_trial_make(struct edge_trial *trial, double (*height)(double x, double y), bool lines,
                     double sigma)
{
    double along = lines ? 0.2 : 0.5, across = lines ? 0.8 : 0.5;
    struct vec3s scan = {0};

    noisy_seed(11);
    for (double y = -10; y < 10; y += across)
        for (double x = -10; x < 10; x += along)
            *array_push(&scan) = vec(x, y, height(x, y) + sigma * noisy_normal());
    edge_trial_of(trial, scan, sqrt(along * across), sigma);
    ck_assert(trial->work.lines == lines);
}

void edge_trial_free(struct edge_trial *trial)
{
    for (size_t i = 0; i < trial->grid.n; i++)
        array_free(&trial->work.found[i]);
    free(trial->work.found);
    free(trial->work.gap);
    if (trial->work.chosen != trial->work.flank) /* it takes its place where flanks are chosen */
        free(trial->work.chosen);
    free(trial->work.flank);
    point_grid_free(&trial->grid);
    array_free(&trial->scan);
}
