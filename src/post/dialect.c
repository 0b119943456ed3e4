/* dialect - see dialect.h. */
#include "dialect.h"

#define ROW(name, title, tcp_of_machine, dc) extern const struct dialect dialect_##name;
CONTROL_TABLE(ROW)
#undef ROW

#define ROW(name, title, tcp_of_machine, dc) &dialect_##name,
static const struct dialect *const table[] = {CONTROL_TABLE(ROW)};
#undef ROW

const struct dialect *dialect_of(enum control_id control)
{
    return table[control];
}

static int given_or_usual(int digits, int usual)
{
    return digits < 0 ? usual : digits;
}

struct nc_ability dialect_ability(enum control_id control, const struct machine *machine,
                                  enum post_axis_words axis, bool still, double unit)
{
    const struct dialect *dialect = dialect_of(control);
    int finer = unit > 1; /* an inch is 25.4 mm: a digit more */
    bool vectors = axis == POST_AXIS_USUAL ? dialect->vectors : axis == POST_AXIS_VECTORS;
    const struct machine_digits *own = &machine->digits, *usual = &dialect->digits;
    struct nc_ability ability = {
        .mode = INTERPOLATE_JOINT,
        .digits = {given_or_usual(own->linear, usual->linear + finer),
                   given_or_usual(own->angle, usual->angle),
                   given_or_usual(own->vector, usual->vector),
                   given_or_usual(own->knot, usual->knot),
                   given_or_usual(own->feed, usual->feed + 2 * finer)},
        .radius_error = 0.005 / unit,
        .unit = unit,
        .feed_max = machine->feed_max,
    };
    bool tcp = machine_has_tcp(machine, control);
    still = still || machine->chain.n == 0;
    ability.tcp = tcp && !still;
    if (tcp || still) {
        vectors = vectors && ability.tcp;
        ability.mode = vectors ? INTERPOLATE_VECTOR : INTERPOLATE_ROTARY;
        ability.doubtful = vectors && dialect->vectors_doubtful;
        bool arcs = machine->arcs && (machine->arcs_tcp || !ability.tcp);
        if (arcs)
            ability.arcs = vectors ? dialect->arcs_vectors : dialect->arcs;
        if (arcs && machine->arcs_space && dialect->arcs_space && !vectors)
            ability.arcs = dialect->arcs_space;
        if (machine->splines)
            ability.splines = vectors ? dialect->splines_vectors : dialect->splines;
    } else if (machine->feeds == FEEDS_COMBINED || dialect->inverse_never) {
        ability.feeds = NC_FEEDS_COMBINED;
    } else {
        ability.feeds = NC_FEEDS_INVERSE;
        ability.digits.feed = given_or_usual(own->feed, 3); /* 1/min: small numbers count */
    }
    return ability;
}
