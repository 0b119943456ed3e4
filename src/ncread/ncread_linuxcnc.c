/*
 * ncread_linuxcnc - blocks of LinuxCNC (its manual: G-Code Overview, G-Codes, Kinematics).
 *
 * A machine has tool centre point control when its kinematics does it all the time: X Y Z are then
 * the tip from the first block on; else they are the linear axes.  Rotary axes turn in proportion.
 */
#include <string.h>

#include "ncread_gcode.h"

enum { BLOCK_MAX = 255 };
static int read_g(struct ncread *c, const struct ncread_word *w, struct gcode_block *b,
                  struct error *error)
{
    int code = (int)lround(w->value[0] * 10);
    enum ncread_meaning meaning = ncread_meaning_of_word(c, w);
    if (meaning != MEANS_NOTHING_KNOWN) {
        if (ncread_meaning_apply(c, meaning, error) < 0)
            return -1;
        b->to = c->here;
        return 0;
    }
    int taken = ncread_hole_code(c, code) ? 1 : ncread_gcode_g(c, code, error);
    if (code == 930)
        c->feed = 0;
    if (code == 800) /* no motion is on after it */
        c->move = MOVE_NONE;
    if (taken != 0)
        return taken < 0 ? -1 : 0;
    switch (code) {
    case 40:
        return 0;
    case 430:
        c->length = true;
        return 0;
    case 490:
        c->length = ncread_meaning_of(c, "G43") == MEANS_NEVER;
        c->here.known[2] = b->to.known[2] = false;
        return 0;
    case 530:
        b->machine = true;
        return 0;
    case 610: /* exact path, exact stop, arcs by their centres, no more constant speed */
    case 611:
    case 970:
        return 0;
    default:
        return ncread_unknown(c, w, error);
    }
}

static int read_address(struct ncread *c, const struct ncread_word *w, struct gcode_block *b,
                        struct error *error)
{
    if (*w->name == 'O') /* of a subprogram, behind other words */
        return ncread_unread(c, w, error);
    if (!ncread_gcode_address(c, w, b) && !strchr("STHDPQN", w->name[0]))
        return ncread_unknown(c, w, error);
    return 0;
}

/* M70 to M73: G words that are kept and come back, as G91, G20 and planes; M61: a tool that is in
 * the spindle already, without its length; M66 to M68 wait or set an output. */
static bool keeps_modes(double m)
{
    return (m >= 70 && m <= 73) || m == 61;
}

static int read_words(struct ncread *c, struct gcode_block *b, struct error *error)
{
    unsigned seen = 0;
    if (ncread_gcode_check(c, error) < 0)
        return -1;
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        char letter = w->name[0];
        unsigned bit = 1u << (letter - 'A');
        int result = 0;
        if (letter == 'G')
            result = read_g(c, w, b, error);
        else if (letter == 'M' && keeps_modes(w->value[0]))
            result = ncread_unread(c, w, error);
        else if (letter == 'M' && w->value[0] == 2)
            c->ended = true;
        else if (letter == 'M')
            result = ncread_m(c, w, error);
        else if (seen & bit)
            return ncread_error(c, error, "a word twice in one block");
        if (result < 0)
            return -1;
        seen |= bit;
    }
    for (size_t i = 0; i < c->words.n; i++)
        if (!strchr("GM", c->words.item[i].name[0]) &&
            read_address(c, &c->words.item[i], b, error) < 0)
            return -1;
    return 0;
}

/* G53: to a place of the machine; the axes named are not known any more. */
static int machine_move(struct ncread *c, const struct gcode_block *b, struct error *error)
{
    if (c->move != MOVE_RAPID && c->move != MOVE_LINE)
        return ncread_error(c, error, "G53 without G0 or G1");
    if (b->named)
        ncread_gcode_forget(c);
    return 0;
}

static int run_block(struct ncread *c, struct gcode_block *b, struct error *error)
{
    if (ncread_hole_dwell(c, 1))
        return b->named ? ncread_error(c, error, "G4 with a place") : 0;
    if (b->machine)
        return machine_move(c, b, error);
    if (!ncread_gcode_goes(c, b))
        return c->setting || !(ncread_gcode_centred(b) || b->radius_named)
                   ? 0
                   : ncread_error(c, error, "I, J, K or R without an arc");
    ncread_turned(c, &b->to);
    if ((c->hole.on || c->move > MOVE_RAPID) && ncread_length(c, error) < 0)
        return -1;
    if (c->hole.on)
        return ncread_hole_block(c, &b->to, 1, error);
    if (c->move == MOVE_NONE)
        return ncread_error(c, error, "a place before G0 or G1");
    if (!c->said)
        return ncread_error(c, error, "a place before G90 or G91");
    struct nc_piece piece = ncread_piece(c, &b->to);
    bool centred = ncread_gcode_centred(b);
    bool arc = c->move == MOVE_CW || c->move == MOVE_CCW, ccw = c->move == MOVE_CCW;
    if (centred + b->radius_named != arc)
        return ncread_error(c, error,
                            "an arc wants its centre by I J K or R, not both; a line "
                            "neither");
    if (centred && ncread_arc(c, &piece, ncread_gcode_centre(c, b, &piece), ccw, error) < 0)
        return -1;
    if (b->radius_named && ncread_arc_radius(c, &piece, b->radius, ccw, error) < 0)
        return -1;
    return ncread_go(c, &b->to, piece, c->move == MOVE_RAPID, error);
}

/* o100 sub, O<name> call, with or without a block number. */
static bool is_flow(const char *line)
{
    const char *s = line + strspn(line, " \t");
    if (*s == 'N' || *s == 'n')
        s += 1 + strspn(s + 1, "0123456789 \t");
    return *s == 'O' || *s == 'o';
}

static int read_block(struct ncread *c, const char *line, struct error *error)
{
    struct error found;
    struct gcode_block b = {0};
    c->motion->blocks++;
    if (c->line == 1) {
        c->move = MOVE_NONE;
        c->plane = 17;
        c->tcp = c->options->tcp;
        c->framed = strcmp(line, "%") == 0;
        if (c->framed)
            return 0;
    }
    if (!*line)
        return 0;
    if (c->ended) { /* M2 or M30 was read: % alone, once */
        if (strcmp(line, "%") != 0 || c->closed)
            return ncread_error(c, error, "expected % after M2 and nothing after it");
        c->closed = true;
        return 0;
    }
    if (strlen(line) > BLOCK_MAX)
        return ncread_error(c, error, "a block of more than 255 characters");
    if (is_flow(line))
        return ncread_error(c, error,
                            "found a subprogram or a loop (O), which this reader does "
                            "not read");
    int lexed = ncread_word_fanuc(line, &c->words, &found);
    const struct ncread_word *n = ncread_word_find(&c->words, "N");
    if (n && ncread_block(c, n->value[0], error) < 0)
        return -1;
    ncread_watch_skip(c, line);
    if (lexed < 0)
        return ncread_error(c, error, found.text);
    b.to = c->here;
    if (read_words(c, &b, error) < 0)
        return -1;
    ncread_watch_words(c);
    ncread_tool_words(c);
    return run_block(c, &b, error);
}

static int read_end(struct ncread *c, struct error *error)
{
    bool never = ncread_meaning_of(c, "G43") == MEANS_NEVER;
    if (!c->ended || (c->framed && !c->closed))
        return ncread_error(c, error, "the program ends without M2 and %");
    if ((c->length && !never && ncread_ours(c)) || c->spindle)
        return ncread_error(c, error, "ends with the spindle turning or with the tool's length on");
    return 0;
}

static bool program_begins(const char *first, const char *second)
{
    return strcmp(first, "%") == 0 && second && *second != 'O';
}

const struct ncread_dialect ncread_linuxcnc = {"linuxcnc", program_begins, read_block, read_end,
                                               true};
