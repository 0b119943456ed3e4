/* dialect - see dialect.h. */
#include "dialect.h"

#include "post_statement.h"

#define ROW(name, title, tcp_of_machine) extern const struct dialect dialect_##name;
CONTROL_TABLE(ROW)
#undef ROW

#define ROW(name, title, tcp_of_machine) &dialect_##name,
static const struct dialect *const table[] = {CONTROL_TABLE(ROW)};
#undef ROW

const struct dialect *dialect_of(enum control_id control)
{
    return table[control];
}

static int given(int digits, int usual)
{
    return digits < 0 ? usual : digits;
}

struct nc_ability dialect_ability(enum control_id control, const struct machine *machine,
                                  enum post_axis_words axis, bool still, double unit)
{
    const struct dialect *dialect = dialect_of(control);
    int finer = unit > 1; /* an inch is 25.4 mm: a digit more */
    bool vectors = axis == POST_AXIS_USUAL ? dialect->vectors : axis == POST_AXIS_VECTORS;
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
    bool tcp = machine_has_tcp(machine, control);
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

void dialect_start(struct nc_program *p)
{
    const struct dialect *dialect = dialect_of(p->control);
    p->hole = NULL;
    p->cutcom.asked = p->cutcom.on = CUTCOM_OFF;
    p->at_plane = 0;
    nc_tool_first(p);
    dialect->start(p);
    dialect->load(p);
    dialect->engage(p);
}

void dialect_finish(struct nc_program *p)
{
    const struct dialect *dialect = dialect_of(p->control);
    if (p->hole)
        dialect->hole_end(p);
    dialect->disengage(p);
    dialect->finish(p);
}

/* Home, the other tool, and back to work; a tool that the program started with is there. */
static void change_tool(struct nc_program *p, const struct nc_move *move)
{
    const struct dialect *dialect = dialect_of(p->control);
    if (move->index < p->tooling.taken)
        return;
    dialect->disengage(p);
    nc_block(&p->w, "M9");
    nc_block(&p->w, "M5");
    nc_tool_change(p, move);
    nc_forget(&p->w, NC_X, NC_F);
    dialect->load(p);
    dialect->engage(p);
}

/* Home and back to work in another plane; a change of tools there goes to it by itself. */
static void change_plane(struct nc_program *p, const struct nc_move *move)
{
    const struct dialect *dialect = dialect_of(p->control);
    if (move->index <= p->at_plane || !nc_tool_stays(p, move))
        return;
    dialect->disengage(p);
    nc_tool_change(p, move);
    nc_forget(&p->w, NC_X, NC_F);
    p->same_tool = true;
    dialect->engage(p);
    p->same_tool = false;
}

void dialect_move(struct nc_program *p, const struct nc_move *move)
{
    const struct dialect *dialect = dialect_of(p->control);
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
        nc_statement(p, p->path->text.item[move->index]);
        break;
    case NC_TOOL:
        change_tool(p, move);
        break;
    case NC_PLANE:
        change_plane(p, move);
        break;
    }
}

void dialect_write(struct nc_program *p)
{
    dialect_start(p);
    for (size_t i = 0; i < p->plan->move.n; i++) {
        bool before = *p->w.met != '\0';
        dialect_move(p, &p->plan->move.item[i]);
        if (!before && *p->w.met)
            p->met = i;
    }
    dialect_finish(p);
}
