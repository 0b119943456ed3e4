/* ncread_siemens_words - see siemens.h. */
#include "ncread_siemens.h"
#include "ncread_unit.h"

#include <string.h>

/* Names that do not change where the tool goes. */
static const char *const known_names[] = {"ORIWKS", "ORIMKS", "SOFT",  "BRISK",  "FFWON", "FFWOF",
                                          "COMPOF", "UPATH",  "SPATH", "STOPRE", "BNAT",  "ENAT",
                                          "BTAN",   "ETAN",   "G642",  "CFC",    "CFTCP", "CFIN"};

/* G words that do not change where the tool goes: compensation off, frames, path control. */
static const int no_effect[] = {40, 54, 55, 56, 57, 60, 64, 641, 642, 645};

static int g_word(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    if (w->value[0] != floor(w->value[0]))
        return ncread_unknown(c, w, error);
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
        c->plane = code;
        return 0;
    case 70:
    case 700:
        return ncread_unit(c, INCH, error);
    case 71:
    case 710:
        return ncread_unit(c, 1, error);
    case 90:
    case 91:
        c->absolute = code == 90;
        return 0;
    case 93:
    case 94:
        c->inverse_time = code == 93;
        return 0;
    default:
        for (size_t i = 0; i < sizeof no_effect / sizeof *no_effect; i++)
            if (code == no_effect[i])
                return 0;
        return ncread_unknown(c, w, error);
    }
}

static int name_word(struct ncread *c, const struct ncread_word *w, struct ncread_siemens_block *b,
                     struct error *error)
{
    if (strcmp(w->name, "CIP") == 0) {
        c->move = MOVE_CIP;
    } else if (strcmp(w->name, "POLY") == 0) {
        c->move = MOVE_POLY;
    } else if (strcmp(w->name, "BSPLINE") == 0) {
        c->move = MOVE_BSPLINE;
    } else if (strcmp(w->name, "TRAORI") == 0) {
        if (!c->setup->tcp)
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
    } else if (strcmp(w->name, "SUPA") == 0) {
        b->machine = true;
    } else if (strcmp(w->name, "MCALL") == 0) {
        c->hole.on = false;
    } else {
        for (size_t i = 0; i < sizeof known_names / sizeof *known_names; i++)
            if (strcmp(w->name, known_names[i]) == 0)
                return 0;
        return ncread_unknown(c, w, error);
    }
    return 0;
}

static int polynomial(const struct ncread *c, const struct ncread_word *w,
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

/* NAME=value */
static int set_word(struct ncread *c, const struct ncread_word *w, struct ncread_siemens_block *b,
                    struct error *error)
{
    const char *name = w->name;
    double value = w->value[0];
    if (w->values == 0) /* T="BALL" */
        return strcmp(name, "T") == 0 ? 0 : ncread_unknown(c, w, error);
    if (strncmp(name, "PO[", 3) == 0)
        return polynomial(c, w, b, error);
    if (w->values > 1)
        return ncread_unknown(c, w, error);
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
    } else if (ncread_axis(c, name, value, &b->to)) {
        b->named = true;
        b->turns = b->turns || *name < 'X';
    } else if (strcmp(name, "S") != 0 && strcmp(name, "D") != 0) {
        return ncread_unknown(c, w, error);
    }
    return 0;
}

static int address(struct ncread *c, const struct ncread_word *w, struct ncread_siemens_block *b,
                   struct error *error)
{
    double value = w->value[0], *centre;
    if (ncread_axis(c, w->name, value, &b->to)) {
        b->named = true;
        b->turns = b->turns || *w->name < 'X';
        return 0;
    }
    switch (w->name[0]) {
    case 'G':
        return g_word(c, w, error);
    case 'M':
        return ncread_m(c, w, error);
    case 'F':
        c->feed = value;
        c->feed_here = true;
        return 0;
    case 'I':
    case 'J':
    case 'K':
        centre = w->name[0] == 'I' ? &b->centre.x : w->name[0] == 'J' ? &b->centre.y : &b->centre.z;
        *centre += value;
        b->centre_named = true;
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

int ncread_siemens_words(struct ncread *c, struct ncread_siemens_block *b, struct error *error)
{
    if (ncread_hole_dwell(c, 0))
        return 0;
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        for (size_t k = 0; k < i; k++)
            if (strcmp(w->name, c->words.item[k].name) == 0 && !strchr("GM", w->name[0]))
                return ncread_error(c, error, "a word twice in one block");
        int result = 0;
        if (w->kind == WORD_NAME)
            result = name_word(c, w, b, error);
        else if (w->kind == WORD_SET)
            result = set_word(c, w, b, error);
        else if (w->kind == WORD_ADDRESS)
            result = address(c, w, b, error);
        else if (strncmp(w->name, "CYCLE8", 6) == 0 && strlen(w->name) == 7)
            result = ncread_hole_call(c, w->name, error);
        else if (strcmp(w->name, "CYCLE800") == 0)
            result = ncread_plane_cycle800(c, error) < 0 ? -1 : 0;
        else if (strcmp(w->name, "CYCLE832") && strcmp(w->name, "FGROUP") &&
                 strcmp(w->name, "MSG") && strcmp(w->name, "TRAORI"))
            result = ncread_unknown(c, w, error);
        if (result < 0)
            return -1;
    }
    return 0;
}
