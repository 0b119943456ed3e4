/* post_words - see post_words.h. */
#include "post_words.h"

#include <string.h>

#include "base/num.h"
#include "post_feed.h"

struct vec3 nc_above_plane(const struct nc_program *p, const struct nc_move *first)
{
    return post_frame_work(p->planes.item[p->at_plane], dialect_of(p->control)->plane_euler,
                           p->plan->ability.digits.angle, first->p);
}

bool nc_zero_first(const struct nc_program *p)
{
    return p->plan->ability.tcp && p->machine->tcp_frame == TCP_FRAME_ZERO && p->machine->chain.n;
}

/* The rotary axes at zero, or as near as their travel lets them be. */
static void zero_angles(const struct nc_program *p, double q[])
{
    for (int i = 0; i < ROTARY_MAX; i++) {
        const struct rotary *r = &p->machine->chain.rotary[i];
        q[i] = i < p->machine->chain.n ? fmin(fmax(0, r->min), r->max) : 0;
    }
}

void nc_rotary_start(struct nc_program *p, const struct nc_move *first)
{
    double zero[ROTARY_MAX];
    zero_angles(p, zero);
    nc_rotary(p, nc_zero_first(p) ? zero : first->q);
}

const struct nc_move *nc_first_move(const struct nc_program *p)
{
    const struct nc_move *move = p->plan->move.item + p->tooling.next;
    while (!nc_moves(move))
        move++;
    return move;
}

void nc_place(struct nc_program *p, struct vec3 to)
{
    int digits = p->plan->ability.digits.linear;
    nc_modal(&p->w, NC_X, "X", to.x, digits);
    nc_modal(&p->w, NC_Y, "Y", to.y, digits);
    nc_modal(&p->w, NC_Z, "Z", to.z, digits);
}

static void vector_words(struct nc_program *p, const char *const address[3], struct vec3 a)
{
    struct nc_writer *w = &p->w;
    if (w->known[NC_I] && w->value[NC_I] == a.x && w->value[NC_J] == a.y && w->value[NC_K] == a.z)
        return;
    nc_forget(w, NC_I, NC_K);
    nc_modal(w, NC_I, address[0], a.x, p->plan->ability.digits.vector);
    nc_modal(w, NC_J, address[1], a.y, p->plan->ability.digits.vector);
    nc_modal(w, NC_K, address[2], a.z, p->plan->ability.digits.vector);
}

void nc_rotary_axes(struct nc_program *p, int n, const double q[])
{
    const struct machine *m = p->machine;
    for (int i = n - 1; i >= 0; i--) { /* the tilting axis first, as people write it */
        const char address[2] = {machine_letter(m->letter[i]), '\0'};
        nc_modal(&p->w, i ? NC_Q1 : NC_Q0, address, DEGREES(q[i]), p->plan->ability.digits.angle);
    }
}

void nc_rotary(struct nc_program *p, const double q[])
{
    nc_rotary_axes(p, p->machine->chain.n, q);
}

void nc_axis(struct nc_program *p, const struct nc_move *move, const char *const address[3])
{
    if (p->plan->ability.mode == INTERPOLATE_VECTOR)
        vector_words(p, address, p->plan->vector.item[move->vector]);
    else
        nc_rotary(p, move->q);
}

void nc_feed(struct nc_program *p, const struct nc_move *move)
{
    if (move->kind == NC_RAPID)
        return;
    if (p->w.inverse)
        nc_forget(&p->w, NC_F, NC_F);
    nc_modal(&p->w, NC_F, "F", move->feed, post_feed_digits(&p->plan->ability, move->feed));
}

/* ---- tools and work offsets */

const char *nc_work_offset(const struct nc_program *p, size_t n)
{
    const struct machine *m = p->machine;
    for (size_t i = n < MACHINE_OFFSETS ? n : MACHINE_OFFSETS; i-- > 0;)
        if (*m->tool_offset[i])
            return m->tool_offset[i];
    return n ? m->offset : "";
}

int nc_tool_after(const struct nc_program *p)
{
    size_t next = p->tooling.taken;
    const struct nc_plan *plan = p->plan;
    for (size_t i = 0; i < plan->move.n; i++)
        if (plan->move.item[i].kind == NC_TOOL && plan->move.item[i].index >= next)
            return p->path->tool.item[plan->move.item[i].index].number;
    return 0;
}

const char *nc_tool_name(const struct nc_program *p)
{
    const struct machine_tool *tool = machine_tool(p->machine, p->tooling.number);
    const struct path *path = p->path;
    if (!p->machine->tool_names || !dialect_of(p->control)->tool_named)
        return NULL;
    if (tool && *tool->name)
        return tool->name;
    const char *name =
        p->tooling.taken ? path->tool.item[p->tooling.taken - 1].name : path->head.tool_name;
    return *name ? name : NULL;
}
