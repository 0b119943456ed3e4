/*
 * reader - see reader.h.
 *
 * One buffer, refilled at its end and moved to its front when a line does not fit; a line
 * is ended in place with '\0' and handed out without a copy.
 */
#include "base/reader.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/cli.h"
#include "base/out.h"
#include "system.h"

enum { CHUNK = 1 << 16, LARGE = 1 << 22, BEHIND = 8 /* bytes that may be looked at */ };

/* The system is at fault. */
static int system_error(struct error *error)
{
    error->file = error->system = true;
    return -1;
}

int reader_open(struct reader *r, const char *file, struct error *error)
{
    memset(r, 0, sizeof *r);
    bool standard = !file || strcmp(file, "-") == 0;
    r->name = standard ? "-" : file;
    r->fd = standard ? 0 : open(file, O_RDONLY | O_CLOEXEC);
    if (r->fd < 0) {
        bool absent = errno == ENOENT || errno == ENOTDIR || errno == EACCES;
        error_at(error, r->name, 0, "cannot open: %s", strerror(errno));
        return absent ? -1 : system_error(error);
    }
    struct stat st;
    if (fstat(r->fd, &st) != 0)
        return 0;
    if (S_ISDIR(st.st_mode)) {
        reader_close(r);
        return error_at(error, r->name, 0, "is a directory, expected a file");
    }
    out_keep(r->fd);
    off_t at = S_ISREG(st.st_mode) ? lseek(r->fd, 0, SEEK_CUR) : -1;
    if (at >= 0 && st.st_size > at)
        r->size = (size_t)(st.st_size - at);
    return 0;
}

bool reader_reads_once(const char *file)
{
    struct stat st;
    return !file || strcmp(file, "-") == 0 || (stat(file, &st) == 0 && S_ISFIFO(st.st_mode));
}

void reader_close(struct reader *r)
{
    if (r->fd > 0)
        close(r->fd);
    r->fd = -1;
    free(r->buf);
    r->buf = NULL;
}

/* Appends one read to the buffer; bytes beyond `to` always stay free for a '\0', and are all '\0'.
 */
static int fill_once(struct reader *r, struct error *error)
{
    size_t chunk = r->at_once > CHUNK ? r->at_once : CHUNK;
    r->buf = mem_grow(r->buf, &r->cap, r->to + chunk + BEHIND, 1);
    r->buf = mem_grow(r->buf, &r->cap, r->cap, 1); /* all the room that there is */
    ssize_t n;
    do
        n = read(r->fd, r->buf + r->to, r->cap - r->to - BEHIND);
    while (n < 0 && errno == EINTR);
    if (n < 0) {
        error_at(error, r->name, r->line, "cannot read: %s", strerror(errno));
        return system_error(error);
    }
    r->end = n == 0;
    if (r->end && r->got < r->size) { /* cut off while it is read, or a disk that fails quietly */
        error_at(error, r->name, r->line, "ends after %zu bytes, expected %zu", r->got, r->size);
        return system_error(error);
    }
    r->to += (size_t)n;
    memset(r->buf + r->to, 0, BEHIND);
    r->got += (size_t)n;
    if (r->size >= LARGE)
        progress("reading", r->end || r->got > r->size ? r->size : r->got, r->size);
    for (size_t at = r->to; at > r->to - (size_t)n; at--)
        if (r->buf[at - 1] == '\n') {
            r->whole = at;
            break;
        }
    return 0;
}

/* Reads more; the first time until a byte order mark would be seen, which is skipped. */
static int fill_buffer(struct reader *r, struct error *error)
{
    if (r->from > 0) {
        memmove(r->buf, r->buf + r->from, r->to - r->from);
        r->to -= r->from;
        r->whole = r->whole > r->from ? r->whole - r->from : 0;
        r->from = 0;
    }
    if (fill_once(r, error) < 0)
        return -1;
    if (!r->begun) {
        while (r->to < 3 && !r->end)
            if (fill_once(r, error) < 0)
                return -1;
        r->begun = true;
        if (r->to >= 3 && memcmp(r->buf, "\xEF\xBB\xBF", 3) == 0)
            r->from = 3;
    }
    return 0;
}

int reader_line(struct reader *r, char **line, size_t *n, struct error *error)
{
    size_t seen = 0;
    if (!r->begun && fill_buffer(r, error) < 0)
        return -1;
    for (;;) {
        char *from = r->buf + r->from;
        size_t have = r->to - r->from;
        char *lf = r->whole > r->from + seen ? memchr(from + seen, '\n', have - seen) : NULL;
        size_t until = lf ? (size_t)(lf - from) : have;
        char *cr = until > seen ? memchr(from + seen, '\r', until - seen) : NULL;
        if (cr && (cr + 1 < from + have || r->end)) { /* what follows it is known */
            *n = (size_t)(cr - from);
            r->from += *n + (cr + 1 == lf ? 2 : 1);
        } else if (lf && !cr) {
            *n = until;
            r->from += until + 1;
        } else if (r->end) {
            if (have == 0)
                return 0;
            *n = have;
            r->from = r->to;
        } else {
            seen = cr ? (size_t)(cr - from) : have;
            if (have > READER_LINE) /* a device without an end, a hole in a file */
                return error_at(error, r->name, r->line + 1, "found a line of more than %d bytes",
                                READER_LINE);
            if (fill_buffer(r, error) < 0)
                return -1;
            continue;
        }
        r->ended = cr || lf;
        r->last = (size_t)(from - r->buf);
        r->last_end = r->last + *n;
        r->last_char = from[*n];
        from[*n] = '\0';
        *line = from;
        r->line++;
        return 1;
    }
}

void reader_unread(struct reader *r)
{
    r->buf[r->last_end] = r->last_char;
    r->from = r->last;
    r->line--;
}

size_t reader_ahead(const struct reader *r, const char **text)
{
    bool any = r->whole > r->from;
    *text = any ? r->buf + r->from : "";
    return any ? r->whole - r->from : 0;
}

void reader_take(struct reader *r, size_t n, size_t lines)
{
    r->from += n;
    r->line += lines;
}

long reader_bytes(struct reader *r, void *p, size_t n, struct error *error)
{
    size_t got = 0;
    while (got < n) {
        size_t have = r->to - r->from;
        if (have == 0) {
            if (r->end)
                break;
            if (fill_buffer(r, error) < 0)
                return -1;
            continue;
        }
        size_t take = have < n - got ? have : n - got;
        memcpy((char *)p + got, r->buf + r->from, take);
        r->from += take;
        got += take;
    }
    return (long)got;
}

long reader_peek(struct reader *r, const char **p, size_t want, struct error *error)
{
    while (r->to - r->from < want && !r->end)
        if (fill_buffer(r, error) < 0)
            return -1;
    size_t have = r->to - r->from;
    *p = r->buf + r->from;
    return (long)(have < want ? have : want);
}
