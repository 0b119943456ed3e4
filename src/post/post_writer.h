/*
 * post_writer - blocks of an NC program: words, modal values, block numbers, comments.
 *
 * A word whose value is modal is left out when it is what the last one said.  Numbers are rounded
 * half away from zero, without an exponent, without -0.
 */
#ifndef CLOUDMILL_POST_WRITER_H
#define CLOUDMILL_POST_WRITER_H

#include <stdbool.h>

#include "base/num.h"
#include "base/out.h"

/* How a control wants its text. */
struct nc_format_options {
    char open[24], close[24]; /* around a comment */
    size_t comment_width;     /* with them */
    bool capitals;            /* in comments, and no brackets in them */
    bool point;               /* a whole number has its decimal point: X12. */
    bool sign;                /* a + before numbers that are not negative: X+12 */
    char number[24];          /* before a block's number: N */
    int number_width;         /* of that, with zeros in front */
    bool count_all;           /* numbers 0, 1, 2 ..., of comments too */
};

/* Modal values. */
enum nc_slot { NC_X, NC_Y, NC_Z, NC_Q0, NC_Q1, NC_I, NC_J, NC_K, NC_F, NC_SLOTS };

enum {
    NC_BLOCK_MAX = 1000,
    NC_LINE_MAX = NC_BLOCK_MAX + 2 * NUM_MAX /* with the word that goes beyond it, and its number */
};

struct nc_writer {
    struct out *out; /* NULL: to nowhere */
    struct nc_format_options style;
    int step;    /* of block numbers, 0: none */
    long most;   /* after it the numbers begin again */
    long number; /* of the last block */
    char *line;  /* the block that is put together: in the output's own memory, or in `own` */
    size_t n;
    double value[NC_SLOTS];
    bool known[NC_SLOTS];
    const char *motion;   /* modal G code of motion, NULL: not said */
    int plane;            /* 17 18 19, 0: not said */
    bool skip;            /* blocks begin with a slash */
    bool inverse;         /* feeds are inverse time: G93 */
    size_t blocks, bytes; /* written */
    long wanted;          /* number of a block to be kept in `met`, -1: none */
    char met[NC_LINE_MAX + 1];
    char own[NC_LINE_MAX];
};

/* Starts a program; nobody else writes to `out` meanwhile. */
void nc_writer_begin(struct nc_writer *w, struct out *out, struct nc_format_options style, int step,
                     long most);

/* From this block on the text goes there; NULL: to nowhere. */
void nc_writer_divert(struct nc_writer *w, struct out *out);

/* Adds a word to the block: a text as it is; an address with a number; with a whole number. */
void nc_code(struct nc_writer *w, const char *word);
void nc_number(struct nc_writer *w, const char *address, double value, int digits);
void nc_count(struct nc_writer *w, const char *address, double whole); /* no point, no sign */

/* The same where it is not what the last one said; true when it was added. */
bool nc_motion(struct nc_writer *w, const char *code);
bool nc_modal(struct nc_writer *w, enum nc_slot slot, const char *address, double value,
              int digits);

/* The same for several words: most of a program, without a call for each. */
struct nc_word {
    enum nc_slot slot;
    int digits;
    const char *address;
    double value;
};
void nc_modal_words(struct nc_writer *w, const struct nc_word word[], size_t n);

/* Makes the next word of the slots from..to be written whatever its value. */
void nc_forget(struct nc_writer *w, enum nc_slot from, enum nc_slot to);

/* Remembers a value that the control has without a word of ours. */
void nc_remember(struct nc_writer *w, enum nc_slot slot, double value);

/* Ends the block and writes it, with its number; a block without words is none. */
void nc_end(struct nc_writer *w);

/* Takes back the block that has begun. */
void nc_drop(struct nc_writer *w);

/* Goes on with the block in a new line. */
void nc_continue(struct nc_writer *w, const char *text);

/* A whole block of one word; a line without a number; a comment on its own line. */
void nc_block(struct nc_writer *w, const char *word);
void nc_line(struct nc_writer *w, const char *text);
void nc_comment(struct nc_writer *w, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
