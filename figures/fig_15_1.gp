# Figure 15.1 - a spring slider: what the hand pulls, with memory and without.   In: fig_15_1.csv   Out: fig_15_1.svg
width = 640; height = 470
load 'style.gp'
set multiplot
# the slider
set lmargin at screen 0.12; set rmargin at screen 0.97; set bmargin at screen 0.80; set tmargin at screen 0.99
set xrange [0:10]; set yrange [0:2]
unset border; unset tics; unset key; unset grid
set object 1 rect from 1.5,0.3 to 2.7,1.1 fc rgb SKY fs solid border lc rgb BLACK
set arrow 1 from 0.4,0.3 to 6.6,0.3 nohead lw 1.5 lc rgb BLACK
do for [i=0:15] { set arrow 10+i from 0.5+0.4*i,0.3 to 0.3+0.4*i,0.05 nohead lw 0.8 lc rgb BLACK }
set arrow 2 from 2.1,1.9 to 2.1,1.15 head filled size 0.16,20 lw 1.3 lc rgb BLACK
set arrow 3 from 5.6,0.7 to 6.9,0.7 head filled size 0.16,20 lw 1.3 lc rgb BLACK
set label 1 '10 N' at 2.25,1.6 textcolor rgb BLACK
set label 2 'hand, {/:Italic u}' at 7.0,0.7 textcolor rgb BLACK
set label 3 '{/:Italic k} = 20 N/mm' at 4.15,1.3 center textcolor rgb BLACK
set label 4 '{/:Italic B} = 5 N' at 0.25,0.75 textcolor rgb BLACK
set label 5 'wall' at 6.8,0.18 textcolor rgb BLACK
$spring << EOD
2.7,0.7
3.1,0.7
3.25,0.95
3.55,0.45
3.85,0.95
4.15,0.45
4.45,0.95
4.75,0.45
5.05,0.95
5.2,0.7
5.6,0.7
EOD
plot $spring using 1:2 with lines ls 7 lw 1.5
# the loop
unset object; unset arrow; unset label
set lmargin at screen 0.12; set rmargin at screen 0.97; set bmargin at screen 0.16; set tmargin at screen 0.76
set border 3; set tics nomirror out scale 0.6; set grid
set xtics nomirror 0.5; set ytics nomirror 2.5
set xrange [-1.25:1.25]; set yrange [-6.2:6.2]
set xlabel 'hand {/:Italic u} [mm]'
set ylabel 'pull of the hand [N]' offset 2,0
unset key
set arrow 1 from 0.85,2.0 to 0.79,0.8 front head filled size 0.05,20 lw 2 lc rgb BLUE
set arrow 2 from -0.85,-2.0 to -0.79,-0.8 front head filled size 0.05,20 lw 2 lc rgb BLUE
set arrow 3 from 0.1,2.0 to 0.16,3.2 front head filled size 0.05,20 lw 2 lc rgb BLUE
set label 14 'from rest' at 0.02,-0.9 left front textcolor rgb BLUE
set label 11 'remembers' at 0.78,-1.2 left front textcolor rgb BLUE
set label 12 'forgets' at 0.12,1.0 left front textcolor rgb RED
set label 13 'circles: by hand' at 0.13,-4.1 center front textcolor rgb BLACK
file = data.'/fig_15_1.csv'
$area << EOD
1,5
0.5,-5
-1,-5
-0.5,5
EOD
set label 10 "lost in a round:\n4{/:Italic B}({/:Italic U} − {/:Italic B}/{/:Italic k})\n= 15 N mm" at -0.43,3.9 left front textcolor rgb BLACK
plot $area using 1:2 with filledcurves closed fc rgb LIGHT notitle, \
     file using 'hand':'pull' with linespoints ls 1 notitle, \
     file using 'hand':'by_hand' with points pt 6 ps 1.2 lc rgb BLACK notitle, \
     file using 'hand':'forgets' smooth unique with lines ls 2 lw 2.5 notitle
unset multiplot
