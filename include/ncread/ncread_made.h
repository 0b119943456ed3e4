/*
 * ncread_made - what a program of ncpost was made with, by its head, the machine and its control:
 * the work offset, and the words of coolant.
 */
#ifndef CLOUDMILL_NCREAD_MADE_H
#define CLOUDMILL_NCREAD_MADE_H

#include "base/cli.h"
#include "ncread/ncread.h"

enum { NCREAD_MADE_TEXT = 60 };

/* The head is ncpost's, and names this control's file; NULL, "": none. */
bool ncread_made_for(const struct ncread_head *head, const char *control);

/* The keys of --set that matter here, as the head says them (machine_set), where `own` does not
 * set them: over those of the machine. */
void ncread_made_set(struct machine *machine, const struct ncread_head *head,
                     const struct cli_list *own);

/*
 * The work offset of the program's first tool.  True if it is known: the user set it (`own`), or
 * the head names the control and the machine that were read.  "": none, the active preset.
 */
bool ncread_made_work(const struct machine *machine, const struct ncread_head *head,
                      const struct cli_list *own, char work[NCREAD_MADE_TEXT]);

/* The same offset, in other letters or with other zeros, from their second words on as far as the
 * shorter text goes: G54.1 P3, G054.1P03. */
bool ncread_made_same(const char *a, const char *b);

#endif
