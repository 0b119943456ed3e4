#include "cl.h"

#include <stdlib.h>
#include <string.h>

#include "cl_state.h"

int cl_wrong(struct cl_state *s, const char *what)
{
    return error_at(s->error, s->file, s->statement->line, "read back: %s", what);
}

int cl_expect(struct cl_state *s, size_t i, size_t n, double *value)
{
    return cl_numbers(s->statement, i, n, value) == n ? 0 : cl_wrong(s, "numbers are missing");
}

/* ---- places */

static struct vec3 in_frame(const struct cl_frame *f, struct vec3 v)
{
    return vec_along(vec_along(vec_scale(v.x, f->x), v.y, f->y), v.z, f->z);
}

static struct vec3 out_of_frame(const struct cl_frame *f, struct vec3 v)
{
    return vec(vec_dot(f->x, v), vec_dot(f->y, v), vec_dot(f->z, v));
}

/* NX: all frames are brought into the first one. */
struct vec3 cl_point(const struct cl_state *s, const double v[3])
{
    struct vec3 p = vec_add(vec_scale(s->unit, vec(v[0], v[1], v[2])), s->shift);
    if (s->frames < 2)
        return p;
    p = vec_add(s->frame.origin, in_frame(&s->frame, p));
    return out_of_frame(&s->first, vec_sub(p, s->first.origin));
}

bool cl_direction(const struct cl_state *s, const double v[3], struct vec3 *direction)
{
    struct vec3 d = vec(v[0], v[1], v[2]);
    if (s->frames > 1)
        d = out_of_frame(&s->first, in_frame(&s->frame, d));
    *direction = vec_unit(d);
    return vec_length(d) > 0;
}

struct nc_piece cl_piece(struct cl_state *s, struct vec3 to, struct vec3 axis)
{
    /* the place before the first motion is not known: it is reached from itself */
    struct nc_piece piece = {.rapid = s->rapid,
                             .touches = s->touches,
                             .inverse = s->inverse,
                             .feed = s->feed,
                             .block = -1,
                             .line = s->statement->line,
                             .p = {s->moved ? s->at : to, to},
                             .q = {s->moved ? s->axis : axis, axis}};
    s->motion->blocks++;
    s->at = to;
    s->axis = axis;
    s->known = s->moved = true;
    s->rapid = s->touches = false;
    return piece;
}

void cl_straight(struct cl_state *s, struct vec3 to, struct vec3 axis, bool rapid)
{
    s->rapid = rapid;
    s->motion->lines += !rapid;
    struct nc_piece piece = cl_piece(s, to, axis);
    *array_push(&s->motion->piece) = piece;
}

/* A point of the stream: the end of an arc, a hole, the end of a straight motion. */
static int go_to(struct cl_state *s, struct vec3 to, struct vec3 axis)
{
    if (s->spline.fallback)
        return 0;
    if (s->arc.open)
        return cl_arc_end(s, to, axis);
    if (s->statement->bare && cl_arc_goes_on(s, to))
        return cl_arc_end(s, to, axis);
    s->arc.lasting = false;
    if (s->hole.on)
        return cl_drill(s, to, axis);
    cl_straight(s, to, axis, s->rapid);
    return 0;
}

/* x, y, z and, when there are three more, the axis. */
static int read_pose(struct cl_state *s, struct vec3 *p, struct vec3 *axis)
{
    double v[6];
    size_t n = s->statement->argument.n;
    if ((n != 3 && n != 6) || cl_expect(s, 0, n, v) < 0)
        return cl_wrong(s, "a point of other than 3 or 6 numbers");
    *p = cl_point(s, v);
    *axis = s->axis;
    if (n == 6 && !cl_direction(s, v + 3, axis))
        return cl_wrong(s, "a tool axis of no length");
    return 0;
}

static int read_goto(struct cl_state *s)
{
    struct vec3 p, axis;
    return read_pose(s, &p, &axis) < 0 ? -1 : go_to(s, p, axis);
}

static int read_godlta(struct cl_state *s)
{
    double v[6] = {0};
    size_t n = s->statement->argument.n;
    struct vec3 axis = s->axis;
    if ((n != 1 && n != 3 && n != 6) || cl_expect(s, 0, n, v) < 0)
        return cl_wrong(s, "GODLTA of other than 1, 3 or 6 numbers");
    if (n == 1)
        return go_to(s, vec_along(s->at, s->unit * v[0], s->axis), axis);
    if (n == 6 && !cl_direction(s, v + 3, &axis))
        return cl_wrong(s, "a tool axis of no length");
    return go_to(s, vec_along(s->at, s->unit, vec(v[0], v[1], v[2])), axis);
}

static int read_from(struct cl_state *s)
{
    if (read_pose(s, &s->at, &s->axis) < 0)
        return -1;
    s->from = s->at;
    s->has_from = s->known = true;
    return 0;
}

static int read_gohome(struct cl_state *s)
{
    struct vec3 p = s->from, axis = s->axis;
    if (s->statement->argument.n > 0 && read_pose(s, &p, &axis) < 0)
        return -1;
    if (s->statement->argument.n > 0 || s->has_from)
        cl_straight(s, p, axis, true);
    return 0;
}

static int read_shift(struct cl_state *s)
{
    double v[3];
    if (cl_expect(s, 0, 3, v) < 0)
        return -1;
    double sign = strcmp(s->statement->word, "ORIGIN") == 0 ? -s->unit : s->unit;
    s->shift = vec_scale(sign, vec(v[0], v[1], v[2]));
    return 0;
}

static int read_clearance(struct cl_state *s)
{
    double v[4] = {0, 0, 1, 0};
    if (strcmp(s->statement->word, "CLEARP") == 0 ? cl_expect(s, 1, 1, v + 3) < 0
                                                  : cl_expect(s, 0, 4, v) < 0)
        return -1;
    s->normal_of_clearance = vec(v[0], v[1], v[2]);
    s->clearance = s->unit * v[3];
    s->has_clearance = true;
    return 0;
}

static int read_retrct(struct cl_state *s)
{
    struct vec3 n = s->normal_of_clearance;
    double slope = vec_dot(n, s->axis);
    if (s->has_clearance && slope != 0)
        cl_straight(s, vec_along(s->at, (s->clearance - vec_dot(n, s->at)) / slope, s->axis),
                    s->axis, true);
    return 0;
}

/* ---- what holds for the motions that follow */

static int read_units(struct cl_state *s)
{
    static const struct {
        const char *name;
        double mm;
    } units[] = {{"MM", 1}, {"CM", 10}, {"INCHES", CL_INCH}, {"INCH", CL_INCH}, {"IN", CL_INCH}};
    const char *what = s->statement->argument.n ? s->statement->argument.item[0].text : "";
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(what, units[i].name) == 0) {
            s->unit = units[i].mm;
            return 0;
        }
    return cl_wrong(s, "a unit that is not known");
}

static int read_rapid(struct cl_state *s)
{
    s->rapid = !s->spline.fallback;
    return 0;
}

/* The first number among the arguments; NAN: none. */
static double any_number(const struct cl_statement *t)
{
    for (size_t i = 0; i < t->argument.n; i++)
        if (t->argument.item[i].is_number)
            return t->argument.item[i].number;
    return NAN;
}

static bool has_word(const struct cl_statement *t, const char *word)
{
    return cl_find(t, word) < t->argument.n;
}

static int read_fedrat(struct cl_state *s)
{
    const struct cl_statement *t = s->statement;
    double feed = any_number(t);
    if (isnan(feed))
        return 0;
    if (!(feed > 0))
        return cl_wrong(s, "a feed of 0 or less");
    s->inverse = has_word(t, "INVERS");
    if (has_word(t, "IPM"))
        feed *= CL_INCH;
    else if (has_word(t, "MMPR"))
        feed *= s->spindle;
    else if (has_word(t, "IPR"))
        feed *= CL_INCH * s->spindle;
    else if (!has_word(t, "MMPM") && !s->inverse)
        feed *= s->unit;
    s->feed = feed;
    return 0;
}

static int read_spindl(struct cl_state *s)
{
    const struct cl_statement *t = s->statement;
    size_t rpm = cl_find(t, "RPM");
    double speed;
    if (rpm < t->argument.n && cl_numbers(t, rpm + 1, 1, &speed) == 1)
        s->spindle = speed;
    else if (!isnan(any_number(t)) && !has_word(t, "ORIENT"))
        s->spindle = any_number(t);
    return 0;
}

static int read_cutter(struct cl_state *s)
{
    double v[2] = {0, 0};
    cl_numbers(s->statement, 0, 2, v);
    if (!s->cl->has_cutter)
        *s->cl = (struct cl){true, s->unit * v[0], s->unit * v[1]};
    return 0;
}

static int read_multax(struct cl_state *s)
{
    if (has_word(s->statement, "OFF"))
        s->axis = vec(0, 0, 1);
    return 0;
}

static int read_axis(struct cl_state *s)
{
    double v[3];
    if (cl_expect(s, 0, 3, v) < 0)
        return -1;
    struct vec3 *to = strcmp(s->statement->word, "INDIRV") == 0 ? &s->tangent : &s->axis;
    return cl_direction(s, v, to) ? 0 : cl_wrong(s, "a direction of no length");
}

/* SolidWorks CAM: the third column is the tool axis of points that give none. */
static int read_csys(struct cl_state *s)
{
    double v[12];
    if (cl_numbers(s->statement, 0, 12, v) == 12)
        s->axis = vec_unit(vec(v[2], v[6], v[10]));
    return 0;
}

/* ---- NX */

static int read_tool_path(struct cl_state *s)
{
    s->ended = s->hole.on = s->rapid = false;
    s->axis = vec(0, 0, 1);
    s->nx = true;
    return 0;
}

static int read_tldata(struct cl_state *s)
{
    double v[2] = {0, 0};
    cl_numbers(s->statement, 1, 2, v);
    if (!s->cl->has_cutter)
        *s->cl =
            (struct cl){true, s->unit * v[0], has_word(s->statement, "MILL") ? s->unit * v[1] : 0};
    return 0;
}

static int read_msys(struct cl_state *s)
{
    double v[9];
    if (cl_expect(s, 0, 9, v) < 0)
        return -1;
    struct cl_frame f = {.origin = vec_scale(s->unit, vec(v[0], v[1], v[2])),
                         .x = vec_unit(vec(v[3], v[4], v[5])),
                         .y = vec_unit(vec(v[6], v[7], v[8]))};
    f.z = vec_cross(f.x, f.y);
    if (s->frames++ == 0)
        s->first = f;
    s->frame = f;
    return 0;
}

static int read_end(struct cl_state *s)
{
    s->ended = true;
    return 0;
}

/* ---- words */

static const struct {
    const char *word;
    int (*read)(struct cl_state *s);
} rows[] = {
    {"GOTO", read_goto},          {"CIRCLE", cl_read_circle}, {"MOVNRB", cl_read_movnrb},
    {"RAPID", read_rapid},        {"FEDRAT", read_fedrat},    {"GODLTA", read_godlta},
    {"FROM", read_from},          {"GOHOME", read_gohome},    {"ORIGIN", read_shift},
    {"TRANS", read_shift},        {"CLEARP", read_clearance}, {"CLRSRF", read_clearance},
    {"RETRCT", read_retrct},      {"UNITS", read_units},      {"UNIT", read_units},
    {"SPINDL", read_spindl},      {"CUTTER", read_cutter},    {"MULTAX", read_multax},
    {"TLAXIS", read_axis},        {"INDIRV", read_axis},      {"CSYS", read_csys},
    {"TLON,GOFWD", cl_read_tlon}, {"CYCLE", cl_read_cycle},   {"NURBS", cl_read_nurbs},
    {"KNOT", cl_read_nurbs},      {"CNTRL", cl_read_nurbs},   {"TOOL PATH", read_tool_path},
    {"TLDATA", read_tldata},      {"MSYS", read_msys},        {"FINI", read_end},
    {"END-OF-PATH", read_end},
};

/* Words that would move the tool otherwise: a reader that skips them ends elsewhere. */
static const char *const refused[] = {"GOFWD",  "GOLFT",  "GORGT",  "PSIS",   "SPLINE",
                                      "HELIX",  "ARC",    "COPY",   "TRACUT", "POCKET",
                                      "ROTABL", "ROTATE", "ROTHED", "TLON"};

static int read_data(struct cl_state *s)
{
    const struct cl_statement *t = s->statement;
    const char *what = t->argument.n ? t->argument.item[0].text : "";
    if (strcmp(t->word, "TRACK") == 0)
        s->motion->track = what[0] == 'T'            ? NC_MOTION_TIP
                           : strcmp(what, "CONTACT") ? NC_MOTION_CENTRE
                                                     : NC_MOTION_CONTACT;
    else if (strcmp(t->word, "PASS") == 0)
        s->motion->passes++;
    else if (strcmp(t->word, "CONTCT") == 0)
        s->touches = true;
    else if (strcmp(t->word, "CUTTER") == 0)
        return read_cutter(s);
    return 0;
}

static int read_statement(struct cl_state *s)
{
    const struct cl_statement *t = s->statement;
    if (strncmp(t->word, "BEGIN NURBS_SIEMENS", 19) == 0 ||
        (s->spline.catia && strncmp(t->word, "XT=", 3) == 0))
        return cl_read_nurbs_siemens(s);
    if (s->spline.catia && strncmp(t->word, "END NURBS", 9) == 0)
        return cl_nurbs_siemens_end(s);
    if (s->spline.open && s->spline.order == 0 && !t->data && *t->word &&
        strcmp(t->word, "MOVNRB") != 0 && strcmp(t->word, "KNOT") != 0 &&
        strcmp(t->word, "CNTRL") != 0 && cl_nurbs_end(s) < 0)
        return -1;
    if (s->arc.open && !t->data && *t->word && strcmp(t->word, "GOTO") != 0)
        return cl_wrong(s, "CIRCLE without the GOTO of its end");
    if (t->bare)
        return read_goto(s);
    if (t->data)
        return read_data(s);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        if (strcmp(rows[i].word, t->word) == 0)
            return rows[i].read(s);
    for (size_t i = 0; i < sizeof refused / sizeof *refused; i++)
        if (strcmp(refused[i], t->word) == 0)
            return cl_wrong(s, "a word that would move the tool otherwise");
    return 0;
}

/* Whose file it is, by its comments and raw text. */
static void look_for_maker(struct cl_state *s)
{
    const char *text = s->statement->text;
    s->creo = s->creo || strstr(text, "Pro/CLfile");
    s->makino = s->makino || strstr(text, "APTCL-SPEC,MAKINO-FF");
    if (s->makino && strstr(text, "END-SECTION,PROCESS-END-PATH"))
        s->ended = true;
}

double cl_ball(const struct cl *cl)
{
    bool ball = cl->diameter > 0 && fabs(cl->corner - cl->diameter / 2) < 1e-6;
    return ball ? cl->diameter / 2 : 0;
}

int cl_read(const char *file, struct cl *cl, struct nc_motion *motion, struct error *error)
{
    struct cl_text text = {0};
    struct cl_state s = {
        .file = file, .motion = motion, .cl = cl, .error = error, .unit = 1, .axis = vec(0, 0, 1)};
    int result = cl_text_read(file, &text, error);
    *cl = (struct cl){0};
    motion->name = file;
    for (size_t i = 0; result == 0 && i < text.n; i++) {
        s.statement = &text.item[i];
        look_for_maker(&s);
        result = read_statement(&s);
        if (strcmp(s.statement->word, "FINI") == 0)
            break;
    }
    if (result == 0 && !s.ended)
        result = error_set(error, "%s: read back: it ends without FINI", file);
    array_free(&s.spline.knot);
    array_free(&s.spline.tip);
    array_free(&s.spline.head);
    cl_text_free(&text);
    return result;
}
