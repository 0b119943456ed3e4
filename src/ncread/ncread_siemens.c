/*
 * ncread_siemens - blocks of the Sinumerik 840D sl and ONE (NC programming manual and the design
 * notes).
 *
 * Under TRAORI X Y Z are the tip in the frame of the work; the axis by A3= B3= C3= on the great
 * circle (ORIVECT), by rotary words in proportion (ORIAXES) or by a second point (ORICURVE).
 */
#include <string.h>

#include "ncread_state.h"

enum siemens_move {
    MOVE_NONE,
    MOVE_RAPID,
    MOVE_LINE,
    MOVE_CW,
    MOVE_CCW,
    MOVE_CIP,
    MOVE_POLY,
    MOVE_BSPLINE
};

/* A polynomial's end and coefficients, PO[X]=(end, a2, a3, a4, a5). */
struct polynomial {
    bool named;
    double value[NC_MOTION_DEGREE];
};

/* What one block says besides its modal words. */
struct ncread_siemens_block {
    struct ncread_place to;
    bool named;   /* a word that moves something */
    bool machine; /* SUPA */
    bool turns;   /* rotary words */
    int vector_n, head_n, middle_n;
    double vector[3], middle[3], head[3];
    bool centre_named, radius_named;
    struct vec3 centre; /* absolute */
    double radius;
    double length; /* PL */
    double weight; /* PW, of a pole; weighs: named */
    bool weighs;
    struct polynomial tip[3], second[3];
};

/* The first n letters of a name are one of these, whole. */
static bool is_among(const char *name, size_t n, const char *const list[], size_t listed)
{
    for (size_t i = 0; i < listed; i++)
        if (strlen(list[i]) == n && strncmp(list[i], name, n) == 0)
            return true;
    return false;
}

#define IS_ONE_OF(name, list) is_among(name, strlen(name), list, sizeof(list) / sizeof *(list))

/* Names that do not change where the tool goes. */
static const char *const known_names[] = {
    "ORIWKS",   "SOFT",    "BRISK", "FFWON", "FFWOF",   "COMPOF",   "STOPRE",    "BNAT",
    "ENAT",     "BTAN",    "ETAN",  "G642",  "CFC",     "CFTCP",    "CFIN",      "COMPON",
    "COMPCURV", "COMPCAD", "DRIVE", "SOFTA", "BRISKA",  "FIFOCTRL", "STARTFIFO", "STOPFIFO",
    "CYCLE832", "DIAMOF",  "KONT",  "NORM",  "ADISPOS", "WALIMOF",  "WALIMON"};

static bool is_idle_call(const char *name)
{
    static const char *const idle[] = {"CYCLE832", "MSG"};
    return IS_ONE_OF(name, idle);
}

/* G words that do not change where the tool goes: compensation off, frames, path control, what
 * compensation does at corners, how a soft approach would go (of G147, which is not read). */
static const int no_effect[] = {9,   40,  54,  55,  56,  57,  60,  62,  64,  97,  140,
                                141, 142, 143, 340, 341, 450, 451, 460, 461, 462, 500,
                                601, 602, 603, 621, 641, 642, 643, 644, 645};

/* A G word that is not known: those that move the tool (G331, G147) or shift it (G58) are too many
 * to be listed, so that a control's file must say that one does not. */
static int unknown_g(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    if (ncread_meaning_of_word(c, w) == MEANS_IDLE)
        return 0;
    if (ncread_meaning_moves('G', (int)lround(10 * w->value[0])))
        return ncread_unknown(c, w, error); /* which says what it is */
    return ncread_unread(c, w, error);
}

/* G18 and G19 turn the tool's length along with the plane, but for a setting of the machine
 * (SD42940 TOOL_LENGTH_CONST); ncpost writes neither. */
static void set_plane(struct ncread *c, int plane)
{
    const char *text = plane == 18 ? "G18 may put the tool's length along Y"
                                   : "G19 may put the tool's length along X";
    if (plane != 17 && c->plane != plane)
        ncread_watch_unasked(c, c->line, c->block, text, 0);
    c->plane = plane;
}

static int read_g(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    if (w->value[0] != floor(w->value[0]))
        return unknown_g(c, w, error);
    int code = (int)w->value[0];
    switch (code) {
    case 0:
    case 1:
    case 2:
    case 3:
        c->move = MOVE_RAPID + code;
        return 0;
    case 17:
    case 18:
    case 19:
        set_plane(c, code);
        return 0;
    case 41: /* a path of the centre, whatever the side */
    case 42:
        return c->options->cutcom ? 0 : unknown_g(c, w, error);
    case 70:
    case 700:
        return ncread_unit(c, INCH, error);
    case 71:
    case 710:
        return ncread_unit(c, 1, error);
    case 90:
    case 91:
        c->absolute = code == 90;
        c->said = true;
        return 0;
    case 93:
    case 94:
        c->inverse_time = code == 93;
        return 0;
    default:
        for (size_t i = 0; i < sizeof no_effect / sizeof *no_effect; i++)
            if (code == no_effect[i])
                return 0;
        return code >= 505 && code <= 599 ? 0 : unknown_g(c, w, error); /* work offsets */
    }
}

static int read_name(struct ncread *c, const struct ncread_word *w, struct ncread_siemens_block *b,
                     struct error *error)
{
    if (strcmp(w->name, "CIP") == 0) {
        c->move = MOVE_CIP;
    } else if (strcmp(w->name, "POLY") == 0) {
        c->move = MOVE_POLY;
    } else if (strcmp(w->name, "BSPLINE") == 0) {
        c->move = MOVE_BSPLINE;
    } else if (strcmp(w->name, "TRAORI") == 0) {
        if (!c->options->tcp)
            return ncread_error(c, error, "TRAORI on a machine without it");
        c->tcp = true;
        memset(b->to.known, 0, sizeof b->to.known);
        c->here = b->to;
    } else if (strcmp(w->name, "TRAFOOF") == 0) {
        c->tcp = false;
        memset(b->to.known, 0, sizeof b->to.known);
        c->here = b->to;
    } else if (strcmp(w->name, "ORIVECT") == 0) {
        c->vectors = true;
        c->curve = false;
    } else if (strcmp(w->name, "ORIAXES") == 0) {
        c->vectors = c->curve = false;
    } else if (strcmp(w->name, "ORICURVE") == 0) {
        c->vectors = c->curve = true;
        b->to.has_head = c->here.has_head = false;
    } else if (strcmp(w->name, "UPATH") == 0 || strcmp(w->name, "SPATH") == 0) {
        c->parameter = *w->name == 'U';
    } else if (strcmp(w->name, "ORIMKS") == 0) {
        return ncread_error(c, error,
                            "ORIMKS: the tool axis would follow the machine, not the work");
    } else if (strcmp(w->name, "SUPA") == 0) {
        b->machine = true;
    } else if (strcmp(w->name, "MCALL") == 0) {
        c->hole.on = false;
    } else if (!IS_ONE_OF(w->name, known_names)) {
        return ncread_unknown(c, w, error);
    }
    return 0;
}

static int read_polynomial(struct ncread *c, const struct ncread_word *w,
                           struct ncread_siemens_block *b, struct error *error)
{
    char axis = w->name[3];
    bool head = w->name[4] == 'H';
    if (axis < 'X' || axis > 'Z' || strcmp(w->name + 4 + head, "]") != 0 ||
        w->values > NC_MOTION_DEGREE)
        return ncread_unknown(c, w, error);
    struct polynomial *p = head ? &b->second[axis - 'X'] : &b->tip[axis - 'X'];
    p->named = true;
    for (int i = 0; i < w->values; i++)
        p->value[i] = w->value[i];
    if (head) {
        b->head[axis - 'X'] = p->value[0];
        b->head_n++;
    } else {
        b->to.at[axis - 'X'] = p->value[0];
        b->to.known[axis - 'X'] = true;
    }
    b->named = true;
    return 0;
}

/* X5, X=5, X=AC(5), X=IC(5), and so on for all axes: true when the word is one. */
static bool read_axis(struct ncread *c, const struct ncread_word *w, struct ncread_siemens_block *b)
{
    bool by = w->by || (c->said && !c->absolute && !w->absolute && !b->machine);
    if (by ? !ncread_axis_by(c, w->name, w->value[0], &b->to)
           : !ncread_axis(c, w->name, w->value[0], &b->to))
        return false;
    b->named = true;
    b->turns = b->turns || *w->name < 'X';
    return true;
}

/* I J K: the centre from where the tool is; I=AC(5) from the zero. */
static bool read_centre(const struct ncread *c, const struct ncread_word *w,
                        struct ncread_siemens_block *b)
{
    if (w->name[1] || *w->name < 'I' || *w->name > 'K')
        return false;
    int k = *w->name - 'I';
    double *centre = k == 0 ? &b->centre.x : k == 1 ? &b->centre.y : &b->centre.z;
    *centre = w->value[0] - (w->absolute ? c->here.at[k] : 0);
    b->centre_named = true;
    return true;
}

/* NAME=value that moves nothing: auxiliary functions, other spindles, limits of the axes, and
 * overrides that make nothing faster. */
static bool is_idle_setting(const struct ncread_word *w)
{
    static const char *const idle[] = {"H",        "M",       "S",        "ACC",
                                       "ACCLIMA",  "JERKLIM", "JERKLIMA", "VELOLIM",
                                       "VELOLIMA", "LIMS",    "FAD"},
                             *const slow[] = {"OVR", "OVRA", "OVRRAP"};
    size_t n = strcspn(w->name, "0123456789[");
    bool slower = w->values == 1 && w->value[0] > 0 && w->value[0] <= 100;
    return is_among(w->name, n, idle, sizeof idle / sizeof *idle) ||
           (slower && is_among(w->name, n, slow, sizeof slow / sizeof *slow));
}

/* How far path control may round: ncread_rounding judges it. */
static bool is_rounding(const char *name)
{
    static const char *const rounding[] = {"ADIS", "ADISPOS", "ATOL", "CTOL", "OTOL"};
    return is_among(name, strcspn(name, "["), rounding, sizeof rounding / sizeof *rounding);
}

/* SPOS=0, SPOSA[1]=90: the spindle that cuts turns to an angle and stands there. */
static bool is_turned(const char *name)
{
    static const char *const turning[] = {"SPOS", "SPOSA", "SPOS[1]", "SPOSA[1]"};
    return IS_ONE_OF(name, turning);
}

/* One that is not known: an offset of the tool (TOFFL, TCARR, DL), an oscillating axis (OS[X]), a
 * feed of the block (FB) have no mark that tells them from others. */
static int unknown_setting(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    if (ncread_meaning_of(c, w->name) == MEANS_IDLE || is_rounding(w->name))
        return 0;
    if (!is_idle_setting(w))
        return ncread_unread(c, w, error);
    return strchr("HMS", *w->name) ? ncread_unknown(c, w, error) : 0; /* the maker's: it is told */
}

/* NAME=value */
static int read_setting(struct ncread *c, const struct ncread_word *w,
                        struct ncread_siemens_block *b, struct error *error)
{
    const char *name = w->name;
    double value = w->value[0];
    if (is_turned(name)) {
        c->spindle = false;
        return 0;
    }
    if (w->values == 0) /* T="BALL" */
        return strcmp(name, "T") == 0 ? 0 : unknown_setting(c, w, error);
    if (strncmp(name, "PO[", 3) == 0)
        return read_polynomial(c, w, b, error);
    if (w->values > 1)
        return unknown_setting(c, w, error);
    if (strlen(name) == 2 && name[0] >= 'A' && name[0] <= 'C' && name[1] == '3') {
        b->vector[name[0] - 'A'] = value;
        b->vector_n++;
        b->named = true;
    } else if (strlen(name) == 2 && name[0] >= 'X' && name[0] <= 'Z' && name[1] == 'H') {
        b->head[name[0] - 'X'] = value;
        b->head_n++;
        b->named = true;
    } else if (strlen(name) == 2 && name[0] >= 'I' && name[0] <= 'K' && name[1] == '1') {
        if (!w->absolute)
            return ncread_error(c, error, "an intermediate point without AC()");
        b->middle[name[0] - 'I'] = value;
        b->middle_n++;
    } else if (strcmp(name, "PL") == 0) {
        b->length = value;
    } else if (strcmp(name, "PW") == 0) {
        b->weight = value;
        b->weighs = true;
    } else if (strcmp(name, "SD") == 0) {
        c->order = (int)value + 1;
    } else if (strcmp(name, "CR") == 0) {
        b->radius = value;
        b->radius_named = true;
    } else if (w->shortest) {
        if (value < 0 || value > 360)
            return ncread_error(c, error, "DC() of less than 0 or more than 360 degrees");
        if (strchr("ABC", *name) == NULL || name[1] || !ncread_nearest(c, *name, value, &b->to))
            return ncread_error(c, error, "DC() where no rotary axis is, or one not known yet");
        b->named = b->turns = true;
    } else if (read_axis(c, w, b) || read_centre(c, w, b)) {
        return 0;
    } else if (w->by || w->absolute || ncread_meaning_shapes(name)) {
        return ncread_error(c, error, "a word of a place that this reader does not know");
    } else if (strcmp(name, "S") != 0 && strcmp(name, "D") != 0) {
        return unknown_setting(c, w, error);
    }
    return 0;
}

/* M70: the spindle as an axis; M17: the end, where no program has called this one. */
static int read_m(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    if (ncread_meaning_of_word(c, w) != MEANS_NOTHING_KNOWN ||
        (w->value[0] != 70 && w->value[0] != 17))
        return ncread_m(c, w, error);
    c->spindle = c->spindle && w->value[0] != 70;
    c->ended = c->ended || w->value[0] == 17;
    return 0;
}

static int read_address(struct ncread *c, const struct ncread_word *w,
                        struct ncread_siemens_block *b, struct error *error)
{
    if (read_axis(c, w, b) || read_centre(c, w, b))
        return 0;
    switch (w->name[0]) {
    case 'G':
        return read_g(c, w, error);
    case 'M':
        return read_m(c, w, error);
    case 'F':
        c->feed = w->value[0];
        c->feed_here = true;
        return 0;
    case 'N':
    case 'S':
    case 'T':
    case 'D':
        return 0;
    default:
        return ncread_unknown(c, w, error);
    }
}

/* M1=3 S1=8000 T1=5 of the spindle that cuts, and F=800, are M3 S8000 T5 F800. */
static void plain_words(struct ncread_words *words)
{
    for (size_t i = 0; i < words->n; i++) {
        struct ncread_word *w = &words->item[i];
        if (w->kind != WORD_SET || !strchr("MSTF", *w->name) ||
            (w->name[1] && strcmp(w->name + 1, "1") != 0) || (*w->name == 'F' && w->name[1]))
            continue;
        w->name[1] = '\0';
        if (w->values == 1 && !w->by && !w->absolute && !w->shortest)
            w->kind = WORD_ADDRESS;
    }
}

/* FGROUP() is as usual, FGROUP(X,Y,Z,A,C) has the axes of the tip. */
static bool has_feed(const char *text)
{
    const char *at = strstr(text, "FGROUP(") + strlen("FGROUP("), *end = strchr(at, ')');
    bool all = at == end;
    size_t n = (size_t)(end - at);
    return all || (memchr(at, 'X', n) && memchr(at, 'Y', n) && memchr(at, 'Z', n));
}

/* G4 stands alone with its time, F or S. */
static int check_dwell(struct ncread *c, struct error *error)
{
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        bool own = w->kind == WORD_ADDRESS && !w->name[1] && strchr("NFSH", *w->name);
        if (!own && !(w->kind == WORD_ADDRESS && *w->name == 'G' && w->value[0] == 4))
            return ncread_error(c, error, "G4 with other words than its time");
    }
    return 0;
}

/* The words of a block into the state and *b. */
static int read_words(struct ncread *c, struct ncread_siemens_block *b, struct error *error)
{
    plain_words(&c->words);
    if (ncread_hole_dwell(c, 0))
        return check_dwell(c, error);
    for (size_t i = 0; i < c->words.n; i++) { /* they hold for words before them too */
        const struct ncread_word *w = &c->words.item[i];
        if (w->kind == WORD_ADDRESS && *w->name == 'G' && !w->name[1] &&
            (w->value[0] == 90 || w->value[0] == 91) && read_g(c, w, error) < 0)
            return -1;
        b->machine = b->machine || (w->kind == WORD_NAME && strcmp(w->name, "SUPA") == 0);
    }
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        for (size_t k = 0; k < i; k++)
            if (strcmp(w->name, c->words.item[k].name) == 0 && !strchr("GM", w->name[0]))
                return ncread_error(c, error, "a word twice in one block");
        int result = 0;
        if (w->kind == WORD_NAME)
            result = read_name(c, w, b, error);
        else if (w->kind == WORD_SET)
            result = read_setting(c, w, b, error);
        else if (w->kind == WORD_ADDRESS)
            result = read_address(c, w, b, error);
        else if (strncmp(w->name, "CYCLE8", 6) == 0 && strlen(w->name) == 7)
            result = ncread_hole_call(c, w->name, error);
        else if (strcmp(w->name, "CYCLE800") == 0)
            result = ncread_plane_cycle800(c, error) < 0 ? -1 : 0;
        else if (strcmp(w->name, "TRAORI") == 0 && strstr(c->text, "TRAORI(1)"))
            result = read_name(c, w, b, error);
        else if (strcmp(w->name, "FGROUP") == 0 && !has_feed(c->text))
            result = ncread_error(c, error, "FGROUP without X, Y and Z: F would not be the tip's");
        else if (strcmp(w->name, "FGROUP") != 0 && !is_idle_call(w->name))
            result = ncread_unknown(c, w, error);
        if (result < 0)
            return -1;
    }
    return 0;
}

/* The tool axis at the end of the block. */
static int block_axis(struct ncread *c, struct ncread_siemens_block *b, struct error *error)
{
    if ((b->vector_n != 0 && b->vector_n != 3) || (b->head_n != 0 && b->head_n != 3))
        return ncread_error(c, error, "a tool vector or second point wants all three words");
    if ((b->vector_n == 3) + (b->head_n == 3) + b->turns > 1)
        return ncread_error(c, error, "the tool axis is given twice");
    if (b->head_n == 3) {
        if (!c->curve)
            return ncread_error(c, error, "a second point without ORICURVE");
        b->to.head = vec(b->head[0], b->head[1], b->head[2]);
        b->to.has_head = true;
        struct vec3 tip = vec(b->to.at[0], b->to.at[1], b->to.at[2]);
        ncread_pointed(&b->to, vec_sub(b->to.head, tip));
    } else if (b->vector_n == 3) {
        struct vec3 axis = vec(b->vector[0], b->vector[1], b->vector[2]);
        if (c->curve)
            return ncread_error(c, error, "a tool vector under ORICURVE");
        if (!c->tcp || fabs(vec_length(axis) - 1) > 1e-3)
            return ncread_error(c, error, "a tool vector wants TRAORI and length 1");
        ncread_pointed(&b->to, axis);
        b->to.has_head = false;
    } else if (b->turns) {
        ncread_turned(c, &b->to);
        b->to.has_head = false;
    } else if (b->named && b->to.has_head) {
        return ncread_error(c, error, "the tip moves under ORICURVE, the second point does not");
    }
    return 0;
}

/* Coefficients of s = p / PL from those of p; the first follows from the ends. */
static void coefficients(const struct polynomial p[3], double length, struct vec3 from,
                         struct vec3 to, struct vec3 c[NC_MOTION_DEGREE])
{
    double power = length;
    c[0] = vec_sub(to, from);
    for (int i = 1; i < NC_MOTION_DEGREE; i++) {
        power *= length;
        c[i] = vec_scale(power, vec(p[0].value[i], p[1].value[i], p[2].value[i]));
        c[0] = vec_sub(c[0], c[i]);
    }
}

static int poly_piece(struct ncread *c, struct ncread_siemens_block *b, struct nc_piece *piece,
                      struct error *error)
{
    if (!(b->length > 0))
        return ncread_error(c, error, "POLY with a PL that is not above zero");
    struct nc_motion_polynomial sum = {.turns = b->head_n == 3};
    piece->shape = SHAPE_POLYNOMIAL;
    piece->index = c->motion->polynomial.n;
    coefficients(b->tip, b->length, piece->p[0], piece->p[1], sum.p);
    if (b->head_n == 3 && piece->interpolation != AXIS_BY_HEAD)
        return ncread_error(c, error, "ORICURVE from a second point that is not known");
    if (sum.turns)
        coefficients(b->second, b->length, piece->q[0], piece->q[1], sum.q);
    *array_push(&c->motion->polynomial) = sum;
    return 0;
}

/* One pole of a BSPLINE; the first pole is where the tool is. */
static int bspline_block(struct ncread *c, struct ncread_siemens_block *b, struct nc_piece *piece,
                         struct error *error)
{
    if (b->vector_n == 3 || b->length != 1)
        return ncread_error(c, error, "BSPLINE with tool vectors or PL");
    if (b->head_n == 3 && piece->interpolation != AXIS_BY_HEAD)
        return ncread_error(c, error, "ORICURVE from a second point that is not known");
    if (c->pole_p.n == 0) {
        if (ncread_ready(c, error) < 0)
            return -1;
        ncread_pole(c, piece, piece->p[0], piece->q[0]);
        *array_push(&c->weight) = 1;
    }
    ncread_pole(c, piece, piece->p[1], piece->q[1]);
    *array_push(&c->weight) = b->weight;
    c->here = b->to;
    return 0;
}

/* Uniform knots, the ends repeated: the spline that has been read is complete. */
static int bspline_ends(struct ncread *c, struct error *error)
{
    size_t order = c->order ? (size_t)c->order : 4, n = c->pole_p.n;
    if (n == 0)
        return 0;
    c->order = (int)order;
    for (size_t i = 0; i < n + order; i++)
        *array_push(&c->knot) = i < order ? 0
                                : i < n   ? (double)(i - order + 1)
                                          : (double)(n - order + 1);
    return ncread_spline(c, error);
}

static int arc_piece(struct ncread *c, struct ncread_siemens_block *b, struct nc_piece *piece,
                     struct error *error)
{
    if (b->centre_named == b->radius_named)
        return ncread_error(c, error, "an arc wants its centre by I J K or CR=, not both");
    if (b->radius_named)
        return ncread_arc_radius(c, piece, b->radius, c->move == MOVE_CCW, error);
    return ncread_arc(c, piece, vec_add(piece->p[0], b->centre), c->move == MOVE_CCW, error);
}

static int run_block(struct ncread *c, struct ncread_siemens_block *b, struct error *error)
{
    bool polynomials = false;
    for (int i = 0; i < 3; i++)
        polynomials = polynomials || b->tip[i].named || b->second[i].named;
    if (b->machine) {
        if (c->tcp)
            return ncread_error(c, error, "SUPA under TRAORI");
        memset(c->here.known, 0, sizeof c->here.known);
        return 0;
    }
    if (block_axis(c, b, error) < 0)
        return -1;
    bool round = b->centre_named && (c->move == MOVE_CW || c->move == MOVE_CCW); /* G2 I5 */
    if (!b->named && !round && !b->centre_named && !b->radius_named)
        return c->move == MOVE_BSPLINE ? 0 : bspline_ends(c, error);
    if ((b->centre_named || b->radius_named) && c->move != MOVE_CW && c->move != MOVE_CCW)
        return ncread_error(c, error,
                            "I, J, K or CR without an arc, which this reader does not read");
    if (c->move == MOVE_NONE)
        return ncread_error(c, error, "a place before G0 or G1");
    if (!c->said)
        return ncread_error(c, error, "a place before G90 or G91");
    if (!c->absolute && (c->move == MOVE_POLY || c->move == MOVE_BSPLINE))
        return ncread_error(c, error, "a curve under G91, which this reader does not read");
    if (c->curve && !c->parameter && (c->move == MOVE_POLY || c->move == MOVE_BSPLINE))
        return ncread_error(c, error, "a curve under ORICURVE without UPATH");
    if (c->hole.on)
        return ncread_hole_down(c, &b->to, error);
    if (b->weighs && c->move != MOVE_BSPLINE)
        return ncread_error(c, error, "PW without BSPLINE");
    if (polynomials && c->move != MOVE_POLY)
        return ncread_error(c, error, "PO[] without POLY");
    if (b->middle_n != (c->move == MOVE_CIP ? 3 : 0))
        return ncread_error(c, error, "CIP wants I1= J1= K1=, others none of them");
    if (c->move != MOVE_BSPLINE && bspline_ends(c, error) < 0)
        return -1;
    struct nc_piece piece = ncread_piece(c, &b->to);
    int result = 0;
    if (c->move == MOVE_BSPLINE)
        return bspline_block(c, b, &piece, error);
    if (c->move == MOVE_CW || c->move == MOVE_CCW)
        result = arc_piece(c, b, &piece, error);
    else if (c->move == MOVE_CIP)
        result =
            ncread_arc_through(c, &piece, vec(b->middle[0], b->middle[1], b->middle[2]), error);
    else if (c->move == MOVE_POLY)
        result = poly_piece(c, b, &piece, error);
    return result < 0 ? -1 : ncread_go(c, &b->to, piece, c->move == MOVE_RAPID, error);
}

static int read_block(struct ncread *c, const char *line, struct error *error)
{
    c->motion->blocks++;
    if (c->line == 1) {
        size_t n = strlen(line);
        c->plane = 17;
        c->vectors = true;
        bool named = n > 8 && strncmp(line, "%_N_", 4) == 0 && strcmp(line + n - 4, "_MPF") == 0;
        if (*line == '%')
            return named ? 0 : ncread_error(c, error, "expected %_N_NAME_MPF");
    }
    if (!*line)
        return 0;
    if (c->ended)
        return ncread_error(c, error, "a block after M30");
    if (strlen(line) > 512)
        return ncread_error(c, error, "a block of more than 512 characters");
    struct error found;
    int lexed = ncread_word_siemens(line, &c->words, &found);
    const struct ncread_word *n = ncread_word_find(&c->words, "N");
    if (n && ncread_block(c, n->value[0], error) < 0)
        return -1;
    ncread_watch_skip(c, line);
    if (lexed < 0)
        return ncread_error(c, error, found.text);
    struct ncread_siemens_block b = {.to = c->here, .length = 1, .weight = 1};
    if (read_words(c, &b, error) < 0)
        return -1;
    ncread_watch_words(c);
    ncread_tool_words(c);
    return run_block(c, &b, error);
}

static int read_end(struct ncread *c, struct error *error)
{
    if (!c->ended)
        return ncread_error(c, error, "the program ends without M30");
    if (c->pole_p.n > 0)
        return ncread_error(c, error, "the program ends inside a BSPLINE");
    if (c->tcp || c->spindle)
        return ncread_error(c, error, "ends with the spindle turning or with TRAORI on");
    return 0;
}

static bool program_begins(const char *first, const char *second)
{
    (void)second;
    return strncmp(first, "%_N_", 4) == 0;
}

const struct ncread_dialect ncread_siemens = {"siemens", program_begins, read_block, read_end,
                                              true};
