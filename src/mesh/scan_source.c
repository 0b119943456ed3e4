/* scan_source - see scan_source.h. */
#include "mesh/scan_source.h"

#include <stdlib.h>
#include <string.h>

#include "base/array.h"

static uint64_t mix(uint64_t hash, double x)
{
    const uint64_t prime = 0xd6e8feb86659fd93, spread = 0x9e3779b97f4a7c15;
    double plain = x + 0.0; /* -0 becomes 0 */
    uint64_t bits;

    memcpy(&bits, &plain, sizeof bits);
    hash = (hash ^ bits * spread) * prime;
    return hash ^ hash >> 31;
}

uint64_t scan_source_hash(const struct vec3 *point, size_t n)
{
    const uint64_t basis = 0xcbf29ce484222325;
    uint64_t sum = basis * n;

    for (size_t i = 0; i < n; i++) {
        uint64_t hash = mix(mix(mix(basis, point[i].x), point[i].y), point[i].z);
        sum += hash * hash + hash; /* no sum of coordinates is left in the sum */
    }
    return sum;
}

void scan_sources_add(struct scan_sources *scan, const char *name, const struct vec3 *point,
                      size_t n)
{
    scan_sources_add_known(scan, name, n, scan_source_hash(point, n));
}

void scan_sources_add_known(struct scan_sources *scan, const char *name, size_t points,
                            uint64_t hash)
{
    *array_push(scan) = (struct scan_source){mem_string(name, strlen(name)), points, hash};
}

bool scan_sources_read(struct scan_sources *scan, const char *text, char separator)
{
    struct scan_source s;
    char *end;

    if (*text < '0' || *text > '9')
        return false;
    s.points = strtoull(text, &end, 10);
    if (*end != separator || strspn(end + 1, "0123456789abcdefABCDEF") != 16)
        return false;
    s.hash = strtoull(end + 1, &end, 16);
    if (*end != separator || !end[1])
        return false;
    s.name = mem_string(end + 1, strlen(end + 1));
    *array_push(scan) = s;
    return true;
}

struct scan_sources scan_sources_copy(const struct scan_sources *scan)
{
    struct scan_sources copy = {.placed = scan->placed, .place = scan->place};

    for (size_t i = 0; i < scan->n; i++) {
        struct scan_source *to = array_push(&copy);
        *to = scan->item[i];
        to->name = mem_string(to->name, strlen(to->name));
    }
    return copy;
}

void scan_sources_free(struct scan_sources *scan)
{
    for (size_t i = 0; i < scan->n; i++)
        free(scan->item[i].name);
    array_free(scan);
}
