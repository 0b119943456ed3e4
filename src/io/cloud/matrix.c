/* matrix - see matrix.h. */
#include "io/cloud/matrix.h"

#include <string.h>

#include "base/num.h"
#include "base/reader.h"

/* The numbers of one line to value[*n...], at most 16 in all. */
static int read_line(const struct reader *r, const char *line, double value[16], int *n,
                     struct error *error)
{
    for (const char *s = line;;) {
        s += strspn(s, " \t,;\r");
        if (!*s || *s == '#')
            return 0;
        if (*n == 16)
            return error_at(error, r->name, r->line,
                            "found more than 16 numbers, expected a 4 x 4 matrix");
        const char *from = s;
        if (!num_read(&s, &value[*n]) || !isfinite(value[*n]) || !strchr(" \t,;\r#", *s))
            return error_at(error, r->name, r->line, "found `%.20s`, expected a number", from);
        (*n)++;
    }
}

static int check_transform(const char *name, const struct transform *t, struct error *error)
{
    const double *last = t->m[3];
    if (last[0] != 0 || last[1] != 0 || last[2] != 0 || last[3] != 1)
        return error_set(error, "%s: found %g %g %g %g as the last row, expected 0 0 0 1", name,
                         last[0], last[1], last[2], last[3]);
    double size = 1;
    for (int i = 0; i < 3; i++)
        size *= vec_length(vec(t->m[i][0], t->m[i][1], t->m[i][2]));
    if (!(fabs(transform_determinant(t)) > 1e-9 * size))
        return error_set(error, "%s: the matrix flattens the points (its determinant is %g)", name,
                         transform_determinant(t));
    return 0;
}

int matrix_read(const char *file, struct transform *matrix, struct error *error)
{
    struct reader r;
    double value[16];
    char *line;
    size_t length;
    int n = 0, got;
    if (reader_open(&r, file, error) < 0)
        return -1;
    while ((got = reader_line(&r, &line, &length, error)) > 0)
        if (read_line(&r, line, value, &n, error) < 0) {
            got = -1;
            break;
        }
    if (got == 0 && n < 16)
        got =
            error_set(error, "%s: found %d numbers, expected the 16 of a 4 x 4 matrix", r.name, n);
    if (got == 0) {
        memcpy(matrix->m, value, sizeof matrix->m);
        got = check_transform(r.name, matrix, error);
    }
    reader_close(&r);
    return got;
}
