/* ncread_machine - see ncread_machine.h. */
#include "ncread/ncread_machine.h"

static void add(struct verify_kinematics *verify_kinematics, const struct machine *machine,
                char letter, bool table)
{
    int k = letter - 'A';
    verify_kinematics->axis[verify_kinematics->n++] =
        (struct verify_kinematics_axis){.letter = letter,
                                        .table = table,
                                        .axis = vec_unit(machine->axis[k]),
                                        .centre = machine->centre[k],
                                        .min = machine->min[MACHINE_A + k],
                                        .max = machine->max[MACHINE_A + k]};
}

struct verify_kinematics ncread_rig(const struct machine *machine)
{
    struct verify_kinematics verify_kinematics = {.tool = vec(0, 0, 1)};
    char letter[VERIFY_KINEMATICS_AXES] = {0};
    int n = 0;
    for (const char *s = machine->axes; *s && n < VERIFY_KINEMATICS_AXES; s++)
        if (*s >= 'A' && *s <= 'C')
            letter[n++] = *s;
    switch (machine->type) {
    case TABLE_TABLE: /* the outer one, named first, is further from the work */
        add(&verify_kinematics, machine, letter[1], true);
        add(&verify_kinematics, machine, letter[0], true);
        break;
    case HEAD_TABLE: /* the head's is named first */
        add(&verify_kinematics, machine, letter[1], true);
        add(&verify_kinematics, machine, letter[0], false);
        break;
    case HEAD_HEAD: /* the outer one, named first, is further from the tool */
        add(&verify_kinematics, machine, letter[0], false);
        add(&verify_kinematics, machine, letter[1], false);
        break;
    case ONE_TABLE:
    case ONE_HEAD:
        add(&verify_kinematics, machine, letter[0], machine->type == ONE_TABLE);
        break;
    default:
        break;
    }
    return verify_kinematics;
}
