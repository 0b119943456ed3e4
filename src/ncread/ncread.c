/* ncread - see ncread.h. */
#include "ncread/ncread.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ncread_unit.h"
#include "base/reader.h"

int ncread_error(const struct ncread *c, struct error *error, const char *what)
{
    if (c->block >= 0)
        return error_at(error, c->name, c->line, "N%ld: %s", c->block, what);
    return error_at(error, c->name, c->line, "%s", what);
}

int ncread_unknown(const struct ncread *c, const struct ncread_word *w, struct error *error)
{
    char text[120];
    if (w->kind == WORD_ADDRESS)
        snprintf(text, sizeof text, "found %s%.15g, which this reader does not know", w->name,
                 w->value[0]);
    else
        snprintf(text, sizeof text, "found %s, which this reader does not know", w->name);
    return ncread_error(c, error, text);
}

int ncread_m(struct ncread *c, const struct ncread_word *w, struct error *error)
{
    int code = (int)w->value[0];
    if (code == 3 || code == 4 || code == 5)
        c->spindle = code != 5;
    else if (code == 30)
        c->ended = true;
    else if (!(code == 0 || code == 1 || (code >= 6 && code <= 9)))
        return ncread_unknown(c, w, error);
    return 0;
}

int ncread_block(struct ncread *c, double number, struct error *error)
{
    c->block = (long)number;
    bool anew = c->last_block >= 9900 && c->block <= 100; /* the digits are used up */
    if (c->block <= c->last_block && !anew)
        return ncread_error(c, error, "its number does not rise");
    c->last_block = c->block;
    return 0;
}

bool ncread_axis(const struct ncread *c, const char *name, double value, struct ncread_place *to)
{
    if (strlen(name) != 1)
        return false;
    if (*name >= 'X' && *name <= 'Z') {
        to->at[*name - 'X'] = value;
        to->known[*name - 'X'] = true;
        return true;
    }
    for (int i = 0; i < c->setup->verify_kinematics.n; i++)
        if (*name == c->setup->verify_kinematics.axis[i].letter) {
            to->turn[i] = value;
            to->turned[i] = true;
            return true;
        }
    return false;
}

static bool all_turned(const struct ncread *c, const struct ncread_place *place)
{
    for (int i = 0; i < c->setup->verify_kinematics.n; i++)
        if (!place->turned[i])
            return false;
    return true;
}

void ncread_turned(const struct ncread *c, struct ncread_place *to)
{
    if (all_turned(c, to)) {
        to->axis = verify_kinematics_axis_at(&c->setup->verify_kinematics, to->turn);
        to->has_axis = true;
    }
}

void ncread_pointed(struct ncread_place *to, struct vec3 axis)
{
    to->axis = vec_unit(axis);
    to->has_axis = true;
    to->turned[0] = to->turned[1] = false;
}

static bool all_known(const struct ncread_place *place)
{
    return place->known[0] && place->known[1] && place->known[2];
}

static struct vec3 point_of(const struct ncread_place *place)
{
    return vec(place->at[0], place->at[1], place->at[2]);
}

struct nc_piece ncread_piece(const struct ncread *c, const struct ncread_place *to)
{
    struct nc_piece piece = {
        .line = c->line, .block = (int)c->block, .feed = c->feed, .inverse = c->inverse_time};
    const struct ncread_place *from = &c->here;
    piece.p[0] = point_of(from);
    piece.p[1] = point_of(to);
    if (c->tilted.on) {
        piece.swing = SWING_GREAT;
        piece.q[0] = piece.q[1] = vec(0, 0, 1);
    } else if (c->curve && from->has_head && to->has_head) {
        piece.swing = SWING_HEAD;
        piece.q[0] = from->head;
        piece.q[1] = to->head;
    } else if (c->vectors && c->setup->tcp) {
        piece.swing = SWING_GREAT;
        piece.q[0] = from->axis;
        piece.q[1] = to->axis;
    } else {
        piece.swing = SWING_ROTARY;
        piece.q[0] = vec(from->turn[0], from->turn[1], 0);
        piece.q[1] = vec(to->turn[0], to->turn[1], 0);
        piece.table = !c->setup->tcp;
    }
    return piece;
}

bool ncread_upright(const struct ncread *c)
{
    for (int i = 0; i < c->setup->verify_kinematics.n; i++)
        if (!c->here.turned[i] || c->here.turn[i] != 0)
            return false;
    return true;
}

int ncread_ready(const struct ncread *c, struct error *error)
{
    if (!(c->unit > 0) || !c->absolute)
        return ncread_error(c, error, "cuts before its unit and absolute words are set");
    if (!c->spindle)
        return ncread_error(c, error, "cuts while the spindle stands");
    if (c->setup->tcp && !c->tcp && !c->tilted.on && !ncread_upright(c))
        return ncread_error(c, error, "cuts without tool centre point control");
    if (!(c->feed > 0))
        return ncread_error(c, error, "cuts without a feed");
    if (c->inverse_time && !c->feed_here)
        return ncread_error(c, error, "no F in a block under inverse time feed");
    if (!all_known(&c->here) || !(c->here.has_axis || c->tilted.on))
        return ncread_error(c, error, "cuts from a place or with an axis that is not known");
    return 0;
}

int ncread_go(struct ncread *c, const struct ncread_place *to, struct nc_piece piece, bool rapid,
              struct error *error)
{
    if (!rapid && ncread_ready(c, error) < 0)
        return -1;
    piece.rapid = rapid;
    bool tracked = c->tcp || !c->setup->tcp || c->tilted.on || ncread_upright(c);
    if (piece.swing == SWING_ROTARY && !rapid && !(all_turned(c, &c->here) && all_turned(c, to)))
        return ncread_error(c, error, "cuts with rotary axes whose place is not known");
    if (tracked && all_known(to) && (to->has_axis || c->tilted.on)) {
        bool axis = c->here.has_axis || c->tilted.on;
        if (!all_known(&c->here) || !axis) { /* from the dark: only its end is known */
            piece.p[0] = piece.p[1];
            piece.q[0] = piece.q[1];
        }
        ncread_plane_turn(c, &piece);
        ncread_unit_piece(c, &piece);
        *array_push(&c->nc_motion->piece) = piece;
        c->nc_motion->lines += piece.shape == SHAPE_LINE && !rapid;
        c->nc_motion->arcs += piece.shape == SHAPE_ARC;
        c->nc_motion->curves += piece.shape == SHAPE_POLYNOMIAL;
    }
    c->here = *to;
    if (!tracked) /* words of another frame: nothing is known of the tip */
        memset(c->here.known, 0, sizeof c->here.known);
    return 0;
}

static const struct ncread_dialect *const dialects[] = {&ncread_fanuc, &ncread_siemens,
                                                        &ncread_heidenhain, &ncread_linuxcnc};

const struct ncread_dialect *ncread_named(const char *name)
{
    for (size_t i = 0; i < sizeof dialects / sizeof *dialects; i++)
        if (strcmp(dialects[i]->name, name) == 0)
            return dialects[i];
    return NULL;
}

const struct ncread_dialect *ncread_tell(const char *file, struct error *error)
{
    const struct ncread_dialect *found = NULL;
    struct reader r;
    char *line;
    size_t n;
    int more = 0;
    if (reader_open(&r, file, error) < 0)
        return NULL;
    for (int i = 0; i < 2 && !found && (more = reader_line(&r, &line, &n, error)) > 0; i++) {
        if (strncmp(line, "%_N_", 4) == 0)
            found = &ncread_siemens;
        else if (strncmp(line, "0 BEGIN PGM ", 12) == 0)
            found = &ncread_heidenhain;
        else if (i == 1 && *line == 'O')
            found = &ncread_fanuc;
        else if (i == 1)
            found = &ncread_linuxcnc;
        if (i == 0 && !found && strcmp(line, "%") != 0)
            break;
    }
    if (!found && more >= 0)
        error_at(error, r.name, 1,
                 "the first lines are those of no control that is known; say "
                 "which by -c");
    reader_close(&r);
    return found;
}

void ncread_place(const struct nc_piece *piece, char *text, size_t size)
{
    if (piece->block >= 0)
        snprintf(text, size, "N%d (line %zu)", piece->block, piece->line);
    else
        snprintf(text, size, "line %zu", piece->line);
}

static int read_lines(struct ncread *c, struct reader *r, struct error *error)
{
    char *line;
    size_t n;
    int more;
    while ((more = reader_line(r, &line, &n, error)) > 0) {
        c->line = r->line;
        c->text = line;
        c->block = -1;
        c->feed_here = false;
        if (strlen(line) != n)
            return ncread_error(c, error, "a byte that no program holds");
        if (c->setup->dialect->block(c, line, error) < 0)
            return -1;
    }
    return more;
}

int ncread_read(const char *file, const struct ncread_options *setup, struct nc_motion *nc_motion,
                struct error *error)
{
    struct ncread c = {.setup = setup, .nc_motion = nc_motion, .name = file, .last_block = -1};
    struct reader r;
    if (reader_open(&r, file, error) < 0)
        return -1;
    nc_motion->name = file;
    nc_motion->verify_kinematics = setup->verify_kinematics;
    c.here.axis = setup->verify_kinematics.tool;
    c.here.has_axis = setup->verify_kinematics.n == 0;
    int result = read_lines(&c, &r, error);
    c.block = -1;
    if (result == 0)
        result = setup->dialect->end(&c, error);
    reader_close(&r);
    array_free(&c.words);
    array_free(&c.knot);
    array_free(&c.weight);
    array_free(&c.pole_p);
    array_free(&c.pole_q);
    array_free(&c.pole_block);
    array_free(&c.pole_line);
    return result;
}
