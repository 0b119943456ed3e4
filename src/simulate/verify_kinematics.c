/* verify_kinematics - see verify_kinematics.h. */
#include "simulate/verify_kinematics.h"

struct matrix3 {
    double m[3][3];
};

/* The rotation about a unit axis, columns and rows written out. */
static struct matrix3 rotation(struct vec3 u, double degrees)
{
    double c = cos(RADIANS(degrees)), s = sin(RADIANS(degrees)), v = 1 - c;
    return (struct matrix3){
        {{c + u.x * u.x * v, u.x * u.y * v - u.z * s, u.x * u.z * v + u.y * s},
         {u.y * u.x * v + u.z * s, c + u.y * u.y * v, u.y * u.z * v - u.x * s},
         {u.z * u.x * v - u.y * s, u.z * u.y * v + u.x * s, c + u.z * u.z * v}}};
}

static struct vec3 matrix_times(const struct matrix3 *a, struct vec3 p)
{
    return vec(a->m[0][0] * p.x + a->m[0][1] * p.y + a->m[0][2] * p.z,
               a->m[1][0] * p.x + a->m[1][1] * p.y + a->m[1][2] * p.z,
               a->m[2][0] * p.x + a->m[2][1] * p.y + a->m[2][2] * p.z);
}

/* p turned about one of the axes, which goes through its centre. */
static struct vec3 turn_about(const struct verify_kinematics_axis *axis, double degrees,
                              struct vec3 p)
{
    struct matrix3 r = rotation(axis->axis, degrees);
    return vec_add(axis->centre, matrix_times(&r, vec_sub(p, axis->centre)));
}

struct vec3 verify_kinematics_axis_at(const struct verify_kinematics *kinematics, const double q[])
{
    struct vec3 a = kinematics->tool;
    for (int i = kinematics->n - 1; i >= 0; i--) {
        struct matrix3 r = rotation(kinematics->axis[i].axis, q[i]);
        a = matrix_times(&r, a);
    }
    return a;
}

/* How far the heads move the tip from where it is at zero. */
static struct vec3 head_shift(const struct verify_kinematics *kinematics, const double q[])
{
    struct vec3 p = {0, 0, 0};
    for (int i = kinematics->n - 1; i >= 0; i--)
        if (!kinematics->axis[i].table)
            p = turn_about(&kinematics->axis[i], q[i], p);
    return p;
}

struct vec3 verify_kinematics_tip(const struct verify_kinematics *kinematics, struct vec3 linear,
                                  const double q[])
{
    struct vec3 p = vec_add(linear, head_shift(kinematics, q));
    for (int i = kinematics->n - 1; i >= 0; i--)
        if (kinematics->axis[i].table)
            p = turn_about(&kinematics->axis[i], q[i], p);
    return p;
}

struct vec3 verify_kinematics_linear(const struct verify_kinematics *kinematics, struct vec3 tip,
                                     const double q[])
{
    for (int i = 0; i < kinematics->n; i++)
        if (kinematics->axis[i].table)
            tip = turn_about(&kinematics->axis[i], -q[i], tip);
    return vec_sub(tip, head_shift(kinematics, q));
}

/* The angle about u that brings p nearest to r, degrees. */
static double angle_about(struct vec3 u, struct vec3 p, struct vec3 r, double otherwise)
{
    struct vec3 a = vec_reject(p, u), b = vec_reject(r, u);
    if (vec_length(a) < 1e-9 || vec_length(b) < 1e-9)
        return otherwise;
    return DEGREES(atan2(vec_dot(u, vec_cross(a, b)), vec_dot(a, b)));
}

/* The whole turns nearest to `near` that are within the travel; *over: none is. */
static double nearest_turn(const struct verify_kinematics_axis *axis, double angle, double near,
                           bool *over)
{
    const double slack = 1e-6;
    angle += 360 * round((near - angle) / 360);
    double within = angle;
    if (angle > axis->max + slack)
        within -= 360 * ceil((angle - axis->max - slack) / 360);
    else if (angle < axis->min - slack)
        within += 360 * ceil((axis->min - slack - angle) / 360);
    *over = within > axis->max + slack || within < axis->min - slack;
    return *over ? angle : within;
}

/* Both vectors that lie on the cones of the tool about axis 1 and of the target about
 * axis 0. */
static void cone_intersections(const struct verify_kinematics *kinematics, struct vec3 target,
                               struct vec3 found[2])
{
    struct vec3 u = kinematics->axis[0].axis, v = kinematics->axis[1].axis, w = vec_cross(u, v);
    double uv = vec_dot(u, v), s = 1 - uv * uv;
    double ut = vec_dot(u, target), vt = vec_dot(v, kinematics->tool);
    double a = (ut - uv * vt) / s, b = (vt - uv * ut) / s;
    double c2 = (1 - a * a - b * b - 2 * a * b * uv) / s;
    double c = c2 > 0 ? sqrt(c2) : 0;
    struct vec3 flat = vec_add(vec_scale(a, u), vec_scale(b, v));
    found[0] = vec_along(flat, c, w);
    found[1] = vec_along(flat, -c, w);
}

bool verify_kinematics_angles(const struct verify_kinematics *kinematics, struct vec3 axis,
                              const double near[], double slack, double q[])
{
    double best = HUGE_VAL;
    bool over[VERIFY_KINEMATICS_AXES];
    if (kinematics->n == 1)
        q[0] = nearest_turn(&kinematics->axis[0],
                            angle_about(kinematics->axis[0].axis, kinematics->tool, axis, near[0]),
                            near[0], over);
    if (kinematics->n == 2) {
        struct vec3 between[2];
        cone_intersections(kinematics, axis, between);
        for (int i = 0; i < 2; i++) {
            double inner =
                angle_about(kinematics->axis[1].axis, kinematics->tool, between[i], near[1]);
            double outer = angle_about(kinematics->axis[0].axis, between[i], axis, near[0]);
            inner = nearest_turn(&kinematics->axis[1], inner, near[1], &over[1]);
            outer = nearest_turn(&kinematics->axis[0], outer, near[0], &over[0]);
            double move = fabs(inner - near[1]) + fabs(outer - near[0]);
            move += over[0] || over[1] ? 1e6 : 0;
            if (move < best) {
                best = move;
                q[0] = outer;
                q[1] = inner;
            }
        }
    }
    return DEGREES(vec_angle(verify_kinematics_axis_at(kinematics, q), axis)) <= slack;
}

struct verify_kinematics verify_kinematics_trunnion(char master, int sense)
{
    struct vec3 tilt = master == 'A' ? vec(sense, 0, 0) : vec(0, sense, 0);
    return (struct verify_kinematics){
        .n = 2,
        .axis = {{'C', true, vec(0, 0, sense), vec(0, 0, 0), -HUGE_VAL, HUGE_VAL},
                 {master, true, tilt, vec(0, 0, 0), -HUGE_VAL, HUGE_VAL}},
        .tool = vec(0, 0, 1)};
}
