/*
 * machine_options - the options -m, --set and -c: the machine and the control that the user chose.
 */
#ifndef CLOUDMILL_MACHINE_OPTIONS_H
#define CLOUDMILL_MACHINE_OPTIONS_H

#include "base/cli.h"
#include "machine/control.h"
#include "machine/machine.h"

struct machine_options {
    const char *name;    /* -m, NULL: machine_default */
    struct cli_list set; /* --set */
    int control;         /* -c: an enum control_id, where control_given */
    bool control_given;
};

/* The rows of a tool's table of options (cli.h); `help` says what -c is for. */
struct cli_option machine_option_name(struct machine_options *options);
struct cli_option machine_option_set(struct machine_options *options);
struct cli_option machine_option_control(struct machine_options *options, const char *help);

/*
 * Makes the machine: that of -m, or the default one, with the keys of --set.  0, or the exit status
 * that the error deserves: EXIT_FAILED, the machine file is missing or wrong; EXIT_USAGE, the keys
 * of --set are.
 */
int machine_options_read(const struct machine_options *options, struct machine *machine,
                         struct error *error);

void machine_options_free(struct machine_options *options);

#endif
