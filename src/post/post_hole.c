/* post_hole - see post_hole.h. */
#include "post_hole.h"

#include "base/num.h"

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
