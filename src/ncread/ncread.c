/* ncread - see ncread.h. */
#include "ncread/ncread.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/reader.h"
#include "ncread_head.h"
#include "ncread_rounding.h"
#include "ncread_state.h"

static void add_axis(struct verify_kinematics *kinematics, const struct machine *machine,
                     char letter, bool table)
{
    int k = letter - 'A';
    kinematics->axis[kinematics->n++] =
        (struct verify_kinematics_axis){.letter = letter,
                                        .table = table,
                                        .axis = vec_unit(machine->axis[k]),
                                        .centre = machine->centre[k],
                                        .min = machine->min[MACHINE_A + k],
                                        .max = machine->max[MACHINE_A + k]};
}

void ncread_wraps(const struct machine *machine, const struct verify_kinematics *kinematics,
                  bool wraps[2])
{
    enum { ENDLESS = 3600 /* degrees of travel */ };
    int words = machine->rotary_words;
    for (int i = 0; i < kinematics->n && i < 2; i++) {
        int axis = MACHINE_A + (kinematics->axis[i].letter - 'A');
        wraps[i] = words != ROTARY_OWN && words != ROTARY_PLAIN && words != ROTARY_DC &&
                   machine->max[axis] - machine->min[axis] > ENDLESS;
    }
}

struct verify_kinematics ncread_kinematics(const struct machine *machine)
{
    struct verify_kinematics kinematics = {.tool = vec(0, 0, 1)};
    char letter[VERIFY_KINEMATICS_AXES] = {0};
    int n = 0;
    for (const char *s = machine->axes; *s && n < VERIFY_KINEMATICS_AXES; s++)
        if (*s >= 'A' && *s <= 'C')
            letter[n++] = *s;
    switch (machine->type) {
    case TABLE_TABLE: /* the outer one, named first, is further from the work */
        add_axis(&kinematics, machine, letter[1], true);
        add_axis(&kinematics, machine, letter[0], true);
        break;
    case HEAD_TABLE: /* the head's is named first */
        add_axis(&kinematics, machine, letter[1], true);
        add_axis(&kinematics, machine, letter[0], false);
        break;
    case HEAD_HEAD: /* the outer one, named first, is further from the tool */
        add_axis(&kinematics, machine, letter[0], false);
        add_axis(&kinematics, machine, letter[1], false);
        break;
    case ONE_TABLE:
    case ONE_HEAD:
        add_axis(&kinematics, machine, letter[0], machine->type == ONE_TABLE);
        break;
    default:
        break;
    }
    return kinematics;
}

/* Little more than half of the last digit that a program for the machine is printed with. */
static double printed_slack(const struct machine *machine)
{
    int usual = 3, digits = usual;
    if (machine->digits.angle >= 0 && machine->digits.angle < digits)
        digits = machine->digits.angle;
    if (machine->digits.linear >= 0 && machine->digits.linear < digits)
        digits = machine->digits.linear;
    return 0.51 * pow(10, -digits);
}

double ncread_digit(const struct machine *machine)
{
    return machine->digits.linear >= 0 ? pow(10, -machine->digits.linear) : 0;
}

struct axis_limits ncread_limits(const struct machine *machine, bool tcp)
{
    struct axis_limits limits = {
        .slack = printed_slack(machine), .strict = !machine->slows, .combined = !tcp};
    for (int k = 0; k < NC_AXES; k++) {
        limits.min[k] = machine->min[k];
        limits.max[k] = machine->max[k];
        limits.rapid[k] = machine->rapid[k];
    }
    return limits;
}

struct machine_time_options ncread_time_options(const struct machine *machine)
{
    struct machine_time_options options = {.smoothing = machine->smoothing};
    for (int k = 0; k < NC_AXES; k++) {
        options.acceleration[k] = machine->acceleration[k];
        options.jerk[k] = machine->jerk[k];
    }
    return options;
}

#define ROW(name, title, tcp_of_machine, dc) &ncread_##name,
static const struct ncread_dialect *const dialects[] = {CONTROL_TABLE(ROW)};
#undef ROW

const struct ncread_dialect *ncread_of(enum control_id control)
{
    return dialects[control];
}

enum { HEAD = 80 }; /* of the first line */

static enum control_id control_of(const char *first, const char *second)
{
    for (int i = 0; i < CONTROLS; i++)
        if (dialects[i]->begins(first, second))
            return (enum control_id)i;
    return CONTROLS;
}

enum control_id ncread_tell(const char *file, struct error *error)
{
    enum control_id found = CONTROLS;
    struct reader r;
    char *line, first[HEAD] = "";
    size_t n;
    if (reader_open(&r, file, error) < 0)
        return CONTROLS;
    int more = reader_line(&r, &line, &n, error);
    if (more > 0) {
        snprintf(first, sizeof first, "%s", line);
        found = control_of(first, NULL);
    }
    if (more > 0 && found == CONTROLS && (more = reader_line(&r, &line, &n, error)) > 0)
        found = control_of(first, line);
    if (found == CONTROLS && more >= 0)
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
        c->feed_here = c->setting = c->selecting = false;
        if (strlen(line) != n)
            return ncread_error(c, error, "a byte that no program holds");
        if (c->ended && line[strspn(line, " \t")] == '\0')
            continue; /* editors leave such lines behind the end */
        if (c->options->head && c->motion->piece.n == 0)
            ncread_head_line(c->options->head, line);
        if (c->options->dialect->block(c, line, error) < 0 || ncread_length_watch(c, error) < 0)
            return -1;
        ncread_rounding_watch(c);
    }
    return more;
}

int ncread_read(const char *file, const struct ncread_options *options, struct nc_motion *motion,
                struct error *error)
{
    struct ncread c = {.options = options, .motion = motion, .name = file, .last_block = -1};
    struct reader r;
    if (reader_open(&r, file, error) < 0)
        return -1;
    if (options->words && ncread_meaning_check(options->words, error) < 0) {
        reader_close(&r);
        return -1;
    }
    motion->name = file;
    motion->kinematics = options->kinematics;
    c.here.axis = options->kinematics.tool;
    c.here.has_axis = options->kinematics.n == 0;
    c.length = ncread_meaning_of(&c, "G43") == MEANS_NEVER;
    int result = read_lines(&c, &r, error);
    motion->asked = options->head ? options->head->asked : 0;
    c.block = -1;
    if (result == 0)
        result = options->dialect->end(&c, error);
    reader_close(&r);
    ncread_meaning_tell(&c);
    array_free(&c.words);
    array_free(&c.knot);
    array_free(&c.weight);
    array_free(&c.pole_p);
    array_free(&c.pole_q);
    array_free(&c.pole_block);
    array_free(&c.pole_line);
    return result;
}
