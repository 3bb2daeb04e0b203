# Figure 8.3 - Coulomb's law with cohesion as two sliders in a row.   In: fig_8_3.csv   Out: fig_8_3.svg
width = 640
height = 330
load 'style.gp'
B = 0.7   # c + mu f_n of the program's pair: 0.2 + 0.5 * 1
set border 0
unset tics
unset grid
set xrange [-1.15:1.15]
set yrange [-1.3:1.25]
set lmargin 1
set rmargin 1
set bmargin 1
set tmargin 2.5
unset key
set multiplot layout 1,3
set arrow 1 from -1.1,0 to 1.1,0 lw 1 lc rgb GREY size screen 0.008,20 back
set arrow 2 from 0,-1.15 to 0,1.15 lw 1 lc rgb GREY size screen 0.008,20 back
set label 2 'friction' at 0.04,1.12 textcolor rgb BLACK
set title 'slides back: (17)'
set label 1 '−{/:Italic u}⁻' at 1.1,-0.18 right textcolor rgb BLACK
set label 3 '{/:Italic B}' at 0.06,B textcolor rgb BLACK
$minus << EOD
-1.05,0.7
0,0.7
0,-1.0
EOD
plot $minus using 1:2 with lines ls 1 lw 3
set title 'slides forth: (18)'
set label 1 '{/:Italic u}⁺'
set label 3 '−{/:Italic B}' at -0.06,-B right
$plus << EOD
1.05,-0.7
0,-0.7
0,1.0
EOD
plot $plus using 1:2 with lines ls 2 dt 1 lw 3
set title 'both in a row: (19)'
set label 1 '{/:Italic u}⁺ − {/:Italic u}⁻'
set label 3 '{/:Italic B} = {/:Italic c} + {/:Italic μf_n}' at 0.06,B left
set label 4 '−{/:Italic B}' at -0.06,-B right textcolor rgb BLACK
set label 5 "elastic\nbody" at -1.15,1.2 left textcolor rgb BLACK
$law << EOD
-1.05,0.7
0,0.7
0,-0.7
1.05,-0.7
EOD
# the elastic body: slip = s + friction
file = data.'/fig_8_3.csv'
plot file using 'slip':'friction':(-0.45):(-0.45) with vectors nohead lw 1 dt (2,3) lc rgb GREY, \
     file using 'slip':'friction':(0.24):(0.24) with vectors nohead lw 1 dt (2,3) lc rgb GREY, \
     $law using 1:2 with lines ls 7 lw 3, \
     file using 'slip':'friction' with points pt 7 ps 1.1 lc rgb RED
unset multiplot
