/* post_program - see post_program.h. */
#include "post_program.h"

#include "post_statement.h"
#include "post_template.h"

/* To the first place; what the work offset was is said there. */
static void approach(struct nc_program *p)
{
    nc_section(p, SECTION_APPROACH);
    p->offset_said = p->tooling.taken + 1;
}

void post_program_start(struct nc_program *p)
{
    p->hole = NULL;
    p->cutcom.asked = p->cutcom.on = CUTCOM_OFF;
    p->at_plane = 0;
    nc_tool_first(p);
    p->warned = false;
    p->offset_said = p->tooling.taken + 1;
    nc_section(p, SECTION_START);
    nc_section(p, SECTION_TOOL);
    approach(p);
}

/* From the last motion of a tool. */
static void go_home(struct nc_program *p)
{
    nc_section(p, SECTION_RETRACT);
    nc_cutcom_end(p);
}

void post_program_finish(struct nc_program *p)
{
    const struct dialect *dialect = dialect_of(p->control);
    if (p->hole)
        dialect->hole_end(p);
    go_home(p);
    nc_section(p, SECTION_END);
}

/* Home, the other tool, and back to work; a tool that the program started with is there. */
static void change_tool(struct nc_program *p, const struct nc_move *move)
{
    if (move->index < p->tooling.taken)
        return;
    go_home(p);
    nc_section(p, SECTION_CHANGE);
    nc_tool_change(p, move);
    nc_forget(&p->w, NC_X, NC_F);
    nc_section(p, SECTION_TOOL);
    approach(p);
}

/* Home and back to work in another plane; a change of tools there goes to it by itself. */
static void change_plane(struct nc_program *p, const struct nc_move *move)
{
    if (move->index <= p->at_plane || !nc_tool_stays(p, move))
        return;
    go_home(p);
    nc_tool_change(p, move);
    nc_forget(&p->w, NC_X, NC_F);
    p->same_tool = true;
    approach(p);
    p->same_tool = false;
}

void post_program_move(struct nc_program *p, const struct nc_move *move)
{
    const struct dialect *dialect = dialect_of(p->control);
    if (p->hole && move->kind != NC_HOLE && move->kind != NC_PASS)
        dialect->hole_end(p);
    nc_warn_standing(p, move);
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
        p->seconds = nc_statement(p, p->path->text.item[move->index]);
        if (p->seconds > 0)
            nc_template(p, p->machine->blocks.dwell);
        break;
    case NC_TOOL:
        change_tool(p, move);
        break;
    case NC_PLANE:
        change_plane(p, move);
        break;
    }
}

void post_program_write(struct nc_program *p)
{
    post_program_start(p);
    for (size_t i = 0; i < p->plan->move.n; i++) {
        bool before = *p->w.met != '\0';
        post_program_move(p, &p->plan->move.item[i]);
        if (!before && *p->w.met)
            p->met = i;
    }
    post_program_finish(p);
}
