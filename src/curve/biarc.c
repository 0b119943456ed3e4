/* biarc - see biarc.h. */
#include "curve/biarc.h"

static const double PARALLEL = 1e-12; /* w below this: the tangents are parallel */

/* The rest of the biarc, when its ends, tangents and legs are known. */
static bool complete_biarc(struct vec3 from, struct vec3 t1, struct vec3 to, struct vec3 t3,
                           double a, double b, struct biarc *biarc)
{
    if (!(a > 0 && b > 0 && isfinite(a + b)))
        return false;
    struct vec3 rest = vec_sub(to, from);
    rest = vec_along(vec_along(rest, -a, t1), -b, t3);
    struct vec3 t2 = vec_unit(vec_scale(1 / (a + b), rest));
    if (vec_dot(t2, t2) < 0.5)
        return false;
    struct vec3 joint = vec_along(from, a, vec_add(t1, t2));
    *biarc = (struct biarc){.a = a,
                            .b = b,
                            .joint = joint,
                            .t2 = t2,
                            .first = arc_to(from, t1, joint),
                            .second = arc_to(joint, t2, to)};
    return true;
}

bool biarc_of_ratio(struct vec3 from, struct vec3 t1, struct vec3 to, struct vec3 t3, double ratio,
                    struct biarc *biarc)
{
    struct vec3 s = vec_sub(to, from), dt = vec_sub(t1, t3);
    double s2 = vec_dot(s, s), w = vec_dot(dt, dt) / 2;
    double q = vec_dot(s, t3) + ratio * vec_dot(s, t1);
    double b = s2 / (q + sqrt(q * q + 2 * ratio * w * s2));
    return complete_biarc(from, t1, to, t3, ratio * b, b, biarc);
}

bool biarc_shortest(struct vec3 from, struct vec3 t1, struct vec3 to, struct vec3 t3,
                    struct biarc *biarc)
{
    struct vec3 s = vec_sub(to, from), dt = vec_sub(t1, t3);
    double w = vec_dot(dt, dt) / 2; /* 1 - t1 . t3, exact for small angles too */
    double st1 = vec_dot(s, t1), st3 = vec_dot(s, t3);
    if (w < PARALLEL)
        return biarc_of_ratio(from, t1, to, t3, 1, biarc);
    double u = sqrt(st1 * st3 + w * vec_dot(s, s) / 2);
    return complete_biarc(from, t1, to, t3, (u - st3) / w, (u - st1) / w, biarc);
}
