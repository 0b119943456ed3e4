/* cloud_pcd - see cloud_pcd.h. */
#include "cloud_pcd.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"

enum { FIELDS_MAX = 64 };

struct pcd {
    char axis[FIELDS_MAX];  /* 'x', 'y' or 'z' for the fields of that name, else 0 */
    int counts[FIELDS_MAX]; /* how many columns a field has */
    int fields;
    double points; /* how many the head says, -1: it does not */
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

static int read_counts(struct cloud_source *s, struct pcd *pcd, char *rest, struct error *error)
{
    double value;
    for (int i = 0; i < pcd->fields; i++) {
        char *word = next_word(&rest);
        if (!word || !num_whole(word, &value) || !(value >= 1 && value <= 1e6))
            return cloud_error(s, error, "COUNT with '%.40s', expected a number for each field",
                               word ? word : "");
        pcd->counts[i] = (int)value;
    }
    return 0;
}

/* One line of the head; 1 when it is DATA, the last. */
static int read_statement(struct cloud_source *s, struct pcd *pcd, char *line, struct error *error)
{
    char *rest = line, *word = next_word(&rest);
    if (!word || *word == '#' || strcmp(word, "VERSION") == 0 || strcmp(word, "SIZE") == 0 ||
        strcmp(word, "TYPE") == 0 || strcmp(word, "WIDTH") == 0 || strcmp(word, "HEIGHT") == 0 ||
        strcmp(word, "VIEWPOINT") == 0)
        return 0;
    if (strcmp(word, "FIELDS") == 0 || strcmp(word, "COLUMNS") == 0)
        return read_fields(s, pcd, rest, error);
    if (strcmp(word, "COUNT") == 0)
        return read_counts(s, pcd, rest, error);
    if (strcmp(word, "POINTS") == 0)
        return num_whole(rest, &pcd->points) && pcd->points >= 0
                   ? 0
                   : cloud_error(s, error, "POINTS '%.40s', expected a number", rest);
    if (strcmp(word, "DATA") != 0)
        return cloud_error(s, error, "'%.40s' in a PCD head, expected FIELDS, POINTS, DATA", word);
    word = next_word(&rest);
    if (!word || strcmp(word, "ascii") != 0)
        return cloud_error(s, error, "PCD with DATA %.40s, expected DATA ascii", word ? word : "");
    return 1;
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

static int read_head(struct cloud_source *s, struct pcd *pcd, struct error *error)
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
    return got < 0 ? -1 : cloud_error(s, error, "the file ends in a PCD head, expected DATA ascii");
}

int cloud_pcd_read(struct cloud_source *s, struct error *error)
{
    struct pcd pcd = {.points = -1};
    struct cloud_options style = {.parting = ' ', .point = '.'};
    if (read_head(s, &pcd, error) < 0 || find_columns(s, &pcd, &style, error) < 0)
        return -1;
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
