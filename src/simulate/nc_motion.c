/* nc_motion - see nc_motion.h. */
#include "simulate/nc_motion.h"

#include <stdlib.h>

#include "base/array.h"

void nc_motion_free(struct nc_motion *m)
{
    for (size_t i = 0; i < m->spline.n; i++) {
        free(m->spline.item[i].knot);
        free(m->spline.item[i].p);
        free(m->spline.item[i].q);
        free(m->spline.item[i].weight);
    }
    array_free(&m->spline);
    array_free(&m->arc);
    array_free(&m->polynomial);
    array_free(&m->piece);
    array_free(&m->remark);
    array_free(&m->blind);
}

/* Last knot index whose span holds u. */
static size_t span_of(const struct nc_motion_spline *b, double u)
{
    size_t i = b->n - 1;
    while (i > (size_t)b->order - 1 && b->knot[i] > u)
        i--;
    while (i > (size_t)b->order - 1 && !(b->knot[i] < b->knot[i + 1]))
        i--;
    return i;
}

/* Both channels at u of the span that begins at knot `span`: de Boor's scheme on weighted poles. */
static void spline_at(const struct nc_motion_spline *b, size_t span, double u, struct vec3 *p,
                      struct vec3 *q)
{
    struct vec3 dp[16] = {{0, 0, 0}}, dq[16] = {{0, 0, 0}};
    double w[16] = {1};
    size_t k = (size_t)b->order, first = span + 1 - k;
    for (size_t i = 0; i < k; i++) {
        w[i] = b->weight ? b->weight[first + i] : 1;
        dp[i] = vec_scale(w[i], b->p[first + i]);
        dq[i] = b->q ? vec_scale(w[i], b->q[first + i]) : vec(0, 0, 0);
    }
    for (size_t level = 1; level < k; level++)
        for (size_t i = k - 1; i >= level; i--) {
            double from = b->knot[first + i], to = b->knot[first + i + k - level];
            double s = (u - from) / (to - from);
            w[i] = w[i - 1] + s * (w[i] - w[i - 1]);
            dp[i] = vec_mix(dp[i - 1], dp[i], s);
            dq[i] = vec_mix(dq[i - 1], dq[i], s);
        }
    *p = vec_scale(1 / w[k - 1], dp[k - 1]);
    if (b->q)
        *q = vec_scale(1 / w[k - 1], dq[k - 1]);
}

static struct vec3 arc_at(const struct nc_motion_arc *arc, const struct nc_piece *piece, double s)
{
    struct vec3 from = vec_sub(piece->p[0], arc->centre), to = vec_sub(piece->p[1], arc->centre);
    double rise0 = vec_dot(from, arc->normal), rise1 = vec_dot(to, arc->normal);
    struct vec3 r0 = vec_reject(from, arc->normal);
    double l0 = vec_length(r0), l1 = vec_length(vec_reject(to, arc->normal));
    double c = cos(s * arc->angle), w = sin(s * arc->angle);
    struct vec3 r = vec_add(vec_scale(c, r0), vec_scale(w, vec_cross(arc->normal, r0)));
    r = vec_scale((l0 + s * (l1 - l0)) / l0, r);
    return vec_along(vec_add(arc->centre, r), rise0 + s * (rise1 - rise0), arc->normal);
}

static struct vec3 polynomial_at(struct vec3 from, const struct vec3 c[NC_MOTION_DEGREE], double s)
{
    struct vec3 sum = c[NC_MOTION_DEGREE - 1];
    for (int i = NC_MOTION_DEGREE - 2; i >= 0; i--)
        sum = vec_along(c[i], s, sum);
    return vec_along(from, s, sum);
}

/* On the great circle, in proportion; opposite axes have none and stay at the start. */
static struct vec3 great_circle(struct vec3 a, struct vec3 b, double s)
{
    double angle = vec_angle(a, b);
    struct vec3 side = vec_unit(vec_reject(b, a));
    return vec_add(vec_scale(cos(s * angle), a), vec_scale(sin(s * angle), side));
}

struct verify_kinematics nc_motion_kinematics(const struct nc_motion *m,
                                              const struct nc_piece *piece)
{
    struct verify_kinematics k = m->kinematics;
    for (int i = 0; i < k.n && piece->length != 0; i++)
        if (!k.axis[i].table)
            k.axis[i].centre = vec_along(k.axis[i].centre, piece->length, k.tool);
    return k;
}

/* With rotary axes at q: a length that is on shifts the linear axes, or under tool-centre-point
 * control the tip along the tool. */
static struct nc_motion_pose turned_pose(const struct nc_motion *m, const struct nc_piece *piece,
                                         struct vec3 p, struct vec3 q)
{
    const double turn[VERIFY_KINEMATICS_AXES] = {q.x, q.y};
    struct vec3 a = verify_kinematics_axis_at(&m->kinematics, turn);
    if (!piece->table)
        return (struct nc_motion_pose){vec_along(p, piece->beyond, a), a};
    struct verify_kinematics k = nc_motion_kinematics(m, piece);
    p = vec_along(p, piece->beyond, k.tool);
    return (struct nc_motion_pose){verify_kinematics_tip(&k, p, turn), a};
}

/* Both channels at s. */
static void channels_at(const struct nc_motion *m, const struct nc_piece *piece, double s,
                        struct vec3 *p, struct vec3 *q)
{
    *p = vec_mix(piece->p[0], piece->p[1], s);
    *q = vec_mix(piece->q[0], piece->q[1], s);
    if (piece->interpolation == AXIS_GREAT_CIRCLE)
        *q = great_circle(piece->q[0], piece->q[1], s);
    if (piece->shape == SHAPE_ARC) {
        *p = arc_at(&m->arc.item[piece->index], piece, s);
    } else if (piece->shape == SHAPE_POLYNOMIAL) {
        const struct nc_motion_polynomial *sum = &m->polynomial.item[piece->index];
        *p = polynomial_at(piece->p[0], sum->p, s);
        if (sum->turns)
            *q = polynomial_at(piece->q[0], sum->q, s);
    } else if (piece->shape == SHAPE_SPLINE) {
        const struct nc_motion_spline *b = &m->spline.item[piece->index];
        double middle = (piece->u[0] + piece->u[1]) / 2;
        spline_at(b, span_of(b, middle), piece->u[0] + s * (piece->u[1] - piece->u[0]), p, q);
    }
}

struct nc_motion_pose nc_motion_at(const struct nc_motion *m, const struct nc_piece *piece,
                                   double s)
{
    struct vec3 p, q;
    channels_at(m, piece, s, &p, &q);
    if (piece->interpolation == AXIS_GREAT_CIRCLE)
        return (struct nc_motion_pose){vec_along(p, piece->beyond, q), q};
    if (piece->interpolation == AXIS_BY_HEAD) {
        struct vec3 a = vec_unit(vec_sub(q, p));
        return (struct nc_motion_pose){vec_along(p, piece->beyond, a), a};
    }
    return turned_pose(m, piece, p, q);
}

struct nc_motion_pose nc_motion_ball(const struct nc_motion *m, size_t piece, double s,
                                     double radius)
{
    struct nc_motion_pose pose = nc_motion_at(m, &m->piece.item[piece], s);

    if (m->track == NC_MOTION_TIP)
        pose.p = vec_along(pose.p, radius, pose.a);
    return pose;
}

bool nc_motion_angles(const struct nc_motion *m, const struct nc_piece *piece, double s,
                      double turn[VERIFY_KINEMATICS_AXES])
{
    struct vec3 p, q;
    if (piece->interpolation != AXIS_ROTARY_LINEAR)
        return false;
    channels_at(m, piece, s, &p, &q);
    turn[0] = q.x;
    turn[1] = q.y;
    return true;
}

double nc_motion_degree(const struct nc_motion *m)
{
    return m->unit > 0 ? m->unit : 1;
}

void nc_motion_add_spline(struct nc_motion *m, struct nc_motion_spline spline,
                          const struct nc_piece *as)
{
    *array_push(&m->spline) = spline;
    m->curves++;
    m->poles += spline.n;
    for (size_t i = (size_t)spline.order - 1; i < spline.n; i++) {
        if (!(spline.knot[i] < spline.knot[i + 1]))
            continue;
        struct nc_piece *piece = array_push(&m->piece);
        *piece = *as;
        piece->shape = SHAPE_SPLINE;
        piece->index = m->spline.n - 1;
        piece->u[0] = spline.knot[i];
        piece->u[1] = spline.knot[i + 1];
        piece->touches = as->touches && i + 1 == spline.n;
    }
}

/* By five places of it, which is enough to tell what is far from what is near. */
static double rough_length(const struct nc_motion *m, const struct nc_piece *piece)
{
    if (piece->shape == SHAPE_LINE)
        return vec_distance(piece->p[0], piece->p[1]);
    double length = 0;
    struct vec3 last = nc_motion_at(m, piece, 0).p;
    for (int i = 1; i <= 4; i++) {
        struct vec3 next = nc_motion_at(m, piece, i / 4.0).p;
        length += vec_distance(last, next);
        last = next;
    }
    return length;
}

#define TOO_FAR                                                                                   \
    "found moves of more than 10 m, %.0f m together, expected at most 100 m: no machine goes so " \
    "far"

int nc_motion_bounded(const struct nc_motion *m, struct error *error)
{
    const double longest = 1e4, most = 1e5; /* mm */
    double far = 0;
    for (size_t i = 0; i < m->piece.n; i++) {
        double length = rough_length(m, &m->piece.item[i]);
        if (!(length > longest))
            continue;
        far += length;
        if (far > most && m->piece.item[i].block > 0)
            return error_at(error, m->name, m->piece.item[i].line, "N%d: " TOO_FAR,
                            m->piece.item[i].block, far / 1e3);
        if (far > most)
            return error_at(error, m->name, m->piece.item[i].line, TOO_FAR, far / 1e3);
    }
    return 0;
}
