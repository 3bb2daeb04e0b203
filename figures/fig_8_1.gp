# Figure 8.1 - two bodies that may touch, after figure 1 of Lin et al.   In: fig_8_1.csv   Out: fig_8_1.svg
width = 640
height = 470
load 'style.gp'
file = data.'/fig_8_1.csv'
set border 0
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.6:5.6]
set yrange [-2.55:3.05]
set lmargin 1
set rmargin 1
set tmargin 1
set bmargin 1
# The bodies: their sides of the figure's curve, closed by straight lines far from the contact.
set arrow 1 from 0.23,1.46 to 0.1,2.55 nohead lw 2 lc rgb BLACK
set arrow 2 from 3.77,1.46 to 3.9,2.55 nohead lw 2 lc rgb BLACK
set arrow 3 from 0.1,2.55 to 3.9,2.55 nohead lw 5 lc rgb BLUE
set arrow 4 from 0.891,-0.105 to -0.6,-0.9 nohead lw 2 lc rgb BLACK
set arrow 5 from 3.109,-0.105 to 4.6,-0.9 nohead lw 2 lc rgb BLACK
set arrow 6 from -0.6,-0.9 to -0.6,-2.0 nohead lw 2 lc rgb BLACK
set arrow 7 from 4.6,-0.9 to 4.6,-2.0 nohead lw 2 lc rgb BLACK
set arrow 8 from -0.6,-2.0 to 4.6,-2.0 nohead lw 5 lc rgb BLUE
set object 1 polygon from 0.1,2.55 to 0.23,1.46 to 0.8,0.87 to 1.4,0.58 to 2,0.5 to 2.6,0.58 to 3.2,0.87 to 3.77,1.46 to 3.9,2.55 to 0.1,2.55 fc rgb '#f3ead8' fs solid noborder back
set object 2 polygon from -0.6,-0.9 to 0.891,-0.105 to 1.2,-0.006 to 1.5,0.06 to 2,0.1 to 2.5,0.06 to 2.8,-0.006 to 3.109,-0.105 to 4.6,-0.9 to 4.6,-2 to -0.6,-2 to -0.6,-0.9 fc rgb LIGHT fs solid noborder back
set arrow 11 from 4.75,2.3 to 3.95,2.1 lw 2 lc rgb RED size screen 0.014,20
set arrow 12 from 4.75,1.95 to 3.9,1.75 lw 2 lc rgb RED size screen 0.014,20
set arrow 13 from 5.4,-1.2 to 4.65,-1.3 lw 2 lc rgb RED size screen 0.014,20
set arrow 14 from 5.4,-1.6 to 4.65,-1.7 lw 2 lc rgb RED size screen 0.014,20
set arrow 15 from 2.575,0.325 to 2.66,0.8 lw 2 lc rgb PURPLE size screen 0.012,20 front
set arrow 16 from 2.575,0.325 to 3.05,0.24 lw 2 lc rgb PURPLE size screen 0.012,20 front
set label 10 '{/:Italic n}' at 2.73,0.86 textcolor rgb BLACK front
set label 11 '{/:Italic t}' at 3.1,0.2 textcolor rgb BLACK front
set label 12 '{/:Italic g}' at 2.3,0.2 textcolor rgb BLACK front
set label 13 '{/:Italic s} across the plane' at 3.55,0.32 textcolor rgb BLACK
set label 1 '{/:Bold a}: source' at 1.55,2.05 textcolor rgb BLACK
set label 2 '{/:Bold b}: target' at 1.55,-1.3 textcolor rgb BLACK
set label 3 '{/:Italic S}_{u1}: held' at 0.1,2.8 textcolor rgb BLACK
set label 4 '{/:Italic S}_{u2}: held' at -0.6,-2.28 textcolor rgb BLACK
set label 5 '{/:Italic S}_{f1}: loaded' at 4.1,2.62 textcolor rgb BLACK
set label 6 '{/:Italic S}_{f2}' at 4.85,-0.95 textcolor rgb BLACK
set label 7 '{/:Italic S}_{c1}' at 0.05,1.3 right textcolor rgb BLACK
set label 8 '{/:Italic S}_{c2}' at 0.75,0.05 right textcolor rgb BLACK
set label 9 '{/:Italic S}_c: mid-points' at -1.05,0.5 textcolor rgb BLACK
plot file using 'x':'y' every :::0::0 with lines lw 2 dt 1 lc rgb BLACK, \
     file using 'x':'y' every :::1::1 with lines lw 2 dt 1 lc rgb BLACK, \
     file using 'x':'y' every :::2::2 with lines lw 1.5 dt (6,4) lc rgb GREEN, \
     file using 'x':'y' every :::3::3 with linespoints lw 1.5 dt (3,3) pt 7 ps 0.9 lc rgb BLACK
