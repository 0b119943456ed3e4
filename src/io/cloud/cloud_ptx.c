/* cloud_ptx - see cloud_ptx.h. */
#include "cloud_ptx.h"

#include <math.h>
#include <string.h>

#include "base/num.h"

enum { PLACE_LINES = 4, MATRIX_LINES = 4 };

/* The next line that is not empty as `want` numbers and nothing else: 1; 0 at the end; -1. */
static int read_numbers(struct cloud_source *s, int want, double *value, struct error *error)
{
    char *line;
    size_t n;
    int got;
    do
        got = cloud_line(s, &line, &n, error);
    while (got > 0 && line[strspn(line, " \t")] == '\0');
    if (got <= 0)
        return got;
    const char *p = line;
    for (int i = 0; i < want; i++) {
        p += strspn(p, " \t");
        if (!num_read(&p, &value[i]) || !isfinite(value[i]) || !strchr(" \t", *p))
            return cloud_error(s, error, "a line of a PTX head, expected %d numbers", want);
    }
    if (p[strspn(p, " \t")] != '\0')
        return cloud_error(s, error, "a line of a PTX head, expected only %d number%s", want,
                           want == 1 ? "" : "s");
    return 1;
}

static int ends_in_head(const struct cloud_source *s, struct error *error)
{
    return cloud_error(s, error, "the file ends in a PTX head, expected its matrix and its cells");
}

/* The head behind the number of columns. */
static int read_head(struct cloud_source *s, double *rows, double matrix[4][4], struct error *error)
{
    double place[3];
    int got = read_numbers(s, 1, rows, error);
    for (int i = 0; i < PLACE_LINES && got > 0; i++)
        got = read_numbers(s, 3, place, error);
    for (int i = 0; i < MATRIX_LINES && got > 0; i++)
        got = read_numbers(s, 4, matrix[i], error);
    if (got <= 0)
        return got < 0 ? -1 : ends_in_head(s, error);
    for (int i = 0; i < MATRIX_LINES; i++)
        if (matrix[i][3] != (i == 3))
            return cloud_error(s, error,
                               "a PTX matrix whose last column holds %g, expected 0 0 0 1",
                               matrix[i][3]);
    return 0;
}

static struct vec3 placed(struct vec3 p, double m[4][4])
{
    return vec(p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
               p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
               p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]);
}

static int read_cells(struct cloud_source *s, size_t cells, double matrix[4][4],
                      struct error *error)
{
    const struct cloud_options style = {.parting = ' ', .point = '.', .column = {0, 1, 2}};
    for (size_t i = 0; i < cells; i++) {
        char *line;
        size_t n;
        int got = cloud_line(s, &line, &n, error);
        if (got < 0)
            return -1;
        if (got == 0)
            return error_at(error, s->reader->name, 0,
                            "ends behind %zu cells of a PTX grid, "
                            "expected %zu",
                            i, cells);
        struct cloud_row row = cloud_row_read(&style, line, n);
        if (row.kind == CLOUD_POINT && row.p.x == 0 && row.p.y == 0 && row.p.z == 0) {
            s->count->not_measured++;
            continue;
        }
        row.p = placed(row.p, matrix);
        if (cloud_take(s, &row, error) < 0)
            return -1;
    }
    return 0;
}

static bool is_count(double x)
{
    return x >= 1 && x <= 1e9 && x == floor(x);
}

int cloud_ptx_read(struct cloud_source *s, struct error *error)
{
    double columns, rows, matrix[4][4];
    int got;
    while ((got = read_numbers(s, 1, &columns, error)) > 0) {
        if (read_head(s, &rows, matrix, error) < 0)
            return -1;
        if (!is_count(columns) || !is_count(rows))
            return cloud_error(s, error, "a PTX grid of %g x %g cells, expected whole numbers",
                               columns, rows);
        s->count->heads += 2 + PLACE_LINES + MATRIX_LINES;
        if (read_cells(s, (size_t)columns * (size_t)rows, matrix, error) < 0)
            return -1;
    }
    return got;
}
