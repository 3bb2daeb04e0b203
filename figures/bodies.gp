# bodies.gp: what figures of bodies have in common, after   load 'style.gp'
#
# A deformed body, filled, and what presses on it:   eval 'plot '.body(cells, 1).', '.pressing(arrows, length, 1)
# cells: a csv of deformed_cells_csv().  arrows: a csv of pressure_arrows_csv(); an arrow ends at the surface that it
# presses on and is `length` long per unit of pressure, in the unit of the axes; a line joins their tails.  A negative
# length draws what presses on the other body; the last number is -1 for the picture in a mirror at x = 0.
BODY = '#dcebf5'
set style line 9 lc rgb RED lw 1.3 dt 1
body(cells, side) = sprintf("'%s' using (%d*column('x')):'y' with polygons fs solid noborder fc rgb BODY notitle, '' using (%d*column('x')):'y' with lines lc rgb '#8fbbd9' lw 0.5 dt 1 notitle", cells, side, side)
part(name, length, side) = sprintf("(%.9g*column('p%s'))", length*side, name)
tail(name, length, side) = sprintf("(%d*(column('%s') - %.9g*column('p%s')))", side, name, length, name)
tails(length, side) = tail('x', length, side).':'.tail('y', length, 1)
pressed(x) = "(abs(column('px')) + abs(column('py')) > 0 ? ".x." : NaN)"
pressing(arrows, length, side) = "'".arrows."' using ".tails(length, side).':'.part('x', length, side).':'.part('y', length, 1)." with vectors filled size screen 0.010,18 ls 9 notitle, '' using ".pressed(tail('x', length, side)).':'.tail('y', length, 1)." with lines ls 9 notitle"
