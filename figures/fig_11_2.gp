# Figure 11.2 - contact pressure, and the errors of pressures at nodes.
# In: fig_11_2.csv, fig_11_2_nodes.csv, fig_11_2_nts.csv   Out: fig_11_2.svg
height = 640
load 'style.gp'
set termoption font 'DejaVu Sans,15'
set multiplot
set lmargin 9
set xrange [0:1.25]
set xtics 0.2
set format x ''
set tmargin at screen 0.98
set bmargin at screen 0.42
set ylabel 'pressure {/:Italic p} [MPa]'
set yrange [0:30]
set key bottom left
plot data.'/fig_11_2.csv' using 'x':'theory' with lines ls 7 title 'closed form (43)', \
     data.'/fig_11_2_nodes.csv' using 'x':'p' with points ls 1 title 'mortar, meshes match', \
     data.'/fig_11_2_nts.csv' using 'x':'p' with points ls 5 title 'node to segment, not matching', \
     data.'/fig_11_2.csv' using 'x':'paper' with lines ls 2 title 'ellipse of the paper''s numbers', \
     data.'/fig_11_2.csv' using 'x':'abaqus' with lines ls 3 title 'ellipse of its ABAQUS numbers'
set tmargin at screen 0.38
set bmargin at screen 0.12
set format x '%g'
set xlabel 'distance from the axis {/:Italic x} [mm]'
set ylabel 'error [% of {/:Italic q}_0]'
set yrange [-9:9]
set ytics 3
unset key
plot 0 with lines ls 7 lw 1, \
     data.'/fig_11_2_nts.csv' using 'x':'error' with linespoints ls 5, \
     data.'/fig_11_2_nodes.csv' using 'x':'error' with linespoints ls 1
unset multiplot
