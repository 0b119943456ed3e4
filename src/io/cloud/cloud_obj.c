/* cloud_obj - see cloud_obj.h. */
#include "cloud_obj.h"

#include <string.h>

static const char *const keyword[] = {
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
    for (size_t i = 0; i < sizeof keyword / sizeof *keyword; i++)
        if (strlen(keyword[i]) == length && memcmp(line, keyword[i], length) == 0)
            return length < n || strcmp(keyword[i], "end") == 0;
    return false;
}

int cloud_obj_read(struct cloud_source *s, struct error *error)
{
    const struct cloud_options style = {.parting = ' ', .point = '.', .column = {0, 1, 2}};
    bool continued = false; /* the line before ended in a backslash */
    char *line;
    size_t n;
    int got;
    while ((got = cloud_line(s, &line, &n, error)) > 0) {
        size_t indent = strspn(line, " \t");
        bool passed_over = continued;
        continued = n > 0 && line[n - 1] == '\\';
        if (passed_over || indent == n)
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
