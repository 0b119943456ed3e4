/* stock_simulate - see stock_simulate.h. */
#include "simulate/stock_simulate.h"

#include <stdlib.h>

struct job {
    const struct stock_simulate_options *setup;
    struct stock *stock;
    struct stock_rest *left;
    struct stock_simulate *run;
    size_t segment;        /* the next one of setup->cut */
    bool cut;              /* the piece before was at feed */
    size_t line;           /* the block that is being cut: it has taken ... */
    double volume, length; /* ... so much on so long a way */
};

/* The block is over: was it air? */
static void end_block(struct job *job)
{
    if (job->line == 0)
        return;
    struct stock_simulate_pass *pass = &job->run->pass.item[job->run->pass.n - 1];
    pass->blocks++;
    pass->length += job->length;
    if (job->volume <= 0) {
        pass->air++;
        pass->air_length += job->length;
    }
    job->line = 0;
    job->volume = job->length = 0;
}

static void end_pass(struct job *job)
{
    end_block(job);
    if (job->cut)
        job->run->pass.item[job->run->pass.n - 1].left = stock_rest_update(job->left, job->stock);
    job->cut = false;
}

static void rapid(struct job *job, size_t piece, struct centre_path *way)
{
    const struct stock_simulate_options *setup = job->setup;
    bool deep = false;
    way->n = 0;
    centre_path_piece(setup->nc_motion, piece, setup->radius, 0, setup->flat, way);
    for (size_t k = 0; k < way->n; k++) {
        struct stock_bite bite =
            stock_capsule(job->stock, way->item[k].a, way->item[k].b, setup->radius, 0);
        deep = deep || bite.depth > setup->tolerance;
        if (bite.depth > fmax(setup->tolerance, job->run->rapid)) {
            job->run->rapid = bite.depth;
            job->run->rapid_piece = piece;
            job->run->rapid_at = bite.at;
        }
    }
    job->run->rapids += deep;
}

static void feed(struct job *job, size_t piece)
{
    const struct centre_path *cut = job->setup->cut;
    if (!job->cut)
        *array_push(&job->run->pass) = (struct stock_simulate_pass){.first = piece};
    struct stock_simulate_pass *pass = &job->run->pass.item[job->run->pass.n - 1];
    if (job->line != job->setup->nc_motion->piece.item[piece].line)
        end_block(job);
    job->line = job->setup->nc_motion->piece.item[piece].line;
    for (; job->segment < cut->n && cut->item[job->segment].piece == piece; job->segment++) {
        const struct centre_segment *s = &cut->item[job->segment];
        struct stock_bite bite =
            stock_capsule(job->stock, s->a, s->b, job->setup->radius, (unsigned)job->run->pass.n);
        job->volume += bite.volume;
        job->length += vec_distance(s->a, s->b);
        pass->volume += bite.volume;
        if (bite.depth > pass->bite) {
            pass->bite = bite.depth;
            pass->bite_piece = piece;
            pass->bite_at = bite.at;
        }
    }
    job->cut = true;
    pass->last = piece;
}

void stock_simulate_run(const struct stock_simulate_options *setup, struct stock *stock,
                        struct stock_rest *left, struct stock_simulate *run)
{
    struct job job = {.setup = setup, .stock = stock, .left = left, .run = run};
    struct centre_path way = {0};
    *run = (struct stock_simulate){.before = stock_volume(stock)};
    for (size_t i = 0; i < setup->nc_motion->piece.n; i++) {
        bool fast = setup->nc_motion->piece.item[i].rapid;
        if (fast) {
            end_pass(&job);
            rapid(&job, i, &way);
        } else {
            feed(&job, i);
        }
        if (setup->way && (fast || !setup->rapids_alone))
            holder_collision_piece(setup->way, i);
    }
    end_pass(&job);
    run->after = stock_volume(stock);
    array_free(&way);
}

void stock_simulate_free(struct stock_simulate *run)
{
    array_free(&run->pass);
}
