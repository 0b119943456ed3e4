/*
 * apt - statements of APT CL text, of any system.
 *
 * A statement is one line, or several where each but the last ends in a single $ (text after it is
 * a comment).  It has a major word and, after a slash, words and numbers with commas between.  $$
 * starts a comment; a line that starts with $$ is a statement of its own, since some systems and
 * this suite put data into it: `$$-> PASS/3`.  The text after PARTNO, PPRINT, INSERT, TPRINT and
 * REMARK is raw.  Case does not matter.  A label before the word (`N30 ,GOTO/...`) is ignored;
 * numbers alone are a statement without a word.
 */
#ifndef CLOUDMILL_APT_H
#define CLOUDMILL_APT_H

#include <stdbool.h>

#include "base/array.h"
#include "base/error.h"
#include "base/reader.h"

struct apt_argument {
    const char *text; /* upper case, trimmed */
    double number;
    bool is_number; /* text is one finite number */
};

struct apt {
    const char *word; /* major word, "" for a comment without data */
    const char *raw;  /* the whole statement as it was written, its lines joined, trimmed */
    bool comment;     /* it starts with $$; with `$$->` word and arguments are filled as well */
    bool slash;       /* there was a slash after the word */
    unsigned line;    /* where it starts */
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

/* True if argument i exists and is this word. */
bool apt_is(const struct apt *apt, size_t i, const char *word);

/*
 * Arguments from, from + 1, ... as numbers into value[0..n-1]; a missing argument or one that is no
 * finite number is an error that names `what`.
 */
int apt_numbers(const struct apt *apt, const char *name, size_t from, size_t n, double *value,
                const char *what, struct error *error);

#endif
