/* post_tilted - see post_tilted.h. */
#include "post_tilted.h"

#include "base/num.h"
#include "machine/ik_choose.h"
#include "post_hole.h"
#include "post_ik.h"

enum { LOOKS = 24 /* on an arc or a curve */ };

/* Where the program is. */
struct tilted {
    const struct nc_program *program;
    const struct machine *machine;
    struct error *error;
    struct kinematic_chain chain; /* of the tool in the spindle */
    struct vec3 x, y, z;          /* the plane's directions in the work, of the program's unit */
    double q[ROTARY_MAX];
    double near; /* from 0, mm: no axis leaves its travel */
    bool begun;  /* the tool has come to the plane */
    struct vec3 at;
};

static void turn_to_plane(struct tilted *t, size_t index)
{
    const struct nc_program *p = t->program;
    enum nc_plane_angles angles = dialect_of(p->control)->plane_angles;
    int digits = p->plan->ability.digits.angle, over;
    double unit = p->options.unit;
    struct nc_plane plane = p->planes.item[index];
    t->x = post_frame_work(plane, angles, digits, vec(unit, 0, 0));
    t->y = post_frame_work(plane, angles, digits, vec(0, unit, 0));
    t->z = post_frame_work(plane, angles, digits, vec(0, 0, unit));
    ik_choose(&t->chain, plane.axis, t->q, true, -1, t->q, &over);
    t->begun = false;
}

static void take_tool(struct tilted *t, int number)
{
    t->chain = t->machine->chain;
    post_ik_chain(t->machine, number, 1, &t->chain);
    t->begun = false;
}

/* The first `axes` linear axes, mm. */
static int check_travel(const struct tilted *t, const struct nc_move *move, struct vec3 linear,
                        int axes, const char *what)
{
    const struct machine *m = t->machine;
    double half = 0.5 * t->program->options.unit / num_ten[t->program->plan->ability.digits.linear];
    const double at[] = {linear.x, linear.y, linear.z};
    for (int i = 0; i < axes; i++)
        if (!(at[i] >= m->min[i] - half && at[i] <= m->max[i] + half))
            return error_at(t->error, t->program->path->name, move->line,
                            "axis %c of %s: found %s %.5f, expected its travel %g to %g",
                            machine_letter(i), m->name, what, at[i], m->min[i], m->max[i]);
    return 0;
}

static int check_place(const struct tilted *t, const struct nc_move *move, struct vec3 p)
{
    struct vec3 tip =
        vec_along(vec_along(vec_scale(p.x, t->x), p.y, t->y), p.z, t->z); /* in the work, mm */
    if (vec_dot(tip, tip) < t->near * t->near)
        return 0;
    if (!t->begun && check_travel(t, move, tip, 2, "above a tilted plane a position of") != 0)
        return -1;
    return check_travel(t, move, chain_linear(&t->chain, tip, t->q), 3,
                        "in a tilted plane a position of");
}

static int check_move(struct tilted *t, const struct nc_move *move)
{
    const struct nc_plan *plan = t->program->plan;
    const struct block_pose from = {.p = t->at}, to = {.p = move->p};
    struct vec3 end = move->p;
    int result = 0;
    if (move->kind == NC_HOLE)
        end.z = nc_hole_bottom(&plan->hole.item[move->index]);
    result = check_place(t, move, end);
    for (int i = 1; i < LOOKS && result == 0 && move->kind == NC_ARC; i++) {
        struct motion arc = nc_arc_motion(&plan->arc.item[move->index], &from, &to);
        result = check_place(t, move, motion_at(&arc, (double)i / LOOKS).p);
    }
    for (int i = 1; i < LOOKS && result == 0 && move->kind == NC_SPLINE; i++)
        result = check_place(
            t, move, nc_spline_at(&plan->spline.item[move->index], t->at, (double)i / LOOKS).p);
    t->at = move->p;
    t->begun = true;
    return result;
}

int post_tilted_check(const struct nc_program *program, const struct machine *machine,
                      struct error *error)
{
    struct tilted t = {.program = program,
                       .machine = machine,
                       .error = error,
                       .near = post_ik_safe_radius(machine)};
    int result = 0;
    chain_zero(&machine->chain, t.q);
    take_tool(&t, program->path->head.tool);
    turn_to_plane(&t, 0);
    for (size_t i = 0; i < program->plan->move.n && result == 0; i++) {
        const struct nc_move *move = &program->plan->move.item[i];
        if (move->kind == NC_TOOL)
            take_tool(&t, program->path->tool.item[move->index].number);
        else if (move->kind == NC_PLANE)
            turn_to_plane(&t, move->index);
        else if (nc_moves(move))
            result = check_move(&t, move);
    }
    return result;
}
