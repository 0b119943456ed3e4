/* nchole - see nchole.h. */
#include "post/nchole.h"

#include "ncmove.h"
#include "post_ik.h"
#include "base/num.h"

/* The tool stands where it left a hole of the same cycle with its mouth as high. */
static bool follows(const struct nc_step *step, const struct nc_hole *hole)
{
    const struct nc_plan *plan = step->plan;
    size_t last = plan->move.n;
    while (last && !nc_moves(&plan->move.item[last - 1]))
        last--;
    if (!step->state.begun || !last || plan->move.item[last - 1].kind != NC_HOLE)
        return false;
    const struct nc_hole *before = &plan->hole.item[plan->move.item[last - 1].index];
    return before->cycle == hole->cycle && before->mouth.z == hole->mouth.z;
}

/* Above the mouth, no lower than now and than where the tool leaves; down to there. */
static int come(struct nc_step *step, struct pose above)
{
    struct pose over = above;
    if (step->state.begun && step->state.pose.p.z > above.p.z)
        over.p.z = step->state.pose.p.z;
    if (step->state.begun && step->state.pose.p.z < above.p.z) {
        struct pose up = step->state.pose;
        up.p.z = above.p.z;
        if (nc_step_rapid(step, up) != 0)
            return -1;
    }
    if (nc_step_rapid(step, over) != 0)
        return -1;
    return over.p.z > above.p.z ? nc_step_rapid(step, above) : 0;
}

/* Length and time of the way down and out. */
static void count(struct nc_step *step, const struct nc_hole *hole, double over)
{
    const struct path_cycle *c = hole->cycle;
    struct nc_total *total = &step->plan->total;
    bool slow = nc_hole_slow(hole);
    double down = hole->depth + hole->clear, out = hole->depth + hole->retract;
    double lift = hole->retract - hole->clear, rapid = over + lift + (slow ? lift : out);
    total->holes++;
    total->cut += slow ? 2 * down : down;
    total->rapid += rapid;
    total->minutes += (slow ? 2 * down : down) / hole->feed + c->dwell / 60 +
                      rapid / step->machine->rapid[MACHINE_X];
}

static struct vec3 printed(const struct nc_step *step, struct vec3 p)
{
    return vec_round(p, step->plan->ability.digits.linear);
}

int nc_hole(struct nc_step *step, const struct path_item *item)
{
    const struct path_cycle *c = &step->path->cycle.item[item->index];
    int digits = step->plan->ability.digits.linear;
    struct nc_hole hole = {.mouth = printed(step, item->to.p),
                           .cycle = c,
                           .depth = num_round(c->depth, digits),
                           .clear = num_round(c->clear, digits),
                           .retract = num_round(c->retract, digits)};
    struct pose above = {hole.mouth, item->to.a}, bottom = above;
    above.p.z = nc_hole_level(&hole);
    bottom.p.z = nc_hole_bottom(&hole);
    double over = 0;
    if (c->feed <= 0 && step->state.feed <= 0) {
        step->state.feed = step->wish.feed;
        step->plan->total.feed_assumed = true;
    }
    hole.feed = fmin(c->feed > 0 ? c->feed : step->state.feed, step->plan->ability.feed_max);
    if (follows(step, &hole))
        over = vec_distance(step->state.pose.p, above.p);
    else if (come(step, above) != 0)
        return -1;
    struct machine_pose deep = nc_station(step, bottom, step->state.at.q);
    struct machine_pose to = nc_station(step, above, step->state.at.q);
    if (nc_check_linear(step, &deep) != 0 || nc_check_linear(step, &to) != 0)
        return -1;
    struct nc_move *move = nc_move_to(step, NC_HOLE, &to);
    move->why = NC_WHY_PATH;
    move->feed = hole.feed;
    move->index = (unsigned)step->plan->hole.n;
    *array_push(&step->plan->hole) = hole;
    count(step, &hole, over);
    step->state.pose = above;
    step->state.touches = false;
    return 0;
}

const struct nc_hole *nc_hole_of(const struct nc_program *p, const struct nc_move *move)
{
    return &p->plan->hole.item[move->index];
}

bool nc_hole_goes_on(const struct nc_program *p, const struct nc_move *move)
{
    const struct nc_hole *hole = nc_hole_of(p, move);
    return p->hole && p->hole->cycle == hole->cycle && p->hole->mouth.z == hole->mouth.z;
}

bool nc_hole_steps_differ(const struct path *path)
{
    for (size_t i = 0; i < path->cycle.n; i++) {
        const struct path_cycle *c = &path->cycle.item[i];
        if (c->step > 0 && (c->next != c->step || c->dwell > 0))
            return true;
    }
    return false;
}

double nc_hole_bottom(const struct nc_hole *hole)
{
    return hole->mouth.z - hole->depth;
}

double nc_hole_clear(const struct nc_hole *hole)
{
    return hole->mouth.z + hole->clear;
}

double nc_hole_level(const struct nc_hole *hole)
{
    return hole->mouth.z + hole->retract;
}

double nc_hole_pitch(const struct nc_program *p, const struct nc_hole *hole)
{
    if (hole->cycle->pitch > 0)
        return hole->cycle->pitch;
    return p->tooling.spindle > 0 ? hole->feed / p->tooling.spindle : 0;
}

bool nc_hole_slow(const struct nc_hole *hole)
{
    return hole->cycle->kind == CYCLE_TAP || hole->cycle->kind == CYCLE_BORE;
}

bool nc_hole_steps(const struct nc_hole *hole)
{
    const struct path_cycle *c = hole->cycle;
    return (c->kind == CYCLE_DEEP || c->kind == CYCLE_BREAK) && c->step > 0;
}

void nc_hole_place(struct nc_program *p, const struct nc_hole *hole)
{
    int digits = p->plan->ability.digits.linear;
    nc_forget(&p->w, NC_X, NC_Y);
    nc_modal(&p->w, NC_X, "X", hole->mouth.x, digits);
    nc_modal(&p->w, NC_Y, "Y", hole->mouth.y, digits);
}

void nc_hole_done(struct nc_program *p, const struct nc_move *move)
{
    p->hole = nc_hole_of(p, move);
    p->w.motion = NULL;
    int digits = p->plan->ability.digits.linear;
    nc_remember(&p->w, NC_X, num_round(move->p.x, digits));
    nc_remember(&p->w, NC_Y, num_round(move->p.y, digits));
    nc_remember(&p->w, NC_Z, num_round(move->p.z, digits));
}
