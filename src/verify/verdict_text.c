/* verdict_text - the verdict as a table of figures, and as points with colours: see verify.h. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "base/num.h"
#include "base/out.h"
#include "ncread/ncread.h"
#include "verify/verify.h"

enum { WORST_BLOCKS = 5 };

#define FARTHEST 1e6 /* mm: a deviation as a map has it, at most */

static double worst_of(const struct verdict *v, bool gouge, size_t piece)
{
    return gouge ? v->piece[piece].gouge : v->piece[piece].over;
}

size_t verdict_worst(const struct verdict *v, bool gouge, size_t most, size_t *piece)
{
    size_t n = 0;
    for (size_t i = 0; i < v->program.motion->piece.n; i++) {
        double value = worst_of(v, gouge, i);
        if (value <= 0 || (n == most && value <= worst_of(v, gouge, piece[n - 1])))
            continue;
        size_t k = n < most ? n++ : n - 1;
        for (; k > 0 && worst_of(v, gouge, piece[k - 1]) < value; k--)
            piece[k] = piece[k - 1];
        piece[k] = i;
    }
    return n;
}

static void print_program(const struct verdict *v, struct out *o)
{
    const struct nc_motion *c = v->program.motion;
    const struct axis_use *use = &v->axes;
    out_printf(o, "program      %s: %s, %zu lines; %zu straight, %zu arcs, %zu curves\n",
               v->program.file, v->program.control, c->blocks, c->lines, c->arcs, c->curves);
    out_printf(o, "machine      %s\n", v->program.machine);
    out_printf(o, "way          %.1f mm in %u cuts from rapid to rapid, %.1f mm rapid\n",
               use->cut_length, v->passes, use->rapid_length);
    out_printf(o, "time         %.2f min at feed, %.2f min rapid", use->cut_time, use->rapid_time);
    if (c->dwell > 0)
        out_printf(o, ", %.2f min dwell", c->dwell);
    out_text(o, "\n");
}

/* The least time, where it is lost, and how much the rotary axes turn. */
static void print_time(const struct verdict *v, struct out *o)
{
    const struct machine_time *time = &v->time;
    if (!(time->programmed > 0))
        return;
    out_printf(o,
               "least time   %.2f min at feed, %.2f times length by feed (%.2f min); %.1f %% of "
               "the way below half the feed; %.2f min rapid\n",
               time->least, time->least / time->programmed, time->programmed, 100 * time->slow,
               time->rapid);
    for (int k = 3; k < NC_AXES; k++)
        if (time->turn[k] > 0)
            out_printf(o, "turned       %c %.0f degrees in all\n", "XYZABC"[k], time -> turn[k]);
    for (int k = 0; k < MACHINE_TIME_WORST && time->lost[k] > 0; k++) {
        char place[60];
        ncread_place(&v->program.motion->piece.item[time->worst[k]], place, sizeof place);
        out_printf(o, "slow         %.2f s lost in %s\n", time->lost[k], place);
    }
}

static void print_axes(const struct verdict *v, struct out *o)
{
    static const char letter[] = "XYZABC";
    const struct axis_use *use = &v->axes;
    char place[60];
    for (int k = 0; k < NC_AXES; k++)
        if (use->low[k] < use->high[k])
            out_printf(o, "travel %c     %.3f to %.3f\n", letter[k], use->low[k], use->high[k]);
    if (use->jump.value > 0) {
        ncread_place(&v->program.motion->piece.item[use->jump.piece], place, sizeof place);
        out_printf(o, "turn         axis %c by at most %.3f degrees in a block, %s\n",
                   letter[use->jump.axis], use->jump.value, place);
    }
    if (use->turn_rate.value > 0) {
        ncread_place(&v->program.motion->piece.item[use->turn_rate.piece], place, sizeof place);
        out_printf(o, "swing        axis %c by at most %.3f degrees a mm, %s\n",
                   letter[use->turn_rate.axis], use->turn_rate.value, place);
    }
}

static void print_deviation(const struct verdict *v, struct out *o, bool gouge)
{
    const struct deviation_map *r = &v->map;
    const double *part = gouge ? r->gouge_part : r->over_part;
    double worst = gouge ? r->gouge : r->over;
    struct vec3 p = v->program.part->item[gouge ? r->gouge_at : r->over_at];
    size_t piece[WORST_BLOCKS], n = verdict_worst(v, gouge, WORST_BLOCKS, piece);
    const char *name = gouge ? "gouge" : "left ";
    out_printf(o, "%s        worst %.4f mm at %.3f %.3f %.3f\n", name, worst, p.x, p.y, p.z);
    out_printf(o, "%s        50%% %.4f, 95%% %.4f, 99%% %.4f mm; %zu points %s\n", name, part[0],
               part[1], part[2], gouge ? r->gouged : r->left,
               gouge ? "deeper than the tolerance"
                     : "above the tolerance, scallops and what is out of reach too");
    for (size_t i = 0; i < n; i++) {
        char place[60];
        const struct verdict_piece *at = &v->piece[piece[i]];
        ncread_place(&v->program.motion->piece.item[piece[i]], place, sizeof place);
        out_printf(o, "%s        %.4f mm in %s, cut %u\n", name,
                   (double)(gouge ? at->gouge : at->over), place, at->pass);
    }
}

static void print_left(struct out *o, const struct stock_rest_sum *left)
{
    out_printf(o, "left %.4f mm (50%% %.4f, 95%% %.4f, 99%% %.4f)", left->worst, left->part[0],
               left->part[1], left->part[2]);
}

static void print_pass(const struct verdict *v, struct out *o, size_t k)
{
    const struct stock_simulate_pass *pass = &v->stock.pass.item[k];
    const struct nc_piece *piece = v->program.motion->piece.item;
    char first[60], last[60], bite[60];
    ncread_place(&piece[pass->first], first, sizeof first);
    ncread_place(&piece[pass->last], last, sizeof last);
    ncread_place(&piece[pass->bite_piece], bite, sizeof bite);
    out_printf(o, "stock        cut %zu, %s to %s: %.1f mm3 off", k + 1, first, last, pass->volume);
    if (pass->bite > 0)
        out_printf(o, ", bite %.4f mm at %.3f %.3f %.3f in %s", pass->bite, pass->bite_at.x,
                   pass->bite_at.y, pass->bite_at.z, bite);
    out_printf(o, ", air in %zu of %zu blocks (%.1f of %.1f mm), ", pass->air, pass->blocks,
               pass->air_length, pass->length);
    print_left(o, &pass->left);
    out_text(o, "\n");
}

static void print_stock(const struct verdict *v, struct out *o)
{
    const struct stock_simulate *run = &v->stock;
    struct stock_simulate_pass sum = {0};
    for (size_t k = 0; k < run->pass.n; k++) {
        const struct stock_simulate_pass *pass = &run->pass.item[k];
        print_pass(v, o, k);
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
    print_left(o, &sum.left);
    out_printf(o, " at %.3f %.3f %.3f\n", sum.left.at.x, sum.left.at.y, sum.left.at.z);
}

static void print_part(const struct verdict *v, struct out *o)
{
    const struct verify_surface *surface = v->program.surface;
    out_printf(o, "part         %zu points", v->map.points);
    if (v->options.partial || v->cut.n == 0)
        out_printf(o, ", %zu of them in the region cut", v->map.cut);
    else if (v->program.region)
        out_printf(o, ", %zu of them in the region that is to be cut", v->asked);
    if (surface && surface->noise > 0)
        out_printf(o, ", noise %.4f mm", surface->noise);
    if (surface && surface->outliers.n > 0)
        out_printf(o, ", %zu outliers", surface->outliers.n);
    out_text(o, "\n");
}

const char *verdict_class(int class)
{
    static const char *const name[] = {"cut", "out of reach", "left", "kept off"};
    return name[class];
}

static void print_coverage(const struct verdict *v, struct out *o)
{
    for (int k = 0; k < COVERAGE_CLASSES; k++) {
        const struct part_coverage_sum *sum = &v->coverage.sum[k];
        bool beyond = k == COVERAGE_OUT_OF_REACH && v->program.region;
        out_printf(o, "coverage     %s%s %zu points, %.1f mm2", verdict_class(k),
                   beyond ? " or beyond the region" : "", sum->points, sum->area);
        if (k != COVERAGE_CUT && sum->points > 0) {
            struct vec3 p = v->program.part->item[sum->at];
            out_printf(o, ", most %.4f mm at %.3f %.3f %.3f", sum->worst, p.x, p.y, p.z);
        }
        if (k == COVERAGE_CUT)
            out_printf(o, " (within %.4g mm)", v->limit);
        out_text(o, "\n");
    }
}

int verdict_class_of(const struct verdict *v, size_t point)
{
    if (v->coverage.of)
        return v->coverage.of[point];
    if (!v->map.region[point])
        return COVERAGE_OUT_OF_REACH;
    return v->map.deviation[point] > v->limit ? COVERAGE_LEFT : COVERAGE_CUT;
}

void verdict_text(const struct verdict *v, const char *file)
{
    struct out *o = out_open(file);
    print_program(v, o);
    print_time(v, o);
    print_axes(v, o);
    print_part(v, o);
    if (v->coverage.of)
        print_coverage(v, o);
    if (v->map.cut > 0) {
        print_deviation(v, o, true);
        print_deviation(v, o, false);
    }
    if (v->has_stock)
        print_stock(v, o);
    for (size_t i = 0; i < v->finding.n; i++)
        out_printf(o, "%s       %s\n", v->finding.item[i].fault ? "fault " : "notice",
                   v->finding.item[i].text);
    out_printf(o, "verdict      %s\n", verdict_refused(v) ? "refused" : "accepted");
    out_close(o);
}

/* ---- as points */

struct colour {
    int red, green, blue;
};

static int mixed(int from, int to, double share)
{
    return (int)lround(from + share * (to - from));
}

/* Red gouges, green is cut, blue is left; out of reach, or beyond the region, grey. */
static struct colour colour_of(const struct verdict *v, size_t point)
{
    static const struct colour good = {70, 170, 90}, deep = {220, 30, 30}, high = {40, 90, 220};
    double full = isfinite(v->options.left) ? v->options.left : 4 * v->options.tolerance;
    double deviation = v->map.deviation[point];
    const struct colour *to = deviation < 0 ? &deep : &high;
    if (!v->map.region[point] || !isfinite(deviation))
        return (struct colour){130, 130, 130};
    double share = fmin(1, deviation < 0 ? -deviation / v->options.tolerance : deviation / full);
    return (struct colour){mixed(good.red, to->red, share), mixed(good.green, to->green, share),
                           mixed(good.blue, to->blue, share)};
}

static void print_point(struct out *o, const struct verdict *v, size_t i)
{
    struct vec3 p = v->program.part->item[i];
    struct colour c = colour_of(v, i);
    unsigned segment = v->map.segment[i];
    out_num(o, p.x, 6);
    out_text(o, " ");
    out_num(o, p.y, 6);
    out_text(o, " ");
    out_num(o, p.z, 6);
    out_printf(o, " %d %d %d ", c.red, c.green, c.blue);
    char deviation[NUM_MAX];
    num_write(deviation, fmin(v->map.deviation[i], FARTHEST), 6);
    bool timed = segment != UINT_MAX && v->time.share;
    double speed = timed ? (double)v->time.share[v->cut.item[segment].piece] : 1;
    out_printf(
        o, "%s %d %s %s %d %.3f %.3f\n", deviation,
        segment == UINT_MAX ? -1 : v->program.motion->piece.item[v->cut.item[segment].piece].block,
        deviation, deviation, verdict_class_of(v, i), speed, speed);
}

void verdict_map(const struct verdict *v, const char *file)
{
    struct out *o = out_open(file);
    out_text(o, "ply\nformat ascii 1.0\ncomment deviation: mm, below zero the ball gouged\n"
                "comment coverage: 0 cut, 1 out of reach or beyond the region, 2 left, 3 kept off\n"
                "comment speed: mean speed of the block there, by its feed\n");
    out_printf(o, "element vertex %zu\n", v->map.points);
    out_text(o, "property double x\nproperty double y\nproperty double z\n");
    out_text(o, "property uchar red\nproperty uchar green\nproperty uchar blue\n");
    out_text(o, "property float deviation\nproperty int block\n");
    /* the deviation once more, by the names that MeshLab and CloudCompare take for a scalar */
    out_text(o, "property float quality\nproperty float scalar_deviation\n");
    out_text(
        o,
        "property uchar coverage\nproperty float speed\nproperty float scalar_speed\nend_header\n");
    for (size_t i = 0; i < v->map.points; i++)
        print_point(o, v, i);
    out_close(o);
}
