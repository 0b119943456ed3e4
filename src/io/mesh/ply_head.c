/* ply_head - see ply_head.h. */
#include "ply_head.h"

#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "ply_origin.h"

enum { WORDS = 6 };

/* Cuts a line into its words in place; those beyond WORDS stay in the last one. */
static int split(char *line, char *word[WORDS])
{
    int n = 0;
    for (char *p = line; n < WORDS; n++) {
        p += strspn(p, " \t");
        if (!*p)
            break;
        word[n] = p;
        p += strcspn(p, " \t");
        if (*p && n + 1 < WORDS)
            *p++ = '\0';
    }
    return n;
}

static bool type_read(const char *word, enum ply_type *type)
{
    static const char *const name[][2] = {
        [PLY_INT8] = {"char", "int8"},        [PLY_UINT8] = {"uchar", "uint8"},
        [PLY_INT16] = {"short", "int16"},     [PLY_UINT16] = {"ushort", "uint16"},
        [PLY_INT32] = {"int", "int32"},       [PLY_UINT32] = {"uint", "uint32"},
        [PLY_FLOAT32] = {"float", "float32"}, [PLY_FLOAT64] = {"double", "float64"},
    };
    for (int i = PLY_INT8; i <= PLY_FLOAT64; i++)
        if (strcmp(word, name[i][0]) == 0 || strcmp(word, name[i][1]) == 0) {
            *type = (enum ply_type)i;
            return true;
        }
    return false;
}

/* A count of rows: digits alone, and no more than memory could ever hold. */
static bool count_read(const char *word, size_t *count)
{
    size_t value = 0;
    if (!*word)
        return false;
    for (const char *p = word; *p; p++) {
        if (*p < '0' || *p > '9' || value > LLONG_MAX / 100)
            return false;
        value = value * 10 + (size_t)(*p - '0');
    }
    *count = value;
    return true;
}

static int read_format(struct ply_head *head, int n, char *word[], const struct reader *r,
                       struct error *error)
{
    static const char *const name[] = {
        [PLY_ASCII] = "ascii",
        [PLY_LITTLE_ENDIAN] = "binary_little_endian",
        [PLY_BIG_ENDIAN] = "binary_big_endian",
    };
    for (int i = PLY_ASCII; n >= 2 && i <= PLY_BIG_ENDIAN; i++)
        if (strcmp(word[1], name[i]) == 0) {
            head->format = (enum ply_format)i;
            return 0;
        }
    return error_at(error, r->name, r->line,
                    "PLY format '%.40s', expected ascii, binary_little_endian or binary_big_endian",
                    n >= 2 ? word[1] : "");
}

static int read_element(struct ply_head *head, int n, char *word[], const struct reader *r,
                        struct error *error)
{
    size_t count;
    if (n != 3 || !count_read(word[2], &count))
        return error_at(error, r->name, r->line,
                        "PLY element with the count '%.40s', expected a name and how many there "
                        "are",
                        n >= 3 ? word[2] : "");
    if (ply_head_element(head, word[1]))
        return error_at(error, r->name, r->line, "element %.40s a second time, expected it once",
                        word[1]);
    struct ply_element *e = array_push(&head->element);
    *e = (struct ply_element){.count = count};
    snprintf(e->name, sizeof e->name, "%s", word[1]);
    return 0;
}

static int read_property(struct ply_head *head, int n, char *word[], const struct reader *r,
                         struct error *error)
{
    if (head->element.n == 0)
        return error_at(error, r->name, r->line, "a property, expected an element first");
    struct ply_property p = {.list = n >= 2 && strcmp(word[1], "list") == 0};
    if (n != (p.list ? 5 : 3))
        return error_at(error, r->name, r->line,
                        "a property of %d words, expected its type and its name", n - 1);
    if (p.list && !type_read(word[2], &p.length_type))
        return error_at(error, r->name, r->line, "unknown type '%.40s', expected uchar, int, ...",
                        word[2]);
    if (!type_read(word[n - 2], &p.type))
        return error_at(error, r->name, r->line,
                        "property of unknown type '%.40s', expected float, double, int, ...",
                        word[n - 2]);
    snprintf(p.name, sizeof p.name, "%s", word[n - 1]);
    *array_push(&head->element.item[head->element.n - 1].property) = p;
    return 0;
}

/* A comment line's text goes to the origin, which gives no place to its errors. */
static int read_comment(struct mesh_origin *origin, const char *text, const struct reader *r,
                        struct error *error)
{
    struct error what;
    if (ply_origin_read(origin, text + strspn(text, " \t"), &what) < 0)
        return error_at(error, r->name, r->line, "%s", what.text);
    return 0;
}

/* One line of the head; 1 when it was the last. */
static int read_statement(struct ply_head *head, char *line, struct mesh_origin *origin,
                          bool *has_format, const struct reader *r, struct error *error)
{
    char *word[WORDS];
    if (strncmp(line, "comment", 7) == 0 && (line[7] == ' ' || line[7] == '\t' || !line[7]))
        return read_comment(origin, line + 7, r, error);
    int n = split(line, word);
    if (n == 0 || strcmp(word[0], "obj_info") == 0)
        return 0;
    if (strcmp(word[0], "end_header") == 0)
        return *has_format ? 1 : error_at(error, r->name, r->line, "no format in the PLY head");
    if (strcmp(word[0], "format") == 0) {
        *has_format = true;
        return read_format(head, n, word, r, error);
    }
    if (strcmp(word[0], "element") == 0)
        return read_element(head, n, word, r, error);
    if (strcmp(word[0], "property") == 0)
        return read_property(head, n, word, r, error);
    return error_at(error, r->name, r->line,
                    "'%.40s' in the PLY head, expected element, property or end_header", word[0]);
}

int ply_head_read(struct reader *r, struct ply_head *head, struct mesh_origin *origin,
                  struct error *error)
{
    char *line;
    size_t n;
    memset(head, 0, sizeof *head);
    int got = reader_line(r, &line, &n, error);
    if (got < 0)
        return -1;
    if (got == 0)
        return error_at(error, r->name, 0, "is empty, expected a PLY file");
    if (n < 3 || memcmp(line, "ply", 3) != 0 || line[3 + strspn(line + 3, " \t")] != '\0')
        return error_at(error, r->name, r->line, "no PLY file, expected the line 'ply' first");

    bool has_format = false;
    while ((got = reader_line(r, &line, &n, error)) > 0) {
        int done = read_statement(head, line, origin, &has_format, r, error);
        if (done)
            return done < 0 ? -1 : 0;
    }
    return got < 0 ? -1
                   : error_at(error, r->name, r->line,
                              "the file ends in its PLY head, expected "
                              "end_header");
}

void ply_head_free(struct ply_head *head)
{
    for (size_t i = 0; i < head->element.n; i++)
        array_free(&head->element.item[i].property);
    array_free(&head->element);
}

const struct ply_element *ply_head_element(const struct ply_head *head, const char *name)
{
    for (size_t i = 0; i < head->element.n; i++)
        if (strcmp(head->element.item[i].name, name) == 0)
            return &head->element.item[i];
    return NULL;
}

int ply_element_property(const struct ply_element *element, const char *name)
{
    for (size_t i = 0; i < element->property.n; i++) {
        const struct ply_property *p = &element->property.item[i];
        if (!p->list && strcmp(p->name, name) == 0)
            return (int)i;
    }
    return -1;
}
