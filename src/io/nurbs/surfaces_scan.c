/* surfaces_scan - see surfaces_scan.h. */
#include "io/nurbs/surfaces_scan.h"

#include <inttypes.h>
#include "math/elementary.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/array.h"
#include "base/num.h"

static const char scan_word[] = "cloudmill scan ", place_word[] = "cloudmill place ";

char *surfaces_scan_text(const struct scan_sources *scan)
{
    enum { NUMBERS = 64, ONE_NUMBER = 40 };
    size_t room = sizeof place_word + 16 * ONE_NUMBER, n = 0;
    for (size_t i = 0; i < scan->n; i++)
        room += sizeof scan_word + NUMBERS + strlen(scan->item[i].name);
    char *text = mem_alloc(room, 1);
    for (size_t i = 0; i < scan->n; i++) {
        const struct scan_source *s = &scan->item[i];
        n += (size_t)snprintf(text + n, room - n, "%s%" PRIu64 " %016" PRIx64 " %s", scan_word,
                              s->points, s->hash, s->name);
        for (size_t k = n - strlen(s->name); k < n; k++)
            if ((unsigned char)text[k] < ' ')
                text[k] = '?';
        text[n++] = '\n';
    }
    if (scan->n > 0 && scan->placed) {
        n += (size_t)snprintf(text + n, room - n, "%s", place_word);
        for (int i = 0; i < 16; i++)
            n += (size_t)snprintf(text + n, room - n, "%s%.17g", i > 0 ? " " : "",
                                  scan->place.m[i / 4][i % 4]);
        text[n++] = '\n';
    }
    text[n] = '\0';
    return text;
}

static bool read_place(const char *text, struct scan_sources *scan)
{
    struct transform place = {0};
    for (int i = 0; i < 16; i++) {
        double *to = &place.m[i / 4][i % 4];
        text += strspn(text, " ");
        if (!num_read(&text, to) || !isfinite(*to))
            return false;
    }
    scan->placed = true;
    scan->place = place;
    return true;
}

bool surfaces_scan_line(const char *line, struct scan_sources *scan)
{
    size_t n = strlen(scan_word), m = strlen(place_word);
    if (strncmp(line, scan_word, n) == 0)
        return scan_sources_read(scan, line + n, ' ');
    return strncmp(line, place_word, m) == 0 && read_place(line + m, scan);
}
