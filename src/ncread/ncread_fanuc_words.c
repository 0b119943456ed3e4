/* ncread_fanuc_words - see ncread_fanuc.h. */
#include "ncread_fanuc.h"
#include "ncread_iso.h"

#include <string.h>

static int g_tool(struct ncread *c, const struct ncread_word *w, struct ncread_fanuc_block *b,
                  struct error *error)
{
    if (!c->setup->tcp)
        return ncread_error(c, error, "tool centre point control on a machine without it");
    if (!ncread_word_find(&c->words, "H"))
        return ncread_error(c, error, "tool centre point control without H");
    c->tcp = b->tool = true;
    c->vectors = w->value[0] > 43.45;
    memset(b->to.known, 0, sizeof b->to.known);
    c->here = b->to;
    return 0;
}

/* Modal and other G words, before the addresses are looked at. */
static int g_word(struct ncread *c, const struct ncread_word *w, struct ncread_fanuc_block *b,
                  struct error *error)
{
    int code = (int)lround(w->value[0] * 10);
    int taken = ncread_hole_code(c, code) ? 1 : ncread_iso_g(c, code, error);
    if (taken != 0)
        return taken < 0 ? -1 : 0;
    switch (code) {
    case 51:  /* smoothing */
    case 690: /* no tilted plane: ncread_plane */
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
    case 280:
        b->home = true;
        return 0;
    case 430:
        c->length = true;
        return 0;
    case 434:
    case 435:
        c->length = true;
        return g_tool(c, w, b, error);
    case 490:
        c->tcp = c->vectors = c->length = false;
        return 0;
    case 530:
        b->machine = true;
        return 0;
    default:
        return ncread_unknown(c, w, error);
    }
}

/* All other words. */
static int address(struct ncread *c, const struct ncread_word *w, struct ncread_fanuc_block *b,
                   struct error *error)
{
    char letter = w->name[0];
    if (strchr("XYZABCIJKRFQ", letter) && !w->pointed)
        return ncread_error(c, error, "a length, angle or feed without a decimal point");
    if (ncread_axis(c, w->name, w->value[0], &b->to)) {
        b->named = true;
    } else if (letter >= 'I' && letter <= 'K') {
        b->centre[letter - 'I'] = w->value[0];
        b->centre_named[letter - 'I'] = true;
    } else if (letter == 'R') {
        b->radius = w->value[0];
        b->radius_named = true;
    } else if (letter == 'F') {
        c->feed = w->value[0];
        c->feed_here = true;
    } else if (letter == 'P' && c->move == MOVE_SPLINE) {
        c->order = (int)w->value[0];
        if (c->order < 2 || c->order > 4)
            return ncread_error(c, error, "a spline whose order is not 2 to 4");
    } else if (!strchr("STHDPQ", letter)) {
        return ncread_unknown(c, w, error);
    }
    return 0;
}

int ncread_fanuc_words(struct ncread *c, struct ncread_fanuc_block *b, struct error *error)
{
    unsigned seen = 0;
    if (ncread_hole_dwell(c, 0.001))
        return 0;
    int plane = ncread_plane_g(c, error);
    if (plane != 0)
        return plane < 0 ? -1 : 0;
    for (size_t i = 0; i < c->words.n; i++) {
        const struct ncread_word *w = &c->words.item[i];
        unsigned bit = 1u << (w->name[0] - 'A');
        if (w->name[0] == 'N' && i > 0)
            return ncread_error(c, error, "N behind other words");
        if (w->name[0] == 'G'   ? g_word(c, w, b, error) < 0
            : w->name[0] == 'M' ? ncread_m(c, w, error) < 0
                                : false)
            return -1;
        if (strchr("GM", w->name[0]))
            continue;
        if (seen & bit)
            return ncread_error(c, error, "a word twice in one block");
        seen |= bit;
    }
    for (size_t i = 0; i < c->words.n; i++)
        if (!strchr("GMN", c->words.item[i].name[0]) && address(c, &c->words.item[i], b, error) < 0)
            return -1;
    return 0;
}
