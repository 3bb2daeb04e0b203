# Figure 13.1 - right half of footing and soil: sketch, and the loaded mesh with the contact pressure on the soil.
# In: fig_13_1.csv, fig_13_1_footing.csv, fig_13_1_arrows.csv   Out: fig_13_1.svg
width = 640; height = 360
load 'style.gp'
load 'bodies.gp'
set size ratio -1
unset key; unset grid; unset border; unset tics
set bmargin at screen 0.02
set tmargin at screen 0.98
set yrange [-16.4:4.2]
set multiplot
set lmargin at screen 0.01
set rmargin at screen 0.48
set xrange [-1.5:15.5]
set object 1 rectangle from 0,0 to 1.5,2 fc rgb LIGHT fs solid noborder
set object 2 rectangle from 0,0 to 1.5,2 fs empty border lc rgb BLACK lw 1.5 dt (6,4)
set object 3 rectangle from 0,-15 to 15,0 fs empty border lc rgb BLACK lw 1.5 dt (6,4)
set arrow from 0,0 to 1.5,0 nohead lc rgb BLACK lw 3 dt 1
set arrow from 0,-15 to 0,2 nohead lc rgb GREY lw 1 dt (12,3,3,3)
do for [k=0:3] { set arrow from 0.5*k,3.6 to 0.5*k,2.1 head size 0.35,20 filled lc rgb RED lw 1.5 dt 1 }
do for [k=1:20] { set arrow from 0.75*k,-15 to 0.75*k-0.7,-15.9 nohead lc rgb BLACK lw 1 dt (4,3) }
do for [y in '-13 -10 -7 -4 1'] { set object circle at -0.45,y size 0.4 fs empty border lc rgb BLACK lw 1.2 dt 1 }
set label '{/:Italic q} = 15 kPa' at 2,3 textcolor rgb RED
set label '2' at 1.8,1
set label '{/:Italic a} = 1.5' at 0.2,-1.1
set label '15' at 7.5,-14 center
set label '15' at 13.4,-7.5
plot NaN notitle
unset object; unset arrow; unset label
set lmargin at screen 0.51
set rmargin at screen 0.98
set xrange [-0.4:6.4]
set yrange [-4.6:3.6]
set arrow from 0,-4.6 to 0,3.6 nohead back lc rgb GREY lw 1 dt (12,3,2,3)
set label 1 'pressure,' at 1.75,2.3 left front textcolor rgb RED
set label 2 'largest at the edge' at 1.75,1.7 left front textcolor rgb RED
eval 'plot '.body(data.'/fig_13_1.csv', 1).', '.body(data.'/fig_13_1_footing.csv', 1).', '.pressing(data.'/fig_13_1_arrows.csv', 0.045, 1)
unset multiplot
