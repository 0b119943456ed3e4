/* post_setup - see post_setup.h. */
#include "post/post_setup.h"

#include "post/nccutcom.h"
#include "post/ncframe.h"

/* *still: the rotary axes stay at zero. */
static int set_frame(struct nc_program *p, struct path *path, struct machine *machine,
                     const struct dialect *dialect, struct nc_post_options choice, bool *still,
                     bool *unmet, struct error *error)
{
    bool planes = nc_frame_planes(path, &p->planes), upright = nc_frame_upright(&p->planes);
    bool cycles = planes && machine->cycles && nc_frame_holes(path);
    int digits = machine->digits.angle < 0 ? dialect->digits.angle : machine->digits.angle;
    if (choice.plane && !planes)
        return error_set(error,
                         "%s: found a tool axis that turns in the cut, expected it to stay "
                         "(--plane)",
                         path->name);
    p->plane = choice.plane || ((machine->plane || cycles) && dialect->plane && planes && !upright);
    p->turned = machine->chain.n;
    *unmet = p->plane &&
             nc_frame_tilt(path, machine, &p->planes, dialect->plane_euler, digits, error) != 0;
    if (*unmet)
        return -1;
    if (!cycles || !(upright || p->plane))
        path_drill(path);
    if (choice.inch)
        nc_frame_inch(path, machine, &p->wish);
    *still = upright && (cycles || !machine->tcp || (machine->cutcom && nc_cutcom_asked(path)));
    return 0;
}

int nc_settle(struct nc_program *p, struct nc_plan *plan, struct path *path,
              struct machine *machine, const struct dialect *dialect, struct nc_post_options choice,
              bool *unmet, struct error *error)
{
    bool still = false;
    double smoothing = machine->smooth ? p->wish.chord : 0;
    if (set_frame(p, path, machine, dialect, choice, &still, unmet, error) != 0)
        return -1;
    struct nc_ability ability = dialect_ability(dialect, machine, choice.axis, still, p->wish.unit);
    ability.smoothing = smoothing;
    int result = nc_plan_make(plan, path, machine, ability, p->wish, error);
    *unmet = result != 0 && plan->unmet;
    if (*unmet && ability.mode == INTERPOLATE_VECTOR) {
        struct error again;
        ability = dialect_ability(dialect, machine, NC_AXIS_ROTARY, still, p->wish.unit);
        ability.smoothing = smoothing;
        nc_plan_free(plan);
        result = nc_plan_make(plan, path, machine, ability, p->wish, &again);
        plan->no_vectors = result == 0;
        *unmet = result != 0;
    }
    return result;
}
