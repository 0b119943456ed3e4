/*
 * ncread_fanuc - blocks of the Fanuc 30i family (operator's manual B-63944 and the design notes).
 *
 * G43.4: X Y Z are the tip in the frame of the work, rotary words and tip go in proportion.
 * G43.5: I J K is the tool axis, which turns on the great circle.  G06.2: a B-spline from the
 * place where the tool is (its first pole), a knot in each block and the last ones alone.
 */
#include <string.h>

#include "ncread_gcode.h"

/*
 * Tenths of those that change not where the tool goes, besides those of ncread_gcode (B-64484EN,
 * lists of G codes): look-ahead, exact stop, polar coordinates off, stroke check off, watching the
 * spindle, normal direction off, mirroring off, other work offsets, feed at corners, tapping,
 * macros off; of Haas look-ahead, its work offsets and smoothness.
 */
static const int no_effect[] = {80,  90,  150, 230, 250,  260,  401, 501,
                                541, 620, 630, 670, 1030, 1540, 1870};

/* Of them those whose other words are numbers of their own: G54.1 P3, G187 P3 E0.01. */
static const int with_settings[] = {80, 250, 260, 541, 1030, 1540, 1870};

static int start_tcp(struct ncread *c, const struct ncread_word *w, struct gcode_block *b,
                     struct error *error)
{
    if (!c->options->tcp)
        return ncread_error(c, error, "tool centre point control on a machine without it");
    if (!ncread_word_find(&c->words, "H"))
        return ncread_error(c, error, "tool centre point control without H");
    c->tcp = b->tool = true;
    c->vectors = w->value[0] > 43.45;
    memset(b->to.known, 0, sizeof b->to.known);
    c->here = b->to;
    return 0;
}

/* G05, G05.1: P or Q with numbers of their own; Q2 and Q3 name axes, others leave no room for a
 * place. */
static int smoothing(struct ncread *c, struct error *error)
{
    const struct ncread_word *q = ncread_word_find(&c->words, "Q");
    c->setting = true;
    c->selecting = q && (q->value[0] == 2 || q->value[0] == 3);
    for (size_t i = 0; i < c->words.n && !c->selecting; i++)
        if (strchr("XYZABC", c->words.item[i].name[0]))
            return ncread_error(c, error, "G05.1 with a place");
    return 0;
}

/* Modal and other G words, before the addresses are looked at. */
static int read_g(struct ncread *c, const struct ncread_word *w, struct gcode_block *b,
                  struct error *error)
{
    int code = (int)lround(w->value[0] * 10);
    enum ncread_meaning meaning = ncread_meaning_of_word(c, w);
    if (meaning != MEANS_NOTHING_KNOWN) {
        if (ncread_meaning_apply(c, meaning, error) < 0)
            return -1;
        b->to = c->here;
        b->machine = b->machine || meaning == MEANS_HOME;
        if (meaning == MEANS_TCP) /* Haas: G234 is of the group of G43, too */
            c->tcp_by_length = true;
        return 0;
    }
    int taken = ncread_hole_code(c, code) ? 1 : ncread_gcode_g(c, code, error);
    if (taken != 0)
        return taken < 0 ? -1 : 0;
    switch (code) {
    case 50: /* smoothing, look-ahead */
    case 51:
        return smoothing(c, error);
    case 531: /* tilted planes on, off: ncread_plane */
    case 682:
    case 690:
        return 0;
    case 24:
    case 34:
        if (c->has_middle)
            return ncread_error(c, error, "G02.4 within G02.4");
        c->move = MOVE_SPACE;
        return 0;
    case 62:
        c->move = MOVE_SPLINE;
        b->spline_begins = true;
        return 0;
    case 280: /* the reference point, and the others by their number P */
    case 300:
        b->home = true;
        return 0;
    case 430: /* of one group with G43.4, which it ends */
        c->tcp = c->tcp && !c->tcp_by_length;
        c->vectors = c->vectors && c->tcp;
        c->length = true;
        return 0;
    case 434:
    case 435:
        c->length = c->tcp_by_length = true;
        return start_tcp(c, w, b, error);
    case 490:
        c->tcp = c->tcp && !c->tcp_by_length; /* M128 of Hurco stays on */
        c->vectors = c->vectors && c->tcp;
        c->length = false;
        c->here.known[2] = c->here.known[2] && !c->lengthened;
        b->to.known[2] = b->to.known[2] && !c->lengthened;
        return 0;
    case 530:
        b->machine = true;
        return 0;
    default:
        if (!IS_G_OF(code, no_effect))
            return ncread_unknown(c, w, error);
        c->setting = c->setting || IS_G_OF(code, with_settings);
        b->bare = b->bare || code == 501;
        return 0;
    }
}

/* All other words. */
static int read_address(struct ncread *c, const struct ncread_word *w, struct gcode_block *b,
                        struct error *error)
{
    char letter = w->name[0];
    if (letter == 'O')
        return c->titled ? ncread_error(c, error, "another program begins (O) amid this one") : 0;
    bool own = c->setting && strchr("IJKRQ", letter);
    if (strchr("XYZABCIJKRQ", letter) && !w->pointed && !own && w->value[0] != 0)
        return ncread_error(c, error, "a length, angle or feed without a decimal point");
    if (ncread_gcode_address(c, w, b))
        return 0;
    if (letter == 'P' && c->move == MOVE_SPLINE) {
        c->order = (int)w->value[0];
        if (c->order < 2 || c->order > 4)
            return ncread_error(c, error, "a spline whose order is not 2 to 4");
    } else if (!strchr("STHDPQ", letter)) {
        return ncread_unknown(c, w, error);
    }
    return 0;
}

/* The G and M words beside one whose other words are its own: G4, G68.2, G53.1. */
static int read_beside(struct ncread *c, struct gcode_block *b, const char *own,
                       struct error *error)
{
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        char letter = w->name[0];
        bool dwell = letter == 'G' && w->value[0] == 4;
        if (!strchr(own, letter) && !strchr("NGMSTDH", letter))
            return ncread_unread(c, w, error);
        if (letter == 'G'   ? !dwell && read_g(c, w, b, error) < 0
            : letter == 'M' ? ncread_m(c, w, error) < 0
                            : false)
            return -1;
    }
    if (b->machine || b->home || b->tool || b->spline_begins)
        return ncread_error(c, error, "G4, G68.2 or G53.1 with a move");
    return 0;
}

/* The words of a block into the state and *b. */
static int read_words(struct ncread *c, struct gcode_block *b, struct error *error)
{
    unsigned seen = 0;
    if (ncread_gcode_check(c, error) < 0)
        return -1;
    if (ncread_hole_dwell(c, 0.001))
        return read_beside(c, b, "XPFUK", error);
    int plane = ncread_plane_g(c, error);
    if (plane != 0)
        return plane < 0 ? -1 : read_beside(c, b, plane > 1 ? "XYZIJK" : "P", error);
    b->to = c->has_middle ? c->middle : c->here; /* G69 forgets it */
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        unsigned bit = 1u << (w->name[0] - 'A');
        if (w->name[0] == 'N' && i > 0)
            return ncread_error(c, error, "N after other words");
        if (w->name[0] == 'G'   ? read_g(c, w, b, error) < 0
            : w->name[0] == 'M' ? ncread_m(c, w, error) < 0
                                : false)
            return -1;
        if (strchr("GM", w->name[0]))
            continue;
        if (seen & bit)
            return ncread_error(c, error, "a word twice in one block");
        seen |= bit;
    }
    for (size_t i = 0; i < c->words.n && !c->selecting; i++)
        if (!strchr("GMN", c->words.item[i].name[0]) &&
            read_address(c, &c->words.item[i], b, error) < 0)
            return -1;
    if (b->bare && b->named)
        return ncread_error(c, error, "G50.1 with a place, which this reader does not read");
    return 0;
}

/* G28, G30 and G53: to a place of the machine; the axes named are not known any more.  Without any
 * of them G28 and G30 take all axes there, on Haas and others. */
static int machine_move(struct ncread *c, struct gcode_block *b, struct error *error)
{
    if (c->tcp)
        return ncread_error(c, error, "G28 or G53 under tool centre point control");
    if (b->home && c->absolute)
        return ncread_error(c, error,
                            "G28 or G30 without G91: the move leads over a point of the workpiece");
    if (b->home && b->moved) { /* over a point on the way */
        ncread_turned(c, &b->to);
        if (ncread_go(c, &b->to, ncread_piece(c, &b->to), true, error) < 0)
            return -1;
    }
    if (b->home && !b->named)
        ncread_gcode_forget_all(c);
    ncread_gcode_forget(c);
    c->here.has_axis = c->here.has_axis && c->here.turned[0] && c->here.turned[1];
    return 0;
}

/* One block of G06.2. */
static int spline_block(struct ncread *c, struct gcode_block *b, struct error *error)
{
    if ((!c->tcp && !ncread_upright(c)) || c->vectors)
        return ncread_error(c, error, "G06.2 wants G43.4");
    if (!c->absolute)
        return ncread_error(c, error, "G06.2 under G91, which this reader does not read");
    if (!b->centre_named[2])
        return ncread_error(c, error, "a block of G06.2 without its knot K");
    struct nc_piece piece = ncread_piece(c, &b->to);
    if (b->spline_begins) {
        if (c->pole_p.n > 0)
            return ncread_error(c, error, "G06.2 inside G06.2");
        if (vec_distance(piece.p[0], piece.p[1]) > 1e-9 ||
            vec_distance(piece.q[0], piece.q[1]) > 1e-9)
            return ncread_error(c, error, "a spline whose first pole is not where the tool is");
        if (c->order == 0)
            return ncread_error(c, error, "G06.2 without its order P");
        if (ncread_ready(c, error) < 0)
            return -1;
    } else if (c->pole_p.n == 0) {
        return ncread_error(c, error, "a block of G06.2 after the end of its spline");
    }
    *array_push(&c->knot) = b->centre[2];
    if (b->named || b->spline_begins) {
        if (c->knot.n != c->pole_p.n + 1)
            return ncread_error(c, error, "a pole after knots without poles");
        ncread_pole(c, &piece, piece.p[1], piece.q[1]);
        *array_push(&c->weight) = b->radius_named ? b->radius : 1;
        c->here = b->to;
    } else if (c->knot.n == c->pole_p.n + (size_t)c->order) {
        return ncread_spline(c, error);
    }
    return 0;
}

static int arc_block(struct ncread *c, struct gcode_block *b, struct nc_piece *piece,
                     struct error *error)
{
    if (c->vectors ? !b->radius_named : ncread_gcode_centred(b) == b->radius_named)
        return ncread_error(c, error,
                            "an arc wants its centre by I J K or R, not both; under "
                            "G43.5 R");
    if (b->radius_named)
        return ncread_arc_radius(c, piece, b->radius, c->move == MOVE_CCW, error);
    return ncread_arc(c, piece, ncread_gcode_centre(c, b, piece), c->move == MOVE_CCW, error);
}

/* The tool axis of the block: I J K under G43.5, all three or none; else the rotary words. */
static int block_axis(struct ncread *c, struct gcode_block *b, struct error *error)
{
    int named = b->centre_named[0] + b->centre_named[1] + b->centre_named[2];
    if (!c->vectors) {
        ncread_turned(c, &b->to);
        return 0;
    }
    if (b->to.turned[0] || b->to.turned[1])
        return ncread_error(c, error, "rotary words under G43.5");
    if (named == 0)
        return 0;
    struct vec3 axis = vec(b->centre[0], b->centre[1], b->centre[2]);
    if (named != 3 || fabs(vec_length(axis) - 1) > 1e-3)
        return ncread_error(c, error, "a tool vector wants all of I J K and length 1");
    ncread_pointed(&b->to, axis);
    b->named = true;
    return 0;
}

/* Makes the piece an arc when the block is one, in a plane or in space. */
static int shape_arc(struct ncread *c, struct gcode_block *b, struct nc_piece *piece,
                     struct error *error)
{
    if (c->move == MOVE_SPACE) {
        const double *at = c->middle.at;
        c->has_middle = false;
        return ncread_arc_through(c, piece, vec(at[0], at[1], at[2]), error);
    }
    return c->move == MOVE_CW || c->move == MOVE_CCW ? arc_block(c, b, piece, error) : 0;
}

static int run_block(struct ncread *c, struct gcode_block *b, struct error *error)
{
    if (b->machine || b->home || c->machine_frame)
        return machine_move(c, b, error);
    if (b->tool && c->vectors) {
        if (ncread_gcode_centred(b))
            return ncread_error(c, error, "I J K in the block of G43.5");
        b->to.turned[0] = b->to.turned[1] = false;
        c->here.turned[0] = c->here.turned[1] = false;
    }
    if (c->move == MOVE_SPLINE && (b->named || b->centre_named[2]))
        return spline_block(c, b, error);
    if (c->pole_p.n > 0)
        return ncread_error(c, error, "a spline that is not complete");
    if (block_axis(c, b, error) < 0)
        return -1;
    bool straight = c->move <= MOVE_LINE && !c->vectors && !c->hole.on && !c->setting;
    if (straight && (ncread_gcode_centred(b) || b->radius_named))
        return ncread_error(c, error,
                            "I, J, K or R without an arc, which this reader does not read");
    if (!ncread_gcode_goes(c, b))
        return 0;
    bool turned = c->options->tcp && !c->tilted.on && !ncread_upright(c); /* which wants G43.4 */
    if ((c->hole.on || c->move > MOVE_RAPID) && !turned && ncread_length(c, error) < 0)
        return -1;
    if (c->hole.on)
        return ncread_hole_block(c, &b->to, 0.001, error);
    if (c->move == MOVE_NONE)
        return ncread_error(c, error, "a place before G0 or G1");
    if (!c->said)
        return ncread_error(c, error, "a place before G90 or G91");
    if (!c->absolute && c->move == MOVE_SPACE)
        return ncread_error(c, error, "G02.4 under G91, which this reader does not read");
    if (c->has_middle && c->move != MOVE_SPACE)
        return ncread_error(c, error, "G02.4 without its end");
    if (c->move == MOVE_SPACE && !c->has_middle) {
        c->middle = b->to;
        c->has_middle = true;
        return 0;
    }
    struct nc_piece piece = ncread_piece(c, &b->to);
    if (shape_arc(c, b, &piece, error) < 0)
        return -1;
    return ncread_go(c, &b->to, piece, c->move == MOVE_RAPID, error);
}

static int read_block(struct ncread *c, const char *line, struct error *error)
{
    c->motion->blocks++;
    if (c->line == 1) {
        c->move = MOVE_NONE;
        c->plane = 17;
        c->framed = strcmp(line, "%") == 0;
        if (*line == '%')
            return 0;
    }
    if (!*line)
        return 0;
    if (c->ended) { /* M30 was read: % alone, once */
        if (strcmp(line, "%") != 0 || c->closed)
            return ncread_error(c, error, "expected % after M30 and nothing after it");
        c->closed = true;
        return 0;
    }
    struct error found;
    int statement = ncread_gcode_statement(c, line, error);
    if (statement != 0)
        return statement < 0 ? -1 : 0;
    int lexed = ncread_word_fanuc(line, &c->words, &found);
    const struct ncread_word *n = ncread_word_find(&c->words, "N");
    if (n && ncread_block(c, n->value[0], error) < 0)
        return -1;
    ncread_watch_skip(c, line);
    if (lexed < 0)
        return ncread_error(c, error, found.text);
    struct gcode_block b = {.to = c->has_middle ? c->middle : c->here};
    if (read_words(c, &b, error) < 0)
        return -1;
    c->titled = c->titled || c->words.n > 0;
    ncread_watch_words(c);
    ncread_tool_words(c);
    return run_block(c, &b, error);
}

static int read_end(struct ncread *c, struct error *error)
{
    if (!c->ended)
        return ncread_error(c, error, "the program ends without M30");
    if (c->framed && !c->closed)
        return ncread_error(c, error, "the program ends without %");
    if (c->tcp || c->spindle)
        return ncread_error(c, error,
                            "ends with the spindle turning or with tool centre point "
                            "control on");
    return 0;
}

static bool program_begins(const char *first, const char *second)
{
    return *first == 'O' || (strcmp(first, "%") == 0 && second && *second == 'O');
}

const struct ncread_dialect ncread_fanuc = {"fanuc", program_begins, read_block, read_end, true};
