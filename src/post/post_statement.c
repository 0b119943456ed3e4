/* post_statement - see post_statement.h. */
#include "post_statement.h"

#include <ctype.h>
#include <math.h>
#include <string.h>

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
    said->coolant = holds_word(text, "OFF") ? 1 : holds_word(text, "MIST") ? 3 : 2;
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

static void spindle_block(struct nc_program *p, double rpm, bool ccw)
{
    nc_count(&p->w, "S", rpm);
    nc_code(&p->w, ccw ? "M4" : "M3");
    nc_end(&p->w);
}

void nc_spindle(struct nc_program *p)
{
    if (p->tooling.spindle > 0)
        spindle_block(p, p->tooling.spindle, p->tooling.ccw);
}

void nc_coolant(struct nc_program *p)
{
    static const char *const code[] = {NULL, NULL, "M8", "M7"};
    if (code[p->tooling.coolant])
        nc_block(&p->w, code[p->tooling.coolant]);
}

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
    static const char *const coolant[] = {NULL, "M9", "M8", "M7"};
    struct nc_tooling was = p->tooling;
    p->tooling = *said;
    if (said->coolant != was.coolant)
        nc_block(&p->w, coolant[said->coolant]);
    if (said->spindle > 0 && (said->spindle != was.spindle || said->ccw != was.ccw))
        (dialect->speed ? dialect->speed : spindle_block)(p, said->spindle, said->ccw);
    else if (said->spindle <= 0 && was.spindle > 0)
        nc_block(&p->w, "M5");
}

/* AUXFUN/n: the M word as it is. */
static void auxiliary_word(struct nc_program *p, double number)
{
    nc_count(&p->w, "M", number);
    nc_end(&p->w);
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
        nc_block(&p->w, "M0");
    else if (is_word(text, "OPSTOP", &rest))
        nc_block(&p->w, "M1");
    else if (is_word(text, "AUXFUN", &rest) && num_read(&rest, &number) && number >= 0 &&
             number <= 9999 && number == floor(number))
        auxiliary_word(p, number);
    else if (is_word(text, "DELAY", &rest) && num_read(&rest, &seconds) && seconds > 0)
        return seconds;
    else if (is_word(text, "PPRINT", &rest) || is_word(text, "REMARK", &rest))
        nc_comment(&p->w, "%.150s", rest);
    return 0;
}
