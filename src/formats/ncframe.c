/* ncframe - see ncframe.h. */
#include "ncframe.h"

static const double inch = 25.4; /* mm */

/* The frame's directions in the work, and what one of its units is in mm. */
struct frame {
    struct vec3 x, y, z;
    double unit;
};

static struct vec3 direction(const struct frame *f, struct vec3 d)
{
    return vec(vec_dot(f->x, d), vec_dot(f->y, d), vec_dot(f->z, d));
}

static struct vec3 point(const struct frame *f, struct vec3 p)
{
    return vec_scale(1 / f->unit, direction(f, p));
}

static struct pose pose(const struct frame *f, struct pose at)
{
    return (struct pose){point(f, at.p), vec_unit(direction(f, at.a))};
}

static void spline_to(const struct frame *f, struct path_spline *s)
{
    for (size_t i = 0; i < s->curve.poles; i++) {
        s->curve.pole[i] = point(f, s->curve.pole[i]);
        if (s->curve.head)
            s->curve.head[i] = point(f, s->curve.head[i]);
    }
    s->curve.length /= f->unit;
    for (size_t i = 0; f->unit != 1 && i < s->curve.poles + (size_t)s->curve.degree + 1; i++)
        s->curve.knot[i] /= f->unit; /* they go with the length */
    for (size_t i = 0; i < s->fallback.n; i++)
        s->fallback.item[i] = pose(f, s->fallback.item[i]);
}

static void path_to(const struct frame *f, struct path *path)
{
    for (size_t i = 0; i < path->item.n; i++) {
        struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_FEED)
            item->feed /= f->unit;
        if (item->kind <= PATH_HOLE)
            item->to = pose(f, item->to);
    }
    for (size_t i = 0; i < path->contact.n; i++) {
        struct contact *at = &path->contact.item[i];
        *at = (struct contact){point(f, at->p), direction(f, at->n)};
    }
    for (size_t i = 0; i < path->arc.n; i++) {
        struct path_arc *arc = &path->arc.item[i];
        arc->centre = point(f, arc->centre);
        arc->axis = direction(f, arc->axis);
        arc->radius /= f->unit;
    }
    for (size_t i = 0; i < path->spline.n; i++)
        spline_to(f, &path->spline.item[i]);
    for (size_t i = 0; i < path->cycle.n; i++) {
        struct path_cycle *c = &path->cycle.item[i];
        double *const length[] = {&c->depth, &c->clear, &c->retract, &c->step,
                                  &c->next,  &c->feed,  &c->pitch};
        for (size_t k = 0; k < sizeof length / sizeof *length; k++)
            *length[k] /= f->unit;
    }
}

/* d, r, e, f and the height; the others are angles */
static void cutter_to_inch(double cutter[7])
{
    for (int i = 0; i < 4; i++)
        cutter[i] /= inch;
    cutter[6] /= inch;
}

void nc_frame_inch(struct path *path, struct machine *machine, struct nc_wish *wish)
{
    const struct frame frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, inch};
    path_to(&frame, path);
    cutter_to_inch(path->head.cutter);
    for (size_t i = 0; i < path->tool.n; i++)
        cutter_to_inch(path->tool.item[i].cutter);
    path->head.clearance /= inch;
    for (int i = MACHINE_X; i <= MACHINE_Z; i++) {
        machine->min[i] /= inch;
        machine->max[i] /= inch;
        machine->rapid[i] /= inch;
    }
    for (int i = 0; i < machine->chain.n; i++)
        machine->chain.rotary[i].centre = vec_scale(1 / inch, machine->chain.rotary[i].centre);
    machine->retract /= inch;
    wish->chord /= inch;
    wish->feed /= inch;
    wish->unit = inch;
}

bool nc_frame_holes(const struct path *path)
{
    bool any = false;
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind != PATH_HOLE)
            continue;
        any = true;
        const struct path_cycle *c = &path->cycle.item[item->index];
        if (c->kind == CYCLE_TAP && !(c->pitch > 0 || path->head.spindle > 0))
            return false;
    }
    return any;
}

bool nc_frame_fixed(const struct path *path, struct vec3 *axis)
{
    bool found = false;
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->kind > PATH_HOLE)
            continue;
        if (!found)
            *axis = item->to.a;
        found = true;
        bool turns = item->kind == PATH_SPLINE && path->spline.item[item->index].curve.head;
        if (turns || vec_angle(*axis, item->to.a) > 1e-7)
            return false;
    }
    return found;
}

void nc_frame_angles(struct vec3 axis, double *about_x, double *about_y)
{
    *about_x = atan2(-axis.y, axis.z);
    *about_y = atan2(axis.x, hypot(axis.y, axis.z));
}

int nc_frame_plane(struct path *path, struct machine *machine, struct vec3 axis,
                   struct error *error)
{
    const double zero[ROTARY_MAX] = {0};
    double q[ROTARY_MAX], a, b;
    int over;
    if (chain_choose(&machine->chain, axis, zero, false, -1, q, &over) != 0)
        return error_set(error, "%s: found tool axis %.6f %.6f %.6f, which %s does not reach",
                         path->name, axis.x, axis.y, axis.z, machine->name);
    nc_frame_angles(axis, &a, &b);
    struct vec3 x = vec(1, 0, 0), y = vec_turn(vec(0, 1, 0), x, a);
    struct frame frame = {vec_turn(x, y, b), y, axis, 1};
    path_to(&frame, path);
    path->head.clearance = NAN; /* a height of the work's Z, not of the plane's */
    machine->chain.n = 0;
    for (int i = MACHINE_X; i <= MACHINE_Z; i++) { /* travel is along other directions there */
        machine->min[i] = -HUGE_VAL;
        machine->max[i] = HUGE_VAL;
    }
    return 0;
}
