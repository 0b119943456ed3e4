/*
 * cli - what every tool does the same way: options, help, messages, exit status, progress; the main
 * header of base, the only folder that ends the process.
 *
 * A tool declares its options as a table; -h -V -q -v -o and -j are added here.  Exit status:
 * 0 done, 1 input, output or memory failed, 2 wrong usage, 3 done but a stated requirement is
 * not met.
 *
 * Beside it: array.h memory and growing arrays, error.h failures as values, num.h numbers as text,
 * reader.h input by lines, out.h output that is complete or absent, parallel.h and aside.h threads,
 * effort.h bounds of the work on a large scan, unmet.h what a stage could not keep, library_file.h
 * files installed with the program.
 */
#ifndef CLOUDMILL_CLI_H
#define CLOUDMILL_CLI_H

#include <float.h>
#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

extern const char cloudmill_version[]; /* what the file VERSION says */

enum { EXIT_DONE = 0, EXIT_FAILED = 1, EXIT_USAGE = 2, EXIT_UNMET = 3 };

enum cli_kind {
    CLI_FLAG,    /* bool *: set to true */
    CLI_NUMBER,  /* double *: one number within min..max */
    CLI_COUNT,   /* int *: a whole number within min..max */
    CLI_TEXT,    /* const char ** */
    CLI_CHOICE,  /* int *: index of the word among `arg`, written "one|two|three" */
    CLI_NUMBERS, /* double[count]: exactly `count` numbers, commas between */
    CLI_LIST,    /* struct cli_list *: may be given several times */
    CLI_ALIAS    /* const char[]: an old name of this option, in no help, with a note; with
                    `name=value` of an option that takes one */
};

#define CLI_POSITIVE DBL_MIN /* as min: above zero */
#define CLI_LARGEST 1e9      /* no number of an option is beyond it, whatever its bounds */

struct cli_list {
    size_t n, cap;
    const char **item;
};

struct cli_option {
    int letter;       /* 0: no short form */
    const char *name; /* long form without the dashes */
    const char *arg;  /* name of the value in the help, NULL for a flag */
    const char *help; /* words, wrapped when printed */
    enum cli_kind kind;
    void *value;     /* where it goes; its contents are the default */
    double min, max; /* both 0: no bounds */
    int count;       /* of CLI_NUMBERS */
    bool *given;     /* set to true if the option is used; may be NULL */
};

struct cli {
    const char *tool;                /* name for messages and usage */
    const char *usage;               /* "[options] [FILE...]" */
    const char *about;               /* one line: what the tool does */
    const struct cli_option *option; /* ends with a name of NULL */
    const struct cli_option *more;   /* a second such table, of options that tools share; or NULL */
    const char *usual;  /* names of the options that --help shows, blanks between; the others are in
                          --help all.  NULL: all */
    bool in_place;      /* -o may name the operand: a result of its kind takes its place */
    const char *output; /* -o, NULL: standard output */
    int threads;        /* -j, 0: as many as there are processors */
    int files;          /* number of operands */
    char **file;        /* the operands; without any: one, "-" */
};

/* Reads the options.  -h (--help; with the operand `all`: every option) and -V end the process with
 * 0, a mistake with 2. */
void cli_parse(struct cli *cli, int argc, char **argv);

/* The file is an operand, under whatever name. */
bool cli_is_operand(const struct cli *cli, const char *file);

/* The name of this tool: "cloudmill" before cli_parse. */
const char *cli_tool(void);

/* One line on standard error after `tool: `.  warn: always, for what -q must not hide: that
 * something is not guarded; say: unless -q; note: only with -v. */
void warn(const char *format, ...) __attribute__((format(printf, 1, 2)));
void say(const char *format, ...) __attribute__((format(printf, 1, 2)));
void note(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Is what note() prints asked for?  What it costs much to find need not be found else. */
bool notes_shown(void);

/* Ends the process with the message: exit 1, exit 1 with error's text, exit 2, exit 3. */
_Noreturn void die(const char *format, ...) __attribute__((format(printf, 1, 2)));
_Noreturn void die_error(const struct error *error);
_Noreturn void die_usage(const char *format, ...) __attribute__((format(printf, 1, 2)));
_Noreturn void die_unmet(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Of what was given with an option: exit 1 where a file is at fault, else exit 2. */
_Noreturn void die_given(const struct error *error);

/* The same with the status as a value: EXIT_FAILED, EXIT_USAGE or EXIT_UNMET. */
_Noreturn void die_status(int status, const struct error *error);

/* Prints a percentage on standard error if that is a terminal and without -q; done == of clears it.
 */
void progress(const char *what, size_t done, size_t of);

#endif
