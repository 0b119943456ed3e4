/* stream - see stream.h. */
#include "stream.h"

#include <ctype.h>
#include <errno.h>
#include <stdbool.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "base/reader.h"
#include "base/spool.h"
#include "io/mesh/stl.h"

enum { HEAD = 4096, CHUNK = 1 << 16 }; /* HEAD: bytes that tell what a file is */

static bool line_begins(const char *line, size_t n, const char *word)
{
    return n >= strlen(word) && strncmp(line, word, strlen(word)) == 0;
}

static bool head_holds(const char *head, size_t n, const char *words)
{
    size_t length = strlen(words);
    for (size_t i = 0; i + length <= n; i++)
        if (memcmp(head + i, words, length) == 0)
            return true;
    return false;
}

/* `WORD/`, `WORD /` in capitals; a remark of APT; one of the words that take a text. */
static bool is_apt(const char *line, size_t n)
{
    static const char *const words[] = {"$$", "PARTNO", "PPRINT", "TOOL PATH/", "MULTAX", "FINI"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (line_begins(line, n, words[i]))
            return true;
    size_t letters = 0;
    while (letters < n && isupper((unsigned char)line[letters]))
        letters++;
    size_t slash = letters;
    while (slash < n && line[slash] == ' ')
        slash++;
    return letters >= 2 && slash < n && line[slash] == '/';
}

/* A block: a number or a first word of it, a program's name, the frame of a Heidenhain program. */
static bool is_block(const char *line, size_t n)
{
    static const char *const words[] = {"%", "BEGIN PGM", "TRAORI", "CYCLE832", "WORKPIECE"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (line_begins(line, n, words[i]))
            return true;
    return (n >= 2 && strchr("NGOTM:", line[0]) && isdigit((unsigned char)line[1])) ||
           (n > 0 && isdigit((unsigned char)line[0]) && head_holds(line, n, " BEGIN PGM "));
}

static bool is_remark(const char *line, size_t n)
{
    return n == 0 || strchr("#;(", line[0]) || line_begins(line, n, "//");
}

enum stream_kind stream_tell(const char *head, size_t n)
{
    static const char *const meshes[] = {"OFF", "COFF", "NOFF"};
    if (line_begins(head, n, "ply"))
        return head_holds(head, n, "element face ") && !head_holds(head, n, "element face 0\n")
                   ? STREAM_MESH
                   : STREAM_CLOUD;
    if (stl_begins(head, n, "solid"))
        return STREAM_MESH;
    for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++)
        if (line_begins(head, n, meshes[i]))
            return STREAM_MESH;
    for (size_t from = 0, to; from < n; from = to + 1) {
        while (from < n && strchr(" \t\r\n", head[from]))
            from++;
        to = from;
        while (to < n && head[to] != '\n' && head[to] != '\r')
            to++;
        if (is_apt(head + from, to - from))
            return STREAM_PATH;
        if (is_block(head + from, to - from))
            return STREAM_PROGRAM;
        if (!is_remark(head + from, to - from))
            return STREAM_CLOUD;
    }
    return STREAM_CLOUD;
}

/* Copies all that waits in the reader to a file without a name, and makes that standard input. */
static int keep_input(struct reader *r, struct error *error)
{
    static char chunk[CHUNK];
    FILE *copy = spool_open();
    if (!copy)
        return error_at(error, r->name, 0, "cannot keep a copy: %s", strerror(errno));
    long n;
    while ((n = reader_bytes(r, chunk, sizeof chunk, error)) > 0)
        if (fwrite(chunk, 1, (size_t)n, copy) != (size_t)n)
            break;
    bool good =
        n == 0 && fflush(copy) == 0 && dup2(fileno(copy), 0) == 0 && lseek(0, 0, SEEK_SET) == 0;
    int why = errno;
    fclose(copy);
    if (n < 0 || good)
        return good ? 0 : -1;
    return error_at(error, r->name, 0, "cannot keep a copy: %s", strerror(why));
}

int stream_find(const char *file, enum stream_kind *kind, const char **name, struct error *error)
{
    struct reader r;
    if (reader_open(&r, file, error) < 0)
        return -1;
    off_t start = lseek(r.fd, 0, SEEK_CUR); /* -1: a pipe */
    const char *head;
    long n = reader_peek(&r, &head, HEAD, error);
    int status = n < 0 ? -1 : 0;
    *name = r.name;
    if (n >= 0) {
        *kind = stream_tell(head, (size_t)n);
        if (*kind == STREAM_CLOUD && stl_is_binary(&r, head, (size_t)n))
            *kind = STREAM_MESH;
        if (start < 0) {
            status = keep_input(&r, error);
            *name = "-";
        } else if (r.fd == 0 && lseek(0, start, SEEK_SET) != start) {
            status = error_at(error, r.name, 0, "cannot go back to its start");
        }
    }
    reader_close(&r);
    return status;
}

int stream_again(const char *name, struct error *error)
{
    if (strcmp(name, "-") == 0 && lseek(0, 0, SEEK_SET) != 0)
        return error_at(error, name, 0, "cannot go back to its start: %s", strerror(errno));
    return 0;
}
