/* post_output - see post_output.h. */
#include "post_output.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"
#include "post_ik.h"
#include "post_program.h"
#include "post_rewind.h"
#include "post_template.h"
#include "post_way.h"

/* How long a program is, or may be at its ends. */
struct length {
    size_t blocks, bytes;
};

/* ---- part of a plan as a program of its own */

enum {
    MADE =
        9, /* moves that may be added to a part: tool, plane, two statements, over the part, down,
                  and up */
    CYCLE = 18 /* blocks of a drilling cycle that is said anew in it */
};

/* The machine with the tool that makes a move of the whole program, or of a copy at its line. */
static struct machine machine_with_tool(const struct nc_program *whole, const struct nc_move *move)
{
    struct machine own = *whole->machine;
    const struct nc_plan *plan = whole->plan;
    int number = whole->path->head.tool;
    for (size_t i = 0; i < plan->move.n && plan->move.item[i].line <= move->line; i++)
        if (plan->move.item[i].kind == NC_TOOL)
            number = whole->path->tool.item[plan->move.item[i].index].number;
    post_ik_chain(whole->machine, number, whole->options.unit, &own.chain);
    return own;
}

/* A planner that stands where a move ends, with the machine of its tool. */
static struct nc_planner planner_at(const struct nc_program *whole, const struct nc_move *from,
                                    struct nc_plan *plan, struct machine *own, struct error *error)
{
    struct nc_planner planner = {
        .path = whole->path, .machine = own, .plan = plan, .clearance = NAN, .error = error};
    *plan = *whole->plan;
    *own = machine_with_tool(whole, from);
    planner.follow = (struct interpolation){.mode = plan->ability.mode, .chain = &own->chain};
    planner.near = ik_near_table(&own->chain);
    planner.state.line = from->line;
    planner.state.at = nc_plan_pose(plan, &own->chain, from);
    planner.state.pose = (struct pose){planner.state.at.p, vec_unit(planner.state.at.a)};
    if (plan->ability.mode == INTERPOLATE_JOINT)
        planner.state.pose.p = chain_tip(&own->chain, planner.state.at.p, planner.state.at.q);
    return planner;
}

/* Off the part along the tool axis from where a move ends, as far as the machine's `retract` and up
 * to the plan's top; `high`: up to there alone, and no further than it goes. */
static int retract_from(struct nc_move *up, const struct nc_program *whole,
                        const struct nc_move *from, bool high, struct error *error)
{
    struct nc_plan plan;
    struct machine own;
    struct nc_planner planner = planner_at(whole, from, &plan, &own, error);
    struct pose pose = planner.state.pose;
    if (pose.a.z < 0)
        planner.cut = post_rewind_extent(whole->path).cut;
    if (!high)
        pose = post_rewind_retracted(&planner);
    pose = post_rewind_above(&planner, pose);
    struct machine_pose target = post_ik_pose(&planner, pose, planner.state.at.q);
    *up = *from; /* the tool axis and the rotary axes as they are */
    up->kind = NC_RAPID;
    up->why = NC_WHY_PART;
    up->p = target.at.p;
    up->feed = 0;
    return post_ik_check_linear(&planner, &target);
}

/* The part begins, or ends, above this move where the path still rises above it. */
static void add_above(struct nc_plan *part, const struct nc_program *whole,
                      const struct nc_move *first)
{
    struct error unheard;
    struct nc_move over;
    struct machine own = machine_with_tool(whole, first);
    struct block_pose at = nc_plan_pose(whole->plan, &own.chain, first);
    if (whole->plan->ability.mode == INTERPOLATE_JOINT)
        at.p = chain_tip(&own.chain, at.p, at.q);
    if (at.p.z < whole->plan->top - 1e-6 && retract_from(&over, whole, first, true, &unheard) == 0)
        *array_push(&part->move) = over;
}

/* The part goes from home to its first motion, or to where the rotary axes may turn before it. */
static int begin_within(struct nc_plan *part, const struct nc_program *whole, size_t first,
                        struct error *error)
{
    struct nc_plan plan;
    struct machine own;
    struct nc_move *move = part->move.item;
    struct nc_planner planner = planner_at(whole, &move[first], &plan, &own, error);
    const struct block_pose at = planner.state.at;
    struct block_pose by;
    struct nc_over over = post_way_from_home(&planner, &at, planner.state.pose.a, &by);
    if (over.is)
        return post_way_tell(&planner, &over, "on the way from home a position of");
    if (vec_distance(by.p, at.p) == 0)
        return 0;
    array_push(&part->move);
    move = part->move.item;
    memmove(move + first + 1, move + first, (part->move.n - 1 - first) * sizeof *move);
    move[first].kind = NC_RAPID;
    move[first].why = NC_WHY_PART;
    move[first].p = by.p;
    move[first].feed = 0;
    return 0;
}

/* The feed with which the tool comes down again to where `to` starts. */
static double feed_down(const struct nc_program *whole, const struct nc_move *to)
{
    const struct nc_ability *ability = &whole->plan->ability;
    if (ability->feeds == NC_FEEDS_INVERSE)
        return fmin(ability->feed_max, whole->options.feed / whole->machine->retract);
    return ability->feeds == NC_FEEDS_TIP ? to->feed : whole->options.feed;
}

static const struct nc_move *last_motion(const struct nc_plan *plan, size_t before)
{
    while (before && !nc_moves(&plan->move.item[before - 1]))
        before--;
    return before ? &plan->move.item[before - 1] : NULL;
}

/* A tool comes between `from` and the first motion. */
static bool begins_with_tool(const struct nc_plan *plan, size_t from, size_t first)
{
    for (size_t i = from; i < first; i++)
        if (plan->move.item[i].kind == NC_TOOL)
            return true;
    return false;
}

/* Tool, plane and statements before the part that last: the last of each kind; a speed only of the
 * tool that the part has. */
static void add_lasting(struct nc_plan *part, const struct nc_program *whole, size_t from,
                        size_t first)
{
    static const char *const word[] = {"SPINDL", "COOLNT"};
    static const enum nc_kind kind[] = {NC_TOOL, NC_PLANE};
    for (size_t k = 0; k < sizeof kind / sizeof *kind; k++)
        for (size_t i = from; i-- > 0;)
            if (whole->plan->move.item[i].kind == kind[k]) {
                *array_push(&part->move) = whole->plan->move.item[i];
                break;
            }
    for (size_t k = 0; k < sizeof word / sizeof *word; k++)
        for (size_t i = k == 0 && begins_with_tool(whole->plan, from, first) ? 0 : from; i-- > 0;) {
            const struct nc_move *move = &whole->plan->move.item[i];
            if (k == 0 && move->kind == NC_TOOL)
                break;
            if (move->kind != NC_TEXT ||
                strncmp(whole->path->text.item[move->index], word[k], strlen(word[k])) != 0)
                continue;
            *array_push(&part->move) = *move;
            break;
        }
}

static int make_part(struct nc_plan *part, const struct nc_program *whole, size_t from, size_t to,
                     struct error *error)
{
    const struct nc_plan *plan = whole->plan;
    size_t first = from;
    *part = *plan;
    part->move.item = NULL;
    part->move.n = part->move.cap = 0;
    array_reserve(&part->move, to - from + MADE);
    while (first < to && !nc_moves(&plan->move.item[first]))
        first++;
    const struct nc_move *before = last_motion(plan, from);
    add_lasting(part, whole, from, first);
    if (before && first < to && plan->move.item[first].kind == NC_HOLE) {
        struct nc_move over = plan->move.item[first];
        over.kind = NC_RAPID;
        over.why = NC_WHY_PART;
        add_above(part, whole, &over);
        *array_push(&part->move) = over;
    } else if (before && first < to && plan->move.item[first].kind == NC_RAPID) {
        add_above(part, whole, &plan->move.item[first]);
    } else if (before && first < to) {
        struct nc_move down = *before, up;
        if (before->kind != NC_RAPID && retract_from(&up, whole, before, false, error) != 0)
            return -1;
        add_above(part, whole, before->kind != NC_RAPID ? &up : before);
        if (before->kind != NC_RAPID)
            *array_push(&part->move) = up;
        down.why = NC_WHY_PART;
        if (before->kind != NC_RAPID) {
            down.kind = NC_LINE;
            down.feed = feed_down(whole, &plan->move.item[first]);
        }
        *array_push(&part->move) = down;
    }
    for (size_t i = from; i < to; i++)
        *array_push(&part->move) = plan->move.item[i];
    const struct nc_move *last = last_motion(plan, to);
    if (last && last->kind != NC_RAPID && last->kind != NC_HOLE &&
        retract_from(array_push(&part->move), whole, last, false, error) != 0)
        return -1;
    if (last && last->kind == NC_RAPID && to < plan->move.n)
        add_above(part, whole, last); /* it is amid an approach */
    for (first = 0; first < part->move.n && !nc_moves(&part->move.item[first]);)
        first++;
    return before && first < part->move.n ? begin_within(part, whole, first, error) : 0;
}

static void free_part(struct nc_plan *part)
{
    array_free(&part->move);
}

static size_t first_of_pass(const struct nc_plan *plan, size_t pass)
{
    size_t i = 0;
    while (i < plan->move.n &&
           !(plan->move.item[i].kind == NC_PASS && plan->move.item[i].index == pass))
        i++;
    return i;
}

/* So far from 0 that a part may need one move more (begin_within). */
static bool goes_far(const struct nc_program *whole)
{
    double far = post_ik_safe_radius(whole->machine);
    for (size_t i = 0; i < whole->plan->move.n; i++)
        if (nc_moves(&whole->plan->move.item[i]) && vec_length(whole->plan->move.item[i].p) >= far)
            return true;
    return false;
}

/* The program written to nowhere: blocks and bytes up to each move, [0] the start's. */
static struct length *lengths_up_to_moves(const struct nc_program *whole, struct length *ends)
{
    struct length *at = mem_alloc(whole->plan->move.n + 1, sizeof *at);
    struct nc_program p = *whole;
    p.w.line = p.w.own;
    post_program_start(&p);
    for (size_t i = 0; i <= whole->plan->move.n; i++) {
        at[i] = (struct length){p.w.blocks, p.w.bytes};
        if (i < whole->plan->move.n)
            post_program_move(&p, &whole->plan->move.item[i]);
    }
    post_program_finish(&p);
    size_t more = MADE + (whole->plan->hole.n ? CYCLE : 0), n = whole->plan->move.n;
    if (goes_far(whole))
        more++;
    *ends = (struct length){at[0].blocks + p.w.blocks - at[n].blocks + more,
                            at[0].bytes + p.w.bytes - at[n].bytes + more * 100};
    return at;
}

/* A part may end here: the tool is off the work, between two rapids. */
static bool clear_of_work(const struct nc_plan *plan, size_t i)
{
    const struct nc_move *before = last_motion(plan, i);
    if (!before || (before->kind != NC_RAPID && before->kind != NC_HOLE) ||
        !nc_moves(&plan->move.item[i - 1]))
        return false;
    while (i < plan->move.n && !nc_moves(&plan->move.item[i]))
        i++;
    return i == plan->move.n || plan->move.item[i].kind == NC_RAPID ||
           plan->move.item[i].kind == NC_HOLE;
}

static bool is_cut(const struct nc_move *move)
{
    return nc_moves(move) && move->kind != NC_RAPID;
}

static int part_ends(struct sizes *ends, const struct nc_program *whole, struct post_extract limit,
                     struct error *error)
{
    const struct nc_plan *plan = whole->plan;
    struct length more, *at = lengths_up_to_moves(whole, &more);
    size_t last = plan->move.n; /* after the last cut: a part needs one */
    int result = 0;
    while (last && !is_cut(&plan->move.item[last - 1]))
        last--;
    for (size_t from = 0; from < plan->move.n && result == 0;) {
        size_t to = from, clear = from;
        bool cut = false;
        while (to < plan->move.n) {
            size_t blocks = at[to + 1].blocks - at[from].blocks + more.blocks;
            size_t bytes = at[to + 1].bytes - at[from].bytes + more.bytes;
            if ((limit.blocks && blocks > limit.blocks) || (limit.bytes && bytes > limit.bytes))
                break;
            cut = is_cut(&plan->move.item[to]) || cut;
            to++;
            if (to == plan->move.n || (cut && to < last && clear_of_work(plan, to)))
                clear = to;
        }
        if (clear > from)
            to = clear;
        else if (to >= last && last > from + 1)
            to = last - 1; /* the last cut is for the next one */
        while (to > from && to < plan->move.n && !nc_moves(&plan->move.item[to - 1]))
            to--; /* what is said after a motion is for the next one */
        if (to == from)
            result = error_set(error,
                               "option --split: found too little room, expected at least %zu "
                               "blocks and %zu bytes",
                               more.blocks + at[from + 1].blocks - at[from].blocks,
                               more.bytes + at[from + 1].bytes - at[from].bytes);
        *array_push(ends) = to;
        from = to;
    }
    free(at);
    return result;
}

/* ---- where a block comes from */

static const char *reason_of(const struct nc_move *move)
{
    static const char *const why[] = {
        [NC_WHY_PATH] = "as the path says it",
        [NC_WHY_DIVIDED] = "one of several blocks, so that what the control makes of them keeps "
                           "the tolerance at the ball and the tool axis",
        [NC_WHY_CHORD] = "a straight piece of a curve that the control cannot be given within the "
                         "tolerance",
        [NC_WHY_TURN] = "retract, turn and return: the travel of a rotary axis ran out",
        [NC_WHY_APPROACH] = "the path starts with a cut: from above along the tool axis",
        [NC_WHY_RETRACT] = "the path ends in a cut: up along the tool axis",
        [NC_WHY_PART] = "the start or end of a part of the program",
    };
    return why[move->why];
}

static void say_origin(struct out *out, const struct path *path, const struct nc_plan *plan,
                       size_t index)
{
    static const char *const kind[] = {"rapid", "straight",  "arc",  "spline", "hole",
                                       "pass",  "statement", "tool", "plane"};
    const struct nc_move *move = &plan->move.item[index];
    size_t pass = 0;
    for (size_t i = 0; i <= index; i++)
        if (plan->move.item[i].kind == NC_PASS)
            pass = plan->move.item[i].index;
    out_printf(out, "%s:%u: pass %zu, %s: %s\n", path->name, move->line, pass, kind[move->kind],
               reason_of(move));
    for (size_t i = 0; move->line && i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->line != move->line || !item->touches)
            continue;
        struct contact at = path->contact.item[item->contact];
        out_printf(out, "contact %.6f %.6f %.6f, normal %.6f %.6f %.6f\n", at.p.x, at.p.y, at.p.z,
                   at.n.x, at.n.y, at.n.z);
        return;
    }
}

static int explain_block(const char *file, struct nc_program *program, long number,
                         struct error *error)
{
    program->w.wanted = number;
    program->met = program->plan->move.n;
    post_program_write(program);
    if (!*program->w.met)
        return error_set(error, "option --explain: found no block %ld, the last one is %ld", number,
                         program->w.number);
    struct out *out = out_open(file);
    out_text(out, program->w.met);
    if (program->met < program->plan->move.n)
        say_origin(out, program->path, program->plan, program->met);
    else
        out_text(out, "at the start or the end of every program for this control and machine\n");
    out_close(out);
    return 0;
}

/* ---- the files */

static void begin_text(struct nc_program *p, struct out *out)
{
    nc_writer_begin(&p->w, out, nc_format_of(p->machine), p->machine->number_step,
                    p->machine->number_max);
}

static void write_program(struct nc_program *p, const char *file)
{
    struct out *out = out_open(file);
    begin_text(p, out);
    post_program_write(p);
    out_close(out);
}

/* The first pass that begins at this move or after it. */
static size_t next_pass(const struct nc_plan *plan, size_t at)
{
    while (at < plan->move.n && plan->move.item[at].kind != NC_PASS)
        at++;
    return at;
}

/* The text of some passes, as it is in the whole program: that is written from its start, to
 * nowhere, since what is modal and the numbers of blocks come from there. */
static void write_passes(struct nc_program *p, struct path_part part, const char *file)
{
    const struct nc_plan *plan = p->plan;
    struct out *out = out_open(file);
    size_t from, to;
    path_part_share(part, plan->move.n, &from, &to);
    from = path_part_first(part) ? 0 : next_pass(plan, from);
    to = path_part_last(part) ? plan->move.n : next_pass(plan, to);
    begin_text(p, path_part_first(part) ? out : NULL);
    post_program_start(p);
    for (size_t i = 0; i < to; i++) {
        if (i == from)
            nc_writer_divert(&p->w, out);
        post_program_move(p, &plan->move.item[i]);
    }
    if (path_part_last(part)) {
        nc_writer_divert(&p->w, out);
        post_program_finish(p);
    }
    out_close(out);
}

char *post_part_name(const char *file, size_t part)
{
    size_t size = strlen(file) + 24;
    const char *slash = strrchr(file, '/'), *dot = strrchr(slash ? slash : file, '.');
    int n = dot ? (int)(dot - file) : (int)strlen(file);
    char *name = mem_alloc(size, 1);
    snprintf(name, size, "%.*s-%zu%s", n, file, part, dot ? dot : "");
    return name;
}

/* Makes the i-th part and, with a file, writes it. */
static int one_part(const struct nc_program *whole, const struct sizes *ends, size_t i,
                    const char *file, struct error *error)
{
    struct nc_plan part;
    struct nc_program p = *whole;
    int result = make_part(&part, whole, i ? ends->item[i - 1] : 0, ends->item[i], error);
    p.plan = &part;
    p.part = i + 1;
    p.parts = ends->n;
    if (result == 0 && file) {
        char *name = post_part_name(file, i + 1);
        write_program(&p, name);
        free(name);
    }
    free_part(&part);
    return result;
}

static int write_parts(struct nc_program *whole, struct post_extract limit, const char *file,
                       size_t *files, struct error *error)
{
    struct sizes ends = {0};
    begin_text(whole, NULL);
    int result = part_ends(&ends, whole, limit, error);
    *files = ends.n;
    for (size_t i = 0; i < ends.n && result == 0; i++) /* all before the first is written */
        result = one_part(whole, &ends, i, NULL, error);
    for (size_t i = 0; i < ends.n && result == 0; i++)
        result = one_part(whole, &ends, i, file, error);
    array_free(&ends);
    return result;
}

static int explain(struct nc_program *p, long number, const char *file, struct error *error)
{
    begin_text(p, NULL);
    return explain_block(file, p, number, error);
}

int nc_output(struct nc_program *p, struct post_extract extract, const char *file, size_t *files,
              struct error *error)
{
    const struct nc_plan *whole = p->plan;
    struct nc_plan later = {0};
    int result = 0;
    *files = 1;
    if (extract.from >= 0) {
        size_t first = first_of_pass(whole, (size_t)extract.from);
        if (first == whole->move.n)
            return error_set(error, "option --from: found no pass %d in %s", extract.from,
                             p->path->name);
        result = make_part(&later, p, first, whole->move.n, error);
        p->plan = &later;
        p->from = &extract.from;
    }
    if (result == 0 && extract.explain >= 0)
        result = explain(p, extract.explain, file, error);
    else if (result == 0 && (extract.blocks || extract.bytes))
        result = write_parts(p, extract, file, files, error);
    else if (result == 0 && extract.part.n > 0)
        write_passes(p, extract.part, file);
    else if (result == 0)
        write_program(p, file);
    p->plan = whole;
    p->from = NULL;
    free_part(&later);
    return result;
}
