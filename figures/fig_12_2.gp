# Figure 12.2 - stress across the load, on disc and plates after loading, and at the lower contact.
# In: fig_12_2.csv, fig_12_2_lower.csv, fig_12_2_upper.csv, fig_12_2_mesh*.csv   Out: fig_12_2.svg
width = 640; height = 480
load 'style.gp'
set size ratio -1
unset key; unset grid
set xlabel '{/:Italic x} [mm]' offset 0,0.5
set palette maxcolors 10
set cbrange [-0.5:9.5]
levels = '-12 -6 -3 -1 -0.3 -0.1 0 0.1 0.2'  # as in drawings.hpp
set cbtics scale 0 ('' 0)
set for [k=1:9] cbtics add (word(levels, k) k - 0.5)
set multiplot
set bmargin at screen 0.17
set tmargin at screen 0.97
set lmargin at screen 0.10
set rmargin at screen 0.42
set xrange [0:52]
set yrange [-10:110]
set xtics 25
set ytics 25
unset colorbox
plot for [part in '_lower _upper'] data.'/fig_12_2'.part.'.csv' using 'x':'y':'band' with polygons fs solid noborder fc palette, \
     data.'/fig_12_2.csv' using 'x':'y':'band' with polygons fs solid noborder fc palette
set lmargin at screen 0.45
set rmargin at screen 0.79
set xrange [0:2.5]
set yrange [-2.2:3]
set xtics 1
set ytics 1
set colorbox user origin 0.80,0.2 size 0.025,0.7
set cblabel 'σ_x [MPa]' offset -0.5,0
plot data.'/fig_12_2_lower.csv' using 'x':'y':'band' with polygons fs solid noborder fc palette, \
     data.'/fig_12_2.csv' using 'x':'y':'band' with polygons fs solid noborder fc palette, \
     data.'/fig_12_2_mesh_lower.csv' using 'x':'y' with lines lc rgb GREY lw 0.4 dt 1, \
     data.'/fig_12_2_mesh.csv' using 'x':'y' with lines lc rgb GREY lw 0.4 dt 1
unset multiplot
