/*
 * verdict_script - the script of the page: a view on a canvas that turns and zooms, by mouse and
 * keys, with points, passes and blocks to choose.
 *
 * It reads `const D`: centre [x y z], points (x y z deviation inside row), nodes (x y z kind row;
 * kind 0 begins, 1 cuts, 2 is rapid), rows (block line pass gouge left), worst (rows), tolerance
 * and full (deviations of full colour).  Places are whole thousandths of a mm, deviations
 * ten-thousandths.
 */
#ifndef CLOUDMILL_VERDICT_SCRIPT_H
#define CLOUDMILL_VERDICT_SCRIPT_H

/* Line by line, NULL at the end. */
extern const char *const verdict_script[];

#endif
