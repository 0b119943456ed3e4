/* nccutcom - see nccutcom.h. */
#include "post/nccutcom.h"

#include <string.h>

#include "nctool.h"

static bool may(const struct machine *machine, const struct nc_ability *ability)
{
    bool still = machine->chain.n == 0 || (!ability->tcp && ability->mode == INTERPOLATE_ROTARY);
    return machine->cutcom && still && ability->feeds == NC_FEEDS_TIP;
}

/* -1: it is no CUTCOM or says nothing of a side. */
static int side(const char *text)
{
    if (!nc_tool_starts(text, "CUTCOM"))
        return -1;
    if (nc_tool_holds(text, "OFF"))
        return CUTCOM_OFF;
    return nc_tool_holds(text, "LEFT")    ? CUTCOM_LEFT
           : nc_tool_holds(text, "RIGHT") ? CUTCOM_RIGHT
                                          : -1;
}

bool nc_cutcom_says(struct nc_program *p, const char *text)
{
    int asked = side(text);
    if (asked >= 0 && may(p->machine, &p->plan->ability))
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
        if (side(path->text.item[i]) > CUTCOM_OFF)
            return true;
    return false;
}

bool nc_cutcom_left_out(const struct path *path, const struct machine *machine,
                        const struct nc_ability *ability)
{
    return nc_cutcom_asked(path) && !may(machine, ability);
}
