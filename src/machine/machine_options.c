/* machine_options - see machine_options.h. */
#include "machine/machine_options.h"

#include <stdlib.h>

#include "base/array.h"

struct cli_option machine_option_name(struct machine_options *options)
{
    return (struct cli_option){
        .letter = 'm',
        .name = "machine",
        .arg = "NAME",
        .help = "machine: NAME.txt in this folder, in $CLOUDMILL_MACHINES or among\n"
                "the installed ones, or a file (default: table-ac)",
        .kind = CLI_TEXT,
        .value = &options->name};
}

struct cli_option machine_option_set(struct machine_options *options)
{
    return (struct cli_option){.name = "set",
                               .arg = "KEY=VALUE",
                               .help = "set one key of the machine; may be given again",
                               .kind = CLI_LIST,
                               .value = &options->set};
}

struct cli_option machine_option_control(struct machine_options *options, const char *help)
{
    return (struct cli_option){.letter = 'c',
                               .name = "control",
                               .arg = control_names(),
                               .help = help,
                               .kind = CLI_CHOICE,
                               .value = &options->control,
                               .given = &options->control_given};
}

int machine_options_read(const struct machine_options *options, struct machine *machine,
                         struct error *error)
{
    *machine = machine_default();
    if (options->name && machine_read(machine, options->name, error) != 0)
        return EXIT_FAILED;
    for (size_t i = 0; i < options->set.n; i++)
        if (machine_set(machine, options->set.item[i], error) != 0)
            return EXIT_USAGE;
    /* a file is checked as it is read: what does not go together now was set */
    return machine_finish(machine, error) == 0 ? 0 : EXIT_USAGE;
}

void machine_options_free(struct machine_options *options)
{
    array_free(&options->set);
}
