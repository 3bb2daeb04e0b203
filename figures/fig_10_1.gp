# Figure 10.1 - an edge of the source with two Gauss points over an edge of the target, after figure 6 of Lin et al.
# In: fig_10_1.csv   Out: fig_10_1.svg
width = 640
height = 400
load 'style.gp'
file = data.'/fig_10_1.csv'
set border 0
unset tics
unset grid
unset key
set size ratio -1
set xrange [-0.9:5.1]
set yrange [-1.15:2.75]
set lmargin 1
set rmargin 1
set tmargin 1
set bmargin 1
set object 1 polygon from 4.2,0.25 to 0,0 to 0.04,-0.8 to 4.24,-0.55 to 4.2,0.25 fc rgb LIGHT fs solid noborder back
set object 2 polygon from 0.6,1.3 to 3.2,1.8 to 3.1,2.6 to 0.5,2.1 to 0.6,1.3 fc rgb '#f3ead8' fs solid noborder back
set label 1 '1' at 0.42,1.3 right textcolor rgb BLACK
set label 2 '2' at 3.32,1.72 textcolor rgb BLACK
set label 3 '3' at 4.32,0.3 textcolor rgb BLACK
set label 4 '4' at -0.12,0.05 right textcolor rgb BLACK
set label 5 'source (slave), edge {/:Italic l}_{12}' at 0.9,1.98 textcolor rgb BLACK
set label 6 'target (master)' at 1.7,-0.4 textcolor rgb BLACK
set label 7 'gp_1' at 1.22,1.2 textcolor rgb BLACK
set label 8 'gp_2' at 2.75,1.45 textcolor rgb BLACK
set label 9 'pgp_1' at 0.85,-0.18 textcolor rgb BLACK
set label 10 'pgp_2' at 2.8,-0.05 textcolor rgb BLACK
set label 11 '{/:Italic g}_1' at 0.9,0.75 textcolor rgb BLACK
set label 12 '{/:Italic n}_1' at 1.24,0.62 textcolor rgb BLACK
set label 13 '{/:Italic t}_1' at 1.95,0.24 textcolor rgb BLACK
set label 14 "forces of\n{/:Italic f_n} at gp_1" at 3.75,1.25 textcolor rgb RED
plot file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::0::1 with vectors nohead lw 3 dt 1 lc rgb BLACK, \
     file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::2::3 with vectors nohead lw 1.2 dt (4,3) lc rgb BLACK, \
     file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::4::7 with vectors size screen 0.018,18 lw 2.5 dt 1 lc rgb RED, \
     file using 'x':'y':(column('x2')-column('x')):(column('y2')-column('y')) every ::8::9 with vectors size screen 0.014,20 lw 1.5 dt 1 lc rgb BLACK, \
     file using 'x':'y' every ::4::7 with points pt 7 ps 1.1 lc rgb BLACK, \
     file using 'x':'y' every ::2::3 with points pt 5 ps 1.0 lc rgb BLUE, \
     file using 'x2':'y2' every ::2::3 with points pt 4 ps 1.0 lc rgb BLUE
