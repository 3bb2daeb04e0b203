# Figure 14.1 - the quarter of the two rings, its mesh, and the loaded rings with the pressures on the lining.
# Gap and displacements are drawn 20 times as large.   In: fig_14_1*.csv   Out: fig_14_1.svg
width = 640; height = 640
load 'style.gp'
load 'bodies.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set xrange [-8:86]
set yrange [-8:84]
set style arrow 1 head filled size 2.2,20 lc rgb BLACK lw 1.2 dt 1     # load
set style arrow 2 head filled size 2.2,20 lc rgb BLACK lw 1 dt (5,4)   # guessed radius
# rollers on the two lines of symmetry
do for [r in "62 66 73 77"] {
  set object circle at r,-2.1 size 1.7 fs empty border lc rgb BLACK lw 1
  set object circle at -2.1,r size 1.7 fs empty border lc rgb BLACK lw 1
}
set arrow from 59,-4.2 to 80,-4.2 nohead lc rgb BLACK lw 1.2 dt 1
set arrow from -4.2,59 to -4.2,80 nohead lc rgb BLACK lw 1.2 dt 1
set multiplot
set lmargin at screen 0; set rmargin at screen 0.52; set bmargin at screen 0.5; set tmargin at screen 1
at(r, w) = sprintf('%g,%g', r*cos(w*pi/180), r*sin(w*pi/180))
ray(r, w, name) = 'set arrow from 0,0 to '.at(r, w).' as 2; set label "'.name.'" at '.at(0.6*r, w + 4).' center rotate by '.sprintf('%g', w).' front'
do for [w in "2 22 44 66 88"] {
  eval 'set arrow from '.at(49, w).' to '.at(59.5, w).' as 1'
}
eval ray(71, 11, '{/:Italic c} = {/:Italic b} + 0.15')
eval ray(79, 33, '{/:Italic d} = 76.15')
eval ray(68, 55, '{/:Italic b} = 68')
eval ray(60, 76, '{/:Italic a} = 60')
set label '180 MPa' at 49,-0.5 right
plot data.'/fig_14_1.csv' using 'x':'y' with lines ls 7
set lmargin at screen 0.49; set rmargin at screen 1.01
unset label; unset arrow
set arrow from 59,-4.2 to 80,-4.2 nohead lc rgb BLACK lw 1.2 dt 1
set arrow from -4.2,59 to -4.2,80 nohead lc rgb BLACK lw 1.2 dt 1
set object circle at 52.1,43.7 size 1 fs solid fc rgb BLACK front
set object circle at 54.4,45.6 size 1 fs solid fc rgb BLACK front
set arrow from 41,34.4 to 51,42.8 as 1 front
set arrow from 69.5,58.3 to 55.5,46.5 as 1 front
set label '10' at 40,33 right
set label '80' at 70,60
set label 'lining' at 27,44 center
set label 'rock' at 47,74 center
plot data.'/fig_14_1_lining.csv' using 'x':'y' with lines ls 7 lw 1, \
     data.'/fig_14_1_rock.csv' using 'x':'y' with lines ls 7 lw 1
unset label; unset arrow; unset object
set lmargin at screen 0.02; set rmargin at screen 0.60; set bmargin at screen 0.01; set tmargin at screen 0.53
set xrange [-2:92]
set yrange [-2:82]
MPA = 0.09  # length of an arrow [cm] for 1 MPa
set style arrow 3 head filled size screen 0.012,18 ls 9
set label '180 MPa' at 45,12 right textcolor rgb RED
set label 'under load' at 98,66 left
set label 'the rock presses the lining' at 98,58 left textcolor rgb RED
set label 'with 44 MPa' at 98,50 left textcolor rgb RED
set label 'pressures to scale' at 98,42 left
pushed(w) = sprintf('set arrow from %.3f,%.3f to %.3f,%.3f as 3', (INSIDE - 180*MPA)*cos(w*pi/180), (INSIDE - 180*MPA)*sin(w*pi/180), INSIDE*cos(w*pi/180), INSIDE*sin(w*pi/180))
INSIDE = 65.8  # the inner rim, displaced
do for [w = 0:90:10] { eval pushed(w) }
lining = data.'/fig_14_1_loaded_lining.csv'; rock = data.'/fig_14_1_loaded_rock.csv'; arrows = data.'/fig_14_1_arrows.csv'
eval 'plot '.body(lining, 1).', '.body(rock, 1).', '.pressing(arrows, MPA, 1)
unset multiplot
