/* off - see off.h. */
#include "off.h"

#include <limits.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"

/* The next line that holds something, without its comment: 1, 0 at the end, -1. */
static int next_line(struct reader *r, const char **line, struct error *error)
{
    char *text;
    size_t n;
    int got;

    while ((got = reader_line(r, &text, &n, error)) > 0) {
        text[strcspn(text, "#")] = '\0';
        *line = text + strspn(text, " \t");
        if (**line)
            return 1;
    }
    return got;
}

static int error_expected(const struct reader *r, struct error *error, const char *what)
{
    return error_at(error, r->name, r->line, "not enough finite numbers, expected %s", what);
}

static int read_numbers(const char **s, double *value, int n)
{
    int got = 0;

    while (got < n) {
        *s += strspn(*s, " \t");
        if (num_not_finite(s) || !num_read(s, &value[got]) || !isfinite(value[got]))
            break;
        got++;
    }
    return got;
}

/* The counts of vertices and faces. */
static int read_head(struct reader *r, double count[2], bool *normals, struct error *error)
{
    const char *s;

    if (next_line(r, &s, error) <= 0)
        return error_expected(r, error, "an OFF file");
    *normals = *s == 'N';
    s += strcspn(s, " \t");
    s += strspn(s, " \t");
    if (!*s && next_line(r, &s, error) <= 0)
        return error_expected(r, error, "the counts of an OFF file: vertices, faces, edges");
    if (read_numbers(&s, count, 2) < 2)
        return error_expected(r, error, "the counts of an OFF file: vertices, faces, edges");
    for (int i = 0; i < 2; i++) {
        if (!(count[i] >= 1 && count[i] <= INT_MAX && count[i] == floor(count[i])))
            return error_at(error, r->name, r->line, "a count of %.17g %s, expected 1 to %d",
                            count[i], i == 0 ? "vertices" : "faces", INT_MAX);
    }
    return 0;
}

static int read_vertex(struct reader *r, bool normals, struct mesh *mesh, struct error *error)
{
    const char *s;
    double v[6];
    int n = normals ? 6 : 3, got = next_line(r, &s, error);

    if (got < 0)
        return -1;
    if (got == 0)
        return error_at(error, r->name, 0, "the OFF file ends after %zu vertices, expected more",
                        mesh->vertex.n);
    if (read_numbers(&s, v, n) < n)
        return error_expected(r, error, normals ? "x y z nx ny nz" : "x y z");
    *array_push(&mesh->vertex) = vec(v[0], v[1], v[2]);
    if (normals)
        *array_push(&mesh->normal) = vec_unit(vec(v[3], v[4], v[5]));
    return 0;
}

static int read_face(struct reader *r, struct mesh *mesh, struct error *error)
{
    const char *s;
    double corners, index;
    int first = 0, before = 0, got = next_line(r, &s, error);

    if (got < 0)
        return -1;
    if (got == 0)
        return error_at(error, r->name, 0, "the OFF file ends after %zu facets, expected more",
                        mesh->face.n);
    if (read_numbers(&s, &corners, 1) < 1 || !(corners >= 3))
        return error_expected(r, error,
                              "a face: the number of its corners, 3 or more, and the corners");
    for (double i = 0; i < corners; i++) {
        if (read_numbers(&s, &index, 1) < 1)
            return error_expected(r, error, "the number of corners of the face");
        if (!(index >= 0 && index < (double)mesh->vertex.n && index == floor(index)))
            return error_at(error, r->name, r->line, "vertex index %.17g, expected 0 to %zu", index,
                            mesh->vertex.n - 1);
        int v = (int)index;
        if (i == 0)
            first = v;
        if (i >= 2)
            *array_push(&mesh->face) = (struct face){{first, before, v}};
        before = v;
    }
    return 0;
}

static int check_end(struct reader *r, double faces, struct error *error)
{
    const char *s;
    int got = next_line(r, &s, error);

    return got <= 0 ? got
                    : error_at(error, r->name, r->line,
                               "more than the %.0f faces of the OFF file's counts, expected the "
                               "end of the file",
                               faces);
}

int off_read(struct reader *r, struct mesh *mesh, struct error *error)
{
    double count[2] = {0, 0};
    bool normals = false;
    int status = read_head(r, count, &normals, error);

    for (double i = 0; status == 0 && i < count[0]; i++)
        status = read_vertex(r, normals, mesh, error);
    for (double i = 0; status == 0 && i < count[1]; i++)
        status = read_face(r, mesh, error);
    return status == 0 ? check_end(r, count[1], error) : status;
}
