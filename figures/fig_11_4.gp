# Figure 11.4 - pressures at Gauss points and at nodes.   In: fig_11_4.csv   Out: fig_11_4.svg
height = 440
load 'style.gp'
set termoption font 'DejaVu Sans,15'
set xlabel 'distance from the axis {/:Italic x} [mm]'
set ylabel 'pressure {/:Italic p}/{/:Italic q}_0'
set xrange [0:1.25]
set yrange [0:3.4]
set xtics 0.2
set ytics 0.5
set key top right
plot data.'/fig_11_4.csv' using 'x':'p' every :::1::1 with linespoints ls 5 lw 1.2 title 'Gauss points, nodes do not meet', \
     '' using 'x':'p' every :::0::0 with linespoints ls 3 lw 1.2 title 'Gauss points, nodes meet, J mended', \
     '' using 'x':'p' every :::3::3 with lines ls 7 title 'closed form (43)', \
     '' using 'x':'p' every :::2::2 with points ls 1 ps 1 title 'nodes (mortar, meshes match)'
