/*
 * error - a failure as a value.
 *
 * A function that can fail returns 0 on success and -1 on failure; it then fills the caller's
 * struct error with one line: `place: what was found, what was expected`.  Only the tools turn it
 * into a message and an exit status (cli.h: die_error).
 */
#ifndef CLOUDMILL_ERROR_H
#define CLOUDMILL_ERROR_H

#include <stdbool.h>
#include <stddef.h>

struct error {
    char text[400]; /* one line without its newline */
    bool file;      /* a file is at fault, not an option */
    bool system;    /* not what the file holds: the system could not read it */
};

/* Fills *error as printf would and returns -1, so that a caller can `return error_set(...)`. */
int error_set(struct error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The same about a file, with the place `name:line: ` (line 0: `name: `) before the text. */
int error_at(struct error *error, const char *name, size_t line, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* Adds to the line, as far as it has room. */
void error_add(struct error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
