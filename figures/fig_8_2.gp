# Figure 8.2 - two complementarity functions, their level lines and zeros.   In: fig_8_2.csv   Out: fig_8_2.svg
width = 640
height = 370
load 'style.gp'
unset grid
set contour base
unset surface
set cntrparam levels discrete -1,-0.5,0.5,1,2,3,4
set table $fb
splot data.'/fig_8_2.csv' using 'a':'b':'phi' with lines
unset table
unset contour
set surface
set datafile separator whitespace
set xrange [-2:2]
set yrange [-2:2]
set size ratio 1
set border 15 back ls 100
set xtics 1
set ytics 1
set xlabel 'gap {/:Italic a}'
set ylabel 'force {/:Italic b}' offset 1,0
set lmargin 6
set rmargin 2
set arrow 1 from 0,0 to 2,0 nohead lw 4 lc rgb BLUE front
set arrow 2 from 0,0 to 0,2 nohead lw 4 lc rgb BLUE front
unset key
set multiplot layout 1,2
set title 'Fischer-Burmeister'
set label 1 'kink' at -0.12,-0.25 right front textcolor rgb RED
set label 3 '' at 0,0 point pt 7 ps 1.3 lc rgb RED front
set label 2 'zero' at 1.2,0.17 front textcolor rgb BLUE
plot $fb using 1:2 with lines ls 8 dt 1 lw 1.2, \
     $fb using 1:2:(sprintf('%g',$3)) every 1000::9 with labels textcolor rgb BLACK @HALO
set title 'minimum (minus it)'
set label 1 'kinks' at -0.75,-1.05 left
unset label 3
set arrow 3 from -2,-2 to 2,2 nohead lw 2 dt (6,4) lc rgb RED front
array level[5] = [-1, -0.5, 0.5, 1, 1.5]
do for [i=1:5] {
  m = -level[i]
  set arrow 10+2*i from m,m to m,2 nohead ls 8 dt 1 lw 1.2
  set arrow 11+2*i from m,m to 2,m nohead ls 8 dt 1 lw 1.2
  set label 10+i sprintf('%g', level[i]) at 1.4,m center front textcolor rgb BLACK @HALO
}
plot NaN
unset multiplot
