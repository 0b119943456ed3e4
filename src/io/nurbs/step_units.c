/* step_units - see step_units.h. */
#include "step_units.h"

#include <stdlib.h>

#include "base/array.h"
#include "step_assembly.h"

/* Metres or radians in an SI_UNIT with its prefix; 0: none that there is. */
static double si_factor(const struct step_value *unit)
{
    static const struct {
        const char *name;
        double factor;
    } prefix[] = {{"EXA", 1e18},  {"PETA", 1e15},  {"TERA", 1e12},  {"GIGA", 1e9},
                  {"MEGA", 1e6},  {"KILO", 1e3},   {"HECTO", 100},  {"DECA", 10},
                  {"DECI", 0.1},  {"CENTI", 0.01}, {"MILLI", 1e-3}, {"MICRO", 1e-6},
                  {"NANO", 1e-9}, {"PICO", 1e-12}, {"FEMTO", 1e-15}};
    for (size_t i = 0; i < sizeof prefix / sizeof *prefix; i++)
        if (step_is(step_item(unit, 0), prefix[i].name))
            return prefix[i].factor;
    return step_item(unit, 0) && step_item(unit, 0)->kind == STEP_ENUM ? 0 : 1;
}

/* A unit of length is one of metres, one of an angle of radians. */
static int check_si(const struct step *step, const struct step_values *v,
                    const struct step_value *si, struct error *error)
{
    const char *name = step_record(v, "LENGTH_UNIT")        ? "METRE"
                       : step_record(v, "PLANE_ANGLE_UNIT") ? "RADIAN"
                                                            : NULL;
    if (!name || (step_is(step_item(si, 1), name) && si_factor(si) > 0))
        return 0;
    return error_at(error, step->name, v->instance->line,
                    "#%ld: a unit of neither prefix nor name that there is, expected some of .%s.",
                    v->instance->id, name);
}

/* The factor of a unit to metres or radians; a unit by conversion is some of another one. */
static int unit_factor(const struct step *step, const struct step_values *v, int depth,
                       double *factor, struct error *error)
{
    const struct step_value *si = step_record(v, "SI_UNIT");
    const struct step_value *converted = step_record(v, "CONVERSION_BASED_UNIT");
    struct step_values measure, unit;
    *factor = si ? si_factor(si) : 1;
    if (si)
        return check_si(step, v, si, error);
    if (!converted || depth > 4)
        return 0;
    if (step_follow(step, v, step_item(converted, 1), &measure, error) < 0)
        return -1;
    const struct step_value *with = step_item(measure.item, 0);
    for (const struct step_value *r = with; r; r = step_next(measure.item, r))
        with = step_item(r, 1) ? r : with; /* the one that holds value and unit */
    const struct step_value *value = step_item(with, 0);
    value = value && value->kind == STEP_RECORD ? step_item(value, 0) : value;
    int status = step_follow(step, &measure, step_item(with, 1), &unit, error);
    if (status == 0) {
        status = unit_factor(step, &unit, depth + 1, factor, error);
        if (value && value->kind == STEP_NUMBER && value->number > 0)
            *factor *= value->number;
        array_free(&unit);
    }
    array_free(&measure);
    return status;
}

int step_units(const struct step *step, double given, const struct step_values *from,
               const struct step_value *context, double *mm, double *angle, struct error *error)
{
    struct step_values v, unit;
    *mm = given > 0 ? given : 1;
    *angle = 1;
    if (step_reference(context) == 0)
        return 0;
    if (step_follow(step, from, context, &v, error) < 0)
        return -1;
    const struct step_value *list = step_item(step_record(&v, "GLOBAL_UNIT_ASSIGNED_CONTEXT"), 0);
    int status = 0;
    for (const struct step_value *i = step_item(list, 0); i && status == 0;
         i = step_next(list, i)) {
        double factor;
        status = step_follow(step, &v, i, &unit, error);
        if (status < 0)
            break;
        status = unit_factor(step, &unit, 0, &factor, error);
        if (step_record(&unit, "LENGTH_UNIT"))
            *mm = 1000 * factor;
        if (step_record(&unit, "PLANE_ANGLE_UNIT"))
            *angle = factor;
        array_free(&unit);
    }
    array_free(&v);
    if (given > 0)
        *mm = given;
    return status;
}
