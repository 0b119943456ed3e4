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
    const char *control; /* -c, NULL: the machine's own */
};

/* The rows of a tool's table of options (cli.h); `help` says what -c is for. */
struct cli_option machine_option_name(struct machine_options *options);
struct cli_option machine_option_set(struct machine_options *options);
struct cli_option machine_option_control(struct machine_options *options, const char *help);

/*
 * Makes the machine: the control of -c, or the machine's own, then that of -m, or the default one,
 * then the keys of --set.  The control is machine->text.dialect; CONTROLS: none was named.  0, or
 * the exit status that the error deserves: EXIT_FAILED, a file is missing or wrong; EXIT_USAGE, the
 * keys of --set are, or there is no such control.
 */
int machine_options_read(const struct machine_options *options, struct machine *machine,
                         struct error *error);

/*
 * What a program's head says of control and machine, where the user chose none: names of files, in
 * capitals where the control's comments are.  True if each of them that is named (not "") was taken
 * or the user chose one; *missing is otherwise what is not there.  The texts are kept, and changed
 * to the case that is there.
 */
bool machine_options_adopt(struct machine_options *options, char *control, char *machine,
                           const char **missing);

void machine_options_free(struct machine_options *options);

#endif
