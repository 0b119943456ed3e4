/* ncread_gcode - see ncread_gcode.h. */
#include "ncread_gcode.h"

#include <stdlib.h>
#include <string.h>

/* Tenths of those that do not change where the tool goes: cutter compensation off, work frames,
 * path control, cycles off, speeds of the spindle.  Any other G is refused, but for those that a
 * dialect or the control's file knows. */
static const int no_effect[] = {400, 540, 550, 560, 570, 580, 590, 591,
                                592, 593, 610, 611, 640, 800, 970};

bool ncread_gcode_among(int tenths, const int *list, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (tenths == list[i])
            return true;
    return false;
}

int ncread_gcode_g(struct ncread *c, int tenths, struct error *error)
{
    switch (tenths) {
    case 0:
    case 10:
    case 20:
    case 30:
        c->move = tenths / 10;
        return 1;
    case 170:
    case 180:
    case 190:
        c->plane = tenths / 10;
        return 1;
    case 200:
    case 210:
        return ncread_unit(c, tenths == 200 ? INCH : 1, error) < 0 ? -1 : 1;
    case 410: /* a path of the centre, whatever the side */
    case 420:
        return c->options->cutcom;
    case 900:
    case 910:
        c->absolute = tenths == 900;
        c->said = true;
        return 1;
    case 901: /* centres of arcs from the zero, from where the tool is */
    case 911:
        c->absolute_centre = tenths == 901;
        return 1;
    case 930:
    case 940:
        c->inverse_time = tenths == 930;
        return 1;
    default:
        return IS_G_OF(tenths, no_effect);
    }
}

int ncread_gcode_check(struct ncread *c, struct error *error)
{
    for (size_t i = 0; i < c->words.n; i++) {
        enum ncread_meaning meaning = ncread_meaning_of_word(c, &c->words.item[i]);
        if (meaning == MEANS_UNREAD || meaning == MEANS_NEVER)
            return ncread_unread(c, &c->words.item[i], error);
    }
    return 0;
}

bool ncread_gcode_address(struct ncread *c, const struct ncread_word *w, struct gcode_block *b)
{
    char letter = w->name[0];
    if (c->setting && !strchr("XYZABCF", letter)) /* a number of its own: P3 E0.01 */
        return true;
    bool by = c->said && !c->absolute && !b->machine;
    if (by ? ncread_axis_by(c, w->name, w->value[0], &b->to)
           : ncread_axis(c, w->name, w->value[0], &b->to)) {
        b->named = true;
        b->moved = b->moved || w->value[0] != 0;
    } else if (letter >= 'I' && letter <= 'K') {
        b->centre[letter - 'I'] = w->value[0];
        b->centre_named[letter - 'I'] = true;
    } else if (letter == 'R') {
        b->radius = w->value[0];
        b->radius_named = true;
    } else if (letter == 'F') {
        c->feed = w->value[0];
        c->feed_here = true;
    } else {
        return false;
    }
    return true;
}

int ncread_gcode_statement(struct ncread *c, const char *line, struct error *error)
{
    char text[WORD_TEXT];
    const char *s = line;
    long number = -1;
    if (*s == 'N') {
        number = strtol(s + 1, NULL, 10);
        s += 1 + strspn(s + 1, "0123456789");
    }
    s += strspn(s, " ");
    size_t n = strcspn(s, "(;");
    while (n && s[n - 1] == ' ')
        n--;
    if (*s != '#' || n >= sizeof text)
        return 0;
    memcpy(text, s, n);
    text[n] = '\0';
    enum ncread_meaning meaning = ncread_meaning_of(c, text);
    if (meaning == MEANS_NOTHING_KNOWN)
        return 0;
    if (number >= 0 && ncread_block(c, (double)number, error) < 0)
        return -1;
    return ncread_meaning_apply(c, meaning, error) < 0 ? -1 : 1;
}

void ncread_gcode_forget(struct ncread *c)
{
    for (size_t i = 0; i < c->words.n; i++) {
        struct ncread_place named = {0};
        ncread_axis(c, c->words.item[i].name, 0, &named);
        for (int k = 0; k < 3; k++)
            c->here.known[k] = c->here.known[k] && !named.known[k];
        for (int k = 0; k < VERIFY_KINEMATICS_AXES; k++)
            c->here.turned[k] = c->here.turned[k] && !named.turned[k];
    }
}

void ncread_gcode_forget_all(struct ncread *c)
{
    memset(c->here.known, 0, sizeof c->here.known);
    memset(c->here.turned, 0, sizeof c->here.turned);
}

bool ncread_gcode_centred(const struct gcode_block *b)
{
    return b->centre_named[0] || b->centre_named[1] || b->centre_named[2];
}

struct vec3 ncread_gcode_centre(const struct ncread *c, const struct gcode_block *b,
                                const struct nc_piece *piece)
{
    if (!c->absolute_centre)
        return vec_add(piece->p[0], vec(b->centre[0], b->centre[1], b->centre[2]));
    return vec(b->centre_named[0] ? b->centre[0] : piece->p[0].x,
               b->centre_named[1] ? b->centre[1] : piece->p[0].y,
               b->centre_named[2] ? b->centre[2] : piece->p[0].z);
}

bool ncread_gcode_goes(const struct ncread *c, const struct gcode_block *b)
{
    bool arc = c->move == MOVE_CW || c->move == MOVE_CCW;
    return b->named || (arc && !c->vectors && !c->setting && ncread_gcode_centred(b));
}
