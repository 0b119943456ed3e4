/* post - see post.h. */
#include "post/post.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/cli.h"
#include "base/num.h"
#include "post_even.h"
#include "post_head.h"
#include "post_hole.h"
#include "post_ik.h"
#include "post_group.h"
#include "post_output.h"
#include "post_statement.h"
#include "post_tilted.h"
#include "post_time.h"

struct post {
    struct nc_program program;
    struct nc_plan plan;
    struct machine untilted; /* the machine, in mm, where the program is in tilted planes */
};

int post_limit_read(const char *text, struct post_extract *extract, struct error *error)
{
    const char *rest = text;
    double n;
    bool good = num_read(&rest, &n) && n >= 1 && n < 1e12;
    double scale = strcmp(rest, "M") == 0 ? 1e6 : strcmp(rest, "k") == 0 ? 1e3 : 0;
    if (!good || (scale == 0 && *rest))
        return error_set(
            error, "option --split: found `%.40s`, expected blocks, or bytes as 500k or 2M", text);
    *(scale > 0 ? &extract->bytes : &extract->blocks) = (size_t)(n * fmax(scale, 1));
    return 0;
}

int post_check(enum control_id control, const struct machine *machine,
               const struct post_options *options, struct error *error)
{
    const struct dialect *dialect = dialect_of(control);
    const char *title = machine->text.title; /* one that a file makes of another has its own */
    const char *name = *title ? title : control_row(control)->name;
    if (options->name && dialect->check_name(options->name, error) != 0)
        return -1;
    if (options->axis == POST_AXIS_VECTORS && dialect->vectors_never)
        return error_set(error, "found --vectors, which %s does not know", name);
    if (options->axis == POST_AXIS_VECTORS && !machine->vectors)
        return error_set(error, "found --vectors, which %s does not know (vectors = no)",
                         machine->text.title);
    if (options->plane && !dialect->plane)
        return error_set(error, "found --plane, which %s does not know", name);
    return 0;
}

/*
 * Brings path and machine into the program's frame.  Holes stay drilling cycles where the tool
 * stands upright in that frame.  *still: the rotary axes stay at zero.  0 or the exit status.
 */
static int set_frame(struct post *post, struct path *path, struct machine *machine,
                     const struct post_options *options, bool *still, struct error *error)
{
    struct nc_program *p = &post->program;
    const struct dialect *dialect = dialect_of(p->control);
    const char *tilt = machine->blocks.plane_on;
    bool tilts = dialect->plane && *tilt && strcmp(tilt, "none") != 0;
    bool planes = post_frame_planes(path, &p->planes), upright = post_frame_upright(&p->planes);
    bool cycles = planes && machine->cycles && post_frame_holes(path);
    int digits = machine->digits.angle < 0 ? dialect->digits.angle : machine->digits.angle;
    if (options->plane && !tilts) {
        error_set(error, "found --plane, which %s does not know", machine->text.title);
        return EXIT_USAGE;
    }
    if (options->plane && !planes) {
        error_set(error,
                  "%s: found a tool axis that turns in the cut, expected it to stay "
                  "(--plane)",
                  path->name);
        return EXIT_FAILED;
    }
    p->plane = options->plane || ((machine->plane || cycles) && tilts && planes && !upright);
    p->turned = machine->chain.n;
    post->untilted = *machine;
    if (p->plane &&
        post_frame_tilt(path, machine, &p->planes, dialect->plane_angles, digits, error) != 0)
        return EXIT_UNMET;
    if (!cycles || !(upright || p->plane))
        path_expand_cycles(path);
    if (options->inch)
        post_frame_inch(path, machine, &p->options);
    *still = upright && (cycles || !machine_has_tcp(machine, p->control) ||
                         (machine->cutcom && nc_cutcom_asked(path)));
    return 0;
}

static int make_plan(struct post *post, const struct machine *machine, enum post_axis_words axis,
                     bool still, double smoothing, struct error *error)
{
    const struct nc_program *p = &post->program;
    struct nc_ability ability = dialect_ability(p->control, machine, axis, still, p->options.unit);
    if (p->plane && ability.splines == NC_SPLINES_ROTARY) /* they need tool-centre-point control */
        ability.splines = NC_SPLINES_NONE;
    ability.smoothing = smoothing;
    if (nc_plan_make(&post->plan, p->path, machine, ability, p->options, error) == 0) {
        post_time(&post->plan, machine);
        return 0;
    }
    return post->plan.unmet ? EXIT_UNMET : EXIT_FAILED;
}

/* Where vectors, which leave the rotary axes to the control, find no way within the travel, rotary
 * words are taken, with which the tool may turn back off the part. */
static int plan_in_frame(struct post *post, struct path *path, struct machine *machine,
                         const struct post_options *options, struct error *error)
{
    struct nc_program *p = &post->program;
    double smoothing = machine->smooth ? p->options.chord : 0;
    bool still = false;
    int status = set_frame(post, path, machine, options, &still, error);
    if (status)
        return status;
    status = make_plan(post, machine, options->axis, still, smoothing, error);
    if (status == EXIT_UNMET && post->plan.ability.mode == INTERPOLATE_VECTOR) {
        struct error again;
        nc_plan_free(&post->plan);
        if (make_plan(post, machine, POST_AXIS_ROTARY, still, smoothing, &again) == 0) {
            post->plan.no_vectors = true;
            status = 0;
        }
    }
    if (status == 0 && p->plane && post_tilted_check(p, &post->untilted, error) != 0)
        return EXIT_UNMET;
    return status;
}

/* Blocks of a path that is not trusted. */
static int refuse_insert(const struct path *path, const struct post_options *options,
                         struct error *error)
{
    for (size_t i = 0; i < path->item.n && options->insert == POST_INSERT_REFUSE; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_TEXT && strncmp(path->text.item[item->index], "INSERT", 6) == 0) {
            error_at(error, path->name, item->line,
                     "found `%.60s`, expected no INSERT (--insert refuse)",
                     path->text.item[item->index]);
            return EXIT_FAILED;
        }
    }
    return 0;
}

struct post *post_plan(enum control_id control, struct path *path, struct machine *machine,
                       const struct post_options *options, int *status, struct error *error)
{
    struct post *post = mem_alloc(1, sizeof *post);
    *post = (struct post){.program = {.control = control,
                                      .path = path,
                                      .machine = machine,
                                      .plan = &post->plan,
                                      .name = options->name,
                                      .asked = *options,
                                      .options = {options->chord, options->axis_tolerance,
                                                  options->feed, options->contact_feed, 1}}};
    *status = refuse_insert(path, options, error);
    if (*status == 0) {
        post_even(path);
        *status = plan_in_frame(post, path, machine, options, error);
    }
    if (*status == 0)
        return post;
    post_free(post);
    if (*status == EXIT_UNMET) /* there is no program of which it would be told */
        *status = EXIT_FAILED;
    return NULL;
}

int post_write(struct post *post, struct post_extract extract, const char *file, size_t *files,
               struct error *error)
{
    return nc_output(&post->program, extract, file, files, error);
}

/* Where a move ends on the path, mm. */
static struct pose pose_of(const struct nc_plan *plan, const struct kinematic_chain *chain,
                           const struct nc_move *move)
{
    struct block_pose at = nc_plan_pose(plan, chain, move);
    struct pose pose = {at.p, vec_unit(at.a)};

    if (plan->ability.mode == INTERPOLATE_JOINT)
        pose.p = chain_tip(chain, at.p, at.q);
    pose.p = vec_scale(plan->ability.unit, pose.p);
    return pose;
}

struct made_moves post_made_moves(const struct post *post)
{
    const struct nc_program *p = &post->program;
    const struct nc_plan *plan = &post->plan;
    struct kinematic_chain chain = p->machine->chain;
    struct made_moves made = {0};
    const struct nc_move *before = NULL;
    unsigned line = 0;

    if (p->plane)
        return made;
    post_ik_chain(p->machine, p->path->head.tool, p->options.unit, &chain);
    for (size_t i = 0; i < plan->move.n && plan->move.item[i].kind != NC_TOOL; i++) {
        const struct nc_move *move = &plan->move.item[i];
        bool here =
            move->why == NC_WHY_TURN || move->why == NC_WHY_APPROACH || move->why == NC_WHY_RETRACT;
        if (!nc_moves(move))
            continue;
        if (here && before && move->kind == NC_RAPID)
            *array_push(&made) = (struct made_move){pose_of(plan, &chain, before),
                                                    pose_of(plan, &chain, move), line};
        line = move->line ? move->line : line;
        before = move;
    }
    return made;
}

struct post_report post_report(const struct post *post)
{
    const struct nc_program *p = &post->program;
    const struct nc_plan *plan = &post->plan;
    const struct nc_total *total = &plan->total;
    double unit = plan->ability.unit;
    struct nc_missing missing = nc_missing(p);
    return (struct post_report){
        .feed_assumed = total->feed_assumed,
        .approach_made = total->approach_made,
        .retract_made = total->retract_made,
        .steps_evened =
            total->holes && dialect_of(p->control)->steps_alike && nc_hole_steps_differ(p->path),
        .cutcom_off = nc_cutcom_left_out(p->path, p->machine, &plan->ability),
        .no_spindle_on = missing.spindle,
        .no_tool = missing.tool,
        .no_coolant = missing.coolant,
        .no_vectors = plan->no_vectors,
        .turns = total->turns,
        .passes = total->passes,
        .lines = total->lines,
        .arcs = total->arcs,
        .splines = total->splines,
        .rapids = total->rapids,
        .chorded = total->chorded,
        .cut = total->cut * unit,
        .rapid = total->rapid * unit,
        .minutes = total->minutes,
        .fast = total->fast,
        .fast_line = total->fast_line,
        .fastest = total->fastest,
        .peaks = total->peaks,
        .peak = total->peak,
        .point = total->spent.point * unit,
        .axis = total->spent.axis,
        .ledger = nc_ledger_sum(p->path, plan)};
}

void post_free(struct post *post)
{
    array_free(&post->program.planes);
    nc_plan_free(&post->plan);
    free(post);
}
