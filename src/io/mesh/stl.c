/* stl - see stl.h. */
#include "io/mesh/stl.h"

#include <limits.h>
#include <stdint.h>
#include <string.h>
#include <strings.h>

#include "math/elementary.h"
#include "base/bytes.h"
#include "base/num.h"
#include "mesh/mesh_weld.h"

enum { HEAD = 84, FACET = 50 }; /* bytes of a binary file: head with the count, each facet */

bool stl_is_binary(const struct reader *r, const char *head, size_t n)
{
    return n >= HEAD && r->size > 0 && (r->size - HEAD) / FACET == bytes_whole(head + 80, 4) &&
           (r->size - HEAD) % FACET == 0;
}

bool stl_begins(const char *text, size_t n, const char *word)
{
    return n >= strlen(word) && strncasecmp(text, word, strlen(word)) == 0;
}

/* A facet with three vertices of its own, in order. */
static int add_facet(const struct reader *r, size_t line, const struct vec3 corner[3],
                     struct mesh *mesh, struct error *error)
{
    size_t first = mesh->vertex.n;

    if (first > INT_MAX - 3)
        return error_at(error, r->name, 0, "more than %d facets, expected no more", INT_MAX / 3);
    for (int i = 0; i < 3; i++) {
        struct vec3 p = corner[i];
        if (!isfinite(p.x) || !isfinite(p.y) || !isfinite(p.z))
            return error_at(error, r->name, line,
                            "facet %zu has a number that is not finite, expected coordinates",
                            mesh->face.n);
        *array_push(&mesh->vertex) = vec(p.x + 0.0, p.y + 0.0, p.z + 0.0);
    }
    *array_push(&mesh->face) = (struct face){{(int)first, (int)first + 1, (int)first + 2}};
    return 0;
}

static int check_end(const struct reader *r, struct mesh *mesh, struct error *error)
{
    if (mesh->face.n == 0)
        return error_at(error, r->name, 0, "an STL file without facets, expected some");
    mesh_weld(mesh);
    return 0;
}

int stl_read_binary(struct reader *r, struct mesh *mesh, struct error *error)
{
    char head[HEAD], facet[FACET];
    long got = reader_bytes(r, head, HEAD, error);
    if (got < 0)
        return -1;
    if (got < HEAD)
        return error_at(error, r->name, 0,
                        "%ld bytes that are no text, expected a mesh: PLY, STL or OFF", got);
    uint32_t facets = (uint32_t)bytes_whole(head + 80, 4);

    for (uint32_t i = 0; i < facets; i++) {
        struct vec3 corner[3];
        got = reader_bytes(r, facet, FACET, error);
        if (got < 0)
            return -1;
        if (got < FACET)
            return error_at(error, r->name, 0,
                            "taken for a binary STL, the file ends after %zu facets, expected "
                            "%lu",
                            mesh->face.n, (unsigned long)facets);
        for (int k = 0; k < 3; k++) {
            const char *p = facet + 12 * (k + 1);
            corner[k] = vec(bytes_float(p), bytes_float(p + 4), bytes_float(p + 8));
        }
        if (add_facet(r, 0, corner, mesh, error) < 0)
            return -1;
    }
    got = reader_bytes(r, facet, FACET, error); /* less may be what a writer filled it up with */
    if (got < 0)
        return -1;
    if (got == FACET)
        return error_at(error, r->name, 0,
                        "more than the %lu facets of the binary STL's count, expected the end of "
                        "the file",
                        (unsigned long)facets);
    return check_end(r, mesh, error);
}

/* The word at *s in any case; *s then points after it. */
static bool take_word(const char **s, const char *word)
{
    const char *p = *s + strspn(*s, " \t");
    size_t n = strlen(word);

    if (strncasecmp(p, word, n) != 0 || (p[n] && p[n] != ' ' && p[n] != '\t'))
        return false;
    *s = p + n;
    return true;
}

static int read_vertex(const struct reader *r, const char *s, struct vec3 *p, struct error *error)
{
    double value[3];

    for (int i = 0; i < 3; i++) {
        s += strspn(s, " \t");
        if (num_not_finite(&s) || !num_read(&s, &value[i]) || !isfinite(value[i]))
            return error_at(error, r->name, r->line,
                            "a vertex of an STL file without three finite numbers, expected "
                            "`vertex x y z`");
    }
    *p = vec(value[0], value[1], value[2]);
    return 0;
}

int stl_read_text(struct reader *r, struct mesh *mesh, struct error *error)
{
    struct vec3 corner[3];
    int corners = 0;
    bool inside = false, ended = false;
    char *line;
    size_t n;
    int got;

    while ((got = reader_line(r, &line, &n, error)) > 0) {
        const char *s = line;
        if (take_word(&s, "facet")) {
            if (inside)
                break;
            inside = true;
            corners = 0;
        } else if (take_word(&s, "vertex")) {
            if (!inside || corners == 3)
                break;
            if (read_vertex(r, s, &corner[corners++], error) < 0)
                return -1;
        } else if (take_word(&s, "endfacet")) {
            if (!inside || corners < 3)
                break;
            inside = false;
            if (add_facet(r, r->line, corner, mesh, error) < 0)
                return -1;
        } else if (take_word(&s, "solid") || take_word(&s, "endsolid")) {
            ended = strncasecmp(line + strspn(line, " \t"), "end", 3) == 0;
        } else if (!take_word(&s, "outer") && !take_word(&s, "endloop") &&
                   line[strspn(line, " \t")]) {
            return error_at(error, r->name, r->line, "'%.40s', expected a statement of an STL file",
                            line);
        }
    }
    if (got < 0)
        return -1;
    if (got > 0)
        return error_at(error, r->name, r->line,
                        "'%.40s' at the wrong place, expected facets of three vertices", line);
    if (inside || !ended)
        return error_at(error, r->name, 0,
                        "the STL file ends after %zu facets without endsolid, expected the rest",
                        mesh->face.n);
    return check_end(r, mesh, error);
}
