/*
 * ncread_head - what the comments at a program's head say, in the form of every control's comments:
 *
 *   TOOL: BALL R5 FLUTE 20 HOLDER 5:60      SCALLOP: 0.02 TOLERANCE: 0.01
 *   NOISE: 0.005
 *   FEED: CONTACT                           cloudmill ncpost for Siemens, Fork head C/A
 *   Tolerance cloud2mesh 0.0002
 *   Tolerance ncpost 0.0011                 Tolerance sum 0.0112 mm, axis 0.0063 deg
 *   CONTROL: siemens                        MACHINE: head-ca
 *   SET: A.max=30                           SCAN: 1681,3cad464a0113cb05,scan.xyz
 *   PLACE1: 1 0 0 5                         and PLACE2:, PLACE3:
 *   REGION: BORDER 0.75 BOX 0 0 -5 40 30 10 POLYGON 0 0 10 0 10 10
 *
 * and TOOL+: and REGION+: for more of these, and an ATTENTION that the places are the centre of the
 * ball.  What is not understood is as if it were not there.
 */
#ifndef CLOUDMILL_NCREAD_HEAD_H
#define CLOUDMILL_NCREAD_HEAD_H

#include "ncread/ncread.h"

/* Looks at one line. */
void ncread_head_line(struct ncread_head *head, const char *line);

#endif
