/*
 * nurbs_text - NURBS surfaces as plain text, cloudmill-nurbs(5).
 */
#ifndef CLOUDMILL_NURBS_TEXT_H
#define CLOUDMILL_NURBS_TEXT_H

#include "nurbs/patch.h"
#include "base/reader.h"

/* Appends all surfaces of the text, in mm; `mm` > 0 takes the place of the text's own unit.  The
 * reader stands at its start. */
int nurbs_text_read(struct reader *r, double mm, struct patches *patches, struct error *error);

#endif
