/*
 * verdict_side - what stands beside the view on the page of verdict_page.c: the verdict, figures,
 * a histogram, the worst blocks, the passes.
 */
#ifndef CLOUDMILL_VERDICT_SIDE_H
#define CLOUDMILL_VERDICT_SIDE_H

#include "base/out.h"
#include "verify/verdict.h"

/* Rows of the table of pieces that the page knows, each once. */
struct side_rows {
    size_t *of; /* number of each piece's row, from 1; 0: none yet */
    struct sizes piece;
};

/* Number of the piece's row, from 0; a new one where it has none. */
long side_row(struct side_rows *rows, size_t piece);

/* Text with what HTML has for <, > and &. */
void side_text(struct out *o, const char *s);

/* All of it, with buttons for the n worst pieces. */
void side_write(struct out *o, const struct verdict *v, struct side_rows *rows, const size_t *worst,
                size_t n);

#endif
