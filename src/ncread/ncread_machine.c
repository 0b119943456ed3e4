/* ncread_machine - see ncread_machine.h. */
#include "ncread/ncread_machine.h"

static void add(struct rig *rig, const struct machine *machine, char letter, bool table)
{
    int k = letter - 'A';
    rig->axis[rig->n++] = (struct rig_axis){.letter = letter,
                                            .table = table,
                                            .axis = vec_unit(machine->axis[k]),
                                            .centre = machine->centre[k],
                                            .min = machine->min[MACHINE_A + k],
                                            .max = machine->max[MACHINE_A + k]};
}

struct rig ncread_rig(const struct machine *machine)
{
    struct rig rig = {.tool = vec(0, 0, 1)};
    char letter[RIG_AXES] = {0};
    int n = 0;
    for (const char *s = machine->axes; *s && n < RIG_AXES; s++)
        if (*s >= 'A' && *s <= 'C')
            letter[n++] = *s;
    switch (machine->type) {
    case TABLE_TABLE: /* the outer one, named first, is further from the work */
        add(&rig, machine, letter[1], true);
        add(&rig, machine, letter[0], true);
        break;
    case HEAD_TABLE: /* the head's is named first */
        add(&rig, machine, letter[1], true);
        add(&rig, machine, letter[0], false);
        break;
    case HEAD_HEAD: /* the outer one, named first, is further from the tool */
        add(&rig, machine, letter[0], false);
        add(&rig, machine, letter[1], false);
        break;
    case ONE_TABLE:
    case ONE_HEAD:
        add(&rig, machine, letter[0], machine->type == ONE_TABLE);
        break;
    default:
        break;
    }
    return rig;
}
