/* ncexplain - see ncexplain.h. */
#include "ncexplain.h"

#include <string.h>

static const char *rule(const struct nc_move *move)
{
    static const char *const why[] = {
        [NC_WHY_PATH] = "as the path says it",
        [NC_WHY_DIVIDED] = "one of several blocks, so that what the control makes of them keeps "
                           "the tolerance at the ball and the tool axis",
        [NC_WHY_CHORD] = "a straight piece of a curve that the control cannot be given within the "
                         "tolerance",
        [NC_WHY_TURN] = "retract, turn and return: the travel of a rotary axis ran out",
        [NC_WHY_APPROACH] = "the path starts with a cut: from above along the tool axis",
        [NC_WHY_RETRACT] = "the path ends in a cut: up along the tool axis",
        [NC_WHY_PART] = "the start or end of a part of the program",
    };
    return why[move->why];
}

static void say_origin(struct out *out, const struct path *path, const struct nc_plan *plan,
                       size_t index)
{
    static const char *const kind[] = {"rapid", "straight",  "arc",  "spline", "hole",
                                       "pass",  "statement", "tool", "plane"};
    const struct nc_move *move = &plan->move.item[index];
    size_t pass = 0;
    for (size_t i = 0; i <= index; i++)
        if (plan->move.item[i].kind == NC_PASS)
            pass = plan->move.item[i].index;
    out_printf(out, "%s:%u: pass %zu, %s: %s\n", path->name, move->line, pass, kind[move->kind],
               rule(move));
    for (size_t i = 0; move->line && i < path->item.n; i++) {
        const struct path_item *item = &path->item.item[i];
        if (item->line != move->line || !item->touches)
            continue;
        struct contact at = path->contact.item[item->contact];
        out_printf(out, "contact %.6f %.6f %.6f, normal %.6f %.6f %.6f\n", at.p.x, at.p.y, at.p.z,
                   at.n.x, at.n.y, at.n.z);
        return;
    }
}

int nc_explain(const char *file, const struct dialect *dialect, struct nc_program *program,
               long number, struct error *error)
{
    program->w.wanted = number;
    program->met = program->plan->move.n;
    dialect_write(dialect, program);
    if (!*program->w.met)
        return error_set(error, "option --explain: found no block %ld, the last one is %ld", number,
                         program->w.number);
    struct out *out = out_open(file);
    out_text(out, program->w.met);
    if (program->met < program->plan->move.n)
        say_origin(out, program->path, program->plan, program->met);
    else
        out_text(out, "at the start or the end of every program for this control and machine\n");
    out_close(out);
    return 0;
}
