# Figure 12.1 - disc and plates after loading.   In: fig_12_1.csv, fig_12_1_lower.csv, fig_12_1_upper.csv   Out: fig_12_1.svg
width = 760; height = 480
load 'style.gp'
set size ratio -1
unset key; unset grid
set xlabel '{/:Italic x} [mm]'
set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.42
set xrange [0:56]
set yrange [-14:114]
set xtics 25
set ytics 25
set palette maxcolors 14
set cbrange [-0.35:0.35]
set colorbox user origin 0.43,0.25 size 0.015,0.5
set cbtics 0.1
set cblabel 'σ_x [MPa]' offset 0.3,0
set ylabel '{/:Italic y} [mm]' offset 1,0
plot for [part in '_lower _upper'] data.'/fig_12_1'.part.'.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     data.'/fig_12_1.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette
set lmargin at screen 0.60
set rmargin at screen 0.88
set xrange [0:3.2]
set yrange [-2.2:3]
set xtics 1
set ytics 1
unset ylabel
set cbrange [-21:0]
set colorbox user origin 0.89,0.25 size 0.015,0.5
set cbtics 3
plot data.'/fig_12_1_lower.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     data.'/fig_12_1.csv' using 'x':'y':'value' with polygons fs solid noborder fc palette, \
     data.'/fig_12_1_lower.csv' using 'x':'y' with lines lc rgb '#80ffffff' lw 0.3 dt 1, \
     data.'/fig_12_1.csv' using 'x':'y' with lines lc rgb '#80ffffff' lw 0.3 dt 1
unset multiplot
