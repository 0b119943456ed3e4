/* verify_finding - see verify_finding.h. */
#include "verify_finding.h"

#include <stdarg.h>
#include <stdio.h>

#include "base/array.h"
#include "ncread/ncread.h"

void finding_add(struct verdict *v, bool fault, size_t piece, const char *format, ...)
{
    struct finding *finding = array_push(&v->finding);
    char place[60], what[FINDING_TEXT - 64];
    va_list arguments;
    ncread_place(&v->program.motion->piece.item[piece], place, sizeof place);
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    finding->fault = fault;
    snprintf(finding->text, sizeof finding->text, "%s: %s", place, what);
}

void finding_remark(struct verdict *v, bool fault, const char *format, ...)
{
    struct finding *finding = array_push(&v->finding);
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(finding->text, sizeof finding->text, format, arguments);
    va_end(arguments);
    finding->fault = fault;
}
