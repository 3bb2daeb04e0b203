# Figure 11.1 - half of the problem with its supports and loads, and the mesh, whole and at the contact.
# In: fig_11_1_disc.csv, fig_11_1_plate.csv   Out: fig_11_1.svg
width = 860; height = 520
load 'style.gp'
set termoption font 'DejaVu Sans,20'
set size ratio -1
unset key; unset grid; unset border; unset tics
set multiplot
set bmargin at screen 0.02
set tmargin at screen 0.98
set lmargin at screen 0.02
set rmargin at screen 0.41
set xrange [-14:112]
set yrange [-117:78]
set object 1 polygon from 0,0 to 95,0 to 95,-95 to 0,-95 to 0,0 fs solid border lc rgb BLACK lw 1.5 fc rgb LIGHT
set object 2 circle at 0,50 size 50 arc [270:360] fs solid noborder fc rgb LIGHT
set object 3 polygon from 0,50 to 50,50 to 0,0 to 0,50 fs solid noborder fc rgb LIGHT
set object 4 circle at 0,50 size 50 arc [270:360] nowedge fs empty border lc rgb BLACK lw 1.5
set arrow 1 from 0,50 to 50,50 nohead lw 1.5 lc rgb BLACK front
set arrow 2 from 0,-95 to 0,50 nohead lw 1.5 lc rgb BLACK front
do for [i=0:4] { set arrow 10+i from 3+11*i,64 to 3+11*i,51 size screen 0.014,20 filled lc rgb GREY lw 2 dt (3,2) front }
set label 1 'P/2, spread evenly' at -3,71 left textcolor rgb GREY
set arrow 20 from 0,50 to 35.4,14.6 head size screen 0.014,20 filled lc rgb BLACK lw 1 front
set label 2 'R = 50 mm' at 44,12 left front
do for [i=0:5] { set object 30+i circle at -3,40-26*i size 2.6 fs empty border lc rgb BLACK lw 1.2 }
set object 40 rectangle from 0,-101 to 95,-95 fs pattern 4 border lc rgb GREY fc rgb GREY
set label 3 'E = 4000 MPa' at 47,-30 center front
set label 4 'ν = 0.35' at 47,-45 center front
set arrow 21 from 0,-110 to 95,-110 heads size screen 0.014,20 lc rgb GREY lw 1.4 dt (6,4) front
set label 5 '95 mm' at 47,-85 center textcolor rgb GREY front
set arrow 22 from 103,0 to 103,-95 heads size screen 0.014,20 lc rgb GREY lw 1.4 dt (6,4) front
set label 6 '95 mm' at 92,-62 right textcolor rgb GREY front
plot NaN
unset object; unset arrow; unset label
set lmargin at screen 0.42
set rmargin at screen 0.72
set tmargin at screen 0.87
set bmargin at screen 0.06
set xrange [0:96]
set yrange [-96:51]
plot for [body in 'plate disc'] data.'/fig_11_1_'.body.'.csv' using 'x':'y' with lines lc rgb BLUE lw 0.5 dt 1
set lmargin at screen 0.75
set rmargin at screen 0.98
set xrange [0:2.8]
set yrange [-2.3:2.3]
set title '2.8 mm' offset 0,-0.5
plot for [body in 'plate disc'] data.'/fig_11_1_'.body.'.csv' using 'x':'y' with lines lc rgb BLUE lw 0.8 dt 1
unset multiplot
