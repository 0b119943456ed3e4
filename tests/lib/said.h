/* said - what a tool says on standard error, for unit tests: between said_begin and said_end it
 * goes into a file. */
#ifndef CLOUDMILL_TEST_SAID_H
#define CLOUDMILL_TEST_SAID_H

#include <check.h>
#include <stdio.h>
#include <unistd.h>

static FILE *said_file;
static int said_before;

static inline void said_begin(void)
{
    fflush(stderr);
    said_file = tmpfile();
    ck_assert_ptr_nonnull(said_file);
    said_before = dup(2);
    ck_assert_int_ge(dup2(fileno(said_file), 2), 0);
}

/* The text, which lasts until the next call. */
static inline const char *said_end(void)
{
    static char text[8000];
    fflush(stderr);
    ck_assert_int_ge(dup2(said_before, 2), 0);
    close(said_before);
    rewind(said_file);
    text[fread(text, 1, sizeof text - 1, said_file)] = '\0';
    fclose(said_file);
    return text;
}

#endif
