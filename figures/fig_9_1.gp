# Figure 9.1 - a node of the source over an edge of the target, and the forces of f_n = 1.2, tau = 0.5.   In: fig_9_1.csv   Out: fig_9_1.svg
width = 640
height = 430
load 'style.gp'
file = data.'/fig_9_1.csv'
set border 0
unset tics
unset grid
unset key
set size ratio -1
set xrange [-1.5:5.2]
set yrange [-1.1:3.4]
set lmargin 1
set rmargin 1
set tmargin 1
set bmargin 1
set object 1 polygon from 4,0 to 0,3 to -0.75,2 to 3.25,-1 to 4,0 fc rgb LIGHT fs solid noborder back
set label 1 '1' at 4.12,0.12 textcolor rgb BLACK
set label 2 '2' at 0.1,3.2 textcolor rgb BLACK
set object 2 polygon from 2.1,2.45 to 3,1.5 to 4.95,0.75 to 5.2,3.3 to 2.5,3.3 to 2.1,2.45 fc rgb '#f3ead8' fs solid noborder back
set label 3 '3' at 3.2,1.5 textcolor rgb BLACK
set label 13 '{/:Bold b}: source (slave)' at 2.75,3.02 textcolor rgb BLACK
set label 4 "3′" at 2.4,1.4 textcolor rgb BLACK
set label 5 '{/:Bold a}: target (master)' at -0.15,1.3 textcolor rgb BLACK
set label 14 'part {/:Italic N}_1' at 0.62,1.72 textcolor rgb BLACK
set label 15 'part {/:Italic N}_2' at 2.5,0.42 textcolor rgb BLACK
set label 6 'force on 3' at 4.18,2.25 textcolor rgb BLACK
set label 7 '{/:Italic N}_1 × reaction' at 3.15,-0.5 right textcolor rgb BLACK
set label 8 '{/:Italic N}_2 × reaction' at -0.14,3.12 right textcolor rgb BLACK
set label 9 'reaction at 3′' at 0.95,0.12 textcolor rgb BLACK
set label 10 '{/:Italic g}_0' at 2.9,1.17 textcolor rgb BLACK
set arrow 11 from 1.0,2.25 to 1.36,2.73 lw 1.5 lc rgb BLACK size screen 0.012,20
set arrow 12 from 1.06,2.33 to 1.54,1.97 lw 1.5 lc rgb BLACK size screen 0.012,20
set label 11 '{/:Italic n}' at 1.42,2.78 textcolor rgb BLACK
set label 12 '{/:Italic t}' at 1.6,2.1 textcolor rgb BLACK
plot file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::0::0 with vectors nohead lw 3 dt 1 lc rgb BLACK, \
     file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::1::1 with vectors nohead lw 1.2 dt (4,3) lc rgb BLACK, \
     file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::5::5 with vectors size screen 0.018,18 lw 2 dt (8,4) lc rgb GREY, \
     file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::2::3 with vectors size screen 0.018,18 lw 2.5 dt 1 lc rgb RED, \
     file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::4::4 with vectors size screen 0.018,18 lw 2.5 dt 1 lc rgb BLUE, \
     file using 'x':'y' every ::2::4 with points pt 7 ps 1.1 lc rgb BLACK, \
     file using 'x':'y' every ::5::5 with points pt 6 ps 1.1 lw 1.5 lc rgb BLACK
