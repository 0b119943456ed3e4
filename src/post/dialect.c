/* dialect - see dialect.h. */
#include "post/dialect.h"

#include <string.h>

#include "post/nccutcom.h"
#include "post/nchead.h"
#include "nctool.h"

extern const struct dialect dialect_fanuc, dialect_siemens, dialect_heidenhain, dialect_linuxcnc;

static const struct dialect *const table[] = {&dialect_fanuc, &dialect_siemens, &dialect_heidenhain,
                                              &dialect_linuxcnc};

const struct dialect *dialect_find(const char *name)
{
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (strcmp(table[i]->name, name) == 0)
            return table[i];
    return NULL;
}

static int given(int digits, int usual)
{
    return digits < 0 ? usual : digits;
}

struct nc_ability dialect_ability(const struct dialect *dialect, const struct machine *machine,
                                  enum nc_axis_words axis, bool still, double unit)
{
    int finer = unit > 1; /* an inch is 25.4 mm: a digit more */
    bool vectors = axis == NC_AXIS_USUAL ? dialect->vectors : axis == NC_AXIS_VECTORS;
    const struct machine_digits *own = &machine->digits, *usual = &dialect->digits;
    struct nc_ability ability = {
        .mode = INTERPOLATE_JOINT,
        .digits = {given(own->linear, usual->linear + finer), given(own->angle, usual->angle),
                   given(own->vector, usual->vector), given(own->knot, usual->knot),
                   given(own->feed, usual->feed + 2 * finer)},
        .radius_error = 0.005 / unit,
        .unit = unit,
        .feed_max = machine->feed_max,
    };
    bool tcp = machine->tcp;
    if (dialect->tcp_of_machine && strcmp(machine->control, dialect->name) != 0)
        tcp = false;
    still = still || machine->chain.n == 0;
    ability.tcp = tcp && !still;
    if (tcp || still) {
        vectors = vectors && ability.tcp;
        ability.mode = vectors ? INTERPOLATE_VECTOR : INTERPOLATE_ROTARY;
        ability.doubtful = vectors && dialect->vectors_doubtful;
        if (machine->arcs)
            ability.arcs = vectors ? dialect->arcs_vectors : dialect->arcs;
        if (machine->arcs && machine->arcs_space && dialect->arcs_space && !vectors)
            ability.arcs = dialect->arcs_space;
        if (machine->splines)
            ability.splines = vectors ? dialect->splines_vectors : dialect->splines;
    } else if (machine->feeds == FEEDS_COMBINED || dialect->inverse_never) {
        ability.feeds = NC_FEEDS_COMBINED;
    } else {
        ability.feeds = NC_FEEDS_INVERSE;
        ability.digits.feed = given(own->feed, 3); /* 1/min: small numbers count */
    }
    return ability;
}

void dialect_start(const struct dialect *dialect, struct nc_program *p)
{
    p->hole = NULL;
    p->cutcom.asked = p->cutcom.on = CUTCOM_OFF;
    p->at_plane = 0;
    nc_tool_first(p);
    dialect->start(p);
    dialect->load(p);
    dialect->take(p);
}

void dialect_finish(const struct dialect *dialect, struct nc_program *p)
{
    if (p->hole)
        dialect->hole_end(p);
    dialect->leave(p);
    dialect->finish(p);
}

/* Home, the other tool, and back to work; a tool that the program started with is there. */
static void change_tool(const struct dialect *dialect, struct nc_program *p,
                        const struct nc_move *move)
{
    if (move->index < p->tooling.taken)
        return;
    dialect->leave(p);
    nc_block(&p->w, "M9");
    nc_block(&p->w, "M5");
    nc_tool_change(p, move);
    nc_forget(&p->w, NC_X, NC_F);
    dialect->load(p);
    dialect->take(p);
}

/* Home and back to work in another plane; a change of tools there goes to it by itself. */
static void change_plane(const struct dialect *dialect, struct nc_program *p,
                         const struct nc_move *move)
{
    if (move->index <= p->at_plane || !nc_tool_stays(p, move))
        return;
    dialect->leave(p);
    nc_tool_change(p, move);
    nc_forget(&p->w, NC_X, NC_F);
    p->same_tool = true;
    dialect->take(p);
    p->same_tool = false;
}

void dialect_move(const struct dialect *dialect, struct nc_program *p, const struct nc_move *move)
{
    if (p->hole && move->kind != NC_HOLE && move->kind != NC_PASS)
        dialect->hole_end(p);
    switch (move->kind) {
    case NC_RAPID:
    case NC_LINE:
        dialect->line(p, move);
        break;
    case NC_ARC:
        dialect->arc(p, move);
        break;
    case NC_SPLINE:
        dialect->spline(p, move);
        break;
    case NC_HOLE:
        dialect->hole(p, move);
        break;
    case NC_PASS:
        nc_comment(&p->w, "Pass %u", move->index);
        break;
    case NC_TEXT:
        nc_statement(p, dialect, p->path->text.item[move->index]);
        break;
    case NC_TOOL:
        change_tool(dialect, p, move);
        break;
    case NC_PLANE:
        change_plane(dialect, p, move);
        break;
    }
}

void dialect_write(const struct dialect *dialect, struct nc_program *p)
{
    dialect_start(dialect, p);
    for (size_t i = 0; i < p->plan->move.n; i++) {
        bool before = *p->w.met != '\0';
        dialect_move(dialect, p, &p->plan->move.item[i]);
        if (!before && *p->w.met)
            p->met = i;
    }
    dialect_finish(dialect, p);
}
