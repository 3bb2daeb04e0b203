# Figure 13.2 - footing and soil, settled, with the vertical stress.
# In: fig_13_2.csv, fig_13_2_footing.csv   Out: fig_13_2.svg
width = 720; height = 620
load 'style.gp'
set size ratio -1
unset key; unset grid
set xlabel '{/:Italic x} [m]'
set ylabel '{/:Italic y} [m]'
set xrange [0:5]
set yrange [-4.5:2]
set rmargin 14
set palette maxcolors 10
set cbrange [-20:0]
set cblabel 'σ_y [kPa]' offset 1,0
set cbtics 4
plot data.'/fig_13_2.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#80ffffff' lw 0.3 dt 1, \
     data.'/fig_13_2_footing.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     '' using 'x':'y' with lines lc rgb '#80ffffff' lw 0.3 dt 1
