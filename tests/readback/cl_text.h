/*
 * cl_text - a CL file as statements, for the tests' reader of paths alone: nothing of it comes from
 * the suite's own reader (io/path), so that a line read wrongly there is not read wrongly here.
 *
 * APT text (ISO 4343; man/cloudmill-path.5, Text): a word, a slash, words and numbers with commas;
 * a single $ ends a line that goes on in the next, $$ begins a comment, $$-> may carry data; some
 * words take the rest of their line raw; a label may stand in front; a line of numbers alone goes
 * on with the points of the GOTO before it.
 */
#ifndef READBACK_CL_TEXT_H
#define READBACK_CL_TEXT_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

enum { CL_WORD = 48 };

struct cl_argument {
    char text[CL_WORD]; /* in capitals, cut off when it is longer */
    bool is_number;
    double number;
};

struct cl_statement {
    size_t line;        /* where it begins, from 1 */
    bool data;          /* it begins with $$-> */
    bool bare;          /* numbers without a word */
    char *text;         /* all of it in one line, as it is written; of a comment too */
    char word[CL_WORD]; /* in capitals; empty: a comment, or bare */
    struct {
        size_t n, cap;
        struct cl_argument *item;
    } argument;
};

struct cl_text {
    size_t n, cap;
    struct cl_statement *item;
};

int cl_text_read(const char *file, struct cl_text *text, struct error *error);
void cl_text_free(struct cl_text *text);

/* Numbers from argument i on: how many stand in a row, at most `most`, in value. */
size_t cl_numbers(const struct cl_statement *s, size_t i, size_t most, double *value);

/* The place of a word among the arguments, argument.n: it is not there. */
size_t cl_find(const struct cl_statement *s, const char *word);

#endif
