/* template - see template.h. */
#include "machine/template.h"

#include <stdlib.h>
#include <string.h>

static const char *const words[TEMPLATE_NONE] = {
    [TEMPLATE_TOOL] = "tool",
    [TEMPLATE_OFFSET] = "offset",
    [TEMPLATE_RPM] = "rpm",
    [TEMPLATE_NEXT] = "tool.next",
    [TEMPLATE_TOLERANCE] = "tolerance",
    [TEMPLATE_ORIENTATION] = "orientation",
    [TEMPLATE_LEVEL] = "level",
    [TEMPLATE_A] = "a",
    [TEMPLATE_B] = "b",
    [TEMPLATE_I] = "i",
    [TEMPLATE_J] = "j",
    [TEMPLATE_K] = "k",
    [TEMPLATE_SPA] = "spa",
    [TEMPLATE_SPB] = "spb",
    [TEMPLATE_PROGRAM] = "program",
    [TEMPLATE_NAME] = "name",
    [TEMPLATE_WORK] = "work",
    [TEMPLATE_SECONDS] = "seconds",
    [TEMPLATE_LENGTH_Z] = "length.off.z",
    [TEMPLATE_HASH] = "hash",
    [TEMPLATE_N] = "n",
    [TEMPLATE_TEXT] = "text",
    [TEMPLATE_LINE] = "line",
    [TEMPLATE_RAPID] = "rapid",
    [TEMPLATE_X] = "X",
    [TEMPLATE_Y] = "Y",
    [TEMPLATE_Z] = "Z",
    [TEMPLATE_X_ABOVE] = "X.above",
    [TEMPLATE_Y_ABOVE] = "Y.above",
    [TEMPLATE_ROTARY_START] = "rotary.start",
    [TEMPLATE_ROTARY] = "rotary",
    [TEMPLATE_AXIS] = "axis",
    [TEMPLATE_ROTARY_ZERO] = "rotary.zero",
    [TEMPLATE_HEAD] = "head",
    [TEMPLATE_HOME] = "home",
    [TEMPLATE_SAFE] = "safe",
    [TEMPLATE_START] = "start",
    [TEMPLATE_END] = "end",
    [TEMPLATE_TOOL_CHANGE] = "tool.change",
    [TEMPLATE_TCP_ON] = "tcp.on",
    [TEMPLATE_TCP_OFF] = "tcp.off",
    [TEMPLATE_PLANE_ON] = "plane.on",
    [TEMPLATE_PLANE_OFF] = "plane.off",
    [TEMPLATE_SMOOTH_ON] = "smooth.on",
    [TEMPLATE_SMOOTH_OFF] = "smooth.off",
    [TEMPLATE_SPINDLE] = "spindle",
    [TEMPLATE_COOLANT] = "coolant",
    [TEMPLATE_SPINDLE_ON] = "spindle.on",
    [TEMPLATE_SPINDLE_OFF] = "spindle.off",
    [TEMPLATE_COOLANT_OFF] = "coolant.off",
    [TEMPLATE_STOP_OPTIONAL] = "stop.optional",
    [TEMPLATE_NO_TOOL] = "no.tool",
    [TEMPLATE_CLAMP_ON] = "clamp.on",
    [TEMPLATE_CLAMP_OFF] = "clamp.off",
};

static const char *const conditions[WHEN_NONE] = {
    [WHEN_MM] = "mm",
    [WHEN_INCH] = "inch",
    [WHEN_TCP] = "tcp",
    [WHEN_ZERO] = "zero",
    [WHEN_HAS_TCP] = "has.tcp",
    [WHEN_OFF_HOME] = "off.home",
    [WHEN_OFF_ALONE] = "off.alone",
    [WHEN_OFF_Z] = "off.z",
    [WHEN_ROTARY] = "rotary",
    [WHEN_VECTORS] = "vectors",
    [WHEN_AXES] = "axes",
    [WHEN_TURNED] = "turned",
    [WHEN_PLANE] = "plane",
    [WHEN_SMOOTH] = "smooth",
    [WHEN_TOOL] = "tool",
    [WHEN_CALLED] = "called",
    [WHEN_RPM] = "rpm",
    [WHEN_CCW] = "ccw",
    [WHEN_CUTCOM] = "cutcom",
    [WHEN_INVERSE] = "inverse",
    [WHEN_G17] = "g17",
    [WHEN_NAMED] = "named",
    [WHEN_SPLINES] = "splines",
    [WHEN_CURVES] = "curves",
    [WHEN_NEXT] = "next",
    [WHEN_STOP] = "stop",
    [WHEN_WORK] = "other.work",
};

/* The name among n: its number, n: none. */
static int find_name(const char *const names[], int n, const char *name, size_t length)
{
    int i = 0;
    while (i < n && (strlen(names[i]) != length || strncmp(names[i], name, length) != 0))
        i++;
    return i;
}

bool template_field(const char *text, struct template_field *field)
{
    *field = (struct template_field){.word = TEMPLATE_NONE, .condition = WHEN_NONE};
    size_t end = strcspn(text, "}");
    if (*text != '{' || !text[end])
        return false;
    const char *name = text + 1;
    bool condition = *name == '?';
    name += condition;
    field->negated = condition && *name == '!';
    name += field->negated;
    size_t length = (size_t)(text + end - name), bare = strcspn(name, ":}");
    field->length = end + 1;
    if (condition) {
        field->condition = (enum template_condition)find_name(conditions, WHEN_NONE, name, length);
        return field->condition != WHEN_NONE;
    }
    if (bare < length) {
        size_t digits = strspn(name + bare + 1, "0123456789");
        if (bare + 1 + digits != length || digits == 0 || digits > 2)
            return false;
        field->width = (int)strtol(name + bare + 1, NULL, 10);
        if (field->width < 1 || field->width > TEMPLATE_WIDTH_MAX)
            return false;
    }
    field->word = (enum template_word)find_name(words, TEMPLATE_NONE, name, bare);
    return field->word != TEMPLATE_NONE && (field->width == 0 || field->word <= TEMPLATE_TEXT);
}

static bool may_stand(enum template_word word, enum template_place place)
{
    switch (place) {
    case TEMPLATE_IN_NUMBER:
        return word == TEMPLATE_N;
    case TEMPLATE_IN_COMMENT:
        return word == TEMPLATE_TEXT;
    case TEMPLATE_IN_KEY:
        return word < TEMPLATE_N;
    case TEMPLATE_IN_SECTION:
        break;
    }
    return word != TEMPLATE_N && word != TEMPLATE_TEXT;
}

/* What is found where a brace opens no field that may stand there. */
static int no_field(const char *text, enum template_place place, struct error *error)
{
    static const char *const expected[] = {
        [TEMPLATE_IN_KEY] =
            "{tool}, {offset}, {rpm}, {tolerance}, {orientation}, {level}, {a}, "
            "{b}, {i}, {j}, {k}, {program}, {name}, {work}, {hash}, {seconds} or a condition "
            "{?...}",
        [TEMPLATE_IN_SECTION] = "a field of cloudmill-control(5)",
        [TEMPLATE_IN_NUMBER] = "{n}",
        [TEMPLATE_IN_COMMENT] = "{text}"};
    size_t n = strcspn(text, "}"), width = strcspn(text, ":");
    if (!text[n] || memchr(text + 1, '{', n - 1))
        return error_set(error, "found `%.20s`, expected } after it", text);
    if (width < n)
        return error_set(error, "found `%.*s`, expected a value with a width of 1 to %d",
                         n < 30 ? (int)n + 1 : 30, text, TEMPLATE_WIDTH_MAX);
    return error_set(error, "found `%.*s`, expected %s", n < 30 ? (int)n + 1 : 30, text,
                     expected[place]);
}

int template_check(const char *text, enum template_place place, struct error *error)
{
    struct template_field field;
    bool words_before = false;
    enum template_word alone = TEMPLATE_NONE;
    for (const char *s = text; *s; s += field.length) {
        if (alone != TEMPLATE_NONE && *s != ' ')
            return error_set(error, "found `%.20s` after {%s}, expected that alone in its line", s,
                             words[alone]);
        field.length = 1;
        if (*s != '{') {
            words_before = words_before || (*s != ' ' && place == TEMPLATE_IN_SECTION);
            continue;
        }
        if (!template_field(s, &field))
            return no_field(s, place, error);
        if (field.condition != WHEN_NONE) {
            if (place == TEMPLATE_IN_NUMBER || place == TEMPLATE_IN_COMMENT)
                return no_field(s, place, error);
            continue;
        }
        if (!may_stand(field.word, place))
            return no_field(s, place, error);
        if (field.word >= TEMPLATE_FIRST_BLOCK) {
            if (words_before && field.word < TEMPLATE_FIRST_KEY)
                return error_set(error,
                                 "found `%.20s` before {%s}, expected that alone in its line", text,
                                 words[field.word]);
            alone = field.word;
        }
        words_before = words_before || field.word != TEMPLATE_LINE;
    }
    if ((place == TEMPLATE_IN_NUMBER || place == TEMPLATE_IN_COMMENT) && !words_before)
        return error_set(error, "found `%.30s`, expected %s in it", text,
                         place == TEMPLATE_IN_NUMBER ? "{n}" : "{text}");
    return 0;
}
