/* toolpath - see toolpath.h. */
#include "stage/toolpath.h"

#include <stdio.h>
#include <stdlib.h>

#include "base/cli.h"
#include "base/parallel.h"
#include "gouge/axis_plan.h"
#include "toolpath_parts.h"

/* Radii of the ball: a link with the tool down is no longer; a retract takes less time. */
static const double LONGEST = 6;

void toolpath_strip(struct toolpath *t, size_t pass, const struct contact *contact, size_t n,
                    struct vec3 along)
{
    struct toolpath_strip strip = {.pass = pass, .rest = t->rest, .lift = t->lift};

    strip.lift.feed.along = along;
    if (t->rest) /* cuts what others left, to the last of it */
        strip.lift.aside = strip.lift.even = 0;
    array_reserve(&strip.contact, n);
    for (size_t i = 0; i < n; i++)
        *array_push(&strip.contact) = contact[i];
    *array_push(&t->strip) = strip;
}

int toolpath_length_bounded(double length, double radius, const char *said, struct error *error)
{
    const double most = 5e5 * radius;

    if (length <= most)
        return 0;
    return error_set(error,
                     "would cut %s, expected at most %.0f m with a ball of radius %g: is the unit "
                     "of the part right? A larger ball, rows farther apart or a part of the mesh "
                     "make less",
                     said, most / 1e3, radius);
}

int toolpath_bounded(const struct toolpath *t, int layers, struct error *error)
{
    const double usual = 2e4; /* radii: what is beyond is said before it takes its time */
    double length = 0;
    char said[400];

    for (size_t k = 0; k < t->strip.n; k++) {
        const struct contact *c = t->strip.item[k].contact.item;
        for (size_t i = 1; i < t->strip.item[k].contact.n; i++)
            length += vec_distance(c[i - 1].p, c[i].p);
    }
    length *= layers;
    snprintf(said, sizeof said, "%.0f m in %zu strips", length / 1e3, t->strip.n * (size_t)layers);
    if (toolpath_length_bounded(length, t->rule.radius, said, error) != 0)
        return -1;
    if (length > usual * t->rule.radius)
        say("%s, much for a ball of radius %g: they are lifted, given axes and joined, which takes "
            "as much longer; a larger ball, higher scallops or a part of the mesh make less",
            said, t->rule.radius);
    return 0;
}

struct link_options toolpath_link_options(const struct toolpath *t)
{
    return (struct link_options){.lift = &t->lift,
                                 .holder = &t->rule.holder,
                                 .radius = t->rule.radius,
                                 .limit = fmax(t->rule.radius, t->rule.longest),
                                 .longest = fmax(t->rule.longest, LONGEST * t->rule.radius),
                                 .rate = t->rule.rate,
                                 .frame = vec_length(t->frame.pole) > 0 ? &t->frame : NULL,
                                 .chain = &t->rule.chain,
                                 .clearance = t->rule.clearance,
                                 .floor = t->rule.floor,
                                 .approach = t->rule.approach};
}

/* ---- ways between parts and the clearance plane */

/* The point of the run nearest to its end (or start) from which a way leads up: looked for at
 * distances along the run that are doubled. */
static struct toolpath_way find_way(const struct toolpath *t, const struct run *run, bool from_end)
{
    struct link_options options = toolpath_link_options(t);
    double along = 0, next = 0;

    for (size_t i = 0; i < run->n; i++) {
        size_t k = from_end ? run->n - 1 - i : i;
        if (i > 0)
            along += vec_distance(run->item[k].ball, run->item[from_end ? k + 1 : k - 1].ball);
        if (along < next && i + 1 < run->n)
            continue;
        struct toolpath_way way = {k, link_retract(&options, &run->item[k])};
        if (way.retract.clear)
            return way;
        next = fmax(t->rule.radius / 2, 2 * along);
    }
    return (struct toolpath_way){.at = run->n};
}

struct way_finder {
    const struct toolpath *t;
    struct toolpath_parts *parts;
};

static void find_ways(void *context, size_t from, size_t to)
{
    const struct way_finder *f = context;

    for (size_t i = from; i < to; i++) {
        struct toolpath_part *part = &f->parts->item[i];
        struct toolpath t = *f->t;
        struct run run = toolpath_part_run(&t, part);
        t.lift = t.strip.item[part->strip].lift;
        part->in = find_way(&t, &run, false);
        part->out = part->in.at < run.n ? find_way(&t, &run, true) : part->in;
    }
}

static void add_report(struct toolpath *t, size_t pass, const struct gouge_lift_report *r)
{
    struct gouge_lift_report *all = &t->report;

    all->points += r->points;
    all->lifted += r->lifted;
    all->unreachable += r->unreachable;
    if (r->highest > all->highest) {
        all->highest = r->highest;
        all->highest_at = r->highest_at;
    }
    if (r->unreachable_by > all->unreachable_by) {
        all->unreachable_by = r->unreachable_by;
        all->unreachable_at = r->unreachable_at;
        t->unreachable_pass = pass;
    }
}

/* What the lift of a strip tells of it. */
static void add_strip(struct toolpath *t, const struct toolpath_strip *strip)
{
    const struct lifted_strip *lifted = &strip->lifted;

    t->chord = fmax(t->chord, strip->chord);
    add_report(t, strip->pass, &lifted->report);
    t->leaned = fmax(t->leaned, strip->leaned);
    if (t->skipped == 0) {
        t->skipped_pass = strip->pass;
        t->skipped_at = strip->skipped_at;
    }
    t->skipped += strip->skipped;
    t->skipped_area += strip->skipped_length * t->rule.spacing;
    for (size_t i = 0; i < lifted->uncut.n; i++)
        *array_push(&t->uncut) =
            (struct toolpath_uncut){lifted->uncut.item[i], strip->pass, strip->lift.offset};
}

/* Strips to be lifted at a time. */
struct batch {
    struct toolpath *t;
    size_t from;
};

/* Checks what there is of the path, writes it, and uses its room for what follows. */
static void write_items(struct toolpath *t)
{
    if (!t->out)
        return;
    path_check_items(&t->check, t->path, 0, t->path->item.n);
    path_write_items(t->out, t->path);
    t->path->item.n = t->path->contact.n = 0;
}

static void lift_strips(void *context, size_t first, size_t last)
{
    const struct batch *b = context;

    for (size_t i = first; i < last; i++)
        toolpath_lift_strip(b->t, &b->t->strip.item[b->from + i]);
}

static void plan_strips(void *context, size_t first, size_t last)
{
    const struct batch *b = context;

    for (size_t i = first; i < last; i++)
        toolpath_plan_strip(b->t, &b->t->strip.item[b->from + i]);
}

/* Where the ball's centre is on a lifted strip. */
static void add_swept(struct toolpath *t, const struct lifted_strip *lifted)
{
    for (size_t i = 0, k = 0; i < lifted->run.n; i++) {
        for (; k < lifted->end.n && i == lifted->end.item[k]; k++)
            *array_push(&t->swept_end) = t->swept.n;
        *array_push(&t->swept) = lifted->run.item[i].ball;
    }
    *array_push(&t->swept_end) = t->swept.n;
}

/* Takes the points [from, to) out of a strip; the part that they were is empty. */
static void remove_points(struct lifted_strip *lifted, size_t from, size_t to)
{
    for (size_t i = to; i < lifted->run.n; i++)
        lifted->run.item[from + i - to] = lifted->run.item[i];
    lifted->run.n -= to - from;
    for (size_t k = 0; k < lifted->end.n; k++)
        if (lifted->end.item[k] > from)
            lifted->end.item[k] -= (lifted->end.item[k] < to ? lifted->end.item[k] : to) - from;
}

/* Leaves out of a strip where the ball touches nothing, but for short ways between; there its parts
 * end. */
static void remove_idle(struct lifted_strip *lifted, double longest)
{
    struct run kept = {.radius = lifted->run.radius};
    struct sizes end = {0};

    for (size_t k = 0, from = 0; k < lifted->end.n; from = lifted->end.item[k++]) {
        size_t last = SIZE_MAX; /* that touches */
        for (size_t i = from; i < lifted->end.item[k]; i++) {
            const struct run_point *p = &lifted->run.item[i];
            if (!run_point_touches(p))
                continue;
            bool near =
                last != SIZE_MAX && vec_distance(lifted->run.item[last].ball, p->ball) <= longest;
            if (last != SIZE_MAX && last + 1 < i && !near)
                *array_push(&end) = kept.n;
            for (size_t b = last + 1; near && b < i; b++)
                *array_push(&kept) = lifted->run.item[b];
            *array_push(&kept) = *p;
            last = i;
        }
        *array_push(&end) = kept.n;
    }
    array_free(&lifted->run);
    array_free(&lifted->end);
    lifted->run = kept;
    lifted->end = end;
}

/* Slivers go at once: what is cut later may rest on what is kept now. */
static void remove_slivers(struct toolpath *t)
{
    struct toolpath_parts parts = toolpath_parts_of(t);

    t->slivers = toolpath_drop_slivers(t, &parts);
    for (size_t k = parts.n; k-- > 0;)
        if (parts.item[k].dropped)
            remove_points(&t->strip.item[parts.item[k].strip].lifted, parts.item[k].from,
                          parts.item[k].to);
    array_free(&parts);
}

/* Does something to all strips that wait, and says how far it is. */
static void in_batches(struct toolpath *t, void (*work)(void *, size_t, size_t), const char *what)
{
    const size_t batch = 16;

    for (size_t from = t->lifted, to; from < t->strip.n; from = to) {
        struct batch b = {t, from};
        to = t->strip.n - from < batch ? t->strip.n : from + batch;
        parallel_for(t->threads, to - from, work, &b);
        progress(what, to, t->strip.n);
    }
}

void toolpath_cut(struct toolpath *t)
{
    const size_t first = t->lifted;

    if (first == 0 && t->rule.turn > 0)
        toolpath_choose_lean(t);
    if (!t->planner) {
        t->planner = toolpath_new_planner(t);
        if (t->planner)
            t->frame = rotary_frame_of(&t->rule.chain);
    }
    in_batches(t, lift_strips, "lifting");
    toolpath_smooth(t, first);
    if (t->planner)
        axis_planner_play(t->planner, toolpath_play(t, t->rest));
    in_batches(t, plan_strips, "axes");
    for (size_t k = first; k < t->strip.n; k++) {
        if (t->strip.item[k].rest)
            remove_idle(&t->strip.item[k].lifted, t->rule.radius);
        else
            add_strip(t, &t->strip.item[k]);
        array_free(&t->strip.item[k].contact);
    }
    t->lifted = t->strip.n;
    if (first == 0 && t->lift.guard)
        remove_slivers(t);
    for (size_t k = first; k < t->lifted; k++)
        add_swept(t, &t->strip.item[k].lifted);
}

/* The clearance plane for the axis of the path that leans most. */
static double plane_of(const struct toolpath *t)
{
    struct link_options options = toolpath_link_options(t);
    double most = 0;

    for (size_t k = 0; k < t->strip.n; k++) {
        const struct run *run = &t->strip.item[k].lifted.run;
        for (size_t i = 0; i < run->n; i++)
            most = fmax(most, toolpath_axis_lean(run->item[i].axis));
    }
    return link_height(&options, 0, most);
}

/* The travel that a path is held to: what is printed may be off by a little. */
static struct kinematic_chain printed_chain(const struct toolpath *t)
{
    const double printed = 1e-5; /* radians */
    struct kinematic_chain chain = t->rule.chain;

    for (int i = 0; i < chain.n; i++) {
        chain.rotary[i].min -= printed;
        chain.rotary[i].max += printed;
    }
    return chain;
}

/* What the path is checked with when it is done. */
static struct path_check path_check_of(const struct toolpath *t)
{
    return (struct path_check){.tool = {.guard = t->lift.guard,
                                        .radius = t->rule.radius,
                                        .tolerance = t->lift.tolerance,
                                        .holder = t->rule.holder},
                               .coarse = !t->lift.between,
                               .floored = isfinite(t->rule.floor),
                               .floor = t->rule.floor,
                               .chain = printed_chain(t),
                               .threads = t->threads};
}

static void free_strips(struct toolpath *t)
{
    for (size_t k = 0; k < t->strip.n; k++) {
        array_free(&t->strip.item[k].contact);
        lifted_strip_free(&t->strip.item[k].lifted);
    }
    array_free(&t->strip);
}

/* What a fitter asks of the whole path (path_next_run), said before its first pass. */
static struct path_runs runs_of(const struct toolpath *t, const struct toolpath_parts *parts)
{
    struct path_runs runs = {.feed = fmax(t->rule.feed, t->rule.plunge)};

    for (size_t k = 0; k < parts->n; k++) {
        struct run run = toolpath_part_run(t, &parts->item[k]);
        if (toolpath_is_blocked(&parts->item[k], run.n))
            continue;
        for (size_t i = 0, from; i < run.n; i++) {
            for (from = i; i < run.n && vec_length(run.item[i].normal) > 0;)
                i++;
            runs.points += i > from + 1 ? i - from : 0;
        }
    }
    return runs;
}

/* The parts of all strips in their order, each with its ways in and out. */
static struct toolpath_parts plan_parts(struct toolpath *t)
{
    struct toolpath_parts parts = toolpath_parts_of(t);
    struct way_finder finder = {t, &parts};

    if (t->lift.guard)
        toolpath_order(t, &parts);
    toolpath_join(t, &parts);
    toolpath_calm(t, &parts, toolpath_link_options(t).longest);
    toolpath_thin(t, &parts);
    parallel_for(t->threads, parts.n, find_ways, &finder);
    return parts;
}

void toolpath_end(struct toolpath *t)
{
    const size_t at_once = 64; /* parts that are checked and written together */

    toolpath_cut(t);
    axis_planner_free(t->planner);
    t->planner = NULL;
    array_free(&t->swept);
    array_free(&t->swept_end);
    struct toolpath_parts parts = plan_parts(t);
    t->plane = plane_of(t);
    t->check = path_check_of(t);
    t->path->head.multax = t->path->head.multax || t->leaned > 0;
    t->path->head.runs = runs_of(t, &parts);
    if (t->streams) {
        t->path->head.clearance = t->plane;
        t->out = out_open(t->output);
        path_write_head(t->out, &t->path->head);
    }
    for (size_t i = 0; i < parts.n; i++) {
        toolpath_add_part(t, &parts.item[i]);
        if (i % at_once == at_once - 1)
            write_items(t);
    }
    toolpath_add_end(t);
    write_items(t);
    if (!t->out)
        path_check_items(&t->check, t->path, 0, t->path->item.n);
    toolpath_parts_free(&parts);
    free_strips(t);
    toolpath_find_uncut(t);
}

void toolpath_free(struct toolpath *t)
{
    array_free(&t->ball);
    array_free(&t->ball_end);
}
