/*
 * iges_files - a file of IGES entities in mm, put together column by column, for unit tests of what
 * reads its entities.
 */
#ifndef CLOUDMILL_TEST_IGES_FILES_H
#define CLOUDMILL_TEST_IGES_FILES_H

#include <check.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/nurbs/iges.h"
#include "nurbs/patch.h"
#include "scratch.h"

static struct {
    char directory[16000], parameter[32000];
    size_t d, p;
    int entities, lines;
} iges_file;

/* The file as it was read, the patch that was made of an entity, and what went wrong: of the test
 * that runs, from iges_file_begin() to iges_file_end(). */
static struct iges iges;
static struct patch patch;
static struct error error;

static inline void iges_file_end(void)
{
    iges_free(&iges);
    patch_free(&patch);
    iges = (struct iges){0};
    patch = (struct patch){0};
    error = (struct error){0};
}

static inline void iges_file_begin(void)
{
    memset(&iges_file, 0, sizeof iges_file);
}

/* An entity; returns the number of its directory entry, 1, 3, 5 ...  dependent: it belongs to
 * another one. */
static inline int iges_file_add(int type, int form, int matrix, bool dependent, const char *values)
{
    int number = 2 * iges_file.entities++ + 1, first = iges_file.lines + 1;
    for (const char *v = values; *v; v += strlen(v) < 64 ? strlen(v) : 64)
        iges_file.p += (size_t)sprintf(iges_file.parameter + iges_file.p, "%-64.64s%8dP%7d\n", v,
                                       number, ++iges_file.lines);
    iges_file.d +=
        (size_t)sprintf(iges_file.directory + iges_file.d,
                        "%8d%8d%8d%8d%8d%8d%8d%8d%8sD%7d\n%8d%8d%8d%8d%8d%16s%8s%8dD%7d\n", type,
                        first, 0, 0, 0, 0, matrix, 0, dependent ? "00010000" : "00000000", number,
                        type, 0, 0, iges_file.lines - first + 1, form, "", "", 0, number + 1);
    ck_assert_uint_lt(iges_file.p, sizeof iges_file.parameter);
    ck_assert_uint_lt(iges_file.d, sizeof iges_file.directory);
    return number;
}

/* An entity whose numbers a format of printf has. */
static inline int iges_file_format(int type, int form, int matrix, bool dependent,
                                   const char *format, ...)
{
    char text[200];
    va_list values;
    va_start(values, format);
    vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return iges_file_add(type, form, matrix, dependent, text);
}

/* Reads the file. */
static inline void iges_file_read(void)
{
    static const char global[] = "1H,,1H;,4Hpart,4Hfile,4Hmake,1H1,32,38,6,308,15,4Hpart,1.,2,2HMM"
                                 ",1,0.01,13H261121.101010,1E-6,200.,,,11,0;";
    static char text[60000];
    struct reader r;
    size_t n = (size_t)sprintf(text, "%-72sS%7d\n", "", 1);
    int globals = 0;
    for (const char *g = global; *g; g += strlen(g) < 72 ? strlen(g) : 72)
        n += (size_t)sprintf(text + n, "%-72.72sG%7d\n", g, ++globals);
    sprintf(text + n, "%s%sS%7dG%7dD%7dP%7d%40sT%7d\n", iges_file.directory, iges_file.parameter, 1,
            globals, 2 * iges_file.entities, iges_file.lines, "", 1);
    ck_assert_int_eq(reader_open(&r, scratch_text(text), &error), 0);
    ck_assert_msg(iges_read(&r, &iges, &error) == 0, "%s", error.text);
    reader_close(&r);
}

#endif
