/* machine_options - see machine_options.h. */
#include "machine/machine_options.h"

#include <ctype.h>
#include <stdlib.h>

#include "base/array.h"
#include "base/reader.h"

struct cli_option machine_option_name(struct machine_options *options)
{
    return (struct cli_option){.letter = 'm',
                               .name = "machine",
                               .arg = "MACHINE",
                               .help = "machine: an installed one, or a file (default: table-ac)",
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
                               .arg = "CONTROL",
                               .help = help,
                               .kind = CLI_TEXT,
                               .value = &options->control};
}

/* The machine's keys and those of --set over what there is. */
static int read_over(const struct machine_options *options, struct machine *machine,
                     struct error *error)
{
    if (options->name && machine_read(machine, options->name, error) != 0)
        return EXIT_FAILED;
    for (size_t i = 0; i < options->set.n; i++)
        if (machine_set(machine, options->set.item[i], error) != 0)
            return EXIT_USAGE;
    return 0;
}

int machine_options_read(const struct machine_options *options, struct machine *machine,
                         struct error *error)
{
    const char *control = options->control;
    struct machine first = machine_default();
    int status = 0;
    if (options->name && reader_reads_once(options->name)) {
        error_at(error, options->name, 0,
                 "found a pipe, expected a file: it is read twice, and "
                 "again by who reads the program");
        return EXIT_FAILED;
    }
    if (!control && (status = read_over(options, &first, error)) != 0)
        return status;
    if (!control)
        control = first.control;
    *machine = machine_default();
    if (*control && !machine_control_exists(control, error))
        return EXIT_USAGE;
    if (*control && machine_control(machine, control, error) != 0)
        return EXIT_FAILED;
    status = read_over(options, machine, error);
    if (status)
        return status;
    /* a file is checked as it is read: what does not go together now was set */
    return machine_finish(machine, error) == 0 ? 0 : EXIT_USAGE;
}

static bool control_exists(const char *name)
{
    struct error error;
    return machine_control_exists(name, &error);
}

/* The name as it stands, or in small letters. */
static bool find_name(char *name, bool (*exists)(const char *))
{
    if (exists(name))
        return true;
    for (char *c = name; *c; c++)
        *c = (char)tolower((unsigned char)*c);
    return exists(name);
}

bool machine_options_adopt(struct machine_options *options, char *control, char *machine,
                           const char **missing)
{
    *missing = NULL;
    if (!options->control && *control) {
        if (find_name(control, control_exists))
            options->control = control;
        else
            *missing = control;
    }
    if (!options->name && *machine) {
        if (find_name(machine, machine_exists))
            options->name = machine;
        else
            *missing = machine;
    }
    return !*missing;
}

void machine_options_free(struct machine_options *options)
{
    array_free(&options->set);
}
