/* meshfile - see meshfile.h. */
#include "io/mesh/meshfile.h"

#include <string.h>

#include "off.h"
#include "io/mesh/ply.h"
#include "ply_origin.h"
#include "io/mesh/stl.h"

enum { HEAD = 4096 }; /* bytes that tell what a file is */

static bool head_begins(const char *head, size_t n, const char *word)
{
    return n >= strlen(word) && memcmp(head, word, strlen(word)) == 0;
}

static bool is_text(const char *head, size_t n)
{
    for (size_t i = 0; i < n; i++) {
        if ((unsigned char)head[i] < ' ' && !memchr("\t\n\v\f\r", head[i], 5))
            return false;
    }
    return true;
}

/* In UTF-16, by its mark or by the noughts between the letters that a mesh of text begins with. */
static bool is_utf16(const char *head, size_t n)
{
    static const char *const words[] = {"ply", "solid", "SOLID", "OFF", "COFF", "NOFF"};
    if (n >= 2 && (memcmp(head, "\xFF\xFE", 2) == 0 || memcmp(head, "\xFE\xFF", 2) == 0))
        return true;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        for (size_t high = 0; high < 2; high++) {
            size_t k = 0;
            while (words[i][k] && 2 * k + 1 < n && head[2 * k + high] == words[i][k] &&
                   head[2 * k + 1 - high] == '\0')
                k++;
            if (!words[i][k])
                return true;
        }
    return false;
}

/* Past blanks and comments; *n: bytes that are left. */
static const char *first_word(const char *head, size_t *n)
{
    const char *end = head + *n, *s = head;

    while (s < end && (memchr(" \t\r\n#", *s, 5))) {
        const char *line = *s == '#' ? memchr(s, '\n', (size_t)(end - s)) : s;
        s = line ? line + 1 : end;
    }
    *n = (size_t)(end - s);
    return s;
}

bool mesh_says_off(const char *head, size_t n)
{
    head = first_word(head, &n);
    return head_begins(head, n, "OFF") || head_begins(head, n, "COFF") ||
           head_begins(head, n, "NOFF");
}

int mesh_read_from(struct reader *r, struct mesh *mesh, struct error *error)
{
    const char *head;
    long got = reader_peek(r, &head, HEAD, error);
    if (got < 0)
        return -1;
    size_t n = (size_t)got;
    bool text = is_text(head, n);

    *mesh = (struct mesh){.origin = ply_origin_none()};
    if (head_begins(head, n, "ply"))
        return ply_read_mesh(r, mesh, error);
    if (mesh_says_off(head, n))
        return off_read(r, mesh, error);
    if (!stl_is_binary(r, head, n) && is_utf16(head, n))
        return error_at(error, r->name, 0, "text in UTF-16 encoding, expected UTF-8 or ASCII");
    if (n > 0 && (!text || stl_is_binary(r, head, n)))
        return stl_read_binary(r, mesh, error);
    size_t rest = n;
    if (stl_begins(first_word(head, &rest), rest, "solid"))
        return stl_read_text(r, mesh, error);
    return ply_read_mesh(r, mesh, error);
}

/* A text STL: the line after its name begins a facet. */
static bool says_facets(const char *head, size_t n)
{
    const char *end = head + n;
    head = first_word(head, &n);
    const char *line = stl_begins(head, n, "solid") ? memchr(head, '\n', n) : NULL;
    while (line && line < end && memchr("\n\r\t ", *line, 4))
        line++;
    return line && stl_begins(line, (size_t)(end - line), "facet");
}

bool mesh_is_there(const char *file)
{
    struct reader r;
    struct error error;
    const char *head;
    if (reader_open(&r, file, &error) < 0)
        return false;
    long n = reader_peek(&r, &head, HEAD, &error);
    bool there = n > 0 && (mesh_says_off(head, (size_t)n) || stl_is_binary(&r, head, (size_t)n) ||
                           says_facets(head, (size_t)n));
    reader_close(&r);
    return there || ply_has_faces(file);
}

int mesh_read(const char *file, struct mesh *mesh, struct error *error)
{
    struct reader r;
    if (reader_open(&r, file, error) < 0)
        return -1;
    int status = mesh_read_from(&r, mesh, error);
    reader_close(&r);
    if (status < 0)
        mesh_free(mesh);
    return status;
}
