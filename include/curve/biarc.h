/*
 * biarc - two arcs in space with one tangent at their joint, from A with t1 to C with t3.
 *
 * Paper 1, 3.4 and appendix A; Sharrock, Biarcs in three dimensions.  With s = C - A, the control
 * legs a and b: C - A = a t1 + (a + b) t2 + b t3, the joint B = A + a (t1 + t2) (A.2 to A.5).
 * Any ratio a / b gives a biarc.
 */
#ifndef CLOUDMILL_BIARC_H
#define CLOUDMILL_BIARC_H

#include <stdbool.h>

#include "curve/arc.h"

struct biarc {
    double a, b;           /* the legs, mm, both positive */
    struct vec3 joint, t2; /* B and the unit tangent there */
    struct arc first, second;
};

/* The biarc with a / b = ratio.  False when it is none: A = C, or no finite positive legs. */
bool biarc_of_ratio(struct vec3 from, struct vec3 t1, struct vec3 to, struct vec3 t3, double ratio,
                    struct biarc *biarc);

/*
 * The biarc with the least a + b, as the paper has it: a = (u - s . t3) / w, b = (u - s . t1) / w,
 * u^2 = (s . t1)(s . t3) + w s^2 / 2, w = 1 - t1 . t3 (the paper's print lacks the brackets, and
 * its A.8 has s^2 (t1 . t3) for (s . t1)(s . t3)).  For parallel tangents, w = 0, it is a = b.
 * False when it is none; then the legs are infinite or negative.
 */
bool biarc_shortest(struct vec3 from, struct vec3 t1, struct vec3 to, struct vec3 t3,
                    struct biarc *biarc);

#endif
