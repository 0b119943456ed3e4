/*
 * ncread_heidenhain - blocks of Klartext, TNC 640 (user's manual for conversational programming).
 *
 * L goes straight with rotary words in proportion, LN with the tool axis TX TY TZ on the great
 * circle; CC and C are an arc in X Y.  X Y Z are the tip while FUNCTION TCPM or M128 is on.
 */
#include <stdlib.h>
#include <string.h>

#include "ncread_state.h"
#include "base/num.h"

enum { TOKENS = 16, TOKEN = 40 };

/* A block as its words between blanks. */
struct klartext {
    int n;
    char word[TOKENS][TOKEN];
    struct ncread_place to;
    bool named, fast, machine, call;
    unsigned seen; /* letters of words that stood in it */
    int vector_n;
    double vector[3];
};

static int split_words(struct ncread *c, const char *line, struct klartext *k, struct error *error)
{
    for (const char *s = line + strspn(line, " "); *s && *s != ';'; s += strspn(s, " ")) {
        size_t n = strcspn(s, " ;");
        if (k->n == TOKENS || n >= TOKEN)
            return ncread_error(c, error, "a word or block that is too long");
        memcpy(k->word[k->n], s, n);
        k->word[k->n++][n] = '\0';
        s += n;
    }
    return 0;
}

/* The number after the letters of a word; with its sign where it is a place. */
static int read_number(struct ncread *c, const char *text, bool sign, double *value,
                       struct error *error)
{
    bool pointed;
    struct error found;
    if (sign && *text != '+' && *text != '-')
        return ncread_error(c, error, "a place or angle without its sign");
    if (ncread_word_number(&text, value, &pointed, &found) < 0)
        return ncread_error(c, error, found.text);
    return *text ? ncread_error(c, error, "found letters after a number") : 0;
}

/* Those that change not where the tool goes: M94 (angles shown), M107 and M108 (tools too large are
 * told), M109 to M111 (feed at arcs), M116 and M117 (feed of rotary axes), M126 and M127 (their way
 * over 360 degrees), M134 and M135 (exact stop), M137 (feed a minute), M148 and M149 (up at a
 * stop); TNC 640, Programming: miscellaneous functions. */
static bool is_idle_m(double m)
{
    static const double idle[] = {94,  107, 108, 109, 110, 111, 116, 117,
                                  126, 127, 134, 135, 137, 148, 149};
    for (size_t i = 0; i < sizeof idle / sizeof *idle; i++)
        if (m == idle[i])
            return true;
    return false;
}

/* From 89 on they are the control's, not the maker's: M89 calls a cycle at each block, M97 changes
 * small steps, M118 adds a handwheel, M130 leaves the tilted plane, M144 counts axes of the
 * kinematics, and so on.  Those that ncread_meaning tells are left to it. */
static bool is_own_m(double m)
{
    return m >= 89 && m < 200 && !ncread_meaning_moves('M', (int)(10 * m));
}

static int read_m(struct ncread *c, const char *text, struct klartext *k, struct error *error)
{
    struct ncread_word w = {.kind = WORD_ADDRESS, .name = "M", .values = 1};
    if (read_number(c, text, false, &w.value[0], error) < 0)
        return -1;
    enum ncread_meaning meaning = ncread_meaning_of_word(c, &w);
    if (meaning != MEANS_NOTHING_KNOWN)
        return ncread_meaning_apply(c, meaning, error);
    if (w.value[0] == 128 || w.value[0] == 129)
        c->tcp = w.value[0] == 128;
    else if (w.value[0] == 92)
        return ncread_error(c, error, "found M92, places from a point of the machine's maker");
    else if (w.value[0] == 143)
        return ncread_error(c, error, "found M143, which ends a basic rotation");
    else if (w.value[0] == 136)
        return ncread_error(c, error,
                            "found M136, a feed per revolution, which this reader does not read");
    else if (is_idle_m(w.value[0]))
        return 0;
    else if (w.value[0] == 91)
        k->machine = true;
    else if (w.value[0] == 99)
        k->call = true;
    else if (is_own_m(w.value[0]))
        return ncread_unread(c, &w, error);
    else
        return ncread_m(c, &w, error);
    return 0;
}

/* IX, IA: from where the axis is. */
static bool is_by(const char *w)
{
    return *w == 'I' && w[1] && strchr("XYZABC", w[1]);
}

/* No word twice in a block: X to Z, A to C, F, T and their vectors; several M are allowed. */
static int check_once(const struct ncread *c, const char *w, struct klartext *k,
                      struct error *error)
{
    bool vector = *w == 'T' && w[1] >= 'X' && w[1] <= 'Z';
    if (is_by(w))
        w++;
    int place = vector ? 26 + w[1] - 'X' : *w - 'A';
    if (place < 0 || *w > 'Z' || *w == 'M')
        return 0;
    if (k->seen & 1u << place)
        return ncread_error(c, error, "a word twice in one block");
    k->seen |= 1u << place;
    return 0;
}

static int read_word(struct ncread *c, const char *w, struct klartext *k, struct error *error)
{
    double value = 0;
    char letter[2] = {*w, '\0'};
    if (check_once(c, w, k, error) < 0)
        return -1;
    if (strcmp(w, "FMAX") == 0) {
        k->fast = true;
        return 0;
    }
    if (strcmp(w, "R0") == 0)
        return 0;
    if (strcmp(w, "RL") == 0 || strcmp(w, "RR") == 0)
        return c->options->cutcom
                   ? 0
                   : ncread_error(c, error, "radius compensation, which this reader does not read");
    if (*w == 'M')
        return read_m(c, w + 1, k, error);
    if (*w == 'F') {
        if (read_number(c, w + 1, false, &c->feed, error) < 0)
            return -1;
        if (!(c->feed > 0) || w[1] == '+')
            return ncread_error(c, error, "a feed of nothing or with a sign");
        return 0;
    }
    if (*w == 'T' && w[1] >= 'X' && w[1] <= 'Z') {
        k->vector_n++;
        return read_number(c, w + 2, true, &k->vector[w[1] - 'X'], error);
    }
    bool by = is_by(w);
    letter[0] = w[by];
    if (read_number(c, w + 1 + by, true, &value, error) < 0)
        return -1;
    if (by ? !ncread_axis_by(c, letter, value, &k->to) : !ncread_axis(c, letter, value, &k->to))
        return ncread_error(c, error, "a word that this reader does not know");
    k->named = true;
    return 0;
}

static void machine_move(struct ncread *c, struct klartext *k)
{
    for (int i = 1; i < k->n; i++)
        if (is_by(k->word[i]))
            c->here.known[0] = c->here.known[1] = c->here.known[2] = false;
        else if (k->word[i][0] >= 'X' && k->word[i][0] <= 'Z')
            c->here.known[k->word[i][0] - 'X'] = false;
}

/* Between two blocks of a cut TCPM leads the tool axis by the rotary axes in proportion, or on the
 * great circle, as PATHCTRL says, whatever words it has; here it is judged by these. */
static void watch_path_control(struct ncread *c, const struct klartext *k, bool vectors)
{
    const struct ncread_place *from = &c->here, *to = &k->to;
    bool turns = vectors ? vec_angle(from->axis, to->axis) > 1e-6
                         : from->turn[0] != to->turn[0] || from->turn[1] != to->turn[1];
    if (k->fast || !c->tcp || !turns || c->path_control != (vectors ? 'A' : 'V'))
        return;
    ncread_watch_unasked(c, c->line, c->block,
                         vectors ? "TX TY TZ under PATHCTRL AXIS, expected PATHCTRL VECTOR"
                                 : "rotary words under PATHCTRL VECTOR, expected PATHCTRL AXIS",
                         0);
    c->path_control = 0;
}

/* L and LN. */
static int run_straight(struct ncread *c, struct klartext *k, bool vectors, struct error *error)
{
    for (int i = 1; i < k->n; i++)
        if (read_word(c, k->word[i], k, error) < 0)
            return -1;
    if (k->machine && c->tcp)
        return ncread_error(c, error, "M91 under tool centre point control");
    if (k->machine) {
        machine_move(c, k);
        return 0;
    }
    c->vectors = vectors;
    if (!vectors) {
        ncread_turned(c, &k->to);
    } else if (k->vector_n == 3) {
        struct vec3 axis = vec(k->vector[0], k->vector[1], k->vector[2]);
        if (fabs(vec_length(axis) - 1) > 1e-5 || !c->tcp)
            return ncread_error(c, error, "LN wants a vector of length 1 and TCPM");
        if (!c->here.has_axis)
            ncread_pointed(&c->here, axis);
        ncread_pointed(&k->to, axis);
        k->named = true;
    }
    if (k->vector_n != (vectors ? 3 : 0))
        return ncread_error(c, error, "LN wants TX TY TZ, L none of them");
    if (k->call)
        return ncread_hole_m99(c, &k->to, error);
    if (!k->named)
        return 0;
    watch_path_control(c, k, vectors);
    return ncread_go(c, &k->to, ncread_piece(c, &k->to), k->fast, error);
}

/* C X Y DR+ */
static int run_circle(struct ncread *c, struct klartext *k, struct error *error)
{
    int sense = 0;
    c->plane = 17;
    for (int i = 1; i < k->n; i++) {
        if (strcmp(k->word[i], "DR+") == 0 || strcmp(k->word[i], "DR-") == 0)
            sense = k->word[i][2] == '+' ? 1 : -1;
        else if (strchr("XYF", k->word[i][k->word[i][0] == 'I']) == NULL ||
                 read_word(c, k->word[i], k, error) < 0)
            return ncread_error(c, error, "C wants X, Y, DR and F alone");
    }
    if (!sense || !c->has_centre || k->fast)
        return ncread_error(c, error, "C wants DR+ or DR- and CC before it");
    struct nc_piece piece = ncread_piece(c, &k->to);
    struct vec3 centre = vec(c->centre.x, c->centre.y, piece.p[0].z);
    if (ncread_arc(c, &piece, centre, sense > 0, error) < 0)
        return -1;
    return ncread_go(c, &k->to, piece, false, error);
}

static int set_centre(struct ncread *c, struct klartext *k, struct error *error)
{
    double at[2] = {0};
    for (int i = 0; i < 2; i++) {
        const char *w = k->n == 3 ? k->word[i + 1] : "";
        bool by = *w == 'I';
        if (w[by] != 'X' + i)
            return ncread_error(c, error, "CC wants X and Y");
        if (read_number(c, w + 1 + by, true, &at[i], error) < 0)
            return -1;
        if (by && !c->here.known[i])
            return ncread_error(c, error, "CC from a place that is not known");
        at[i] += by ? c->here.at[i] : 0;
    }
    c->has_centre = true;
    c->centre = vec(at[0], at[1], 0);
    return 0;
}

static int run_function(struct ncread *c, const struct klartext *k, struct error *error)
{
    if (k->n == 3 && strcmp(k->word[1], "RESET") == 0 && strcmp(k->word[2], "TCPM") == 0) {
        c->tcp = false;
        return 0;
    }
    if (k->n != 8 || strcmp(k->word[1], "TCPM") != 0 || strcmp(k->word[5], "POS") != 0)
        return ncread_error(c, error, "a FUNCTION that this reader does not know");
    c->tcp = true;
    c->path_control = k->word[7][0];
    if (strcmp(k->word[3], "CONT") == 0)
        ncread_watch_unasked(c, c->line, c->block,
                             "F CONT: F is not the speed of the tip where the tool turns", 0);
    return 0;
}

/* Seconds, after letters or alone. */
static void read_dwell(struct ncread *c, const char *word)
{
    double seconds;
    word += strcspn(word, "0123456789");
    if (num_read(&word, &seconds))
        c->motion->dwell += seconds / 60;
}

/* Dwell, tolerance, work offset and drilling cycles are read; those that change where the tool
 * goes, wait for a call, or stop the spindle (13) are refused. */
static int check_cycle(struct ncread *c, const struct klartext *k, struct error *error)
{
    static const long moving[] = {7, 8, 10, 11, 12, 14, 19, 26, 27, 28, 39};
    long number = k->n > 2 ? strtol(k->word[2], NULL, 10) : 0;
    if (k->n < 2 || strcmp(k->word[1], "DEF") != 0)
        return ncread_error(c, error, "CYCL CALL, which this reader does not read");
    for (size_t i = 0; i < sizeof moving / sizeof *moving; i++)
        if (number == moving[i])
            return ncread_error(
                c, error, "a cycle that moves or turns the frame, which this reader does not read");
    bool hole = number >= 200 && number <= 207 && number != 204; /* which bores from below */
    if (!hole && number != 9 && number != 32 && number != 247)
        return ncread_error(c, error, "a cycle which this reader does not read");
    return 0;
}

/* M words without a move, behind a STOP or alone. */
static int read_alone(struct ncread *c, struct klartext *k, int first, struct error *error)
{
    for (int i = first; i < k->n; i++)
        if (k->word[i][0] != 'M')
            return ncread_error(c, error, "a block that this reader does not know");
        else if (read_m(c, k->word[i] + 1, k, error) < 0)
            return -1;
    return k->call ? ncread_hole_m99(c, &k->to, error) : 0;
}

/* A block that moves nothing: the blank, a heading. */
static bool is_idle(struct ncread *c, const char *first)
{
    return strcmp(first, "BLK") == 0 || *first == '*' || ncread_meaning_of(c, first) == MEANS_IDLE;
}

static void watch_block(struct ncread *c, const struct klartext *k)
{
    const char *word[TOKENS];
    for (int i = 0; i < k->n; i++)
        word[i] = k->word[i];
    ncread_watch_text(c, k->n, word);
    ncread_tool_text(c, k->n, word);
}

/* TOOL CALL 1 Z S8000 DL+0.2: a tool longer or thicker than its table says cuts elsewhere. */
static int read_tool(struct ncread *c, const struct klartext *k, struct error *error)
{
    bool quoted = false;
    if (k->n < 3)
        return ncread_error(c, error, "TOOL CALL or TOOL DEF without a tool or a speed");
    for (int i = 2; i < k->n; i++) {
        const char *w = k->word[i], *value = w + (*w == 'S' ? 1 : 2 + (strncmp(w, "DR2", 3) == 0));
        bool name = quoted || *w == '"';
        if (!name && i <= 3 && w[1] == '\0' && strchr("XYUVW", *w))
            return ncread_error(c, error, "found a tool along another axis, expected TOOL CALL Z");
        double more = 0, speed = 0;
        for (const char *s = w; *s; s++)
            quoted = quoted != (*s == '"');
        if (!name && *w == 'S') {
            if (!num_read(&value, &speed))
                return ncread_error(c, error, "TOOL CALL with a speed that is no number");
            ncread_watch_speed(c, speed);
        }
        if (!name && (strncmp(w, "DL", 2) == 0 || strncmp(w, "DR", 2) == 0) &&
            (!num_read(&value, &more) || more != 0))
            return ncread_error(c, error,
                                "TOOL CALL with DL or DR, which this reader does not read");
    }
    return 0;
}

static int run_block(struct ncread *c, struct klartext *k, struct error *error)
{
    watch_block(c, k);
    const char *first = k->n ? k->word[0] : "";
    if (strcmp(first, "CYCL") == 0) {
        ncread_hole_define(c, k->n > 2 ? k->word[2] : "");
        if (k->n > 3 && strcmp(k->word[2], "9.1") == 0)
            read_dwell(c, k->word[k->n - 1]);
    }
    if (strcmp(first, "CYCL") == 0)
        return check_cycle(c, k, error);
    if (!*first || is_idle(c, first))
        return 0;
    if (strcmp(first, "TOOL") == 0)
        return read_tool(c, k, error);
    if (strcmp(first, "L") == 0 || strcmp(first, "LN") == 0)
        return run_straight(c, k, first[1] == 'N', error);
    if (strcmp(first, "CC") == 0)
        return set_centre(c, k, error);
    if (strcmp(first, "C") == 0)
        return run_circle(c, k, error);
    if (strcmp(first, "FUNCTION") == 0)
        return run_function(c, k, error);
    if (*first == 'M' && k->n == 1)
        return read_alone(c, k, 0, error);
    if (strcmp(first, "STOP") == 0)
        return read_alone(c, k, 1, error);
    int plane = ncread_plane_spatial(c, error);
    if (plane != 0)
        return plane < 0 ? -1 : 0;
    return ncread_error(c, error, "a block that this reader does not know");
}

static int read_block(struct ncread *c, const char *line, struct error *error)
{
    char *end;
    struct klartext k = {.to = c->here};
    c->motion->blocks++;
    if (*line == ' ')
        return ncread_hole_parameter(c, line, error);
    c->block = strtol(line, &end, 10);
    if (end == line || *end != ' ' || c->block != (long)(c->line - 1 - c->hole.lines))
        return ncread_error(c, error, "block numbers that do not count from 0");
    if (c->closed)
        return ncread_error(c, error, "a block after END PGM");
    if (split_words(c, end, &k, error) < 0)
        return -1;
    bool inch = k.n == 4 && strcmp(k.word[3], "INCH") == 0;
    bool outer =
        k.n == 4 && strcmp(k.word[1], "PGM") == 0 && (inch || strcmp(k.word[3], "MM") == 0);
    if (outer && ncread_unit(c, inch ? INCH : 1, error) < 0)
        return -1;
    if (c->block == 0) {
        c->absolute = c->said = true;
        return outer && strcmp(k.word[0], "BEGIN") == 0
                   ? 0
                   : ncread_error(c, error, "expected BEGIN PGM NAME MM or INCH");
    }
    if (c->ended) {
        c->closed = outer && strcmp(k.word[0], "END") == 0;
        return c->closed ? 0 : ncread_error(c, error, "expected END PGM after M30");
    }
    return run_block(c, &k, error);
}

static int read_end(struct ncread *c, struct error *error)
{
    if (!c->closed || c->tcp || c->spindle)
        return ncread_error(c, error,
                            "ends without END PGM, with the spindle turning or with "
                            "tool centre point control on");
    return 0;
}

static bool program_begins(const char *first, const char *second)
{
    (void)second;
    return strncmp(first, "0 BEGIN PGM ", 12) == 0;
}

const struct ncread_dialect ncread_heidenhain = {"heidenhain", program_begins, read_block, read_end,
                                                 false};
