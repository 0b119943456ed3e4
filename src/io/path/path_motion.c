/*
 * path_motion - the words that move the tool: GOTO, GODLTA, FROM and the tool axis; CIRCLE; GOHOME
 * and RETRCT.  See path_parse.h.
 */
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "path_parse.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

/* ---- arcs */

/* How far the ends of an arc may be off its circle, and its start off its plane, mm. */
static const double arc_tolerance = 0.01;

/* Start and end nearer than this are the same printed point, so the arc is a full circle, mm.  NX
 * writes arcs as short as the last digit after others, which are no circles. */
static const double same_point = 2e-6;

/* -1: the point is not on the circle. */
static int expect_on_circle(struct path_parse *p, struct vec3 point, const char *which)
{
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 d = vec_sub(point, arc->centre);
    double r = vec_length(vec_reject(d, arc->axis));
    if (fabs(r - arc->radius) > arc_tolerance)
        return error_at(AT(p),
                        "found the %s of a CIRCLE %.4f mm from its centre, expected its "
                        "radius %.4f",
                        which, r, arc->radius);
    return 0;
}

/* Adds the arc from where the tool is; its centre is moved to the height of the start. */
static void add_arc(struct path_parse *p, struct pose to)
{
    struct path_arc arc = p->circle.arc;
    double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
    if (fabs(height) > arc_tolerance)
        arc.centre = vec_along(arc.centre, height, arc.axis);
    struct motion motion = motion_arc(p->at, to, arc.centre, arc.axis);
    path_feed_inverse(p, motion_length(&motion));
    path_attach_contact(p, path_add_arc(p->path, to, arc));
    p->at = to;
}

/* The angle from the start to the end, above 0 to 2 pi, by the right-hand rule. */
static double angle_to(const struct path_parse *p, struct vec3 to)
{
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 u = vec_reject(vec_sub(p->at.p, arc->centre), arc->axis);
    struct vec3 v = vec_reject(vec_sub(to, arc->centre), arc->axis);
    double angle = atan2(vec_dot(vec_cross(u, v), arc->axis), vec_dot(u, v));
    return angle > 0 ? angle : angle + 2 * PI;
}

/* Adds a helix of this angle in pieces of at most half a turn, since an arc item turns less than
 * once. */
static void add_turns(struct path_parse *p, struct pose to, double angle)
{
    struct pose from = p->at;
    struct path_arc arc = p->circle.arc;
    size_t pieces = (size_t)ceil(angle / PI - 1e-9);
    struct vec3 spoke = vec_reject(vec_sub(from.p, arc.centre), arc.axis);
    struct vec3 foot = vec_sub(from.p, spoke);
    double rise = vec_dot(vec_sub(to.p, from.p), arc.axis);
    for (size_t i = 1; i < pieces; i++) {
        double s = (double)i / (double)pieces;
        struct vec3 at = vec_add(foot, vec_turn(spoke, arc.axis, s * angle));
        add_arc(p, (struct pose){vec_along(at, s * rise, arc.axis), vec_slerp(from.a, to.a, s)});
    }
    add_arc(p, to);
}

/* -1: MOVARC says another angle than the one at the arc's end, by more than its digits may make. */
static int expect_sweep(struct path_parse *p, double angle)
{
    double said = fmod(RADIANS(p->circle.sweep), 2 * PI), off = fabs(angle - said);
    off = fmin(off, fabs(off - 2 * PI));
    if (off * p->circle.arc.radius <= arc_tolerance || off < 1e-3)
        return 0;
    return error_at(AT(p), "found a MOVARC of %g degrees that ends after %.4f, expected the same",
                    p->circle.sweep, DEGREES(angle));
}

/* Adds the open arc, to its end; -1: its ends are off its circle. */
static int end_arc(struct path_parse *p, struct pose to)
{
    struct vec3 axis = p->circle.arc.axis, way = vec_sub(to.p, p->at.p);
    double rise = vec_dot(way, axis), off = vec_length(vec_reject(way, axis));
    bool closed = off < same_point;
    if (expect_on_circle(p, p->at.p, "start") < 0 || expect_on_circle(p, to.p, "end") < 0)
        return -1;
    if (closed) /* start = end: a full turn */
        to.p = fabs(rise) > arc_tolerance ? vec_along(p->at.p, rise, axis) : p->at.p;
    if (p->circle.sweep > 0 && expect_sweep(p, closed ? 2 * PI : angle_to(p, to.p)) < 0)
        return -1;
    double whole = 2 * PI * (p->circle.turns ? (double)p->circle.turns : 1);
    if (closed && (p->circle.turns || fabs(rise) > arc_tolerance))
        add_turns(p, to, whole);
    else if (p->circle.turns > 1)
        add_turns(p, to, whole - 2 * PI + angle_to(p, to.p));
    else
        add_arc(p, to);
    p->circle.open = false;
    p->circle.lasting = true;
    return 0;
}

bool path_arc_continues(struct path_parse *p, struct vec3 point)
{
    const struct path_arc *arc = &p->circle.arc;
    struct vec3 d = vec_sub(point, arc->centre);
    if (!p->circle.lasting || fabs(vec_dot(d, arc->axis)) > arc_tolerance ||
        fabs(vec_length(d) - arc->radius) > arc_tolerance ||
        vec_distance(point, p->at.p) < arc_tolerance)
        return false;
    p->circle.open = angle_to(p, point) < PI;
    return p->circle.open;
}

int path_begin_arc(struct path_parse *p, struct path_arc arc)
{
    if (!p->moved)
        return error_at(AT(p), "found %.20s before any position, expected a GOTO first",
                        p->apt.word);
    if (p->cycling)
        return error_at(AT(p), "found %.20s among the holes of a CYCLE, expected CYCLE/OFF first",
                        p->apt.word);
    if (!(arc.radius > 0) || !isfinite(arc.radius))
        return error_at(AT(p), "found a CIRCLE of radius %g, expected one above 0", arc.radius);
    if (path_expect_reach(p, arc.centre) < 0)
        return -1;
    double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
    if (fabs(height) > arc_tolerance)
        return error_at(AT(p),
                        "found the start of a CIRCLE %.4f mm off its plane, expected it there",
                        fabs(height));
    p->circle = (struct arc_parse){.open = true, .arc = arc};
    return 0;
}

int path_read_circle(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    bool clockwise = n >= 11;
    double v[7], times = 0;
    struct path_arc arc;
    if (n != 6 && n != 7 && !clockwise)
        return error_at(AT(p), "found %zu numbers in CIRCLE, expected seven: centre, axis, radius",
                        n);
    if (path_numbers(p, 0, n == 6 ? 6 : 7, v, "centre, axis, radius") < 0 ||
        path_direction(p, v + 3, "a CIRCLE's axis", &arc.axis) < 0)
        return -1;
    arc.centre = path_point_of(p, v);
    if (apt_is(&p->apt, 11, "TIMES") && path_numbers(p, 12, 1, &times, "turns") < 0)
        return -1;
    if (!(times >= 0 && times <= 10000 && times == floor(times)))
        return error_at(AT(p), "found TIMES,%g in CIRCLE, expected a whole number", times);
    if (clockwise) {
        arc.axis = vec_scale(-1, arc.axis);
        double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
        arc.centre =
            vec_along(arc.centre, height, arc.axis); /* a helix may have its centre at its end */
    }
    arc.radius =
        n == 6 ? vec_length(vec_reject(vec_sub(p->at.p, arc.centre), arc.axis)) : p->unit * v[6];
    if (path_begin_arc(p, arc) < 0)
        return -1;
    p->circle.turns = (size_t)times;
    return 0;
}

int path_read_movarc(struct path_parse *p)
{
    double v[7], sweep = 0;
    struct path_arc arc;
    size_t n = p->apt.argument.n;
    bool turns = n == 9 && apt_is(&p->apt, 7, "ANGLE");
    if (n != 7 && !turns)
        return error_at(AT(p),
                        "found %zu arguments in MOVARC, expected centre, axis, radius, ANGLE and "
                        "degrees",
                        n);
    if (path_numbers(p, 0, 7, v, "centre, axis, radius") < 0 ||
        (turns && path_numbers(p, 8, 1, &sweep, "degrees") < 0) ||
        path_direction(p, v + 3, "a MOVARC's axis", &arc.axis) < 0)
        return -1;
    if (turns && (sweep == 0 || fabs(sweep) > 36000))
        return error_at(AT(p), "found a MOVARC of %g degrees, expected an angle", sweep);
    if (sweep < 0)
        arc.axis = vec_scale(-1, arc.axis);
    arc.centre = path_point_of(p, v);
    double height = vec_dot(vec_sub(p->at.p, arc.centre), arc.axis);
    arc.centre = vec_along(arc.centre, height, arc.axis);
    arc.radius = p->unit * v[6];
    if (path_begin_arc(p, arc) < 0)
        return -1;
    p->circle.sweep = fabs(sweep);
    p->circle.turns = fabs(sweep) > 360 ? (size_t)ceil(fabs(sweep) / 360 - 1e-9) : 0;
    return 0;
}

/* ---- points */

int path_expect_reach(struct path_parse *p, struct vec3 v)
{
    if (fabs(v.x) < 1e8 && fabs(v.y) < 1e8 && fabs(v.z) < 1e8)
        return 0;
    return error_at(AT(p),
                    "found a coordinate too large for any machine, expected less than 1e8 mm");
}

void path_attach_contact(struct path_parse *p, struct path_item *item)
{
    item->line = p->apt.line;
    if (p->touches)
        path_set_contact(p->path, item, p->contact);
    p->touches = false;
}

int path_move_to(struct path_parse *p, struct pose to)
{
    if (path_expect_reach(p, to.p) < 0)
        return -1;
    if (!p->rapid && path_expect_speed(p) < 0)
        return -1;
    path_tool_move(p);
    p->last_point = to.p;
    if (p->circle.open) {
        if (end_arc(p, to) < 0)
            return -1;
    } else if (p->cycling) {
        if (path_add_cycle_hole(p, to) < 0)
            return -1;
    } else {
        p->circle.lasting = false;
        if (!p->rapid && p->moved)
            path_feed_inverse(p, vec_distance(p->at.p, to.p));
        path_attach_contact(p, path_add_point(p->path, to, p->rapid));
        p->at = to;
    }
    p->rapid = false;
    p->moved = true;
    return 0;
}

/* The point of three numbers, or six with the tool axis. */
static int move_to_numbers(struct path_parse *p, const double *v, size_t n)
{
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0)
        return -1;
    struct pose to = {path_point_of(p, v), p->axis};
    p->listing = true;
    if (p->spline.stage == SPLINE_FALLBACK) {
        spline_parse_point(&p->spline, to);
        return 0;
    }
    return path_move_to(p, to);
}

int path_read_goto(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    double v[6];
    if (n != 3 && n != 6)
        return error_at(AT(p), "found %zu numbers in GOTO, expected three or six", n);
    if (path_numbers(p, 0, n, v, n == 3 ? "x, y, z" : "x, y, z, i, j, k") < 0)
        return -1;
    return move_to_numbers(p, v, n);
}

static int set_contact(struct path_parse *p, const double *v)
{
    p->contact.p = path_point_of(p, v);
    p->touches = true;
    return path_direction(p, v + 3, "a surface normal", &p->contact.n);
}

int path_read_contact(struct path_parse *p)
{
    double v[6];
    if (path_numbers(p, 0, 6, v, "x, y, z and the surface normal") < 0)
        return -1;
    return set_contact(p, v);
}

static inline const char *skip_blanks(const char *s)
{
    while (*s == ' ')
        s++;
    return s;
}

enum { PLAIN_MOST = 6 };

/* Reads the numbers of a line, from the end of its word; returns the next line, or NULL when there
 * is anything but plain numbers.  behind: of num_in_column, of each column. */
static const char *plain_numbers(const char *s, int behind[], double *v, size_t *n)
{
    s = skip_blanks(s);
    if (*s != '/')
        return NULL;
    for (*n = 0; *n < PLAIN_MOST; s = skip_blanks(s)) {
        s = num_in_column(skip_blanks(s + 1), &v[*n], &behind[*n]);
        ++*n;
        if (!s)
            return NULL;
        if (*s != ',' && *(s = skip_blanks(s)) != ',')
            break;
    }
    s += *s == '\r';
    return *s == '\n' ? s + 1 : NULL;
}

enum { SHORT_LINE = 16 /* bytes of a point */ };

/* Reserves memory for all points, by how many the part of the file has that was read, of which
 * `ahead` bytes are not parsed yet: no block of millions is moved then. */
static void make_room(struct path_parse *p, size_t ahead)
{
    const struct reader *r = &p->reader;
    size_t n = p->path->item.n, parsed = r->got - ahead;
    if (n > 1000 && r->got < r->size && p->path->item.cap - n < ahead / SHORT_LINE)
        array_reserve(&p->path->item,
                      (size_t)(1.02 * (double)n * ((double)r->size / (double)parsed)) + 1000);
}

/* A plain point at feed now changes nothing but the position. */
static bool only_position_changes(const struct path_parse *p)
{
    return !p->rapid && !p->circle.open && !p->cycling && !p->framed && p->inverse <= 0 &&
           p->spline.stage != SPLINE_FALLBACK && !(p->by_turn > 0);
}

/* move_to_numbers for one more point at feed, with nothing last_point since the last one. */
static int add_next_point(struct path_parse *p, const double *v, size_t n)
{
    struct vec3 a = vec(v[3], v[4], v[5]);
    if (n == 6 && fabs(vec_dot(a, a) - 1) < 3e-9) /* as path_direction takes it */
        p->axis = a;
    else if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0)
        return -1;
    struct pose to = {vec_add(vec_scale(p->unit, vec(v[0], v[1], v[2])), p->shift), p->axis};
    if (path_expect_reach(p, to.p) < 0)
        return -1;
    struct path_item *item = array_push_inline(&p->path->item);
    *item = (struct path_item){.kind = PATH_POINT, .line = p->apt.line, .to = to};
    if (p->touches)
        path_attach_contact(p, item);
    p->last_point = to.p;
    p->at = to;
    return 0;
}

int path_read_plain_gotos(struct path_parse *p)
{
    const char *text, *s;
    size_t n = reader_ahead(&p->reader, &text), lines = 0;
    make_room(p, n);
    const char *end = (s = text) + n;
    size_t first = p->reader.line + 1;
    bool on = false;
    int result = 0, behind[PLAIN_MOST] = {0};
    while (s < end && result == 0) {
        bool contact = *s == '$' && p->sniffed && strncmp(s, "$$-> CONTCT", 11) == 0;
        double v[6] = {0};
        const char *next = NULL;
        if (contact)
            next = plain_numbers(s + 11, behind, v, &n);
        else if (memcmp(s, "GOTO", 4) == 0)
            next = plain_numbers(s + 4, behind, v, &n);
        if (!next || (n != 6 && (n != 3 || contact)))
            break;
        p->apt.line = (unsigned)(first + lines++);
        if (contact) {
            result = set_contact(p, v);
        } else if (on) {
            result = add_next_point(p, v, n);
        } else {
            on = only_position_changes(p);
            result = move_to_numbers(p, v, n);
        }
        s = next;
    }
    reader_take(&p->reader, (size_t)(s - text), lines);
    return result;
}

int path_read_godlta(struct path_parse *p)
{
    double v[6];
    size_t n = p->apt.argument.n;
    if (!p->moved)
        return error_at(AT(p), "found GODLTA before any position, expected FROM or GOTO first");
    if (n != 1 && n != 3 && n != 6)
        return error_at(AT(p),
                        "found %zu numbers in GODLTA, expected dx, dy, dz, with the tool axis or "
                        "without, or a distance along it",
                        n);
    if (path_numbers(p, 0, n, v, "dx, dy, dz") < 0 ||
        (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0))
        return -1;
    struct vec3 way = n == 1 ? vec_scale(p->unit * v[0], p->axis) : path_vector_of(p, v);
    return path_move_to(p, (struct pose){vec_add(p->last_point, way), p->axis});
}

int path_read_tlaxis(struct path_parse *p)
{
    double v[3];
    if (p->apt.argument.n != 3)
        return error_at(AT(p), "found %zu numbers in TLAXIS, expected i, j, k", p->apt.argument.n);
    if (path_numbers(p, 0, 3, v, "i, j, k") < 0)
        return -1;
    return path_direction(p, v, "a tool axis", &p->axis);
}

/* FROM gives the position without a motion.  It is kept as text, in millimetres. */
int path_read_from(struct path_parse *p)
{
    double v[6];
    size_t n = p->apt.argument.n >= 6 ? 6 : 3;
    if (path_numbers(p, 0, n, v, "x, y, z") < 0)
        return -1;
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0)
        return -1;
    p->at = (struct pose){path_point_of(p, v), p->axis};
    p->last_point = p->at.p;
    p->moved = p->home.known = true;
    p->home.from = p->at;
    if (path_expect_reach(p, p->at.p) < 0)
        return -1;
    const double at[] = {p->at.p.x, p->at.p.y, p->at.p.z, p->at.a.x, p->at.a.y, p->at.a.z};
    char text[6 * NUM_MAX] = "FROM";
    char *end = text + strlen(text);
    for (size_t i = 0; i < n; i++) {
        *end++ = i ? ',' : '/';
        end += num_write(end, at[i], i < 3 ? 6 : 9);
    }
    path_add_text(p->path, text);
    return 0;
}

/* ---- home, clearance plane, rotary tables */

static int go_at_rapid(struct path_parse *p, struct pose to)
{
    if (p->cycling)
        return error_at(AT(p), "found %.20s among the holes of a CYCLE, expected CYCLE/OFF first",
                        p->apt.word);
    p->rapid = true;
    p->axis = to.a;
    return path_move_to(p, to);
}

int path_read_gohome(struct path_parse *p)
{
    size_t n = p->apt.argument.n;
    double v[6];
    if (n == 0 && p->home.known)
        return go_at_rapid(p, p->home.from);
    if (n == 0) {
        path_count_unknown(p, "GOHOME");
        return 0;
    }
    if (n != 3 && n != 6)
        return error_at(AT(p), "found %zu numbers in GOHOME, expected three or six, or none", n);
    if (path_numbers(p, 0, n, v, n == 3 ? "x, y, z" : "x, y, z, i, j, k") < 0)
        return -1;
    struct vec3 axis = p->axis;
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &axis) < 0)
        return -1;
    return go_at_rapid(p, (struct pose){path_point_of(p, v), axis});
}

int path_read_retrct(struct path_parse *p)
{
    const struct home_parse *h = &p->home;
    double along = vec_dot(h->normal, p->at.a);
    if (!h->cleared || !p->moved || along < 1e-3) {
        path_count_unknown(p, "RETRCT");
        return 0;
    }
    double way = (h->height - vec_dot(h->normal, p->at.p)) / along;
    if (way <= 0)
        return 0;
    return go_at_rapid(p, (struct pose){vec_along(p->at.p, way, p->at.a), p->at.a});
}

int path_read_clearp(struct path_parse *p)
{
    struct home_parse *h = &p->home;
    size_t n = p->apt.argument.n, first = apt_is(&p->apt, 0, "XYPLAN");
    double v[4] = {0, 0, 1};
    h->cleared = false;
    if (n - first != 1 && n != 4) {
        path_count_unknown(p, p->apt.word);
        return 0;
    }
    if (n == 4 ? path_numbers(p, 0, 4, v, "a, b, c, d of a plane") < 0
               : path_numbers(p, first, 1, v + 3, "z of the clearance plane") < 0)
        return -1;
    double length = vec_length(vec(v[0], v[1], v[2]));
    if (path_direction(p, v, "a plane's normal", &h->normal) < 0)
        return -1;
    double foot[3]; /* a point of the plane, in the coordinates of the stream */
    for (int i = 0; i < 3; i++)
        foot[i] = v[i] * v[3] / (length * length);
    h->height = vec_dot(h->normal, path_point_of(p, foot));
    h->cleared = true;
    return 0;
}

int path_read_rotabl(struct path_parse *p)
{
    bool any = false, turns = false;
    for (size_t i = 0; i < p->apt.argument.n; i++) {
        any = any || p->apt.argument.item[i].is_number;
        turns = turns || (p->apt.argument.item[i].is_number && p->apt.argument.item[i].number != 0);
    }
    if (any && !turns)
        return 0;
    return error_at(AT(p),
                    "found %.20s, which turns the table by itself, expected the tool axis in GOTO: "
                    "ignoring it would send the tool to the wrong place",
                    p->apt.word);
}
