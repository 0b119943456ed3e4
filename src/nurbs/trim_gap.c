/* trim_gap - see trim_gap.h. */
#include "trim_gap.h"

#include "trim_order.h"

/* By the length of the loop.  In the files that were at hand curves meet within 2e-6 of it. */
static const double OPEN = 1e-4;

/* A place of a curve of the loop, in space. */
static struct vec3 in_space(const struct patch_loop *loop, const struct pullback *on,
                            struct vec3 at)
{
    return loop->space ? at : pullback_point(on, (struct uv){at.x, at.y});
}

static double length_of(const struct pullback *on, const struct uvs *followed)
{
    double length = 0;

    for (size_t i = 1; i < followed->n; i++)
        length += vec_distance(pullback_point(on, followed->item[i - 1]),
                               pullback_point(on, followed->item[i]));
    return length;
}

double trim_gap(const struct patch *patch, const struct patch_loop *loop, const struct pullback *on,
                const struct uvs *followed, struct vec3 *at)
{
    struct vec3 begin = {0, 0, 0}, came = {0, 0, 0};
    double most = 0;

    for (size_t k = 0; k <= loop->n && loop->n > 0; k++) {
        struct vec3 goes = begin;
        bool backwards = k < loop->n && trim_order_backwards(patch, loop, k, came);
        if (k < loop->n)
            goes = trim_order_end(&loop->item[k], backwards);
        struct vec3 a = in_space(loop, on, k > 0 ? came : goes), b = in_space(loop, on, goes);
        if (vec_distance(a, b) > most) {
            most = vec_distance(a, b);
            *at = vec_mix(a, b, 0.5);
        }
        begin = k == 0 ? goes : begin;
        if (k < loop->n)
            came = trim_order_end(&loop->item[k], !backwards);
    }
    return most > OPEN * length_of(on, followed) ? most : 0;
}
