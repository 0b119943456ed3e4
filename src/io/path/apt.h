/*
 * apt - statements of APT CL text, whatever system wrote it.
 *
 * A statement is one line, or more where a line ends in a single $ (anything behind it is a
 * comment).  It is a major word and, behind a slash, words and numbers with commas between.  $$
 * starts a comment; a line that starts with $$ is a statement of its own, for some systems (this
 * one too) carry data in it: `$$-> PASS/3`.  The text behind PARTNO, PPRINT, INSERT, TPRINT and
 * REMARK is raw.  Upper and lower case are the same.  A label in front (`N30 ,GOTO/...`) is passed
 * over; numbers alone are a statement without a word.
 */
#ifndef CLOUDMILL_APT_H
#define CLOUDMILL_APT_H

#include <stdbool.h>

#include "base/array.h"
#include "base/error.h"
#include "base/reader.h"

struct apt_argument {
    const char *text; /* upper case, without blanks around */
    double number;
    bool is_number; /* text is one finite number */
};

struct apt {
    const char *word; /* major word, "" for a comment that carries nothing */
    const char *raw;  /* the statement as it stood, joined, without blanks around */
    bool comment;  /* it stands behind $$; with `$$->` word and arguments are filled all the same */
    bool slash;    /* there was a slash behind the word */
    unsigned line; /* where it starts */
    struct {
        size_t n, cap;
        struct apt_argument *item;
    } argument;
    struct {
        size_t n, cap;
        char *item;
    } joined, upper; /* storage of the above */
};

/* The next statement that is not empty: 1; 0 at the end of the input; -1: error. */
int apt_read(struct reader *r, struct apt *apt, struct error *error);
void apt_free(struct apt *apt);

/* True when argument i is there and is this word. */
bool apt_is(const struct apt *apt, size_t i, const char *word);

/*
 * Arguments from, from + 1, ... as numbers into value[0..n-1]; an argument that is missing or is no
 * finite number is an error that names it and `what`.
 */
int apt_numbers(const struct apt *apt, const char *name, size_t from, size_t n, double *value,
                const char *what, struct error *error);

#endif
