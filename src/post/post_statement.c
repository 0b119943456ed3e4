/* post_statement - see post_statement.h. */
#include "post_statement.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"

/* ---- the tool in the spindle */

static bool holds_word(const char *text, const char *word)
{
    size_t n = strlen(word);
    for (; *text; text++) {
        size_t i = 0;
        while (i < n && toupper((unsigned char)text[i]) == word[i])
            i++;
        if (i == n)
            return true;
    }
    return false;
}

/* The text starts with the word, in capitals or not. */
static bool starts_with(const char *text, const char *word)
{
    size_t n = strlen(word);
    for (size_t i = 0; i < n; i++)
        if (toupper((unsigned char)text[i]) != word[i])
            return false;
    return !isalnum((unsigned char)text[n]);
}

static bool says_spindle(const char *text, struct nc_tooling *said)
{
    double rpm;
    if (holds_word(text, "OFF")) {
        said->spindle = 0;
        return true;
    }
    for (const char *s = text; *s; s++)
        if (isdigit((unsigned char)*s) && num_read(&s, &rpm)) {
            said->spindle = rpm;
            said->ccw = holds_word(text, "CCLW");
            return true;
        }
    return false;
}

static bool says_tooling(const char *text, struct nc_tooling *said)
{
    if (starts_with(text, "SPINDL"))
        return says_spindle(text, said);
    if (!starts_with(text, "COOLNT"))
        return false;
    char word[20] = "";
    const char *at = text + strcspn(text, "/");
    at += strspn(at, "/ \t");
    size_t n = strcspn(at, ", \t");
    for (size_t i = 0; i < n && i + 1 < sizeof word; i++)
        word[i] = (char)toupper((unsigned char)at[i]);
    enum path_coolant coolant = path_coolant_of(word);
    said->coolant = coolant == COOLANT_NOT_GIVEN ? COOLANT_ON : (int)coolant;
    return true;
}

static int offset_of(int number, int offset)
{
    return offset > 0 ? offset : number > 0 ? number : 1;
}

/* What is said from move i on, before the next motion or tool. */
static void read_ahead(struct nc_program *p, size_t i)
{
    const struct nc_plan *plan = p->plan;
    p->tooling.next = i;
    for (; i < plan->move.n && !nc_moves(&plan->move.item[i]); i++) {
        const struct nc_move *move = &plan->move.item[i];
        if (move->kind == NC_TOOL) {
            p->tooling.taken = move->index + 1;
            const struct path_tool *tool = &p->path->tool.item[move->index];
            p->tooling.number = tool->number;
            p->tooling.offset = offset_of(tool->number, tool->offset);
        } else if (move->kind == NC_PLANE) {
            p->at_plane = move->index;
        } else if (move->kind == NC_TEXT) {
            says_tooling(p->path->text.item[move->index], &p->tooling);
        }
    }
}

void nc_tool_first(struct nc_program *p)
{
    const struct path_head *head = &p->path->head;
    p->tooling = (struct nc_tooling){.number = head->tool,
                                     .offset = offset_of(head->tool, head->offset),
                                     .spindle = head->spindle,
                                     .ccw = head->spindle_ccw,
                                     .coolant = head->coolant};
    read_ahead(p, 0);
}

void nc_tool_change(struct nc_program *p, const struct nc_move *change)
{
    read_ahead(p, (size_t)(change - p->plan->move.item));
}

bool nc_tool_stays(const struct nc_program *p, const struct nc_move *from)
{
    const struct nc_move *end = p->plan->move.item + p->plan->move.n;
    while (from < end && !nc_moves(from) && from->kind != NC_TOOL)
        from++;
    return from == end || from->kind != NC_TOOL;
}

/* ---- radius compensation */

static bool may_compensate(const struct machine *machine, const struct nc_ability *ability)
{
    bool still = machine->chain.n == 0 || (!ability->tcp && ability->mode == INTERPOLATE_ROTARY);
    return machine->cutcom && still && ability->feeds == NC_FEEDS_TIP;
}

/* -1: it is no CUTCOM or says nothing of a side. */
static int cutcom_side(const char *text)
{
    if (!starts_with(text, "CUTCOM"))
        return -1;
    if (holds_word(text, "OFF"))
        return CUTCOM_OFF;
    return holds_word(text, "LEFT") ? CUTCOM_LEFT : holds_word(text, "RIGHT") ? CUTCOM_RIGHT : -1;
}

static bool says_cutcom(struct nc_program *p, const char *text)
{
    int asked = cutcom_side(text);
    if (asked >= 0 && may_compensate(p->machine, &p->plan->ability))
        p->cutcom.asked = asked;
    return asked >= 0;
}

const char *nc_cutcom_word(struct nc_program *p, const struct nc_move *move,
                           const char *const word[3])
{
    const struct nc_writer *w = &p->w;
    bool known = w->known[NC_X] && w->known[NC_Y];
    bool across = known && (w->value[NC_X] != move->p.x || w->value[NC_Y] != move->p.y);
    if (p->cutcom.asked == p->cutcom.on || !across)
        return NULL;
    if (p->cutcom.asked != CUTCOM_OFF && move->kind == NC_RAPID)
        return NULL;
    p->cutcom.on = p->cutcom.asked;
    return word[p->cutcom.on];
}

bool nc_cutcom_end(struct nc_program *p)
{
    bool on = p->cutcom.on != CUTCOM_OFF;
    p->cutcom.on = CUTCOM_OFF;
    return on;
}

bool nc_cutcom_asked(const struct path *path)
{
    for (size_t i = 0; i < path->text.n; i++)
        if (cutcom_side(path->text.item[i]) > CUTCOM_OFF)
            return true;
    return false;
}

bool nc_cutcom_left_out(const struct path *path, const struct machine *machine,
                        const struct nc_ability *ability)
{
    return nc_cutcom_asked(path) && !may_compensate(machine, ability);
}

/* ---- statements as blocks */

/* Blocks without fields, `|` between; `none`: none. */
static void write_blocks(struct nc_program *p, const char *text)
{
    char block[MACHINE_BLOCKS];
    while (strcmp(text, "none") != 0) {
        text += strspn(text, " ");
        size_t n = strcspn(text, "|");
        snprintf(block, sizeof block, "%.*s", (int)n, text);
        for (size_t k = strlen(block); k && block[k - 1] == ' '; k--)
            block[k - 1] = '\0';
        if (*block)
            nc_block(&p->w, block);
        if (!text[n])
            return;
        text += n + 1;
    }
}

/* The machine's blocks or, where it has none, the usual word. */
static void own_or_usual(struct nc_program *p, const char *own, const char *usual)
{
    write_blocks(p, *own ? own : usual);
}

static const char *spindle_word(const struct nc_program *p, bool ccw)
{
    const struct machine_templates *b = &p->machine->blocks;
    const char *own = ccw ? b->spindle_ccw : b->spindle_cw;
    return *own ? own : ccw ? "M4" : "M3";
}

static void spindle_block(struct nc_program *p, double rpm, bool ccw)
{
    nc_count(&p->w, "S", rpm);
    nc_code(&p->w, spindle_word(p, ccw));
    nc_end(&p->w);
}

void nc_spindle(struct nc_program *p)
{
    if (p->tooling.spindle > 0)
        spindle_block(p, p->tooling.spindle, p->tooling.ccw);
}

void nc_spindle_on(struct nc_program *p)
{
    nc_block(&p->w, spindle_word(p, p->tooling.ccw));
}

void nc_spindle_off(struct nc_program *p)
{
    own_or_usual(p, p->machine->blocks.spindle_off, "M5");
}

void nc_coolant_off(struct nc_program *p)
{
    own_or_usual(p, p->machine->blocks.coolant_off, "M9");
}

/* The machine's blocks for a kind of coolant, or the usual word; NULL: it has none. */
static const char *coolant_blocks(const struct machine *machine, int coolant)
{
    const struct machine_templates *b = &machine->blocks;
    const char *const own[] = {
        "", b->coolant_off, b->coolant_on, b->coolant_mist, b->coolant_thru, b->coolant_air};
    static const char *const usual[] = {NULL, "M9", "M8", "M7", NULL, NULL};
    return *own[coolant] ? own[coolant] : usual[coolant];
}

static void start_coolant(struct nc_program *p, int coolant)
{
    const char *blocks = coolant_blocks(p->machine, coolant);
    if (blocks)
        write_blocks(p, blocks);
    else if (coolant > COOLANT_OFF)
        nc_comment(&p->w, "*** COOLNT/%s: the machine file has no word for it ***",
                   coolant == COOLANT_AIR ? "AIR" : "THRU");
}

void nc_coolant(struct nc_program *p)
{
    if (p->tooling.coolant > COOLANT_OFF)
        start_coolant(p, p->tooling.coolant);
}

/* What the first cut is made with; false: nothing is cut. */
static bool first_cut(const struct nc_program *p, struct nc_tooling *now)
{
    const struct nc_move *move = p->plan->move.item, *end = move + p->plan->move.n;
    *now = p->tooling;
    for (; move < end && (!nc_moves(move) || move->kind == NC_RAPID); move++)
        if (move->kind == NC_TEXT)
            says_tooling(p->path->text.item[move->index], now);
    return move < end;
}

bool nc_cuts_dry(const struct nc_program *p)
{
    struct nc_tooling now;
    return first_cut(p, &now) &&
           (now.coolant <= COOLANT_OFF || !control_text_has(&p->machine->text, "{coolant}"));
}

bool nc_cuts_anticlockwise(const struct nc_program *p)
{
    struct nc_tooling now;
    return first_cut(p, &now) && now.spindle > 0 && now.ccw;
}

/* ---- what is missing */

void nc_warn_standing(struct nc_program *p, const struct nc_move *move)
{
    if (move->kind == NC_RAPID || !nc_moves(move) || p->tooling.spindle > 0 ||
        p->asked.no_spindle || p->warned)
        return;
    nc_comment(&p->w, "*** NO SPEED OF THE SPINDLE: IT MAY STAND STILL HERE ***");
    p->warned = true;
}

void nc_warn_no_tool(struct nc_program *p)
{
    if (p->tooling.number == 0 && !p->asked.no_spindle)
        nc_comment(&p->w, "*** NO TOOL IN THE PATH: THE ONE IN THE SPINDLE IS TAKEN ***");
}

/* A coolant that the machine has no word for. */
static bool lacks_coolant(const struct nc_program *p, const struct nc_tooling *now)
{
    return now->coolant > COOLANT_OFF && !coolant_blocks(p->machine, now->coolant);
}

/* Nothing is missing wherever the path moves: its tools and statements tell, which are few. */
static bool all_is_said(const struct nc_program *p)
{
    const struct path *path = p->path;
    struct nc_tooling now = {.spindle = path->head.spindle, .coolant = path->head.coolant};
    bool all = path->head.tool != 0 && now.spindle > 0 && !lacks_coolant(p, &now);
    for (size_t i = 0; i < path->tool.n && all; i++)
        all = path->tool.item[i].number != 0;
    for (size_t i = 0; i < path->text.n && all; i++)
        if (says_tooling(path->text.item[i], &now))
            all = now.spindle > 0 && !lacks_coolant(p, &now);
    return all;
}

struct nc_missing nc_missing(const struct nc_program *p)
{
    const struct path_head *head = &p->path->head;
    struct nc_tooling now = {
        .number = head->tool, .spindle = head->spindle, .coolant = head->coolant};
    struct nc_missing missing = {0};
    const struct nc_move *move = p->plan->move.item, *end = move + p->plan->move.n;
    if (all_is_said(p))
        return missing;
    while (move < end) { /* from what changes it on all moves have the same */
        bool moves = false, cuts = false;
        if (move->kind == NC_TOOL)
            now.number = p->path->tool.item[move->index].number;
        else if (move->kind == NC_TEXT)
            says_tooling(p->path->text.item[move->index], &now);
        missing.coolant = missing.coolant || lacks_coolant(p, &now);
        do {
            moves |= nc_moves(move);
            cuts |= nc_moves(move) && move->kind != NC_RAPID;
            move++;
        } while (move < end && move->kind != NC_TOOL && move->kind != NC_TEXT);
        missing.tool = missing.tool || (moves && now.number == 0);
        missing.spindle = missing.spindle || (cuts && !(now.spindle > 0));
    }
    missing.tool = missing.tool && !p->asked.no_spindle;
    missing.spindle = missing.spindle && !p->asked.no_spindle;
    return missing;
}

/* ---- statements as blocks */

/* The statement starts with this word; *rest follows it and a slash. */
static bool is_word(const char *text, const char *word, const char **rest)
{
    size_t n = strlen(word);
    for (size_t i = 0; i < n; i++)
        if (toupper((unsigned char)text[i]) != word[i])
            return false;
    if (isalnum((unsigned char)text[n]))
        return false;
    *rest = text + n + strspn(text + n, " \t/");
    return true;
}

/* What a statement changes of the spindle and the coolant. */
static void change_tooling(struct nc_program *p, const struct nc_tooling *said)
{
    const struct dialect *dialect = dialect_of(p->control);
    struct nc_tooling was = p->tooling;
    p->tooling = *said;
    if (said->coolant != was.coolant)
        start_coolant(p, said->coolant);
    if (said->spindle > 0 && (said->spindle != was.spindle || said->ccw != was.ccw))
        (dialect->speed ? dialect->speed : spindle_block)(p, said->spindle, said->ccw);
    else if (said->spindle <= 0 && was.spindle > 0)
        nc_spindle_off(p);
}

/* AUXFUN/n: the machine's blocks for it (aux.n), else the M word as it is. */
static void auxiliary_word(struct nc_program *p, double number)
{
    const struct machine *m = p->machine;
    for (size_t i = 0; i < MACHINE_AUX && *m->aux[i].blocks; i++)
        if (m->aux[i].number == (int)number) {
            write_blocks(p, m->aux[i].blocks);
            return;
        }
    nc_count(&p->w, "M", number);
    nc_end(&p->w);
}

void nc_stop_optional(struct nc_program *p)
{
    own_or_usual(p, p->machine->blocks.stop_optional, "M1");
}

/* A text as comments, as many as it needs. */
static void comment_lines(struct nc_program *p, const char *text)
{
    size_t room = 70;
    for (; strlen(text) > room; text += strspn(text, " ")) {
        size_t n = room;
        while (n > room / 2 && text[n] != ' ')
            n--;
        n = text[n] == ' ' ? n : room;
        nc_comment(&p->w, "%.*s", (int)n, text);
        text += n;
    }
    nc_comment(&p->w, "%s", text);
}

/* INSERT: a block as it stands, whose words the program does not follow. */
static void insert_block(struct nc_program *p, const char *text)
{
    struct nc_writer *w = &p->w;
    if (!*text)
        return;
    if (p->asked.insert == POST_INSERT_COMMENT) {
        comment_lines(p, text);
        return;
    }
    if (toupper((unsigned char)*text) == 'N' && isdigit((unsigned char)text[1]))
        nc_line(w, text);
    else
        nc_block(w, text);
    nc_forget(w, NC_X, NC_F);
    w->motion = NULL;
}

/* OPSKIP/ON, OFF: the blocks between are marked, to be skipped by a switch of the control. */
static void skip_blocks(struct nc_program *p, const char *rest)
{
    p->w.skip = p->machine->block_skip && !starts_with(rest, "OFF");
}

double nc_statement(struct nc_program *p, const char *text)
{
    struct nc_tooling said = p->tooling;
    const char *rest;
    double seconds, number;
    if (says_cutcom(p, text))
        return 0;
    if (says_tooling(text, &said))
        change_tooling(p, &said);
    else if (is_word(text, "STOP", &rest))
        own_or_usual(p, p->machine->blocks.stop, "M0");
    else if (is_word(text, "OPSTOP", &rest))
        nc_stop_optional(p);
    else if (is_word(text, "INSERT", &rest))
        insert_block(p, rest);
    else if (is_word(text, "OPSKIP", &rest))
        skip_blocks(p, rest);
    else if (is_word(text, "AUXFUN", &rest) && num_read(&rest, &number) && number >= 0 &&
             number <= 9999 && number == floor(number))
        auxiliary_word(p, number);
    else if (is_word(text, "DELAY", &rest) && num_read(&rest, &seconds) && seconds > 0)
        return seconds;
    else if (is_word(text, "PPRINT", &rest) || is_word(text, "TPRINT", &rest) ||
             is_word(text, "REMARK", &rest))
        comment_lines(p, rest);
    return 0;
}
