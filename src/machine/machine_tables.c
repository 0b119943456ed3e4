/* machine_tables - see machine_tables.h. */
#include "machine_tables.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

#include "math/elementary.h"
#include "base/num.h"
#include "base/reader.h"

enum { MOST_NUMBER = 1000000000 /* one more than a tool's number may be */ };

/* ---- tools */

const struct machine_tool *machine_tool(const struct machine *machine, int number)
{
    for (size_t i = 0; i < machine->tools; i++)
        if (machine->tool[i].number == number)
            return &machine->tool[i];
    return NULL;
}

bool machine_has_lengths(const struct machine *machine)
{
    for (size_t i = 0; i < machine->tools; i++)
        if (!isnan(machine->tool[i].length))
            return true;
    return false;
}

/* The tool of that number, a new one where there is none; NULL: no room. */
static struct machine_tool *find_tool(struct machine *m, int number)
{
    for (size_t i = 0; i < m->tools; i++)
        if (m->tool[i].number == number)
            return &m->tool[i];
    if (m->tools == MACHINE_TOOLS)
        return NULL;
    m->tool[m->tools] = (struct machine_tool){.number = number, .length = NAN};
    return &m->tool[m->tools++];
}

static int set_length(struct machine_tool *tool, const char *value, const char *name, size_t line,
                      struct error *error)
{
    if (num_whole(value, &tool->length) && tool->length >= 0 && tool->length <= 1e4)
        return 0;
    return error_at(error, name, line, "found `%.40s` as a tool's length, expected 0 to 10000 mm",
                    value);
}

static int set_tool_name(struct machine_tool *tool, const char *value, const char *name,
                         size_t line, struct error *error)
{
    if (strlen(value) < sizeof tool->name && !strpbrk(value, "\"()")) {
        snprintf(tool->name, sizeof tool->name, "%s", value);
        return 0;
    }
    return error_at(error, name, line,
                    "found `%.40s` as a tool's name, expected fewer than %zu characters, no quotes "
                    "and brackets",
                    value, sizeof tool->name);
}

/* ---- a table of tools */

/* A tool's number from a table: whole, and as large as one in a key may be. */
static bool take_number(double value, int *number)
{
    bool good = value >= 0 && value < MOST_NUMBER && value == floor(value);
    *number = good ? (int)value : -1;
    return good;
}

/* A line of LinuxCNC's table: T1 P1 Z120.5 D10 */
static int read_linuxcnc_line(const char *s, int *number, double *length)
{
    double value;
    *number = -1;
    *length = NAN;
    for (; *s; s += strspn(s, " \t")) {
        char letter = (char)toupper((unsigned char)*s++);
        if (!isalpha((unsigned char)letter) || !num_read(&s, &value))
            return -1;
        if (letter == 'T' && !take_number(value, number))
            return -1;
        if (letter == 'Z')
            *length = value;
    }
    return *number >= 0 ? 0 : -1;
}

static int read_tool_line(struct machine *m, char *text, const char *file, size_t line,
                          struct error *error)
{
    text += strspn(text, " \t");
    text[strcspn(text, "#\r")] = '\0';
    char *note = strchr(text, ';');
    double value, length = NAN;
    int number = -1;
    const char *s = text, *tool_name = "";
    if (note) {
        *note++ = '\0';
        tool_name = note + strspn(note, " \t");
    }
    if (!*text)
        return 0;
    bool good = true;
    if (toupper((unsigned char)*text) == 'T') {
        good = read_linuxcnc_line(text, &number, &length) == 0;
    } else {
        good = num_read(&s, &value) && take_number(value, &number);
        s += strspn(s, " \t");
        good = good && num_read(&s, &length);
        s += strspn(s, " \t");
        tool_name = good && *s ? s : tool_name;
    }
    struct machine_tool *tool = good ? find_tool(m, number) : NULL;
    if (!good || !(isnan(length) || (length >= 0 && length <= 1e4)))
        return error_at(error, file, line, "found `%.40s`, expected a tool's number and length",
                        text);
    if (!tool)
        return error_at(error, file, line, "found more than %d tools, expected no more",
                        MACHINE_TOOLS);
    if (!isnan(length))
        tool->length = length;
    char trimmed[80];
    snprintf(trimmed, sizeof trimmed, "%.79s", tool_name);
    size_t n = strlen(trimmed);
    while (n && strchr(" \t", trimmed[n - 1]))
        trimmed[--n] = '\0';
    return n ? set_tool_name(tool, trimmed, file, line, error) : 0;
}

/* The file is beside the machine file that names it. */
static int read_tools(struct machine *m, const char *value, const char *beside, struct error *error)
{
    char file[1024];
    const char *slash = *value == '/' ? NULL : strrchr(beside, '/');
    snprintf(file, sizeof file, "%.*s%s", slash ? (int)(slash - beside + 1) : 0, beside, value);
    struct reader r;
    if (reader_open(&r, file, error) != 0)
        return -1;
    char *line;
    size_t n;
    int got, result = 0;
    while (result == 0 && (got = reader_line(&r, &line, &n, error)) != 0)
        result = got < 0 ? -1 : read_tool_line(m, line, r.name, r.line, error);
    if (result == 0 && m->tools == 0)
        result = error_at(error, r.name, 0, "found no tool, expected lines of number and length");
    reader_close(&r);
    return result;
}

/* ---- keys with numbers */

/* The whole number at *s, behind which this character or the end stands. */
static bool read_count(const char **s, int *number)
{
    long n = 0;
    const char *p = *s;
    while (isdigit((unsigned char)*p) && n < MOST_NUMBER / 10)
        n = 10 * n + (*p++ - '0');
    if (p == *s)
        return false;
    *s = p;
    *number = (int)n;
    return true;
}

static int set_offset(struct machine *m, int n, const char *value, const char *name, size_t line,
                      struct error *error)
{
    if (n < 1 || n > MACHINE_OFFSETS || strlen(value) >= sizeof m->tool_offset[0])
        return error_at(error, name, line,
                        "found offset.%d = %.40s, expected offset.1 to offset.%d and a short word",
                        n, value, MACHINE_OFFSETS);
    snprintf(m->tool_offset[n - 1], sizeof m->tool_offset[0], "%s", value);
    return 0;
}

static int set_aux(struct machine *m, int n, const char *value, const char *name, size_t line,
                   struct error *error)
{
    for (size_t i = 0; i < MACHINE_AUX; i++)
        if (m->aux[i].number == n || !*m->aux[i].blocks) {
            if (strlen(value) >= sizeof m->aux[i].blocks)
                break;
            m->aux[i].number = n;
            snprintf(m->aux[i].blocks, sizeof m->aux[i].blocks, "%s", value);
            return 0;
        }
    return error_at(error, name, line, "found aux.%d = %.40s, expected up to %d short blocks", n,
                    value, MACHINE_AUX);
}

/* Sets the numbered key, whose value is not empty. */
static int set_numbered(struct machine *m, const char *key, const char *value, const char *name,
                        size_t line, struct error *error)
{
    const char *s = strchr(key, '.');
    int n;
    if (strcmp(key, "tools") == 0)
        return read_tools(m, value, name, error);
    if (!s || (s++, !read_count(&s, &n)))
        return 1;
    if (strncmp(key, "offset.", 7) == 0 && !*s)
        return set_offset(m, n, value, name, line, error);
    if (strncmp(key, "aux.", 4) == 0 && !*s)
        return set_aux(m, n, value, name, line, error);
    bool length = strcmp(s, ".length") == 0;
    if (strncmp(key, "tool.", 5) != 0 || (!length && strcmp(s, ".name") != 0))
        return 1;
    struct machine_tool *tool = find_tool(m, n);
    if (!tool)
        return error_at(error, name, line, "found more than %d tools, expected no more",
                        MACHINE_TOOLS);
    return length ? set_length(tool, value, name, line, error)
                  : set_tool_name(tool, value, name, line, error);
}

int machine_tables_set(struct machine *machine, const char *text, const char *name, size_t line,
                       struct error *error)
{
    char key[60], value[1000];
    size_t n = strcspn(text, "=");
    const char *from = text + strspn(text, " \t"), *to = text + n;
    if (!*to)
        return 1;
    while (to > from && strchr(" \t", to[-1]))
        to--;
    snprintf(key, sizeof key, "%.*s", (int)(to - from), from);
    const char *said = text + n + 1 + strspn(text + n + 1, " \t");
    snprintf(value, sizeof value, "%s", said);
    n = strlen(value);
    while (n && strchr(" \t\r", value[n - 1]))
        value[--n] = '\0';
    if (!*value)
        return 1;
    return set_numbered(machine, key, value, name, line, error);
}
