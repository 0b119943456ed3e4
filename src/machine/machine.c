/* machine - see machine.h. */
#include "machine/machine.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "base/library_file.h"
#include "base/reader.h"
#include "machine/keys.h"
#include "machine_tables.h"
#include "machine/template.h"

static const char letters[] = "XYZABC";

char machine_letter(int axis)
{
    return letters[axis];
}

bool machine_has_head(const struct machine *machine)
{
    for (int i = 0; i < machine->chain.n; i++)
        if (!machine->chain.rotary[i].table)
            return true;
    return false;
}

bool machine_has_tcp(const struct machine *machine, enum control_id control)
{
    bool its_own = control_find(machine->control) == control ||
                   (*machine->control && strcmp(machine->control, machine->used) == 0);
    return machine->tcp && machine->text.tcp && (!control_row(control)->tcp_of_machine || its_own);
}

struct machine machine_default(void)
{
    struct machine m = {
        .name = "Table-table A/C",
        .file = "table-ac",
        .type = TABLE_TABLE,
        .axes = "A C",
        .axis = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
        .tcp = true,
        .arcs = true,
        .arcs_tcp = true,
        .splines = true,
        .vectors = true,
        .cycles = true,
        .min = {-2000, -2000, -2000, -120, -120, -99999},
        .max = {2000, 2000, 2000, 120, 120, 99999},
        .block_skip = true,
        .rapid = {30000, 30000, 30000, 7200, 7200, 7200},
        .acceleration = {3000, 3000, 3000, 1000, 1000, 1000},
        .jerk = {50000, 50000, 50000, 20000, 20000, 20000},
        .smoothing = 0.2,
        .slows = true,
        .retract = 50,
        .feed_max = 99999,
        .number_step = 10,
        .number_max = 99999999,
        .digits = {-1, -1, -1, -1, -1},
        .text = {.dialect = CONTROLS,
                 .comment = "({text})",
                 .tcp = true,
                 .comment_width = 80,
                 .number = "N{n}"},
    };
    return m;
}

static void add_bounded(struct keys *keys, const char *name, enum key_kind kind, void *value,
                        double min, double max)
{
    struct key *key = keys_add(keys, name, kind, value);
    key->min = min;
    key->max = max;
}

static void add_text(struct keys *keys, const char *name, char *value, size_t size)
{
    keys_add(keys, name, KEY_TEXT, value)->size = size;
}

/* The keys of an axis that slides or turns: x.min x.max x.acceleration x.jerk */
static void add_axis(struct keys *keys, struct machine *m, int axis)
{
    char name[20], small = (char)(letters[axis] - 'A' + 'a');
    snprintf(name, sizeof name, "%c.min", small);
    add_bounded(keys, name, KEY_NUMBER, &m->min[axis], 0, 0);
    snprintf(name, sizeof name, "%c.max", small);
    add_bounded(keys, name, KEY_NUMBER, &m->max[axis], 0, 0);
    snprintf(name, sizeof name, "%c.acceleration", small);
    add_bounded(keys, name, KEY_NUMBER, &m->acceleration[axis], 1e-3, 1e9);
    snprintf(name, sizeof name, "%c.jerk", small);
    add_bounded(keys, name, KEY_NUMBER, &m->jerk[axis], 1e-3, 1e12);
}

/* Those that a rotary axis, A B or C, has besides: a.rapid axis.A centre.A */
static void add_rotary(struct keys *keys, struct machine *m, int i)
{
    char name[20], large = (char)('A' + i), small = (char)('a' + i);
    snprintf(name, sizeof name, "%c.rapid", small);
    add_bounded(keys, name, KEY_NUMBER, &m->rapid[MACHINE_A + i], 1, 1e7);
    snprintf(name, sizeof name, "axis.%c", large);
    keys_add(keys, name, KEY_VECTOR, &m->axis[i]);
    snprintf(name, sizeof name, "centre.%c", large);
    keys_add(keys, name, KEY_VECTOR, &m->centre[i]);
}

/* How the control's programs look. */
static void add_control(struct keys *keys, struct control_text *text)
{
    add_text(keys, "title", text->title, sizeof text->title);
    keys_add(keys, "dialect", KEY_CHOICE, &text->dialect)->words = control_names();
    add_text(keys, "comment", text->comment, sizeof text->comment);
    keys_add(keys, "comment.capitals", KEY_YES, &text->comment_capitals);
    add_bounded(keys, "comment.width", KEY_COUNT, &text->comment_width, 40, 132);
    add_text(keys, "number", text->number, sizeof text->number);
    add_text(keys, "words", text->words, sizeof text->words);
    keys_add(keys, "control.tcp", KEY_YES, &text->tcp);
    keys_add(keys, "number.all", KEY_YES, &text->number_all);
    keys_add(keys, "point", KEY_YES, &text->point);
    keys_add(keys, "sign", KEY_YES, &text->sign);
}

/* ---- the keys */

static struct keys machine_keys(struct machine *m)
{
    struct keys keys = {0};
    add_text(&keys, "name", m->name, sizeof m->name);
    add_text(&keys, "control", m->control, sizeof m->control);
    add_control(&keys, &m->text);
    keys_add(&keys, "type", KEY_CHOICE, &m->type)->words =
        "table-table|head-table|head-head|table|head|none";
    add_text(&keys, "axes", m->axes, sizeof m->axes);
    for (int axis = 0; axis < MACHINE_AXES; axis++)
        add_axis(&keys, m, axis);
    for (int i = 0; i < MACHINE_AXES - MACHINE_A; i++)
        add_rotary(&keys, m, i);
    keys_add(&keys, "tcp", KEY_YES, &m->tcp);
    keys_add(&keys, "arcs", KEY_YES, &m->arcs);
    keys_add(&keys, "arcs.tcp", KEY_YES, &m->arcs_tcp);
    keys_add(&keys, "arcs.space", KEY_YES, &m->arcs_space);
    keys_add(&keys, "splines", KEY_YES, &m->splines);
    keys_add(&keys, "vectors", KEY_YES, &m->vectors);
    keys_add(&keys, "cycles", KEY_YES, &m->cycles);
    keys_add(&keys, "cutcom", KEY_YES, &m->cutcom);
    add_bounded(&keys, "rapid", KEY_NUMBER, &m->rapid[MACHINE_X], 1, 1e7);
    add_bounded(&keys, "smoothing", KEY_NUMBER, &m->smoothing, 0, 100);
    keys_add(&keys, "slows", KEY_YES, &m->slows);
    add_bounded(&keys, "retract", KEY_NUMBER, &m->retract, 0.1, 1e5);
    keys_add(&keys, "tcp.frame", KEY_CHOICE, &m->tcp_frame)->words = "zero|stands";
    keys_add(&keys, "length.off", KEY_CHOICE, &m->length_off)->words = "home|alone|z";
    add_bounded(&keys, "length.off.z", KEY_NUMBER, &m->length_z, -1e5, 1e5);
    keys_add(&keys, "rotary.words", KEY_CHOICE, &m->rotary_words)->words =
        "own|plain|0-360|dc|signed|shortest";
    add_text(&keys, "safe", m->blocks.safe, sizeof m->blocks.safe);
    add_text(&keys, "offset", m->offset, sizeof m->offset);
    add_text(&keys, "home", m->blocks.home, sizeof m->blocks.home);
    add_text(&keys, "start", m->blocks.start, sizeof m->blocks.start);
    add_text(&keys, "end", m->blocks.end, sizeof m->blocks.end);
    add_text(&keys, "tool.change", m->blocks.tool_change, sizeof m->blocks.tool_change);
    add_text(&keys, "dwell", m->blocks.dwell, sizeof m->blocks.dwell);
    add_text(&keys, "tap", m->blocks.tap, sizeof m->blocks.tap);
    add_text(&keys, "tcp.on", m->blocks.tcp_on, sizeof m->blocks.tcp_on);
    add_text(&keys, "tcp.off", m->blocks.tcp_off, sizeof m->blocks.tcp_off);
    add_text(&keys, "clamp.on", m->blocks.clamp_on, sizeof m->blocks.clamp_on);
    add_text(&keys, "clamp.off", m->blocks.clamp_off, sizeof m->blocks.clamp_off);
    add_text(&keys, "coolant.on", m->blocks.coolant_on, sizeof m->blocks.coolant_on);
    add_text(&keys, "coolant.mist", m->blocks.coolant_mist, sizeof m->blocks.coolant_mist);
    add_text(&keys, "coolant.thru", m->blocks.coolant_thru, sizeof m->blocks.coolant_thru);
    add_text(&keys, "coolant.air", m->blocks.coolant_air, sizeof m->blocks.coolant_air);
    add_text(&keys, "coolant.off", m->blocks.coolant_off, sizeof m->blocks.coolant_off);
    add_text(&keys, "spindle.cw", m->blocks.spindle_cw, sizeof m->blocks.spindle_cw);
    add_text(&keys, "spindle.ccw", m->blocks.spindle_ccw, sizeof m->blocks.spindle_ccw);
    add_text(&keys, "spindle.off", m->blocks.spindle_off, sizeof m->blocks.spindle_off);
    add_text(&keys, "stop", m->blocks.stop, sizeof m->blocks.stop);
    add_text(&keys, "stop.optional", m->blocks.stop_optional, sizeof m->blocks.stop_optional);
    keys_add(&keys, "tool.names", KEY_YES, &m->tool_names);
    keys_add(&keys, "tool.next", KEY_YES, &m->tool_next);
    keys_add(&keys, "tool.stop", KEY_YES, &m->tool_stop);
    keys_add(&keys, "block.skip", KEY_YES, &m->block_skip);
    keys_add(&keys, "smooth", KEY_YES, &m->smooth);
    add_text(&keys, "smooth.on", m->blocks.smooth_on, sizeof m->blocks.smooth_on);
    add_text(&keys, "smooth.off", m->blocks.smooth_off, sizeof m->blocks.smooth_off);
    keys_add(&keys, "plane", KEY_YES, &m->plane);
    add_text(&keys, "plane.on", m->blocks.plane_on, sizeof m->blocks.plane_on);
    add_text(&keys, "plane.off", m->blocks.plane_off, sizeof m->blocks.plane_off);
    keys_add(&keys, "feeds", KEY_CHOICE, &m->feeds)->words = "inverse|combined";
    add_bounded(&keys, "feed.max", KEY_NUMBER, &m->feed_max, 1, 1e8);
    add_bounded(&keys, "number.step", KEY_COUNT, &m->number_step, 0, 1000);
    add_bounded(&keys, "number.max", KEY_COUNT, &m->number_max, 999, 999999999);
    add_bounded(&keys, "digits.linear", KEY_COUNT, &m->digits.linear, 1, 9);
    add_bounded(&keys, "digits.angle", KEY_COUNT, &m->digits.angle, 1, 9);
    add_bounded(&keys, "digits.vector", KEY_COUNT, &m->digits.vector, 3, 9);
    add_bounded(&keys, "digits.knot", KEY_COUNT, &m->digits.knot, 0, 9);
    add_bounded(&keys, "digits.feed", KEY_COUNT, &m->digits.feed, 0, 9);
    return keys;
}

/* For those who read the program: which keys were set. */
static void note_set(struct machine *machine, const char *setting)
{
    size_t n = strlen(machine->set), room = sizeof machine->set - n;
    if (strlen(setting) + 2 <= room)
        snprintf(machine->set + n, room, "%s%s", n ? " " : "", setting);
}

int machine_set(struct machine *machine, const char *setting, struct error *error)
{
    if (keys_hash_meant(setting))
        return error_at(error, "--set", 0, KEYS_HASH_MEANT);
    struct keys keys = machine_keys(machine);
    char *text = mem_string(setting, strlen(setting));
    int result = machine_tables_set(machine, text, "--set", 0, error);
    result = result == 1 ? keys_set(&keys, text, "--set", 0, error) : result;
    free(text);
    array_free(&keys);
    if (result == 0)
        note_set(machine, setting);
    return result;
}

/* The letters of the rotary axes, blanks between or not: their number, -1 when they are wrong. */
static int read_letters(const char *axes, int letter[ROTARY_MAX])
{
    int n = 0;
    for (; *axes; axes++) {
        if (*axes == ' ' || *axes == '\t')
            continue;
        const char *found = strchr("ABC", *axes);
        if (!found || n == ROTARY_MAX)
            return -1;
        letter[n++] = MACHINE_A + (int)(found - "ABC");
    }
    return n == 2 && letter[0] == letter[1] ? -1 : n;
}

/* Those that hold templates; -1: `key` is the one to blame. */
/* Where no field may stand. */
enum { WORDS_ALONE = TEMPLATE_IN_COMMENT + 1 };

static int check_templates(const struct machine *m, char key[KEY_NAME], struct error *error)
{
    const struct machine_templates *b = &m->blocks;
    const struct {
        const char *key, *text;
        int place; /* enum template_place, WORDS_ALONE */
    } all[] = {{"comment", m->text.comment, TEMPLATE_IN_COMMENT},
               {"number", m->text.number, TEMPLATE_IN_NUMBER},
               {"home", b->home, TEMPLATE_IN_KEY},
               {"safe", b->safe, TEMPLATE_IN_KEY},
               {"start", b->start, TEMPLATE_IN_KEY},
               {"clamp.on", b->clamp_on, TEMPLATE_IN_KEY},
               {"clamp.off", b->clamp_off, TEMPLATE_IN_KEY},
               {"coolant.on", b->coolant_on, WORDS_ALONE},
               {"coolant.mist", b->coolant_mist, WORDS_ALONE},
               {"coolant.thru", b->coolant_thru, WORDS_ALONE},
               {"coolant.air", b->coolant_air, WORDS_ALONE},
               {"coolant.off", b->coolant_off, WORDS_ALONE},
               {"spindle.cw", b->spindle_cw, WORDS_ALONE},
               {"spindle.ccw", b->spindle_ccw, WORDS_ALONE},
               {"spindle.off", b->spindle_off, WORDS_ALONE},
               {"stop", b->stop, WORDS_ALONE},
               {"stop.optional", b->stop_optional, WORDS_ALONE},
               {"end", b->end, TEMPLATE_IN_KEY},
               {"tool.change", b->tool_change, TEMPLATE_IN_KEY},
               {"dwell", b->dwell, TEMPLATE_IN_KEY},
               {"tap", b->tap, TEMPLATE_IN_KEY},
               {"tcp.on", b->tcp_on, TEMPLATE_IN_KEY},
               {"tcp.off", b->tcp_off, TEMPLATE_IN_KEY},
               {"smooth.on", b->smooth_on, TEMPLATE_IN_KEY},
               {"smooth.off", b->smooth_off, TEMPLATE_IN_KEY},
               {"plane.on", b->plane_on, TEMPLATE_IN_KEY},
               {"plane.off", b->plane_off, TEMPLATE_IN_KEY}};
    struct error found;
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        snprintf(key, KEY_NAME, "%s", all[i].key);
        if (all[i].place == WORDS_ALONE && strchr(all[i].text, '{'))
            return error_set(error, "%s: found `%.40s`, expected words without fields", key,
                             all[i].text);
        if (all[i].place != WORDS_ALONE &&
            template_check(all[i].text, (enum template_place)all[i].place, &found) != 0)
            return error_set(error, "%s: %s", key, found.text);
    }
    return 0;
}

static int check_travel(const struct machine *m, char key[KEY_NAME], struct error *error)
{
    for (int axis = 0; axis < MACHINE_AXES; axis++) {
        char small = (char)(letters[axis] - 'A' + 'a');
        snprintf(key, KEY_NAME, "%c.max", small);
        if (m->min[axis] > m->max[axis])
            return error_set(error, "found %c.min %g above %c.max %g, expected min <= max", small,
                             m->min[axis], small, m->max[axis]);
    }
    return 0;
}

/* The chain, work to tool: a table's outer axis and a head's inner one are nearest the tool. */
static int make_chain(struct machine *m, const int letter[], int n, char key[KEY_NAME],
                      struct error *error)
{
    bool turned = m->type == TABLE_TABLE || m->type == HEAD_TABLE;
    m->chain =
        (struct kinematic_chain){.n = n, .master = turned && n == 2 ? 1 : 0, .tool = {0, 0, 1}};
    for (int i = 0; i < n; i++) {
        int k = letter[turned ? n - 1 - i : i], of = k - MACHINE_A;
        bool table =
            m->type == TABLE_TABLE || m->type == ONE_TABLE || (m->type == HEAD_TABLE && i == 0);
        m->letter[i] = k;
        m->chain.rotary[i] = (struct rotary){.axis = vec_unit(m->axis[of]),
                                             .centre = m->centre[of],
                                             .table = table,
                                             .min = RADIANS(m->min[k]),
                                             .max = RADIANS(m->max[k]),
                                             .rapid = RADIANS(m->rapid[k])};
        snprintf(key, KEY_NAME, "axis.%c", letters[k]);
        if (!(vec_length(m->axis[of]) >= 1e-9 && vec_length(m->axis[of]) < 1e9))
            return error_set(error, "%s: found a direction %g long, expected 1e-9 to 1e9", key,
                             vec_length(m->axis[of]));
    }
    if (n == 2 && vec_length(vec_cross(m->chain.rotary[0].axis, m->chain.rotary[1].axis)) < 1e-6)
        return error_set(error, "axes: found two parallel rotary axes, expected two directions");
    return 0;
}

/* ---- files */

enum { INCLUDES_MAX = 8, FILE_MAX = LIBRARY_FILE };

static bool is_folder(const char *file)
{
    struct stat status;
    return stat(file, &status) == 0 && S_ISDIR(status.st_mode);
}

static const struct library machines = {"machine", "machines", "CLOUDMILL_MACHINES"};
static const struct library controls = {"control", "controls", "CLOUDMILL_CONTROLS"};

bool machine_control_exists(const char *name, struct error *error)
{
    char file[FILE_MAX];
    struct error inner = {0};
    if (control_find(name) != CONTROLS ||
        library_file_find(&controls, name, NULL, file, &inner) == 0)
        return true;
    return error_set(error, "control: found `%.60s`, expected %s or a control file (%.200s)", name,
                     control_names(), inner.text) == 0;
}

/* What the keys say together, and the chain; -1: `key` is the one to blame. */
static int assemble(struct machine *m, char key[KEY_NAME], struct error *error)
{
    static const int axes_of_type[] = {2, 2, 2, 1, 1, 0};
    int letter[ROTARY_MAX] = {0, 0}, n = axes_of_type[m->type];
    snprintf(key, KEY_NAME, "control");
    if (*m->control && !machine_control_exists(m->control, error))
        return -1;
    if (check_templates(m, key, error) != 0 || check_travel(m, key, error) != 0)
        return -1;
    snprintf(key, KEY_NAME, "rotary.words");
    if (m->rotary_words == ROTARY_DC && m->text.dialect != CONTROLS &&
        !control_row((enum control_id)m->text.dialect)->dc)
        return error_set(error, "rotary.words: found dc, which %s does not know, expected another",
                         m->text.title);
    snprintf(key, KEY_NAME, "axes");
    if (n && read_letters(m->axes, letter) != n)
        return error_set(error, "axes: found `%s`, expected %s of A B C", m->axes,
                         n == 2 ? "two" : "one");
    m->rapid[MACHINE_Y] = m->rapid[MACHINE_Z] = m->rapid[MACHINE_X];
    return make_chain(m, letter, n, key, error);
}

int machine_finish(struct machine *m, struct error *error)
{
    char key[KEY_NAME];
    struct error found;
    if (assemble(m, key, &found) == 0)
        return 0;
    return error_set(error, "machine %.100s: %s", m->name, found.text);
}

/* ---- reading */

/* A file while it is read. */
struct machine_file {
    struct machine *machine;
    struct keys keys;
    const char *name; /* for messages */
    size_t line;
    size_t said;                  /* lines that say something */
    int depth;                    /* of files within files */
    enum control_section section; /* whose lines these are, CONTROL_SECTIONS: keys */
    bool begun[CONTROL_SECTIONS]; /* in this file */
};

static int read_file(struct machine *m, const char *file, int depth, struct error *error);
static int read_built_in(struct machine *m, const char *name, struct error *error);

/* The value where the line is `WORD = value`, NULL: it is another. */
static char *value_of(char *line, const char *word)
{
    size_t n = strlen(word);
    if (strcspn(line, " \t=") != n || strncmp(line, word, n) != 0)
        return NULL;
    char *value = keys_trim(line + n);
    return *value == '=' ? keys_trim(value + 1) : NULL;
}

/* `include = NAME` or `base = NAME` in the line: 1 and it was read, 0: another line, -1: error. */
static int read_include(struct machine_file *f, char *line, struct error *error)
{
    char file[FILE_MAX], *name = value_of(line, "include");
    const char *word = name ? "include" : "base";
    if (!name)
        name = value_of(line, "base");
    if (!name)
        return 0;
    if (!*name)
        return error_at(error, f->name, f->line, "found no name, expected %s = NAME", word);
    if (f->depth + 1 >= INCLUDES_MAX)
        return error_at(error, f->name, f->line,
                        "found %s within %s %d deep, expected no file to include itself", word,
                        word, INCLUDES_MAX);
    struct error inner;
    if (*word == 'b' && control_text_built_in(name))
        return read_built_in(f->machine, name, error) == 0 ? 1 : -1;
    if (library_file_find(*word == 'b' ? &controls : &machines, name, f->name, file, &inner) != 0)
        return error_at(error, f->name, f->line, "%s: %.300s", word, inner.text);
    if (access(file, R_OK) != 0)
        return error_at(error, f->name, f->line, "%s: cannot open %.200s", word, name);
    if (is_folder(file))
        return error_at(error, f->name, f->line, "%s: found the folder %.200s, expected a file",
                        word, name);
    if (read_file(f->machine, file, f->depth + 1, &inner) != 0)
        return *error = inner, -1;
    return 1;
}

/* A line `[name]`: those of a base are replaced. */
static int begin_section(struct machine_file *f, const char *line, struct error *error)
{
    f->section = control_section_find(line);
    if (f->section == CONTROL_SECTIONS)
        return error_at(error, f->name, f->line,
                        "found `%.40s`, expected [start], [tool], [approach], [retract], [change] "
                        "or [end]",
                        line);
    if (f->begun[f->section])
        return error_at(error, f->name, f->line, "found %s again, expected it once", line);
    f->begun[f->section] = true;
    *f->machine->text.section[f->section] = '\0';
    return 0;
}

static int read_line(struct machine_file *f, char *line, size_t n, struct error *error)
{
    struct error wrong;
    for (size_t i = 0; i < n; i++)
        if (((unsigned char)line[i] < ' ' && !strchr("\t\r\f", line[i])) || !line[i])
            return error_at(error, f->name, f->line,
                            "found a binary character (code %d), expected key = value",
                            (unsigned char)line[i]);
    bool section = f->section != CONTROL_SECTIONS;
    if (keys_hash_meant(line) && (section || line[strspn(line, " \t")] != '#'))
        return error_at(error, f->name, f->line, KEYS_HASH_MEANT);
    char *text = keys_trim(line);
    if (!*text)
        return 0;
    f->said++;
    if (*text == '[')
        return begin_section(f, text, error);
    if (section) {
        if (control_section_add(&f->machine->text, f->section, text, &wrong) == 0)
            return 0;
        return error_at(error, f->name, f->line, "%s", wrong.text);
    }
    int included = read_include(f, text, error);
    if (included)
        return included < 0 ? -1 : 0;
    int numbered = machine_tables_set(f->machine, text, f->name, f->line, error);
    if (numbered != 1)
        return numbered;
    return keys_set(&f->keys, text, f->name, f->line, error);
}

/* A control that is built in, from its text. */
static int read_built_in(struct machine *m, const char *name, struct error *error)
{
    struct machine_file f = {.machine = m, .name = name, .section = CONTROL_SECTIONS};
    int result = 0;
    f.keys = machine_keys(m);
    for (const char *s = control_text_built_in(name); *s && result == 0; s++) {
        size_t n = strcspn(s, "\n");
        char *line = mem_string(s, n);
        f.line++;
        result = read_line(&f, line, n, error);
        free(line);
        s += n;
    }
    array_free(&f.keys);
    return result;
}

/* What the keys say together; the place is that of the key to blame or, where it stands in another
 * file, of the last key that has to do with the axes. */
static int check_together(const struct machine *m, const struct keys *keys, const char *name,
                          struct error *error)
{
    static const char *const others[] = {"type", "axes", "axis.A", "axis.B", "axis.C"};
    struct machine trial = *m;
    struct error found;
    char blamed[KEY_NAME];
    if (assemble(&trial, blamed, &found) == 0)
        return 0;
    size_t line = keys_find(keys, blamed)->line, n = strlen(blamed);
    if (n == 5 && strcmp(blamed + 1, ".max") == 0) { /* or that axis's min, the later of both */
        memcpy(blamed + 2, "min", 4);
        size_t min = keys_find(keys, blamed)->line;
        line = min > line ? min : line;
    } else if (strncmp(blamed, "ax", 2) == 0) {
        for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
            size_t other = keys_find(keys, others[i])->line;
            line = line == 0 || (strcmp(blamed, "axes") == 0 && other > line) ? other : line;
        }
    }
    return error_at(error, name, line, "%s", found.text);
}

static int read_file(struct machine *m, const char *file, int depth, struct error *error)
{
    struct reader r;
    struct machine_file f = {
        .machine = m, .name = file, .depth = depth, .section = CONTROL_SECTIONS};
    if (reader_open(&r, file, error) != 0)
        return -1;
    f.keys = machine_keys(m);
    char *line;
    size_t n;
    int got, result = 0;
    while (result == 0 && (got = reader_line(&r, &line, &n, error)) != 0) {
        f.line = r.line;
        result = got < 0 ? -1 : read_line(&f, line, n, error);
    }
    if (result == 0 && f.said == 0)
        result = error_at(error, f.name, 0, "found no key, expected lines key = value");
    if (result == 0 && depth == 0)
        result = check_together(m, &f.keys, f.name, error);
    array_free(&f.keys);
    reader_close(&r);
    return result;
}

int machine_control(struct machine *machine, const char *name, struct error *error)
{
    char file[FILE_MAX];
    struct control_text *text = &machine->text;
    snprintf(machine->used, sizeof machine->used, "%s", name);
    if (control_text_built_in(name))
        return read_built_in(machine, name, error);
    if (library_file_find(&controls, name, NULL, file, error) != 0 ||
        read_file(machine, file, 0, error) != 0)
        return -1;
    if (text->dialect == CONTROLS)
        return error_at(error, file, 0, "found no base, expected base = %s or another control",
                        control_names());
    return 0;
}

bool machine_exists(const char *name)
{
    char file[FILE_MAX];
    struct error error;
    return library_file_find(&machines, name, NULL, file, &error) == 0 && access(file, R_OK) == 0;
}

int machine_read(struct machine *machine, const char *name, struct error *error)
{
    char file[FILE_MAX];
    int n = snprintf(machine->file, sizeof machine->file, "%s", name);
    if (n >= (int)sizeof machine->file)
        machine->file[0] = '\0';
    if (library_file_find(&machines, name, NULL, file, error) != 0)
        return -1;
    return read_file(machine, file, 0, error);
}
