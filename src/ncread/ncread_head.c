/* ncread_head - see ncread_head.h. */
#include "ncread_head.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/num.h"
#include "base/reader.h"

/* Takes the number at *s; 0 where there is none. */
static double number_at(const char **s)
{
    double value;
    *s += strspn(*s, " ");
    return num_read(s, &value) && value > 0 ? value : 0;
}

/* The next word of the text, at most size - 1 of its characters. */
static const char *next_word(const char *s, char *word, size_t size)
{
    s += strspn(s, " ");
    size_t n = strcspn(s, " )");
    size_t kept = n < size ? n : size - 1;
    memcpy(word, s, kept);
    word[kept] = '\0';
    return s + n;
}

/* The words of a tool so far: all of them again, for a word may go on in the next line. */
static void read_tool(struct ncread_head *head)
{
    char word[NCREAD_HEAD_TEXT];
    const char *s = head->tool;
    head->ball = head->flute = 0;
    head->flute_given = false;
    *head->holder = '\0';
    for (s = next_word(s, word, sizeof word); *word; s = next_word(s, word, sizeof word)) {
        const char *value = word + 1;
        if (*word == 'R' && isdigit((unsigned char)word[1])) {
            head->ball = number_at(&value);
        } else if (strcmp(word, "FLUTE") == 0) {
            head->flute = number_at(&s);
            head->flute_given = true;
        } else if (strcmp(word, "HOLDER") == 0) {
            s = next_word(s, head->holder, sizeof head->holder);
        } else if (strcmp(word, "CUTTER") == 0) {
            return; /* no ball */
        }
    }
}

/* More of the tool; a line was ended before a blank, which it lacks, or within a word. */
static void add_tool(struct ncread_head *head, const char *text)
{
    size_t n = strlen(head->tool), more = strcspn(text, ")");
    bool letters =
        n > 0 && (isupper((unsigned char)head->tool[n - 1]) || isupper((unsigned char)*text));
    if (n + letters + more + 1 > sizeof head->tool)
        return;
    if (letters)
        head->tool[n++] = ' ';
    memcpy(head->tool + n, text, more);
    head->tool[n + more] = '\0';
    read_tool(head);
}

/* True if the comment begins with the key; *s then stands behind it. */
static bool has_key(const char **s, const char *key)
{
    size_t n = strlen(key);
    if (strncmp(*s, key, n) != 0)
        return false;
    *s += n + strspn(*s + n, " ");
    return true;
}

/* The same in letters of any case. */
static bool has_word(const char **s, const char *word)
{
    const char *p = *s;
    for (; *word; word++, p++)
        if (tolower((unsigned char)*p) != tolower((unsigned char)*word))
            return false;
    *s = p + strspn(p, " ");
    return true;
}

/* What is left of a comment, without blanks around it. */
static void read_name(char *to, size_t size, const char *s)
{
    s += strspn(s, " ");
    size_t n = strcspn(s, ")\r\n");
    while (n > 0 && s[n - 1] == ' ')
        n--;
    n = n < size ? n : size - 1;
    memcpy(to, s, n);
    to[n] = '\0';
}

/* The same after what is there, which ended before a blank. */
static void add_name(char *to, size_t size, const char *s)
{
    size_t n = strlen(to);
    if (n == 0 || n + 2 > size)
        return;
    to[n] = ' ';
    read_name(to + n + 1, size - n - 1, s);
}

/* A row of the placing: four numbers. */
static void read_place(struct ncread_head *head, int row, const char *s)
{
    if (head->place_rows == 0)
        head->place = transform_identity();
    for (int k = 0; k < 4; k++) {
        s += strspn(s, " ");
        if (!num_read(&s, &head->place.m[row][k]) || !isfinite(head->place.m[row][k]))
            return;
    }
    head->place_rows |= 1 << row;
}

/* A file of the scan: how many points, and their hash. */
static void read_scan(struct ncread_head *head, const char *s)
{
    if (head->scans == NCREAD_SCANS)
        return;
    head->scan_points[head->scans] = number_at(&s);
    head->scan_hash[head->scans++] = *s == ',' ? strtoull(s + 1, NULL, 16) : 0;
}

/* The way at rapid, which stands behind that at feed. */
static void read_way(struct ncread_head *head, const char *s)
{
    number_at(&s);
    head->rapid = has_word(&s, " mm, rapid ") ? number_at(&s) : 0;
}

static void read_noise(struct ncread_head *head, const char *s)
{
    double noise;
    head->noise_given = num_read(&s, &noise) && noise >= 0 && isfinite(noise);
    head->noise = head->noise_given ? noise : 0;
}

/* Tool 3: ball nose D 8 R 4 */
static void read_number(struct ncread_head *head, const char *s)
{
    char *end;
    long number = strtol(s, &end, 10);

    s = end + 1;
    if (end[0] != ':' || number < 0 || number > 99999999)
        return;
    s += strspn(s, " ");
    if (!has_word(&s, "ball nose D ") && !has_word(&s, "cutter D "))
        return;
    if (head->numbers++ == 0)
        head->number = (int)number;
}

/* More of the region; a line was ended before a blank. */
static void add_region(struct ncread_head *head, const char *text)
{
    size_t n = strlen(head->region), more = strcspn(text, ")\r\n");

    if (n + more + 2 > sizeof head->region) /* so that it is no region */
        snprintf(head->region, sizeof head->region, "too long");
    else
        snprintf(head->region + n, sizeof head->region - n, " %.*s", (int)more, text);
}

/* n numbers at *s, which moves on. */
static bool take_numbers(const char **s, int n, double *value)
{
    const char *p = *s;

    for (int i = 0; i < n; i++) {
        p += strspn(p, " ");
        if (!num_read(&p, &value[i]) || !isfinite(value[i]))
            return false;
    }
    *s = p + strspn(p, " ");
    return true;
}

bool ncread_head_region(const struct ncread_head *head, struct region *region)
{
    const char *s = head->region + strspn(head->region, " ");
    double v[6];
    bool good = *s != '\0';

    while (good && *s) {
        if (has_key(&s, "BORDER ")) {
            good = take_numbers(&s, 1, &region->border);
        } else if (has_key(&s, "BOX ")) {
            good = region->boxed = take_numbers(&s, 6, v);
            region->box = (struct box){vec(v[0], v[1], v[2]), vec(v[3], v[4], v[5])};
        } else if (has_key(&s, "POLYGON ")) {
            *array_push(&region->polygons.from) = (int)region->polygons.corner.n;
            while (take_numbers(&s, 2, v))
                *array_push(&region->polygons.corner) = vec(v[0], v[1], 0);
        } else {
            good = false;
        }
    }
    if (!good)
        region_polygons_free(&region->polygons);
    if (!good)
        *region = (struct region){0};
    return good && region_given(region);
}

void ncread_head_line(struct ncread_head *head, const char *line)
{
    const char *s = line + strcspn(line, "(;");
    if (!*s)
        return;
    s += 1 + strspn(s + 1, " ");
    if (has_key(&s, "TOOL: ")) {
        *head->tool = '\0';
        add_tool(head, s);
    } else if (has_key(&s, "TOOL+: ")) {
        add_tool(head, s);
    } else if (has_key(&s, "REGION: ")) {
        *head->region = '\0';
        add_region(head, s);
    } else if (has_key(&s, "REGION+: ")) {
        add_region(head, s);
    } else if (has_key(&s, "CONTROL: ")) {
        read_name(head->control_file, sizeof head->control_file, s);
    } else if (has_key(&s, "MACHINE: ")) {
        read_name(head->machine_file, sizeof head->machine_file, s);
    } else if (has_key(&s, "NOISE: ")) {
        read_noise(head, s);
    } else if (has_key(&s, "SCAN: ")) {
        read_scan(head, s);
    } else if (has_key(&s, "PLACE1: ")) {
        read_place(head, 0, s);
    } else if (has_key(&s, "PLACE2: ")) {
        read_place(head, 1, s);
    } else if (has_key(&s, "PLACE3: ")) {
        read_place(head, 2, s);
    } else if (has_key(&s, "SET: ")) {
        read_name(head->set, sizeof head->set, s);
    } else if (has_key(&s, "SET+: ")) {
        add_name(head->set, sizeof head->set, s);
    } else if (has_key(&s, "AMID: ")) {
        head->asked = (has_word(&s, "SPEEDS") ? NC_ASKED_SPEEDS : 0u) |
                      (has_word(&s, "SKIPS") ? NC_ASKED_SKIPS : 0u);
    } else if (has_key(&s, "COOLANT: NONE")) {
        head->dry = true;
    } else if (has_key(&s, "SPINDLE: CCLW")) {
        head->anticlockwise = true;
    } else if (has_key(&s, "FEED: CONTACT")) {
        head->contact_feed = true;
    } else if (has_key(&s, "*** ATTENTION: X Y Z ARE THE CENTRE OF THE BALL")) {
        head->centre = true;
    } else if (has_word(&s, "UNMET:")) {
        if (head->unmet++ == 0)
            read_name(head->unmet_first, sizeof head->unmet_first, s);
    } else if (has_word(&s, "UNMET+:")) {
        if (head->unmet == 1)
            add_name(head->unmet_first, sizeof head->unmet_first, s);
    } else if (has_word(&s, "cloudmill ncpost")) {
        head->numbered = true;
        s += strcspn(s, ",");
        if (*s)
            read_name(head->machine, sizeof head->machine, s + 1);
    } else if (head->numbered && has_word(&s, "Tool ") && isdigit((unsigned char)*s)) {
        read_number(head, s);
    } else if (head->numbered && has_word(&s, "Cut ")) {
        read_way(head, s);
    } else if (head->numbered && (has_word(&s, "Part ") || has_word(&s, "From pass "))) {
        head->of_whole = true;
    } else if (has_word(&s, "Tolerance ncpost")) {
        head->post = number_at(&s);
    } else if (has_word(&s, "Tolerance smoothing")) {
        head->smoothing = number_at(&s);
    } else if (has_word(&s, "Tolerance cloud2mesh")) {
        head->mesh = number_at(&s);
    } else if (has_word(&s, "Tolerance sum")) {
        s += strcspn(s, ",");
        if (has_word(&s, ", axis"))
            head->axis = number_at(&s);
    } else {
        if (has_key(&s, "SCALLOP: "))
            head->scallop = number_at(&s);
        s += strspn(s, " ");
        if (has_key(&s, "TOLERANCE: "))
            head->tolerance = number_at(&s);
    }
}

int ncread_head_of(const char *file, struct ncread_head *head, struct error *error)
{
    enum { LINES = 1000 };
    struct reader r;
    char *line;
    size_t n;
    int more = 0;
    if (reader_open(&r, file, error) < 0)
        return -1;
    for (int i = 0; i < LINES && (more = reader_line(&r, &line, &n, error)) > 0; i++)
        ncread_head_line(head, line);
    reader_close(&r);
    return more < 0 ? -1 : 0;
}
