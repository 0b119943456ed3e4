/*
 * iges_trim - what trims a surface of an IGES file: entities 142, 141 and 508, and what
 * bounds a plane, 108.
 */
#ifndef CLOUDMILL_IGES_TRIM_H
#define CLOUDMILL_IGES_TRIM_H

#include "iges.h"
#include "nurbs/patch.h"
#include "math/transform.h"

/* Where the loops come from, and how those in space are placed: first `outer`, then to mm. */
struct iges_trimming {
    const struct iges *iges;
    double mm;
    struct transform outer;
    bool space; /* curves in space first, whatever the file prefers */
};

/*
 * Appends the loop of an entity 142, 141, 508 or 108 (form 1) to the patch: its curves in the
 * parameters, or those in space where the file prefers them or has no others.  One with curves that
 * are not read is counted in patch->ignored.  Where a 142 has both, and those in space are taken,
 * the others go to patch->told as the file has them.
 */
int iges_trim(const struct iges_trimming *trimming, struct patch *patch,
              const struct iges_entity *entity, struct error *error);

#endif
