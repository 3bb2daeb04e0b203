# Figure 6.4 - the deformed beam with its bending stress, and the contact pressure on it.
# In: fig_6_4.csv, fig_6_4_arrows.csv, fig_6_4_zero.csv   Out: fig_6_4.svg
width = 480; height = 370
load 'style.gp'
load 'bodies.gp'
set lmargin 8
set rmargin 2
set bmargin at screen 0.38
unset key; unset grid
set xlabel '{/:Italic x} [cm]' offset 0,0.3
set ylabel '{/:Italic y} [cm]' offset 1,0
set xrange [-0.5:50.5]
set yrange [-5.2:5.5]
set ytics 0,2
set palette maxcolors 12
set cbrange [-300:300]
set colorbox horizontal user origin 0.16,0.17 size 0.79,0.045
set cblabel 'bending stress {/:Italic σ_{xx}} [kN/cm²]' offset 0,0.4
set cbtics 100
set object 1 rectangle from -0.5,-5.2 to 50.5,-1 fc rgb LIGHT fs solid noborder behind
set arrow 1 from -0.5,-1 to 50.5,-1 nohead front ls 7
set label 1 'tension' at 7.5,3.5 center front textcolor rgb 'white'
set label 2 'compression' at 7.5,0.6 center front textcolor rgb 'white'
set label 3 'compression' at 33,2.6 center front textcolor rgb 'white'
set label 4 'tension' at 33,0.2 center front textcolor rgb 'white'
set label 5 'rigid foundation' at 10,-2.6 center front
set label 6 "contact pressure,\nup to 11.5 kN/cm²" at 41.2,-3.2 right front textcolor rgb RED
eval "plot data.'/fig_6_4.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#a0ffffff' lw 0.3 dt 1, \
     data.'/fig_6_4_zero.csv' using 'x':'y' with lines ls 7 lc rgb 'white' lw 2.5, \
     '' using 'x':'y' with lines ls 7, ".pressing(data.'/fig_6_4_arrows.csv', 0.3, 1)
