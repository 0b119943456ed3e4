/* cloud_formats - the point formats of other programs: OBJ, PTX, PCD; see cloud_source.h. */
#include <stdlib.h>
#include <string.h>

#include "math/elementary.h"
#include "base/array.h"
#include "base/bytes.h"
#include "base/num.h"
#include "cloud_source.h"

static const char *const obj_keyword[] = {
    "v",         "vt",    "vn",    "vp",     "f",        "l",        "p",    "o",
    "g",         "s",     "mg",    "usemtl", "mtllib",   "cstype",   "deg",  "bmat",
    "step",      "curv",  "curv2", "surf",   "parm",     "trim",     "hole", "scrv",
    "sp",        "end",   "con",   "bevel",  "c_interp", "d_interp", "lod",  "shadow_obj",
    "trace_obj", "ctech", "stech", "maplib", "usemap",   "call",     "csh",
};

bool cloud_obj_statement(const char *line, size_t n)
{
    size_t length = 0;
    while (length < n && line[length] != ' ' && line[length] != '\t')
        length++;
    for (size_t i = 0; i < sizeof obj_keyword / sizeof *obj_keyword; i++)
        if (strlen(obj_keyword[i]) == length && memcmp(line, obj_keyword[i], length) == 0)
            return length < n || strcmp(obj_keyword[i], "end") == 0;
    return false;
}

int cloud_obj_read(struct cloud_source *s, struct error *error)
{
    const struct cloud_options style = {.delimiter = ' ', .point = '.', .column = {0, 1, 2}};
    bool continued = false; /* the line before ended in a backslash */
    char *line;
    size_t n;
    int got;
    while ((got = cloud_line(s, &line, &n, error)) > 0) {
        size_t indent = strspn(line, " \t");
        bool is_continuation = continued;
        continued = n > 0 && line[n - 1] == '\\';
        if (is_continuation || indent == n)
            continue;
        if (line[indent] == '#') {
            s->count->comments++;
            continue;
        }
        if (!cloud_obj_statement(line + indent, n - indent))
            return cloud_error(s, error, "'%.40s', expected a statement of an OBJ file",
                               line + indent);
        if (line[indent] != 'v' || (line[indent + 1] != ' ' && line[indent + 1] != '\t'))
            continue;
        struct cloud_row row = cloud_row_read(&style, line + indent + 2, n - indent - 2);
        if (cloud_take(s, &row, error) < 0)
            return -1;
    }
    return got;
}

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

/* The head after the number of columns. */
static int read_ptx_head(struct cloud_source *s, double *rows, double matrix[4][4],
                         struct error *error)
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

static struct vec3 place_point(struct vec3 p, double m[4][4])
{
    return vec(p.x * m[0][0] + p.y * m[1][0] + p.z * m[2][0] + m[3][0],
               p.x * m[0][1] + p.y * m[1][1] + p.z * m[2][1] + m[3][1],
               p.x * m[0][2] + p.y * m[1][2] + p.z * m[2][2] + m[3][2]);
}

static int read_cells(struct cloud_source *s, size_t cells, double matrix[4][4],
                      struct error *error)
{
    const struct cloud_options style = {.delimiter = ' ', .point = '.', .column = {0, 1, 2}};
    for (size_t i = 0; i < cells; i++) {
        char *line;
        size_t n;
        int got = cloud_line(s, &line, &n, error);
        if (got < 0)
            return -1;
        if (got == 0)
            return error_at(error, s->reader->name, 0,
                            "ends after %zu cells of a PTX grid, "
                            "expected %zu",
                            i, cells);
        struct cloud_row row = cloud_row_read(&style, line, n);
        if (row.kind == CLOUD_POINT && row.p.x == 0 && row.p.y == 0 && row.p.z == 0) {
            s->count->not_measured++;
            continue;
        }
        row.p = place_point(row.p, matrix);
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
    double columns = 0, rows = 0, matrix[4][4];
    int got;
    while ((got = read_numbers(s, 1, &columns, error)) > 0) {
        if (read_ptx_head(s, &rows, matrix, error) < 0)
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

enum { FIELDS_MAX = 64 };

struct pcd {
    char axis[FIELDS_MAX];  /* 'x', 'y' or 'z' for the fields of that name, else 0 */
    int counts[FIELDS_MAX]; /* how many columns a field has */
    int sizes[FIELDS_MAX];  /* bytes of each, where the data are binary; 0: not said */
    char types[FIELDS_MAX]; /* F, I or U */
    int fields;
    double points; /* how many the head says, -1: it does not */
    bool binary;
};

/* The word at *s, cut off in place, or NULL. */
static char *next_word(char **s)
{
    char *word = *s + strspn(*s, " \t");
    if (!*word)
        return NULL;
    *s = word + strcspn(word, " \t");
    if (**s)
        *(*s)++ = '\0';
    return word;
}

static int read_fields(struct cloud_source *s, struct pcd *pcd, char *rest, struct error *error)
{
    for (char *word; (word = next_word(&rest));) {
        if (pcd->fields == FIELDS_MAX)
            return cloud_error(s, error, "more than %d fields, expected fewer", FIELDS_MAX);
        bool axis = strchr("xyz", *word) && word[1] == '\0';
        pcd->counts[pcd->fields] = 1;
        pcd->axis[pcd->fields++] = axis ? *word : '\0';
    }
    return 0;
}

/* A whole number up to `most` for each field, after the statement `name`. */
static int read_counts(struct cloud_source *s, const struct pcd *pcd, const char *name, double most,
                       char *rest, int *counts, struct error *error)
{
    double value;
    for (int i = 0; i < pcd->fields; i++) {
        char *word = next_word(&rest);
        if (!word || !num_whole(word, &value) || !(value >= 1 && value <= most))
            return cloud_error(s, error, "%s with '%.40s', expected a number for each field", name,
                               word ? word : "");
        counts[i] = (int)value;
    }
    return 0;
}

static int read_types(struct cloud_source *s, struct pcd *pcd, char *rest, struct error *error)
{
    for (int i = 0; i < pcd->fields; i++) {
        char *word = next_word(&rest);
        if (!word || !strchr("FIU", *word) || word[1] != '\0')
            return cloud_error(s, error, "TYPE with '%.40s', expected F, I or U for each field",
                               word ? word : "");
        pcd->types[i] = *word;
    }
    return 0;
}

static int read_data(struct cloud_source *s, struct pcd *pcd, char *rest, struct error *error)
{
    const char *word = next_word(&rest);
    if (word && strcmp(word, "binary_compressed") == 0)
        return cloud_error(s, error,
                           "PCD with DATA binary_compressed, expected ascii or binary: convert it "
                           "first, as by `pcl_convert_pcd_ascii_binary IN.pcd OUT.pcd 1`");
    pcd->binary = word && strcmp(word, "binary") == 0;
    if (!word || (!pcd->binary && strcmp(word, "ascii") != 0))
        return cloud_error(s, error, "PCD with DATA %.40s, expected DATA ascii or binary",
                           word ? word : "");
    return 1;
}

/* One line of the head; 1 when it is DATA, the last. */
static int read_statement(struct cloud_source *s, struct pcd *pcd, char *line, struct error *error)
{
    char *rest = line, *word = next_word(&rest);
    if (!word || *word == '#' || strcmp(word, "VERSION") == 0 || strcmp(word, "WIDTH") == 0 ||
        strcmp(word, "HEIGHT") == 0 || strcmp(word, "VIEWPOINT") == 0)
        return 0;
    if (strcmp(word, "FIELDS") == 0 || strcmp(word, "COLUMNS") == 0)
        return read_fields(s, pcd, rest, error);
    if (strcmp(word, "COUNT") == 0)
        return read_counts(s, pcd, word, 1e6, rest, pcd->counts, error);
    if (strcmp(word, "SIZE") == 0)
        return read_counts(s, pcd, word, 8, rest, pcd->sizes, error);
    if (strcmp(word, "TYPE") == 0)
        return read_types(s, pcd, rest, error);
    if (strcmp(word, "POINTS") == 0)
        return num_whole(rest, &pcd->points) && pcd->points >= 0
                   ? 0
                   : cloud_error(s, error, "POINTS '%.40s', expected a number", rest);
    if (strcmp(word, "DATA") != 0)
        return cloud_error(s, error, "'%.40s' in a PCD head, expected FIELDS, POINTS, DATA", word);
    return read_data(s, pcd, rest, error);
}

/* Which columns are x, y and z. */
static int find_columns(struct cloud_source *s, const struct pcd *pcd, struct cloud_options *style,
                        struct error *error)
{
    for (int axis = 0; axis < 3; axis++) {
        size_t column = 0;
        int i = 0;
        while (i < pcd->fields && pcd->axis[i] != "xyz"[axis])
            column += (size_t)pcd->counts[i++];
        if (i == pcd->fields)
            return cloud_error(s, error, "a PCD file without field %c, expected x y z",
                               "xyz"[axis]);
        style->column[axis] = column;
    }
    return 0;
}

static int read_pcd_head(struct cloud_source *s, struct pcd *pcd, struct error *error)
{
    char *line;
    size_t n;
    int got;
    while ((got = cloud_line(s, &line, &n, error)) > 0) {
        s->count->heads++;
        int last = read_statement(s, pcd, line, error);
        if (last)
            return last < 0 ? -1 : 0;
    }
    return got < 0 ? -1 : cloud_error(s, error, "the file ends in a PCD head, expected DATA");
}

/* Where a record of a binary PCD has x, y and z, and how long it is. */
struct record {
    size_t at[3], size[3], length;
};

static int find_bytes(struct cloud_source *s, const struct pcd *pcd, struct record *record,
                      struct error *error)
{
    *record = (struct record){0};
    if (pcd->points < 0)
        return cloud_error(s, error, "a binary PCD file without POINTS, expected their number");
    for (int i = 0; i < pcd->fields; i++) {
        size_t size = (size_t)pcd->sizes[i];
        if (size == 0 || !pcd->types[i])
            return cloud_error(s, error, "a binary PCD file without %s, expected it",
                               size == 0 ? "SIZE" : "TYPE");
        if (pcd->axis[i]) {
            if (pcd->types[i] != 'F' || (size != 4 && size != 8))
                return cloud_error(s, error, "field %c of type %c %zu, expected F 4 or F 8",
                                   pcd->axis[i], pcd->types[i], size);
            record->at[pcd->axis[i] - 'x'] = record->length;
            record->size[pcd->axis[i] - 'x'] = size;
        }
        record->length += size * (size_t)pcd->counts[i];
    }
    return 0;
}

static double number_at(const struct record *record, const char *bytes, int axis)
{
    const char *p = bytes + record->at[axis];
    return record->size[axis] == 4 ? bytes_float(p) : bytes_double(p);
}

static int read_records(struct cloud_source *s, const struct pcd *pcd, struct error *error)
{
    struct record record;
    if (find_bytes(s, pcd, &record, error) < 0)
        return -1;
    char *bytes = mem_alloc(record.length, 1);
    double rows = 0;
    long got = (long)record.length;
    while (rows < pcd->points && got == (long)record.length) {
        got = reader_bytes(s->reader, bytes, record.length, error);
        if (got < (long)record.length)
            break;
        cloud_take_point(s, vec(number_at(&record, bytes, 0), number_at(&record, bytes, 1),
                                number_at(&record, bytes, 2)));
        rows++;
    }
    free(bytes);
    s->count->columns = 3;
    if (got >= 0 && rows < pcd->points)
        return error_at(error, s->reader->name, 0, "%.0f points, expected the %.0f of its PCD head",
                        rows, pcd->points);
    return got < 0 ? -1 : 0;
}

int cloud_pcd_read(struct cloud_source *s, struct error *error)
{
    struct pcd pcd = {.points = -1};
    struct cloud_options style = {.delimiter = ' ', .point = '.'};
    if (read_pcd_head(s, &pcd, error) < 0 || find_columns(s, &pcd, &style, error) < 0)
        return -1;
    if (pcd.binary)
        return read_records(s, &pcd, error);
    char *line;
    size_t n, rows = 0;
    int got;
    while ((got = cloud_line(s, &line, &n, error)) > 0) {
        struct cloud_row row = cloud_row_read(&style, line, n);
        if (row.kind == CLOUD_EMPTY || row.kind == CLOUD_COMMENT)
            continue;
        if (cloud_take(s, &row, error) < 0)
            return -1;
        rows++;
    }
    if (got == 0 && pcd.points >= 0 && (double)rows != pcd.points)
        return error_at(error, s->reader->name, 0, "%zu points, expected the %.0f of its PCD head",
                        rows, pcd.points);
    return got;
}
