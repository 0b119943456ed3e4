/* verdict_stock - what the stock says: see verdict.h. */
#include "base/out.h"
#include "verify/verdict.h"

static void put_left(struct out *o, const struct stock_rest_sum *left)
{
    out_printf(o, "left %.4f mm (50%% %.4f, 95%% %.4f, 99%% %.4f)", left->worst, left->part[0],
               left->part[1], left->part[2]);
}

static void put_pass(const struct verdict *v, struct out *o, size_t k)
{
    const struct stock_simulate_pass *pass = &v->stock->pass.item[k];
    const struct nc_piece *piece = v->nc_motion->piece.item;
    char first[60], last[60], bite[60];
    ncread_place(&piece[pass->first], first, sizeof first);
    ncread_place(&piece[pass->last], last, sizeof last);
    ncread_place(&piece[pass->bite_piece], bite, sizeof bite);
    out_printf(o, "stock        pass %zu, %s to %s: %.1f mm3 off", k + 1, first, last,
               pass->volume);
    if (pass->bite > 0)
        out_printf(o, ", bite %.4f mm at %.3f %.3f %.3f in %s", pass->bite, pass->bite_at.x,
                   pass->bite_at.y, pass->bite_at.z, bite);
    out_printf(o, ", air in %zu of %zu blocks (%.1f of %.1f mm), ", pass->air, pass->blocks,
               pass->air_length, pass->length);
    put_left(o, &pass->left);
    out_text(o, "\n");
}

void verdict_stock(const struct verdict *v, struct out *o)
{
    const struct stock_simulate *run = v->stock;
    struct stock_simulate_pass sum = {0};
    for (size_t k = 0; k < run->pass.n; k++) {
        const struct stock_simulate_pass *pass = &run->pass.item[k];
        put_pass(v, o, k);
        sum.air += pass->air;
        sum.blocks += pass->blocks;
        sum.air_length += pass->air_length;
        sum.length += pass->length;
        sum.left = pass->left;
    }
    out_printf(o, "stock        %.1f mm3, %.1f left; columns %.3f mm apart\n", run->before,
               run->after, v->cell);
    out_printf(o, "stock        air in %zu of %zu blocks (%.1f of %.1f mm)\n", sum.air, sum.blocks,
               sum.air_length, sum.length);
    if (run->pass.n == 0)
        return;
    out_text(o, "stock        ");
    put_left(o, &sum.left);
    out_printf(o, " at %.3f %.3f %.3f\n", sum.left.at.x, sum.left.at.y, sum.left.at.z);
}
