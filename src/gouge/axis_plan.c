/* axis_plan - see axis_plan.h. */
#include "gouge/axis_plan.h"

#include <stdlib.h>
#include <string.h>

#include "access.h"
#include "gouge/axis_smooth.h"
#include "gouge/holder_sweep.h"
#include "machine/rotary_cost.h"

enum { ROUNDS = 4, NEIGHBOURS = 48 };

static const double NODES = 0.4;         /* of the radius: between nodes, at most */
static const double STEP = 0.23;         /* radians: neighbouring directions are no further apart */
static const double ROUND = RADIANS(45); /* about the rule: further off only where none is open */
static const double MARGIN = 0.05;       /* mm: kept free of the tool, ... */
static const double SLOPE = 0.0087;    /* ... and so much more for each mm of height: 0.5 degrees */
static const double SHORTEST = 0.0205; /* mm: no piece of a program should be shorter */
static const double AT_POLE = 1e-4;    /* radians: an axis that leans less has no say in its turn */
static const double NEAR = 0.004;      /* cost per mm of an axis that is off by all of `play` */
static const double AIR = RADIANS(60); /* how far axes in the air are off their rule for little */
static const double FAR = 20;          /* cost per mm and radian beyond */
static const double ALIKE = 0.1;       /* radians: directions so much further off are as good */
static const double JUMP = 12;         /* cost of an axis that can't be come to from the last */
static const double WIDEST = 16;       /* mm: first half length of averages, halved each time */
static const double NARROWEST = 1.5;   /* mm: and the last */
static const double BENT = RADIANS(0.15); /* an axis further off the straight line gets a point */
static const double SPARE = RADIANS(0.6); /* of play, for what the turn is off beside the pole */
static const double BESIDE = RADIANS(12); /* so near it the turn may be off for that */
static const double SUDDEN = 0.6; /* radians between nodes beyond the rule's: lift instead */

struct neighbours {
    int n;
    int index[NEIGHBOURS];
    float travel[NEIGHBOURS]; /* of the rotary axes, radians */
};

struct axis_planner {
    struct axis_planner_options options;
    struct sphere_grid grid;
    struct access *access;
    struct rotary_frame frame;
    bool *reached; /* by the machine, each direction of the grid */
    struct neighbours *beside;
};

static double travel_between(const struct rotary_frame *f, struct vec3 a, struct vec3 b)
{
    struct vec3 from = vec(vec_dot(a, f->x), vec_dot(a, f->y), vec_dot(a, f->pole));
    struct vec3 to = vec(vec_dot(b, f->x), vec_dot(b, f->y), vec_dot(b, f->pole));
    double lean0, lean1, turn;

    if (f->both)
        return rotary_travel(from, to);
    lean0 = atan2(hypot(from.x, from.y), from.z);
    lean1 = atan2(hypot(to.x, to.y), to.z);
    turn = atan2(fabs(from.x * to.y - from.y * to.x), from.x * to.x + from.y * to.y);
    return fabs(lean1 - lean0) + (fmin(lean0, lean1) > 1e-6 ? turn : 0);
}

static void find_neighbours(struct axis_planner *p, int i)
{
    struct neighbours *beside = &p->beside[i];

    for (int j = 0; j < p->grid.n; j++) {
        if (beside->n == NEIGHBOURS || vec_dot(p->grid.at[i], p->grid.at[j]) < cos(STEP))
            continue;
        beside->index[beside->n] = j;
        beside->travel[beside->n++] =
            (float)travel_between(&p->frame, p->grid.at[i], p->grid.at[j]);
    }
}

struct axis_planner *axis_planner_new(const struct axis_planner_options *options)
{
    struct axis_planner *p = mem_alloc(1, sizeof *p);

    p->options = *options;
    p->frame = rotary_frame_of(&options->chain);
    p->grid = sphere_grid_new(p->frame.pole);
    struct access_options access = {
        options->guard, &p->options.holder,    &p->grid, options->radius / 12, MARGIN,
        SLOPE,          options->tolerance / 2};
    p->access = access_new(&access);
    p->reached = mem_alloc((size_t)p->grid.n, sizeof *p->reached);
    p->beside = mem_alloc((size_t)p->grid.n, sizeof *p->beside);
    for (int i = 0; i < p->grid.n; i++) {
        p->reached[i] = options->chain.n == 2 && rotary_reaches(&options->chain, p->grid.at[i]);
        find_neighbours(p, i);
    }
    return p;
}

void axis_planner_free(struct axis_planner *p)
{
    if (!p)
        return;
    access_free(p->access);
    sphere_grid_free(&p->grid);
    free(p->reached);
    free(p->beside);
    free(p);
}

void axis_plan_free(struct axis_plan *plan)
{
    array_free(&plan->run);
    array_free(&plan->state);
}

/* ---- nodes */

struct node {
    double along; /* the path of the ball's centre, mm */
    struct vec3 ball, normal;
    struct vec3 rule;     /* axis by the rule */
    unsigned char *state; /* of the directions of the grid; NULL: not yet found */
    int open;             /* how many are */
    bool rule_open;
    bool strict; /* the grid is not fine enough here: each axis is checked */
    bool pole;   /* put between two others, where the axis is at the pole; for this round alone */

    struct vec3 axis; /* that it gets */
    bool by_rule;     /* which is the rule's */
    bool begins;      /* can't be come to from the node before */
    double allow;     /* how far the axis may be off its rule, radians */
    struct rotary_angles angles;
};

struct nodes {
    size_t n, cap;
    struct node *item;
};

/* A run and where its points are along the path. */
struct work {
    const struct axis_planner *planner;
    const struct run *run;
    double *along; /* of each point */
    struct nodes nodes;
};

/* The place at `along` on the straight lines between the points. */
static struct run_point point_at(const struct work *w, size_t after, double along)
{
    const struct run_point *a = &w->run->item[after > 0 ? after - 1 : 0], *b = &w->run->item[after];
    double from = w->along[after > 0 ? after - 1 : 0], length = w->along[after] - from;
    double s = length > 0 ? (along - from) / length : 1;
    struct run_point p = *b;

    if (s >= 1)
        return p;
    p = (struct run_point){.ball = vec_mix(a->ball, b->ball, s),
                           .axis = vec_slerp(a->axis, b->axis, s)};
    if (run_point_touches(a) && run_point_touches(b)) {
        p.normal = vec_slerp(a->normal, b->normal, s);
        p.contact = vec_mix(a->contact, b->contact, s);
    }
    return p;
}

static void add_node(struct nodes *nodes, const struct run_point *p, double along, bool strict)
{
    *array_push(nodes) = (struct node){
        .along = along, .ball = p->ball, .normal = p->normal, .rule = p->axis, .strict = strict};
}

static int by_along(const void *a, const void *b)
{
    double x = ((const struct node *)a)->along, y = ((const struct node *)b)->along;

    return (x > y) - (x < y);
}

/* Nodes at the run's ends and evenly between, and at points where it turns sharply. */
static void first_nodes(struct work *w)
{
    double length = w->along[w->run->n - 1], last = 0;
    double step = NODES * w->planner->options.radius;

    step = length > 0 ? length / ceil(length / step) : step;

    add_node(&w->nodes, &w->run->item[0], 0, false);
    for (size_t i = 1; i < w->run->n; i++) {
        bool sharp = vec_dot(w->run->item[i].axis, w->run->item[i - 1].axis) < 0.99;
        while (last + step < w->along[i] - 1e-9) {
            last += step;
            struct run_point p = point_at(w, i, last);
            add_node(&w->nodes, &p, last, false);
        }
        if (i + 1 == w->run->n || sharp)
            add_node(&w->nodes, &w->run->item[i], w->along[i], false);
    }
}

static void find_open(const struct axis_planner *p, struct node *node)
{
    size_t n = (size_t)p->grid.n;

    if (node->state)
        return;
    node->state = mem_alloc(n, 1);
    for (double within = fmin(ROUND, p->options.limit); node->open == 0;
         within = p->options.limit) {
        access_find(p->access, node->ball, node->normal, node->rule, within, node->state);
        for (size_t i = 0; i < n; i++) {
            if (!p->reached[i])
                node->state[i] = ACCESS_BLOCKED;
            node->open += node->state[i] != ACCESS_BLOCKED;
        }
        if (within >= p->options.limit)
            break;
    }
    node->rule_open = (p->options.chain.n < 2 || rotary_reaches(&p->options.chain, node->rule)) &&
                      vec_dot(node->rule, node->normal) > -1e-6 &&
                      (node->open > 0 && !p->options.fixed ? access_is_open : access_is_clear)(
                          p->access, node->ball, node->rule);
}

/* ---- dynamic programming */

/* The cheapest way to each direction at a node; the last one is the rule's. */
struct step {
    double *cost;
    short *from;
};

/* The play that the choice of axes has: less by what is spared. */
static double play_of(const struct axis_planner *p)
{
    return p->options.play > 4 * SPARE ? p->options.play - SPARE : p->options.play;
}

/* How far off the rule costs little: play, or what is open nearest to it and a little more. */
static double free_zone(const struct axis_planner *p, const struct node *node)
{
    double nearest = -1;

    if (vec_length(node->normal) == 0 && p->options.play > 0)
        return AIR;
    if (node->rule_open)
        return play_of(p);
    for (int j = 0; j < p->grid.n; j++)
        if (node->state[j] != ACCESS_BLOCKED)
            nearest = fmax(nearest, vec_dot(p->grid.at[j], node->rule));
    double off = acos(fmin(nearest, 1));
    return off > play_of(p) ? off + ALIKE : play_of(p);
}

static double off_cost(double zone, const struct node *node, struct vec3 axis, double length)
{
    double off2 = 2 - 2 * vec_dot(axis, node->rule);

    if (off2 <= zone * zone)
        return zone > 0 ? NEAR * length * off2 / (zone * zone) : 0;
    return length * (NEAR + FAR * (acos(1 - off2 / 2) - zone));
}

static int nearest_of_grid(const struct axis_planner *p, struct vec3 axis)
{
    int corner[4], best;

    sphere_grid_corners(&p->grid, axis, corner);
    best = corner[0];
    for (int k = 1; k < 4; k++)
        if (vec_dot(p->grid.at[corner[k]], axis) > vec_dot(p->grid.at[best], axis))
            best = corner[k];
    return best;
}

/* Offers the rule's axis at the node before as the one to come from. */
static void come_from_rule(const struct axis_planner *p, const struct node *before,
                           const struct step *last, const struct node *node, struct step *now)
{
    const struct neighbours *beside = &p->beside[nearest_of_grid(p, before->rule)];

    for (int k = 0; before->rule_open && k < beside->n; k++) {
        int j = beside->index[k];
        if (node->state[j] == ACCESS_BLOCKED)
            continue;
        double cost =
            last->cost[p->grid.n] + travel_between(&p->frame, before->rule, p->grid.at[j]);
        if (cost < now->cost[j]) {
            now->cost[j] = cost;
            now->from[j] = (short)p->grid.n;
        }
    }
}

/* Finds where to come from to the rule's axis. */
static void come_to_rule(const struct axis_planner *p, const struct node *before,
                         const struct step *last, const struct node *node, struct step *now)
{
    const struct neighbours *beside = &p->beside[nearest_of_grid(p, node->rule)];
    int rule = p->grid.n;

    if (before->rule_open) {
        now->cost[rule] = last->cost[rule] + travel_between(&p->frame, before->rule, node->rule);
        now->from[rule] = (short)rule;
    }
    for (int k = 0; k < beside->n; k++) {
        int j = beside->index[k];
        if (before->state[j] == ACCESS_BLOCKED)
            continue;
        double cost = last->cost[j] + travel_between(&p->frame, p->grid.at[j], node->rule);
        if (cost < now->cost[rule]) {
            now->cost[rule] = cost;
            now->from[rule] = (short)j;
        }
    }
}

static void come_by_grid(const struct axis_planner *p, const struct step *last,
                         const struct node *node, struct step *now)
{
    for (int j = 0; j < p->grid.n; j++) {
        const struct neighbours *beside = &p->beside[j];
        if (node->state[j] == ACCESS_BLOCKED)
            continue;
        for (int k = 0; k < beside->n; k++) {
            double cost = last->cost[beside->index[k]] + beside->travel[k];
            if (cost < now->cost[j]) {
                now->cost[j] = cost;
                now->from[j] = (short)beside->index[k];
            }
        }
    }
}

static int cheapest(const struct step *step, int n)
{
    int best = 0;

    for (int j = 1; j < n; j++)
        if (step->cost[j] < step->cost[best])
            best = j;
    return best;
}

static struct step new_step(const struct axis_planner *p)
{
    size_t n = (size_t)p->grid.n + 1;
    struct step s = {mem_alloc(n, sizeof *s.cost), mem_alloc(n, sizeof *s.from)};

    for (size_t j = 0; j < n; j++) {
        s.cost[j] = HUGE_VAL;
        s.from[j] = -1;
    }
    return s;
}

/* The step to node i, from the one before unless it is the first; what was dear is come to by a
 * jump. */
static void take_step(const struct axis_planner *p, const struct node *node, bool first,
                      double length, const struct step *last, struct step *now)
{
    int n = p->grid.n + 1, best = first ? -1 : cheapest(last, n);
    double zone = free_zone(p, node), start = first ? 0 : last->cost[best] + JUMP;

    if (!first) {
        come_by_grid(p, last, node, now);
        come_from_rule(p, node - 1, last, node, now);
        if (node->rule_open)
            come_to_rule(p, node - 1, last, node, now);
    }
    for (int j = 0; j < n; j++) {
        bool open = j + 1 < n ? node->state[j] != ACCESS_BLOCKED : node->rule_open;
        if (!open)
            continue;
        if (start < now->cost[j]) {
            now->cost[j] = start;
            now->from[j] = (short)best;
        }
        now->cost[j] += off_cost(zone, node, j + 1 < n ? p->grid.at[j] : node->rule, length);
    }
}

/* Axes of the nodes [from, to), each of which has an open one. */
static void choose_axes(const struct work *w, size_t from, size_t to)
{
    const struct axis_planner *p = w->planner;
    struct step *step = mem_alloc(to - from, sizeof *step);
    struct node *node = &w->nodes.item[from];

    for (size_t i = 0; i < to - from; i++) {
        double before = i > 0 ? node[i].along - node[i - 1].along : 0;
        double after = i + 1 < to - from ? node[i + 1].along - node[i].along : 0;
        step[i] = new_step(p);
        take_step(p, &node[i], i == 0, 0.01 + (before + after) / 2, i > 0 ? &step[i - 1] : NULL,
                  &step[i]);
    }
    int at = cheapest(&step[to - from - 1], p->grid.n + 1);
    for (size_t i = to - from; i-- > 0; at = step[i].from[at]) {
        node[i].by_rule = at == p->grid.n;
        node[i].axis = node[i].by_rule ? node[i].rule : p->grid.at[at];
    }
    for (size_t i = 0; i < to - from; i++) {
        free(step[i].cost);
        free(step[i].from);
        node[i].begins = i == 0 || vec_angle(node[i].axis, node[i - 1].axis) >
                                       vec_angle(node[i].rule, node[i - 1].rule) + SUDDEN;
    }
    free(step);
}

/* ---- the axes made smooth */

/* True if the node may have the axis. */
static bool may_have(const struct axis_planner *p, const struct node *node, struct vec3 axis,
                     double spare)
{
    int corner[4];

    if (vec_dot(axis, node->rule) < cos(node->allow + spare))
        return false;
    if (node->strict)
        return access_is_open(p->access, node->ball, axis);
    sphere_grid_corners(&p->grid, axis, corner);
    for (int k = 0; k < 4; k++)
        if (node->state[corner[k]] == ACCESS_BLOCKED)
            return false;
    return true;
}

/* How far each axis may be off its rule: `play`, or as far as it was chosen to be or the nodes
 * beside it, less by the way between. */
static void set_allowances(const struct work *w, size_t from, size_t to)
{
    const double ramp = 0.04; /* radians/mm */
    struct node *node = w->nodes.item;

    for (size_t i = from; i < to; i++) {
        double off = vec_angle(node[i].axis, node[i].rule), play = play_of(w->planner);
        if (vec_length(node[i].normal) == 0 && play > 0)
            play = AIR;
        node[i].allow = off > play + 1e-6 ? off + 0.05 : play;
    }
    for (size_t i = from + 1; i < to; i++)
        node[i].allow =
            fmax(node[i].allow, node[i - 1].allow - ramp * (node[i].along - node[i - 1].along));
    for (size_t i = to - 1; i-- > from;)
        node[i].allow =
            fmax(node[i].allow, node[i + 1].allow - ramp * (node[i + 1].along - node[i].along));
}

static void unwrap_angles(const struct work *w, size_t from, size_t to)
{
    struct node *node = w->nodes.item;
    struct rotary_angles last = {0, 0};

    for (size_t i = from; i < to; i++) {
        if (i == from)
            last.turn = rotary_angles_near(&w->planner->frame, node[i].axis, last).turn;
        node[i].angles = last = rotary_angles_near(&w->planner->frame, node[i].axis, last);
    }
}

/* The node's angles towards `to`, as far as it may have them. */
static void move_towards(const struct axis_planner *p, struct node *node, struct rotary_angles to)
{
    struct rotary_angles was = node->angles;

    if (fabs(to.lean - was.lean) + fabs(to.turn - was.turn) < 1e-9)
        return;
    for (double part = 1; part > 0.1; part /= 2) {
        struct rotary_angles a = {was.lean + part * (to.lean - was.lean),
                                  was.turn + part * (to.turn - was.turn)};
        struct vec3 axis = rotary_axis(&p->frame, a);
        if (!may_have(p, node, axis, 0))
            continue;
        node->angles = a;
        node->axis = axis;
        node->by_rule = false;
        return;
    }
}

/* Each node's angles to the mean over `half` mm before and after it, less near the ends. */
static void average_angles(const struct work *w, size_t from, size_t to, double half)
{
    struct node *node = &w->nodes.item[from];
    size_t n = to - from;
    struct rotary_angles *sum = mem_alloc(n + 1, sizeof *sum);

    for (size_t i = 0; i + 1 < n; i++) { /* integrals up to node i */
        double length = node[i + 1].along - node[i].along;
        sum[i + 1].lean =
            sum[i].lean + length * (node[i].angles.lean + node[i + 1].angles.lean) / 2;
        sum[i + 1].turn =
            sum[i].turn + length * (node[i].angles.turn + node[i + 1].angles.turn) / 2;
    }
    for (size_t i = 1, low = 0, high = 0; i + 1 < n; i++) {
        double reach =
            fmin(half, fmin(node[i].along - node[0].along, node[n - 1].along - node[i].along));
        while (low < i && node[i].along - node[low].along > reach + 1e-9)
            low++;
        high = high < i ? i : high;
        while (high + 1 < n && node[high + 1].along - node[i].along <= reach + 1e-9)
            high++;
        while (high > i && node[high].along - node[i].along > reach + 1e-9)
            high--;
        double length = node[high].along - node[low].along;
        if (length <= 0)
            continue;
        move_towards(w->planner, &node[i],
                     (struct rotary_angles){(sum[high].lean - sum[low].lean) / length,
                                            (sum[high].turn - sum[low].turn) / length});
    }
    free(sum);
}

/* The turn of a node between its neighbours', as far as that moves the axis by no more than SPARE:
 * beside the pole that is far, and no axis is any nearer to its rule for a turn there. */
static void relax_turn(const struct axis_planner *p, struct node *node, double turn0)
{
    double before = node->along - node[-1].along, after = node[1].along - node->along;
    double sine = fabs(sin(node->angles.lean)), most = sine > 0 ? SPARE / sine : HUGE_VAL;
    double to = before + after > 0 ? (node[-1].angles.turn * after + node[1].angles.turn * before) /
                                         (before + after)
                                   : node->angles.turn;
    struct rotary_angles angles = {node->angles.lean, fmin(fmax(to, turn0 - most), turn0 + most)};
    struct vec3 axis = rotary_axis(&p->frame, angles);

    if (fabs(angles.turn - node->angles.turn) < 1e-9 || !may_have(p, node, axis, SPARE))
        return;
    node->angles = angles;
    node->axis = axis;
    node->by_rule = false;
}

static void relax_turns(const struct work *w, size_t from, size_t to)
{
    enum { SWEEPS = 60 };
    struct node *node = w->nodes.item;
    double *turn0 = mem_alloc(to - from, sizeof *turn0);

    for (size_t i = from; i < to; i++)
        turn0[i - from] = node[i].angles.turn;
    for (int sweep = 0; sweep < SWEEPS; sweep++)
        for (size_t k = 1; k + 1 < to - from; k++) {
            size_t i = sweep % 2 ? to - 1 - k : from + k;
            if (fabs(node[i].angles.lean) < BESIDE)
                relax_turn(w->planner, &node[i], turn0[i - from]);
        }
    free(turn0);
}

/* The axes of nodes [from, to), none of which but the first begins anew. */
static void smooth_axes(const struct work *w, size_t from, size_t to)
{
    enum { SWEEPS = 4 };

    if (to - from < 3)
        return;
    set_allowances(w, from, to);
    for (double half = WIDEST; half > NARROWEST; half /= 2)
        for (int sweep = 0; sweep < SWEEPS; sweep++)
            average_angles(w, from, to, half);
    if (w->planner->options.play > 0)
        relax_turns(w, from, to);
}

static bool has_axis(const struct node *node)
{
    return node->open > 0 || node->rule_open;
}

static void plan_nodes(const struct work *w)
{
    const struct nodes *nodes = &w->nodes;

    for (size_t from = 0, to; from < nodes->n; from = to) {
        for (to = from; to < nodes->n && has_axis(&nodes->item[to]); to++)
            ;
        if (to == from) {
            to++;
            continue;
        }
        choose_axes(w, from, to);
        for (size_t first = from, last; first < to; first = last) {
            for (last = first + 1; last < to && !nodes->item[last].begins; last++)
                ;
            unwrap_angles(w, first, last);
            smooth_axes(w, first, last);
        }
    }
}

/* ---- the points of the run */

static void set_axis(struct run_point *p, double radius, struct vec3 axis)
{
    p->axis = axis;
    p->tip = vec_along(p->ball, -radius, axis);
}

/* The axis at a place of the path between the nodes `at` and at + 1, or of the one that has any. */
static struct vec3 axis_between(const struct work *w, size_t at, const struct run_point *p,
                                double along)
{
    const struct node *a = &w->nodes.item[at], *b = at + 1 < w->nodes.n ? a + 1 : a;

    if (!has_axis(a) || !has_axis(b))
        return has_axis(a) ? a->axis : has_axis(b) ? b->axis : p->axis;
    const struct kinematic_chain *chain = &w->planner->options.chain;
    if (a->by_rule && b->by_rule && (chain->n < 2 || rotary_reaches(chain, p->axis)))
        return p->axis;
    double length = b->along - a->along, s = length > 0 ? (along - a->along) / length : 0;
    if (b->begins)
        return s < 0.5 ? a->axis : b->axis;
    struct rotary_angles to = rotary_angles_between(a->angles, b->angles, fmin(fmax(s, 0), 1));
    struct vec3 axis = rotary_axis(&w->planner->frame, to);
    double off = vec_angle(axis, p->axis), most = fmax(a->allow, b->allow);
    /* by a little, for the angles go straight between nodes; by more the rule itself jumps */
    return off > most && off < most + 0.02 ? vec_slerp(p->axis, axis, most / off) : axis;
}

/* Neither the node `at` nor the one after it, among the first n, has an axis. */
static bool is_without(const struct work *w, size_t n, size_t at)
{
    return !has_axis(&w->nodes.item[at]) && !has_axis(&w->nodes.item[at + 1 < n ? at + 1 : at]);
}

/* Appends a point, and before it, if it is joined to the last, as many on the straight line of the
 * ball's centre that a tip that goes straight does not swing the ball off it by more than may be.
 * An axis that would leave its travel on the way is not turned: check_points parts the run
 * there. */
static void put_point(const struct work *w, size_t after, struct run_point end, double at,
                      bool joined, struct run *to, struct doubles *along)
{
    const struct axis_planner_options *o = &w->planner->options;

    if (to->n > 0 && joined && o->between &&
        rotary_reaches_between(&o->chain, to->item[to->n - 1].axis, end.axis)) {
        const struct run_point last = to->item[to->n - 1];
        double from = along->item[along->n - 1];
        double parts = ceil(vec_angle(last.axis, end.axis) / sqrt(0.8 * o->tolerance / o->radius));
        for (double k = 1; k < parts && at > from; k++) {
            struct run_point p = point_at(w, after, from + k / parts * (at - from));
            set_axis(&p, to->radius, vec_slerp(last.axis, end.axis, k / parts));
            *array_push(to) = p;
            *array_push(along) = from + k / parts * (at - from);
        }
    }
    *array_push(to) = end;
    *array_push(along) = at;
}

/* A node wherever the axis goes past the pole between two: there the way is through it. */
static void add_poles(struct work *w)
{
    size_t n = w->nodes.n;

    for (size_t i = 1, after = 0; i < n; i++) {
        const struct node a = w->nodes.item[i - 1], b = w->nodes.item[i];
        double s = has_axis(&a) && has_axis(&b) && !b.begins && !(a.by_rule && b.by_rule)
                       ? rotary_pole_between(a.angles, b.angles)
                       : -1;
        double along = a.along + s * (b.along - a.along);
        if (s < 0)
            continue;
        while (after + 1 < w->run->n && w->along[after] < along)
            after++;
        struct run_point place = point_at(w, after, along);
        add_node(&w->nodes, &place, along, false);
        struct node *pole = &w->nodes.item[w->nodes.n - 1];
        pole->pole = true;
        pole->open = 1;
        pole->angles = rotary_angles_between(a.angles, b.angles, s);
        pole->angles.lean = 0;
        pole->axis = rotary_axis(&w->planner->frame, pole->angles);
        pole->allow = fmax(a.allow, b.allow);
    }
    qsort(w->nodes.item, w->nodes.n, sizeof *w->nodes.item, by_along);
}

/* A point of the run so near to where the axis passes the pole that it passes it there. */
static bool meets_pole(const struct node *node, struct run_point *p, double apart, double radius)
{
    bool meets = node->pole && apart < SHORTEST && vec_angle(p->axis, node->axis) < AT_POLE;

    if (meets)
        set_axis(p, radius, node->axis);
    return meets;
}

/* Appends the points of the run with their axes and, if any may be put between, those nodes where
 * the axis is not on the straight line. */
static void put_points(const struct work *w, struct run *to, struct doubles *along)
{
    const struct nodes *nodes = &w->nodes;
    size_t at = 0;
    bool joined = false; /* the last point has an axis to go on from */

    for (size_t i = 0; i < w->run->n; i++) {
        struct run_point end = w->run->item[i];
        size_t first = at;
        while (at + 1 < nodes->n && nodes->item[at + 1].along <= w->along[i])
            at++;
        set_axis(&end, to->radius, axis_between(w, at, &end, w->along[i]));
        for (size_t k = first + 1; i > 0 && k <= at && w->planner->options.between; k++) {
            const struct node *node = &nodes->item[k];
            struct run_point *last = &to->item[to->n - 1];
            double from = along->item[along->n - 1];
            if (node->along <= from || node->along >= w->along[i] || !has_axis(node) ||
                meets_pole(node, &end, w->along[i] - node->along, to->radius) ||
                meets_pole(node, last, node->along - from, to->radius) ||
                (!node->pole && vec_angle(vec_slerp(last->axis, end.axis,
                                                    (node->along - from) / (w->along[i] - from)),
                                          node->axis) < BENT))
                continue;
            struct run_point p = point_at(w, i, node->along);
            set_axis(&p, to->radius, node->axis);
            put_point(w, i, p, node->along, joined, to, along);
            joined = true;
        }
        bool none = is_without(w, nodes->n, at);
        put_point(w, i, end, w->along[i], joined && !none, to, along);
        joined = !none;
    }
}

/* A strict node at a place of the path, which is no later than the point `after`. */
static void add_strict(struct work *w, size_t after, double along)
{
    while (after > 0 && w->along[after - 1] >= along)
        after--;
    struct run_point place = point_at(w, after, along);
    add_node(&w->nodes, &place, along, true);
}

/* What becomes of the points; places where the tool is not clear get nodes, and then it returns
 * true, unless this is the last round. */
static bool check_points(struct work *w, const struct run *run, const struct doubles *along,
                         bool last, int *state)
{
    const double far = 1; /* mm: clearances beyond are all the same */
    const struct axis_planner *p = w->planner;
    const double slack = p->options.tolerance / 2;
    const struct holder_sweep sweep = {p->options.guard, &p->options.holder, slack};
    double before = -1, now = 0;
    size_t after = 0, at = 0, nodes = w->nodes.n;
    bool any = false;

    for (size_t i = 0; i < run->n; i++, before = now) {
        const struct run_point *b = &run->item[i];
        now = sweep.guard ? holder_sweep_clearance(&sweep, b, far) : far;
        while (at + 1 < nodes && w->nodes.item[at + 1].along <= along->item[i])
            at++;
        if (is_without(w, nodes, at)) {
            state[i] = AXIS_PLAN_SKIP;
            now = -1;
            continue;
        }
        if (p->options.fixed && vec_dot(b->axis, b->normal) < -1e-6)
            now = -1; /* below the ball's equator, where a node beside it was not */
        state[i] = now >= -slack ? AXIS_PLAN_CUT : AXIS_PLAN_SKIP;
        if (i > 0 && fmin(before, now) >= -slack &&
            (!rotary_reaches_between(&p->options.chain, b[-1].axis, b->axis) ||
             (sweep.guard && !holder_sweep_clear_between(&sweep, b - 1, before, b, now))))
            state[i] = AXIS_PLAN_BREAK;
        if (state[i] == AXIS_PLAN_CUT || last)
            continue;
        while (after + 1 < w->run->n && w->along[after] < along->item[i])
            after++;
        add_strict(w, after, along->item[i]);
        if (state[i] == AXIS_PLAN_BREAK)
            add_strict(w, after, (along->item[i] + along->item[i - 1]) / 2);
        any = true;
    }
    return any;
}

/* Nodes in order, those in one place as one, which is strict if one of them is. */
static void sort_nodes(struct nodes *nodes)
{
    size_t kept = 0;

    qsort(nodes->item, nodes->n, sizeof *nodes->item, by_along);
    for (size_t i = 0; i < nodes->n; i++) {
        struct node *last = &nodes->item[kept > 0 ? kept - 1 : 0], *node = &nodes->item[i];
        if (node->pole)
            continue;
        if (kept > 0 && node->along - last->along < 1e-6) {
            last->strict = last->strict || node->strict;
            free(node->state);
        } else {
            nodes->item[kept++] = *node;
        }
    }
    nodes->n = kept;
}

static void measure(struct work *w)
{
    w->along = mem_alloc(w->run->n, sizeof *w->along);
    for (size_t i = 1; i < w->run->n; i++)
        w->along[i] =
            w->along[i - 1] + vec_distance(w->run->item[i - 1].ball, w->run->item[i].ball);
}

/* The run with the rule's axes averaged. */
static void average_rule(const struct work *w, struct run *averaged)
{
    const struct run *run = w->run;
    struct vec3 *rule = mem_alloc(run->n, sizeof *rule);

    for (size_t i = 0; i < run->n; i++)
        rule[i] = run->item[i].axis;
    axis_smooth_rules(run->item, run->n, w->planner->options.radius, w->planner->options.inward,
                      rule);
    averaged->radius = run->radius;
    for (size_t i = 0; i < run->n; i++) {
        struct run_point p = run->item[i];
        p.axis = rule[i];
        *array_push(averaged) = p;
    }
    free(rule);
}

static void append(struct axis_plan *plan, const struct run *from, const int *state,
                   const struct work *w)
{
    for (size_t i = 0; i < from->n; i++) {
        *array_push(&plan->run) = from->item[i];
        *array_push(&plan->state) = state[i];
    }
    for (size_t i = 0; i < w->nodes.n; i++)
        if (has_axis(&w->nodes.item[i]) && !w->nodes.item[i].by_rule && !w->nodes.item[i].pole)
            plan->leaned =
                fmax(plan->leaned, vec_angle(w->nodes.item[i].axis, w->nodes.item[i].rule));
}

void axis_plan_run(const struct axis_planner *planner, const struct run *run,
                   struct axis_plan *plan)
{
    struct work w = {.planner = planner, .run = run};
    struct run points = {.radius = run->radius}, averaged = {0};
    struct doubles along = {0};
    struct ints state = {0};
    bool again = run->n > 0;

    plan->run.radius = run->radius;
    if (run->n == 0)
        return;
    measure(&w);
    if (planner->options.play > 0) {
        average_rule(&w, &averaged);
        w.run = &averaged;
    }
    first_nodes(&w);
    for (int round = 1; again; round++) {
        sort_nodes(&w.nodes);
        for (size_t i = 0; i < w.nodes.n; i++)
            find_open(planner, &w.nodes.item[i]);
        plan_nodes(&w);
        if (planner->options.between)
            add_poles(&w);
        points.n = along.n = 0;
        put_points(&w, &points, &along);
        array_reserve(&state, points.n);
        again = check_points(&w, &points, &along, round == ROUNDS, state.item);
    }
    append(plan, &points, state.item, &w);
    for (size_t i = 0; i < w.nodes.n; i++)
        free(w.nodes.item[i].state);
    array_free(&w.nodes);
    array_free(&points);
    array_free(&averaged);
    array_free(&along);
    array_free(&state);
    free(w.along);
}
