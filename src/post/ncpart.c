/* ncpart - see ncpart.h. */
#include "post/ncpart.h"

#include <stdlib.h>
#include <string.h>

#include "post/nchead.h"
#include "post_ik.h"
#include "base/num.h"

enum {
    MADE = 8,  /* moves that may be added to a part: tool, plane, two statements, down, and up */
    CYCLE = 18 /* blocks of a drilling cycle that is said anew in it */
};

int nc_limit_read(const char *text, struct nc_limit *limit, struct error *error)
{
    const char *rest = text;
    double n;
    bool good = num_read(&rest, &n) && n >= 1 && n < 1e12;
    double scale = strcmp(rest, "M") == 0 ? 1e6 : strcmp(rest, "k") == 0 ? 1e3 : 0;
    if (!good || (scale == 0 && *rest))
        return error_set(
            error, "option --split: found `%.40s`, expected blocks, or bytes as 500k or 2M", text);
    *(scale > 0 ? &limit->bytes : &limit->blocks) = (size_t)(n * fmax(scale, 1));
    return 0;
}

/* Off the part along the tool axis from where a move ends. */
static int above(struct nc_move *up, const struct nc_program *whole, const struct nc_move *from,
                 struct error *error)
{
    struct nc_plan plan = *whole->plan;
    struct nc_step step = {
        .path = whole->path, .machine = whole->machine, .plan = &plan, .error = error};
    const struct kinematic_chain *chain = &whole->machine->chain;
    step.follow = (struct interpolation){.mode = plan.ability.mode, .chain = chain};
    step.ways = ik_near_table(chain);
    step.state.line = from->line;
    struct block_pose at = nc_plan_station(&plan, chain, from);
    struct pose pose = {at.p, vec_unit(at.a)};
    if (plan.ability.mode == INTERPOLATE_JOINT)
        pose.p = chain_tip(chain, at.p, at.q);
    pose.p = vec_along(pose.p, whole->machine->retract, pose.a);
    struct machine_pose stance = nc_station(&step, pose, at.q);
    *up = *from; /* the tool axis and the rotary axes as they are */
    up->kind = NC_RAPID;
    up->why = NC_WHY_PART;
    up->p = stance.at.p;
    up->feed = 0;
    return nc_check_linear(&step, &stance);
}

/* The feed with which the tool comes down again to where `to` starts. */
static double feed_down(const struct nc_program *whole, const struct nc_move *to)
{
    const struct nc_ability *ability = &whole->plan->ability;
    if (ability->feeds == NC_FEEDS_INVERSE)
        return fmin(ability->feed_max, whole->wish.feed / whole->machine->retract);
    return ability->feeds == NC_FEEDS_TIP ? to->feed : whole->wish.feed;
}

static const struct nc_move *last_motion(const struct nc_plan *plan, size_t before)
{
    while (before && !nc_moves(&plan->move.item[before - 1]))
        before--;
    return before ? &plan->move.item[before - 1] : NULL;
}

/* Tool, plane and statements before the part that last: the last of each kind. */
static void add_lasting(struct nc_plan *part, const struct nc_program *whole, size_t from)
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
        for (size_t i = from; i-- > 0;) {
            const struct nc_move *move = &whole->plan->move.item[i];
            if (move->kind != NC_TEXT ||
                strncmp(whole->path->text.item[move->index], word[k], strlen(word[k])) != 0)
                continue;
            *array_push(&part->move) = *move;
            break;
        }
}

int nc_part_make(struct nc_plan *part, const struct nc_program *whole, size_t from, size_t to,
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
    add_lasting(part, whole, from);
    if (before && first < to && plan->move.item[first].kind == NC_HOLE) {
        struct nc_move over = plan->move.item[first];
        over.kind = NC_RAPID;
        over.why = NC_WHY_PART;
        *array_push(&part->move) = over;
    } else if (before && first < to && plan->move.item[first].kind != NC_RAPID) {
        struct nc_move down = *before;
        if (before->kind != NC_RAPID && above(array_push(&part->move), whole, before, error) != 0)
            return -1;
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
    if (last && last->kind != NC_RAPID && last->kind != NC_HOLE)
        return above(array_push(&part->move), whole, last, error);
    return 0;
}

void nc_part_free(struct nc_plan *part)
{
    array_free(&part->move);
}

size_t nc_part_pass(const struct nc_plan *plan, size_t pass)
{
    size_t i = 0;
    while (i < plan->move.n &&
           !(plan->move.item[i].kind == NC_PASS && plan->move.item[i].index == pass))
        i++;
    return i;
}

/* The program written to nowhere: blocks and bytes up to each move, [0] the start's. */
static struct nc_limit *measure(const struct dialect *dialect, const struct nc_program *whole,
                                struct nc_limit *ends)
{
    struct nc_limit *at = mem_alloc(whole->plan->move.n + 1, sizeof *at);
    struct nc_program p = *whole;
    p.w.line = p.w.own;
    dialect_start(dialect, &p);
    for (size_t i = 0; i <= whole->plan->move.n; i++) {
        at[i] = (struct nc_limit){p.w.blocks, p.w.bytes};
        if (i < whole->plan->move.n)
            dialect_move(dialect, &p, &whole->plan->move.item[i]);
    }
    dialect_finish(dialect, &p);
    size_t more = MADE + (whole->plan->hole.n ? CYCLE : 0), n = whole->plan->move.n;
    *ends = (struct nc_limit){at[0].blocks + p.w.blocks - at[n].blocks + more,
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

static bool cuts(const struct nc_move *move)
{
    return nc_moves(move) && move->kind != NC_RAPID;
}

int nc_part_ends(struct sizes *ends, const struct dialect *dialect, const struct nc_program *whole,
                 struct nc_limit limit, struct error *error)
{
    const struct nc_plan *plan = whole->plan;
    struct nc_limit more, *at = measure(dialect, whole, &more);
    size_t last = plan->move.n; /* behind the last cut: a part without one would be none */
    int result = 0;
    while (last && !cuts(&plan->move.item[last - 1]))
        last--;
    for (size_t from = 0; from < plan->move.n && result == 0;) {
        size_t to = from, clear = from;
        bool cut = false;
        while (to < plan->move.n) {
            size_t blocks = at[to + 1].blocks - at[from].blocks + more.blocks;
            size_t bytes = at[to + 1].bytes - at[from].bytes + more.bytes;
            if ((limit.blocks && blocks > limit.blocks) || (limit.bytes && bytes > limit.bytes))
                break;
            cut = cuts(&plan->move.item[to]) || cut;
            to++;
            if (to == plan->move.n || (cut && to < last && clear_of_work(plan, to)))
                clear = to;
        }
        if (clear > from)
            to = clear;
        else if (to >= last && last > from + 1)
            to = last - 1; /* the last cut is for the next one */
        while (to > from && to < plan->move.n && !nc_moves(&plan->move.item[to - 1]))
            to--; /* what is said behind a motion is for the next one */
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
