/* verdict_map - the deviation on each point as a PLY: see verdict.h. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>

#include "base/num.h"
#include "base/out.h"
#include "verify/verdict.h"

static int mixed(int from, int to, double share)
{
    return (int)lround(from + share * (to - from));
}

struct colour verdict_colour(const struct verdict *v, size_t point)
{
    static const struct colour good = {70, 170, 90}, deep = {220, 30, 30}, high = {40, 90, 220};
    double full = isfinite(v->left) ? v->left : 4 * v->tolerance;
    double deviation = v->roll.deviation[point];
    const struct colour *to = deviation < 0 ? &deep : &high;
    if (!v->roll.region[point])
        return (struct colour){130, 130, 130};
    double share = fmin(1, deviation < 0 ? -deviation / v->tolerance : deviation / full);
    return (struct colour){mixed(good.red, to->red, share), mixed(good.green, to->green, share),
                           mixed(good.blue, to->blue, share)};
}

static void row(struct out *o, const struct verdict *v, size_t i)
{
    struct vec3 p = v->point->item[i];
    struct colour c = verdict_colour(v, i);
    unsigned segment = v->roll.segment[i];
    out_num(o, p.x, 6);
    out_text(o, " ");
    out_num(o, p.y, 6);
    out_text(o, " ");
    out_num(o, p.z, 6);
    out_printf(o, " %d %d %d ", c.red, c.green, c.blue);
    char deviation[NUM_MAX];
    num_write(deviation, v->roll.deviation[i], 6);
    out_printf(o, "%s %d %s %s\n", deviation,
               segment == UINT_MAX ? -1
                                   : v->nc_motion->piece.item[v->cut->item[segment].piece].block,
               deviation, deviation);
}

void verdict_map(const struct verdict *v, const char *file)
{
    struct out *o = out_open(file);
    out_text(o, "ply\nformat ascii 1.0\ncomment deviation: mm, below zero the ball gouged\n");
    out_printf(o, "element vertex %zu\n", v->roll.points);
    out_text(o, "property double x\nproperty double y\nproperty double z\n");
    out_text(o, "property uchar red\nproperty uchar green\nproperty uchar blue\n");
    out_text(o, "property float deviation\nproperty int block\n");
    /* the deviation once more, by the names that MeshLab and CloudCompare take for a scalar */
    out_text(o, "property float quality\nproperty float scalar_deviation\nend_header\n");
    for (size_t i = 0; i < v->roll.points; i++)
        row(o, v, i);
    out_close(o);
}
