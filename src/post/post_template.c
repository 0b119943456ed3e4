/* post_template - see post_template.h. */
#include "post_template.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "machine/template.h"
#include "post_head.h"
#include "post_statement.h"
#include "post_words.h"

enum { ROOM = 400 };

struct nc_format_options nc_format_of(const struct machine *machine)
{
    const struct control_text *text = &machine->text;
    struct nc_format_options f = {.capitals = text->comment_capitals,
                                  .comment_width = (size_t)text->comment_width,
                                  .point = text->point,
                                  .sign = text->sign,
                                  .count_all = text->number_all};
    struct template_field field;
    size_t before = strcspn(text->comment, "{"), n = strcspn(text->number, "{");
    snprintf(f.open, sizeof f.open, "%.*s", (int)before, text->comment);
    if (template_field(text->comment + before, &field))
        snprintf(f.close, sizeof f.close, "%s", text->comment + before + field.length);
    snprintf(f.number, sizeof f.number, "%.*s", (int)n, text->number);
    if (template_field(text->number + n, &field))
        f.number_width = field.width;
    return f;
}

/* ---- conditions */

static bool has_splines_that_turn(const struct nc_plan *plan)
{
    for (size_t i = 0; i < plan->spline.n; i++)
        if (plan->spline.item[i].turns)
            return true;
    return false;
}

/* How the tool's length is left; -1: by the machine's own blocks. */
static int length_off(const struct nc_program *p)
{
    if (p->plan->ability.tcp && *p->machine->blocks.tcp_off)
        return -1;
    return p->machine->length_off;
}

static bool holds(const struct nc_program *p, enum template_condition condition)
{
    int off = length_off(p);
    const struct nc_ability *ability = &p->plan->ability;
    bool vectors = ability->mode == INTERPOLATE_VECTOR;
    const bool value[WHEN_NONE] = {
        [WHEN_MM] = ability->unit <= 1,
        [WHEN_INCH] = ability->unit > 1,
        [WHEN_TCP] = ability->tcp,
        [WHEN_ZERO] = nc_zero_first(p),
        [WHEN_HAS_TCP] = machine_has_tcp(p->machine, p->control),
        [WHEN_OFF_HOME] = off == LENGTH_OFF_HOME,
        [WHEN_OFF_ALONE] = off == LENGTH_OFF_ALONE,
        [WHEN_OFF_Z] = off == LENGTH_OFF_Z,
        [WHEN_ROTARY] = !vectors,
        [WHEN_VECTORS] = vectors,
        [WHEN_AXES] = p->machine->chain.n > 0,
        [WHEN_TURNED] = (p->plane ? p->turned : p->machine->chain.n) > 0,
        [WHEN_PLANE] = p->plane,
        [WHEN_SMOOTH] = p->machine->smooth,
        [WHEN_TOOL] = p->tooling.number > 0,
        [WHEN_CALLED] = p->tooling.number > 0 && !p->same_tool,
        [WHEN_RPM] = p->tooling.spindle > 0,
        [WHEN_CCW] = p->tooling.ccw,
        [WHEN_CUTCOM] = p->cutcom.on != 0,
        [WHEN_INVERSE] = p->w.inverse,
        [WHEN_G17] = p->w.plane == 17,
        [WHEN_NAMED] = p->name != NULL,
        [WHEN_SPLINES] = p->plan->spline.n > 0,
        [WHEN_NEXT] = p->machine->tool_next && nc_tool_after(p) > 0,
        [WHEN_STOP] = p->machine->tool_stop,
        [WHEN_WORK] =
            strcmp(nc_work_offset(p, p->tooling.taken + 1), nc_work_offset(p, p->offset_said)) != 0,
        [WHEN_CURVES] = has_splines_that_turn(p->plan),
    };
    return value[condition];
}

/* ---- values */

/* 1 at 0.1 mm and above, for speed, to 10 at 0.001 mm and below, for accuracy. */
static double smoothing_level(double tolerance)
{
    return fmin(10, fmax(1, round(1 + 4.5 * log10(0.1 / tolerance))));
}

/* Angles of the tilted plane that the program is in. */
static size_t write_angle(const struct nc_program *p, enum template_word word, char *text)
{
    struct nc_plane plane = {0};
    if (p->at_plane < p->planes.n)
        plane = p->planes.item[p->at_plane];
    const double angle[] = {plane.a, plane.b, plane.i, plane.j, plane.k, plane.spa, plane.spb};
    int i = (int)word - TEMPLATE_PLANE;
    bool sign = p->w.style.sign && angle[i] >= 0;
    *text = '+';
    return sign +
           num_write_short(text + sign, angle[i], p->plan->ability.digits.angle, p->w.style.point);
}

static double program_number(const struct nc_program *p)
{
    return (p->name ? strtod(p->name, NULL) : 1) + (p->parts ? (double)p->part - 1 : 0);
}

/* The text of a value; it fits into ROOM. */
static size_t write_value(const struct nc_program *p, enum template_word word, char *text)
{
    const struct nc_tooling *t = &p->tooling;
    double value = 0;
    int digits = 0;
    switch (word) {
    case TEMPLATE_NEXT:
        value = nc_tool_after(p);
        break;
    case TEMPLATE_TOOL:
        if (nc_tool_name(p))
            return (size_t)snprintf(text, ROOM, dialect_of(p->control)->tool_named,
                                    nc_tool_name(p));
        value = t->number ? t->number : 1;
        break;
    case TEMPLATE_OFFSET:
        value = t->offset;
        break;
    case TEMPLATE_RPM:
        value = t->spindle;
        break;
    case TEMPLATE_TOLERANCE:
        value = p->options.chord;
        digits = p->plan->ability.unit > 1 ? 5 : 4; /* of an inch */
        break;
    case TEMPLATE_ORIENTATION:
        value = DEGREES(p->options.axis_tolerance);
        digits = 4;
        break;
    case TEMPLATE_LEVEL:
        value = smoothing_level(p->options.chord);
        break;
    case TEMPLATE_PROGRAM:
        value = program_number(p);
        break;
    case TEMPLATE_NAME:
        dialect_of(p->control)->name(p, text);
        return strlen(text);
    case TEMPLATE_WORK:
        return (size_t)snprintf(text, ROOM, "%s", nc_work_offset(p, p->tooling.taken + 1));
    case TEMPLATE_SECONDS:
        return num_write_short(text, p->seconds, 3, p->w.style.point);
    case TEMPLATE_LENGTH_Z:
        return num_write_short(text, p->machine->length_z / p->plan->ability.unit,
                               p->plan->ability.digits.linear, p->w.style.point);
    case TEMPLATE_HASH:
        *text = '#';
        return 1;
    default:
        return write_angle(p, word, text);
    }
    return num_write_short(text, value, digits, false);
}

/* Zeros in front, after a sign. */
static size_t fill_zeros(char *text, size_t n, int width)
{
    size_t sign = *text == '-' || *text == '+', zeros = (size_t)width > n ? (size_t)width - n : 0;
    memmove(text + sign + zeros, text + sign, n - sign);
    memset(text + sign, '0', zeros);
    return n + zeros;
}

/* ---- blocks */

/* Words that leave the modal motion as it is, and what others do to what the writer remembers. */
static void follow_words(struct nc_writer *w, const char *text)
{
    static const double idle[] = {4,  5.1, 17, 18, 19, 20, 21, 40, 43, 49,
                                  54, 55,  56, 57, 58, 59, 90, 93, 94};
    for (const char *s = text; *s;) {
        size_t n = strcspn(s, " ");
        char *end;
        double value = strtod(s + 1, &end);
        bool word = n > 1 && isupper((unsigned char)*s) && (size_t)(end - s) == n;
        bool keeps = (word && *s != 'G') || strncmp(s, "ORI", 3) == 0 ||
                     strncmp(s, "COMPOF", 6) == 0 || strncmp(s, "CYCLE832", 8) == 0;
        if (word && *s == 'G') {
            for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
                keeps = keeps || value == idle[i];
            if (value >= 17 && value <= 19)
                w->plane = (int)value;
            if (value == 93 || value == 94)
                w->inverse = value == 93;
        }
        if (!keeps)
            w->motion = NULL;
        s += n;
        s += strspn(s, " ");
    }
}

/* The block so far, as a word of its own. */
static void flush_text(struct nc_program *p, char *text, size_t *n)
{
    while (*n && text[*n - 1] == ' ')
        --*n;
    text[*n] = '\0';
    char *from = text + strspn(text, " ");
    if (*from) {
        follow_words(&p->w, from);
        nc_code(&p->w, from);
    }
    *n = 0;
}

static void first_place(struct nc_program *p, enum template_word word)
{
    static const char *const address[] = {"X", "Y", "Z"};
    bool above = word >= TEMPLATE_X_ABOVE;
    struct vec3 to = nc_first_move(p)->p;
    if (above && p->plane && p->at_plane < p->planes.n)
        to = nc_above_plane(p, nc_first_move(p));
    const double at[] = {to.x, to.y, to.z};
    int i = (int)word - (above ? TEMPLATE_X_ABOVE : TEMPLATE_X);
    nc_modal(&p->w, (enum nc_slot)((int)NC_X + i), address[i], at[i],
             p->plan->ability.digits.linear);
}

static const char *const vector_address[] = {"I", "J", "K"};

static void write_word(struct nc_program *p, enum template_word word)
{
    const double zero[ROTARY_MAX] = {0};
    int n = p->plane ? p->turned : p->machine->chain.n;
    switch (word) {
    case TEMPLATE_RAPID:
        nc_motion(&p->w, "G0");
        break;
    case TEMPLATE_ROTARY_START:
        nc_forget(&p->w, NC_Q0, NC_Q1);
        nc_rotary_start(p, nc_first_move(p));
        break;
    case TEMPLATE_ROTARY:
        nc_rotary(p, nc_first_move(p)->q);
        break;
    case TEMPLATE_AXIS:
        nc_axis(p, nc_first_move(p), vector_address);
        break;
    case TEMPLATE_ROTARY_ZERO:
        nc_forget(&p->w, NC_Q0, NC_Q1);
        nc_rotary_axes(p, n, zero);
        break;
    default:
        first_place(p, word);
    }
}

static void write_blocks(struct nc_program *p, enum template_word word)
{
    const struct machine_templates *b = &p->machine->blocks;
    switch (word) {
    case TEMPLATE_HEAD:
        nc_head(p);
        break;
    case TEMPLATE_HOME:
        nc_template(p, b->home);
        nc_forget(&p->w, NC_X, NC_Z);
        p->w.motion = NULL;
        break;
    case TEMPLATE_SAFE:
        nc_template(p, b->safe);
        break;
    case TEMPLATE_START:
        nc_template(p, b->start);
        break;
    case TEMPLATE_END:
        nc_template(p, b->end);
        break;
    case TEMPLATE_TOOL_CHANGE:
        nc_template(p, b->tool_change);
        break;
    case TEMPLATE_TCP_ON:
        nc_template(p, b->tcp_on);
        break;
    case TEMPLATE_TCP_OFF:
        nc_template(p, b->tcp_off);
        break;
    case TEMPLATE_PLANE_ON:
        nc_template(p, b->plane_on);
        nc_forget(&p->w, NC_X, NC_Z);
        p->w.motion = NULL;
        break;
    case TEMPLATE_PLANE_OFF:
        nc_template(p, b->plane_off);
        break;
    case TEMPLATE_SMOOTH_ON:
        nc_template(p, b->smooth_on);
        break;
    case TEMPLATE_SMOOTH_OFF:
        nc_template(p, b->smooth_off);
        break;
    case TEMPLATE_SPINDLE:
        nc_spindle(p);
        break;
    case TEMPLATE_SPINDLE_ON:
        nc_spindle_on(p);
        break;
    case TEMPLATE_SPINDLE_OFF:
        nc_spindle_off(p);
        break;
    case TEMPLATE_COOLANT_OFF:
        nc_coolant_off(p);
        break;
    case TEMPLATE_STOP_OPTIONAL:
        nc_stop_optional(p);
        break;
    case TEMPLATE_NO_TOOL:
        nc_warn_no_tool(p);
        break;
    case TEMPLATE_CLAMP_ON:
        nc_template(p, b->clamp_on);
        break;
    case TEMPLATE_CLAMP_OFF:
        nc_template(p, b->clamp_off);
        break;
    default:
        nc_coolant(p);
    }
}

/* One block: n characters of a template. */
static void write_block(struct nc_program *p, const char *s, size_t n)
{
    char text[ROOM + CONTROL_SECTION_SIZE];
    size_t length = 0;
    const char *end = s + n, *motion = p->w.motion;
    struct template_field field;
    bool line = false, words = false, said = false;
    for (const char *c = s; c < end; c++) { /* nothing of it where a condition does not hold */
        if (!template_field(c, &field))
            continue;
        if (field.condition != WHEN_NONE && holds(p, field.condition) == field.negated)
            return;
        line = line || field.word == TEMPLATE_LINE;
    }
    while (s < end) {
        if (!template_field(s, &field)) {
            if (length < sizeof text - ROOM)
                text[length++] = *s;
            s++;
            continue;
        }
        s += field.length;
        if (field.word >= TEMPLATE_FIRST_WORD && field.word < TEMPLATE_NONE)
            flush_text(p, text, &length);
        if (field.word >= TEMPLATE_FIRST_BLOCK && field.word < TEMPLATE_NONE)
            write_blocks(p, field.word);
        else if (field.word > TEMPLATE_LINE && field.word < TEMPLATE_FIRST_BLOCK) {
            size_t before = p->w.n;
            write_word(p, field.word);
            words = words || field.word != TEMPLATE_RAPID;
            said = said || (field.word != TEMPLATE_RAPID && p->w.n > before);
        } else if (field.word < TEMPLATE_LINE && length < sizeof text - ROOM)
            length +=
                fill_zeros(text + length, write_value(p, field.word, text + length), field.width);
    }
    if (line) {
        text[length] = '\0';
        nc_line(&p->w, text);
        return;
    }
    flush_text(p, text, &length);
    if (words && !said) { /* it says nothing new */
        nc_drop(&p->w);
        p->w.motion = motion;
    }
    nc_end(&p->w);
}

/* Each of the blocks between which `between` stands. */
static void write_all(struct nc_program *p, const char *text, const char *between)
{
    for (;;) {
        size_t n = strcspn(text, between);
        while (n && *text == ' ')
            text++, n--;
        write_block(p, text, n);
        text += n;
        if (!*text++)
            return;
    }
}

void nc_template(struct nc_program *p, const char *text)
{
    if (strcmp(text, "none") == 0)
        return;
    write_all(p, text, "|");
}

void nc_section(struct nc_program *p, enum control_section section)
{
    write_all(p, p->machine->text.section[section], "\n");
}
