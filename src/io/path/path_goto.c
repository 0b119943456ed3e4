/* path_goto - see path_goto.h. */
#include "path_goto.h"

#include <math.h>
#include <string.h>

#include "base/num.h"
#include "path_arc.h"
#include "path_cycle.h"
#include "path_feed.h"
#include "path_tool.h"

#define AT(p) (p)->error, (p)->path->name, (p)->apt.line

int path_expect_reach(struct path_parse *p, struct vec3 v)
{
    if (fabs(v.x) < 1e8 && fabs(v.y) < 1e8 && fabs(v.z) < 1e8)
        return 0;
    return error_at(AT(p),
                    "found a coordinate too large for any machine, expected less than 1e8 mm");
}

void path_take_contact(struct path_parse *p, struct path_item *item)
{
    item->line = p->apt.line;
    if (p->touches)
        path_touch(p->path, item, p->contact);
    p->touches = false;
}

int path_move_to(struct path_parse *p, struct pose to)
{
    if (path_expect_reach(p, to.p) < 0)
        return -1;
    path_tool_move(p);
    p->said = to.p;
    if (p->circle.open) {
        if (path_arc_to(p, to) < 0)
            return -1;
    } else if (p->cycling) {
        if (path_hole(p, to) < 0)
            return -1;
    } else {
        p->circle.lasting = false;
        if (!p->rapid && p->moved)
            path_feed_inverse(p, vec_distance(p->at.p, to.p));
        path_take_contact(p, path_add_point(p->path, to, p->rapid));
        p->at = to;
    }
    p->rapid = false;
    p->moved = true;
    return 0;
}

/* The point that n numbers say: three, or six with the tool axis. */
static int take_point(struct path_parse *p, const double *v, size_t n)
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
    return take_point(p, v, n);
}

static int take_contact(struct path_parse *p, const double *v)
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
    return take_contact(p, v);
}

static inline const char *behind_blanks(const char *s)
{
    while (*s == ' ')
        s++;
    return s;
}

/* From behind the word of a line to behind its end; NULL where it is not so many plain numbers. */
static const char *plain_numbers(const char *s, size_t most, double *v, size_t *n)
{
    s = behind_blanks(s);
    if (*s != '/')
        return NULL;
    for (*n = 0; *n < most; s = behind_blanks(s)) {
        s = num_plain(behind_blanks(s + 1), &v[(*n)++]);
        if (!s)
            return NULL;
        if (*s != ',' && *(s = behind_blanks(s)) != ',')
            break;
    }
    s += *s == '\r';
    return *s == '\n' ? s + 1 : NULL;
}

/* Room for all points, by how many the part of the file that was read has. */
static void make_room(struct path_parse *p)
{
    const struct reader *r = &p->reader;
    size_t n = p->path->item.n;
    if (n > 1000 && r->got < r->size)
        array_reserve(&p->path->item,
                      (size_t)(1.02 * (double)n * ((double)r->size / (double)r->got)) + 1000);
    array_reserve(&p->path->item, n + 1);
}

/* A point at feed means no more than that, and so does the next one. */
static bool goes_on(const struct path_parse *p)
{
    return !p->rapid && !p->circle.open && !p->cycling && !p->framed && p->inverse <= 0 &&
           p->spline.stage != SPLINE_FALLBACK;
}

/* take_point for one more point at feed, with nothing said since the last one. */
static int take_next(struct path_parse *p, const double *v, size_t n)
{
    struct vec3 a = vec(v[3], v[4], v[5]);
    if (n == 6 && fabs(vec_dot(a, a) - 1) < 3e-9) /* as path_direction takes it */
        p->axis = a;
    else if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0)
        return -1;
    struct pose to = {vec_add(vec_scale(p->unit, vec(v[0], v[1], v[2])), p->shift), p->axis};
    if (path_expect_reach(p, to.p) < 0)
        return -1;
    if (p->path->item.n == p->path->item.cap)
        make_room(p);
    struct path_item *item = &p->path->item.item[p->path->item.n++];
    *item = (struct path_item){.kind = PATH_POINT, .line = p->apt.line, .to = to};
    if (p->touches)
        path_take_contact(p, item);
    p->said = to.p;
    p->at = to;
    return 0;
}

int path_goto_run(struct path_parse *p)
{
    const char *text, *s;
    size_t n = reader_ahead(&p->reader, &text), lines = 0;
    const char *end = (s = text) + n;
    size_t first = p->reader.line + 1;
    bool on = false;
    int result = 0;
    while (s < end && result == 0) {
        bool contact = *s == '$' && p->sniffed && strncmp(s, "$$-> CONTCT", 11) == 0;
        double v[6] = {0};
        const char *behind = NULL;
        if (contact)
            behind = plain_numbers(s + 11, 6, v, &n);
        else if (memcmp(s, "GOTO", 4) == 0)
            behind = plain_numbers(s + 4, 6, v, &n);
        if (!behind || (n != 6 && (n != 3 || contact)))
            break;
        p->apt.line = (unsigned)(first + lines++);
        if (contact) {
            result = take_contact(p, v);
        } else if (on) {
            result = take_next(p, v, n);
        } else {
            on = goes_on(p);
            result = take_point(p, v, n);
        }
        s = behind;
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
                        "without, or a way along it",
                        n);
    if (path_numbers(p, 0, n, v, "dx, dy, dz") < 0 ||
        (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0))
        return -1;
    struct vec3 way = n == 1 ? vec_scale(p->unit * v[0], p->axis) : path_way_of(p, v);
    return path_move_to(p, (struct pose){vec_add(p->said, way), p->axis});
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

/* FROM says where the tool is, without a motion.  It is carried along, in millimetres. */
int path_read_from(struct path_parse *p)
{
    double v[6];
    size_t n = p->apt.argument.n >= 6 ? 6 : 3;
    if (path_numbers(p, 0, n, v, "x, y, z") < 0)
        return -1;
    if (n == 6 && path_direction(p, v + 3, "a tool axis", &p->axis) < 0)
        return -1;
    p->at = (struct pose){path_point_of(p, v), p->axis};
    p->said = p->at.p;
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
