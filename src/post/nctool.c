/* nctool - see nctool.h. */
#include "nctool.h"

#include <ctype.h>
#include <string.h>

#include "base/num.h"

bool nc_tool_holds(const char *text, const char *word)
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

bool nc_tool_starts(const char *text, const char *word)
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
    if (nc_tool_holds(text, "OFF")) {
        said->spindle = 0;
        return true;
    }
    for (const char *s = text; *s; s++)
        if (isdigit((unsigned char)*s) && num_read(&s, &rpm)) {
            said->spindle = rpm;
            said->ccw = nc_tool_holds(text, "CCLW");
            return true;
        }
    return false;
}

bool nc_tool_says(const char *text, struct nc_tooling *said)
{
    if (nc_tool_starts(text, "SPINDL"))
        return says_spindle(text, said);
    if (!nc_tool_starts(text, "COOLNT"))
        return false;
    said->coolant = nc_tool_holds(text, "OFF") ? 1 : nc_tool_holds(text, "MIST") ? 3 : 2;
    return true;
}

static int offset_of(int number, int offset)
{
    return offset > 0 ? offset : number > 0 ? number : 1;
}

/* What is said from move i on, before the next motion or tool. */
static void listen(struct nc_program *p, size_t i)
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
            nc_tool_says(p->path->text.item[move->index], &p->tooling);
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
    listen(p, 0);
}

void nc_tool_change(struct nc_program *p, const struct nc_move *change)
{
    listen(p, (size_t)(change - p->plan->move.item));
}

bool nc_tool_stays(const struct nc_program *p, const struct nc_move *from)
{
    const struct nc_move *end = p->plan->move.item + p->plan->move.n;
    while (from < end && !nc_moves(from) && from->kind != NC_TOOL)
        from++;
    return from == end || from->kind != NC_TOOL;
}
