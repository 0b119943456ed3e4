/* post_frame - see post_frame.h. */
#include "post_frame.h"

#include <stdlib.h>

#include "base/num.h"
#include "machine/ik_choose.h"

static const double inch = 25.4; /* mm */

/* The frame's directions in the work, and what one of its units is in mm. */
struct frame {
    struct vec3 x, y, z;
    double unit;
    bool upright; /* the tool stands along z, but for the rounding of its angles */
};

static struct vec3 direction(const struct frame *f, struct vec3 d)
{
    return vec(vec_dot(f->x, d), vec_dot(f->y, d), vec_dot(f->z, d));
}

static struct vec3 point(const struct frame *f, struct vec3 p)
{
    return vec_scale(1 / f->unit, direction(f, p));
}

static struct pose pose_to(const struct frame *f, struct pose at)
{
    struct vec3 axis = f->upright ? vec(0, 0, 1) : vec_unit(direction(f, at.a));
    return (struct pose){point(f, at.p), axis};
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
        s->fallback.item[i] = pose_to(f, s->fallback.item[i]);
}

static void arc_to(const struct frame *f, struct path_arc *arc)
{
    arc->centre = point(f, arc->centre);
    arc->axis = direction(f, arc->axis);
    if (f->upright && fabs(arc->axis.z) > 1 - 1e-8)
        arc->axis = vec(0, 0, arc->axis.z > 0 ? 1 : -1);
    arc->radius /= f->unit;
}

/* The items [from, to). */
static void path_to(const struct frame *f, struct path *path, size_t from, size_t to)
{
    for (size_t i = from; i < to; i++) {
        struct path_item *item = &path->item.item[i];
        if (item->kind == PATH_FEED)
            item->feed /= f->unit;
        if (item->kind > PATH_HOLE)
            continue;
        item->to = pose_to(f, item->to);
        if (item->touches) {
            struct contact *at = &path->contact.item[item->contact];
            *at = (struct contact){point(f, at->p), direction(f, at->n)};
        }
        if (item->kind == PATH_ARC)
            arc_to(f, &path->arc.item[item->index]);
        if (item->kind == PATH_SPLINE)
            spline_to(f, &path->spline.item[item->index]);
    }
}

static void cycles_to(const struct frame *f, struct path *path)
{
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

void post_frame_inch(struct path *path, struct machine *machine, struct nc_plan_options *options)
{
    const struct frame frame = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, inch, false};
    path_to(&frame, path, 0, path->item.n);
    cycles_to(&frame, path);
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
    options->chord /= inch;
    options->feed /= inch;
    options->unit = inch;
}

bool post_frame_holes(const struct path *path)
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
        if (c->kind == CYCLE_MANUAL || c->clear < 0)
            return false;
    }
    return any;
}

static bool same_direction(struct vec3 a, struct vec3 b)
{
    return (a.x == b.x && a.y == b.y && a.z == b.z) || vec_angle(a, b) < 1e-7;
}

bool post_frame_planes(const struct path *path, struct nc_planes *planes)
{
    bool home = true; /* the tool comes from there */
    planes->n = 0;
    for (size_t i = 0; i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        bool rapid = item->kind == PATH_HOLE || path_is_rapid(item);
        home = home || item->kind == PATH_TOOL;
        if (item->kind > PATH_HOLE)
            continue;
        bool turns = item->kind == PATH_SPLINE && path->spline.item[item->index].curve.head;
        bool goes_on = planes->n && same_direction(planes->item[planes->n - 1].axis, item->to.a);
        bool may = rapid || (home && item->kind == PATH_POINT);
        if (turns || (!goes_on && !may)) {
            array_free(planes);
            *planes = (struct nc_planes){0};
            return false;
        }
        if (!goes_on)
            *array_push(planes) = (struct nc_plane){.from = i, .axis = item->to.a};
        home = false;
    }
    return planes->n > 0;
}

bool post_frame_upright(const struct nc_planes *planes)
{
    return planes->n == 1 && same_direction(planes->item[0].axis, vec(0, 0, 1));
}

static struct vec3 turned_about(struct vec3 v, struct vec3 about, double degrees)
{
    return vec_turn(v, about, RADIANS(degrees));
}

/* All kinds of angles, and the frame that one of them, as printed, makes. */
static struct frame plane_frame(struct nc_plane *p, enum nc_plane_angles angles, int digits)
{
    const struct vec3 x0 = {1, 0, 0}, y0 = {0, 1, 0}, z0 = {0, 0, 1};
    struct vec3 a = p->axis, x, y, z;
    p->a = num_round(DEGREES(atan2(-a.y, a.z)), digits);
    p->b = num_round(DEGREES(atan2(a.x, hypot(a.y, a.z))), digits);
    y = turned_about(y0, x0, p->a);
    x = turned_about(x0, y, p->b);
    bool upright = hypot(a.x, a.y) < 1e-9;
    p->i = upright ? 0 : num_round(DEGREES(atan2(a.x, -a.y)), digits);
    p->j = num_round(DEGREES(atan2(hypot(a.x, a.y), a.z)), digits);
    p->k = num_round(DEGREES(upright ? atan2(x.y, x.x) : atan2(x.z, y.z)), digits);
    p->spa = num_round(DEGREES(atan2(-a.y, hypot(a.x, a.z))), digits);
    p->spb = num_round(DEGREES(atan2(a.x, a.z)), digits);
    if (angles == NC_PLANE_EULER) {
        struct vec3 node = turned_about(x0, z0, p->i);
        z = turned_about(z0, node, p->j);
        x = turned_about(node, z, p->k);
    } else if (angles == NC_PLANE_SPATIAL) {
        z = turned_about(turned_about(z0, x0, p->spa), y0, p->spb);
        x = turned_about(x0, y0, p->spb);
    } else {
        z = turned_about(turned_about(z0, y0, p->b), x0, p->a);
    }
    return (struct frame){x, vec_cross(z, x), z, 1, true};
}

struct vec3 post_frame_work(struct nc_plane plane, enum nc_plane_angles angles, int digits,
                            struct vec3 p)
{
    struct frame f = plane_frame(&plane, angles, digits);
    return vec_add(vec_add(vec_scale(p.x, f.x), vec_scale(p.y, f.y)), vec_scale(p.z, f.z));
}

static int expect_reach(const struct path *path, const struct machine *machine, struct vec3 axis,
                        struct error *error)
{
    const double zero[ROTARY_MAX] = {0};
    double q[ROTARY_MAX];
    int over;
    if (ik_choose(&machine->chain, axis, zero, false, -1, q, &over) == 0)
        return 0;
    return error_set(error, "%s: found tool axis %.6f %.6f %.6f, which %s does not reach",
                     path->name, axis.x, axis.y, axis.z, machine->name);
}

/* A PATH_PLANE before the first motion of each plane but the first. */
static void add_planes(struct path *path, const struct nc_planes *planes)
{
    struct path_item *old = path->item.item;
    size_t n = path->item.n, next = 1;
    path->item.item = NULL;
    path->item.n = path->item.cap = 0;
    array_reserve(&path->item, n + planes->n);
    for (size_t i = 0; i < n; i++) {
        if (next < planes->n && planes->item[next].from == i) {
            *array_push(&path->item) = (struct path_item){
                .kind = PATH_PLANE, .line = old[i].line, .index = (unsigned)next};
            next++;
        }
        *array_push(&path->item) = old[i];
    }
    free(old);
}

int post_frame_tilt(struct path *path, struct machine *machine, struct nc_planes *planes,
                    enum nc_plane_angles angles, int digits, struct error *error)
{
    for (size_t i = 0; i < planes->n; i++) {
        struct nc_plane *plane = &planes->item[i];
        if (expect_reach(path, machine, plane->axis, error) != 0)
            return -1;
        struct frame frame = plane_frame(plane, angles, digits);
        path_to(&frame, path, plane->from, i + 1 < planes->n ? plane[1].from : path->item.n);
    }
    add_planes(path, planes);
    path->head.clearance = NAN; /* a height of the work's Z, not of the plane's */
    machine->chain.n = 0;
    for (int i = MACHINE_X; i <= MACHINE_Z; i++) { /* travel is along other directions there */
        machine->min[i] = -HUGE_VAL;
        machine->max[i] = HUGE_VAL;
    }
    return 0;
}
