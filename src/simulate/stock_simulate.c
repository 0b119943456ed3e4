/* stock_simulate - see stock_simulate.h. */
#include "simulate/stock_simulate.h"

#include <stdlib.h>

struct simulation {
    const struct stock_simulate_options *options;
    struct stock *stock;
    struct stock_rest *rest;
    struct stock_simulate *run;
    size_t segment;        /* the next one of options->cut */
    bool cut;              /* the piece before was at feed */
    size_t line;           /* the block that is being cut: it has taken ... */
    double volume, length; /* ... so much over such a length */
};

/* The block is over: was it air? */
static void end_block(struct simulation *s)
{
    if (s->line == 0)
        return;
    struct stock_simulate_pass *pass = &s->run->pass.item[s->run->pass.n - 1];
    pass->blocks++;
    pass->length += s->length;
    if (s->volume <= 0) {
        pass->air++;
        pass->air_length += s->length;
    }
    s->line = 0;
    s->volume = s->length = 0;
}

static void end_pass(struct simulation *s)
{
    end_block(s);
    if (s->cut)
        s->run->pass.item[s->run->pass.n - 1].left = stock_rest_update(s->rest, s->stock);
    s->cut = false;
}

static void run_rapid(struct simulation *s, size_t piece, struct centre_path *path)
{
    const struct stock_simulate_options *options = s->options;
    bool deep = false;
    path->n = 0;
    const struct centre_path_options how = {options->radius, options->flat, NULL};
    centre_path_piece(options->motion, piece, &how, path);
    for (size_t k = 0; k < path->n; k++) {
        struct stock_bite bite =
            stock_capsule(s->stock, path->item[k].a, path->item[k].b, options->radius, 0);
        deep = deep || bite.depth > options->tolerance;
        if (bite.depth > fmax(options->tolerance, s->run->rapid)) {
            s->run->rapid = bite.depth;
            s->run->rapid_piece = piece;
            s->run->rapid_at = bite.at;
        }
    }
    s->run->rapids += deep;
}

static void run_cut(struct simulation *s, size_t piece)
{
    const struct centre_path *cut = s->options->cut;
    if (!s->cut)
        *array_push(&s->run->pass) = (struct stock_simulate_pass){.first = piece};
    struct stock_simulate_pass *pass = &s->run->pass.item[s->run->pass.n - 1];
    if (s->line != s->options->motion->piece.item[piece].line)
        end_block(s);
    s->line = s->options->motion->piece.item[piece].line;
    for (; s->segment < cut->n && cut->item[s->segment].piece == piece; s->segment++) {
        const struct centre_segment *segment = &cut->item[s->segment];
        struct stock_bite bite = stock_capsule(s->stock, segment->a, segment->b, s->options->radius,
                                               (unsigned)s->run->pass.n);
        s->volume += bite.volume;
        s->length += vec_distance(segment->a, segment->b);
        pass->volume += bite.volume;
        if (bite.depth > pass->bite) {
            pass->bite = bite.depth;
            pass->bite_piece = piece;
            pass->bite_at = bite.at;
        }
    }
    s->cut = true;
    pass->last = piece;
}

void stock_simulate_run(const struct stock_simulate_options *options, struct stock *stock,
                        struct stock_rest *rest, struct stock_simulate *run)
{
    struct simulation s = {.options = options, .stock = stock, .rest = rest, .run = run};
    struct centre_path path = {0};
    *run = (struct stock_simulate){.before = stock_volume(stock)};
    for (size_t i = 0; i < options->motion->piece.n; i++) {
        bool fast = options->motion->piece.item[i].rapid;
        if (fast) {
            end_pass(&s);
            run_rapid(&s, i, &path);
        } else {
            run_cut(&s, i);
        }
        if (options->tool)
            holder_collision_piece(options->tool, &run->holder, i);
    }
    end_pass(&s);
    run->after = stock_volume(stock);
    array_free(&path);
}

void stock_simulate_free(struct stock_simulate *run)
{
    array_free(&run->pass);
}
