/* verify_run - a program run over the part and the stock: see verify.h. */
#include <stdint.h>
#include <stdlib.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/aside.h"
#include "cloud/judged_scan.h"
#include "math/box.h"
#include "math/kdtree.h"
#include "verify_judge.h"

#define FLAT 0.0002 /* mm: how straight the ball's centre goes between two places */
#define SURE 0.5    /* of what rows may leave: a ball that could cut leaves no more */
#define SIGMAS 1.5  /* of the noise, that are allowed besides the tolerance and what may be left */
#define STEEP 1.0   /* of the points' spacing: so far a steep flank may be behind its facets */
#define UNDER 0.1   /* of the radius: less than that and the points' spacing is beside a scan */

/* ---- what the program does */

/* Outliers, beside the verdict. */
static void roll_outliers(struct verdict *v)
{
    const struct verify_options *o = &v->options;
    const struct vec3s *outliers = &v->program.surface->outliers;
    struct deviation_map_options options = {o->radius, o->tolerance + v->noise, 0, o->threads, true,
                                            HUGE_VAL};
    struct deviation_map map;
    deviation_map_run(&v->cut, outliers->item, outliers->n, &options, &map);
    v->outliers = (struct verdict_outliers){outliers->n, map.gouged, map.gouge, {0, 0, 0}};
    if (map.gouged > 0)
        v->outliers.at = outliers->item[map.gouge_at];
    deviation_map_free(&map);
}

/* Between the points of steep flanks, which are far apart. */
static void roll_steep(struct verdict *v)
{
    const struct verify_options *o = &v->options;
    const struct vec3s *place = &v->program.surface->steep;
    double known = STEEP * v->program.surface->spacing;
    struct deviation_map_options options = {
        o->radius, o->tolerance + v->noise + known, 0, o->threads, true, HUGE_VAL};
    struct deviation_map map;
    if (place->n == 0 || v->cut.n == 0)
        return;
    deviation_map_run(&v->cut, place->item, place->n, &options, &map);
    if (map.gouged > 0)
        v->steep = (struct verdict_steep){map.gouge, map.gouged,
                                          v->cut.item[map.segment[map.gouge_at]].piece,
                                          place->item[map.gouge_at]};
    deviation_map_free(&map);
}

/* So near a ball has to come that could cut a point: by what stages after the rows may leave, no
 * point is nearer. */
static double near_of(const struct verdict *v)
{
    const struct verify_options *o = &v->options;
    double rows = isfinite(o->left) ? v->limit - o->left + fmin(o->rows, o->left) : v->limit;

    return SURE * rows;
}

/* Which points are cut, out of reach (also those `beside`, NULL: none), or left by so much, with a
 * curtain in the way; `each` of them looked at, or as many as tell of those beside them. */
static void cover_points(const struct verdict *v, const double *left, const unsigned char *beside,
                         const struct vec3s *curtain, bool each, struct part_coverage *coverage)
{
    const struct verify_options *o = &v->options;
    const struct vec3s *part = v->program.part;
    const struct verify_surface *surface = v->program.surface;
    struct vec3s axis = part_coverage_axes(&v->program.motion->kinematics);
    const struct part_coverage_options reach = {.radius = o->radius,
                                                .limit = v->limit,
                                                .near = near_of(v),
                                                .tool = &o->tool,
                                                .axis = &axis,
                                                .curtain = curtain,
                                                .whole = !surface,
                                                .left_only = each,
                                                .threads = o->threads};

    if (!beside && surface)
        beside = surface->under;
    part_coverage_run(part->item, left, beside, part->n, &reach, coverage);
    array_free(&axis);
}

static const struct vec3s *curtain_of(const struct verdict *v)
{
    return v->program.surface ? &v->program.surface->curtain : NULL;
}

/* Of the points that are left those that the tool reaches only if nothing goes on, unseen, between
 * points: counted where so many may be left with these, and not without. */
static void count_unseen(struct verdict *v, const unsigned char *beside)
{
    const struct verify_surface *surface = v->program.surface;
    size_t n = v->program.part->n, found = v->coverage.sum[COVERAGE_LEFT].points;
    size_t may = verify_may_be_left(v);
    struct part_coverage coverage;
    struct vec3s solid = {0};

    if (!surface || found <= may || found > JUDGED_SCAN_UNSEEN * may)
        return;
    double *left = mem_alloc(n, sizeof *left);
    for (size_t i = 0; i < n; i++)
        left[i] = v->coverage.of[i] == COVERAGE_LEFT ? v->map.deviation[i] : 0;
    vec3s_add(&solid, surface->curtain.item, surface->curtain.n);
    verify_surface_unseen(surface, v->options.radius, v->options.threads, &solid);
    cover_points(v, left, beside, &solid, true, &coverage);
    v->unseen = found - coverage.sum[COVERAGE_LEFT].points;
    part_coverage_free(&coverage);
    array_free(&solid);
    free(left);
}

static bool is_reached(const struct part_coverage *coverage, size_t i)
{
    return coverage->of[i] == COVERAGE_CUT || coverage->of[i] == COVERAGE_LEFT;
}

/* Of the region cut: points that no ball and tool reach are none of it. */
static void leave_out_of_reach(struct verdict *v)
{
    size_t n = v->program.part->n;
    double *left = mem_alloc(n, sizeof *left);
    struct part_coverage coverage;
    for (size_t i = 0; i < n; i++)
        left[i] = v->map.region[i] ? v->map.deviation[i] : 0;
    cover_points(v, left, NULL, curtain_of(v), false, &coverage);
    for (size_t i = 0; i < n; i++)
        v->map.region[i] = v->map.region[i] && is_reached(&coverage, i);
    part_coverage_free(&coverage);
    free(left);
}

/* 1 of each point that is not asked for, or under a roof; counts the points of the region. */
static unsigned char *beside_region(struct verdict *v)
{
    const struct verify_surface *surface = v->program.surface;
    const struct vec3s *part = v->program.part;
    unsigned char *beside = mem_alloc(part->n + 1, 1);

    v->asked = 0;
    for (size_t i = 0; i < part->n; i++) {
        bool in = region_holds(v->program.region, part->item[i]);
        beside[i] = !in || (surface && surface->under && surface->under[i]);
        v->asked += in;
    }
    return beside;
}

/* The ball over all points; which of them are cut, out of reach, or left. */
static void roll_cuts(struct verdict *v)
{
    const struct verify_options *o = &v->options;
    const struct vec3s *part = v->program.part;
    struct deviation_map_options roll = {o->radius, o->tolerance + v->noise, o->band, o->threads,
                                         false,     o->left + v->noise};
    deviation_map_run(&v->cut, part->item, part->n, &roll, &v->map);
    if (v->program.surface) {
        roll_outliers(v);
        roll_steep(v);
    }
    if (v->cut.n == 0)
        return;
    if (o->partial) {
        leave_out_of_reach(v);
    } else {
        unsigned char *beside = v->program.region ? beside_region(v) : NULL;
        cover_points(v, v->map.deviation, beside, curtain_of(v), false, &v->coverage);
        count_unseen(v, beside);
        free(beside);
        for (size_t i = 0; i < part->n; i++)
            v->map.region[i] = is_reached(&v->coverage, i);
    }
    deviation_map_sum(&roll, &v->map);
}

/* The deepest that the ball goes into the part in a rapid move. */
static void roll_rapids(struct verdict *v, const struct centre_path_options *how)
{
    const struct verify_options *o = &v->options;
    const struct vec3s *part = v->program.part;
    struct centre_path rapid = {0};
    struct deviation_map map;
    centre_path_rapid(v->program.motion, how, &rapid);
    struct deviation_map_options options = {o->radius, o->tolerance + v->noise, 0, o->threads, true,
                                            HUGE_VAL};
    deviation_map_run(&rapid, part->item, part->n, &options, &map);
    if (map.gouged > 0)
        v->rapid = (struct verdict_rapid){map.gouge, map.gouged, map.gouge_at,
                                          rapid.item[map.segment[map.gouge_at]].piece};
    deviation_map_free(&map);
    array_free(&rapid);
}

static struct holder_collision_options along_program(const struct verdict *v,
                                                     struct collision_body *body)
{
    return (struct holder_collision_options){.motion = v->program.motion,
                                             .tool = &v->options.tool,
                                             .body = body,
                                             .radius = v->options.radius,
                                             .tolerance = v->options.tolerance + v->noise};
}

static void follow_tool(struct verdict *v)
{
    struct collision_body part = collision_body_points(v->program.part->item, v->program.part->n);
    struct holder_collision_options options = along_program(v, &part);
    v->part_holder = holder_collision_all(&options, v->options.threads);
    collision_body_free(&part);
}

/* Roof no higher than that. */
static struct vec3s low_roof(const struct vec3s *roof, double z)
{
    struct vec3s low = {0};

    for (size_t i = 0; i < roof->n; i++)
        if (roof->item[i].z <= z)
            *array_push(&low) = roof->item[i];
    return low;
}

/* Where no point of the scan stands for the material below it: down to its lowest point, and below
 * roof that is no higher than a radius above that, all the way. */
static void look_under(struct verdict *v)
{
    const struct verify_options *o = &v->options;
    const struct vec3s *roof = &v->program.surface->roof;
    double known = UNDER * o->radius + v->program.surface->spacing;
    const struct vec3s *part = v->program.part;
    struct under_scan_options options = {v->program.motion,
                                         &o->tool,
                                         o->radius,
                                         fmax(o->tolerance + v->noise, known),
                                         box_around(part->item, part->n).low.z,
                                         o->threads};
    struct vec3s low = low_roof(roof, options.bottom + o->radius);

    v->under = under_scan_find(&options, roof->item, roof->n);
    options.bottom = -HUGE_VAL;
    struct under_scan deeper = under_scan_find(&options, low.item, low.n);
    size_t pieces = v->under.pieces > deeper.pieces ? v->under.pieces : deeper.pieces;
    if (deeper.depth > v->under.depth)
        v->under = deeper;
    v->under.pieces = pieces;
    array_free(&low);
}

static void cut_stock(struct verdict *v)
{
    const struct verify_options *o = &v->options;
    const struct vec3 *point = v->program.part->item;
    size_t n = v->program.part->n;
    v->cell = o->cell > 0 ? o->cell : stock_cell(o->stock, point, n, o->radius);
    struct stock stock = stock_new(o->stock, point, n, v->cell);
    struct stock_rest rest = stock_rest_new(point, n, &stock);
    struct collision_body block = collision_body_stock(&stock);
    struct holder_collision_options tool = along_program(v, &block);
    const struct stock_simulate_options options = {
        v->program.motion, &v->cut, o->radius, FLAT, o->tolerance, o->tool.n > 0 ? &tool : NULL};
    stock_simulate_run(&options, &stock, &rest, &v->stock);
    v->has_stock = true;
    collision_body_free(&block);
    stock_rest_free(&rest);
    stock_free(&stock);
}

/* What all axes do, and how long it takes: of the program alone, so that it may be reckoned beside
 * the rest. */
static void follow_axes(void *context)
{
    struct verdict *v = context;
    const struct nc_motion *motion = v->program.motion;
    struct machine_time_options time = v->options.time;

    v->axes = axis_limits_check(motion, &v->options.limits);
    time.limits = &v->options.limits;
    if (time.acceleration[0] > 0)
        v->time = machine_time_of(motion, &time);
}

struct verdict verify_run(const struct verify_program *program,
                          const struct verify_options *options)
{
    struct verdict v = {.program = *program, .options = *options, .asked = program->part->n};
    if (!options->partial)
        v.program.region = NULL;
    if (v.program.region) /* what is to be cut is known, and judged as if it were all */
        v.options.partial = false;
    v.noise = program->surface ? SIGMAS * program->surface->noise : 0;
    v.limit = ROUNDED + v.noise +
              (isfinite(options->left) ? options->left : fmax(options->told, options->tolerance));
    struct aside *aside = aside_begin(options->threads);
    aside_do(aside, follow_axes, &v);
    const struct box around = box_around(program->part->item, program->part->n);
    const struct centre_path_options how = {options->radius, FLAT, &around};
    centre_path_cut(program->motion, &how, &v.cut);
    roll_cuts(&v);
    roll_rapids(&v, &how);
    if (options->tool.n > 0)
        follow_tool(&v);
    if (program->surface)
        look_under(&v);
    if (options->stock)
        cut_stock(&v);
    aside_end(aside);
    verify_judge(&v);
    return v;
}

bool verdict_refused(const struct verdict *v)
{
    for (size_t i = 0; i < v->finding.n; i++)
        if (v->finding.item[i].fault)
            return true;
    return false;
}

void verdict_free(struct verdict *v)
{
    array_free(&v->cut);
    deviation_map_free(&v->map);
    part_coverage_free(&v->coverage);
    machine_time_free(&v->time);
    stock_simulate_free(&v->stock);
    free(v->piece);
    array_free(&v->finding);
}
