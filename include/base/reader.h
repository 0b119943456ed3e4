/*
 * reader - input line by line, or byte by byte, from a file or standard input.
 *
 * Lines may end in LF, CRLF or a bare CR, the last one in nothing; a UTF-8 byte order mark at the
 * start is skipped.  Lines may be of up to READER_LINE bytes.  A regular file that ends before the
 * length it had when it was opened is an error.
 */
#ifndef CLOUDMILL_READER_H
#define CLOUDMILL_READER_H

#include <stdbool.h>
#include <stddef.h>

#include "base/error.h"

enum { READER_LINE = 1 << 28 };

struct reader {
    int fd;
    const char *name; /* for messages: the file's name, or "-" for standard input */
    size_t line;      /* number of the line last read, from 1 */
    size_t size;      /* of a regular file from where reading begins, bytes; 0: not known */
    size_t got;       /* bytes read so far */
    bool ended;       /* the line had a line end: false only for the last one */
    size_t at_once;   /* bytes asked of the system at once, at least; 0: as many as is usual */
    char *buf;        /* from here on private to reader.c */
    size_t cap, from, to;
    size_t whole; /* end of the last LF in the buffer */
    size_t last, last_end;
    char last_char;
    bool end, begun;
};

/* Opens a file; NULL or "-" is standard input.  A directory is an error. */
int reader_open(struct reader *r, const char *file, struct error *error);

/* Can the file be read but once: standard input, or a pipe that has a name? */
bool reader_reads_once(const char *file);

/*
 * The next line: 1 and *line (ends in '\0', without its line end; may be changed in place, valid
 * until the next call) and *n, its length, which counts a NUL byte inside if there is one;
 * 0 at the end of the input; -1 when reading failed or the line is too long.
 */
int reader_line(struct reader *r, char **line, size_t *n, struct error *error);

/* Unreads the last line, once, if it was not changed: the next reader_line returns it again. */
void reader_unread(struct reader *r);

/*
 * For a parser that scans the text itself: the complete lines in the buffer, each with its LF, and
 * their length; 0 does not mean the end of the input.  Eight bytes after them may be read too.
 * reader_take then consumes the first n bytes, which are `lines` lines.
 */
size_t reader_ahead(const struct reader *r, const char **text);
void reader_take(struct reader *r, size_t n, size_t lines);

/* Reads n bytes to p; returns their number (fewer only at the end), -1 on failure. */
long reader_bytes(struct reader *r, void *p, size_t n, struct error *error);

/* The next bytes without consuming them: *p, at most `want` (<= 4096); returns their number. */
long reader_peek(struct reader *r, const char **p, size_t want, struct error *error);

void reader_close(struct reader *r);

#endif
