/* machine_read - machine files; see machine.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "base/array.h"
#include "machine/keys.h"
#include "machine/machine.h"
#include "base/reader.h"
#include "base/program_dir.h"

#ifndef CLOUDMILL_DATADIR
#define CLOUDMILL_DATADIR "/usr/local/share/cloudmill"
#endif

enum { INCLUDES_MAX = 8, FILE_MAX = 1024 };

static bool is_file(const char *name)
{
    return name[strcspn(name, "/.")] != '\0';
}

static bool is_folder(const char *file)
{
    struct stat status;
    return stat(file, &status) == 0 && S_ISDIR(status.st_mode);
}

/* Where the machine called `name` is; `beside` is the file that includes it, or NULL. */
static int find_file(const char *name, const char *beside, char file[FILE_MAX], struct error *error)
{
    const char *slash = beside ? strrchr(beside, '/') : NULL;
    int folder = slash && *name != '/' ? (int)(slash - beside + 1) : 0;
    const char *own = getenv("CLOUDMILL_MACHINES");
    if (is_file(name)) {
        int n = snprintf(file, FILE_MAX, "%.*s%s", folder, folder ? beside : "", name);
        if (n >= FILE_MAX)
            return error_set(error, "%.40s...: file name too long", name);
        return 0;
    }
    char self[FILE_MAX], beside_installed[FILE_MAX + 32], beside_built[FILE_MAX + 32];
    program_dir(self, sizeof self);
    snprintf(beside_installed, sizeof beside_installed, "%s/../share/cloudmill/machines", self);
    snprintf(beside_built, sizeof beside_built, "%s/../../machines", self);
    const char *const places[] = {".", own && *own ? own : ".", beside_installed, beside_built,
                                  CLOUDMILL_DATADIR "/machines"};
    int n = snprintf(file, FILE_MAX, "%.*s%s.txt", folder, folder ? beside : "", name);
    for (size_t i = 0; i < sizeof places / sizeof *places; i++) {
        if (n < FILE_MAX && access(file, R_OK) == 0)
            return 0;
        n = snprintf(file, FILE_MAX, "%s/%s.txt", places[i], name);
    }
    if (n < FILE_MAX && access(file, R_OK) == 0)
        return 0;
    return error_set(error,
                     "machine %.100s: not found in this folder, in $CLOUDMILL_MACHINES or in %s",
                     name, CLOUDMILL_DATADIR "/machines");
}

static int read_file(struct machine *m, const char *file, int depth, struct error *error);

/* `include = NAME` in the line: 1 and it was read, 0: another line, -1: error. */
static int read_include(struct machine *m, char *line, const struct reader *r, int depth,
                        struct error *error)
{
    char file[FILE_MAX];
    size_t n = strcspn(line, " \t=");
    if (n != 7 || strncmp(line, "include", n) != 0)
        return 0;
    char *name = keys_trim(line + n);
    if (*name != '=')
        return 0;
    name = keys_trim(name + 1);
    if (!*name)
        return error_at(error, r->name, r->line, "found no name, expected include = NAME");
    if (depth + 1 >= INCLUDES_MAX)
        return error_at(error, r->name, r->line,
                        "found include within include %d deep, expected no file to include itself",
                        INCLUDES_MAX);
    struct error inner;
    if (find_file(name, r->name, file, &inner) != 0)
        return error_at(error, r->name, r->line, "include: %.300s", inner.text);
    if (access(file, R_OK) != 0)
        return error_at(error, r->name, r->line, "include: cannot open %.200s", name);
    if (is_folder(file))
        return error_at(error, r->name, r->line,
                        "include: found the folder %.200s, expected a file", name);
    if (read_file(m, file, depth + 1, &inner) != 0)
        return *error = inner, -1;
    return 1;
}

static int read_line(struct machine *m, struct keys *keys, char *line, size_t n,
                     const struct reader *r, int depth, struct error *error)
{
    for (size_t i = 0; i < n; i++)
        if (((unsigned char)line[i] < ' ' && !strchr("\t\r\f", line[i])) || !line[i])
            return error_at(error, r->name, r->line,
                            "found a binary character (code %d), expected key = value",
                            (unsigned char)line[i]);
    char *text = keys_trim(line);
    if (!*text)
        return 0;
    int included = read_include(m, text, r, depth, error);
    if (included)
        return included < 0 ? -1 : 0;
    return keys_set(keys, text, r->name, r->line, error);
}

/* What the keys say together; the place is that of the key to blame or, where it stands in another
 * file, of the last key that has to do with the axes. */
static int check_together(const struct machine *m, const struct keys *keys, const char *name,
                          struct error *error)
{
    static const char *const others[] = {"type", "axes", "axis.A", "axis.B", "axis.C"};
    struct machine trial = *m;
    struct error found;
    char blamed[KEY_NAME];
    if (machine_assemble(&trial, blamed, &found) == 0)
        return 0;
    size_t line = keys_find(keys, blamed)->line, n = strlen(blamed);
    if (n == 5 && strcmp(blamed + 1, ".max") == 0) { /* or that axis's min, the later of both */
        memcpy(blamed + 2, "min", 4);
        size_t min = keys_find(keys, blamed)->line;
        line = min > line ? min : line;
    } else if (strncmp(blamed, "ax", 2) == 0) {
        for (size_t i = 0; i < sizeof others / sizeof *others; i++) {
            size_t other = keys_find(keys, others[i])->line;
            line = line == 0 || (strcmp(blamed, "axes") == 0 && other > line) ? other : line;
        }
    }
    return error_at(error, name, line, "%s", found.text);
}

static int read_file(struct machine *m, const char *file, int depth, struct error *error)
{
    struct reader r;
    if (reader_open(&r, file, error) != 0)
        return -1;
    struct keys keys = machine_keys(m);
    char *line;
    size_t n;
    int got, result = 0;
    while (result == 0 && (got = reader_line(&r, &line, &n, error)) != 0)
        result = got < 0 ? -1 : read_line(m, &keys, line, n, &r, depth, error);
    if (result == 0 && depth == 0)
        result = check_together(m, &keys, r.name, error);
    array_free(&keys);
    reader_close(&r);
    return result;
}

int machine_read(struct machine *machine, const char *name, struct error *error)
{
    char file[FILE_MAX];
    if (find_file(name, NULL, file, error) != 0)
        return -1;
    return read_file(machine, file, 0, error);
}
