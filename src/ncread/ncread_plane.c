/* ncread_plane - see ncread_plane.h. */
#include "ncread_plane.h"

#include <string.h>

#include "ncread_state.h"
#include "math/elementary.h"
#include "base/num.h"

enum {
    CYCLE800_ANGLES = 7,
    CYCLE800_MODE = 3,
    AXIS_BY_AXIS = 57,
    CYCLE800_SHIFT = 10,
    CYCLE800_DIRECTION = 13, /* 0: the plane is reckoned alone, nothing turns */
    ARGUMENTS = 14
};

static void forget_place(struct ncread *c)
{
    memset(c->here.known, 0, sizeof c->here.known);
    c->here.has_axis = false;
}

/* Off: where the rotary axes stand is unknown until the program names them. */
static int leave_plane(struct ncread *c)
{
    c->tilted.on = false;
    forget_place(c);
    for (int i = 0; i < VERIFY_KINEMATICS_AXES; i++)
        c->here.turned[i] = false;
    if (c->options->kinematics.n == 0)
        c->here.has_axis = true;
    return 1;
}

/* Turned about its own X, Y or Z (0, 1, 2), degrees. */
static void turn_frame(struct ncread_plane *p, int axis, double degrees)
{
    struct vec3 about = axis == 0 ? p->x : axis == 1 ? p->y : p->z;
    p->x = vec_turn(p->x, about, RADIANS(degrees));
    p->y = vec_turn(p->y, about, RADIANS(degrees));
    p->z = vec_turn(p->z, about, RADIANS(degrees));
}

static int enter_plane(struct ncread *c, struct vec3 origin, const int axis[3],
                       const double degrees[3], bool brought, struct error *error)
{
    if (c->tcp || c->tilted.on)
        return ncread_error(c, error,
                            "a tilted plane within another or under tool centre point "
                            "control");
    c->tilted = (struct ncread_plane){true, brought, origin, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int i = 0; i < 3; i++)
        turn_frame(&c->tilted, axis[i], degrees[i]);
    forget_place(c);
    return 1;
}

int ncread_plane_g(struct ncread *c, struct error *error)
{
    static const char *const name[] = {"X", "Y", "Z", "I", "J", "K"};
    static const int euler[] = {2, 0, 2};
    double v[6];
    bool begins = false, others = false, leaves = false;
    for (size_t i = 0; i < c->words.n; i++) {
        int code =
            c->words.item[i].name[0] == 'G' ? (int)lround(c->words.item[i].value[0] * 10) : -1;
        begins = begins || code == 682;
        others = others || code == 531;
        leaves = leaves || code == 690;
    }
    if (begins + others + leaves > 1)
        return ncread_error(c, error, "G68.2, G53.1 and G69 in one block");
    if (others && !c->tilted.on)
        return ncread_error(c, error, "G53.1 without G68.2");
    if (others) {
        c->tilted.brought = true;
        return 1;
    }
    if (leaves && c->tilted.on)
        leave_plane(c);
    if (!begins)
        return 0;
    for (int i = 0; i < 6; i++) {
        const struct ncread_word *w = ncread_word_find(&c->words, name[i]);
        if (!w || !w->pointed)
            return ncread_error(c, error, "G68.2 wants X Y Z I J K with decimal points");
        v[i] = w->value[0];
    }
    return enter_plane(c, vec(v[0], v[1], v[2]), euler, v + 3, false, error) < 0 ? -1 : 2;
}

int ncread_plane_cycle800(struct ncread *c, struct error *error)
{
    static const int axes[] = {0, 1, 2};
    const char *s = strstr(c->text, "CYCLE800(");
    double v[ARGUMENTS] = {[CYCLE800_DIRECTION] = -1};
    if (!s)
        return 0;
    s = strchr(s, '(') + 1;
    if (*s == ')')
        return leave_plane(c);
    for (int i = 0; i < ARGUMENTS && *s; i++) {
        num_read(&s, &v[i]);
        s += strcspn(s, ",)");
        s += *s == ',';
    }
    if (v[CYCLE800_MODE] != AXIS_BY_AXIS)
        return ncread_error(c, error, "CYCLE800 in another mode than 57, axis by axis");
    for (int i = 0; i < 3; i++)
        if (v[CYCLE800_SHIFT + i] != 0)
            return ncread_error(c, error, "CYCLE800 with a shift in the plane");
    return enter_plane(c, vec(v[4], v[5], v[6]), axes, v + CYCLE800_ANGLES,
                       v[CYCLE800_DIRECTION] != 0, error);
}

int ncread_plane_spatial(struct ncread *c, struct error *error)
{
    /* about the axes of the frame that is not tilted in the order A B C, which is the same as about
     * the axes as they turn in the order C B A (TNC 620 and 640, PLANE SPATIAL, Application) */
    static const char *const name[] = {" SPC", " SPB", " SPA"};
    static const int axes[] = {2, 1, 0};
    const char *spatial = strstr(c->text, "PLANE SPATIAL ");
    double v[3];
    if (strstr(c->text, "PLANE RESET"))
        return leave_plane(c);
    if (!spatial)
        return 0;
    for (int i = 0; i < 3; i++) {
        const char *s = strstr(spatial + 13, name[i]);
        if (s)
            s += strlen(name[i]);
        if (!s || (*s != '+' && *s != '-') || !num_read(&s, &v[i]))
            return ncread_error(c, error, "PLANE SPATIAL wants SPA SPB SPC with their signs");
    }
    if (!strstr(c->text, " TURN") && !strstr(c->text, " MOVE"))
        return ncread_error(c, error, "PLANE SPATIAL without TURN or MOVE");
    return enter_plane(c, vec(0, 0, 0), axes, v, true, error);
}

bool ncread_plane_reached(const struct ncread *c)
{
    const double upright = RADIANS(0.02);
    return !c->tilted.on || c->tilted.brought ||
           (c->here.has_axis && vec_angle(c->here.axis, c->tilted.z) < upright);
}

static struct vec3 direction_in_work(const struct ncread_plane *p, struct vec3 v)
{
    return vec_along(vec_along(vec_scale(v.x, p->x), v.y, p->y), v.z, p->z);
}

static struct vec3 point_in_work(const struct ncread_plane *p, struct vec3 v)
{
    return vec_add(p->origin, direction_in_work(p, v));
}

static void turn_ends(const struct ncread_plane *p, struct nc_piece *piece)
{
    for (int i = 0; i < 2; i++) {
        piece->p[i] = point_in_work(p, piece->p[i]);
        piece->q[i] = direction_in_work(p, piece->q[i]);
    }
}

void ncread_plane_turn(struct ncread *c, struct nc_piece *piece)
{
    const struct ncread_plane *p = &c->tilted;
    if (!p->on)
        return;
    turn_ends(p, piece);
    if (piece->shape == SHAPE_ARC) {
        struct nc_motion_arc *arc = &c->motion->arc.item[piece->index];
        arc->centre = point_in_work(p, arc->centre);
        arc->normal = direction_in_work(p, arc->normal);
    } else if (piece->shape == SHAPE_POLYNOMIAL) {
        struct nc_motion_polynomial *sum = &c->motion->polynomial.item[piece->index];
        for (int i = 0; i < NC_MOTION_DEGREE; i++)
            sum->p[i] = direction_in_work(p, sum->p[i]);
    }
}

void ncread_plane_turn_poles(struct ncread *c)
{
    const struct ncread_plane *p = &c->tilted;
    if (!p->on)
        return;
    for (size_t i = 0; i < c->pole_p.n; i++) {
        c->pole_p.item[i] = point_in_work(p, c->pole_p.item[i]);
        c->pole_q.item[i] = direction_in_work(p, c->pole_q.item[i]);
    }
    turn_ends(p, &c->spline);
}
