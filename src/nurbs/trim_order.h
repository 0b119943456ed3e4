/*
 * trim_order - which way the curves of a loop that is not directed run.
 */
#ifndef CLOUDMILL_TRIM_ORDER_H
#define CLOUDMILL_TRIM_ORDER_H

#include "nurbs/patch.h"

/* The squared distance of two places, in parts of the range. */
double trim_order_square(struct uv a, struct uv b, const struct nurbs *s);

struct vec3 trim_order_end(const struct nurbs_curve *c, bool last);

/* Does curve k run backwards, when the loop has come to `at`?  The first one runs so that its end
 * is near an end of the second. */
bool trim_order_backwards(const struct patch *patch, const struct patch_loop *loop, size_t k,
                          struct vec3 at);

/*
 * The rims of a pipe, joined by its seam, are parts of one loop that begin and end in one place, so
 * that they fit it either way: a file may have both the same way round.  The loop with part `which`
 * of those turned round, from 0; false where there are not so many, or the loop is directed or in
 * the parameters.  The caller frees it (patch_loop_free).
 */
bool trim_order_turned(const struct patch *patch, const struct patch_loop *loop, size_t which,
                       struct patch_loop *turned);

#endif
